//! Numbers as the shortest text that reads back as the same doubles.

use crate::decimal::shortest;

/// Three rows, each on a line of its own; no number of a report is −0.
pub(crate) fn rows_text(rows: &[[f64; 3]; 3]) -> String {
    rows.map(|row| row.map(exact).join(" ")).join("\n")
}

pub(crate) fn exact(number: f64) -> String {
    let text = shortest(number);
    match text.strip_suffix(".0") {
        Some(whole) => whole.to_owned(),
        None => text,
    }
}
