//! Euler angles of any sequence and the rotation that they mean, which nalgebra works out, and never quatlas.

use proptest::prelude::*;
use quatlas::nalgebra::{UnitQuaternion, Vector3};
use quatlas::{Axis, EulerAxes, EulerFrame, EulerSequence};

pub(crate) fn sequences() -> impl Strategy<Value = EulerSequence> {
    let frames = [EulerFrame::Intrinsic, EulerFrame::Extrinsic];
    (
        prop::sample::select(EulerAxes::ALL.to_vec()),
        prop::sample::select(frames.to_vec()),
    )
        .prop_map(|(axes, frame)| EulerSequence { axes, frame })
}

/// Three angles in radians, some of them such that the axes meet or half a turn is made.
pub(crate) fn angles() -> impl Strategy<Value = [f64; 3]> {
    let special = [0.0, 1.0, -1.0, 2.0, 0.5].map(|quarters| quarters * std::f64::consts::FRAC_PI_2);
    prop::array::uniform3(prop_oneof![
        4 => -3.1..3.1_f64,
        1 => prop::sample::select(special.to_vec()),
        1 => -1e-4..1e-4_f64,
    ])
}

/// The rotation of a sequence with angles, body to world.
pub(crate) fn turned(sequence: EulerSequence, angles: [f64; 3]) -> UnitQuaternion<f64> {
    let axes = sequence.axes.axes().map(|axis| match axis {
        Axis::X => Vector3::x_axis(),
        Axis::Y => Vector3::y_axis(),
        Axis::Z => Vector3::z_axis(),
    });
    let [i, j, k] = [0, 1, 2].map(|at| UnitQuaternion::from_axis_angle(&axes[at], angles[at]));
    match sequence.frame {
        EulerFrame::Intrinsic => i * j * k,
        EulerFrame::Extrinsic => k * j * i,
    }
}
