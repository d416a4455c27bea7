//! What commands say to whoever uses them for the first time.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

/// The line of the help's example: the drive flank of sample 1 of ISO 23509.
const DRIVE: &str = "drive,6.4e8,5,0,0,27.46,0.76975,-0.62285,0.1398,0,0,76.49,-0.76975,0.1398,-0.62285";

fn bevelscope(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_bevelscope")).args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn head() -> String {
    bevelscope::gear::COLUMNS.join(",")
}

/// Standard output and error of an import of this table into a shipped design.
fn import(table: &str, design: &str, flank: &str) -> (bool, String, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("m1.csv");
    std::fs::write(&path, table).unwrap();
    let design = format!("designs/{design}.toml");
    let output = bevelscope(&["import-mesh", path.to_str().unwrap(), &design, "--flank", flank, "-o", "-"]);
    (output.status.success(), text(&output.stdout), text(&output.stderr))
}

#[test]
fn an_import_says_so_beside_each_number_and_leaves_no_comment_on_the_old_ones() {
    let old = std::fs::read_to_string("designs/overhung-rigid.toml").unwrap();
    let (done, new, said) = import(&format!("{}\n{DRIVE}\n", head()), "overhung-rigid", "drive");
    assert!(done && said.is_empty(), "{said}");
    // byte for byte: the section is this, all else is as it was
    let (start, end) = (old.find("[mesh]").unwrap(), old.find("# ---- Pinion").unwrap());
    let section = "\
[mesh]
stiffness_n_per_m = 6.4e8  # imported: m1.csv, drive flank
damping = 0.06                   # designer's choice: loss factor of the tooth contact
transmission_error_um = 5.0  # imported: m1.csv, drive flank

[mesh.pinion]  # imported: m1.csv, drive flank
point_mm = [0.0, 0.0, 27.46]  # imported: m1.csv, drive flank
line_of_action = [0.76975, -0.62285, 0.1398]  # imported: m1.csv, drive flank

[mesh.gear]  # imported: m1.csv, drive flank
point_mm = [0.0, 0.0, 76.49]  # imported: m1.csv, drive flank
line_of_action = [-0.76975, 0.1398, -0.62285]  # imported: m1.csv, drive flank

";
    assert_eq!(new, [&old[..start], section, &old[end..]].concat());
}

#[test]
fn gear_data_that_give_way_are_counted() {
    let (done, new, said) = import(&format!("{}\n{DRIVE}\n", head()), "tapered-axle", "drive");
    assert!(done && !new.contains("[mesh.geometry]") && !new.contains("estimate: ISO"), "{new}");
    assert!(said.ends_with("m1.csv: [mesh.geometry] is taken out, 12 keys with their comments\n"), "{said}");
}

#[test]
fn vectors_of_another_tooth_are_warned_of() {
    const WARNING: &str = "deg away from the tooth normal of [mesh.geometry], on either flank";
    // the coast flank that follows from the same gear data
    let coast = "coast,5.1e8,4,0,0,27.46,-0.76975,0.39173,0.50401,0,0,76.49,0.76975,0.50401,0.39173";
    let table = |line: &str| format!("{}\n{line}\n", head());
    let (_, _, said) = import(&table(coast), "tapered-axle", "coast");
    assert!(!said.contains(WARNING), "{said}");
    let reversed = DRIVE.replace("-0.76975,0.1398,-0.62285", "0.76975,-0.1398,0.62285");
    let exchanged = DRIVE.replace("-0.76975,0.1398,-0.62285", "-0.76975,-0.62285,0.1398");
    for wrong in [reversed, exchanged] {
        let (done, _, said) = import(&table(&wrong), "tapered-axle", "drive");
        assert!(done && said.contains("warning: gear_line is") && said.contains(WARNING), "{said}");
        assert!(!said.contains("pinion_line"), "{said}");
    }
}

#[test]
fn a_table_that_cannot_be_read_says_all_that_is_wrong_with_it() {
    let refused = |table: &str, expected: &str| {
        let (done, new, said) = import(table, "overhung-rigid", "drive");
        assert!(!done && new.is_empty() && said.contains(expected), "{said}");
    };
    refused(&head().replace(',', ";"), "separated by semicolons; commas are wanted between values, and a point");
    refused(&head().replace(',', "\t"), "separated by tabs");
    let few = head().replace("flank,", "").replace(",gear_line_z", "");
    refused(&few, "the columns `flank`, `gear_line_z` are missing");
    refused(&format!("{}\n{}", head(), DRIVE.replace('.', ",")), "decimals stand behind a point, not a comma");
    refused(&format!("{}\n{}", head(), DRIVE.replace("0.1398", "0.3")), "must be a unit vector, to 1 %");
    // two decimals: (0.77, -0.62, 0.14) has the length 0.998449
    let rounded = DRIVE.replace("0.76975,-0.62285,0.1398,", "0.77,-0.62,0.14,");
    let (done, new, said) = import(&format!("{}\n{rounded}\n", head()), "overhung-rigid", "drive");
    assert!(done && said.contains("line 2: pinion_line had the length 0.998449; it is scaled to 1"), "{said}");
    let line = bevelscope::design::read(&new).design.unwrap().mesh.pinion.line_of_action;
    assert!((line.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 3e-6);
    assert!((line[0] - 0.77 / 0.998_449).abs() < 2e-6);
}

#[test]
fn the_example_in_the_help_works() {
    let help = text(&bevelscope(&["import-mesh", "--help"]).stdout);
    let example: Vec<&str> = help.lines().skip_while(|line| !line.starts_with("flank,")).collect();
    let (done, _, said) = import(&example.join("\n"), "overhung-rigid", "drive");
    assert!(done && said.is_empty() && example.len() == 2, "{said}");
    for said in ["taken out where the design has it", "N/m", "mm, from the pinion's mesh station", "force on the gear"]
    {
        assert!(help.replace("\n  ", " ").contains(said), "{said}: {help}");
    }
}

#[test]
fn names_of_files_get_their_ending_or_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let made = bevelscope(&["new", &path("first")]);
    assert_eq!(text(&made.stdout).trim_end(), path("first.toml"));
    assert!(Path::new(&path("first.toml")).is_file() && !Path::new(&path("first")).exists());
    let refused = |arguments: &[&str], expected: &str| {
        let output = bevelscope(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(text(&output.stderr).contains(expected), "{}", text(&output.stderr));
    };
    let design = path("first.toml");
    for name in ["page.pdf", "page"] {
        refused(&["report", &design, "-o", &path(name)], "a name that ends in .html or .htm is wanted, or -");
        assert!(!Path::new(&path(name)).exists());
    }
    std::fs::create_dir(path("folder.html")).unwrap();
    refused(&["report", &design, "-o", &path("folder.html"), "--force"], "there is a folder of that name already");
    refused(&["new", &path("folder.html")], "there is a folder of that name already");
    refused(&["new", &design], "there is a file of that name already");
}

#[test]
fn wrong_numbers_are_answered_with_what_is_wanted() {
    for (arguments, expected) in [
        (&["new", "--pinion-teeth", "3.5"][..], "--pinion-teeth: a whole number from 5 to 100 is wanted"),
        (&["new", "--face-width-mm", "abc"], "--face-width-mm: "),
        (&["new", "--pinion-torque-n-m", "-5"], "--pinion-torque-n-m: "),
        (&["new", "--spiral-angle-deg", "-35"], "--spiral-angle-deg: "),
        (&["mesh-stiffness", "--face-width-mm", "-1"], "the face width must be greater than 0 mm"),
        (&["mesh-stiffness", "--face-width-mm", "abc"], "wanted a length in mm, greater than 0, such as 21.59"),
        (
            &["mesh-stiffness", "--face-width-mm", "20", "--spiral-angle-deg", "-5"],
            "the spiral angle must be from 0 to 80 deg",
        ),
        (&["check", "designs", "--max-rms-db", "-1"], "wanted a number, not negative, such as 3"),
        (&["bands", "designs/overhung-rigid.toml", "--tolerance", "-1"], "wanted a number, not negative"),
        (&["report", "designs/overhung-rigid.toml", "--tolerance", "-1"], "wanted a number, not negative"),
    ] {
        let output = bevelscope(arguments);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(
            said.contains(expected) && !said.contains("literal") && !said.contains("digit"),
            "{arguments:?}: {said}"
        );
    }
}

/// The greatest force on the lines of `solve`, which is above the highest peak where the force still rises at the end of the range.
#[test]
fn a_force_that_rises_to_the_end_of_the_range_is_not_hidden_by_a_peak() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("hb.toml").display().to_string();
    let wishes = ["--pinion-teeth", "19", "--gear-teeth", "57", "--normal-module-mm", "4", "--face-width-mm", "40"];
    let more = ["--spiral-angle-deg", "12", "--pinion-torque-n-m", "500"];
    let arguments: Vec<&str> = ["new", &path, "--kind", "helical"].into_iter().chain(wishes).chain(more).collect();
    assert!(bevelscope(&arguments).status.success());
    let json = |arguments: &[&str]| -> Value { serde_json::from_slice(&bevelscope(arguments).stdout).unwrap() };
    let checked = json(&["check", &path, "--format", "json"]);
    let solved = json(&["solve", &path, "--model", "fe", "--format", "json"]);
    let part = |key: &str| {
        let list = solved["models"]["fe"]["mesh_force_n"][key].as_array().unwrap();
        list.iter().map(|value| value.as_f64().unwrap()).collect::<Vec<_>>()
    };
    let greatest = part("re").iter().zip(part("im")).map(|(re, im)| re.hypot(im)).fold(0.0, f64::max);
    let row = &checked[0];
    assert!((row["fe_greatest"]["force_n"].as_f64().unwrap() / greatest - 1.0).abs() < 1e-12);
    assert_eq!(row["fe_greatest"]["frequency_hz"], 5000.0);
    assert!(row["fe_highest_peak"]["force_n"].as_f64().unwrap() < greatest);
    let table = text(&bevelscope(&["check", &path]).stdout);
    assert!(table.contains("hb: the FE force rises to ") && table.contains(" N at the end of the range, 5,000 Hz"));
    assert!(!text(&bevelscope(&["check", "designs/overhung-rigid.toml"]).stdout).contains("rises to"));
}
