//! Frames written in as few bytes as a slow line asks for.
//!
//! ratatui finds the cells that differ from the frame before; this writes them. The cursor moves by the shortest sequence, a
//! style says only what changes from the one before it, and of a blank cell only what shows. All of a frame goes out in one
//! write, between the marks of one synchronized update; where nothing differs, nothing is written.

use std::io::{self, Write};

use ratatui::backend::{Backend, ClearType, WindowSize};
use ratatui::buffer::Cell;
use ratatui::layout::{Position, Size};
use unicode_width::UnicodeWidthStr;

use super::pen::Pen;

const BEGIN: &[u8] = b"\x1b[?2026h";
const END: &[u8] = b"\x1b[?2026l";

/// A terminal behind a writer.
#[derive(Debug)]
pub struct Painter<W: Write> {
    out: W,
    size: fn() -> io::Result<(u16, u16)>,
    /// What is to be written between the marks.
    frame: Vec<u8>,
    /// What the terminal writes with, where the cursor stands and whether it shows; `None` is not known.
    pen: Option<Pen>,
    place: Option<Position>,
    shows_cursor: Option<bool>,
}

impl<W: Write> Painter<W> {
    /// Writes to a terminal whose columns and rows `size` tells.
    pub fn new(out: W, size: fn() -> io::Result<(u16, u16)>) -> Self {
        Self { out, size, frame: Vec::new(), pen: None, place: None, shows_cursor: None }
    }

    /// The state of the terminal is no longer known: someone else has written to it.
    pub fn forget(&mut self) {
        (self.pen, self.place, self.shows_cursor) = (None, None, None);
    }

    /// Where the bytes go.
    pub fn writer_mut(&mut self) -> &mut W {
        &mut self.out
    }

    fn put(&mut self, text: &str) {
        self.frame.extend_from_slice(text.as_bytes());
    }

    fn go_to(&mut self, to: Position) {
        if self.place != Some(to) {
            let text = shortest_move(self.place, to);
            self.put(&text);
            self.place = Some(to);
        }
    }

    fn style(&mut self, cell: &Cell) {
        let wanted = Pen { fg: cell.fg, bg: cell.bg, modifier: cell.modifier };
        let wanted = match self.pen {
            Some(now) if cell.symbol() == " " => wanted.for_blank(now),
            _ => wanted,
        };
        if self.pen != Some(wanted) {
            let text = wanted.sequence(self.pen);
            self.put(&text);
            self.pen = Some(wanted);
        }
    }
}

impl<W: Write> Backend for Painter<W> {
    type Error = io::Error;

    fn draw<'a, I>(&mut self, content: I) -> io::Result<()>
    where
        I: Iterator<Item = (u16, u16, &'a Cell)>,
    {
        let (width, _) = (self.size)()?;
        for (x, y, cell) in content {
            self.go_to(Position { x, y });
            self.style(cell);
            self.put(cell.symbol());
            // terminals disagree about the width of anything but single narrow characters, and about where the cursor is
            // after the last column
            let mut characters = cell.symbol().chars();
            let is_simple = characters.next().is_some() && characters.next().is_none() && cell.symbol().width() == 1;
            self.place = (is_simple && x + 1 < width).then_some(Position { x: x + 1, y });
        }
        Ok(())
    }

    fn hide_cursor(&mut self) -> io::Result<()> {
        if self.shows_cursor != Some(false) {
            self.put("\x1b[?25l");
            self.shows_cursor = Some(false);
        }
        Ok(())
    }

    fn show_cursor(&mut self) -> io::Result<()> {
        if self.shows_cursor != Some(true) {
            self.put("\x1b[?25h");
            self.shows_cursor = Some(true);
        }
        Ok(())
    }

    /// The terminal is never asked: its answer would be read as keys.
    fn get_cursor_position(&mut self) -> io::Result<Position> {
        Ok(self.place.unwrap_or_default())
    }

    fn set_cursor_position<P: Into<Position>>(&mut self, position: P) -> io::Result<()> {
        self.go_to(position.into());
        Ok(())
    }

    fn clear(&mut self) -> io::Result<()> {
        self.clear_region(ClearType::All)
    }

    fn clear_region(&mut self, clear_type: ClearType) -> io::Result<()> {
        let erase = match clear_type {
            ClearType::All => "\x1b[2J",
            ClearType::AfterCursor => "\x1b[J",
            ClearType::BeforeCursor => "\x1b[1J",
            ClearType::CurrentLine => "\x1b[2K",
            ClearType::UntilNewLine => "\x1b[K",
        };
        // many terminals erase with the colour they write with
        let plain = Pen::default().sequence(self.pen);
        self.pen = Some(Pen::default());
        self.put(&plain);
        self.put(erase);
        Ok(())
    }

    fn size(&self) -> io::Result<Size> {
        (self.size)().map(Size::from)
    }

    fn window_size(&mut self) -> io::Result<WindowSize> {
        Ok(WindowSize { columns_rows: self.size()?, pixels: Size::default() })
    }

    /// Ends the frame.
    fn flush(&mut self) -> io::Result<()> {
        if self.frame.is_empty() {
            return Ok(());
        }
        if self.pen.is_some_and(|pen| pen != Pen::default()) {
            self.put("\x1b[m");
            self.pen = Some(Pen::default());
        }
        let mut frame = std::mem::take(&mut self.frame);
        frame.splice(..0, BEGIN.iter().copied());
        frame.extend_from_slice(END);
        self.out.write_all(&frame)?;
        self.out.flush()
    }
}

fn shortest_move(from: Option<Position>, to: Position) -> String {
    let absolute = match (to.x, to.y) {
        (0, 0) => "\x1b[H".to_owned(),
        (0, y) => format!("\x1b[{}H", y + 1),
        (x, y) => format!("\x1b[{};{}H", y + 1, x + 1),
    };
    let Some(from) = from else { return absolute };
    let across = match i32::from(to.x) - i32::from(from.x) {
        0 => String::new(),
        _ if to.x == 0 => "\r".into(),
        1 => "\x1b[C".into(),
        by @ 2.. => format!("\x1b[{by}C"),
        by @ -4..0 => "\x08".repeat(by.unsigned_abs() as usize),
        by => format!("\x1b[{}D", -by),
    };
    let down = match i32::from(to.y) - i32::from(from.y) {
        0 => String::new(),
        1 => "\x1b[B".into(),
        by @ 2.. => format!("\x1b[{by}B"),
        -1 => "\x1b[A".into(),
        by => format!("\x1b[{}A", -by),
    };
    let relative = across + &down;
    if relative.len() < absolute.len() { relative } else { absolute }
}
