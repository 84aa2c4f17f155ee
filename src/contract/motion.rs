//! What is asked and answered of an attitude in motion: after a small turn, at a rate, and over time.
//!
//! Lists of quaternions begin with the declared convention, which Hamilton and JPL follow with their own
//! numbers of the same attitude. Lists of plain numbers have the places that their text says.

use crate::contract::attitude::{Components, Euler, ReadQuaternion, Turn};
use crate::contract::note::Note;
use crate::contract::text::Text;
use crate::contract::translation::Mistake;
use crate::convention::Convention;
use crate::convention::euler_sequence::EulerSequence;
use crate::convention::matrix::MatrixConvention;
use crate::convention::side::{IncrementSign, Side};
use crate::motion::kinematics::RateAxes;
use serde::{Deserialize, Serialize};

/// One attitude, and what moves it. A text that is empty is not asked.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct MotionRequest {
    /// The attitude, in any accepted form.
    pub quaternion: Text,
    /// What four numbers are declared to mean; its perturbation tells on whose axes the increment is.
    pub convention: Convention,
    /// What nine numbers are declared to mean; body to world where it is left out.
    #[serde(default)]
    pub matrix: MatrixConvention,
    /// The sequence of the Euler angles whose rates are given; intrinsic ZYX where it is left out.
    #[serde(default)]
    pub euler: EulerSequence,
    /// The angular velocity of the body against the world, right-handed: `0.1 -0.2 0.3`, in `rad/s`, `deg/s`
    /// or `rpm`; without a unit it is in rad/s.
    #[serde(default)]
    pub rate: Text,
    /// The angular velocity at the end of the duration, to which it goes by equal amounts in equal times;
    /// constant where it is empty.
    #[serde(default)]
    pub rate_end: Text,
    /// On whose axes both are; on the body's where it is left out.
    #[serde(default)]
    pub rate_axes: RateAxes,
    /// How long: `10 s`, `500 ms`, `2 min`; without a unit it is in seconds.
    #[serde(default)]
    pub duration: Text,
    /// In how many steps, from 1 to 240; 20 where it is left out.
    #[serde(default = "MotionRequest::usual_steps")]
    pub steps: u32,
    /// A small turn δ, as a rotation vector: `0.02 -0.03 0.05`, in `rad` or `deg`; without a unit it is in
    /// radians.
    #[serde(default)]
    pub increment: Text,
    /// Whether these numbers are the turn of the body, or what the convention's exponential takes; the turn
    /// of the body where it is left out.
    #[serde(default)]
    pub increment_sign: IncrementSign,
    /// A covariance of a vector, or of small turns in rad², on the axes on which the increment is: nine numbers
    /// row by row, the six of the upper triangle, three variances, or one for all three axes.
    #[serde(default)]
    pub covariance: Text,
    /// A point x fixed in the body, in its coordinates.
    #[serde(default)]
    pub point: Text,
}

impl MotionRequest {
    /// The most steps.
    pub const MOST_STEPS: u32 = 240;

    /// The request without an increment, a rate and a duration.
    #[must_use]
    pub fn new(quaternion: &str, convention: Convention) -> Self {
        Self {
            quaternion: quaternion.to_owned(),
            convention,
            matrix: MatrixConvention::default(),
            euler: EulerSequence::default(),
            rate: String::new(),
            rate_end: String::new(),
            rate_axes: RateAxes::default(),
            duration: String::new(),
            steps: Self::usual_steps(),
            increment: String::new(),
            increment_sign: IncrementSign::default(),
            covariance: String::new(),
            point: String::new(),
        }
    }

    pub(crate) const fn usual_steps() -> u32 {
        20
    }
}

/// What a small turn, a rate and time make of one attitude; what was not asked is absent.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MotionReport {
    /// The attitude as it was read.
    pub quaternion: ReadQuaternion,
    /// Where an increment was given: the attitude after it.
    pub increment: Option<IncrementReport>,
    /// Where a rate was given: the derivatives at the beginning.
    pub derivative: Option<DerivativeReport>,
    /// Where a rate and a duration were given: the way of the body.
    pub path: Option<PathReport>,
    /// Where a covariance was given: that on both sets of axes.
    pub covariance: Option<CovarianceReport>,
    /// Where a point was given: how its image changes.
    pub point: Option<PointReport>,
    /// What a careful reader should know about these texts.
    pub notes: Vec<Note>,
}

/// One covariance on two sets of axes, each row by row: `P_W = R_WB P_B R_WBᵀ`, which is symmetric as `R_WB P_B`
/// is not.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CovarianceReport {
    /// On the body's axes.
    pub body: [[f64; 3]; 3],
    /// On the world's axes.
    pub world: [[f64; 3]; 3],
}

/// How the image of a point x fixed in the body changes with the attitude; a quaternion is of norm 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct PointReport {
    /// `R_WB x`, in coordinates of the world.
    pub world: [f64; 3],
    /// `∂(R_WB x)/∂δ = −R_WB [x]×` for a small turn δ of the body on its own axes, row by row (specification,
    /// FX-06).
    pub by_body_turn: [[f64; 3]; 3],
    /// `−[R_WB x]×`, for one on the world's axes.
    pub by_world_turn: [[f64; 3]; 3],
    /// `∂(q∘x∘q*)/∂q` of the declared product at the declared quaternion: three rows, with a column for each
    /// component in the declared order (specification, FX-25). Where that takes world to body, as in JPL, the same
    /// three numbers x are coordinates in the world.
    pub by_components: [[f64; 4]; 3],
}

/// What a factor makes of a quaternion of norm 1, and on which side of it that stands.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SidedQuaternion {
    /// The convention of the numbers; its `perturbation` tells on whose axes the increment or the rate is.
    pub convention: Convention,
    /// `q ⊕ δ`, or q̇.
    pub quaternion: Components,
    /// The side of q on which the factor stands.
    pub side: Side,
    /// σ: +1, or −1 where the components are those of the conjugate.
    pub sign: i8,
    /// What q is multiplied by: of an increment the error quaternion `δq = Exp(σδ)` (Cheng 2018, eqs. 2.27
    /// and 2.28), of a rate `σω`, of which half is taken.
    pub factor: Components,
    /// The matrix of the factor on arrays in the order of the convention, row by row: of a rate Ω, with
    /// `q̇ = ½ Ω q` (Cheng 2018, eq. 2.36; Yoosefian 2021, eqs. 10 and 17).
    pub matrix: [[f64; 4]; 4],
}

/// An attitude after a small turn δ, `q ⊕ δ`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct IncrementReport {
    /// The right-handed turn of the body on the body's axes.
    pub body_rad: [f64; 3],
    /// The same turn on the world's axes.
    pub world_rad: [f64; 3],
    /// `q ⊕ δ` of norm 1 in the declared convention, Hamilton and JPL, with the given numbers on the body's
    /// axes, and then the same three with them on the world's.
    pub plus: Vec<SidedQuaternion>,
    /// `q ⊕ (−δ)` in the same places: the attitude from which the increment leads to q.
    pub minus: Vec<SidedQuaternion>,
    /// `R_WB` after the increment on the declared axes, row by row; `R_BW` is the transpose.
    pub body_to_world: [[f64; 3]; 3],
    /// `[1, σδ/2]` in the declared convention, the error quaternion but for terms of second order; its norm
    /// is not 1 (Cheng 2018, eq. 2.29).
    pub small_angle_quaternion: Components,
    /// `I + [δ]×`, the matrix of the turn but for terms of second order; it is no rotation (Cheng 2018,
    /// eq. 2.30).
    pub small_angle_matrix: [[f64; 3]; 3],
    /// How far off these are: the norm of the quaternion's difference, the Frobenius norm of the matrix's,
    /// and the angle in radians between the turn and that of the quaternion divided by its norm.
    pub small_angle_off: [f64; 3],
    /// What goes wrong, and by how much.
    pub mistakes: Vec<Mistake>,
}

/// How an attitude changes at a rate.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct DerivativeReport {
    /// The angular velocity on the body's axes, in radians per second.
    pub body_rad: [f64; 3],
    /// The same on the world's axes.
    pub world_rad: [f64; 3],
    /// q̇ of the quaternion of norm 1, by the rate on the axes on which it was given: of the declared
    /// convention, Hamilton and JPL (Cheng 2018, eq. 2.34; Yoosefian 2021, eqs. 9 and 16).
    pub quaternions: Vec<SidedQuaternion>,
    /// `Ṙ_WB = R_WB [ω_B]× = [ω_W]× R_WB`, row by row (Cheng 2018, eqs. 1.10 and 2.37); `Ṙ_BW` is the
    /// transpose.
    pub body_to_world: [[f64; 3]; 3],
    /// The angles whose rates are below.
    pub euler: Euler,
    /// The rates of those angles in their order; absent at gimbal lock, where they are infinite.
    pub euler_rates_rad: Option<[f64; 3]>,
    /// The determinant of the matrix that makes the angular velocity of those rates; 0 at gimbal lock.
    pub euler_determinant: f64,
    /// The rotation vector whose rate is below: as typed, or else the shortest.
    pub vector_rad: [f64; 3],
    /// Its rate, `v̇ = J_r⁻¹ ω_B`; absent at a whole turn.
    pub vector_rate_rad: Option<[f64; 3]>,
    /// The right Jacobian, `ω_B = J_r v̇`, row by row; the left one is its transpose.
    pub right_jacobian: [[f64; 3]; 3],
    /// Its inverse; absent at a whole turn.
    pub right_jacobian_inverse: Option<[[f64; 3]; 3]>,
}

/// The way of a body for a rate that is constant, or goes from one to another in equal steps.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PathReport {
    /// The way of the body, and then that of each mistake in its place: the time in seconds, then w, x, y
    /// and z of the Hamilton quaternion body to world, of norm 1, for one moment more than the steps. The
    /// signs go on from one to the next.
    pub ways: Vec<Vec<[f64; 5]>>,
    /// The last one of the body in the declared convention, of norm 1.
    pub end: Components,
    /// The turn that carries the world axes onto the body axes at the end.
    pub turn: Turn,
    /// How well steps follow the body, a list for each of seven kinds: by the turn at the rate at the
    /// beginning of the step (order 1), at that in the middle (2), by two rates and their cross product
    /// (4, Magnus), by `q + h q̇` divided by its norm (1), and by Runge–Kutta on the components, on the Euler
    /// angles and on the rotation vector (4).
    ///
    /// The longest step is first, and that of the asked number of steps is among them. Of each: how many
    /// there are; the step in seconds; the angle in radians between the attitude at the end and the right
    /// one, 0 where that is no more than rounding; the most that the norm of components differed from 1
    /// before it was divided out; and the power of the step with which the error has vanished since the step
    /// before, 0 where there is no error that shows it. Steps that meet gimbal lock or a whole turn are left
    /// out.
    pub integrators: Vec<Vec<[f64; 5]>>,
    /// What goes wrong, and by how much at the end.
    pub mistakes: Vec<Mistake>,
}
