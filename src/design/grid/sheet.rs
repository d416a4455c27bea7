//! Which tables a design has.

use crate::design::schema::{Kind, ROOT, Table};
use crate::design::{
    Analysis, Bearing, Body, Drive, KeyPath, Material, Mesh, MeshGeometry, MeshVectors, Operating, RotorDesign,
    Segment, Side,
};

/// One table, or list of tables, of every design.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// Where it is: `pinion.segment`; the root for the design's own keys.
    pub path: KeyPath,
    pub shape: Shape,
    pub table: &'static Table,
}

/// How many tables there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Shape {
    /// One
    Single,
    /// A list with at least that many: rows can be inserted, duplicated, deleted and moved
    List { at_least: usize },
    /// By name: rows can be added, renamed and removed
    Named,
}

impl Sheet {
    /// Every sheet, in the order of the schema; each followed by those below it.
    pub fn all() -> Vec<Self> {
        let mut sheets = vec![Self::design()];
        sheets.extend(Self::design().below());
        sheets
    }

    fn below(&self) -> Vec<Self> {
        let tables = self.table.fields.iter().filter_map(|field| {
            let path = self.path.key(field.key);
            match field.kind {
                Kind::Table(table) => Some(Self { path, shape: Shape::Single, table }),
                Kind::Tables(table, at_least) => Some(Self { path, shape: Shape::List { at_least }, table }),
                Kind::NamedTables(table) => Some(Self { path, shape: Shape::Named, table }),
                _ => None,
            }
        });
        // what is below a row is part of the row
        let with_below = |sheet: Self| {
            let below = if sheet.shape == Shape::Single { sheet.below() } else { Vec::new() };
            std::iter::once(sheet).chain(below)
        };
        tables.flat_map(with_below).collect()
    }

    /// Name, description, tags, parent, note.
    pub fn design() -> Self {
        Self { path: KeyPath::root(), shape: Shape::Single, table: ROOT }
    }

    pub fn analysis() -> Self {
        Self { path: KeyPath::root().key("analysis"), shape: Shape::Single, table: Analysis::TABLE }
    }

    pub fn materials() -> Self {
        Self { path: KeyPath::root().key("material"), shape: Shape::Named, table: Material::TABLE }
    }

    pub fn mesh() -> Self {
        Self { path: KeyPath::root().key("mesh"), shape: Shape::Single, table: Mesh::TABLE }
    }

    pub fn mesh_side(side: Side) -> Self {
        Self { path: Self::mesh().path.key(side.name()), shape: Shape::Single, table: MeshVectors::TABLE }
    }

    /// Gear data in place of both sides' vectors.
    pub fn mesh_geometry() -> Self {
        Self { path: Self::mesh().path.key("geometry"), shape: Shape::Single, table: MeshGeometry::TABLE }
    }

    /// Torque and speed.
    pub fn operating() -> Self {
        Self { path: KeyPath::root().key("operating"), shape: Shape::Single, table: Operating::TABLE }
    }

    /// The rotor's own keys.
    pub fn rotor(side: Side) -> Self {
        Self { path: KeyPath::root().key(side.name()), shape: Shape::Single, table: RotorDesign::TABLE }
    }

    pub fn segments(side: Side) -> Self {
        Self { path: Self::rotor(side).path.key("segment"), shape: Shape::List { at_least: 1 }, table: Segment::TABLE }
    }

    pub fn bodies(side: Side) -> Self {
        Self { path: Self::rotor(side).path.key("body"), shape: Shape::List { at_least: 0 }, table: Body::TABLE }
    }

    pub fn bearings(side: Side) -> Self {
        Self { path: Self::rotor(side).path.key("bearing"), shape: Shape::List { at_least: 1 }, table: Bearing::TABLE }
    }

    pub fn drive(side: Side) -> Self {
        Self { path: Self::rotor(side).path.key("drive"), shape: Shape::Single, table: Drive::TABLE }
    }
}
