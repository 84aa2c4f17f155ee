//! One attitude in all conventions.

use crate::contract::attitude::{Column, PairedMatrix, ReadQuaternion};
use crate::contract::note::Note;
use serde::{Deserialize, Serialize};

/// One attitude in the 8 conventions of hand, function and direction, each in both orders of the components
/// (specification, table 2.1).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct AtlasReport {
    /// The attitude as it was read.
    pub quaternion: ReadQuaternion,
    /// The 16 columns, with the declared perturbation: first the eight with the scalar first, of Hamilton's
    /// product and then of JPL's, passive before active, body to world before world to body.
    pub rows: Vec<Column>,
    /// For each row the place of the first one with the same four numbers in the same places.
    pub same_as: Vec<usize>,
    /// The matrix in the declared convention of matrices.
    pub paired: PairedMatrix,
    /// What a careful reader should know about this input.
    pub notes: Vec<Note>,
}
