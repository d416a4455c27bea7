//! What the user writes: design files, read whole and checked before anything is used.
//!
//! ```text
//! file --load--> text --read--> Design + findings
//!                  |
//!                Editor (edits that keep everything else as it was) --save--> file
//! ```

#[macro_use]
mod declare;
mod align;
mod changes;
mod check;
mod diff;
mod document;
mod draft;
mod edit;
mod finding;
mod geometry;
pub mod grid;
mod hash;
mod key_path;
mod label;
pub mod library;
mod load;
mod model;
pub mod new;
mod read;
pub mod reference;
mod render;
mod rolling;
mod rotor;
mod save;
pub mod schema;
mod side;
mod station;
mod text_file;
mod totals;

pub use changes::{Changes, LineChange};
pub use diff::{Difference, changed_cells, diff};
pub use document::{Document, EditError};
pub use edit::{Applied, Edit, EditName, Editor, Spelled, Towards};
pub use finding::{Finding, Severity};
pub use geometry::*;
pub use hash::hash;
pub use key_path::{KeyPath, KeyPathError, Step};
pub use load::{LoadError, Loaded, MAX_BYTES, load, load_from};
pub use model::*;
pub(crate) use read::did_you_mean;
pub use read::{Reading, read};
pub use render::{Position, Source};
pub use rolling::*;
pub use rotor::*;
pub use save::{SaveError, save, save_new};
pub use side::Side;
pub use station::{MAX_STATIONS, SAME_STATION};
pub(crate) use text_file::{TextError, read_text};
pub use totals::Totals;
