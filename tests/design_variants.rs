//! Library operations on files: variants, copies, renaming, the trash.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::fs;
use std::path::Path;

use bevelscope::design::library::{
    About, SHIPPED, TRASH, VariantError, VariantName, delete, duplicate, files, follow_parent, rename, restore,
    save_variant, trashed,
};
use bevelscope::design::{SaveError, read};

fn name(name: &str) -> VariantName {
    VariantName::new(name).unwrap()
}

fn library() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for shipped in SHIPPED {
        fs::write(folder.path().join(shipped.file_name), shipped.text).unwrap();
    }
    folder
}

#[test]
fn a_variant_says_where_it_came_from_and_keeps_all_else() {
    let folder = library();
    let about =
        About { design_name: Some("Stiffer \"tail\""), parent: Some("overhung-elastic"), note: Some("ky + 20 %") };
    let (path, text) = save_variant(folder.path(), &name("stiffer"), SHIPPED[0].text, about).unwrap();
    assert_eq!(path, folder.path().join("stiffer.toml"));
    assert_eq!(fs::read_to_string(&path).unwrap(), text);
    let expected = SHIPPED[0]
        .text
        .replacen("name = \"Both overhung, elastic bearings\"", "name = 'Stiffer \"tail\"'", 1)
        .replacen("14/39\"]\n", "14/39\"]\nparent = \"overhung-elastic\"\nnote = \"ky + 20 %\"\n", 1);
    assert_eq!(text, expected);
    let design = read(&text).design.unwrap();
    assert_eq!((design.parent.as_deref(), design.note.as_deref()), (about.parent, about.note));
    // a variant of the variant without a note has none
    let about = About { design_name: None, parent: Some("stiffer"), note: None };
    let (_, third) = save_variant(folder.path(), &name("third"), &text, about).unwrap();
    assert_eq!(
        third,
        text.replacen("note = \"ky + 20 %\"\n", "", 1).replacen(
            "parent = \"overhung-elastic\"",
            "parent = \"stiffer\"",
            1
        )
    );
}

#[test]
fn nothing_is_ever_overwritten() {
    let folder = library();
    let at = |file: &str| folder.path().join(file);
    let first = at("overhung-elastic.toml");
    let taken = name("overhung-rigid");
    let saved = save_variant(folder.path(), &taken, SHIPPED[0].text, About::default());
    assert!(matches!(saved, Err(VariantError::Save(SaveError::Exists(_)))));
    assert!(matches!(rename(&first, &taken), Err(SaveError::Exists(_))));
    assert!(matches!(duplicate(&first, &taken), Err(SaveError::Exists(_))));
    for shipped in SHIPPED {
        assert_eq!(fs::read_to_string(at(shipped.file_name)).unwrap(), shipped.text);
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), SHIPPED.len());
    assert!(matches!(rename(&at("gone.toml"), &name("x")), Err(SaveError::NotThere(_))));
    assert!(matches!(duplicate(&at("gone.toml"), &name("x")), Err(SaveError::NotThere(_))));
    assert!(matches!(delete(&at("gone.toml")), Err(SaveError::NotThere(_))));
    assert!(matches!(delete(folder.path()), Err(SaveError::Folder(_))));
}

#[test]
fn copies_are_the_same_bytes_and_names_change() {
    let folder = library();
    let odd = folder.path().join("odd.toml");
    fs::write(&odd, b"\xef\xbb\xbfa = 1\r\n\xff").unwrap();
    let copy = duplicate(&odd, &name("copy")).unwrap();
    assert_eq!(fs::read(&copy).unwrap(), fs::read(&odd).unwrap());
    let renamed = rename(&odd, &name("even")).unwrap();
    assert!(!odd.exists() && renamed.ends_with("even.toml") && renamed.exists());
    assert_eq!(rename(&renamed, &name("even")).unwrap(), renamed);
}

#[test]
fn children_follow_a_renamed_parent() {
    let folder = library();
    let about = About { parent: Some("overhung-elastic"), ..About::default() };
    let (child, text) = save_variant(folder.path(), &name("child"), SHIPPED[0].text, about).unwrap();
    fs::write(folder.path().join("broken.toml"), "parent = \"overhung-elastic\" x").unwrap();
    let to = name("mother");
    rename(&folder.path().join("overhung-elastic.toml"), &to).unwrap();
    let followed = follow_parent(folder.path(), "overhung-elastic", &to);
    let renamed = text.replace("\"overhung-elastic\"", "\"mother\"");
    assert!(matches!(followed.as_slice(), [(path, Ok(text))] if *path == child && *text == renamed));
    assert_eq!(fs::read_to_string(child).unwrap(), renamed);
}

#[test]
fn deleted_files_can_be_had_back() {
    let folder = library();
    let file = folder.path().join("overhung-elastic.toml");
    let mut gone = Vec::new();
    // the same name again and again, within a second
    for round in 0..3 {
        fs::write(&file, format!("# {round}")).unwrap();
        gone.push(delete(&file).unwrap());
        assert!(!file.exists());
    }
    assert_eq!(files(&[folder.path().to_path_buf()]).len(), SHIPPED.len() - 1);
    let listed = trashed(folder.path());
    assert_eq!(listed.len(), 3);
    assert_eq!(listed.iter().rev().cloned().collect::<Vec<_>>(), gone);
    assert!(
        listed.iter().all(|trashed| trashed.file_name == "overhung-elastic.toml" && trashed.when.starts_with("20"))
    );
    assert!(gone[0].path.starts_with(folder.path().join(TRASH)));
    assert_eq!(restore(&gone[1]).unwrap(), file);
    assert_eq!(fs::read_to_string(&file).unwrap(), "# 1");
    assert!(matches!(restore(&gone[2]), Err(SaveError::Exists(_))));
    assert!(matches!(restore(&gone[1]), Err(SaveError::NotThere(_) | SaveError::Exists(_))));
    assert_eq!(trashed(folder.path()).len(), 2);
    fs::write(folder.path().join(TRASH).join("note.txt"), "of somebody").unwrap();
    assert_eq!(trashed(folder.path()).len(), 2);
    assert_eq!(trashed(Path::new("/nowhere")).len(), 0);
}

#[test]
fn a_trash_that_cannot_be_made_keeps_the_file() {
    let folder = library();
    fs::write(folder.path().join(TRASH), "a file").unwrap();
    let file = folder.path().join("overhung-elastic.toml");
    assert!(delete(&file).unwrap_err().to_string().contains("the trash cannot be made"));
    assert_eq!(fs::read_to_string(file).unwrap(), SHIPPED[0].text);
}
