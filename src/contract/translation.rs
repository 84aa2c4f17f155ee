//! What a translation answers.

use crate::contract::attitude::{Components, ReadQuaternion, Turn};
use crate::contract::note::Note;
use crate::convention::angle::AngleUnit;
use crate::convention::family::Family;
use crate::convention::matrix::CosineMatrix;
use crate::convention::names::serialized_by_name;
use crate::convention::order::ComponentOrder;
use crate::convention::side::Side;
use crate::convention::{ComponentSign, Convention, Direction, Handedness};
use crate::frames::axis_mapping::{AxesHand, AxisMapping};
use crate::library::endpoint::Assumption;
use crate::library::{RecordNumbersKind, VectorLayout};
use serde::{Deserialize, Serialize};
use strum::VariantNames;

/// One attitude at both ends of a translation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct TranslateReport {
    /// The attitude as it was read.
    pub quaternion: ReadQuaternion,
    /// The end that it comes from.
    pub from: TranslatedEnd,
    /// The end that it goes to.
    pub to: TranslatedEnd,
    /// What is done to the four numbers on the way.
    pub change: Change,
    /// What goes wrong if a needed step is forgotten, or one is done that is not needed.
    pub mistakes: Vec<Mistake>,
    /// How `a * b` of the first end is written at the second.
    pub product: ProductOrder,
    /// The change of axes, where one was asked for.
    pub axes: Option<AxesReport>,
    /// The turn that carries the world axes onto the body axes, at the first end.
    pub turn: Turn,
    /// The id of the library whose call was pasted, where it is not the one at the first end.
    pub proposed: Option<String>,
    /// What a careful reader should know about the text.
    pub notes: Vec<Note>,
}

/// One attitude as one end writes it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct TranslatedEnd {
    /// The id of the library; absent for a convention.
    pub library: Option<String>,
    /// The convention as it was chosen; of a library, the one that these numbers follow: order,
    /// direction, and the hand that belongs to what the quaternion does to a vector.
    pub convention: Convention,
    /// The four numbers by name.
    pub components: Components,
    /// The four numbers in their order.
    pub array: [f64; 4],
    /// That order.
    pub order: ComponentOrder,
    /// The order of the constructor's arguments, where it is known.
    pub constructor_order: Option<ComponentOrder>,
    /// Whether the numbers are those of the body-to-world Hamilton quaternion or of its conjugate.
    pub sign: ComponentSign,
    /// The product; absent where it is not established.
    pub handedness: Option<Handedness>,
    /// What the quaternion multiplies a column vector with when it acts: `R(q)` or `C(q)`.
    pub action: CosineMatrix,
    /// Which coordinates to which that takes.
    pub direction: Direction,
    /// How product and action belong together; absent where the product is not established.
    pub family: Option<Family>,
    /// The operand of `a * b` that acts first on a vector; absent where the product is not
    /// established.
    pub first_to_act: Option<Side>,
    /// What this end writes for the attitude, where that is no quaternion. The four numbers are then none
    /// of its own, but those of the same turn by `R(q)`.
    pub numbers: Option<EndNumbers>,
    /// The matrix as this end prints it; absent where that is not established.
    pub matrix: Option<PrintedMatrix>,
    /// The line of code that makes the quaternion, with all digits; absent for a convention.
    pub construct: Option<String>,
    /// The call that usually follows: a vector is rotated, or else the matrix made.
    pub usual: Option<String>,
    /// What is not established for the library and was assumed here.
    pub assumed: Vec<Assumption>,
}

/// What an end writes for an attitude, where that is no quaternion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct EndNumbers {
    /// What they are.
    pub kind: RecordNumbersKind,
    /// What they are called, in their order, with spaces between; absent where they have no names.
    pub names: Option<String>,
    /// The numbers in their order; of a matrix nine of them, row by row.
    pub values: Vec<f64>,
    /// The unit of the angles among them.
    pub unit: Option<AngleUnit>,
}

/// What a library does by itself, whatever the attitude.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct LibraryDescription {
    /// The convention that its numbers follow: order, direction, and the hand that belongs to what the
    /// quaternion does to a vector.
    pub convention: Convention,
    /// The order of its numbers: as it prints them, or else that of its array.
    pub order: ComponentOrder,
    /// What the quaternion multiplies a column vector with when it acts: `R(q)` or `C(q)`.
    pub action: CosineMatrix,
    /// Which coordinates to which that takes.
    pub direction: Direction,
    /// How product and action belong together; absent where the product is not established.
    pub family: Option<Family>,
    /// The operand of `a * b` that acts first on a vector; absent where the product is not
    /// established.
    pub first_to_act: Option<Side>,
    /// What is not established and was assumed here.
    pub assumed: Vec<Assumption>,
}

/// A matrix as a library prints it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PrintedMatrix {
    /// Row by row.
    pub rows: [[f64; 3]; 3],
    /// `R(q)` or `C(q)` of the end's own numbers.
    pub form: CosineMatrix,
    /// Whether it multiplies columns (`M v`) or rows (`v M`).
    pub vectors: VectorLayout,
}

/// What is done to four numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[derive(VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub enum Change {
    /// Nothing: they are copied.
    Copied,
    /// The scalar moves to the other end.
    Reordered,
    /// The vector part changes its sign.
    Conjugated,
    /// Both.
    ReorderedAndConjugated,
}

serialized_by_name!(Change);

/// What may go wrong with a translation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, VariantNames)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum MistakeKind {
    /// The four numbers are copied as they are, though they are to be reordered and conjugated.
    Copied,
    /// The scalar is left where it stood.
    NotReordered,
    /// The sign of the vector part is left as it was.
    NotConjugated,
    /// The sign of the vector part is changed, though it is to stay: the usual mistake with JPL.
    ConjugatedNeedlessly,
    /// The array is passed to a constructor that takes the other order.
    ConstructorOrder,
    /// The axes are left as they were.
    AxesKept,
    /// A small turn or a rate stands on the other side of the quaternion: it is taken for one on the axes
    /// of the other frame.
    OtherSide,
    /// A small turn or a rate has the other sign.
    OtherSign,
    /// The half of the angle in the exponential, or of the rate in the derivative, is forgotten.
    HalfForgotten,
    /// The numbers are in degrees where radians are taken.
    DegreesAsRadians,
}

serialized_by_name!(MistakeKind);

/// What goes wrong, and by how much.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Mistake {
    /// What was done or left out.
    pub kind: MistakeKind,
    /// How far the attitude is then from the right one, from 0 to 180 degrees. At 0 this very
    /// quaternion does not show the mistake.
    pub angle_deg: f64,
}

/// How a product of one end is written at the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[derive(VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub enum ProductOrder {
    /// `a * b` stays `a * b`.
    Same,
    /// `a * b` becomes `b * a`.
    Reversed,
    /// Neither: the axes of world and body change differently, so the product of two attitudes on new
    /// axes is not that of the old ones.
    Neither,
    /// The product of one end is not established.
    NotEstablished,
}

serialized_by_name!(ProductOrder);

/// A change of axes on the way.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct AxesReport {
    /// Of the world axes.
    pub world: MappedAxes,
    /// Of the body axes.
    pub body: MappedAxes,
}

/// A change of the axes of one frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MappedAxes {
    /// Which old axis each new one is.
    pub mapping: AxisMapping,
    /// The same as text, which reads back: `y x -z`.
    pub text: String,
    /// The matrix from old to new coordinates, row by row.
    pub rows: [[f64; 3]; 3],
    /// +1 or −1.
    pub determinant: i8,
    /// Whether the hand of the axes changes.
    pub hand: AxesHand,
}
