//! What four numbers mean: quaternions in Hamilton and JPL convention, as matrices, inverses and
//! composition order.
//!
//! ```text
//! page -> wasm/ -> a request (contract/) -> analyze/ -> text/      numbers with their places
//!                                              |     -> convention/  tagged with what they mean
//!                                              |     -> rotation/    one canonical rotation, and back
//! page <- wasm/ <- a report  (contract/) <-----'
//!                  or, from any step, a problem/ that points into the text
//! ```
//!
//! [`analyze()`] is that whole road in one call. The steps can be used alone: [`parse_quaternion`],
//! [`TaggedQuaternion`], [`Rotation`]. What the words mean, with numbers that show it, is in
//! [`convention`](mod@convention).
//!
//! What real libraries do is in [`library`](mod@library), a table of records, most of which were
//! run. Two requests use it: [`TranslateRequest`] takes an attitude from one library or convention to another, and
//! [`IdentifyRequest`] tells which convention a library has from what it printed.
//!
//! # Sources
//!
//! Equations are cited by their documents: *Cheng 2018* (H. Cheng, "Standardised Use of Quaternion
//! for SO(3) Representation", National University of Singapore), *Yoosefian 2021* (M. H. Yoosefian
//! Nooshabadi, "A Concise Note on Coordinate Frames Transformation and Quaternion Conventions"), the
//! lecture *ME 495* ("Quaternions and More Geometry") and the *field guide* ("Implementing
//! Rotations: A Robotics Field Guide"). *Specification* with a number or an id is the project's own
//! inventory of their equations, each checked numerically.
//!
//! # Reading the code
//!
//! Each folder of `src` is a room, and so is each file beside them. They are declared below in the order in
//! which they are best read, after two small ones that know nothing of the subject (`character`, `decimal`):
//!
//! 1. [`convention`](mod@convention): the words, each defined by what it does.
//! 2. [`problem`]: what is said where a step stops.
//! 3. [`rotation`]: the canonical rotation, Hamilton's quaternion of `R_WB`, with its two gates from and to
//!    conventions, and its representations; on it stand [`motion`] and [`frames`].
//! 4. [`library`](mod@library) and [`errata`](mod@errata): what is known of programs and of documents.
//! 5. [`text`](mod@text): from typed text to named numbers, in `grammar`, `vocabulary` and `description`.
//! 6. [`contract`]: what is asked and answered, as plain numbers and names; the TypeScript types are made of it.
//! 7. [`analyze`](mod@analyze): the road through all of them.
//! 8. `wasm`: the edge to JavaScript, and the only room that knows of it. Inside spans count bytes, outside
//!    UTF-16 units.
//!
//! Which room may use which is the table `ROOMS` of `tests/house.rs`, and that test holds it. Why it is all so,
//! and what was given up, is in `src/decisions.md`, [`decisions`] here.

// Nothing that is typed may panic. The tests may.
#![warn(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

pub use nalgebra;

// What single characters are.
mod character;

// Doubles to and from decimal text.
#[cfg_attr(target_arch = "wasm32", path = "wasm/decimal.rs")]
mod decimal;

/// What four numbers mean.
pub mod convention;

/// One problem: a code, a place, what was expected, what to try.
pub mod problem;

/// The canonical rotation, its two gates, and its representations.
pub mod rotation;

/// Attitudes in motion.
pub mod motion;

/// Poses between frames, and other names for their axes.
pub mod frames;

/// What libraries do with four numbers.
pub mod library;

/// Errata of the literature.
pub mod errata;

/// Text to numbers.
pub mod text;

/// What is asked and answered.
pub mod contract;

/// A request in, an outcome out.
pub mod analyze;

/// The edge to JavaScript: of texts and requests, or of numbers alone.
#[cfg(target_arch = "wasm32")]
#[cfg_attr(feature = "rotations", path = "wasm/rotations/mod.rs")]
pub mod wasm;

pub use analyze::analyze;
pub use analyze::describe::describe_convention;
pub use analyze::identify::recognition::{
    EulerReading, direction_of_yawed, function_of_chain, increment_of,
};
pub use analyze::identify::standard_probes;
pub use analyze::translate::describe_library;
pub use contract::probe::{MatrixLayout, Probe, ProbeKind};
#[cfg(feature = "whole")]
pub use contract::request::{
    AtlasRequest, BetweenRequest, ChainFactor, ChainRequest, SwingTwistRequest,
};
pub use contract::request::{
    ComposeRequest, IdentifyRequest, MatricesRequest, NumbersRequest, ReadRequest, Request,
    TranslateRequest,
};
pub use contract::*;
pub use convention::angle::{AngleUnit, UnitSource};
pub use convention::euler_sequence::{Axis, EulerAxes, EulerFrame, EulerSequence, UnknownSequence};
pub use convention::family::Family;
pub use convention::matrix::{CosineMatrix, MatrixConvention};
pub use convention::order::{ComponentOrder, OrderSource};
pub use convention::presets::NamedConvention;
pub use convention::side::{IncrementSign, Side};
pub use convention::{
    ComponentSign, Convention, Direction, Function, Handedness, Perturbation, UnknownName,
};
pub use errata::{Erratum, SourceDocument, Witness, errata};
pub use frames::axis_mapping::{
    AxesChange, AxesHand, AxisMapping, OneSidedReflection, Sense, SignedAxis,
};
pub use frames::axis_names::UnknownAxes;
pub use frames::pose::{FramesDoNotMeet, Pose};
pub use library::behaviour::{Behaviour, BehaviourAxis};
pub use library::endpoint::{Assumption, ConventionEndpoint, Endpoint, LibraryEndpoint};
pub use library::*;
pub use motion::euler_rates::SingularRates;
pub use motion::integration::{NoStep, rotation_vector_runge_kutta_step};
pub use motion::kinematics::{IntegrationOrder, RateAxes, action_jacobian};
pub use motion::perturbation::{small_angle_matrix, small_angle_quaternion};
pub use problem::fault::Fault;
pub use problem::suggestion::{Remedy, Suggestion, Suggestions};
pub use problem::{Field, Problem, ProblemCode, Span};
pub use rotation::alignment::{Alignment, NoAlignment};
pub use rotation::euler::{EulerAngles, GIMBAL_LOCK_RAD, GimbalLock, Survivor};
pub use rotation::interpolation::{NoMean, NotFinite};
pub use rotation::nearest::{NearestRotation, NoNearestRotation};
pub use rotation::quaternion::{MixedConventions, TaggedQuaternion, hamilton_product, jpl_product};
pub use rotation::rotation_vector::{
    AxisVector, compose_rotation_vectors, half_angle_exponential, left_jacobian,
    left_jacobian_inverse, right_jacobian, right_jacobian_inverse,
};
pub use rotation::swing_twist::SwingTwist;
pub use rotation::tagged_matrix::{ROTATION_TOLERANCE, TaggedMatrix};
pub use rotation::weights::UnusableWeights;
pub use rotation::{NoRotation, Rotation};
pub use text::description::{
    ParsedAxisAngle, ParsedEulerAngles, ParsedHalfAngleVector, ParsedRotation, ParsedRotationVector,
};
pub use text::{ParsedQuaternion, parse_number, parse_quaternion, parse_rotation, parse_vector};

/// Why things are as they are, and what was given up for it.
#[cfg(doc)]
pub mod decisions {
    #![doc = include_str!("decisions.md")]
}

/// The examples of the README, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
