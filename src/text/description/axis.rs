//! The axis of a turn, in letters, in numbers or by a library's name for it, and its angle.

use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::description::angle::{self, Angle};
use crate::text::description::list::members;
use crate::text::description::vector as three_numbers;
use crate::text::grammar;
use crate::text::grammar::lex::{Token, TokenKind, last_segment};
use crate::text::grammar::tree::{Entry, Lead, Node, NodeKind};
use nalgebra::Vector3;

/// Where pieces of a text stand: from the first token to the last, or else right after `before`.
pub(crate) fn span_of(tokens: &[Token<'_>], before: Span) -> Span {
    match tokens {
        [first, .., last] => first.span.to(last.span),
        [only] => only.span,
        [] => Span::from(before.end..before.end),
    }
}

/// The tokens without the commas around them.
pub(crate) fn trimmed<'s, 't>(mut tokens: &'s [Token<'t>]) -> &'s [Token<'t>] {
    while let [first, rest @ ..] = tokens
        && first.kind == TokenKind::Comma
    {
        tokens = rest;
    }
    while let [rest @ .., last] = tokens
        && last.kind == TokenKind::Comma
    {
        tokens = rest;
    }
    tokens
}

/// The axis that all these tokens are; `before` stands before them.
pub(crate) fn axis(tokens: &[Token<'_>], before: Span) -> Result<Vector3<f64>, Fault> {
    let tokens = without_fillers(trimmed(tokens));
    if let Some((axis, [])) = letter_ahead(tokens) {
        return Ok(axis);
    }
    let span = span_of(tokens, before);
    match tokens {
        [] => Err(Fault::no_axis(span)),
        [word] if word.kind == TokenKind::Word => match unit_axis(word.text) {
            Some(axis) => Ok(axis),
            None => vector(&grammar::entries(tokens)?, span).map_err(|fault| match word.text {
                "i" | "j" | "k" => fault,
                other => Fault::unknown_axis(span, other),
            }),
        },
        _ => vector(&grammar::entries(tokens)?, span),
    }
}

/// `the z axis`, `z-axis`
fn without_fillers<'s, 't>(mut tokens: &'s [Token<'t>]) -> &'s [Token<'t>] {
    let is = |token: &Token<'_>, word| token.kind == TokenKind::Word && token.text == word;
    while let [first, rest @ ..] = tokens
        && (is(first, "the") || is(first, "axis"))
    {
        tokens = rest;
    }
    if let [rest @ .., last] = tokens
        && is(last, "axis")
    {
        tokens = rest;
        if let [rest @ .., dash] = tokens
            && dash.kind == TokenKind::Minus
        {
            tokens = rest;
        }
    }
    tokens
}

/// `z` or `-z`, and the tokens after it.
pub(crate) fn letter_ahead<'s, 't>(
    tokens: &'s [Token<'t>],
) -> Option<(Vector3<f64>, &'s [Token<'t>])> {
    let (sign, rest) = match tokens {
        [sign, rest @ ..] if sign.kind == TokenKind::Minus => (-1.0, rest),
        [sign, rest @ ..] if sign.kind == TokenKind::Plus => (1.0, rest),
        _ => (1.0, tokens),
    };
    let (letter, rest) = rest.split_first()?;
    let is_name = matches!(letter.kind, TokenKind::Word | TokenKind::Quoted);
    let axis = is_name.then(|| letter_axis(letter.text)).flatten()?;
    // No −0 in the other two.
    Some((axis.map(|part| part * sign + 0.0), rest))
}

pub(crate) fn letter_axis(letter: &str) -> Option<Vector3<f64>> {
    match letter {
        "x" | "X" => Some(Vector3::x()),
        "y" | "Y" => Some(Vector3::y()),
        "z" | "Z" => Some(Vector3::z()),
        _ => None,
    }
}

/// What libraries call a coordinate axis: `Eigen::Vector3d::UnitZ`, `Vector3::z_axis`, `Vec3::Z`.
fn unit_axis(path: &str) -> Option<Vector3<f64>> {
    let last = last_segment(path);
    if let Some(letter) = last
        .strip_prefix("Unit")
        .or_else(|| last.strip_suffix("_axis"))
    {
        return letter_axis(letter);
    }
    let of_a_vector = path.to_ascii_lowercase().contains("vec");
    letter_axis(last).filter(|_| of_a_vector)
}

/// The axis that a member of a call or a list is.
pub(crate) fn axis_of_node(node: &Node<'_>) -> Result<Vector3<f64>, Fault> {
    if let NodeKind::Word(word) = node.kind
        && let Some(axis) = letter_axis(word)
    {
        return Ok(axis);
    }
    vector(&[alone(node)], node.span)
}

/// The axis whose three numbers stand among others.
pub(crate) fn axis_of_entries(entries: &[Entry<'_>]) -> Result<Vector3<f64>, Fault> {
    let spans = entries.iter().map(|entry| entry.node.span);
    vector(entries, spans.reduce(Span::to).unwrap_or_default())
}

fn vector(entries: &[Entry<'_>], span: Span) -> Result<Vector3<f64>, Fault> {
    if let [only] = entries
        && only.key.is_none()
        && let NodeKind::Word(name) | NodeKind::Call { name, .. } = only.node.kind
        && let Some(axis) = unit_axis(name)
    {
        return Ok(axis);
    }
    let axis = three_numbers::vector(entries, span)?;
    if axis.iter().all(|number| *number == 0.0) {
        return Err(Fault::zero_axis(span));
    }
    Ok(axis)
}

/// A node as the only member of a list.
pub(crate) fn alone<'t>(node: &Node<'t>) -> Entry<'t> {
    Entry {
        key: None,
        node: node.clone(),
        lead: Lead::First,
        doubtful_sign: None,
    }
}

/// `45,5`: one comma and no space.
fn is_decimal_comma(whole: &Entry<'_>, part: &Entry<'_>) -> bool {
    part.lead == Lead::AfterComma && part.node.span.start == whole.node.span.end + 1
}

/// The one angle that all these tokens are.
pub(crate) fn angle(tokens: &[Token<'_>], before: Span) -> Result<Angle, Fault> {
    let (tokens, unit) = angle::without_unit(trimmed(tokens));
    let span = span_of(tokens, before);
    match &members(&grammar::entries(tokens)?)?[..] {
        [] => Err(Fault::no_angle(span)),
        [only] if only.key.is_none() => {
            let value = only.node.angle()?;
            let value = unit.map_or(Ok(value), |unit| value.angle(unit, span))?;
            Ok((value, only.node.span))
        }
        [whole, part] if is_decimal_comma(whole, part) => Err(Fault::decimal_comma(span)),
        _ => Err(Fault::one_angle(span)),
    }
}
