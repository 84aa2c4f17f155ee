//! What consoles write around numbers.

use nalgebra::Matrix3;
use std::borrow::Cow;
use std::ops::Range;

/// The text with what consoles write around lists of numbers blanked, every byte at its place.
///
/// `Float32Array(4) [ … ]`, `Mat3(9) [ … ]`, and the corners and lines that are drawn around a matrix.
pub(crate) fn without_wrappers(text: &str) -> Cow<'_, str> {
    let drawn = text.match_indices(|c| ('\u{2500}'..='\u{257f}').contains(&c));
    let drawn = drawn.map(|(at, character)| at..at + character.len());
    let lists = text
        .match_indices('[')
        .filter_map(|(at, _)| typed_list(text, at));
    let wrappers: Vec<Range<usize>> = drawn.chain(lists).collect();
    if wrappers.is_empty() {
        return Cow::Borrowed(text);
    }
    let mut bare = text.to_owned();
    for wrapper in wrappers {
        let blank = " ".repeat(wrapper.len());
        bare.replace_range(wrapper, &blank);
    }
    Cow::Owned(bare)
}

/// `Name(9)` before the bracket at a place.
fn typed_list(text: &str, bracket: usize) -> Option<Range<usize>> {
    let before = text[..bracket].trim_end().strip_suffix(')')?;
    let call = before.trim_end_matches(|c: char| c.is_ascii_digit());
    let has_count = call.len() < before.len();
    let name = call.strip_suffix('(')?;
    let rest = name.trim_end_matches(|c: char| c.is_alphanumeric() || c == '_');
    (has_count && rest.len() < name.len()).then_some(rest.len()..bracket)
}

/// The rotation part of sixteen numbers whose last row and last column are 0, 0, 0, 1.
pub(crate) fn homogeneous(text: &str) -> Option<Matrix3<f64>> {
    let text = without_wrappers(text);
    let separators = |c: char| c.is_whitespace() || ",;[](){}".contains(c);
    let parts = text.split(separators).filter(|part| !part.is_empty());
    let numbers: Vec<f64> = parts.map(|part| part.parse().ok()).collect::<Option<_>>()?;
    let entry = |row: usize, column: usize| numbers[4 * row + column];
    let is_affine = numbers.len() == 16
        && entry(3, 3) == 1.0
        && (0..3).all(|at| entry(at, 3) == 0.0 && entry(3, at) == 0.0);
    is_affine.then(|| Matrix3::from_fn(entry))
}
