//! What is answered: plain numbers and names, the source of the TypeScript types.
//!
//! No number here is NaN, infinite or −0. A number that a double cannot hold is
//! absent, and a [`Note`] says so. A matrix is a list of its rows, and multiplies a column from the
//! left.

use crate::convention::{ComponentOrder, Convention, Direction};
use crate::problem::{Field, Problem};
use nalgebra::{Matrix3, Matrix4, Quaternion, Vector3};
use serde::{Deserialize, Serialize};

/// A report, or the problems that stand in its way.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(tag = "status", rename_all = "kebab-case")]
pub enum Outcome {
    /// The answer to a [`Request::Read`](crate::Request::Read).
    Read(Box<ReadReport>),
    /// The answer to a [`Request::Compose`](crate::Request::Compose).
    Compose(Box<ComposeReport>),
    /// At least one text could not be read; every text's first problem is here.
    Problems(Problems),
}

/// Every text's first problem, in the order of the request.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Problems {
    /// At least one.
    pub problems: Vec<Problem>,
}

/// What one quaternion means in both conventions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ReadReport {
    /// The quaternion as it was read, before anything was done to it.
    pub quaternion: ReadQuaternion,
    /// The vector `x` as it was read.
    pub vector: [f64; 3],
    /// The attitude as a Hamilton quaternion, body to world.
    pub hamilton: Column,
    /// The same attitude as a JPL quaternion, world to body.
    pub jpl: Column,
    /// The JPL quaternion whose matrix is the Hamilton column's, body to world: the conjugate
    /// (Yoosefian 2021, eq. 18).
    pub jpl_with_same_matrix: Components,
    /// The turn that carries the world axes onto the body axes; it is the same in every
    /// convention.
    pub turn: Turn,
    /// What a careful reader should know about this input.
    pub notes: Vec<Note>,
}

/// A quaternion as it was read from text.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ReadQuaternion {
    /// The four numbers, stored in the order that was used.
    pub components: Components,
    /// How the text told which number is which.
    pub order_source: OrderSource,
    /// The convention that was used: the declared one, with the order that the text told.
    pub convention: Convention,
    /// The square root of the sum of squares; absent where a double cannot hold it.
    pub norm: Option<f64>,
}

/// How a text told which number is the scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum OrderSource {
    /// It did not: the declared order was used.
    Declared,
    /// By names: `w=`, `x:`, `"y":`, or the units i, j, k.
    Named,
    /// By brackets: `[w, [x, y, z]]` or `[[x, y, z], w]`.
    Grouped,
    /// By a constructor whose order is known, such as `Eigen::Quaterniond`.
    Constructor,
}

/// One attitude in one convention.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Column {
    /// The convention of every number below.
    pub convention: Convention,
    /// The quaternion with the norm it was typed with.
    pub quaternion: Components,
    /// The quaternion with norm 1.
    pub unit: Components,
    /// The conjugate of `quaternion`: the vector part changes its sign.
    pub conjugate: Components,
    /// The inverse of `quaternion`, conjugate / norm²; absent where a double cannot hold it.
    pub inverse: Option<Components>,
    /// R(q) for Hamilton, body to world; C(q) for JPL, world to body.
    pub matrix: [[f64; 3]; 3],
    /// Its inverse, which is its transpose.
    pub inverse_matrix: [[f64; 3]; 3],
    /// `matrix` times `x`; absent where a double cannot hold it.
    pub image: Option<[f64; 3]>,
    /// The matrix of `p ↦ q∘p` for the unit quaternion, on arrays in this column's order.
    pub left_product_matrix: [[f64; 4]; 4],
    /// The matrix of `p ↦ p∘q` for the unit quaternion, on arrays in this column's order.
    pub right_product_matrix: [[f64; 4]; 4],
}

/// Four components by name, and as an array in the order of the convention beside them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Components {
    /// The scalar part.
    pub w: f64,
    /// The coefficient of i.
    pub x: f64,
    /// The coefficient of j.
    pub y: f64,
    /// The coefficient of k.
    pub z: f64,
    /// The same four numbers in the order of the convention.
    pub array: [f64; 4],
}

/// A right-handed turn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Turn {
    /// The angle in radians, from 0 to π.
    pub angle_rad: f64,
    /// The same angle in degrees, from 0 to 180.
    pub angle_deg: f64,
    /// The axis, of length 1, with the same coordinates in world and body; absent where the angle
    /// is 0.
    pub axis: Option<[f64; 3]>,
    /// Angle times axis, in radians.
    pub rotation_vector_rad: [f64; 3],
}

/// What two quaternions make together, in both products and both orders.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ComposeReport {
    /// The left operand as it was read.
    pub p: ReadQuaternion,
    /// The right operand as it was read.
    pub q: ReadQuaternion,
    /// The vector `x` as it was read.
    pub vector: [f64; 3],
    /// p ⊙ q, q ⊙ p, p ⊗ q, q ⊗ p.
    pub products: Vec<Product>,
    /// Whether the order of the two matters.
    pub order_matters: OrderMatters,
    /// What a careful reader should know about these inputs.
    pub notes: Vec<Note>,
}

/// Whether p∘q and q∘p are the same quaternion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum OrderMatters {
    /// They differ.
    Yes,
    /// They are the same: the axes are parallel, or one of the two is no turn.
    No,
    /// They are q and −q: two quaternions of one rotation (half turns about perpendicular axes).
    OnlyInSign,
}

/// One of the two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum Operand {
    /// The quaternion that was typed as p.
    P,
    /// The quaternion that was typed as q.
    Q,
}

/// A frame of a composition.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum Frame {
    /// W, the world.
    World,
    /// B, the body.
    Body,
    /// C, a second body whose attitude is given relative to B.
    SecondBody,
}

/// One product of p and q.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Product {
    /// Hamilton, whose product is ⊙, or JPL, whose product is ⊗.
    pub convention: Convention,
    /// The operand on the left of the sign.
    pub left: Operand,
    /// The operand on the right of the sign. It acts on a vector first.
    pub right: Operand,
    /// The product.
    pub quaternion: Components,
    /// R(left ⊙ right) = R(left) R(right), or C(left ⊗ right) = C(left) C(right).
    pub matrix: [[f64; 3]; 3],
    /// `x` after the right operand, then after both; absent where a double cannot hold it.
    pub images: Option<[[f64; 3]; 2]>,
    /// Which frame's coordinates to which the matrix takes.
    pub direction: Direction,
    /// The frames on the way of a vector: where it starts, where the two meet, where it ends.
    pub frames: [Frame; 3],
    /// The operand whose turn comes first when every turn is about the fixed axes; about the
    /// moving axes it is the other one.
    pub first_about_fixed_axes: Operand,
    /// The places in the list of products that have the same quaternion, this one included.
    pub equal_to: Vec<usize>,
}

/// One thing worth knowing, as data; the page has the words.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Note {
    /// Which text it is about.
    pub field: Field,
    /// What there is to know.
    pub fact: Fact,
}

/// What a [`Note`] says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Fact {
    /// The norm is not 1, so the numbers were divided by it.
    Normalised(Normalised),
    /// The text tells its own order, which is not the declared one.
    OrderFromText(OrderFromText),
    /// The order cannot be told from the text, and the other order is another rotation.
    OrderAssumed(OrderAssumed),
    /// Both orders give the same rotation, so this input cannot show which one is used.
    OrderInvisible,
    /// The text is a call whose order is not known here.
    UnknownConstructor(UnknownConstructor),
    /// The scalar is negative: −q is the same rotation and names the shorter turn.
    NegativeScalar,
    /// The rotation is none: every axis is as good, so none is given.
    NoTurn,
    /// Half a turn: the axis and its opposite describe the same rotation.
    HalfTurn,
    /// Some number is beyond what a double can hold and is left out.
    OutOfRange(OutOfRange),
}

/// The data of [`Fact::Normalised`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Normalised {
    /// The norm as typed; absent where a double cannot hold it.
    pub norm: Option<f64>,
    /// The norm minus 1; absent where the norm is.
    pub deviation: Option<f64>,
}

/// The data of [`Fact::OrderFromText`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct OrderFromText {
    /// How it was told.
    pub source: OrderSource,
    /// The order that was used.
    pub order: ComponentOrder,
}

/// The data of [`Fact::OrderAssumed`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct OrderAssumed {
    /// The order that was used.
    pub order: ComponentOrder,
    /// How far away the rotation is that the other order gives, in degrees.
    pub other_order_differs_by_deg: f64,
}

/// The data of [`Fact::UnknownConstructor`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct UnknownConstructor {
    /// The name as typed.
    pub name: String,
    /// The order that was used: the declared one.
    pub order: ComponentOrder,
}

/// The data of [`Fact::OutOfRange`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct OutOfRange {
    /// Which number is left out.
    pub what: OutOfRangeNumber,
}

/// A number that a double may be unable to hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum OutOfRangeNumber {
    /// The norm.
    Norm,
    /// The inverse quaternion.
    Inverse,
    /// The turned vector.
    Image,
    /// The product of the quaternions as typed; the product of the unit quaternions is given.
    Product,
}

impl Outcome {
    /// The same outcome with every span counted in UTF-16 units of the text it points into.
    #[must_use]
    pub fn in_utf16(mut self, text_of: impl Fn(Field) -> String) -> Self {
        if let Self::Problems(Problems { problems }) = &mut self {
            for problem in problems {
                problem.span = problem.span.in_utf16(&text_of(problem.field));
            }
        }
        self
    }
}

/// The number itself, with −0 written as 0.
pub(crate) fn plain(number: f64) -> f64 {
    number + 0.0
}

impl Components {
    pub(crate) fn of(quaternion: &Quaternion<f64>, order: ComponentOrder) -> Self {
        let [w, x, y, z] = [quaternion.w, quaternion.i, quaternion.j, quaternion.k].map(plain);
        let array = match order {
            ComponentOrder::ScalarFirst => [w, x, y, z],
            ComponentOrder::ScalarLast => [x, y, z, w],
        };
        Self { w, x, y, z, array }
    }
}

pub(crate) fn coordinates(vector: &Vector3<f64>) -> [f64; 3] {
    [vector.x, vector.y, vector.z].map(plain)
}

pub(crate) fn rows3(matrix: &Matrix3<f64>) -> [[f64; 3]; 3] {
    matrix.transpose().map(plain).into()
}

pub(crate) fn rows4(matrix: &Matrix4<f64>) -> [[f64; 4]; 4] {
    matrix.transpose().map(plain).into()
}
