//! The texts that say the unit which a text leaves out: once for all its angles, or inside sin, cos and
//! tan, where numbers are radians, as everywhere, though more than a full turn may have been meant as
//! degrees.

use crate::convention::angle::{AngleUnit, UnitSource};
use crate::problem::Span;
use crate::text::description::angle::FULL_TURN_RAD;
use crate::text::grammar;
use crate::text::grammar::arithmetic::{Linear, Quantity};
use crate::text::grammar::lex::{Bracket, Token, TokenKind};
use crate::text::grammar::nesting::{closed, inside};
use crate::text::grammar::tree::Entry;
use crate::text::vocabulary::Telling;

/// A text with the word for either unit; absent where there is no plain place for it.
#[derive(Clone, Debug)]
pub(crate) struct UnitTexts {
    pub(crate) in_degrees: Option<String>,
    pub(crate) in_radians: Option<String>,
}

/// With the word once for all, at the end or beside the first number, as in `45 about z`; `unit_of`
/// tells how a text says its unit.
pub(crate) fn for_all(text: &str, unit_of: &dyn Fn(&str) -> Option<UnitSource>) -> UnitTexts {
    let text = text.trim_end();
    let written = |unit: AngleUnit, word: &str| {
        let mut candidates = vec![format!("{text} {word}")];
        candidates.extend(
            text.split_once(char::is_whitespace)
                .map(|(first, rest)| format!("{first} {word} {rest}")),
        );
        if cfg!(feature = "whole") {
            candidates.extend(behind_large_numbers(text, word));
        }
        let says_so = |candidate: &String| unit_of(candidate) == Some(UnitSource::Written(unit));
        candidates.into_iter().find(says_so)
    };
    UnitTexts {
        in_degrees: written(AngleUnit::Degrees, "deg"),
        in_radians: written(AngleUnit::Radians, "rad"),
    }
}

/// With the word behind every number that is more than a full turn, in the call of a library.
fn behind_large_numbers(text: &str, word: &str) -> Option<String> {
    let tokens = Telling::of(text).ok()?.tokens;
    let calls = |pair: &[Token<'_>]| {
        pair[0].kind == TokenKind::Word
            && !Linear::is_function(pair[0].text)
            && pair[1].kind == TokenKind::Open(Bracket::Round)
    };
    if !tokens.windows(2).any(calls) {
        return None;
    }
    let is_large = |token: &&Token<'_>| matches!(token.kind, TokenKind::Number(value) if value > FULL_TURN_RAD);
    let mut written = String::new();
    let mut end = 0;
    for number in tokens.iter().filter(is_large) {
        written.push_str(text.get(end..number.span.end)?);
        written.push(' ');
        written.push_str(word);
        end = number.span.end;
    }
    written.push_str(text.get(end..)?);
    (end > 0).then_some(written)
}

/// With the word inside every function, where a number there is more than a full turn; `is_read` tells
/// whether a text is read.
pub(crate) fn inside_functions(text: &str, is_read: &dyn Fn(&str) -> bool) -> Option<UnitTexts> {
    if !["sin", "cos", "tan"].iter().any(|name| text.contains(name)) {
        return None;
    }
    let tokens = Telling::of(text).ok()?.tokens;
    let mut bare: Vec<Argument> = Vec::new();
    for at in 0..tokens.len() {
        bare.extend(bare_argument(&tokens[at..]));
    }
    if bare.iter().all(|argument| argument.size <= FULL_TURN_RAD) {
        return None;
    }
    let written = |word: &str| with_unit(text, &bare, word).filter(|text| is_read(text));
    Some(UnitTexts {
        in_degrees: written("deg"),
        in_radians: written("rad"),
    })
}

/// A number of a function that has neither a unit nor a π.
struct Argument {
    span: Span,
    size: f64,
    /// Whether it is computed, and so needs brackets before a unit.
    is_computed: bool,
}

/// That of the function whose name comes first.
fn bare_argument(tokens: &[Token<'_>]) -> Option<Argument> {
    let [name, rest @ ..] = tokens else {
        return None;
    };
    let [open, ..] = rest else { return None };
    let is_function = name.kind == TokenKind::Word && Linear::takes_angle(name.text);
    if !is_function || open.kind != TokenKind::Open(Bracket::Round) {
        return None;
    }
    let inside = inside(&rest[..closed(rest)?])?;
    let [
        Entry {
            key: None, node, ..
        },
    ] = &grammar::arguments(inside).ok()?[..]
    else {
        return None;
    };
    let value = node.operand().ok()?;
    let is_bare = value.quantity == Quantity::Number && value.units.is_none();
    let span = inside.first()?.span.to(inside.last()?.span);
    is_bare.then_some(Argument {
        span,
        size: value.scalar.abs(),
        is_computed: inside.iter().any(|token| {
            !matches!(
                token.kind,
                TokenKind::Number(_) | TokenKind::Minus | TokenKind::Plus
            )
        }) || inside.len() > 2,
    })
}

/// The text with the word for a unit behind each of the numbers; `None` where one is inside another.
fn with_unit(text: &str, bare: &[Argument], word: &str) -> Option<String> {
    let mut written = String::new();
    let mut end = 0;
    for argument in bare.iter().filter(|argument| argument.size > 0.0) {
        let Span { start, end: stop } = argument.span;
        written.push_str(text.get(end..start)?);
        let number = text.get(start..stop)?;
        written.push_str(&if argument.is_computed {
            format!("({number}) {word}")
        } else {
            format!("{number} {word}")
        });
        end = stop;
    }
    written.push_str(text.get(end..)?);
    Some(written)
}
