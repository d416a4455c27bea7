//! The colours of the themes, by what lies behind them.
//!
//! Where the terminal has more than its own 16 colours, every colour is chosen so that text on it can be read: at least
//! 4.5 to 1 where the background is known, and about 4.5 to 1 on black and on white alike where it is not (the best that
//! one colour can do). The 16 colours are the user's own; of those, the ones that are pale in the usual palettes are kept off
//! light backgrounds, and nothing is dimmed there.

use ratatui::style::{Color, Modifier, Style};

use super::caps::{Background, ColourDepth};

/// The colours of a theme; nothing where the terminal's own is as good.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Colours {
    pub enhanced: Color,
    pub basic: Color,
    pub error: Color,
    pub warning: Color,
    /// What is there to be found, not to be read first.
    pub faint: Style,
    pub border: Style,
    pub band: Style,
}

impl Colours {
    /// The colours for a terminal that has some.
    pub fn new(depth: ColourDepth, background: Background) -> Self {
        match (depth, background) {
            (ColourDepth::None | ColourDepth::Sixteen, Background::Light) => ON_LIGHT_16,
            (ColourDepth::None | ColourDepth::Sixteen, background) => on_dark_16(background),
            (ColourDepth::Indexed | ColourDepth::True, Background::Unknown) => ON_EITHER,
            (ColourDepth::Indexed | ColourDepth::True, Background::Dark) => ON_DARK,
            (ColourDepth::Indexed | ColourDepth::True, Background::Light) => ON_LIGHT,
        }
    }
}

const fn indexed(colour: u8) -> Style {
    Style::new().fg(Color::Indexed(colour))
}

const ON_DARK: Colours = Colours {
    enhanced: Color::Indexed(45),
    basic: Color::Indexed(213),
    error: Color::Indexed(210),
    warning: Color::Indexed(220),
    faint: indexed(247),
    border: indexed(243),
    // of the two, the character is for those who cannot tell the tint
    band: indexed(88).bg(Color::Indexed(52)),
};

const ON_LIGHT: Colours = Colours {
    enhanced: Color::Indexed(25),
    basic: Color::Indexed(127),
    error: Color::Indexed(124),
    warning: Color::Indexed(94),
    faint: indexed(240),
    border: indexed(243),
    band: indexed(217).bg(Color::Indexed(224)),
};

/// A tint would have to differ from the curves, from black and from white: the band is its character alone.
const ON_EITHER: Colours = Colours {
    enhanced: Color::Indexed(31),
    basic: Color::Indexed(163),
    error: Color::Indexed(131),
    warning: Color::Indexed(130),
    faint: indexed(243),
    border: indexed(243),
    band: indexed(243),
};

const ON_LIGHT_16: Colours = Colours {
    enhanced: Color::Blue,
    basic: Color::Magenta,
    error: Color::Red,
    warning: Color::Magenta,
    faint: Style::new(),
    border: Style::new(),
    band: Style::new().bg(Color::Gray),
};

const fn on_dark_16(background: Background) -> Colours {
    let dim = Style::new().add_modifier(Modifier::DIM);
    Colours {
        enhanced: Color::Cyan,
        basic: Color::Magenta,
        error: Color::Red,
        warning: Color::Yellow,
        // it may be a light one after all
        faint: if matches!(background, Background::Dark) { dim } else { Style::new() },
        border: dim,
        // or half a picture of it would outshine the curves
        band: dim.bg(Color::DarkGray),
    }
}
