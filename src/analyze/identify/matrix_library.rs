//! Which convention a library of rotation matrices uses, from what it printed (specification, FX-07).

use crate::analyze::identify::observation::{matrix, rounding_of, vector_of};
use crate::analyze::identify::recognition::{
    ONE_DECIMAL, direction_of_yawed, function_of_chain, increments_that_fit,
};
use crate::contract::MatricesReport;
use crate::contract::request::MatricesRequest;
use crate::convention::side::IncrementSign;
use crate::convention::{Direction, Function, Perturbation};
use crate::problem::fault::Fault;
use crate::problem::{Field, Problem, Span};
use crate::rotation::Rotation;
use crate::rotation::nearest::nearest;
use nalgebra::{Matrix3, Vector3};

/// Noise of single precision, after a product of matrices.
const SINGLE_PRECISION: f64 = 1e-5;

/// An entry of a product of rounded matrices is this many roundings off at most: three of each factor, and
/// its own.
const ROUNDINGS_OF_PRODUCT: f64 = 7.0;

/// What the prints of a library tell, or the problem of the first text that cannot be read.
pub(crate) fn identify_matrices(request: &MatricesRequest) -> Result<MatricesReport, Problem> {
    let yawed = read(&request.yawed, Field::Yawed)?;
    let operator = yawed.and_then(|yawed| direction_of_yawed((yawed * Vector3::x()).into()));
    if yawed.is_some_and(|yawed| !is_yaw(&yawed)) {
        return Err(contradiction(
            &request.yawed,
            Field::Yawed,
            "neither the matrix of 90° about z nor its transpose",
            "turn the body by +90° about the z of the world: [[0, -1, 0], [1, 0, 0], [0, 0, 1]] or its transpose",
        ));
    }
    let function = function(request)?;
    let increment = increment(request, operator)?;
    Ok(MatricesReport {
        operator,
        function,
        direction: match function {
            Some(Function::Passive) => operator,
            Some(Function::Active) => operator.map(Direction::reversed),
            None => None,
        },
        perturbation: increment.map(|(axes, _)| axes),
        increment_sign: increment.map(|(_, sign)| sign),
    })
}

/// The nine numbers of a text; nothing where it is empty, as the probe was not run.
fn read(text: &str, field: Field) -> Result<Option<Matrix3<f64>>, Problem> {
    if text.is_empty() {
        return Ok(None);
    }
    matrix(text)
        .map(Some)
        .map_err(|fault| fault.in_field(field))
}

fn function(request: &MatricesRequest) -> Result<Option<Function>, Problem> {
    let MatricesRequest { a, b, product, .. } = request;
    let rounding = ROUNDINGS_OF_PRODUCT * rounding_of(&[a, b, product]);
    let matrices = (
        read(a, Field::A)?,
        read(b, Field::B)?,
        read(product, Field::Product)?,
    );
    let (Some(a), Some(b), Some(product)) = matrices else {
        return Ok(None);
    };
    let tolerance = rounding.max(SINGLE_PRECISION);
    if [b * a, a * b]
        .iter()
        .all(|whole| (whole - product).amax() > tolerance)
    {
        return Err(contradiction(
            &request.product,
            Field::Product,
            "neither product of the other two",
            "print the matrix A to C of the same three frames",
        ));
    }
    Ok(function_of_chain(&a, &b, &product, tolerance))
}

/// A quarter turn about z in either sense, to one decimal.
fn is_yaw(matrix: &Matrix3<f64>) -> bool {
    let yaw = Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    [yaw, yaw.transpose()]
        .iter()
        .any(|expected| (matrix - expected).amax() <= ONE_DECIMAL)
}

fn contradiction(text: &str, field: Field, what: &'static str, hint: &'static str) -> Problem {
    Fault::fits_no_convention(Span::of_trimmed(text), what, hint).in_field(field)
}

fn increment(
    request: &MatricesRequest,
    operator: Option<Direction>,
) -> Result<Option<(Perturbation, IncrementSign)>, Problem> {
    let before = read(&request.matrix, Field::Matrix)?;
    let after = read(&request.printed, Field::Printed)?;
    let (Some(before), Some(after), Some(operator)) = (before, after, operator) else {
        return Ok(None);
    };
    if request.rotation_vector.is_empty() {
        return Ok(None);
    }
    let turn = vector_of(&request.rotation_vector);
    let turn = turn.map_err(|fault| fault.in_field(Field::RotationVector))?;
    let both = attitude(before, operator).zip(attitude(after, operator));
    let Some((before, after)) = both else {
        return Ok(None);
    };
    match increments_that_fit(&before, &after, turn.into())[..] {
        [] => Err(contradiction(
            &request.printed,
            Field::Printed,
            "not the matrix before turned by φ, on either axes, in either sense",
            "print the matrix after φ was added to the one before",
        )),
        [told] => Ok(Some(told)),
        _ => Ok(None),
    }
}

/// The attitude of a matrix with this operator.
fn attitude(matrix: Matrix3<f64>, operator: Direction) -> Option<Rotation> {
    let rotation = nearest(&matrix)?;
    Some(match operator {
        Direction::BodyToWorld => rotation,
        Direction::WorldToBody => rotation.inverse(),
    })
}
