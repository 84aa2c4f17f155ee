//! What the beginning of a text is, by its characters alone.

use crate::character::{begins_number, is_alphabetic, is_alphanumeric, is_of_name};
use crate::text::record::names::finite_decimal;
use std::f64::consts::PI;

/// How many bytes a date, an index or a list of types has at most.
const LONGEST: usize = 80;

/// How many bytes at the start are the index of a member that is labelled: `[0] =`.
pub(crate) fn index(text: &str) -> usize {
    let length = element(text);
    let after = text[length..].trim_start_matches(' ');
    if length > 0 && after.starts_with(['=', ':']) && text[1..].find(']') == Some(length - 2) {
        length
    } else {
        0
    }
}

/// How many bytes at the start are places of an element: `[0]`, `[1][2]`.
pub(crate) fn element(text: &str) -> usize {
    let mut length = 0;
    while let Some(inside) = text[length..].strip_prefix('[') {
        let digits = inside.bytes().take_while(u8::is_ascii_digit).count();
        if !(1..=2).contains(&digits) || !inside[digits..].starts_with(']') {
            break;
        }
        length += digits + 2;
    }
    length
}

/// How many bytes at the start are the number of a row or a column as R prints it.
pub(crate) fn row_label(text: &str) -> usize {
    let Some(end) = text.bytes().take(LONGEST).position(|byte| byte == b']') else {
        return 0;
    };
    let inside = &text[1..end];
    let is_count =
        |digits: &str| !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    let is_label = inside.strip_suffix(',').is_some_and(is_count)
        || inside.strip_prefix(',').is_some_and(is_count);
    if is_label { end + 1 } else { 0 }
}

/// Whether the checksum of a sentence follows: `*48`.
pub(crate) fn is_checksum(text: &str) -> bool {
    let digits = text.get(1..3).unwrap_or("");
    let ends = text
        .get(3..)
        .is_none_or(|rest| !rest.starts_with(is_alphanumeric));
    ends && digits.len() == 2 && digits.bytes().all(|digit| digit.is_ascii_hexdigit())
}

/// How many bytes at the start are a name.
pub(crate) fn name(text: &str) -> usize {
    text.len() - text.trim_start_matches(is_of_name).len()
}

/// How many bytes at the start are types in brackets: names alone, and sizes.
pub(crate) fn types(text: &str) -> usize {
    let close = match text.chars().next() {
        Some('<') => b'>',
        Some('{') => b'}',
        _ => return 0,
    };
    let Some(end) = text.bytes().take(LONGEST).position(|byte| byte == close) else {
        return 0;
    };
    let inside = &text[1..end];
    let is_types = inside.starts_with(is_alphabetic)
        && inside
            .chars()
            .all(|mark| is_alphanumeric(mark) || "_:, ".contains(mark))
        && !inside.contains(": ");
    if is_types { end + 1 } else { 0 }
}

/// How many bytes at the start of a line a console wrote: `>>> `, `In [3]: `, `Out[7]= `.
pub(crate) fn prompt(line: &str) -> usize {
    for name in ["In", "Out"] {
        let Some(rest) = line.strip_prefix(name) else {
            continue;
        };
        let rest = rest.trim_start_matches(' ');
        if let Some(inside) = rest.strip_prefix('[')
            && let Some(end) = inside.find(']')
            && inside[..end]
                .trim()
                .bytes()
                .all(|byte| byte.is_ascii_digit())
        {
            let after = inside[end + 1..].trim_start_matches("//MatrixForm");
            let after = after.trim_start_matches([':', '=']);
            return line.len() - after.len();
        }
    }
    line.len()
        - line
            .trim_start_matches(['>', '#', '%', '$', '/', '*', ' ', '\t'])
            .len()
}

/// How many bytes at the start are a date or a time of day.
pub(crate) fn time(text: &str) -> Option<usize> {
    let is_part = |byte: &u8| byte.is_ascii_digit() || b"-:.TZ/".contains(byte);
    let length = text.bytes().take(LONGEST).take_while(is_part).count();
    let written = &text[..length];
    let digits = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let date = written.split(['T', ' ']).next().unwrap_or("");
    let parts: Vec<&str> = date.split(['-', '/']).collect();
    let is_date = parts.len() >= 2
        && parts.iter().all(|part| digits(part) && part.len() <= 4)
        && parts.iter().any(|part| part.len() == 4)
        && (parts.len() == 3 || written.contains('T'));
    // The day of a log without its year: `03-14 09:26:53`.
    let after = text[length..].trim_start_matches(' ');
    let is_day = parts.len() == 2
        && parts.iter().all(|part| digits(part) && part.len() == 2)
        && after.get(2..3) == Some(":");
    let clock: Vec<&str> = written.split(':').collect();
    let is_clock = clock.len() >= 2
        && digits(clock[0])
        && clock[1].get(..2).is_some_and(digits)
        && clock[0].len() <= 2;
    (is_date || is_day || is_clock).then_some(length)
}

/// Units that may touch a number.
const UNITS: [&str; 12] = [
    "deg", "rad", "mm", "m", "cm", "s", "ms", "px", "degrees", "turn", "grad", "gon",
];

/// How many bytes at the start are no number though they begin with a digit: `3x3`, `4×4`, `17a3`, `10.0.0.1`.
pub(crate) fn identifier(text: &str) -> Option<usize> {
    let length = text
        .find(|mark: char| !(is_alphanumeric(mark) || "_.×".contains(mark)))
        .unwrap_or(text.len());
    let written = text[..length].trim_end_matches('.');
    let points = written.matches('.').count();
    let number = written.trim_end_matches(['f', 'F', 'd', 'L']);
    let number = ["_f64", "_f32", "f64", "f32"]
        .into_iter()
        .find_map(|suffix| written.strip_suffix(suffix))
        .unwrap_or(number);
    let unit = number.trim_start_matches(begins_number);
    let is_exponent = unit.strip_prefix(['e', 'E', 'D']).is_some_and(|rest| {
        rest.bytes().all(|byte| byte.is_ascii_digit())
            && (!rest.is_empty() || text[length..].starts_with(['+', '-']))
    });
    let is_unit = |unit: &str| UNITS.contains(&unit);
    let whole = written.trim_start_matches(begins_number);
    let is_known = unit.is_empty() || is_exponent || is_unit(unit) || is_unit(whole);
    (points > 1 || !is_known).then_some(written.len().max(1))
}

/// How long an angle of xacro at the start is, `${-pi/2}` or `${3*pi/4}`, and its value in radians.
pub(crate) fn part_of_pi(text: &str) -> Option<(usize, f64)> {
    let (inside, _) = text.strip_prefix("${")?.split_once('}')?;
    let (before, after) = inside.split_once("pi")?;
    let factor = match before.trim() {
        "" => 1.0,
        "-" => -1.0,
        written => finite_decimal(written.strip_suffix('*')?.trim())?,
    };
    let divisor = match after.trim() {
        "" => 1.0,
        written => finite_decimal(written.strip_prefix('/')?.trim())?,
    };
    Some((inside.len() + "${}".len(), factor * PI / divisor))
}

/// Whether a text ends with the letter of an axis that stands alone.
pub(crate) fn is_axis(text: &str) -> bool {
    let mut letters = text.chars().rev();
    let is_letter = letters.next().is_some_and(|last| "XYZxyz".contains(last));
    is_letter && letters.next().is_none_or(|before| !is_alphanumeric(before))
}
