//! The invariants at the top of `src/lib.rs`, as far as they can be read off the sources and the output.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::fs;
use std::path::{Path, PathBuf};

use bevelscope::commands::Cli;
use clap::Parser;
use serde_json::Value;

/// All sources below `src`, with their tests and comments cut off, by their path below `src`.
fn sources() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut folders = vec![root.clone()];
    let mut files: Vec<PathBuf> = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() { folders.push(path) } else { files.push(path) }
        }
    }
    assert!(files.len() > 50, "the sources are there");
    let code = |path: PathBuf| {
        let text = fs::read_to_string(&path).unwrap();
        let text = text.split("#[cfg(test)]").next().unwrap();
        let code = |line: &&str| !line.trim_start().starts_with("//");
        let name = path.strip_prefix(&root).unwrap().display().to_string();
        (name, text.lines().filter(code).collect::<Vec<_>>().join("\n"))
    };
    files.into_iter().map(code).collect()
}

fn assert_absent(words: &[&str], concerned: impl Fn(&str) -> bool) {
    let mut seen = 0;
    for (name, code) in sources().iter().filter(|(name, _)| concerned(name)) {
        seen += 1;
        for word in words {
            assert!(!code.contains(word), "src/{name} has `{word}`");
        }
    }
    assert!(seen > 0);
}

#[test]
fn only_the_explorer_knows_the_terminal_libraries() {
    assert_absent(&["ratatui", "crossterm"], |name| !name.starts_with("tui/"));
}

#[test]
fn the_mechanics_touch_no_file_and_no_terminal() {
    let mechanics = ["bearing", "gear", "pair", "rotor", "model", "response", "agreement"];
    let concerned = |name: &str| mechanics.iter().any(|part| name.starts_with(&format!("{part}/")));
    assert_absent(&["print!", "println!", "eprint"], concerned);
    for (name, code) in sources().iter().filter(|(name, _)| concerned(name)) {
        for module in code.split("std::").skip(1).flat_map(modules) {
            let is_outside = ["fs", "io", "env", "process", "thread", "net"].contains(&module.as_str());
            assert!(!is_outside, "src/{name} names std::{module}");
        }
    }
}

#[test]
fn no_panic_is_written_outside_tests() {
    let words = [".unwrap()", ".expect(", "panic!(", "unreachable!(", "todo!(", "unimplemented!("];
    assert_absent(&words, |_| true);
}

/// Keys whose numbers have no unit, or several that the documentation gives.
const WITHOUT_UNIT: [&str; 27] = [
    // of the gear to the pinion
    "torque_arm_ratio",
    "tooth_ratio",
    "elements",
    "loaded_elements",
    "line_of_action",
    "fe",
    "lumped",
    // rows of the MAC matrix of a model
    "enhanced",
    "basic",
    "coordinates",
    "lateral",
    "axial",
    "tilt",
    "torsion",
    "frac",
    "mac",
    "fe_mode",
    "energy_residual",
    "mesh_strain_share",
    "share",
    "mode_share",
    "participation",
    "participation_ratio",
    "lumped_mode",
    // 6x6, N/m, N and N m/rad
    "stiffness",
    // values of any key of a design file; `unit` stands beside them
    "a",
    "b",
];
const UNITS: [&str; 13] =
    ["_um", "_deg", "_rad", "_mrad", "_hz", "_n", "_m", "_mm", "_kg", "_kg_m2", "_db", "_percent", "_stiffness"];

#[test]
fn every_number_in_json_has_a_unit_in_its_key() {
    let design = concat!(env!("CARGO_MANIFEST_DIR"), "/designs/straddle-elastic.toml");
    let other = concat!(env!("CARGO_MANIFEST_DIR"), "/designs/overhung-rigid.toml");
    for command in ["solve", "modes", "inspect", "check", "compare", "bands"] {
        let mut out = Vec::new();
        let files = match command {
            "compare" => vec![design, other],
            "solve" => vec![design, "--bearing-forces"],
            "modes" => vec![design, "--shapes"],
            _ => vec![design],
        };
        let arguments = ["bevelscope", command].into_iter().chain(files).chain(["--format", "json"]);
        let cli = Cli::try_parse_from(arguments).unwrap();
        cli.run(&mut out, std::io::sink()).unwrap();
        let mut numbers = 0;
        look_at_keys(&serde_json::from_slice(&out).unwrap(), "", &mut numbers);
        assert!(numbers > 20, "{command}: {numbers}");
    }
}

fn look_at_keys(value: &Value, key: &str, numbers: &mut usize) {
    match value {
        Value::Object(fields) => {
            for (name, value) in fields {
                // the two parts of a complex number have the unit of the whole
                let key = if ["re", "im"].contains(&name.as_str()) { key } else { name };
                look_at_keys(value, key, numbers);
            }
        }
        Value::Array(values) => values.iter().for_each(|value| look_at_keys(value, key, numbers)),
        Value::Number(_) => {
            *numbers += 1;
            let named = WITHOUT_UNIT.contains(&key) || UNITS.iter().any(|unit| key.ends_with(unit));
            assert!(named, "`{key}` has a number and no unit");
        }
        _ => {}
    }
}

/// The data flow of ARCHITECTURE.md: which modules of the crate each part may name.
#[test]
fn modules_know_what_the_architecture_says() {
    const MAY_KNOW: [(&str, &[&str]); 16] = [
        ("units/", &["units", "text"]),
        ("text.rs", &[]),
        ("number.rs", &[]),
        ("bearing/", &["bearing"]),
        ("gear/", &["gear", "text"]),
        ("design/", &["design", "units", "text", "number", "moment", "rotor", "bearing", "gear"]),
        ("pair/", &["pair", "design", "gear", "rotor", "document", "number"]),
        ("rotor/", &["rotor", "design", "bearing"]),
        ("model/", &["model", "rotor", "design"]),
        ("response/", &["response", "model", "rotor", "design"]),
        ("agreement/", &["agreement", "response", "model", "rotor", "design"]),
        ("comparison.rs", &["agreement", "response", "model", "rotor", "design"]),
        ("document/", &["document"]),
        (
            "report/",
            &["report", "pair", "document", "agreement", "comparison", "response", "model", "design", "number", "text"],
        ),
        (
            "commands/",
            &[
                "commands",
                "tui",
                "report",
                "comparison",
                "agreement",
                "response",
                "model",
                "rotor",
                "bearing",
                "gear",
                "pair",
                "design",
                "document",
                "number",
                "text",
                "units",
                "log",
                "crash",
                "moment",
            ],
        ),
        (
            "tui/",
            &[
                "tui",
                "agreement",
                "bearing",
                "comparison",
                "design",
                "document",
                "gear",
                "model",
                "pair",
                "number",
                "rotor",
                "text",
                "units",
                "response",
                "log",
                "crash",
            ],
        ),
    ];
    for (name, code) in sources() {
        let Some((_, allowed)) = MAY_KNOW.iter().find(|(part, _)| name.starts_with(part)) else { continue };
        for module in code.split("crate::").skip(1).flat_map(modules) {
            assert!(allowed.contains(&module.as_str()), "src/{name} names crate::{module}");
        }
    }
}

/// What stands behind `crate::`: one name, or the first of each in braces; none in `crate::Name`.
fn modules(rest: &str) -> Vec<String> {
    let first =
        |text: &str| text.trim().chars().take_while(|c| c.is_ascii_lowercase() || *c == '_').collect::<String>();
    let Some(inside) = rest.strip_prefix('{') else {
        return [first(rest)].into_iter().filter(|m| !m.is_empty()).collect();
    };
    let (mut depth, mut names, mut name) = (0, Vec::new(), String::new());
    for c in inside.chars() {
        match c {
            '}' if depth == 0 => break,
            ',' if depth == 0 => names.push(std::mem::take(&mut name)),
            '{' => depth += 1,
            '}' => depth -= 1,
            _ if depth == 0 => name.push(c),
            _ => {}
        }
    }
    names.push(name);
    names.iter().map(|name| first(name)).filter(|name| !name.is_empty()).collect()
}

#[test]
fn modules_in_braces_are_seen() {
    assert_eq!(modules("{design, tui::keys};"), ["design", "tui"]);
    assert_eq!(modules("{log::{a, b}, moment, Name};\nuse x"), ["log", "moment"]);
    assert_eq!(modules("text::printable;"), ["text"]);
    assert!(modules("Name;").is_empty());
}

/// Files that the documentation sends its readers to.
#[test]
fn files_named_in_the_documentation_exist() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for document in ["README.md", "ARCHITECTURE.md", "src/lib.rs"] {
        let text = fs::read_to_string(root.join(document)).unwrap();
        for name in text.split('`').skip(1).step_by(2) {
            let is_path =
                ["src/", "tests/", "benches/", "docs/", "designs/"].iter().any(|folder| name.starts_with(folder));
            if is_path && !name.contains(['*', ' ', '#']) {
                assert!(root.join(name).exists(), "{document} names {name}");
            }
        }
    }
}
