//! Which convention a library of rotation matrices uses, from what it printed (specification, FX-07).

use crate::analyze::identify::observation::{matrix, rounding_of, vector_of};
use crate::analyze::identify::recognition::{direction_of_yawed, function_of_chain, increment_of};
use crate::contract::MatricesReport;
use crate::contract::request::MatricesRequest;
use crate::convention::side::IncrementSign;
use crate::convention::{Direction, Function, Perturbation};
use crate::problem::{Field, Problem};
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
    Ok(function_of_chain(
        &a,
        &b,
        &product,
        rounding.max(SINGLE_PRECISION),
    ))
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
    Ok(attitude(before, operator)
        .zip(attitude(after, operator))
        .and_then(|(before, after)| increment_of(&before, &after, turn.into())))
}

/// The attitude of a matrix with this operator.
fn attitude(matrix: Matrix3<f64>, operator: Direction) -> Option<Rotation> {
    let rotation = nearest(&matrix)?;
    Some(match operator {
        Direction::BodyToWorld => rotation,
        Direction::WorldToBody => rotation.inverse(),
    })
}
