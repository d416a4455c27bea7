//! Materials: tables by name, which segments refer to.

use super::Spelled;
use super::steps::Steps;
use crate::design::document::Tree;
use crate::design::key_path::KeyPath;
use crate::design::schema::{Presence, Written};
use crate::design::{EditError, Material, STEEL, Segment, Side};

fn path(name: &str) -> KeyPath {
    KeyPath::root().key("material").key(name)
}

/// The keys of a material with the values of steel, spelled.
fn values_of_steel() -> impl Iterator<Item = (&'static str, String)> {
    Material::TABLE.fields.iter().filter_map(|field| match field.presence {
        Presence::DefaultIn(STEEL, Written::Number(number)) => Some((field.key, format!("{number:?}"))),
        _ => None,
    })
}

pub(super) fn add(steps: &mut Steps, name: &str) -> Result<KeyPath, EditError> {
    check_name(&steps.tree(), name)?;
    for (key, value) in values_of_steel() {
        steps.put(&path(name).key(key), &value)?;
    }
    Ok(path(name))
}

pub(super) fn rename(steps: &mut Steps, from: &str, to: &str) -> Result<KeyPath, EditError> {
    let tree = steps.tree();
    if from == to && tree.at(&path(from)).is_some() {
        return Ok(path(from));
    }
    check_name(&tree, to)?;
    match tree.at(&path(from)) {
        None if from == STEEL => {
            add(steps, to)?;
        }
        written => {
            let missing = |key: &str| written.is_none_or(|material| material.get(key).is_none());
            if from == STEEL {
                // under another name, nothing is there without being written
                for (key, value) in values_of_steel().filter(|(key, _)| missing(key)) {
                    steps.put(&path(from).key(key), &value)?;
                }
            }
            steps.rename(&path(from), to)?;
        }
    }
    let naming: Vec<KeyPath> = segments_of(&tree, from).iter().map(|segment| segment.key("material")).collect();
    steps.put_all(&naming, Spelled::text(to).as_str())?;
    Ok(path(to))
}

pub(super) fn remove(steps: &mut Steps, name: &str) -> Result<KeyPath, EditError> {
    steps.remove(&path(name))?;
    Ok(KeyPath::root().key("material"))
}

fn check_name(tree: &Tree, name: &str) -> Result<(), EditError> {
    if name.trim().is_empty() {
        return Err(EditError::Refused("a material needs a name".into()));
    }
    if tree.at(&path(name)).is_some() {
        return Err(EditError::Refused(format!("there is a material {name} already")));
    }
    Ok(())
}

/// The segments of both rotors that are of the material, also where that is not written.
fn segments_of(tree: &Tree, material: &str) -> Vec<KeyPath> {
    let default = match Segment::TABLE.field("material").map(|field| field.presence) {
        Some(Presence::Default(Written::Text(default))) => default,
        _ => STEEL,
    };
    let lists = Side::BOTH.map(|side| KeyPath::root().key(side.name()).key("segment"));
    let segments = lists.iter().flat_map(|list| {
        let rows = tree.at(list).map(Tree::entries).unwrap_or_default();
        rows.iter().enumerate().map(|(place, row)| (list.place(place), row))
    });
    let is_of =
        |row: &Tree| row.get("material").map_or_else(|| material == default, |m| m.text().as_deref() == Some(material));
    segments.filter(|(_, row)| is_of(row)).map(|(path, _)| path).collect()
}
