//! The whole road: a request in, an outcome out.
//!
//! Text is parsed, tagged with its convention, turned into the canonical
//! rotation, and written back in every convention. Any step may stop with
//! problems; nothing is thrown and nothing is printed.

use crate::attitude::{Attitude, Declared};
use crate::bare_arguments;
use crate::compose::compose as compose_attitudes;
use crate::convention::Convention;
use crate::describe::{euler, rules, turn};
use crate::identify::identify;
use crate::parse::parse_vector;
use crate::problem::{Field, Problem};
use crate::report::{
    Components, ComposeReport, Fact, Note, OutOfRange, OutOfRangeNumber, Outcome, Problems,
    ReadReport, coordinates,
};
use crate::request::{ComposeRequest, ReadRequest, Request};
use crate::suggestion::with_suggestion;
use crate::translate::translate;
use nalgebra::Vector3;

/// The answer to a request: a report with notes, or the problems of its texts.
///
/// Nothing that is typed makes it panic, and no number of the answer is NaN, infinite or −0.
///
/// ```
/// use quatlas::{analyze, Convention, Outcome, ReadRequest, Request};
///
/// // Four numbers of a JPL filter: x y z w, world to body; a quarter turn about z.
/// let request = ReadRequest::new("0 0 1/√2 1/√2", "1 0 0", Convention::JPL);
/// let outcome = analyze(&Request::Read(request));
/// let Outcome::Read(report) = outcome else { panic!("{outcome:?}") };
///
/// // The world's x axis, seen from the body, is −y; the body's, seen from the world, is y.
/// assert_eq!(report.jpl.image, Some([0.0, -1.0, 0.0]));
/// assert_eq!(report.hamilton.image, Some([0.0, 1.0, 0.0]));
/// ```
#[must_use]
pub fn analyze(request: &Request) -> Outcome {
    let answered = match request {
        Request::Read(request) => read(request).map(|report| Outcome::Read(Box::new(report))),
        Request::Compose(request) => {
            compose(request).map(|report| Outcome::Compose(Box::new(report)))
        }
        Request::Translate(request) => {
            translate(request).map(|report| Outcome::Translate(Box::new(report)))
        }
        Request::Identify(request) => Ok(Outcome::Identify(Box::new(identify(request)))),
    };
    answered.unwrap_or_else(|problems| Outcome::Problems(Problems { problems }))
}

pub(crate) fn read(request: &ReadRequest) -> Result<ReadReport, Vec<Problem>> {
    let declared = Declared {
        convention: request.convention,
        matrix: request.matrix,
    };
    let attitude = Attitude::of_text(&request.quaternion, Field::Quaternion, declared);
    let vector = vector_of_text(&request.vector);
    let (attitude, vector) = match (attitude, vector) {
        (Ok(attitude), Ok(vector)) => (attitude, vector),
        (attitude, vector) => return Err(problems([attitude.err(), vector.err()])),
    };

    let mut notes = attitude.notes(Field::Quaternion);
    notes.extend(note_of_vector(&request.vector));
    // Small turns are on the declared axes in both columns.
    let perturbed = |preset: Convention| Convention {
        perturbation: request.convention.perturbation,
        ..preset
    };
    let hamilton = attitude.column(perturbed(Convention::HAMILTON), vector);
    let jpl = attitude.column(perturbed(Convention::JPL), vector);
    let mut left_out = |field, what, present: bool| {
        if !present {
            let fact = Fact::OutOfRange(OutOfRange { what });
            notes.push(Note { field, fact });
        }
    };
    left_out(
        Field::Quaternion,
        OutOfRangeNumber::Inverse,
        hamilton.inverse.is_some(),
    );
    left_out(
        Field::Vector,
        OutOfRangeNumber::Image,
        hamilton.image.is_some() && jpl.image.is_some(),
    );
    let same_matrix = Convention {
        direction: Convention::HAMILTON.direction,
        ..Convention::JPL
    };
    Ok(ReadReport {
        quaternion: attitude.as_read(),
        vector: coordinates(&vector),
        hamilton,
        jpl,
        declared: attitude.column(attitude.tagged.convention, vector),
        rules: rules(attitude.tagged.convention),
        paired: attitude.paired(request.matrix),
        euler: euler(&attitude.rotation, request.euler),
        jpl_with_same_matrix: Components::of(
            &attitude.tagged.to_convention(same_matrix).components,
            same_matrix.order,
        ),
        turn: turn(&attitude.rotation),
        notes,
    })
}

pub(crate) fn compose(request: &ComposeRequest) -> Result<ComposeReport, Vec<Problem>> {
    let declared = Declared {
        convention: request.convention,
        matrix: request.matrix,
    };
    let p = Attitude::of_text(&request.p, Field::P, declared);
    let q = Attitude::of_text(&request.q, Field::Q, declared);
    let vector = vector_of_text(&request.vector);
    let (p, q, vector) = match (p, q, vector) {
        (Ok(p), Ok(q), Ok(vector)) => (p, q, vector),
        (p, q, vector) => return Err(problems([p.err(), q.err(), vector.err()])),
    };
    let composition = compose_attitudes(&p, &q, vector);

    let mut notes = p.notes(Field::P);
    notes.extend(q.notes(Field::Q));
    notes.extend(note_of_vector(&request.vector));
    notes.extend(composition.out_of_range.map(|out_of_range| Note {
        field: Field::P,
        fact: Fact::OutOfRange(out_of_range),
    }));
    if composition
        .products
        .iter()
        .any(|product| product.images.is_none())
    {
        notes.push(Note {
            field: Field::Vector,
            fact: Fact::OutOfRange(OutOfRange {
                what: OutOfRangeNumber::Image,
            }),
        });
    }
    Ok(ComposeReport {
        p: p.as_read(),
        q: q.as_read(),
        p_turn: turn(&p.rotation),
        q_turn: turn(&q.rotation),
        vector: coordinates(&vector),
        declared: composition.declared,
        products: composition.products,
        order_matters: composition.order_matters,
        notes,
    })
}

fn vector_of_text(text: &str) -> Result<Vector3<f64>, Problem> {
    let read = |text: &str| parse_vector(text, Field::Vector);
    read(text)
        .map_err(|problem| with_suggestion(problem, text, &|candidate| read(candidate).map(drop)))
}

/// That radians were assumed inside the functions of a vector that is read.
fn note_of_vector(text: &str) -> Option<Note> {
    let field = Field::Vector;
    let is_read = |text: &str| parse_vector(text, field).is_ok();
    bare_arguments::unit_assumed(text, &is_read).map(|unit| Note {
        field,
        fact: Fact::AngleUnitAssumed(unit),
    })
}

fn problems<const COUNT: usize>(found: [Option<Problem>; COUNT]) -> Vec<Problem> {
    found.into_iter().flatten().collect()
}
