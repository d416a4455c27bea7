//! Every cell of every table, by keys.

use crate::tui_support::{ASCII, Screen, UNICODE};
use crate::{editing, opened};
use bevelscope::design::grid::{Cell, CellKind, Sheet};
use bevelscope::design::schema::{Kind, ROOT};
use bevelscope::tui::editor::Place;
use bevelscope::tui::keymap::Mode;

/// Something else that the cell may hold.
fn another(cell: &Cell) -> String {
    let old = cell.shown.text();
    match cell.kind {
        CellKind::Number(_, limit) => if limit.allows(7.5) { "7.5" } else { "0.25" }.into(),
        CellKind::VectorEntry(_) | CellKind::MatrixEntry(..) => "0.5".into(),
        CellKind::Whole(low, high) => {
            [3, low].into_iter().find(|number| (low..=high).contains(number)).unwrap().to_string()
        }
        CellKind::Text | CellKind::Name => "quite \"another\" #1 = [x]".into(),
        CellKind::Texts => "one, two".into(),
        CellKind::Choice(_) | CellKind::Model(_) => {
            let words = cell.kind.words();
            let next = words.iter().position(|word| *word == old).map_or(0, |at| at + 1);
            words[next % words.len()].into()
        }
        CellKind::Flags(_) => "x".into(),
    }
}

/// Goes to a place by keys.
fn go(screen: &mut Screen, row: usize, column: usize) {
    screen.keys("g");
    screen.keys(&"j".repeat(row));
    screen.keys("<Home>");
    while editing(screen).cursor().column < column {
        screen.keys("l");
    }
    assert_eq!((editing(screen).cursor().row, editing(screen).cursor().column), (row, column));
}

/// Changes what is under the cursor by keys, sees it in the text, and takes it back.
fn change(screen: &mut Screen, cell: &Cell) {
    // the number of the format can be no other
    if matches!(cell.kind, CellKind::Whole(low, high) if low == high) {
        return;
    }
    // nor what follows from gear data
    if cell.shown.is_derived() {
        return;
    }
    // nor the only word that there is
    if matches!(cell.kind, CellKind::Choice(_)) && cell.kind.words() == [cell.shown.text()] {
        return;
    }
    let before = editing(screen).editor.text().to_owned();
    let new = another(cell);
    let keys = match cell.kind {
        CellKind::Choice(_) | CellKind::Model(_) => " ".to_owned(),
        CellKind::Flags(_) if cell.shown.text() == "x" => "<Enter>j <Enter>".into(),
        CellKind::Flags(_) => {
            // ticks off what is on, and x on
            let ticked = |word: &str| cell.shown.text().contains(word);
            let keys = [("x", !ticked("x")), ("y", ticked("y")), ("z", ticked("z"))];
            let keys: String = keys.iter().map(|(_, press)| if *press { " j" } else { "j" }).collect();
            format!("<Enter>{keys}<Enter>")
        }
        _ => format!("c{new}<Enter>"),
    };
    screen.keys(&keys);
    let path = &cell.path;
    let text = editing(screen).editor.text().to_owned();
    assert!(new != cell.shown.text() || !cell.shown.is_written(), "{path}: nothing else to type");
    assert_ne!(text, before, "{path}: {keys}: {}", screen.text());
    let sheet = Sheet::all().into_iter().find(|sheet| editing(screen).editor.grid(sheet).cell(path).is_some());
    let sheet = sheet.unwrap_or_else(|| panic!("{path}"));
    let shown = editing(screen).editor.grid(&sheet).cell(path).unwrap().shown.text().to_owned();
    if !matches!(cell.kind, CellKind::Flags(_)) {
        assert_eq!(shown, new, "{path}");
    }
    screen.keys("u");
    assert_eq!(editing(screen).editor.text(), before, "{path}");
}

#[test]
fn every_cell_of_every_table_is_reached_by_keys_changed_and_taken_back() {
    let mut seen = std::collections::BTreeSet::new();
    for (stem, prepare) in [
        ("overhung-elastic", ""),
        ("overhung-rigid", ""),
        ("overhung-elastic", "<F2>lll "),
        ("straddle-helical", ""),
        ("tapered-hypoid", ""),
    ] {
        let (mut screen, _) = opened(80, 24, ASCII);
        screen.keys("L<Esc>");
        while screen.selected() != stem {
            screen.keys("j");
        }
        screen.keys("e");
        screen.keys(prepare);
        for (tab, side) in ["<F1>", "<F2>", "<F3>", "<F4>", "<F5>", "<F6>", "<F7>", "<F8>"]
            .into_iter()
            .flat_map(|tab| ["", "p"].map(|side| (tab, side)))
        {
            screen.keys(tab).keys(side);
            let view = editing(&screen).view.clone();
            for (row, column) in
                (0..view.rows.len()).flat_map(|row| (0..view.rows[row].places.len()).map(move |column| (row, column)))
            {
                let cell = match view.place(row, column) {
                    None => continue,
                    Some(Place::Name) => {
                        go(&mut screen, row, column);
                        continue;
                    }
                    Some(Place::Matrix) => {
                        go(&mut screen, row, column);
                        screen.keys("<Enter>");
                        for at in 0..36 {
                            let cell = view.matrix_entry(row, (at / 6, at % 6)).unwrap();
                            screen.keys("g<Home>").keys(&"<Tab>".repeat(at));
                            assert_eq!(editing(&screen).entry().unwrap().path, cell.path);
                            change(&mut screen, cell);
                            seen.insert((cell.column.key, cell.column.label.clone()));
                        }
                        screen.keys("<Esc>");
                        continue;
                    }
                    Some(Place::Cell(_)) => view.cell(row, column).unwrap(),
                };
                go(&mut screen, row, column);
                change(&mut screen, cell);
                seen.insert((cell.column.key, cell.column.label.clone()));
            }
            screen.keys(side);
        }
    }
    let keys: std::collections::BTreeSet<&str> = seen.iter().map(|(key, _)| *key).collect();
    let fields = ROOT
        .walk()
        .into_iter()
        .flat_map(|table| table.fields)
        .filter(|field| !matches!(field.kind, Kind::Table(_) | Kind::Tables(..) | Kind::NamedTables(_)));
    assert_eq!(keys, fields.map(|field| field.key).collect());
    let entries = |wanted: &str| seen.iter().filter(|(key, _)| *key == wanted).count();
    assert_eq!((entries("stiffness"), entries("point_mm"), entries("line_of_action")), (36, 3, 3));
}

#[test]
fn both_mirrored_entries_change_and_what_is_no_stiffness_says_so() {
    let (mut screen, _) = opened(80, 24, UNICODE);
    screen.keys("<F2>lll l<Enter>lc1e8<Enter>");
    let text = editing(&screen).editor.text().to_owned();
    assert_eq!(text.matches("1e8").count(), 2, "{text}");
    assert!(!screen.text().contains("semidefinite"), "{}", screen.text());
    screen.keys("kc9e9<Enter>");
    assert!(screen.text().contains("semidefinite"), "{}", screen.text());
    screen.keys("u");
    assert_eq!(screen.app.mode, Mode::Matrix);
    assert!(!screen.text().contains("semidefinite"), "{}", screen.text());
}

#[test]
fn materials_come_get_names_and_go() {
    let (mut screen, _) = opened(80, 24, UNICODE);
    screen.keys("<F7>atitanium<Enter>");
    assert!(editing(&screen).editor.text().contains("[material.titanium]"), "{}", editing(&screen).editor.text());
    screen.keys("<F1><End>hctitanium<Enter><F7>j<Home><Enter><Ctrl-u>ti<Enter>");
    let text = editing(&screen).editor.text().to_owned();
    assert!(text.contains("[material.ti]") && text.contains("material = \"ti\""), "{text}");
    screen.keys("GD");
    assert!(screen.text().contains("1 finding"), "{}", screen.text());
    screen.keys("uuuu");
    assert!(!editing(&screen).is_modified());
}
