//! `bevelscope new` from outside.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::process::{Command, Output};

use serde_json::Value;

fn bevelscope(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_bevelscope")).args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn the_file_is_made_checked_and_never_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("first.toml").display().to_string();
    let made = bevelscope(&["new", &path, "--kind", "hypoid", "--offset-mm", "20", "--name", "Mine \"first\""]);
    assert!(made.status.success(), "{}", text(&made.stderr));
    assert_eq!(text(&made.stdout), format!("{path}\n"));
    let written = std::fs::read_to_string(&path).unwrap();
    let checked = bevelscope(&["check", &path]);
    assert_eq!((checked.status.code(), text(&checked.stderr).as_str()), (Some(0), ""));
    let inspected: Value = serde_json::from_slice(&bevelscope(&["inspect", &path, "--format", "json"]).stdout).unwrap();
    assert_eq!(inspected["design"], "Mine \"first\"");
    let mesh = &inspected["mesh"];
    for (key, expected) in [("offset_mm", 20.0), ("shaft_angle_deg", 90.0)] {
        let value = mesh[key].as_f64().unwrap_or_else(|| panic!("{mesh}"));
        assert!((value - expected).abs() < 1e-6, "{key}: {value}");
    }
    let again = bevelscope(&["new", &path]);
    assert_eq!(again.status.code(), Some(2));
    assert!(text(&again.stderr).contains("there is a file of that name already"), "{}", text(&again.stderr));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), written);
}

#[test]
fn without_a_file_the_design_is_on_standard_output() {
    let plain = bevelscope(&["new"]);
    assert!(plain.status.success());
    let design = bevelscope::design::read(&text(&plain.stdout)).design.unwrap();
    assert_eq!((design.name.as_str(), design.pinion.teeth), ("Spiral bevel pair 14/39", Some(14)));
    assert_eq!(bevelscope(&["new", "-"]).stdout, plain.stdout);
    let sources =
        ["ISO 10300-1", "ISO 23509", "ISO 355", "designer's choice", "no maker", "rules of thumb", "estimate: "];
    let unwrapped = text(&plain.stdout).replace("\n# ", " ");
    for source in sources {
        assert!(unwrapped.contains(source), "{source}");
    }
}

#[test]
fn every_option_is_taken_with_its_unit() {
    let made = bevelscope(&[
        "new",
        "--kind",
        "helical",
        "--pinion-teeth",
        "21",
        "--gear-teeth",
        "64",
        "--pinion-torque-n-m",
        "120",
        "--pinion-speed-rpm",
        "1800",
        "--normal-module-mm",
        "3",
        "--face-width-mm",
        "28",
        "--spiral-angle-deg",
        "22",
        "--pressure-angle-deg",
        "21",
        "--hand",
        "left",
        "--pinion-mounting",
        "overhung",
        "--gear-mounting",
        "straddle",
        "--pinion-b1",
        "tapered-35",
        "--pinion-b2",
        "tapered-35",
        "--gear-b1",
        "deep-groove-50",
        "--gear-b2",
        "deep-groove-50",
    ]);
    assert!(made.status.success(), "{}", text(&made.stderr));
    let design = bevelscope::design::read(&text(&made.stdout)).design.unwrap();
    let geometry = design.mesh.geometry.unwrap();
    let diameter = geometry.pinion_pitch_diameter.unwrap() * 1e3;
    assert!((diameter - 63.0 / f64::to_radians(22.0).cos()).abs() < 1e-9, "{diameter}");
    let asked = text(&made.stdout).matches("asked for").count();
    assert!(asked >= 14, "{asked} numbers say that they were asked for");
    let hypoid = ["new", "--kind", "hypoid", "--gear-outer-diameter-mm", "170", "--cutter-radius-mm", "63.5"];
    assert!(bevelscope(&hypoid).status.success());
}

#[test]
fn bad_input_says_which_option_and_makes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bad.toml").display().to_string();
    for (arguments, expected) in [
        (&["--pinion-teeth", "3"][..], "error: --pinion-teeth: a whole number from 5 to 100 is wanted"),
        (&["--gear-teeth", "200", "--pinion-teeth", "12"], "error: --gear-teeth: at most 120"),
        (&["--face-width-mm", "NaN"], "error: --face-width-mm: "),
        (&["--kind", "spur", "--offset-mm", "5"], "error: --offset-mm: a spur pair has none"),
        (&["--pinion-torque-n-m", "14000"], "error: --pinion-torque-n-m: "),
        (&["--gear-b2", "6208"], "error: --gear-b2: `6208` is no bearing of the list"),
        (&["--name", " "], "error: --name: "),
        (&["--kind", "worm"], "invalid value 'worm'"),
        (&["--format", "json"], "--list-bearings"),
    ] {
        let all: Vec<&str> = ["new", &path].into_iter().chain(arguments.iter().copied()).collect();
        let output = bevelscope(&all);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(text(&output.stderr).contains(expected), "{arguments:?}: {}", text(&output.stderr));
        assert!(output.stdout.is_empty() && std::fs::read_dir(folder.path()).unwrap().next().is_none());
    }
}

#[test]
fn the_list_of_bearings_says_what_they_are() {
    let table = text(&bevelscope(&["new", "--list-bearings"]).stdout);
    for said in ["typical bearings, of no maker", "tapered-35", "deep-groove-100", "ISO 355", "ISO 15"] {
        assert!(table.contains(said), "{said}: {table}");
    }
    assert!(table.lines().all(|line| line.chars().count() <= 80), "{table}");
    let listed: Value =
        serde_json::from_slice(&bevelscope(&["new", "--list-bearings", "--format", "json"]).stdout).unwrap();
    let bearings = listed.as_array().unwrap();
    assert_eq!(bearings.len(), 30);
    for bearing in bearings {
        assert!(bearing["source"].as_str().unwrap().contains("typical inner sizes"), "{bearing}");
        assert!(bearing["bore_mm"].as_f64().unwrap() < bearing["outside_diameter_mm"].as_f64().unwrap());
    }
}
