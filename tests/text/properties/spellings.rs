//! What may be written in several ways and means the same.

use crate::asked::read_request;
use crate::properties::corpus::{changed, corpus};
use crate::properties::each::for_all_of_each;
use crate::properties::written::written;
use crate::property::for_all;
use crate::support::all_conventions;
use crate::turned::{angles, sequences, turned};
use proptest::prelude::*;
use quatlas::nalgebra::Matrix3;
use quatlas::{
    ComponentOrder, Convention, Direction, Fact, MatrixConvention, Outcome, ReadReport,
    ReadRequest, Request, TaggedQuaternion, Turn, analyze,
};

const CASES: u32 = 600;

fn answer(text: &str, convention: Convention) -> Outcome {
    analyze(&read_request(text, "1 2 3", convention))
}

fn report(request: &Request) -> Result<ReadReport, TestCaseError> {
    match analyze(request) {
        Outcome::Read(report) => Ok(*report),
        other => Err(TestCaseError::fail(format!("{request:?} gives {other:?}"))),
    }
}

fn read(text: &str) -> Result<ReadReport, TestCaseError> {
    report(&read_request(text, "1 2 3", Convention::HAMILTON))
}

/// The report without the texts that are offered in it or quoted.
fn without_texts(mut report: ReadReport) -> ReadReport {
    for note in &mut report.notes {
        if let Fact::AngleUnitAssumed(assumed) = &mut note.fact {
            assumed.in_degrees = None;
            assumed.in_radians = None;
        }
        note.suggestions = Box::default();
        if let Fact::FoundInText(found) = &mut note.fact {
            found.text.clear();
        }
    }
    report
}

/// The largest difference of two entries.
fn difference(one: [[f64; 3]; 3], other: &Matrix3<f64>) -> f64 {
    (Matrix3::from(one).transpose() - other).amax()
}

#[test]
fn what_is_written_is_read() {
    for_all(CASES, written(), |written| {
        let report = read(&written.text)?;
        let apart = difference(report.hamilton.matrix, &written.body_to_world);
        prop_assert!(
            apart <= written.tolerance,
            "{apart:e}: {:?}",
            report.quaternion
        );
        Ok(())
    });
}

/// Other spacing, and what it is.
type Spacing = (&'static str, fn(&str) -> String);

const SPACINGS: &[Spacing] = &[
    ("spaces that are doubled", |text| text.replace(' ', "  ")),
    ("lines that end as in Windows", |text| {
        text.replace('\n', "\r\n")
    }),
    ("spaces after commas", |text| text.replace(',', ", ")),
    ("spaces inside brackets", spaced_brackets),
    ("white space around", |text| format!(" \n\t{text}\n \t\r\n")),
];

/// Without those of a console's count, as in `Float32Array(4) [`.
fn spaced_brackets(text: &str) -> String {
    let mut spaced = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(['(', '[', '{', ')', ']', '}']) {
        let (before, bracket) = rest.split_at(at);
        spaced.push_str(before);
        let digits = bracket[1..].bytes().take_while(u8::is_ascii_digit).count();
        let is_count =
            bracket.starts_with('(') && digits > 0 && bracket[1 + digits..].starts_with(')');
        let (mark, next) = bracket.split_at(if is_count { digits + 2 } else { 1 });
        match mark {
            "(" | "[" | "{" => spaced.extend([mark, " "]),
            ")" | "]" | "}" => spaced.extend([" ", mark]),
            count => spaced.push_str(count),
        }
        rest = next;
    }
    spaced + rest
}

/// What is read is the same with any other spacing.
fn check_spacings(text: &str, convention: Convention) -> Result<(), TestCaseError> {
    let Outcome::Read(plain) = answer(text, convention) else {
        return Ok(());
    };
    let plain = without_texts(*plain);
    for (name, spaced) in SPACINGS {
        let spaced = spaced(text);
        let report = report(&read_request(&spaced, "1 2 3", convention))?;
        prop_assert_eq!(&without_texts(report), &plain, "{}: {:?}", name, spaced);
    }
    Ok(())
}

#[test]
fn spacing_changes_nothing_of_what_is_written() {
    for_all(CASES / 2, written(), |written| {
        read(&written.text)?;
        check_spacings(&written.text, Convention::HAMILTON)
    });
}

#[test]
fn spacing_changes_nothing_of_what_is_read() {
    for_all_of_each(&corpus(), 1, changed, |text| {
        check_spacings(&text, Convention::JPL)
    });
}

fn numbers() -> impl Strategy<Value = [f64; 4]> {
    let part = prop_oneof![
        6 => -1.0..1.0_f64,
        1 => Just(0.0),
        1 => -1e-9..1e-9_f64,
        1 => prop::sample::select(vec![1.0, -1.0, 0.5, -0.5, 3.0, 1e-160, 1e160]),
    ];
    prop::array::uniform4(part).prop_filter("no rotation", |numbers| {
        numbers.iter().any(|number| *number != 0.0)
    })
}

fn conventions() -> impl Strategy<Value = Convention> {
    prop::sample::select(all_conventions())
}

fn list(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|number| format!("{number:?}")).collect();
    numbers.join(", ")
}

/// Of any norm, which is read where the text says what the numbers are.
fn quaternion(numbers: &[f64; 4]) -> String {
    format!("quaternion {}", list(numbers))
}

#[test]
fn minus_q_is_the_same_rotation() {
    for_all(
        CASES,
        (numbers(), conventions()),
        |(numbers, convention)| {
            let one = report(&read_request(&quaternion(&numbers), "1 2 3", convention))?;
            let opposite = quaternion(&numbers.map(|number| -number));
            let other = report(&read_request(&opposite, "1 2 3", convention))?;
            prop_assert_eq!(one.hamilton.matrix, other.hamilton.matrix);
            prop_assert_eq!(one.jpl.matrix, other.jpl.matrix);
            prop_assert_eq!(one.declared.image, other.declared.image);
            let [one_euler, other_euler] =
                [&one, &other].map(|report| turned(report.euler.sequence, report.euler.angles_rad));
            prop_assert!(one_euler.angle_to(&other_euler) <= 1e-14);
            // At half a turn the axis and its opposite are both right, and each has the sign of its q.
            let turned_round = Turn {
                axis: other.turn.axis.map(opposite_of),
                rotation_vector_rad: opposite_of(other.turn.rotation_vector_rad),
                gibbs_vector: other.turn.gibbs_vector.map(opposite_of),
                modified_rodrigues_parameters: opposite_of(
                    other.turn.modified_rodrigues_parameters,
                ),
                ..other.turn.clone()
            };
            let is_half_a_turn = one.hamilton.quaternion.w == 0.0;
            let expected = if is_half_a_turn {
                turned_round
            } else {
                other.turn
            };
            prop_assert_eq!(one.turn, expected);
            Ok(())
        },
    );
}

fn opposite_of(numbers: [f64; 3]) -> [f64; 3] {
    numbers.map(|number| 0.0 - number)
}

#[test]
fn the_declared_order_is_that_of_the_numbers() {
    for_all(
        CASES,
        (numbers(), conventions()),
        |([w, x, y, z], convention)| {
            let declared = |order, numbers: [f64; 4]| {
                let convention = Convention {
                    order,
                    ..convention
                };
                report(&read_request(&quaternion(&numbers), "1 2 3", convention))
            };
            let first = declared(ComponentOrder::ScalarFirst, [w, x, y, z])?;
            let last = declared(ComponentOrder::ScalarLast, [x, y, z, w])?;
            prop_assert_eq!(&first.hamilton, &last.hamilton);
            prop_assert_eq!(&first.jpl, &last.jpl);
            prop_assert_eq!(&first.turn, &last.turn);
            prop_assert_eq!(first.declared.matrix, last.declared.matrix);
            // By name, no order is declared.
            let named = format!("qw: {w:?}, qx: {x:?}, qy: {y:?}, qz: {z:?}");
            let named = report(&read_request(&named, "1 2 3", convention))?;
            prop_assert_eq!(&named.hamilton, &first.hamilton);
            Ok(())
        },
    );
}

/// Where each number of a report is pasted, the same attitude is read.
#[test]
fn what_is_reported_is_read_back() {
    for_all(
        CASES / 2,
        (sequences(), angles(), sequences(), conventions()),
        |(sequence, angles, euler, convention)| {
            let rotation = turned(sequence, angles);
            let matrix = rotation.to_rotation_matrix().into_inner();
            let named = format!(
                "w={:?} x={:?} y={:?} z={:?}",
                rotation.w, rotation.i, rotation.j, rotation.k
            );
            let canonical = read(&named)?.hamilton.unit;
            let text = list(
                &TaggedQuaternion::new(
                    canonical.w,
                    canonical.x,
                    canonical.y,
                    canonical.z,
                    Convention::HAMILTON,
                )
                .to_convention(convention)
                .to_array(),
            );
            let request = |text: &str| {
                Request::Read(ReadRequest {
                    euler,
                    ..ReadRequest::new(text, "1 2 3", convention)
                })
            };
            let told = report(&request(&text))?;
            let near = |text: &str, tolerance: f64| {
                let again = report(&request(text))?;
                let apart = difference(again.hamilton.matrix, &matrix);
                prop_assert!(apart <= tolerance, "{}: {:e}", text, apart);
                Ok(again)
            };
            near(&text, 4e-15)?;
            let again = near(&list(&told.declared.unit.array), 4e-15)?;
            prop_assert_eq!(&again.declared.unit, &told.declared.unit);
            near(
                &rows(told.hamilton.matrix, ["[[", ", ", "], [", "]]"]),
                4e-15,
            )?;
            near(&rows(told.hamilton.matrix, ["[", " ", "; ", "]"]), 4e-15)?;
            near(&rows(told.hamilton.matrix, ["", " ", "\n", ""]), 4e-15)?;
            let [axis, vector] = [
                told.turn.axis.unwrap_or([0.0, 0.0, 1.0]),
                told.turn.rotation_vector_rad,
            ]
            .map(|numbers| list(&numbers));
            near(&format!("rotvec [{vector}]"), 1e-14)?;
            near(
                &format!("axis-angle [{axis}] {:?} rad", told.turn.angle_rad),
                1e-14,
            )?;
            near(&format!("{:?}° about [{axis}]", told.turn.angle_deg), 1e-14)?;
            near(
                &format!("{euler} {} rad", list(&told.euler.angles_rad)),
                3e-14,
            )?;
            near(
                &format!("{euler} {} deg", list(&told.euler.angles_deg)),
                3e-14,
            )?;
            Ok(())
        },
    );
}

fn rows(rows: [[f64; 3]; 3], [open, between, next, close]: [&str; 4]) -> String {
    let rows = rows.map(|row| row.map(|number| format!("{number:?}")).join(between));
    format!("{open}{}{close}", rows.join(next))
}

#[test]
fn a_matrix_is_read_as_it_is_declared() {
    let declarations = prop::sample::select(MatrixConvention::all().collect::<Vec<_>>());
    for_all(
        CASES / 2,
        (sequences(), angles(), declarations),
        |(sequence, angles, declared)| {
            let matrix = turned(sequence, angles).to_rotation_matrix().into_inner();
            let typed = match declared.operator() {
                Direction::BodyToWorld => matrix.transpose(),
                Direction::WorldToBody => matrix,
            };
            // nalgebra's matrices are lists of columns: the columns of the transpose are the rows.
            let text = rows(typed.into(), ["[[", ", ", "], [", "]]"]);
            let request = ReadRequest {
                matrix: declared,
                ..ReadRequest::new(&text, "1 2 3", Convention::JPL)
            };
            let report = report(&Request::Read(request))?;
            let apart = difference(report.hamilton.matrix, &matrix);
            prop_assert!(apart <= 4e-15, "{}: {:e}", text, apart);
            Ok(())
        },
    );
}
