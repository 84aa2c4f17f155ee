//! The text of a vector.

use crate::analyze::attitude::unit_assumed;
use crate::contract::{Fact, Note};
use crate::convention::angle::AngleUnit;
use crate::problem::{Field, Problem, Wanted};
use crate::text::mend::{unit, with_suggestion};
use crate::text::parse_vector;
use nalgebra::Vector3;

pub(crate) fn vector_of_text(text: &str) -> Result<Vector3<f64>, Problem> {
    parse_vector(text).map_err(|fault| {
        let read = |candidate: &str| parse_vector(candidate).map(drop);
        with_suggestion(fault, text, Wanted::Vector, &read).in_field(Field::Vector)
    })
}

/// That radians were assumed inside the functions of a vector that is read.
pub(crate) fn note_of_vector(text: &str) -> Option<Note> {
    let field = Field::Vector;
    let is_read = |text: &str| parse_vector(text).is_ok();
    unit::inside_functions(text, &is_read).map(|texts| Note {
        field,
        fact: Fact::AngleUnitAssumed(unit_assumed(AngleUnit::Radians, texts)),
    })
}
