//! Which rows of two tables are the same row.

use super::grid::{Cell, Grid, Row, Shape, Sheet};

/// A row of the first table, of the second, or of both; as places.
pub type Pair = (Option<usize>, Option<usize>);

/// Pairs the rows of two tables, in the order of the first; those of the second alone come last where rows have names.
/// Rows with names are paired by name; of those that are left, the ones that differ in nothing but the name. Other rows are
/// paired in their order, so that as little as possible differs.
pub fn align(sheet: &Sheet, a: &Grid, b: &Grid, is_same: impl Fn(&Cell, &Cell) -> bool) -> Vec<Pair> {
    let apart = |a: &Row, b: &Row| distance(a, b, &is_same);
    if is_named(sheet) { by_name(sheet, a, b, apart) } else { by_order(&a.rows, &b.rows, apart) }
}

/// Have its rows names that mean the same in both designs?
pub fn is_named(sheet: &Sheet) -> bool {
    match sheet.shape {
        Shape::List { .. } => sheet.table.field("name").is_some(),
        Shape::Single | Shape::Named => true,
    }
}

/// How many cells are not the same, without the name; a cell that only one has counts as one.
fn distance(a: &Row, b: &Row, is_same: impl Fn(&Cell, &Cell) -> bool) -> usize {
    let (below_a, below_b) = (a.path.steps().len(), b.path.steps().len());
    let counts = |cell: &&Cell| cell.column.key != "name";
    let same = a.cells.iter().filter(counts).filter(|cell| {
        let other = b.cells.iter().find(|other| other.path.steps()[below_b..] == cell.path.steps()[below_a..]);
        other.is_some_and(|other| is_same(cell, other))
    });
    a.cells.iter().filter(counts).count().max(b.cells.iter().filter(counts).count()) - same.count()
}

fn by_name(sheet: &Sheet, a: &Grid, b: &Grid, distance: impl Fn(&Row, &Row) -> usize) -> Vec<Pair> {
    let mut free: Vec<usize> = (0..b.rows.len()).collect();
    let mut take = |wanted: &dyn Fn(&Row) -> bool| {
        let at = free.iter().position(|&place| wanted(&b.rows[place]))?;
        Some(free.remove(at))
    };
    let mut pairs: Vec<Pair> =
        a.rows.iter().enumerate().map(|(at, row)| (Some(at), take(&|other| other.label == row.label))).collect();
    if sheet.shape != Shape::Single {
        for (at, place) in pairs.iter_mut().filter(|(_, place)| place.is_none()) {
            let row = at.map(|at| &a.rows[at]);
            *place = take(&|other| row.is_some_and(|row| distance(row, other) == 0));
        }
    }
    pairs.extend(free.into_iter().map(|place| (None, Some(place))));
    pairs
}

/// More combinations of rows than this are not tried: rows are then paired by place.
const MOST: usize = 40_000;

/// What begins and ends alike is paired at once, what is between by the least cost.
fn by_order(a: &[Row], b: &[Row], distance: impl Fn(&Row, &Row) -> usize) -> Vec<Pair> {
    let alike = |(a, b): &(&Row, &Row)| distance(a, b) == 0;
    let start = a.iter().zip(b).take_while(alike).count();
    let end = a[start..].iter().rev().zip(b[start..].iter().rev()).take_while(alike).count();
    let (to_a, to_b) = (a.len() - end, b.len() - end);
    let between = if (to_a - start).saturating_mul(to_b - start) > MOST {
        let place = |at: usize, count: usize| (at < count).then_some(at);
        (0..(to_a - start).max(to_b - start)).map(|at| (place(at, to_a - start), place(at, to_b - start))).collect()
    } else {
        by_cost(&a[start..to_a], &b[start..to_b], distance)
    };
    let same = |from: (usize, usize), count| (0..count).map(move |at| (Some(from.0 + at), Some(from.1 + at)));
    let between = between.into_iter().map(|(a, b)| (a.map(|at| at + start), b.map(|at| at + start)));
    same((0, 0), start).chain(between).chain(same((to_a, to_b), end)).collect()
}

/// The alignment with the least cost. Cells that differ cost 2 each, a row that only one table has costs as much as half a
/// row of differing cells: with two of those, a row is never worse changed than removed and added.
fn by_cost(a: &[Row], b: &[Row], distance: impl Fn(&Row, &Row) -> usize) -> Vec<Pair> {
    let gap = |row: &Row| row.cells.len();
    let width = b.len() + 1;
    let mut costs = vec![0; (a.len() + 1) * width];
    let cost = |costs: &[usize], i: usize, j: usize| costs[i * width + j];
    let both = |costs: &[usize], i: usize, j: usize| 2 * distance(&a[i], &b[j]) + cost(costs, i + 1, j + 1);
    for i in (0..=a.len()).rev() {
        for j in (0..=b.len()).rev() {
            let only_a = a.get(i).map(|row| gap(row) + cost(&costs, i + 1, j));
            let only_b = b.get(j).map(|row| gap(row) + cost(&costs, i, j + 1));
            let paired = (i < a.len() && j < b.len()).then(|| both(&costs, i, j));
            costs[i * width + j] = [only_a, only_b, paired].into_iter().flatten().min().unwrap_or(0);
        }
    }
    let (mut i, mut j) = (0, 0);
    let mut pairs = Vec::new();
    while i < a.len() || j < b.len() {
        let best = cost(&costs, i, j);
        if i < a.len() && j < b.len() && both(&costs, i, j) == best {
            pairs.push((Some(i), Some(j)));
            (i, j) = (i + 1, j + 1);
            continue;
        }
        let is_only_a = i < a.len() && gap(&a[i]) + cost(&costs, i + 1, j) == best;
        let is_only_b = j < b.len() && gap(&b[j]) + cost(&costs, i, j + 1) == best;
        // of two ways as good as each other the same one also where the designs are swapped
        if is_only_a && (!is_only_b || texts(&a[i]) < texts(&b[j])) {
            pairs.push((Some(i), None));
            i += 1;
        } else {
            pairs.push((None, Some(j)));
            j += 1;
        }
    }
    pairs
}

fn texts(row: &Row) -> Vec<&str> {
    row.cells.iter().map(|cell| cell.shown.text()).collect()
}
