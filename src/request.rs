//! What is asked: text as it was typed, and the convention it is declared to be in.

use crate::convention::Convention;
use crate::euler_sequence::EulerSequence;
use crate::rotation_matrix::MatrixConvention;
use serde::{Deserialize, Serialize};

/// A question to [`analyze`](crate::analyze()), one kind for each view of the page.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(tag = "view", rename_all = "kebab-case")]
pub enum Request {
    /// What does this attitude mean?
    Read(ReadRequest),
    /// What do these two make together?
    Compose(ComposeRequest),
}

/// One attitude and one vector.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ReadRequest {
    /// The attitude, as a quaternion or in any other accepted form (see [`parse`](mod@crate::parse)).
    pub quaternion: String,
    /// The vector `x`, in any accepted form.
    pub vector: String,
    /// What four numbers are declared to mean.
    pub convention: Convention,
    /// What nine numbers are declared to mean; body to world where it is left out.
    #[serde(default)]
    pub matrix: MatrixConvention,
    /// The sequence of the Euler angles in the answer; intrinsic ZYX where it is left out.
    #[serde(default)]
    pub euler: EulerSequence,
}

/// Two attitudes and one vector.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ComposeRequest {
    /// The left operand.
    pub p: String,
    /// The right operand.
    pub q: String,
    /// The vector `x` that both turn, one after the other.
    pub vector: String,
    /// What four numbers of either are declared to mean.
    pub convention: Convention,
    /// What nine numbers of either are declared to mean; body to world where it is left out.
    #[serde(default)]
    pub matrix: MatrixConvention,
}

impl ReadRequest {
    /// The request with a matrix body to world and the Euler angles of the aerospace sequence.
    #[must_use]
    pub fn new(quaternion: &str, vector: &str, convention: Convention) -> Self {
        Self {
            quaternion: quaternion.to_owned(),
            vector: vector.to_owned(),
            convention,
            matrix: MatrixConvention::default(),
            euler: EulerSequence::default(),
        }
    }
}

impl ComposeRequest {
    /// The request with matrices body to world.
    #[must_use]
    pub fn new(p: &str, q: &str, vector: &str, convention: Convention) -> Self {
        Self {
            p: p.to_owned(),
            q: q.to_owned(),
            vector: vector.to_owned(),
            convention,
            matrix: MatrixConvention::default(),
        }
    }
}
