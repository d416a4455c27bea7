//! What screens show, written to files: with the explorer's own backend, in a folder of its own.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod tui_support;

use std::fs;
use std::path::{Path, PathBuf};

use bevelscope::commands::Files;
use bevelscope::comparison::solve;
use bevelscope::design::library::SHIPPED;
use bevelscope::design::{self, Design};
use bevelscope::model::{ModelKind, Rotors};
use bevelscope::response::frequency_lines;
use bevelscope::tui::Backend;
use bevelscope::tui::keymap::Mode;
use roxmltree::{Document, ParsingOptions};
use tempfile::TempDir;
use tui_support::Screen;

/// Two shipped designs in a folder, and the explorer on it.
fn library() -> (TempDir, Screen) {
    let folder = tempfile::tempdir().unwrap();
    let paths: Vec<PathBuf> = SHIPPED[..2].iter().map(|shipped| folder.path().join(shipped.file_name)).collect();
    for (path, shipped) in paths.iter().zip(SHIPPED) {
        fs::write(path, shipped.text).unwrap();
    }
    let screen = Screen::over(paths, 120, 40, Files::new(vec![folder.path().into()]));
    (folder, screen)
}

/// Takes the proposed name away and types another one.
fn write(screen: &mut Screen, path: &Path) -> String {
    assert_eq!(screen.app.mode, Mode::Export, "{}", screen.text());
    screen.keys(&format!("<Ctrl-u>{}<Enter>", path.display()));
    assert_ne!(screen.app.mode, Mode::Export, "{}", screen.text());
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{error}: {}", screen.text()))
}

fn parsed(text: &str) -> Document<'_> {
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).unwrap_or_else(|error| panic!("{error}"))
}

/// RFC 4180 below a line that begins with `#`: that line, the heads, the rows.
fn csv(text: &str) -> (String, Vec<String>, Vec<Vec<String>>) {
    let mut records: Vec<Vec<String>> = vec![vec![String::new()]];
    let (first, rest) = text.split_once("\r\n").unwrap();
    let mut quoted = false;
    let mut letters = rest.chars().peekable();
    while let Some(letter) = letters.next() {
        let record = records.last_mut().unwrap();
        match letter {
            '"' if quoted && letters.peek() == Some(&'"') => {
                letters.next();
                record.last_mut().unwrap().push('"');
            }
            '"' => quoted = !quoted,
            ',' if !quoted => record.push(String::new()),
            '\r' if !quoted => {
                assert_eq!(letters.next(), Some('\n'));
                records.push(vec![String::new()]);
            }
            letter => record.last_mut().unwrap().push(letter),
        }
    }
    assert_eq!(records.pop(), Some(vec![String::new()]), "the last line is ended");
    let heads = records.remove(0);
    assert!(records.iter().all(|record| record.len() == heads.len()), "{records:?}");
    (first.to_owned(), heads, records)
}

/// Nothing that a browser would fetch or run.
fn assert_alone(text: &str) {
    let text = text.replace("http://www.w3.org/2000/svg", "");
    for word in ["http", "src=", "url(", "<script", "@import", "<link", "javascript:", "<iframe", " onload", "<base"] {
        assert!(!text.to_lowercase().contains(word), "it has {word}");
    }
}

/// The keys to a screen, how its proposed name begins, and whether it is about both designs.
const SCREENS: [(&str, &str, bool); 9] = [
    ("wnp", "overhung-elastic-mesh_force.csv", false),
    ("wvvr<Tab>", "overhung-elastic-bearing_pinion_", false),
    ("w4<Tab><Tab>x", "overhung-elastic-mesh_force.csv", false),
    ("M", "overhung-elastic-modes.csv", false),
    ("Mjjo", "overhung-elastic-deflection-", false),
    ("Mx", "overhung-elastic-mac-enhanced.csv", false),
    ("P", "overhung-elastic-gear-pair.csv", false),
    ("O", "overview.csv", true),
    ("mjc", "overhung-elastic-and-overhung-rigid.csv", true),
];

#[test]
fn every_screen_is_written_in_every_format_with_version_and_hash() {
    let version = format!("bevelscope {}", env!("CARGO_PKG_VERSION"));
    let hashes: Vec<String> = SHIPPED[..2].iter().map(|shipped| design::hash(shipped.text.as_bytes())).collect();
    for (keys, proposed, both) in SCREENS {
        let (folder, mut screen) = library();
        screen.keys(keys).keys("e");
        assert!(screen.text().contains(proposed), "{keys}: {}", screen.text());
        let hashes = &hashes[..if both { 2 } else { 1 }];
        let data = write(&mut screen, &folder.path().join("out.csv"));
        let (first, heads, rows) = csv(&data);
        assert!(first.starts_with(&format!("# {version}")), "{first}");
        assert!(hashes.iter().all(|hash| first.contains(&format!("hash {hash}"))), "{first}");
        assert!(heads.len() > 2 && rows.len() > 1, "{keys}: {heads:?} {}", rows.len());
        // another key of the same meaning
        screen.keys("E");
        let picture = write(&mut screen, &folder.path().join("out.SVG"));
        assert_alone(&picture);
        let document = parsed(&picture);
        assert!(document.root_element().has_tag_name("svg"));
        let lines = document
            .descendants()
            .filter(|node| node.attribute("class").is_some_and(|class| class.starts_with("curve") || class == "shade"));
        assert!(lines.count() > 1, "{keys}");
        let said = document.descendants().find(|node| node.has_tag_name("desc")).unwrap().text().unwrap().to_owned();
        assert!(said.contains(&version) && hashes.iter().all(|hash| said.contains(hash.as_str())), "{said}");
        screen.keys("e");
        let page = write(&mut screen, &folder.path().join("out.html"));
        assert_alone(&page);
        let document = parsed(&page);
        let named = |name: &str| document.descendants().filter(|node| node.has_tag_name(name)).count();
        assert!(named("svg") == 1 && named("table") > 0 && named("h1") == 1, "{keys}");
        assert!(page.contains(&version) && hashes.iter().all(|hash| page.contains(hash.as_str())));
        // nothing else was left in the folder
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 5, "{keys}");
    }
}

/// The mean load on a bearing is what its elements carry together: sum Q cos(a) in the direction of each, sum Q sin(a) along the shaft.
#[test]
fn bearings_are_written_with_elements_that_carry_the_load() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tapered-axle.toml");
    let shipped = SHIPPED.iter().find(|shipped| shipped.file_name == "tapered-axle.toml").unwrap();
    fs::write(&path, shipped.text).unwrap();
    let mut screen = Screen::over(vec![path], 120, 40, Files::new(vec![folder.path().into()]));
    screen.keys("Be");
    assert!(screen.text().contains("tapered-axle-bearings.csv"), "{}", screen.text());
    let (first, heads, rows) = csv(&write(&mut screen, &folder.path().join("out.csv")));
    assert!(first.contains(&design::hash(shipped.text.as_bytes())), "{first}");
    let at = |name: &str| heads.iter().position(|head| head == name).unwrap_or_else(|| panic!("{name}: {heads:?}"));
    let number = |row: &[String], name: &str| row[at(name)].parse::<f64>().unwrap();
    let (elements, bearings): (Vec<_>, Vec<_>) = rows.iter().partition(|row| !row[at("element")].is_empty());
    let design = design::read(shipped.text).design.unwrap();
    assert_eq!(bearings.len(), design.pinion.bearings.len() + design.gear.bearings.len());
    let selected = bearings[0];
    assert_eq!(elements.len() as f64, number(selected, "elements"));
    let mut sum = [0.0; 3];
    for row in &elements {
        assert_eq!(row[at("bearing")], selected[at("bearing")]);
        let load = number(row, "element_load_n");
        let [azimuth, angle] = ["azimuth_deg", "contact_angle_deg"].map(|name| number(row, name).to_radians());
        sum[0] += load * angle.cos() * azimuth.sin();
        sum[1] += load * angle.sin();
        sum[2] += load * angle.cos() * azimuth.cos();
    }
    let force = ["force_x_n", "force_y_n", "force_z_n"].map(|name| number(selected, name));
    let size = force.iter().map(|value| value * value).sum::<f64>().sqrt();
    assert!(size > 1.0);
    for (sum, force) in sum.iter().zip(force) {
        assert!((sum - force).abs() < 1e-9 * size, "{sum} {force}");
    }
    screen.keys("E");
    let picture = write(&mut screen, &folder.path().join("out.svg"));
    assert_alone(&picture);
    let document = parsed(&picture);
    let bars = document
        .descendants()
        .filter(|node| node.has_tag_name("line") && node.attribute("class") == Some("curve pinion"));
    let loaded = elements.iter().filter(|row| number(row, "element_load_n") > 0.0).count();
    assert_eq!(bars.count(), loaded, "a bar on each loaded element");
    screen.keys("e");
    let page = write(&mut screen, &folder.path().join("out.html"));
    assert_alone(&page);
    let document = parsed(&page);
    assert_eq!(document.descendants().filter(|node| node.has_tag_name("table")).count(), 3);
    // a bearing whose stiffness is given has no elements, and no picture
    let linear = bearings.iter().position(|row| row[at("elements")].is_empty());
    assert_eq!(linear, None, "all bearings of this design roll");
}

/// The forces on both shafts turn them with and against the torque: F_t r of the pinion is the torque.
#[test]
fn the_gear_pair_is_written_with_forces_that_balance_the_torque() {
    let (folder, mut screen) = library();
    screen.keys("Pe");
    let (_, heads, rows) = csv(&write(&mut screen, &folder.path().join("out.csv")));
    assert_eq!(heads, ["figure", "pinion", "gear", "pair", "unit"]);
    let row = |name: &str| rows.iter().find(|row| row[0] == name).unwrap_or_else(|| panic!("{name}: {rows:?}"));
    let number = |name: &str, column: usize| row(name)[column].parse::<f64>().unwrap();
    let radius = number("mesh_point_x", 1).hypot(number("mesh_point_z", 1)) / 1e3;
    let torque = number("tangential_force", 1) * radius;
    assert!((torque.abs() - number("torque", 3)).abs() < 1e-9 * torque.abs(), "{torque}");
    let force = ["axial_force", "radial_force", "tangential_force"].map(|name| number(name, 2));
    let size = force.iter().map(|value| value * value).sum::<f64>().sqrt();
    // the shipped lines of action have few digits
    assert!((size / number("normal_force", 3) - 1.0).abs() < 1e-3, "{size}");
    assert_eq!((row("axial_force")[4].as_str(), row("torque_arm")[4].as_str()), ("N", "mm"));
}

fn solved(kind: ModelKind) -> (Design, Vec<f64>, Vec<num_complex::Complex64>) {
    let design = design::read(SHIPPED[0].text).design.unwrap();
    let lines = frequency_lines(&design.analysis);
    let force = solve(kind, &design, &Rotors::new(&design).unwrap(), &lines).unwrap().mesh_force;
    (design, lines, force)
}

#[test]
fn the_lines_in_sight_are_the_librarys_to_the_last_digit() {
    let (folder, mut screen) = library();
    screen.keys("w3iie");
    let (_, heads, rows) = csv(&write(&mut screen, &folder.path().join("lines.csv")));
    let of = |model: &str| [format!("{model}_mesh_force_n_re"), format!("{model}_mesh_force_n_im")];
    let wanted: Vec<String> = std::iter::once("frequency_hz".into()).chain(of("fe")).chain(of("enhanced")).collect();
    assert_eq!(heads, wanted);
    let axis = screen.app.spectra.as_ref().unwrap().axis().unwrap();
    let ((_, lines, fe), (.., enhanced)) = (solved(ModelKind::Fe), solved(ModelKind::Enhanced));
    let all = lines.iter().zip(fe.iter().zip(&enhanced)).filter(|(hz, _)| (axis.min..=axis.max).contains(*hz));
    let wanted: Vec<Vec<f64>> =
        all.map(|(hz, (fe, enhanced))| vec![*hz, fe.re, fe.im, enhanced.re, enhanced.im]).collect();
    assert!((200..300).contains(&wanted.len()), "a quarter of a thousand: {}", wanted.len());
    let found: Vec<Vec<f64>> = rows.iter().map(|row| row.iter().map(|cell| cell.parse().unwrap()).collect()).collect();
    assert_eq!(found, wanted);
}

#[test]
fn a_design_is_written_from_the_list_and_from_the_tables_through_the_palette() {
    let (folder, mut screen) = library();
    screen.keys(":export-shown<Enter>");
    assert!(screen.text().contains("overhung-elastic.html"), "{}", screen.text());
    let page = write(&mut screen, &folder.path().join("all.html"));
    assert!(page.contains("Trust the enhanced model up to 2,997 Hz"), "the whole report");
    screen.keys("<Enter>:export-shown<Enter>");
    let (first, heads, rows) = csv(&write(&mut screen, &folder.path().join("all.csv")));
    assert!(first.contains(&design::hash(SHIPPED[0].text.as_bytes())), "{first}");
    assert_eq!((heads.len(), rows.len()), (13, solved(ModelKind::Fe).1.len()));
    // `e` opens the tables in the list, and types into no file
    assert_eq!(screen.app.mode, Mode::Table);
}

#[test]
fn unsaved_edits_are_written_as_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let own = folder.path().join("own.toml");
    fs::write(&own, SHIPPED[0].text).unwrap();
    let edited = SHIPPED[0].text.replace("frequency_lines = 1000", "frequency_lines = 20");
    let files = Files::new(vec![folder.path().into()]);
    for name in ["a.csv", "a.svg", "a.html"] {
        let path = files.export_design(&folder.path().join(name), &own, Some(&edited)).unwrap();
        let text = fs::read_to_string(path).unwrap();
        assert!(
            text.contains(&design::hash(edited.as_bytes()))
                && !text.contains(&design::hash(SHIPPED[0].text.as_bytes()))
        );
    }
    let rows = csv(&fs::read_to_string(folder.path().join("a.csv")).unwrap()).2;
    assert_eq!(rows.len(), 20);
    let broken = files.export_design(&folder.path().join("b.csv"), &own, Some("format = 1"));
    assert!(broken.is_err() && !folder.path().join("b.csv").exists());
}

#[test]
fn nothing_is_lost_where_a_file_cannot_be_written() {
    let (folder, mut screen) = library();
    let taken = folder.path().join("taken.csv");
    fs::write(&taken, "mine").unwrap();
    screen.keys("we");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let design = path("overhung-rigid.toml");
    let cases = [
        (path("shown.png"), "the name must end in .csv (the data), .svg (the picture) or"),
        (design.clone(), "the name must end in"),
        (path("shown"), "the name must end in"),
        (String::new(), "a file needs a name"),
        (path("taken.csv"), "already"),
        (path("no/such/folder.csv"), "folder.csv"),
    ];
    for (name, why) in cases {
        screen.keys(&format!("<Ctrl-u>{name}<Enter>"));
        assert_eq!(screen.app.mode, Mode::Export);
        let text = screen.text().replace(['\n', '│'], " ").split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(why), "{name}: {text}");
        assert_eq!(screen.app.export.as_ref().unwrap().field.text(), name);
    }
    assert_eq!(fs::read_to_string(&taken).unwrap(), "mine");
    assert_eq!(fs::read_to_string(design).unwrap(), SHIPPED[1].text);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 3);
    // the name can be mended, or given up
    screen.keys("<Ctrl-u>");
    write_again(&mut screen, &folder.path().join("free.csv"));
    screen.keys("e<Esc>");
    assert_eq!(screen.app.mode, Mode::Spectra);
    assert!(screen.app.export.is_none());
}

fn write_again(screen: &mut Screen, path: &Path) {
    assert!(!write(screen, path).is_empty());
}

#[test]
fn a_screen_without_a_picture_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let paths: Vec<PathBuf> = ["a.toml", "b.toml"].iter().map(|name| folder.path().join(name)).collect();
    for path in &paths {
        fs::write(path, "format = 1\n").unwrap();
    }
    let mut screen = Screen::over(paths, 80, 24, Files::new(vec![folder.path().into()]));
    let svg = folder.path().join("o.svg");
    screen.keys(&format!("Oe<Ctrl-u>{}<Enter>", svg.display()));
    assert!(screen.text().contains("there is no picture in sight: write .csv or .html"), "{}", screen.text());
    assert!(!svg.exists());
    screen.keys("<Esc><Esc>we");
    assert!(screen.text().contains("there is nothing to write yet"), "{}", screen.text());
}
