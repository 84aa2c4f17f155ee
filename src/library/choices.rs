//! The choices of a record that have no meaning outside of it.
//!
//! The build script reads the records with these very types, so nothing else is used here.

use serde::{Deserialize, Serialize};

/// What a record is of, where that is no library.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum RecordKind {
    /// A file, a message, a notation.
    Format,
    /// A device, or the controller of one.
    Device,
}

/// The field a library comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum Group {
    /// Robotics and ROS.
    Robotics,
    /// State estimation and mapping.
    Estimation,
    /// Simulation and physics.
    Simulation,
    /// Graphics and games.
    Graphics,
    /// Aircraft and spacecraft.
    Aerospace,
    /// Mathematics and science.
    Mathematics,
    /// Devices and formats.
    Devices,
}

/// A language of code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum Language {
    /// C.
    C,
    /// C++.
    Cpp,
    /// C#.
    Csharp,
    /// Java.
    Java,
    /// JavaScript and TypeScript.
    Javascript,
    /// MATLAB.
    Matlab,
    /// No language: a message or a file.
    Message,
    /// Python.
    #[default]
    Python,
    /// Rust.
    Rust,
    /// Swift.
    Swift,
}

/// How the behaviour of a library is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum Known {
    /// It was run, and printed the numbers that are recorded.
    Run,
    /// Its source was read.
    Read,
    /// Its documentation says so.
    Documented,
}

/// What a rotation is written as, where that is no quaternion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum RecordNumbersKind {
    /// Three angles about axes.
    EulerAngles,
    /// Three numbers: the axis times the angle.
    RotationVector,
    /// Four numbers: a unit axis, and then the angle.
    AxisAngle,
    /// The nine numbers of a matrix, perhaps with a translation beside them.
    Matrix,
}

/// Which vectors a library's matrices are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum VectorLayout {
    /// Columns, on the right of the matrix: `M v`.
    Column,
    /// Rows, on the left of the matrix: `v M`.
    Row,
}

/// The sign of z in the quaternion of a positive turn about +z.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum AxisAngleSign {
    /// As in `(cos θ/2, sin θ/2 n)`.
    Positive,
    /// The other one.
    Negative,
}

/// Which way slerp goes between `a` and `−b`, by default.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum SlerpWay {
    /// The same as between `a` and `b`: the shorter one.
    Short,
    /// As the signs say, even if that is the longer one.
    Long,
}

/// What comes of a quaternion of norm 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum NonUnitResult {
    /// For a constructor: it is kept.
    Kept,
    /// As from the unit quaternion.
    Normalised,
    /// Four times as large as from the unit quaternion.
    Scaled,
    /// Something that is no rotation times a factor.
    Distorted,
    /// For a constructor: something else.
    Changed,
    /// An error.
    Refused,
}

/// What comes of the zero quaternion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum ZeroResult {
    /// For a constructor: zeros are kept.
    Kept,
    /// The identity: of quaternions, of matrices, or the vector as it was.
    Identity,
    /// Minus the identity matrix.
    MinusIdentity,
    /// Half a turn.
    HalfTurn,
    /// Zeros.
    Zero,
    /// No number: NaN or infinity.
    Nan,
    /// An error.
    Refused,
    /// Something else.
    Other,
}

/// Which of q and −q comes out of a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum SignChoice {
    /// The one whose scalar part is not negative.
    ScalarNonNegative,
    /// The one whose largest component is positive, so the scalar part can be negative.
    LargestPositive,
    /// No rule that the runs show.
    Mixed,
}

/// Whether matrices of half turns come back right.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum HalfTurns {
    /// All five that were tried.
    Right,
    /// At least one was wrong, no number, or an error.
    Wrong,
}
