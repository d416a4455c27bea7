//! What the terminal can show, found out from the environment.

/// How many colours may be used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColourDepth {
    None,
    /// The 16 colours that the user's own palette defines.
    Sixteen,
    Indexed,
    True,
}

/// What lies behind the text, as far as the terminal says so.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Background {
    Unknown,
    Dark,
    Light,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Capabilities {
    pub colour: ColourDepth,
    pub background: Background,
    /// Nothing beyond 7-bit ASCII is drawn.
    pub ascii: bool,
}

/// What was found out, and from what.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Detected {
    pub capabilities: Capabilities,
    pub colour_why: &'static str,
    pub background_why: &'static str,
    pub characters_why: &'static str,
}

impl Capabilities {
    /// Reads the environment through `variable`; `ascii` is what the command line asks for.
    pub fn detect(ascii: bool, variable: impl Fn(&str) -> Option<String>) -> Self {
        Detected::new(ascii, variable).capabilities
    }
}

impl Detected {
    /// As [`Capabilities::detect`].
    pub fn new(ascii: bool, variable: impl Fn(&str) -> Option<String>) -> Self {
        let given = |name: &str| variable(name).filter(|value| !value.is_empty());
        let terminal = given("TERM").unwrap_or_default();
        let (colour, colour_why) = if given("NO_COLOR").is_some() {
            (ColourDepth::None, "NO_COLOR is set")
        } else if terminal == "dumb" {
            (ColourDepth::None, "TERM is dumb")
        } else if terminal == "linux" {
            (ColourDepth::Sixteen, "TERM is linux, a console")
        } else if given("COLORTERM").is_some_and(|value| value == "truecolor" || value == "24bit") {
            (ColourDepth::True, "COLORTERM says so")
        } else if terminal.contains("256color") {
            (ColourDepth::Indexed, "TERM says so")
        } else {
            (ColourDepth::Sixteen, "neither TERM nor COLORTERM promises more")
        };
        let (background, background_why) = background(given("COLORFGBG").as_deref());
        // the first that is set decides, as in the C library; Windows has none of them and is always Unicode
        let locale = given("LC_ALL").or_else(|| given("LC_CTYPE")).or_else(|| given("LANG")).unwrap_or_default();
        let locale = locale.to_ascii_lowercase();
        let unicode = cfg!(windows) || locale.contains("utf-8") || locale.contains("utf8");
        let (ascii, characters_why) = if ascii {
            (true, "--ascii")
        } else if !unicode {
            (true, "the locale is not UTF-8")
        } else if matches!(terminal.as_str(), "dumb" | "linux") {
            // the font of the Linux console has no braille
            (true, "TERM names a terminal whose font has little else")
        } else {
            (false, "the locale is UTF-8")
        };
        let capabilities = Capabilities { colour, background, ascii };
        Self { capabilities, colour_why, background_why, characters_why }
    }
}

/// `COLORFGBG` is "foreground;background" in numbers of the 16-colour palette.
fn background(colours: Option<&str>) -> (Background, &'static str) {
    match colours.and_then(|value| value.rsplit(';').next()).map(str::parse::<u8>) {
        Some(Ok(7 | 9..=15)) => (Background::Light, "COLORFGBG"),
        Some(Ok(_)) => (Background::Dark, "COLORFGBG"),
        Some(Err(_)) => (Background::Unknown, "COLORFGBG has no number for it"),
        None => (Background::Unknown, "COLORFGBG is not set"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn detect(variables: &[(&str, &str)]) -> Capabilities {
        Capabilities::detect(false, |name| {
            variables.iter().find(|(key, _)| *key == name).map(|(_, value)| (*value).to_owned())
        })
    }

    #[test]
    fn no_color_and_plain_terminals_win_over_what_else_is_claimed() {
        let utf8 = ("LANG", "en_US.UTF-8");
        let cases: &[(&[(&str, &str)], ColourDepth)] = &[
            (&[("TERM", "xterm-256color"), ("COLORTERM", "truecolor")], ColourDepth::True),
            (&[("TERM", "xterm-256color")], ColourDepth::Indexed),
            (&[("TERM", "xterm")], ColourDepth::Sixteen),
            (&[("TERM", "linux"), ("COLORTERM", "truecolor")], ColourDepth::Sixteen),
            (&[("TERM", "dumb"), ("COLORTERM", "truecolor")], ColourDepth::None),
            (&[("TERM", "xterm-256color"), ("NO_COLOR", "1")], ColourDepth::None),
            (&[("TERM", "xterm-256color"), ("NO_COLOR", "")], ColourDepth::Indexed),
        ];
        for (variables, expected) in cases {
            let variables: Vec<_> = variables.iter().copied().chain([utf8]).collect();
            assert_eq!(detect(&variables).colour, *expected, "{variables:?}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn the_first_locale_variable_that_is_set_decides() {
        let cases: &[(&[(&str, &str)], bool)] = &[
            (&[("LANG", "en_US.UTF-8")], false),
            (&[("LANG", "C.utf8")], false),
            (&[("LC_CTYPE", "UTF-8")], false),
            (&[("LC_ALL", "C"), ("LANG", "en_US.UTF-8")], true),
            (&[("LC_ALL", ""), ("LANG", "en_US.UTF-8")], false),
            (&[], true),
            (&[("TERM", "linux"), ("LANG", "en_US.UTF-8")], true),
        ];
        for (variables, expected) in cases {
            assert_eq!(detect(variables).ascii, *expected, "{variables:?}");
        }
    }

    #[test]
    fn the_background_is_known_only_where_the_terminal_says_so() {
        assert_eq!(detect(&[("COLORFGBG", "15;0")]).background, Background::Dark);
        assert_eq!(detect(&[("COLORFGBG", "0;default;15")]).background, Background::Light);
        assert_eq!(detect(&[]).background, Background::Unknown);
    }
}
