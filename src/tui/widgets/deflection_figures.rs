//! The mesh forces of all models at the frequency of a deflection shape, and how large each shape is.
//!
//! ```text
//!  at 541.72 Hz            FE   enhanced      basic  reduced:3
//!  mesh force, N         43.1      42.9      7.01       43.1
//!  largest motion, m  8.36e-6   8.30e-6   1.02e-6    8.36e-6
//!  rotation, rad      1.21e-4   ...
//! ```

use num_complex::Complex;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::wide_plot::style;
use crate::model::ModelKind;
use crate::number::significant;
use crate::tui::modes::{Deflection, DeflectionShapes, Study};
use crate::tui::spectra::legend_name;
use crate::tui::theme::Theme;

const LABEL: usize = 22;
const MODEL: usize = 12;

/// What stands in a cell.
type Shown<'a> = dyn Fn(ModelKind, &Deflection) -> String + 'a;

/// Draws a row a quantity; of two rows the second one is the force, of more the others are what moves.
pub fn render(study: &Study, found: &DeflectionShapes, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let kinds = study.small().map(|small| small.own.kind());
    let models: Vec<(ModelKind, &Deflection)> =
        std::iter::once((ModelKind::Fe, &found.fe)).chain(kinds.zip(&found.small)).collect();
    let at = format!("at {} Hz", significant(found.at_hz, 5));
    let lines: [(&str, &Shown); 4] = [
        (&at, &|kind, _| legend_name(kind)),
        ("mesh force, N", &|_, one| significant(one.force.norm(), 4)),
        ("largest motion, m", &|_, one| significant(largest(one, 0..3), 3)),
        ("largest rotation, rad", &|_, one| significant(largest(one, 3..6), 3)),
    ];
    for ((label, value), y) in lines.into_iter().zip(area.top()..area.bottom()) {
        buffer.set_stringn(area.x, y, format!(" {label:<LABEL$}"), usize::from(area.width), theme.faint);
        let mut x = area.x + 1 + LABEL as u16;
        for (kind, one) in &models {
            // what does not fit as a whole is left out
            if usize::from(area.right().saturating_sub(x)) < MODEL {
                break;
            }
            x = buffer.set_stringn(x, y, format!("{:>MODEL$}", value(*kind, one)), MODEL, style(*kind, theme)).0;
        }
    }
}

/// The largest amplitude of some of the six displacements over both shafts.
fn largest(one: &Deflection, components: std::ops::Range<usize>) -> f64 {
    let stations = one.shapes.iter().flat_map(|shaft| &shaft.displacements);
    let entries = stations.flat_map(|station| station.get(components.clone()).unwrap_or_default());
    entries.copied().map(Complex::norm).fold(0.0, f64::max)
}
