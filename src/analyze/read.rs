//! What one attitude means in both conventions.

use crate::analyze::attitude::{Attitude, Declared};
use crate::analyze::describe::{euler, rules, turn};
use crate::analyze::plain_numbers::coordinates;
use crate::analyze::vector::TypedVector;
use crate::contract::request::ReadRequest;
use crate::contract::{Components, Fact, Note, OutOfRange, OutOfRangeNumber, ReadReport};
use crate::convention::Convention;
use crate::problem::{Field, Problem};

pub(crate) fn read(request: &ReadRequest) -> Result<ReadReport, Vec<Problem>> {
    let declared = Declared::plain(request.convention, request.matrix);
    let attitude = Attitude::of_text(&request.quaternion, Field::Quaternion, declared);
    let vector = TypedVector::of_text(&request.vector, Field::Vector);
    let (attitude, vector) = match (attitude, vector) {
        (Ok(attitude), Ok(vector)) => (attitude, vector),
        (attitude, vector) => {
            let mut problems = Vec::new();
            problems.extend(attitude.err());
            problems.extend(vector.err());
            return Err(problems);
        }
    };

    let TypedVector { vector, note } = vector;
    let mut notes = attitude.notes(Field::Quaternion);
    notes.extend(note);
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
            notes.push(Note::new(field, fact));
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
