//! The user's keys: `keys.toml`.
//!
//! ```toml
//! [all]                 # wherever the action is
//! "f5" = "reread"
//!
//! [library]             # in the list of designs only
//! "ctrl-d" = "duplicate"
//! "D" = "none"          # no longer does anything
//! ```
//!
//! Whatever is wrong in a line is reported with its place, and the other lines hold.

use toml::de::{DeTable, DeValue};

use super::{Bound, Key, Keys};
use crate::design::{Finding, KeyPath, Severity, did_you_mean};
use crate::tui::action::{ACTIONS, Action};
use crate::tui::keymap::{self, Mode};

/// The table for all modes.
const ALL: &str = "all";
/// In place of an action: the key does nothing.
const NONE: &str = "none";

/// Actions without which one is lost in any mode.
const ESSENTIAL: [Action; 4] = [Action::Quit, Action::Help, Action::Back, Action::Palette];

/// Whether an action that has a key in a mode must keep one: what the palette does not offer there can be had in no other
/// way. What is the same in every mode can be done in another one.
fn must_keep_a_key(mode: Mode, action: Action) -> bool {
    let everywhere = || Mode::ALL.into_iter().all(|mode| keymap::is_known(mode, action));
    ESSENTIAL.contains(&action) || !(keymap::is_known(mode, Action::Palette) || everywhere())
}

/// A file's keys over those of the program.
#[derive(Debug, Clone, PartialEq)]
pub struct Remapped {
    pub keys: Keys,
    /// What is wrong, in the order of the text.
    pub findings: Vec<Finding>,
}

type Span = std::ops::Range<usize>;

/// One line that can be used.
#[derive(Debug, Clone)]
struct Line {
    modes: Vec<Mode>,
    /// From the table for all modes: a mode's own table goes before it.
    general: bool,
    key: Key,
    action: Option<Action>,
    span: Span,
}

impl Line {
    fn binds(&self, mode: Mode, key: Key) -> bool {
        self.key == key && self.modes.contains(&mode)
    }
}

/// Reads a file of keys. Whatever is in it, the keys can be used.
pub fn read(text: &str) -> Remapped {
    let (document, errors) = DeTable::parse_recoverable(text);
    let mut reader = Reader::default();
    for error in errors {
        reader.error(error.span().unwrap_or(0..0), format!("not TOML: {}", error.message()), None);
    }
    for (name, value) in document.get_ref() {
        reader.table(name.get_ref(), name.span(), value.get_ref());
    }
    // tables come by name, conflicts are told by place
    reader.lines.sort_by_key(|line| line.span.start);
    reader.drop_conflicts();
    let keys = reader.drop_what_strands(&Keys::default());
    let mut findings = reader.findings;
    findings.sort_by_key(|finding| finding.span.as_ref().map_or(0, |span| span.start));
    // the parser says the same in several ways
    findings.dedup_by(|one, other| one.span == other.span);
    Remapped { keys, findings }
}

#[derive(Default)]
struct Reader {
    lines: Vec<Line>,
    findings: Vec<Finding>,
}

impl Reader {
    fn error(&mut self, span: Span, message: impl Into<String>, hint: Option<String>) {
        self.findings.push(Finding {
            severity: Severity::Error,
            key_path: KeyPath::root(),
            span: Some(span),
            message: message.into(),
            hint,
        });
    }

    fn table(&mut self, name: &str, span: Span, value: &DeValue<'_>) {
        let DeValue::Table(table) = value else {
            let hint = format!("put it below [{ALL}], or below a mode such as [library]");
            return self.error(span, "a key must stand in a table", Some(hint));
        };
        let mode = Mode::ALL.into_iter().find(|mode| mode.name() == name);
        if mode.is_none() && name != ALL {
            let names = || Mode::ALL.iter().map(|mode| mode.name()).chain([ALL]);
            let near = did_you_mean(name, names());
            let hint = format!("{near}there are: {}", names().collect::<Vec<_>>().join(", "));
            return self.error(span, format!("there is no mode `{name}`"), Some(hint));
        }
        for (key, value) in table {
            self.line(mode, key.get_ref(), key.span(), (value.get_ref(), value.span()));
        }
    }

    fn line(&mut self, mode: Option<Mode>, key: &str, span: Span, (value, value_span): (&DeValue<'_>, Span)) {
        let key = match Key::parse(key) {
            Ok(key) => key,
            Err(error) => return self.error(span, format!("`{key}`: {error}"), None),
        };
        let DeValue::String(name) = value else {
            let message = format!("the name of an action in quotes is wanted, or \"{NONE}\"");
            return self.error(value_span, message, None);
        };
        let about = ACTIONS.iter().find(|about| about.name == name);
        if about.is_none() && name != NONE {
            let near = did_you_mean(name, ACTIONS.iter().map(|about| about.name));
            let hint = format!("{near}`bevelscope keys` lists all actions");
            return self.error(value_span, format!("there is no action `{name}`"), Some(hint));
        }
        let action = about.map(|about| about.action);
        let known = |mode: Mode| action.is_none_or(|action| keymap::is_known(mode, action));
        let modes: Vec<Mode> = match mode {
            Some(mode) if mode.is_typing() && key.is_text() => {
                let message = format!("in [{}] this key is text", mode.name());
                return self.error(span, message, Some("use it with ctrl or alt".into()));
            }
            Some(mode) if !known(mode) => {
                let message = format!("`{name}` does nothing in [{}]", mode.name());
                return self.error(value_span, message, action.map(where_known));
            }
            Some(mode) => vec![mode],
            None => Mode::ALL.into_iter().filter(|mode| known(*mode) && !(mode.is_typing() && key.is_text())).collect(),
        };
        self.lines.push(Line { modes, general: mode.is_none(), key, action, span });
    }

    /// Of two lines for the same key the first one holds.
    fn drop_conflicts(&mut self) {
        let mut kept: Vec<Line> = Vec::new();
        for line in std::mem::take(&mut self.lines) {
            let other = kept.iter().find(|other| {
                other.general == line.general && line.modes.iter().any(|&mode| other.binds(mode, line.key))
            });
            let Some(other) = other else {
                kept.push(line);
                continue;
            };
            let name = |action: Option<Action>| action.map_or(NONE, Action::name);
            let message = format!("{} is bound to `{}` already", line.key.shown(true), name(other.action));
            self.error(line.span, message, Some("of two lines for one key the first one holds".into()));
        }
        self.lines = kept;
    }

    /// Drops the lines that would leave no key for an action without which one is lost.
    fn drop_what_strands(&mut self, defaults: &Keys) -> Keys {
        loop {
            let keys = applied(&self.lines, defaults);
            let reached =
                |keys: &Keys, mode, action| keys.bound.iter().any(|bound| bound.mode == mode && bound.action == action);
            let needed = defaults.bound.iter().map(|bound| (bound.mode, bound.action));
            let lost = needed
                .filter(|&(mode, action)| must_keep_a_key(mode, action) && !reached(&keys, mode, action))
                .find_map(|(mode, action)| {
                    let taken = |bound: &&Bound| bound.mode == mode && bound.action == action;
                    let takes =
                        |line: &Line| defaults.bound.iter().filter(taken).any(|bound| line.binds(mode, bound.key));
                    self.lines.iter().rposition(takes).map(|at| (at, mode, action))
                });
            let Some((at, mode, action)) = lost else { return keys };
            if self.lines[at].general && !ESSENTIAL.contains(&action) {
                // in all other modes it does what is meant
                self.lines[at].modes.retain(|other| *other != mode);
                continue;
            }
            let line = self.lines.remove(at);
            let message = format!("this would leave no key for `{}` in [{}]", action.name(), mode.name());
            self.error(line.span, message, Some("the line is left out; bind another key to it first".into()));
        }
    }
}

/// Where an action can be used, in words.
fn where_known(action: Action) -> String {
    let modes = Mode::ALL.into_iter().filter(|mode| keymap::is_known(*mode, action));
    format!("it is for {}", modes.map(|mode| format!("[{}]", mode.name())).collect::<Vec<_>>().join(", "))
}

/// The lines before the program's own keys: a mode's own lines first.
fn applied(lines: &[Line], defaults: &Keys) -> Keys {
    let own = lines.iter().filter(|line| !line.general);
    let ordered: Vec<&Line> = own.chain(lines.iter().filter(|line| line.general)).collect();
    let mut bound: Vec<Bound> = Vec::new();
    for (at, line) in ordered.iter().enumerate() {
        let Some(action) = line.action else { continue };
        let free = |mode: &&Mode| !ordered[..at].iter().any(|other| other.binds(**mode, line.key));
        bound.extend(line.modes.iter().filter(free).map(|&mode| Bound { mode, key: line.key, action }));
    }
    let kept = defaults.bound.iter().filter(|default| !lines.iter().any(|line| line.binds(default.mode, default.key)));
    bound.extend(kept);
    Keys { bound }
}
