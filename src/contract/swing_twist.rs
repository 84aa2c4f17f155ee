//! A turn about an axis, and the rest.

use crate::contract::attitude::{Components, ReadQuaternion, Turn};
use crate::contract::note::Note;
use serde::{Deserialize, Serialize};

/// An attitude as a twist about an axis, and a swing that has none.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct SwingTwistReport {
    /// The attitude as it was read.
    pub quaternion: ReadQuaternion,
    /// The axis, of length 1; it has the same coordinates in the world and in the twisted body.
    pub axis: [f64; 3],
    /// The angle of the twist, right-handed about the axis, above −π and up to π; absent where no twist is
    /// nearer than the others, at half a turn about an axis that is perpendicular.
    pub twist_rad: Option<f64>,
    /// The same angle in degrees.
    pub twist_deg: Option<f64>,
    /// The quaternion of the twist in the declared convention.
    pub twist: Components,
    /// What follows the twist on the world's axes, `R_WB = R_swing R_twist`.
    pub swing: Turn,
    /// The quaternion of that swing in the declared convention.
    pub swing_quaternion: Components,
    /// The same swing on the axes of the twisted body, `R_WB = R_twist R_swing`.
    pub body_swing: Turn,
    /// The quaternion of that one in the declared convention.
    pub body_swing_quaternion: Components,
    /// What a careful reader should know about these inputs.
    pub notes: Vec<Note>,
}
