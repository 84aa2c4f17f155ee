//! Numbers in, numbers out: what the class `Rotation` of the package asks.
//!
//! A rotation is four numbers in JavaScript, and each call takes its numbers from [`registers`] and leaves its
//! answer there, so that nothing is allocated and nothing has to be freed. That is why neither slices nor
//! objects cross here: a product takes 17 ns through memory that both sides see, 235 to 257 ns with the slices of
//! wasm-bindgen, and an object of serde-wasm-bindgen 54 ns a number. Which names a choice has is told by
//! `pkg/values.js`; here it is its place in that list.

// Attitudes of other attitudes.
pub mod algebra;

// Attitudes from their descriptions.
pub mod describing;

// The numbers that both sides see.
pub mod registers;

// Attitudes in motion.
pub mod moving;

// Four numbers with their convention.
pub mod tagged;

// Descriptions of attitudes.
pub mod telling;

use crate::convention::angle::{AngleUnit, degrees_in_radians};
use crate::convention::euler_sequence::{EulerAxes, EulerFrame, EulerSequence};
use crate::convention::order::ComponentOrder;
use crate::convention::side::IncrementSign;
use crate::convention::{Convention, Direction, Function, Handedness, Perturbation};
use crate::motion::kinematics::RateAxes;
use wasm_bindgen::prelude::*;

/// What came of a call; where it is not [`CallOutcome::Done`], the registers hold nothing.
#[wasm_bindgen]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CallOutcome {
    /// The answer is in the registers.
    Done,
    /// Numbers that are all zero, or not finite.
    NoRotation,
    /// The matrix has a negative determinant.
    Reflection,
    /// The columns of the matrix lie in a plane, or no rotation is nearest.
    Singular,
    /// The answer is larger than any double.
    TooLarge,
}

/// The place of a choice in its list: of one beyond the end, the last.
fn chosen<Choice: Copy>(list: &[Choice; 2], place: u8) -> Choice {
    list[usize::from(place != 0)]
}

/// The convention of five bits: order, handedness, function, direction and perturbation, from the lowest up,
/// each the place of the choice in its list.
fn convention(code: u8) -> Convention {
    Convention {
        order: chosen(&ComponentOrder::ALL, code & 1),
        handedness: chosen(&Handedness::ALL, code & 2),
        function: chosen(&Function::ALL, code & 4),
        direction: chosen(&Direction::ALL, code & 8),
        perturbation: chosen(&Perturbation::ALL, code & 16),
    }
}

fn direction(place: u8) -> Direction {
    chosen(&Direction::ALL, place)
}

fn rate_axes(place: u8) -> RateAxes {
    chosen(&[RateAxes::Body, RateAxes::World], place)
}

fn increment_sign(place: u8) -> IncrementSign {
    chosen(&IncrementSign::ALL, place)
}

fn unit(place: u8) -> AngleUnit {
    chosen(&[AngleUnit::Degrees, AngleUnit::Radians], place)
}

/// The sequence of the place of its axes and that of its frame.
fn sequence(axes: u8, frame: u8) -> EulerSequence {
    let mut found = EulerAxes::Xyz;
    for (place, axes_there) in (0_u8..).zip(EulerAxes::ALL) {
        if place == axes {
            found = axes_there;
        }
    }
    EulerSequence {
        axes: found,
        frame: chosen(&EulerFrame::ALL, frame),
    }
}

/// An angle as it was given, in radians.
fn in_radians(angle: f64, unit: AngleUnit) -> f64 {
    match unit {
        AngleUnit::Degrees => degrees_in_radians(angle),
        AngleUnit::Radians => angle,
    }
}

/// An angle in radians, as it is asked for.
fn in_unit(angle_rad: f64, unit: AngleUnit) -> f64 {
    match unit {
        AngleUnit::Degrees => angle_rad.to_degrees(),
        AngleUnit::Radians => angle_rad,
    }
}
