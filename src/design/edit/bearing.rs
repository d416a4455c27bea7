//! Giving a bearing another model.

use super::steps::Steps;
use super::{Spelled, row};
use crate::design::document::Tree;
use crate::design::key_path::KeyPath;
use crate::design::schema::{Field, Kind, Presence, Table, Variant, Written, target};
use crate::design::{EditError, Hold};

/// The springs of a diagonal bearing with their places in the matrix.
const SPRINGS: [(&str, usize); 5] =
    [("kx_n_per_m", 0), ("ky_n_per_m", 1), ("kz_n_per_m", 2), ("krx_n_m_per_rad", 3), ("krz_n_m_per_rad", 5)];

/// What a held translation becomes as a spring, N/m: stiffer than rolling bearings, soft enough for good numerics.
const STIFF: &str = "1.0e9";
const NONE: &str = "0.0";

/// What a ball or roller bearing starts with: sizes of a 35 x 72 mm bearing, under an axial preload.
const TYPICAL: [(&str, &str, &str); 13] = [
    ("ball", "elements", "12"),
    ("ball", "contact_angle_deg", "40.0"),
    ("ball", "ball_diameter_mm", "11.1125"),
    ("ball", "pitch_diameter_mm", "53.5"),
    ("ball", "inner_groove_factor", "0.52"),
    ("ball", "outer_groove_factor", "0.52"),
    ("ball", "preload", "{ y_n = 1000.0 }"),
    ("roller", "elements", "17"),
    ("roller", "contact_angle_deg", "20.0"),
    ("roller", "pitch_radius_mm", "27.5"),
    ("roller", "contact_stiffness_n_per_m_10_9", "9.6e8"),
    ("roller", "roller_length_mm", "17.0"),
    ("roller", "preload", "{ y_n = 5000.0 }"),
];

/// How the mean state of a bearing can be said.
const MEAN_STATES: [&str; 3] = ["displacement", "preload", "mean_load"];

/// The value of a key that a ball or roller bearing starts with; what the old model says stays.
fn typical(word: &str, row: &Tree, key: &'static str) -> Option<(&'static str, String)> {
    let is_said =
        row.get(key).is_some() || MEAN_STATES.contains(&key) && MEAN_STATES.iter().any(|key| row.get(key).is_some());
    let value = TYPICAL.iter().find(|typical| (typical.0, typical.1) == (word, key));
    value.filter(|_| !is_said).map(|(.., value)| (key, (*value).to_owned()))
}

const STIFFNESS: &str = "stiffness";
const PITCH_RADIUS: &str = "pitch_radius_mm";
const HOLD: &str = "hold";
const AXIAL_SERIES: &str = "axial_series_stiffness_n_per_m";

/// Takes the keys of the other models out, and writes those of the new one that must be there. What the old model says
/// about a direction, the new one says in its way.
pub(super) fn set_model(steps: &mut Steps, bearing: &KeyPath, word: &str) -> Result<KeyPath, EditError> {
    let tree = steps.tree();
    let row = tree.at(bearing).cloned().ok_or_else(|| EditError::NotThere(bearing.clone()))?;
    let (field, variants) = choice(bearing).ok_or_else(|| EditError::NotThere(bearing.key("model")))?;
    let table = table_of(variants, word)?;
    let path = bearing.key(field.key);
    let default = match field.presence {
        Presence::Default(Written::Text(word)) => Some(word.to_owned()),
        _ => None,
    };
    let old = row.get(field.key).map_or(default, Tree::text);
    if old.as_deref() == Some(word) {
        return Ok(path);
    }
    steps.put(&path, Spelled::text(word).as_str())?;
    let keys = new_keys(steps, bearing, &row, table);
    let others = variants.iter().flat_map(|variant| variant.table.fields);
    for key in others.map(|field| field.key).filter(|key| table.field(key).is_none() && row.get(key).is_some()) {
        if steps.tree().at(&bearing.key(key)).is_some() {
            steps.remove(&bearing.key(key))?;
        }
    }
    // a ball bearing starts from its geometry, which its radius follows from
    if word == "ball" && row.get(PITCH_RADIUS).is_some() {
        steps.remove(&bearing.key(PITCH_RADIUS))?;
    }
    let holds_y = keys.iter().any(|(key, value)| *key == HOLD && value.contains("\"y\""));
    for (key, value) in keys {
        steps.put(&bearing.key(key), &value)?;
    }
    if holds_y && row.get(AXIAL_SERIES).is_some() {
        steps.remove(&bearing.key(AXIAL_SERIES))?;
    }
    Ok(path)
}

/// The key that chooses among models.
fn choice(bearing: &KeyPath) -> Option<(&'static Field, &'static [Variant])> {
    target(bearing)?.table.fields.iter().find_map(|field| match field.kind {
        Kind::Variant(variants) => Some((field, variants)),
        _ => None,
    })
}

fn table_of(variants: &'static [Variant], word: &str) -> Result<&'static Table, EditError> {
    let variant = variants.iter().find(|variant| variant.word == word);
    variant.map(|variant| variant.table).ok_or_else(|| {
        let words: Vec<&str> = variants.iter().map(|v| v.word).collect();
        EditError::Refused(format!("the model must be one of {}", words.join(", ")))
    })
}

/// The keys that the new model starts with.
fn new_keys(steps: &Steps, bearing: &KeyPath, row: &Tree, table: &'static Table) -> Vec<(&'static str, String)> {
    let diagonal = diagonal(row);
    let is_stiff = |i: usize| Tree::Value(diagonal[i].clone()).number().is_some_and(|stiffness| stiffness > 0.0);
    let held: Vec<&str> = Hold::WORDS.iter().enumerate().filter(|(i, _)| is_stiff(*i)).map(|(_, word)| *word).collect();
    let held = if held.is_empty() { Hold::WORDS.to_vec() } else { held };
    let table_word = table.name.split(' ').next().unwrap_or_default();
    let value = |field: &'static Field| {
        if let Some((key, place)) = SPRINGS.iter().find(|(key, _)| *key == field.key) {
            return Some((*key, diagonal[*place].clone()));
        }
        match field.key {
            STIFFNESS => {
                let entry = |i: usize, j: usize| if i == j { diagonal[i].clone() } else { NONE.to_owned() };
                let rows = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
                Some((STIFFNESS, matrix(steps, bearing, &rows)))
            }
            _ if TYPICAL.iter().any(|(word, ..)| *word == table_word) => typical(table_word, row, field.key),
            HOLD => Some((HOLD, Spelled::texts(held.iter().copied()).as_str().into())),
            key if row.get(key).is_some() => None,
            key => (field.presence == Presence::Required).then(|| (key, row::first(field))),
        }
    };
    table.fields.iter().filter_map(value).collect()
}

/// The diagonal of the stiffness as the old model has it, spelled as there.
fn diagonal(row: &Tree) -> [String; 6] {
    let held = row.get(HOLD).map(|hold| hold.entries().iter().filter_map(Tree::text).collect::<Vec<_>>());
    std::array::from_fn(|i| {
        let spring = SPRINGS.iter().find(|(_, place)| *place == i).and_then(|(key, _)| row.get(key));
        let entry = row.get(STIFFNESS).and_then(|rows| rows.entries().get(i)?.entries().get(i));
        if let Some(value) = spring.or(entry).filter(|value| value.number().is_some()) {
            return value.raw().unwrap_or(NONE).into();
        }
        let is_held = |held: &Vec<String>| Hold::WORDS.get(i).is_some_and(|word| held.iter().any(|held| held == word));
        if held.as_ref().is_some_and(is_held) { STIFF.into() } else { NONE.into() }
    })
}

/// Six rows of six numbers: each in a line of its own, unless the bearing stands in one line.
pub(super) fn matrix(steps: &Steps, bearing: &KeyPath, rows: &[[String; 6]; 6]) -> String {
    let rows: Vec<String> = rows.iter().map(|row| format!("[{}]", row.join(", "))).collect();
    if steps.document.raw(bearing).is_some() {
        return format!("[{}]", rows.join(", "));
    }
    let line_break = steps.document.line_break();
    let between = format!(",{line_break}    ");
    format!("[{line_break}    {},{line_break}]", rows.join(&between))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::{BallBearing, Bearing, DiagonalBearing, MatrixBearing, Preload, RigidBearing, RollerBearing};

    // A key that has another name in the schema would be left out of a new model without a word.
    #[test]
    fn the_keys_here_are_those_of_the_schema() {
        let springs: Vec<&str> = DiagonalBearing::TABLE.fields.iter().map(|field| field.key).collect();
        assert_eq!(springs, SPRINGS.map(|(key, _)| key));
        assert!(MatrixBearing::TABLE.field(STIFFNESS).is_some());
        assert!(RigidBearing::TABLE.field(HOLD).is_some());
        assert!(Bearing::TABLE.field(AXIAL_SERIES).is_some());
        for (word, table) in [("ball", BallBearing::TABLE), ("roller", RollerBearing::TABLE)] {
            let (_, variants) = choice(&"pinion.bearing[0]".parse().unwrap()).unwrap();
            assert_eq!(table_of(variants, word).unwrap().name, table.name);
            let typical = TYPICAL.iter().filter(|typical| typical.0 == word).map(|typical| typical.1);
            let keys: Vec<&str> = typical.chain(MEAN_STATES).chain([PITCH_RADIUS]).collect();
            assert!(keys.len() > 6 && keys.iter().all(|key| table.field(key).is_some()), "{keys:?}");
            // what a new bearing must have is there
            let required = table.fields.iter().filter(|field| field.presence == Presence::Required);
            assert!(required.map(|field| field.key).all(|key| keys.contains(&key)), "{keys:?}");
        }
        assert!(Preload::TABLE.field("y_n").is_some());
    }
}
