//! The text of a vector.

use crate::analyze::attitude::unit_assumed;
use crate::contract::{Fact, Note};
use crate::convention::angle::AngleUnit;
use crate::problem::{Field, Problem};
#[cfg(feature = "whole")]
use crate::text::in_known_notation;
use crate::text::mend::{unit, with_suggestion};
use crate::text::parse_vector;
use nalgebra::Vector3;

/// A vector as it was typed.
pub(crate) struct TypedVector {
    pub(crate) vector: Vector3<f64>,
    /// That radians were assumed inside its functions.
    pub(crate) note: Option<Note>,
}

impl TypedVector {
    /// The vector that a text holds, or its first problem with what to write instead.
    pub(crate) fn of_text(text: &str, field: Field) -> Result<Self, Problem> {
        #[cfg(feature = "whole")]
        let known = in_known_notation(text);
        #[cfg(feature = "whole")]
        let text = known.as_deref().unwrap_or(text);
        let vector = parse_vector(text).map_err(|fault| {
            let read = |candidate: &str| parse_vector(candidate).map(drop);
            with_suggestion(fault, text, &read).in_field(field)
        })?;
        let is_read = |text: &str| parse_vector(text).is_ok();
        Ok(Self {
            vector,
            note: unit::inside_functions(text, &is_read).map(|texts| {
                let unit = unit_assumed(AngleUnit::Radians, texts);
                Note::new(field, Fact::AngleUnitAssumed(unit))
            }),
        })
    }
}
