//! How a product and the matrix that a quaternion acts with belong together.

use crate::convention::Handedness;
use crate::convention::matrix::CosineMatrix;
use crate::convention::side::Side;
use serde::{Deserialize, Serialize};

/// How the product and the rotation of a library belong together.
///
/// The labelled conventions of [`Convention`](crate::Convention) are the first two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum Family {
    /// The Hamilton product with `R(q)`.
    Hamilton,
    /// The Shuster product with `C(q)`: what JPL means.
    Shuster,
    /// The Shuster product with `R(q)`, as row vectors want it: not JPL, although ij = −k.
    ReversedProduct,
    /// The Hamilton product with `C(q)`: the matrices multiply the other way round.
    TransposedMatrix,
}

impl Family {
    /// The family of a product and the matrix that the quaternion acts with.
    ///
    /// ```
    /// use quatlas::{CosineMatrix, Family, Handedness};
    /// // DirectXMath has JPL's product and is not JPL.
    /// let family = Family::of(Handedness::Left, CosineMatrix::Hamilton);
    /// assert_eq!(family, Family::ReversedProduct);
    /// ```
    #[must_use]
    pub const fn of(handedness: Handedness, action: CosineMatrix) -> Self {
        match (handedness, action) {
            (Handedness::Right, CosineMatrix::Hamilton) => Self::Hamilton,
            (Handedness::Left, CosineMatrix::Shuster) => Self::Shuster,
            (Handedness::Left, CosineMatrix::Hamilton) => Self::ReversedProduct,
            (Handedness::Right, CosineMatrix::Shuster) => Self::TransposedMatrix,
        }
    }

    /// The operand of `a ∘ b` that acts first on a vector.
    ///
    /// `M(a ∘ b) = M(a) M(b)` where product and matrix are of one kind, so the right operand does.
    #[must_use]
    pub const fn first_to_act(self) -> Side {
        match self {
            Self::Hamilton | Self::Shuster => Side::Right,
            Self::ReversedProduct | Self::TransposedMatrix => Side::Left,
        }
    }
}
