//! What became of a bearing since the design was saved.

use super::{BearingRow, is_stale};
use crate::number::grouped;
use crate::tui::editor::{Editing, same_mechanics};

/// `most 1,400 N (was 1,350), kx +3.2 %, kz +2.1 %`; nothing where the bearing or its load is not that of a saved one, or all is as saved.
pub fn since_saved(editing: &Editing, row: &BearingRow<'_>) -> Option<String> {
    let (now, saved) = (editing.solving.current.as_ref()?, editing.solving.ghost.as_ref()?);
    if is_stale(editing) || same_mechanics(&now.design, &saved.design) {
        return None;
    }
    let then = saved.design.rotor(row.side).bearings.get(row.place)?;
    if then.name != row.bearing.name || then.model.word() != row.bearing.model.word() {
        return None;
    }
    let states = saved.bearings.as_ref()?.side(row.side);
    let (support, was) = (states.supports.get(row.place)?, states.rolling.get(row.place)?.as_ref()?);
    let change = |at: usize| {
        let ratio = row.support?.stiffness[(at, at)] / support.stiffness[(at, at)];
        ratio.is_finite().then(|| format!("{:+.1} %", 100.0 * (ratio - 1.0)))
    };
    let change = |at: usize| change(at).unwrap_or_else(|| "-".into());
    let [most, before] = [row.rolling?, was].map(|rolling| grouped(rolling.state.greatest_load()));
    Some(format!("most {most} N (was {before}), kx {}, kz {}", change(0), change(2)))
}
