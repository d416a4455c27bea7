//! The bearings of a design under its mean load: what the keys do to them, and what is known of each.
//!
//! The screen lies over the tables of the design: all edits are theirs, and so is the solution that is shown.

mod keys;
mod since_saved;
mod states;
mod text;
mod torque;

pub use since_saved::since_saved;
pub use states::{BearingStates, SideStates, displacement, load, resultant};
pub use torque::{shown_torque, stepped, torque};

use super::app::Scroll;
use super::editor::{Editing, Tab, same_mechanics};
use super::text_field::TextField;
use crate::bearing::State;
use crate::design::{Bearing, Design, Side};
use crate::number::grouped;
use crate::rotor::{Rolling, Support};

/// What is seen where there is no room for everything.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Pane {
    #[default]
    Spectra,
    /// Loads, displacement and stiffness
    State,
    /// The picture of the elements
    Elements,
}

/// What the screen shows of a design.
#[derive(Debug, Clone, Default)]
pub struct BearingsView {
    /// Among all bearings, those of the pinion first
    pub cursor: usize,
    pub scroll: Scroll,
    /// The element that is read out
    pub element: usize,
    pub pane: Pane,
    /// Panes that share one place; known after the first frame
    pub shared: Vec<Pane>,
    /// The torque while it is typed
    pub field: TextField,
    /// Whether it was opened from the list of designs, and leads back there.
    pub(super) from_list: bool,
}

/// One bearing, and what the last solution says of it.
#[derive(Debug, Clone, Copy)]
pub struct BearingRow<'a> {
    pub side: Side,
    pub place: usize,
    pub bearing: &'a Bearing,
    pub support: Option<&'a Support>,
    pub rolling: Option<&'a Rolling>,
}

/// Side and place of all bearings of a design, those of the pinion first.
fn places(design: &Design) -> impl Iterator<Item = (Side, usize)> {
    Side::BOTH.into_iter().flat_map(|side| (0..design.rotor(side).bearings.len()).map(move |place| (side, place)))
}

/// All bearings of the design as it is now, or as it was before it had errors.
pub fn rows(editing: &Editing) -> Vec<BearingRow<'_>> {
    let Some(design) = &editing.last_design else { return Vec::new() };
    let solution = editing.solving.current.as_ref();
    let row = |(side, place): (Side, usize)| {
        let bearing = &design.rotor(side).bearings[place];
        // rows may have moved since
        let of_same = solution.filter(|solution| {
            let then = solution.design.rotor(side).bearings.get(place);
            then.is_some_and(|then| then.name == bearing.name && then.model.word() == bearing.model.word())
        });
        let states = of_same.and_then(|solution| solution.bearings.as_ref()).map(|states| states.side(side));
        BearingRow {
            side,
            place,
            bearing,
            support: states.and_then(|states| states.supports.get(place)),
            rolling: states.and_then(|states| states.rolling.get(place)?.as_ref()),
        }
    };
    places(design).map(row).collect()
}

/// Why the design as it is now cannot be solved, if that was found out.
pub fn failure(editing: &Editing) -> Option<&str> {
    editing.design.as_ref().and_then(|design| editing.solving.failure(design))
}

/// What a failure says of one bearing, in one word such as `NO_CONTACT`; nothing where it is not about it.
pub fn failure_of<'a>(reason: &'a str, row: &BearingRow<'_>) -> Option<&'a str> {
    let of_side = ["both shafts: ".to_owned(), format!("{} shaft: ", row.side.name())].into_iter().find_map(|who| {
        let start = reason.find(&who)?;
        let rest = &reason[start..];
        Some(rest.find("; gear shaft: ").map_or(rest, |end| &rest[..end]))
    })?;
    let is_named = of_side.contains(&format!("bearing \"{}\"", row.bearing.name.escape_debug()));
    // what is about the whole shaft is about all bearings that were looked for with it
    let is_of_shaft = !of_side.contains("bearing \"") && row.bearing.model.follows_torque();
    if !is_named && !is_of_shaft {
        return None;
    }
    let is_code =
        |word: &&str| word.len() > 3 && word.chars().all(|letter| letter.is_ascii_uppercase() || letter == '_');
    of_side.split([' ', ':']).find(is_code)
}

/// What is known of the bearing under the cursor of the tables under load, in a line.
pub fn in_words(editing: &Editing) -> Option<String> {
    if editing.tab != Tab::Bearings || is_stale(editing) {
        return None;
    }
    let rows = rows(editing);
    let at = (editing.side, editing.cursor().row);
    let rolling = rows.iter().find(|row| (row.side, row.place) == at)?.rolling?;
    let (load, state) = (load(rolling), &rolling.state);
    let [x, y, z] = [load[0], load[1], load[2]].map(grouped);
    let (loaded, elements, angles) = (state.loaded(), state.contacts.len(), angles(state));
    Some(format!("load {x}, {y}, {z} N in x, y, z, {loaded} of {elements} loaded at {angles} deg"))
}

/// Contact angles of the loaded elements, from the least to the greatest, deg.
pub fn angles(state: &State) -> String {
    let Some(range) = state.angle_range() else { return "-".into() };
    let [low, high] = range.map(|angle| format!("{:.1}", angle.to_degrees()));
    if low == high { low } else { format!("{low}..{high}") }
}

/// Whether a bearing of the design takes its load from the torque.
pub fn follows_torque(editing: &Editing) -> bool {
    editing.last_design.as_ref().is_some_and(|design| design.follows_torque())
}

/// Whether the states that are shown are not those of the design as it is now.
pub fn is_stale(editing: &Editing) -> bool {
    match (&editing.solving.current, &editing.design) {
        (Some(solution), Some(design)) => !same_mechanics(&solution.design, design),
        (Some(_), None) => true,
        (None, _) => false,
    }
}
