//! The numbers behind an announcement, as the description that it announces.

use crate::convention::angle::AngleUnit;
use crate::problem::fault::Fault;
use crate::problem::{Span, Wanted};
use crate::text::description::angle::{self, Angle, UnitRule};
use crate::text::description::announcement::{self, Announcement};
use crate::text::description::axis::{span_of, trimmed};
use crate::text::description::axis_angle;
use crate::text::description::call;
use crate::text::description::label;
use crate::text::description::list::members;
use crate::text::description::matrix;
use crate::text::description::matrix_columns::{self, labelled_vectors};
use crate::text::description::named_parts::{self, named_parts};
use crate::text::description::vector::vector;
use crate::text::description::{
    ParsedRotation, THREE_ANGLES, THREE_HALVES, THREE_NUMBERS, euler_angles, half_angle_vector,
    rotation_vector, three,
};
use crate::text::grammar;
use crate::text::grammar::arithmetic::Linear;
use crate::text::grammar::lex::{self, Token, TokenKind};
use crate::text::grammar::nesting::inside;
use crate::text::vocabulary::declaration::without_words;
use crate::text::vocabulary::phrases::{Form, is_name};

/// What follows an announcement, as the description that it announces.
pub(crate) fn rotation(
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
        if let Some(first) = inner.first().filter(|first| is_name(first)) {
            label::check(first.text, first.span, Wanted::Quaternion)?;
        }
        return named_parts::rotation(&found, announcement, span_of(rest, announcement.span));
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
            let vector = vector(&grammar::entries(rest)?, span)?;
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
            axis_angle::announced(rest, span, form, rule(UnitRule::Magnitude))
        }
    }
}

/// Three angles, in a list or by the names of their axes.
fn vector_of_angles(tokens: &[Token<'_>], span: Span, what: &str) -> Result<[Angle; 3], Fault> {
    let entries = grammar::entries(tokens)?;
    if members(&entries)?.iter().any(|entry| entry.key.is_some()) {
        let part = |number| (Linear::real(number), span);
        let vector = vector(&entries, span)?;
        return Ok([part(vector.x), part(vector.y), part(vector.z)]);
    }
    three(&entries, span, what)
}

/// The tokens inside quotes around all the numbers: `rpy="0.1 0.2 0.3"`.
fn quoted<'t>(tokens: &[Token<'_>], text: &'t str) -> Result<Option<Vec<Token<'t>>>, Fault> {
    match tokens {
        [only] if only.kind == TokenKind::Quoted => {
            let inside = Span::from(only.span.start + 1..only.span.end - 1);
            let tokens = lex::tokens_within(text, inside)?;
            Ok(Some(without_words(&tokens)))
        }
        _ => Ok(None),
    }
}
