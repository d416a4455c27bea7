//! The explorer's state. Nothing here touches the terminal, the clock or a file.

use std::path::PathBuf;
use std::sync::Arc;

use super::backend::LoadedDesign;
use super::bearings::{BearingStates, BearingsView};
use super::caps::Capabilities;
use super::clipboard::Route;
use super::compare::CompareView;
use super::conflict::Conflicts;
use super::editor::Editors;
use super::export::ExportForm;
use super::file_jobs::FileJob;
use super::files::Form;
use super::help::HelpSearch;
use super::keymap::Mode;
use super::keys::Keys;
use super::library::{Library, RowState};
use super::message::Effect;
use super::modes::ModesView;
use super::new_design::NewDesign;
use super::notice::{Messages, Notice};
use super::overview::Overview;
use super::pair::PairView;
use super::palette::Palette;
use super::recovery::Recovery;
use super::solving::{Job, Summary, Ticket};
use super::spectra::SpectraView;
use super::theme::Theme;
use super::traces::{Columns, Traces};
use crate::design::library::Trashed;

#[derive(Debug)]
pub struct App {
    pub theme: Theme,
    /// The library as the user names it, e.g. `~/designs`.
    pub shown_as: String,
    pub library: Library,
    pub detail: Detail,
    /// The designs that are being edited, and whether one is in sight instead of the explorer.
    pub editors: Editors,
    pub mode: Mode,
    /// The modes that the present one lies over, the lowest first.
    pub below: Vec<Mode>,
    pub keys: Keys,
    pub help_scroll: Scroll,
    pub help_search: HelpSearch,
    pub palette: Palette,
    pub notice: Option<Notice>,
    pub messages: Messages,
    pub form: Option<Form>,
    pub export: Option<ExportForm>,
    /// The file that the question is about.
    pub to_delete: Option<PathBuf>,
    /// Deleted since the start, the latest last.
    pub(super) deleted: Vec<Trashed>,
    pub compare: Option<CompareView>,
    pub spectra: Option<SpectraView>,
    pub modes: Option<Box<ModesView>>,
    pub bearings: Option<BearingsView>,
    pub overview: Overview,
    pub pair: Option<Box<PairView>>,
    pub new_design: NewDesign,
    /// How a copied text gets to the terminal.
    pub clipboard: Route,
    pub recovery: Recovery,
    pub conflicts: Conflicts,
    pub(super) tickets: Ticket,
    pub(super) view_moved: bool,
    /// The terminal is too small to show what the keys would act on.
    pub(super) is_unseen: bool,
}

/// The right side: what is known of the selected design.
#[derive(Debug, Default)]
pub struct Detail {
    pub path: Option<PathBuf>,
    /// The latest request for this design; results of others are refused.
    pub ticket: Ticket,
    /// Whether its result is still to come.
    pub pending: bool,
    /// What was read for that result.
    pub(super) loaded: Option<Arc<LoadedDesign>>,
    pub outcome: Option<Outcome>,
    pub text_scroll: Scroll,
}

#[derive(Debug)]
pub enum Outcome {
    Solved {
        /// What was solved; the library may have read the file again since.
        loaded: Arc<LoadedDesign>,
        summary: Box<Summary>,
        picture: Box<Picture>,
        bearings: Option<Arc<BearingStates>>,
    },
    /// Neither read nor solved; the whole message.
    Failed { title: &'static str, text: String },
}

/// Spectra, and their columns at the width that was drawn last.
#[derive(Debug)]
pub struct Picture {
    pub traces: Arc<Traces>,
    columns: Option<Columns>,
}

impl Picture {
    pub fn new(traces: impl Into<Arc<Traces>>) -> Self {
        Self { traces: traces.into(), columns: None }
    }

    /// Computes the columns if the width has changed. A million lines take longer than a frame should.
    pub fn prepare(&mut self, width: usize, dots: usize) {
        if self.columns(width, dots).is_none() {
            self.columns = Some(self.traces.columns(width, dots));
        }
    }

    pub fn columns(&self, width: usize, dots: usize) -> Option<&Columns> {
        self.columns.as_ref().filter(|columns| columns.width == width && columns.dots == dots)
    }
}

/// Where a text is scrolled to. Its length and its window are known when it is drawn.
#[derive(Debug, Clone, Copy, Default)]
pub struct Scroll {
    pub top: usize,
    lines: usize,
    height: usize,
}

impl Scroll {
    pub fn by(&mut self, lines: isize) {
        self.top = self.top.saturating_add_signed(lines).min(self.last());
    }

    /// Scrolls no further than needed for a line to be in sight.
    pub fn show(&mut self, line: usize) {
        let lowest = (line + 1).saturating_sub(self.height);
        self.top = self.top.clamp(lowest.min(line), line).min(self.last());
    }

    /// The last place that shows a full window.
    pub fn last(&self) -> usize {
        self.lines.saturating_sub(self.height)
    }

    /// Lines of a page; one stays in sight.
    pub fn page(&self) -> isize {
        self.height.saturating_sub(1).max(1).cast_signed()
    }

    /// Takes over the size of the text and of its window.
    pub fn fit(&mut self, lines: usize, height: usize) {
        (self.lines, self.height) = (lines, height);
        self.by(0);
    }

    /// E.g. `1-12 of 30`; nothing where all is in sight.
    pub fn position(&self) -> Option<String> {
        (self.lines > self.height)
            .then(|| format!("{}-{} of {}", self.top + 1, (self.top + self.height).min(self.lines), self.lines))
    }
}

impl App {
    /// The state before anything is read.
    pub fn new(library: Vec<PathBuf>, shown_as: String, capabilities: Capabilities) -> Self {
        Self {
            theme: Theme::new(capabilities),
            shown_as,
            library: Library::new(library),
            detail: Detail::default(),
            editors: Editors::default(),
            mode: Mode::Library,
            below: Vec::new(),
            keys: Keys::default(),
            help_scroll: Scroll::default(),
            help_search: HelpSearch::default(),
            palette: Palette::default(),
            notice: None,
            messages: Messages::default(),
            form: None,
            export: None,
            to_delete: None,
            deleted: Vec::new(),
            compare: None,
            spectra: None,
            modes: None,
            bearings: None,
            overview: Overview::default(),
            pair: None,
            new_design: NewDesign::default(),
            clipboard: Route::default(),
            recovery: Recovery::default(),
            conflicts: Conflicts::default(),
            tickets: Ticket::default(),
            view_moved: false,
            is_unseen: false,
        }
    }

    /// What to do after the first frame.
    pub fn start(&mut self) -> Vec<Effect> {
        let mut effects = self.follow_selection();
        effects.push(Effect::File(FileJob::Left));
        effects.extend(self.fill());
        self.view_moved = false;
        effects
    }

    /// What to do after a frame: rows that have come into sight are read first.
    pub fn after_frame(&mut self) -> Vec<Effect> {
        if let Some(pending) = self.editors.open_mut().and_then(|editing| editing.solving.pending.as_mut()) {
            pending.is_fresh = false;
        }
        if std::mem::take(&mut self.view_moved) { self.fill().into_iter().collect() } else { Vec::new() }
    }

    /// Whether a frame drawn now would likely be replaced at once, because the selected design is being solved.
    pub fn is_settling(&self) -> bool {
        match self.editors.open() {
            Some(editing) => editing.solving.pending.as_ref().is_some_and(|pending| pending.is_fresh),
            None => self.detail.pending && self.detail.outcome.is_none(),
        }
    }

    /// Whether the right side is a text that can be scrolled.
    pub fn has_text(&self) -> bool {
        matches!(self.detail.outcome, Some(Outcome::Failed { .. }))
    }

    pub(super) fn ticket(&mut self) -> Ticket {
        self.tickets.0 += 1;
        self.tickets
    }

    /// Asks for the selected design if it is another one than before. Not while tables are open: what they ask for has the
    /// same place.
    pub(super) fn follow_selection(&mut self) -> Vec<Effect> {
        if self.editors.open().is_some() {
            return Vec::new();
        }
        let path = self.library.selected().map(|row| row.path.clone());
        if path == self.detail.path {
            return Vec::new();
        }
        self.detail = Detail { path, ..Detail::default() };
        if self.mode == Mode::Text {
            self.mode = Mode::Library;
        }
        // what the library knows already is shown at once
        self.detail.outcome = match self.library.selected().map(|row| &row.state) {
            Some(RowState::Broken(broken)) => Some(Outcome::Failed { title: BROKEN, text: broken.full_text.clone() }),
            Some(RowState::Unsolvable(text)) => Some(Outcome::Failed { title: UNSOLVABLE, text: text.clone() }),
            _ => None,
        };
        self.solve_selected()
    }

    pub(super) fn solve_selected(&mut self) -> Vec<Effect> {
        let Some(path) = self.detail.path.clone() else { return Vec::new() };
        let ticket = self.ticket();
        self.detail.ticket = ticket;
        self.detail.pending = true;
        vec![Effect::Solve(Job { ticket, path, with_traces: true })]
    }

    pub(super) fn fill(&mut self) -> Option<Effect> {
        let waiting = self.library.waiting();
        let ticket = self.ticket();
        let job = |path| Job { ticket, path, with_traces: false };
        (!waiting.is_empty()).then(|| Effect::Fill(waiting.into_iter().map(job).collect()))
    }
}

/// Title over the message of a design that cannot be read.
pub(super) const BROKEN: &str = "This design cannot be read";
/// Title over the message of a design that cannot be solved.
pub(super) const UNSOLVABLE: &str = "This design cannot be solved";
