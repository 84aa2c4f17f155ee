//! The ways in which the text of a problem is rewritten, each as a list of texts to try.

use crate::character::{begins_number, is_alphanumeric, is_digit, is_space_of_numbers};
use crate::character::{decorates, plain_character};
use crate::problem::ProblemCode;
use crate::problem::fault::Fault;
use crate::problem::suggestion::Remedy;
use crate::text::grammar::arithmetic::Linear;

/// The texts to try, of a text and its problem.
pub(crate) type Rewrite = fn(&Fault, &str) -> Vec<String>;

pub(crate) const fn rewrites(code: ProblemCode) -> &'static [(Remedy, Rewrite)] {
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
            (Remedy::SeparateNumbers, separated_numbers),
            (Remedy::AddSign, added_sign),
        ],
        ProblemCode::UnexpectedEnd => &[(Remedy::RemoveMark, without_last_mark)],
        ProblemCode::WrongCount => &[(Remedy::DecimalPoints, decimal_points)],
        ProblemCode::MissingComponent => &[(Remedy::AddZeros, added_zeros)],
        ProblemCode::MixedNames => &[(Remedy::NameNumber, named_number)],
        ProblemCode::MixedUnits => &[(Remedy::SameUnit, same_unit)],
        ProblemCode::TooSmall => &[(Remedy::WriteZero, zero_at_place)],
        ProblemCode::ZeroQuaternion => &[(Remedy::WriteIdentity, identity)],
        // What is meant can only be guessed, or the matrix itself tells it (`analyze/matrix.rs`).
        _ => &[],
    }
}

/// The text with something else at the place of the problem; nothing where the place is none of it.
fn at_place(fault: &Fault, text: &str, replacement: &str) -> Vec<String> {
    let place = fault.span.start..fault.span.end;
    match (text.get(..place.start), text.get(place.end..)) {
        (Some(before), Some(after)) => vec![[before, replacement, after].concat()],
        _ => Vec::new(),
    }
}

const PAIRS: [(char, char); 4] = [('(', ')'), ('[', ']'), ('{', '}'), ('<', '>')];

/// A bracket around a list may be closed at its end, or taken away. What it encloses of a product or
/// of the argument of a function, only its writer knows.
fn matched_brackets(fault: &Fault, text: &str) -> Vec<String> {
    let (Some(before), Some(from)) = (text.get(..fault.span.start), text.get(fault.span.start..))
    else {
        return Vec::new();
    };
    if fault.code == ProblemCode::UnclosedBracket {
        let open = from.chars().next();
        let pair = PAIRS.iter().find(|(opening, _)| Some(*opening) == open);
        let encloses_list = from.contains(',') || !from.contains(is_factor);
        return match pair {
            Some((_, closing)) if !binds(before) && encloses_list => {
                vec![format!("{}{closing}", text.trim_end())]
            }
            _ => Vec::new(),
        };
    }
    let mut open = Vec::new();
    for character in before.chars() {
        if let Some(pair) = PAIRS.iter().find(|pair| pair.0 == character) {
            open.push(pair.1);
        } else if open.last() == Some(&character) {
            open.pop();
        }
    }
    if let Some(closing) = open.last() {
        return at_place(fault, text, &closing.to_string());
    }
    let after = text.get(fault.span.end..).unwrap_or_default();
    let is_list = before.contains(',') || !before.contains(['i', 'j', 'k']);
    let is_plain =
        is_list || !(before.trim_start().starts_with(is_sign) || before.contains(['*', '·', '×']));
    if is_plain && !after.trim_start().starts_with(is_factor) {
        return at_place(fault, text, "");
    }
    Vec::new()
}

/// Whether a text ends in what takes the next bracket for its operand: a sign, a factor, a function.
fn binds(before: &str) -> bool {
    let before = before.trim_end();
    let rest = before.trim_end_matches(|c: char| is_alphanumeric(c) || "_.:".contains(c));
    let name = &before[rest.len()..];
    before.ends_with(is_sign) || before.ends_with(is_factor) || Linear::is_function(name)
}

fn is_sign(character: char) -> bool {
    matches!(character, '+' | '-' | '−' | '–')
}

fn is_factor(character: char) -> bool {
    matches!(
        character,
        '*' | '·' | '×' | '⋅' | '∗' | '/' | '÷' | '∕' | '⁄' | '√'
    )
}

/// Spaces that may group the digits of a number are not rewritten where they can be meant so.
fn plain_characters(_: &Fault, text: &str) -> Vec<String> {
    if groups_digits(text, is_space_of_numbers).contains(&true) {
        return Vec::new();
    }
    vec![text.chars().map(plain_character).collect()]
}

/// For each such character between two digits whether it can part thousands: it stands before just
/// three digits, and behind one to three that do not begin with a zero, unless a point does.
fn groups_digits(text: &str, is_mark: fn(char) -> bool) -> Vec<bool> {
    let mut groups = Vec::new();
    for (at, mark) in text.char_indices() {
        if !is_mark(mark) {
            continue;
        }
        let (before, after) = (&text[..at], &text[at + mark.len_utf8()..]);
        let rest = before.trim_end_matches(is_digit);
        let group = &before[rest.len()..];
        let follow = after.bytes().take_while(u8::is_ascii_digit).count();
        let is_group = rest.ends_with('.') || !group.starts_with('0');
        let parts = is_group && group.len() <= 3 && follow == 3;
        if !group.is_empty() && follow > 0 {
            groups.push(parts);
        }
    }
    groups
}

/// Only a mark that decorates: what may be an operator, a dash or a number that is left out tells
/// something. Not where it touches a word or a number either: it may change it, as in `0.9$`.
fn without_mark(fault: &Fault, text: &str) -> Vec<String> {
    let stands_apart = |neighbour: Option<char>| {
        neighbour
            .is_none_or(|character| character.is_whitespace() || ",;()[]{}".contains(character))
    };
    let (Some(before), Some(mark), Some(after)) = (
        text.get(..fault.span.start),
        text.get(fault.span.start..fault.span.end),
        text.get(fault.span.end..),
    ) else {
        return Vec::new();
    };
    let is_alone = stands_apart(before.chars().next_back()) && stands_apart(after.chars().next());
    if is_alone && mark.chars().all(decorates) {
        vec![[before, after].concat().trim().to_owned()]
    } else {
        Vec::new()
    }
}

/// A minus behind the last number may be its own: `0.5-` is −0.5 in some programs.
fn without_last_mark(_: &Fault, text: &str) -> Vec<String> {
    let bare = text
        .trim_end()
        .trim_end_matches(|c: char| "+-−–*/·×÷√".contains(c) || c.is_whitespace());
    let removed = &text[bare.len()..];
    // `q*` is the conjugate.
    if removed.starts_with(is_sign) || removed.starts_with('*') || removed.contains(['-', '−', '–'])
    {
        return Vec::new();
    }
    vec![bare.to_owned()]
}

/// A comma between two digits, without a space, becomes a point; not where it can part thousands.
fn decimal_points(_: &Fault, text: &str) -> Vec<String> {
    // One that cannot part thousands tells what all of them are.
    let groups = groups_digits(text, |character| character == ',');
    if groups.iter().all(|&is_group| is_group) {
        return Vec::new();
    }
    let is_digit = |at: usize| text.as_bytes().get(at).is_some_and(u8::is_ascii_digit);
    let mut points = String::new();
    for (at, character) in text.char_indices() {
        let is_inside = character == ',' && at > 0 && is_digit(at - 1) && is_digit(at + 1);
        points.push(if is_inside { '.' } else { character });
    }
    vec![points]
}

/// A sign before the first number may be the dash of a list, which is no sign.
fn attached_sign(fault: &Fault, text: &str) -> Vec<String> {
    let before = text.get(..fault.span.start).map(str::trim_end);
    let sign = text.get(fault.span.start..fault.span.end);
    let after = text.get(fault.span.end..);
    match (before, sign, after) {
        (Some(before), Some(sign @ ("-" | "−" | "–" | "+")), Some(after))
            if before.len() < fault.span.start
                && before.ends_with(|c: char| is_alphanumeric(c) || c == '.') =>
        {
            vec![format!("{before} {sign}{}", after.trim_start())]
        }
        _ => Vec::new(),
    }
}

/// A space before the sign between two numbers.
fn separated_numbers(fault: &Fault, text: &str) -> Vec<String> {
    let Some(written) = text.get(fault.span.start..fault.span.end) else {
        return Vec::new();
    };
    let is_between =
        |(at, sign): &(usize, char)| is_sign(*sign) && written[..*at].ends_with(begins_number);
    let separated = written
        .char_indices()
        .find(is_between)
        .map(|(at, _)| format!("{} {}", &written[..at], &written[at..]));
    separated
        .map(|separated| at_place(fault, text, &separated))
        .unwrap_or_default()
}

/// Only before a term with a unit: a number in brackets may be anything.
fn added_sign(fault: &Fault, text: &str) -> Vec<String> {
    let term = text.get(fault.span.start..fault.span.end);
    if !term.is_some_and(|term| term.contains(['i', 'j', 'k']) && !term.contains('(')) {
        return Vec::new();
    }
    let (before, after) = match (text.get(..fault.span.start), text.get(fault.span.start..)) {
        (Some(before), Some(after)) => (before.trim_end().trim_end_matches(',').trim_end(), after),
        _ => return Vec::new(),
    };
    // After the dash of a list it would be a second sign.
    if before.is_empty() || before.ends_with(is_sign) {
        return Vec::new();
    }
    if after.starts_with(['+', '-', '−']) {
        return vec![format!("{before} {after}")];
    }
    vec![format!("{before} + {after}")]
}

/// Only what is missing can be added: a name that stands there would stand there twice. The scalar is
/// none of them, since 0 is half a turn.
fn added_zeros(_: &Fault, text: &str) -> Vec<String> {
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
    let mut texts = Vec::new();
    for names in MISSING {
        let mut text = inside.to_owned();
        for name in names {
            for part in [separator, quote, name, quote, mark, "0"] {
                text.push_str(part);
            }
        }
        text.push_str(brackets);
        texts.push(text);
    }
    texts
}

fn named_number(fault: &Fault, text: &str) -> Vec<String> {
    let Some(number) = text.get(fault.span.start..fault.span.end) else {
        return Vec::new();
    };
    let mark = if text.contains('=') { "=" } else { ": " };
    let mut texts = Vec::new();
    for name in ["w", "x", "y", "z"] {
        texts.extend(at_place(fault, text, &[name, mark, number].concat()));
    }
    texts
}

fn same_unit(fault: &Fault, text: &str) -> Vec<String> {
    let Some(angle) = text.get(fault.span.start..fault.span.end) else {
        return Vec::new();
    };
    let mut texts = Vec::new();
    for unit in ["deg", "rad"] {
        texts.extend(at_place(fault, text, &[angle, unit].concat()));
    }
    texts
}

fn zero_at_place(fault: &Fault, text: &str) -> Vec<String> {
    at_place(fault, text, "0")
}

fn identity(_: &Fault, _: &str) -> Vec<String> {
    vec!["w=1 x=0 y=0 z=0".to_owned()]
}
