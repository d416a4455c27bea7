//! Saving: the old file or the new one, whatever happens.

#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::fs;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use bevelscope::design::{SaveError, save, save_new};

/// Everything in a folder, hidden or not.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn folder() -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.toml");
    fs::write(&file, "old").unwrap();
    (folder, file)
}

#[test]
fn a_file_is_replaced_and_nothing_is_left_beside_it() {
    let (folder, file) = folder();
    for text in ["new", "", "newer\r\n"] {
        save(&file, text).unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), text);
    }
    save(&folder.path().join("b.toml"), "b").unwrap();
    assert_eq!(names(folder.path()), ["a.toml", "b.toml"]);
}

#[test]
fn permissions_stay() {
    let (_folder, file) = folder();
    for mode in [0o600, 0o640, 0o664, 0o777] {
        fs::set_permissions(&file, fs::Permissions::from_mode(mode)).unwrap();
        save(&file, "new").unwrap();
        assert_eq!(fs::metadata(&file).unwrap().mode() & 0o7777, mode);
    }
    // a new file has what any new file has here
    let other = file.with_file_name("b.toml");
    save(&other, "b").unwrap();
    let plain = file.with_file_name("c.toml");
    fs::write(&plain, "c").unwrap();
    assert_eq!(fs::metadata(other).unwrap().mode(), fs::metadata(plain).unwrap().mode());
}

#[test]
fn the_owner_stays_where_that_is_allowed() {
    let (_folder, file) = folder();
    if std::os::unix::fs::chown(&file, Some(12345), Some(12346)).is_err() {
        // only the superuser can try
        return;
    }
    save(&file, "new").unwrap();
    let now = fs::metadata(&file).unwrap();
    assert_eq!((now.uid(), now.gid()), (12345, 12346));
}

#[test]
fn links_stay_and_what_they_lead_to_is_replaced() {
    let (folder, file) = folder();
    let below = folder.path().join("links");
    fs::create_dir(&below).unwrap();
    symlink("../a.toml", below.join("one.toml")).unwrap();
    symlink("one.toml", below.join("two.toml")).unwrap();
    save(&below.join("two.toml"), "new").unwrap();
    assert_eq!(fs::read_to_string(&file).unwrap(), "new");
    assert!(fs::symlink_metadata(below.join("one.toml")).unwrap().is_symlink());
    symlink("../later.toml", below.join("three.toml")).unwrap();
    save(&below.join("three.toml"), "first").unwrap();
    assert_eq!(fs::read_to_string(folder.path().join("later.toml")).unwrap(), "first");
    symlink("round.toml", below.join("round.toml")).unwrap();
    assert!(save(&below.join("round.toml"), "x").unwrap_err().to_string().contains("too many links"));
    assert_eq!(names(&below), ["one.toml", "round.toml", "three.toml", "two.toml"]);
}

#[test]
fn what_cannot_be_saved_says_why_and_leaves_everything() {
    let (folder, file) = folder();
    let inside = folder.path().join("folder.toml");
    fs::create_dir(&inside).unwrap();
    assert!(matches!(save(&inside, "x"), Err(SaveError::Folder(_))));
    assert!(matches!(save(&folder.path().join("no/a.toml"), "x"), Err(SaveError::NoFolder(_))));
    // a file in place of the folder
    let below = file.join("b.toml");
    assert!(matches!(save(&below, "x"), Err(SaveError::NoFolder(_) | SaveError::Io { .. })));
    assert!(matches!(save(Path::new("/dev/full"), "x"), Err(SaveError::NoFile(_))));
    assert!(matches!(save_new(&file, "x"), Err(SaveError::Exists(_))));
    assert!(matches!(save_new(&inside, "x"), Err(SaveError::Exists(_))));
    symlink("nowhere", folder.path().join("dangling.toml")).unwrap();
    assert!(matches!(save_new(&folder.path().join("dangling.toml"), "x"), Err(SaveError::Exists(_))));
    fs::set_permissions(&file, fs::Permissions::from_mode(0o444)).unwrap();
    assert!(matches!(save(&file, "x"), Err(SaveError::ReadOnly(_))));
    // a folder in which nobody can make a file
    let error = save(Path::new("/proc/a.toml"), "x").unwrap_err().to_string();
    assert!(error.starts_with("/proc/a.toml: a file cannot be made in its folder: "), "{error}");
    assert_eq!(fs::read_to_string(&file).unwrap(), "old");
    assert_eq!(names(folder.path()), ["a.toml", "dangling.toml", "folder.toml"]);
}

#[test]
fn a_long_name_is_no_reason_to_fail() {
    let (folder, _) = folder();
    let long = folder.path().join(format!("{}.toml", "n".repeat(250)));
    save(&long, "x").unwrap();
    assert_eq!(fs::read_to_string(long).unwrap(), "x");
}

/// Set for the process that is to save: the file and how many bytes.
const CHILD: &str = "BEVELSCOPE_TEST_SAVES";

/// Not a test of its own: what the tests below start as a process.
#[test]
fn child() {
    let Ok(job) = std::env::var(CHILD) else { return };
    let (count, path) = job.split_once(' ').unwrap();
    let count: usize = count.parse().unwrap();
    if count == 0 {
        for round in 0_usize.. {
            save(Path::new(path), &content(round)).unwrap();
        }
    }
    let error = save(Path::new(path), &"x".repeat(count)).unwrap_err();
    assert!(error.to_string().contains("cannot be written"), "{error}");
}

/// One of the texts that the process writes: large enough to be caught half-way.
fn content(round: usize) -> String {
    let digit = (round % 10).to_string();
    digit.repeat(200_000 + (round % 10) * 1000)
}

fn start(job: &str, before: &str) -> Command {
    let mut command = Command::new("sh");
    let script = format!("{before}exec \"$0\" --exact child --test-threads 1");
    command.arg("-c").arg(script).arg(std::env::current_exe().unwrap()).env(CHILD, job);
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

// A limit on the size of files stops the superuser too, as a full disk does.
#[test]
fn a_full_disk_leaves_the_old_file() {
    let (folder, file) = folder();
    let job = format!("1000000 {}", file.display());
    // the signal that comes with the limit would end the process before it sees the error
    let status = start(&job, "trap '' XFSZ; ulimit -f 8; ").status().unwrap();
    assert!(status.success());
    assert_eq!(fs::read_to_string(&file).unwrap(), "old");
    assert_eq!(names(folder.path()), ["a.toml"]);
}

#[test]
fn a_reader_sees_whole_files_only_also_when_the_writer_is_killed() {
    let (_folder, file) = folder();
    let whole: Vec<String> = (0..10).map(content).collect();
    for run in 0..5 {
        let mut child = start(&format!("0 {}", file.display()), "").spawn().unwrap();
        let started = Instant::now();
        let mut seen = std::collections::BTreeSet::new();
        while started.elapsed() < Duration::from_millis(150 + 40 * run)
            || (seen.len() < 2 && started.elapsed().as_secs() < 20)
        {
            let text = fs::read_to_string(&file).unwrap();
            assert!(text == "old" || whole.contains(&text), "{} bytes", text.len());
            seen.insert(text.len());
        }
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(seen.len() > 1, "the writer wrote nothing");
        assert!(whole.contains(&fs::read_to_string(&file).unwrap()));
    }
}

/// How often a writer is killed; 1,000 takes some minutes.
const KILLS: &str = "BEVELSCOPE_TEST_KILLS";

#[test]
fn a_writer_killed_at_any_moment_leaves_the_old_file_or_the_new_one() {
    let kills = std::env::var(KILLS).ok().and_then(|count| count.parse().ok()).unwrap_or(100_u64);
    let (folder, file) = folder();
    let whole: Vec<String> = (0..10).map(content).collect();
    let mut drafts = 0;
    for kill in 0..kills {
        fs::write(&file, "old").unwrap();
        let mut child = start(&format!("0 {}", file.display()), "").spawn().unwrap();
        let deadline = Instant::now() + Duration::from_secs(20);
        while fs::metadata(&file).unwrap().len() == 3 && Instant::now() < deadline {
            std::thread::sleep(Duration::from_micros(200));
        }
        // spread over some savings, by a fraction that never repeats
        std::thread::sleep(Duration::from_micros(kill * 7919 % 9973));
        child.kill().unwrap();
        child.wait().unwrap();
        let text = fs::read_to_string(&file).unwrap();
        assert!(whole.contains(&text), "{} bytes after kill {kill}", text.len());
        // a while later
        for name in names(folder.path()).iter().filter(|name| *name != "a.toml") {
            drafts += 1;
            let draft = fs::File::open(folder.path().join(name)).unwrap();
            draft.set_modified(std::time::SystemTime::now() - Duration::from_secs(60)).unwrap();
        }
        assert!(names(folder.path()).len() <= 2, "what earlier ones have left was cleared: {:?}", names(folder.path()));
    }
    assert!(drafts > 0, "no writer was caught half-way");
    save(&file, "last").unwrap();
    assert_eq!(names(folder.path()), ["a.toml"]);
}
