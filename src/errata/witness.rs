//! The two sides of a statement in numbers, and how far they are apart.
//!
//! What the witnesses of all documents share: a statement is a list of equations, and its error is
//! the largest difference between a number on the left and its number on the right.

use crate::convention::Convention;
use crate::rotation::Rotation;
use nalgebra::{Matrix3, Quaternion, SVector, Vector3};
use serde::Serialize;

/// A statement as it is printed and as it should be, evaluated for one example.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Witness {
    /// The input, in words and numbers.
    pub example: &'static str,
    /// What the statement says as it is printed.
    pub printed: Sides,
    /// The largest difference between the two sides of `printed`.
    pub printed_error: f64,
    /// What the corrected statement says.
    pub corrected: Sides,
    /// The largest difference between the two sides of `corrected`: roundings.
    pub corrected_error: f64,
}

impl Witness {
    pub(crate) fn new(example: &'static str, printed: Sides, corrected: Sides) -> Self {
        Self {
            example,
            printed_error: printed.error(),
            printed,
            corrected_error: corrected.error(),
            corrected,
        }
    }
}

/// Both sides of a statement, number by number.
///
/// A matrix is told row by row, a quaternion as w, x, y, z; of several equations the numbers follow
/// each other. No number is −0.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Sides {
    /// The left-hand sides.
    pub left: Vec<f64>,
    /// The right-hand sides, as many numbers.
    pub right: Vec<f64>,
}

impl Sides {
    /// A statement without equations, to which they are added.
    pub(crate) fn new() -> Self {
        Self::default()
    }

    /// And one number is another.
    pub(crate) fn number(mut self, left: f64, right: f64) -> Self {
        self.left.push(left + 0.0);
        self.right.push(right + 0.0);
        self
    }

    /// And one vector is another.
    pub(crate) fn vector<const LENGTH: usize>(
        self,
        left: &SVector<f64, LENGTH>,
        right: &SVector<f64, LENGTH>,
    ) -> Self {
        let pairs = left.iter().zip(right.iter());
        pairs.fold(self, |sides, (left, right)| sides.number(*left, *right))
    }

    /// And one quaternion is another.
    pub(crate) fn quaternion(self, left: &Quaternion<f64>, right: &Quaternion<f64>) -> Self {
        self.number(left.w, right.w)
            .vector(&left.vector().into(), &right.vector().into())
    }

    /// And one matrix is another.
    pub(crate) fn matrix(self, left: &Matrix3<f64>, right: &Matrix3<f64>) -> Self {
        let (left, right) = (left.transpose(), right.transpose());
        let rows = left.column_iter().zip(right.column_iter());
        rows.fold(self, |sides, (left, right)| {
            sides.vector(&left.into(), &right.into())
        })
    }

    /// The largest difference; NaN if one is NaN.
    pub(crate) fn error(&self) -> f64 {
        let pairs = self.left.iter().zip(&self.right);
        pairs.fold(0.0_f64, |largest, (left, right)| {
            let difference = (left - right).abs();
            if difference.is_nan() || largest.is_nan() {
                f64::NAN
            } else {
                largest.max(difference)
            }
        })
    }
}

/// The quaternion of norm 1 of most examples: `[w, x, y, z]`, about (1, 2, 2)/3, with decimals.
pub(crate) const EXAMPLE: Quaternion<f64> = Quaternion::new(0.8, 0.2, 0.4, 0.4);

/// [`EXAMPLE`] as it is told.
pub(crate) const EXAMPLE_TEXT: &str = "q = (0.8, 0.2, 0.4, 0.4)";

/// The units of the quaternions.
pub(crate) const I: Quaternion<f64> = Quaternion::new(0.0, 1.0, 0.0, 0.0);
pub(crate) const J: Quaternion<f64> = Quaternion::new(0.0, 0.0, 1.0, 0.0);
pub(crate) const K: Quaternion<f64> = Quaternion::new(0.0, 0.0, 0.0, 1.0);

/// The rotation of numbers that are written in this crate and are one.
///
/// (If they were none, the corrected statement that is made of them would not hold.)
pub(crate) fn known<Problem>(rotation: Result<Rotation, Problem>) -> Rotation {
    rotation.unwrap_or(Rotation::identity())
}

/// The exponential of a rotation vector.
pub(crate) fn exponential(vector: Vector3<f64>) -> Rotation {
    known(Rotation::from_rotation_vector_rad(vector.into()))
}

/// The turn by an angle about an axis.
pub(crate) fn turn(axis: [f64; 3], angle_rad: f64) -> Rotation {
    known(Rotation::from_axis_angle(axis, angle_rad))
}

/// The Hamilton quaternion of a rotation, body to world.
pub(crate) fn hamilton(rotation: &Rotation) -> Quaternion<f64> {
    rotation.to_tagged(Convention::HAMILTON).components
}

/// The quaternion `(0, v)`.
pub(crate) fn pure(vector: &Vector3<f64>) -> Quaternion<f64> {
    Quaternion::from_imag(*vector)
}
