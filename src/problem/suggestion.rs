//! A text to write in place of one that has a problem.

use serde::{Deserialize, Serialize};

/// A whole text to write in place of one that has a problem.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Suggestion {
    /// What was done to the text.
    pub remedy: Remedy,
    /// The text, which is read without a problem.
    pub text: String,
}

/// What a [`Suggestion`] does to a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Remedy {
    /// Brackets are closed, replaced by their match, or removed where they close nothing.
    MatchBrackets,
    /// Decimal commas become points.
    DecimalPoints,
    /// Full-width digits and marks become those of ASCII.
    PlainCharacters,
    /// A mark that only decorates, or joins nothing, is removed.
    RemoveMark,
    /// The space between a sign and its number is removed.
    AttachSign,
    /// A space is put between two numbers that run together.
    SeparateNumbers,
    /// A plus is put before a term of a sum.
    AddSign,
    /// Components or angles that are missing are written as 0.
    AddZeros,
    /// The number without a name gets the one name that is left.
    NameNumber,
    /// Every angle gets the unit that one of them has.
    SameUnit,
    /// A number that is smaller than any double becomes 0.
    WriteZero,
    /// The rotation of no turn stands in place of zeros.
    WriteIdentity,
    /// Only the upper left three by three numbers of a homogeneous matrix are kept.
    RotationPart,
    /// The axis that a reflection flips is turned round.
    RestoreAxis,
    /// The rotation that is nearest to the matrix stands in its place.
    NearestRotation,
}
