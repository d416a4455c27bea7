//! Every file of `tests/fixtures/valid` is read without an error, every file of `invalid` gives exactly the errors that its
//! first lines expect: `# expect: LINE: KEY PATH: part of the message`; `# warn:` is the same for warnings.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::fs;
use std::path::{Path, PathBuf};

use bevelscope::design::{Finding, Severity, Source, read};

fn fixtures(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures").join(folder);
    let mut files: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    files.sort();
    assert!(!files.is_empty());
    files
}

/// Lines, key paths and parts of messages that a file expects, in the order of lines.
fn expected<'a>(text: &'a str, mark: &str) -> Vec<(usize, &'a str, &'a str)> {
    let parts = |line: &'a str| {
        let mut parts = line.strip_prefix(mark)?.splitn(3, ": ").map(str::trim);
        Some((parts.next()?.parse().ok()?, parts.next()?, parts.next()?))
    };
    let mut expected: Vec<_> = text.lines().filter_map(parts).collect();
    expected.sort_unstable();
    let marks = text.lines().filter(|line| line.starts_with(mark)).count();
    assert_eq!(expected.len(), marks, "an expectation is not written as LINE: KEY PATH: MESSAGE");
    expected
}

/// What differs from the expectation; nothing where all is as expected.
fn differences(path: &Path, severity: Severity, mark: &str) -> Option<String> {
    let text = fs::read_to_string(path).unwrap();
    let name = path.file_name().unwrap().to_string_lossy().into_owned();
    let source = Source::new(&name, &text);
    let findings: Vec<Finding> = read(&text).findings.into_iter().filter(|f| f.severity == severity).collect();
    let expected = expected(&text, mark);
    let line = |finding: &Finding| finding.span.as_ref().map_or(0, |span| source.position(span.start).line);
    let mut left: Vec<&Finding> = findings.iter().collect();
    let mut missed = Vec::new();
    for (at, key_path, part) in expected {
        let fits = |f: &&Finding| line(f) == at && f.shown_path() == key_path && f.message.contains(part);
        match left.iter().position(fits) {
            Some(found) => drop(left.remove(found)),
            None => missed.push(format!("{at}: {key_path}: {part}")),
        }
    }
    (!left.is_empty() || !missed.is_empty()).then(|| {
        let left: String = left.into_iter().map(|finding| source.render(finding)).collect();
        format!("== {name}\n-- expected and not found:\n{}\n-- found and not expected:\n{left}", missed.join("\n"))
    })
}

fn assert_as_expected(folder: &str, severity: Severity, mark: &str) {
    let differences: Vec<String> =
        fixtures(folder).iter().filter_map(|path| differences(path, severity, mark)).collect();
    assert!(differences.is_empty(), "\n{}", differences.join("\n"));
}

#[test]
fn invalid_files_give_the_errors_they_expect_and_no_others() {
    assert_as_expected("invalid", Severity::Error, "# expect: ");
    for path in fixtures("invalid") {
        let text = fs::read_to_string(&path).unwrap();
        assert!(text.contains("# expect: "), "{}", path.display());
        assert!(read(&text).design.is_none(), "{}", path.display());
    }
}

#[test]
fn valid_files_are_read_and_warn_as_they_expect() {
    assert_as_expected("valid", Severity::Error, "# expect: ");
    assert_as_expected("valid", Severity::Warning, "# warn: ");
    for path in fixtures("valid") {
        assert!(read(&fs::read_to_string(&path).unwrap()).design.is_some(), "{}", path.display());
    }
}

#[test]
fn nothing_shown_about_any_file_steers_a_terminal() {
    for folder in ["invalid", "valid"] {
        for path in fixtures(folder) {
            let text = fs::read_to_string(&path).unwrap();
            let shown = Source::new("\u{1b}[2Jname.toml", &text).render_all(&read(&text).findings);
            let unprintable = |c: char| c != '\n' && bevelscope::text::is_unprintable(c);
            assert!(!shown.contains(unprintable), "{}:\n{shown:?}", path.display());
        }
    }
}
