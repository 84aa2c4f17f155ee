//! Three numbers as a description of an attitude: Euler angles, or a vector along the axis.
//!
//! 108 readings have the numbers in their order: 24 sequences in two units, a rotation vector and a
//! half-angle vector in two units, Gibbs and modified Rodrigues; each of the attitude or of its inverse.
//! Of three different axes there are 96 more, whose numbers stand in another order than that of the turns.

use crate::analyze::numbers::candidate::Candidate;
use crate::analyze::plain_numbers::plain;
use crate::contract::{NumbersMeaning, Reading};
use crate::convention::Direction;
use crate::convention::angle::{AngleUnit, degrees_in_radians};
use crate::convention::euler_sequence::{Axis, EulerAxes, EulerFrame, EulerSequence};
use crate::rotation::Rotation;
use crate::rotation::rotation_vector::AxisVector;
use crate::text::mend::exact;
use nalgebra::Vector3;

const UNITS: [AngleUnit; 2] = [AngleUnit::Radians, AngleUnit::Degrees];

/// The readings of three numbers, each with how far it is from the attitude; in one unit where it is known.
pub(crate) fn of_three_numbers(
    numbers: [f64; 3],
    unit: Option<AngleUnit>,
    attitude: &Rotation,
) -> Vec<Candidate> {
    let is_meant = |meaning: &NumbersMeaning| {
        unit.is_none() || unit_of(meaning).is_none_or(|other| unit == Some(other))
    };
    meanings()
        .filter(is_meant)
        .filter_map(|meaning| Some((rotation(&meaning, numbers)?, meaning)))
        .flat_map(|(rotation, meaning)| {
            Direction::ALL.map(|direction| {
                let described = match direction {
                    Direction::BodyToWorld => *attitude,
                    Direction::WorldToBody => attitude.inverse(),
                };
                candidate(
                    &meaning,
                    numbers,
                    direction,
                    rotation.angle_to_rad(&described),
                )
            })
        })
        .collect()
}

fn candidate(
    meaning: &NumbersMeaning,
    numbers: [f64; 3],
    direction: Direction,
    off_rad: f64,
) -> Candidate {
    let in_order = !matches!(meaning, NumbersMeaning::EulerAngles { sequence, turns_about, .. }
        if sequence.axes.axes() != *turns_about);
    Candidate {
        off_rad,
        half_unit_rad: half_unit_rad(meaning),
        class: u8::from(!in_order),
        rank: u8::from(direction == Direction::WorldToBody),
        reading: Reading {
            meaning: meaning.clone(),
            direction,
            off_deg: off_rad.to_degrees(),
            text: Some(text(meaning, numbers, direction)),
        },
    }
}

/// What three numbers may be, in order those first that have theirs.
fn meanings() -> impl Iterator<Item = NumbersMeaning> {
    let euler = |sequence: EulerSequence, turns_about: [Axis; 3]| {
        UNITS.map(|unit| NumbersMeaning::EulerAngles {
            sequence,
            unit,
            turns_about,
        })
    };
    let in_order =
        EulerSequence::all().flat_map(move |sequence| euler(sequence, sequence.axes.axes()));
    let vectors = UNITS.into_iter().flat_map(|unit| {
        [
            NumbersMeaning::RotationVector { unit },
            NumbersMeaning::HalfAngleVector { unit },
        ]
    });
    let others = [
        NumbersMeaning::GibbsVector,
        NumbersMeaning::ModifiedRodrigues,
    ];
    // About axes that move, and backwards about those that stay: the latter stand above.
    let out_of_order = EulerSequence::all()
        .filter(|sequence| sequence.frame == EulerFrame::Intrinsic && !sequence.is_proper())
        .flat_map(move |sequence| {
            let [first, second, third] = sequence.axes.axes();
            EulerAxes::ALL
                .into_iter()
                .map(EulerAxes::axes)
                .filter(move |axes| axes[0] != axes[2])
                .filter(move |axes| {
                    *axes != [first, second, third] && *axes != [third, second, first]
                })
                .flat_map(move |axes| euler(sequence, axes))
        });
    in_order.chain(vectors).chain(others).chain(out_of_order)
}

const fn unit_of(meaning: &NumbersMeaning) -> Option<AngleUnit> {
    match meaning {
        NumbersMeaning::EulerAngles { unit, .. }
        | NumbersMeaning::RotationVector { unit }
        | NumbersMeaning::HalfAngleVector { unit } => Some(*unit),
        _ => None,
    }
}

/// The attitude that the numbers are.
fn rotation(meaning: &NumbersMeaning, numbers: [f64; 3]) -> Option<Rotation> {
    let in_radians = |unit: &AngleUnit| match unit {
        AngleUnit::Radians => numbers,
        AngleUnit::Degrees => numbers.map(degrees_in_radians),
    };
    match meaning {
        NumbersMeaning::EulerAngles {
            sequence,
            unit,
            turns_about,
        } => {
            let angles_rad = in_sequence(in_radians(unit), *sequence, *turns_about);
            Rotation::from_euler_in(*unit, *sequence, angles_rad)
        }
        NumbersMeaning::RotationVector { unit } => {
            AxisVector::RotationVector(in_radians(unit).into()).to_rotation()
        }
        NumbersMeaning::HalfAngleVector { unit } => {
            AxisVector::HalfAngle(in_radians(unit).into()).to_rotation()
        }
        NumbersMeaning::GibbsVector => AxisVector::Gibbs(numbers.into()).to_rotation(),
        NumbersMeaning::ModifiedRodrigues => {
            AxisVector::ModifiedRodrigues(numbers.into()).to_rotation()
        }
        NumbersMeaning::Quaternion { .. } | NumbersMeaning::Matrix { .. } => return None,
    }
    .ok()
}

/// The numbers in the order of the turns.
fn in_sequence(numbers: [f64; 3], sequence: EulerSequence, turns_about: [Axis; 3]) -> [f64; 3] {
    if sequence.axes.axes() == turns_about {
        // Also where an axis stands twice.
        return numbers;
    }
    sequence.axes.axes().map(|axis| {
        let mut pairs = turns_about.into_iter().zip(numbers);
        pairs
            .find(|(other, _)| *other == axis)
            .map_or(0.0, |(_, number)| number)
    })
}

/// How much half a unit of the last decimal of each of the three numbers turns, at most.
fn half_unit_rad(meaning: &NumbersMeaning) -> f64 {
    let per_unit_rad = match unit_of(meaning) {
        Some(AngleUnit::Degrees) => degrees_in_radians(1.0),
        _ => 1.0,
    };
    per_unit_rad
        * match meaning {
            NumbersMeaning::EulerAngles { .. } => 3.0,
            NumbersMeaning::RotationVector { .. } => 2.0,
            NumbersMeaning::HalfAngleVector { .. } | NumbersMeaning::GibbsVector => 4.0,
            _ => 7.0,
        }
}

/// The attitude in the words that the reader of texts knows: the numbers as they are, or for the inverse
/// with the other sign, Euler angles backwards.
fn text(meaning: &NumbersMeaning, numbers: [f64; 3], direction: Direction) -> String {
    let is_inverse = direction == Direction::WorldToBody;
    let sign = if is_inverse { -1.0 } else { 1.0 };
    let mut numbers = Vector3::from(numbers).map(|number| sign * number).into();
    let name = match meaning {
        NumbersMeaning::EulerAngles {
            sequence,
            turns_about,
            ..
        } => {
            numbers = in_sequence(numbers, *sequence, *turns_about);
            let mut sequence = *sequence;
            if is_inverse {
                numbers.reverse();
                sequence = backwards(sequence);
            }
            sequence.to_string()
        }
        NumbersMeaning::RotationVector { .. } => "rotvec".to_owned(),
        NumbersMeaning::HalfAngleVector { .. } => "halfangle".to_owned(),
        NumbersMeaning::GibbsVector => "gibbs".to_owned(),
        _ => "mrp".to_owned(),
    };
    let [a, b, c] = numbers.map(|number| exact(plain(number)));
    let unit = match unit_of(meaning) {
        Some(AngleUnit::Degrees) => " deg",
        Some(AngleUnit::Radians) => " rad",
        None => "",
    };
    format!("{name} {a} {b} {c}{unit}")
}

/// The sequence of the inverse, whose turns are backwards one after the other.
fn backwards(sequence: EulerSequence) -> EulerSequence {
    let [first, second, third] = sequence.axes.axes();
    let axes = EulerAxes::ALL
        .into_iter()
        .find(|axes| axes.axes() == [third, second, first]);
    EulerSequence {
        axes: axes.unwrap_or(sequence.axes),
        ..sequence
    }
}
