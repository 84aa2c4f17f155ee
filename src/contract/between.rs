//! What the comparison of two attitudes answers.

use crate::contract::attitude::{Column, Euler, ReadQuaternion, Turn};
use crate::contract::note::Note;
use crate::contract::translation::Mistake;
use serde::{Deserialize, Serialize, Serializer};
use strum::VariantNames;

/// How two attitudes p and q differ, and what is between them.
///
/// The columns are of norm 1. Those of the error are of the quaternion δq with `q = p∘δq` or `q = δq∘p`,
/// on the side that `rules.increment` says (Cheng 2018, eqs. 2.27 and 2.28; specification, table 2.2): of
/// the turn on the body's axes where the declared perturbation is local, on the world's where it is global.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct BetweenReport {
    /// The first attitude as it was read.
    pub p: ReadQuaternion,
    /// The second attitude as it was read.
    pub q: ReadQuaternion,
    /// What the two are to each other.
    pub verdict: Verdict,
    /// The turn from p to q on the axes of p's body, `R_WP⁻¹ R_WQ`; its angle is the geodesic distance.
    pub local: Turn,
    /// The same turn on the axes of the world, `R_WQ R_WP⁻¹`.
    pub global: Turn,
    /// The error quaternion in the declared convention.
    pub declared: Column,
    /// The error quaternion as a Hamilton one.
    pub hamilton: Column,
    /// The error quaternion as a JPL one: the same numbers, on the other side.
    pub jpl: Column,
    /// The Frobenius norm of the difference of the two matrices, from 0 to 2√2.
    pub chordal_distance: f64,
    /// The norm of p − q, each of norm 1, from 0 to 2.
    pub quaternion_distance: f64,
    /// The norm of p + q, that is from p to −q. The nearer of q and −q is that with the smaller norm, and
    /// that norm a distance of the attitudes.
    pub negated_quaternion_distance: f64,
    /// The part of the way from p to q: 0 is p, 1 is q, and beyond these the turn goes on.
    pub part: f64,
    /// The attitude there, in the declared convention (slerp, by the shorter way; Shoemake 1985).
    pub way: Column,
    /// The attitude half way, in the declared convention; at half a turn one of two, as the way is one of two.
    pub halfway: Column,
    /// Where a duration was given: the constant rate that leads from p to q in it.
    pub rate: Option<RateBetween>,
    /// p as Euler angles in the requested sequence.
    pub p_euler: Euler,
    /// q as Euler angles in the same sequence.
    pub q_euler: Euler,
    /// The angles of q less those of p, each by the shorter way round, in degrees: 359° and 1° differ by 2.
    /// They are no turn: applied one after the other they do not lead from p to q.
    pub euler_differences_deg: [f64; 3],
    /// What a careful reader should know about these inputs.
    pub notes: Vec<Note>,
}

/// The constant angular velocity of the body against the world, right-handed, that leads from p to q by the
/// shorter turn (specification, FX-06); of half a turn either way round is as short.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct RateBetween {
    /// The time from p to q, in seconds.
    pub duration_s: f64,
    /// On the axes of the body, in rad/s: `Log(R_WP⁻¹ R_WQ)` over the duration.
    pub body_rad: [f64; 3],
    /// The same on the axes of the world, `Log(R_WQ R_WP⁻¹)` over the duration.
    pub world_rad: [f64; 3],
    /// What goes wrong, and how far from q the body is then after the duration: without the half of the
    /// angle that a quaternion holds, the rate is half as large.
    pub mistakes: Vec<Mistake>,
}

/// What two attitudes are to each other; the first that holds, within 2·10⁻⁴ rad, which four decimals keep.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[derive(VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub enum Verdict {
    /// One attitude.
    Equal,
    /// One attitude by two quaternions, q and −q.
    Opposite,
    /// Each is the conjugate of the other, or the transpose: the opposite turn.
    Conjugated,
    /// The same four numbers with the scalar at the other end.
    ScalarMoved,
    /// The scalar at the other end, and then the conjugate.
    ScalarMovedAndConjugated,
    /// Two attitudes.
    Different,
}

/// By the list of names; what is derived has the code of a case for each.
impl Serialize for Verdict {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let name = <Self as VariantNames>::VARIANTS[*self as usize];
        serializer.serialize_unit_variant("Verdict", *self as u32, name)
    }
}
