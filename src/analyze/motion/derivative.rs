//! How an attitude changes at a rate.

use crate::analyze::attitude::Attitude;
use crate::analyze::describe::euler;
use crate::analyze::motion::sided::{conventions, sided, sigma};
use crate::analyze::plain_numbers::{coordinates, plain, plain3, rows3};
use crate::contract::{DerivativeReport, Form};
use crate::convention::euler_sequence::EulerSequence;
use crate::convention::matrix::MatrixConvention;
use crate::motion::kinematics::RateAxes;
use crate::rotation::rotation_vector::{right_jacobian, right_jacobian_inverse};
use nalgebra::{Quaternion, Vector3};

pub(super) fn of_rate(
    attitude: &Attitude,
    rate: Vector3<f64>,
    axes: RateAxes,
    sequence: EulerSequence,
) -> DerivativeReport {
    let rotation = &attitude.rotation;
    let (body, world) = attitude.on_both_axes(rate, axes);
    let mut quaternions = Vec::new();
    for convention in conventions(attitude, axes.perturbation()) {
        let factor = Quaternion::from_parts(0.0, rate * sigma(convention));
        quaternions.push(sided(attitude, convention, factor, 0.5));
    }
    let matrix = rotation.to_tagged_matrix(MatrixConvention::BODY_TO_WORLD);
    let matrix = matrix.derivative(rate.into(), axes);
    let euler = euler(rotation, sequence);
    let (rates, determinant) =
        sequence.rates_and_determinant(euler.angles_rad, body.into(), RateAxes::Body);
    let vector = match attitude.form {
        Form::RotationVector(read) => read.vector_rad.into(),
        _ => rotation.rotation_vector_rad(),
    };
    let inverse = right_jacobian_inverse(&vector);
    let vector_rate = inverse.map(|inverse| inverse * body);
    DerivativeReport {
        body_rad: coordinates(&body),
        world_rad: coordinates(&world),
        quaternions,
        body_to_world: rows3(&matrix),
        euler_rates_rad: rates.map(plain3),
        euler_determinant: plain(determinant),
        euler,
        vector_rad: coordinates(&vector),
        vector_rate_rad: vector_rate
            .filter(|rate| rate.amax().is_finite())
            .as_ref()
            .map(coordinates),
        right_jacobian: rows3(&right_jacobian(&vector)),
        right_jacobian_inverse: inverse.as_ref().map(rows3),
    }
}
