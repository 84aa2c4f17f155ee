//! What the identification of a library answers.

use crate::contract::probe::Probe;
use crate::convention::family::Family;
use crate::convention::matrix::CosineMatrix;
use crate::convention::order::ComponentOrder;
use crate::convention::side::{IncrementSign, Side};
use crate::convention::{ComponentSign, Direction, Function, Handedness, Perturbation};
use crate::library::Language;
use crate::library::behaviour::{Behaviour, BehaviourAxis};
use crate::problem::{Field, Problem};
use serde::{Deserialize, Serialize};

/// What can be said of a library after some observations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct IdentifyReport {
    /// What became of each observation, in their order.
    pub observations: Vec<ObservationReport>,
    /// Each observation as a line of code; absent where what went in is not written as plain numbers.
    pub codes: Vec<Option<String>>,
    /// How many of the 256 behaviours are still possible.
    pub possible: usize,
    /// The values of each choice that are still possible.
    pub remaining: Remaining,
    /// How its product and its rotation belong together; absent until both are settled.
    pub family: Option<Family>,
    /// The choices of which one value is left, in the order of [`BehaviourAxis`].
    pub settled: Vec<BehaviourAxis>,
    /// The labels that fit: what no numbers can tell apart (specification, MODEL-10).
    pub labels: Vec<Labels>,
    /// The records that say nothing else, those with the most established choices first.
    pub libraries: Vec<LibraryMatch>,
    /// The probe that leaves the least, on average; absent where none can tell more.
    pub next: Option<NextProbe>,
    /// Observations that no library can have made together: two wherever two suffice, and never one that
    /// could be spared.
    pub contradiction: Option<Contradiction>,
    /// What is settled, as a sentence for an issue.
    pub sentence: String,
}

/// What became of one observation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(tag = "status", rename_all = "kebab-case")]
pub enum ObservationReport {
    /// Nothing was entered as printed yet.
    Empty,
    /// A text could not be read.
    Problem(ObservationProblem),
    /// No behaviour prints this, not even roughly.
    Unexplained(Unexplained),
    /// It was read.
    Told(Told),
}

/// A text of an observation that could not be read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ObservationProblem {
    /// The first of them.
    pub problem: Problem,
}

/// Numbers that no behaviour prints.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Unexplained {
    /// How far away the nearest behaviour is, relative to the size of what was printed; absent for
    /// what has no direction, such as zeros.
    pub distance: Option<f64>,
}

/// What an observation tells.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Told {
    /// How many of the 256 behaviours it leaves, alone.
    pub possible: usize,
    /// The choices that it settles, alone.
    pub settles: Vec<BehaviourAxis>,
    /// How far what was printed is from the nearest behaviour, relative to its size.
    pub distance: f64,
}

/// The values that are still possible; one each where a choice is settled.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Remaining {
    /// The order of the constructor's arguments.
    pub constructor: Vec<ComponentOrder>,
    /// The order in which it prints and stores.
    pub array: Vec<ComponentOrder>,
    /// Its product.
    pub handedness: Vec<Handedness>,
    /// What its call that rotates multiplies a column with.
    pub rotate: Vec<CosineMatrix>,
    /// What its matrix of a quaternion is, row by row.
    pub matrix: Vec<CosineMatrix>,
    /// Whether the quaternion of a body's attitude is that of body to world or its conjugate.
    pub attitude: Vec<ComponentSign>,
    /// On which axes a small turn is added.
    pub perturbation: Vec<Perturbation>,
    /// Whether a small turn φ turns the body by φ or by −φ.
    pub increment_sign: Vec<IncrementSign>,
    /// The operand of `a * b` that acts first on a vector; it follows from product and rotation.
    pub first_to_act: Vec<Side>,
    /// Which coordinates to which the call that rotates takes; it follows from rotation and attitude.
    pub direction: Vec<Direction>,
}

/// A function and a direction, which only the names of frames can tell from others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Labels {
    /// Whether the coordinates change or the vector moves.
    pub function: Function,
    /// From which frame to which.
    pub direction: Direction,
}

/// A record that agrees with everything that was observed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct LibraryMatch {
    /// Its id.
    pub id: String,
    /// The choices of which the record says nothing, so that they could not disagree.
    pub unestablished: Vec<BehaviourAxis>,
}

/// What to run next.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct NextProbe {
    /// What goes in; `printed` is empty.
    pub probe: Probe,
    /// The same as code, with names to be replaced by the library's own.
    pub code: String,
    /// The language of that code.
    pub language: Language,
    /// How many different answers there are.
    pub answers: usize,
    /// How many behaviours are left after it, on average.
    pub leaves: f64,
}

/// Observations that no library can have made together.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Contradiction {
    /// Their places in the list.
    pub observations: Vec<usize>,
    /// The choices about which they disagree; empty where it takes several choices together.
    pub about: Vec<BehaviourAxis>,
}

impl IdentifyReport {
    /// With every span counted in UTF-16 units of the text it points into.
    pub(crate) fn in_utf16(mut self, text_of: impl Fn(Field, usize) -> String) -> Self {
        for (at, observation) in self.observations.iter_mut().enumerate() {
            if let ObservationReport::Problem(ObservationProblem { problem, .. }) = observation {
                problem.span = problem.span.in_utf16(&text_of(problem.field, at));
            }
        }
        self
    }
}

/// What remains of the behaviours, value by value.
pub(crate) fn remaining(behaviours: &[Behaviour]) -> Remaining {
    Remaining {
        constructor: values(behaviours, |behaviour| behaviour.constructor),
        array: values(behaviours, |behaviour| behaviour.array),
        handedness: values(behaviours, |behaviour| behaviour.handedness),
        rotate: values(behaviours, |behaviour| behaviour.rotate),
        matrix: values(behaviours, |behaviour| behaviour.matrix),
        attitude: values(behaviours, |behaviour| behaviour.attitude),
        perturbation: values(behaviours, |behaviour| behaviour.perturbation),
        increment_sign: values(behaviours, |behaviour| behaviour.increment_sign),
        first_to_act: values(behaviours, Behaviour::first_to_act),
        direction: values(behaviours, Behaviour::direction),
    }
}

fn values<Value: Copy + PartialEq>(
    behaviours: &[Behaviour],
    value: impl Fn(&Behaviour) -> Value,
) -> Vec<Value> {
    let mut found = Vec::new();
    for behaviour in behaviours {
        let value = value(behaviour);
        if !found.contains(&value) {
            found.push(value);
        }
    }
    found
}

impl Remaining {
    /// How product and rotation belong together, once both are settled.
    pub(crate) fn family(&self) -> Option<Family> {
        match (&self.handedness[..], &self.rotate[..]) {
            ([handedness], [rotate]) => Some(Family::of(*handedness, *rotate)),
            _ => None,
        }
    }

    /// The choices of which one value is left.
    pub(crate) fn settled(&self) -> Vec<BehaviourAxis> {
        let counts = [
            self.constructor.len(),
            self.array.len(),
            self.handedness.len(),
            self.rotate.len(),
            self.matrix.len(),
            self.attitude.len(),
            self.perturbation.len(),
            self.increment_sign.len(),
        ];
        let mut settled = Vec::new();
        for (axis, count) in BehaviourAxis::ALL.into_iter().zip(counts) {
            if count == 1 {
                settled.push(axis);
            }
        }
        settled
    }
}
