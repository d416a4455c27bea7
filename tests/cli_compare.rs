//! `bevelscope compare`: what differs between two designs, and how both behave.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;
use tempfile::TempDir;

const PROGRAM: &str = env!("CARGO_BIN_EXE_bevelscope");

fn design(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("designs").join(format!("{name}.toml")).display().to_string()
}

fn compare(arguments: &[&str]) -> Output {
    Command::new(PROGRAM).arg("compare").args(arguments).stdin(Stdio::null()).output().unwrap()
}

fn json(arguments: &[&str]) -> Value {
    let arguments: Vec<&str> = arguments.iter().copied().chain(["--format", "json"]).collect();
    let output = compare(&arguments);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The shipped design with some of its text replaced.
fn edited(edits: &[(&str, &str)]) -> (TempDir, PathBuf) {
    let mut text = std::fs::read_to_string(design("overhung-elastic")).unwrap();
    for (from, to) in edits {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("edited.toml");
    std::fs::write(&path, text).unwrap();
    (folder, path)
}

#[test]
fn a_design_does_not_differ_from_itself() {
    let file = design("overhung-elastic");
    let output = compare(&[&file, &file]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert!(text.contains("no value differs") && text.contains("0.00 dB RMS apart"), "{text}");
    let json = json(&[&file, &file]);
    assert_eq!((json["differences"].as_array().unwrap().len(), json["fe_rms_db"].as_f64()), (0, Some(0.0)));
    assert_eq!(json["a"]["enhanced"], json["b"]["enhanced"]);
}

#[test]
fn differing_values_come_by_key_path_as_they_are_spelled() {
    // a comment and another spelling of the same number are no difference
    let (_folder, path) = edited(&[
        ("stiffness_n_per_m = 6.4e8", "stiffness_n_per_m = 6.40E+8 # the same"),
        ("kx_n_per_m = 6.0e8", "kx_n_per_m = 7.5e8"),
    ]);
    let path = path.to_str().unwrap();
    let json = json(&[&design("overhung-elastic"), path]);
    let differences = json["differences"].as_array().unwrap();
    assert_eq!(differences.len(), 1, "{differences:?}");
    let difference = &differences[0];
    let key = difference["key"].as_str().unwrap();
    assert!(key.starts_with("pinion.bearing[") && key.ends_with("].kx_n_per_m"), "{key}");
    assert_eq!(
        (&difference["a"], &difference["b"], &difference["unit"]),
        (&6.0e8.into(), &7.5e8.into(), &"N/m".into())
    );
    assert_eq!((&difference["a_text"], &difference["b_text"]), (&"6.0e8".into(), &"7.5e8".into()));
    assert!(json["fe_rms_db"].as_f64().unwrap() > 0.0);
    assert_eq!(json["b"]["file"].as_str(), Some(path));
    let output = compare(&[&design("overhung-elastic"), path]);
    let text = String::from_utf8(output.stdout).unwrap();
    let line = text.lines().find(|line| line.contains("kx_n_per_m")).unwrap();
    assert!(line.contains(key) && line.ends_with("6.0e8  7.5e8  N/m"), "{line}");
}

#[test]
fn spectra_on_different_lines_are_not_subtracted() {
    let (_folder, path) = edited(&[("frequency_lines = 1000", "frequency_lines = 500")]);
    let json = json(&[&design("overhung-elastic"), path.to_str().unwrap()]);
    assert_eq!(json["fe_rms_db"], Value::Null);
}

// A terminal's lines are cut; what goes elsewhere is whole.
#[test]
fn what_is_piped_is_not_cut() {
    let long = format!("name = \"{} and its end\"", "long ".repeat(40).trim_end());
    let (_folder, path) = edited(&[("name = \"Both overhung, elastic bearings\"", &long)]);
    let output = compare(&[&design("overhung-elastic"), path.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0));
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(text.matches("long and its end").count(), 2, "{text}");
    for head in ["key", "limit Hz", "dB", "FRAC", "basic"] {
        assert!(text.contains(head), "{head}: {text}");
    }
}

#[test]
fn rows_come_and_go_as_wholes() {
    let text = std::fs::read_to_string(design("overhung-elastic")).unwrap();
    let first = text.find("[[pinion.segment]]").unwrap();
    let (_folder, path) = edited(&[]);
    let row = "[[pinion.segment]]\nlength_mm = 1.0\nouter_diameter_mm = 40.0\n\n";
    std::fs::write(&path, format!("{}{row}{}", &text[..first], &text[first..])).unwrap();
    let path = path.to_str().unwrap();
    for (files, change) in
        [([&*design("overhung-elastic"), path], "added"), ([path, &design("overhung-elastic")], "removed")]
    {
        let text = String::from_utf8(compare(&files).stdout).unwrap();
        let rows: Vec<&str> = text.lines().filter(|line| line.contains("pinion.segment")).collect();
        assert!(rows.len() == 1 && rows[0].contains("pinion.segment[0]") && rows[0].ends_with(change), "{text}");
    }
}

#[test]
fn one_of_the_two_may_be_standard_input() {
    let file = design("overhung-elastic");
    let mut child = Command::new(PROGRAM)
        .args(["compare", "-", &file, "--format", "json"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(&std::fs::read(&file).unwrap()).unwrap();
    let output = child.wait_with_output().unwrap();
    let json: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(json["a"]["design"], json["b"]["design"]);
}

#[test]
fn bad_input_is_refused() {
    let file = design("overhung-elastic");
    let (_broken_folder, broken) = edited(&[("teeth = 14", "teth = 14")]);
    let (_loose_folder, loose) = edited(&[("ky_n_per_m = 2.2e8", "ky_n_per_m = 0"); 2]);
    for (arguments, words) in [
        (vec![file.as_str()], "required"),
        (vec![&file, "no-such.toml"], "there is no such file"),
        (vec![&file, broken.to_str().unwrap()], "pinion.teth"),
        (vec![&file, loose.to_str().unwrap()], "nothing holds it"),
        (vec!["-", "-"], "not both"),
        (vec![&file, &file, "--format", "csv"], "csv"),
    ] {
        let output = compare(&arguments);
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {stderr}");
        assert!(output.stdout.is_empty() && stderr.contains(words), "{arguments:?}: {stderr}");
    }
}

#[test]
fn escape_sequences_are_shown_harmlessly() {
    let (_folder, path) = edited(&[
        ("name = \"Both overhung, elastic bearings\"", r#"name = "evil \u001b[31m\u001b]0;title\u0007 \u202e""#),
        ("name = \"B1\"", r#"name = "B\u001b[2J1""#),
    ]);
    for format in ["table", "json"] {
        let output = compare(&[&design("overhung-elastic"), path.to_str().unwrap(), "--format", format]);
        assert_eq!(output.status.code(), Some(0));
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(!text.contains(|c: char| c != '\n' && bevelscope::text::is_unprintable(c)), "{text:?}");
        assert!(text.contains("evil"), "{text}");
    }
}

#[test]
fn a_text_that_looks_like_a_number_stays_a_text_in_json() {
    let (_folder, path) =
        edited(&[("name = \"Both overhung, elastic bearings\"", "name = \"12\""), ("elements = 2", "elements = 0x3")]);
    let json = json(&[&design("overhung-elastic"), path.to_str().unwrap()]);
    let by_key = |key: &str| {
        let all = json["differences"].as_array().unwrap();
        all.iter().find(|difference| difference["key"].as_str().unwrap().ends_with(key)).unwrap().clone()
    };
    let name = by_key("name");
    assert_eq!((&name["b"], &name["b_text"]), (&"12".into(), &"12".into()));
    let elements = by_key("elements");
    assert_eq!((elements["a"].as_f64(), elements["b"].as_f64()), (Some(2.0), Some(3.0)));
    assert_eq!(elements["b_text"], "0x3");
}
