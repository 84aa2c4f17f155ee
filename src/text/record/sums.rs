//! Sums of units among other words: `Q = -0.9 + 0.2*i + 0.1*j + 0.3*k`.

use crate::character::{is_alphanumeric, is_digit};
use crate::convention::order::{ComponentOrder, OrderSource};
use crate::decimal::nearest_double;
use crate::problem::Span;
use crate::text::record::found::Found;
use crate::text::record::parts::{Made, quaternion};

/// The sums of a text that have all three units, each once, and a norm of 1.
pub(crate) fn sums(text: &str) -> Vec<Found> {
    let mut found = Vec::new();
    let mut at = 0;
    while found.len() < MOST
        && let Some(next) = text[at..].find(begins_term)
    {
        let start = at + next;
        // What touches it may be a sign, or make it a part of a name.
        let is_apart = text[..start]
            .chars()
            .next_back()
            .is_none_or(|before| before.is_whitespace() || "([{=:,<|\"'".contains(before));
        let (length, parts) = sum(&text[start..]);
        let rotation = parts.filter(|_| is_apart).and_then(|parts| {
            quaternion(&parts, (ComponentOrder::ScalarFirst, OrderSource::Named))
        });
        found.extend(rotation.map(|rotation| Found {
            made: Made::Rotation(rotation),
            ..Found::at(Span::from(start..start + length))
        }));
        at = start + length.max(1);
        while !text.is_char_boundary(at) {
            at += 1;
        }
    }
    found
}

/// How many sums of a text are looked at.
const MOST: usize = 24;

fn begins_term(first: char) -> bool {
    first.is_ascii_digit() || "+-−.".contains(first)
}

/// How long the sum at the start is, and its scalar and vector where it has every unit once.
fn sum(text: &str) -> (usize, Option<[f64; 4]>) {
    let mut parts: [Option<f64>; 4] = [None; 4];
    let mut length = 0;
    let mut is_clear = true;
    while let Some((term, place, value)) = term(&text[length..], length == 0) {
        is_clear &= parts[place].is_none();
        parts[place] = Some(value);
        length += term;
    }
    let [scalar, i, j, k] = parts;
    let all = i.zip(j).zip(k).filter(|_| is_clear);
    let quaternion = all.map(|((i, j), k)| [scalar.unwrap_or(0.0), i, j, k]);
    (length, quaternion)
}

/// The length of a term, which of w, x, y, z it is, and its value; only the first may have no sign.
fn term(text: &str, is_first: bool) -> Option<(usize, usize, f64)> {
    let after_space = text.trim_start_matches(' ');
    let (negative, unsigned) = match after_space.chars().next()? {
        '+' => (false, &after_space[1..]),
        '-' => (true, &after_space[1..]),
        '−' => (true, &after_space['−'.len_utf8()..]),
        _ if is_first => (false, after_space),
        _ => return None,
    };
    let unsigned = unsigned.trim_start_matches(' ');
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let mut end = digits(unsigned);
    if unsigned[end..].starts_with('.') {
        end += 1 + digits(&unsigned[end + 1..]);
    }
    if !unsigned[..end].contains(is_digit) {
        return None;
    }
    if unsigned[end..].starts_with(['e', 'E']) {
        let signed = usize::from(unsigned[end + 1..].starts_with(['+', '-']));
        let exponent = digits(&unsigned[end + 1 + signed..]);
        if exponent > 0 {
            end += 1 + signed + exponent;
        }
    }
    let magnitude = nearest_double(&unsigned[..end]);
    let rest = &unsigned[end..];
    let behind = rest.trim_start_matches([' ', '*', '·']);
    let unit = behind.chars().next().filter(|unit| {
        let next = behind[unit.len_utf8()..].chars().next();
        !next.is_some_and(|next| is_alphanumeric(next) || next == '_')
    });
    let (place, rest) = match unit {
        Some('i' | '𝐢' | '𝒊' | 'î') => (1, &behind[unit?.len_utf8()..]),
        Some('j' | '𝐣' | '𝒋' | 'ĵ') => (2, &behind[unit?.len_utf8()..]),
        Some('k' | '𝐤' | '𝒌') => (3, &behind[unit?.len_utf8()..]),
        _ => (0, rest),
    };
    let value = if negative { -magnitude } else { magnitude };
    Some((text.len() - rest.len(), place, value))
}
