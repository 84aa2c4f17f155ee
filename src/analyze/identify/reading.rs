//! A probe in texts to numbers.

use crate::analyze::identify::prediction::{Numbers, Printed, Question};
use crate::contract::probe::{MatrixLayout, Probe};
use crate::convention::ComponentOrder;
use crate::convention::OrderSource;
use crate::library::{Language, stores_columns};
use crate::motion::perturbation::exponential;
use crate::problem::fault::Fault;
use crate::problem::{Field, Problem, ProblemCode, Span};
use crate::text::{
    ParsedRotation, RowMarks, only_numbers, parse_quaternion, parse_rotation, parse_vector,
};
use nalgebra::{Matrix3, Quaternion};

/// Fewer decimals than these are taken for exact in what went in, such as 0.5.
const ROUNDED_DECIMALS: usize = 3;

/// No library prints more of one quaternion, vector or matrix; and all observations are read again with every
/// letter, so that together they must not be long.
pub(crate) const LONGEST_TEXT_BYTES: usize = 4096;

/// What goes in.
pub(crate) fn question(probe: &Probe, language: Language) -> Result<Question, Problem> {
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
            parse_vector(measured(vector, Field::Vector)?, Field::Vector)?,
        ),
        Probe::Matrix {
            quaternion,
            layout,
            printed,
        } => Question::Matrix(
            numbers(quaternion, Field::Quaternion)?,
            written_layout(*layout, printed, language),
        ),
        Probe::FromMatrix {
            matrix: given,
            layout,
            ..
        } => {
            // Whoever puts a matrix in knows its rows.
            let layout = match layout {
                MatrixLayout::AsWritten => MatrixLayout::Rows,
                known => *known,
            };
            Question::from_matrix(matrix(given, Field::Matrix)?, layout)
        }
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

/// Lists of lists are rows, except in languages whose libraries print the columns that they store.
fn written_layout(layout: MatrixLayout, printed: &str, language: Language) -> MatrixLayout {
    match (layout, RowMarks::of(printed)) {
        (MatrixLayout::AsWritten, RowMarks::Lines) => MatrixLayout::Rows,
        (MatrixLayout::AsWritten, RowMarks::Brackets) if !stores_columns(language) => {
            MatrixLayout::Rows
        }
        (MatrixLayout::AsWritten, _) => MatrixLayout::Unknown,
        (known, _) => known,
    }
}

/// What came out.
pub(crate) fn printed(probe: &Probe) -> Result<Printed, Problem> {
    let (text, field) = (probe.printed(), Field::Printed);
    Ok(match probe {
        Probe::Rotate { .. } => Printed::Vector(parse_vector(measured(text, field)?, field)?),
        Probe::Matrix { .. } => Printed::Matrix(matrix(text, field)?),
        Probe::Components { .. }
        | Probe::Product { .. }
        | Probe::FromMatrix { .. }
        | Probe::QuarterTurn { .. }
        | Probe::Perturb { .. } => Printed::Quaternion(numbers(text, field)?),
    })
}

/// How far the numbers may be rounded: half a unit of the last decimal, of what was printed and of
/// what went in, whichever is more.
pub(crate) fn rounding(probe: &Probe) -> f64 {
    let half_unit = |decimals: usize| 0.5 * 0.1_f64.powf(decimals as f64);
    let inputs = probe.inputs().into_iter();
    let rounded = inputs
        .map(decimals)
        .filter(|&decimals| decimals >= ROUNDED_DECIMALS)
        .chain([decimals(probe.printed())]);
    rounded.min().map_or(0.0, half_unit)
}

/// The most digits that follow a point in a text.
fn decimals(text: &str) -> usize {
    let digits = |part: &str| part.bytes().take_while(u8::is_ascii_digit).count();
    let points = text.match_indices('.');
    points
        .map(|(at, _)| digits(&text[at + 1..]))
        .max()
        .unwrap_or(0)
}

/// The text, if it is not too long to be worked on.
fn measured(text: &str, field: Field) -> Result<&str, Problem> {
    if text.len() > LONGEST_TEXT_BYTES {
        let span = Span::of_trimmed(text);
        let fault = Fault::text_too_long(span, text.len(), LONGEST_TEXT_BYTES);
        return Err(fault.in_field(field));
    }
    Ok(text)
}

/// Four numbers: with names where the text tells which is which, and else as they stand.
fn numbers(text: &str, field: Field) -> Result<Numbers, Problem> {
    let text = measured(text, field)?;
    let parsed = parse_quaternion(text, field, ComponentOrder::ScalarFirst).map_err(of_numbers)?;
    let Quaternion { coords } = parsed.quaternion;
    if coords.amax() == 0.0 {
        let fault = Fault::zero_quaternion(Span::of_trimmed(text));
        return Err(of_numbers(fault.in_field(field)));
    }
    let [w, x, y, z] = [coords.w, coords.x, coords.y, coords.z];
    // A constructor by name tells nothing here: which order it takes is the question.
    Ok(match (parsed.order_source, parsed.order) {
        (OrderSource::Named | OrderSource::Grouped, _) => Numbers::Named(parsed.quaternion),
        (_, ComponentOrder::ScalarFirst) => Numbers::AsWritten([w, x, y, z]),
        (_, ComponentOrder::ScalarLast) => Numbers::AsWritten([x, y, z, w]),
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
    let text = measured(text, field)?;
    if let Some(entries) = homogeneous(text) {
        return Ok(entries);
    }
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

/// The rotation part of sixteen numbers whose last row and last column are 0, 0, 0, 1.
fn homogeneous(text: &str) -> Option<Matrix3<f64>> {
    let numbers = only_numbers(text)?;
    let entry = |row: usize, column: usize| numbers[4 * row + column].value;
    let is_affine = numbers.len() == 16
        && entry(3, 3) == 1.0
        && (0..3).all(|at| entry(at, 3) == 0.0 && entry(3, at) == 0.0);
    is_affine.then(|| Matrix3::from_fn(entry))
}

fn turn(text: &str) -> Result<Quaternion<f64>, Problem> {
    let field = Field::RotationVector;
    let vector_rad = parse_vector(measured(text, field)?, field)?;
    exponential(vector_rad).map_err(|_| Fault::too_large(Span::of_trimmed(text)).in_field(field))
}
