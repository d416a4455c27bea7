//! Reading a bearing's model: its word decides which other keys the same table has.

use super::table::{Found, FromFile, FromTable, TableReader};
use super::{did_you_mean, written};
use crate::design::rolling::{BallBearing, RollerBearing};
use crate::design::rotor::{BearingModel, DiagonalBearing, Hold, MatrixBearing, RigidBearing};
use crate::design::schema::{Field, Table, Written};

/// Stands in for a model that could not be read; no check objects to it.
const STAND_IN: BearingModel = BearingModel::Rigid(Hold { x: false, y: false, z: false });

impl FromFile for BearingModel {
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        let chosen = chosen(reader, field);
        reader.variant = Some((field, chosen.map(|(word, _)| word)));
        let Some((word, table)) = chosen else { return STAND_IN };
        reader.schemas.push(table);
        match word {
            "diagonal" => Self::Diagonal(DiagonalBearing::from_table(reader)),
            "matrix" => Self::Matrix(MatrixBearing::from_table(reader).stiffness),
            "rigid" => Self::Rigid(RigidBearing::from_table(reader).hold),
            "ball" => Self::Ball(BallBearing::from_table(reader)),
            "roller" => Self::Roller(RollerBearing::from_table(reader)),
            _ => STAND_IN,
        }
    }
}

/// The word and its keys; nothing, and reported, where it is unknown.
fn chosen(reader: &TableReader<'_>, field: &'static Field) -> Option<(&'static str, &'static Table)> {
    let known = |word: &str| BearingModel::VARIANTS.iter().find(|v| v.word == word).map(|v| (v.word, v.table));
    let value = match reader.look_up(field) {
        Found::Written(value) => value,
        Found::Default(Written::Text(word)) => return known(word),
        Found::Default(_) | Found::Nothing => return None,
    };
    let path = reader.path_of(field);
    let Some(word) = value.get_ref().as_str() else {
        let message = format!("expected {}, found {}", written::wanted(field), written::what(reader.text, value));
        reader.wrong(&path, value, message, None);
        return None;
    };
    let found = known(word);
    if found.is_none() {
        let words: Vec<&str> = BearingModel::VARIANTS.iter().map(|v| v.word).collect();
        let hint = did_you_mean(word, words.iter().copied()).trim_end().to_string();
        let message = format!("must be one of {}; it is {}", written::quoted(&words), written::raw(reader.text, value));
        reader.wrong(&path, value, message, Some(hint).filter(|h| !h.is_empty()));
    }
    found
}
