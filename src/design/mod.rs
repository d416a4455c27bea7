//! What the user writes: design files, read whole and checked before anything is used.

mod model;

pub use model::*;
