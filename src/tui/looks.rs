//! How things are drawn, changed while the program runs.

use super::action::Action;
use super::app::App;
use super::caps::{Background, ColourDepth};
use super::message::Effect;
use super::theme::Theme;

impl App {
    /// The next marker, or the colours for the other background.
    pub(super) fn change_looks(&mut self, action: Action) -> Vec<Effect> {
        let Theme { capabilities, marker, .. } = self.theme;
        if action == Action::CycleMarker {
            self.theme.marker = marker.next(capabilities.ascii);
            self.say_in_sight(format!("curves: {}", self.theme.marker.name()));
            return Vec::new();
        }
        let (background, name) = match capabilities.background {
            Background::Light => (Background::Dark, "dark"),
            Background::Dark | Background::Unknown => (Background::Light, "light"),
        };
        // from what suits both first to the light one: on a dark one everything can be read already
        let capabilities = super::caps::Capabilities { background, ..capabilities };
        self.theme = Theme { marker, ..Theme::new(capabilities) };
        let nothing = if capabilities.colour == ColourDepth::None { " (without colours all the same)" } else { "" };
        self.say_in_sight(format!("colours for a {name} background{nothing}"));
        Vec::new()
    }

    /// Says something where it is seen: the tables have a line of their own for it.
    pub(super) fn say_in_sight(&mut self, text: String) {
        if self.below.is_empty()
            && let Some(editing) = self.editors.open_mut()
        {
            editing.say(text);
        } else {
            self.say(text);
        }
    }
}
