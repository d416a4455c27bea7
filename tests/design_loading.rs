//! Files that are no design files at all, and random damage to one that is.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::fs;
use std::io::{self, Read};
use std::path::Path;

use bevelscope::design::library::SHIPPED;
use bevelscope::design::{KeyPath, LoadError, MAX_BYTES, Source, load, load_from, read};
use proptest::prelude::*;

fn failure(bytes: &[u8]) -> LoadError {
    load_from(bytes, "x.toml").expect_err("no design")
}

#[test]
fn an_empty_file_says_so() {
    assert_eq!(failure(b"").to_string(), "x.toml: the file is empty");
}

#[test]
fn a_file_of_blanks_lacks_what_a_design_needs() {
    let LoadError::Invalid { findings, .. } = failure(b"\n\n") else { panic!("not read") };
    let paths: Vec<String> = findings.iter().map(|finding| finding.key_path.to_string()).collect();
    assert_eq!(paths, ["format", "name", "mesh", "pinion", "gear"]);
}

#[test]
fn a_folder_is_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let error = load(folder.path()).expect_err("a folder");
    assert!(matches!(error, LoadError::Folder { .. }), "{error}");
}

#[test]
fn a_missing_file_is_named() {
    let error = load(Path::new("no/such\u{1b}[2J.toml")).expect_err("missing");
    assert_eq!(error.to_string(), "no/such\\u{1b}[2J.toml: there is no such file");
}

#[test]
fn the_limit_of_4_mib_is_exact() {
    let shipped = SHIPPED[0].text;
    let most = 4 * 1024 * 1024;
    let padded = |bytes: usize| format!("{shipped}#{}\n", "x".repeat(bytes - shipped.len() - 2));
    assert!(load_from(padded(most).as_bytes(), "x.toml").is_ok());
    assert!(matches!(failure(padded(most + 1).as_bytes()), LoadError::TooLarge { .. }));

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("large.toml");
    fs::write(&path, padded(most + 1)).unwrap();
    assert!(matches!(load(&path), Err(LoadError::TooLarge { .. })));
}

/// Never ends, and counts what is taken.
struct Endless(u64);

impl Read for &mut Endless {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        buffer.fill(b'#');
        self.0 += buffer.len() as u64;
        Ok(buffer.len())
    }
}

#[test]
fn no_more_than_a_byte_over_the_limit_is_read() {
    let mut endless = Endless(0);
    assert!(matches!(load_from(&mut endless, "-"), Err(LoadError::TooLarge { .. })));
    // a reader may be asked for a whole buffer, never for more than the limit allows
    assert!(endless.0 <= MAX_BYTES + 1, "{}", endless.0);
}

#[test]
fn bytes_that_are_no_text_are_named_by_line_and_byte() {
    // 0xe9 is e acute in Latin-1; alone it is no UTF-8
    let error = failure(b"format = 1\nname = \"caf\xe9\"\n");
    assert_eq!(error.to_string(), "x.toml:2: not UTF-8 text: byte 22 of the file is 0xe9");
    assert_eq!(error.reason(), "line 2: not UTF-8 text");
}

#[test]
fn a_byte_order_mark_and_dos_line_ends_are_read() {
    let text = format!("\u{feff}{}", SHIPPED[0].text.replace('\n', "\r\n"));
    assert!(read(&text).design.is_some());
    assert_eq!(read(&text).design, read(SHIPPED[0].text).design);
}

#[test]
fn the_reason_is_one_line() {
    let text = SHIPPED[0].text.replace("length_mm", "lenght_mm");
    let reason = failure(text.as_bytes()).reason();
    assert!(reason.starts_with("line ") && !reason.contains('\n'), "{reason}");
    // eight segments with a key unknown and a key missing each
    assert!(reason.ends_with(" (and 15 more errors)"), "{reason}");
}

#[test]
fn a_file_full_of_errors_is_answered_quickly_and_shortly() {
    for line in ["x{} = 1\n", "[[pinion.segment]] # {}\n", "a = {}\n", "\"{}\n", "[a{}\n"] {
        let text: String = (0..100_000).map(|i| line.replace("{}", &i.to_string())).collect();
        let findings = read(&text).findings;
        assert!((1..=201).contains(&findings.len()), "{line}: {}", findings.len());
    }
}

#[test]
fn no_number_of_warnings_hides_an_error() {
    // each body has more polar inertia than a rigid body can have; the material of the gear's shaft is nowhere
    let body = "[[pinion.body]]\nposition_mm = 18\nmass_kg = 1\ndiametral_inertia_kg_m2 = 1\npolar_inertia_kg_m2 = 3\n";
    let text = format!("{}{}", SHIPPED[0].text, body.repeat(300));
    let reading = read(&text);
    assert!(reading.design.is_some() && reading.errors().count() == 0);
    assert_eq!(reading.warnings().count(), 201);
    let (before, after) = text.split_once("[[gear.segment]]").unwrap();
    let reading = read(&format!("{before}[[gear.segment]]\nmaterial = \"nowhere\"{after}"));
    assert!(reading.design.is_none());
    assert!(reading.errors().any(|error| error.shown_path() == "gear.segment[0].material"));
}

#[test]
fn deep_nesting_is_an_error() {
    for text in ["[".repeat(100_000), format!("a = {}", "[".repeat(100_000)), format!("a = {}", "{a=".repeat(100_000))]
    {
        assert!(read(&text).design.is_none());
    }
    assert!(read(&format!("{} = 1", vec!["a"; 50_000].join("."))).design.is_none());
}

#[test]
fn a_long_line_is_clipped_around_the_place() {
    let text = format!("tags = [{}7, {}]", "\"a\", ".repeat(100), "\"b\", ".repeat(100));
    let findings = read(&text).findings;
    let finding = findings.iter().find(|finding| finding.shown_path() == "tags[100]").unwrap();
    let shown = Source::new("x.toml", &text).render(finding);
    let lines: Vec<&str> = shown.lines().collect();
    // 8 columns before the list, 5 an entry, from 1
    assert!(lines[0].starts_with("x.toml:1:509: error: tags[100]: "), "{shown}");
    assert_eq!(lines[1].matches("...").count(), 2, "{shown}");
    assert_eq!(lines[1].len(), "  1 | ".len() + 2 * 60 + 2 * "...".len(), "{shown}");
    assert_eq!(lines[1].find('7'), lines[2].find('^'), "{shown}");
}

#[test]
fn a_name_as_long_as_the_file_is_clipped() {
    let name = "x".repeat(1_000_000);
    let text = format!("[material.{name}]\n{}", (0..1000).map(|i| format!("k{i} = 1\n")).collect::<Vec<_>>().concat());
    let shown = Source::new("x.toml", &text).render_all(&read(&text).findings);
    assert!(shown.len() < 500_000, "{}", shown.len());
}

/// A path that is too long to be shown in full still leads to its value.
#[test]
fn the_path_of_a_long_name_is_clipped_only_where_it_is_shown() {
    let name = "x".repeat(1000);
    let text = format!("{}\n[material.{name}]\nelastic_modulus_gpa = -1.0\n", SHIPPED[0].text);
    let findings = read(&text).findings;
    let path = KeyPath::root().key("material").key(&name).key("elastic_modulus_gpa");
    let finding = findings.iter().find(|finding| finding.key_path == path).unwrap();
    assert_eq!(finding.shown_path().len(), 500 + "...".len());
}

#[test]
fn the_mark_stands_under_the_place() {
    // column 7 is counted in characters: a tab, two wide characters and an escape are one each
    let text = "\t\"歯車\u{200b}\" = 1";
    let finding = read(&format!("format = 1\n{text}")).findings;
    let shown = Source::new("x.toml", &format!("format = 1\n{text}"))
        .render(finding.iter().find(|f| f.shown_path().contains('歯')).unwrap_or(&finding[0]));
    let lines: Vec<&str> = shown.lines().collect();
    assert_eq!(lines[0], "x.toml:2:2: error: \"歯車\\u{200b}\": unknown key");
    assert_eq!(lines[1], "  2 | \t\"歯車\\u{200b}\" = 1");
    // quote, 2 + 2 columns, 8 for the escape, quote
    assert_eq!(lines[2], format!("    | \t{}", "^".repeat(14)));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damaged_files_are_refused_or_read_but_never_panic(
        shipped in 0..SHIPPED.len(),
        end in 0.2f64..=1.0,
        damage in prop::collection::vec((0.0f64..1.0, any::<u8>()), 0..8),
    ) {
        let mut bytes = SHIPPED[shipped].text.as_bytes().to_vec();
        bytes.truncate((bytes.len() as f64 * end) as usize);
        for (place, byte) in damage {
            let place = (bytes.len() as f64 * place) as usize;
            bytes[place] = byte;
        }
        let result = load_from(bytes.as_slice(), "x.toml");
        let shown = result.map_or_else(|error| error.to_string() + &error.reason(), |loaded| loaded.render_warnings());
        let steers = shown.contains('\u{1b}');
        prop_assert!(!steers);
    }

    #[test]
    fn other_numbers_are_refused_or_read_but_never_panic(
        shipped in 0..SHIPPED.len(),
        line in 0usize..200,
        number in prop_oneof![any::<f64>().prop_map(|n| format!("{n:?}")), any::<i64>().prop_map(|n| n.to_string())],
    ) {
        let text = SHIPPED[shipped].text;
        let changed: Vec<String> = text.lines().enumerate().map(|(i, written)| match written.split_once(" = ") {
            Some((key, _)) if i == line % text.lines().count() => format!("{key} = {number}"),
            _ => written.to_string(),
        }).collect();
        let changed = changed.join("\n");
        let _ = Source::new("x.toml", &changed).render_all(&read(&changed).findings);
    }
}
