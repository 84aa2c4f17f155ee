//! One attitude in the report: as it was read, and in every representation.

use crate::convention::euler_sequence::EulerSequence;
use crate::convention::matrix::{CosineMatrix, MatrixConvention};
use crate::convention::order::OrderSource;
use crate::convention::presets::NamedConvention;
use crate::convention::side::Side;
use crate::convention::{Convention, Direction};
use crate::rotation::euler::Survivor;
use serde::{Deserialize, Serialize};

/// An attitude as it was read from text, as a quaternion of the declared convention.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ReadQuaternion {
    /// What the text describes the attitude by.
    pub form: Form,
    /// The four numbers, stored in the order that was used; of norm 1 where the text is no
    /// quaternion.
    pub components: Components,
    /// How the text told which number is which.
    pub order_source: OrderSource,
    /// The convention that was used: the declared one, with the order that the text told.
    pub convention: Convention,
    /// The square root of the sum of squares; absent where a double cannot hold it.
    pub norm: Option<f64>,
}

/// What a text describes an attitude by.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Form {
    /// Four components.
    Quaternion,
    /// An axis and an angle about it.
    AxisAngle(ReadAxisAngle),
    /// A rotation vector.
    RotationVector(ReadRotationVector),
    /// A half-angle vector.
    HalfAngleVector(ReadHalfAngleVector),
    /// A Gibbs vector.
    GibbsVector(ReadGibbsVector),
    /// Modified Rodrigues parameters.
    ModifiedRodrigues(ReadModifiedRodrigues),
    /// Three angles about the axes of a sequence.
    EulerAngles(ReadEulerAngles),
    /// Nine numbers, row by row.
    Matrix(ReadMatrix),
}

/// The data of [`Form::AxisAngle`], as typed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ReadAxisAngle {
    /// The axis, of any length.
    pub axis: [f64; 3],
    /// The angle, of any size.
    pub angle_rad: f64,
}

/// The data of [`Form::RotationVector`], as typed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ReadRotationVector {
    /// Angle times axis, of any length.
    pub vector_rad: [f64; 3],
}

/// The data of [`Form::HalfAngleVector`], as typed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ReadHalfAngleVector {
    /// Half the angle times axis, of any length.
    pub vector_rad: [f64; 3],
}

/// The data of [`Form::GibbsVector`], as typed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ReadGibbsVector {
    /// tan(angle/2) times axis, of any length.
    pub vector: [f64; 3],
}

/// The data of [`Form::ModifiedRodrigues`], as typed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ReadModifiedRodrigues {
    /// tan(angle/4) times axis, of any length.
    pub parameters: [f64; 3],
}

/// The data of [`Form::EulerAngles`], as typed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ReadEulerAngles {
    /// The axes and whether they move.
    pub sequence: EulerSequence,
    /// The angles in the order of the sequence, of any size.
    pub angles_rad: [f64; 3],
}

/// The data of [`Form::Matrix`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ReadMatrix {
    /// The matrix as typed.
    pub rows: [[f64; 3]; 3],
    /// What it was declared to be.
    pub convention: MatrixConvention,
    /// The largest magnitude among the entries of `MᵀM − I`.
    pub orthogonality_error: f64,
    /// The Frobenius norm of its difference from the nearest rotation, which was used.
    pub correction: f64,
}

/// What a convention multiplies in which order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Rules {
    /// Whether the components are those of the Hamilton quaternion body to world (σ = +1) or of its
    /// conjugate (σ = −1).
    pub is_canonical: bool,
    /// Which coordinates `q∘v∘q⁻¹` takes to which: its matrix is `R_WB` or `R_BW`.
    pub operator: Direction,
    /// In `q_AC` made of `q_AB` and `q_BC`, by their labels: the side on which `q_AB` stands.
    pub labelled_first: Side,
    /// In the quaternion of C in W made of that of B in W and that of C in B: the side on which that
    /// of B in W stands.
    pub chain_first: Side,
    /// The side on which a small turn of the body multiplies.
    pub increment: Side,
    /// The side on which the body's angular velocity stands in the derivative.
    pub body_rate: Side,
}

/// What a convention is called and what it does, whatever the attitude.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ConventionDescription {
    /// Its name, whichever its perturbation is; absent where it has none.
    pub named: Option<NamedConvention>,
    /// Hamilton or JPL, where the numbers are the same as of that preset but for their places.
    pub preset: Option<NamedConvention>,
    /// The direction of `R(q)` of these numbers; `C(q)` has the other one.
    pub hamilton_matrix: Direction,
    /// The convention in which the conjugate of a quaternion is the same attitude.
    pub reversed: Convention,
    /// What it multiplies in which order.
    pub rules: Rules,
}

/// The matrix of the attitude in the convention that nine numbers are declared in: with the declared
/// convention of four numbers, a pairing (specification, section 1.7 and MODEL-09).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PairedMatrix {
    /// The function and direction of the matrix.
    pub convention: MatrixConvention,
    /// Row by row.
    pub rows: [[f64; 3]; 3],
    /// `R(q)` or `C(q)` of the declared quaternion's own numbers.
    pub form: CosineMatrix,
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
    /// The matrix of `v ↦ q∘v∘q⁻¹`: R(q) for Hamilton, body to world; C(q) for JPL, world to body.
    pub matrix: [[f64; 3]; 3],
    /// Its inverse, which is its transpose.
    pub inverse_matrix: [[f64; 3]; 3],
    /// `matrix` times `v`; absent where a double cannot hold it, and where nothing is asked of a vector.
    pub image: Option<[f64; 3]>,
    /// The matrix L of `q∘p = L p` for `quaternion` with its norm, on arrays in this column's order
    /// (Yoosefian 2021, eqs. 7 and 13).
    pub left_product_matrix: [[f64; 4]; 4],
    /// The matrix R of `p∘q = R p` for `quaternion` with its norm, on arrays in this column's order
    /// (Yoosefian 2021, eqs. 6 and 14).
    pub right_product_matrix: [[f64; 4]; 4],
    /// What this convention multiplies in which order.
    pub rules: Rules,
    /// The name of this convention, whichever its perturbation is; absent where it has none.
    pub named: Option<NamedConvention>,
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
    /// The square root of the sum of the squares; absent where a double cannot hold it.
    pub norm: Option<f64>,
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
    /// tan(angle/2) times axis; absent at half a turn, where it is infinite.
    pub gibbs_vector: Option<[f64; 3]>,
    /// tan(angle/4) times axis.
    pub modified_rodrigues_parameters: [f64; 3],
}

/// An attitude as Euler angles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Euler {
    /// The axes and whether they move.
    pub sequence: EulerSequence,
    /// The angles in the order of the sequence, in radians; at gimbal lock the canonical ones.
    pub angles_rad: [f64; 3],
    /// The same angles in degrees.
    pub angles_deg: [f64; 3],
    /// Present at gimbal lock, where only a sum or difference of the outer angles is determined.
    pub gimbal_lock: Option<ReadGimbalLock>,
    /// Present near gimbal lock, but not at it: how far the middle angle is from it, in degrees.
    pub near_lock_deg: Option<f64>,
    /// Present at gimbal lock and near it: a sequence of the same frame that is far from its own lock
    /// at this attitude, about the same axes where there is one.
    pub free_sequence: Option<EulerSequence>,
}

/// What is left of the outer angles at gimbal lock.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ReadGimbalLock {
    /// Whether first plus third or first minus third survives.
    pub survivor: Survivor,
    /// That sum or difference, in degrees.
    pub survivor_deg: f64,
    /// The place of the angle that was set to 0: 0 or 2.
    pub lost: usize,
    /// How far the middle angle is from the lock, in degrees.
    pub distance_deg: f64,
}
