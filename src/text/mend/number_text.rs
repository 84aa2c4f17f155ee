//! Numbers as the shortest text that reads back as the same doubles.

use crate::decimal::shortest;

/// Three rows, each on a line of its own; no number of a report is −0.
pub(crate) fn rows_text(rows: &[[f64; 3]; 3]) -> String {
    let mut text = String::new();
    for row in rows {
        if !text.is_empty() {
            text.push('\n');
        }
        text.push_str(&exact_list(row));
    }
    text
}

/// Numbers with a space between.
pub(crate) fn exact_list(numbers: &[f64]) -> String {
    let mut text = String::new();
    for number in numbers {
        if !text.is_empty() {
            text.push(' ');
        }
        text.push_str(&exact(*number));
    }
    text
}

pub(crate) fn exact(number: f64) -> String {
    let text = shortest(number);
    match text.strip_suffix(".0") {
        Some(whole) => whole.to_owned(),
        None => text,
    }
}
