//! Points in time as people and file names have them, in UTC.

use std::time::{SystemTime, UNIX_EPOCH};

/// `20250131T120000Z`, which sorts by time.
pub fn stamp(time: SystemTime) -> String {
    let ([year, month, day], [hour, minute, second], _) = parts(time);
    format!("{year:04}{month:02}{day:02}T{hour:02}{minute:02}{second:02}Z")
}

/// `2025-01-31 12:00:00.123Z`
pub fn readable(time: SystemTime) -> String {
    let ([year, month, day], [hour, minute, second], millis) = parts(time);
    format!("{year:04}-{month:02}-{day:02} {hour:02}:{minute:02}:{second:02}.{millis:03}Z")
}

/// `2025-01-31`
pub fn day(time: SystemTime) -> String {
    let ([year, month, day], ..) = parts(time);
    format!("{year:04}-{month:02}-{day:02}")
}

/// Year, month, day; hour, minute, second; milliseconds. Before 1970 it is 1970.
fn parts(time: SystemTime) -> ([u64; 3], [u64; 3], u32) {
    let since = time.duration_since(UNIX_EPOCH).unwrap_or_default();
    let (days, second) = (since.as_secs() / 86_400, since.as_secs() % 86_400);
    (date(days), [second / 3600, second / 60 % 60, second % 60], since.subsec_millis())
}

/// Year, month and day of the Gregorian calendar, from days since 1970-01-01 (Hinnant, "chrono-compatible low-level date
/// algorithms", `civil_from_days`).
fn date(days: u64) -> [u64; 3] {
    let days = days + 719_468;
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let year = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    [year + era * 400 + u64::from(month <= 2), month, day]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    // Dates by `date -u -d @SECONDS`.
    #[test]
    fn stamps_are_dates() {
        for (seconds, expected) in [
            (0, "19700101T000000Z"),
            (951_782_400, "20000229T000000Z"),
            (1_709_251_199, "20240229T235959Z"),
            (4_107_542_400, "21000301T000000Z"),
        ] {
            assert_eq!(stamp(UNIX_EPOCH + Duration::from_secs(seconds)), expected);
        }
        let time = UNIX_EPOCH + Duration::from_millis(1_709_251_199_042);
        assert_eq!(readable(time), "2024-02-29 23:59:59.042Z");
        assert_eq!(day(time), "2024-02-29");
    }
}
