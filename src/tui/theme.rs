//! Colours and characters.
//!
//! State never hangs on colour: what a style says, a character says too. Without colours there is a theme of its own, which
//! tells the selected row by reverse video.

use ratatui::style::{Modifier, Style};

use super::caps::{Capabilities, ColourDepth};
use super::colours::Colours;
use super::marker::Marker;

/// Every style and character that the screens use.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Theme {
    pub fe: Style,
    pub enhanced: Style,
    pub basic: Style,
    /// Behind the columns where the enhanced model is off by more than the tolerance.
    pub band: Style,
    /// Differences beyond the tolerance.
    pub beyond: Style,
    pub border: Style,
    pub border_focused: Style,
    pub title: Style,
    pub selected: Style,
    pub faint: Style,
    pub error: Style,
    pub warning: Style,
    pub key: Style,
    pub glyphs: &'static Glyphs,
    /// What curves and shafts are drawn with.
    pub marker: Marker,
    /// What all of this was chosen for.
    pub capabilities: Capabilities,
}

/// The characters that differ between Unicode and ASCII.
#[derive(Debug, PartialEq)]
pub struct Glyphs {
    pub ascii: bool,
    pub ellipsis: &'static str,
    pub separator: &'static str,
    pub minus: &'static str,
    pub plus_minus: &'static str,
    pub selected: &'static str,
    pub broken: &'static str,
    /// The design that others are compared with.
    pub marked: &'static str,
    /// Before a variant, below its parent.
    pub branch: &'static str,
    pub bearing: char,
    pub rigid_bearing: char,
    pub mesh: char,
    /// Above what the cursor is on.
    pub pointer: char,
    /// Dots of the saved state's curve.
    pub ghost: char,
    /// A box that is ticked.
    pub ticked: char,
    /// The trust limit on the frequency axis.
    pub trust: char,
    pub band: char,
    /// The letters of the curves where there are no dots.
    pub letters: [char; 3],
    pub horizontal: char,
    pub vertical: char,
    pub top_left: char,
    pub top_right: char,
    pub bottom_left: char,
    pub bottom_right: char,
    pub tee_left: char,
    pub tee_right: char,
    pub tick_left: char,
    pub tick_down: char,
}

static UNICODE: Glyphs = Glyphs {
    ascii: false,
    ellipsis: "…",
    separator: "·",
    minus: "−",
    plus_minus: "±",
    selected: "▌",
    broken: "×",
    marked: "◆",
    branch: "└ ",
    bearing: '△',
    rigid_bearing: '▲',
    mesh: '×',
    pointer: '▼',
    ghost: '·',
    ticked: '×',
    trust: '▲',
    band: '░',
    letters: ['F', 'e', 'b'],
    horizontal: '─',
    vertical: '│',
    top_left: '┌',
    top_right: '┐',
    bottom_left: '└',
    bottom_right: '┘',
    tee_left: '├',
    tee_right: '┤',
    tick_left: '┤',
    tick_down: '┬',
};

static ASCII: Glyphs = Glyphs {
    ascii: true,
    ellipsis: "..",
    separator: "-",
    minus: "-",
    plus_minus: "+/-",
    selected: ">",
    broken: "x",
    marked: "@",
    branch: "`-",
    bearing: '^',
    rigid_bearing: 'A',
    mesh: 'x',
    pointer: 'v',
    ghost: '.',
    ticked: 'x',
    trust: '^',
    band: ':',
    letters: ['F', 'e', 'b'],
    horizontal: '-',
    vertical: '|',
    top_left: '+',
    top_right: '+',
    bottom_left: '+',
    bottom_right: '+',
    tee_left: '+',
    tee_right: '+',
    tick_left: '+',
    tick_down: '+',
};

impl Theme {
    /// The theme for a terminal. Without more than the user's own 16 colours, all is made of those.
    pub fn new(capabilities: Capabilities) -> Self {
        let glyphs = if capabilities.ascii { &ASCII } else { &UNICODE };
        let plain = Style::new();
        let bold = plain.add_modifier(Modifier::BOLD);
        let monochrome = Self {
            fe: plain,
            enhanced: plain,
            basic: plain,
            band: plain,
            beyond: bold,
            border: plain,
            border_focused: bold,
            title: bold,
            selected: plain.add_modifier(Modifier::REVERSED),
            faint: plain,
            error: bold,
            warning: bold,
            key: bold,
            glyphs,
            marker: Marker::first(capabilities.ascii),
            capabilities,
        };
        if capabilities.colour == ColourDepth::None {
            return monochrome;
        }
        let colours = Colours::new(capabilities.colour, capabilities.background);
        Self {
            enhanced: plain.fg(colours.enhanced),
            basic: plain.fg(colours.basic),
            band: colours.band,
            beyond: bold.fg(colours.error),
            border: colours.border,
            border_focused: bold.fg(colours.enhanced),
            faint: colours.faint,
            error: bold.fg(colours.error),
            warning: bold.fg(colours.warning),
            key: bold.fg(colours.enhanced),
            ..monochrome
        }
    }
}
