//! Every file of `tests/fixtures/keys/valid` is read without an error, every file of `invalid` gives exactly the errors that it
//! expects: `# expect: LINE:COLUMN: part of the message`. In both, `# holds: MODE KEY ACTION` says what is in force.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use bevelscope::design::Source;
use bevelscope::tui::action::Action;
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::keys::{Bound, Key, Keys, read};

fn fixtures(folder: &str) -> Vec<(PathBuf, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/keys").join(folder);
    let mut files: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    assert!(files.len() > 3);
    files.into_iter().map(|path| (fs::read_to_string(&path).unwrap(), path)).map(|(text, path)| (path, text)).collect()
}

fn assert_as_expected(path: &Path, text: &str) {
    let remapped = read(text);
    let source = Source::new("keys.toml", text);
    let mut left: Vec<String> = remapped.findings.iter().map(|finding| source.render(finding)).collect();
    for expected in text.lines().filter_map(|line| line.strip_prefix("# expect: ")) {
        let (place, message) = expected.split_once(": ").unwrap_or((expected.trim_end_matches(':'), ""));
        let fits = |shown: &String| shown.starts_with(&format!("keys.toml:{place}:")) && shown.contains(message);
        let found = left.iter().position(fits);
        assert!(found.is_some(), "{}: not found: {expected}\n{}", path.display(), left.concat());
        left.remove(found.unwrap());
    }
    assert!(left.is_empty(), "{}: not expected:\n{}", path.display(), left.concat());
    for holds in text.lines().filter_map(|line| line.strip_prefix("# holds: ")) {
        let [mode, key, action] = holds.split(' ').collect::<Vec<_>>()[..] else { panic!("{holds}") };
        let mode = Mode::ALL.into_iter().find(|known| known.name() == mode).unwrap();
        let key = Key::parse(key).unwrap();
        let bound = remapped.keys.bound().iter().find(|bound| bound.mode == mode && bound.key == key);
        let found = bound.map_or("none", |bound| bound.action.name());
        assert_eq!(found, action, "{}: {holds}", path.display());
    }
}

#[test]
fn valid_files_hold() {
    for (path, text) in fixtures("valid") {
        assert!(!text.contains("# expect: "));
        assert_as_expected(&path, &text);
    }
}

#[test]
fn invalid_files_give_the_errors_they_expect_and_the_other_lines_hold() {
    for (path, text) in fixtures("invalid") {
        assert!(text.contains("# expect: "));
        assert_as_expected(&path, &text);
    }
}

#[test]
fn slips_are_mended_with_the_nearest_name() {
    for (text, hint) in [
        ("[library]\na = \"renam\"", "did you mean `rename`?"),
        ("[library]\na = \"toggle_tree\"", "did you mean `toggle-tree`?"),
        ("[libary]\na = \"mark\"", "did you mean `library`?"),
    ] {
        let finding = read(text).findings.remove(0);
        assert!(finding.hint.as_ref().unwrap().contains(hint), "{finding:?}");
    }
}

/// A file that takes every key of a mode.
fn nothing_in(mode: Mode) -> String {
    let keys =
        Keys::default().bound().iter().filter(|bound| bound.mode == mode).map(|bound| bound.key).collect::<Vec<_>>();
    let lines: Vec<String> = keys.iter().map(|key| format!("{:?} = \"none\"\n", key.shown(true))).collect();
    format!("[{}]\n{}", mode.name(), lines.concat())
}

/// Whatever is in the file, there is a way to quit and to the help; and without the palette, a way to all that only this
/// mode has.
#[test]
fn no_file_strands_anyone() {
    let has = |keys: &Keys, mode: Mode, action: Action| {
        keys.bound().iter().any(|bound| bound.mode == mode && bound.action == action)
    };
    let keys = read(&Mode::ALL.map(nothing_in).concat()).keys;
    for mode in Mode::ALL {
        let palette = has(&Keys::default(), mode, Action::Palette);
        for Bound { action, .. } in Keys::default().bound().iter().filter(|bound| bound.mode == mode) {
            let everywhere = Mode::ALL.into_iter().all(|mode| has(&Keys::default(), mode, *action));
            let basic = matches!(action, Action::Quit | Action::Help | Action::Back | Action::Palette);
            let kept = basic || (!palette && !everywhere);
            assert_eq!(has(&keys, mode, *action), kept, "{action:?} in {mode:?}");
        }
    }
    for (mode, key, action) in [
        ("form", "enter", "save-form"),
        ("choice", "enter", "choose"),
        ("leave", "s", "save-all"),
        ("name", "enter", "accept"),
    ] {
        let findings = read(&format!("[{mode}]\n{key} = \"none\"\n")).findings;
        let expected = format!("this would leave no key for `{action}` in [{mode}]");
        assert_eq!(findings.first().map(|finding| finding.message.as_str()), Some(expected.as_str()));
    }
}

/// A line for all modes holds where nobody misses the key.
#[test]
fn a_line_for_all_modes_leaves_a_question_its_answer() {
    let action = |keys: &Keys, mode: &str, key: &str| {
        let key = Key::parse(key).unwrap();
        let found = keys.bound().iter().find(|bound| bound.mode.name() == mode && bound.key == key);
        found.map(|bound| bound.action)
    };
    let remapped = read("[all]\ns = \"none\"\n");
    assert_eq!(remapped.findings, []);
    assert_eq!(action(&remapped.keys, "table", "s"), None);
    assert_eq!(action(&remapped.keys, "leave", "s"), Some(Action::SaveAll));
}

/// With ASCII as it is, otherwise with arrows in place of four names.
#[test]
fn every_key_that_is_shown_can_be_written() {
    for bound in Keys::default().bound() {
        assert_eq!(Key::parse(&bound.key.shown(true)), Ok(bound.key));
        let shown = bound.key.shown(false);
        match ['↑', '↓', '←', '→'].iter().position(|arrow| shown.contains(*arrow)) {
            Some(at) => assert_eq!(bound.key.shown(true), ["Up", "Down", "Left", "Right"][at]),
            None => assert_eq!(Key::parse(&shown), Ok(bound.key)),
        }
    }
}

fn bevelscope(arguments: &[&str], config: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_bevelscope"))
        .args(arguments)
        .env("XDG_CONFIG_HOME", config)
        .env("HOME", config)
        .output()
        .unwrap()
}

#[test]
fn the_command_checks_a_file_and_prints_what_is_in_force() {
    let config = tempfile::tempdir().unwrap();
    let text = |output: &[u8]| String::from_utf8(output.to_vec()).unwrap();
    for (folder, status) in [("valid", 0), ("invalid", 2)] {
        for (path, _) in fixtures(folder) {
            let output = bevelscope(&["keys", "--check", path.to_str().unwrap()], config.path());
            assert_eq!(output.status.code(), Some(status), "{}: {}", path.display(), text(&output.stderr));
            assert_eq!(output.stdout.is_empty(), status == 2);
            let harmful = |c: char| c != '\n' && bevelscope::text::is_unprintable(c);
            assert!(!text(&output.stderr).contains(harmful));
        }
    }
    let path = config.path().join("my-keys.toml");
    fs::write(&path, "[library]\nf6 = \"mark\"\nf7 = \"nonsense\"\n").unwrap();
    let output = bevelscope(&["keys", "--keys", path.to_str().unwrap()], config.path());
    assert_eq!(output.status.code(), Some(0));
    assert!(text(&output.stdout).contains("F6 m"), "{}", text(&output.stdout));
    assert!(text(&output.stderr).contains("my-keys.toml:3:6: error: there is no action `nonsense`"));
    assert!(text(&output.stdout).lines().all(|line| line.chars().count() <= 80));
    for (arguments, words) in [
        (vec!["keys", "--check", "no-such.toml"], "no-such.toml"),
        (vec!["keys", "--keys", config.path().to_str().unwrap()], "this is a folder"),
        (vec!["--keys", "no-such.toml"], "no-such.toml"),
    ] {
        let output = bevelscope(&arguments, config.path());
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(text(&output.stderr).contains(words), "{arguments:?}: {}", text(&output.stderr));
    }
}

/// A file that never ends is no file of keys.
#[cfg(target_os = "linux")]
#[test]
fn no_more_is_read_than_a_file_of_keys_may_have() {
    let config = tempfile::tempdir().unwrap();
    for option in ["--keys", "--check"] {
        let output = bevelscope(&["keys", option, "/dev/zero"], config.path());
        assert_eq!(output.status.code(), Some(2), "{option}");
        let error = String::from_utf8(output.stderr).unwrap();
        assert!(error.contains("larger than 1 MiB"), "{error}");
    }
}

/// The user's own file, where the system looks for such files.
#[cfg(target_os = "linux")]
#[test]
fn the_users_file_is_found() {
    let config = tempfile::tempdir().unwrap();
    fs::create_dir(config.path().join("bevelscope")).unwrap();
    fs::write(config.path().join("bevelscope/keys.toml"), "[library]\nf9 = \"rename\"\n").unwrap();
    let output = bevelscope(&["keys"], config.path());
    assert!(String::from_utf8(output.stdout).unwrap().contains("F9 r"));
}
