//! How the image of a point changes with the attitude.

use crate::analyze::attitude::Attitude;
use crate::analyze::motion::covariance::MOST;
use crate::analyze::plain_numbers::{coordinates, plain, rows3};
use crate::contract::PointReport;
use crate::convention::matrix::MatrixConvention;
use crate::convention::order::ComponentOrder;
use crate::convention::{Handedness, Perturbation};
use crate::motion::kinematics::action_jacobian;
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::parse_vector;
use nalgebra::Vector3;

/// The three coordinates of a point.
pub(super) fn point(text: &str) -> Result<Vector3<f64>, Fault> {
    let point = parse_vector(text)?;
    if point.amax() > MOST {
        return Err(Fault::too_large(Span::of_trimmed(text)));
    }
    Ok(point)
}

pub(super) fn of_point(attitude: &Attitude, point: Vector3<f64>) -> PointReport {
    let rotation = &attitude.rotation;
    let matrix = rotation.to_tagged_matrix(MatrixConvention::BODY_TO_WORLD);
    let convention = attitude.tagged.convention;
    let unit = rotation.to_tagged(convention).components;
    // q ⊗ x ⊗ q* is q* ⊙ x ⊙ q, which changes with the vector part of q as with that of q*, turned round.
    let (of, sign) = match convention.handedness {
        Handedness::Right => (unit, 1.0),
        Handedness::Left => (unit.conjugate(), -1.0),
    };
    let jacobian = action_jacobian(&of, &point);
    let by = |row: usize, component: usize| {
        plain(jacobian[(row, component)] * if component == 0 { 1.0 } else { sign })
    };
    let places = match convention.order {
        ComponentOrder::ScalarFirst => [0, 1, 2, 3],
        ComponentOrder::ScalarLast => [1, 2, 3, 0],
    };
    PointReport {
        world: coordinates(&rotation.body_to_world(point)),
        by_body_turn: rows3(&matrix.action_jacobian(point.into(), Perturbation::Local)),
        by_world_turn: rows3(&matrix.action_jacobian(point.into(), Perturbation::Global)),
        by_components: [0, 1, 2].map(|row| places.map(|component| by(row, component))),
    }
}
