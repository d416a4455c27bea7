//! The report: its pages and pictures as text, what they may hold, and how a browser sees them.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod support;

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use bevelscope::design::{Design, Finding, Loaded, Severity, library::SHIPPED, read};
use bevelscope::pair::PairFigures;
use bevelscope::report::Study;
use bevelscope::report::html::{Entry, page};
use bevelscope::report::svg::{Picture, WIDTH, levels, pair, side_view, spectra};
use proptest::prelude::*;
use roxmltree::{Document, ParsingOptions};
use support::random::{config, designs};

const PROGRAM: &str = env!("CARGO_BIN_EXE_bevelscope");

/// A shipped design with few lines.
fn small() -> Loaded {
    let text = SHIPPED[0].text.replace("frequency_lines = 1000", "frequency_lines = 50");
    assert_ne!(text, SHIPPED[0].text);
    loaded(text, "small.toml")
}

fn loaded(text: String, name: &str) -> Loaded {
    let reading = read(&text);
    let design = reading.design.unwrap_or_else(|| panic!("{:?}", reading.findings));
    Loaded { design, text, warnings: reading.findings, name: name.into() }
}

fn page_of(loaded: &Loaded) -> String {
    let study = Study::new(&loaded.design, 3.0).unwrap();
    page(&[Entry { loaded, study: &study }], "2026-01-31")
}

fn pictures(design: &Design, tolerance_db: f64) -> [Picture; 3] {
    let study = Study::new(design, tolerance_db).unwrap();
    [spectra(design, &study), levels(design, &study), side_view(design)]
}

fn parsed(text: &str) -> Document<'_> {
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).unwrap_or_else(|error| panic!("{error}"))
}

/// Nothing that a browser would fetch or run.
fn assert_alone(html: &str) {
    for word in ["http", "src=", "url(", "<script", "@import", "<link", "javascript:", "<iframe", " onload", "<base"] {
        assert!(!html.to_lowercase().contains(word), "the page has {word}");
    }
}

#[test]
fn pictures_of_a_small_design() {
    for picture in pictures(&small().design, 3.0) {
        let file = picture.file("PROVENANCE");
        parsed(&file);
        insta::assert_snapshot!(format!("report_{}", picture.name), file);
    }
}

#[test]
fn page_of_a_small_design() {
    let page = page_of(&small());
    let version = format!("bevelscope {}</dd>", env!("CARGO_PKG_VERSION"));
    assert_eq!(page.matches(&version).count(), 1);
    // pictures have snapshots of their own
    let mut text = page.replace(&version, "bevelscope VERSION</dd>");
    while let (Some(from), Some(to)) = (text.find("<svg"), text.find("</svg>")) {
        text.replace_range(from..to + "</svg>".len(), "[picture]");
    }
    insta::assert_snapshot!("report_page", text);
}

#[test]
fn a_page_stands_alone_and_is_well_formed() {
    for shipped in SHIPPED {
        let page = page_of(&loaded(shipped.text.into(), shipped.file_name));
        assert_alone(&page);
        let document = parsed(&page);
        let elements = || document.descendants().filter(roxmltree::Node::is_element);
        let named = |name: &'static str| elements().filter(move |node| node.has_tag_name(name));
        assert!(named("html").all(|html| html.attribute("lang") == Some("en")));
        assert_eq!(named("h1").count(), 1);
        // every table says what it is and of what its columns are, every picture has words
        assert!(named("table").count() > 10);
        for table in named("table") {
            assert_eq!(table.children().filter(|node| node.has_tag_name("caption")).count(), 1);
            let columns = table.descendants().filter(|node| node.attribute("scope") == Some("col")).count();
            for row in table.descendants().filter(|node| node.has_tag_name("tr")) {
                assert_eq!(row.children().filter(roxmltree::Node::is_element).count(), columns);
            }
        }
        let ids: Vec<&str> = elements().filter_map(|node| node.attribute("id")).collect();
        let mut once = ids.clone();
        once.sort_unstable();
        once.dedup();
        assert_eq!(once.len(), ids.len());
        assert_eq!(named("svg").count(), 4);
        for label in elements().filter_map(|node| node.attribute("aria-labelledby")).flat_map(str::split_whitespace) {
            assert!(ids.contains(&label), "{label}");
        }
    }
}

#[test]
fn the_figures_come_first_and_are_those_of_check() {
    let page = page_of(&loaded(SHIPPED[0].text.into(), SHIPPED[0].file_name));
    let place = |text: &str| page.find(text).unwrap_or_else(|| panic!("no {text}"));
    // README.md, `bevelscope check designs`
    assert!(place("Trust the enhanced model up to 2,997 Hz") < place("<svg"));
    for figure in ["3.72", "12.69", "3,457", "0.555", "10.13"] {
        assert!(page.contains(&format!(">{figure}<")), "{figure}");
    }
    // sha256sum designs/overhung-elastic.toml
    assert!(page.contains(&bevelscope::design::hash(SHIPPED[0].text.as_bytes())));
}

/// A speed puts the mesh frequency, 14 teeth at 1,500 rpm = 350 Hz, on both plots of the spectra; without one there is no mark.
#[test]
fn harmonics_of_the_mesh_frequency_are_marked_where_a_speed_is_given() {
    let plain = small();
    let text = plain.text + "\n[operating]\npinion_speed_rpm = 1500.0\n";
    let design = loaded(text, "speed.toml").design;
    let teeth = f64::from(design.pinion.teeth.unwrap());
    let picture = &pictures(&design, 3.0)[0];
    let file = picture.file("");
    let document = parsed(&file);
    let places = document.descendants().filter(|node| node.attribute("class") == Some("place")).count();
    let last = design.analysis.frequency_max / (teeth * 25.0);
    assert_eq!(places, 2 * (last.floor() as usize).min(9));
    assert!(file.contains(">1\u{d7}<") && picture.description.contains("mesh frequency"), "{file}");
    let without = &pictures(&without_speed(&design), 3.0)[0];
    assert!(!without.body.contains("class=\"place\"") && !without.description.contains("mesh frequency"));
}

fn without_speed(design: &Design) -> Design {
    let mut design = design.clone();
    if let Some(operating) = &mut design.operating {
        operating.pinion_speed = None;
    }
    design
}

#[test]
fn a_page_has_the_gear_pair_and_names_no_folder() {
    let shipped = SHIPPED[0].text;
    let design = loaded(shipped.into(), "/home/someone/secret folder/own.toml");
    let warned = Loaded {
        warnings: vec![Finding {
            severity: Severity::Warning,
            key_path: "note".parse().unwrap(),
            span: None,
            message: "unusual".into(),
            hint: None,
        }],
        ..design
    };
    let page = page_of(&warned);
    assert!(page.contains("unusual") && page.contains("own.toml"), "the warning is there");
    assert!(!page.contains("secret folder"));
    assert!(page.contains(">Gear pair</h2>") && page.contains("axial force") && page.contains("id=\"d1-pair-title\""));
}

#[test]
fn several_designs_have_a_list_of_contents() {
    let all: Vec<Loaded> = SHIPPED.iter().map(|shipped| loaded(shipped.text.into(), shipped.file_name)).collect();
    let studies: Vec<Study> = all.iter().map(|loaded| Study::new(&loaded.design, 3.0).unwrap()).collect();
    let entries: Vec<Entry<'_>> = all.iter().zip(&studies).map(|(loaded, study)| Entry { loaded, study }).collect();
    let page = page(&entries, "2026-01-31");
    let document = parsed(&page);
    let links: Vec<&str> = document.descendants().filter_map(|node| node.attribute("href")).collect();
    let places: Vec<String> = (1..=SHIPPED.len()).map(|number| format!("#d{number}")).collect();
    assert_eq!(links, places);
    for link in links {
        assert!(document.descendants().any(|node| node.attribute("id") == Some(&link[1..])));
    }
}

#[test]
fn a_million_lines_make_no_larger_picture() {
    let mut design = small().design;
    design.analysis.frequency_lines = 1_000_000;
    let [spectra, ..] = pictures(&design, 3.0);
    let bytes = spectra.file("PROVENANCE").len();
    assert!((20_000..200_000).contains(&bytes), "{bytes}");
}

/// Every number of a picture that is a coordinate, checked to lie in it.
fn check_coordinates(picture: &Picture) -> Result<(), TestCaseError> {
    let file = picture.file("PROVENANCE");
    let document = parsed(&file);
    let inside = |what: &str, number: &str, high: f64| {
        let value: f64 = number.parse().map_err(|_| TestCaseError::fail(format!("{what}: {number:?}")))?;
        prop_assert!(value.is_finite() && (-0.01..=high + 0.01).contains(&value), "{}: {what}={number}", picture.name);
        Ok(value)
    };
    for node in document.descendants().filter(roxmltree::Node::is_element).skip(1) {
        for attribute in node.attributes() {
            let high = match attribute.name() {
                "x" | "x1" | "x2" | "cx" => WIDTH,
                "y" | "y1" | "y2" | "cy" | "r" => picture.height,
                _ => continue,
            };
            inside(attribute.name(), attribute.value(), high)?;
        }
        if let (true, Some(x), Some(y)) = (node.has_tag_name("rect"), node.attribute("x"), node.attribute("y")) {
            let at = |text: &str| text.parse::<f64>().unwrap();
            inside("width", &(at(x) + at(node.attribute("width").unwrap())).to_string(), WIDTH)?;
            inside("height", &(at(y) + at(node.attribute("height").unwrap())).to_string(), picture.height)?;
        }
        if let Some(d) = node.attribute("d") {
            let numbers: Vec<&str> = d.trim_start_matches('M').trim_end_matches('Z').split(' ').collect();
            for pair in numbers.chunks(2) {
                inside("d", pair[0], WIDTH)?;
                inside("d", pair[1], picture.height)?;
            }
        }
    }
    Ok(())
}

/// Names that try to be markup, to steer a terminal, or to turn text around.
fn hostile() -> impl Strategy<Value = String> {
    let pieces = prop_oneof![
        Just("<script>alert(1)</script>".to_owned()),
        Just("\"><img onerror='x'>".to_owned()),
        Just("]]>&amp;<!--".to_owned()),
        Just("</style></title></text></svg>".to_owned()),
        Just("\u{1b}[2J\u{9b}\u{0}\u{7f}".to_owned()),
        Just("\u{202e}\u{2066}\u{200f}\u{feff}".to_owned()),
        Just("\u{fffe}\u{ffff}\u{fdd0}\u{1fffe}".to_owned()),
        Just("\n\r\n\t'&#x3c;".to_owned()),
        any::<String>(),
    ];
    proptest::collection::vec(pieces, 1..4).prop_map(|pieces| pieces.concat())
}

proptest! {
    #![proptest_config(config(24))]

    #[test]
    fn pictures_of_random_designs_stay_inside(design in designs(), tolerance_db in 0.0..20.0_f64) {
        for picture in pictures(&design, tolerance_db) {
            check_coordinates(&picture)?;
        }
        if let Some(picture) = pair(&design, &PairFigures::new(&design)) {
            check_coordinates(&picture)?;
        }
    }

    #[test]
    fn no_name_is_markup(names in proptest::collection::vec(hostile(), 6)) {
        let mut text = small().text;
        let mut put = |from: &str, name: &String| {
            assert!(text.contains(from), "{from}");
            let key = from.split_once(" = ").unwrap().0;
            text = text.replacen(from, &format!("{key} = {}", toml_edit::Value::from(name.as_str())), 1);
        };
        put("name = \"Both overhung, elastic bearings\"", &format!("{}.", names[0]));
        put("name = \"head\"", &format!("a{}", names[1]));
        put("name = \"B1\"", &format!("b{}", names[2]));
        put("name = \"B2\"", &format!("c{}", names[3]));
        put("tags = [\"case-b\", \"spiral bevel\", \"14/39\"]", &names[5]);
        let text = text.replacen("tags = ", "note = ", 1);
        let loaded = loaded(text, &names[4]);
        let html = page_of(&loaded);
        let document = parsed(&html);
        let allowed = ["script", "img"];
        prop_assert!(!document.descendants().any(|node| allowed.contains(&node.tag_name().name())));
        // the same elements as with harmless names
        let count = |document: &Document<'_>| document.descendants().filter(roxmltree::Node::is_element).count();
        let breaks = document.descendants().filter(|node| node.has_tag_name("br")).count();
        let plain = page_of(&small());
        let lines = loaded.design.note.as_ref().is_some_and(|note| !note.trim().is_empty());
        // labels of marks are left out where there is no room: text elements of the side view do not count
        let texts = |document: &Document<'_>| document.descendants().filter(|node| node.has_tag_name("text")).count();
        let plain = parsed(&plain);
        let (found, expected) = (count(&document) - texts(&document) - breaks - usize::from(lines), count(&plain) - texts(&plain));
        prop_assert_eq!(found, expected);
        for picture in pictures(&loaded.design, 3.0) {
            check_coordinates(&picture)?;
        }
        let raw = html.chars().find(|c| bevelscope::text::is_unprintable(*c) && *c != '\n');
        prop_assert_eq!(raw, None);
    }
}

fn bevelscope(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(PROGRAM);
    command.current_dir(folder).args(arguments).env("SOURCE_DATE_EPOCH", "951782400").stdin(Stdio::null());
    command.output().unwrap()
}

#[test]
fn nothing_is_overwritten_unasked_and_no_design_ever() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let own = here.join("own.toml");
    std::fs::write(&own, SHIPPED[0].text).unwrap();
    let first = bevelscope(here, &["report", "own.toml", "--svg", "pictures"]);
    assert_eq!(first.status.code(), Some(0), "{}", String::from_utf8_lossy(&first.stderr));
    let files = "pictures/own-spectra.svg\npictures/own-levels.svg\npictures/own-side-view.svg\npictures/own-pair.svg\nown.html\n";
    assert_eq!(String::from_utf8_lossy(&first.stdout), files);
    let text = std::fs::read_to_string(here.join("own.html")).unwrap();
    assert!(text.contains("<time datetime=\"2000-02-29\">"));
    let picture = std::fs::read_to_string(here.join("pictures/own-spectra.svg")).unwrap();
    parsed(&picture);
    let hash = bevelscope::design::hash(SHIPPED[0].text.as_bytes());
    let provenance =
        format!("bevelscope {}, design Both overhung, elastic bearings, hash {hash}.", env!("CARGO_PKG_VERSION"));
    assert!(picture.contains(&provenance), "{provenance}");
    // to standard output, byte for byte
    let again = bevelscope(here, &["report", "own.toml", "-o", "-"]);
    assert_eq!(String::from_utf8(again.stdout).unwrap(), text);
    std::fs::write(here.join("own.html"), "mine").unwrap();
    let refused = bevelscope(here, &["report", "own.toml"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("--force"));
    assert_eq!(std::fs::read_to_string(here.join("own.html")).unwrap(), "mine");
    let forced = bevelscope(here, &["report", "own.toml", "--force"]);
    assert_eq!(forced.status.code(), Some(0));
    assert_eq!(std::fs::read_to_string(here.join("own.html")).unwrap(), text);
    let over_design = bevelscope(here, &["report", "own.toml", "-o", "own.toml", "--force"]);
    assert_eq!(over_design.status.code(), Some(2));
    assert_eq!(std::fs::read_to_string(&own).unwrap(), SHIPPED[0].text);
    // the page over one of its own pictures: nothing is written, also where all may be overwritten
    let before = std::fs::read_dir(here).unwrap().count();
    for page in ["new/own-spectra.svg", "./new/../new/own-spectra.svg"] {
        let output = bevelscope(here, &["report", "own.toml", "--svg", "new", "-o", page, "--force"]);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains("cannot have one name"), "{said}");
    }
    assert_eq!(std::fs::read_dir(here).unwrap().count(), before);
    for bad in [["report", "missing.toml"].as_slice(), &["report", "own.toml", "-o", "no/folder/x.html"], &["report"]] {
        let output = bevelscope(here, bad);
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{bad:?}");
    }
}

/// A Chromium on the path.
fn chromium() -> Option<PathBuf> {
    let names = ["chromium", "chromium-browser", "google-chrome"];
    let path = std::env::var_os("PATH")?;
    let folders: Vec<PathBuf> = std::env::split_paths(&path).collect();
    folders.iter().flat_map(|folder| names.map(|name| folder.join(name))).find(|file| file.is_file())
}

/// Without a way into any network, a profile of its own, and the page's console on standard error.
fn browse(chromium: &Path, folder: &Path, more: &[&str]) -> Output {
    let profile = format!("--user-data-dir={}", folder.join("profile").display());
    let netlog = format!("--log-net-log={}", folder.join("netlog.json").display());
    let page = format!("file://{}", folder.join("page.html").display());
    let mut command = Command::new(chromium);
    command.args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run"]);
    command.args(["--disable-background-networking", "--disable-component-update", "--disable-sync"]);
    command.args(["--proxy-server=127.0.0.1:9", "--enable-logging=stderr", &profile, &netlog]).args(more).arg(page);
    command.stdin(Stdio::null()).output().unwrap()
}

#[test]
fn a_browser_shows_the_page_without_a_request_and_prints_it() {
    let Some(chromium) = chromium() else {
        println!("skipped: there is no chromium, chromium-browser or google-chrome on the path");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    std::fs::write(here.join("page.html"), page_of(&loaded(SHIPPED[0].text.into(), SHIPPED[0].file_name))).unwrap();
    let shown = browse(&chromium, here, &["--dump-dom"]);
    let (dom, log) = (String::from_utf8_lossy(&shown.stdout), String::from_utf8_lossy(&shown.stderr));
    assert!(shown.status.success(), "{log}");
    assert!(dom.contains("Trust the enhanced model up to 2,997 Hz") && dom.matches("</svg>").count() == 4);
    assert!(!log.contains(":CONSOLE"), "{log}");
    let netlog = std::fs::read_to_string(here.join("netlog.json")).unwrap();
    let asked: Vec<&str> = netlog.split("\"url\":\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    // what the browser asks for itself is not the page's
    let of_page: Vec<&&str> = asked.iter().filter(|url| !url.contains("google") && !url.starts_with("file:")).collect();
    assert!(of_page.is_empty(), "{of_page:?}");
    let pdf = here.join("page.pdf");
    let printed = browse(&chromium, here, &["--no-pdf-header-footer", &format!("--print-to-pdf={}", pdf.display())]);
    assert!(printed.status.success());
    let bytes = std::fs::read(&pdf).unwrap();
    let text = String::from_utf8_lossy(&bytes);
    let pages = text.matches("/Type /Page\n").count();
    assert!((4..=12).contains(&pages), "{pages} pages");
    // A4 is 595.28 by 841.89 points
    assert!(text.contains("/MediaBox [0 0 594.95") || text.contains("/MediaBox [0 0 595"), "not A4");
}
