//! From one end of a translation to the other.

use crate::attitude::{Attitude, Declared, turn};
use crate::axis_mapping::{AxesChange, AxisMapping};
use crate::convention::{ComponentOrder, ComponentSign, Convention};
use crate::endpoint::{Endpoint, Meaning};
use crate::library::{Library, family, first_to_act, libraries, stores_columns};
use crate::matrix_rows::RowMarks;
use crate::messages::Fault;
use crate::problem::{Field, Problem, Span, is_too_long};
use crate::quaternion::{TaggedQuaternion, UNIT_NORM_TOLERANCE, is_representable};
use crate::report::{
    AxesReport, Change, Components, Fact, MappedAxes, Mistake, MistakeKind, Note, OutOfRange,
    OutOfRangeNumber, PrintedMatrix, ProductOrder, TranslateReport, TranslatedEnd, plain, rows3,
};
use crate::request::TranslateRequest;
use crate::rotation::Rotation;
use crate::template;
use std::cmp::Reverse;

pub(crate) fn translate(request: &TranslateRequest) -> Result<TranslateReport, Vec<Problem>> {
    let ends = (
        meaning(&request.from, Field::From),
        meaning(&request.to, Field::To),
    );
    let world = axes(&request.world_axes, Field::WorldAxes);
    let body = axes(&request.body_axes, Field::BodyAxes);
    let (from, to) = match ends {
        (Ok(from), Ok(to)) => (from, to),
        (from, to) => {
            let found = [from.err(), to.err(), world.err(), body.err()];
            return Err(found.into_iter().flatten().collect());
        }
    };
    let pasted = pasted(&request.quaternion);
    let attitude = attitude(&request.quaternion, &from, pasted);
    let (attitude, world, body) = match (attitude, world, body) {
        (Ok(attitude), Ok(world), Ok(body)) => (attitude, world, body),
        (attitude, world, body) => {
            let found = [attitude.err(), world.err(), body.err()];
            return Err(found.into_iter().flatten().collect());
        }
    };
    let change = AxesChange { world, body };
    let changes_axes = change != AxesChange::NONE;
    let mut notes = notes(&attitude, &from);
    // Where the axes stay, the numbers are those that were typed, not rounded again.
    let (numbers, rotation) = if changes_axes {
        let rotation = change.apply(&attitude.rotation).map_err(|_| {
            let span = Span::of_trimmed(&request.body_axes);
            vec![Fault::one_sided_reflection(span).in_field(Field::BodyAxes)]
        })?;
        let unit = rotation.to_tagged(to.numbers());
        let numbers = with_norm_of(&attitude.tagged, unit).unwrap_or_else(|| {
            notes.push(Note {
                field: Field::Quaternion,
                fact: Fact::OutOfRange(OutOfRange {
                    what: OutOfRangeNumber::Norm,
                }),
            });
            unit
        });
        (numbers, rotation)
    } else {
        (
            attitude.tagged.to_convention(to.numbers()),
            attitude.rotation,
        )
    };

    let mut mistakes = mistakes(&from, &to, &numbers, &rotation);
    if changes_axes {
        mistakes.push(Mistake {
            kind: MistakeKind::AxesKept,
            angle_deg: angle_deg(&rotation, &attitude.rotation),
        });
    }
    let typed = attitude.tagged.to_convention(from.numbers());
    Ok(TranslateReport {
        quaternion: attitude.as_read(),
        change: change_between(&from, &to),
        mistakes,
        product: if world == body {
            product_order(&from, &to)
        } else {
            ProductOrder::Neither
        },
        axes: changes_axes.then(|| AxesReport {
            world: mapped(world),
            body: mapped(body),
        }),
        turn: turn(&attitude.rotation),
        proposed: pasted
            .filter(|pasted| from.library.is_none_or(|library| library.id != pasted.id))
            .map(|pasted| pasted.id.clone()),
        notes,
        from: end(&from, &typed, &attitude.rotation),
        to: end(&to, &numbers, &rotation),
    })
}

/// The attitude that a text holds at the first end. Plain numbers stand in the order of the array; the
/// arguments of a call stand in that of the constructor, which may be another one.
fn attitude(
    text: &str,
    from: &Meaning,
    pasted: Option<&'static Library>,
) -> Result<Attitude, Problem> {
    let declared = |order| Declared {
        convention: Convention {
            order,
            ..from.numbers()
        },
        matrix: from.matrix_convention(),
    };
    let in_order = |order| Attitude::of_text(text, Field::Quaternion, declared(order));
    let read = in_order(from.order);
    let is_certain = read
        .as_ref()
        .is_ok_and(|attitude| !attitude.is_of_unknown_constructor());
    if is_certain || is_too_long(text) {
        return read;
    }
    // The library's own line, whatever its form, as the other end of a translation shows it.
    let known = [pasted, from.library].into_iter().flatten();
    let mut lines = known.filter_map(|library| library.code.construct.as_deref());
    if let Some(named) = lines.find_map(|line| template::read(line, text)) {
        return Attitude::of_text(&named, Field::Quaternion, declared(from.order));
    }
    let library = pasted.or(from.library);
    let constructor = library.and_then(|library| library.constructor_order);
    match (read, constructor) {
        (Ok(_), Some(order)) => in_order(order),
        (read, _) => read,
    }
}

/// What is known of the text; also that lists of lists, which libraries of some languages print by
/// columns, were read by rows.
fn notes(attitude: &Attitude, from: &Meaning) -> Vec<Note> {
    let field = Field::Quaternion;
    let mut notes = attitude.notes(field);
    let language = from.library.map(|library| library.language);
    if attitude.row_marks == Some(RowMarks::Brackets) && language.is_some_and(stores_columns) {
        let fact = attitude.rows_fact();
        notes.extend(fact.map(|fact| Note { field, fact }));
    }
    notes
}

/// A quaternion of norm 1 made as long as what was typed, which a rotation does not remember; `None`
/// where a double that small has lost digits of the attitude, or all of them, or cannot hold the norm.
///
/// Of norm 1 it stays where it was typed so but for rounding.
fn with_norm_of(typed: &TaggedQuaternion, unit: TaggedQuaternion) -> Option<TaggedQuaternion> {
    let norm = typed.norm();
    if (norm - 1.0).abs() <= UNIT_NORM_TOLERANCE {
        return Some(unit);
    }
    let components = unit.components * norm;
    is_representable(&components).then_some(TaggedQuaternion { components, ..unit })
}

fn meaning(endpoint: &Endpoint, field: Field) -> Result<Meaning, Problem> {
    Meaning::of(endpoint).ok_or_else(|| {
        let id = match endpoint {
            Endpoint::Library(endpoint) => endpoint.id.as_str(),
            Endpoint::Convention(_) => "",
        };
        Fault::unknown_library(Span::of_trimmed(id), id).in_field(field)
    })
}

fn axes(text: &str, field: Field) -> Result<AxisMapping, Problem> {
    if is_too_long(text) {
        let message = "so long a text names no axes".to_owned();
        return Err(Fault::unknown_axes(Span::of_trimmed(text), message).in_field(field));
    }
    text.parse::<AxisMapping>().map_err(|unknown| {
        Fault::unknown_axes(Span::of_trimmed(text), unknown.message).in_field(field)
    })
}

fn end(meaning: &Meaning, numbers: &TaggedQuaternion, rotation: &Rotation) -> TranslatedEnd {
    let components = Components::of(&numbers.components, meaning.order);
    let library = meaning.library;
    let code = library.map(|library| &library.code);
    TranslatedEnd {
        library: library.map(|library| library.id.clone()),
        convention: meaning.declared.unwrap_or(meaning.numbers()),
        array: numbers.to_array().map(plain),
        order: meaning.order,
        constructor_order: library.map_or(Some(meaning.order), |library| library.constructor_order),
        sign: meaning.numbers().component_sign(),
        handedness: meaning.handedness,
        action: meaning.action,
        direction: meaning.direction,
        family: meaning
            .handedness
            .map(|handedness| family(handedness, meaning.action)),
        first_to_act: meaning
            .handedness
            .map(|handedness| first_to_act(handedness, meaning.action)),
        matrix: meaning.matrix.map(|printed| PrintedMatrix {
            rows: rows3(&rotation.matrix(meaning.direction_of(printed.form))),
            form: printed.form,
            vectors: printed.vectors,
        }),
        construct: code
            .and_then(|code| code.construct.as_deref())
            .map(|line| template::write(line, &components)),
        usual: code.and_then(|code| code.rotate.clone().or_else(|| code.matrix.clone())),
        assumed: meaning.assumed.clone(),
        components,
    }
}

fn change_between(from: &Meaning, to: &Meaning) -> Change {
    let reordered = from.order != to.order;
    let conjugated = from.numbers().component_sign() != to.numbers().component_sign();
    match (reordered, conjugated) {
        (false, false) => Change::Copied,
        (true, false) => Change::Reordered,
        (false, true) => Change::Conjugated,
        (true, true) => Change::ReorderedAndConjugated,
    }
}

/// What comes of the numbers when a step is left out, or a conjugation done that is not needed.
fn mistakes(
    from: &Meaning,
    to: &Meaning,
    right: &TaggedQuaternion,
    rotation: &Rotation,
) -> Vec<Mistake> {
    let not_reordered = |numbers: &TaggedQuaternion| {
        let mut array = numbers.to_array();
        match from.order {
            ComponentOrder::ScalarFirst => array.rotate_right(1),
            ComponentOrder::ScalarLast => array.rotate_left(1),
        }
        TaggedQuaternion::from_array(array, numbers.convention)
    };
    let passed_on = match to.library.and_then(|library| library.constructor_order) {
        Some(order) if order != to.order && to.order == from.order => {
            let array = right.to_array();
            let wrong = TaggedQuaternion::from_array(
                array,
                Convention {
                    order,
                    ..right.convention
                },
            );
            Some((MistakeKind::ConstructorOrder, wrong))
        }
        _ => None,
    };
    // Its own inverse: the mistake that undoes a needed conjugation is the one that adds another.
    let conjugated = right.conjugate();
    let made = match change_between(from, to) {
        Change::Copied => vec![(MistakeKind::ConjugatedNeedlessly, conjugated)],
        Change::Reordered => vec![
            (MistakeKind::NotReordered, not_reordered(right)),
            (MistakeKind::ConjugatedNeedlessly, conjugated),
        ],
        Change::Conjugated => vec![(MistakeKind::NotConjugated, conjugated)],
        Change::ReorderedAndConjugated => vec![
            (MistakeKind::Copied, not_reordered(&conjugated)),
            (MistakeKind::NotConjugated, conjugated),
            (MistakeKind::NotReordered, not_reordered(right)),
        ],
    };
    made.into_iter()
        .chain(passed_on)
        .filter_map(|(kind, wrong)| {
            let wrong = Rotation::from_tagged(&wrong).ok()?;
            Some(Mistake {
                kind,
                angle_deg: angle_deg(rotation, &wrong),
            })
        })
        .collect()
}

fn angle_deg(right: &Rotation, wrong: &Rotation) -> f64 {
    plain(right.angle_to_rad(wrong).to_degrees())
}

/// A conjugation turns a product round, and so does the other hand; both together do not.
fn product_order(from: &Meaning, to: &Meaning) -> ProductOrder {
    let (Some(one), Some(other)) = (from.handedness, to.handedness) else {
        return ProductOrder::NotEstablished;
    };
    let sign = |meaning: &Meaning| meaning.numbers().component_sign() == ComponentSign::Canonical;
    if (one == other) == (sign(from) == sign(to)) {
        ProductOrder::Same
    } else {
        ProductOrder::Reversed
    }
}

fn mapped(mapping: AxisMapping) -> MappedAxes {
    MappedAxes {
        mapping,
        text: mapping.to_string(),
        rows: rows3(&mapping.matrix()),
        determinant: mapping.determinant(),
        hand: mapping.hand(),
    }
}

/// The library whose call stands in the text first: by the longest of the fragments that do.
fn pasted(text: &str) -> Option<&'static Library> {
    if is_too_long(text) {
        return None;
    }
    let compact = |text: &str| text.split_whitespace().collect::<String>();
    let text = compact(text);
    libraries()
        .iter()
        .flat_map(|library| library.pasted.iter().map(move |part| (library, part)))
        .filter_map(|(library, part)| {
            let part = compact(part);
            Some((text.find(&part)?, Reverse(part.len()), library))
        })
        .min_by_key(|(at, length, _)| (*at, *length))
        .map(|(_, _, library)| library)
}
