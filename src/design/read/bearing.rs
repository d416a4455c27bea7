//! Reading a bearing's model: its word decides which other keys the same table has.

use super::table::{Found, FromFile, FromTable, TableReader};
use super::{did_you_mean, written};
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
            _ => STAND_IN,
        }
    }
}

/// The word and its keys; nothing, and reported, where it is unknown or not supported yet.
fn chosen(reader: &TableReader<'_>, field: &'static Field) -> Option<(&'static str, &'static Table)> {
    let supported =
        |word: &str| BearingModel::VARIANTS.iter().filter(|v| v.word == word).find_map(|v| Some((v.word, v.table?)));
    let value = match reader.look_up(field) {
        Found::Written(value) => value,
        Found::Default(Written::Text(word)) => return supported(word),
        Found::Default(_) | Found::Nothing => return None,
    };
    let path = reader.path_of(field);
    let Some(word) = value.get_ref().as_str() else {
        let message = format!("expected {}, found {}", written::wanted(field), written::what(reader.text, value));
        reader.wrong(&path, value, message, None);
        return None;
    };
    let found = supported(word);
    if found.is_none() {
        let known = || BearingModel::VARIANTS.iter().filter(|v| v.table.is_some()).map(|v| v.word);
        let allowed = written::quoted(&known().collect::<Vec<_>>());
        let raw = written::raw(reader.text, value);
        if BearingModel::VARIANTS.iter().any(|v| v.word == word) {
            let hint = format!("supported so far: {allowed}");
            reader.wrong(&path, value, format!("model {raw} is not supported yet"), Some(hint));
        } else {
            let hint = did_you_mean(word, BearingModel::VARIANTS.iter().map(|v| v.word)).trim_end().to_string();
            reader.wrong(
                &path,
                value,
                format!("must be one of {allowed}; it is {raw}"),
                Some(hint).filter(|h| !h.is_empty()),
            );
        }
    }
    found
}
