//! A text that cannot be read, rewritten so that it can be.
//!
//! Only where one way to rewrite it is certain, or does no more than its name says. Each rewritten
//! text is read before it is offered, so taking it never leads to another problem.

use crate::problem::{Problem, ProblemCode};
use serde::{Deserialize, Serialize};

/// A whole text to write in place of one that has a problem.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Suggestion {
    /// What was done to the text.
    pub remedy: Remedy,
    /// The text, which is read without a problem.
    pub text: String,
}

/// What a [`Suggestion`] does to a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Remedy {
    /// Brackets are closed, replaced by their match, or removed where they close nothing.
    MatchBrackets,
    /// Decimal commas become points.
    DecimalPoints,
    /// Full-width digits and marks become those of ASCII.
    PlainCharacters,
    /// A mark that has no meaning here, or joins nothing, is removed.
    RemoveMark,
    /// The space between a sign and its number is removed.
    AttachSign,
    /// A plus is put before a term of a sum.
    AddSign,
    /// Components or angles that are missing are written as 0.
    AddZeros,
    /// The number without a name gets the one name that is left.
    NameNumber,
    /// Every angle gets the unit that one of them has.
    SameUnit,
    /// A number that is smaller than any double becomes 0.
    WriteZero,
    /// The rotation of no turn stands in place of zeros.
    WriteIdentity,
    /// Only the upper left three by three numbers of a homogeneous matrix are kept.
    RotationPart,
    /// The axis that a reflection flips is turned round.
    RestoreAxis,
    /// The rotation that is nearest to the matrix stands in its place.
    NearestRotation,
}

/// Longer texts get no suggestion: the candidates are read on every keystroke.
const LONGEST_TEXT_BYTES: usize = 4096;

/// How many places are mended one after the other.
const MOST_STEPS: usize = 6;

/// Where there are more texts to try, none leads to another place: their number would multiply.
const MOST_TEXTS_OF_A_STEP: usize = 2;

/// The problem with a suggestion, where there is one; `read` tells how a text is read.
pub(crate) fn with_suggestion(
    problem: Problem,
    text: &str,
    read: &dyn Fn(&str) -> Result<(), Problem>,
) -> Problem {
    if problem.suggestion.is_some() || text.len() > LONGEST_TEXT_BYTES {
        return problem;
    }
    let suggestion = rewrites(problem.code)
        .iter()
        .find_map(|&(remedy, rewrite)| {
            let text = mended(&problem, text, rewrite, read, MOST_STEPS)?;
            Some(Box::new(Suggestion { remedy, text }))
        });
    Problem {
        suggestion,
        ..problem
    }
}

/// The texts to try, of a text and its problem.
type Rewrite = fn(&Problem, &str) -> Vec<String>;

const fn rewrites(code: ProblemCode) -> &'static [(Remedy, Rewrite)] {
    match code {
        ProblemCode::UnclosedBracket | ProblemCode::UnmatchedBracket => {
            &[(Remedy::MatchBrackets, matched_brackets)]
        }
        ProblemCode::UnexpectedCharacter => &[
            (Remedy::PlainCharacters, plain_characters),
            (Remedy::RemoveMark, without_mark),
        ],
        ProblemCode::Unexpected => &[
            (Remedy::DecimalPoints, decimal_points),
            (Remedy::AttachSign, attached_sign),
            (Remedy::AddSign, added_sign),
        ],
        ProblemCode::UnexpectedEnd => &[(Remedy::RemoveMark, without_last_mark)],
        ProblemCode::WrongCount => &[
            (Remedy::DecimalPoints, decimal_points),
            (Remedy::RotationPart, rotation_part),
        ],
        ProblemCode::MissingComponent => &[(Remedy::AddZeros, added_zeros)],
        ProblemCode::MixedNames => &[(Remedy::NameNumber, named_number)],
        ProblemCode::MixedUnits => &[(Remedy::SameUnit, same_unit)],
        ProblemCode::TooSmall => &[(Remedy::WriteZero, zero_at_place)],
        ProblemCode::ZeroQuaternion => &[(Remedy::WriteIdentity, identity)],
        // What is meant can only be guessed, or the matrix itself tells it (`matrix_reading.rs`).
        _ => &[],
    }
}

/// The first text that is read, mending the same kind of problem place by place.
fn mended(
    problem: &Problem,
    text: &str,
    rewrite: Rewrite,
    read: &dyn Fn(&str) -> Result<(), Problem>,
    steps: usize,
) -> Option<String> {
    let is_mended_so = |next: &Problem| {
        let mut same = rewrites(next.code).iter().map(|&(remedy, _)| remedy);
        rewrites(problem.code)
            .iter()
            .any(|&(remedy, _)| same.any(|other| other == remedy))
    };
    let candidates = rewrite(problem, text);
    let goes_on = steps > 1 && candidates.len() <= MOST_TEXTS_OF_A_STEP;
    candidates
        .into_iter()
        .find_map(|candidate| match read(&candidate) {
            Ok(()) => Some(candidate),
            Err(next) if goes_on && is_mended_so(&next) => {
                mended(&next, &candidate, rewrite, read, steps - 1)
            }
            Err(_) => None,
        })
}

/// The text with something else at the place of the problem; nothing where the place is none of it.
fn at_place(problem: &Problem, text: &str, replacement: &str) -> Vec<String> {
    let place = problem.span.start..problem.span.end;
    match (text.get(..place.start), text.get(place.end..)) {
        (Some(before), Some(after)) => vec![[before, replacement, after].concat()],
        _ => Vec::new(),
    }
}

fn matched_brackets(problem: &Problem, text: &str) -> Vec<String> {
    const PAIRS: [(char, char); 4] = [('(', ')'), ('[', ']'), ('{', '}'), ('<', '>')];
    let Some(before) = text.get(..problem.span.start) else {
        return Vec::new();
    };
    if problem.code == ProblemCode::UnclosedBracket {
        let open = text[before.len()..].chars().next();
        let pair = PAIRS.iter().find(|(opening, _)| Some(*opening) == open);
        return pair
            .map(|(_, closing)| format!("{}{closing}", text.trim_end()))
            .into_iter()
            .collect();
    }
    let mut open = Vec::new();
    for character in before.chars() {
        if let Some(pair) = PAIRS.iter().find(|pair| pair.0 == character) {
            open.push(pair.1);
        } else if open.last() == Some(&character) {
            open.pop();
        }
    }
    let closing = open.last().map_or_else(String::new, char::to_string);
    at_place(problem, text, &closing)
}

/// U+FF01 to U+FF5E are the ASCII characters from `!` on, as wide as an ideograph.
fn plain_characters(_: &Problem, text: &str) -> Vec<String> {
    let plain = |character: char| match character {
        '\u{ff01}'..='\u{ff5e}' => {
            char::from_u32(u32::from(character) - 0xfee0).unwrap_or(character)
        }
        '、' => ',',
        '。' => '.',
        '“' | '”' => '"',
        '‘' | '’' => '\'',
        _ => character,
    };
    vec![text.chars().map(plain).collect()]
}

/// Not where the mark touches a word or a number: it may change it, as in `0.9²`.
fn without_mark(problem: &Problem, text: &str) -> Vec<String> {
    let stands_apart = |neighbour: Option<char>| {
        neighbour
            .is_none_or(|character| character.is_whitespace() || ",;()[]{}".contains(character))
    };
    let before = text
        .get(..problem.span.start)
        .and_then(|before| before.chars().next_back());
    let after = text
        .get(problem.span.end..)
        .and_then(|after| after.chars().next());
    if stands_apart(before) && stands_apart(after) {
        let without = at_place(problem, text, "").into_iter();
        without.map(|text| text.trim().to_owned()).collect()
    } else {
        Vec::new()
    }
}

fn without_last_mark(_: &Problem, text: &str) -> Vec<String> {
    let bare = text
        .trim_end()
        .trim_end_matches(|c: char| "+-−–*/·×÷√".contains(c) || c.is_whitespace());
    vec![bare.to_owned()]
}

/// A comma between two digits, without a space, becomes a point.
fn decimal_points(_: &Problem, text: &str) -> Vec<String> {
    let is_digit = |at: usize| text.as_bytes().get(at).is_some_and(u8::is_ascii_digit);
    let points = text.char_indices().map(|(at, character)| {
        let is_inside = character == ',' && at > 0 && is_digit(at - 1) && is_digit(at + 1);
        if is_inside { '.' } else { character }
    });
    let rewritten: String = points.collect();
    if rewritten == text {
        return Vec::new();
    }
    vec![rewritten]
}

/// A sign before the first number may be the dash of a list, which is no sign.
fn attached_sign(problem: &Problem, text: &str) -> Vec<String> {
    let before = text.get(..problem.span.start).map(str::trim_end);
    let sign = text.get(problem.span.start..problem.span.end);
    let after = text.get(problem.span.end..);
    match (before, sign, after) {
        (Some(before), Some(sign @ ("-" | "−" | "–" | "+")), Some(after))
            if before.ends_with(|c: char| c.is_alphanumeric() || c == '.') =>
        {
            vec![format!("{before} {sign}{}", after.trim_start())]
        }
        _ => Vec::new(),
    }
}

/// Only before a term with a unit: a number in brackets may be anything.
fn added_sign(problem: &Problem, text: &str) -> Vec<String> {
    let term = text.get(problem.span.start..problem.span.end);
    if !term.is_some_and(|term| term.contains(['i', 'j', 'k']) && !term.contains('(')) {
        return Vec::new();
    }
    let (before, after) = match (
        text.get(..problem.span.start),
        text.get(problem.span.start..),
    ) {
        (Some(before), Some(after)) => (before.trim_end().trim_end_matches(',').trim_end(), after),
        _ => return Vec::new(),
    };
    if before.is_empty() {
        return Vec::new();
    }
    if after.starts_with(['+', '-', '−']) {
        return vec![format!("{before} {after}")];
    }
    vec![format!("{before} + {after}")]
}

/// The numbers of a text of twelve or sixteen: the three by three on the left of the first three rows,
/// as they are written.
fn rotation_part(_: &Problem, text: &str) -> Vec<String> {
    let separators = |c: char| c.is_whitespace() || ",;[](){}".contains(c);
    let parts: Vec<_> = text
        .split(separators)
        .filter(|part| !part.is_empty())
        .collect();
    let is_zero = |part: &str| part.contains('0') && part.trim_matches(['0', '.', '-']).is_empty();
    let is_one = |part: &str| part.trim_end_matches('0').trim_end_matches('.') == "1";
    let is_homogeneous = match parts.as_slice() {
        [.., a, b, c, d] if parts.len() == 16 => {
            [a, b, c].iter().all(|part| is_zero(part)) && is_one(d)
        }
        _ => parts.len() == 12,
    };
    if !is_homogeneous {
        return Vec::new();
    }
    let rows = [0, 4, 8].map(|at| parts[at..at + 3].join(" "));
    vec![rows.join("\n")]
}

/// Only what is missing can be added: a name that stands there would stand there twice. The scalar is
/// none of them, since 0 is half a turn.
fn added_zeros(_: &Problem, text: &str) -> Vec<String> {
    const MISSING: [&[&str]; 13] = [
        &["x"],
        &["y"],
        &["z"],
        &["x", "y"],
        &["x", "z"],
        &["y", "z"],
        &["x", "y", "z"],
        &["roll"],
        &["pitch"],
        &["yaw"],
        &["roll", "pitch"],
        &["roll", "yaw"],
        &["pitch", "yaw"],
    ];
    let text = text.trim_end();
    let inside = text.trim_end_matches([')', ']', '}', '>']).trim_end();
    let brackets = &text[inside.len()..];
    let (mark, separator) = match (inside.contains('='), inside.contains('\n')) {
        (true, false) if !inside.contains(',') => ("=", " "),
        (true, _) => ("=", ", "),
        (false, true) => (": ", "\n"),
        (false, false) => (": ", ", "),
    };
    let quote = if inside.contains('"') { "\"" } else { "" };
    MISSING
        .iter()
        .map(|names| {
            let zeros: String = names
                .iter()
                .map(|name| format!("{separator}{quote}{name}{quote}{mark}0"))
                .collect();
            format!("{inside}{zeros}{brackets}")
        })
        .collect()
}

fn named_number(problem: &Problem, text: &str) -> Vec<String> {
    let Some(number) = text.get(problem.span.start..problem.span.end) else {
        return Vec::new();
    };
    let mark = if text.contains('=') { "=" } else { ": " };
    ["w", "x", "y", "z"]
        .into_iter()
        .flat_map(|name| at_place(problem, text, &format!("{name}{mark}{number}")))
        .collect()
}

fn same_unit(problem: &Problem, text: &str) -> Vec<String> {
    let Some(angle) = text.get(problem.span.start..problem.span.end) else {
        return Vec::new();
    };
    ["deg", "rad"]
        .into_iter()
        .flat_map(|unit| at_place(problem, text, &format!("{angle}{unit}")))
        .collect()
}

fn zero_at_place(problem: &Problem, text: &str) -> Vec<String> {
    at_place(problem, text, "0")
}

fn identity(_: &Problem, _: &str) -> Vec<String> {
    vec!["w=1 x=0 y=0 z=0".to_owned()]
}

/// Three rows, each on a line of its own, as the shortest numbers that read back as the same doubles.
pub(crate) fn rows_text(rows: &[[f64; 3]; 3]) -> String {
    rows.map(|row| row.map(exact).join(" ")).join("\n")
}

fn exact(number: f64) -> String {
    // Adding 0 makes a zero of a negative one.
    let text = shortest(number + 0.0);
    match text.strip_suffix(".0") {
        Some(whole) => whole.to_owned(),
        None => text,
    }
}

/// The shortest decimal number that reads back as the same double.
#[cfg(not(target_arch = "wasm32"))]
fn shortest(number: f64) -> String {
    format!("{number:?}")
}

// The same from JavaScript, which spares the wasm tables of 15 kB.
#[cfg(target_arch = "wasm32")]
use crate::wasm::shortest;
