//! The list of designs: what is known of each, which are shown, which is selected.

mod row;

use std::path::{Path, PathBuf};

pub use row::{Row, RowState};

use unicode_width::UnicodeWidthStr;

use super::solving::Ticket;
use super::text_field::TextField;
use crate::design::library::{by_name, tree};
use crate::text::printable;

/// A row in the list.
#[derive(Debug, Clone)]
pub struct Visible<'a> {
    pub row: &'a Row,
    pub selected: bool,
    /// Others are compared with this one.
    pub marked: bool,
    /// How far below the design that it came from; 0 for those at the top.
    pub depth: usize,
    /// Where it is, if another one has the same name.
    pub folder: Option<String>,
}

#[derive(Debug, Clone, Default)]
pub struct Library {
    rows: Vec<Row>,
    /// The rows that match the filter, as they are listed: index and depth.
    shown: Vec<(usize, usize)>,
    /// All in one list, without regard to parents.
    flat: bool,
    /// The design that others are compared with.
    marked: Option<PathBuf>,
    /// To be selected as soon as it is there.
    wanted: Option<PathBuf>,
    /// Place of the selection in `shown`.
    cursor: usize,
    filter: TextField,
    /// First visible place, and how many are visible: known after the first frame.
    scroll: usize,
    height: usize,
}

impl Library {
    pub fn new(paths: Vec<PathBuf>) -> Self {
        let rows: Vec<Row> = paths.into_iter().map(Row::new).collect();
        Self { shown: (0..rows.len()).map(|at| (at, 0)).collect(), rows, ..Self::default() }
    }

    pub fn len(&self) -> usize {
        self.rows.len()
    }

    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Columns of the screen that the longest name takes, with what stands before it in the tree.
    pub fn longest_name(&self) -> usize {
        let widths = self.shown.iter().map(|&(at, depth)| 2 * depth.min(4) + self.rows[at].stem.width());
        widths.max().unwrap_or(0)
    }

    /// How many match the filter.
    pub fn matches(&self) -> usize {
        self.shown.len()
    }

    pub fn cursor(&self) -> usize {
        self.cursor
    }

    pub fn filter(&self) -> &str {
        self.filter.text()
    }

    pub fn filter_field(&self) -> &TextField {
        &self.filter
    }

    pub fn selected(&self) -> Option<&Row> {
        self.shown.get(self.cursor).and_then(|&(at, _)| self.rows.get(at))
    }

    pub fn row_mut(&mut self, path: &Path) -> Option<&mut Row> {
        self.rows.iter_mut().find(|row| row.path == path)
    }

    /// Moves the selection, held at both ends.
    pub fn move_by(&mut self, by: isize) {
        self.cursor = self.cursor.saturating_add_signed(by).min(self.shown.len().saturating_sub(1));
    }

    /// Moves the selection, from the end to the start again.
    pub fn cycle(&mut self, by: isize) {
        if !self.shown.is_empty() {
            self.cursor = (self.cursor.cast_signed() + by).rem_euclid(self.shown.len().cast_signed()).cast_unsigned();
        }
    }

    pub fn select_first(&mut self) {
        self.cursor = 0;
    }

    /// Rows of a page; one stays in sight.
    pub fn page(&self) -> isize {
        self.height.saturating_sub(1).max(1).cast_signed()
    }

    /// Changes the filter; the selection stays on its design while that matches.
    pub fn set_filter(&mut self, filter: String) {
        self.edit_filter(|field| *field = TextField::new(filter));
    }

    /// The same, as it is typed.
    pub fn edit_filter(&mut self, edit: impl FnOnce(&mut TextField)) {
        edit(&mut self.filter);
        self.refilter();
    }

    /// The row of a file.
    pub fn row(&self, path: &Path) -> Option<&Row> {
        self.rows.iter().find(|row| row.path == path)
    }

    /// The row that the design of `row` came from; one in its folder comes before others of the same name.
    pub fn parent(&self, row: &Row) -> Option<&Row> {
        let parent = row.parent()?;
        let mut named = self.rows.iter().filter(|other| other.raw_stem() == parent);
        let near = named.clone().find(|other| other.path.parent() == row.path.parent());
        near.or_else(|| named.next()).filter(|other| other.path != row.path)
    }

    /// The folder of a row, safe to show, where another one has the same name: in short where that tells them apart.
    fn folder(&self, row: &Row) -> Option<String> {
        let alike = || self.rows.iter().filter(|other| other.stem == row.stem && other.path != row.path);
        alike().next()?;
        let short = |row: &Row| row.path.parent().and_then(Path::file_name).map(ToOwned::to_owned);
        let is_told_apart = short(row).is_some() && alike().all(|other| short(other) != short(row));
        let folder = row.path.parent().unwrap_or(Path::new("")).to_string_lossy();
        let name = short(row).filter(|_| is_told_apart).map(|name| name.to_string_lossy().into_owned());
        Some(printable(&name.unwrap_or(folder.into_owned())).into_owned())
    }

    /// How many designs name this one as the one that they came from.
    pub fn variants(&self, row: &Row) -> usize {
        self.rows.iter().filter(|other| self.parent(other).is_some_and(|parent| parent.path == row.path)).count()
    }

    /// Whether variants stand below the design that they came from.
    pub fn is_tree(&self) -> bool {
        !self.flat
    }

    pub fn toggle_tree(&mut self) {
        self.flat = !self.flat;
        self.refilter();
    }

    pub fn marked(&self) -> Option<&Row> {
        self.marked.as_ref().and_then(|path| self.row(path))
    }

    pub fn mark(&mut self, path: Option<PathBuf>) {
        self.marked = path;
    }

    /// Selects a file as soon as it is in the list.
    pub fn want(&mut self, path: PathBuf) {
        self.wanted = Some(path);
    }

    /// A file has another name now; what is known of it is kept.
    pub fn moved(&mut self, from: &Path, to: &Path) {
        if self.marked.as_deref() == Some(from) {
            self.marked = Some(to.into());
        }
        if self.row(to).is_none()
            && let Some(row) = self.row_mut(from)
        {
            *row = Row { path: to.into(), stem: Row::new(to.into()).stem, ..row.clone() };
        }
    }

    /// Matches and orders the rows anew: a design's name may match where its file's does not, and it names its parent.
    pub fn names_changed(&mut self, parents: bool) {
        if !self.filter.is_empty() || (parents && !self.flat) {
            self.refilter();
        }
    }

    fn refilter(&mut self) {
        let selected = self.shown.get(self.cursor).map(|&(at, _)| at);
        let filter = self.filter.text().to_lowercase();
        let all: Vec<usize> = (0..self.rows.len()).collect();
        let matching: Vec<usize> = all.iter().copied().filter(|&at| self.rows[at].matches(&filter)).collect();
        self.shown = self.ordered(&matching);
        let place = |at: usize| self.shown.iter().position(|&(shown, _)| shown == at);
        // the next one after the design that was selected, if that one is gone
        let cursor = selected.and_then(|selected| {
            place(selected).or_else(|| {
                let order = self.ordered(&all);
                order.iter().map(|&(at, _)| at).skip_while(|&at| at != selected).find_map(place)
            })
        });
        let last = self.shown.len().saturating_sub(1);
        self.cursor = cursor.unwrap_or(if selected.is_some() { last } else { 0 }).min(last);
    }

    /// These rows as they are listed.
    fn ordered(&self, rows: &[usize]) -> Vec<(usize, usize)> {
        if self.flat || rows.iter().all(|&at| self.rows[at].parent().is_none()) {
            return rows.iter().map(|&at| (at, 0)).collect();
        }
        let files: Vec<(&Path, Option<&str>)> =
            rows.iter().map(|&at| (self.rows[at].path.as_path(), self.rows[at].parent())).collect();
        tree(&files).into_iter().filter_map(|branch| Some((*rows.get(branch.index)?, branch.depth))).collect()
    }

    /// Takes over a new list of files. What is known of a file that is still there is kept until it is read again.
    pub fn replace(&mut self, paths: Vec<PathBuf>) {
        let selected = self.selected().map(|row| row.path.clone());
        let wanted = self.wanted.take_if(|wanted| paths.contains(wanted));
        let place = self.cursor;
        let mut old = std::mem::take(&mut self.rows);
        self.rows = paths
            .into_iter()
            .map(|path| match old.iter().position(|row| row.path == path) {
                Some(at) => old.swap_remove(at),
                None => Row::new(path),
            })
            .collect();
        self.shown.clear();
        self.refilter();
        let find = |path: &Path| self.shown.iter().position(|&(at, _)| self.rows[at].path == path);
        let kept = wanted.as_deref().and_then(find).or_else(|| selected.as_deref().and_then(find));
        self.cursor = kept.unwrap_or(place).min(self.shown.len().saturating_sub(1));
    }

    /// Takes in a file, by name among those of its folder.
    pub fn add(&mut self, path: PathBuf) {
        let mut paths: Vec<PathBuf> = self.rows.iter().map(|row| row.path.clone()).collect();
        if !paths.contains(&path) {
            let mut places = (0..paths.len()).filter(|&at| paths[at].parent() == path.parent());
            let place =
                places.clone().find(|&at| by_name(&paths[at], &path).is_gt()).or(places.next_back().map(|at| at + 1));
            paths.insert(place.unwrap_or(paths.len()), path);
            self.replace(paths);
        }
    }

    /// Selects a design; a filter that hides it is dropped.
    pub fn select(&mut self, path: &Path) {
        let Some(at) = self.rows.iter().position(|row| row.path == path) else { return };
        if !self.shown.iter().any(|&(shown, _)| shown == at) {
            self.set_filter(String::new());
        }
        self.cursor = self.shown.iter().position(|&(shown, _)| shown == at).unwrap_or(self.cursor);
    }

    /// Marks all rows to be read again; results of requests before `ticket` are refused from now on.
    pub fn mark_stale(&mut self, ticket: Ticket) {
        for row in &mut self.rows {
            row.stale = true;
            row.ticket = ticket;
        }
    }

    /// The files that are still to be read or solved: the visible ones first, then downwards and from the top again.
    pub fn waiting(&self) -> Vec<PathBuf> {
        let visible = self.scroll.min(self.shown.len());
        let mut hidden = vec![true; self.rows.len()];
        for &(at, _) in &self.shown {
            hidden[at] = false;
        }
        let hidden = (0..self.rows.len()).filter(|&at| hidden[at]);
        let shown = self.shown[visible..].iter().chain(&self.shown[..visible]).map(|&(at, _)| at);
        let order = shown.chain(hidden).map(|at| &self.rows[at]);
        order.filter(|row| row.waits()).map(|row| row.path.clone()).collect()
    }

    /// Scrolls so that the selection is in sight of a list `height` rows high. Says whether the view has moved.
    pub fn scroll_into_view(&mut self, height: usize) -> bool {
        let before = (self.scroll, self.height);
        self.height = height;
        let last_start = self.shown.len().saturating_sub(height);
        let lowest = (self.cursor + 1).saturating_sub(height);
        self.scroll = self.scroll.clamp(lowest, self.cursor.max(lowest)).min(last_start.max(lowest));
        before != (self.scroll, self.height)
    }

    /// All rows that match the filter, as they are listed.
    pub fn matching(&self) -> impl Iterator<Item = &Row> {
        self.shown.iter().filter_map(|&(at, _)| self.rows.get(at))
    }

    /// The visible rows.
    pub fn visible(&self) -> impl Iterator<Item = Visible<'_>> {
        let places = self.scroll..(self.scroll + self.height).min(self.shown.len());
        places.map(|place| {
            let (at, depth) = self.shown[place];
            let row = &self.rows[at];
            let marked = self.marked.as_ref() == Some(&row.path);
            Visible { row, selected: place == self.cursor, marked, depth, folder: self.folder(row) }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn library(count: usize) -> Library {
        Library::new((0..count).map(|at| PathBuf::from(format!("/designs/d{at:02}.toml"))).collect())
    }

    fn stem(library: &Library) -> &str {
        library.selected().map_or("", |row| &row.stem)
    }

    #[test]
    fn the_selection_stays_in_sight_and_the_list_is_never_scrolled_past_its_end() {
        let mut library = library(30);
        for (cursor, height) in [(0, 5), (29, 5), (12, 5), (29, 1), (3, 40), (29, 0), (7, 6)] {
            library.select_first();
            library.move_by(cursor);
            library.scroll_into_view(height);
            let visible: Vec<_> = library.visible().collect();
            assert_eq!(visible.len(), height.min(30));
            assert!(height == 0 || visible.iter().any(|visible| visible.selected));
        }
    }

    #[test]
    fn a_filter_keeps_the_selected_design_or_takes_the_next() {
        let mut library = library(30);
        library.move_by(12);
        library.set_filter("D1".into());
        assert_eq!((stem(&library), library.matches()), ("d12", 10));
        library.set_filter("d2".into());
        assert_eq!(stem(&library), "d20");
        library.set_filter("none of them".into());
        assert!(library.selected().is_none());
        library.set_filter(String::new());
        assert_eq!(library.matches(), 30);
    }

    #[test]
    fn files_come_and_go_and_the_selection_follows_its_file() {
        let mut library = library(4);
        library.move_by(2);
        library.replace(["/designs/a.toml", "/designs/d02.toml", "/designs/z.toml"].map(PathBuf::from).into());
        assert_eq!((stem(&library), library.len()), ("d02", 3));
        library.replace(vec![PathBuf::from("/designs/a.toml")]);
        assert_eq!(stem(&library), "a");
        library.replace(Vec::new());
        assert!(library.selected().is_none());
    }

    #[test]
    fn designs_of_one_name_are_told_apart_by_their_folders() {
        let shown = |paths: &[&str]| -> Vec<Option<String>> {
            let mut library = Library::new(paths.iter().map(PathBuf::from).collect());
            library.scroll_into_view(9);
            library.visible().map(|visible| visible.folder).collect()
        };
        let some = |folder: &str| Some(folder.to_owned());
        assert_eq!(shown(&["/x/a/base.toml", "/x/a/one.toml", "/x/b/base.toml"]), [some("a"), None, some("b")]);
        assert_eq!(shown(&["/x/a/base.toml", "/y/a/base.toml"]), [some("/x/a"), some("/y/a")]);
    }

    #[test]
    fn visible_rows_are_read_first() {
        let mut library = library(30);
        library.move_by(20);
        library.scroll_into_view(5);
        let waiting = library.waiting();
        assert_eq!(waiting.len(), 30);
        assert_eq!(waiting[0], PathBuf::from("/designs/d16.toml"));
    }
}
