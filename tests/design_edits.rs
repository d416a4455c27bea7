//! Edits by meaning: what each does to the text, what it is called, and that it can be taken back.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use bevelscope::design::library::SHIPPED;
use bevelscope::design::{BearingModel, Edit, EditError, EditName, Editor, KeyPath, Spelled, Towards};

fn path(text: &str) -> KeyPath {
    text.parse().unwrap()
}

fn set(at: &str, value: &str) -> Edit {
    Edit::Set { path: path(at), value: Spelled::parse(value).unwrap() }
}

fn insert(list: &str, place: usize) -> Edit {
    Edit::InsertRow { list: path(list), place }
}

fn delete(row: &str) -> Edit {
    Edit::DeleteRow { row: path(row) }
}

fn down(row: &str) -> Edit {
    Edit::MoveRow { row: path(row), towards: Towards::End }
}

fn up(row: &str) -> Edit {
    Edit::MoveRow { row: path(row), towards: Towards::Start }
}

fn model(bearing: &str, model: &str) -> Edit {
    Edit::SetModel { bearing: path(bearing), model: model.into() }
}

/// The text after the edit, which was undone and redone on the way.
fn edited(text: &str, edit: &Edit) -> String {
    let mut editor = Editor::new(text).unwrap();
    let applied = editor.apply(edit).unwrap_or_else(|error| panic!("{edit:?} in {text:?}: {error}"));
    let after = editor.text().to_owned();
    assert_eq!(applied.changed, after != text);
    if applied.changed {
        assert_eq!(editor.undo_name(), Some(&applied.name));
        assert_eq!(editor.undo(), Some(applied.clone()));
        assert_eq!(editor.text(), text);
        assert_eq!(editor.redo(), Some(applied));
        assert_eq!(editor.text(), after);
    }
    after
}

const ROWS: &str = "\
[pinion]
teeth = 9

# the first
[[pinion.segment]] # head
length_mm = 10 # short
outer_diameter_mm = 30

# ---- a banner ----

[[pinion.segment]]
length_mm = 20
outer_diameter_mm = 40
# below

# about the body
[[pinion.body]]
mass_kg = 1
";

#[test]
fn rows_with_headers_move_with_their_comments() {
    let moved = "\
[pinion]
teeth = 9

[[pinion.segment]]
length_mm = 20
outer_diameter_mm = 40
# below

# ---- a banner ----

# the first
[[pinion.segment]] # head
length_mm = 10 # short
outer_diameter_mm = 30

# about the body
[[pinion.body]]
mass_kg = 1
";
    assert_eq!(edited(ROWS, &down("pinion.segment[0]")), moved);
    assert_eq!(edited(moved, &up("pinion.segment[1]")), ROWS);
    assert_eq!(edited(&ROWS.replace('\n', "\r\n"), &up("pinion.segment[1]")), moved.replace('\n', "\r\n"));
    // also at the end of a file without a last line break
    assert_eq!(edited("[[a.s]]\nx = 1\n[[a.s]]\nx = 2", &down("a.s[0]")), "[[a.s]]\nx = 2\n[[a.s]]\nx = 1");
}

#[test]
fn rows_with_headers_are_deleted_with_their_comments() {
    let without_first = "\
[pinion]
teeth = 9

# ---- a banner ----

[[pinion.segment]]
length_mm = 20
outer_diameter_mm = 40
# below

# about the body
[[pinion.body]]
mass_kg = 1
";
    assert_eq!(edited(ROWS, &delete("pinion.segment[0]")), without_first);
    let without_second = ROWS.replace("[[pinion.segment]]\nlength_mm = 20\nouter_diameter_mm = 40\n# below\n\n", "");
    assert_eq!(edited(ROWS, &delete("pinion.segment[1]")), without_second);
    let without_body = ROWS.replace("\n# about the body\n[[pinion.body]]\nmass_kg = 1\n", "");
    assert_eq!(edited(ROWS, &delete("pinion.body[0]")), without_body);
    assert_eq!(edited(ROWS, &delete("pinion.body[body 1]")), without_body);
    assert_eq!(edited("[[a.s]]\nx = 1", &delete("a.s[0]")), "");
    // rows that stand close stay close
    let close = "[[a.s]]\nx = 1\n[[a.s]]\nx = 2\n\n[b]\n";
    assert_eq!(edited(close, &delete("a.s[1]")), "[[a.s]]\nx = 1\n\n[b]\n");
    assert_eq!(edited(close, &delete("a.s[0]")), "[[a.s]]\nx = 2\n\n[b]\n");
}

#[test]
fn rows_with_headers_are_inserted_like_their_neighbours() {
    let row = "[[pinion.segment]]\nlength_mm = 10\nouter_diameter_mm = 30\n";
    let at_start = ROWS.replacen("# the first", &format!("{row}\n# the first"), 1);
    assert_eq!(edited(ROWS, &insert("pinion.segment", 0)), at_start);
    let behind_first = ROWS.replacen("\n\n# ---- a", &format!("\n\n{row}\n# ---- a"), 1);
    assert_eq!(edited(ROWS, &insert("pinion.segment", 1)), behind_first);
    let row = "[[pinion.segment]]\nlength_mm = 20\nouter_diameter_mm = 40\n";
    let at_end = ROWS.replacen("# below\n", &format!("# below\n\n{row}"), 1);
    assert_eq!(edited(ROWS, &insert("pinion.segment", 2)), at_end);
    // the first row of a list that is not there comes where the schema has it
    let bearing = "[[pinion.bearing]]\nposition_mm = 15.0\nkx_n_per_m = 1.0e8\nkz_n_per_m = 1.0e8\n";
    assert_eq!(edited(ROWS, &insert("pinion.bearing", 0)), format!("{ROWS}\n{bearing}"));
    let indented = "[pinion]\n\t[[pinion.segment]]\n\t\tlength_mm = 1\n\t\touter_diameter_mm = 2\n";
    assert_eq!(
        edited(indented, &insert("pinion.segment", 1)),
        format!("{indented}\t[[pinion.segment]]\n\t\tlength_mm = 1\n\t\touter_diameter_mm = 2\n")
    );
}

const INLINE: &str = "\
[gear]
teeth = 9 # c
segment = [{ length_mm = 10, outer_diameter_mm = 30 }, { length_mm = 20, outer_diameter_mm = 40 }] # all
body = [
  # heavy
  { name = \"ring\", mass_kg = 3 }, # steel
  { mass_kg = 1 }
]
";

#[test]
fn inline_rows_come_go_and_move() {
    let row = "{ length_mm = 10, outer_diameter_mm = 30 }";
    let expected = INLINE.replacen("}, {", &format!("}}, {row}, {{"), 1);
    assert_eq!(edited(INLINE, &insert("gear.segment", 1)), expected);
    assert_eq!(edited(INLINE, &delete("gear.segment[0]")), INLINE.replacen(&format!("{row}, "), "", 1));
    let swapped = "[{ length_mm = 20, outer_diameter_mm = 40 }, { length_mm = 10, outer_diameter_mm = 30 }] # all";
    let (start, rest) = INLINE.split_once("segment = ").unwrap();
    let (_, rest) = rest.split_once('\n').unwrap();
    assert_eq!(edited(INLINE, &down("gear.segment[0]")), format!("{start}segment = {swapped}\n{rest}"));
    assert_eq!(
        edited(INLINE, &up("gear.body[1]")),
        INLINE.replacen(
            "  # heavy\n  { name = \"ring\", mass_kg = 3 }, # steel\n  { mass_kg = 1 }\n",
            "  { mass_kg = 1 },\n  # heavy\n  { name = \"ring\", mass_kg = 3 } # steel\n",
            1
        )
    );
    assert_eq!(
        edited(INLINE, &delete("gear.body[ring]")),
        INLINE.replacen("  # heavy\n  { name = \"ring\", mass_kg = 3 }, # steel\n", "", 1)
    );
    let position = "position_mm = 15.0";
    let bearing = format!("{{ {position}, kx_n_per_m = 1.0e8, kz_n_per_m = 1.0e8 }}");
    assert_eq!(edited(INLINE, &insert("gear.bearing", 0)), format!("{INLINE}bearing = [{bearing}]\n"));
    assert_eq!(edited("body = [{ a = 1 }]", &delete("body[0]")), "body = []");
}

#[test]
fn a_copy_has_a_name_of_its_own() {
    for (rows, expected) in [
        ("[[gear.body]] # c\nname = \"ring\" # n\n", "[[gear.body]] # c\nname = \"ring 2\" # n\n"),
        ("[[gear.body]]\nname = \"B1\"\n[[gear.body]]\nname = \"B2\"\n", "[[gear.body]]\nname = \"B3\"\n"),
        ("[[gear.body]]\nmass_kg = 1\n", "[[gear.body]]\nmass_kg = 1\n"),
        ("[[gear.body]]\n[[gear.body]]\nname = \"body 2\"\n", "[[gear.body]]\nname = \"body 3\"\n"),
    ] {
        let first = rows[2..].find("[[").map_or(rows.len(), |at| at + 2);
        let (first, rest) = rows.split_at(first);
        assert_eq!(edited(rows, &Edit::DuplicateRow { row: path("gear.body[0]") }), format!("{first}{expected}{rest}"));
    }
}

#[test]
fn entries_of_lists_change_one_by_one() {
    for (text, edit, expected) in [
        ("tags = ['a', \"b\", 'c'] # t", set("tags", "[\"a\", \"x\", \"c\"]"), "tags = ['a', \"x\", 'c'] # t"),
        ("tags = ['a', 'c']", set("tags", "[\"a\", \"b\", \"c\"]"), "tags = ['a', \"b\", 'c']"),
        ("tags = ['a', 'b', 'c']", set("tags", "[\"c\"]"), "tags = ['c']"),
        ("tags = ['a']", set("tags", "[]"), "tags = []"),
        ("name = \"n\"", set("tags", "[\"a\"]"), "name = \"n\"\ntags = [\"a\"]"),
        ("tags = 'a, b'", set("tags", "[\"a\"]"), "tags = [\"a\"]"),
        ("tags = ['a']", Edit::Remove { path: path("note") }, "tags = ['a']"),
        ("tags = ['a', 'b']", Edit::Remove { path: path("tags[0]") }, "tags = ['b']"),
        (
            "mesh.pinion.point_mm = [ 1, 2.0,3 ] # p",
            set("mesh.pinion.point_mm[1]", "9"),
            "mesh.pinion.point_mm = [ 1, 9,3 ] # p",
        ),
        ("mesh.damping = 1", set("mesh.gear.point_mm[2]", "9"), "mesh.damping = 1\nmesh.gear.point_mm = [0.0, 0.0, 9]"),
        ("mesh.gear.point_mm = [7]", set("mesh.gear.point_mm[2]", "9"), "mesh.gear.point_mm = [7, 0.0, 9]"),
    ] {
        assert_eq!(edited(text, &edit), expected, "{text}");
    }
}

const BEARING: &str = "\
[[pinion.bearing]] # b
name = \"B1\"
position_mm = 5
model = \"diagonal\" # m
kx_n_per_m = 6.0e8
kz_n_per_m = 5e8 # z
krx_n_m_per_rad = 8e4
axial_series_stiffness_n_per_m = 9e8 # nut
";

const MATRIX: &str = "\
[[pinion.bearing]] # b
name = \"B1\"
position_mm = 5
model = \"matrix\" # m
stiffness = [
    [6.0e8, 0.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 5e8, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 8e4, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
]
axial_series_stiffness_n_per_m = 9e8 # nut
";

#[test]
fn a_model_brings_its_keys_and_takes_those_of_the_old_one() {
    assert_eq!(edited(BEARING, &model("pinion.bearing[B1]", "matrix")), MATRIX);
    let springs =
        "kx_n_per_m = 6.0e8\nky_n_per_m = 0.0\nkz_n_per_m = 5e8\nkrx_n_m_per_rad = 8e4\nkrz_n_m_per_rad = 0.0\n";
    let head = "[[pinion.bearing]] # b\nname = \"B1\"\nposition_mm = 5\n";
    let kc = "axial_series_stiffness_n_per_m = 9e8 # nut\n";
    assert_eq!(
        edited(MATRIX, &model("pinion.bearing[0]", "diagonal")),
        format!("{head}model = \"diagonal\" # m\n{springs}{kc}")
    );
    let rigid = format!("{head}model = \"rigid\" # m\nhold = [\"x\", \"z\"]\n{kc}");
    assert_eq!(edited(BEARING, &model("pinion.bearing[0]", "rigid")), rigid);
    assert_eq!(edited(BEARING, &set("pinion.bearing[0].model", "\"rigid\"")), rigid);
    let springs = springs.replace("6.0e8", "1.0e9").replace("5e8", "1.0e9").replace("8e4", "0.0");
    assert_eq!(
        edited(&rigid, &model("pinion.bearing[0]", "diagonal")),
        format!("{head}model = \"diagonal\" # m\n{springs}{kc}")
    );
    // a bearing that holds y has no spring in series
    let axial = "[[gear.bearing]]\nposition_mm = 1\nky_n_per_m = 1e8\naxial_series_stiffness_n_per_m = 9e8\n";
    assert_eq!(
        edited(axial, &model("gear.bearing[0]", "rigid")),
        "[[gear.bearing]]\nposition_mm = 1\nmodel = \"rigid\"\nhold = [\"y\"]\n"
    );
    assert_eq!(
        edited("bearing = [{ position_mm = 1, kx_n_per_m = 2e8 }]", &set("bearing[0].x", "1")),
        "bearing = [{ position_mm = 1, kx_n_per_m = 2e8, x = 1 }]"
    );
    let inline = "[gear]\nbearing = [{ position_mm = 1, kx_n_per_m = 2e8 }]";
    assert_eq!(
        edited(inline, &model("gear.bearing[0]", "rigid")),
        "[gear]\nbearing = [{ position_mm = 1, model = \"rigid\", hold = [\"x\"] }]"
    );
    assert!(!edited(inline, &model("gear.bearing[0]", "matrix")).trim_end().contains("\n    "));
    // clearing the word means the default, and so do its keys
    let cleared = edited(&rigid, &Edit::Remove { path: path("pinion.bearing[0].model") });
    assert!(!cleared.contains("model") && cleared.contains("kx_n_per_m = 1.0e9"), "{cleared}");
    assert_eq!(edited(BEARING, &model("pinion.bearing[0]", "diagonal")), BEARING);
}

#[test]
fn an_entry_of_a_matrix_changes_its_mirror_in_one_edit() {
    let changed = MATRIX.replacen("[6.0e8, 0.0,", "[6.0e8, -1e6,", 1).replacen(
        "[0.0, 0.0, 0.0, 0.0, 0.0, 0.0]",
        "[-1e6, 0.0, 0.0, 0.0, 0.0, 0.0]",
        1,
    );
    assert_eq!(edited(MATRIX, &set("pinion.bearing[0].stiffness[0][1]", "-1e6")), changed);
    assert_eq!(edited(MATRIX, &set("pinion.bearing[0].stiffness[1][0]", "-1e6")), changed);
    assert_eq!(edited(MATRIX, &set("pinion.bearing[0].stiffness[0][0]", "7e8")), MATRIX.replace("6.0e8", "7e8"));
    let missing = "[[gear.bearing]]\nmodel = \"matrix\"\n";
    let made = edited(missing, &set("gear.bearing[0].stiffness[5][0]", "3"));
    assert_eq!(made.matches('3').count(), 2, "{made}");
}

const MATERIALS: &str = "\
[material.\"Ti 6-4\"] # light
youngs_modulus_gpa = 112
poissons_ratio = 0.34
density_kg_per_m3 = 4430

[[pinion.segment]]
length_mm = 1
material = \"Ti 6-4\" # hollow
[gear]
segment = [{ material = 'Ti 6-4' }, { length_mm = 1 }]
";

#[test]
fn materials_are_renamed_wherever_they_are_named() {
    let rename = |from: &str, to: &str| Edit::RenameMaterial { from: from.into(), to: to.into() };
    let expected = MATERIALS
        .replace("'Ti 6-4'", "\"Ti 6-4\"")
        .replace("material.\"Ti 6-4\"", "material.ti")
        .replace("Ti 6-4", "ti");
    assert_eq!(edited(MATERIALS, &rename("Ti 6-4", "ti")), expected);
    // what is not written is steel
    let steel = edited(MATERIALS, &rename("steel", "S"));
    assert!(
        steel.contains("[material.S]\nyoungs_modulus_gpa = 206.0\npoissons_ratio = 0.3\ndensity_kg_per_m3 = 7850.0\n")
    );
    assert!(steel.contains("{ length_mm = 1, material = \"S\" }"), "{steel}");
    let partly = "[material.steel]\npoissons_ratio = 0.29\n";
    assert_eq!(
        edited(partly, &rename("steel", "S")),
        "[material.S]\nyoungs_modulus_gpa = 206.0\npoissons_ratio = 0.29\ndensity_kg_per_m3 = 7850.0\n"
    );
    for (inline, expected) in [
        ("material = { a = { x = 1 } }", "material = { b = { x = 1 } }"),
        ("material.a.x = 1\nmaterial.a.y = 2", "material.b.x = 1\nmaterial.b.y = 2"),
        ("[material]\na.x = 1", "[material]\nb.x = 1"),
    ] {
        assert_eq!(edited(inline, &rename("a", "b")), expected);
    }
    let mut editor = Editor::new(MATERIALS).unwrap();
    for (from, to) in [("gone", "x"), ("Ti 6-4", " ")] {
        assert!(editor.apply(&rename(from, to)).is_err());
    }
}

#[test]
fn materials_come_and_go() {
    let added = edited(MATERIALS, &Edit::AddMaterial { name: "brass \"5\"".into() });
    let table =
        "[material.'brass \"5\"']\nyoungs_modulus_gpa = 206.0\npoissons_ratio = 0.3\ndensity_kg_per_m3 = 7850.0\n";
    // as close to its neighbours as other tables are in this file
    assert_eq!(added, MATERIALS.replacen("4430\n", &format!("4430\n\n{table}"), 1));
    let removed = edited(MATERIALS, &Edit::RemoveMaterial { name: "Ti 6-4".into() });
    assert!(removed.starts_with("[[pinion.segment]]"), "{removed}");
    let mut editor = Editor::new(MATERIALS).unwrap();
    assert!(matches!(editor.apply(&Edit::AddMaterial { name: "Ti 6-4".into() }), Err(EditError::Refused(_))));
    assert!(matches!(editor.apply(&Edit::AddMaterial { name: String::new() }), Err(EditError::Refused(_))));
}

#[test]
fn edits_are_called_what_they_mean() {
    let text = SHIPPED[0].text;
    for (edit, name) in [
        (set("pinion.segment[2].outer_diameter_mm", "37"), "outer diameter of pinion segment 3"),
        (set("pinion.bearing[0].kx_n_per_m", "1"), "kx of pinion bearing head bearing"),
        (set("mesh.pinion.point_mm[2]", "1"), "point z of mesh pinion"),
        (set("mesh.damping", "1"), "damping of mesh"),
        (set("name", "'x'"), "name of design"),
        (set("analysis.frequency_lines", "10"), "frequency lines of analysis"),
        (set("material.steel.density_kg_per_m3", "1"), "density of material steel"),
        (
            Edit::Remove { path: path("pinion.segment[0].inner_diameter_mm") },
            "clear inner diameter of pinion segment 1",
        ),
        (delete("gear.body[ring gear]"), "delete body ring gear of gear"),
        (delete("gear.body[0]"), "delete body ring gear of gear"),
        (down("pinion.segment[0]"), "move segment 1 of pinion down"),
        (insert("gear.bearing", 2), "insert bearing B3 of gear"),
        (Edit::DuplicateRow { row: path("gear.body[0]") }, "duplicate body ring gear of gear"),
        (model("pinion.bearing[head bearing]", "rigid"), "model of pinion bearing head bearing: rigid"),
        (Edit::AddMaterial { name: "brass".into() }, "add material brass"),
    ] {
        let mut editor = Editor::new(text).unwrap();
        assert_eq!(editor.apply(&edit).unwrap().name.as_str(), name);
    }
}

#[test]
fn what_cannot_be_done_leaves_everything_as_it_was() {
    let mut editor = Editor::new(SHIPPED[0].text).unwrap();
    for edit in [
        up("pinion.segment[0]"),
        down("pinion.segment[3]"),
        down("pinion.segment[9]"),
        delete("pinion.segment[4]"),
        delete("pinion.body[nobody]"),
        delete("pinion"),
        insert("pinion.segment", 9),
        insert("pinion", 0),
        insert("pinion.drive", 0),
        insert("nowhere", 0),
        set("pinion", "1"),
        set("pinion.segment", "1"),
        set("pinion.bearing[7].name", "'x'"),
        model("pinion.bearing[0]", "magnetic"),
        model("pinion.bearing[5]", "rigid"),
        model("pinion", "rigid"),
        Edit::Remove { path: path("pinion.nothing") },
        Edit::Remove { path: path("mesh.pinion.point_mm[0]") },
        Edit::RemoveMaterial { name: "steel".into() },
        Edit::ReplaceText { text: "a = ".into(), name: EditName::new("reload") },
    ] {
        assert!(editor.apply(&edit).is_err(), "{edit:?}");
        assert_eq!(editor.text(), SHIPPED[0].text, "{edit:?}");
        assert!(editor.undo_name().is_none() && !editor.is_modified());
    }
    assert!(Editor::new("a = ").is_err());
}

#[test]
fn errors_in_a_design_are_allowed_and_found() {
    let mut editor = Editor::new(SHIPPED[0].text).unwrap();
    editor.apply(&set("pinion.segment[0].length_mm", "-1")).unwrap();
    assert!(editor.reading().design.is_none());
    assert_eq!(editor.reading().errors().next().unwrap().shown_path(), "pinion.segment[0].length_mm");
    editor.undo();
    assert!(editor.reading().design.is_some());
}

#[test]
fn history_outlives_saving_and_what_says_the_same_is_no_edit() {
    let mut editor = Editor::new(SHIPPED[0].text).unwrap();
    assert!(editor.undo().is_none() && editor.redo().is_none() && !editor.is_modified());
    editor.apply(&set("mesh.damping", "0.07")).unwrap();
    assert!(editor.is_modified());
    editor.mark_saved(editor.text().to_owned());
    assert!(!editor.is_modified() && editor.saved_text() == editor.text());
    assert!(!editor.apply(&set("mesh.damping", "0.07")).unwrap().changed);
    editor.undo();
    assert!(editor.is_modified() && editor.text() == SHIPPED[0].text);
    assert_eq!(editor.redo_name().unwrap().as_str(), "damping of mesh");
    editor.redo();
    assert!(!editor.is_modified());
    let text = SHIPPED[1].text.to_owned();
    let reload = EditName::new("reload from disk");
    editor.apply(&Edit::ReplaceText { text, name: reload.clone() }).unwrap();
    assert_eq!(editor.text(), SHIPPED[1].text);
    assert_eq!(editor.undo().unwrap().name, reload);
    editor.apply(&set("mesh.damping", "0.08")).unwrap();
    assert!(editor.redo().is_none());
}

#[test]
fn the_focus_follows_the_row() {
    let mut editor = Editor::new(SHIPPED[0].text).unwrap();
    let mut focus = |edit: &Edit| editor.apply(edit).unwrap().focus.to_string();
    assert_eq!(focus(&down("pinion.segment[0]")), "pinion.segment[1]");
    assert_eq!(focus(&insert("pinion.segment", 4)), "pinion.segment[4]");
    assert_eq!(focus(&delete("pinion.segment[4]")), "pinion.segment[3]");
    assert_eq!(focus(&Edit::DuplicateRow { row: path("gear.body[ring gear]") }), "gear.body[1]");
    assert_eq!(focus(&set("gear.body[differential].mass_kg", "1")), "gear.body[2].mass_kg");
}

// New rows and models are designs that can be read, whatever they are put beside.
#[test]
fn what_edits_make_up_is_valid() {
    for shipped in SHIPPED {
        for side in ["pinion", "gear"] {
            for list in ["segment", "body", "bearing"] {
                for place in 0..2 {
                    let mut editor = Editor::new(shipped.text).unwrap();
                    editor.apply(&insert(&format!("{side}.{list}"), place)).unwrap();
                    assert_eq!(editor.reading().errors().count(), 0, "{list} {place}: {:?}", editor.reading().findings);
                }
            }
            for word in ["diagonal", "matrix", "rigid"] {
                let mut editor = Editor::new(shipped.text).unwrap();
                editor.apply(&model(&format!("{side}.bearing[0]"), word)).unwrap();
                let design =
                    editor.reading().design.as_ref().unwrap_or_else(|| panic!("{:?}", editor.reading().findings));
                let bearings = if side == "pinion" { &design.pinion.bearings } else { &design.gear.bearings };
                assert_eq!(bearings[0].model.word(), word);
            }
        }
    }
    let mut editor = Editor::new(SHIPPED[0].text).unwrap();
    editor.apply(&model("pinion.bearing[0]", "matrix")).unwrap();
    let design = editor.reading().design.clone().unwrap();
    let BearingModel::Matrix(matrix) = design.pinion.bearings[0].model else { panic!("a matrix") };
    let diagonal: Vec<f64> = (0..6).map(|i| matrix[i][i]).collect();
    assert_eq!(diagonal, [6e8, 2.5e8, 6e8, 1.5e5, 0.0, 1.5e5]);
}

// Reading the text anew for each of 3,000 segments would take minutes.
#[test]
fn a_material_of_many_segments_is_renamed_in_time() {
    const SEGMENTS: usize = 3000;
    let written = "\n[[pinion.segment]]\nlength_mm = 1.0\nouter_diameter_mm = 30.0\nmaterial = \"steel\"\n";
    let default = "\n[[pinion.segment]]\nlength_mm = 1.0\nouter_diameter_mm = 30.0\n";
    let text = format!("{}{}", SHIPPED[0].text, (written.to_owned() + default).repeat(SEGMENTS / 2));
    let mut editor = Editor::new(text.as_str()).unwrap();
    let started = std::time::Instant::now();
    editor.apply(&Edit::RenameMaterial { from: "steel".into(), to: "18CrNiMo7-6".into() }).unwrap();
    assert!(started.elapsed() < std::time::Duration::from_secs(20), "{:?}", started.elapsed());
    // the four segments of each shaft come with the shipped design
    assert_eq!(editor.text().matches("material = \"18CrNiMo7-6\"").count(), SEGMENTS + 8);
    editor.undo();
    assert_eq!(editor.text(), text);
}
