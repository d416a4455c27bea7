//! What the messages of this part change, and what its actions do.

use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::keymap::Mode;
use crate::tui::message::{Effect, Ending, Message};

impl App {
    pub(in crate::tui) fn hear_of_recovery(&mut self, message: Message) {
        match message {
            Message::Looked { path, look } => self.looked(&path, look),
            Message::Left(left) => self.take_in_left(left),
            Message::Protected(result) => self.protected(result),
            Message::NotTidied(error) => self.complain(error),
            _ => {}
        }
    }

    pub(in crate::tui) fn answer(&mut self, action: Action) -> Vec<Effect> {
        match (action, self.mode) {
            (Action::DiscardAll, _) => {
                let mut effects = self.discard_all();
                effects.push(Effect::Quit(Ending::Quit));
                effects
            }
            (Action::Recover, _) => self.ask_for_offers(),
            (Action::TakeEdits, _) => self.take_offer(false),
            (Action::SaveVariant, Mode::Recovery) => self.take_offer(true),
            (Action::DiscardEdits, _) => self.discard_offer(),
            (Action::NextOffer, _) => {
                self.next_offer();
                Vec::new()
            }
            (Action::KeepMine, _) => self.keep_mine(),
            (Action::TakeTheirs, _) => self.take_theirs(),
            (Action::SaveVariant, Mode::Conflict) => self.conflict_to_variant(),
            _ => Vec::new(),
        }
    }
}
