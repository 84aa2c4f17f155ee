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
//! What real libraries do is in [`library`](mod@library), a table of records that were run. Two requests
//! use it: [`TranslateRequest`] takes an attitude from one library or convention to another, and
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
//! Each of the modules below uses only those above it: words, rotations, what is asked and answered,
//! text, and last the road through all of them. Inside the crate spans count bytes and one rotation is canonical: Hamilton, body to world. Conventions are
//! tags at the edge.

// Nothing that is typed may panic. The tests may.
#![warn(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

pub use nalgebra;

// Words.

/// One problem: a code, a place, what was expected, what to try.
pub mod problem;

/// A text that has a problem, rewritten so that it is read.
pub mod suggestion;

/// The unit of an angle.
pub mod angle;

/// What four numbers mean.
pub mod convention;

/// The 24 Euler sequences.
pub mod euler_sequence;

// Numbers to rotations.

// Exact scaling, and sums of products that are rounded once.
mod scaling;

/// Four numbers with the convention that says what they mean.
pub mod quaternion;

/// The canonical rotation and its two gates.
pub mod rotation;

/// Rotation to matrix.
pub mod matrix;

/// Rotation to and from axis, angle and rotation vector.
pub mod axis_angle;

/// The rotation nearest to nine numbers.
pub mod nearest_rotation;

/// Nine numbers with the convention that says what they mean.
pub mod rotation_matrix;

/// Rotation to and from Euler angles.
pub mod euler;

// Rotations together and in motion.

/// How far two attitudes are apart.
pub mod distance;

/// Attitudes between attitudes.
pub mod interpolation;

/// Rotation vectors: composition, Jacobians, and their relatives.
pub mod rotation_vector;

/// Small turns added to attitudes and taken between them.
pub mod perturbation;

/// How attitudes change in time.
pub mod kinematics;

/// Euler angle rates.
pub mod euler_rates;

/// Integration of components, of Euler angles and of rotation vectors.
pub mod integration;

/// Poses between named frames.
pub mod pose;

/// Other names for the same axes.
pub mod axis_mapping;

// Libraries.

/// What libraries do with four numbers.
pub mod library;

/// One end of a translation.
pub mod endpoint;

/// What a library may do with four numbers.
pub mod behaviour;

/// What was tried on a library.
pub mod probe;

/// What a library means by three angles, by a matrix and by a small turn.
pub mod recognition;

// What the literature prints, in numbers.

// The two sides of a statement.
mod errata_witness;

// Those of Cheng 2018.
mod errata_cheng;

// Those of the field guide.
mod errata_field_guide;

// Those of the lecture.
mod errata_lecture;

// Those of Yoosefian 2021.
mod errata_yoosefian;

/// Errata of the literature.
pub mod errata;

// What is asked and answered.

/// One attitude in the report.
mod report_attitude;

/// What a careful reader should know.
mod report_notes;

/// What a translation answers.
mod report_translate;

/// What an identification answers.
mod report_identify;

/// What is answered.
pub mod report;

/// What is asked.
pub mod request;

// Text to numbers.

// The sentences of problems of any text.
mod messages;

// The sentences of problems of marks and signs.
mod mark_messages;

// The sentences of problems of matrices.
mod matrix_messages;

// The sentences of problems of rotations.
mod rotation_messages;

// The sentences of problems of Euler sequences.
mod euler_messages;

// The sentences of problems of translation and identification.
mod library_messages;

// What consoles write around numbers.
mod console;

// What stands between tokens.
mod blank;
// Words of a declaration.
mod declaration;

// Text to tokens.
mod lex;

// The arithmetic of typed text.
mod linear;

// The members that a text consists of.
mod tree;

// Signs that may mean two things.
mod signs;

// The tokens on their way through the grammar.
mod input;

// Tokens to a tree.
mod syntax;

// What a call does with its numbers.
mod constructor;

// Words that are known before numbers.
mod phrases;

// Named words that say something of all the numbers.
mod settings;

// Members with names.
mod names;

// Lists of plain numbers.
mod numbers;

// The texts that may be written in place of one with a problem.
mod rewrites;

// The numbers that stand in any text.
mod typed_numbers;

// Members to named components.
mod meaning;

// Nine numbers to a matrix.
mod matrix_rows;

// Three vectors with labels to a matrix.
mod matrix_columns;

// Angles with units to radians.
mod angles;

// Numbers without a unit inside sines and cosines.
mod bare_arguments;

// An axis and its angle.
mod axis;

/// What a text holds when it holds a rotation.
pub mod representation;

// The parts of a rotation by name.
mod parts;

// What the words of a text announce.
mod spoken;

// Calls of libraries that make a rotation.
mod calls;

// What is announced in words to a rotation.
mod announced;

/// Text to numbers.
pub mod parse;

// The whole road.

// Nine numbers to an attitude, or what is nearest to them.
mod matrix_reading;

// A rotation in the representations that need no text.
mod describe;

// A text to an attitude, and the attitude to numbers in a convention.
mod attitude;

// Two quaternions together.
mod compose;

// A library's line of code, with numbers.
mod template;

// From one end of a translation to the other.
mod translate;

// What a library is asked, and what it may answer.
mod observation;

// A probe in texts to numbers.
mod observe;

// A probe as code.
mod probe_code;

// What is settled, in words.
mod sentence;

// Which convention a library uses.
mod identify;

/// A request in, an outcome out.
pub mod analyze;

// The members of objects of JavaScript.
#[cfg(target_arch = "wasm32")]
mod wasm_members;

// The texts of requests, and how long they are.
#[cfg(target_arch = "wasm32")]
mod wasm_text;

// The requests that the page begins with, from JavaScript.
#[cfg(target_arch = "wasm32")]
mod wasm_request;

// The requests that need the table of libraries, from JavaScript.
#[cfg(all(target_arch = "wasm32", feature = "libraries"))]
mod wasm_library_request;

/// The edge to JavaScript.
#[cfg(target_arch = "wasm32")]
pub mod wasm;

pub use analyze::analyze;
pub use angle::{AngleUnit, UnitSource};
pub use axis_mapping::{
    AxesChange, AxesHand, AxisMapping, OneSidedReflection, Sense, SignedAxis, UnknownAxes,
};
pub use behaviour::{Behaviour, BehaviourAxis};
pub use convention::{
    ComponentOrder, ComponentSign, Convention, Direction, Function, Handedness, Perturbation,
    UnknownName,
};
pub use endpoint::{Assumption, ConventionEndpoint, Endpoint, LibraryEndpoint};
pub use errata::{Erratum, SourceDocument, Witness, errata};
pub use euler::{EulerAngles, GIMBAL_LOCK_RAD, GimbalLock, Survivor};
pub use euler_rates::SingularRates;
pub use euler_sequence::{Axis, EulerAxes, EulerFrame, EulerSequence, UnknownSequence};
pub use integration::{NoStep, rotation_vector_runge_kutta_step};
pub use interpolation::NotFinite;
pub use kinematics::{IntegrationOrder, RateAxes, action_jacobian};
pub use library::*;
pub use nearest_rotation::{NearestRotation, NoNearestRotation};
pub use parse::{ParsedQuaternion, parse_quaternion, parse_rotation, parse_vector};
pub use perturbation::{IncrementSign, Side, small_angle_matrix, small_angle_quaternion};
pub use pose::{FramesDoNotMeet, Pose};
pub use probe::{MatrixLayout, Probe, ProbeKind};
pub use problem::{Field, Problem, ProblemCode, Span};
pub use quaternion::{MixedConventions, TaggedQuaternion, hamilton_product, jpl_product};
pub use recognition::{EulerReading, direction_of_yawed, function_of_chain, increment_of};
pub use report::*;
pub use representation::{
    ParsedAxisAngle, ParsedEulerAngles, ParsedHalfAngleVector, ParsedRotation, ParsedRotationVector,
};
pub use request::{ComposeRequest, IdentifyRequest, ReadRequest, Request, TranslateRequest};
pub use rotation::{NoRotation, Rotation};
pub use rotation_matrix::{CosineMatrix, MatrixConvention, ROTATION_TOLERANCE, TaggedMatrix};
pub use rotation_vector::{
    AxisVector, compose_rotation_vectors, half_angle_exponential, left_jacobian,
    left_jacobian_inverse, right_jacobian, right_jacobian_inverse,
};
pub use suggestion::{Remedy, Suggestion};

/// The examples of the README, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
