//! What is asked: text as it was typed, and the convention it is declared to be in.

#[cfg(feature = "whole")]
use crate::contract::frames::FramesRequest;
#[cfg(feature = "whole")]
use crate::contract::motion::MotionRequest;
use crate::contract::probe::{Probe, ProbeKind};
use crate::contract::text::Text;
use crate::convention::Convention;
use crate::convention::euler_sequence::EulerSequence;
use crate::convention::matrix::MatrixConvention;
use crate::library::Language;
use crate::library::endpoint::Endpoint;
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
    /// What is this attitude elsewhere?
    Translate(TranslateRequest),
    /// Which convention does a library use?
    Identify(IdentifyRequest),
    /// Which description of this attitude are these numbers?
    Numbers(NumbersRequest),
    /// Which convention does a library of matrices use?
    Matrices(MatricesRequest),
    /// How do these two differ, and what is between them?
    #[cfg(feature = "whole")]
    Between(BetweenRequest),
    /// What do all these make together?
    #[cfg(feature = "whole")]
    Chain(ChainRequest),
    /// What is this attitude in all conventions?
    #[cfg(feature = "whole")]
    Atlas(AtlasRequest),
    /// What of this attitude is a turn about this axis?
    #[cfg(feature = "whole")]
    SwingTwist(SwingTwistRequest),
    /// Where does one frame stand in another?
    #[cfg(feature = "whole")]
    Frames(FramesRequest),
    /// What do a small turn, a rate and time make of this attitude?
    #[cfg(feature = "whole")]
    Motion(MotionRequest),
}

/// One attitude and one vector.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ReadRequest {
    /// The attitude, as a quaternion or in any other accepted form (see [`parse`](mod@crate::text)).
    pub quaternion: Text,
    /// The vector `v`, in any accepted form.
    pub vector: Text,
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
    pub p: Text,
    /// The right operand.
    pub q: Text,
    /// The vector `v` that both turn, one after the other.
    pub vector: Text,
    /// What four numbers of either are declared to mean.
    pub convention: Convention,
    /// What nine numbers of either are declared to mean; body to world where it is left out.
    #[serde(default)]
    pub matrix: MatrixConvention,
}

/// Two attitudes, and a part of the way between them.
#[cfg(feature = "whole")]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BetweenRequest {
    /// Where the way begins; as an error is taken, the estimate.
    pub p: Text,
    /// Where it ends.
    pub q: Text,
    /// What four numbers of either are declared to mean; its perturbation says on which axes the error is.
    pub convention: Convention,
    /// What nine numbers of either are declared to mean; body to world where it is left out.
    #[serde(default)]
    pub matrix: MatrixConvention,
    /// The sequence of the Euler angles in the answer; intrinsic ZYX where it is left out.
    #[serde(default)]
    pub euler: EulerSequence,
    /// The part of the way, a number: 0 is p, 1 is q; half of it where it is left out or empty.
    #[serde(default)]
    pub part: Text,
    /// The time from p to q, of which the rate is asked: `0.25 s`, `250 ms`, `2 min`; without a unit it is in
    /// seconds. Where it is left out or empty, no rate is.
    #[serde(default)]
    pub duration: Text,
}

/// Many attitudes, multiplied from left to right.
#[cfg(feature = "whole")]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ChainRequest {
    /// The factors from left to right; from JavaScript from one to 32.
    pub factors: Vec<ChainFactor>,
    /// What four numbers of each are declared to mean, and which product is taken.
    pub convention: Convention,
    /// What nine numbers of each are declared to mean; body to world where it is left out.
    #[serde(default)]
    pub matrix: MatrixConvention,
    /// The sequence of the Euler angles in the answer; intrinsic ZYX where it is left out.
    #[serde(default)]
    pub euler: EulerSequence,
}

/// One factor of a chain.
#[cfg(feature = "whole")]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ChainFactor {
    /// The attitude, in any accepted form.
    pub text: Text,
    /// Whether its inverse stands in the chain.
    #[serde(default)]
    pub inverse: bool,
}

/// One attitude, to be written in all conventions.
#[cfg(feature = "whole")]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct AtlasRequest {
    /// The attitude, in any accepted form.
    pub quaternion: Text,
    /// What four numbers are declared to mean.
    pub convention: Convention,
    /// What nine numbers are declared to mean; body to world where it is left out.
    #[serde(default)]
    pub matrix: MatrixConvention,
}

/// One attitude and the axis of a twist.
#[cfg(feature = "whole")]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SwingTwistRequest {
    /// The attitude, in any accepted form.
    pub quaternion: Text,
    /// The axis: three numbers of any length but zero, or `x`, `y`, `z`.
    pub axis: Text,
    /// What four numbers are declared to mean.
    pub convention: Convention,
    /// What nine numbers are declared to mean; body to world where it is left out.
    #[serde(default)]
    pub matrix: MatrixConvention,
}

/// One attitude, from one library or convention to another.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct TranslateRequest {
    /// The attitude as the first end writes it: its four numbers, its matrix, its constructor call; or
    /// any other accepted form.
    pub quaternion: Text,
    /// Where it comes from.
    pub from: Endpoint,
    /// Where it goes to.
    pub to: Endpoint,
    /// The new world axes (`NED to ENU`, `y x -z`); empty where they stay.
    #[serde(default)]
    pub world_axes: String,
    /// The new body axes (`FRD to FLU`, `x -y -z`); empty where they stay.
    #[serde(default)]
    pub body_axes: String,
}

/// What a library printed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct IdentifyRequest {
    /// The observations in any order, of any kind and number.
    pub observations: Vec<Probe>,
    /// The name of the library, for the sentence.
    #[serde(default)]
    pub name: String,
    /// The language of the code of the next probe.
    #[serde(default)]
    pub language: Language,
    /// Kinds of probes that cannot be run.
    #[serde(default)]
    pub unavailable: Vec<ProbeKind>,
}

/// What a library of rotation matrices printed, nine numbers each, row by row, as the matrix multiplies a
/// column. A text that is empty was not tried.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase", default)]
pub struct MatricesRequest {
    /// The matrix of a body that was turned by +90° about the world's z axis.
    pub yawed: Text,
    /// Of three frames A, B and C, turned about different axes, that with the label A to B.
    pub a: Text,
    /// That with the label B to C.
    pub b: Text,
    /// That with the label A to C.
    pub product: Text,
    /// A matrix to which a small turn is added, best that of `yawed`.
    pub matrix: Text,
    /// The rotation vector that the library's own call adds to it, in radians, best about x.
    pub rotation_vector: Text,
    /// What the call made of the matrix.
    pub printed: Text,
}

/// Numbers beside an attitude.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct NumbersRequest {
    /// Three, four or nine numbers as a program printed them; or four names, each of a component, such
    /// as `(-q2, q1, -q4, q3)`: the rewriting of any quaternion.
    pub numbers: Text,
    /// The attitude, in any accepted form; beside four names it is not read.
    pub quaternion: Text,
    /// What four numbers are declared to mean.
    pub convention: Convention,
    /// What nine numbers are declared to mean; body to world where it is left out.
    #[serde(default)]
    pub matrix: MatrixConvention,
}

impl TranslateRequest {
    /// The request with the axes as they are.
    #[must_use]
    pub fn new(quaternion: &str, from: Endpoint, to: Endpoint) -> Self {
        Self {
            quaternion: quaternion.to_owned(),
            from,
            to,
            world_axes: String::new(),
            body_axes: String::new(),
        }
    }
}

impl IdentifyRequest {
    /// The request without a name, with code in Python.
    #[must_use]
    pub fn new(observations: Vec<Probe>) -> Self {
        Self {
            observations,
            name: String::new(),
            language: Language::default(),
            unavailable: Vec::new(),
        }
    }
}

impl NumbersRequest {
    /// The request with a matrix body to world.
    ///
    /// ```
    /// use quatlas::{Convention, NumbersMeaning, NumbersRequest, Outcome, Request, analyze};
    /// // A game engine turns about y, x and z, which move, and prints x, y, z from 0 to 360.
    /// let q = "w=0.77781 x=-0.52878 y=-0.19588 z=0.27755";
    /// let request = NumbersRequest::new("314.45, 301.32, 65.83", q, Convention::HAMILTON);
    /// let Outcome::Numbers(report) = analyze(&Request::Numbers(request)) else { panic!("read") };
    /// assert!(report.decides);
    /// let NumbersMeaning::EulerAngles { sequence, .. } = report.readings[0].meaning else { panic!("angles") };
    /// assert_eq!(sequence.to_string(), "YXZ");
    /// ```
    #[must_use]
    pub fn new(numbers: &str, quaternion: &str, convention: Convention) -> Self {
        Self {
            numbers: numbers.to_owned(),
            quaternion: quaternion.to_owned(),
            convention,
            matrix: MatrixConvention::default(),
        }
    }
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
