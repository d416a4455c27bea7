//! Everything that the schema has can be seen and edited as a cell.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::collections::BTreeSet;

use bevelscope::design::grid::{Cell, CellKind, Sheet, Shown};
use bevelscope::design::library::SHIPPED;
use bevelscope::design::schema::{Kind, Limit, ROOT, target};
use bevelscope::design::{BearingModel, Design, Edit, Editor, KeyPath, Severity, Side, Spelled, Step, Towards, read};

fn fixture(name: &str) -> String {
    std::fs::read_to_string(format!("{}/tests/fixtures/valid/{name}.toml", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn path(text: &str) -> KeyPath {
    text.parse().unwrap()
}

/// Every cell of the design.
fn cells(editor: &Editor) -> Vec<Cell> {
    Sheet::all().iter().flat_map(|sheet| editor.grid(sheet).rows).flat_map(|row| row.cells).collect()
}

fn number(limit: Limit) -> Vec<String> {
    let typed = match limit {
        Limit::Between(low, high) => return vec![format!("{:?}", low + 0.3 * (high - low))],
        // within the shaft, and above all inner diameters
        _ => vec!["31", "2.5e1", "17.0"],
    };
    typed.into_iter().map(String::from).collect()
}

/// What may be typed: the first one that the design takes without an error is what the test is after.
fn valid(cell: &Cell) -> Vec<String> {
    let typed: Vec<&str> = match cell.kind {
        CellKind::Number(_, limit) => return number(limit),
        CellKind::VectorEntry(_) => vec!["0.6", "-0.61", "0.0"],
        CellKind::MatrixEntry(4, _) | CellKind::MatrixEntry(_, 4) => vec!["0", "0.0"],
        CellKind::MatrixEntry(row, column) if row == column => vec!["8e8", "9e8"],
        CellKind::MatrixEntry(..) => vec!["1.5", "0.25"],
        CellKind::Whole(1, 1) => vec!["1", "1.0"],
        CellKind::Whole(..) => vec!["3", "4"],
        CellKind::Text | CellKind::Name if cell.column.key == "material" => vec!["steel", "alloy"],
        CellKind::Text | CellKind::Name => vec!["Zahn \"9\"", "other"],
        CellKind::Texts => vec!["a, c", "x"],
        CellKind::Choice(_) | CellKind::Model(_) => cell.kind.words(),
        CellKind::Flags(_) => vec!["x z", "x y z"],
    };
    typed.into_iter().map(String::from).collect()
}

/// Numbers by what they are, not by how they are spelled.
/// Why something cannot be typed into a cell.
fn refusal(cell: &Cell, typed: &str) -> String {
    Edit::from_typed(cell, typed).unwrap_err().to_string()
}

fn value(text: &str) -> String {
    text.replace('_', "").parse::<f64>().map_or_else(|_| text.to_owned(), |number| format!("{number:?}"))
}

fn numeric(cell: &Cell) -> String {
    value(cell.shown.text())
}

fn walk(text: &str, reached: &mut BTreeSet<(&'static str, &'static str)>) {
    let mut editor = Editor::new(text).unwrap();
    let design = editor.reading().design.clone().unwrap_or_else(|| panic!("{:?}", editor.reading().findings));
    for cell in cells(&editor) {
        if design.mesh.geometry.is_some() && cell.column.key == "line_of_action" {
            // follows from the gear data, and to write both is an error of the table
            continue;
        }
        let mut changed = false;
        for typed in valid(&cell) {
            let edit = Edit::from_typed(&cell, &typed).unwrap_or_else(|error| panic!("{}: {error}", cell.path));
            let applied = editor.apply(&edit).unwrap_or_else(|error| panic!("{edit:?}: {error}"));
            if !applied.changed {
                // a choice of one word cannot become another
                changed |= cell.kind.words().len() == 1;
                continue;
            }
            let now = cells(&editor).into_iter().find(|now| now.path == cell.path).unwrap();
            // a shorter shaft may have something beyond its end: that is said elsewhere
            let own = now.findings.iter().map(|place| &editor.reading().findings[*place]);
            let has_error = own.into_iter().any(|finding| finding.severity == Severity::Error);
            if cell.column.key == "line_of_action" {
                // a line that is turned is no unit vector any more, and that is said here
                assert_eq!(editor.reading().design.is_none(), has_error);
                changed = true;
            } else {
                changed |= !has_error;
            }
            if let Some(now) = &editor.reading().design {
                assert_eq!(*now != design, numeric(&cell) != value(&typed), "{} {typed}", cell.path);
            }
            if let CellKind::Number(..) | CellKind::VectorEntry(_) | CellKind::Whole(..) | CellKind::MatrixEntry(..) =
                cell.kind
            {
                assert_eq!(now.shown, Shown::Written(typed.clone()), "{}", cell.path);
            } else if let CellKind::Choice(_) | CellKind::Model(_) | CellKind::Text | CellKind::Name = cell.kind {
                assert_eq!(now.shown, Shown::Written(typed.clone()), "{}", cell.path);
            }
            assert_eq!(editor.undo(), Some(applied));
            assert_eq!(editor.text(), text, "{}", cell.path);
        }
        if !changed {
            // a bearing that holds y has no spring in series: valid in another design
            continue;
        }
        let target = target(&cell.path).unwrap();
        // the keys of the row's own model, which several models may have
        let model = design_model(&design, &cell.path);
        let below = target.table.fields.iter().flat_map(|field| match field.kind {
            Kind::Variant(variants) => variants.iter().filter(|v| Some(v.word) == model).map(|v| v.table).collect(),
            _ => Vec::new(),
        });
        let owner = std::iter::once(target.table).chain(below).find(|table| table.field(cell.column.key).is_some());
        reached.insert((owner.unwrap().name, cell.column.key));
    }
}

/// The model of the bearing that the path leads into.
fn design_model(design: &Design, path: &KeyPath) -> Option<&'static str> {
    let [Step::Key(side), Step::Key(list), Step::Place(place), ..] = path.steps() else { return None };
    let side = Side::BOTH.into_iter().find(|known| known.name() == side).filter(|_| list == "bearing")?;
    Some(design.rotor(side).bearings.get(*place)?.model.word())
}

#[test]
fn every_field_of_the_schema_is_a_cell_that_can_be_edited() {
    let mut reached = BTreeSet::new();
    let texts = SHIPPED.iter().map(|shipped| shipped.text.to_owned());
    for text in texts
        .chain(["small", "inline", "matrix", "other-tables", "rolling", "geometry", "geometry-helical"].map(fixture))
    {
        walk(&text, &mut reached);
    }
    let mut expected = BTreeSet::new();
    for table in ROOT.walk() {
        for field in table.fields {
            match field.kind {
                Kind::Table(_) | Kind::Tables(..) | Kind::NamedTables(_) => {}
                _ => {
                    expected.insert((table.name, field.key));
                }
            }
        }
    }
    assert_eq!(reached, expected);
}

// What the reading of a cell's edit must be, for one field of each kind, through the typed structs.
#[test]
fn what_is_typed_is_what_is_read() {
    type Check = fn(&Design) -> bool;
    let cases: [(&str, &str, Check); 12] = [
        ("name", "x", |d| d.name == "x"),
        ("tags", "p, q", |d| d.tags == ["p", "q"]),
        ("analysis.frequency_lines", "77", |d| d.analysis.frequency_lines == 77),
        ("analysis.frequency_spacing", "lo", |d| d.analysis.frequency_spacing.word() == "log"),
        ("material.steel.density_kg_per_m3", "7.8 g/cm3", |d| d.materials["steel"].density == 7800.0),
        ("mesh.stiffness_n_per_m", "650 N/um", |d| d.mesh.stiffness == 6.5e8),
        ("mesh.damping", "7 %", |d| d.mesh.damping == 0.07),
        ("mesh.gear.point_mm[2]", "3 in", |d| d.mesh.gear.point[2] == 0.0762),
        ("pinion.segment[2].outer_diameter_mm", "0.037 m", |d| d.pinion.segments[2].outer_diameter == 0.037),
        (
            "pinion.bearing[0].krx_n_m_per_rad",
            "160 kNm/rad",
            |d| matches!(&d.pinion.bearings[0].model, BearingModel::Diagonal(springs) if springs.krx == 1.6e5),
        ),
        ("pinion.bearing[1].model", "rigid", |d| d.pinion.bearings[1].model.word() == "rigid"),
        ("gear.teeth", "41", |d| d.gear.teeth == Some(41)),
    ];
    for (at, typed, check) in cases {
        let mut editor = Editor::new(SHIPPED[0].text).unwrap();
        let cell = cells(&editor).into_iter().find(|cell| cell.path == path(at)).unwrap_or_else(|| panic!("{at}"));
        editor.apply(&Edit::from_typed(&cell, typed).unwrap()).unwrap();
        let reading = editor.reading();
        // torque arms that contradict the numbers of teeth are a warning
        let design = reading.design.as_ref().or_else(|| panic!("{at}: {:?}", reading.findings)).unwrap();
        assert!(check(design), "{at}");
    }
}

#[test]
fn what_a_cell_shows_typed_again_changes_nothing() {
    let texts = SHIPPED.iter().map(|shipped| shipped.text.to_owned());
    for text in texts.chain(["small", "inline", "other-tables", "numbers"].map(fixture)) {
        let mut editor = Editor::new(text.as_str()).unwrap();
        for cell in cells(&editor).into_iter().filter(|cell| cell.shown.is_written()) {
            let edit =
                Edit::from_typed(&cell, cell.shown.text()).unwrap_or_else(|error| panic!("{}: {error}", cell.path));
            let before = editor.reading().clone();
            editor.apply(&edit).unwrap();
            assert_eq!(editor.reading().design, before.design, "{}", cell.path);
            // other quotes are all that may be different
            let plain = |text: &str| text.replace('\'', "\"");
            assert_eq!(plain(editor.text()), plain(&text), "{}", cell.path);
            while editor.undo().is_some() {}
        }
    }
}

#[test]
fn defaults_are_shown_and_marked_and_come_back_when_cleared() {
    let mut editor = Editor::new(fixture("small")).unwrap();
    let shown = |editor: &Editor, at: &str| cells(editor).into_iter().find(|cell| cell.path == path(at)).unwrap().shown;
    for (at, expected) in [
        ("pinion.segment[0].inner_diameter_mm", Shown::Default("0.0".into())),
        ("pinion.segment[0].material", Shown::Default("steel".into())),
        ("pinion.segment[0].elements", Shown::Written("5".into())),
        ("gear.bearing[1].name", Shown::Default("B2".into())),
        ("gear.bearing[1].model", Shown::Default("diagonal".into())),
        ("pinion.body[0].name", Shown::Default("body 1".into())),
        ("analysis.frequency_max_hz", Shown::Default("5000.0".into())),
        ("material.steel.youngs_modulus_gpa", Shown::Default("206.0".into())),
        ("pinion.teeth", Shown::Nothing),
        ("description", Shown::Nothing),
    ] {
        assert_eq!(shown(&editor, at), expected, "{at}");
    }
    let before = editor.text().to_owned();
    for (at, typed) in
        [("analysis.frequency_max_hz", "4 kHz"), ("material.steel.poissons_ratio", "0.29"), ("pinion.teeth", "9")]
    {
        let cell = cells(&editor).into_iter().find(|cell| cell.path == path(at)).unwrap();
        editor.apply(&Edit::from_typed(&cell, typed).unwrap()).unwrap();
        assert!(shown(&editor, at).is_written());
        editor.apply(&Edit::from_typed(&cell, " ").unwrap()).unwrap();
        assert_eq!(shown(&editor, at), cell.shown);
    }
    let length = cells(&editor).into_iter().find(|cell| cell.path == path("pinion.segment[0].length_mm")).unwrap();
    assert_eq!(refusal(&length, ""), "length cannot be left empty");
    assert_eq!(read(editor.text()).design, read(&before).design);
}

#[test]
fn what_cannot_be_typed_says_what_can() {
    let editor = Editor::new(SHIPPED[0].text).unwrap();
    for (at, typed, error) in [
        ("mesh.damping", "much", "a number is wanted, e.g. 0.03 or 3 %"),
        ("analysis.frequency_lines", "2.5", "a whole number is wanted; this is 2.5"),
        ("analysis.damping_model", "elastic", "one of these is wanted: hysteretic, viscous"),
        ("pinion.bearing[0].model", "x", "one of these is wanted: diagonal, matrix, rigid, ball, roller"),
        ("pinion.segment[0].length_mm", "3,5", "write 3.5: the decimal separator is a point"),
        ("tags", "[1]", "a list of texts is wanted: [\"a\", \"b\"], or a, b"),
    ] {
        let cell = cells(&editor).into_iter().find(|cell| cell.path == path(at)).unwrap();
        assert_eq!(refusal(&cell, typed), error, "{at}");
    }
    let mut rigid = Editor::new(SHIPPED[1].text).unwrap();
    let hold = cells(&rigid).into_iter().find(|cell| cell.column.key == "hold").unwrap();
    assert_eq!(refusal(&hold, "w"), "any of these are wanted: x, y, z");
    for typed in ["z, x", "xz", "[\"x\", \"z\"]", "x+z"] {
        let Ok(Edit::Set { value, .. }) = Edit::from_typed(&hold, typed) else { panic!("{typed}") };
        assert_eq!(value.as_str(), "[\"x\", \"z\"]");
    }
    let bearing = hold.path.split_last().unwrap().0;
    rigid.apply(&Edit::SetModel { bearing: bearing.clone(), model: "matrix".into() }).unwrap();
    let entry = |i, j| cells(&rigid).into_iter().find(|cell| cell.kind == CellKind::MatrixEntry(i, j)).unwrap();
    for (i, j, typed, expected) in [
        (0, 1, "1 N/um", Ok("1e6")),
        (0, 3, "2 kN/rad", Ok("2000.0")),
        (3, 0, "-2.5 N", Ok("-2.5")),
        (3, 3, "2 kN m/rad", Ok("2000.0")),
        (4, 1, "-7000 kN", Ok("-7e6")),
        (0, 3, "600 N/um", Err("unknown unit `N/um`; accepted: N/rad, kN/rad, MN/rad, lbf/rad")),
        (0, 3, "2 lbf/in", Err("unknown unit `lbf/in`; accepted: N/rad, kN/rad, MN/rad, lbf/rad")),
        (3, 0, "600 N/um", Err("unknown unit `N/um`; accepted: N, kN, MN, lbf")),
        (3, 0, "x", Err("a number is wanted in N, e.g. -5000 or -5 kN")),
    ] {
        let edit = Edit::from_typed(&entry(i, j), typed);
        let spelled =
            edit.map(|edit| if let Edit::Set { value, .. } = edit { value.as_str().to_owned() } else { panic!() });
        assert_eq!(
            spelled.map_err(|error| error.to_string()),
            expected.map(String::from).map_err(String::from),
            "{typed}"
        );
    }
}

#[test]
fn columns_are_those_of_every_row_and_a_models_own_come_after() {
    let editor = Editor::new(fixture("inline")).unwrap();
    let grid = editor.grid(&Sheet::bearings(Side::Pinion));
    let columns: Vec<&str> = grid.columns.iter().map(|column| column.key).collect();
    assert_eq!(columns, ["name", "position_mm", "axial_series_stiffness_n_per_m", "model"]);
    let keys = |row: usize| grid.rows[row].cells.iter().map(|cell| cell.column.key).collect::<Vec<_>>();
    assert_eq!(keys(0)[..4], columns);
    assert_eq!(keys(0)[4..], ["kx_n_per_m", "ky_n_per_m", "kz_n_per_m", "krx_n_m_per_rad", "krz_n_m_per_rad"]);
    assert_eq!(keys(1)[4..], ["hold"]);
    let labels: Vec<&str> = grid.rows.iter().map(|row| row.label.as_str()).collect();
    assert_eq!(labels, ["B1", "B2"]);
    for sheet in Sheet::all() {
        let grid = editor.grid(&sheet);
        for row in &grid.rows {
            let shared: Vec<_> = row.cells.iter().take(grid.columns.len()).map(|cell| &cell.column).collect();
            assert_eq!(shared, grid.columns.iter().collect::<Vec<_>>(), "{}", row.path);
        }
    }
    let gear = editor.grid(&Sheet::bearings(Side::Gear));
    assert_eq!(gear.rows[0].cells.len(), 4 + 36);
    assert_eq!(
        (gear.rows[0].cells[4 + 5].column.label.as_str(), gear.rows[0].cells[4 + 5].column.unit),
        ("x thz", "N/rad")
    );
    assert_eq!(editor.grid(&Sheet::segments(Side::Pinion)).rows[1].label, "segment 2");
    let materials: Vec<String> = editor.grid(&Sheet::materials()).rows.into_iter().map(|row| row.label).collect();
    assert_eq!(materials, ["steel", "alloy"]);
}

#[test]
fn sheets_are_those_of_the_schema() {
    let paths: Vec<String> = Sheet::all().iter().map(|sheet| sheet.path.to_string()).collect();
    let rotor = |side: &str| ["", ".segment", ".body", ".bearing", ".drive"].map(|list| format!("{side}{list}"));
    let mut expected: BTreeSet<String> =
        ["", "analysis", "material", "mesh", "mesh.pinion", "mesh.gear", "mesh.geometry", "operating"]
            .map(String::from)
            .into();
    expected.extend(rotor("pinion"));
    expected.extend(rotor("gear"));
    assert_eq!(paths.len(), expected.len());
    assert_eq!(paths.into_iter().collect::<BTreeSet<_>>(), expected);
    let all = Sheet::all();
    for side in Side::BOTH {
        for sheet in [
            Sheet::mesh_side(side),
            Sheet::rotor(side),
            Sheet::segments(side),
            Sheet::bodies(side),
            Sheet::bearings(side),
            Sheet::drive(side),
        ] {
            assert!(all.contains(&sheet), "{}", sheet.path);
        }
    }
    for sheet in [
        Sheet::design(),
        Sheet::analysis(),
        Sheet::materials(),
        Sheet::mesh(),
        Sheet::mesh_geometry(),
        Sheet::operating(),
    ] {
        assert!(all.contains(&sheet), "{}", sheet.path);
    }
}

#[test]
fn findings_are_beside_their_cells() {
    let mut editor = Editor::new(SHIPPED[0].text).unwrap();
    let set = |editor: &mut Editor, at: &str, value: &str| {
        editor.apply(&Edit::Set { path: path(at), value: Spelled::parse(value).unwrap() }).unwrap();
    };
    set(&mut editor, "pinion.segment[1].inner_diameter_mm", "50");
    set(&mut editor, "mesh.pinion.line_of_action[0]", "0");
    set(&mut editor, "gear.bearing[0].position_mm", "'x'");
    let found = |editor: &Editor| {
        let beside = cells(editor).into_iter().filter(|cell| !cell.findings.is_empty());
        beside.map(|cell| cell.path.to_string()).collect::<Vec<_>>()
    };
    let expected = [
        "mesh.pinion.line_of_action[0]",
        "mesh.pinion.line_of_action[1]",
        "mesh.pinion.line_of_action[2]",
        "pinion.segment[1].inner_diameter_mm",
        "gear.bearing[0].position_mm",
    ];
    assert_eq!(found(&editor), expected);
    let segments = editor.grid(&Sheet::segments(Side::Pinion));
    assert!(segments.rows[0].findings.is_empty() && segments.rows[1].findings.len() == 1);
    assert!(editor.grid(&Sheet::rotor(Side::Pinion)).rows[0].findings.is_empty());
    // every finding is beside something, or about a list
    editor.apply(&Edit::MoveRow { row: path("pinion.segment[1]"), towards: Towards::Start }).unwrap();
    assert_eq!(editor.grid(&Sheet::segments(Side::Pinion)).rows[0].findings.len(), 1);
    for place in (0..4).rev() {
        editor.apply(&Edit::DeleteRow { row: path("gear.segment").place(place) }).unwrap();
    }
    assert_eq!(editor.grid(&Sheet::segments(Side::Gear)).findings.len(), 1, "{:?}", editor.reading().findings);
}
