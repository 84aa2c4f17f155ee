//! The specification's tests that tell which convention a library has: FX-07, FX-11, FX-19 and FX-26.
//!
//! Each library is simulated in a convention and then told by what it does alone.

mod euler_angles;
mod matrices;
mod quaternions;
mod vectors;

use quatlas::Rotation;
use quatlas::nalgebra::Vector3;

pub(super) fn attitude(v: Vector3<f64>) -> Rotation {
    Rotation::from_rotation_vector_rad(v.into()).expect("finite")
}

pub(super) fn sign_of(number: f64) -> f64 {
    assert!(number.abs() > 1e-3, "clearly one or the other");
    number.signum()
}
