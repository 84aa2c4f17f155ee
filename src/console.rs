//! What consoles write around numbers.

use crate::blank::is_blank;
use crate::numbers::only_numbers;
use crate::problem::is_too_long;
use nalgebra::Matrix3;
use std::borrow::Cow;
use std::ops::Range;

/// The text with what consoles write before lists of numbers blanked, every byte at its place.
///
/// `Float32Array(4) [ … ]`, `Mat3(9) [ … ]`
pub(crate) fn without_wrappers(text: &str) -> Cow<'_, str> {
    let wrappers: Vec<Range<usize>> = text
        .match_indices('[')
        .filter_map(|(at, _)| typed_list(text, at))
        .collect();
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
    let before = text[..bracket].trim_end_matches(is_blank);
    let before = before.strip_suffix(')')?;
    let call = before.trim_end_matches(|c: char| c.is_ascii_digit());
    let has_count = call.len() < before.len();
    let name = call.strip_suffix('(')?;
    let rest = name.trim_end_matches(|c: char| c.is_alphanumeric() || c == '_');
    (has_count && rest.len() < name.len()).then_some(rest.len()..bracket)
}

/// The rotation part of sixteen numbers whose last row and last column are 0, 0, 0, 1.
pub(crate) fn homogeneous(text: &str) -> Option<Matrix3<f64>> {
    if is_too_long(text) {
        return None;
    }
    let numbers = only_numbers(&without_wrappers(text))?;
    let entry = |row: usize, column: usize| numbers[4 * row + column].value;
    let is_affine = numbers.len() == 16
        && entry(3, 3) == 1.0
        && (0..3).all(|at| entry(at, 3) == 0.0 && entry(3, at) == 0.0);
    is_affine.then(|| Matrix3::from_fn(entry))
}
