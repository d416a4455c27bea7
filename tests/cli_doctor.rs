//! `bevelscope doctor`, from outside.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::SystemTime;

use bevelscope::design::library::{Journals, Locks};
use serde_json::Value;

fn doctor(home: &Path, arguments: &[&str], environment: &[(&str, &str)]) -> Output {
    let folder = |name: &str| home.join(name);
    Command::new(env!("CARGO_BIN_EXE_bevelscope"))
        .arg("doctor")
        .args(arguments)
        .current_dir(home)
        .env_clear()
        .env("HOME", home)
        .env("XDG_DATA_HOME", folder("data"))
        .env("XDG_CONFIG_HOME", folder("config"))
        .env("XDG_STATE_HOME", folder("state"))
        .envs(environment.iter().copied())
        .output()
        .unwrap()
}

fn json(home: &Path, arguments: &[&str], environment: &[(&str, &str)]) -> Value {
    let arguments: Vec<&str> = arguments.iter().copied().chain(["--format", "json"]).collect();
    let output = doctor(home, &arguments, environment);
    assert!(output.status.success(), "{output:?}");
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn the_table_fits_80_columns_and_nothing_in_it_steers_a_terminal() {
    let home = tempfile::tempdir().unwrap();
    let hostile = "x\u{1b}[31m\u{7}".repeat(20);
    let environment = [("TERM", hostile.as_str()), ("LANG", &hostile), ("COLORFGBG", &hostile), ("TERM_PROGRAM", "é")];
    let output = doctor(home.path(), &[], &environment);
    assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
    let text = String::from_utf8(output.stdout).unwrap();
    for line in text.lines() {
        assert!(line.chars().count() <= 80, "{line}");
        assert!(!line.chars().any(char::is_control), "{line:?}");
    }
    for part in ["version", "platform", "TERM", "ssh", "locale", "clipboard", "designs", "state", "key file"] {
        assert!(text.contains(part), "no {part} in\n{text}");
    }
    assert!(text.contains(env!("CARGO_PKG_VERSION")));
}

/// JSON escapes C0 by itself, but neither C1 nor what turns the direction of text.
#[test]
fn nothing_in_the_json_steers_a_terminal() {
    let home = tempfile::tempdir().unwrap();
    let hostile = "x\u{9b}2J\u{202e}\u{7f}";
    let output = doctor(home.path(), &["--format", "json"], &[("TERM", hostile)]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(!text.trim_end().contains(|c: char| c.is_control() || c == '\u{202e}'), "{text:?}");
    let json: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["terminal"]["TERM"], hostile);
}

#[test]
fn what_was_found_out_stands_with_its_reason() {
    type Variables<'a> = &'a [(&'a str, &'a str)];
    let home = tempfile::tempdir().unwrap();
    let terminal = |arguments: &[&str], environment: &[(&str, &str)], key: &str| {
        json(home.path(), arguments, environment)["terminal"][key].as_str().unwrap().to_owned()
    };
    let cases: [(Variables, &str, &str); 10] = [
        (&[("TERM", "xterm-256color")], "colours", "256: TERM says so"),
        (&[("TERM", "xterm-256color"), ("NO_COLOR", "1")], "colours", "none: NO_COLOR is set"),
        (&[("COLORTERM", "truecolor")], "colours", "16 million: COLORTERM says so"),
        (&[("COLORFGBG", "0;15")], "background", "light (COLORFGBG)"),
        (&[], "background", "unknown: colours for both (COLORFGBG is not set)"),
        (&[("LANG", "C.UTF-8")], "characters", "Unicode: the locale is UTF-8"),
        (&[("LC_ALL", "C"), ("LANG", "C.UTF-8")], "characters", "ASCII: the locale is not UTF-8"),
        (&[("LC_ALL", "C"), ("LANG", "C.UTF-8")], "locale", "C (LC_ALL)"),
        (&[("SSH_TTY", "/dev/pts/1")], "ssh", "yes"),
        (&[], "output_is_a_terminal", "no"),
    ];
    for (environment, key, expected) in cases {
        assert_eq!(terminal(&[], environment, key), expected);
    }
    assert_eq!(terminal(&["--ascii"], &[("LANG", "C.UTF-8")], "characters"), "ASCII: --ascii");
    assert!(terminal(&[], &[("TMUX", "/tmp/tmux")], "clipboard").contains("set-clipboard on"));
    assert!(terminal(&[], &[("STY", "1.a")], "clipboard").contains("GNU screen"));
}

#[test]
fn folders_are_tried_and_none_is_made() {
    let home = tempfile::tempdir().unwrap();
    let folders = |home: &Path| json(home, &[], &[])["folders"].clone();
    let found = folders(home.path());
    for name in ["designs", "configuration", "state"] {
        assert!(found[name].as_str().unwrap().ends_with("(not there yet, can be made)"), "{found}");
    }
    assert!(found["key_file"].as_str().unwrap().ends_with("keys.toml (not there: the shipped keys hold)"), "{found}");
    assert_eq!(std::fs::read_dir(home.path()).unwrap().count(), 0);

    std::fs::create_dir_all(home.path().join("config/bevelscope")).unwrap();
    std::fs::write(home.path().join("config/bevelscope/keys.toml"), "").unwrap();
    std::fs::create_dir(home.path().join("designs")).unwrap();
    // a file where the folder should be: permissions would stop no one who is root
    std::fs::create_dir(home.path().join("state")).unwrap();
    std::fs::write(home.path().join("state/bevelscope"), "").unwrap();
    let found = folders(home.path());
    assert!(found["designs"].as_str().unwrap().ends_with("designs (exists, can be written)"), "{found}");
    assert!(found["configuration"].as_str().unwrap().ends_with("bevelscope (exists, can be written)"), "{found}");
    assert!(found["state"].as_str().unwrap().ends_with("(is no folder)"), "{found}");
    assert!(found["key_file"].as_str().unwrap().ends_with("keys.toml (exists, can be written)"), "{found}");
    // what was tried has left nothing
    assert_eq!(std::fs::read_dir(home.path().join("designs")).unwrap().count(), 0);
    let named = json(home.path(), &["--keys", "mine.toml"], &[]);
    assert_eq!(named["folders"]["key_file"], "mine.toml (not there: the shipped keys hold)");
    // it has no end, and is not read
    let endless = json(home.path(), &["--keys", "/dev/zero"], &[]);
    assert_eq!(endless["folders"]["key_file"], "/dev/zero (is no plain file)");
}

/// Name, time of the last change and content of everything below a folder.
fn everything(folder: &Path) -> Vec<(PathBuf, SystemTime, Vec<u8>)> {
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            all.extend(everything(&path));
        } else {
            let changed = fs::metadata(&path).unwrap().modified().unwrap();
            all.push((path.clone(), changed, fs::read(&path).unwrap()));
        }
    }
    all.sort();
    all
}

#[test]
fn locks_and_journals_are_told_and_stay_as_they_are() {
    let home = tempfile::tempdir().unwrap();
    let (designs, recovery) = (home.path().join("designs"), home.path().join("state/bevelscope/recovery"));
    fs::create_dir(&designs).unwrap();
    let [open, left] = ["open.toml", "left.toml"].map(|name| designs.join(name));
    for design in [&open, &left] {
        fs::write(design, "old").unwrap();
    }
    let mut locks = Locks::default();
    assert_eq!(locks.hold(&open), None);
    let mut living = Journals::new(recovery.clone());
    living.keep(&open, "old", "mine").unwrap();
    let mut ended = Journals::new(recovery.clone());
    ended.keep(&left, "old", "theirs").unwrap();
    drop(ended);
    fs::write(recovery.join("damaged.journal"), "nonsense").unwrap();
    // a draft whose writer was killed a day ago: the next explorer may remove it
    let draft = recovery.join(".bevelscope.1.0.new");
    fs::write(&draft, "half").unwrap();
    fs::File::options().write(true).open(&draft).unwrap().set_modified(SystemTime::UNIX_EPOCH).unwrap();
    let before = everything(home.path());

    let report = json(home.path(), &[], &[])["designs_in_use"].clone();
    let rows: Vec<String> = report.as_object().unwrap().values().map(|row| row.as_str().unwrap().into()).collect();
    let about = |name: &str| rows.iter().filter(|row| row.contains(name)).cloned().collect::<Vec<_>>();
    if cfg!(target_os = "linux") {
        let held = format!("open.toml by process {} of", std::process::id());
        assert!(rows.iter().any(|row| row.contains(&held)), "{report}");
    }
    assert!(report["locks"].as_str().unwrap().starts_with("1 of 2 designs"), "{report}");
    assert!(report["journals"].as_str().unwrap().starts_with("3 in "), "{report}");
    assert!(about("open.toml").iter().any(|row| row.contains("of a program that runs")), "{report}");
    let [of_left] = &about("left.toml")[..] else { panic!("{report}") };
    assert!(
        of_left.contains("left by a program that ended") && of_left.contains(env!("CARGO_PKG_VERSION")),
        "{report}"
    );
    assert_eq!(about("damaged.journal").len(), 1, "{report}");
    // the edits themselves are nobody's business
    assert!(!rows.iter().any(|row| row.contains("mine") || row.contains("theirs")), "{report}");
    assert_eq!(everything(home.path()), before);
}
