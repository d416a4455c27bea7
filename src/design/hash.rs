//! What tells one text of a design from another.

use sha2::{Digest, Sha256};

/// The hash of a design, by which a result says what it came from: the first 12 hexadecimal digits of the SHA-256 of the file's
/// bytes.
///
/// ```
/// // FIPS 180-2, appendix B.1
/// assert_eq!(bevelscope::design::hash(b"abc"), "ba7816bf8f01");
/// ```
pub fn hash(file: &[u8]) -> String {
    let mut digits = checksum(file);
    digits.truncate(12);
    digits
}

/// All 64 digits.
pub(super) fn checksum(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 16] = b"0123456789abcdef";
    let digest = Sha256::digest(bytes);
    let digit = |half: u8| char::from(DIGITS[usize::from(half)]);
    digest.iter().flat_map(|byte| [digit(byte >> 4), digit(byte & 15)]).collect()
}
