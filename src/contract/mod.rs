//! What is answered: plain numbers and names, the source of the TypeScript types.
//!
//! No number here is NaN, infinite or −0. A number that a double cannot hold is
//! absent, and a [`Note`] says so. A matrix is a list of its rows, and multiplies a column from the
//! left.

// One attitude in all conventions.
#[cfg(feature = "whole")]
mod atlas;

// One attitude in the report.
mod attitude;

// From one attitude to another.
#[cfg(feature = "whole")]
mod between;

// Many attitudes one after the other.
#[cfg(feature = "whole")]
mod chain;

// What stands around a rotation in a text.
#[cfg(feature = "whole")]
mod found;

// What is asked of poses between frames, and what follows.
#[cfg(feature = "whole")]
pub(crate) mod frames;

// What an identification answers.
pub(crate) mod identification;

// What a careful reader should know.
mod note;

// What the identification of a library of matrices answers.
mod matrices;

// What is asked and answered of an attitude in motion.
#[cfg(feature = "whole")]
mod motion;

// What numbers beside an attitude are.
mod numbers;

/// What was tried on a library.
pub mod probe;

/// What is asked.
pub mod request;

// A turn about an axis, and the rest.
#[cfg(feature = "whole")]
mod swing_twist;

// What is typed.
mod text;

// What a translation answers.
mod translation;

#[cfg(feature = "whole")]
pub use crate::contract::atlas::*;
pub use crate::contract::attitude::*;
#[cfg(feature = "whole")]
pub use crate::contract::between::*;
#[cfg(feature = "whole")]
pub use crate::contract::chain::*;
#[cfg(feature = "whole")]
pub use crate::contract::found::*;
#[cfg(feature = "whole")]
pub use crate::contract::frames::*;
pub use crate::contract::identification::*;
pub use crate::contract::matrices::*;
#[cfg(feature = "whole")]
pub use crate::contract::motion::*;
pub use crate::contract::note::*;
pub use crate::contract::numbers::*;
#[cfg(feature = "whole")]
pub use crate::contract::swing_twist::*;
pub use crate::contract::text::*;
pub use crate::contract::translation::*;
use crate::convention::{Convention, Direction};
use crate::problem::{Field, Problem};
use serde::{Deserialize, Serialize};

/// A report, or the problems that stand in its way.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(tag = "status", rename_all = "kebab-case")]
pub enum Outcome {
    /// The answer to a [`Request::Read`](crate::Request::Read).
    Read(Box<ReadReport>),
    /// The answer to a [`Request::Compose`](crate::Request::Compose).
    Compose(Box<ComposeReport>),
    /// The answer to a [`Request::Translate`](crate::Request::Translate).
    Translate(Box<TranslateReport>),
    /// The answer to a [`Request::Identify`](crate::Request::Identify); problems of its texts are in it.
    Identify(Box<IdentifyReport>),
    /// The answer to a [`Request::Numbers`](crate::Request::Numbers).
    Numbers(Box<NumbersReport>),
    /// The answer to a [`Request::Matrices`](crate::Request::Matrices).
    Matrices(MatricesReport),
    /// The answer to a [`Request::Between`](crate::Request::Between).
    #[cfg(feature = "whole")]
    Between(Box<BetweenReport>),
    /// The answer to a [`Request::Chain`](crate::Request::Chain).
    #[cfg(feature = "whole")]
    Chain(Box<ChainReport>),
    /// The answer to a [`Request::Atlas`](crate::Request::Atlas).
    #[cfg(feature = "whole")]
    Atlas(Box<AtlasReport>),
    /// The answer to a [`Request::SwingTwist`](crate::Request::SwingTwist).
    #[cfg(feature = "whole")]
    SwingTwist(Box<SwingTwistReport>),
    /// The answer to a [`Request::Frames`](crate::Request::Frames); problems of its texts are in it.
    #[cfg(feature = "whole")]
    Frames(Box<FramesReport>),
    /// The answer to a [`Request::Motion`](crate::Request::Motion).
    #[cfg(feature = "whole")]
    Motion(Box<MotionReport>),
    /// At least one text could not be read; every text's first problem is here.
    Problems(Problems),
}

/// Every text's first problem, in the order of the request.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Problems {
    /// At least one.
    pub problems: Vec<Problem>,
}

/// What one quaternion means in both conventions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ReadReport {
    /// The attitude as it was read, before anything was done to it.
    pub quaternion: ReadQuaternion,
    /// The vector `v` as it was read.
    pub vector: [f64; 3],
    /// The attitude in the declared convention, whichever of the 32 it is.
    pub declared: Column,
    /// What the declared convention multiplies in which order; the same as in `declared`.
    pub rules: Rules,
    /// The matrix in the declared convention of matrices.
    pub paired: PairedMatrix,
    /// The attitude as a Hamilton quaternion, body to world, with the declared perturbation.
    pub hamilton: Column,
    /// The same attitude as a JPL quaternion, world to body, with the declared perturbation.
    pub jpl: Column,
    /// The JPL quaternion whose matrix is the Hamilton column's, body to world: the conjugate
    /// (Yoosefian 2021, eq. 18).
    pub jpl_with_same_matrix: Components,
    /// The turn that carries the world axes onto the body axes; it is the same in every
    /// convention.
    pub turn: Turn,
    /// The same attitude as Euler angles in the requested sequence.
    pub euler: Euler,
    /// What a careful reader should know about this input.
    pub notes: Vec<Note>,
}

/// What two quaternions make together, in both products and both orders.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ComposeReport {
    /// The left operand as it was read.
    pub p: ReadQuaternion,
    /// The right operand as it was read.
    pub q: ReadQuaternion,
    /// The turn of the body that p is, about axes that it leaves where they are.
    pub p_turn: Turn,
    /// The turn of the body that q is.
    pub q_turn: Turn,
    /// The vector `v` as it was read.
    pub vector: [f64; 3],
    /// `p∘q` in the declared convention, whichever of the 32 it is.
    pub declared: Product,
    /// p ⊙ q, q ⊙ p, p ⊗ q, q ⊗ p.
    pub products: Vec<Product>,
    /// Whether the order of the two matters.
    pub order_matters: OrderMatters,
    /// What a careful reader should know about these inputs.
    pub notes: Vec<Note>,
}

/// Whether p∘q and q∘p are the same quaternion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum OrderMatters {
    /// They differ.
    Yes,
    /// They are the same: the axes are parallel, or one of the two is no turn.
    No,
    /// They are q and −q: two quaternions of one rotation (half turns about perpendicular axes).
    OnlyInSign,
}

/// One of the two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum Operand {
    /// The quaternion that was typed as p.
    P,
    /// The quaternion that was typed as q.
    Q,
}

/// A frame of a composition.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum Frame {
    /// W, the world.
    World,
    /// B, the body.
    Body,
    /// C, a second body whose attitude is given relative to B.
    SecondBody,
}

/// One product of p and q.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Product {
    /// The convention of the product, ⊙ for the right hand and ⊗ for the left.
    pub convention: Convention,
    /// The operand on the left of the sign.
    pub left: Operand,
    /// The operand on the right of the sign. It acts on a vector first.
    pub right: Operand,
    /// The product.
    pub quaternion: Components,
    /// The turn that carries the world axes onto the axes of the second body, from the attitudes that
    /// are multiplied. Products with the same numbers have the same turn: p ⊙ q body to world and
    /// q ⊗ p world to body are one attitude, and nothing is conjugated.
    pub turn: Turn,
    /// R(left ⊙ right) = R(left) R(right) for Hamilton, C(left ⊗ right) = C(left) C(right) for JPL.
    pub matrix: [[f64; 3]; 3],
    /// `v` after the right operand, then after both; absent where a double cannot hold it.
    pub images: Option<[[f64; 3]; 2]>,
    /// Which frame's coordinates to which the matrix takes.
    pub direction: Direction,
    /// The frames on the way of a vector: where it starts, where the two meet, where it ends.
    pub frames: [Frame; 3],
    /// The operand whose turn comes first when every turn is about the fixed axes; about the
    /// moving axes it is the other one.
    pub first_about_fixed_axes: Operand,
    /// The places in the list of products that have the same numbers, its own included.
    pub equal_to: Vec<usize>,
}

impl Outcome {
    /// The same outcome with every span counted in UTF-16 units of the text it points into: the text
    /// of a field, of the observation at a place where there are several. Of [`Outcome::Frames`] 0 is
    /// the question, and 1 the first of the poses.
    #[must_use]
    pub fn in_utf16(self, text_of: impl Fn(Field, usize) -> String) -> Self {
        match self {
            Self::Problems(problems) => Self::Problems(problems.in_utf16(text_of)),
            Self::Identify(report) => Self::Identify(Box::new(report.in_utf16(text_of))),
            #[cfg(feature = "whole")]
            Self::Frames(report) => {
                let of_pose = |field, at: usize| text_of(field, at + 1);
                Self::Frames(Box::new(
                    report.in_utf16(of_pose, |field| text_of(field, 0)),
                ))
            }
            Self::Read(_)
            | Self::Compose(_)
            | Self::Translate(_)
            | Self::Numbers(_)
            | Self::Matrices(_) => self,
            #[cfg(feature = "whole")]
            Self::Between(_)
            | Self::Chain(_)
            | Self::Atlas(_)
            | Self::SwingTwist(_)
            | Self::Motion(_) => self,
        }
    }
}

impl Problems {
    pub(crate) fn in_utf16(mut self, text_of: impl Fn(Field, usize) -> String) -> Self {
        for problem in &mut self.problems {
            problem.span = problem
                .span
                .in_utf16(&text_of(problem.field, problem.at.into()));
        }
        self
    }
}
