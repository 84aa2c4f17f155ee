//! What is asked: text as it was typed, and the convention it is declared to be in.

use crate::convention::Convention;
use serde::{Deserialize, Serialize};

/// A question to [`analyze`](crate::analyze()), one kind for each view of the page.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(tag = "view", rename_all = "kebab-case")]
pub enum Request {
    /// What does this quaternion mean?
    Read(ReadRequest),
    /// What do these two make together?
    Compose(ComposeRequest),
}

/// One quaternion and one vector.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ReadRequest {
    /// The quaternion, in any accepted form (see [`parse`](mod@crate::parse)).
    pub quaternion: String,
    /// The vector `x`, in any accepted form.
    pub vector: String,
    /// What the four numbers are declared to mean.
    pub convention: Convention,
}

/// Two quaternions and one vector.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ComposeRequest {
    /// The left operand.
    pub p: String,
    /// The right operand.
    pub q: String,
    /// The vector `x` that both turn, one after the other.
    pub vector: String,
    /// What the numbers of both are declared to mean.
    pub convention: Convention,
}
