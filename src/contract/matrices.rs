//! What the identification of a library of matrices answers.

use crate::contract::identification::{ObservationProblem, values};
use crate::convention::matrix::MatrixConvention;
use crate::convention::side::IncrementSign;
use crate::convention::{Direction, Function, Perturbation};
use crate::problem::{Field, Problem};
use serde::{Deserialize, Serialize};

/// What can be said of a library of rotation matrices after some observations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MatricesReport {
    /// What became of each observation, in their order.
    pub observations: Vec<MatrixObservationReport>,
    /// How many of the 16 behaviours are still possible; 0 where the observations contradict each other.
    pub possible: usize,
    /// The values of each choice that are still possible.
    pub remaining: RemainingOfMatrices,
}

/// What became of one observation of a library of matrices.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(tag = "status", rename_all = "kebab-case")]
pub enum MatrixObservationReport {
    /// Nothing was entered as printed yet.
    Empty,
    /// A text could not be read.
    Problem(ObservationProblem),
    /// No behaviour prints this, or all do, as of turns about one axis.
    Unexplained,
    /// It was read.
    Told(MatrixTold),
}

/// What an observation of a library of matrices tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MatrixTold {
    /// How many of the 16 behaviours it leaves, alone.
    pub possible: usize,
}

/// The values that are still possible; one each where a choice is settled.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct RemainingOfMatrices {
    /// Which coordinates to which its matrix takes, as a column on the right: `R_WB` or `R_BW`.
    pub operator: Vec<Direction>,
    /// Whether its labels change coordinates or move vectors.
    pub function: Vec<Function>,
    /// From which frame to which its labels lead.
    pub direction: Vec<Direction>,
    /// On which axes a small turn is added.
    pub perturbation: Vec<Perturbation>,
    /// Whether a small turn φ turns the body by φ or by −φ.
    pub increment_sign: Vec<IncrementSign>,
}

/// One way in which a library of matrices may behave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MatrixBehaviour {
    pub(crate) convention: MatrixConvention,
    pub(crate) perturbation: Perturbation,
    pub(crate) increment_sign: IncrementSign,
}

impl MatrixBehaviour {
    /// All 16.
    pub(crate) fn all() -> Vec<Self> {
        let mut all = Vec::new();
        for convention in MatrixConvention::all() {
            for perturbation in Perturbation::ALL {
                for increment_sign in IncrementSign::ALL {
                    all.push(Self {
                        convention,
                        perturbation,
                        increment_sign,
                    });
                }
            }
        }
        all
    }
}

impl RemainingOfMatrices {
    pub(crate) fn of(behaviours: &[MatrixBehaviour]) -> Self {
        Self {
            operator: values(behaviours, |behaviour| behaviour.convention.operator()),
            function: values(behaviours, |behaviour| behaviour.convention.function),
            direction: values(behaviours, |behaviour| behaviour.convention.direction),
            perturbation: values(behaviours, |behaviour| behaviour.perturbation),
            increment_sign: values(behaviours, |behaviour| behaviour.increment_sign),
        }
    }
}

impl MatricesReport {
    /// With every span counted in UTF-16 units of the text it points into.
    pub(crate) fn in_utf16(mut self, text_of: impl Fn(Field, usize) -> String) -> Self {
        for (at, problem) in self.problems_mut() {
            problem.span = problem.span.in_utf16(&text_of(problem.field, at));
        }
        self
    }

    /// The problems, each with the place of its observation.
    pub(crate) fn problems_mut(&mut self) -> impl Iterator<Item = (usize, &mut Problem)> {
        let observations = self.observations.iter_mut().enumerate();
        observations.filter_map(|(at, observation)| match observation {
            MatrixObservationReport::Problem(found) => Some((at, &mut found.problem)),
            _ => None,
        })
    }
}
