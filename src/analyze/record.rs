//! The attitude in a whole block of text: which of its rotations is meant, and what stands beside it.

use crate::analyze::attitude::{Attitude, Declared};
use crate::analyze::plain_numbers::plain as plain_number;
use crate::contract::{
    Beside, BesideQuantity, Fact, Form, FormatAssumed, FoundInText, OtherDescription,
};
use crate::convention::Direction;
use crate::library::VectorLayout;
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::problem::suggestion::{Remedy, Suggestion};
use crate::text::mend::written::rotation_text;
use crate::text::{
    DeclaredFormat, FORMATS, PLAIN, ParsedRotation, Record, RecordRotation, RotationText, RowMarks,
    What, record_of,
};
use nalgebra::Vector3;

/// Two descriptions of one rotation are no farther apart, in degrees: angles are often printed with no
/// more than whole degrees, and matrices with two decimals.
const SAME_WITHIN_DEG: f64 = 0.75;

/// The attitude that is found in a text, or why it is not known which; `None` where none is found.
///
/// `plain` is what the text is read as by itself, where it is.
pub(crate) fn of_record(
    text: &str,
    declared: Declared,
    plain: Option<&Attitude>,
) -> Option<Result<Attitude, Fault>> {
    let of_text = DeclaredFormat {
        order: declared.convention.order,
        library: declared.library.map(|library| library.id),
    };
    let record = record_of(text, of_text, FORMATS, PLAIN);
    let mut read: Vec<(&RecordRotation, Attitude)> = Vec::new();
    let mut fault = None;
    for found in record.rotations.iter().filter(|found| !found.is_derived) {
        let parsed = RotationText {
            rotation: as_declared(found, declared),
            row_marks: if found.has_rows {
                RowMarks::Lines
            } else {
                RowMarks::None
            },
        };
        match Attitude::of_parsed(parsed, text, declared) {
            Ok(attitude) => read.push((found, attitude)),
            Err(problem) => fault = fault.or(Some(problem)),
        }
    }
    let derived = record.rotations.iter().find(|found| found.is_derived);
    let has_head = record.head.is_some();
    if read.is_empty() && plain.is_some() && has_head && record.rotations.is_empty() {
        return Some(Err(Fault::no_rotation_in_row(record.rows[0])));
    }
    if read.is_empty() {
        return match (fault, derived) {
            (Some(fault), _) => Some(Err(fault)),
            (None, Some(derived)) if plain.is_none() => {
                Some(Err(Fault::derived_label(derived.span, &derived.label)))
            }
            _ => None,
        };
    }
    if plain.is_none() && record.rows.len() > 1 {
        return Some(Err(several_rows(&record, text)));
    }
    let differs =
        |one: &Attitude, other: &Attitude| one.rotation.angle_to_rad(&other.rotation).to_degrees();
    let chosen = match plain {
        Some(plain) => {
            let agrees = read
                .iter()
                .position(|(_, attitude)| differs(plain, attitude) < SAME_WITHIN_DEG);
            // What a format prints has its own meaning, whatever the numbers alone are read as.
            let of_format = || {
                read.iter()
                    .position(|(found, _)| is_of_format(found, declared))
            };
            agrees.or_else(of_format)?
        }
        None => preferred(&read),
    };
    let plain = plain.filter(|plain| differs(plain, &read[chosen].1) < SAME_WITHIN_DEG);
    let others: Vec<(&RecordRotation, f64)> = read
        .iter()
        .enumerate()
        .filter(|(at, _)| *at != chosen)
        .map(|(_, (found, other))| (*found, differs(&read[chosen].1, other)))
        .collect();
    let (found, attitude) = read.swap_remove(chosen);
    let disagree = others.iter().any(|(_, differs)| *differs > SAME_WITHIN_DEG);
    let is_kind = |other: &RecordRotation| {
        std::mem::discriminant(&other.rotation) == std::mem::discriminant(&found.rotation)
    };
    // Of two quaternions one is another rotation; angles beside a quaternion should be the same one.
    if disagree
        && plain.is_none()
        && others
            .iter()
            .any(|(other, differs)| *differs > SAME_WITHIN_DEG && is_kind(other))
    {
        return Some(Err(several_rotations(&record, text)));
    }
    let mut told = Vec::new();
    for (other, differs_by_deg) in others {
        let description = OtherDescription {
            label: named(&other.label),
            text: text[other.span.start..other.span.end].to_owned(),
            differs_by_deg: plain_number(differs_by_deg),
        };
        told.push(if differs_by_deg > SAME_WITHIN_DEG {
            Fact::DescriptionsDisagree(description)
        } else {
            Fact::SecondDescription(description)
        });
    }
    told.extend(found_in_text(&record, found, &attitude, declared, text));
    if found.by_columns && plain.is_none() {
        told.push(Fact::ColumnsFromText);
    }
    if let Some(format) = found.format.filter(|format| format.marks.is_empty()) {
        told.push(Fact::FormatAssumed(FormatAssumed {
            format: format.name.to_owned(),
        }));
    }
    let attitude = match plain {
        Some(plain) => plain.clone(),
        None => attitude,
    };
    Some(Ok(Attitude { told, ..attitude }))
}

/// Whether a format says what the rotation is that is declared, or is known by its words.
fn is_of_format(found: &RecordRotation, declared: Declared) -> bool {
    found.format.is_some_and(|format| {
        let is_declared = declared
            .library
            .is_some_and(|library| library.id == format.id);
        is_declared || !format.marks.is_empty()
    })
}

/// The rotation as the declaration has it: what a library prints for row vectors was read with the
/// translation in its last row, so it is as it was printed again.
fn as_declared(found: &RecordRotation, declared: Declared) -> ParsedRotation {
    let is_for_rows = declared
        .library
        .is_some_and(|library| library.vectors == VectorLayout::Row);
    match &found.rotation {
        ParsedRotation::Matrix(matrix) if found.by_columns && is_for_rows => {
            ParsedRotation::Matrix(matrix.transpose())
        }
        rotation => rotation.clone(),
    }
}

fn named(label: &str) -> Option<String> {
    (!label.is_empty()).then(|| label.to_owned())
}

/// A quaternion or a matrix before angles, whose sequence may only be the usual one; the first of those.
fn preferred(read: &[(&RecordRotation, Attitude)]) -> usize {
    let is_certain =
        |attitude: &Attitude| matches!(attitude.form, Form::Quaternion | Form::Matrix(_));
    read.iter()
        .position(|(_, attitude)| is_certain(attitude))
        .unwrap_or(0)
}

/// What stands around the rotation; `None` where the numbers are all that there is.
fn found_in_text(
    record: &Record,
    found: &RecordRotation,
    attitude: &Attitude,
    declared: Declared,
    text: &str,
) -> Option<Fact> {
    let beside: Vec<Beside> = record
        .beside
        .iter()
        .map(|beside| Beside {
            quantity: match beside.what {
                What::Position => BesideQuantity::Position,
                What::Scale => BesideQuantity::Scale,
            },
            label: named(&beside.label),
            numbers: beside.numbers.map(plain_number),
            body_in_world: (beside.what == What::Position).then(|| {
                if beside.is_in_world {
                    beside.numbers.map(plain_number)
                } else {
                    body_in_world(beside.numbers, attitude, declared)
                }
            }),
        })
        .collect();
    let format = found.format.map(|format| format.name.to_owned());
    let is_told = !beside.is_empty() || format.is_some();
    is_told.then(|| {
        Fact::FoundInText(FoundInText {
            format,
            label: named(&found.label),
            text: text[found.span.start..found.span.end].to_owned(),
            beside,
        })
    })
}

/// Where the body's origin stands in the world, of a translation beside numbers that lead from one to the
/// other: x = R X + t of world to body puts it at −Rᵀt.
fn body_in_world(translation: [f64; 3], attitude: &Attitude, declared: Declared) -> [f64; 3] {
    let direction = match attitude.form {
        Form::Quaternion => declared.convention.direction,
        Form::Matrix(_) => declared.matrix.direction,
        _ => Direction::BodyToWorld,
    };
    match direction {
        Direction::BodyToWorld => translation.map(plain_number),
        Direction::WorldToBody => {
            let body_to_world = attitude.rotation.matrix(Direction::BodyToWorld);
            let origin = -(body_to_world * Vector3::from(translation));
            [origin.x, origin.y, origin.z].map(plain_number)
        }
    }
}

/// That there are several rotations, each as a text of its own.
fn several_rotations(record: &Record, text: &str) -> Fault {
    let span = Span::of_trimmed(text);
    let rotations = record.rotations.iter().filter(|found| !found.is_derived);
    let count = rotations.clone().count();
    Fault::several_rotations(span, count).offering(|| {
        rotations
            .enumerate()
            .map(|(at, found)| Suggestion {
                label: Some(if found.label.is_empty() {
                    format!("{}", at + 1)
                } else {
                    found.label.clone()
                }),
                ..Suggestion::new(Remedy::ThisRotation, rotation_text(&found.rotation))
            })
            .collect()
    })
}

/// That there are several rows of a file: the names above and one of them is a text of its own.
fn several_rows(record: &Record, text: &str) -> Fault {
    let span = record.rows[0].to(record.rows[record.rows.len() - 1]);
    Fault::several_rows(span, record.rows.len()).offering(|| {
        let head = record.head.map_or("", |head| &text[head.start..head.end]);
        let last = record.rows.len() - 1;
        [0, last]
            .into_iter()
            .map(|at| {
                let row = &text[record.rows[at].start..record.rows[at].end];
                let text = if head.is_empty() {
                    row.to_owned()
                } else {
                    format!("{head}\n{row}")
                };
                Suggestion {
                    label: Some(format!("row {}", at + 1)),
                    ..Suggestion::new(Remedy::ThisRotation, text)
                }
            })
            .collect()
    })
}
