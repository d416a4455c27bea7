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
/// has any. `file` is harmless to show. Beside each number stands that it is imported and from which file, in place of comments on what was there.
pub fn edit_of(mesh: &AveragedMesh, editor: &Editor, file: &str) -> Edit {
    let top = KeyPath::root().key("mesh");
    let source = format!("imported: {file}, {} flank", mesh.flank);
    let comment = |path: KeyPath| Edit::Comment { path, text: source.clone() };
    let set = |path: KeyPath, text: String| {
        let value = Spelled::parse(&text);
        value
            .into_iter()
            .flat_map(|value| [Edit::Set { path: path.clone(), value }, comment(path.clone())])
            .collect::<Vec<_>>()
    };
    let geometry = Some(top.key("geometry")).filter(|path| editor.is_written(path));
    let mut edits: Vec<Edit> = geometry.into_iter().map(|path| Edit::Remove { path }).collect();
    for (side, (point, line)) in Side::BOTH.into_iter().zip(mesh.sides) {
        edits.extend(set(top.key(side.name()).key("point_mm"), format!("{point:?}")));
        edits.extend(set(top.key(side.name()).key("line_of_action"), format!("{line:?}")));
        edits.push(comment(top.key(side.name())));
    }
    edits.extend(set(top.key("transmission_error_um"), format!("{:?}", mesh.transmission_error_um)));
    edits.extend(set(top.key("stiffness_n_per_m"), format!("{:e}", mesh.stiffness_n_per_m)));
    let name = EditName::new(format!("averaged mesh numbers of the {} flank", mesh.flank));
    Edit::Several { edits, name }
}

/// Angle between an imported line of action and that of the gear data beyond which they are not of one tooth: pressure angles of
/// hypoid flanks and averaging over a contact pattern stay below, rad.
const ODD_ANGLE: f64 = 10.0 * std::f64::consts::PI / 180.0;

/// What else is to be known before the flank is taken over, in sentences: what was rescaled, that gear data go, and where the vectors are not those
/// that follow from these for either flank.
pub fn import_notes(mesh: &AveragedMesh, editor: &Editor) -> Vec<String> {
    let geometry = KeyPath::root().key("mesh").key("geometry");
    let mut notes = mesh.notes.clone();
    if !editor.is_written(&geometry) {
        return notes;
    }
    notes.push(format!("[mesh.geometry] is taken out, {} keys with their comments", editor.count_keys(&geometry)));
    let mut flanks = Vec::new();
    for turns in ["\"positive\"", "\"negative\""] {
        let mut turned = editor.clone();
        let value = Spelled::parse(turns).map(|value| Edit::Set { path: geometry.key("pinion_turns"), value });
        if value.is_some_and(|edit| turned.apply(&edit).is_ok()) {
            flanks.extend(
                turned
                    .reading()
                    .design
                    .as_ref()
                    .map(|design| [&design.mesh.pinion, &design.mesh.gear].map(|side| side.line_of_action)),
            );
        }
    }
    let off = |lines: &[[f64; 3]; 2]| [0, 1].map(|side| angle(lines[side], mesh.sides[side].1));
    // the flank that one of the sides fits: of a vector that is reversed on one side only, the other side says which it is
    let nearest = flanks.iter().map(off).min_by(|a, b| a[0].min(a[1]).total_cmp(&b[0].min(b[1])));
    for (side, angle) in
        Side::BOTH.into_iter().zip(nearest.into_iter().flatten()).filter(|(_, angle)| *angle > ODD_ANGLE)
    {
        notes.push(format!(
            "warning: {}_line is {:.0} deg away from the tooth normal of [mesh.geometry], on either flank: check its signs and the order of its components",
            side.name(),
            angle.to_degrees()
        ));
    }
    notes
}

fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
    let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    (dot(a, b) / (dot(a, a) * dot(b, b)).sqrt()).clamp(-1.0, 1.0).acos()
}
