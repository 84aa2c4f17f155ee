//! An axis and an angle, in the words of a sentence, beside each other, or as announced.

use crate::convention::angle::AngleUnit;
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::description::angle::{self, UnitRule};
use crate::text::description::axis::{
    self, axis_of_entries, axis_of_node, letter_ahead, span_of, trimmed,
};
use crate::text::description::list::{check_no_factor, check_separators, held, members};
use crate::text::description::{self, ParsedRotation};
use crate::text::grammar;
use crate::text::grammar::arithmetic::{Linear, Quantity};
use crate::text::grammar::lex::{Token, TokenKind};
use crate::text::grammar::tree::{Entry, NodeKind};
use crate::text::vocabulary::phrases::Form;

/// `45deg about z`, `about z by 45deg`
pub(crate) fn about(
    before: &[Token<'_>],
    word: Span,
    after: &[Token<'_>],
    unit: Option<AngleUnit>,
) -> Result<ParsedRotation, Fault> {
    let before = without_verbs(before);
    let is_by = |token: &Token<'_>| token.kind == TokenKind::Word && token.text == "by";
    let (angle, at, axis) = match after.iter().position(is_by) {
        Some(by) if before.is_empty() => (&after[by + 1..], after[by].span, &after[..by]),
        _ => (before, Span::from(word.start..word.start), after),
    };
    let angle_alone = trimmed(angle).is_empty();
    if angle_alone {
        return Err(Fault::no_angle(span_of(&[], at)));
    }
    let angle = axis::angle(angle, at)?;
    let axis = axis::axis(axis, word)?;
    description::axis_angle(axis, angle, angle::rule(unit, UnitRule::Magnitude))
}

/// `rotate by 45deg`, `rotation of 45deg`, `a turn by 45deg`
fn without_verbs<'s, 't>(mut tokens: &'s [Token<'t>]) -> &'s [Token<'t>] {
    const VERBS: [&str; 8] = [
        "a", "rotate", "rotated", "rotation", "turn", "turned", "of", "by",
    ];
    while let [first, rest @ ..] = tokens
        && first.kind == TokenKind::Word
        && VERBS.contains(&first.text.to_ascii_lowercase().as_str())
    {
        tokens = rest;
    }
    tokens
}

/// `45deg [0, 0, 1]`, `(z, 45deg)`: a unit tells which of the two is the angle.
pub(crate) fn beside(members: &[Entry<'_>]) -> Result<Option<ParsedRotation>, Fault> {
    let is_angle = |entry: &Entry<'_>| {
        matches!(
            entry.node.kind,
            NodeKind::Value(Linear {
                quantity: Quantity::Angle(_),
                ..
            })
        )
    };
    let is_axis = |entry: &Entry<'_>| !matches!(entry.node.kind, NodeKind::Value(_));
    let (angle, axis) = match members {
        [one, two] if one.key.is_some() || two.key.is_some() => return Ok(None),
        [angle, axis] | [axis, angle] if is_angle(angle) && is_axis(axis) => (angle, axis),
        _ => return Ok(None),
    };
    let angle = (angle.node.angle()?, angle.node.span);
    description::axis_angle(axis_of_node(&axis.node)?, angle, UnitRule::Magnitude).map(Some)
}

/// An axis in letters or three numbers, and an angle, in the order of their announcement; brackets
/// around the axis tell the order themselves.
pub(crate) fn announced(
    tokens: &[Token<'_>],
    span: Span,
    form: Form,
    rule: UnitRule,
) -> Result<ParsedRotation, Fault> {
    if let Some((axis, rest)) = letter_ahead(tokens) {
        let angle = axis::angle(rest, span)?;
        return description::axis_angle(axis, angle, rule);
    }
    let entries = members(&grammar::entries(tokens)?)?;
    if let Some(named) = entries.iter().find_map(|entry| entry.key) {
        return Err(Fault::unknown_argument(named.span, named.name));
    }
    let is_value = |entry: &Entry<'_>| matches!(entry.node.kind, NodeKind::Value(_));
    // `axis-angle(1) [0, 0, 1, 0.785]`
    let is_whole = |entry: &Entry<'_>| held(&entry.node).is_some_and(|inner| inner.len() == 4);
    let (axis, angle) = match &entries[..] {
        [_, list] if is_whole(list) => {
            check_no_factor(&entries)?;
            return Err(Fault::axis_angle_parts(span));
        }
        [axis, angle] if is_value(angle) && !is_value(axis) => (axis_of_node(&axis.node)?, angle),
        [angle, axis] if is_value(angle) && !is_value(axis) => (axis_of_node(&axis.node)?, angle),
        [_, _, _, _] => {
            check_separators(&entries, span)?;
            let (axis, angle) = match form {
                Form::AngleAxis => (&entries[1..], &entries[0]),
                _ => (&entries[..3], &entries[3]),
            };
            (axis_of_entries(axis)?, angle)
        }
        _ => return Err(Fault::axis_angle_parts(span)),
    };
    let angle = (angle.node.angle()?, angle.node.span);
    description::axis_angle(axis, angle, rule)
}
