//! What is answered of numbers beside an attitude: which description of it they are.

use crate::contract::attitude::ReadQuaternion;
use crate::convention::Direction;
use crate::convention::angle::AngleUnit;
use crate::convention::euler_sequence::{Axis, EulerSequence};
use crate::convention::order::ComponentOrder;
use serde::{Deserialize, Serialize};

/// Which description of an attitude three, four or nine numbers are.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct NumbersReport {
    /// The attitude as it was read; absent where the numbers are names, which hold for any.
    pub quaternion: Option<ReadQuaternion>,
    /// Those that fit, the most usual first; then the others, the nearest first. Only the first few.
    pub readings: Vec<Reading>,
    /// How many readings fit: as many of the first.
    pub fitting: usize,
    /// Whether one alone fits.
    pub decides: bool,
    /// How far the nearest is that does not fit; absent where all do, or where the numbers are names.
    pub margin_deg: Option<f64>,
}

/// One way to read the numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Reading {
    /// What the numbers are.
    pub meaning: NumbersMeaning,
    /// Body to world where they describe the attitude itself; world to body where its inverse: that of
    /// the conjugate, or of the transposed matrix.
    pub direction: Direction,
    /// The world axes that a quaternion or a matrix is on, where they are others.
    pub world: Option<OtherAxes>,
    /// The body axes that it is on, where they are others.
    pub body: Option<OtherAxes>,
    /// The angle of the turn between the attitude and what the numbers are, read so.
    pub off_deg: f64,
    /// The attitude that the numbers are, read so, as a text that says all of it; absent where they are
    /// names.
    pub text: Option<String>,
}

/// What three, four or nine numbers are.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(
    tag = "kind",
    rename_all = "kebab-case",
    rename_all_fields = "camelCase"
)]
pub enum NumbersMeaning {
    /// Euler angles.
    EulerAngles {
        /// About which axes they turn, and whether the axes turn too.
        sequence: EulerSequence,
        /// Their unit.
        unit: AngleUnit,
        /// The axis about which each turns, as they stand: not always in the order of the sequence, as
        /// where a program turns about y, x and z and prints x, y, z.
        turns_about: [Axis; 3],
    },
    /// The axis times the angle.
    RotationVector {
        /// The unit of its length.
        unit: AngleUnit,
    },
    /// The axis times half the angle.
    HalfAngleVector {
        /// The unit of its length.
        unit: AngleUnit,
    },
    /// The axis times the tangent of half the angle.
    GibbsVector,
    /// The axis times the tangent of a quarter of the angle.
    ModifiedRodrigues,
    /// The components of a quaternion.
    Quaternion {
        /// Where its scalar stands.
        order: ComponentOrder,
    },
    /// The entries of a matrix, row by row.
    Matrix {
        /// By what a matrix of columns of length 1 was multiplied.
        scale: f64,
    },
}

/// The same axes under other names or reversed, as a translation takes them.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct OtherAxes {
    /// The new axes in terms of the old: `y x -z`.
    pub axes: String,
    /// What Hamilton's product multiplies by on that side, in the world from the left and in the body from
    /// the right, as a text: `180deg about x`; absent where the hand of the axes changes on this side alone,
    /// which no turn does.
    pub factor: Option<String>,
}
