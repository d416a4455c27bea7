//! Edits change the bytes of the value and no others.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use bevelscope::design::library::SHIPPED;
use bevelscope::design::{Document, EditError, KeyPath, read};
use toml_edit::Value;

fn path(text: &str) -> KeyPath {
    text.parse().unwrap()
}

/// The document after an edit; the value keeps the spelling given.
fn edited(text: &str, at: &str, value: &str) -> String {
    let mut document = Document::parse(text).unwrap();
    document.set(&path(at), value.parse::<Value>().unwrap()).unwrap();
    document.text().to_string()
}

/// Everything that printing a parsed document would change: a byte order mark, line ends, blanks, dotted keys apart.
const ODD: &str = "\u{feff}# top\r\n\r\nformat = 1   # one\r\na.x   =  1_000.50\t# x\r\nname='odd'\r\na.y = 0x1F\r\n\r\n\
    [[pinion.bearing]] # first\r\n  name = \"B1\"  # its name\r\n  kx_n_per_m = 6e8 # stiff\r\n[[pinion.bearing]]\r\n\
    kx_n_per_m = 5.0e+08 # second\r\n[gear]\r\nbearing = [ {kx_n_per_m=1}, # why\r\n  { name = \"rear one\", kx_n_per_m = 2 , },\r\n]";

#[test]
fn a_document_is_its_text() {
    for text in [ODD, "", SHIPPED[0].text] {
        assert_eq!(Document::parse(text).unwrap().text(), text);
    }
}

#[test]
fn an_edit_changes_the_value_and_no_other_byte() {
    for (at, old, new) in [
        ("pinion.bearing[B1].kx_n_per_m", "6e8 # stiff", "7.25e8 # stiff"),
        ("pinion.bearing[0].kx_n_per_m", "6e8 # stiff", "7.25e8 # stiff"),
        ("pinion.bearing[B2].kx_n_per_m", "5.0e+08 # second", "7.25e8 # second"),
        ("gear.bearing[B1].kx_n_per_m", "{kx_n_per_m=1}", "{kx_n_per_m=7.25e8}"),
        ("gear.bearing[rear one].kx_n_per_m", "kx_n_per_m = 2 ,", "kx_n_per_m = 7.25e8 ,"),
        ("a.x", "1_000.50\t#", "7.25e8\t#"),
        ("a.y", "0x1F", "7.25e8"),
    ] {
        assert_eq!(edited(ODD, at, "7.25e8"), ODD.replacen(old, new, 1), "{at}");
    }
}

#[test]
fn values_come_with_their_spelling() {
    let document = Document::parse(ODD).unwrap();
    assert_eq!(document.raw(&path("a.x")), Some("1_000.50"));
    let value = document.get(&path("a.x")).unwrap();
    assert_eq!((value.as_float(), value.to_string()), (Some(1000.5), "1_000.50".into()));
    assert_eq!(document.raw(&path("gear.bearing[0]")), Some("{kx_n_per_m=1}"));
    for nothing in
        ["a.z", "a", "pinion", "pinion.bearing", "pinion.bearing[0]", "pinion.bearing[2]", "gear.bearing[B2]"]
    {
        assert_eq!(document.raw(&path(nothing)), None, "{nothing}");
    }
}

#[test]
fn a_key_is_added_after_the_last_of_its_table() {
    for (text, at, expected) in [
        (
            "a = 1 # c\n\n[mesh]\n  x = 1 # c\n\n# about gear\n[gear]\n",
            "mesh.y",
            "a = 1 # c\n\n[mesh]\n  x = 1 # c\n  y = 9\n\n# about gear\n[gear]\n",
        ),
        ("a = 1 # c\n\n[gear]\n", "b", "a = 1 # c\nb = 9\n\n[gear]\n"),
        ("[mesh] # c\r\n\r\n[gear]", "mesh.y", "[mesh] # c\r\ny = 9\r\n\r\n[gear]"),
        ("[mesh]", "mesh.y", "[mesh]\ny = 9"),
        ("[mesh]\nx = [\n 1, # c\n] # d", "mesh.y", "[mesh]\nx = [\n 1, # c\n] # d\ny = 9"),
        ("[[p.s]]\na = 1\n[[p.s]]\na = 2\n", "p.s[0].b", "[[p.s]]\na = 1\nb = 9\n[[p.s]]\na = 2\n"),
        ("s = [{ a = 1 }, { }]\n", "s[0].b", "s = [{ a = 1, b = 9 }, { }]\n"),
        ("s = [{ a = 1 }, { }]\n", "s[1].b", "s = [{ a = 1 }, { b = 9 }]\n"),
        ("a = 1\n", "analysis.b", "a = 1\n\n[analysis]\nb = 9\n"),
        ("[[p.s]]\na = 1\n", "p.b", "[[p.s]]\na = 1\n\n[p]\nb = 9\n"),
        ("[m.steel]\na = 1\n", "m.\"Ti 6\".b", "[m.steel]\na = 1\n\n[m.\"Ti 6\"]\nb = 9\n"),
        ("", "a", "a = 9\n"),
        ("# c\n[m]\nx = 1", "a", "a = 9\n\n# c\n[m]\nx = 1"),
        // dotted keys stay among dotted keys
        ("a.x = 1 # c\nb = 2\n", "a.y", "a.x = 1 # c\na.y = 9\nb = 2\n"),
        ("[p]\n  a . \"b c\".x = 1\n", "p.a.\"b c\".y", "[p]\n  a . \"b c\".x = 1\n  a . \"b c\".y = 9\n"),
        ("a.x = 1\n", "a.q.y", "a.x = 1\na.q.y = 9\n"),
        // a table is written like the one around it
        ("a = { x = 1 }", "a.q.y", "a = { x = 1, q = { y = 9 } }"),
        ("[a.b]\nx = 1\n", "a.q.y", "[a.b]\nx = 1\n\n[a.q]\ny = 9\n"),
        ("[[p.s]]\nx = 1\n[[p.s]]\n", "p.s[0].q.y", "[[p.s]]\nx = 1\nq = { y = 9 }\n[[p.s]]\n"),
        ("b = 1\n", "material.\"Ti 6\".x", "b = 1\n\n[material.\"Ti 6\"]\nx = 9\n"),
        // in the order of the schema
        ("[[gear.body]] # c\n  mass_kg = 1\n", "gear.body[0].name", "[[gear.body]] # c\n  name = 9\n  mass_kg = 1\n"),
        ("gear = { body = [{ mass_kg = 1 }] }", "gear.body[0].name", "gear = { body = [{ name = 9, mass_kg = 1 }] }"),
        ("format = 1\n", "name", "format = 1\nname = 9\n"),
        (
            "format = 1\nname = \"n\"\ntags = []\n",
            "description",
            "format = 1\nname = \"n\"\ndescription = 9\ntags = []\n",
        ),
        (
            "format = 1 # c\n\n# about the mesh\n[mesh]\nx = 1\n",
            "analysis.beam_theory",
            "format = 1 # c\n\n[analysis]\nbeam_theory = 9\n\n# about the mesh\n[mesh]\nx = 1\n",
        ),
        ("format = 1\n[mesh]\n[gear]\n", "pinion.teeth", "format = 1\n[mesh]\n[pinion]\nteeth = 9\n[gear]\n"),
    ] {
        assert_eq!(edited(text, at, "9"), expected, "{at} in {text:?}");
    }
}

#[test]
fn what_cannot_be_edited_leaves_the_text_alone() {
    let mut document = Document::parse(ODD).unwrap();
    for at in ["pinion", "pinion.bearing[0]", "pinion.bearing", "a", "gear.bearing[7].x", "gear.bearing[7]", "name.x"] {
        let error = document.set(&path(at), 1).expect_err(at);
        assert_eq!(matches!(error, EditError::NotThere(_)), at.contains("[7]"), "{at}: {error}");
        assert!(!matches!(error, EditError::Syntax(_)), "{at}: {error}");
        assert_eq!(document.text(), ODD, "{at}");
    }
    assert!(matches!(Document::parse("a = "), Err(EditError::Syntax(_))));
}

#[test]
fn text_is_written_so_that_it_is_read_back() {
    for text in ["", "a\"b\\c", "two\nlines", "\u{1b}[2J", "it's", "\u{202e}"] {
        let mut document = Document::parse("name = 'x' # c\n").unwrap();
        document.set(&path("name"), text).unwrap();
        assert_eq!(document.get(&path("name")).unwrap().as_str(), Some(text));
        assert!(document.text().ends_with(" # c\n"));
    }
}

#[test]
fn a_number_is_edited_alone_and_keeps_its_comment() {
    let text = SHIPPED[0].text;
    let before = read(text).design.unwrap();
    let mut document = Document::parse(text).unwrap();
    document.set(&path("pinion.bearing[tail bearing].axial_series_stiffness_n_per_m"), 1e9).unwrap();
    let changed: Vec<_> = text.lines().zip(document.text().lines()).filter(|(old, new)| old != new).collect();
    assert_eq!(changed.len(), 1);
    assert!(changed[0].1.ends_with("  # nut and spacer that the thrust passes through"), "{}", changed[0].1);
    let after = read(document.text()).design.unwrap();
    let mut expected = before;
    expected.pinion.bearings[1].axial_series_stiffness = Some(1e9);
    assert_eq!(after, expected);
}
