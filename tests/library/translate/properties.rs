//! Whatever is translated is one attitude at both ends, and each end reads what it prints.

use super::with_plain_quaternions;
use crate::property::for_all;
use crate::support::all_conventions;
use crate::turned::{angles, sequences, turned};
use proptest::prelude::*;
use quatlas::nalgebra::{Matrix3, Quaternion, UnitQuaternion};
use quatlas::{
    ComponentOrder, Components, CosineMatrix, Direction, Endpoint, LibraryEndpoint, Outcome,
    PrintedMatrix, ProblemCode, Request, TranslateReport, TranslateRequest, TranslatedEnd, analyze,
};

const CASES: u32 = 500;

/// What an entry of a matrix of a unit quaternion may be off by.
const TOLERANCE: f64 = 4e-15;

fn libraries_as_ends() -> impl Strategy<Value = LibraryEndpoint> {
    let ids: Vec<&str> = with_plain_quaternions().map(|library| library.id).collect();
    let directions = prop::option::of(prop::sample::select(Direction::ALL.to_vec()));
    (prop::sample::select(ids), directions).prop_map(|(id, direction)| LibraryEndpoint {
        id: id.to_owned(),
        order: None,
        direction,
    })
}

fn with_an_order_of_their_own() -> impl Strategy<Value = LibraryEndpoint> {
    let orders = prop::sample::select(ComponentOrder::ALL.to_vec());
    (libraries_as_ends(), orders).prop_map(|(end, order)| LibraryEndpoint {
        order: Some(order),
        ..end
    })
}

fn ends() -> impl Strategy<Value = Endpoint> {
    prop_oneof![
        2 => libraries_as_ends().prop_map(Endpoint::Library),
        1 => with_an_order_of_their_own().prop_map(Endpoint::Library),
        1 => prop::sample::select(all_conventions()).prop_map(Endpoint::convention),
    ]
}

/// A quaternion of norm 1, four numbers of no order yet.
fn numbers() -> impl Strategy<Value = [f64; 4]> {
    (sequences(), angles(), any::<bool>()).prop_map(|(sequence, angles, is_opposite)| {
        let q = turned(sequence, angles);
        let sign = if is_opposite { -1.0 } else { 1.0 };
        [q.w, q.i, q.j, q.k].map(|number| sign * number)
    })
}

/// Which old axis each new one is, as text, and the matrix from old to new coordinates.
fn axes() -> impl Strategy<Value = (String, Matrix3<f64>)> {
    let order = Just([0, 1, 2]).prop_shuffle();
    (order, prop::array::uniform3(any::<bool>())).prop_map(|(order, is_against)| {
        let mut matrix = Matrix3::zeros();
        let mut text = Vec::new();
        for (new, (old, is_against)) in order.into_iter().zip(is_against).enumerate() {
            matrix[(new, old)] = if is_against { -1.0 } else { 1.0 };
            let sign = if is_against { "-" } else { "" };
            text.push(format!("{sign}{}", ["x", "y", "z"][old]));
        }
        (text.join(" "), matrix)
    })
}

fn list(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|number| format!("{number:?}")).collect();
    numbers.join(", ")
}

fn report(request: TranslateRequest) -> Result<TranslateReport, TestCaseError> {
    match analyze(&Request::Translate(request.clone())) {
        Outcome::Translate(report) => Ok(*report),
        other => Err(TestCaseError::fail(format!("{request:?} gives {other:?}"))),
    }
}

fn translate(text: &str, from: &Endpoint, to: &Endpoint) -> Result<TranslateReport, TestCaseError> {
    report(TranslateRequest::new(text, from.clone(), to.clone()))
}

/// `R(q)`, by nalgebra.
fn active_matrix(q: &Components) -> Matrix3<f64> {
    let unit = UnitQuaternion::from_quaternion(Quaternion::new(q.w, q.x, q.y, q.z));
    unit.to_rotation_matrix().into_inner()
}

fn of_form(form: CosineMatrix, q: &Components) -> Matrix3<f64> {
    match form {
        CosineMatrix::Hamilton => active_matrix(q),
        CosineMatrix::Shuster => active_matrix(q).transpose(),
    }
}

/// `R_WB` of the numbers of one end, by what the end says of them.
fn body_to_world(end: &TranslatedEnd) -> Matrix3<f64> {
    let acts = of_form(end.action, &end.components);
    match end.direction {
        Direction::BodyToWorld => acts,
        Direction::WorldToBody => acts.transpose(),
    }
}

fn apart(one: &Matrix3<f64>, other: &Matrix3<f64>) -> f64 {
    (one - other).amax()
}

#[test]
fn both_ends_are_one_attitude_on_the_axes_that_were_asked_for() {
    let asked = prop::option::of((axes(), axes()));
    for_all(
        2 * CASES,
        (numbers(), ends(), ends(), asked),
        |(numbers, from, to, axes)| {
            let mut request = TranslateRequest::new(&list(&numbers), from, to);
            let (mut world, mut body) = (Matrix3::identity(), Matrix3::identity());
            if let Some((asked_world, asked_body)) = axes {
                (request.world_axes, world) = asked_world;
                (request.body_axes, body) = asked_body;
            }
            if world.determinant() * body.determinant() < 0.0 {
                let outcome = analyze(&Request::Translate(request));
                let Outcome::Problems(found) = outcome else {
                    return Err(TestCaseError::fail(format!("a reflection: {outcome:?}")));
                };
                prop_assert_eq!(found.problems[0].code, ProblemCode::OneSidedReflection);
                return Ok(());
            }
            let report = report(request)?;
            let expected = world * body_to_world(&report.from) * body.transpose();
            let apart = apart(&body_to_world(&report.to), &expected);
            prop_assert!(apart <= TOLERANCE, "{apart:e}: {report:?}");
            Ok(())
        },
    );
}

#[test]
fn the_printed_matrix_is_that_of_the_numbers_and_is_read_back() {
    for_all(CASES, (numbers(), ends(), ends()), |(numbers, from, to)| {
        let there = translate(&list(&numbers), &from, &to)?;
        let attitude = body_to_world(&there.from);
        for (end, endpoint) in [(&there.from, &from), (&there.to, &to)] {
            let Some(PrintedMatrix { rows, form, .. }) = end.matrix else {
                continue;
            };
            let printed = Matrix3::from(rows).transpose();
            let apart_by = apart(&printed, &of_form(form, &end.components));
            prop_assert!(apart_by <= TOLERANCE, "{apart_by:e}: {end:?}");
            for text in [list(&rows.concat()), in_lists(rows)] {
                let again = translate(&text, endpoint, &to)?;
                let apart_by = apart(&body_to_world(&again.to), &attitude);
                prop_assert!(apart_by <= 2.0 * TOLERANCE, "{text}: {apart_by:e}");
            }
        }
        Ok(())
    });
}

fn in_lists(rows: [[f64; 3]; 3]) -> String {
    format!(
        "[{}]",
        rows.map(|row| format!("[{}]", list(&row))).join(", ")
    )
}

#[test]
fn the_way_back_is_the_same_numbers() {
    for_all(CASES, (numbers(), ends(), ends()), |(numbers, from, to)| {
        let there = translate(&list(&numbers), &from, &to)?;
        let back = translate(&list(&there.to.array), &to, &from)?;
        prop_assert_eq!(back.to.array, there.from.array);
        prop_assert_eq!(back.change, there.change);
        prop_assert_eq!(back.product, there.product);
        Ok(())
    });
}

/// The line of an end, pasted at that end.
fn check_line(numbers: [f64; 4], from: &Endpoint, to: &Endpoint) -> Result<(), TestCaseError> {
    let there = translate(&list(&numbers), from, to)?;
    let Some(line) = &there.to.construct else {
        return Ok(());
    };
    let again = translate(line, to, from)?;
    let apart = apart(&body_to_world(&again.to), &body_to_world(&there.from));
    prop_assert!(apart <= TOLERANCE, "{line}: {apart:e}");
    Ok(())
}

#[test]
fn a_line_is_read_where_it_was_printed() {
    let to = libraries_as_ends().prop_map(Endpoint::Library);
    for_all(CASES, (numbers(), ends(), to), |(numbers, from, to)| {
        check_line(numbers, &from, &to)
    });
}

#[test]
fn a_line_of_an_order_of_its_own_is_read_where_it_was_printed() {
    let to = with_an_order_of_their_own().prop_map(Endpoint::Library);
    for_all(CASES, (numbers(), ends(), to), |(numbers, from, to)| {
        check_line(numbers, &from, &to)
    });
}
