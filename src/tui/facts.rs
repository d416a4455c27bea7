//! What the program sees of the terminal, in words: for bug reports, the log and `doctor`.

use std::io::{IsTerminal, stdin, stdout};

use ratatui::crossterm::terminal::size;

use super::caps::{Background, ColourDepth, Detected};
use super::clipboard::Route;

/// One thing that is known: what it is called, and what it is.
pub type Fact = (&'static str, String);

/// All that follows from the environment and the terminal. The values are as they are: make them
/// [printable](crate::text::printable).
pub fn facts(ascii: bool, variable: impl Fn(&str) -> Option<String>) -> Vec<Fact> {
    let given = |name: &str| variable(name).filter(|value| !value.is_empty());
    let shown = |name: &str| given(name).unwrap_or_else(|| "not set".into());
    let yes = |is: bool| if is { "yes" } else { "no" };
    let detected = Detected::new(ascii, &variable);
    let capabilities = detected.capabilities;
    let colours = match capabilities.colour {
        ColourDepth::None => "none",
        ColourDepth::Sixteen => "16",
        ColourDepth::Indexed => "256",
        ColourDepth::True => "16 million",
    };
    let background = match capabilities.background {
        Background::Unknown => "unknown: colours for both",
        Background::Dark => "dark",
        Background::Light => "light",
    };
    let locale = ["LC_ALL", "LC_CTYPE", "LANG"].into_iter().find_map(|name| given(name).map(|value| (name, value)));
    vec![
        ("input is a terminal", yes(stdin().is_terminal()).into()),
        ("output is a terminal", yes(stdout().is_terminal()).into()),
        ("size", size_of_terminal().map_or_else(|| "not known".into(), |(columns, rows)| format!("{columns}x{rows}"))),
        ("TERM", shown("TERM")),
        ("program", given("TERM_PROGRAM").unwrap_or_else(|| "not set (TERM_PROGRAM)".into())),
        ("tmux", yes(given("TMUX").is_some()).into()),
        ("screen", yes(given("STY").is_some()).into()),
        ("ssh", yes(["SSH_TTY", "SSH_CONNECTION"].into_iter().any(|name| given(name).is_some())).into()),
        ("locale", locale.map_or_else(|| "not set".into(), |(name, value)| format!("{value} ({name})"))),
        ("NO_COLOR", shown("NO_COLOR")),
        ("COLORTERM", shown("COLORTERM")),
        ("COLORFGBG", shown("COLORFGBG")),
        ("colours", format!("{colours}: {}", detected.colour_why)),
        ("background", format!("{background} ({})", detected.background_why)),
        (
            "characters",
            format!("{}: {}", if capabilities.ascii { "ASCII" } else { "Unicode" }, detected.characters_why),
        ),
        ("clipboard", Route::detect(&variable).describe().into()),
    ]
}

/// Facts as lines of text, harmless to show.
pub fn as_text(facts: &[Fact]) -> String {
    let line = |(name, value): &Fact| format!("{name}: {}", crate::text::printable(value));
    facts.iter().map(line).collect::<Vec<_>>().join("\n")
}

fn size_of_terminal() -> Option<(u16, u16)> {
    // without a terminal, crossterm would ask the program `tput`
    if stdout().is_terminal() || stdin().is_terminal() { size().ok() } else { None }
}
