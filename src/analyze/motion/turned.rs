//! Turns of unit quaternions, and how far one is off.

use crate::analyze::attitude::Attitude;
use crate::contract::{Mistake, MistakeKind};
use crate::convention::Convention;
use crate::motion::kinematics::RateAxes;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::f64::consts::PI;

/// Hamilton, body to world, of norm 1.
pub(super) fn unit(attitude: &Attitude) -> UnitQuaternion<f64> {
    let unit = attitude.rotation.to_tagged(Convention::HAMILTON).components;
    UnitQuaternion::new_unchecked(unit)
}

/// The turn by a rotation vector.
pub(super) fn exponential(vector_rad: Vector3<f64>) -> UnitQuaternion<f64> {
    let half_angle = vector_rad.norm_squared().sqrt() / 2.0;
    let (sine, cosine) = libm::sincos(half_angle);
    // Of a vector whose squares are too small for a double the half is its sine.
    let sinc = if half_angle > 0.0 {
        sine / half_angle
    } else {
        1.0
    };
    let turn = Quaternion::from_parts(cosine, vector_rad * (sinc / 2.0));
    UnitQuaternion::new_unchecked(turn)
}

/// The attitude after a turn on the axes of the body or of the world.
pub(super) fn turned(
    attitude: &UnitQuaternion<f64>,
    axes: RateAxes,
    turn_rad: Vector3<f64>,
) -> UnitQuaternion<f64> {
    let turn = exponential(turn_rad);
    match axes {
        RateAxes::Body => attitude * turn,
        RateAxes::World => turn * attitude,
    }
}

/// What goes wrong, and what a small turn or a rate is multiplied by then.
pub(super) static MISTAKES: [(MistakeKind, f64); 4] = [
    (MistakeKind::OtherSide, 1.0),
    (MistakeKind::OtherSign, -1.0),
    (MistakeKind::HalfForgotten, 2.0),
    (MistakeKind::DegreesAsRadians, 180.0 / PI),
];

/// On whose axes the numbers are then.
pub(super) const fn axes_of(kind: MistakeKind, right: RateAxes) -> RateAxes {
    match (kind, right) {
        (MistakeKind::OtherSide, RateAxes::Body) => RateAxes::World,
        (MistakeKind::OtherSide, RateAxes::World) => RateAxes::Body,
        _ => right,
    }
}

impl Attitude {
    /// A vector with coordinates on these axes, on those of the body and on those of the world.
    pub(super) fn on_both_axes(
        &self,
        vector: Vector3<f64>,
        axes: RateAxes,
    ) -> (Vector3<f64>, Vector3<f64>) {
        match axes {
            RateAxes::Body => (vector, self.rotation.body_to_world(vector)),
            RateAxes::World => (self.rotation.world_to_body(vector), vector),
        }
    }
}

/// How far an attitude is from the right one, or 0 where that is the rounding of so large a turn in so
/// many steps.
pub(super) fn mistake(
    kind: MistakeKind,
    right: &UnitQuaternion<f64>,
    wrong: &UnitQuaternion<f64>,
    rounding_rad: f64,
) -> Mistake {
    let angle_rad = beyond_rounding(right.angle_to(wrong), rounding_rad);
    Mistake {
        kind,
        angle_deg: angle_rad.to_degrees(),
    }
}

pub(super) fn beyond_rounding(angle_rad: f64, rounding_rad: f64) -> f64 {
    if angle_rad > rounding_rad {
        angle_rad
    } else {
        0.0
    }
}

/// What may be rounding at the end of a turn of so many radians in so many steps.
pub(super) fn rounding_rad(turn_rad: f64, steps: f64) -> f64 {
    (16.0 + 4.0 * turn_rad + 2.0 * steps) * f64::EPSILON
}
