//! No suggestion changes a number that was typed.

use crate::checked::{answer, problem};
use crate::property::for_all;
use proptest::prelude::*;
use quatlas::{Field, Outcome, Remedy};

/// The numbers of a text with the signs before them, whatever stands between; a plus is none.
fn numbers(text: &str) -> Vec<(String, String)> {
    let ascii: String = text
        .chars()
        .map(|character| match character {
            // As wide as an ideograph.
            '０'..='９' | '．' => char::from_u32(character as u32 - 0xfee0).expect("ASCII"),
            '－' | '−' | '–' | '—' | '‒' | '─' | '━' => '-',
            other => other,
        })
        .collect();
    let is_part = |c: char| c.is_ascii_digit() || c == '.';
    let mut found = Vec::new();
    let mut before = String::new();
    let mut rest = &ascii[..];
    while let Some(first) = rest.chars().next() {
        let length = if first.is_ascii_digit() {
            rest.find(|c| !is_part(c)).unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        let (piece, after) = rest.split_at(length);
        if first.is_ascii_digit() {
            let rest = before.trim_end_matches(|c: char| "+-.".contains(c) || c.is_whitespace());
            let signs = before[rest.len()..].chars().filter(|c| "+-".contains(*c));
            let signs: String = signs.collect();
            // A plus before all is none.
            found.push((signs.trim_start_matches('+').to_owned(), piece.to_owned()));
            before.clear();
        } else {
            before.push_str(piece);
        }
        rest = after;
    }
    found
}

const PIECES: [&str; 44] = [
    "0",
    "1",
    "0.5",
    "-0.5",
    "0.5",
    "10",
    " ",
    " ",
    " ",
    "-",
    "- ",
    "+",
    " - ",
    " + ",
    "−",
    "–",
    "—",
    "‒",
    "─",
    "│",
    "~",
    "•",
    "|",
    "🙂",
    "(",
    ")",
    "[",
    "]",
    ", ",
    ",",
    ";",
    "\n",
    "\n- ",
    "i",
    "0.5i",
    "0.5j",
    " 0.5k",
    "*",
    "/2",
    "√",
    "\u{a0}",
    "\u{200b}",
    "０．５",
    "rpy ",
];

#[test]
fn no_suggestion_changes_a_number_that_was_typed() {
    let texts = prop::collection::vec(prop::sample::select(&PIECES[..]), 1..16)
        .prop_map(|pieces| pieces.concat());
    let fields = prop::sample::select(vec![Field::Quaternion, Field::Vector]);
    for_all(2500, (texts, fields), |(text, field)| {
        let Outcome::Problems(_) = answer(field, &text) else {
            return Ok(());
        };
        let Some(suggestion) = problem(field, &text).suggestion else {
            return Ok(());
        };
        let (typed, offered) = (numbers(&text), numbers(&suggestion.text));
        match suggestion.remedy {
            Remedy::DecimalPoints
            | Remedy::WriteIdentity
            | Remedy::RestoreAxis
            | Remedy::NearestRotation => {}
            _ => prop_assert_eq!(&typed, &offered, "{:?} -> {:?}", text, suggestion),
        }
        let is_read = matches!(answer(field, &suggestion.text), Outcome::Read(_));
        prop_assert!(is_read, "{:?}", suggestion);
        Ok(())
    });
}
