//! Properties that hold for every valid design, on random ones.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

#[path = "../support/mod.rs"]
mod support;

mod extremes;
mod generator;
mod models;
mod rotors;
mod spectra;

use bevelscope::design::Design;
use bevelscope::model::{Model, ModelKind, Rotors};

fn models(design: &Design) -> [Model; 3] {
    let rotors = Rotors::new(design).unwrap();
    ModelKind::ALL.map(|kind| Model::new(kind, design, &rotors).unwrap())
}
