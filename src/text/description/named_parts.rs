//! The parts of a rotation by name: `roll=10deg pitch=20deg yaw=30deg`, `axis=[0, 0, 1] angle=45deg`.

use crate::convention::angle::AngleUnit;
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::description::angle::{self, Angle, UnitRule};
use crate::text::description::announcement::Announcement;
use crate::text::description::axis::{self, trimmed};
use crate::text::description::{self, ParsedRotation, euler_angles};
use crate::text::grammar::lex::{Token, last_segment};
use crate::text::grammar::nesting::at_depth_zero;
use crate::text::vocabulary::phrases::{Form, is_mark, is_name};
use strum::{EnumString, IntoStaticStr};

pub(crate) struct SpokenPart<'s, 't> {
    pub(crate) part: Part,
    /// That of its name.
    pub(crate) unit: Option<AngleUnit>,
    pub(crate) label: Span,
    pub(crate) tokens: &'s [Token<'t>],
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, EnumString, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum Part {
    Axis,
    Angle,
    Roll,
    Pitch,
    #[strum(to_string = "yaw", serialize = "heading")]
    Yaw,
}

impl Part {
    /// The part that a name is, with the unit at its end, as in `roll_deg`.
    fn named(token: &Token<'_>) -> Option<(Self, Option<AngleUnit>)> {
        if !is_name(token) {
            return None;
        }
        let lower = last_segment(token.text).to_ascii_lowercase();
        let (name, unit) = match lower.split_once('_') {
            Some((name, unit)) => (name, Some(AngleUnit::named(unit)?)),
            None => (lower.as_str(), None),
        };
        let part = name.parse().ok()?;
        if part == Self::Axis && unit.is_some() {
            return None;
        }
        Some((part, unit))
    }
}

/// The parts whose names a text begins with.
pub(crate) fn named_parts<'s, 't>(tokens: &'s [Token<'t>]) -> Option<Vec<SpokenPart<'s, 't>>> {
    let mut parts: Vec<SpokenPart<'s, 't>> = Vec::new();
    // Where what belongs to the last name begins.
    let mut start = 0;
    for at in at_depth_zero(tokens) {
        let Some((part, unit)) = Part::named(&tokens[at]) else {
            continue;
        };
        match parts.last_mut() {
            Some(last) => last.tokens = &tokens[start..at],
            // A type may stand before the first name, as in `double roll = 0.1`.
            None if at > 1 || (at == 1 && !is_name(&tokens[0])) => return None,
            None => {}
        }
        start = at + 1 + usize::from(is_mark(tokens.get(at + 1)));
        parts.push(SpokenPart {
            part,
            unit,
            label: tokens[at].span,
            tokens: &tokens[start..],
        });
    }
    (!parts.is_empty()).then_some(parts)
}

/// Whether a token names a roll, pitch or yaw.
pub(crate) fn is_named_angle(token: &Token<'_>) -> bool {
    Part::named(token).is_some_and(|(part, _)| !is_of_turn(part))
}

/// The rotation whose parts these are, announced as what they can be.
pub(crate) fn rotation(
    parts: &[SpokenPart<'_, '_>],
    announcement: &Announcement<'_>,
    span: Span,
) -> Result<ParsedRotation, Fault> {
    for (at, part) in parts.iter().enumerate() {
        if is_of_turn(part.part) != is_of_turn(parts[0].part) {
            return Err(Fault::mixed_parts(part.label));
        }
        if parts[..at].iter().any(|other| other.part == part.part) {
            return Err(Fault::duplicate_part(part.label, part.part.into()));
        }
    }
    let is_announced = match announcement.form {
        None => true,
        Some(Form::AxisAngle | Form::AngleAxis) => is_of_turn(parts[0].part),
        Some(Form::Euler) => !is_of_turn(parts[0].part),
        Some(_) => false,
    };
    if !is_announced {
        return Err(Fault::mixed_parts(parts[0].label));
    }
    let for_all = announcement.unit;
    let find = |wanted| parts.iter().find(|part| part.part == wanted);
    let end = Span::from(span.end..span.end);
    if is_of_turn(parts[0].part) {
        let axis = find(Part::Axis).ok_or_else(|| Fault::no_axis(end))?;
        let angle = find(Part::Angle).ok_or_else(|| Fault::no_angle(end))?;
        let axis = axis::axis(axis.tokens, axis.label)?;
        let angle = angle_of(angle, angle.tokens)?;
        return description::axis_angle(axis, angle, angle::rule(for_all, UnitRule::Magnitude));
    }
    let names = [Part::Roll, Part::Pitch, Part::Yaw];
    let [Some(roll), Some(pitch), Some(yaw)] = [find(names[0]), find(names[1]), find(names[2])]
    else {
        let mut missing: Vec<&str> = Vec::new();
        for part in names {
            if find(part).is_none() {
                missing.push(part.into());
            }
        }
        return Err(Fault::missing_part(span, &missing));
    };
    // A unit apart after the last number is one for all.
    let last = parts.last().map_or(&[][..], |last| last.tokens);
    let (last_number, unit) = angle::without_unit(trimmed(last));
    let angle = |part: &SpokenPart<'_, '_>| {
        let is_last = std::ptr::eq(part.tokens, last);
        angle_of(part, if is_last { last_number } else { part.tokens })
    };
    let by_axis = [angle(roll)?, angle(pitch)?, angle(yaw)?];
    if let (Some(one), Some(other)) = (unit, for_all)
        && one != other
    {
        return Err(Fault::mixed_units(span));
    }
    let rule = angle::rule(unit.or(for_all), UnitRule::Magnitude);
    let sequence = announcement.sequence_of_named_angles()?;
    let [one, two, three] = sequence.axes.places();
    euler_angles(sequence, [by_axis[one], by_axis[two], by_axis[three]], rule)
}

/// The angle that tokens are, in the unit that the name of the part says.
fn angle_of(part: &SpokenPart<'_, '_>, tokens: &[Token<'_>]) -> Result<Angle, Fault> {
    let (value, span) = axis::angle(tokens, part.label)?;
    match part.unit {
        Some(unit) => Ok((value.angle(unit, span)?, span)),
        None => Ok((value, span)),
    }
}

fn is_of_turn(part: Part) -> bool {
    matches!(part, Part::Axis | Part::Angle)
}
