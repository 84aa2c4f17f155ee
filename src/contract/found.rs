//! What was found around a rotation in a text.

use serde::{Deserialize, Serialize};

/// The data of [`Fact::FoundInText`](crate::Fact::FoundInText).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct FoundInText {
    /// The format that was recognised, as people call it; absent where the names alone told it.
    pub format: Option<String>,
    /// The name that the rotation has in the text; absent where it has none.
    pub label: Option<String>,
    /// The piece of the text that was read.
    pub text: String,
    /// What stands beside it.
    pub beside: Vec<Beside>,
}

/// A quantity that stands beside a rotation in a text.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Beside {
    /// What it is.
    pub quantity: BesideQuantity,
    /// The name that it has in the text; absent where it has none.
    pub label: Option<String>,
    /// The numbers as written.
    pub numbers: [f64; 3],
    /// Of a translation: where the body's origin stands in the world. The numbers themselves where the
    /// rotation leads from body to world, −Rᵀt where it leads from world to body.
    pub body_in_world: Option<[f64; 3]>,
}

/// What stands beside a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum BesideQuantity {
    /// A position, or the translation of a homogeneous matrix.
    Position,
    /// A scale along each axis.
    Scale,
}

/// The data of [`Fact::SecondDescription`](crate::Fact::SecondDescription) and
/// [`Fact::DescriptionsDisagree`](crate::Fact::DescriptionsDisagree).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct OtherDescription {
    /// The name that it has in the text; absent where it has none.
    pub label: Option<String>,
    /// The piece of the text.
    pub text: String,
    /// How far it is from the one that was read, in degrees.
    pub differs_by_deg: f64,
}

/// The data of [`Fact::SaidElsewhere`](crate::Fact::SaidElsewhere).
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SaidElsewhere {
    /// The line that says it, or its beginning.
    pub words: String,
    /// What the numbers are if it is said of them, such as `an inverse` or `left-handed axes`.
    pub what: String,
}

/// The data of [`Fact::FormatAssumed`](crate::Fact::FormatAssumed).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FormatAssumed {
    /// The format, as people call it.
    pub format: String,
}
