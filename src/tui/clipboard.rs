//! A text handed to the terminal for its clipboard: OSC 52, which goes through SSH, and through tmux and screen with their
//! help.
//!
//! The text goes in as base64, so nothing in it can end the sequence or steer the terminal. The terminal never answers,
//! and whether it took the text cannot be known.

/// The longest text, bytes. Terminals take sequences of up to 100,000 bytes (hterm's limit), of which base64 has 4 for 3.
pub const LONGEST: usize = 74_994;

/// GNU screen hands no string on that is longer than 256 bytes in its older versions.
const SCREEN_PIECE: usize = 240;

/// What stands between the program and the terminal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Route {
    #[default]
    Direct,
    /// tmux takes the sequence itself with `set-clipboard on`, and hands it on with `allow-passthrough on`.
    Tmux,
    /// GNU screen hands on what it is given in pieces.
    Screen,
}

impl Route {
    /// Reads the environment through `variable`.
    pub fn detect(variable: impl Fn(&str) -> Option<String>) -> Self {
        let given = |name: &str| variable(name).filter(|value| !value.is_empty());
        if given("TMUX").is_some() {
            Self::Tmux
        } else if given("STY").is_some() || given("TERM").is_some_and(|terminal| is_screen(&terminal)) {
            Self::Screen
        } else {
            Self::Direct
        }
    }

    /// In a few words.
    pub fn describe(self) -> &'static str {
        match self {
            Self::Direct => "OSC 52",
            Self::Tmux => "OSC 52, plain for `set-clipboard on` and wrapped for `allow-passthrough on`",
            Self::Screen => "OSC 52 in the pieces that GNU screen hands on",
        }
    }
}

fn is_screen(terminal: &str) -> bool {
    terminal == "screen" || terminal.starts_with("screen.") || terminal.starts_with("screen-")
}

/// The text is longer than [`LONGEST`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("not copied: {0} bytes are more than the {LONGEST} that terminals take")]
pub struct TooLong(pub usize);

/// The bytes that hand a text to the terminal.
///
/// # Errors
///
/// [`TooLong`].
pub fn sequence(text: &str, route: Route) -> Result<Vec<u8>, TooLong> {
    if text.len() > LONGEST {
        return Err(TooLong(text.len()));
    }
    let plain = format!("\x1b]52;c;{}\x07", base64(text.as_bytes()));
    let bytes = match route {
        Route::Direct => plain,
        Route::Tmux => format!("{plain}\x1bPtmux;{}\x1b\\", plain.replace('\x1b', "\x1b\x1b")),
        // all of it is ASCII: any place is one between characters
        Route::Screen => plain
            .as_bytes()
            .chunks(SCREEN_PIECE)
            .fold(String::new(), |all, piece| all + "\x1bP" + &String::from_utf8_lossy(piece) + "\x1b\\"),
    };
    Ok(bytes.into_bytes())
}

/// RFC 4648, section 4.
fn base64(bytes: &[u8]) -> String {
    const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for piece in bytes.chunks(3) {
        let bits = (0..3).fold(0_u32, |bits, at| bits << 8 | u32::from(piece.get(at).copied().unwrap_or(0)));
        for at in 0..4 {
            let letter = char::from(ALPHABET[(bits >> (18 - 6 * at) & 63) as usize]);
            text.push(if at <= piece.len() { letter } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    // the test vectors of RFC 4648, section 10
    #[test]
    fn base64_is_that_of_the_standard() {
        let vectors = [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ];
        for (plain, coded) in vectors {
            assert_eq!(base64(plain.as_bytes()), coded);
        }
        assert_eq!(base64(&[0xfb, 0xff, 0xfe]), "+//+");
    }

    #[test]
    fn each_route_has_its_wrapping() {
        let bytes = |text: &str, route| String::from_utf8(sequence(text, route).unwrap()).unwrap();
        assert_eq!(bytes("foobar", Route::Direct), "\x1b]52;c;Zm9vYmFy\x07");
        assert_eq!(bytes("foobar", Route::Tmux), "\x1b]52;c;Zm9vYmFy\x07\x1bPtmux;\x1b\x1b]52;c;Zm9vYmFy\x07\x1b\\");
        assert_eq!(bytes("foobar", Route::Screen), "\x1bP\x1b]52;c;Zm9vYmFy\x07\x1b\\");
        let long = "x".repeat(5000);
        let pieces = bytes(&long, Route::Screen);
        let pieces: Vec<&str> = pieces.split_terminator("\x1b\\").collect();
        assert!(pieces.len() > 20 && pieces.iter().all(|piece| piece.starts_with("\x1bP") && piece.len() <= 256));
        let whole: String = pieces.iter().map(|piece| &piece[2..]).collect();
        assert_eq!(whole, bytes(&long, Route::Direct));
    }

    #[test]
    fn what_is_too_long_is_refused() {
        assert_eq!(sequence(&"x".repeat(LONGEST), Route::Direct).unwrap().len(), 100_000);
        let error = sequence(&"x".repeat(LONGEST + 1), Route::Tmux).unwrap_err();
        assert_eq!(error.to_string(), "not copied: 74995 bytes are more than the 74994 that terminals take");
    }

    #[test]
    fn the_route_follows_from_the_environment() {
        let route = |variables: &[(&str, &str)]| {
            Route::detect(|name| variables.iter().find(|(key, _)| *key == name).map(|(_, value)| (*value).to_owned()))
        };
        assert_eq!(route(&[("TERM", "xterm-256color")]), Route::Direct);
        assert_eq!(route(&[("TERM", "screen-256color"), ("TMUX", "/tmp/tmux-0/default,1,0")]), Route::Tmux);
        assert_eq!(route(&[("TERM", "screen.xterm-256color")]), Route::Screen);
        assert_eq!(route(&[("TERM", "xterm"), ("STY", "1.pts-0.host")]), Route::Screen);
    }
}
