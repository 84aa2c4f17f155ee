//! Which description of an attitude three, four or nine numbers are.

// The ways to read them, and which of them fit.
mod candidate;

// What was printed, as numbers.
mod printed;

// The same attitude on other axes.
mod renamed;

// Four names of components.
mod rewriting;

// Three numbers.
mod three;

use crate::analyze::attitude::{Attitude, Declared};
use crate::analyze::numbers::candidate::{Candidate, Judged, Rounding};
use crate::analyze::numbers::printed::Printed;
use crate::analyze::numbers::renamed::Renamed;
use crate::analyze::numbers::rewriting::of_names;
use crate::analyze::numbers::three::ThreeNumbers;
#[cfg(feature = "whole")]
pub(crate) use crate::analyze::numbers::three::nearest_off_rad;
use crate::contract::request::NumbersRequest;
use crate::contract::{NumbersReport, Reading};
use crate::problem::{Field, Problem};

/// More readings tell no more.
const MOST_READINGS: usize = 12;

/// What numbers beside an attitude are, or the problems of either text.
pub(crate) fn numbers(request: &NumbersRequest) -> Result<NumbersReport, Vec<Problem>> {
    let text = &request.numbers;
    let (convention, matrix) = (request.convention, request.matrix);
    if let Some(rewriting) = of_names(text, convention) {
        let judged = Judged::of(&rewriting.candidates, Rounding::NONE, Rounding::NONE);
        let mut told = report(&rewriting.candidates, judged, &|at| rewriting.reading(at));
        // Nothing of the numbers on which it was tried.
        told.readings.truncate(told.fitting);
        told.margin_deg = None;
        for reading in &mut told.readings {
            reading.text = None;
        }
        return Ok(told);
    }
    let declared = Declared::plain(convention, matrix);
    let printed = Printed::of(text, declared).map_err(|fault| fault.in_field(Field::Numbers));
    let attitude = Attitude::of_text(&request.quaternion, Field::Quaternion, declared);
    let (printed, attitude) = match (printed, attitude) {
        (Ok(printed), Ok(attitude)) => (printed, attitude),
        (printed, attitude) => {
            let mut problems = Vec::new();
            problems.extend(printed.err());
            problems.extend(attitude.err());
            return Err(problems);
        }
    };
    let judged = |candidates: &[Candidate]| {
        Judged::of(
            candidates,
            Rounding::of(text),
            Rounding::of(&request.quaternion),
        )
    };
    let told = match printed {
        Printed::Three(numbers, unit) => {
            let three = ThreeNumbers::of(numbers, unit, &attitude.rotation);
            let judged = judged(&three.candidates);
            report(&three.candidates, judged, &|at| three.reading(at))
        }
        Printed::Four(orders) => {
            let renamed = Renamed::of_quaternion(orders, &attitude.rotation, convention);
            let judged = judged(&renamed.candidates);
            report(&renamed.candidates, judged, &|at| renamed.reading(at))
        }
        Printed::Nine(seen) => {
            let operator = matrix.operator();
            let renamed = Renamed::of_matrix(&seen.turn, seen.scale, &attitude.rotation, operator);
            let judged = judged(&renamed.candidates);
            report(&renamed.candidates, judged, &|at| renamed.reading(at))
        }
    };
    Ok(NumbersReport {
        quaternion: Some(attitude.as_read()),
        ..told
    })
}

/// The first of the candidates as they are told; `reading` says what the one at a place is.
fn report(
    candidates: &[Candidate],
    mut judged: Judged,
    reading: &dyn Fn(usize) -> Reading,
) -> NumbersReport {
    let mut readings = Vec::new();
    while readings.len() < MOST_READINGS
        && let Some(at) = judged.next()
    {
        let off_deg = candidates[at].off_rad.to_degrees();
        readings.push(Reading {
            off_deg,
            ..reading(at)
        });
    }
    NumbersReport {
        quaternion: None,
        readings,
        fitting: judged.fitting,
        decides: judged.fitting == 1,
        margin_deg: judged.margin_rad.map(f64::to_degrees),
    }
}
