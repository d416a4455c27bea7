//! `mesh-stiffness`, `import-mesh`, and what `inspect` says of bearings and teeth, from outside.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::path::Path;
use std::process::{Command, Output};

use bevelscope::design::{Edit, Editor, KeyPath, Spelled, read};
use bevelscope::gear::COLUMNS;
use serde_json::Value;

fn bevelscope(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_bevelscope")).args(arguments).output().unwrap()
}

fn design(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("designs").join(format!("{name}.toml")).display().to_string()
}

fn json(arguments: &[&str]) -> Value {
    let output = bevelscope(arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

// Sample 1 of ISO 23509: 6.4e8 N/m.
#[test]
fn the_estimate_says_that_it_is_one() {
    let output = bevelscope(&["mesh-stiffness", "--face-width-mm", "21.59", "--spiral-angle-deg", "35"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.starts_with("stiffness_n_per_m = 6.435e8") && text.contains("estimate: ISO 10300-1"), "{text}");
    let refused = bevelscope(&["mesh-stiffness", "--face-width-mm", "0"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("face width must be greater than 0"));
}

#[test]
fn a_flank_of_a_table_goes_into_a_design() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let coast = "coast,5.1e8,4,0,0,27.46,-0.76975,0.39173,0.50401,0,0,76.49,0.76975,0.50401,0.39173";
    let drive = "drive,6e8,3,0,0.1,27.46,0.76975,-0.62285,0.1398,0,0,76.49,-0.76975,0.1398,-0.62285";
    std::fs::write(path("mesh.csv"), format!("{}\n{drive}\n{coast}\n", COLUMNS.join(","))).unwrap();
    let source = design("tapered-axle");
    let import = |flank: &str, out: &str| {
        bevelscope(&["import-mesh", &path("mesh.csv"), &source, "--flank", flank, "-o", &path(out)])
    };
    let output = import("coast", "out.toml");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = std::fs::read_to_string(path("out.toml")).unwrap();
    let read_back = read(&text).design.unwrap();
    assert_eq!((read_back.mesh.stiffness, read_back.mesh.transmission_error), (5.1e8, 4e-6));
    assert_eq!((read_back.mesh.geometry, read_back.mesh.gear.point), (None, [0.0, 0.0, 76.49 / 1e3]));
    // every other line is as it was
    let old = std::fs::read_to_string(&source).unwrap();
    let own = |line: &&str| !line.starts_with("stiffness_n_per_m") && !line.starts_with("transmission_error_um");
    let bearings = old.find("# Tapered rollers").unwrap();
    assert!(old[bearings..].lines().filter(own).all(|line| text.contains(line)), "{text}");
    // a file that is there stays
    let again = import("drive", "out.toml");
    assert_eq!(again.status.code(), Some(2));
    assert_eq!(std::fs::read_to_string(path("out.toml")).unwrap(), text);
    std::fs::write(path("mesh.csv"), format!("{}\n{}\n", COLUMNS.join(","), drive.replace("27.46", "x\u{1b}[2J")))
        .unwrap();
    let wrong = import("drive", "other.toml");
    let message = String::from_utf8_lossy(&wrong.stderr).into_owned();
    assert_eq!(wrong.status.code(), Some(2));
    assert!(
        message.contains("mesh.csv: line 2: pinion_point_z_mm must be a number") && !message.contains('\u{1b}'),
        "{message}"
    );
    std::fs::write(path("mesh.csv"), format!("{}\n{drive}\n", COLUMNS.join(","))).unwrap();
    let missing = import("coast", "other.toml");
    assert!(String::from_utf8_lossy(&missing.stderr).contains("no line for the flank coast"));
    assert!(!Path::new(&path("other.toml")).exists());
}

#[test]
fn inspect_shows_bearings_and_forces() {
    let value = json(&["inspect", &design("tapered-axle"), "--format", "json"]);
    let mesh = &value["mesh"];
    // ISO/TR 10300-30: 14193.3 N, 1200 rpm on 14 teeth
    assert!((number(&mesh["normal_force_n"]) / 14193.3 - 1.0).abs() < 1e-4);
    assert!((number(&mesh["mesh_frequency_hz"]) - 280.0).abs() < 1e-9);
    assert!((number(&mesh["shaft_angle_deg"]) - 90.0).abs() < 1e-9 && number(&mesh["offset_mm"]).abs() < 1e-9);
    let force = |side: &str, key: &str| number(&mesh[side]["force"][key]);
    assert!((force("pinion", "axial_n") / 10925.3 - 0.80915).abs() < 1e-4);
    assert!((force("pinion", "axial_n") - force("gear", "radial_n")).abs() < 1.0);
    let mut thrust = 0.0;
    for bearing in value["pinion"]["bearings"].as_array().unwrap() {
        let state = &bearing["mean_state"];
        thrust += number(&state["load"]["y_n"]);
        let loads = state["element_loads_n"].as_array().unwrap();
        let loaded = loads.iter().filter(|load| number(load) > 0.0).count() as u64;
        assert_eq!(state["loaded_elements"], loaded);
        assert_eq!(state["elements"], loads.len());
        assert!(number(&bearing["stiffness"][1][1]) > 1e7);
    }
    assert!((thrust / force("pinion", "axial_n") - 1.0).abs() < 1e-9, "the bearings take the thrust");
    assert!(number(&mesh["torque_arm_deviation_percent"]).abs() < 0.02);
    assert!((number(&mesh["tooth_ratio"]) - 39.0 / 14.0).abs() < 1e-12 && mesh["at_1_n_m"].is_null());
    assert!(mesh["thrust"].as_str().unwrap().starts_with("thrust pushes the pinion out of mesh"));
    // without a torque the forces are those under 1 N m
    let value = json(&["inspect", &design("overhung-elastic"), "--format", "json"]);
    assert!(value["mesh"]["normal_force_n"].is_null() && value["mesh"]["pinion"]["force"].is_null());
    let unit = &value["mesh"]["at_1_n_m"];
    let arm = number(&value["mesh"]["pinion"]["torque_arm_mm"]) / 1e3;
    assert!((number(&unit["normal_force_n"]) * arm - 1.0).abs() < 1e-12);
    let text = String::from_utf8(bevelscope(&["inspect", &design("overhung-elastic")]).stdout).unwrap();
    assert!(text.contains("N under 1 N m;") && text.contains("teeth 2.7857 to 1"), "{text}");
}

/// Parallel axes have a centre distance and no offset; a series spring is named where there is one.
#[test]
fn inspect_names_the_centre_distance_and_only_springs_that_are_there() {
    let text = |name: &str| {
        let path = design(name);
        let source = std::fs::read_to_string(&path).unwrap();
        let output = bevelscope(&["inspect", &path]);
        (source, String::from_utf8(output.stdout).unwrap())
    };
    let (_, helical) = text("turbine-generator");
    assert!(helical.contains("deg, centre distance 589.11 mm") && !helical.contains("offset"), "{helical}");
    let (_, hypoid) = text("tapered-hypoid");
    assert!(hypoid.contains("deg, offset ") && !hypoid.contains("centre distance"), "{hypoid}");
    for name in ["overhung-elastic", "straddle-elastic", "tapered-axle", "turbine-generator"] {
        let (source, found) = text(name);
        let written = |key: &str| source.lines().any(|line| line.trim_start().starts_with(key));
        assert_eq!(found.contains("with Kc"), written("axial_series_stiffness_n_per_m"), "{name}: {found}");
        assert_eq!(found.contains("before Khb"), written("housing_axial_stiffness_n_per_m"), "{name}: {found}");
    }
}

#[test]
fn without_drives_there_are_twelve_lumped_coordinates() {
    let path = design("turbine-generator");
    assert_eq!(json(&["inspect", &path, "--format", "json"])["coordinates"]["lumped"], 12);
    let modes = json(&["modes", &path, "--format", "json"]);
    for model in ["fe", "enhanced", "basic"] {
        let modes = modes["models"][model].as_array().unwrap();
        assert_eq!(number(&modes[0]["frequency_hz"]), 0.0, "{model}");
        assert!(number(&modes[1]["frequency_hz"]) > 0.1, "{model}");
        assert!(
            (number(&modes[0]["energy_share"]["pinion"]["torsion"])
                + number(&modes[0]["energy_share"]["gear"]["torsion"])
                - 1.0)
                .abs()
                < 1e-9
        );
    }
    // one drive: thirteen
    let mut editor = Editor::new(std::fs::read_to_string(design("overhung-elastic")).unwrap()).unwrap();
    editor.apply(&Edit::Remove { path: "gear.drive".parse::<KeyPath>().unwrap() }).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("one.toml").display().to_string();
    std::fs::write(&file, editor.text()).unwrap();
    assert_eq!(json(&["inspect", &file, "--format", "json"])["coordinates"]["lumped"], 13);
    assert!(
        !json(&["solve", &file, "--format", "json"])["models"]["fe"]["mesh_force_n"]["re"]
            .as_array()
            .unwrap()
            .is_empty()
    );
}

#[test]
fn switching_a_bearing_to_balls_or_rollers_gives_a_valid_design() {
    let text = std::fs::read_to_string(design("overhung-elastic")).unwrap();
    for models in [["ball", "roller"], ["roller", "ball"]] {
        let mut editor = Editor::new(text.as_str()).unwrap();
        for model in models {
            let bearing: KeyPath = "pinion.bearing[0]".parse().unwrap();
            editor.apply(&Edit::SetModel { bearing: bearing.clone(), model: model.into() }).unwrap();
            let reading = editor.reading();
            // as many balls as there were rollers may not fit, which is a warning
            assert_eq!(reading.errors().next(), None, "{model}: {}", editor.text());
            assert_eq!(reading.design.as_ref().unwrap().pinion.bearings[0].model.word(), model);
            let set = Edit::Set { path: bearing.key("preload").key("x_n"), value: Spelled::parse("150.0").unwrap() };
            editor.apply(&set).unwrap();
            assert!(editor.reading().design.is_some(), "{}", editor.text());
            editor.undo();
        }
        while editor.undo().is_some() {}
        assert_eq!(editor.text(), text);
    }
}

/// A ball bearing with one shoulder that is loaded the wrong way; whoever solves the design is told.
#[test]
fn what_is_unusual_about_a_mean_state_is_a_warning_wherever_a_design_is_solved() {
    const WARNING: &str = "bearing[0]: \"head bearing\" in its mean state: 12 balls bear on the opposite shoulder, which a bearing with one shoulder";
    let mut editor = Editor::new(std::fs::read_to_string(design("overhung-elastic")).unwrap()).unwrap();
    let bearing: KeyPath = "pinion.bearing[0]".parse().unwrap();
    editor.apply(&Edit::SetModel { bearing: bearing.clone(), model: "ball".into() }).unwrap();
    for (key, value) in [("elements", "12"), ("contact_angle_deg", "-40.0")] {
        editor.apply(&Edit::Set { path: bearing.key(key), value: Spelled::parse(value).unwrap() }).unwrap();
    }
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("wrong.toml").display().to_string();
    std::fs::write(&file, editor.text()).unwrap();
    for command in [
        ["solve", &file].as_slice(),
        &["modes", &file],
        &["bands", &file],
        &["report", &file, "-o", "-"],
        &["compare", &file, &file],
    ] {
        let output = bevelscope(command);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success() && text.contains(WARNING), "{command:?}: {text}");
        if command[0] == "report" {
            let page = String::from_utf8_lossy(&output.stdout).into_owned();
            assert!(page.contains("12 balls bear on the opposite shoulder") && !page.contains("raises no warning"));
            assert!(!page.contains(&folder.path().display().to_string()), "the page names no folder");
        }
    }
    let output = bevelscope(&["check", &file]);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success() && text.contains("wrong !") && text.contains(WARNING), "{text}");
}

/// Ten of the 21 rollers of the axle's loaded gear bearing face away from the load, which is as it should be.
#[test]
fn unloaded_elements_are_a_note_of_inspect_and_no_warning() {
    for command in ["solve", "modes", "bands"] {
        let output = bevelscope(&[command, "designs/tapered-axle.toml"]);
        assert!(output.status.success() && output.stderr.is_empty(), "{command}");
    }
    let text = String::from_utf8(bevelscope(&["check", "designs/tapered-axle.toml"]).stdout).unwrap();
    assert!(text.contains("\ntapered-axle  ") && !text.contains("warning"), "{text}");
    let text = String::from_utf8(bevelscope(&["inspect", "designs/tapered-axle.toml"]).stdout).unwrap();
    assert!(text.contains("\n  note: 10 of 21 rolling elements carry no load\n"), "{text}");
    let value = json(&["inspect", "designs/tapered-axle.toml", "--format", "json"]);
    let state = &value["gear"]["bearings"][0]["mean_state"];
    assert_eq!(state["note"], "10 of 21 rolling elements carry no load");
    assert_eq!(state["warnings"], serde_json::json!([]));
}

/// The elements that are listed are the bearing's load: their forces add up to it, and they stand in the table one by one.
#[test]
fn the_elements_of_a_bearing_add_up_to_its_load() {
    for name in ["tapered-axle", "tapered-hypoid"] {
        let value = json(&["inspect", &design(name), "--format", "json"]);
        let table = String::from_utf8(bevelscope(&["inspect", &design(name)]).stdout).unwrap();
        for state in ["pinion", "gear"].iter().flat_map(|side| value[side]["bearings"].as_array().unwrap()) {
            let state = &state["mean_state"];
            let list = |key: &str| state[key].as_array().unwrap().iter().map(number).collect::<Vec<f64>>();
            let (loads, angles) = (list("element_loads_n"), list("element_contact_angles_deg"));
            let mut sum = [0.0_f64; 3];
            for ((load, position), angle) in loads.iter().zip(list("element_positions_deg")).zip(&angles) {
                let (position, angle) = (position.to_radians(), angle.to_radians());
                let radial = load * angle.cos();
                sum = [sum[0] + radial * position.sin(), sum[1] + load * angle.sin(), sum[2] + radial * position.cos()];
            }
            let load = ["x_n", "y_n", "z_n"].map(|key| number(&state["load"][key]));
            let size = load.iter().map(|load| load.abs()).fold(0.0, f64::max);
            for (sum, load) in sum.iter().zip(load) {
                assert!((sum - load).abs() <= 1e-9 * size, "{name}: {sum} {load}");
            }
            let greatest = loads.iter().copied().fold(0.0, f64::max);
            assert!(table.contains(&bevelscope::number::significant(greatest, 4)), "{name}: {greatest}");
        }
    }
}
