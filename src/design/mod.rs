//! What the user writes: design files, read whole and checked before anything is used.

mod model;
mod side;

pub use model::*;
pub use side::Side;
