//! A covariance on the axes of the body and of the world.

use crate::analyze::attitude::Attitude;
use crate::analyze::identify::observation;
use crate::analyze::plain_numbers::rows3;
use crate::contract::CovarianceReport;
use crate::convention::{Direction, Perturbation};
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::{only_numbers, parse_vector};
use nalgebra::Matrix3;

/// What is made of more may not fit into a double.
pub(super) const MOST: f64 = f64::MAX / 16.0;

/// What a matrix may lack of symmetry, or a minor of zero, against its largest entry: four decimals of numbers
/// about 1 leave half of it.
const ROUNDING: f64 = 1e-4;

const EXPECTED: &str =
    "nine numbers, six of the upper triangle, three variances, or one for all three";
const HINT: &str = "0.01 0.01 0.04";

/// Nine numbers, the six of the upper triangle row by row, the three variances of numbers that are not
/// correlated, or one for all three.
pub(super) fn covariance(text: &str) -> Result<Matrix3<f64>, Fault> {
    let covariance = match (parse_vector(text), only_numbers(text).as_deref()) {
        (Ok(variances), _) => Matrix3::from_diagonal(&variances),
        (_, Some(&[variance])) => Matrix3::from_diagonal_element(variance),
        (_, Some(&[xx, xy, xz, yy, yz, zz])) => Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz),
        _ => observation::matrix(text).map_err(|fault| Fault {
            expected: EXPECTED.to_owned(),
            hint: HINT.to_owned(),
            ..fault
        })?,
    };
    if covariance.amax() > MOST {
        return Err(Fault::too_large(Span::of_trimmed(text)));
    }
    let refused = |what| Err(Fault::not_a_covariance(Span::of_trimmed(text), what));
    let most = covariance.amax();
    let scaled = if most > 0.0 {
        covariance / most
    } else {
        covariance
    };
    if (scaled - scaled.transpose()).amax() > ROUNDING {
        return refused("a matrix that is not symmetric");
    }
    if (0..3).any(|at| scaled[(at, at)] < 0.0) {
        return refused("a negative variance");
    }
    let is_correlated = |one, other| {
        scaled[(one, other)] * scaled[(other, one)]
            > scaled[(one, one)] * scaled[(other, other)] + ROUNDING
    };
    if is_correlated(0, 1)
        || is_correlated(0, 2)
        || is_correlated(1, 2)
        || scaled.determinant() < -ROUNDING
    {
        return refused("numbers that are correlated more than wholly");
    }
    Ok(covariance)
}

/// `R P Rᵀ` of one that is on the axes of the declared perturbation, and itself.
pub(super) fn of_covariance(attitude: &Attitude, covariance: &Matrix3<f64>) -> CovarianceReport {
    let (from, to) = match attitude.tagged.convention.perturbation {
        Perturbation::Local => (Direction::BodyToWorld, [1, 0]),
        Perturbation::Global => (Direction::WorldToBody, [0, 1]),
    };
    let matrix = attitude.rotation.matrix(from);
    let turned = rows3(&(matrix * covariance * matrix.transpose()));
    let both = [turned, rows3(covariance)];
    CovarianceReport {
        body: both[to[0]],
        world: both[to[1]],
    }
}
