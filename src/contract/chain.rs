//! What the product of many attitudes answers.

use crate::contract::attitude::{Column, Components, Euler, ReadQuaternion, Turn};
use crate::contract::note::Note;
use serde::{Deserialize, Serialize};

/// The factors of a chain multiplied out, in the order in which they are listed.
///
/// The three columns are one attitude. In those whose `rules.operator` is that of `declared` the factors
/// stand in the listed order, in the others in reverse: `a ⊙ b ⊙ c` body to world and `c ⊗ b ⊗ a` world to
/// body are one (Cheng 2018, eqs. 2.23 to 2.26). A factor is conjugated only where it is to be inverted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ChainReport {
    /// The factors as they were read, before any is inverted.
    pub factors: Vec<ReadQuaternion>,
    /// The product in the declared convention, with the norm that the factors give it.
    pub declared: Column,
    /// The same attitude as a Hamilton quaternion.
    pub hamilton: Column,
    /// The same attitude as a JPL quaternion.
    pub jpl: Column,
    /// The turn that carries the world axes onto those of the last body.
    pub turn: Turn,
    /// The product as Euler angles in the requested sequence.
    pub euler: Euler,
    /// The attitude in the middle of the factors as they stand in the chain, as a quaternion of the declared
    /// convention (Markley et al. 2007); absent where none is nearer to all than others.
    pub mean: Option<Components>,
    /// What a careful reader should know about the factors, and at the end about the product.
    pub notes: Vec<Note>,
    /// For each note the place of its factor.
    pub noted: Vec<usize>,
}
