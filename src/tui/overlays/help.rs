//! The help: the keymap as it is, and what the marks mean.
//!
//! ```text
//! ┌ Help ────────────────────────────────────────────┐
//! │ Moving                                           │
//! │   ↑ k           the design above, or a line up   │
//! │   ↓ j           the design below, or a line down │
//! └ lines 1-12 of 40 ────────────────────────────────┘
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use crate::text::cut;
use crate::tui::action::{ACTIONS, About, Action, Category};
use crate::tui::app::App;
use crate::tui::keymap::{self, Mode};
use crate::tui::theme::Theme;
use crate::tui::traces::TOLERANCE_DB;
use crate::tui::widgets::panel::{self, Title};

const KEYS: usize = 20;

/// Draws the help over `area`.
pub fn render(app: &mut App, area: Rect, buffer: &mut Buffer) {
    let theme = app.theme;
    let lines = lines(&theme, if app.editors.open().is_some() { EDITOR } else { EXPLORER });
    let width = area.width.saturating_sub(4).min(78);
    let height = area.height.min(lines.len() as u16 + 2);
    let window = Rect { x: area.x + (area.width - width) / 2, y: area.y + (area.height - height) / 2, width, height };
    for y in window.top()..window.bottom() {
        for x in window.left()..window.right() {
            if let Some(cell) = buffer.cell_mut((x, y)) {
                cell.reset();
            }
        }
    }
    let inner = panel::frame(window, buffer, &Title::left("Help"), true, &theme);
    let room = usize::from(inner.width.saturating_sub(1));
    app.help_scroll.fit(lines.len(), usize::from(inner.height));
    for (line, y) in lines.iter().skip(app.help_scroll.top).zip(inner.top()..inner.bottom()) {
        match line {
            Line::Title(title) => drop(buffer.set_stringn(inner.x + 1, y, title, room, theme.title)),
            Line::Entry(keys, text) => {
                let gap = " ".repeat(KEYS.saturating_sub(keys.width()).max(1));
                let (x, _) = buffer.set_stringn(inner.x + 1, y, format!("  {keys}{gap}"), room, theme.key);
                let left = usize::from(inner.right().saturating_sub(x));
                buffer.set_stringn(x, y, cut(text, left, theme.glyphs.ellipsis), left, Style::new());
            }
        }
    }
    if let Some(position) = app.help_scroll.position() {
        let left = vec![format!("lines {position}, Esc closes"), position];
        panel::bottom(window, buffer, &Title { left, right: Vec::new() }, true, &theme);
    }
}

enum Line {
    Title(&'static str),
    Entry(String, String),
}

/// Where letters are keys, and where they are text.
type Modes = (&'static [Mode], &'static [Mode]);

const EXPLORER: Modes = (&[Mode::Library, Mode::Text], &[Mode::Filter]);
const EDITOR: Modes =
    (&[Mode::Table, Mode::Matrix, Mode::Choice, Mode::Findings, Mode::Leave], &[Mode::Cell, Mode::Form]);

fn lines(theme: &Theme, (keyed, typed): Modes) -> Vec<Line> {
    let ascii = theme.glyphs.ascii;
    let mut lines = Vec::new();
    let mut section = |title: &'static str, entries: Vec<Line>| {
        if entries.is_empty() {
            return;
        }
        if !lines.is_empty() {
            lines.push(Line::Title(""));
        }
        lines.push(Line::Title(title));
        lines.extend(entries);
    };
    for category in Category::ALL {
        let entries = ACTIONS.iter().filter(|about| about.category == category);
        section(category.title(), entries.filter_map(|about| entry(about, keyed, ascii)).collect());
    }
    let typing = ACTIONS.iter().filter(|about| keys_in(keyed, about.action, ascii).is_empty());
    section("While something is typed", typing.filter_map(|about| entry(about, typed, ascii)).collect());
    section("Marks", marks(theme));
    lines
}

/// An action with its keys, if it has some in these modes.
fn entry(about: &About, modes: &[Mode], ascii: bool) -> Option<Line> {
    let keys = keys_in(modes, about.action, ascii);
    (!keys.is_empty()).then(|| Line::Entry(keys.join(" "), about.doc.into()))
}

fn keys_in(modes: &[Mode], action: Action, ascii: bool) -> Vec<String> {
    let mut keys: Vec<String> = Vec::new();
    for key in modes.iter().flat_map(|&mode| keymap::keys(mode, action, ascii)) {
        if !keys.contains(&key) {
            keys.push(key);
        }
    }
    keys
}

fn marks(theme: &Theme) -> Vec<Line> {
    let glyphs = theme.glyphs;
    let [fe, enhanced, basic] = glyphs.samples;
    let entry = |mark: String, text: &str| Line::Entry(mark, text.into());
    vec![
        entry(fe.into(), "mesh force of the finite element model"),
        entry(enhanced.into(), "of the enhanced lumped model"),
        entry(basic.into(), "of the basic lumped model"),
        Line::Entry(
            glyphs.band.into(),
            format!("the enhanced model is off by more than {TOLERANCE_DB} dB; in the strip: wide bars"),
        ),
        entry(glyphs.trust.into(), "on the frequency axis: up to here the enhanced model can be trusted"),
        entry(format!("{} {}", glyphs.bearing, glyphs.rigid_bearing), "a bearing, a rigid bearing"),
        entry(format!("m {}", glyphs.mesh), "where the mesh acts on the shaft, and the mesh point"),
        entry("E L".into(), "the drives: engine and load"),
        entry(glyphs.broken.into(), "a design that cannot be read or solved"),
        entry("!".into(), "a design with warnings; a cell with a warning"),
        entry("*".into(), "edits that are not saved"),
        entry("(0.0)".into(), "not written in the file: the default that holds"),
        entry("[36.0]".into(), "the cell under the cursor"),
        entry(glyphs.pointer.into(), "in the side view: what the cursor is on"),
        entry(glyphs.ghost.into(), "mesh force of the saved state, finite element model"),
    ]
}
