//! Folders of designs, and the library of the first use.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::fs;
use std::path::{Path, PathBuf};

use bevelscope::design::library::{DefaultFolder, LibraryError, SHIPPED, default_folder_in, files};
use bevelscope::design::{LoadError, load};

fn manifest(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

#[test]
fn every_shipped_design_is_compiled_in_and_reads_without_a_warning() {
    let names: Vec<&str> = SHIPPED.iter().map(|shipped| shipped.file_name).collect();
    let on_disk = files(&[manifest("designs")]);
    let on_disk: Vec<_> = on_disk.iter().map(|path| path.file_name().unwrap().to_str().unwrap()).collect();
    assert_eq!(names, on_disk);
    for path in files(&[manifest("designs")]) {
        assert_eq!(load(&path).unwrap().warnings, []);
    }
}

// The cases hold the same designs with the figures of an independent solver.
#[test]
fn shipped_designs_say_what_the_reference_cases_say() {
    // the first three are those of the paper
    for shipped in &SHIPPED[..3] {
        let case = load(&manifest("tests/fixtures/cases").join(shipped.file_name)).unwrap();
        let design = load(&manifest("designs").join(shipped.file_name)).unwrap();
        assert_eq!(design.design, case.design, "{}", shipped.file_name);
    }
}

#[test]
fn files_come_in_the_order_given_and_folders_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let in_folder = |name: &str| folder.path().join(name);
    for name in ["b.toml", "a.toml", ".hidden.toml", "notes.txt", "c.toml.bak"] {
        fs::write(in_folder(name), SHIPPED[0].text).unwrap();
    }
    fs::create_dir(in_folder("below.toml")).unwrap();
    fs::create_dir(in_folder("below")).unwrap();
    fs::write(in_folder("below/d.toml"), "").unwrap();
    let single = in_folder("below/d.toml");
    let missing = in_folder("missing.toml");
    let listed = files(&[single.clone(), folder.path().to_path_buf(), missing.clone()]);
    assert_eq!(listed, [single, in_folder("a.toml"), in_folder("b.toml"), missing]);
}

// Opening it would wait for a writer that never comes.
#[cfg(unix)]
#[test]
fn a_pipe_among_the_designs_is_no_design() {
    let folder = tempfile::tempdir().unwrap();
    let design = folder.path().join("a.toml");
    fs::write(&design, SHIPPED[0].text).unwrap();
    let pipe = folder.path().join("pipe.toml");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let nowhere = folder.path().join("nowhere.toml");
    std::os::unix::fs::symlink("gone", &nowhere).unwrap();
    assert_eq!(files(&[folder.path().to_path_buf()]), [design, nowhere]);
}

#[test]
fn one_broken_file_does_not_hide_the_others() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("1-broken.toml"), "format = ").unwrap();
    fs::write(folder.path().join("2-empty.toml"), "").unwrap();
    fs::write(folder.path().join("3-good\u{1b}.toml"), SHIPPED[0].text).unwrap();
    let files = files(&[folder.path().to_path_buf()]);
    let [broken, empty, good] = &files[..] else { panic!("{files:?}") };
    assert!(matches!(load(broken), Err(LoadError::Invalid { .. })));
    assert!(matches!(load(empty), Err(LoadError::Empty { .. })));
    assert!(load(good).is_ok());
}

#[test]
fn the_library_here_comes_first() {
    let here = tempfile::tempdir().unwrap();
    fs::create_dir(here.path().join("designs")).unwrap();
    let data = tempfile::tempdir().unwrap();
    assert_eq!(default_folder_in(here.path(), Some(data.path())).unwrap().path, here.path().join("designs"));
    assert_eq!(fs::read_dir(data.path()).unwrap().count(), 0);
}

#[test]
fn the_first_use_fills_the_data_folder_and_later_ones_leave_it() {
    let (here, data) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let DefaultFolder { path: folder, is_new } = default_folder_in(here.path(), Some(data.path())).unwrap();
    assert!(is_new);
    assert_eq!(folder, data.path().join("bevelscope/designs"));
    let filled = files(std::slice::from_ref(&folder));
    assert!(filled.len() == SHIPPED.len() && filled.iter().all(|path| load(path).is_ok()));
    // nothing is left beside it
    assert_eq!(fs::read_dir(data.path().join("bevelscope")).unwrap().count(), 1);

    fs::write(folder.join(SHIPPED[0].file_name), "mine").unwrap();
    fs::remove_file(folder.join(SHIPPED[1].file_name)).unwrap();
    assert!(!default_folder_in(here.path(), Some(data.path())).unwrap().is_new);
    assert_eq!(fs::read_to_string(folder.join(SHIPPED[0].file_name)).unwrap(), "mine");
    assert!(!folder.join(SHIPPED[1].file_name).exists());
}

#[test]
fn a_library_that_cannot_be_made_says_where() {
    let here = tempfile::tempdir().unwrap();
    assert!(matches!(default_folder_in(here.path(), None), Err(LibraryError::NoDataFolder)));
    // a file in place of the folder: permission bits would not stop the superuser
    fs::write(here.path().join("bevelscope"), "").unwrap();
    let error = default_folder_in(here.path(), Some(here.path())).expect_err("a file is in the way");
    assert!(error.to_string().contains("bevelscope"), "{error}");
}
