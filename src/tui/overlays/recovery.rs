//! Unsaved edits of an earlier run, and what to do with them.
//!
//! ```text
//! ┌ Unsaved edits of an earlier run, 1 of 2 ──────────────────┐
//! │ overhung-elastic, 2025-01-31 12:00:00 UTC, 3 hours ago    │
//! │                                                           │
//! │ The edits, 1 value:                                       │
//! │   length of pinion segment 1: 36.0 → 35 mm                │
//! │                                                           │
//! │    t  take: open the tables with them, not saved yet      │
//! │    S  save as a variant                                   │
//! │    d  discard: put them aside                             │
//! │  Esc  later                                               │
//! └───────────────────────────────────────────────────────────┘
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::changes::{self, Said};
use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::recovery::{Offer, Theirs};
use crate::tui::theme::Theme;

/// Draws the present offer over `area`.
pub fn render(app: &mut App, area: Rect, buffer: &mut Buffer) {
    let Some(offer) = app.recovery.offers.present() else { return };
    let count = app.recovery.offers.all.len();
    let place = if count > 1 { format!(", {} of {count}", app.recovery.offers.at + 1) } else { String::new() };
    let title = format!("Unsaved edits of an earlier run{place}");
    let said = said(offer, &app.theme);
    let take = match &offer.theirs {
        None => "take: open the tables with them, not saved yet",
        Some(Theirs::Changed(_)) => "open anyway: as edits over the file as it is now, not saved yet",
        Some(Theirs::Gone) => "take: open the tables with them; saving makes the file",
        Some(Theirs::Unreadable(_)) => "open anyway: over the file as it was, not saved yet",
    };
    let mut choices = vec![
        (Action::TakeEdits, take),
        (Action::SaveVariant, "save as a variant, with a name"),
        (Action::DiscardEdits, "discard: put them aside"),
    ];
    if count > 1 {
        choices.push((Action::NextOffer, "the next design"));
    }
    choices.push((Action::Back, "later"));
    let mut scroll = app.recovery.offers.scroll;
    changes::render(app, title, &said, &choices, &mut scroll, area, buffer);
    app.recovery.offers.scroll = scroll;
}

fn said(offer: &Offer, theme: &Theme) -> Vec<Said> {
    let mut said = vec![(format!("{}, {}", offer.stem, offer.left.when), theme.title)];
    if matches!(offer.theirs, Some(Theirs::Changed(_))) {
        said.push(("Somebody has changed the file since these edits began.".into(), theme.warning));
    }
    said.push((String::new(), theme.fe));
    if let Some(theirs) = offer.theirs.as_ref().filter(|theirs| !matches!(theirs, Theirs::Changed(_))) {
        said.extend(changes::of_theirs(theirs, theme));
    }
    said.extend(changes::section("The edits", &offer.mine, theme));
    if let Some(theirs @ Theirs::Changed(_)) = &offer.theirs {
        said.extend(changes::of_theirs(theirs, theme));
    }
    said
}
