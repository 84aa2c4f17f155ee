//! What libraries do with four numbers, and how that is known.
//!
//! One record is one library in one version, or one face of a library that has several; or a format, or a
//! device, which may have angles, a vector or a matrix in the place of a quaternion. The records are in
//! `libraries.json`; what was run has its numbers in `observations.json`, and tests compute them
//! again. What is not established is left out, and never guessed.
//!
//! A record says more than the five axes of a [`Convention`](crate::Convention). Libraries of
//! graphics with row vectors have the Shuster product and still rotate by `R(q)`; some of aerospace
//! have the Hamilton product and the transposed matrix. See [`Family`].

/// What a library may do with four numbers.
pub mod behaviour;

mod choices;

/// One end of a translation.
pub mod endpoint;

use crate::convention::angle::AngleUnit;
use crate::convention::family::Family;
use crate::convention::matrix::CosineMatrix;
use crate::convention::order::ComponentOrder;
use crate::convention::side::Side;
use crate::convention::{Direction, Handedness};
use serde::{Deserialize, Serialize};

pub use crate::library::choices::{
    AxisAngleSign, Group, HalfTurns, Known, Language, NonUnitResult, RecordKind, RecordNumbersKind,
    SignChoice, SlerpWay, VectorLayout, ZeroResult,
};

/// Written by `build.rs` from `libraries.json`.
static LIBRARIES: &[Library] = include!(concat!(env!("OUT_DIR"), "/libraries.rs"));

/// What translating and identifying need of the records. A program that does no more, such as the wasm,
/// does not carry the rest of the table.
static ESSENTIALS: [Essentials; LIBRARIES.len()] = {
    let mut essentials = [LIBRARIES[0].essentials(); LIBRARIES.len()];
    let mut at = 0;
    while at < LIBRARIES.len() {
        essentials[at] = LIBRARIES[at].essentials();
        at += 1;
    }
    essentials
};

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
    LIBRARIES
}

/// The record with this id; `None` where there is none.
#[must_use]
pub fn library(id: &str) -> Option<&'static Library> {
    libraries().iter().find(|library| library.id == id)
}

/// The essentials of all records, in the order of the table.
pub(crate) fn essentials() -> &'static [Essentials] {
    &ESSENTIALS
}

/// One library in one version; or a format, or a device.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Library {
    /// The stable name in addresses and requests: small letters, digits and hyphens.
    pub id: &'static str,
    /// What people call it.
    pub name: &'static str,
    /// Other words that find it.
    // In TypeScript a member with a default may be missing, as it may in the file.
    #[serde(default)]
    pub words: &'static [&'static str],
    /// What it is a record of, where that is no library.
    pub kind: Option<RecordKind>,
    /// The field it comes from.
    pub group: Group,
    /// The language of its lines of code.
    pub language: Language,
    /// The version, or the date of the document.
    pub version: &'static str,
    /// How all this is known.
    pub known: Known,
    /// The order of its array: in memory, in messages, as printed where nothing else is said.
    pub array_order: Option<ComponentOrder>,
    /// The order in which it prints four numbers without their names, where that is not the order of
    /// the array.
    pub printed_order: Option<ComponentOrder>,
    /// What it writes for a rotation, where that is no quaternion.
    pub numbers: Option<&'static RecordNumbers>,
    /// The order in which its constructor takes four numbers.
    pub constructor_order: Option<ComponentOrder>,
    /// Its product: right is Hamilton's, left is Shuster's.
    pub handedness: Option<Handedness>,
    /// What its call that rotates a vector multiplies the vector with: `R(q)` or `C(q)`; of a format or a
    /// device, what its quaternion stands for.
    pub rotate: Option<CosineMatrix>,
    /// What its matrix of a quaternion is, as printed row by row.
    pub matrix: Option<CosineMatrix>,
    /// Which vectors its matrices are for.
    pub vectors: Option<VectorLayout>,
    /// From which frame to which its quaternion leads, or else its [`RecordNumbers`], where that is known. A
    /// camera, a tool, a sensor, a crystal is a body; the scene, the base, the specimen is the world.
    pub direction: Option<Direction>,
    /// Which axes its numbers are for, where they are its own: their hand, and where they point.
    pub axes: Option<&'static str>,
    /// Its calls with Euler angles, the usual one first.
    #[serde(default)]
    pub euler: &'static [EulerCall],
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
    pub pasted: &'static [&'static str],
    /// Which calls were run.
    pub calls: Option<&'static str>,
    /// What was read, where nothing was run.
    pub source: Option<Source>,
    /// What surprises people.
    pub note: Option<&'static str>,
    /// What is uncertain of it, and why.
    pub doubt: Option<&'static str>,
}

/// The numbers that stand for a rotation where no quaternion does.
///
/// They say the rotation that takes the coordinates of [`Library::direction`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RecordNumbers {
    /// What they are.
    pub kind: RecordNumbersKind,
    /// What they are called, in their order, with spaces between.
    pub names: Option<&'static str>,
    /// Of three angles a, b, c in their order: the rotation for column vectors as a product, as
    /// [`EulerCall::means`] has it.
    pub means: Option<&'static str>,
    /// The unit of its angles.
    pub unit: Option<AngleUnit>,
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
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct EulerCall {
    /// The call, with the angles in its own order; in radians unless it says degrees.
    pub call: &'static str,
    /// The rotation for column vectors as a product, the factor that acts first on the right:
    /// `Rz(a) Ry(b) Rx(c)`.
    pub means: &'static str,
}

/// The calls of a library, one line each; `q`, `a`, `b` are its quaternions, `v` is a vector.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Code {
    /// Four numbers to a quaternion; `{w}`, `{x}`, `{y}`, `{z}` stand for the numbers.
    pub construct: Option<&'static str>,
    /// The vector rotated by the quaternion.
    pub rotate: Option<&'static str>,
    /// The matrix of the quaternion.
    pub matrix: Option<&'static str>,
    /// The product of two quaternions.
    pub product: Option<&'static str>,
    /// The quaternion of a matrix `M`.
    pub from_matrix: Option<&'static str>,
    /// The four numbers of the quaternion.
    pub print: Option<&'static str>,
}

/// What was read.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Source {
    /// What it says.
    pub text: &'static str,
    /// Where it says so.
    pub url: Option<&'static str>,
}

/// What translating and identifying need of a record.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Essentials {
    pub(crate) id: &'static str,
    pub(crate) kind: Option<RecordKind>,
    pub(crate) language: Language,
    pub(crate) array_order: Option<ComponentOrder>,
    pub(crate) printed_order: Option<ComponentOrder>,
    pub(crate) numbers: Option<&'static RecordNumbers>,
    pub(crate) constructor_order: Option<ComponentOrder>,
    pub(crate) handedness: Option<Handedness>,
    pub(crate) rotate: Option<CosineMatrix>,
    pub(crate) matrix: Option<CosineMatrix>,
    pub(crate) vectors: Option<VectorLayout>,
    pub(crate) direction: Option<Direction>,
    /// [`Code::construct`]
    pub(crate) construct: Option<&'static str>,
    /// What usually follows: a vector is rotated, or else the matrix made.
    pub(crate) usual: Option<&'static str>,
    pub(crate) pasted: &'static [&'static str],
}

impl Library {
    pub(crate) const fn essentials(&self) -> Essentials {
        Essentials {
            id: self.id,
            kind: self.kind,
            language: self.language,
            array_order: self.array_order,
            printed_order: self.printed_order,
            numbers: self.numbers,
            constructor_order: self.constructor_order,
            handedness: self.handedness,
            rotate: self.rotate,
            matrix: self.matrix,
            vectors: self.vectors,
            direction: self.direction,
            construct: self.code.construct,
            usual: match self.code.rotate {
                None => self.code.matrix,
                rotate => rotate,
            },
            pasted: self.pasted,
        }
    }

    /// The order in which its numbers are usually met: as it prints them, or else that of the array, or
    /// else of the constructor.
    ///
    /// ```
    /// use quatlas::{ComponentOrder, library};
    ///
    /// // In a USD file the scalar stands first, in the memory of a Gf.Quatd last.
    /// let usd = library("usd").unwrap();
    /// assert_eq!(usd.array_order, Some(ComponentOrder::ScalarLast));
    /// assert_eq!(usd.order(), Some(ComponentOrder::ScalarFirst));
    /// ```
    #[must_use]
    pub fn order(&self) -> Option<ComponentOrder> {
        self.essentials().order()
    }

    /// What the quaternion multiplies a column vector with when it acts: by the call that rotates, or
    /// else by the matrix as it is applied to vectors.
    #[must_use]
    pub fn action(&self) -> Option<CosineMatrix> {
        self.essentials().action()
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

impl Essentials {
    /// [`Library::order`]
    pub(crate) fn order(&self) -> Option<ComponentOrder> {
        self.printed_order
            .or(self.array_order)
            .or(self.constructor_order)
    }

    /// [`Library::action`]
    pub(crate) fn action(&self) -> Option<CosineMatrix> {
        self.rotate.or_else(|| {
            let matrix = self.matrix?;
            Some(match self.vectors? {
                VectorLayout::Column => matrix,
                VectorLayout::Row => matrix.transposed(),
            })
        })
    }
}

/// Whether matrices that libraries of a language print as lists of lists may be lists of columns.
pub(crate) const fn stores_columns(language: Language) -> bool {
    matches!(language, Language::C | Language::Cpp | Language::Rust)
}
