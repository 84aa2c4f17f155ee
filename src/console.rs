//! What consoles write around numbers.

use nalgebra::Matrix3;
use std::borrow::Cow;

/// The text with what consoles write around lists of numbers blanked, every byte at its place.
///
/// `Float32Array(4) [ … ]`, `Mat3(9) [ … ]`, and the corners and lines that are drawn around a matrix.
pub(crate) fn without_wrappers(text: &str) -> Cow<'_, str> {
    let mut bare = Cow::Borrowed(text);
    while let Some(found) = typed_list(&bare).or_else(|| drawn(&bare)) {
        let blank = " ".repeat(found.len());
        bare.to_mut().replace_range(found, &blank);
    }
    bare
}

/// `Name(9)` before a bracket.
fn typed_list(text: &str) -> Option<std::ops::Range<usize>> {
    text.match_indices('[').find_map(|(at, _)| {
        let before = text[..at].trim_end();
        let before = before.strip_suffix(')')?;
        let name = before.trim_end_matches(|c: char| c.is_ascii_digit());
        let has_count = name.len() < before.len();
        let name = name.strip_suffix('(')?;
        let start = name
            .rfind(|c: char| !(c.is_alphanumeric() || c == '_'))
            .map_or(0, |at| {
                at + name[at..].chars().next().map_or(1, char::len_utf8)
            });
        (has_count && start < name.len()).then_some(start..at)
    })
}

/// One of the characters that boxes are drawn with.
fn drawn(text: &str) -> Option<std::ops::Range<usize>> {
    let is_drawn = |c: char| ('\u{2500}'..='\u{257f}').contains(&c);
    let at = text.find(is_drawn)?;
    let length = text[at..].chars().next()?.len_utf8();
    Some(at..at + length)
}

/// The rotation part of sixteen numbers whose last row and last column are 0, 0, 0, 1.
pub(crate) fn homogeneous(text: &str) -> Option<Matrix3<f64>> {
    let separators = |c: char| c.is_whitespace() || ",;[](){}".contains(c);
    let parts = text.split(separators).filter(|part| !part.is_empty());
    let numbers: Vec<f64> = parts.map(|part| part.parse().ok()).collect::<Option<_>>()?;
    let entry = |row: usize, column: usize| numbers[4 * row + column];
    let is_affine = numbers.len() == 16
        && entry(3, 3) == 1.0
        && (0..3).all(|at| entry(at, 3) == 0.0 && entry(3, at) == 0.0);
    is_affine.then(|| Matrix3::from_fn(entry))
}
