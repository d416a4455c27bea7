//! Which tables there are, and the one in sight as rows and columns of cells.

use std::collections::HashSet;

use unicode_width::UnicodeWidthStr;

use super::shown_text;
use crate::design::grid::{Cell, CellKind, Grid, Row, Shape, Sheet, Shown};
use crate::design::schema::target;
use crate::design::{Editor, KeyPath, Side, Step, changed_cells};
use crate::tui::action::Action;

/// The tables of a design, in the order of their keys.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tab {
    Segments,
    Bearings,
    Bodies,
    Mesh,
    Drives,
    Analysis,
    Materials,
    Design,
}

impl Tab {
    pub const ALL: [Self; 8] = [
        Self::Segments,
        Self::Bearings,
        Self::Bodies,
        Self::Mesh,
        Self::Drives,
        Self::Analysis,
        Self::Materials,
        Self::Design,
    ];

    pub fn title(self) -> &'static str {
        match self {
            Self::Segments => "segments",
            Self::Bearings => "bearings",
            Self::Bodies => "bodies",
            Self::Mesh => "mesh",
            Self::Drives => "drives",
            Self::Analysis => "analysis",
            Self::Materials => "materials",
            Self::Design => "design",
        }
    }

    /// What shows it.
    pub fn action(self) -> Action {
        match self {
            Self::Segments => Action::Segments,
            Self::Bearings => Action::Bearings,
            Self::Bodies => Action::Bodies,
            Self::Mesh => Action::Mesh,
            Self::Drives => Action::Drives,
            Self::Analysis => Action::Analysis,
            Self::Materials => Action::Materials,
            Self::Design => Action::Design,
        }
    }

    /// Whether pinion and gear each have one.
    pub fn has_sides(self) -> bool {
        !matches!(self, Self::Analysis | Self::Materials | Self::Design)
    }

    /// What it shows.
    pub fn sheets(self, side: Side) -> Vec<Sheet> {
        match self {
            Self::Segments => vec![Sheet::segments(side)],
            Self::Bearings => vec![Sheet::bearings(side)],
            Self::Bodies => vec![Sheet::bodies(side)],
            Self::Mesh => vec![Sheet::mesh(), Sheet::mesh_side(side), Sheet::rotor(side), Sheet::mesh_geometry()],
            Self::Drives => vec![Sheet::drive(side)],
            Self::Analysis => vec![Sheet::analysis(), Sheet::operating()],
            Self::Materials => vec![Sheet::materials()],
            Self::Design => vec![Sheet::design()],
        }
    }

    /// Where the value, the row or the table of a key path is shown.
    pub fn of(path: &KeyPath) -> (Self, Option<Side>) {
        let key = |at: usize| match path.steps().get(at) {
            Some(Step::Key(key)) => key.as_str(),
            _ => "",
        };
        let side = |name: &str| Side::BOTH.into_iter().find(|side| side.name() == name);
        match (key(0), key(1)) {
            ("mesh", below) => (Self::Mesh, side(below)),
            ("analysis" | "operating", _) => (Self::Analysis, None),
            ("material", _) => (Self::Materials, None),
            (rotor, below) if side(rotor).is_some() => {
                let tab = match below {
                    "segment" => Self::Segments,
                    "bearing" => Self::Bearings,
                    "body" => Self::Bodies,
                    "drive" => Self::Drives,
                    _ => Self::Mesh,
                };
                (tab, side(rotor))
            }
            _ => (Self::Design, None),
        }
    }
}

/// A column of the table in sight.
#[derive(Debug, Clone, PartialEq)]
pub struct ViewColumn {
    pub key: &'static str,
    pub label: String,
    pub unit: &'static str,
    /// Columns of the screen that the longest of its values takes
    pub longest: usize,
}

/// What a place of the table holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// The row's cell with that number
    Cell(usize),
    /// All entries of a stiffness matrix
    Matrix,
    /// The name of a table that has a name: a material
    Name,
}

/// A line of the table in sight.
#[derive(Debug, Clone, PartialEq)]
pub struct ViewRow {
    grid: usize,
    row: usize,
    /// By column; nothing where the row has no such value.
    pub places: Vec<Option<Place>>,
}

/// The table in sight. A single table is turned around: each of its cells is a row.
#[derive(Debug, Clone, PartialEq)]
pub struct View {
    grids: Vec<Grid>,
    pub rows: Vec<ViewRow>,
    /// Empty where each row has a single cell of its own.
    pub columns: Vec<ViewColumn>,
    pub shape: Shape,
    /// Columns of the screen that the longest label of a row takes
    pub longest_label: usize,
    /// The cells that are not as they were saved.
    changed: HashSet<KeyPath>,
}

impl View {
    pub fn new(editor: &Editor, tab: Tab, side: Side) -> Self {
        let grids: Vec<Grid> = tab.sheets(side).iter().map(|sheet| editor.grid(sheet)).collect();
        let shape = grids.first().map_or(Shape::Single, |grid| grid.sheet.shape);
        let saved = editor.saved_text();
        let changed =
            grids.iter().filter(|_| editor.is_modified()).flat_map(|grid| changed_cells(saved, grid)).collect();
        let view = if shape == Shape::Single { Self::turned(grids) } else { Self::table(grids, shape) };
        Self { changed, ..view }
    }

    fn turned(grids: Vec<Grid>) -> Self {
        let mut rows = Vec::new();
        for (grid, table) in grids.iter().enumerate() {
            for (row, line) in table.rows.iter().enumerate() {
                let places = (0..line.cells.len()).map(|cell| vec![Some(Place::Cell(cell))]);
                rows.extend(places.map(|places| ViewRow { grid, row, places }));
            }
        }
        Self { grids, rows, columns: Vec::new(), shape: Shape::Single, longest_label: 0, changed: HashSet::new() }
    }

    fn table(grids: Vec<Grid>, shape: Shape) -> Self {
        let mut columns: Vec<ViewColumn> = Vec::new();
        if shape == Shape::Named {
            columns.push(ViewColumn { key: "", label: "name".into(), unit: "", longest: 0 });
        }
        let named = columns.len();
        for column in grids.iter().flat_map(|grid| &grid.columns) {
            columns.push(ViewColumn { key: column.key, label: column.label.clone(), unit: column.unit, longest: 0 });
        }
        let mut rows = Vec::new();
        for (grid, table) in grids.iter().enumerate() {
            for (row, line) in table.rows.iter().enumerate() {
                let mut places = vec![None; columns.len()];
                if named > 0 {
                    places[0] = Some(Place::Name);
                }
                for (at, cell) in line.cells.iter().enumerate() {
                    let (label, unit, place) = match cell.kind {
                        CellKind::MatrixEntry(..) => ("stiffness", "matrix", Place::Matrix),
                        _ => (cell.column.label.as_str(), cell.column.unit, Place::Cell(at)),
                    };
                    let column = columns[named..]
                        .iter()
                        .position(|column| column.key == cell.column.key && column.label == label)
                        .map_or(columns.len(), |at| at + named);
                    if column == columns.len() {
                        columns.push(ViewColumn { key: cell.column.key, label: label.into(), unit, longest: 0 });
                    }
                    places.resize(places.len().max(column + 1), None);
                    places[column] = Some(place);
                }
                rows.push(ViewRow { grid, row, places });
            }
        }
        let count = columns.len();
        for row in &mut rows {
            row.places.resize(count, None);
        }
        let mut view = Self { grids, rows, columns, shape, longest_label: 0, changed: HashSet::new() };
        view.measure();
        view
    }

    /// Once for each text, and not for each frame: a design may have thousands of rows.
    fn measure(&mut self) {
        let rows = 0..self.rows.len();
        let longest = |column: usize| {
            let shown = rows.clone().filter_map(|row| self.shown(row, column));
            shown.map(|shown| shown_text(&shown).width()).max().unwrap_or(0)
        };
        let longest: Vec<usize> = (0..self.columns.len()).map(longest).collect();
        self.longest_label = rows.filter_map(|row| self.row(row)).map(|row| row.label.width()).max().unwrap_or(0);
        self.columns.iter_mut().zip(longest).for_each(|(column, longest)| column.longest = longest);
    }

    /// Whether each row is one value of a single table.
    pub fn is_turned(&self) -> bool {
        self.shape == Shape::Single
    }

    /// Whether the first column stays in sight: it is what the rows are called.
    pub fn has_name_column(&self) -> bool {
        self.columns.first().is_some_and(|column| column.key.is_empty() || column.key == "name")
    }

    pub fn row(&self, row: usize) -> Option<&Row> {
        self.rows.get(row).and_then(|line| self.grids.get(line.grid)?.rows.get(line.row))
    }

    /// What stands over a row: what its table is called, where there are several tables.
    pub fn heading(&self, row: usize) -> Option<&str> {
        let grid = self.rows.get(row)?.grid;
        let first = row == 0 || self.rows.get(row - 1)?.grid != grid;
        (self.is_turned() && self.grids.len() > 1 && first).then(|| self.row(row).map_or("", |row| &row.label))
    }

    /// The findings about the list as a whole.
    pub fn list_findings(&self) -> &[usize] {
        self.grids.first().map_or(&[], |grid| &grid.findings)
    }

    /// The sheet that a row belongs to; of a table without rows the only one.
    pub fn sheet(&self, row: usize) -> Option<&Sheet> {
        let grid = self.rows.get(row).map_or(0, |line| line.grid);
        self.grids.get(grid).map(|grid| &grid.sheet)
    }

    pub fn place(&self, row: usize, column: usize) -> Option<Place> {
        self.rows.get(row).and_then(|line| line.places.get(column).copied().flatten())
    }

    /// The cell at a place; nothing for a matrix, a name and where the row has no such value.
    pub fn cell(&self, row: usize, column: usize) -> Option<&Cell> {
        match self.place(row, column)? {
            Place::Cell(at) => self.row(row)?.cells.get(at),
            Place::Matrix | Place::Name => None,
        }
    }

    /// What a place shows, as in the file.
    pub fn shown(&self, row: usize, column: usize) -> Option<Shown> {
        match self.place(row, column)? {
            Place::Cell(_) => self.cell(row, column).map(|cell| cell.shown.clone()),
            Place::Matrix => Some(Shown::Written("6x6".into())),
            Place::Name => {
                let row = self.row(row)?;
                let written = row.cells.iter().any(|cell| cell.shown.is_written());
                Some(if written { Shown::Written(row.label.clone()) } else { Shown::Default(row.label.clone()) })
            }
        }
    }

    /// Whether a place is not as it was saved.
    pub fn is_changed(&self, row: usize, column: usize) -> bool {
        let is_changed = |cell: &Cell| self.changed.contains(&cell.path);
        match self.place(row, column) {
            Some(Place::Cell(_)) => self.cell(row, column).is_some_and(is_changed),
            Some(Place::Matrix) => self.row(row).is_some_and(|row| {
                row.cells.iter().any(|cell| matches!(cell.kind, CellKind::MatrixEntry(..)) && is_changed(cell))
            }),
            Some(Place::Name) | None => false,
        }
    }

    /// Which findings are about a place, as places in the list of findings.
    pub fn findings(&self, row: usize, column: usize) -> Vec<usize> {
        match self.place(row, column) {
            Some(Place::Cell(_)) => self.cell(row, column).map_or(Vec::new(), |cell| cell.findings.clone()),
            Some(Place::Matrix) => self.matrix_findings(row),
            Some(Place::Name) | None => Vec::new(),
        }
    }

    fn matrix_findings(&self, row: usize) -> Vec<usize> {
        let cells = self.row(row).into_iter().flat_map(|row| &row.cells);
        let mut findings: Vec<usize> = cells
            .filter(|cell| matches!(cell.kind, CellKind::MatrixEntry(..)))
            .flat_map(|cell| cell.findings.iter().copied())
            .collect();
        findings.sort_unstable();
        findings.dedup();
        findings
    }

    /// The entry of the row's matrix.
    pub fn matrix_entry(&self, row: usize, entry: (usize, usize)) -> Option<&Cell> {
        let kind = CellKind::MatrixEntry(entry.0, entry.1);
        self.row(row)?.cells.iter().find(|cell| cell.kind == kind)
    }

    /// The row and column of a value, or of the row that a key path leads to or into.
    pub fn find(&self, path: &KeyPath) -> Option<(usize, Option<usize>)> {
        let leads_to = |cell: &Cell| cell.path == *path || is_below(path, &cell.path) || is_below(&cell.path, path);
        for row in 0..self.rows.len() {
            let exact = |column: &usize| self.cell(row, *column).is_some_and(|cell| cell.path == *path);
            if let Some(column) = (0..self.rows[row].places.len()).find(exact) {
                return Some((row, Some(column)));
            }
        }
        for row in 0..self.rows.len() {
            let Some(line) = self.row(row) else { continue };
            if !is_below(path, &line.path) && line.path != *path && !is_below(&line.path, path) {
                continue;
            }
            let columns = 0..self.rows[row].places.len();
            let column = columns.into_iter().find(|&column| match self.place(row, column) {
                Some(Place::Cell(_)) => is_below(path, &line.path) && self.cell(row, column).is_some_and(leads_to),
                Some(Place::Matrix) => line
                    .cells
                    .iter()
                    .any(|cell| matches!(cell.kind, CellKind::MatrixEntry(..)) && leads_to(cell) && line.path != *path),
                Some(Place::Name) | None => false,
            });
            if column.is_some() || !self.is_turned() {
                return Some((row, column));
            }
        }
        // a table that is turned around is at its first value, and so is a key that it should not have
        let around = path.split_last().map(|(around, _)| around).filter(|_| is_unknown(path));
        let table = around.as_ref().unwrap_or(path);
        (0..self.rows.len()).find(|&row| self.row(row).is_some_and(|line| line.path == *table)).map(|row| (row, None))
    }
}

/// Whether no table has the key.
pub fn is_unknown(path: &KeyPath) -> bool {
    target(path).is_none()
}

/// Does `path` go on from `above`?
pub fn is_below(path: &KeyPath, above: &KeyPath) -> bool {
    path.steps().len() > above.steps().len() && path.steps().starts_with(above.steps())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sheet_of_the_schema_is_in_a_tab() {
        let shown: Vec<Sheet> =
            Tab::ALL.into_iter().flat_map(|tab| Side::BOTH.map(|side| tab.sheets(side))).flatten().collect();
        for sheet in Sheet::all() {
            assert!(shown.contains(&sheet), "{}", sheet.path);
        }
    }

    #[test]
    fn every_sheet_is_found_from_its_path() {
        for (tab, side) in Tab::ALL.into_iter().flat_map(|tab| Side::BOTH.map(|side| (tab, side))) {
            for sheet in tab.sheets(side) {
                let (found, found_side) = Tab::of(&sheet.path);
                assert_eq!(found, tab, "{}", sheet.path);
                assert!(found_side.is_none_or(|found| found == side), "{}", sheet.path);
            }
        }
    }
}
