//! Saving where somebody else has changed the file.
//!
//! ```text
//! ┌ overhung-elastic has changed on disk ─────────────────────┐
//! │ The file since, 1 value:                                  │
//! │   length of pinion segment 1: 36.0 → 40 mm                │
//! │ These edits, 1 value:                                     │
//! │   length of pinion segment 1: 36.0 → 35 mm                │
//! │                                                           │
//! │    m  keep mine: write over the file as shown here        │
//! │    t  take theirs: undo brings these edits back           │
//! │    S  save these edits as a variant                       │
//! │  Esc  do nothing                                          │
//! └───────────────────────────────────────────────────────────┘
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::changes;
use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::recovery::Theirs;

/// Draws the present question over `area`.
pub fn render(app: &mut App, area: Rect, buffer: &mut Buffer) {
    let Some(conflict) = app.conflicts.present() else { return };
    let title = format!("{} has changed on disk", conflict.stem);
    let mut said = changes::of_theirs(&conflict.theirs, &app.theme);
    said.extend(changes::section("These edits", &conflict.mine, &app.theme));
    let keep = match &conflict.theirs {
        Theirs::Gone => "keep mine: write the file again",
        _ => "keep mine: write over the file as it is shown here",
    };
    let mut choices = vec![(Action::KeepMine, keep)];
    if conflict.can_be_taken() {
        choices.push((Action::TakeTheirs, "take theirs: undo brings these edits back"));
    }
    choices.push((Action::SaveVariant, "save these edits as a variant, with a name"));
    choices.push((Action::Back, "do nothing: the edits stay unsaved"));
    let mut scroll = app.conflicts.scroll;
    changes::render(app, title, &said, &choices, &mut scroll, area, buffer);
    app.conflicts.scroll = scroll;
}
