//! A bearing as lines with tabs, for a spreadsheet.

use super::{BearingRow, displacement, load};
use crate::number::significant;

const MOTIONS: [&str; 6] = ["x", "y", "z", "thx", "thy", "thz"];

/// Loads, displacement, elements and stiffness.
pub(super) fn as_text(row: &BearingRow<'_>) -> String {
    let name = format!("{} bearing {}", row.side.name(), row.bearing.name);
    let mut lines = vec![format!("{name}\t{}\t{:?}\tmm", row.bearing.model.word(), row.bearing.position * 1e3)];
    let six = |values: [f64; 6]| values.map(|value| significant(value, 6)).join("\t");
    if let Some(rolling) = row.rolling {
        let (load, moved) = (load(rolling), displacement(rolling));
        lines.push(format!("\t{}", MOTIONS.join("\t")));
        lines.push(format!("load, N and N m\t{}", six(load.into())));
        lines.push(format!("displacement, m and rad\t{}", six(moved.into())));
        lines.push("element\tposition, deg\tload, N\tcontact angle, deg".into());
        lines.extend(rolling.state.contacts.iter().enumerate().map(|(at, contact)| {
            let [position, angle] = [contact.position, contact.angle].map(|angle| significant(angle.to_degrees(), 6));
            format!("{at}\t{position}\t{}\t{angle}", significant(contact.load, 6))
        }));
    }
    if let Some(support) = row.support {
        lines.push(format!("stiffness, N/m, N/rad, N m/rad\t{}", MOTIONS.join("\t")));
        lines.extend(
            MOTIONS
                .iter()
                .enumerate()
                .map(|(i, name)| format!("{name}\t{}", six(std::array::from_fn(|j| support.stiffness[(i, j)])))),
        );
    }
    lines.join("\n")
}
