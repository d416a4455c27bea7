//! Averaged mesh numbers of a contact program, as one edit of a design.

use crate::design::{Edit, EditName, Editor, KeyPath, Side, Spelled};
use crate::gear::{AveragedMesh, read_csv};

/// A flank of a table of mesh numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flank {
    Drive,
    Coast,
}

impl Flank {
    pub fn word(self) -> &'static str {
        match self {
            Self::Drive => "drive",
            Self::Coast => "coast",
        }
    }

    #[must_use]
    pub fn other(self) -> Self {
        match self {
            Self::Drive => Self::Coast,
            Self::Coast => Self::Drive,
        }
    }

    /// The numbers of this flank.
    ///
    /// # Errors
    ///
    /// The table has no line for it, in words.
    pub fn of(self, flanks: &[AveragedMesh]) -> Result<&AveragedMesh, String> {
        let word = self.word();
        flanks.iter().find(|mesh| mesh.flank == word).ok_or_else(|| format!("there is no line for the flank {word}"))
    }
}

/// All flanks of a table.
///
/// # Errors
///
/// What is wrong, with the line and what is allowed there. Texts of the table may stand in it.
pub fn read_flanks(text: &str) -> Result<Vec<AveragedMesh>, String> {
    read_csv(text).map_err(|error| error.to_string())
}

/// Mesh point, line of action, stiffness and transmission error of one flank, for the text as it is in `editor`: vectors take the place of gear data, if it
/// has any.
pub fn edit_of(mesh: &AveragedMesh, editor: &Editor) -> Edit {
    let top = KeyPath::root().key("mesh");
    let set = |path: KeyPath, text: String| Some(Edit::Set { path, value: Spelled::parse(&text)? });
    let geometry = Some(top.key("geometry")).filter(|path| editor.is_written(path));
    let mut edits: Vec<Option<Edit>> = geometry.into_iter().map(|path| Some(Edit::Remove { path })).collect();
    for (side, (point, line)) in Side::BOTH.into_iter().zip(mesh.sides) {
        edits.push(set(top.key(side.name()).key("point_mm"), format!("{point:?}")));
        edits.push(set(top.key(side.name()).key("line_of_action"), format!("{line:?}")));
    }
    edits.push(set(top.key("transmission_error_um"), format!("{:?}", mesh.transmission_error_um)));
    edits.push(set(top.key("stiffness_n_per_m"), format!("{:e}", mesh.stiffness_n_per_m)));
    let name = EditName::new(format!("averaged mesh numbers of the {} flank", mesh.flank));
    Edit::Several { edits: edits.into_iter().flatten().collect(), name }
}
