//! The table as text.

use super::{ModesView, SmallStudy};
use crate::number::significant;
use crate::tui::spectra::legend_name;

impl ModesView {
    /// The table as lines with tabs, for a spreadsheet.
    pub fn as_text(&self) -> Option<String> {
        let study = self.study()?;
        let head = |small: &SmallStudy| format!("{} Hz\tshift %\tMAC", legend_name(small.own.kind()));
        let heads: Vec<String> = study.small().map(head).collect();
        let mut lines = vec![format!("FE\tFE Hz\tname\t{}\tmesh strain %", heads.join("\t"))];
        for row in &self.rows {
            let mode = row.mode(study)?;
            let of_fe = row.fe.map_or_else(
                || ["-".to_owned(), "-".to_owned()],
                |fe| [(fe + 1).to_string(), significant(mode.frequency_hz, 6)],
            );
            let number =
                |value: Option<f64>, decimals: usize| value.map_or("-".into(), |value| format!("{value:.decimals$}"));
            let mut cells = of_fe.to_vec();
            cells.push(mode.name());
            for partner in row.partners.iter().take(heads.len()) {
                cells.push(partner.map_or("-".into(), |one| significant(one.hz, 6)));
                cells.push(number(partner.and_then(|one| one.shift_percent), 2));
                cells.push(number(partner.and_then(|one| one.mac), 3));
            }
            cells.push(format!("{:.1}", 100.0 * mode.mesh_strain_share));
            lines.push(cells.join("\t"));
        }
        Some(lines.join("\n"))
    }
}
