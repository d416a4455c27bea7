//! Up, down and back, wherever the keys go.

use super::app::App;
use super::help::HelpSearch;
use super::keymap::Mode;
use super::message::Effect;
use super::text_field::TextField;

impl App {
    pub(super) fn page(&self) -> isize {
        match self.mode {
            Mode::Modes => self.modes.as_ref().map_or(1, |view| view.page()),
            Mode::Overview => self.overview.page(),
            Mode::Bearings => self.bearings.as_ref().map_or(1, |view| view.scroll.page()),
            Mode::Pair | Mode::MeshImport => self.pair.as_ref().map_or(1, |view| view.page()),
            Mode::New => self.new_design.scroll.page(),
            Mode::Filter if self.below.contains(&Mode::Overview) => self.overview.page(),
            Mode::Library | Mode::Filter => self.library.page(),
            Mode::Text => self.detail.text_scroll.page(),
            Mode::Help | Mode::HelpSearch => self.help_scroll.page(),
            Mode::Palette => self.palette.height.saturating_sub(1).max(1).cast_signed(),
            Mode::Messages => self.messages.scroll.page(),
            Mode::Recovery => self.recovery.offers.scroll.page(),
            Mode::Conflict => self.conflicts.scroll.page(),
            Mode::Compare => self.compare.as_ref().map_or(1, |view| view.scroll.page()),
            Mode::Why => self.spectra.as_ref().map_or(1, |view| view.scroll.page()),
            _ => 0,
        }
    }

    pub(super) fn move_by(&mut self, by: isize) -> Vec<Effect> {
        match self.mode {
            Mode::Overview => self.move_in_overview(by),
            Mode::Filter if self.below.contains(&Mode::Overview) => self.move_in_overview(by),
            Mode::Modes => self.move_in_modes(by),
            Mode::Bearings => self.move_in_bearings(by),
            Mode::Pair | Mode::MeshImport => self.pair.iter_mut().for_each(|view| view.move_by(by)),
            Mode::New => self.move_in_new(by),
            Mode::Library | Mode::Filter => {
                self.library.move_by(by);
                return self.follow_selection();
            }
            Mode::Text => self.detail.text_scroll.by(by),
            Mode::Help | Mode::HelpSearch => self.help_scroll.by(by),
            Mode::Palette => self.move_in_palette(by),
            Mode::Messages => self.messages.scroll.by(by),
            Mode::Recovery => self.recovery.offers.scroll.by(by),
            Mode::Conflict => self.conflicts.scroll.by(by),
            Mode::Compare => {
                if let Some(view) = &mut self.compare {
                    view.scroll.by(by);
                }
            }
            Mode::Why => {
                if let Some(view) = &mut self.spectra {
                    view.scroll.by(by);
                }
            }
            _ => {}
        }
        Vec::new()
    }

    pub(super) fn next_match(&mut self, by: isize) -> Vec<Effect> {
        if self.library.filter().is_empty() {
            return Vec::new();
        }
        self.library.cycle(by);
        self.follow_selection()
    }

    pub(super) fn back(&mut self) -> Vec<Effect> {
        match self.mode {
            Mode::HelpSearch => {
                self.help_search = HelpSearch::default();
                self.close();
            }
            // what is searched for goes first, as in the list of designs
            Mode::Help if !self.help_search.is_empty() => self.help_search = HelpSearch::default(),
            Mode::Name => {
                self.form = None;
                self.close();
            }
            Mode::Compare => {
                self.compare = None;
                self.close();
                return vec![Effect::CancelCompare];
            }
            Mode::Spectra => return self.close_spectra(),
            Mode::Export => self.close_export(),
            Mode::Frequency
            | Mode::Torque
            | Mode::Help
            | Mode::Palette
            | Mode::Confirm
            | Mode::Messages
            | Mode::Why => self.close(),
            Mode::Recovery => {
                self.close();
                self.say("kept for later: :recover shows them again");
            }
            Mode::Conflict => self.cancel_conflicts(),
            Mode::Leave => self.stay(),
            Mode::Text => self.mode = Mode::Library,
            Mode::Filter | Mode::Library => {
                self.mode = Mode::Library;
                return self.edit_filter(|filter| *filter = TextField::default());
            }
            _ => {}
        }
        Vec::new()
    }
}
