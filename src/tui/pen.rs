//! What a terminal writes with, and the shortest way from one such state to another (ECMA-48, SGR).

use ratatui::style::{Color, Modifier};

/// Colours and modifiers in force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Pen {
    pub fg: Color,
    pub bg: Color,
    pub modifier: Modifier,
}

/// Modifiers that are set and reset by themselves.
const ALONE: [(Modifier, &str, &str); 6] = [
    (Modifier::ITALIC, "3", "23"),
    (Modifier::UNDERLINED, "4", "24"),
    (Modifier::SLOW_BLINK, "5", "25"),
    (Modifier::REVERSED, "7", "27"),
    (Modifier::HIDDEN, "8", "28"),
    (Modifier::CROSSED_OUT, "9", "29"),
];
/// Modifiers that have one reset together.
const WEIGHTS: [(Modifier, &str); 2] = [(Modifier::BOLD, "1"), (Modifier::DIM, "2")];
/// Modifiers that show on a blank cell.
const ON_BLANK: Modifier = Modifier::UNDERLINED.union(Modifier::REVERSED).union(Modifier::CROSSED_OUT);

impl Pen {
    /// What looks the same on a blank cell and is nearer to `now`.
    #[must_use]
    pub fn for_blank(self, now: Self) -> Self {
        let shows = self.modifier & ON_BLANK;
        let fg = if shows.is_empty() { now.fg } else { self.fg };
        Self { fg, bg: self.bg, modifier: shows | (now.modifier - ON_BLANK) }
    }

    /// The sequence that leads from `now` to this; `None` is not known.
    pub fn sequence(self, now: Option<Self>) -> String {
        let whole = self.codes(Self::default(), vec!["0".into()]);
        let codes = match now {
            Some(now) if now == self => return String::new(),
            Some(now) => {
                let part = self.codes(now, Vec::new());
                if part.len() <= whole.len() { part } else { whole }
            }
            None => whole,
        };
        // zero is what is meant where nothing stands
        format!("\x1b[{}m", if codes == "0" { "" } else { &codes })
    }

    /// The parameters that lead from `now` to this, after those given.
    fn codes(self, now: Self, mut codes: Vec<String>) -> String {
        let (added, removed) = (self.modifier - now.modifier, now.modifier - self.modifier);
        let weights = Modifier::BOLD | Modifier::DIM;
        let lighter = removed.intersects(weights);
        if lighter {
            codes.push("22".into());
        }
        let again = if lighter { self.modifier & weights } else { added };
        codes.extend(WEIGHTS.iter().filter(|(one, _)| again.contains(*one)).map(|(_, on)| (*on).to_owned()));
        for (one, on, off) in ALONE {
            if added.contains(one) {
                codes.push(on.into());
            } else if removed.contains(one) {
                codes.push(off.into());
            }
        }
        if self.fg != now.fg {
            codes.push(colour(self.fg, 30));
        }
        if self.bg != now.bg {
            codes.push(colour(self.bg, 40));
        }
        codes.join(";")
    }
}

/// The parameters of a colour; `base` is 30 for the text, 40 for what is behind it.
fn colour(colour: Color, base: u8) -> String {
    let place = match colour {
        Color::Reset => return (base + 9).to_string(),
        Color::Indexed(place) => return format!("{};5;{place}", base + 8),
        Color::Rgb(red, green, blue) => return format!("{};2;{red};{green};{blue}", base + 8),
        Color::Black => 0,
        Color::Red => 1,
        Color::Green => 2,
        Color::Yellow => 3,
        Color::Blue => 4,
        Color::Magenta => 5,
        Color::Cyan => 6,
        Color::Gray => 7,
        Color::DarkGray => 60,
        Color::LightRed => 61,
        Color::LightGreen => 62,
        Color::LightYellow => 63,
        Color::LightBlue => 64,
        Color::LightMagenta => 65,
        Color::LightCyan => 66,
        Color::White => 67,
    };
    (base + place).to_string()
}
