//! What four numbers mean: quaternions in Hamilton and JPL convention, as matrices, inverses and
//! composition order.
//!
//! ```text
//! text as typed -> parse -> numbers + spans -> convention -> tagged quaternion -> rotation -> canonical rotation
//!       ^                                                                                            |
//!       '-------------- page <- wasm <- report <------------------ analyze <-------------------------'
//!                               any step may stop with a problem that points into the text
//! ```
//!
//! [`analyze()`] is that whole road in one call. The steps can be used alone: [`parse_quaternion`],
//! [`TaggedQuaternion`], [`Rotation`]. What the words mean, with numbers that show it, is in
//! [`convention`](mod@convention).
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
//! The modules below stand in the order of the road; each uses only those above it. Inside the
//! crate spans count bytes and one rotation is canonical: Hamilton, body to world. Conventions are
//! tags at the edge.

// Nothing that is typed may panic. The tests may.
#![warn(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

pub use nalgebra;

// Words: plain types, no mathematics.

/// One problem: a code, a place, what was expected, what to try.
pub mod problem;
// The sentence of every problem.
/// What four numbers mean.
pub mod convention;
/// The 24 Euler sequences.
pub mod euler_sequence;
mod messages;
/// What is answered.
pub mod report;
/// What is asked.
pub mod request;

// Text to numbers.

// Text to tokens.
mod lex;
// The arithmetic of typed text.
mod linear;
// The members that a text consists of.
mod tree;
// The tokens on their way through the grammar.
mod input;
// Tokens to a tree.
mod syntax;
// What a call does with its numbers.
mod constructor;
// Members with names.
mod names;
// Members to named components.
mod meaning;
/// Text to numbers.
pub mod parse;

// Numbers to rotations.

// Exact scaling, so that squares neither overflow nor underflow.
/// Rotation to and from axis, angle and rotation vector.
pub mod axis_angle;
/// Rotation to and from Euler angles.
pub mod euler;
/// Rotation to matrix.
pub mod matrix;
/// The rotation nearest to nine numbers.
pub mod nearest_rotation;
/// Four numbers with the convention that says what they mean.
pub mod quaternion;
/// The canonical rotation and its two gates.
pub mod rotation;
/// Nine numbers with the convention that says what they mean.
pub mod rotation_matrix;
mod scaling;
// Two quaternions together.
mod compose;

// What the literature prints, in numbers.

// The two sides of a statement.
mod errata_witness;

// Those of the statements, document by document.
mod errata_cheng;
mod errata_field_guide;
mod errata_lecture;
mod errata_yoosefian;

/// Errata of the literature.
pub mod errata;

// The whole road.

/// A request in, an outcome out.
pub mod analyze;
/// The only file that knows JavaScript.
#[cfg(target_arch = "wasm32")]
pub mod wasm;

pub use analyze::analyze;
pub use convention::{
    ComponentOrder, ComponentSign, Convention, Direction, Function, Handedness, Perturbation,
    UnknownName,
};
pub use errata::{Document, Erratum, Witness, errata};
pub use euler::{EulerAngles, GimbalLock};
pub use euler_sequence::{Axis, EulerAxes, EulerFrame, EulerSequence, UnknownSequence};
pub use nearest_rotation::{NearestRotation, NoNearestRotation};
pub use parse::{ParsedQuaternion, parse_quaternion, parse_vector};
pub use problem::{Field, Problem, ProblemCode, Span};
pub use quaternion::{MixedConventions, TaggedQuaternion, hamilton_product, jpl_product};
pub use report::*;
pub use request::{ComposeRequest, ReadRequest, Request};
pub use rotation::{NoRotation, Rotation};
pub use rotation_matrix::{CosineMatrix, MatrixConvention, ROTATION_TOLERANCE, TaggedMatrix};

/// The examples of the README, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
