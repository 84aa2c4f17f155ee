//! A probe in texts to numbers.

use crate::analyze::identify::prediction::{Numbers, Printed, Question};
use crate::contract::probe::{MatrixLayout, Probe};
use crate::convention::order::ComponentOrder;
use crate::convention::order::OrderSource;
use crate::decimal::nearest_double;
use crate::library::{Language, stores_columns};
use crate::motion::perturbation::exponential;
use crate::problem::fault::Fault;
use crate::problem::{Field, Problem, ProblemCode, Span};
use crate::text::{
    ParsedRotation, RowMarks, only_numbers, parse_quaternion, parse_rotation, parse_vector,
};
use nalgebra::{Matrix3, Matrix4, Quaternion, Vector3, Vector4};

/// Fewer decimals than these are taken for exact in what went in, such as 0.5.
pub(crate) const ROUNDED_DECIMALS: usize = 3;

/// No library prints more of one quaternion, vector or matrix; and all observations are read again with every
/// letter, so that together they must not be long.
pub(crate) const LONGEST_TEXT_BYTES: usize = 4096;

/// What goes in.
pub(crate) fn question(probe: &Probe, language: Language) -> Result<Question, Problem> {
    Ok(match probe {
        Probe::Components { quaternion, .. } => {
            Question::Components(numbers(quaternion).map_err(in_field(Field::Quaternion))?)
        }
        Probe::Product { a, b, .. } => Question::Product(
            numbers(a).map_err(in_field(Field::A))?,
            numbers(b).map_err(in_field(Field::B))?,
        ),
        Probe::Rotate {
            quaternion, vector, ..
        } => Question::Rotate(
            numbers(quaternion).map_err(in_field(Field::Quaternion))?,
            vector_of(vector).map_err(in_field(Field::Vector))?,
        ),
        Probe::Matrix {
            quaternion,
            layout,
            printed,
        } => Question::Matrix(
            numbers(quaternion).map_err(in_field(Field::Quaternion))?,
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
            Question::from_matrix(matrix(given).map_err(in_field(Field::Matrix))?, layout)
        }
        Probe::QuarterTurn { .. } => Question::QuarterTurn,
        Probe::Perturb {
            quaternion,
            rotation_vector,
            ..
        } => Question::Perturb(
            numbers(quaternion).map_err(in_field(Field::Quaternion))?,
            turn(rotation_vector).map_err(in_field(Field::RotationVector))?,
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
    let text = probe.printed();
    let printed = match probe {
        Probe::Rotate { .. } => vector_of(text).map(Printed::Vector),
        Probe::Matrix { .. } => matrix(text).map(Printed::Matrix),
        Probe::Components { .. }
        | Probe::Product { .. }
        | Probe::FromMatrix { .. }
        | Probe::QuarterTurn { .. }
        | Probe::Perturb { .. } => numbers(text).map(Printed::Quaternion),
    };
    printed.map_err(in_field(Field::Printed))
}

fn in_field(field: Field) -> impl Fn(Fault) -> Problem {
    move |fault| fault.in_field(field)
}

/// How far the numbers may be rounded: half a unit of the last decimal, of what was printed and of
/// what went in, whichever is more.
pub(crate) fn rounding(probe: &Probe) -> f64 {
    let mut fewest = decimals(probe.printed());
    for input in probe.inputs() {
        let decimals = decimals(input);
        if decimals >= ROUNDED_DECIMALS {
            fewest = fewest.min(decimals);
        }
    }
    half_unit(fewest)
}

/// Half a unit of the last decimal of the text that has fewest, of those that are rounded.
pub(crate) fn rounding_of(texts: &[&str]) -> f64 {
    let mut fewest = None;
    for text in texts {
        let decimals = decimals(text);
        if decimals >= ROUNDED_DECIMALS && fewest.is_none_or(|fewest| decimals < fewest) {
            fewest = Some(decimals);
        }
    }
    fewest.map_or(0.0, half_unit)
}

/// Half a unit of the last of so many decimals.
pub(crate) fn half_unit(decimals: usize) -> f64 {
    nearest_double(&format!("5e-{}", decimals + 1))
}

/// The most digits that follow a point in a text.
pub(crate) fn decimals(text: &str) -> usize {
    let digits = |part: &str| part.bytes().take_while(u8::is_ascii_digit).count();
    let mut most = 0;
    for part in text.split('.').skip(1) {
        most = most.max(digits(part));
    }
    most
}

/// The text, if it is not too long to be worked on.
fn measured(text: &str) -> Result<&str, Fault> {
    if text.len() > LONGEST_TEXT_BYTES {
        let span = Span::of_trimmed(text);
        return Err(Fault::text_too_long(span, text.len(), LONGEST_TEXT_BYTES));
    }
    Ok(text)
}

pub(crate) fn vector_of(text: &str) -> Result<Vector3<f64>, Fault> {
    parse_vector(measured(text)?)
}

/// Four numbers: with names where the text tells which is which, and else as they stand.
fn numbers(text: &str) -> Result<Numbers, Fault> {
    let text = measured(text)?;
    let parsed = parse_quaternion(text, ComponentOrder::ScalarFirst).map_err(of_numbers)?;
    let Quaternion { coords } = parsed.quaternion;
    if coords.amax() == 0.0 {
        let fault = Fault::zero_quaternion(Span::of_trimmed(text));
        return Err(of_numbers(fault));
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
fn of_numbers(fault: Fault) -> Fault {
    let is_of_rotations = matches!(
        fault.code,
        ProblemCode::EmptyText
            | ProblemCode::WrongCount
            | ProblemCode::ZeroQuaternion
            | ProblemCode::NotAQuaternion
    );
    if !is_of_rotations {
        return fault;
    }
    Fault {
        expected: "the four numbers of a quaternion, not all zero, as they were put in or printed"
            .to_owned(),
        hint: "0.5 0.5 0.5 0.5, or with names w: 0.5, x: 0.5, y: 0.5, z: 0.5".to_owned(),
        ..fault
    }
}

/// The nine numbers of a matrix, whatever they are.
pub(crate) fn matrix(text: &str) -> Result<Matrix3<f64>, Fault> {
    let not_a_matrix = |what| Fault::not_a_matrix(Span::of_trimmed(text), what);
    let text = measured(text)?;
    if let Some(entries) = without_translation(text) {
        return Ok(entries);
    }
    match parse_rotation(text, ComponentOrder::ScalarFirst) {
        Ok(ParsedRotation::Matrix(entries)) => Ok(entries),
        Ok(other) => Err(not_a_matrix(other.in_words())),
        Err(fault) if fault.code == ProblemCode::WrongCount => Err(Fault {
            message: fault.message,
            span: fault.span,
            ..not_a_matrix("")
        }),
        Err(fault) => Err(fault),
    }
}

/// The nine numbers of sixteen that are a homogeneous matrix without a translation.
fn without_translation(text: &str) -> Option<Matrix3<f64>> {
    let numbers: [f64; 16] = only_numbers(text)?.try_into().ok()?;
    let matrix = Matrix4::from_row_slice(&numbers);
    let is_only_turn =
        matrix.row(3) == Vector4::w().transpose() && matrix.column(3) == Vector4::w();
    is_only_turn.then(|| matrix.fixed_view::<3, 3>(0, 0).into_owned())
}

fn turn(text: &str) -> Result<Quaternion<f64>, Fault> {
    exponential(vector_of(text)?).map_err(|_| Fault::too_large(Span::of_trimmed(text)))
}
