//! The attitude in a whole block of text: which of its rotations is meant, and what stands beside it.

use crate::analyze::attitude::{Attitude, Declared};
use crate::analyze::plain_numbers::{coordinates, plain as plain_number, plain3};
use crate::analyze::record_choices::{other_order, several_rotations, several_rows};
use crate::character::is_alphabetic;
use crate::contract::{
    Beside, BesideQuantity, Fact, Form, FormatAssumed, FoundInText, OtherDescription,
    RotationAssumed,
};
use crate::convention::Direction;
use crate::convention::order::OrderSource;
use crate::library::VectorLayout;
use crate::problem::fault::Fault;
use crate::problem::{ProblemCode, Span, shorten};
use crate::text::{
    DeclaredFormat, FORMATS, PLAIN, ParsedQuaternion, ParsedRotation, Record, RecordRotation,
    RotationText, RowMarks, Told, What, other_than_rotation, record_of, says_nothing,
};
use nalgebra::{Matrix3, Vector3};

/// Two descriptions of one rotation are no farther apart, in degrees: angles are often printed with no
/// more than whole degrees, and matrices with two decimals.
const SAME_WITHIN_DEG: f64 = 0.75;

/// The attitude that is found in a text, or why it is not known which; `None` where none is found, or where
/// what the text is read as by itself, `plain`, stands.
pub(crate) fn of_record(
    text: &str,
    declared: Declared,
    plain: &Result<Attitude, Fault>,
) -> Option<Result<Attitude, Fault>> {
    let of_text = DeclaredFormat {
        order: declared.convention.order,
        library: declared.library.map(|library| library.id),
    };
    let record = record_of(text, of_text, FORMATS, PLAIN);
    if let Some(place) = record.unknown_orientation {
        return Some(Err(Fault::unknown_orientation(place)));
    }
    match plain {
        Ok(plain) => beside_plain(text, declared, &record, plain),
        Err(fault) if may_hold_more(text, &record, fault) => of_block(text, declared, &record),
        Err(_) => None,
    }
}

/// Whether a problem of a text is that it holds more than one rotation and its numbers: words around them,
/// other quantities, another notation. A sign in doubt, a sequence that contradicts or a number that is none
/// stays a problem of the text itself.
fn may_hold_more(text: &str, record: &Record, fault: &Fault) -> bool {
    let has_words = text.contains(is_alphabetic);
    let is_one_line = !text.trim().contains('\n');
    let is_arrow = text.get(fault.span.start..fault.span.end) == Some(">");
    let is_of_format =
        |found: &RecordRotation| found.format.is_some_and(|format| format.has_marks());
    let holds_more = record.quantities > 1
        || record.rotations.len() + record.beside.len() > 1
        || !record.rows.is_empty()
        || record.rotations.iter().any(is_of_format);
    match fault.code {
        ProblemCode::WrongCount => true,
        // A bracket that is missing where nothing but the numbers stands.
        ProblemCode::UnclosedBracket | ProblemCode::UnmatchedBracket
            if is_one_line && !holds_more =>
        {
            is_arrow
        }
        ProblemCode::UnknownWord
        | ProblemCode::UnknownComponent
        | ProblemCode::Unexpected
        | ProblemCode::UnexpectedCharacter
        | ProblemCode::UnexpectedEnd
        | ProblemCode::UnclosedBracket
        | ProblemCode::UnmatchedBracket
        | ProblemCode::MixedNames
        | ProblemCode::EmptyText => has_words || holds_more,
        ProblemCode::MissingComponent
        | ProblemCode::DuplicateComponent
        | ProblemCode::OtherQuantity
        | ProblemCode::NotAQuaternion
        | ProblemCode::UnknownSequence
        | ProblemCode::NotANumber
        | ProblemCode::Infinite => holds_more,
        ProblemCode::TwoMeanings => record.rotations.iter().any(is_of_format),
        _ => false,
    }
}

/// A rotation of a record, and the attitude that it is.
type Read<'r> = (&'r RecordRotation, Attitude);

/// The rotations of a record that can be meant, or the first problem of one.
fn read_all<'r>(
    text: &str,
    declared: Declared,
    record: &'r Record,
) -> (Vec<Read<'r>>, Option<Fault>) {
    let mut read = Vec::new();
    let mut fault = None;
    let is_meant = |found: &&RecordRotation| !found.is_derived && !is_another_quantity(found);
    for found in record.rotations.iter().filter(is_meant) {
        // Its own piece of the text, which may be one of many, and long.
        let own = &text[found.span.start..found.span.end];
        let parsed = RotationText {
            rotation: as_declared(found, declared),
            row_marks: match (found.by_columns, found.has_rows) {
                (true, _) => RowMarks::Columns,
                (false, true) => RowMarks::Lines,
                (false, false) => RowMarks::None,
            },
            told: Told::of_label(&found.label, Span::of_trimmed(own)),
        };
        match Attitude::of_parsed(parsed, own, declared) {
            Ok(attitude) => read.push((found, attitude)),
            Err(problem) => fault = fault.or(Some(problem.behind(found.span.start))),
        }
    }
    (read, fault)
}

/// The attitude of a text that is read only as a block.
fn of_block(text: &str, declared: Declared, record: &Record) -> Option<Result<Attitude, Fault>> {
    let (mut read, fault) = read_all(text, declared, record);
    if read.is_empty() {
        return fault.map(Err);
    }
    if record.rows.len() > 1 {
        return Some(Err(several_rows(record, text)));
    }
    let chosen = preferred(&read);
    let (found, attitude) = read.swap_remove(chosen);
    let others = others(&read, &attitude);
    let is_kind = |other: &RecordRotation| {
        std::mem::discriminant(&other.rotation) == std::mem::discriminant(&found.rotation)
    };
    // Of two quaternions one is another rotation; angles beside a quaternion should be the same one.
    // Formats write no turn for what was never set.
    let is_unset = |other: &RecordRotation| is_identity(other) && is_of_format(found, declared);
    let has_another = |(other, differs): &(&RecordRotation, f64)| {
        *differs > SAME_WITHIN_DEG && is_kind(other) && !is_unset(other)
    };
    if others.iter().any(has_another) {
        return Some(Err(several_rotations(record, text)));
    }
    let attitude = with_other_order(attitude, &read);
    let mut told = descriptions(text, &others);
    told.extend(found_in_text(record, found, &attitude, text));
    if is_assumed(found) && !has_mark_before(text, found.span) {
        return None;
    }
    if is_assumed(found) {
        let label = shorten(&found.label, LONGEST_LABEL);
        told.push(Fact::RotationAssumed(RotationAssumed { label }));
    }
    if let Some(format) = found.format.filter(|format| !format.has_marks()) {
        told.push(Fact::FormatAssumed(FormatAssumed {
            format: format.name.to_owned(),
        }));
    }
    Some(Ok(telling(attitude, told)))
}

/// What else stands in a text that is read by itself; `None` where nothing does.
fn beside_plain(
    text: &str,
    declared: Declared,
    record: &Record,
    plain: &Attitude,
) -> Option<Result<Attitude, Fault>> {
    if let (Some(row), true) = (record.rows.first(), record.rotations.is_empty()) {
        return Some(Err(Fault::no_rotation_in_row(*row)));
    }
    let (mut read, _) = read_all(text, declared, record);
    let same = read
        .iter()
        .position(|(_, attitude)| differs_by_deg(plain, attitude) < SAME_WITHIN_DEG);
    // What a format prints has its own meaning, whatever the numbers alone are read as.
    let of_format = || {
        let is_told = |parsed: &ParsedQuaternion| parsed.order_source != OrderSource::Declared;
        let has_own_order = !plain.is_far_from_unit()
            && (matches!(plain.form, Form::Matrix(_))
                || plain.parsed.as_ref().is_some_and(is_told));
        read.iter()
            .position(|(found, _)| !has_own_order && is_of_format(found, declared))
    };
    let (found, attitude) = read.swap_remove(same.or_else(of_format)?);
    let attitude = if same.is_some() {
        plain.clone()
    } else {
        attitude
    };
    let attitude = with_other_order(attitude, &read);
    let mut told = descriptions(text, &others(&read, &attitude));
    told.extend(found_in_text(record, found, &attitude, text));
    (!told.is_empty()).then(|| Ok(telling(attitude, told)))
}

fn telling(attitude: Attitude, told: Vec<Fact>) -> Attitude {
    let told = [&attitude.told[..], &told[..]].concat();
    Attitude { told, ..attitude }
}

/// With the same four numbers in the other order as a text, where the order was only declared and the other
/// one agrees with what else describes the rotation.
fn with_other_order(attitude: Attitude, others: &[Read<'_>]) -> Attitude {
    let Some(parsed) = &attitude.parsed else {
        return attitude;
    };
    let Some(in_other_order) = attitude.read_in_other_order() else {
        return attitude;
    };
    if parsed.order_source != OrderSource::Declared || attitude.is_far_from_unit() {
        return attitude;
    }
    let agrees = |(_, other): &Read<'_>| {
        let off_rad = in_other_order.angle_to_rad(&other.rotation);
        off_rad.to_degrees() < SAME_WITHIN_DEG && differs_by_deg(&attitude, other) > SAME_WITHIN_DEG
    };
    if !others.iter().any(agrees) {
        return attitude;
    }
    Attitude {
        meanings: [other_order(parsed)].into(),
        ..attitude
    }
}

fn differs_by_deg(one: &Attitude, other: &Attitude) -> f64 {
    one.rotation.angle_to_rad(&other.rotation).to_degrees()
}

fn others<'r>(read: &[Read<'r>], chosen: &Attitude) -> Vec<(&'r RecordRotation, f64)> {
    let mut others = Vec::new();
    for (found, other) in read {
        others.push((*found, differs_by_deg(chosen, other)));
    }
    others
}

fn descriptions(text: &str, others: &[(&RecordRotation, f64)]) -> Vec<Fact> {
    let mut told = Vec::new();
    for (other, differs_by_deg) in others {
        told.push(description(text, other, *differs_by_deg));
    }
    told
}

/// That the text holds the rotation a second time, or another one.
fn description(text: &str, other: &RecordRotation, differs_by_deg: f64) -> Fact {
    let description = OtherDescription {
        label: named(&other.label),
        text: closed(&text[other.span.start..other.span.end]),
        differs_by_deg: plain_number(differs_by_deg),
    };
    if differs_by_deg > SAME_WITHIN_DEG {
        Fact::DescriptionsDisagree(description)
    } else {
        Fact::SecondDescription(description)
    }
}

/// No turn, which stands for what was never set.
fn is_identity(found: &RecordRotation) -> bool {
    match &found.rotation {
        ParsedRotation::Quaternion(parsed) => parsed.quaternion.imag().amax() == 0.0,
        ParsedRotation::Matrix(matrix) => *matrix == Matrix3::identity(),
        _ => false,
    }
}

/// Whether a format says what the rotation is that is declared, or is known by its words.
fn is_of_format(found: &RecordRotation, declared: Declared) -> bool {
    found.format.is_some_and(|format| {
        let is_declared = declared
            .library
            .is_some_and(|library| library.id == format.id);
        is_declared || format.has_marks()
    })
}

/// Whether the label of numbers that may be anything names something else.
fn is_another_quantity(found: &RecordRotation) -> bool {
    may_be_anything(found) && other_than_rotation(&found.label).is_some()
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

/// Whether a mark divides numbers from the words before them, which are a label then: `pose: 1 0 0 0`.
fn has_mark_before(text: &str, numbers: Span) -> bool {
    let (before, own) = text.split_at(numbers.start);
    let before = before.trim_end();
    own.starts_with(['(', '[', '{'])
        || before.ends_with([':', '=', '>', '(', '[', '{', '<', '"', '≈', '⟨'])
}

/// How much of a label a note repeats, in characters.
const LONGEST_LABEL: usize = 40;

/// Whether only the count of the numbers, or that they are upright, makes a rotation of them: the label
/// says nothing, and no format is marked.
fn is_assumed(found: &RecordRotation) -> bool {
    may_be_anything(found) && !found.label.is_empty() && says_nothing(&found.label)
}

/// Whether neither a format nor the numbers themselves say that they are a rotation.
fn may_be_anything(found: &RecordRotation) -> bool {
    let is_any = match &found.rotation {
        ParsedRotation::Quaternion(parsed) => parsed.order_source == OrderSource::Declared,
        // A matrix of real numbers that is one is no accident; a permutation may be anything.
        ParsedRotation::Matrix(matrix) => matrix.iter().all(|entry| entry.fract() == 0.0),
        _ => false,
    };
    is_any && found.format.is_none()
}

fn named(label: &str) -> Option<String> {
    (!label.is_empty()).then(|| closed(label))
}

/// A piece of a text with the brackets that it leaves open.
fn closed(piece: &str) -> String {
    let mut text = piece.to_owned();
    let mut open = Vec::new();
    for mark in piece.chars() {
        match mark {
            '(' => open.push(')'),
            '[' => open.push(']'),
            '{' => open.push('}'),
            _ if open.last() == Some(&mark) => drop(open.pop()),
            _ => {}
        }
    }
    text.extend(open.iter().rev());
    text
}

/// Which of several descriptions is read: a quaternion or a matrix before angles, whose sequence may only be
/// the usual one, and what turns before what does not; the first of those.
fn preferred(read: &[Read<'_>]) -> usize {
    let is_certain = |(found, attitude): &Read<'_>| {
        matches!(attitude.form, Form::Quaternion | Form::Matrix(_)) && !is_identity(found)
    };
    read.iter().position(is_certain).unwrap_or(0)
}

/// What stands around the rotation; `None` where the numbers are all that there is.
fn found_in_text(
    record: &Record,
    found: &RecordRotation,
    attitude: &Attitude,
    text: &str,
) -> Option<Fact> {
    let mut all = Vec::new();
    for beside in &record.beside {
        let numbers = plain3(beside.numbers);
        let (quantity, body_in_world) = match beside.what {
            What::Scale => (BesideQuantity::Scale, None),
            What::Position if beside.is_in_world => (BesideQuantity::Position, Some(numbers)),
            What::Position => {
                let in_world = body_in_world(beside.numbers, attitude);
                (BesideQuantity::Position, Some(in_world))
            }
        };
        all.push(Beside {
            quantity,
            label: named(&beside.label),
            numbers,
            body_in_world,
        });
    }
    let format = found.format.map(|format| format.name.to_owned());
    let is_told = !all.is_empty() || format.is_some();
    is_told.then(|| {
        Fact::FoundInText(FoundInText {
            format,
            label: named(&found.label),
            text: closed(&text[found.span.start..found.span.end]),
            beside: all,
        })
    })
}

/// Where the body's origin stands in the world, of a translation beside numbers that lead from one to the
/// other: x = R X + t of world to body puts it at −Rᵀt.
fn body_in_world(translation: [f64; 3], attitude: &Attitude) -> [f64; 3] {
    let direction = match attitude.form {
        Form::Quaternion => attitude.tagged.convention.direction,
        Form::Matrix(read) => read.convention.direction,
        _ => Direction::BodyToWorld,
    };
    match direction {
        Direction::BodyToWorld => plain3(translation),
        Direction::WorldToBody => {
            let body_to_world = attitude.rotation.matrix(Direction::BodyToWorld);
            let origin = -(body_to_world * Vector3::from(translation));
            coordinates(&origin)
        }
    }
}
