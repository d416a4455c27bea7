//! What goes over the line to the terminal: as little as can be, and what it shows is what was drawn.
//!
//! The whole application on the shipped designs and the real solver, drawn by the writer that the terminal gets.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod tui_support;

use std::cell::Cell;
use std::io::{self, Write};
use std::rc::Rc;

use bevelscope::design::library::SHIPPED;
use bevelscope::tui::app::App;
use bevelscope::tui::caps::{Background, Capabilities, ColourDepth};
use bevelscope::tui::painter::Painter;
use bevelscope::tui::view;
use ratatui::backend::CrosstermBackend;
use ratatui::crossterm::style::force_color_output;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier};
use ratatui::{Terminal, TerminalOptions, Viewport};
use tui_support::{Screen, Shelf, UNICODE};

const INDEXED: Capabilities = Capabilities { colour: ColourDepth::Indexed, ..UNICODE };

/// A terminal at the end of the line.
struct Line {
    terminal: Terminal<Painter<Vec<u8>>>,
    shown: vt100::Parser,
}

impl Line {
    fn new(width: u16, height: u16, size: fn() -> io::Result<(u16, u16)>) -> Self {
        let terminal = Terminal::new(Painter::new(Vec::new(), size)).unwrap();
        Self { terminal, shown: vt100::Parser::new(height, width, 0) }
    }

    fn wide() -> Self {
        Self::new(120, 40, || Ok((120, 40)))
    }

    fn narrow() -> Self {
        Self::new(80, 24, || Ok((80, 24)))
    }

    /// Draws a frame; its bytes.
    fn draw(&mut self, app: &mut App) -> Vec<u8> {
        self.terminal.draw(|frame| view::draw(app, frame)).unwrap();
        let bytes = std::mem::take(self.terminal.backend_mut().writer_mut());
        let marks = |mark: &str| String::from_utf8_lossy(&bytes).matches(mark).count();
        let frames = usize::from(!bytes.is_empty());
        assert_eq!((marks("\x1b[?2026h"), marks("\x1b[?2026l")), (frames, frames));
        assert!(bytes.is_empty() || (bytes.starts_with(b"\x1b[?2026h") && bytes.ends_with(b"\x1b[?2026l")));
        self.shown.process(&bytes);
        bytes
    }
}

/// The explorer on the shipped designs, all solved, and its first frame drawn.
fn start(line: &mut Line, capabilities: Capabilities) -> Screen {
    let stems: Vec<_> = SHIPPED.iter().map(|shipped| shipped.file_name.trim_end_matches(".toml")).collect();
    let (rows, columns) = line.shown.screen().size();
    let mut screen = Screen::with(&stems, columns, rows, capabilities, Shelf::shipped());
    line.draw(&mut screen.app);
    screen
}

fn bytes_of(line: &mut Line, screen: &mut Screen, keys: &str) -> usize {
    screen.keys(keys);
    let bytes = line.draw(&mut screen.app);
    println!("{:?} {keys:<12} {:>6} bytes", line.shown.screen().size(), bytes.len());
    bytes.len()
}

/// To the stiffness kx of the pinion's first bearing.
const TO_BEARING: &str = "e<F2>llll";

#[test]
fn a_slow_line_carries_what_is_needed_and_no_more() {
    for background in [Background::Unknown, Background::Dark, Background::Light] {
        let capabilities = Capabilities { background, ..INDEXED };
        for (mut line, edit, other) in [(Line::wide(), 6 * 1024, 16 * 1024), (Line::narrow(), 3 * 1024, 6 * 1024)] {
            let mut screen = start(&mut line, capabilities);
            println!("{background:?}");
            for key in ["j", "j", "k", "k"] {
                let bytes = bytes_of(&mut line, &mut screen, key);
                assert!(bytes > 1000 && bytes <= other, "another design: {bytes}");
            }
            bytes_of(&mut line, &mut screen, TO_BEARING);
            for key in ["l", "l", "h", "j", "k", "h"] {
                let bytes = bytes_of(&mut line, &mut screen, key);
                assert!(bytes > 10 && bytes <= 600, "a cell further: {bytes}");
            }
            // 6.0e8 N/m and a hundredth more
            let bytes = bytes_of(&mut line, &mut screen, "c6.06e8<Enter>");
            assert!(screen.text().contains("6.06e8"), "{}", screen.text());
            assert!(bytes > 500 && bytes <= edit, "an edit: {bytes}");
        }
    }
}

/// A copy of a design under another name: the picture is the same.
#[test]
fn a_cursor_that_moves_under_the_same_picture_costs_little() {
    let text = SHIPPED[0].text;
    let mut line = Line::wide();
    let mut screen =
        Screen::with(&["a", "b", "c"], 120, 40, INDEXED, Shelf::new(&[("a", text), ("b", text), ("c", text)]));
    line.draw(&mut screen.app);
    for key in ["j", "j", "k"] {
        let bytes = bytes_of(&mut line, &mut screen, key);
        assert!(bytes > 10 && bytes <= 600, "a row further: {bytes}");
    }
}

/// Screens one after the other, with windows, wide characters and a cursor.
const SCRIPTS: [&str; 4] = [
    "jbbjbb",
    "?/move<Enter><Esc><Esc>:cycle<Enter>:toggle-background<Enter>",
    "mjc<Esc>/over<Esc>rdritte 歯車<Esc>",
    "e<F2>llllc6.06e8<Enter>kl9<Esc>f<Esc>:help<Esc><F3>c\u{301}<Esc>u<Esc>",
];

#[test]
fn what_the_line_carries_is_what_was_drawn() {
    for colour in [ColourDepth::None, ColourDepth::Sixteen, ColourDepth::Indexed, ColourDepth::True] {
        for script in SCRIPTS {
            let mut line = Line::narrow();
            let mut screen = start(&mut line, Capabilities { colour, background: Background::Dark, ascii: false });
            for key in keys(script) {
                screen.keys(key);
                line.draw(&mut screen.app);
                assert_shows(line.shown.screen(), &screen, &format!("{colour:?} {script} {key}"));
                // nothing has changed, so nothing is sent
                assert_eq!(line.draw(&mut screen.app), b"");
            }
        }
    }
}

/// The keys of a script one by one.
fn keys(script: &str) -> Vec<&str> {
    let mut keys = Vec::new();
    let mut rest = script;
    while let Some(first) = rest.chars().next() {
        let length = if first == '<' { rest.find('>').map_or(1, |end| end + 1) } else { first.len_utf8() };
        let (key, after) = rest.split_at(length);
        keys.push(key);
        rest = after;
    }
    keys
}

fn assert_shows(shown: &vt100::Screen, screen: &Screen, when: &str) {
    let buffer = screen.buffer();
    for row in 0..buffer.area.height {
        for column in 0..buffer.area.width {
            let (cell, drawn) = (shown.cell(row, column).unwrap(), &buffer[(column, row)]);
            if cell.is_wide_continuation() {
                continue;
            }
            let place =
                || format!("{when}: column {column}, row {row}: {drawn:?} shown as {cell:?}\n{}", screen.text());
            let text = if cell.has_contents() { cell.contents() } else { " " };
            assert_eq!(text, drawn.symbol(), "{}", place());
            assert_eq!(cell.inverse(), drawn.modifier.contains(Modifier::REVERSED), "{}", place());
            assert_eq!(cell.bgcolor(), as_shown(drawn.bg), "{}", place());
            if text != " " {
                assert_eq!(cell.fgcolor(), as_shown(drawn.fg), "{}", place());
                // this terminal knows one weight at a time
                let [bold, dim] = [Modifier::BOLD, Modifier::DIM].map(|weight| drawn.modifier.contains(weight));
                assert_eq!(cell.bold() || cell.dim(), bold || dim, "{}", place());
                assert!(bold && dim || cell.bold() == bold, "{}", place());
            }
        }
    }
    let cursor = screen.terminal.backend();
    assert_eq!(shown.hide_cursor(), !cursor.cursor_visible(), "{when}");
    if cursor.cursor_visible() {
        let place = cursor.cursor_position();
        assert_eq!(shown.cursor_position(), (place.y, place.x), "{when}");
    }
}

fn as_shown(colour: Color) -> vt100::Color {
    match colour {
        Color::Indexed(place) => vt100::Color::Idx(place),
        Color::Rgb(red, green, blue) => vt100::Color::Rgb(red, green, blue),
        Color::Red => vt100::Color::Idx(1),
        Color::Yellow => vt100::Color::Idx(3),
        Color::Blue => vt100::Color::Idx(4),
        Color::Magenta => vt100::Color::Idx(5),
        Color::Cyan => vt100::Color::Idx(6),
        Color::Gray => vt100::Color::Idx(7),
        Color::DarkGray => vt100::Color::Idx(8),
        _ => vt100::Color::Default,
    }
}

struct Counter(Rc<Cell<usize>>);

impl Write for Counter {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.set(self.0.get() + bytes.len());
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// The same frames by ratatui's own writer cost more, or this one would not be worth its lines.
#[test]
fn the_writer_is_worth_its_lines() {
    let mut line = Line::wide();
    let mut screen = start(&mut line, INDEXED);
    let viewport = TerminalOptions { viewport: Viewport::Fixed(Rect::new(0, 0, 120, 40)) };
    force_color_output(true);
    let counted = Rc::new(Cell::new(0));
    let mut usual = Terminal::with_options(CrosstermBackend::new(Counter(Rc::clone(&counted))), viewport).unwrap();
    let mut usual_bytes = |app: &mut App| {
        usual.draw(|frame| view::draw(app, frame)).unwrap();
        counted.take()
    };
    usual_bytes(&mut screen.app);
    for key in keys("jke<F2>llll").into_iter().chain(["l", "j", "hkc6.06e8<Enter>"]) {
        let bytes = bytes_of(&mut line, &mut screen, key);
        let usual = usual_bytes(&mut screen.app);
        println!("{key}: {bytes}, usually {usual}");
        assert!(bytes <= usual * 9 / 10, "{key}: {bytes} and {usual}");
    }
}
