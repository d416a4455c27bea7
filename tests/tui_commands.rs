//! Palette, help, remapped keys, files of the library and the comparison of two designs: the state before, the keys, the
//! state after, through the whole explorer.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod tui_support;

use std::path::{Path, PathBuf};
use std::sync::Mutex;

use bevelscope::comparison::{Comparison, Observer, SolveError};
use bevelscope::design::library::{TRASH, Trashed};
use bevelscope::design::{Design, Difference, KeyPath};
use bevelscope::tui::action::ACTIONS;
use bevelscope::tui::files::{FileDone, FileRequest};
use bevelscope::tui::help::HelpLine;
use bevelscope::tui::keymap::{Mode, is_known};
use bevelscope::tui::keys;
use bevelscope::tui::message::{Effect, Ending, Message};
use bevelscope::tui::notice::NoticeKind;
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign};
use insta::assert_snapshot;
use tui_support::{ASCII, MadeUp, Screen, Shelf, UNICODE, paths};

/// A folder in memory whose files can be changed.
#[derive(Debug)]
struct Folder {
    files: Mutex<Vec<PathBuf>>,
    /// Every change fails.
    locked: bool,
}

const FILES: [&str; 5] = ["base", "base-stiff", "base-stiff-2", "other", "typo"];

impl Folder {
    fn new() -> Self {
        Self { files: Mutex::new(paths(&FILES)), locked: false }
    }

    fn screen(width: u16, height: u16) -> Screen {
        Screen::with(&FILES, width, height, UNICODE, Self::new())
    }
}

impl Backend for Folder {
    fn load(&self, path: &Path) -> Result<LoadedDesign, BrokenDesign> {
        let mut loaded = MadeUp.load(path)?;
        loaded.design.parent = match path.file_stem().unwrap().to_str().unwrap() {
            "base-stiff" => Some("base".into()),
            "base-stiff-2" => Some("base-stiff".into()),
            _ => None,
        };
        Ok(loaded)
    }

    fn compare(&self, design: &Design, observer: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        let mut comparison = MadeUp.compare(design, observer)?;
        if design.name.contains("stiff") {
            comparison.fe.mesh_force.iter_mut().for_each(|force| *force *= 2.0);
            comparison.enhanced_agreement.agreement_limit_hz = 3364.0;
        }
        Ok(comparison)
    }

    fn list(&self) -> Option<Result<Vec<PathBuf>, String>> {
        let mut files = self.files.lock().unwrap().clone();
        files.sort();
        Some(Ok(files))
    }

    fn change_file(&self, request: &FileRequest) -> Result<FileDone, String> {
        if self.locked {
            return Err("/designs: Permission denied".into());
        }
        let mut files = self.files.lock().unwrap();
        let taken = |files: &[PathBuf], path: &PathBuf| {
            let error = format!("{}: there is a file of that name already", path.display());
            if files.contains(path) { Err(error) } else { Ok(path.clone()) }
        };
        Ok(match request {
            FileRequest::Rename { path, name } => {
                let to = taken(&files, &name.path_in(Path::new("/designs")))?;
                files.retain(|file| file != path);
                files.push(to.clone());
                FileDone::Renamed { from: path.clone(), to, variants: Vec::new() }
            }
            FileRequest::Duplicate { path, name } => {
                let to = taken(&files, &name.path_in(Path::new("/designs")))?;
                files.push(to.clone());
                FileDone::Duplicated { from: path.clone(), to }
            }
            FileRequest::Create { name, .. } => {
                let path = taken(&files, &name.path_in(Path::new("/designs")))?;
                files.push(path.clone());
                FileDone::Created { path }
            }
            FileRequest::Delete { path } => {
                files.retain(|file| file != path);
                let file_name = path.file_name().unwrap().to_str().unwrap().to_owned();
                let trashed = Path::new("/designs").join(TRASH).join(&file_name);
                FileDone::Deleted {
                    path: path.clone(),
                    trashed: Trashed { path: trashed, file_name, when: "2025-01-31 12:00:00".into() },
                }
            }
            FileRequest::Restore(trashed) => {
                let trashed = trashed.as_ref().ok_or("nothing was deleted here")?;
                let path = taken(&files, &Path::new("/designs").join(&trashed.file_name))?;
                files.push(path.clone());
                FileDone::Restored { path }
            }
        })
    }

    fn differences(&self, _: &Path, _: &Path) -> Result<Vec<Difference>, String> {
        let bearing = KeyPath::root().key("pinion").key("bearing").name("B1");
        let one = |key: &str, label: &str, a: Option<&str>, b: Option<&str>, unit| Difference {
            is_number: false,
            is_row: key == "flange",
            path: bearing.key(key),
            path_in_b: bearing.key(key),
            label: label.into(),
            label_in_b: label.into(),
            a: a.map(Into::into),
            b: b.map(Into::into),
            unit,
        };
        Ok(vec![
            one("position_mm", "position of pinion bearing B1", Some("55.0"), Some("57.5"), "mm"),
            one("kx_n_per_m", "kx of pinion bearing B1", Some("6.0e8"), Some("7.5e8"), "N/m"),
            one(
                "axial_series_stiffness_n_per_m",
                "axial series stiffness of pinion bearing B1",
                None,
                Some("9e8"),
                "N/m",
            ),
            one("flange", "pinion body flange", Some("row"), None, ""),
        ])
    }
}

fn stems(screen: &Screen) -> Vec<String> {
    screen.app.library.visible().map(|visible| format!("{}{}", "-".repeat(visible.depth), visible.row.stem)).collect()
}

fn said(screen: &Screen) -> &str {
    screen.app.notice.as_ref().map_or("", |notice| &notice.text)
}

/// Over the tables of a design: the palette has their actions, and what lies over them goes back to them.
#[test]
fn the_palette_and_the_help_lie_over_the_tables_as_well() {
    let mut screen = Screen::with(&["overhung-elastic"], 80, 24, UNICODE, Shelf::shipped());
    screen.keys("e:");
    let found: Vec<_> = screen.app.palette_entries().iter().map(|entry| entry.about.name).collect();
    for about in ACTIONS.iter().filter(|about| about.name != "palette") {
        assert_eq!(found.contains(&about.name), is_known(Mode::Table, about.action), "{}", about.name);
    }
    screen.keys("add-row<Enter>");
    assert_eq!(screen.app.mode, Mode::Table);
    assert!(screen.app.library.selected().unwrap().unsaved, "{}", screen.text());
    for (script, mode) in [("?", Mode::Help), (":", Mode::Palette), ("<Esc>", Mode::Help), ("<Esc>", Mode::Table)] {
        assert_eq!(screen.keys(script).app.mode, mode, "{script}");
    }
    // unsaved edits go before anything is done with the file
    for script in ["<Esc>r", "D"] {
        screen.keys(script);
        assert!(said(&screen).contains("save them first"), "{script}: {}", said(&screen));
        assert_eq!(screen.app.mode, Mode::Library);
    }
    screen.keys(":quit<Enter>");
    assert_eq!(screen.app.mode, Mode::Leave);
    screen.keys("<Esc>");
    assert_eq!(screen.app.mode, Mode::Library);
}

/// Keys, the mode after them, and what is selected.
const SCRIPTS: &[(&str, Mode, &str)] = &[
    (":", Mode::Palette, "base"),
    (":<Esc>", Mode::Library, "base"),
    (":q", Mode::Palette, "base"),
    (":last<Enter>", Mode::Library, "typo"),
    (":help<Enter>", Mode::Help, "base"),
    ("?:<Esc>", Mode::Help, "base"),
    // from the help only what the help can do
    ("?:rename<Enter>", Mode::Palette, "base"),
    // nothing found: nothing is run
    (":xyzzy<Enter>", Mode::Palette, "base"),
    (":xyzzy<Ctrl-u>last<Enter>", Mode::Library, "typo"),
    ("jr", Mode::Name, "base-stiff"),
    ("jr<Esc>", Mode::Library, "base-stiff"),
    // letters are text in a form
    ("r<Ctrl-u>qD?:", Mode::Name, "base"),
    ("D", Mode::Confirm, "base"),
    ("Dn", Mode::Library, "base"),
    ("D<Esc>", Mode::Library, "base"),
    // any other key leaves the question where it is
    ("Dqj", Mode::Confirm, "base"),
    ("Dy", Mode::Library, "base-stiff"),
    ("Dyu", Mode::Library, "base"),
    ("m", Mode::Library, "base"),
    ("mjc", Mode::Compare, "base-stiff"),
    ("mjcq", Mode::Library, "base-stiff"),
    ("mjc<Esc>j", Mode::Library, "base-stiff-2"),
    ("mjc?<Esc>", Mode::Compare, "base-stiff"),
    ("mjc:<Esc><Esc>", Mode::Library, "base-stiff"),
    // without a mark: the parent
    ("jc", Mode::Compare, "base-stiff"),
    // neither mark nor parent
    ("c", Mode::Library, "base"),
    ("mc", Mode::Library, "base"),
    ("!", Mode::Messages, "base"),
    ("!<Esc>", Mode::Library, "base"),
    // the text pane is returned to
    ("G<Tab>:<Esc>", Mode::Text, "typo"),
    ("G<Tab>?/x<Enter><Esc><Esc>", Mode::Text, "typo"),
    ("?/", Mode::HelpSearch, "base"),
    ("?/q<Enter>", Mode::Help, "base"),
    ("?/q<Esc><Esc>", Mode::Library, "base"),
];

#[test]
fn keys_lead_where_they_should() {
    for (script, mode, selected) in SCRIPTS {
        let mut screen = Folder::screen(80, 24);
        screen.keys(script);
        assert_eq!((screen.app.mode, screen.selected().as_str()), (*mode, *selected), "{script}");
        assert!(!screen.effects.contains(&Effect::Quit(Ending::Quit)), "{script}");
    }
}

#[test]
fn the_palette_finds_by_letters_in_order_and_shows_the_keys() {
    let mut screen = Folder::screen(80, 24);
    screen.keys(":rd");
    let first = screen.text().lines().find(|line| line.contains("▌ ") || line.contains("▌r")).unwrap().to_owned();
    assert!(first.contains("restore-deleted") && first.contains(" u "), "{first}");
    screen.keys("<Esc>:quit<Enter>");
    assert!(screen.effects.contains(&Effect::Quit(Ending::Quit)));
}

#[test]
fn every_action_is_in_the_palette_of_a_mode_that_has_it_or_has_a_key_there() {
    for mode in [Mode::Library, Mode::Text, Mode::Help, Mode::Compare] {
        let mut screen = Folder::screen(80, 24);
        screen.keys(match mode {
            Mode::Text => "G<Tab>",
            Mode::Help => "?",
            Mode::Compare => "jc",
            _ => "",
        });
        assert_eq!(screen.app.mode, mode);
        screen.keys(":");
        let found: Vec<_> = screen.app.palette_entries().iter().map(|entry| entry.about.name).collect();
        for about in ACTIONS.iter().filter(|about| about.name != "palette") {
            assert_eq!(found.contains(&about.name), is_known(mode, about.action), "{mode:?} {}", about.name);
        }
    }
}

#[test]
fn every_action_is_in_the_help_with_its_keys() {
    let mut lines = Folder::screen(80, 24).app.help_lines();
    // the help over the tables has theirs
    let mut tables = Screen::with(&["overhung-elastic"], 80, 24, UNICODE, Shelf::shipped());
    lines.extend(tables.keys("e").app.help_lines());
    for about in ACTIONS {
        let line = lines.iter().find(|line| matches!(line, HelpLine::Entry { name, .. } if *name == about.name));
        let Some(HelpLine::Entry { keys, text, .. }) = line else { panic!("no help for {}", about.name) };
        assert!(!keys.is_empty() && text == about.doc, "{}", about.name);
    }
}

#[test]
fn the_help_is_searched() {
    let mut screen = Folder::screen(80, 24);
    screen.keys("?/design's");
    let text = screen.text();
    assert!(text.contains("rename the design's file") && !text.contains("after the last letter"), "{text}");
    // names find their action, though they are not shown
    screen.keys("<Ctrl-u>restore-del");
    assert!(screen.text().contains("bring back what was deleted last"), "{}", screen.text());
    screen.keys("<Ctrl-u>e<Enter>");
    let place = |screen: &Screen| {
        let title = screen.text().lines().find(|line| line.contains("Help /e")).unwrap().to_owned();
        title.split("Help /e").nth(1).unwrap().split_whitespace().next().unwrap().parse::<usize>().unwrap()
    };
    assert_eq!(place(&screen), 1);
    screen.keys("nn");
    assert_eq!(place(&screen), 3);
    // round and round, and always in sight
    screen.keys("NNN");
    assert!(place(&screen) > 20);
    assert!(screen.text().contains("│ ▌ "), "{}", screen.text());
    screen.keys("n");
    assert_eq!(place(&screen), 1);
    screen.keys("/nothing has this");
    assert!(screen.text().contains("no match"), "{}", screen.text());
    // Esc: the search first, then the help
    screen.keys("<Esc>");
    assert_eq!(screen.app.mode, Mode::Help);
}

#[test]
fn remapped_keys_are_in_force_and_shown_everywhere() {
    let mut screen = Folder::screen(80, 24);
    let remapped = keys::read("[library]\n\"f5\" = \"rename\"\n\"r\" = \"none\"\n\"Q\" = \"quit\"\n\"m\" = \"last\"\n");
    assert_eq!(remapped.findings, []);
    screen.app.keys = remapped.keys;
    screen.keys("r");
    assert_eq!(screen.app.mode, Mode::Library);
    screen.keys("m");
    assert_eq!(screen.selected(), "typo");
    screen.keys("<F5>");
    assert_eq!(screen.app.mode, Mode::Name);
    screen.keys("<Esc>");
    assert!(screen.text().contains("Q quit"), "{}", screen.text());
    screen.keys(":rename");
    assert!(screen.text().lines().any(|line| line.contains("rename") && line.contains("F5")), "{}", screen.text());
    screen.keys("<Esc>?/rename the");
    assert!(screen.text().lines().any(|line| line.contains("F5") && line.contains("rename")), "{}", screen.text());
    // what lost its key in one mode has it in another; where it has none it is named for the palette
    let keys_of = |screen: &mut Screen, doc: &str| -> Vec<String> {
        let text = screen.keys("<Ctrl-u>").keys(doc).text();
        let lines = text.lines().filter(|line| line.contains(&format!(" {doc}")) && !line.contains('/'));
        let key = |line: &str| line.trim_start_matches(['│', ' ', '▌']).split(' ').next().unwrap().to_owned();
        lines.map(key).collect()
    };
    assert_eq!(keys_of(&mut screen, "mark the design"), [":mark", "m"], "{}", screen.text());
    screen.app.keys = keys::read("[all]\nm = \"none\"\n").keys;
    assert_eq!(keys_of(&mut screen, "mark the design"), [":mark"], "{}", screen.text());
    screen.keys("<Esc><Esc><Ctrl-c>");
    assert!(screen.effects.contains(&Effect::Quit(Ending::Quit)));
}

#[test]
fn what_is_wrong_with_the_keys_is_said_and_can_be_read_in_full() {
    let mut screen = Folder::screen(80, 24);
    screen.app.complain_at_length(
        "keys (! shows all): line 3: there is no action `jump`",
        "keys.toml:3:8: error: ...".into(),
    );
    screen.draw();
    assert!(screen.text().contains("there is no action `jump`"), "{}", screen.text());
    screen.keys("j");
    assert!(!screen.text().contains("there is no action"), "{}", screen.text());
    screen.keys("!");
    assert!(screen.text().contains("keys.toml:3:8"), "{}", screen.text());
}

#[test]
fn variants_stand_below_their_parents() {
    let mut screen = Folder::screen(80, 24);
    assert_eq!(stems(&screen), ["base", "-base-stiff", "--base-stiff-2", "other", "typo"]);
    screen.keys("t");
    assert_eq!(stems(&screen), ["base", "base-stiff", "base-stiff-2", "other", "typo"]);
    // what the filter leaves keeps its order; a variant without its parent in sight stands at the top
    screen.keys("t/2");
    assert_eq!(stems(&screen), ["base-stiff-2"]);
    screen.keys("<Esc>/stiff<Enter>");
    assert_eq!(
        (stems(&screen), screen.selected()),
        (vec!["base-stiff".into(), "-base-stiff-2".into()], "base-stiff-2".into())
    );
    screen.keys("<Esc>j");
    assert_eq!(screen.selected(), "other");
}

#[test]
fn files_are_renamed_copied_deleted_and_brought_back() {
    let mut screen = Folder::screen(80, 24);
    screen.keys("jjjr");
    assert_eq!(screen.app.form.as_ref().unwrap().field.text(), "other");
    // the same name is none, nor is one that is taken, nor one that no system takes
    screen.keys("<Enter>");
    assert!(screen.text().contains("this is its name now"), "{}", screen.text());
    screen.keys("<Ctrl-u>base");
    assert!(screen.text().contains("of that name already"), "{}", screen.text());
    screen.keys("<Enter>");
    assert_eq!(screen.app.mode, Mode::Name);
    screen.keys("<Ctrl-u>a/b<Enter>");
    assert_eq!(screen.app.mode, Mode::Name);
    screen.keys("<Ctrl-u>another<Enter>");
    assert_eq!((screen.app.mode, screen.selected().as_str()), (Mode::Library, "another"));
    assert_eq!(said(&screen), "renamed other to another");
    assert_eq!(stems(&screen), ["another", "base", "-base-stiff", "--base-stiff-2", "typo"]);

    screen.keys("Y<Enter>");
    assert_eq!((screen.selected().as_str(), said(&screen)), ("another-2", "copied another to another-2"));
    screen.keys("D");
    assert!(screen.text().contains("Move another-2 to the trash"), "{}", screen.text());
    screen.keys("y");
    assert_eq!(stems(&screen), ["another", "base", "-base-stiff", "--base-stiff-2", "typo"]);
    assert_eq!(said(&screen), "deleted another-2; u brings it back");
    screen.keys("Gu");
    assert_eq!((screen.selected().as_str(), said(&screen)), ("another-2", "another-2 is back"));
    screen.keys("u");
    assert_eq!(said(&screen), "nothing was deleted here");
}

#[test]
fn what_the_file_system_refuses_is_said_beside_the_name() {
    let mut screen = Screen::with(&FILES, 80, 24, UNICODE, Folder { locked: true, ..Folder::new() });
    screen.keys("rx<Enter>");
    assert_eq!(screen.app.mode, Mode::Name);
    assert_eq!(screen.text().matches("Permission denied").count(), 2, "{}", screen.text());
    // another letter, another try
    screen.keys("y");
    assert!(!screen.text().contains("Permission denied"), "{}", screen.text());
    screen.keys("<Esc>Dy");
    assert_eq!(screen.app.notice.as_ref().map(|notice| notice.kind), Some(NoticeKind::Failed));
    assert_eq!(stems(&screen).len(), FILES.len());
    // a library that cannot be changed says so
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.keys("rx<Enter>");
    assert!(screen.text().contains("cannot be changed"), "{}", screen.text());
}

#[test]
fn a_file_request_is_made_once_and_its_result_taken_after_the_form_has_gone() {
    let mut screen = Folder::screen(80, 24);
    screen.held = true;
    screen.effects.clear();
    screen.keys("rx<Enter><Enter>y");
    let [Effect::ChangeFile(request)] = &screen.effects[..] else { panic!("{:?}", screen.effects) };
    let request = request.clone();
    assert_eq!(screen.app.form.as_ref().unwrap().field.text(), "x");
    screen.keys("<Esc>j");
    screen.send(Message::FileChanged { request, result: Err("the folder is full".into()) });
    assert_eq!((screen.app.mode, said(&screen)), (Mode::Library, "the folder is full"));
}

#[test]
fn two_designs_are_compared() {
    let mut screen = Folder::screen(80, 24);
    screen.keys("m");
    assert!(screen.text().contains("◆ base"), "{}", screen.text());
    screen.keys("jc");
    let text = screen.text();
    for shown in ["A base", "B base-stiff", "4 differences", "kx of pinion bearing B1", "7.5e8", "3,364", "6.02 dB RMS"]
    {
        assert!(text.contains(shown), "{shown}: {text}");
    }
    // what is asked for again takes the place of what came before
    screen.held = true;
    screen.keys("q");
    screen.effects.clear();
    screen.keys("jc");
    let [.., Effect::Compare(job)] = &screen.effects[..] else { panic!("{:?}", screen.effects) };
    assert_eq!(job.paths, paths(&["base", "base-stiff-2"])[..]);
    assert!(screen.text().contains("Reading and solving"), "{}", screen.text());
}

#[test]
fn designs_without_a_solution_are_compared_as_far_as_they_can_be() {
    let mut screen = Folder::screen(80, 24);
    screen.keys("mGc");
    let text = screen.text();
    for shown in ["B: line 14: unknown key", "no agreement without a solution"] {
        assert!(text.contains(shown), "{shown}: {text}");
    }
    // a library without files says why there are no differences
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.keys("jjjmjc");
    assert!(screen.text().contains("neither design has a solution"), "{}", screen.text());
}

#[test]
fn palette_80x24_ascii() {
    assert_snapshot!(Screen::with(&FILES, 80, 24, ASCII, Folder::new()).keys(":re").text());
}

#[test]
fn palette_120x40() {
    assert_snapshot!(Folder::screen(120, 40).keys("jm:").text());
}

#[test]
fn help_searched_80x24_ascii() {
    assert_snapshot!(Screen::with(&FILES, 80, 24, ASCII, Folder::new()).keys("?/design<Enter>nn").text());
}

#[test]
fn name_refused_80x24_ascii() {
    assert_snapshot!(Screen::with(&FILES, 80, 24, ASCII, Folder::new()).keys("jr<Ctrl-u>other").text());
}

#[test]
fn delete_question_80x24() {
    assert_snapshot!(Folder::screen(80, 24).keys("D").text());
}

#[test]
fn compare_80x24_ascii() {
    assert_snapshot!(Screen::with(&FILES, 80, 24, ASCII, Folder::new()).keys("jc").text());
}

#[test]
fn compare_120x40() {
    assert_snapshot!(Folder::screen(120, 40).keys("jc").text());
}

#[test]
fn compare_60x18() {
    assert_snapshot!(Folder::screen(60, 18).keys("jc").text());
}

#[test]
fn messages_80x24() {
    assert_snapshot!(Folder::screen(80, 24).keys("mjrx<Enter>u!").text());
}
