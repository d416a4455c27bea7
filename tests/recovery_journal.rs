//! Journals of unsaved edits and locks on design files: whole or not at all, and never those of somebody who lives.

#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::fs;
use std::io::{BufRead, BufReader};
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use bevelscope::design::library::{
    DISCARDED, Journal, JournalError, Journals, Left, Locks, OnDisk, discard_journal, holder, journals, left_edits,
};
use bevelscope::design::{SaveError, save};
use proptest::prelude::*;

fn journal(design: &str, base: &str, text: &str) -> Journal {
    Journal {
        design: design.into(),
        when: UNIX_EPOCH + Duration::from_secs(1_735_689_600),
        program: "0.1.0".into(),
        base: base.into(),
        text: text.into(),
    }
}

fn small() -> Journal {
    journal("/designs/ä b\n.toml", "a = 1\r\n", "a = 2 # two\n")
}

/// Names of the files in a folder, hidden ones too.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

proptest! {
    #[test]
    fn what_was_written_is_read(path in "/[^\0]{1,40}", base in ".{0,200}", text in "(?s).{0,200}", seconds in 0_u64..1 << 33) {
        let mut journal = journal(&path, &base, &text);
        journal.when = UNIX_EPOCH + Duration::from_secs(seconds);
        prop_assert_eq!(Journal::decode(&journal.encode()).unwrap(), journal);
    }

    #[test]
    fn nonsense_is_no_journal(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        prop_assert!(Journal::decode(&bytes).is_err());
    }
}

#[test]
fn a_path_need_not_be_text() {
    use std::os::unix::ffi::OsStrExt;
    let mut journal = small();
    journal.design = PathBuf::from(std::ffi::OsStr::from_bytes(b"/designs/\xff.toml"));
    assert_eq!(Journal::decode(&journal.encode()).unwrap(), journal);
}

#[test]
fn damage_never_gives_a_wrong_text() {
    let whole = small().encode();
    for length in 0..whole.len() {
        assert!(Journal::decode(&whole[..length]).is_err(), "cut to {length} bytes");
    }
    for at in 0..whole.len() {
        for bit in 0..8 {
            let mut bytes = whole.clone();
            bytes[at] ^= 1 << bit;
            assert!(Journal::decode(&bytes).is_err(), "bit {bit} of byte {at}");
        }
    }
    let longer = [&whole[..], b"\n"].concat();
    assert!(matches!(Journal::decode(&longer), Err(JournalError::Damaged)));
    let later = String::from_utf8(whole).unwrap().replacen("journal 1", "journal 2", 1);
    assert!(matches!(Journal::decode(later.as_bytes()), Err(JournalError::Version(2))));
}

#[test]
fn a_design_has_one_journal_which_is_private_and_goes() {
    let folder = tempfile::tempdir().unwrap();
    let state = folder.path().join("state/bevelscope/recovery");
    let design = folder.path().join("a.toml");
    let mut own = Journals::new(state.clone());
    for text in ["1", "2", "3"] {
        own.keep(&design, "0", text).unwrap();
    }
    own.keep(&folder.path().join("b.toml"), "0", "1").unwrap();
    let found = journals(&state);
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(found.iter().all(|found| found.is_alive));
    let of_a = found.iter().find(|found| found.journal.as_ref().unwrap().design.ends_with("a.toml")).unwrap();
    let journal = of_a.journal.as_ref().unwrap();
    assert_eq!((journal.base.as_str(), journal.text.as_str()), ("0", "3"));
    assert!(journal.design.is_absolute());
    assert!(journal.when.elapsed().unwrap() < Duration::from_secs(60));
    let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode() & 0o777;
    assert_eq!((mode(&state), mode(&of_a.path)), (0o700, 0o600));
    own.forget(&design).unwrap();
    assert_eq!(names(&state).len(), 1);
    own.discard(&folder.path().join("b.toml")).unwrap();
    assert_eq!(names(&state), [DISCARDED]);
    assert_eq!(names(&state.join(DISCARDED)).len(), 1);
    // nothing is left to be removed
    own.forget(&design).unwrap();
}

#[test]
fn only_the_newest_discarded_ones_are_kept() {
    let folder = tempfile::tempdir().unwrap();
    for number in 0..30 {
        let path = folder.path().join(format!("{number:02}.journal"));
        fs::write(&path, small().encode()).unwrap();
        let then = SystemTime::now() - Duration::from_secs(1000 - number);
        fs::File::open(&path).unwrap().set_modified(then).unwrap();
        discard_journal(&path).unwrap();
    }
    let kept: Vec<String> = (10..30).map(|number| format!("{number}.journal")).collect();
    assert_eq!(names(&folder.path().join(DISCARDED)), kept);
}

#[test]
fn what_cannot_be_written_says_why() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    let design = folder.path().join("a.toml");
    let error = Journals::new(file.join("recovery")).keep(&design, "", "x").unwrap_err().to_string();
    assert!(error.contains("the folder cannot be made"), "{error}");
    let mut own = Journals::new(folder.path().join("recovery"));
    own.keep(&design, "", "x").unwrap();
    // a folder in place of the journal
    let journal = journals(&folder.path().join("recovery"))[0].path.clone();
    fs::remove_file(&journal).unwrap();
    fs::create_dir_all(journal.join("inside")).unwrap();
    let error = own.keep(&design, "", "y").unwrap_err().to_string();
    assert!(error.contains("cannot be replaced"), "{error}");
    assert_eq!(names(&folder.path().join("recovery")).len(), 1, "no draft is left");
    assert!(journals(&folder.path().join("recovery")).is_empty());
}

/// Left behind by a process that is gone: nobody holds the lock.
fn leave(state: &Path, name: &str, journal: &Journal) -> PathBuf {
    fs::create_dir_all(state).unwrap();
    let path = state.join(name);
    fs::write(&path, journal.encode()).unwrap();
    path
}

#[test]
fn what_is_left_is_found_for_the_library_only() {
    let folder = tempfile::tempdir().unwrap();
    let (state, designs) = (folder.path().join("state"), folder.path().join("designs"));
    fs::create_dir(&designs).unwrap();
    let real = fs::canonicalize(&designs).unwrap();
    let design = |name: &str| real.join(name).display().to_string();
    for name in ["changed", "same", "saved"] {
        fs::write(designs.join(format!("{name}.toml")), format!("{name} = 1\n")).unwrap();
    }
    leave(&state, "1.journal", &journal(&design("changed.toml"), "base", "mine"));
    leave(&state, "2.journal", &journal(&design("same.toml"), "same = 1\n", "mine"));
    leave(&state, "3.journal", &journal(&design("gone.toml"), "base", "mine"));
    leave(&state, "4.journal", &journal("/elsewhere/a.toml", "base", "mine"));
    let saved = leave(&state, "5.journal", &journal(&design("saved.toml"), "base", "saved = 1\n"));
    fs::write(state.join("6.journal"), "\x1b[31mnothing of this").unwrap();
    fs::create_dir(state.join("7.journal")).unwrap();
    let mut own = Journals::new(state.clone());
    own.keep(&designs.join("alive.toml"), "base", "mine").unwrap();
    let files: Vec<PathBuf> = ["changed.toml", "same.toml", "saved.toml"].map(|name| designs.join(name)).into();
    let left = left_edits(&state, &files, std::slice::from_ref(&designs));
    let mut found: Vec<_> = left.edits.iter().map(|edits| (edits.path.clone(), edits.on_disk.clone())).collect();
    found.sort_by(|a, b| a.0.cmp(&b.0));
    let expected = [
        (designs.join("changed.toml"), OnDisk::Text("changed = 1\n".into())),
        (designs.join("gone.toml"), OnDisk::Gone),
        (designs.join("same.toml"), OnDisk::Text("same = 1\n".into())),
    ];
    assert_eq!(found, expected);
    assert!(left.edits[0].when.starts_with("2025-01-01 00:00:00 UTC, "), "{}", left.edits[0].when);
    assert_eq!(left.elsewhere, [PathBuf::from("/elsewhere/a.toml")]);
    assert!(!saved.exists(), "its edits are in the file");
    assert_eq!(left.damaged.len(), 1);
    assert!(left.damaged[0].contains("6.journal") && left.damaged[0].contains("6.journal.damaged now"));
    assert!(!left.damaged[0].contains("nothing of this"));
    assert_eq!(fs::read(state.join("6.journal.damaged")).unwrap(), b"\x1b[31mnothing of this");
    // a file that is named, its folder not
    let named = left_edits(&state, &files[..1], &[]);
    assert_eq!((named.edits.len(), named.elsewhere.len(), named.damaged.len()), (1, 3, 0));
    // a folder that is not there has nothing
    assert_eq!(left_edits(&folder.path().join("no"), &files, &[]), Left::default());
}

#[test]
fn stale_drafts_are_removed_and_those_of_the_living_are_not() {
    let folder = tempfile::tempdir().unwrap();
    let draft = |name: &str| folder.path().join(name);
    let old = SystemTime::now() - Duration::from_secs(60);
    let make = |name: &str| {
        let file = fs::File::create(draft(name)).unwrap();
        file.set_modified(old).unwrap();
        file
    };
    drop(make(".bevelscope.1.0.new"));
    let living = make(".bevelscope.1.1.new");
    living.lock().unwrap();
    fs::write(draft(".bevelscope.1.2.new"), "just made").unwrap();
    drop(make("other.new"));
    save(&draft("a.toml"), "a").unwrap();
    let left = [".bevelscope.1.1.new", ".bevelscope.1.2.new", "a.toml", "other.new"];
    assert_eq!(names(folder.path()), left);
    // looking at journals changes nothing; looking for what is left does
    drop(make(".bevelscope.1.3.new"));
    assert!(journals(folder.path()).is_empty());
    assert!(draft(".bevelscope.1.3.new").exists());
    assert_eq!(left_edits(folder.path(), &[], &[]), Left::default());
    assert_eq!(names(folder.path()), left);
}

const CHILD: &str = "BEVELSCOPE_TEST_HOLDS";

/// Not a test of its own: a process that keeps a journal and holds a design until it is killed.
#[test]
fn child() {
    let Ok(folder) = std::env::var(CHILD) else { return };
    let design = Path::new(&folder).join("a.toml");
    let mut locks = Locks::default();
    assert_eq!(locks.hold(&design), None);
    let mut own = Journals::new(Path::new(&folder).join("state"));
    own.keep(&design, "old", "mine").unwrap();
    println!("\nready");
    std::thread::sleep(Duration::from_secs(60));
}

fn start(folder: &Path) -> Child {
    let mut command = Command::new(std::env::current_exe().unwrap());
    command.args(["--exact", "child", "--nocapture", "--test-threads=1"]).env(CHILD, folder);
    let mut child = command.stdin(Stdio::null()).stdout(Stdio::piped()).spawn().unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    assert!(lines.any(|line| line.unwrap() == "ready"));
    child
}

#[test]
fn a_lock_ends_with_its_owner() {
    let folder = tempfile::tempdir().unwrap();
    let (design, state) = (folder.path().join("a.toml"), folder.path().join("state"));
    fs::write(&design, "old").unwrap();
    let mut child = start(folder.path());
    assert!(journals(&state)[0].is_alive);
    assert_eq!(left_edits(&state, std::slice::from_ref(&design), &[]), Left::default());
    let who = holder(&design).unwrap();
    #[cfg(target_os = "linux")]
    {
        assert_eq!(who.process, Some(child.id()));
        let user = who.user.clone().unwrap();
        assert!(who.to_string().starts_with(&format!("process {} of {user}", child.id())));
    }
    let mut locks = Locks::default();
    assert_eq!(locks.hold(&design), Some(who));
    // also by another name
    std::os::unix::fs::symlink("a.toml", folder.path().join("link.toml")).unwrap();
    assert!(holder(&folder.path().join("link.toml")).is_some());
    // the lock keeps nobody from saving, and what is saved is locked by who saved it
    locks.save(&design, Some(b"old"), "new").unwrap();
    assert_eq!(holder(&design).unwrap().process, cfg!(target_os = "linux").then(std::process::id));
    locks.release(&design);
    assert_eq!(holder(&design), None);
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(!journals(&state)[0].is_alive);
    assert_eq!(left_edits(&state, std::slice::from_ref(&design), &[]).edits.len(), 1);
}

#[test]
fn saving_keeps_the_lock_and_looks_at_the_file_first() {
    let folder = tempfile::tempdir().unwrap();
    let design = folder.path().join("a.toml");
    fs::write(&design, "old").unwrap();
    let mut locks = Locks::default();
    assert_eq!(locks.hold(&design), None);
    locks.save(&design, Some(b"old"), "new").unwrap();
    assert!(holder(&design).is_some());
    assert_eq!(locks.hold(&design), None);
    // somebody else puts another file in its place
    save(&design, "theirs").unwrap();
    let error = locks.save(&design, Some(b"new"), "mine").unwrap_err();
    assert!(matches!(error, SaveError::Changed(_, Some(now)) if now == b"theirs"));
    assert_eq!(fs::read(&design).unwrap(), b"theirs");
    assert_eq!(holder(&design), None, "the lock is of the file that is gone");
    assert_eq!(locks.hold(&design), None);
    assert!(holder(&design).is_some(), "locked again");
    // the same text is no conflict
    locks.save(&design, Some(b"new"), "theirs").unwrap();
    // a file that is gone is not made by mistake, and one that came back is not overwritten
    fs::remove_file(&design).unwrap();
    assert!(matches!(locks.save(&design, Some(b"theirs"), "mine"), Err(SaveError::Changed(_, None))));
    locks.save(&design, None, "mine").unwrap();
    assert!(matches!(locks.save(&design, None, "again"), Err(SaveError::Changed(_, Some(now))) if now == b"mine"));
    assert_eq!(names(folder.path()), ["a.toml"]);
    // what cannot be locked has no holder
    assert_eq!(locks.hold(Path::new("/dev/null")), None);
    assert_eq!(locks.hold(folder.path()), None);
    assert_eq!(holder(&folder.path().join("no.toml")), None);
}
