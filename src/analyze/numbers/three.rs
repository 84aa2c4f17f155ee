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
use crate::text::mend::number_text::exact;

/// What three numbers may be.
#[derive(Clone, Copy)]
enum Description {
    /// The axis of each number, as they stand.
    Euler(EulerSequence, [Axis; 3]),
    RotationVector,
    HalfAngle,
    Gibbs,
    ModifiedRodrigues,
}

/// One reading: the unit is radians where there is none.
#[derive(Clone, Copy)]
struct Way {
    description: Description,
    unit: AngleUnit,
    direction: Direction,
}

/// All readings of three numbers, beside an attitude.
pub(crate) struct ThreeNumbers {
    numbers: [f64; 3],
    ways: Vec<Way>,
    pub(crate) candidates: Vec<Candidate>,
}

impl ThreeNumbers {
    /// In one unit where it is known.
    pub(crate) fn of(numbers: [f64; 3], known: Option<AngleUnit>, attitude: &Rotation) -> Self {
        let mut three = Self {
            numbers,
            ways: Vec::new(),
            candidates: Vec::new(),
        };
        for unit in [AngleUnit::Radians, AngleUnit::Degrees] {
            if known.is_some_and(|known| known != unit) {
                continue;
            }
            for sequence in EulerSequence::all() {
                let axes = sequence.axes.axes();
                three.add(Description::Euler(sequence, axes), unit, attitude);
                for other in EulerAxes::ALL {
                    if is_in_another_order(sequence, other) {
                        three.add(Description::Euler(sequence, other.axes()), unit, attitude);
                    }
                }
            }
            three.add(Description::RotationVector, unit, attitude);
            three.add(Description::HalfAngle, unit, attitude);
        }
        three.add(Description::Gibbs, AngleUnit::Radians, attitude);
        three.add(Description::ModifiedRodrigues, AngleUnit::Radians, attitude);
        three
    }

    fn add(&mut self, description: Description, unit: AngleUnit, attitude: &Rotation) {
        let Some(described) = description.rotation(self.numbers, unit) else {
            return;
        };
        for direction in Direction::ALL {
            let attitude = match direction {
                Direction::BodyToWorld => *attitude,
                Direction::WorldToBody => attitude.inverse(),
            };
            self.ways.push(Way {
                description,
                unit,
                direction,
            });
            self.candidates.push(Candidate {
                off_rad: described.angle_to_rad(&attitude),
                half_unit_rad: description.half_unit_rad() * in_radians(1.0, unit),
                class: u8::from(!description.is_in_order()),
                rank: u8::from(direction == Direction::WorldToBody),
            });
        }
    }

    /// What the candidate at a place is; how far off it is, is known there.
    pub(crate) fn reading(&self, at: usize) -> Reading {
        let way = self.ways[at];
        Reading {
            meaning: way.meaning(),
            direction: way.direction,
            world: None,
            body: None,
            off_deg: 0.0,
            text: Some(way.text(self.numbers)),
        }
    }
}

/// How far an attitude is from the nearest one that three numbers may be, in radians.
#[cfg(feature = "whole")]
pub(crate) fn nearest_off_rad(
    numbers: [f64; 3],
    known: Option<AngleUnit>,
    attitude: &Rotation,
) -> f64 {
    let mut nearest = f64::INFINITY;
    for candidate in ThreeNumbers::of(numbers, known, attitude).candidates {
        nearest = nearest.min(candidate.off_rad);
    }
    nearest
}

/// Whether angles about these axes are those of the sequence in another order than that of the turns. About
/// axes that stay they would be those about axes that move, backwards.
fn is_in_another_order(sequence: EulerSequence, axes: EulerAxes) -> bool {
    let [first, second, third] = sequence.axes.axes();
    let other = axes.axes();
    sequence.frame == EulerFrame::Intrinsic
        && first != third
        && other[0] != other[2]
        && other != [first, second, third]
        && other != [third, second, first]
}

fn in_radians(number: f64, unit: AngleUnit) -> f64 {
    match unit {
        AngleUnit::Radians => number,
        AngleUnit::Degrees => degrees_in_radians(number),
    }
}

impl Description {
    fn is_in_order(self) -> bool {
        !matches!(self, Self::Euler(sequence, axes) if sequence.axes.axes() != axes)
    }

    /// The attitude that the numbers are.
    fn rotation(self, numbers: [f64; 3], unit: AngleUnit) -> Option<Rotation> {
        let [one, two, three] = numbers;
        let numbers = [
            in_radians(one, unit),
            in_radians(two, unit),
            in_radians(three, unit),
        ];
        let vector = numbers.into();
        let rotation = match self {
            Self::Euler(sequence, _) => {
                Rotation::from_euler_in(unit, sequence, self.in_sequence(numbers))
            }
            Self::RotationVector => AxisVector::RotationVector(vector).to_rotation(),
            Self::HalfAngle => AxisVector::HalfAngle(vector).to_rotation(),
            Self::Gibbs => AxisVector::Gibbs(vector).to_rotation(),
            Self::ModifiedRodrigues => AxisVector::ModifiedRodrigues(vector).to_rotation(),
        };
        rotation.ok()
    }

    /// The numbers in the order of the turns.
    fn in_sequence(self, numbers: [f64; 3]) -> [f64; 3] {
        let Self::Euler(sequence, turns_about) = self else {
            return numbers;
        };
        let mut is_left = [true; 3];
        let mut sorted = [0.0; 3];
        for (turn, axis) in sequence.axes.axes().into_iter().enumerate() {
            // Of an axis that stands twice the first number first.
            for at in 0..3 {
                if is_left[at] && turns_about[at] == axis {
                    sorted[turn] = numbers[at];
                    is_left[at] = false;
                    break;
                }
            }
        }
        sorted
    }

    /// How much half a unit of each of the three numbers, in radians, turns at most.
    const fn half_unit_rad(self) -> f64 {
        match self {
            Self::Euler(..) => 3.0,
            Self::RotationVector => 2.0,
            Self::HalfAngle | Self::Gibbs => 4.0,
            Self::ModifiedRodrigues => 7.0,
        }
    }
}

impl Way {
    fn meaning(self) -> NumbersMeaning {
        let unit = self.unit;
        match self.description {
            Description::Euler(sequence, turns_about) => NumbersMeaning::EulerAngles {
                sequence,
                unit,
                turns_about,
            },
            Description::RotationVector => NumbersMeaning::RotationVector { unit },
            Description::HalfAngle => NumbersMeaning::HalfAngleVector { unit },
            Description::Gibbs => NumbersMeaning::GibbsVector,
            Description::ModifiedRodrigues => NumbersMeaning::ModifiedRodrigues,
        }
    }

    /// The attitude in words that are read: the numbers as they are, or for the inverse with the other sign,
    /// Euler angles backwards.
    fn text(self, numbers: [f64; 3]) -> String {
        let mut numbers = self.description.in_sequence(numbers);
        let mut axes = None;
        if let Description::Euler(sequence, _) = self.description {
            axes = Some(sequence);
        }
        if self.direction == Direction::WorldToBody {
            let [one, two, three] = numbers;
            numbers = [-one, -two, -three];
            if let Some(sequence) = axes {
                numbers.reverse();
                axes = Some(sequence.backwards());
            }
        }
        let name = match self.description {
            Description::Euler(..) => "",
            Description::RotationVector => "rotvec",
            Description::HalfAngle => "halfangle",
            Description::Gibbs => "gibbs",
            Description::ModifiedRodrigues => "mrp",
        };
        let mut text = axes.map_or(name.to_owned(), |sequence| sequence.to_string());
        for number in numbers {
            text.push(' ');
            text.push_str(&exact(plain(number)));
        }
        match (self.description, self.unit) {
            (Description::Gibbs | Description::ModifiedRodrigues, _) => {}
            (_, AngleUnit::Degrees) => text.push_str(" deg"),
            (_, AngleUnit::Radians) => text.push_str(" rad"),
        }
        text
    }
}
