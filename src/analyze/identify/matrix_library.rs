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
    let mut possible = MatrixBehaviour::all();
    let mut observations = Vec::new();
    for probe in &request.observations {
        let agreeing = |told: &Told, behaviours: &[MatrixBehaviour]| {
            let mut agreeing = behaviours.to_vec();
            agreeing.retain(|behaviour| told.agrees_with(*behaviour));
            agreeing
        };
        observations.push(match Told::of(probe) {
            _ if probe.printed().trim().is_empty() => MatrixObservationReport::Empty,
            Err(problem) => MatrixObservationReport::Problem(ObservationProblem { problem }),
            Ok(None) => MatrixObservationReport::Unexplained,
            Ok(Some(told)) => {
                possible = agreeing(&told, &possible);
                let possible = agreeing(&told, &MatrixBehaviour::all()).len();
                MatrixObservationReport::Told(MatrixTold { possible })
            }
        });
    }
    MatricesReport {
        observations,
        possible: possible.len(),
        remaining: RemainingOfMatrices::of(&possible),
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
                let told = |operator: Direction| {
                    let (before, after) = (attitude(before, operator), attitude(after, operator));
                    increment_of(&before?, &after?, increment.into())
                };
                let told = [told(Direction::BodyToWorld), told(Direction::WorldToBody)];
                (told != [None, None]).then_some(Self::Increment(told))
            }
        })
    }

    fn agrees_with(&self, behaviour: MatrixBehaviour) -> bool {
        let operator = behaviour.convention.operator();
        match self {
            Self::Operator(told) => *told == operator,
            Self::Function(told) => *told == behaviour.convention.function,
            Self::Increment([body_to_world, world_to_body]) => {
                let told = match operator {
                    Direction::BodyToWorld => body_to_world,
                    Direction::WorldToBody => world_to_body,
                };
                *told == Some((behaviour.perturbation, behaviour.increment_sign))
            }
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
