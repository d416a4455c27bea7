//! Figures as the screen shows them.

use std::time::Duration;

/// A span of time in the unit that suits it.
pub fn duration(elapsed: Duration) -> String {
    let milliseconds = elapsed.as_secs_f64() * 1e3;
    if milliseconds < 10.0 {
        format!("{milliseconds:.1} ms")
    } else if milliseconds < 1000.0 {
        format!("{milliseconds:.0} ms")
    } else {
        format!("{:.1} s", milliseconds / 1e3)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_have_the_unit_that_suits_them() {
        assert_eq!(duration(Duration::from_micros(612)), "0.6 ms");
        assert_eq!(duration(Duration::from_millis(2540)), "2.5 s");
    }
}
