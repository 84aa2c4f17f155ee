//! The attitude in a whole block of text: which of its rotations is meant, and what stands beside it.

use crate::analyze::attitude::{Attitude, Declared};
use crate::analyze::record_choices::{other_order, several_rotations, several_rows};
use crate::analyze::record_kind::{is_another_quantity, is_assumed, is_identity, is_of_format};
use crate::analyze::record_told::{SAME_WITHIN_DEG, descriptions, found_in_text, loose_angles};
use crate::character::is_alphabetic;
use crate::contract::{Fact, Form, FormatAssumed, RotationAssumed};
use crate::convention::order::OrderSource;
use crate::library::VectorLayout;
use crate::problem::fault::Fault;
use crate::problem::{ProblemCode, Span, Wanted, shorten};
use crate::text::{
    Comment, DeclaredFormat, FORMATS, PLAIN, ParsedQuaternion, ParsedRotation, Record,
    RecordRotation, RotationText, RowMarks, Told, comments_of, is_for_rows, made_by_code,
    made_by_remark, record_of,
};

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
        Err(fault) if may_hold_more(text, &record, fault) => {
            let found = of_block(text, declared, &record);
            let is_formula = || found.is_none() && is_formula(text, &record, fault);
            if is_formula() {
                return Some(Err(Fault::formula(Span::of_trimmed(text))));
            }
            found
        }
        Err(_) => None,
    }
}

/// Whether a text says with letters and signs how something is made of others, and has no numbers of a rotation:
/// `R = I + sin(θ) K`.
fn is_formula(text: &str, record: &Record, fault: &Fault) -> bool {
    let is_unread = matches!(
        fault.code,
        ProblemCode::UnknownWord | ProblemCode::UnexpectedCharacter | ProblemCode::Unexpected
    );
    let right = text.split_once('=').map_or("", |(_, right)| right);
    let computes = right.contains([
        '*', '^', '/', '+', '−', '·', '⊗', '⊙', '∘', '\\', '²', '(', ' ',
    ]);
    // `0.6 + 0.8i` has no names.
    let has_names = right.contains(|mark: char| is_alphabetic(mark) && !"ijke".contains(mark));
    is_unread && record.most_numbers < 3 && computes && has_names
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
    let comments = comments_of(text);
    let is_meant = |found: &&RecordRotation| !found.is_derived && !is_another_quantity(found);
    for found in record.rotations.iter().filter(is_meant) {
        // Its own piece of the text, which may be one of many, and long.
        let own = &text[found.span.start..found.span.end];
        let told = match told_around(text, found, &comments) {
            Ok(told) => told,
            Err(problem) => {
                fault = fault.or(Some(problem));
                continue;
            }
        };
        let parsed = RotationText {
            rotation: as_declared(found, declared, comments.iter().any(is_for_rows)),
            row_marks: match (found.by_columns, found.has_rows) {
                (true, _) => RowMarks::Columns,
                (false, true) => RowMarks::Lines,
                (false, false) => RowMarks::None,
            },
            told: told.with_comments(&comments, Span::of_trimmed(own)),
        };
        match Attitude::of_parsed(parsed, own, declared) {
            Ok(attitude) => read.push((found, attitude)),
            Err(problem) => fault = fault.or(Some(problem.behind(found.span.start))),
        }
    }
    (read, fault)
}

/// What is told by the label of a rotation and by what is said around it.
fn told_around<'t>(
    text: &'t str,
    found: &'t RecordRotation,
    comments: &[Comment<'t>],
) -> Result<Told<'t>, Fault> {
    let refused = |span, what| Err(Fault::other_comment(span, what, Wanted::Quaternion));
    if let Some(span) = found.code
        && let Some(what) = made_by_code(&text[span.start..span.end])
    {
        return refused(span, what);
    }
    // What was typed at a prompt is the name of what it printed.
    if found.label.contains(['(', '\'', '.'])
        && let Some(what) = made_by_code(&found.label)
    {
        return refused(found.span, what);
    }
    let span = found.remark;
    let remark = &text[span.start..span.end];
    if let Some(what) = made_by_remark(remark) {
        return refused(span, what);
    }
    // What a comment says is told once, with all comments.
    let mut label = &found.label[..];
    let mut is_comment = false;
    for comment in comments {
        if comment.text.contains(label) {
            label = "";
        }
        is_comment |= comment.span.start <= span.start && span.start < comment.span.end;
    }
    let told = Told::around(label, found.span, &[Comment { text: remark, span }])?;
    if is_comment {
        Told::around(label, found.span, &[])
    } else {
        Ok(told)
    }
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
    told.extend(loose_angles(text, record, &attitude));
    told.extend(found_in_text(record, found, &attitude, text));
    // `2026-07-08T09:10:11 0.1 0.2 0.3 0.9`, a row of an AEM of CCSDS.
    let is_row = found.label.contains(':')
        && found
            .label
            .starts_with(|first: char| first.is_ascii_digit());
    if is_assumed(found) && !is_row && !has_mark_before(text, found.span) {
        return None;
    }
    if is_assumed(found) && is_row {
        told.push(Fact::FormatAssumed(FormatAssumed {
            format: "a time and a quaternion".to_owned(),
        }));
    } else if is_assumed(found) {
        let label = shorten(&found.label, LONGEST_LABEL);
        told.push(Fact::RotationAssumed(RotationAssumed { label }));
    }
    if let Some(format) = found.format.filter(|format| !format.has_marks()) {
        told.push(Fact::FormatAssumed(FormatAssumed {
            format: format.name.to_owned(),
        }));
    }
    Some(Ok(attitude.telling(told)))
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
    let (mut read, fault) = read_all(text, declared, record);
    // What is said around the numbers, which the grammar reads past.
    if read.is_empty()
        && let Some(fault) = fault
        && fault.code == ProblemCode::OtherQuantity
    {
        return Some(Err(fault));
    }
    let same = read
        .iter()
        .position(|(_, attitude)| differs_by_deg(plain, attitude) < SAME_WITHIN_DEG);
    // What a format prints has its own meaning, whatever the numbers alone are read as.
    let of_format = || {
        let is_told = |parsed: &ParsedQuaternion| parsed.order_source != OrderSource::Declared;
        let has_own_order = !plain.is_far_from_unit()
            && (matches!(plain.form, Form::Matrix(_))
                || plain.parsed.as_ref().is_some_and(is_told));
        // So has what is said behind the numbers.
        let is_ordered = |attitude: &Attitude| {
            let parsed = attitude.parsed.as_ref();
            parsed.is_some_and(|parsed| parsed.order_source == OrderSource::Label)
        };
        read.iter().position(|(found, attitude)| {
            !has_own_order && (is_of_format(found, declared) || is_ordered(attitude))
        })
    };
    let (found, attitude) = read.swap_remove(same.or_else(of_format)?);
    let attitude = if same.is_some() {
        plain.clone()
    } else {
        attitude
    };
    let attitude = with_other_order(attitude, &read);
    let mut told = descriptions(text, &others(&read, &attitude));
    told.extend(loose_angles(text, record, &attitude));
    told.extend(found_in_text(record, found, &attitude, text));
    let is_more = same.is_none() || !told.is_empty();
    is_more.then(|| Ok(attitude.telling(told)))
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

/// The rotation as the declaration has it: what a library prints for row vectors was read with the
/// translation in its last row, so it is as it was printed again; one of which a comment says that it multiplies
/// rows is the transpose.
fn as_declared(
    found: &RecordRotation,
    declared: Declared,
    is_told_for_rows: bool,
) -> ParsedRotation {
    let is_library_of_rows = declared
        .library
        .is_some_and(|library| library.vectors == VectorLayout::Row);
    match &found.rotation {
        ParsedRotation::Matrix(matrix)
            if (found.by_columns && is_library_of_rows) != is_told_for_rows =>
        {
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

/// Which of several descriptions is read: a quaternion or a matrix before angles, whose sequence may only be
/// the usual one, and what turns before what does not; the first of those.
fn preferred(read: &[Read<'_>]) -> usize {
    let is_certain = |(found, attitude): &Read<'_>| {
        matches!(attitude.form, Form::Quaternion | Form::Matrix(_)) && !is_identity(found)
    };
    read.iter().position(is_certain).unwrap_or(0)
}
