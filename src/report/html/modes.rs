//! Natural modes: where their energy is, and which of them pair up.

use super::table::{Cell, Table};
use crate::agreement::{COMPARED_FE_MODES, LEAST_MAC, ModePair};
use crate::number::significant;
use crate::report::study::Study;
use crate::response::{Mode, Modes};

pub fn render(study: &Study) -> String {
    let fe = &study.modes.fe;
    finite_elements(fe)
        + &lumped("Enhanced", &study.modes.lumped, &study.modes.pairs, fe)
        + &lumped("Basic", &study.basic_modes, &study.basic_pairs, fe)
}

fn finite_elements(modes: &Modes) -> String {
    let caption = format!(
        "Finite elements, the lowest {} of {} modes. Shares of the kinetic energy, %: lateral x, z; axial y; tilt thx, thz; torsion thy, \
         drive. Mesh: share of the strain energy in it, %",
        modes.0.len().min(COMPARED_FE_MODES),
        modes.0.len()
    );
    let heads = ["mode#", "Hz#", "name"].into_iter().chain(SHARES).chain(["mesh#"]);
    let mut table = Table::new(&caption, heads);
    for (i, mode) in modes.0.iter().take(COMPARED_FE_MODES).enumerate() {
        let start = [Cell::number(&(i + 1).to_string()), frequency(mode), Cell::text(&mode.name())];
        table.row(start.into_iter().chain(shares(mode)).chain([percent(mode.mesh_strain_share)]));
    }
    table.render()
}

fn lumped(name: &str, modes: &Modes, pairs: &[ModePair], fe: &Modes) -> String {
    let caption =
        format!("{name} lumped model, with the finite element modes of the same shape (MAC at least {LEAST_MAC})");
    let heads = ["mode#", "Hz#"].into_iter().chain(SHARES).chain(["FE mode#", "FE, Hz#", "shift, %#", "MAC#"]);
    let mut table = Table::new(&caption, heads);
    for (i, mode) in modes.0.iter().enumerate() {
        let pair = pairs.iter().find(|pair| pair.lumped == i);
        let partner = pair.and_then(|pair| fe.0.get(pair.fe));
        // the rigid rotation has no frequency to be off from
        let shift = partner.filter(|partner| !partner.is_rigid());
        let shift = shift.map(|partner| 100.0 * (mode.frequency_hz / partner.frequency_hz - 1.0));
        let end = [
            Cell::number_or_none(pair.map(|pair| (pair.fe + 1).to_string())),
            partner.map_or_else(Cell::none, frequency),
            Cell::number_or_none(shift.map(|shift| format!("{shift:+.2}"))),
            Cell::number_or_none(pair.map(|pair| format!("{:.2}", pair.mac))),
        ];
        let start = [Cell::number(&(i + 1).to_string()), frequency(mode)];
        table.row(start.into_iter().chain(shares(mode)).chain(end));
    }
    table.render()
}

const SHARES: [&str; 8] = [
    "pinion lateral#",
    "pinion axial#",
    "pinion tilt#",
    "pinion torsion#",
    "gear lateral#",
    "gear axial#",
    "gear tilt#",
    "gear torsion#",
];

fn shares(mode: &Mode) -> impl Iterator<Item = Cell> {
    [mode.pinion, mode.gear]
        .into_iter()
        .flat_map(|share| [share.lateral, share.axial, share.tilt, share.torsion].map(percent))
}

fn frequency(mode: &Mode) -> Cell {
    Cell::number(&significant(mode.frequency_hz, 5))
}

/// Whole percent.
fn percent(share: f64) -> Cell {
    Cell::number(&format!("{:.0}", 100.0 * share.max(0.0)))
}
