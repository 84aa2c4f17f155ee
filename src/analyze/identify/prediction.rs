//! What a library is asked, what it printed, and what each behaviour would print.

use crate::contract::probe::MatrixLayout;
use crate::convention::matrix::CosineMatrix;
use crate::convention::order::ComponentOrder;
use crate::convention::side::IncrementSign;
use crate::convention::{ComponentSign, Handedness, Perturbation};
use crate::library::behaviour::{Behaviour, BehaviourAxis};
use crate::rotation::Rotation;
use crate::rotation::nearest::nearest;
use crate::rotation::precise::Norm;
use crate::rotation::quaternion::{hamilton_product, jpl_product};
use nalgebra::{Matrix3, Quaternion, Vector3};

/// Four numbers, with or without names.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Numbers {
    /// Which number is which is known.
    Named(Quaternion<f64>),
    /// They stand as the library takes or prints them.
    AsWritten([f64; 4]),
}

impl Numbers {
    fn in_order(self, order: ComponentOrder) -> Quaternion<f64> {
        match (self, order) {
            (Self::Named(quaternion), _) => quaternion,
            (Self::AsWritten([w, x, y, z]), ComponentOrder::ScalarFirst)
            | (Self::AsWritten([x, y, z, w]), ComponentOrder::ScalarLast) => {
                Quaternion::new(w, x, y, z)
            }
        }
    }
}

/// What goes in.
#[derive(Clone, Debug)]
pub(crate) enum Question {
    Components(Numbers),
    Product(Numbers, Numbers),
    Rotate(Numbers, Vector3<f64>),
    Matrix(Numbers, MatrixLayout),
    /// The rotations whose `R(q)` the matrix may be: two where its layout is not known.
    FromMatrix(Vec<Rotation>),
    QuarterTurn,
    /// A quaternion, and the body-to-world quaternion of the turn that is added.
    Perturb(Numbers, Quaternion<f64>),
}

/// What comes out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Printed {
    Quaternion(Numbers),
    Vector(Vector3<f64>),
    Matrix(Matrix3<f64>),
}

/// What a behaviour would print.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Answer {
    /// Itself or its opposite, which is the same rotation.
    Rotation(Quaternion<f64>),
    /// Itself.
    Quaternion(Quaternion<f64>),
    Vector(Vector3<f64>),
    Matrix(Matrix3<f64>),
}

/// Numbers of norm 1 that differ by less are taken for the same.
const SAME: f64 = 1e-6;

impl Question {
    /// The question for the quaternion of a matrix.
    pub(crate) fn from_matrix(matrix: Matrix3<f64>, layout: MatrixLayout) -> Self {
        // Once for all behaviours: it is the longest of all these computations.
        let mut rotations = Vec::new();
        for matrix in layouts(layout, matrix) {
            rotations.extend(nearest(&matrix));
        }
        Self::FromMatrix(rotations)
    }

    /// The same for behaviours that print the same because no choice that matters here tells them apart:
    /// what is computed for one of them holds for all.
    pub(crate) fn key(&self, behaviour: &Behaviour) -> usize {
        behaviour.bits_of(match self {
            Self::Components(..) => &[BehaviourAxis::Constructor, BehaviourAxis::Array],
            Self::Product(..) => &[
                BehaviourAxis::Constructor,
                BehaviourAxis::Array,
                BehaviourAxis::Handedness,
            ],
            Self::Rotate(..) => &[BehaviourAxis::Constructor, BehaviourAxis::Rotate],
            Self::Matrix(..) => &[BehaviourAxis::Constructor, BehaviourAxis::Matrix],
            Self::FromMatrix(..) => &[BehaviourAxis::Array, BehaviourAxis::Matrix],
            Self::QuarterTurn => &[BehaviourAxis::Array, BehaviourAxis::Attitude],
            Self::Perturb(..) => &[
                BehaviourAxis::Constructor,
                BehaviourAxis::Array,
                BehaviourAxis::Attitude,
                BehaviourAxis::Perturbation,
                BehaviourAxis::IncrementSign,
            ],
        })
    }

    /// What this behaviour prints: two possible answers where the layout is not known, none where it
    /// cannot print any.
    pub(crate) fn answers(&self, behaviour: &Behaviour) -> Vec<Answer> {
        let given = |numbers: Numbers| numbers.in_order(behaviour.constructor);
        match *self {
            Self::Components(numbers) => vec![Answer::Rotation(given(numbers))],
            Self::Product(a, b) => vec![product(behaviour.handedness, &given(a), &given(b))],
            Self::Rotate(quaternion, vector) => match behaviour.rotate.of(&given(quaternion)) {
                Some(matrix) => vec![Answer::Vector(matrix * vector)],
                None => Vec::new(),
            },
            Self::Matrix(quaternion, layout) => {
                let mut answers = Vec::new();
                if let Some(matrix) = behaviour.matrix.of(&given(quaternion)) {
                    for matrix in layouts(layout, matrix) {
                        answers.push(Answer::Matrix(matrix));
                    }
                }
                answers
            }
            Self::FromMatrix(ref rotations) => {
                let mut answers = Vec::new();
                for rotation in rotations {
                    answers.push(Answer::Rotation(match behaviour.matrix {
                        CosineMatrix::Hamilton => *rotation.canonical(),
                        CosineMatrix::Shuster => rotation.canonical().conjugate(),
                    }));
                }
                answers
            }
            Self::QuarterTurn => {
                let yawed = Quaternion::new(1.0, 0.0, 0.0, 1.0);
                vec![Answer::Rotation(signed(yawed, behaviour.attitude))]
            }
            Self::Perturb(quaternion, turn) => {
                // By the body-to-world quaternion, of which the numbers may be the conjugate.
                let attitude = signed(given(quaternion), behaviour.attitude);
                let of_body = match behaviour.increment_sign {
                    IncrementSign::Physical => turn,
                    IncrementSign::Formal => turn.conjugate(),
                };
                let turned = match behaviour.perturbation {
                    Perturbation::Local => hamilton_product(&attitude, &of_body),
                    Perturbation::Global => hamilton_product(&of_body, &attitude),
                };
                vec![Answer::Rotation(signed(turned, behaviour.attitude))]
            }
        }
    }
}

/// Where `a * b` is minus `b * a`, as with i and j, the sign is all that tells the products apart.
fn product(handedness: Handedness, a: &Quaternion<f64>, b: &Quaternion<f64>) -> Answer {
    let (hamilton, jpl) = (hamilton_product(a, b), jpl_product(a, b));
    let product = match handedness {
        Handedness::Right => hamilton,
        Handedness::Left => jpl,
    };
    let norm = |q: Quaternion<f64>| Norm::of(q.coords.as_slice()).value();
    if norm(hamilton + jpl) <= SAME * norm(hamilton) {
        Answer::Quaternion(product)
    } else {
        Answer::Rotation(product)
    }
}

fn signed(quaternion: Quaternion<f64>, sign: ComponentSign) -> Quaternion<f64> {
    match sign {
        ComponentSign::Canonical => quaternion,
        ComponentSign::Conjugated => quaternion.conjugate(),
    }
}

fn layouts(layout: MatrixLayout, matrix: Matrix3<f64>) -> Vec<Matrix3<f64>> {
    match layout {
        MatrixLayout::Rows => vec![matrix],
        MatrixLayout::Columns => vec![matrix.transpose()],
        MatrixLayout::AsWritten | MatrixLayout::Unknown => vec![matrix, matrix.transpose()],
    }
}

impl Answer {
    /// How far what was printed is from this, relative to the size of either.
    ///
    /// Infinite for another kind of thing, and for what has no direction.
    pub(crate) fn distance(&self, printed: &Printed, array: ComponentOrder) -> f64 {
        match (self, printed) {
            (Self::Quaternion(expected), Printed::Quaternion(numbers)) => {
                let printed = numbers.in_order(array);
                between(printed.coords.as_slice(), expected.coords.as_slice())
            }
            (Self::Rotation(expected), Printed::Quaternion(numbers)) => {
                let printed = numbers.in_order(array);
                let twin = -expected;
                between(printed.coords.as_slice(), expected.coords.as_slice())
                    .min(between(printed.coords.as_slice(), twin.coords.as_slice()))
            }
            (Self::Vector(expected), Printed::Vector(printed)) => {
                between(printed.as_slice(), expected.as_slice())
            }
            (Self::Matrix(expected), Printed::Matrix(printed)) => {
                between(printed.as_slice(), expected.as_slice())
            }
            _ => f64::INFINITY,
        }
    }

    /// The answer as it is printed.
    pub(crate) fn printed(&self, array: ComponentOrder) -> Printed {
        match *self {
            Self::Rotation(quaternion) | Self::Quaternion(quaternion) => {
                let c = quaternion.coords;
                Printed::Quaternion(Numbers::AsWritten(array.array([c.w, c.x, c.y, c.z])))
            }
            Self::Vector(vector) => Printed::Vector(vector),
            Self::Matrix(matrix) => Printed::Matrix(matrix),
        }
    }
}

impl Question {
    /// Behaviours in groups that this question cannot tell apart.
    pub(crate) fn groups(&self, behaviours: &[Behaviour]) -> Vec<Vec<Behaviour>> {
        let mut groups: Vec<(Vec<Printed>, Vec<Behaviour>)> = Vec::new();
        let mut group_of = [None; Behaviour::COUNT];
        for behaviour in behaviours {
            let key = self.key(behaviour);
            if let Some((_, group)) = group_of[key].and_then(|at: usize| groups.get_mut(at)) {
                group.push(*behaviour);
                continue;
            }
            let answers = self.answers(behaviour);
            let is_same = |printed: &[Printed]| {
                let mut pairs = answers.iter().zip(printed);
                pairs.all(|(answer, printed)| answer.distance(printed, behaviour.array) < SAME)
            };
            let known = groups.iter().position(|(printed, _)| is_same(printed));
            match known.and_then(|at| groups.get_mut(at)) {
                Some((_, group)) => group.push(*behaviour),
                None => {
                    let mut printed = Vec::new();
                    for answer in answers {
                        printed.push(answer.printed(behaviour.array));
                    }
                    groups.push((printed, vec![*behaviour]));
                }
            }
            group_of[key] = Some(known.unwrap_or(groups.len() - 1));
        }
        let mut behaviours = Vec::new();
        for (_, group) in groups {
            behaviours.push(group);
        }
        behaviours
    }
}

/// The distance of two lists of numbers after each was divided by its norm.
fn between(printed: &[f64], expected: &[f64]) -> f64 {
    let (one, other) = (Norm::of(printed).value(), Norm::of(expected).value());
    if !(one.is_finite() && other.is_finite() && one > 0.0 && other > 0.0) {
        return f64::INFINITY;
    }
    let squares = printed
        .iter()
        .zip(expected)
        .map(|(p, e)| (p / one - e / other).powi(2));
    squares.sum::<f64>().sqrt()
}
