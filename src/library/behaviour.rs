//! What a library may do with four numbers: eight choices.

use crate::convention::family::Family;
use crate::convention::matrix::CosineMatrix;
use crate::convention::names::serialized_by_name;
use crate::convention::order::ComponentOrder;
use crate::convention::side::{IncrementSign, Side};
use crate::convention::{ComponentSign, Direction, Handedness, Perturbation, names};
use crate::library::{Essentials, Library};
use serde::{Deserialize, Serialize};
use strum::{VariantArray, VariantNames};

/// What a library does with four numbers, as far as numbers show it.
///
/// Function and direction are not here: from numbers alone, passive body to world cannot be told from
/// active world to body (specification, MODEL-10).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Behaviour {
    /// The order of the constructor's arguments.
    pub constructor: ComponentOrder,
    /// The order in which it prints and stores.
    pub array: ComponentOrder,
    /// Its product.
    pub handedness: Handedness,
    /// What its call that rotates multiplies a column with.
    pub rotate: CosineMatrix,
    /// What its matrix of a quaternion is, row by row.
    pub matrix: CosineMatrix,
    /// Whether the quaternion of a body's attitude is that of body to world or its conjugate.
    pub attitude: ComponentSign,
    /// On which axes a small turn is added.
    pub perturbation: Perturbation,
    /// Whether adding a small turn φ turns the body by φ, which is [`IncrementSign::Physical`], or by
    /// −φ, which is [`IncrementSign::Formal`] (specification, FX-26, step 6).
    ///
    /// By −φ it turns where φ stands without a sign in the exponential of a quaternion that is
    /// conjugated (σ = −1), or of a matrix of world to body (τ = −1). Where there is no such sign to
    /// leave out, both signs are the same turn, and numbers show it as the physical one.
    pub increment_sign: IncrementSign,
}

/// One of the eight choices, under the name that its values have in [`Remaining`](crate::Remaining).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize, VariantArray)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
#[derive(VariantNames)]
#[strum(serialize_all = "camelCase")]
pub enum BehaviourAxis {
    /// [`Behaviour::constructor`]
    Constructor,
    /// [`Behaviour::array`]
    Array,
    /// [`Behaviour::handedness`]
    Handedness,
    /// [`Behaviour::rotate`]
    Rotate,
    /// [`Behaviour::matrix`]
    Matrix,
    /// [`Behaviour::attitude`]
    Attitude,
    /// [`Behaviour::perturbation`]
    Perturbation,
    /// [`Behaviour::increment_sign`]
    IncrementSign,
}

serialized_by_name!(BehaviourAxis);

impl BehaviourAxis {
    /// All eight: first those of the library, then those of how it is used.
    pub const ALL: [Self; 8] = names::all(VariantArray::VARIANTS);

    /// Those of the library itself.
    const OF_LIBRARY: [Self; 5] = [
        Self::Constructor,
        Self::Array,
        Self::Handedness,
        Self::Rotate,
        Self::Matrix,
    ];

    /// Whether a behaviour has the second of the two values of this choice.
    pub(crate) fn is_second(self, behaviour: &Behaviour) -> bool {
        match self {
            Self::Constructor => behaviour.constructor == ComponentOrder::ALL[1],
            Self::Array => behaviour.array == ComponentOrder::ALL[1],
            Self::Handedness => behaviour.handedness == Handedness::ALL[1],
            Self::Rotate => behaviour.rotate == CosineMatrix::ALL[1],
            Self::Matrix => behaviour.matrix == CosineMatrix::ALL[1],
            Self::Attitude => behaviour.attitude == ComponentSign::ALL[1],
            Self::Perturbation => behaviour.perturbation == Perturbation::ALL[1],
            Self::IncrementSign => behaviour.increment_sign == IncrementSign::ALL[1],
        }
    }
}

impl Behaviour {
    /// How many there are: 256.
    pub(crate) const COUNT: usize = 1 << BehaviourAxis::ALL.len();

    /// All 256.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..Self::COUNT).map(Self::of_bits)
    }

    /// One bit for each choice, in their order: 0 for the first of its values and 1 for the second.
    fn of_bits(bits: usize) -> Self {
        let bit = |axis: BehaviourAxis| bits >> axis as usize & 1;
        Self {
            constructor: ComponentOrder::ALL[bit(BehaviourAxis::Constructor)],
            array: ComponentOrder::ALL[bit(BehaviourAxis::Array)],
            handedness: Handedness::ALL[bit(BehaviourAxis::Handedness)],
            rotate: CosineMatrix::ALL[bit(BehaviourAxis::Rotate)],
            matrix: CosineMatrix::ALL[bit(BehaviourAxis::Matrix)],
            attitude: ComponentSign::ALL[bit(BehaviourAxis::Attitude)],
            perturbation: Perturbation::ALL[bit(BehaviourAxis::Perturbation)],
            increment_sign: IncrementSign::ALL[bit(BehaviourAxis::IncrementSign)],
        }
    }

    /// Which of these choices have the second of their values, one bit each.
    pub(crate) fn bits_of(&self, axes: &[BehaviourAxis]) -> usize {
        let second = axes.iter().filter(|axis| axis.is_second(self));
        second.map(|&axis| 1 << axis as usize).sum()
    }

    /// The behaviour that differs in this choice alone.
    pub(crate) fn with_other(&self, axis: BehaviourAxis) -> Self {
        Self::of_bits(self.bits_of(&BehaviourAxis::ALL) ^ 1 << axis as usize)
    }

    /// The five choices of the library itself, which do not depend on how it is used, one bit each.
    pub(crate) fn of_library(&self) -> usize {
        self.bits_of(&BehaviourAxis::OF_LIBRARY)
    }

    /// The operand of `a * b` that acts first on a vector.
    #[must_use]
    pub fn first_to_act(&self) -> Side {
        Family::of(self.handedness, self.rotate).first_to_act()
    }

    /// Which coordinates to which the call that rotates takes.
    #[must_use]
    pub fn direction(&self) -> Direction {
        match (self.rotate, self.attitude) {
            (CosineMatrix::Hamilton, ComponentSign::Canonical)
            | (CosineMatrix::Shuster, ComponentSign::Conjugated) => Direction::BodyToWorld,
            (CosineMatrix::Shuster, ComponentSign::Canonical)
            | (CosineMatrix::Hamilton, ComponentSign::Conjugated) => Direction::WorldToBody,
        }
    }

    /// Whether a record says nothing else; how it rotates may be told by its matrix alone.
    #[must_use]
    pub fn is_of(&self, library: &Library) -> bool {
        self.agrees_with(&library.essentials())
    }

    /// [`Behaviour::is_of`]
    pub(crate) fn agrees_with(&self, library: &Essentials) -> bool {
        agrees(library.constructor_order, self.constructor)
            && agrees(library.array_order, self.array)
            && agrees(library.handedness, self.handedness)
            && agrees(library.action(), self.rotate)
            && agrees(library.matrix, self.matrix)
    }
}

impl Library {
    /// The choices of which the record says nothing.
    #[must_use]
    pub fn unestablished(&self) -> Vec<BehaviourAxis> {
        self.essentials().unestablished()
    }
}

impl Essentials {
    /// [`Library::unestablished`]
    pub(crate) fn unestablished(&self) -> Vec<BehaviourAxis> {
        let choices = [
            (BehaviourAxis::Constructor, self.constructor_order.is_none()),
            (BehaviourAxis::Array, self.array_order.is_none()),
            (BehaviourAxis::Handedness, self.handedness.is_none()),
            (BehaviourAxis::Rotate, self.action().is_none()),
            (BehaviourAxis::Matrix, self.matrix.is_none()),
        ];
        let mut missing = Vec::new();
        for (axis, is_missing) in choices {
            if is_missing {
                missing.push(axis);
            }
        }
        missing
    }
}

fn agrees<Value: PartialEq>(established: Option<Value>, value: Value) -> bool {
    established.is_none_or(|established| established == value)
}
