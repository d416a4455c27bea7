//! Colours and characters.
//!
//! State never hangs on colour: what a style says, a character says too. The monochrome theme is chosen here, and not
//! left to crossterm: with `NO_COLOR` set, crossterm 0.29 writes an empty colour command in place of each colour, which
//! is a full reset and takes the reverse video of the selected row with it.

use ratatui::style::{Color, Modifier, Style};

use super::caps::{Background, Capabilities, ColourDepth};

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
    /// How the legend shows the curves: FE, enhanced, basic.
    pub samples: [&'static str; 3],
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
    samples: ["━", "╍", "┈"],
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
    samples: ["F", "e", "b"],
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
    /// The theme for a terminal. All but the band behind the curves comes from the user's own 16 colours, so light and
    /// dark backgrounds both work.
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
        };
        if capabilities.colour == ColourDepth::None {
            return monochrome;
        }
        Self {
            enhanced: plain.fg(Color::Cyan),
            basic: plain.fg(Color::Magenta),
            // dimmed, or half a picture of it would outshine the curves
            band: plain.bg(band_colour(capabilities)).add_modifier(Modifier::DIM),
            beyond: bold.fg(Color::Red),
            border: plain.add_modifier(Modifier::DIM),
            border_focused: bold.fg(Color::Cyan),
            faint: plain.add_modifier(Modifier::DIM),
            error: bold.fg(Color::Red),
            warning: bold.fg(Color::Yellow),
            key: bold.fg(Color::Cyan),
            ..monochrome
        }
    }
}

/// Grey from the user's palette lies under dark and light text alike; a tint needs to know what it lies on.
fn band_colour(capabilities: Capabilities) -> Color {
    match (capabilities.colour, capabilities.background) {
        (ColourDepth::True, Background::Dark) => Color::Rgb(72, 36, 36),
        (ColourDepth::True, Background::Light) => Color::Rgb(250, 222, 218),
        (ColourDepth::Indexed, Background::Dark) => Color::Indexed(52),
        (ColourDepth::Indexed, Background::Light) => Color::Indexed(224),
        _ => Color::DarkGray,
    }
}
