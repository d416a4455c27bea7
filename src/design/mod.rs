//! What the user writes: design files, read whole and checked before anything is used.
//!
//! ```text
//! file --load--> text --read--> Design + findings
//!                  |
//!               Document (edits that keep everything else as it was)
//! ```

#[macro_use]
mod declare;
mod check;
mod finding;
mod key_path;
mod model;
mod read;
mod render;
mod rotor;
pub mod schema;
mod side;

pub use check::MAX_STATIONS;
pub use finding::{Finding, Severity};
pub use key_path::{KeyPath, KeyPathError, Step};
pub use model::*;
pub use read::{Reading, read};
pub use render::{Position, Source};
pub use rotor::*;
pub use side::Side;
