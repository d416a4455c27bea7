//! The natural modes of a design: what the screen shows, and what its keys do.
//!
//! ```text
//! key ─> ModesJob ─> Backend ─> Study ─> rows, shapes, MAC
//!                      └─ Study, Hz ─> DeflectionShapes
//! ```

mod job;
mod keys;
mod rows;
mod study;

use std::sync::Arc;

pub use job::{Answer, ModesJob, Wanted, perform};
pub use rows::{ModeRow, Partner};
pub use study::{DeflectionShapes, ModelStudy, Study};

use super::app::Scroll;
use super::solving::Ticket;
use super::text_field::TextField;
use crate::number::significant;
use crate::response::StationShape;

/// Steps of a period.
pub const PHASES: usize = 8;

/// Names of the lumped models, in the order of [`Study::lumped`].
pub const LUMPED: [&str; 2] = ["enhanced", "basic"];

/// The view.
#[derive(Debug)]
pub struct ModesView {
    /// The latest request; results of others are refused.
    pub ticket: Ticket,
    /// The design's file, safe to show, and whether its unsaved edits count.
    pub name: String,
    /// The same without that
    pub stem: String,
    /// Or why there are none.
    pub study: Option<Result<Arc<Study>, String>>,
    pub rows: Vec<ModeRow>,
    /// Place in `rows`.
    pub cursor: usize,
    pub scroll: Scroll,
    /// Which of the lumped models is drawn beside finite elements.
    pub lumped: usize,
    /// Eighths of a period.
    pub phase: usize,
    /// The cursor in the MAC picture, row and column, while that is shown.
    pub mac: Option<(usize, usize)>,
    /// The deflection shape is wanted in place of the mode, at this frequency (Hz).
    pub deflection_hz: Option<f64>,
    pub deflection: Option<Result<Arc<DeflectionShapes>, String>>,
    /// A frequency that is being typed.
    pub field: TextField,
}

/// A shape at one moment, and a second one beside it.
#[derive(Debug)]
pub struct Moment {
    /// Each: pinion, gear. The first is drawn solid: finite elements, or the mode without a partner.
    pub shapes: Vec<(ShapeOf, [StationShape<f64>; 2])>,
    /// The largest displacement across the shafts over the whole period, m, and the largest rotation about them, rad: those of all shapes.
    pub largest: [f64; 2],
}

/// Whose shape it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShapeOf {
    Fe,
    /// Place in [`LUMPED`]
    Lumped(usize),
}

impl ModesView {
    pub fn study(&self) -> Option<&Arc<Study>> {
        self.study.as_ref().and_then(|study| study.as_ref().ok())
    }

    /// Rows of a page.
    pub fn page(&self) -> isize {
        self.scroll.page()
    }

    pub fn row(&self) -> Option<&ModeRow> {
        self.rows.get(self.cursor)
    }

    /// The shapes as they are at the present phase; nothing while they are computed.
    pub fn moment(&self) -> Option<Moment> {
        let angle = std::f64::consts::TAU * self.phase as f64 / PHASES as f64;
        let mut shapes = Vec::new();
        let mut largest = [0.0_f64; 2];
        if self.deflection_hz.is_some() {
            let found = self.deflection.as_ref()?.as_ref().ok()?;
            let turned = num_complex::Complex64::from_polar(1.0, angle);
            for (of, shape) in [(ShapeOf::Fe, &found.fe), (ShapeOf::Lumped(self.lumped), &found.lumped[self.lumped])] {
                largest = over(largest, shape, num_complex::Complex::norm);
                shapes.push((of, shape.each_ref().map(|shaft| at_moment(shaft, |value| (value * turned).re))));
            }
        } else {
            let (study, row) = (self.study()?, self.row()?);
            let fe = row.fe.map(|fe| (ShapeOf::Fe, &study.fe.shapes[fe]));
            let model = if row.fe.is_some() { self.lumped } else { usize::from(row.lumped[0].is_none()) };
            let lumped = row.lumped[model].map(|one| (ShapeOf::Lumped(model), &study.lumped[model].shapes[one.mode]));
            for (of, shape) in fe.into_iter().chain(lumped) {
                largest = over(largest, shape, f64::abs);
                shapes.push((of, shape.each_ref().map(|shaft| at_moment(shaft, |value| value * angle.cos()))));
            }
        }
        Some(Moment { shapes, largest })
    }

    /// The table as lines with tabs, for a spreadsheet.
    pub fn as_text(&self) -> Option<String> {
        let study = self.study()?;
        let mut lines =
            vec!["FE\tFE Hz\tname\tenhanced Hz\tshift %\tMAC\tbasic Hz\tshift %\tMAC\tmesh strain %".to_owned()];
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
            for partner in &row.lumped {
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

fn at_moment<T: Copy>(shaft: &StationShape<T>, real: impl Fn(T) -> f64) -> StationShape<f64> {
    StationShape {
        positions: shaft.positions.clone(),
        displacements: shaft.displacements.iter().map(|station| station.map(&real)).collect(),
        drive: shaft.drive.map(&real),
    }
}

fn over<T: Copy>(largest: [f64; 2], shape: &[StationShape<T>; 2], size: impl Fn(T) -> f64) -> [f64; 2] {
    shape.iter().fold(largest, |[across, about], shaft| {
        let stations = || shaft.displacements.iter();
        let across = stations().flat_map(|d| [d[0], d[1], d[2]]).map(&size).fold(across, f64::max);
        let about = stations().map(|d| size(d[4])).chain(shaft.drive.map(&size)).fold(about, f64::max);
        [across, about]
    })
}
