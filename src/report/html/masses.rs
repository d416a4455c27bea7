//! What the lumped models make of each shaft at its mesh station.

use super::table::{Cell, Table};
use crate::design::Side;
use crate::number::significant;
use crate::report::study::Study;

/// A row a plane of a shaft: the enhanced model's mass and inertia beside what else they could be.
pub fn render(study: &Study) -> String {
    let caption = "Effective mass and inertia of the enhanced model, from the first bending mode of each plane; static: what the static shapes carry; \
                   whole: of the basic model. Missed: share of the mode's kinetic energy. *: the static one, since the mode gives none";
    let heads = [
        "shaft and plane",
        "first bending mode, Hz#",
        "effective mass, kg#",
        "static, kg#",
        "whole, kg#",
        "effective inertia, kg m^2#",
        "static, kg m^2#",
        "whole, kg m^2#",
        "missed, %#",
    ];
    let mut table = Table::new(caption, heads);
    for side in Side::BOTH {
        let rotor = study.rotors.get(side);
        // the coordinates are x, y, z, thx, thy, thz
        for (plane, bending, [deflection, rotation]) in
            [("x-y", &rotor.bending_x, [0, 5]), ("y-z", &rotor.bending_z, [2, 3])]
        {
            let number = |value: f64| Cell::number(&significant(value, 4));
            let effective = |value: f64, is_fallback: bool| {
                Cell::number(&format!("{}{}", significant(value, 4), if is_fallback { "*" } else { "" }))
            };
            table.row([
                Cell::text(&format!("{} {plane}", side.name())),
                number(bending.frequency),
                effective(bending.mass, bending.mass_fallback),
                number(rotor.statics.static_mass[deflection]),
                number(rotor.totals.mass),
                effective(bending.inertia, bending.inertia_fallback),
                number(rotor.statics.static_mass[rotation]),
                number(rotor.totals.diametral_inertia),
                Cell::number(&format!("{:.2}", 100.0 * bending.energy_residual)),
            ]);
        }
    }
    table.render()
}
