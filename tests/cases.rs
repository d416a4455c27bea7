//! Four whole designs through the command line, against an independent dense solver of the same formulation.
//!
//! `tests/fixtures/cases/NAME.expected.json` holds what that solver gave: direct complex solves a line, dense eigensolves, its own
//! Initial Parameter Method. Three are the configurations of Hua, Lim, Peng and Wali (2012) on the gear pair of ISO 23509:2016
//! sample 1; `mixed` is what those leave out: Timoshenko, hollow steps, two materials, a coupled bearing matrix, Kc and Khb, viscous
//! damping, logarithmic lines.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use bevelscope::commands::{Cli, Status};
use bevelscope::comparison::solve;
use bevelscope::model::{ModelKind, Rotors};
use clap::Parser;
use serde_json::Value;

const CASES: [&str; 4] = ["overhung-rigid", "overhung-elastic", "straddle-elastic", "mixed"];
const MODELS: [&str; 3] = ["fe", "enhanced", "basic"];

fn fixture(name: &str) -> String {
    format!("{}/tests/fixtures/cases/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn expected(case: &str) -> Value {
    let text = std::fs::read_to_string(fixture(&format!("{case}.expected.json"))).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn run(command: &str, case: &str) -> Value {
    let file = fixture(&format!("{case}.toml"));
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let cli = Cli::try_parse_from(["bevelscope", command, &file, "--format", "json"]).unwrap();
    assert_eq!(cli.run(&mut out, &mut err).unwrap(), Status::Success);
    // only `mixed` has a mesh point off the tooth ratio
    let warnings = String::from_utf8(err).unwrap();
    assert_eq!(warnings.is_empty(), case != "mixed" || command == "check", "{case}: {warnings}");
    serde_json::from_slice(&out).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("no number: {value}"))
}

fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    let error = (found - expected).abs() / expected.abs().max(f64::MIN_POSITIVE);
    assert!(error <= tolerance, "{what}: {found} instead of {expected}, off by {error:e}");
}

#[test]
fn spectra_agree_with_direct_solves() {
    // required 1e-6 of the largest magnitude; 1.5e-11 seen
    const TOLERANCE: f64 = 1e-9;
    for case in CASES {
        let (found, expected) = (run("solve", case), expected(case));
        assert_eq!(found["design"], expected["design"]);
        let lines = numbers(&expected["frequency_hz"]);
        for (line, expected) in numbers(&found["frequency_hz"]).iter().zip(&lines) {
            close(*line, *expected, 1e-12, case);
        }
        for model in MODELS {
            let (found, expected) = (&found["models"][model], &expected["models"][model]);
            assert_eq!(found["coordinates"], expected["coordinates"], "{case} {model}");
            for quantity in ["mesh_force_n", "transmission_error_m"] {
                let parts = |value: &Value| (numbers(&value[quantity]["re"]), numbers(&value[quantity]["im"]));
                let ((re, im), (expected_re, expected_im)) = (parts(found), parts(expected));
                assert_eq!((re.len(), im.len()), (lines.len(), lines.len()));
                let largest = expected_re.iter().zip(&expected_im).map(|(re, im)| re.hypot(*im)).fold(0.0, f64::max);
                let worst = (0..lines.len())
                    .map(|i| (re[i] - expected_re[i]).hypot(im[i] - expected_im[i]) / largest)
                    .fold(0.0, f64::max);
                assert!(worst <= TOLERANCE, "{case} {model} {quantity}: {worst:e} of the largest magnitude");
            }
        }
    }
}

#[test]
fn natural_frequencies_agree() {
    // required 1e-6; 6.3e-10 seen, in the highest of the twenty modes
    const TOLERANCE: f64 = 1e-8;
    for case in CASES {
        let (found, expected) = (run("modes", case), expected(case));
        for model in MODELS {
            let found = found["models"][model].as_array().unwrap();
            let expected = numbers(&expected["modes"][model]);
            assert!(found.len() >= expected.len(), "{case} {model}");
            for (i, (mode, expected)) in found.iter().zip(&expected).enumerate() {
                let frequency = number(&mode["frequency_hz"]);
                if i == 0 {
                    assert!((0.0..0.01).contains(&frequency), "{case} {model}: rigid rotation at {frequency} Hz");
                } else {
                    close(frequency, *expected, TOLERANCE, &format!("{case} {model} mode {i}"));
                }
                let shares = ["pinion", "gear"].into_iter().flat_map(|rotor| {
                    let share = &mode["energy_share"][rotor];
                    ["lateral", "axial", "tilt", "torsion"].map(|motion| number(&share[motion]))
                });
                assert!((shares.sum::<f64>() - 1.0).abs() < 1e-9, "{case} {model} mode {i}");
            }
        }
    }
}

#[test]
fn stiffness_totals_and_effective_masses_agree() {
    for case in CASES {
        let (found, expected) = (run("inspect", case), expected(case));
        for rotor in ["pinion", "gear"] {
            let (found, expected) = (&found[rotor], &expected["inspect"][rotor]);
            let what = |name: &str| format!("{case} {rotor} {name}");
            for (station, expected) in numbers(&found["stations_mm"]).iter().zip(numbers(&expected["stations_mm"])) {
                assert!((station - expected).abs() < 1e-9, "{}", what("station"));
            }
            for total in ["mass_kg", "polar_inertia_kg_m2", "diametral_inertia_kg_m2", "centroid_mm"] {
                close(number(&found[total]), number(&expected[total]), 1e-12, &what(total));
            }
            same_matrix(&found["shaft_bearing_stiffness"], &expected["shaft_bearing_stiffness"], 1e-10, &what("K_ll"));
            for plane in ["x", "z"] {
                let (found, expected) = (&found["bending"][plane], &expected["bending"][plane]);
                assert_eq!(found["fallback"], expected["fallback"], "{}", what(plane));
                for (figure, tolerance) in
                    [("frequency_hz", 1e-11), ("mass_kg", 1e-10), ("inertia_kg_m2", 1e-10), ("energy_residual", 1e-8)]
                {
                    close(number(&found[figure]), number(&expected[figure]), tolerance, &what(figure));
                }
            }
            let bearings = expected["bearings"].as_array().unwrap();
            assert_eq!(found["bearings"].as_array().unwrap().len(), bearings.len());
            for (i, expected) in bearings.iter().enumerate() {
                let found = &found["bearings"][i];
                assert_eq!(found["name"], expected["name"]);
                same_matrix(&found["stiffness"], &expected["stiffness"], 1e-12, &what("bearing"));
            }
        }
    }
}

/// Entry by entry, relative to the diagonal entries that an entry couples (metres and radians have no common size).
fn same_matrix(found: &Value, expected: &Value, tolerance: f64, what: &str) {
    for i in 0..6 {
        for j in 0..6 {
            let (entry, wanted) = (number(&found[i][j]), number(&expected[i][j]));
            let size = (number(&expected[i][i]) * number(&expected[j][j])).abs().sqrt();
            assert!((entry - wanted).abs() <= tolerance * size, "{what} [{i}][{j}]: {entry} instead of {wanted}");
        }
    }
}

#[test]
fn agreement_figures_agree() {
    // required 1e-4; 1e-11 seen
    const TOLERANCE: f64 = 1e-8;
    for case in CASES {
        let (found, expected) = (run("check", case), expected(case));
        for model in ["enhanced", "basic"] {
            let (found, expected) = (&found[0][model], &expected["check"][model]);
            for figure in ["rms_db", "max_db", "max_at_hz", "frac", "agreement_limit_hz"] {
                close(
                    number(&found[figure]),
                    number(&expected[figure]),
                    TOLERANCE,
                    &format!("{case} {model} {figure}"),
                );
            }
        }
    }
}

/// Hua et al. (2012) find the enhanced model within a few dB of finite elements where the basic one is far off: below 1.5 kHz about
/// 1 dB against several on designs like theirs.
#[test]
fn below_the_bending_modes_the_enhanced_model_agrees_and_the_basic_one_does_not() {
    for case in ["overhung-rigid", "overhung-elastic", "straddle-elastic"] {
        let file = fixture(&format!("{case}.toml"));
        let mut out = Vec::new();
        let cli = Cli::try_parse_from(["bevelscope", "check", &file, "--band", "10:1500", "--format", "json"]).unwrap();
        cli.run(&mut out, std::io::sink()).unwrap();
        let found: Value = serde_json::from_slice(&out).unwrap();
        let (enhanced, basic) = (number(&found[0]["enhanced"]["rms_db"]), number(&found[0]["basic"]["rms_db"]));
        println!("{case}: enhanced {enhanced:.2} dB, basic {basic:.2} dB RMS from 10 to 1500 Hz");
        assert!(enhanced < 1.0, "{case}: {enhanced}");
        assert!(basic > 3.0, "{case}: {basic}");
    }
}

/// A lumped model is statically exact: its response tends to that of finite elements as the frequency goes to zero.
#[test]
fn both_lumped_models_are_right_at_low_frequency() {
    // the paper's three, whose first modes lie far above
    for shipped in &bevelscope::design::library::SHIPPED[..3] {
        let design = bevelscope::design::read(shipped.text).design.unwrap();
        let rotors = Rotors::new(&design).unwrap();
        let at_1_hz = |kind| solve(kind, &design, &rotors, &[1.0]).unwrap().mesh_force[0];
        let fe = at_1_hz(ModelKind::Fe);
        for kind in [ModelKind::Enhanced, ModelKind::Basic] {
            let error = (at_1_hz(kind) - fe).norm() / fe.norm();
            println!("{} {}: {error:.1e} at 1 Hz", shipped.file_name, kind.name());
            assert!(error < 1e-6, "{} {}: {error:e}", shipped.file_name, kind.name());
        }
    }
}
