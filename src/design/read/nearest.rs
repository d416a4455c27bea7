//! "Did you mean": the known word nearest to an unknown one.

/// Longer words are not typing errors, and comparing them takes time.
const LONGEST: usize = 64;

/// The nearest of the known words, if one is near.
pub(crate) fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if word.len() > LONGEST || word.is_empty() {
        return None;
    }
    let word = word.to_lowercase();
    known
        .into_iter()
        .map(|candidate| (similarity(&word, &candidate.to_lowercase()), candidate))
        .filter(|(similarity, _)| *similarity >= 0.8)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, candidate)| candidate)
}

fn similarity(word: &str, candidate: &str) -> f64 {
    // a key without its unit is the commonest slip, and short ones would not count as near
    let without_unit = candidate.strip_prefix(word).is_some_and(|rest| rest.starts_with('_'));
    if without_unit { 1.0 } else { strsim::jaro_winkler(word, candidate) }
}

/// "did you mean `length_mm`? ", with the space at the end, or nothing.
pub(crate) fn did_you_mean<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(word, known).map_or_else(String::new, |nearest| format!("did you mean `{nearest}`? "))
}

/// The words one after the other; the rest of a long list is counted.
pub(crate) fn listed<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    const MOST: usize = 24;
    let words: Vec<&str> = words.into_iter().collect();
    let shown = words.iter().take(MOST).copied().collect::<Vec<_>>().join(", ");
    if words.len() > MOST { format!("{shown} and {} more", words.len() - MOST) } else { shown }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_find_their_word_and_nonsense_none() {
        let keys = ["length_mm", "outer_diameter_mm", "inner_diameter_mm", "material", "elements", "kx_n_per_m"];
        for (slip, meant) in [
            ("lenght_mm", "length_mm"),
            ("length", "length_mm"),
            ("length_m", "length_mm"),
            ("Material", "material"),
            ("outer_diamter_mm", "outer_diameter_mm"),
            ("kx", "kx_n_per_m"),
        ] {
            assert_eq!(nearest(slip, keys), Some(meant), "{slip}");
        }
        assert_eq!(nearest("colour", keys), None);
        assert_eq!(nearest(&"length_mm".repeat(1000), keys), None);
    }
}
