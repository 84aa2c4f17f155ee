//! Angles as typed to radians: which unit each has, and what stands where none is written.

use crate::convention::angle::{AngleUnit, UnitSource};
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::grammar::arithmetic::{Linear, Quantity};
use crate::text::grammar::lex::{Token, TokenKind};

/// A full turn in radians as people round it: 6.28, 6.283, 6.2832.
pub(crate) const FULL_TURN_RAD: f64 = 6.29;

/// A number where an angle is wanted, and its place.
pub(crate) type Angle = (Linear, Span);

/// The unit of the numbers that have none beside them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum UnitRule {
    /// Written once for all the numbers, as in `ZYX 30 20 10 deg`.
    ForAll(AngleUnit),
    /// That of the library whose call holds the numbers.
    Library(AngleUnit),
    /// Customary for this representation.
    Custom(AngleUnit),
    /// Radians where no angle is larger than a full turn, degrees otherwise.
    Magnitude,
}

/// What the angles of one rotation are: turns, of which many are as good as none, or lengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Of {
    Turns,
    Vector,
}

/// All the angles of one rotation in radians, and how their unit was told.
pub(crate) fn in_radians<const COUNT: usize>(
    angles: [Angle; COUNT],
    of: Of,
    rule: UnitRule,
) -> Result<([f64; COUNT], UnitSource), Fault> {
    let source = unit_source(&angles, rule)?;
    let mut radians = [0.0; COUNT];
    for (radians, (value, span)) in radians.iter_mut().zip(angles) {
        let value = match (value.quantity, source.unit()) {
            (Quantity::Angle(_), _) | (_, AngleUnit::Radians) => value,
            (_, AngleUnit::Degrees) => value.angle(AngleUnit::Degrees, span)?,
        };
        if value.scalar != 0.0 && value.radians().scalar == 0.0 {
            return Err(Fault::too_small(span));
        }
        *radians = match of {
            Of::Turns => value.turn().scalar,
            Of::Vector => value.radians().scalar,
        };
    }
    Ok((radians, source))
}

fn unit_source(angles: &[Angle], rule: UnitRule) -> Result<UnitSource, Fault> {
    let beside = angles.iter().find_map(|(value, _)| match value.quantity {
        Quantity::Angle(unit) => Some(unit),
        Quantity::Number | Quantity::OfPi => None,
    });
    if let Some(unit) = beside {
        check_units(angles, unit, rule)?;
        return Ok(UnitSource::Written(unit));
    }
    let is_of_pi = |(value, _): &Angle| value.quantity == Quantity::OfPi;
    let is_more_than_a_turn = |(value, _): &Angle| {
        value.quantity == Quantity::Number && value.scalar.abs() > FULL_TURN_RAD
    };
    Ok(match rule {
        // The library takes radians, and 90 of them are hardly meant.
        UnitRule::Library(AngleUnit::Radians)
            if cfg!(feature = "whole") && angles.iter().any(is_more_than_a_turn) =>
        {
            UnitSource::Assumed(AngleUnit::Radians)
        }
        UnitRule::ForAll(unit) | UnitRule::Library(unit) => UnitSource::Written(unit),
        _ if angles.iter().any(is_of_pi) => UnitSource::Written(AngleUnit::Radians),
        UnitRule::Custom(unit) => UnitSource::Assumed(unit),
        UnitRule::Magnitude
            if angles
                .iter()
                .all(|(value, _)| value.scalar.abs() <= FULL_TURN_RAD) =>
        {
            UnitSource::Assumed(AngleUnit::Radians)
        }
        UnitRule::Magnitude => UnitSource::Assumed(AngleUnit::Degrees),
    })
}

/// Where one number has a unit beside it, all must have that one; only zero needs none.
fn check_units(angles: &[Angle], unit: AngleUnit, rule: UnitRule) -> Result<(), Fault> {
    for &(value, span) in angles {
        match (value.quantity, unit) {
            (Quantity::Angle(other), _) if other != unit => return Err(Fault::mixed_units(span)),
            (Quantity::OfPi, AngleUnit::Degrees) => return Err(Fault::mixed_units(span)),
            (Quantity::Number, _) if value.scalar != 0.0 && rule != UnitRule::ForAll(unit) => {
                return Err(Fault::missing_unit(span, unit));
            }
            (Quantity::Angle(_), _) if matches!(rule, UnitRule::ForAll(all) if all != unit) => {
                return Err(Fault::mixed_units(span));
            }
            _ => {}
        }
    }
    Ok(())
}

/// The tokens without a unit that stands apart at their end, and so belongs to all of them:
/// `30 20 10 deg`, `[0, 0, 45]°`, `30 20 10 (rad)`.
pub(crate) fn without_unit<'s, 't>(
    tokens: &'s [Token<'t>],
) -> (&'s [Token<'t>], Option<AngleUnit>) {
    let is_opening = |kind| matches!(kind, TokenKind::Open(_));
    match tokens {
        [rest @ .., open, unit, close]
            if is_opening(open.kind)
                && matches!(close.kind, TokenKind::Close(_))
                && unit.angle_unit().is_some() =>
        {
            (rest, unit.angle_unit())
        }
        [rest @ .., before, unit]
            if unit.angle_unit().is_some()
                && (!unit.spacing.is_adjacent() || matches!(before.kind, TokenKind::Close(_))) =>
        {
            (&tokens[..=rest.len()], unit.angle_unit())
        }
        _ => (tokens, None),
    }
}

/// The rule that a unit written for all makes, or else this one.
pub(crate) fn rule(for_all: Option<AngleUnit>, otherwise: UnitRule) -> UnitRule {
    for_all.map_or(otherwise, UnitRule::ForAll)
}
