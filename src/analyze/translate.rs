//! From one end of a translation to the other.

use crate::analyze::attitude::{Attitude, Declared, DeclaredLibrary};
use crate::analyze::code_line::{self, Line};
use crate::analyze::describe::turn;
use crate::analyze::plain_numbers::{plain4, rows3};
use crate::analyze::record_numbers;
use crate::analyze::translate_mistakes::{angle_deg, change_between, mistakes, product_order};
use crate::contract::request::TranslateRequest;
use crate::contract::{
    AxesReport, Components, Fact, LibraryDescription, MappedAxes, Mistake, MistakeKind, Note,
    OutOfRange, OutOfRangeNumber, PrintedMatrix, ProductOrder, TranslateReport, TranslatedEnd,
};
use crate::convention::Convention;
use crate::convention::order::ComponentOrder;
use crate::convention::order::OrderSource;
use crate::frames::axis_mapping::{AxesChange, AxisMapping};
use crate::library::endpoint::{Endpoint, Meaning};
use crate::library::{Essentials, VectorLayout, essentials, stores_columns};
use crate::problem::fault::Fault;
use crate::problem::suggestion::{Suggestion, suggestions};
use crate::problem::{Field, MAX_TEXT_BYTES, Problem, ProblemCode, Span, is_too_long};
use crate::rotation::Rotation;
use crate::rotation::quaternion::{TaggedQuaternion, UNIT_NORM_TOLERANCE, is_representable};
use crate::text::{ParsedRotation, RowMarks, parse_rotation};
use nalgebra::Quaternion;

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
            let mut problems = Vec::new();
            problems.extend(from.err());
            problems.extend(to.err());
            problems.extend(world.err());
            problems.extend(body.err());
            return Err(problems);
        }
    };
    let text = &*request.quaternion;
    let pasted = pasted(text);
    let attitude = attitude(text, &from, pasted);
    let (attitude, world, body) = match (attitude, world, body) {
        (Ok(attitude), Ok(world), Ok(body)) => (attitude, world, body),
        (attitude, world, body) => {
            let mut problems = Vec::new();
            problems.extend(attitude.err());
            problems.extend(world.err());
            problems.extend(body.err());
            return Err(problems);
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
            let what = OutOfRangeNumber::Norm;
            let fact = Fact::OutOfRange(OutOfRange { what });
            notes.push(Note::new(Field::Quaternion, fact));
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
            .map(|pasted| pasted.id.to_owned()),
        notes,
        from: end(&from, &typed, &attitude.rotation),
        to: end(&to, &numbers, &rotation),
    })
}

/// The attitude that a text holds at the first end. The numbers of a record without a quaternion are its
/// own. Plain numbers stand in the order in which they are
/// printed; the arguments of a call stand in that of the constructor, which may be another one.
fn attitude(
    text: &str,
    from: &Meaning,
    pasted: Option<&'static Essentials>,
) -> Result<Attitude, Problem> {
    let declared = |order| Declared {
        convention: Convention {
            order,
            ..from.numbers()
        },
        matrix: from.matrix_convention(),
        library: from.library.map(|library| DeclaredLibrary {
            id: library.id,
            vectors: from
                .matrix
                .map_or(VectorLayout::Column, |printed| printed.vectors),
        }),
    };
    if let Some(words) = record_numbers::in_words(text, from) {
        let read = Attitude::of_text(&words, Field::Quaternion, declared(from.order));
        return read.map_err(|problem| record_numbers::about_all(problem, text));
    }
    let in_order = |order| Attitude::of_text(text, Field::Quaternion, declared(order));
    let plain = Attitude::plain(text, declared(from.order));
    let is_settled = match &plain {
        Ok(attitude) => !attitude.is_of_unknown_constructor(),
        Err(fault) => fault.code == ProblemCode::TextTooLong,
    };
    if is_settled {
        return in_order(from.order);
    }
    // The library's own line, whatever its form, as the other end of a translation shows it.
    let known = [pasted, from.library].into_iter().flatten();
    let mut lines = known.filter_map(|library| library.construct);
    if let Some(line) = lines.find_map(|line| code_line::read(line, text)) {
        let read = Attitude::of_text(&line.named, Field::Quaternion, declared(from.order));
        return read.map_err(|problem| as_typed(problem, &line, text));
    }
    let library = pasted.or(from.library);
    let constructor = library.and_then(|library| library.constructor_order);
    match (plain, constructor) {
        (Ok(_), Some(order)) => in_order(order),
        _ => in_order(from.order),
    }
}

/// A problem of the numbers of a line, at their places in it.
fn as_typed(problem: Problem, line: &Line, text: &str) -> Problem {
    let in_line = |suggestion: Suggestion| {
        let text = line.with_numbers(text, &suggestion.text)?;
        Some(Suggestion { text, ..suggestion })
    };
    let suggestion = problem
        .suggestion
        .and_then(|suggestion| in_line(*suggestion));
    let choices = suggestions(|| {
        let mut choices = Vec::new();
        for choice in problem.choices {
            choices.extend(in_line(choice));
        }
        choices
    });
    Problem {
        span: line.place(problem.span).unwrap_or(Span::of_trimmed(text)),
        suggestion: suggestion.map(Box::new),
        choices,
        ..problem
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
        notes.extend(fact.map(|fact| Note::new(field, fact)));
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
        let fault = Fault::text_too_long(Span::of_trimmed(text), text.len(), MAX_TEXT_BYTES);
        return Err(fault.in_field(field));
    }
    text.parse::<AxisMapping>().map_err(|unknown| {
        Fault::unknown_axes(Span::of_trimmed(text), unknown.message).in_field(field)
    })
}

/// What a library does by itself, whatever the attitude; `None` for an id that no library has.
///
/// ```
/// use quatlas::{Family, Side, describe_library};
/// // Its product is JPL's and it rotates by R(q), so of a * b the left operand acts first.
/// let described = describe_library("directxmath").expect("a library of the table");
/// assert_eq!(described.family, Some(Family::ReversedProduct));
/// assert_eq!(described.first_to_act, Some(Side::Left));
/// ```
#[must_use]
pub fn describe_library(id: &str) -> Option<LibraryDescription> {
    let meaning = Meaning::of(&Endpoint::library(id))?;
    Some(LibraryDescription {
        convention: meaning.numbers(),
        order: meaning.order,
        action: meaning.action,
        direction: meaning.direction,
        family: meaning.family(),
        first_to_act: meaning.first_to_act(),
        assumed: meaning.assumed,
    })
}

fn end(meaning: &Meaning, numbers: &TaggedQuaternion, rotation: &Rotation) -> TranslatedEnd {
    let components = Components::of(&numbers.components, meaning.order);
    let library = meaning.library;
    TranslatedEnd {
        library: library.map(|library| library.id.to_owned()),
        convention: meaning.declared.unwrap_or(meaning.numbers()),
        array: plain4(numbers.to_array()),
        order: meaning.order,
        constructor_order: library.map_or(Some(meaning.order), |library| library.constructor_order),
        sign: meaning.numbers().component_sign(),
        handedness: meaning.handedness,
        action: meaning.action,
        direction: meaning.direction,
        family: meaning.family(),
        first_to_act: meaning.first_to_act(),
        numbers: record_numbers::written(rotation, meaning),
        matrix: meaning.matrix.map(|printed| PrintedMatrix {
            rows: rows3(&rotation.matrix(meaning.direction_of(printed.form))),
            form: printed.form,
            vectors: printed.vectors,
        }),
        construct: library
            .and_then(|library| library.construct)
            .map(|line| construct(line, &components, meaning)),
        usual: library.and_then(|library| library.usual).map(str::to_owned),
        assumed: meaning.assumed.clone(),
        components,
    }
}

/// The line of code with these numbers. Where the line is nothing but an array, its numbers stand in the
/// order in which those of this end do, so that the line is read here as what it was written for.
fn construct(template: &str, components: &Components, meaning: &Meaning) -> String {
    let line = code_line::write(template, components);
    let numbers = Quaternion::new(1.0, 2.0, 3.0, 4.0);
    let sample = Components::of(&numbers, ComponentOrder::ScalarFirst);
    let sample = code_line::write(template, &sample);
    let read = parse_rotation(&sample, meaning.order);
    match read {
        Ok(ParsedRotation::Quaternion(read))
            if read.unknown_constructor.is_none() && read.order_source == OrderSource::Declared =>
        {
            code_line::write_in_order(template, components, meaning.order)
        }
        _ => line,
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

/// The library whose call stands in the text first; no fragment begins that of another library. A text
/// that is too long is nobody's line.
fn pasted(text: &str) -> Option<&'static Essentials> {
    if is_too_long(text) {
        return None;
    }
    let compact = |text: &str| {
        let mut compact = String::new();
        for word in text.split_whitespace() {
            compact.push_str(word);
        }
        compact
    };
    let text = compact(text);
    let mut first: Option<(usize, &Essentials)> = None;
    for library in essentials() {
        for part in library.pasted {
            if let Some(at) = text.find(&compact(part))
                && first.is_none_or(|(least, _)| at < least)
            {
                first = Some((at, library));
            }
        }
    }
    first.map(|(_, library)| library)
}
