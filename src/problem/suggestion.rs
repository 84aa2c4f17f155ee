//! A text to write in place of one that has a problem, or of which a note asks what it means.

use crate::convention::names::serialized_by_name;
#[cfg(not(feature = "whole"))]
use serde::Serializer;
use serde::{Deserialize, Serialize};
use strum::VariantNames;

/// A whole text to write in place of one that has a problem, or of which a note asks what it means.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Suggestion {
    /// What was done to the text.
    pub remedy: Remedy,
    /// The text, which is read without a problem.
    pub text: String,
    /// What it is of several, in the words of the text that it was taken from, such as `T_cam_imu` or
    /// `row 2`; absent where the remedy says it all.
    pub label: Option<String>,
}

impl Suggestion {
    /// A text without a label.
    pub(crate) fn new(remedy: Remedy, text: impl Into<String>) -> Self {
        Self {
            remedy,
            text: text.into(),
            label: None,
        }
    }
}

/// Several of them, in the order in which they are offered.
#[cfg(feature = "whole")]
pub type Suggestions = Box<[Suggestion]>;

/// Several of them, which are none: a build without the feature `whole` has no place for one.
#[cfg(not(feature = "whole"))]
pub type Suggestions = [Suggestion; 0];

/// What is found; a build without the feature `whole` looks for none.
#[cfg(feature = "whole")]
pub(crate) fn suggestions(find: impl FnOnce() -> Vec<Suggestion>) -> Suggestions {
    find().into()
}

#[cfg(not(feature = "whole"))]
pub(crate) fn suggestions(_: impl FnOnce() -> Vec<Suggestion>) -> Suggestions {
    []
}

/// That there is no suggestion, without the code that writes one.
#[cfg(not(feature = "whole"))]
pub(crate) fn none<S: Serializer>(
    _: &Option<Box<Suggestion>>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.serialize_none()
}

/// What a [`Suggestion`] does to a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize, VariantNames)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
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
    /// The axis that a reflection flips is turned round.
    RestoreAxis,
    /// The rotation that is nearest to the matrix stands in its place.
    NearestRotation,
    /// The numbers are said to be those of a quaternion, whatever its norm.
    AsQuaternion,
    /// The numbers are said to be an axis and an angle, with the unit of the angle.
    AsAxisAngle,
    /// One number is said to be the yaw, with its unit; those of a position are left out.
    AsYaw,
    /// The numbers are said to be Euler angles, with their sequence and their unit.
    AsEulerAngles,
    /// One of the rotations of the text is kept alone; the label says which.
    ThisRotation,
    /// The sequence of the angles is written before them.
    WithSequence,
    /// The numbers get the names that they have in the other order of components.
    OtherOrder,
    /// A frame gets the name of another one: the text. Where it is one of several choices, the label is
    /// the name that it has.
    RenameFrame,
    /// The pose of a frame, the text, in another one, the label, is added.
    AddPose,
}

serialized_by_name!(Remedy);
