//! The mean state of a ball or roller bearing.

use std::io::{self, Write};

use super::wrapped;
use crate::bearing::frames;
use crate::number::significant;
use crate::rotor::Rolling;

#[derive(serde::Serialize)]
pub struct MeanStateOutput {
    /// On the inner ring
    load: Load,
    /// Of the inner ring
    displacement: Displacement,
    elements: usize,
    loaded_elements: usize,
    /// Least and greatest of the loaded elements
    contact_angle_deg: Option<[f64; 2]>,
    /// From +z (up) towards +x
    element_positions_deg: Vec<f64>,
    element_loads_n: Vec<f64>,
    /// Also of elements that are not in contact
    element_contact_angles_deg: Vec<f64>,
    /// What is worth knowing
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<String>,
    /// What is unusual
    warnings: Vec<String>,
}

#[derive(serde::Serialize)]
struct Load {
    x_n: f64,
    y_n: f64,
    z_n: f64,
    rx_n_m: f64,
    rz_n_m: f64,
}

#[derive(serde::Serialize)]
struct Displacement {
    x_um: f64,
    y_um: f64,
    z_um: f64,
    rx_mrad: f64,
    rz_mrad: f64,
}

impl MeanStateOutput {
    pub fn new(rolling: &Rolling) -> Self {
        let state = &rolling.state;
        let (load, q) = (frames::to_station(&state.load), frames::to_station(&state.displacement));
        let contacts = &state.contacts;
        Self {
            load: Load { x_n: load[0], y_n: load[1], z_n: load[2], rx_n_m: load[3], rz_n_m: load[5] },
            displacement: Displacement {
                x_um: q[0] * 1e6,
                y_um: q[1] * 1e6,
                z_um: q[2] * 1e6,
                rx_mrad: q[3] * 1e3,
                rz_mrad: q[5] * 1e3,
            },
            elements: contacts.len(),
            loaded_elements: state.loaded(),
            contact_angle_deg: state.angle_range().map(|range| range.map(f64::to_degrees)),
            element_positions_deg: contacts.iter().map(|contact| contact.position.to_degrees()).collect(),
            element_loads_n: contacts.iter().map(|contact| contact.load).collect(),
            element_contact_angles_deg: contacts.iter().map(|contact| contact.angle.to_degrees()).collect(),
            note: state.note(),
            warnings: state.warnings.iter().map(ToString::to_string).collect(),
        }
    }

    pub fn write(&self, out: &mut impl Write, name: &str) -> io::Result<()> {
        let five = |values: [f64; 5]| values.map(|value| significant(value, 5)).join("  ");
        let (load, q) = (&self.load, &self.displacement);
        writeln!(out, "bearing \"{name}\": mean state")?;
        writeln!(
            out,
            "  loads x, y, z (N), rx, rz (N m)          {}",
            five([load.x_n, load.y_n, load.z_n, load.rx_n_m, load.rz_n_m])
        )?;
        writeln!(
            out,
            "  displacement x, y, z (um), rx, rz (mrad)  {}",
            five([q.x_um, q.y_um, q.z_um, q.rx_mrad, q.rz_mrad])
        )?;
        let angles = self.contact_angle_deg.map_or(String::new(), |[low, high]| {
            format!(", contact angles {} to {} deg", significant(low, 4), significant(high, 4))
        });
        let most = self.element_loads_n.iter().copied().fold(0.0, f64::max);
        writeln!(
            out,
            "  {} of {} elements loaded, at most {} N{angles}",
            self.loaded_elements,
            self.elements,
            significant(most, 5)
        )?;
        writeln!(out, "  load of each element (N), from the one at +z towards +x")?;
        let loads: Vec<String> = self.element_loads_n.iter().map(|load| significant(*load, 4)).collect();
        for line in wrapped(&loads, 74) {
            writeln!(out, "    {line}")?;
        }
        if let Some(note) = &self.note {
            writeln!(out, "  note: {note}")?;
        }
        self.warnings.iter().try_for_each(|warning| writeln!(out, "  warning: {warning}"))
    }
}
