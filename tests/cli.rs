//! The program from outside: what it prints, where, and how it ends, on good and on bad input.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;
use tempfile::TempDir;

const PROGRAM: &str = env!("CARGO_BIN_EXE_bevelscope");

fn designs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("designs")
}

fn elastic() -> String {
    designs().join("overhung-elastic.toml").display().to_string()
}

fn elastic_text() -> String {
    std::fs::read_to_string(elastic()).unwrap()
}

fn bevelscope(arguments: &[&str]) -> Output {
    Command::new(PROGRAM).args(arguments).stdin(Stdio::null()).output().unwrap()
}

fn stdout(output: &Output) -> &str {
    std::str::from_utf8(&output.stdout).unwrap()
}

fn stderr(output: &Output) -> &str {
    std::str::from_utf8(&output.stderr).unwrap()
}

/// Bad input: exit 2, a message on stderr that holds the given words, nothing on stdout.
fn refused(arguments: &[&str], words: &[&str]) {
    let output = bevelscope(arguments);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", stderr(&output));
    assert_eq!(stdout(&output), "", "{arguments:?}");
    for word in words {
        assert!(stderr(&output).contains(word), "{arguments:?}: no {word:?} in: {}", stderr(&output));
    }
}

/// A folder with one file of the given content.
fn folder_with(name: &str, content: impl AsRef<[u8]>) -> (TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(name);
    std::fs::write(&file, content).unwrap();
    let file = file.display().to_string();
    (folder, file)
}

#[test]
fn csv_reads_back_as_the_json() {
    let json = bevelscope(&["solve", &elastic(), "--format", "json"]);
    let json: Value = serde_json::from_slice(&json.stdout).unwrap();
    let csv = bevelscope(&["solve", &elastic(), "--format", "csv"]);
    let mut lines = stdout(&csv).split_terminator("\r\n");
    assert_eq!(
        lines.next().unwrap(),
        "frequency_hz,\
         fe_mesh_force_n_re,fe_mesh_force_n_im,fe_transmission_error_m_re,fe_transmission_error_m_im,\
         enhanced_mesh_force_n_re,enhanced_mesh_force_n_im,enhanced_transmission_error_m_re,enhanced_transmission_error_m_im,\
         basic_mesh_force_n_re,basic_mesh_force_n_im,basic_transmission_error_m_re,basic_transmission_error_m_im"
    );
    let rows: Vec<Vec<f64>> = lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    assert_eq!(rows.len(), 1000);
    for (i, row) in rows.iter().enumerate() {
        let mut wanted = vec![json["frequency_hz"][i].as_f64().unwrap()];
        for model in ["fe", "enhanced", "basic"] {
            for quantity in ["mesh_force_n", "transmission_error_m"] {
                wanted.extend(["re", "im"].map(|part| json["models"][model][quantity][part][i].as_f64().unwrap()));
            }
        }
        assert_eq!(*row, wanted, "line {i}");
    }
}

#[test]
fn models_are_chosen_and_ordered() {
    let output = bevelscope(&["solve", &elastic(), "--model", "basic,fe,basic", "--format", "csv"]);
    let header = stdout(&output).lines().next().unwrap();
    assert!(header.starts_with("frequency_hz,basic_mesh_force_n_re,"), "{header}");
    assert_eq!(header.split(',').count(), 9);
    let output = bevelscope(&["modes", &elastic(), "--model", "enhanced", "--format", "json"]);
    let json: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(json["models"].as_object().unwrap().keys().collect::<Vec<_>>(), ["enhanced"]);
    assert_eq!(json["models"]["enhanced"].as_array().unwrap().len(), 14);
}

/// The table counts from 1, JSON has places in its lists.
#[test]
fn modes_are_counted_from_1_where_people_read() {
    let table = bevelscope(&["modes", &elastic()]);
    let text = stdout(&table);
    let json: Value = serde_json::from_slice(&bevelscope(&["modes", &elastic(), "--format", "json"]).stdout).unwrap();
    let pairs = json["models"]["enhanced"].as_array().unwrap();
    let (_, enhanced) = text.split_once("\nEnhanced").unwrap_or_else(|| panic!("{text}"));
    let rows: Vec<Vec<&str>> = enhanced.lines().map(|line| line.split_whitespace().collect()).collect();
    for (at, mode) in pairs.iter().enumerate() {
        let number = (at + 1).to_string();
        let row =
            rows.iter().find(|row| row.len() == 14 && row[0] == number).unwrap_or_else(|| panic!("{number}: {text}"));
        match mode["paired_with"]["fe_mode"].as_u64() {
            Some(fe) => assert_eq!(row[10], (fe + 1).to_string()),
            None => assert_eq!(row[10], "-"),
        }
    }
    // the rigid rotation is at 0 Hz in both
    assert_eq!(rows.iter().find(|row| row.len() == 14 && row[0] == "1").unwrap()[12], "-");
    let help = bevelscope(&["modes", "--help"]);
    assert!(stdout(&help).contains("JSON from 0"), "{}", stdout(&help));
    // a share below 0 comes with a line about it, and no line without one
    for (design, text) in bevelscope::design::library::SHIPPED.iter().map(|shipped| {
        let file = format!("designs/{}", shipped.file_name);
        (file.clone(), stdout(&bevelscope(&["modes", &file])).to_owned())
    }) {
        let shares = text.lines().filter(|line| line.starts_with(|digit: char| digit == ' ' || digit.is_ascii_digit()));
        let shares = shares.map(|line| line.split_whitespace().skip(2).take(8).collect::<Vec<_>>());
        let is_negative = shares.flatten().any(|cell| cell.starts_with('-') && cell.parse::<i32>().is_ok());
        assert_eq!(is_negative, text.contains("shares below 0:"), "{design}: {text}");
    }
}

#[test]
fn reduced_models_stand_beside_the_others() {
    let models = ["reduced:3,fe,reduced:0", "--format"];
    let json = bevelscope(&[["solve", &elastic(), "--model"].as_slice(), &models, &["json"]].concat());
    let json: Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(json["models"].as_object().unwrap().keys().collect::<Vec<_>>(), ["fe", "reduced_0", "reduced_3"]);
    assert_eq!(
        (&json["models"]["reduced_3"]["coordinates"], &json["models"]["reduced_0"]["coordinates"]),
        (&20.into(), &14.into())
    );
    let csv = bevelscope(&[["solve", &elastic(), "--model"].as_slice(), &models, &["csv"]].concat());
    let header = stdout(&csv).lines().next().unwrap();
    assert!(header.starts_with("frequency_hz,reduced_3_mesh_force_n_re,reduced_3_mesh_force_n_im,"), "{header}");
    let json = bevelscope(&[["modes", &elastic(), "--model"].as_slice(), &models, &["json"]].concat());
    let json: Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(json["models"]["reduced_3"].as_array().unwrap().len(), 20);
    assert_eq!(json["models"]["reduced_3"][1]["paired_with"]["fe_mode"], 1);
    for format in ["solve", "modes"] {
        let table = bevelscope(&[[format, &elastic(), "--model"].as_slice(), &models, &["table"]].concat());
        assert!(table.status.success() && stdout(&table).lines().all(|line| line.chars().count() <= 80));
    }
    for wrong in ["reduced", "reduced:x", "reduced:-1", "fem"] {
        refused(&["solve", &elastic(), "--model", wrong], &[wrong, "reduced:K"]);
    }
    let check = bevelscope(&["check", designs().to_str().unwrap(), "--format", "json"]);
    let check: Value = serde_json::from_slice(&check.stdout).unwrap();
    let modes = [0, 1, 2].map(|row: usize| check[row]["reduced_modes_for_1_db"].as_u64());
    assert_eq!(modes, [Some(2), Some(1), Some(6)]);
}

#[test]
fn bearing_forces_are_columns_with_safe_names() {
    let name = r#"left, \u001b[31m\"A\""#;
    let text = elastic_text().replacen("name = \"B1\"", &format!("name = \"{name}\""), 1);
    assert_ne!(text, elastic_text());
    let (_folder, file) = folder_with("named.toml", text);
    let run = |format: &str| {
        let output = bevelscope(&["solve", &file, "--model", "fe,basic", "--bearing-forces", "--format", format]);
        assert!(output.status.success(), "{}", stderr(&output));
        assert!(!output.stdout.contains(&0x1b), "{format}");
        stdout(&output).to_owned()
    };
    let (csv, json): (String, Value) = (run("csv"), serde_json::from_str(&run("json")).unwrap());
    let header = csv.split("\r\n").next().unwrap();
    let first = "fe_bearing_gear_left, \\u{1b}[31m\"\"A\"\"_fx_n_re";
    assert!(header.contains(&format!(",\"{first}\",")), "{header}");
    assert!(header.ends_with(",basic_bearing_gear_B2_mz_n_m_re,basic_bearing_gear_B2_mz_n_m_im"), "{header}");
    let row: Vec<f64> = csv.split("\r\n").nth(8).unwrap().split(',').map(|cell| cell.parse().unwrap()).collect();
    let mut at = 9;
    for (model, how) in [("fe", "exact"), ("basic", "recovered by static shapes")] {
        let forces = &json["models"][model]["bearing_forces"];
        assert_eq!(forces["displacements"], how);
        for (i, rotor) in ["pinion", "pinion", "gear", "gear"].into_iter().enumerate() {
            let bearing = &forces["bearings"][i];
            assert_eq!(bearing["rotor"], rotor);
            let mut squares = 0.0;
            for component in ["fx_n", "fy_n", "fz_n", "mx_n_m", "my_n_m", "mz_n_m"] {
                for part in ["re", "im"] {
                    let value = bearing[component][part][7].as_f64().unwrap();
                    assert_eq!(row[at], value, "{model} {i} {component}");
                    squares += if component.starts_with('f') { value * value } else { 0.0 };
                    at += 1;
                }
            }
            let total = bearing["total_n"][7].as_f64().unwrap();
            assert!((total - squares.sqrt()).abs() < 1e-12 * total);
        }
    }
    assert_eq!(row.len(), at);
    let table = run("table");
    assert!(table.contains("recovered by static shapes") && table.lines().all(|line| line.chars().count() <= 80));
    let without = bevelscope(&["solve", &elastic(), "--format", "json"]);
    assert!(!stdout(&without).contains("bearing_forces"));
}

#[test]
fn modes_have_names_and_shapes_on_request() {
    let run = |more: &[&str]| -> Value {
        let output = bevelscope(&[&["modes", &elastic(), "--format", "json"], more].concat());
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let plain = run(&[]);
    assert!(plain.get("mac").is_none() && plain.get("shapes").is_none());
    assert_eq!(plain["models"]["fe"][0]["name"], "rigid rotation");
    assert_eq!(plain["models"]["fe"][1]["name"], "torsion of both");
    assert_eq!(plain["models"]["fe"][9]["name"], "gear tilt, x-y plane");
    let shapes = run(&["--shapes"]);
    let mac = |i: usize, j: usize| shapes["mac"]["enhanced"][i][j].as_f64().unwrap();
    let pair = &shapes["models"]["enhanced"][6]["paired_with"];
    assert_eq!(mac(6, pair["fe_mode"].as_u64().unwrap() as usize), pair["mac"].as_f64().unwrap());
    assert!((shapes["mac"]["fe"][3][3].as_f64().unwrap() - 1.0).abs() < 1e-12);
    assert_eq!(shapes["shapes"]["basic"]["displacements"], "recovered by static shapes");
    let turned = &shapes["shapes"]["basic"]["modes"][0]["gear"];
    let (stations, turning) = (turned["stations_mm"].as_array().unwrap(), turned["thy_rad"].as_array().unwrap());
    assert_eq!(stations.len(), turning.len());
    let drive = turned["drive_rad"].as_f64().unwrap();
    assert!(drive != 0.0 && turning.iter().all(|value| (value.as_f64().unwrap() / drive - 1.0).abs() < 1e-6));
}

#[test]
fn bands_say_where_and_why() {
    let run = |more: &[&str]| {
        let output = bevelscope(&[&["bands", &elastic()], more].concat());
        assert!(output.status.success(), "{}", stderr(&output));
        stdout(&output).to_owned()
    };
    let json: Value = serde_json::from_str(&run(&["--format", "json"])).unwrap();
    let bands = json["bands"].as_array().unwrap();
    assert_eq!((&json["model"], &json["tolerance_db"], bands.len()), (&"enhanced".into(), &3.0.into(), 6));
    let missing = &bands[4];
    assert_eq!((&missing["mode"]["name"], &missing["shift"]), (&"gear torsion".into(), &Value::Null));
    assert!(missing["why"][1].as_str().unwrap().contains("is missing in the enhanced model"));
    let csv = run(&["--format", "csv"]);
    let rows: Vec<&str> = csv.split_terminator("\r\n").collect();
    assert_eq!(rows.len(), 7);
    assert!(rows[0].starts_with("from_hz,to_hz,worst_db,worst_at_hz,mode,mode_hz,"));
    let from: Vec<f64> = rows[1..].iter().map(|row| row.split(',').next().unwrap().parse().unwrap()).collect();
    assert!(from.iter().zip(bands).all(|(from, band)| *from == band["from_hz"].as_f64().unwrap()));
    let table = run(&["--model", "basic", "--tolerance", "10"]);
    assert!(table.contains("basic against FE: lines that differ by more than 10 dB") && table.contains("gear lateral"));
    assert!(run(&["--model", "reduced:99", "--tolerance", "0.1"]).contains("no line differs"));
    refused(&["bands", &elastic(), "--model", "fe"], &["themselves"]);
    refused(&["bands", &elastic(), "--tolerance=-1"], &["not negative"]);
}

#[test]
fn tables_fit_eighty_columns_and_say_their_units() {
    for (arguments, units) in [
        (vec!["solve", "--format", "table"], vec!["Hz", "F, N", "deg", "um"]),
        (vec!["modes", "--model", "fe,enhanced,basic,reduced:2"], vec!["Hz", "%", "MAC"]),
        (vec!["bands"], vec!["Hz", "%", "dB"]),
        (vec!["bands", "--model", "basic"], vec!["Hz", "%", "dB"]),
        (vec!["inspect"], vec!["mm", "kg", "kg m2", "Hz", "N/m"]),
        (vec!["check"], vec!["limit Hz", "dB", "FRAC"]),
    ] {
        for design in ["overhung-elastic", "overhung-rigid", "straddle-elastic"] {
            let file = designs().join(format!("{design}.toml")).display().to_string();
            let arguments: Vec<&str> = arguments.iter().copied().chain([file.as_str()]).collect();
            let output = bevelscope(&arguments);
            assert!(output.status.success(), "{}", stderr(&output));
            let widest = stdout(&output).lines().map(|line| line.chars().count()).max().unwrap();
            assert!(widest <= 80, "{arguments:?}: {widest} columns");
            for unit in &units {
                assert!(stdout(&output).contains(unit), "{arguments:?}: no {unit}");
            }
        }
    }
}

#[test]
fn standard_input_is_a_file_too() {
    for command in ["solve", "modes", "inspect", "check"] {
        let mut child = Command::new(PROGRAM)
            .args([command, "-", "--format", "json"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        child.stdin.take().unwrap().write_all(elastic_text().as_bytes()).unwrap();
        let output = child.wait_with_output().unwrap();
        assert!(output.status.success(), "{command}");
        let json: Value = serde_json::from_slice(&output.stdout).unwrap();
        let design = if command == "check" { &json[0]["design"] } else { &json["design"] };
        assert_eq!(design, "Both overhung, elastic bearings", "{command}");
    }
}

#[test]
fn check_lists_a_folder_by_file_name() {
    let output = bevelscope(&["check", designs().to_str().unwrap(), "--format", "json"]);
    let json: Value = serde_json::from_slice(&output.stdout).unwrap();
    let files: Vec<&str> = json.as_array().unwrap().iter().map(|row| row["file"].as_str().unwrap()).collect();
    let stems: Vec<&str> = files.iter().map(|file| Path::new(file).file_stem().unwrap().to_str().unwrap()).collect();
    assert_eq!(
        stems,
        [
            "overhung-elastic",
            "overhung-rigid",
            "straddle-elastic",
            "straddle-helical",
            "tapered-axle",
            "tapered-hypoid",
            "turbine-generator"
        ]
    );
}

#[test]
fn check_judges_the_enhanced_model_by_the_limits() {
    let status = |limits: &[&str]| {
        let of_the_paper = ["overhung-elastic", "overhung-rigid", "straddle-elastic"];
        let files = of_the_paper.map(|name| designs().join(format!("{name}.toml")).display().to_string());
        let files = files.iter().map(String::as_str);
        let arguments: Vec<&str> = std::iter::once("check").chain(files).chain(limits.iter().copied()).collect();
        bevelscope(&arguments).status.code().unwrap()
    };
    // 3.72 dB and 2,997 Hz are the worst of the three
    assert_eq!(status(&[]), 0);
    assert_eq!(status(&["--max-rms-db", "4"]), 0);
    assert_eq!(status(&["--max-rms-db", "3.5"]), 1);
    assert_eq!(status(&["--min-limit-hz", "2990"]), 0);
    assert_eq!(status(&["--min-limit-hz", "3000"]), 1);
    // the band restricts the RMS but not the agreement limit
    assert_eq!(status(&["--max-rms-db", "1", "--band", "10:1500"]), 0);
    assert_eq!(status(&["--min-limit-hz", "2990", "--band", "10:1500"]), 0);
}

#[test]
fn check_goes_on_after_a_broken_design() {
    let (folder, _) = folder_with("broken.toml", "format = 1\nname = ");
    std::fs::write(folder.path().join("whole.toml"), elastic_text()).unwrap();
    let output = bevelscope(&["check", folder.path().to_str().unwrap(), "--format", "json"]);
    assert_eq!(output.status.code(), Some(2));
    let json: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(json[0]["error"].as_str().unwrap().contains("broken.toml:2"), "{json}");
    assert_eq!(json[1]["design"], "Both overhung, elastic bearings");
    let table = bevelscope(&["check", folder.path().to_str().unwrap()]);
    assert_eq!(table.status.code(), Some(2));
    assert!(stdout(&table).contains("broken") && stdout(&table).contains("whole"), "{}", stdout(&table));
    // a file that is not there, or a band without lines, is a row with its reason as well
    let missing = bevelscope(&["check", "no-such.toml", &elastic(), "--band", "5000:6000"]);
    assert_eq!(missing.status.code(), Some(2));
    for words in ["there is no such file", "no frequency line lies in the band 5000 to 6000 Hz"] {
        assert!(stdout(&missing).contains(words), "{}", stdout(&missing));
    }
    // the mark below a quoted line stays below what it marks
    let (folder, file) = folder_with("tabs.toml", elastic_text().replace("teeth = 14", "\tteth = 14"));
    for arguments in [vec!["check", &file], vec!["inspect", &file]] {
        let output = bevelscope(&arguments);
        let text = [stdout(&output), stderr(&output)].concat();
        assert!(text.contains("| \tteth = 14") && !text.contains("\\u{9}"), "{text}");
    }
    // limits do not turn bad input into a mere 1
    let limited = bevelscope(&["check", folder.path().to_str().unwrap(), "--max-rms-db", "0"]);
    assert_eq!(limited.status.code(), Some(2));
}

#[test]
fn bad_files_are_refused() {
    for command in ["solve", "modes", "inspect"] {
        let (_folder, empty) = folder_with("empty.toml", "");
        refused(&[command, &empty], &["the file is empty"]);
        let (_folder, large) = folder_with("large.toml", vec![b'#'; (4 << 20) + 1]);
        refused(&[command, &large], &["4 MiB"]);
        let (_folder, latin) = folder_with("latin.toml", b"format = 1\nname = \"Stra\xdfe\"\n");
        refused(&[command, &latin], &["latin.toml:2", "UTF-8"]);
        let (_folder, nan) = folder_with("nan.toml", elastic_text().replace("= 6.4e8", "= nan"));
        refused(&[command, &nan], &["mesh.stiffness_n_per_m", "nan"]);
        let (_folder, unknown) = folder_with("unknown.toml", elastic_text().replace("teeth = 14", "teth = 14"));
        refused(&[command, &unknown], &["pinion.teth", "`teeth`"]);
        refused(&[command, designs().to_str().unwrap()], &["this is a folder"]);
        refused(&[command, "no-such.toml"], &["there is no such file"]);
    }
}

/// Values that can be read but not computed with: the error names what came out, and no figure is printed.
#[test]
fn values_that_overflow_name_their_result() {
    let text = elastic_text();
    for (from, to, words) in [
        ("stiffness_n_per_m = 6.4e8", "stiffness_n_per_m = 1e308", vec!["mesh force"]),
        ("mass_kg = 3.67", "mass_kg = 1e308", vec!["gear shaft"]),
        ("kx_n_per_m = 6.0e8", "kx_n_per_m = 1e308", vec!["pinion shaft"]),
        ("inertia_kg_m2 = 0.3", "inertia_kg_m2 = 1e308", vec!["gear shaft"]),
        ("length_mm = 36.0", "length_mm = 1e308", vec!["pinion shaft: the centre of mass is too large"]),
    ] {
        assert!(text.contains(from), "{from}");
        let (_folder, file) = folder_with("huge.toml", text.replacen(from, to, 1));
        let output = bevelscope(&["solve", &file, "--format", "json"]);
        match output.status.code() {
            // a result that is finite all the same is a result
            Some(0) => {
                let json: Value = serde_json::from_slice(&output.stdout).unwrap();
                let forces = json["models"]["fe"]["mesh_force_n"]["re"].as_array().unwrap();
                assert!(forces.iter().all(|force| force.as_f64().is_some_and(f64::is_finite)), "{to}");
            }
            Some(2) => {
                assert_eq!(stdout(&output), "", "{to}");
                assert!(words.iter().any(|word| stderr(&output).contains(word)), "{to}: {}", stderr(&output));
            }
            other => panic!("{to}: {other:?} {}", stderr(&output)),
        }
    }
}

#[test]
fn an_unsupported_shaft_is_named_with_its_motion() {
    let text = elastic_text().replace("ky_n_per_m = 2.2e8", "ky_n_per_m = 0");
    let (_folder, file) = folder_with("loose.toml", text);
    refused(&["solve", &file], &["gear shaft: nothing holds it in the axial direction"]);
    let check = bevelscope(&["check", &file]);
    assert_eq!(check.status.code(), Some(2));
    assert!(stdout(&check).contains("nothing holds it in the axial direction"), "{}", stdout(&check));
}

/// Escape sequences in a name would recolour, clear or retitle the terminal that shows them.
#[test]
fn escape_sequences_in_names_are_shown_harmlessly() {
    let text = elastic_text()
        .replace("\"Both overhung, elastic bearings\"", r#""evil \u001b[31m\u001b]0;title\u0007 \u009b2J name""#)
        .replace("name = \"B1\"", r#"name = "B\u001b[2J1""#);
    let (_folder, file) = folder_with("\u{1b}[2Jevil.toml", text);
    for arguments in [
        vec!["solve", &file],
        vec!["solve", &file, "--format", "json"],
        vec!["solve", &file, "--format", "csv"],
        vec!["modes", &file],
        vec!["modes", &file, "--format", "json"],
        vec!["inspect", &file],
        vec!["inspect", &file, "--format", "json"],
        vec!["check", &file],
        vec!["check", &file, "--format", "json"],
    ] {
        let output = bevelscope(&arguments);
        assert!(output.status.success(), "{arguments:?}: {}", stderr(&output));
        for text in [stdout(&output), stderr(&output)] {
            let control = text.chars().find(|c| c.is_control() && !matches!(c, '\n' | '\r'));
            assert_eq!(control, None, "{arguments:?}");
        }
    }
    let json = bevelscope(&["inspect", &file, "--format", "json"]);
    let json: Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(json["design"], "evil \u{1b}[31m\u{1b}]0;title\u{7} \u{9b}2J name", "the data itself is untouched");
}

#[test]
fn a_folder_without_designs_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    // a row with its reason, and the rest goes on
    let output = bevelscope(&["check", folder.path().to_str().unwrap(), &elastic()]);
    assert_eq!(output.status.code(), Some(2));
    assert!(stdout(&output).contains("the folder holds no design"), "{}", stdout(&output));
    assert!(stdout(&output).contains("2,997"), "{}", stdout(&output));
}

/// Warnings are no errors, but `check` must not swallow them.
#[test]
fn check_shows_warnings() {
    let (_folder, file) = folder_with("odd.toml", elastic_text().replace("= 0.00026", "= 0.26"));
    let table = bevelscope(&["check", &file]);
    assert_eq!(table.status.code(), Some(0));
    assert!(stdout(&table).contains("odd !"), "{}", stdout(&table));
    assert!(stdout(&table).contains("polar_inertia_kg_m2"), "{}", stdout(&table));
    let json = bevelscope(&["check", &file, "--format", "json"]);
    let json: Value = serde_json::from_slice(&json.stdout).unwrap();
    assert!(json[0]["warnings"].as_str().unwrap().contains("polar_inertia_kg_m2"), "{json}");
}

/// A result is worth more than its warnings.
#[cfg(target_os = "linux")]
#[test]
fn warnings_that_cannot_be_written_lose_no_result() {
    let (_folder, file) = folder_with("odd.toml", elastic_text().replace("= 0.00026", "= 0.26"));
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = Command::new(PROGRAM).args(["inspect", &file]).stderr(full).output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert!(stdout(&output).contains("GEAR"));
}

/// Sizes at which a count of parts or a bracket would never end: an error that names a result, in bounded time.
#[test]
fn senseless_sizes_come_to_an_end() {
    let text = elastic_text();
    for (from, to) in [
        ("outer_diameter_mm = 44.0", "outer_diameter_mm = 1e-300"),
        ("outer_diameter_mm = 44.0", "outer_diameter_mm = 1e100"),
        ("length_mm = 36.0", "length_mm = 1e100"),
        ("mass_kg = 3.67", "mass_kg = 1e200"),
        ("kx_n_per_m = 6.0e8", "kx_n_per_m = 1e250"),
        ("point_mm = [0.0, 0.0, 27.4595]", "point_mm = [1e300, 0.0, 27.4595]"),
        ("frequency_max_hz = 4000.0", "frequency_max_hz = 1e300"),
    ] {
        assert!(text.contains(from), "{from}");
        let (_folder, file) = folder_with("senseless.toml", text.replacen(from, to, 1));
        for command in ["solve", "modes", "inspect", "check"] {
            let output = bevelscope(&[command, &file, "--format", "json"]);
            let status = output.status.code();
            assert!(matches!(status, Some(0 | 2)), "{command} {to}: {status:?} {}", stderr(&output));
            if status == Some(0) {
                assert_no_null_number(&serde_json::from_slice(&output.stdout).unwrap(), &format!("{command} {to}"));
            }
        }
    }
}

/// JSON has no infinity: a number that overflowed would be null. Only partners of peaks and modes may be missing.
fn assert_no_null_number(value: &Value, what: &str) {
    match value {
        Value::Object(fields) => {
            for (key, value) in fields {
                let may_miss = ["paired_with", "fe_hz", "lumped_hz", "shift_percent", "height_db"];
                assert!(!value.is_null() || may_miss.contains(&key.as_str()), "{what}: {key} is null");
                assert_no_null_number(value, what);
            }
        }
        Value::Array(values) => {
            for value in values {
                assert!(!value.is_null(), "{what}: null in a list");
                assert_no_null_number(value, what);
            }
        }
        _ => {}
    }
}

/// A range in which all lines are one frequency is a plateau from end to end.
#[test]
fn a_range_of_one_frequency_is_solved_in_time() {
    let text = elastic_text()
        .replace("frequency_min_hz = 10.0", "frequency_min_hz = 1000.0")
        .replace("frequency_max_hz = 4000.0", "frequency_max_hz = 1000.0000000000002")
        .replace("frequency_lines = 1000", "frequency_lines = 200000");
    let (_folder, file) = folder_with("flat.toml", text);
    assert!(bevelscope(&["check", &file]).status.success());
}

#[test]
fn a_mistyped_command_is_recognised() {
    refused(&["slove"], &["did you mean the command `solve`"]);
    refused(&["-"], &["standard input"]);
    refused(&["--ascii", "keys"], &["`keys` is a command", "bevelscope keys"]);
}

#[test]
fn bad_usage_exits_with_two() {
    refused(&["check", &elastic(), "--band", "1000:100"], &["--band", "lower first"]);
    refused(&["check", &elastic(), "--max-rms-db", "much"], &["--max-rms-db"]);
    refused(&["check"], &["PATHS"]);
    refused(&["solve", &elastic(), "--model", "fe,reduced"], &["reduced", "enhanced"]);
    refused(&["solve", &elastic(), "--format", "xml"], &["xml", "csv"]);
    refused(&["--no-such-flag"], &["--no-such-flag"]);
}

#[test]
fn the_explorer_needs_a_terminal() {
    refused(&[], &["not a terminal"]);
    refused(&[designs().to_str().unwrap()], &["not a terminal", "bevelscope check"]);
    refused(&["no-such-folder"], &["there is no such file or folder"]);
}

/// `bevelscope solve ... | head -1` ends quietly.
#[test]
fn a_reader_that_leaves_early_ends_the_program_quietly() {
    let mut child = Command::new(PROGRAM)
        .args(["solve", &elastic(), "--format", "json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut first = [0; 16];
    child.stdout.take().unwrap().read_exact(&mut first).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(stderr(&output), "");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_reported() {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = Command::new(PROGRAM).args(["solve", &elastic()]).stdout(full).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("cannot write the output"), "{}", stderr(&output));
}
