//! The side of a product on which a small turn stands, and the sign with which.

use crate::convention::matrix::MatrixConvention;
use crate::convention::{ComponentSign, Convention, Direction, Perturbation, names};
use serde::{Deserialize, Serialize};
use strum::VariantArray;

/// A side of a product.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// Before the attitude: `δ∘q`.
    Left,
    /// After it: `q∘δ`.
    Right,
}

/// Whether an increment is the turn of the body or what a convention's own exponential takes.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, VariantArray,
)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum IncrementSign {
    /// δ, the right-handed turn of the body.
    #[default]
    Physical,
    /// θ = σδ for quaternions, τδ for matrices: the logarithm of the error as it stands.
    Formal,
}

impl IncrementSign {
    /// Both.
    pub const ALL: [Self; 2] = names::all(VariantArray::VARIANTS);
}

/// The side on which an increment stands, for an operator and the axes of the increment.
const fn side(operator: Direction, axes: Perturbation) -> Side {
    match (operator, axes) {
        (Direction::BodyToWorld, Perturbation::Local)
        | (Direction::WorldToBody, Perturbation::Global) => Side::Right,
        (Direction::BodyToWorld, Perturbation::Global)
        | (Direction::WorldToBody, Perturbation::Local) => Side::Left,
    }
}

const fn sign_of(component_sign: ComponentSign) -> f64 {
    match component_sign {
        ComponentSign::Canonical => 1.0,
        ComponentSign::Conjugated => -1.0,
    }
}

impl Convention {
    /// The side on which an increment multiplies the quaternion: `q∘Exp(σδ)` or `Exp(σδ)∘q`.
    #[must_use]
    pub const fn increment_side(self) -> Side {
        side(self.operator(), self.perturbation)
    }

    /// What an increment of this sign is multiplied by before the exponential: σ or 1.
    pub(crate) const fn increment_factor(self, sign: IncrementSign) -> f64 {
        match sign {
            IncrementSign::Physical => sign_of(self.component_sign()),
            IncrementSign::Formal => 1.0,
        }
    }
}

impl MatrixConvention {
    /// The side on which an increment on these axes multiplies the matrix.
    #[must_use]
    pub const fn increment_side(self, axes: Perturbation) -> Side {
        side(self.operator(), axes)
    }

    /// What an increment of this sign is multiplied by before the exponential: τ or 1.
    pub(crate) const fn increment_factor(self, sign: IncrementSign) -> f64 {
        match (sign, self.operator()) {
            (IncrementSign::Formal, _) | (_, Direction::BodyToWorld) => 1.0,
            (IncrementSign::Physical, Direction::WorldToBody) => -1.0,
        }
    }
}
