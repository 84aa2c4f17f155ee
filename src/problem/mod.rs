//! One problem: a stable code, a place in the text, and sentences that help.
//!
//! A problem never ends the program: it is data, returned in place of a
//! report. What each says stands in `sentences/`.

/// What is wrong with a text.
pub mod fault;

// A problem as lines of text.
mod render;

// What each problem says.
pub(crate) mod sentences;

/// A text to write in place of one with a problem.
pub mod suggestion;

use crate::convention::names::serialized_by_name;
use crate::problem::suggestion::{Suggestion, Suggestions};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::ops::Range;
use strum::VariantNames;

/// Which text of a request a problem or a note is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[derive(VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub enum Field {
    /// The quaternion of the Read view.
    Quaternion,
    /// The left operand `p` of the Compose view.
    P,
    /// The right operand `q` of the Compose view.
    Q,
    /// The vector `v`.
    Vector,
    /// Where a translation comes from.
    From,
    /// Where a translation goes to.
    To,
    /// The change of the world axes of a translation.
    WorldAxes,
    /// The change of the body axes of a translation.
    BodyAxes,
    /// The left operand of an observed product.
    A,
    /// The right operand of an observed product.
    B,
    /// The matrix that went into an observed library.
    Matrix,
    /// The rotation vector of an observed perturbation.
    RotationVector,
    /// What an observed library printed.
    Printed,
    /// Numbers beside an attitude.
    Numbers,
    /// The matrix that an observed library printed of a yawed body.
    Yawed,
    /// The matrix that an observed library printed of two turns.
    Product,
    /// The part of the way between two attitudes.
    #[cfg(feature = "whole")]
    Part,
    /// A factor of a chain; [`Problem::at`] says which.
    #[cfg(feature = "whole")]
    Factor,
    /// The axis of a twist.
    #[cfg(feature = "whole")]
    Axis,
    /// The name of the frame in which a pose is given or asked for.
    #[cfg(feature = "whole")]
    Parent,
    /// The name of the frame whose pose it is.
    #[cfg(feature = "whole")]
    Child,
    /// The rotation of a pose.
    #[cfg(feature = "whole")]
    Rotation,
    /// The position of a pose.
    #[cfg(feature = "whole")]
    Position,
    /// A point in the frame that is asked about.
    #[cfg(feature = "whole")]
    Point,
    /// An angular velocity.
    #[cfg(feature = "whole")]
    Rate,
    /// The angular velocity at the end.
    #[cfg(feature = "whole")]
    RateEnd,
    /// How long a motion lasts.
    #[cfg(feature = "whole")]
    Duration,
    /// A small turn.
    #[cfg(feature = "whole")]
    Increment,
    /// A covariance.
    #[cfg(feature = "whole")]
    Covariance,
}

serialized_by_name!(Field);

/// The most bytes of text that are read: far more than any quaternion, few enough to answer at once.
pub(crate) const MAX_TEXT_BYTES: usize = 131_072;

/// Whether a text is longer than any that is read.
pub(crate) const fn is_too_long(text: &str) -> bool {
    text.len() > MAX_TEXT_BYTES
}

/// A half-open range of a text.
///
/// Inside the crate it counts bytes of UTF-8; at the JavaScript boundary it is
/// turned into UTF-16 units by [`Span::in_utf16`], which is what an HTML text
/// field counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Span {
    /// The first unit inside.
    pub start: usize,
    /// The first unit after it.
    pub end: usize,
}

impl Span {
    /// The text without the white space around it; all of a text that is too long to look at.
    pub(crate) fn of_trimmed(text: &str) -> Self {
        if is_too_long(text) {
            return Self::from(0..text.len());
        }
        let start = text.len() - text.trim_start().len();
        Self::from(start..text.trim_end().len().max(start))
    }

    /// The smallest span that holds both.
    #[must_use]
    pub fn to(self, other: Self) -> Self {
        Self {
            start: self.start.min(other.start),
            end: self.end.max(other.end),
        }
    }

    /// The same place counted in UTF-16 units of `text`, from a span in bytes.
    ///
    /// A position inside a character or past the end moves back to the nearest
    /// place where a character starts.
    ///
    /// ```
    /// use quatlas::Span;
    /// // The emoji takes 4 bytes and 2 UTF-16 units.
    /// let bytes = Span { start: 4, end: 5 };
    /// assert_eq!(bytes.in_utf16("🙂x"), Span { start: 2, end: 3 });
    /// ```
    #[must_use]
    pub fn in_utf16(self, text: &str) -> Self {
        let units = |byte| text[..floor_boundary(text, byte)].encode_utf16().count();
        Self {
            start: units(self.start),
            end: units(self.end),
        }
    }
}

impl From<Range<usize>> for Span {
    fn from(range: Range<usize>) -> Self {
        Self {
            start: range.start,
            end: range.end,
        }
    }
}

/// What kind of problem it is; the names are stable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[derive(VariantNames)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum ProblemCode {
    /// Nothing but white space.
    EmptyText,
    /// More text than is read.
    TextTooLong,
    /// More brackets inside brackets than are read.
    NestedTooDeep,
    /// A character that has no meaning here.
    UnexpectedCharacter,
    /// A number, name or sign in a place where it cannot stand.
    Unexpected,
    /// The text stops where a number should follow.
    UnexpectedEnd,
    /// A bracket that is never closed.
    UnclosedBracket,
    /// A closing bracket that closes nothing, or closes another kind.
    UnmatchedBracket,
    /// A word that is not a number, a unit or a function.
    UnknownWord,
    /// A label or a comment that names something else than the rotation, or another convention than is
    /// declared.
    OtherQuantity,
    /// Too few or too many numbers.
    WrongCount,
    /// A component that is named twice.
    DuplicateComponent,
    /// A component that is not named while others are.
    MissingComponent,
    /// A name that is no component.
    UnknownComponent,
    /// Some numbers are named and some are not.
    MixedNames,
    /// A division by zero.
    DivisionByZero,
    /// Not a number, or an expression that has no real value.
    NotANumber,
    /// Infinity.
    Infinite,
    /// Too large for a double.
    TooLarge,
    /// Not zero, but so small that a double would make it zero.
    TooSmall,
    /// A product of two imaginary units, whose sign is the very question.
    ProductOfUnits,
    /// A scalar part where a vector is meant.
    ScalarInVector,
    /// A zero quaternion, which is no rotation.
    ZeroQuaternion,
    /// Numbers of a norm that no quaternion of a rotation has: zero but for rounding, or hundreds.
    FarFromUnit,
    /// A matrix with a negative determinant.
    Reflection,
    /// A matrix that is far from every rotation, or an axis of which a call makes none.
    NotARotation,
    /// An axis of length zero.
    ZeroAxis,
    /// Letters that are no Euler sequence, or angles without a sequence.
    UnknownSequence,
    /// Numbers that mean one of two things, which only a word can tell.
    TwoMeanings,
    /// Degrees and radians in one rotation, or a unit at some of its angles only.
    MixedUnits,
    /// Several rotations, of which one has to be chosen.
    SeveralRotations,
    /// Letters and signs that say how something is made of others, without numbers.
    Formula,
    /// Another description of a rotation where only a quaternion is read.
    NotAQuaternion,
    /// Another description of a rotation where only a matrix is read.
    NotAMatrix,
    /// An id that no library of the table has.
    UnknownLibrary,
    /// A text that names no mapping of axes.
    UnknownAxes,
    /// Axes of the other hand on one side only.
    OneSidedReflection,
    /// A frame without a name.
    #[cfg(feature = "whole")]
    UnnamedFrame,
    /// One frame where two are needed.
    #[cfg(feature = "whole")]
    SameFrame,
    /// A name that no frame has.
    #[cfg(feature = "whole")]
    UnknownFrame,
    /// Two frames between which nothing is known.
    #[cfg(feature = "whole")]
    FramesDoNotMeet,
    /// More poses than are read.
    #[cfg(feature = "whole")]
    TooManyPoses,
    /// A rate, a small turn or a duration outside of what is answered.
    #[cfg(feature = "whole")]
    OutOfBounds,
    /// What no library prints of what was put in.
    FitsNoConvention,
    /// Nine numbers that are no covariance.
    #[cfg(feature = "whole")]
    NotACovariance,
}

serialized_by_name!(ProblemCode);

impl ProblemCode {
    /// The stable name, as it is written in JavaScript and in the test files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        <Self as VariantNames>::VARIANTS[self as usize]
    }
}

/// Why a text has no result: the place, what is wrong, what was expected, what to try.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Problem {
    /// The stable name of the kind of problem.
    pub code: ProblemCode,
    /// The text it is about.
    pub field: Field,
    /// The place of that text among several of its kind, such as factors, from 0 to 255; else 0.
    #[serde(default)]
    #[cfg_attr(not(feature = "whole"), serde(skip))]
    pub at: u8,
    /// Where in that text: bytes in Rust, UTF-16 units in JavaScript.
    pub span: Span,
    /// What is wrong, in one sentence; without the feature `whole` it is empty, as are the next two.
    pub message: String,
    /// What was expected at that place.
    pub expected: String,
    /// What to try.
    pub hint: String,
    /// The text to write in its place, where that is certain; in the answers of
    /// [`analyze`](fn@crate::analyze) only, and only with the feature `whole`.
    #[cfg_attr(not(feature = "whole"), serde(serialize_with = "suggestion::none"))]
    pub suggestion: Option<Box<Suggestion>>,
    /// The texts of which a reader has to choose one, in the order in which they are offered, where what
    /// is meant is a question, as of several rotations; mostly none. Where and when as the suggestion.
    pub choices: Suggestions,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.message)
    }
}

impl std::error::Error for Problem {}

/// What a text is meant to hold, which decides the examples in its messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wanted {
    Quaternion,
    Vector,
}

impl Wanted {
    pub(crate) const fn count(self) -> usize {
        match self {
            Self::Quaternion => 4,
            Self::Vector => 3,
        }
    }

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Quaternion => "quaternion",
            Self::Vector => "vector",
        }
    }

    pub(crate) const fn in_words(self) -> &'static str {
        match self {
            Self::Quaternion => {
                "a quaternion, axis and angle, a rotation vector, Euler angles or a matrix"
            }
            Self::Vector => "a vector: three numbers, or x, y and z by name",
        }
    }

    pub(crate) const fn example(self) -> &'static str {
        match self {
            Self::Quaternion => "1/sqrt(2) 0 0 1/sqrt(2)",
            Self::Vector => "1 0 0",
        }
    }

    pub(crate) const fn names(self) -> &'static str {
        match self {
            Self::Quaternion => "w, x, y and z",
            Self::Vector => "x, y and z",
        }
    }
}

/// How many characters of the user's own text a message repeats.
pub(crate) const QUOTED_CHARACTERS: usize = 24;

/// The first `most` characters of a text, with an ellipsis where some were left out.
pub(crate) fn shorten(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((at, _)) => format!("{}…", &text[..at]),
        None => text.to_owned(),
    }
}

/// The greatest character boundary of `text` that is not after `byte`.
pub(crate) fn floor_boundary(text: &str, byte: usize) -> usize {
    (0..=byte.min(text.len()))
        .rev()
        .find(|&at| text.is_char_boundary(at))
        .unwrap_or(0)
}
