//! What goes over the line to the terminal: as little as can be, and what it shows is what was drawn.
//!
//! The whole application on the shipped designs and the real solver, drawn by the writer that the terminal gets.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod tui_support;

use std::io::{self, Write};

use bevelscope::design::library::SHIPPED;
use bevelscope::tui::app::App;
use bevelscope::tui::caps::{Background, Capabilities, ColourDepth};
use bevelscope::tui::message::Message;
use bevelscope::tui::painter::Painter;
use bevelscope::tui::view;
use ratatui::Terminal;
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
const TO_BEARING: &str = "e2lll";

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
            // 6e8 N/m and a hundredth more
            let bytes = bytes_of(&mut line, &mut screen, "c6.06e8<Enter>");
            assert!(bytes > 500 && bytes <= edit, "an edit: {bytes}");
        }
    }
}
