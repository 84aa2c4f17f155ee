//! What a text holds when it holds a rotation: one of eight descriptions, each as it was typed.

// Angles with units to radians.
pub(crate) mod angle;

// The words before the numbers.
pub(crate) mod announcement;

// The axis of a turn.
pub(crate) mod axis;

// An axis and an angle.
pub(crate) mod axis_angle;

// Calls of libraries that make a rotation.
pub(crate) mod call;

// The numbers behind an announcement.
pub(crate) mod announced_numbers;

// A label of numbers.
pub(crate) mod label;

// Lists of plain numbers.
pub(crate) mod list;

// Nine numbers to a matrix.
pub(crate) mod matrix;

// Three vectors with labels to a matrix.
pub(crate) mod matrix_columns;

// Members with names.
pub(crate) mod named_members;

// The parts of a rotation by name.
pub(crate) mod named_parts;

// Members to named components.
pub(crate) mod quaternion;

// Named words that say something of all the numbers.
pub(crate) mod settings;

// What labels and comments tell.
pub(crate) mod told;

// Members to three numbers.
pub(crate) mod vector;

// How a text speaks of its numbers.
pub(crate) mod wording;

use crate::convention::angle::UnitSource;
use crate::convention::euler_sequence::EulerSequence;
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::description::angle::{Angle, Of, UnitRule};
use crate::text::description::list::{check_no_factor, check_separators, members};
use crate::text::description::quaternion::ParsedQuaternion;
use crate::text::grammar::tree::Entry;
use nalgebra::{Matrix3, Vector3};

/// A rotation as it was typed; every number is finite.
#[derive(Clone, Debug, PartialEq)]
pub enum ParsedRotation {
    /// Four numbers by name, of any norm.
    Quaternion(ParsedQuaternion),
    /// A turn about an axis.
    AxisAngle(ParsedAxisAngle),
    /// The axis times the angle.
    RotationVector(ParsedRotationVector),
    /// The axis times half the angle: the logarithm of the quaternion itself.
    HalfAngleVector(ParsedHalfAngleVector),
    /// The axis times tan(angle/2), also called (classical) Rodrigues parameters; of any length.
    GibbsVector(Vector3<f64>),
    /// The axis times tan(angle/4), of any length.
    ModifiedRodrigues(Vector3<f64>),
    /// Three turns about coordinate axes.
    EulerAngles(ParsedEulerAngles),
    /// Three rows of three numbers as written, which need not be a rotation.
    Matrix(Matrix3<f64>),
}

impl ParsedRotation {
    /// How the unit of its angles was told; `None` where it has none.
    pub(crate) const fn unit(&self) -> Option<UnitSource> {
        match self {
            Self::AxisAngle(parsed) => Some(parsed.unit),
            Self::RotationVector(parsed) => Some(parsed.unit),
            Self::HalfAngleVector(parsed) => Some(parsed.unit),
            Self::EulerAngles(parsed) => Some(parsed.unit),
            Self::Quaternion(_)
            | Self::GibbsVector(_)
            | Self::ModifiedRodrigues(_)
            | Self::Matrix(_) => None,
        }
    }

    /// What it is, for the sentences of problems.
    pub(crate) const fn in_words(&self) -> &'static str {
        match self {
            Self::Quaternion(_) => "a quaternion",
            Self::AxisAngle(_) => "an axis and an angle",
            Self::RotationVector(_) => "a rotation vector",
            Self::HalfAngleVector(_) => "a half-angle vector",
            Self::GibbsVector(_) => "a Gibbs vector",
            Self::ModifiedRodrigues(_) => "a set of modified Rodrigues parameters",
            Self::EulerAngles(_) => "a set of Euler angles",
            Self::Matrix(_) => "a matrix",
        }
    }
}

/// A turn by an angle about an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct ParsedAxisAngle {
    /// The axis as written: of any length but zero.
    pub axis: Vector3<f64>,
    /// The angle in radians, of any size and sign; of degrees beyond two turns, what is left of them.
    pub angle_rad: f64,
    /// How the unit of the angle was told.
    pub unit: UnitSource,
}

/// An axis whose length is the angle.
#[derive(Clone, Debug, PartialEq)]
pub struct ParsedRotationVector {
    /// In radians, of any length.
    pub vector_rad: Vector3<f64>,
    /// How the unit was told.
    pub unit: UnitSource,
}

/// An axis whose length is half the angle.
#[derive(Clone, Debug, PartialEq)]
pub struct ParsedHalfAngleVector {
    /// In radians, of any length.
    pub vector_rad: Vector3<f64>,
    /// How the unit was told.
    pub unit: UnitSource,
}

/// Three turns about coordinate axes.
#[derive(Clone, Debug, PartialEq)]
pub struct ParsedEulerAngles {
    /// Which axes, in which order, and whether they move.
    pub sequence: EulerSequence,
    /// The angles in radians, in the order of the axes; of degrees beyond two turns, what is left.
    pub angles_rad: [f64; 3],
    /// How the unit of the angles was told.
    pub unit: UnitSource,
}

pub(crate) fn axis_angle(
    axis: Vector3<f64>,
    angle: Angle,
    rule: UnitRule,
) -> Result<ParsedRotation, Fault> {
    let ([angle_rad], unit) = angle::in_radians([angle], Of::Turns, rule)?;
    Ok(ParsedRotation::AxisAngle(ParsedAxisAngle {
        axis,
        angle_rad,
        unit,
    }))
}

pub(crate) fn euler_angles(
    sequence: EulerSequence,
    angles: [Angle; 3],
    rule: UnitRule,
) -> Result<ParsedRotation, Fault> {
    let (angles_rad, unit) = angle::in_radians(angles, Of::Turns, rule)?;
    Ok(ParsedRotation::EulerAngles(ParsedEulerAngles {
        sequence,
        angles_rad,
        unit,
    }))
}

pub(crate) fn rotation_vector(angles: [Angle; 3], rule: UnitRule) -> Result<ParsedRotation, Fault> {
    let (vector_rad, unit) = angle::in_radians(angles, Of::Vector, rule)?;
    Ok(ParsedRotation::RotationVector(ParsedRotationVector {
        vector_rad: vector_rad.into(),
        unit,
    }))
}

pub(crate) fn half_angle_vector(
    angles: [Angle; 3],
    rule: UnitRule,
) -> Result<ParsedRotation, Fault> {
    let (vector_rad, unit) = angle::in_radians(angles, Of::Vector, rule)?;
    Ok(ParsedRotation::HalfAngleVector(ParsedHalfAngleVector {
        vector_rad: vector_rad.into(),
        unit,
    }))
}

/// What the three numbers of Euler angles and of a rotation vector are, for a sentence.
pub(crate) const THREE_ANGLES: &str = "three angles, one for each axis of the sequence";
pub(crate) const THREE_NUMBERS: &str = "three numbers: the axis times the angle";
pub(crate) const THREE_HALVES: &str = "three numbers: the axis times half the angle";

/// Three numbers that may have units, in any brackets.
pub(crate) fn three(entries: &[Entry<'_>], span: Span, what: &str) -> Result<[Angle; 3], Fault> {
    let entries = members(entries)?;
    check_no_factor(&entries)?;
    check_separators(&entries, span)?;
    let mut angles: Vec<Angle> = Vec::new();
    for entry in entries.iter() {
        if let Some(key) = entry.key {
            return Err(Fault::unknown_argument(key.span, key.name));
        }
        angles.push((entry.node.angle()?, entry.node.span));
    }
    angles
        .try_into()
        .map_err(|found: Vec<Angle>| Fault::count_of_angles(span, found.len(), what))
}
