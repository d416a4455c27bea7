//! What curves and shafts are drawn with.
//!
//! ```text
//!            braille   blocks   points   dots, letters
//! one cell:   o o       o o       o
//!             o o       o o       o           o
//!             o o
//!             o o
//! ```

use super::widgets::plot::Dash;

/// A set of characters that a picture is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Marker {
    /// The finest
    Braille,
    /// Quarters of a cell, which more fonts have
    Blocks,
    Dots,
    /// The letter of each curve
    Letters,
    /// Two dots a cell, in ASCII
    Points,
}

/// By bit: top left, top right, bottom left, bottom right.
const QUADRANTS: [char; 16] = [' ', '▘', '▝', '▀', '▖', '▌', '▞', '▛', '▗', '▚', '▐', '▜', '▄', '▙', '▟', '█'];

impl Marker {
    /// Those that a terminal can show.
    pub fn all(ascii: bool) -> &'static [Self] {
        if ascii { &[Self::Letters, Self::Points] } else { &[Self::Braille, Self::Blocks, Self::Dots, Self::Letters] }
    }

    /// The one to start with.
    pub fn first(ascii: bool) -> Self {
        if ascii { Self::Letters } else { Self::Braille }
    }

    /// The next one that the terminal can show; after the last the first.
    #[must_use]
    pub fn next(self, ascii: bool) -> Self {
        let mut rest = Self::all(ascii).iter().skip_while(|marker| **marker != self).skip(1);
        rest.next().copied().unwrap_or(Self::first(ascii))
    }

    pub fn name(self) -> &'static str {
        match self {
            Self::Braille => "braille",
            Self::Blocks => "blocks",
            Self::Dots => "dots",
            Self::Letters => "ASCII letters",
            Self::Points => "ASCII points",
        }
    }

    /// Dots in one cell, across and down.
    pub fn dots(self) -> (usize, usize) {
        match self {
            Self::Braille => (2, 4),
            Self::Blocks => (2, 2),
            Self::Points => (1, 2),
            Self::Dots | Self::Letters => (1, 1),
        }
    }

    /// The character of a cell with these dots: bit 2 y + x is column x, row y. Nothing where it is the curve's letter.
    pub fn character(self, dots: u8) -> Option<char> {
        match self {
            Self::Braille => Some(braille(dots)),
            Self::Blocks => QUADRANTS.get(usize::from(dots)).copied(),
            Self::Dots => Some('•'),
            Self::Letters => None,
            Self::Points => Some(match dots {
                0b001 => '\'',
                0b100 => ',',
                _ => '|',
            }),
        }
    }

    /// How the curves are told apart without colour: FE, enhanced, basic.
    pub fn dashes(self) -> [Dash; 3] {
        let dashed = if self.dots().0 == 2 { Dash { on: 6, off: 4 } } else { Dash { on: 2, off: 2 } };
        [Dash { on: 1, off: 0 }, dashed, Dash { on: 1, off: 2 }]
    }

    /// How the legend shows the curves: FE, enhanced, basic.
    pub fn samples(self) -> [&'static str; 3] {
        match self {
            Self::Letters => ["F", "e", "b"],
            Self::Points => [",,,", ",,", ","],
            Self::Dots => ["•••", "••", "•"],
            Self::Braille | Self::Blocks => ["━", "╍", "┈"],
        }
    }

    /// How the legend of two designs shows them: A, B.
    pub fn samples_of_two(self) -> [&'static str; 2] {
        let [first, second, _] = self.samples();
        if self == Self::Letters { ["a", "b"] } else { [first, second] }
    }
}

/// Unicode counts the dots down the left column, then down the right one, and the fourth row last.
fn braille(dots: u8) -> char {
    const PLACES: [u32; 8] = [0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80];
    let pattern = (0..8).filter(|bit| dots >> bit & 1 == 1).map(|bit| PLACES[bit]).sum::<u32>();
    char::from_u32(0x2800 + pattern).unwrap_or(' ')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cycle_comes_back_and_has_each_once() {
        for ascii in [false, true] {
            let mut seen = vec![Marker::first(ascii)];
            while let next = seen[seen.len() - 1].next(ascii)
                && next != seen[0]
            {
                assert!(!seen.contains(&next) && seen.len() < 9, "{seen:?}");
                seen.push(next);
            }
            assert_eq!(seen, Marker::all(ascii));
            assert!(ascii || seen.len() == 4);
        }
    }

    #[test]
    fn markers_of_ascii_terminals_draw_ascii() {
        for marker in Marker::all(true) {
            for dots in 0..=u8::MAX {
                assert!(marker.character(dots).is_none_or(|shown| shown.is_ascii()), "{marker:?}");
            }
            assert!(marker.samples().iter().all(|sample| sample.is_ascii()));
        }
    }
}
