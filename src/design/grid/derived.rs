//! Values that are not written because they follow from others: mesh vectors from gear data.

use super::{CellKind, Grid, Sheet, Shown};
use crate::design::document::Tree;
use crate::design::key_path::Step;
use crate::design::{Design, Side};

impl Grid {
    /// Puts what follows from the gear data of the text into the empty cells of a table of mesh vectors. As long as the text is no design, nobody
    /// knows what that is.
    pub(in crate::design) fn derive(&mut self, text: &str, design: Option<&Design>) {
        let Some(side) = Side::BOTH.into_iter().find(|side| self.sheet.path == Sheet::mesh_side(*side).path) else {
            return;
        };
        if Tree::read(text).at(&Sheet::mesh_geometry().path).is_none() {
            return;
        }
        let vectors = design.map(|design| design.mesh.vectors(side));
        for cell in self.rows.iter_mut().flat_map(|row| &mut row.cells).filter(|cell| cell.shown == Shown::Nothing) {
            let (CellKind::VectorEntry(_), Some((_, &Step::Place(at)))) = (cell.kind, cell.path.split_last()) else {
                continue;
            };
            let value = vectors.and_then(|vectors| match cell.column.key {
                "point_mm" => vectors.point.get(at).map(|value| format!("{:.4}", value * 1e3)),
                _ => vectors.line_of_action.get(at).map(|value| format!("{value:.6}")),
            });
            // without a digit it is the zero that it stands for
            let is_something = |text: &String| text.contains(|digit| ('1'..='9').contains(&digit));
            let shown = value.map(|text| if is_something(&text) { text } else { "0".into() });
            cell.shown = Shown::Derived(shown.unwrap_or_else(|| "?".into()));
            cell.required = false;
        }
    }
}
