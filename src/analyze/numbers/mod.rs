//! Which description of an attitude three, four or nine numbers are.

// The ways to read them, judged.
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
use crate::analyze::numbers::candidate::{Rounding, judged};
use crate::analyze::numbers::printed::Printed;
use crate::analyze::numbers::renamed::{of_matrix, of_quaternion};
use crate::analyze::numbers::rewriting::of_names;
use crate::analyze::numbers::three::of_three_numbers;
use crate::contract::NumbersReport;
use crate::contract::request::NumbersRequest;
use crate::problem::{Field, Problem};

/// What numbers beside an attitude are, or the problems of either text.
pub(crate) fn numbers(request: &NumbersRequest) -> Result<NumbersReport, Vec<Problem>> {
    let text = &request.numbers;
    let (convention, matrix) = (request.convention, request.matrix);
    if let Some(candidates) = of_names(text, convention) {
        return Ok(judged(candidates, Rounding::NONE, Rounding::NONE));
    }
    let declared = Declared { convention, matrix };
    let typed = Printed::of(text, declared).map_err(|fault| fault.in_field(Field::Numbers));
    let attitude = Attitude::of_text(&request.quaternion, Field::Quaternion, declared);
    let (typed, attitude) = match (typed, attitude) {
        (Ok(typed), Ok(attitude)) => (typed, attitude),
        (typed, attitude) => {
            let problems = [typed.err(), attitude.err()];
            return Err(problems.into_iter().flatten().collect());
        }
    };
    let candidates = match &typed {
        Printed::Three(numbers, unit) => of_three_numbers(*numbers, *unit, &attitude.rotation),
        Printed::Four(seen) => of_quaternion(seen, &attitude.rotation, convention),
        Printed::Nine(seen) => of_matrix(seen, &attitude.rotation, matrix.operator()),
    };
    let rounding = [text, &request.quaternion].map(|text| Rounding::of(text));
    let [of_numbers, of_attitude] = rounding;
    Ok(NumbersReport {
        quaternion: Some(attitude.as_read()),
        ..judged(candidates, of_numbers, of_attitude)
    })
}
