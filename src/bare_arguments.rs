//! Numbers without a unit inside sin, cos and tan: radians, as everywhere, though more than a full turn
//! may have been meant as degrees.

use crate::angle::AngleUnit;
use crate::angles::FULL_TURN_RAD;
use crate::lex::{self, Bracket, Token, TokenKind};
use crate::linear::{Linear, Quantity};
use crate::problem::Span;
use crate::report::AngleUnitAssumed;
use crate::spoken;
use crate::syntax;
use crate::tree::Entry;

/// That radians were assumed, where one of these numbers is more than a full turn; with the texts that
/// say a unit, where `is_read` tells that they are read.
pub(crate) fn unit_assumed(text: &str, is_read: &dyn Fn(&str) -> bool) -> Option<AngleUnitAssumed> {
    if !["sin", "cos", "tan"].iter().any(|name| text.contains(name)) {
        return None;
    }
    let tokens = lex::tokens(text).ok()?;
    let bare: Vec<Argument> = (0..tokens.len())
        .filter_map(|at| bare_argument(&tokens[at..]))
        .collect();
    if bare.iter().all(|argument| argument.size <= FULL_TURN_RAD) {
        return None;
    }
    let written = |word: &str| with_unit(text, &bare, word).filter(|text| is_read(text));
    Some(AngleUnitAssumed {
        unit: AngleUnit::Radians,
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
    let inside = spoken::inside(&rest[..closed(rest)?])?;
    let [
        Entry {
            key: None, node, ..
        },
    ] = &syntax::arguments(inside).ok()?[..]
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

/// How many tokens there are up to the bracket that closes the first.
fn closed(tokens: &[Token<'_>]) -> Option<usize> {
    let mut depth = 0_usize;
    let end = tokens.iter().position(|token| {
        match token.kind {
            TokenKind::Open(_) => depth += 1,
            TokenKind::Close(_) => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0
    });
    end.map(|end| end + 1)
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
