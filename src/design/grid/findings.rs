//! Findings beside the cells that they are about.

use super::{CellKind, Row, Shape};
use crate::design::{Finding, KeyPath};

pub(super) fn place_in_row(row: &mut Row, findings: &[Finding], shape: Shape) {
    for cell in &mut row.cells {
        // a vector or a matrix as a whole is meant by each of its entries
        let wholes: Vec<KeyPath> = match cell.kind {
            CellKind::VectorEntry(_) => vec![up(&cell.path)],
            CellKind::MatrixEntry(..) => {
                let row = cell.path.split_last().map(|(row, _)| row).unwrap_or_default();
                vec![up(&row), row]
            }
            _ => Vec::new(),
        };
        let is_about =
            |finding: &Finding| finding.key_path.starts_with(&cell.path) || wholes.contains(&finding.key_path);
        cell.findings = places(findings, is_about);
    }
    let path = &row.path;
    row.findings = if shape == Shape::Single {
        // tables below have findings of their own
        let mut own: Vec<usize> = row.cells.iter().flat_map(|cell| cell.findings.iter().copied()).collect();
        own.extend(places(findings, |finding| finding.key_path == *path && *path != KeyPath::root()));
        own.sort_unstable();
        own.dedup();
        own
    } else {
        places(findings, |finding| finding.key_path.starts_with(path))
    };
}

/// Those about exactly that path.
pub(super) fn about(path: &KeyPath, findings: &[Finding]) -> Vec<usize> {
    places(findings, |finding| finding.key_path == *path)
}

fn up(path: &KeyPath) -> KeyPath {
    path.split_last().map(|(path, _)| path).unwrap_or_default()
}

fn places(findings: &[Finding], is_about: impl Fn(&Finding) -> bool) -> Vec<usize> {
    findings.iter().enumerate().filter(|(_, finding)| is_about(finding)).map(|(place, _)| place).collect()
}
