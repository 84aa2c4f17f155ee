//! What is announced in words to a rotation.

use crate::convention::angle::AngleUnit;
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::description;
use crate::text::description::angle::{self, Angle, UnitRule};
use crate::text::description::announcement::{self, Announcement};
use crate::text::description::axis::{
    self, axis_of_entries, axis_of_node, letter_ahead, span_of, trimmed,
};
use crate::text::description::call;
use crate::text::description::list::{check_no_factor, check_separators, held, members};
use crate::text::description::matrix;
use crate::text::description::matrix_columns::{self, labelled_vectors};
use crate::text::description::parts::{self, named_parts};
use crate::text::description::quaternion;
use crate::text::description::{
    ParsedRotation, THREE_ANGLES, THREE_HALVES, THREE_NUMBERS, euler_angles, half_angle_vector,
    rotation_vector, three,
};
use crate::text::grammar;
use crate::text::grammar::arithmetic::{Linear, Quantity};
use crate::text::grammar::lex::{Token, TokenKind};
use crate::text::grammar::nesting::inside;
use crate::text::grammar::tree::{Entry, NodeKind};
use crate::text::vocabulary::constructors::is_derived_label;
use crate::text::vocabulary::declaration;
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

/// What follows an announcement, as the description that it announces.
pub(crate) fn announced(
    announcement: &Announcement<'_>,
    form: Form,
    rest: &[Token<'_>],
    text: &str,
) -> Result<ParsedRotation, Fault> {
    let rest = trimmed(rest);
    if let [word, open, ..] = rest
        && word.kind == TokenKind::Word
        && matches!(open.kind, TokenKind::Open(_))
        && let Some(rotation) = call::rotation(&grammar::entries(rest)?)?
    {
        return match announcement.unit {
            Some(_) => Err(Fault::mixed_units(announcement.span)),
            None => Ok(rotation),
        };
    }
    let inner = inside(rest).unwrap_or(rest);
    if let Some(word) = announcement::telling_label(inner) {
        return Err(Fault::unknown_keyword(word.span, word.text));
    }
    if let Some(found) = named_parts(inner) {
        if let Some(label) = inner.first().filter(|word| is_derived_label(word.text)) {
            return Err(Fault::derived_label(label.span, label.text));
        }
        return parts::rotation(&found, announcement, span_of(rest, announcement.span));
    }
    let (rest, unit) = angle::without_unit(rest);
    if let (Some(before), Some(after)) = (announcement.unit, unit)
        && before != after
    {
        return Err(Fault::mixed_units(announcement.span));
    }
    let unit = announcement.unit.or(unit);
    let span = span_of(rest, announcement.span);
    let rule = |otherwise| angle::rule(unit, otherwise);
    let radians = UnitRule::Custom(AngleUnit::Radians);
    match form {
        Form::Matrix => {
            if unit.is_some() {
                return Err(Fault::mixed_units(announcement.span));
            }
            if let Some(vectors) = labelled_vectors(inside(rest).unwrap_or(rest)) {
                return matrix_columns::matrix(&vectors, span).map(ParsedRotation::Matrix);
            }
            let entries = grammar::entries(rest)?;
            matrix::matrix(&entries, span).map(ParsedRotation::Matrix)
        }
        Form::RotationVector => {
            rotation_vector(vector_of_angles(rest, span, THREE_NUMBERS)?, rule(radians))
        }
        Form::HalfAngleVector => {
            half_angle_vector(vector_of_angles(rest, span, THREE_HALVES)?, rule(radians))
        }
        Form::GibbsVector | Form::ModifiedRodrigues => {
            if unit.is_some() {
                return Err(Fault::unit_of_tangents(span));
            }
            let vector = quaternion::vector(&grammar::entries(rest)?, span)?;
            Ok(match form {
                Form::GibbsVector => ParsedRotation::GibbsVector(vector),
                _ => ParsedRotation::ModifiedRodrigues(vector),
            })
        }
        Form::RodriguesVector => Err(Fault::rodrigues_vector(announcement.span)),
        Form::Euler => {
            let sequence = announcement.euler_sequence()?;
            // In quotes they are an attribute of URDF, whose angles are radians.
            let quoted = quoted(rest, text)?;
            let rule = rule(match quoted {
                Some(_) => radians,
                None => UnitRule::Magnitude,
            });
            let entries = grammar::entries(quoted.as_deref().unwrap_or(rest))?;
            euler_angles(sequence, three(&entries, span, THREE_ANGLES)?, rule)
        }
        Form::AxisAngle | Form::AngleAxis | Form::Quaternion => {
            axis_angle(rest, span, form, rule(UnitRule::Magnitude))
        }
    }
}

/// Three angles, in a list or by the names of their axes.
fn vector_of_angles(tokens: &[Token<'_>], span: Span, what: &str) -> Result<[Angle; 3], Fault> {
    let entries = grammar::entries(tokens)?;
    if members(&entries)?.iter().any(|entry| entry.key.is_some()) {
        let part = |number| (Linear::real(number), span);
        let vector: [f64; 3] = quaternion::vector(&entries, span)?.into();
        return Ok(vector.map(part));
    }
    three(&entries, span, what)
}

/// `45deg [0, 0, 1]`, `(z, 45deg)`: a unit tells which of the two is the angle.
pub(crate) fn angle_beside_axis(entries: &[Entry<'_>]) -> Result<Option<ParsedRotation>, Fault> {
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
    let Ok(members) = members(entries) else {
        return Ok(None);
    };
    let (angle, axis) = match &members[..] {
        [one, two] if one.key.is_some() || two.key.is_some() => return Ok(None),
        [angle, axis] | [axis, angle] if is_angle(angle) && is_axis(axis) => (angle, axis),
        _ => return Ok(None),
    };
    let angle = (angle.node.angle()?, angle.node.span);
    description::axis_angle(axis_of_node(&axis.node)?, angle, UnitRule::Magnitude).map(Some)
}

/// The tokens inside quotes around all the numbers: `rpy="0.1 0.2 0.3"`.
fn quoted<'t>(tokens: &[Token<'_>], text: &'t str) -> Result<Option<Vec<Token<'t>>>, Fault> {
    match tokens {
        [only] if only.kind == TokenKind::Quoted => {
            let inside = Span::from(only.span.start + 1..only.span.end - 1);
            declaration::tokens_within(text, inside).map(Some)
        }
        _ => Ok(None),
    }
}

/// An axis in letters or three numbers, and an angle, in the order of their announcement; brackets
/// around the axis tell the order themselves.
fn axis_angle(
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
