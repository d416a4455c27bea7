//! The gear pair of a design: what its teeth do to both shafts in numbers and as a picture to scale, an estimate of its stiffness, and
//! averaged results of a contact program as an edit.
//!
//! Screen, commands and reports show the same figures, since all take them from here.

mod bevel;
mod document;
mod estimate;
mod figures;
mod import;
mod parallel;
mod scene;
mod thrust;

pub use document::{data, notes, sketch, table_of};
pub use estimate::{Estimate, METHOD, spiral_angle};
pub use figures::{Arms, PairFigures, ShaftFigures};
pub use import::{Flank, edit_of, import_notes, read_flanks};
pub use scene::{Role, Scene, Shape, scenes};
