//! The texts of rates, small turns and times, in the units of reports.

use crate::analyze::attitude::unit_assumed;
use crate::contract::{Fact, Note};
use crate::convention::angle::AngleUnit;
use crate::problem::fault::Fault;
use crate::problem::{Field, Problem, Span};
use crate::text::mend::unit::UnitTexts;
use crate::text::units::{OF_RATES, OF_TIMES, OF_TURNS, without_unit};
use crate::text::{parse_number, parse_vector};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// No body turns faster, and all that is computed of it fits into a double.
const MOST: f64 = 1e9;

/// Of less, two moments would have one time.
const SHORTEST_S: f64 = 1e-100;

/// What is read of the texts of one request.
#[derive(Default)]
pub(crate) struct Reader {
    pub(crate) problems: Vec<Problem>,
    pub(super) notes: Vec<Note>,
}

impl Reader {
    /// Three numbers in rad/s, or of an increment in rad; none where the text is empty or has a problem.
    ///
    /// Without a unit they are in radians, as those of a rotation vector; beyond a full turn that is asked.
    pub(super) fn vector(&mut self, text: &str, field: Field) -> Option<Vector3<f64>> {
        if text.trim().is_empty() {
            return None;
        }
        let (units, per) = match field {
            Field::Increment => (OF_TURNS, ""),
            _ => (OF_RATES, "/s"),
        };
        let (numbers, unit) = without_unit(text, units);
        let read = parse_vector(numbers).map_err(|fault| told(fault, vector_hint(field), field));
        let vector = self.unless_problem(read)? * unit.unwrap_or(1.0);
        if vector.amax() > MOST {
            self.refuse(Fault::too_fast(Span::of_trimmed(text)), field);
        }
        if unit.is_none() && vector.amax() > TAU {
            let texts = UnitTexts {
                in_degrees: Some(format!("{numbers} deg{per}")),
                in_radians: Some(format!("{numbers} rad{per}")),
            };
            let fact = Fact::AngleUnitAssumed(unit_assumed(AngleUnit::Radians, texts));
            self.notes.push(Note::new(field, fact));
        }
        Some(vector)
    }

    /// What a text holds; none where it is empty or has a problem.
    pub(super) fn if_any<Read>(
        &mut self,
        text: &str,
        field: Field,
        read: fn(&str) -> Result<Read, Fault>,
    ) -> Option<Read> {
        if text.trim().is_empty() {
            return None;
        }
        self.unless_problem(read(text).map_err(|fault| fault.in_field(field)))
    }

    /// A time above zero, in seconds.
    pub(crate) fn duration(&mut self, text: &str) -> Option<f64> {
        if text.trim().is_empty() {
            return None;
        }
        let (number, unit) = without_unit(text, OF_TIMES);
        let hint = (
            "a time, with one unit behind it",
            "10 s, 500 ms, 5 us or 2 min",
        );
        let read = parse_number(number).map_err(|fault| told(fault, hint, Field::Duration));
        let seconds = self.unless_problem(read)? * unit.unwrap_or(1.0);
        let span = Span::of_trimmed(text);
        if seconds < SHORTEST_S {
            self.refuse(Fault::not_a_duration(span), Field::Duration);
        } else if seconds.is_infinite() {
            // By its unit alone.
            self.refuse(Fault::infinite(span), Field::Duration);
        }
        Some(seconds)
    }

    pub(super) fn refuse(&mut self, fault: Fault, field: Field) {
        self.problems.push(fault.in_field(field));
    }

    /// What was read, unless there was a problem.
    pub(crate) fn unless_problem<Read>(&mut self, read: Result<Read, Problem>) -> Option<Read> {
        read.map_err(|problem| self.problems.push(problem)).ok()
    }
}

const fn vector_hint(field: Field) -> (&'static str, &'static str) {
    match field {
        Field::Increment => (
            "three numbers, and one unit behind them",
            "0.02 -0.03 0.05 rad, or 1 0 0 deg",
        ),
        _ => (
            "three numbers, and one unit of a rate behind them",
            "0.1 -0.2 0.3 rad/s, or 0 0 90 deg/s",
        ),
    }
}

/// A fault with what is expected of such a text, and an example of it.
fn told(fault: Fault, (expected, hint): (&str, &str), field: Field) -> Problem {
    Fault {
        expected: expected.to_owned(),
        hint: hint.to_owned(),
        ..fault
    }
    .in_field(field)
}
