//! Which convention a library of rotation matrices uses, from what it printed.
//!
//! Every observation is compared with what each of 16 behaviours prints; those remain that agree with all
//! (specification, FX-07).

use crate::analyze::identify::observation::{matrix, rounding_of, vector_of};
use crate::analyze::identify::recognition::{direction_of_yawed, function_of_chain, increment_of};
use crate::contract::probe::MatrixProbe;
use crate::contract::request::MatricesRequest;
use crate::contract::{
    MatricesReport, MatrixBehaviour, MatrixObservationReport, MatrixTold, ObservationProblem,
    RemainingOfMatrices,
};
use crate::convention::Direction;
use crate::convention::side::IncrementSign;
use crate::convention::{Function, Perturbation};
use crate::problem::{Field, Problem};
use crate::rotation::Rotation;
use crate::rotation::nearest::nearest;
use nalgebra::{Matrix3, Vector3};

/// Noise of single precision, after a product of matrices.
const SINGLE_PRECISION: f64 = 1e-5;

/// An entry of a product of rounded matrices is this many roundings off at most: three of each factor, and
/// its own.
const ROUNDINGS_OF_PRODUCT: f64 = 7.0;

/// What can be said of a library of matrices, whatever was entered.
pub(crate) fn identify_matrices(request: &MatricesRequest) -> MatricesReport {
    let read: Vec<_> = request.observations.iter().map(Told::of).collect();
    let told = read.iter().filter_map(|told| told.as_ref().ok()?.as_ref());
    let told: Vec<&Told> = told.collect();
    let possible: Vec<MatrixBehaviour> = MatrixBehaviour::all()
        .filter(|behaviour| told.iter().all(|told| told.agrees_with(*behaviour)))
        .collect();
    let observations = request.observations.iter().zip(&read);
    MatricesReport {
        observations: observations
            .map(|(probe, read)| report(probe, read.as_ref()))
            .collect(),
        possible: possible.len(),
        remaining: RemainingOfMatrices::of(&possible),
    }
}

fn report(probe: &MatrixProbe, read: Result<&Option<Told>, &Problem>) -> MatrixObservationReport {
    match read {
        _ if probe.printed().trim().is_empty() => MatrixObservationReport::Empty,
        Err(problem) => MatrixObservationReport::Problem(ObservationProblem {
            problem: problem.clone(),
        }),
        Ok(None) => MatrixObservationReport::Unexplained,
        Ok(Some(told)) => MatrixObservationReport::Told(MatrixTold {
            possible: MatrixBehaviour::all()
                .filter(|behaviour| told.agrees_with(*behaviour))
                .count(),
        }),
    }
}

/// What one observation tells.
enum Told {
    Operator(Direction),
    Function(Function),
    /// On whose axes and with which sign, where the matrix is `R_WB`, and where it is `R_BW`.
    Increment([Option<(Perturbation, IncrementSign)>; 2]),
}

impl Told {
    /// Nothing where no behaviour prints this, or all do.
    fn of(probe: &MatrixProbe) -> Result<Option<Self>, Problem> {
        let read = |text: &str, field| matrix(text).map_err(|fault| fault.in_field(field));
        let printed = read(probe.printed(), Field::Printed);
        Ok(match probe {
            MatrixProbe::Yawed { .. } => {
                let image_of_x = printed? * Vector3::x();
                direction_of_yawed(image_of_x.into()).map(Self::Operator)
            }
            MatrixProbe::Chain {
                a,
                b,
                printed: text,
            } => {
                let (a_to_b, b_to_c) = (read(a, Field::A)?, read(b, Field::B)?);
                let rounding = ROUNDINGS_OF_PRODUCT * rounding_of(&[a, b, text]);
                let tolerance = rounding.max(SINGLE_PRECISION);
                function_of_chain(&a_to_b, &b_to_c, &printed?, tolerance).map(Self::Function)
            }
            MatrixProbe::Increment {
                matrix: before,
                rotation_vector,
                ..
            } => {
                let before = read(before, Field::Matrix)?;
                let increment = vector_of(rotation_vector)
                    .map_err(|fault| fault.in_field(Field::RotationVector))?;
                let after = printed?;
                let told = Direction::ALL.map(|operator| {
                    let [before, after] = [before, after].map(|matrix| attitude(matrix, operator));
                    increment_of(&before?, &after?, increment.into())
                });
                told.iter()
                    .any(Option::is_some)
                    .then_some(Self::Increment(told))
            }
        })
    }

    fn agrees_with(&self, behaviour: MatrixBehaviour) -> bool {
        let operator = behaviour.convention.operator();
        match self {
            Self::Operator(told) => *told == operator,
            Self::Function(told) => *told == behaviour.convention.function,
            Self::Increment(told) => Direction::ALL
                .into_iter()
                .zip(told)
                .filter(|(of, _)| *of == operator)
                .any(|(_, told)| *told == Some((behaviour.perturbation, behaviour.increment_sign))),
        }
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
