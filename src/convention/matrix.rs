//! What a rotation matrix means, and which formula makes one of the four numbers of a quaternion.
//!
//! A matrix has a function and a direction of its own, which need not be those of the quaternion
//! beside it (specification, section 1.7): the field guide's "My Lab" pairs an active quaternion
//! with a passive matrix. It has no order and no handedness.
//!
//! | function, direction | matrix | columns |
//! |---|---|---|
//! | passive, body to world | `R_WB` | the body axes in world coordinates |
//! | passive, world to body | `R_BW` | the world axes in body coordinates |
//! | active, body to world | `R_BW` | the world axes in body coordinates |
//! | active, world to body | `R_WB` | the body axes in world coordinates |

use crate::convention::{ComponentSign, Convention, Direction, Function, UnknownName, names};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;
use strum::VariantArray;

/// What a rotation matrix means: two independent choices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MatrixConvention {
    /// Whether the coordinates change or the vector moves.
    pub function: Function,
    /// From which frame to which.
    pub direction: Direction,
}

impl Default for MatrixConvention {
    /// Body to world.
    fn default() -> Self {
        Self::BODY_TO_WORLD
    }
}

impl MatrixConvention {
    /// `R_WB`: coordinates in the body to coordinates in the world.
    pub const BODY_TO_WORLD: Self = Self {
        function: Function::Passive,
        direction: Direction::BodyToWorld,
    };

    /// `R_BW`: coordinates in the world to coordinates in the body.
    #[doc(alias = "attitude matrix")]
    pub const WORLD_TO_BODY: Self = Self {
        function: Function::Passive,
        direction: Direction::WorldToBody,
    };

    /// All four.
    pub fn all() -> impl Iterator<Item = Self> {
        Function::ALL.into_iter().flat_map(|function| {
            Direction::ALL.map(|direction| Self {
                function,
                direction,
            })
        })
    }

    /// Which passive matrix it is: `R_WB` is body to world (τ = +1), `R_BW` world to body (τ = −1).
    ///
    /// The active matrix from X to Y is the inverse of the passive one (Cheng 2018, section 2.5).
    #[must_use]
    #[doc(alias = "tau")]
    pub const fn operator(self) -> Direction {
        self.function.passive_direction(self.direction)
    }
}

impl fmt::Display for MatrixConvention {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.function, self.direction)
    }
}

/// From its two names, in any order, each once: `world-to-body passive`.
///
/// ```
/// use quatlas::MatrixConvention;
/// let convention: MatrixConvention = "world-to-body passive".parse()?;
/// assert_eq!(convention, MatrixConvention::WORLD_TO_BODY);
/// assert_eq!(convention.to_string(), "passive world-to-body");
/// # Ok::<(), quatlas::UnknownName>(())
/// ```
impl FromStr for MatrixConvention {
    type Err = UnknownName;

    fn from_str(text: &str) -> Result<Self, UnknownName> {
        let unknown = || UnknownName {
            name: text.to_owned(),
        };
        let mut function = None;
        let mut direction = None;
        for word in text.split_whitespace() {
            let is_second = match word.parse() {
                Ok(named) => function.replace(named).is_some(),
                Err(_) => direction.replace(word.parse()?).is_some(),
            };
            if is_second {
                return Err(unknown());
            }
        }
        Ok(Self {
            function: function.ok_or_else(unknown)?,
            direction: direction.ok_or_else(unknown)?,
        })
    }
}

/// Which formula makes a matrix of the four numbers of a quaternion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, VariantArray)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[doc(alias("C_H", "C_S"))]
pub enum CosineMatrix {
    /// `C_H(q) = [(w² − v·v) I + 2 w [v]× + 2 v vᵀ] / |q|²`, which is also called `R(q)`.
    #[serde(rename = "R")]
    Hamilton,
    /// `C_S(q) = C_H(q)ᵀ`, which is also called `C(q)`.
    #[serde(rename = "C")]
    Shuster,
}

impl CosineMatrix {
    /// Both.
    pub const ALL: [Self; 2] = names::all(VariantArray::VARIANTS);

    /// The other one.
    #[must_use]
    pub const fn transposed(self) -> Self {
        match self {
            Self::Hamilton => Self::Shuster,
            Self::Shuster => Self::Hamilton,
        }
    }
}

impl Convention {
    /// The formula that makes, of this convention's numbers, the matrix of another convention.
    ///
    /// Hamilton's where the sign of the components is that of the matrix (σ = τ), Shuster's where it
    /// is not; 32 conventions times four matrices (specification, MODEL-09). With the same function
    /// and direction on both sides only the hand decides (MODEL-17).
    ///
    /// ```
    /// use quatlas::{Convention, CosineMatrix, MatrixConvention};
    /// let jpl = Convention::JPL.cosine_matrix(MatrixConvention::WORLD_TO_BODY);
    /// assert_eq!(jpl, CosineMatrix::Shuster);
    /// // The numbers of "My Lab" are Hamilton's, but its matrix is world to body.
    /// let my_lab = Convention::MY_LAB.cosine_matrix(MatrixConvention::WORLD_TO_BODY);
    /// assert_eq!(my_lab, CosineMatrix::Shuster);
    /// ```
    #[must_use]
    pub const fn cosine_matrix(self, matrix: MatrixConvention) -> CosineMatrix {
        match (self.component_sign(), matrix.operator()) {
            (ComponentSign::Canonical, Direction::BodyToWorld)
            | (ComponentSign::Conjugated, Direction::WorldToBody) => CosineMatrix::Hamilton,
            (ComponentSign::Canonical, Direction::WorldToBody)
            | (ComponentSign::Conjugated, Direction::BodyToWorld) => CosineMatrix::Shuster,
        }
    }
}
