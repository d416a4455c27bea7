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
mod text;

use std::sync::Arc;

pub use job::{Answer, ModesJob, Wanted, perform};
pub use rows::{ModeRow, Partner};
pub use study::{Deflection, DeflectionShapes, MODELS, ModelStudy, SmallStudy, Study};

use super::app::Scroll;
use super::solving::Ticket;
use super::text_field::TextField;
use crate::model::ModelKind;
use crate::response::{Mode, StationShape};

/// Steps of a period.
pub const PHASES: usize = 8;

/// Fixed-interface modes a rotor of the reduced model, at first and at most.
const FIRST_REDUCED: usize = 3;
const MOST_REDUCED: usize = 99;

/// m: makes a rotation comparable with a displacement.
const LEVER: f64 = 0.1;
/// The smallest rotation that is told beside a displacement.
const ROUNDING: f64 = 1e-6;

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
    /// Place among [`Study::small`] of the model that is drawn beside finite elements.
    pub model: usize,
    /// Fixed-interface modes a rotor of the reduced model, and whether it is being computed.
    pub reduced: usize,
    pub is_reducing: bool,
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
    /// Each: pinion, gear. Finite elements come first, where they have the mode.
    pub shapes: Vec<(ModelKind, [StationShape<f64>; 2])>,
    /// The largest displacement across the shafts over the whole period, m, and the largest rotation about them, rad: those of all shapes. What
    /// rounding leaves of a rotation is 0.
    pub largest: [f64; 2],
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

    /// The model whose mode is shown beside that of finite elements, or without one.
    fn partner_model(&self) -> usize {
        self.row().and_then(ModeRow::model).unwrap_or(self.model)
    }

    /// The modes that the selected row is about, that of finite elements first, where they have it.
    pub fn pair(&self) -> Vec<(ModelKind, &Mode)> {
        let (Some(study), Some(row)) = (self.study(), self.row()) else { return Vec::new() };
        let fe = row.fe.and_then(|fe| Some((ModelKind::Fe, study.fe.modes.0.get(fe)?)));
        let model = self.partner_model();
        let partner = row.partner_mode(model, study).zip(study.one(model));
        let partner = partner.map(|(mode, small)| (small.own.kind(), mode));
        fe.into_iter().chain(partner).collect()
    }

    /// The shapes as they are at the present phase; nothing while they are computed.
    pub fn moment(&self) -> Option<Moment> {
        let angle = std::f64::consts::TAU * self.phase as f64 / PHASES as f64;
        let mut shapes = Vec::new();
        let mut largest = [0.0_f64; 2];
        if self.deflection_hz.is_some() {
            let found = self.deflection.as_ref()?.as_ref().ok()?;
            let turned = num_complex::Complex64::from_polar(1.0, angle);
            let study = self.study()?;
            let fe = (study.fe.kind(), &found.fe.shapes);
            let other = study.one(self.model).zip(found.small.get(self.model));
            let other = other.map(|(small, deflection)| (small.own.kind(), &deflection.shapes));
            for (of, shape) in std::iter::once(fe).chain(other) {
                largest = over(largest, shape, num_complex::Complex::norm);
                shapes.push((of, shape.each_ref().map(|shaft| at_moment(shaft, |value| (value * turned).re))));
            }
        } else {
            let (study, row) = (self.study()?, self.row()?);
            let fe = row.fe.map(|fe| (ModelKind::Fe, &study.fe.shapes[fe]));
            let model = self.partner_model();
            let partner = study.one(model).zip(row.partners[model]);
            let partner = partner.map(|(small, one)| (small.own.kind(), &small.own.shapes[one.mode]));
            for (of, shape) in fe.into_iter().chain(partner) {
                largest = over(largest, shape, f64::abs);
                shapes.push((of, shape.each_ref().map(|shaft| at_moment(shaft, |value| value * angle.cos()))));
            }
        }
        let [across, about] = largest;
        // next to motions across the shafts, what rounding leaves of rotations is none
        let about = if LEVER * about > ROUNDING * across { about } else { 0.0 };
        Some(Moment { shapes, largest: [across, about] })
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
