//! Key scripts: the state before, the keys, the state after.

mod tui_support;

use bevelscope::tui::keymap::Mode;
use bevelscope::tui::keys;
use bevelscope::tui::message::{Effect, Ending, Message};
use tui_support::{ASCII, MadeUp, STEMS, Screen, Shelf, UNICODE, paths};

/// Keys, and the design that is selected after them.
const SELECTION: &[(&str, &str)] = &[
    ("", "overhung-elastic"),
    ("j", "overhung-rigid"),
    ("<Down><Down>k", "overhung-rigid"),
    ("k", "overhung-elastic"),
    ("G", "warned"),
    ("Gj", "warned"),
    ("Ggj", "overhung-rigid"),
    ("<End>", "warned"),
    ("<End><Home>", "overhung-elastic"),
    ("<PgDn>", "warned"),
    ("<PgDn><PgUp>", "overhung-elastic"),
    ("n", "overhung-elastic"),
    // typing narrows by file name
    ("/straddle", "straddle-elastic"),
    ("/STRADDLE<Enter>", "straddle-elastic"),
    // and by design name
    ("/rigid bear", "overhung-rigid"),
    // letters are text while the filter is typed, digits and marks too
    ("/qjkgGnN?", ""),
    ("/qjk<Ctrl-u>warn", "warned"),
    ("/qz<Backspace><Backspace>typo", "typo-in-bearing"),
    // arrows move while the filter is typed
    ("/elastic<Down>", "straddle-elastic"),
    // n and N go round among the matches
    ("/elastic<Enter>n", "straddle-elastic"),
    ("/elastic<Enter>nn", "overhung-elastic"),
    ("/elastic<Enter>N", "straddle-elastic"),
    // Esc drops the filter and stays on the design
    ("/straddle<Esc>j", "typo-in-bearing"),
    ("/straddle<Enter><Esc>j", "typo-in-bearing"),
    // the help takes the keys
    ("?jjjj<Esc>", "overhung-elastic"),
    ("?qj", "overhung-rigid"),
    // the error text takes them while it has the focus
    ("jjj<Tab>jj<Tab>", "typo-in-bearing"),
    ("jjjljjhj", "unsolvable"),
    ("jjj<Tab>jj<Esc>j", "unsolvable"),
    // without a text there is nothing to go to
    ("<Tab>j", "overhung-rigid"),
];

#[test]
fn keys_move_the_selection() {
    for (keys, selected) in SELECTION {
        let mut screen = Screen::new(80, 24, UNICODE);
        assert_eq!(screen.keys(keys).selected(), *selected, "{keys}");
    }
}

#[test]
fn the_right_side_follows_the_selection() {
    let mut screen = Screen::new(80, 24, UNICODE);
    for stem in STEMS {
        let name = screen.app.library.selected().unwrap().name();
        let text = screen.text();
        let shown: String = name.chars().take(15).collect();
        assert!(text.lines().next().unwrap().contains(&shown), "{stem}: {text}");
        assert_eq!(text.contains("cannot be read"), stem.starts_with("typo"), "{stem}");
        assert_eq!(text.contains("cannot be solved"), stem.starts_with("unsolvable"), "{stem}");
        assert_eq!(text.contains("trust up to"), !screen.app.has_text(), "{stem}");
        screen.keys("j");
    }
}

#[test]
fn quitting_keys_quit_and_escape_never_does() {
    let cases: &[(&str, bool)] = &[
        ("q", true),
        ("<Ctrl-c>", true),
        ("/<Ctrl-c>", true),
        ("?<Ctrl-c>", true),
        ("jjj<Tab>q", true),
        ("<Esc><Esc><Esc>", false),
        ("?<Esc><Esc>", false),
        ("/q<Esc><Esc>", false),
        ("jjj<Tab><Esc><Esc>", false),
        ("?q", false),
        ("/q", false),
    ];
    for (keys, quits) in cases {
        let mut screen = Screen::new(80, 24, UNICODE);
        screen.keys(keys);
        assert_eq!(screen.effects.contains(&Effect::Quit(Ending::Quit)), *quits, "{keys}");
    }
}

#[test]
fn escape_goes_back_one_level() {
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.keys("/typo<Enter><Tab>?");
    for mode in [Mode::Help, Mode::Text, Mode::Library] {
        assert_eq!(screen.app.mode, mode);
        screen.keys("<Esc>");
    }
    assert_eq!(screen.app.library.filter(), "");
}

#[test]
fn pasted_text_is_text_and_never_keys() {
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.send(Message::Paste("q".into()));
    assert!(!screen.effects.contains(&Effect::Quit(Ending::Quit)));
    screen.keys("/");
    screen.send(Message::Paste("straddle\nq".into()));
    assert_eq!((screen.app.library.filter(), screen.selected().as_str()), ("straddle", "straddle-elastic"));
}

#[test]
fn scrolling_is_held_at_both_ends() {
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.keys("?Gjjjj");
    let bottom = screen.app.help_scroll.top;
    assert_eq!(bottom, screen.app.help_scroll.last());
    assert!(bottom > 0);
    screen.keys("k");
    assert_eq!(screen.app.help_scroll.top, bottom - 1);
    // a larger window has room for more
    screen.resize(120, 400);
    assert_eq!(screen.app.help_scroll.top, 0);
}

#[test]
fn a_long_list_scrolls_with_the_selection() {
    let stems: Vec<String> = (0..500).map(|at| format!("design-{at:03}")).collect();
    let stems: Vec<&str> = stems.iter().map(String::as_str).collect();
    let mut screen = Screen::with(&stems, 80, 24, UNICODE, MadeUp);
    for keys in ["G", "<PgUp>", "kkkkkkkkkk", "<PgDn>", "g", "jjjjjjjjjjjj"] {
        let selected = screen.keys(keys).selected();
        let marked: Vec<_> = screen.text().lines().filter(|line| line.contains('▌')).map(str::to_owned).collect();
        assert_eq!(marked.len(), 1, "{keys}");
        assert!(marked[0].contains(&selected), "{keys}: {marked:?}");
    }
}

#[test]
fn rereading_asks_for_the_folder_the_selected_design_and_all_rows() {
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.effects.clear();
    screen.held = true;
    screen.keys("R");
    let [Effect::Solve(job), Effect::List, Effect::Fill(jobs)] = &screen.effects[..] else {
        panic!("{:?}", screen.effects)
    };
    assert_eq!(job.path, paths(&STEMS)[0]);
    assert_eq!(jobs.len(), STEMS.len());
    // what was known is still shown
    assert!(screen.text().contains("rereading") && screen.text().contains("2,997"), "{}", screen.text());

    screen.held = false;
    screen.send(Message::Listed(Ok(paths(&["added", "overhung-elastic"]))));
    assert_eq!((screen.selected().as_str(), screen.app.library.len()), ("overhung-elastic", 2));
    assert!(screen.text().contains("added"));
    screen.send(Message::Listed(Err("~/designs: no such folder".into())));
    assert!(screen.text().contains("no such folder"));
}

/// Keys that texts name, moved to others.
const MOVED: &str = r#"
[all]
"ctrl-g" = "back"
"esc" = "none"
"ctrl-q" = "quit"
"q" = "none"
"?" = "help"
[help]
"&" = "filter"
"/" = "none"
[library]
"F2" = "reread"
"R" = "none"
"F3" = "next-pane"
"tab" = "none"
[table]
"v" = "solve"
"=" = "none"
"w" = "findings"
"f" = "none"
"z" = "undo"
"u" = "none"
"f9" = "toggle-live"
"L" = "none"
"d" = "clear-cell"
"x" = "none"
"delete" = "none"
"o" = "other-shaft"
"p" = "none"
"i" = "edit-cell"
"enter" = "none"
"f10" = "materials"
"f7" = "none"
"#;

/// The explorer with the keys of [`MOVED`].
fn moved(stems: &[&str], shelf: Shelf) -> Screen {
    let mut screen = Screen::with(stems, 120, 40, ASCII, shelf);
    let remapped = keys::read(MOVED);
    assert_eq!(remapped.findings, []);
    screen.app.keys = remapped.keys;
    screen.draw();
    screen
}

#[test]
fn texts_name_the_keys_in_force() {
    let mut screen = moved(&["overhung-elastic"], Shelf::shipped());
    let mut says = |keys: &str, texts: &[&str]| {
        let text = screen.keys(keys).text();
        for wanted in texts {
            assert!(text.contains(wanted), "{keys}: no {wanted:?} in\n{text}");
        }
    };
    says("ej", &["F10 materials", "(o: gear)"]);
    says("<End>", &["(d clears)"]);
    says("<Home>lc38<Tab>", &["z: outer diameter"]);
    says("<F9>", &["v solves"]);
    says("<Home>lc39<Tab>", &["stale, live off: v solves"]);
    says("<Home>c-1<Tab>c-2<Tab>v", &["findings (w)", "(w lists them)"]);
    says("<F10>", &["i renames it"]);
    says("<F2><Ctrl-g>?", &["& searches, Ctrl-g closes"]);
    // before anything is there, and where there is no match
    let mut screen = moved(&[], Shelf::new(&[]));
    assert!(screen.text().contains("press F2, or quit with Ctrl-q"), "{}", screen.text());
    screen.resize(20, 10);
    assert!(screen.text().replace('\n', " ").contains("(Ctrl-q quits)"), "{}", screen.text());
    let mut screen = moved(&["overhung-elastic"], Shelf::shipped());
    screen.keys("/nothing");
    assert!(screen.text().contains("Ctrl-g drops the filter"), "{}", screen.text());
}
