//! What the identification of a library of matrices answers.

use crate::convention::side::IncrementSign;
use crate::convention::{Direction, Function, Perturbation};
use serde::{Deserialize, Serialize};

/// What a library of rotation matrices means; absent is what its prints do not tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct MatricesReport {
    /// Which coordinates to which its matrix takes, as a column on the right: `R_WB` or `R_BW`.
    pub operator: Option<Direction>,
    /// Whether its labels change coordinates or move vectors.
    pub function: Option<Function>,
    /// From which frame to which its labels lead: it follows from the two above.
    pub direction: Option<Direction>,
    /// On which axes a small turn is added; it needs the operator.
    pub perturbation: Option<Perturbation>,
    /// Whether a small turn φ turns the body by φ or by −φ; it needs the operator.
    pub increment_sign: Option<IncrementSign>,
}
