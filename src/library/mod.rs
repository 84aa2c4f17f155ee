//! What libraries do with four numbers, and how that is known.
//!
//! One record is one library in one version, or one face of a library that has several. The records are
//! in `libraries.json`; what was run has its numbers in `observations.json`, and tests compute them
//! again. What is not established is left out, and never guessed.
//!
//! A record says more than the five axes of a [`Convention`](crate::Convention). Libraries of
//! graphics with row vectors have the Shuster product and still rotate by `R(q)`; some of aerospace
//! have the Hamilton product and the transposed matrix. See [`Family`].

/// What a library may do with four numbers.
pub mod behaviour;

/// One end of a translation.
pub mod endpoint;

use crate::convention::family::Family;
use crate::convention::matrix::CosineMatrix;
use crate::convention::order::ComponentOrder;
use crate::convention::side::Side;
use crate::convention::{Direction, Handedness};
use serde::{Deserialize, Serialize};
use std::sync::LazyLock;

/// The table as text.
pub(crate) const TABLE: &str = include_str!("libraries.json");

static LIBRARIES: LazyLock<Vec<Library>> = LazyLock::new(|| {
    #[expect(
        clippy::expect_used,
        reason = "the table is part of the program, and a test reads all of it"
    )]
    serde_json::from_str(TABLE).expect("every record of libraries.json is of the type Library")
});

/// All records, in the order of the table.
///
/// ```
/// use quatlas::{CosineMatrix, Handedness, Side, libraries, library};
///
/// // DirectXMath has JPL's product and is not JPL: it rotates by R(q), and the left operand acts first.
/// let directx = library("directxmath").unwrap();
/// assert_eq!(directx.handedness, Some(Handedness::Left));
/// assert_eq!(directx.rotate, Some(CosineMatrix::Hamilton));
/// assert_eq!(directx.first_to_act(), Some(Side::Left));
/// assert!(libraries().len() >= 60);
/// ```
#[must_use]
pub fn libraries() -> &'static [Library] {
    &LIBRARIES
}

/// The record with this id; `None` where there is none.
#[must_use]
pub fn library(id: &str) -> Option<&'static Library> {
    libraries().iter().find(|library| library.id == id)
}

/// One library in one version.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Library {
    /// The stable name in addresses and requests: small letters, digits and hyphens.
    pub id: String,
    /// What people call it.
    pub name: String,
    /// Other words that find it.
    #[serde(default)]
    pub words: Vec<String>,
    /// The field it comes from.
    pub group: Group,
    /// The language of its lines of code.
    pub language: Language,
    /// The version, or the date of the document.
    pub version: String,
    /// How all this is known.
    pub known: Known,
    /// The order of its array: in memory, in messages, as printed.
    pub array_order: Option<ComponentOrder>,
    /// The order in which its constructor takes four numbers.
    pub constructor_order: Option<ComponentOrder>,
    /// Its product: right is Hamilton's, left is Shuster's.
    pub handedness: Option<Handedness>,
    /// What its call that rotates a vector multiplies the vector with: `R(q)` or `C(q)`.
    pub rotate: Option<CosineMatrix>,
    /// What its matrix of a quaternion is, as printed row by row.
    pub matrix: Option<CosineMatrix>,
    /// Which vectors its matrices are for.
    pub vectors: Option<VectorLayout>,
    /// From which frame to which its quaternion leads, where its documentation says so.
    pub direction: Option<Direction>,
    /// Its calls with Euler angles, the usual one first.
    #[serde(default)]
    pub euler: Vec<EulerCall>,
    /// The sign of z in its quaternion of a positive turn about +z.
    pub axis_angle: Option<AxisAngleSign>,
    /// What it does with a quaternion of norm 2.
    #[serde(default)]
    pub non_unit: NonUnit,
    /// What it does with the zero quaternion.
    #[serde(default)]
    pub zero: Zero,
    /// How it makes a quaternion of a matrix.
    pub matrix_to_quaternion: Option<MatrixToQuaternion>,
    /// Which way its slerp goes by default.
    pub slerp: Option<SlerpWay>,
    /// Its calls as one writes them.
    #[serde(default)]
    pub code: Code,
    /// Fragments of pasted code that mean this library.
    #[serde(default)]
    pub pasted: Vec<String>,
    /// Which calls were run.
    pub calls: Option<String>,
    /// What was read, where nothing was run.
    pub source: Option<Source>,
    /// What surprises people.
    pub note: Option<String>,
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

/// What a library does with a quaternion of norm 2.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct NonUnit {
    /// The constructor.
    pub construct: Option<NonUnitResult>,
    /// The matrix of it.
    pub matrix: Option<NonUnitResult>,
    /// A vector that it rotates.
    pub rotate: Option<NonUnitResult>,
}

/// What a library does with the zero quaternion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct Zero {
    /// The constructor.
    pub construct: Option<ZeroResult>,
    /// The matrix of it.
    pub matrix: Option<ZeroResult>,
    /// A vector that it rotates.
    pub rotate: Option<ZeroResult>,
    /// Normalising it.
    pub normalize: Option<ZeroResult>,
    /// Its inverse.
    pub inverse: Option<ZeroResult>,
}

/// How a library makes a quaternion of a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct MatrixToQuaternion {
    /// Which of q and −q it gives.
    pub sign: SignChoice,
    /// What becomes of half turns.
    pub half_turns: HalfTurns,
}

/// A call with three angles a, b, c.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct EulerCall {
    /// The call, with the angles in its own order; in radians unless it says degrees.
    pub call: String,
    /// The rotation for column vectors as a product, the factor that acts first on the right:
    /// `Rz(a) Ry(b) Rx(c)`.
    pub means: String,
}

/// The calls of a library, one line each; `q`, `a`, `b` are its quaternions, `v` is a vector.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Code {
    /// Four numbers to a quaternion; `{w}`, `{x}`, `{y}`, `{z}` stand for the numbers.
    pub construct: Option<String>,
    /// The vector rotated by the quaternion.
    pub rotate: Option<String>,
    /// The matrix of the quaternion.
    pub matrix: Option<String>,
    /// The product of two quaternions.
    pub product: Option<String>,
    /// The quaternion of a matrix `M`.
    pub from_matrix: Option<String>,
    /// The four numbers of the quaternion.
    pub print: Option<String>,
}

/// What was read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// What it says.
    pub text: String,
    /// Where it says so.
    pub url: Option<String>,
}

impl Library {
    /// The order in which its numbers are usually met: that of the array, or else of the constructor.
    #[must_use]
    pub fn order(&self) -> Option<ComponentOrder> {
        self.array_order.or(self.constructor_order)
    }

    /// What the quaternion multiplies a column vector with when it acts: by the call that rotates, or
    /// else by the matrix as it is applied to vectors.
    #[must_use]
    pub fn action(&self) -> Option<CosineMatrix> {
        self.rotate.or_else(|| {
            let matrix = self.matrix?;
            Some(match self.vectors? {
                VectorLayout::Column => matrix,
                VectorLayout::Row => matrix.transposed(),
            })
        })
    }

    /// The operand of `a * b` that acts first on a vector.
    #[must_use]
    pub fn first_to_act(&self) -> Option<Side> {
        self.family().map(Family::first_to_act)
    }

    /// How its product and its rotation belong together.
    #[must_use]
    pub fn family(&self) -> Option<Family> {
        Some(Family::of(self.handedness?, self.action()?))
    }
}

/// Whether matrices that libraries of a language print as lists of lists may be lists of columns.
pub(crate) const fn stores_columns(language: Language) -> bool {
    matches!(language, Language::C | Language::Cpp | Language::Rust)
}
