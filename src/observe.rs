//! A probe in texts to numbers.

use crate::convention::ComponentOrder;
use crate::messages::Fault;
use crate::observation::{Numbers, Printed, Question};
use crate::parse::{ParsedRotation, parse_quaternion, parse_rotation, parse_vector};
use crate::perturbation::exponential;
use crate::probe::Probe;
use crate::problem::{Field, Problem, ProblemCode, Span};
use crate::report::OrderSource;
use nalgebra::{Matrix3, Quaternion};

/// Fewer decimals than these are taken for exact in what went in, such as 0.5.
const ROUNDED_DECIMALS: usize = 3;

/// What goes in.
pub(crate) fn question(probe: &Probe) -> Result<Question, Problem> {
    Ok(match probe {
        Probe::Components { quaternion, .. } => {
            Question::Components(numbers(quaternion, Field::Quaternion)?)
        }
        Probe::Product { a, b, .. } => {
            Question::Product(numbers(a, Field::A)?, numbers(b, Field::B)?)
        }
        Probe::Rotate {
            quaternion, vector, ..
        } => Question::Rotate(
            numbers(quaternion, Field::Quaternion)?,
            parse_vector(vector, Field::Vector)?,
        ),
        Probe::Matrix {
            quaternion, layout, ..
        } => Question::Matrix(numbers(quaternion, Field::Quaternion)?, *layout),
        Probe::FromMatrix {
            matrix: given,
            layout,
            ..
        } => Question::FromMatrix(matrix(given, Field::Matrix)?, *layout),
        Probe::QuarterTurn { .. } => Question::QuarterTurn,
        Probe::Perturb {
            quaternion,
            rotation_vector,
            ..
        } => Question::Perturb(
            numbers(quaternion, Field::Quaternion)?,
            turn(rotation_vector)?,
        ),
    })
}

/// What came out; `None` where nothing was entered yet.
pub(crate) fn printed(probe: &Probe) -> Result<Option<Printed>, Problem> {
    let text = probe.printed();
    if text.trim().is_empty() {
        return Ok(None);
    }
    let field = Field::Printed;
    Ok(Some(match probe {
        Probe::Rotate { .. } => Printed::Vector(parse_vector(text, field)?),
        Probe::Matrix { .. } => Printed::Matrix(matrix(text, field)?),
        Probe::Components { .. }
        | Probe::Product { .. }
        | Probe::FromMatrix { .. }
        | Probe::QuarterTurn { .. }
        | Probe::Perturb { .. } => Printed::Quaternion(numbers(text, field)?),
    }))
}

/// How far the numbers may be rounded: half a unit of the last decimal, of what was printed and of
/// what went in, whichever is more.
pub(crate) fn rounding(probe: &Probe) -> f64 {
    let half_unit = |decimals: usize| 0.5 * 0.1_f64.powf(decimals as f64);
    let given: &[&str] = match probe {
        Probe::Components { quaternion, .. }
        | Probe::Matrix { quaternion, .. }
        | Probe::Perturb { quaternion, .. } => &[quaternion],
        Probe::Rotate {
            quaternion, vector, ..
        } => &[quaternion, vector],
        Probe::Product { a, b, .. } => &[a, b],
        Probe::FromMatrix { matrix, .. } => &[matrix],
        Probe::QuarterTurn { .. } => &[],
    };
    let rounded = given
        .iter()
        .map(|text| decimals(text))
        .filter(|&decimals| decimals >= ROUNDED_DECIMALS)
        .chain([decimals(probe.printed())]);
    rounded.min().map_or(0.0, half_unit)
}

/// The most digits that follow a point in a text.
fn decimals(text: &str) -> usize {
    let digits = |part: &str| part.bytes().take_while(u8::is_ascii_digit).count();
    text.split('.').skip(1).map(digits).max().unwrap_or(0)
}

/// Four numbers: with names where the text tells which is which, and else as they stand.
fn numbers(text: &str, field: Field) -> Result<Numbers, Problem> {
    let parsed = parse_quaternion(text, field, ComponentOrder::ScalarFirst).map_err(of_numbers)?;
    let Quaternion { coords } = parsed.quaternion;
    if coords.amax() == 0.0 {
        let fault = Fault::zero_quaternion(Span::of_trimmed(text));
        return Err(of_numbers(fault.in_field(field)));
    }
    Ok(match parsed.order_source {
        OrderSource::Declared => Numbers::AsWritten([coords.w, coords.x, coords.y, coords.z]),
        _ => Numbers::Named(parsed.quaternion),
    })
}

/// Only numbers are wanted here, not any description of a rotation.
fn of_numbers(problem: Problem) -> Problem {
    let is_of_rotations = matches!(
        problem.code,
        ProblemCode::EmptyText
            | ProblemCode::WrongCount
            | ProblemCode::ZeroQuaternion
            | ProblemCode::NotAQuaternion
    );
    if !is_of_rotations {
        return problem;
    }
    Problem {
        expected: "the four numbers of a quaternion, not all zero, as they were put in or printed"
            .to_owned(),
        hint: "0.5 0.5 0.5 0.5, or with names w: 0.5, x: 0.5, y: 0.5, z: 0.5".to_owned(),
        ..problem
    }
}

fn matrix(text: &str, field: Field) -> Result<Matrix3<f64>, Problem> {
    let not_a_matrix = |what| {
        let fault = Fault::not_a_matrix(Span::of_trimmed(text), what);
        fault.in_field(field)
    };
    match parse_rotation(text, field, ComponentOrder::ScalarFirst) {
        Ok(ParsedRotation::Matrix(entries)) => Ok(entries),
        Ok(other) => Err(not_a_matrix(other.in_words())),
        Err(problem) if problem.code == ProblemCode::WrongCount => {
            let Problem { message, span, .. } = problem;
            Err(Problem {
                message,
                span,
                ..not_a_matrix("")
            })
        }
        Err(problem) => Err(problem),
    }
}

fn turn(text: &str) -> Result<Quaternion<f64>, Problem> {
    let field = Field::RotationVector;
    let vector_rad = parse_vector(text, field)?;
    exponential(vector_rad).map_err(|_| Fault::too_large(Span::of_trimmed(text)).in_field(field))
}
