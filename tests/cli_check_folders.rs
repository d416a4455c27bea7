//! `bevelscope check DIR` is the overview without a screen: the same figures, and an exit status.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod tui_support;

use std::path::Path;
use std::process::{Command, Output};

use bevelscope::design::library::SHIPPED;
use bevelscope::tui::library::RowState;
use bevelscope::tui::overview::{Column, reason};
use serde_json::Value;
use tempfile::TempDir;
use tui_support::{Screen, Shelf, UNICODE};

fn check(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_bevelscope")).arg("check").args(arguments).output().unwrap()
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap()
}

const BROKEN: &str = "format = 1\nname = ";

/// A folder with these files.
fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (stem, text) in files {
        std::fs::write(folder.path().join(format!("{stem}.toml")), text).unwrap();
    }
    folder
}

fn shipped(stem: &str) -> &'static str {
    SHIPPED.iter().find(|shipped| shipped.file_name == format!("{stem}.toml")).unwrap().text
}

#[test]
fn the_overview_has_the_figures_of_check() {
    let mut files: Vec<(&str, &str)> =
        SHIPPED.iter().map(|shipped| (shipped.file_name.trim_end_matches(".toml"), shipped.text)).collect();
    files.push(("broken", BROKEN));
    let stems: Vec<&str> = files.iter().map(|(stem, _)| *stem).collect();
    let screen = Screen::with(&stems, 120, 40, UNICODE, Shelf::new(&files));
    let folder = folder(&files);
    let output = check(&[folder.path().to_str().unwrap(), "--format", "json"]);
    let checked = json(&output);
    let mut compared = 0;
    for row in screen.app.library.matching() {
        let stem = |file: &Value| Path::new(file.as_str().unwrap()).file_stem().unwrap().display().to_string();
        let printed = checked.as_array().unwrap().iter().find(|printed| stem(&printed["file"]) == row.stem).unwrap();
        if let RowState::Solved(_) = row.state {
            for (column, keys) in [
                (Column::EnhancedLimit, ["enhanced", "agreement_limit_hz"]),
                (Column::EnhancedRms, ["enhanced", "rms_db"]),
                (Column::BasicLimit, ["basic", "agreement_limit_hz"]),
                (Column::BasicRms, ["basic", "rms_db"]),
                (Column::PeakFrequency, ["fe_highest_peak", "frequency_hz"]),
                (Column::PeakForce, ["fe_highest_peak", "force_n"]),
            ] {
                // bit by bit: both come from the same lines
                assert_eq!(column.figure(row), printed[keys[0]][keys[1]].as_f64(), "{} {column:?}", row.stem);
                compared += 1;
            }
        } else {
            assert!(printed["error"].is_string() && reason(row).is_some(), "{printed}");
        }
    }
    assert_eq!((compared, checked.as_array().unwrap().len()), (6 * SHIPPED.len(), files.len()));
}

/// The highest point of the spectrum that `solve` writes which is higher than both of its neighbours.
#[test]
fn the_highest_peak_is_that_of_the_spectrum() {
    let folder = folder(&[("elastic", shipped("overhung-elastic"))]);
    let file = folder.path().join("elastic.toml").display().to_string();
    let solved =
        Command::new(env!("CARGO_BIN_EXE_bevelscope")).args(["solve", &file, "--format", "json"]).output().unwrap();
    let solved = json(&solved);
    let numbers = |value: &Value| value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect();
    let hz: Vec<f64> = numbers(&solved["frequency_hz"]);
    let force = &solved["models"]["fe"]["mesh_force_n"];
    let (re, im): (Vec<f64>, Vec<f64>) = (numbers(&force["re"]), numbers(&force["im"]));
    let force: Vec<f64> = re.iter().zip(&im).map(|(re, im)| re.hypot(*im)).collect();
    for band in [None, Some([100.0, 1000.0]), Some([1600.0, 1650.0])] {
        let [low, high] = band.unwrap_or([0.0, f64::INFINITY]);
        let inside: Vec<usize> = (0..hz.len()).filter(|&at| (low..=high).contains(&hz[at])).collect();
        let inner = &inside[1..inside.len() - 1];
        let is_peak = |at: &&usize| force[**at] > force[**at - 1] && force[**at] > force[**at + 1];
        let highest = inner.iter().filter(is_peak).max_by(|a, b| force[**a].total_cmp(&force[**b]));
        let band = band.map(|[low, high]| format!("{low}:{high}"));
        let arguments: Vec<&str> = [file.as_str(), "--format", "json"]
            .into_iter()
            .chain(band.iter().flat_map(|band| ["--band", band.as_str()]))
            .collect();
        let checked = json(&check(&arguments));
        let found = &checked[0]["fe_highest_peak"];
        match highest {
            Some(&at) => {
                assert_eq!(found["frequency_hz"].as_f64(), Some(hz[at]), "{band:?}");
                let relative = found["force_n"].as_f64().unwrap() / force[at] - 1.0;
                assert!(relative.abs() < 1e-9, "{relative}");
            }
            // a slope has none, and none is said of it
            None => assert!(found.is_null(), "{found}"),
        }
    }
}

/// elastic: 3.72 dB and 2,997 Hz; turbine: 13.35 dB and 8 Hz (README).
#[test]
fn the_exit_status_of_a_folder_is_that_of_its_worst_design() {
    let good = folder(&[("elastic", shipped("overhung-elastic")), ("rigid", shipped("overhung-rigid"))]);
    let poor = folder(&[("elastic", shipped("overhung-elastic")), ("turbine", shipped("turbine-generator"))]);
    let broken = folder(&[("broken", BROKEN)]);
    let mixed = folder(&[("elastic", shipped("overhung-elastic")), ("broken", BROKEN)]);
    let empty = folder(&[]);
    let limits = ["--max-rms-db", "4", "--min-limit-hz", "2000"];
    for (folder, without, with) in [(&good, 0, 0), (&poor, 0, 1), (&broken, 2, 2), (&mixed, 2, 2), (&empty, 2, 2)] {
        let path = folder.path().to_str().unwrap();
        for format in ["table", "json"] {
            let status = |limits: &[&str]| {
                let all: Vec<&str> = [path, "--format", format].iter().chain(limits).copied().collect();
                check(&all).status.code()
            };
            assert_eq!(status(&[]), Some(without), "{path} {format}");
            assert_eq!(status(&limits), Some(with), "{path} {format}");
            if without == 0 {
                // either limit alone, each just passed and just missed by the worst design
                assert_eq!(status(&["--max-rms-db", "14"]), Some(0));
                assert_eq!(status(&["--max-rms-db", "3"]), Some(1));
                assert_eq!(status(&["--min-limit-hz", "8"]), Some(0));
                assert_eq!(status(&["--min-limit-hz", "5000"]), Some(1));
            }
        }
    }
    // which one it is, in the table and in the rows
    let path = poor.path().to_str().unwrap();
    let table = check(&[path, limits[0], limits[1]]);
    let table = String::from_utf8(table.stdout).unwrap();
    let ends = |stem: &str, word: &str| table.lines().any(|line| line.starts_with(stem) && line.ends_with(word));
    assert!(ends("turbine", "NO") && ends("elastic", "yes"), "{table}");
    let rows = json(&check(&[path, limits[0], limits[1], "--format", "json"]));
    assert_eq!([&rows[0]["within_limits"], &rows[1]["within_limits"]], [&Value::Bool(true), &Value::Bool(false)]);
}
