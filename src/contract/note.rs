//! What a careful reader should know: notes are data, the page has the words.

#[cfg(feature = "whole")]
use crate::contract::found::{FormatAssumed, FoundInText, OtherDescription, SaidElsewhere};
use crate::convention::angle::AngleUnit;
use crate::convention::names::serialized_by_name;
use crate::convention::order::ComponentOrder;
use crate::convention::order::OrderSource;
use crate::convention::{Direction, Handedness};
use crate::problem::Field;
use crate::problem::suggestion::{Suggestion, Suggestions, suggestions};
use serde::{Deserialize, Serialize};
use strum::VariantNames;

/// One thing worth knowing, as data; the page has the words.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Note {
    /// Which text it is about.
    pub field: Field,
    /// What there is to know.
    pub fact: Fact,
    /// Whether it stops a reader: [`Fact::stops`] of the fact.
    pub stops: bool,
    /// Texts to write instead, where what is meant can be said in one: the likeliest first, mostly none.
    /// Only with the feature `whole`.
    pub suggestions: Suggestions,
}

impl Note {
    /// The note of a fact, without suggestions.
    #[must_use]
    pub fn new(field: Field, fact: Fact) -> Self {
        Self {
            field,
            stops: fact.stops(),
            fact,
            suggestions: Suggestions::default(),
        }
    }

    /// The same note with texts to write instead; a build without the sentences looks for none.
    #[must_use]
    pub fn suggesting(self, find: impl FnOnce() -> Vec<Suggestion>) -> Self {
        Self {
            suggestions: suggestions(find),
            ..self
        }
    }
}

/// What a [`Note`] says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Fact {
    /// The norm is not 1, so the numbers were divided by it.
    Normalised(Normalised),
    /// The norm is outside 0.9 to 1.1 and nothing says that the numbers are a quaternion, as which they
    /// were read, divided by it; the suggestions of the note say what else they may be.
    FarFromUnit(FarFromUnit),
    /// The text tells its own order, which is not the declared one.
    OrderFromText(OrderFromText),
    /// The order cannot be told from the text, and the other order is another rotation.
    OrderAssumed(OrderAssumed),
    /// Both orders give the same rotation, so this input cannot show which one is used.
    OrderInvisible,
    /// The text is a call whose order is not known here.
    UnknownConstructor(UnknownConstructor),
    /// The angles, or the numbers inside sin, cos and tan, have no unit, so one was assumed.
    AngleUnitAssumed(AngleUnitAssumed),
    /// Nothing marks the rows of nine numbers, so they were read row by row.
    RowsAssumed(RowsAssumed),
    /// Three vectors with the names of axes were taken for the columns of the matrix.
    AxesAsColumns(AxesAsColumns),
    /// A label says that the nine numbers are columns, so they were read column by column.
    ColumnsFromText(AxesAsColumns),
    /// The matrix is not quite a rotation, so the nearest one was used.
    NearestRotation(UsedNearestRotation),
    /// The scalar is negative, as typed or because the angles are more than half a turn: −q, to which
    /// one more turn leads, is the same rotation and names the shorter turn.
    NegativeScalar,
    /// The rotation is none: every axis is as good, so none is given.
    NoTurn,
    /// So small a turn that its axis hardly shows in rounded numbers.
    NearlyNoTurn(NearlyNoTurn),
    /// Half a turn: the axis and its opposite describe the same rotation.
    HalfTurn,
    /// So near to half a turn that rounding may give the axis the opposite sign.
    NearlyHalfTurn(NearlyHalfTurn),
    /// Some number is beyond what a double can hold and is left out.
    OutOfRange(OutOfRange),
    /// The text tells which frame's coordinates the numbers take to which, and perhaps whose product they
    /// have, and it is not what is declared.
    DirectionFromText(DirectionFromText),
    /// Only the count of the numbers says that they are a rotation: their label says nothing of one.
    RotationAssumed(RotationAssumed),
    /// The rotation was found in a text that holds more.
    #[cfg(feature = "whole")]
    FoundInText(FoundInText),
    /// The text holds the rotation a second time, in another description.
    #[cfg(feature = "whole")]
    SecondDescription(OtherDescription),
    /// The text holds another rotation beside it, where it should be the same one.
    #[cfg(feature = "whole")]
    DescriptionsDisagree(OtherDescription),
    /// Nothing names the numbers: they were read as a row of this format, as which they pass.
    #[cfg(feature = "whole")]
    FormatAssumed(FormatAssumed),
    /// A line apart from the numbers says something that, said of them, makes them another rotation; it was not
    /// used.
    #[cfg(feature = "whole")]
    SaidElsewhere(SaidElsewhere),
}

impl Fact {
    /// Whether it stops a reader, who has to settle it before the answer is of use: where a meaning was
    /// taken that neither the text nor the declaration tells, and another one is another rotation.
    ///
    /// These stop:
    ///
    /// - a norm that is far from 1: the numbers may be a point, or an axis and an angle;
    /// - an unknown constructor: the order was declared for numbers, and its own may be the other one;
    /// - an assumed unit of angles: degrees for radians are another rotation by a factor of 57;
    /// - assumed rows, and axes as columns: the other way is the inverse rotation;
    /// - numbers that no word calls a rotation, and a row that nothing calls one of its format;
    /// - another rotation beside the one that was read, where it should be the same;
    /// - an inverse, a product or another convention that a line apart from the numbers tells.
    ///
    /// These do not: the text is what it says, or the reader declared how it is read.
    ///
    /// - a norm that was divided out, and the nearest rotation: what is rounded is the same but for the
    ///   rounding, and how far off it was is told;
    /// - an order that the text tells, that was declared, or that makes no difference;
    /// - a turn that is none or half, or nearly, and a negative scalar: facts of the very rotation;
    /// - a number that no double holds: it is left out, and no other stands in its place;
    /// - a direction and columns that the text tells, and what else stands in it.
    ///
    /// ```
    /// use quatlas::{Convention, Fact, Outcome, ReadRequest, Request, analyze};
    /// let stops = |text: &str| {
    ///     let request = ReadRequest::new(text, "1 0 0", Convention::HAMILTON);
    ///     let Outcome::Read(report) = analyze(&Request::Read(request)) else {
    ///         panic!("{text} is read")
    ///     };
    ///     report.notes.iter().any(|note| note.stops)
    /// };
    /// // Nobody has said in which unit these are; those are what was declared.
    /// assert!(stops("ZYX 30 20 10"));
    /// assert!(!stops("0.6 0 0 0.8"));
    /// ```
    #[must_use]
    pub const fn stops(&self) -> bool {
        match self {
            Self::FarFromUnit(_)
            | Self::UnknownConstructor(_)
            | Self::AngleUnitAssumed(_)
            | Self::RowsAssumed(_)
            | Self::AxesAsColumns(_)
            | Self::RotationAssumed(_) => true,
            #[cfg(feature = "whole")]
            Self::DescriptionsDisagree(_) | Self::FormatAssumed(_) | Self::SaidElsewhere(_) => true,
            Self::Normalised(_)
            | Self::NearestRotation(_)
            | Self::OrderFromText(_)
            | Self::OrderAssumed(_)
            | Self::OrderInvisible
            | Self::NegativeScalar
            | Self::NoTurn
            | Self::NearlyNoTurn(_)
            | Self::HalfTurn
            | Self::NearlyHalfTurn(_)
            | Self::OutOfRange(_)
            | Self::DirectionFromText(_)
            | Self::ColumnsFromText(_) => false,
            #[cfg(feature = "whole")]
            Self::FoundInText(_) | Self::SecondDescription(_) => false,
        }
    }
}

/// The data of [`Fact::Normalised`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Normalised {
    /// The norm as typed; absent where a double cannot hold it.
    pub norm: Option<f64>,
    /// The norm minus 1; absent where the norm is.
    pub deviation: Option<f64>,
}

/// The data of [`Fact::FarFromUnit`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct FarFromUnit {
    /// The norm as typed; absent where a double cannot hold it.
    pub norm: Option<f64>,
    /// The norm minus 1; absent where the norm is.
    pub deviation: Option<f64>,
}

/// The data of [`Fact::OrderFromText`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct OrderFromText {
    /// How it was told.
    pub source: OrderSource,
    /// The order that was used.
    pub order: ComponentOrder,
}

/// The data of [`Fact::DirectionFromText`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct DirectionFromText {
    /// The direction that was used.
    pub direction: Direction,
    /// The product that was used, where the text tells another one than is declared.
    pub handedness: Option<Handedness>,
}

/// The data of [`Fact::RotationAssumed`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RotationAssumed {
    /// The label as typed, at most some words of it.
    pub label: String,
}

/// The data of [`Fact::OrderAssumed`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct OrderAssumed {
    /// The order that was used.
    pub order: ComponentOrder,
    /// How far away the rotation is that the other order gives, in degrees.
    pub other_order_differs_by_deg: f64,
}

/// The data of [`Fact::UnknownConstructor`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct UnknownConstructor {
    /// The name as typed.
    pub name: String,
    /// The order that was used: the declared one.
    pub order: ComponentOrder,
}

/// The data of [`Fact::AngleUnitAssumed`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct AngleUnitAssumed {
    /// The unit that was used.
    pub unit: AngleUnit,
    /// The same text with the word for degrees; absent where there is no plain place for it.
    pub in_degrees: Option<String>,
    /// The same text with the word for radians; absent where there is no plain place for it.
    pub in_radians: Option<String>,
}

/// The data of [`Fact::RowsAssumed`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct RowsAssumed {
    /// How far away the rotation is that the same numbers give column by column, the opposite turn, in
    /// degrees.
    pub columns_differ_by_deg: f64,
}

/// The data of [`Fact::AxesAsColumns`] and [`Fact::ColumnsFromText`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct AxesAsColumns {
    /// How far away the rotation is that the same vectors give row by row, the opposite turn, in
    /// degrees.
    pub rows_differ_by_deg: f64,
}

/// The data of [`Fact::NearestRotation`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct UsedNearestRotation {
    /// The largest magnitude among the entries of `MᵀM − I`.
    pub orthogonality_error: f64,
    /// The Frobenius norm of the difference between the two.
    pub correction: f64,
}

/// The data of [`Fact::NearlyNoTurn`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct NearlyNoTurn {
    /// The angle, less than 1e-4 radians.
    pub angle_rad: f64,
    /// The same angle in degrees.
    pub angle_deg: f64,
    /// How far the axis is off, in degrees, where the quaternion is rounded to six decimals; absent
    /// where it may then be any.
    pub axis_uncertain_by_deg: Option<f64>,
}

/// The data of [`Fact::NearlyHalfTurn`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct NearlyHalfTurn {
    /// What the angle lacks of π, less than 1e-4 radians.
    pub short_by_rad: f64,
    /// The same in degrees.
    pub short_by_deg: f64,
}

/// The data of [`Fact::OutOfRange`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct OutOfRange {
    /// Which number is left out.
    pub what: OutOfRangeNumber,
}

/// A number that a double may be unable to hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[derive(VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub enum OutOfRangeNumber {
    /// The norm as typed, of numbers for other axes: those numbers have norm 1.
    Norm,
    /// The inverse quaternion.
    Inverse,
    /// The turned vector.
    Image,
    /// The product of the quaternions as typed; the product of the unit quaternions is given.
    Product,
    /// A position.
    #[cfg(feature = "whole")]
    Position,
}

serialized_by_name!(OutOfRangeNumber);
