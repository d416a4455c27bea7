//! Random edits on designs in every spelling: each leaves TOML, changes what it is about and nothing else, and can be taken
//! back byte for byte.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use bevelscope::design::grid::{CellKind, Grid, Sheet};
use bevelscope::design::library::SHIPPED;
use bevelscope::design::{Document, Edit, EditError, Editor, KeyPath, Side, Spelled, Towards, diff, read};
use proptest::prelude::*;

/// The shipped designs, the same with other line ends and a byte order mark, and those of the fixtures that use inline
/// tables, dotted keys and every optional table.
fn texts() -> Vec<String> {
    let fixture = |name: &str| {
        let path = format!("{}/tests/fixtures/valid/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        std::fs::read_to_string(path).unwrap()
    };
    let mut texts: Vec<String> = SHIPPED.iter().map(|shipped| shipped.text.to_owned()).collect();
    texts.push(format!("\u{feff}{}", SHIPPED[1].text.replace('\n', "\r\n")));
    texts.push(SHIPPED[2].text.trim_end().to_owned());
    texts.extend(["small", "matrix", "no-tables-of-their-own", "other-tables", "inline"].map(fixture));
    texts
}

/// One random edit of whatever the design has; picks are taken modulo what there is.
fn edit(editor: &Editor, kind: usize, pick: usize, value: usize) -> Edit {
    let sheets = Sheet::all();
    let side = Side::BOTH[value % 2];
    let lists = [Sheet::segments(side), Sheet::bodies(side), Sheet::bearings(side)];
    let list = editor.grid(&lists[pick % 3]);
    let place = (pick / 3) % (list.rows.len() + 1);
    let row = || list.sheet.path.place(place.min(list.rows.len().saturating_sub(1)));
    match kind {
        0 => Edit::InsertRow { list: list.sheet.path.clone(), place },
        1 => Edit::DuplicateRow { row: row() },
        2 => Edit::DeleteRow { row: row() },
        3 => Edit::MoveRow { row: row(), towards: if value % 4 < 2 { Towards::Start } else { Towards::End } },
        4 => {
            let model = ["diagonal", "matrix", "rigid"][value % 3].to_owned();
            Edit::SetModel { bearing: Sheet::bearings(side).path.place(pick % 3), model }
        }
        5 => Edit::AddMaterial { name: ["brass", "steel", "Ti 6-4"][value % 3].into() },
        6 => Edit::RenameMaterial {
            from: ["steel", "brass", "Ti 6-4"][pick % 3].into(),
            to: ["alloy", "brass", "a.b \"c\""][value % 3].into(),
        },
        7 => Edit::RemoveMaterial { name: ["steel", "brass", "alloy"][value % 3].into() },
        _ => {
            let cells: Vec<_> =
                sheets.iter().flat_map(|sheet| editor.grid(sheet).rows).flat_map(|row| row.cells).collect();
            let cell = &cells[pick % cells.len()];
            if kind == 8 {
                Edit::Remove { path: cell.path.clone() }
            } else {
                Edit::from_typed(cell, &typed(cell.kind, value)).unwrap()
            }
        }
    }
}

fn typed(kind: CellKind, value: usize) -> String {
    match kind {
        CellKind::Number(..) | CellKind::VectorEntry(_) | CellKind::MatrixEntry(..) => {
            ["1.5e3", "7", "0.25", "-3", "1_0.0"][value % 5].into()
        }
        CellKind::Whole(..) => (value % 30 + 1).to_string(),
        CellKind::Text | CellKind::Name => ["a", "two words", "\"#'\\", "ä\u{1b}\n", "steel"][value % 5].into(),
        CellKind::Texts => ["a", "a, b, c", "[\"x, y\", \"z\"]", "c, b"][value % 4].into(),
        CellKind::Choice(_) | CellKind::Model(_) => kind.words()[value % kind.words().len()].into(),
        CellKind::Flags(_) => ["x", "x z", "xyz", "y"][value % 4].into(),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn edits_undone_give_the_file_back_byte_for_byte(
        which in 0..64_usize,
        picks in proptest::collection::vec((0..14_usize, any::<u16>(), any::<u16>()), 1..16),
    ) {
        let texts = texts();
        let text = &texts[which % texts.len()];
        let mut editor = Editor::new(text.as_str()).unwrap();
        let mut states = vec![text.clone()];
        for (kind, pick, value) in picks {
            let edit = edit(&editor, kind, pick.into(), value.into());
            let before = editor.text().to_owned();
            match editor.apply(&edit) {
                Ok(applied) => {
                    prop_assert_eq!(applied.changed, before != editor.text());
                    if applied.changed {
                        states.push(editor.text().to_owned());
                    }
                }
                Err(error) => {
                    prop_assert_eq!(&before, editor.text());
                    prop_assert!(!matches!(error, EditError::NoPlace(_) | EditError::Syntax(_)), "{edit:?}: {error}");
                }
            }
            prop_assert!(editor.text().parse::<toml_edit::DocumentMut>().is_ok(), "{edit:?}");
            kept(&before, editor.text(), &edit)?;
        }
        prop_assert_eq!(Some(editor.text()), states.last().map(String::as_str));
        for state in states.iter().rev().skip(1) {
            prop_assert!(editor.undo().is_some());
            prop_assert_eq!(editor.text(), state);
        }
        prop_assert!(editor.undo().is_none() && !editor.is_modified());
        for state in states.iter().skip(1) {
            prop_assert!(editor.redo().is_some());
            prop_assert_eq!(editor.text(), state);
        }
        prop_assert!(editor.redo().is_none());
    }

    // The edit that a person makes most: one value. Exactly one line changes, and only before its comment.
    #[test]
    fn one_value_changes_one_line(which in 0..5_usize, pick in any::<usize>(), value in 1e-3..1e9_f64) {
        let texts = texts();
        let text = &texts[which];
        let mut editor = Editor::new(text.as_str()).unwrap();
        let rows = Sheet::all().iter().flat_map(|sheet| editor.grid(sheet).rows).collect::<Vec<_>>();
        let numbers: Vec<KeyPath> = rows
            .into_iter()
            .flat_map(|row| row.cells)
            .filter(|cell| cell.shown.is_written() && matches!(cell.kind, CellKind::Number(..) | CellKind::VectorEntry(_)))
            .map(|cell| cell.path)
            .collect();
        let path = numbers[pick % numbers.len()].clone();
        editor.apply(&Edit::Set { path, value: Spelled::parse(&format!("{value:?}")).unwrap() }).unwrap();
        let changed: Vec<(&str, &str)> = text.split('\n').zip(editor.text().split('\n')).filter(|(a, b)| a != b).collect();
        prop_assert_eq!(text.matches('\n').count(), editor.text().matches('\n').count());
        prop_assert!(changed.len() <= 1);
        for (old, new) in changed {
            let rest = |line: &str| line.split_once('#').map(|(_, comment)| comment.to_owned());
            let key = |line: &str| line.split_once('=').map(|(key, _)| key.to_owned());
            prop_assert_eq!((key(old), rest(old)), (key(new), rest(new)));
            prop_assert_eq!(old.ends_with('\r'), new.ends_with('\r'));
        }
    }
}

/// Pieces that make a text something else where they are put in.
const PIECES: [&str; 16] = [
    "\"",
    "'''",
    "[",
    "]",
    "{",
    "}",
    "[[pinion.segment]]\n",
    "\n[pinion]\n",
    "#",
    "\n",
    ",",
    "\\",
    "name.x = 1\n",
    "ä",
    "= 5\n",
    "\r",
];

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    // Damaged files are shown as far as they can be read; those that are still TOML are edited, or the edit is refused.
    #[test]
    fn no_text_breaks_it(
        which in 0..64_usize,
        damage in proptest::collection::vec((any::<usize>(), 0..PIECES.len(), 0..20_usize), 1..4),
        picks in proptest::collection::vec((0..14_usize, any::<u16>(), any::<u16>()), 4),
    ) {
        let texts = texts();
        let whole = &texts[which % texts.len()];
        let mut text = whole.clone();
        for (at, piece, cut) in damage {
            let start = boundary(&text, at % (text.len() + 1));
            let end = boundary(&text, (start + cut).min(text.len()));
            text.replace_range(start..end, PIECES[piece]);
        }
        let findings = read(&text).findings;
        for sheet in Sheet::all() {
            Grid::new(&text, &findings, &sheet);
        }
        diff(&text, whole);
        let Ok(mut editor) = Editor::new(text.as_str()) else { return Ok(()) };
        for (kind, pick, value) in picks {
            let edit = edit(&editor, kind, pick.into(), value.into());
            let _ = editor.apply(&edit);
            prop_assert!(Document::parse(editor.text()).is_ok());
        }
        while editor.undo().is_some() {}
        prop_assert_eq!(editor.text(), text);
    }
}

/// The byte itself, or the start of the character that it is in the middle of.
fn boundary(text: &str, at: usize) -> usize {
    (0..=at).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0)
}

/// Every comment outlives an edit, unless what it stands beside was taken out; line ends and the byte order mark stay.
fn kept(before: &str, after: &str, edit: &Edit) -> Result<(), TestCaseError> {
    prop_assert_eq!(before.starts_with('\u{feff}'), after.starts_with('\u{feff}'));
    let windows = before.contains("\r\n");
    let lone = after.matches('\n').count() - after.matches("\r\n").count();
    prop_assert!(!windows || lone == 0, "{edit:?} wrote other line ends");
    let takes = matches!(
        edit,
        Edit::DeleteRow { .. }
            | Edit::Remove { .. }
            | Edit::SetModel { .. }
            | Edit::RemoveMaterial { .. }
            | Edit::DuplicateRow { .. }
    );
    if !takes {
        let comments = |text: &str| {
            // texts of the edits may have a # in them, the comments of the designs none of these
            let lines = text.lines().filter_map(|line| line.split_once("# ").map(|(_, comment)| comment.to_owned()));
            let mut lines: Vec<String> = lines.collect();
            lines.sort();
            lines
        };
        prop_assert_eq!(comments(before), comments(after), "{:?}", edit);
    }
    Ok(())
}
