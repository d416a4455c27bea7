//! Edits of a design by meaning: each one changes the bytes it is about and no others, has a name, and can be undone.
//!
//! ```
//! use bevelscope::design::{Edit, Editor, Spelled, library::SHIPPED};
//!
//! let mut editor = Editor::new(SHIPPED[0].text)?;
//! let path = "pinion.bearing[head bearing].kx_n_per_m".parse()?;
//! let applied = editor.apply(&Edit::Set { path, value: Spelled::parse("6.5e8").unwrap() })?;
//! assert_eq!(applied.name.as_str(), "kx of pinion bearing head bearing");
//! assert!(editor.is_modified() && editor.reading().design.is_some());
//! editor.undo();
//! assert_eq!(editor.text(), SHIPPED[0].text);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bearing;
mod editor;
mod history;
mod material;
mod name;
mod row;
mod spelled;
mod steps;
mod value;

pub use editor::{Applied, Editor};
pub use name::EditName;
pub use spelled::Spelled;

use super::KeyPath;

/// One edit of a design, as a person means it. Rows are named by their key path, by place or by name:
/// `pinion.bearing[0]`, `pinion.bearing[B1]`.
#[derive(Debug, Clone, PartialEq)]
pub enum Edit {
    /// Writes a value. A key or table that is not there is added. An entry of a vector or of a matrix is a value of its
    /// own (`mesh.pinion.point_mm[2]`); of a matrix the mirrored entry changes as well.
    Set { path: KeyPath, value: Spelled },
    /// Takes a key or a table out, so that its default holds again.
    Remove { path: KeyPath },
    /// Says something, on one line, beside a value or a header in place of the comments at the end of its line and right above it.
    /// Nothing changes where it has no line of its own.
    Comment { path: KeyPath, text: String },
    /// Adds a row with starting values to a list of tables; the row has that place afterwards.
    InsertRow { list: KeyPath, place: usize },
    /// Adds a copy of the row after it, with a name of its own.
    DuplicateRow { row: KeyPath },
    /// Takes the row out.
    DeleteRow { row: KeyPath },
    /// Swaps the row, with the comments that belong to it, with its neighbour.
    MoveRow { row: KeyPath, towards: Towards },
    /// Gives a bearing another model: the keys of the old one go, those of the new one come with starting values.
    SetModel { bearing: KeyPath, model: String },
    /// Adds a material with the values of steel.
    AddMaterial { name: String },
    /// Renames a material, also where segments name it.
    RenameMaterial { from: String, to: String },
    /// Takes a material out. Segments that name it keep the name, and findings say so.
    RemoveMaterial { name: String },
    /// Several edits as one, called by what they are for.
    Several { edits: Vec<Edit>, name: EditName },
    /// Takes over a whole text, e.g. that of the file after someone else changed it.
    ReplaceText { text: String, name: EditName },
}

/// Which way a row moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Towards {
    Start,
    End,
}
