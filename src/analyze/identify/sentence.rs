//! What is settled of a library, as a sentence for an issue.

use crate::contract::Remaining;
use crate::convention::family::Family;
use crate::convention::matrix::CosineMatrix;
use crate::convention::order::ComponentOrder;
use crate::convention::side::{IncrementSign, Side};
use crate::convention::{Direction, Handedness, Perturbation};

/// One sentence of what is settled, one of what that is called, and one of what is not settled.
pub(crate) fn sentence(name: &str, left: &Remaining) -> String {
    let name = match name.trim() {
        "" => "The library",
        name => name,
    };
    let clauses = [
        only(&left.handedness).map(|handedness| match handedness {
            Handedness::Right => "multiplies Hamilton (i*j = k)".to_owned(),
            Handedness::Left => "multiplies Shuster/JPL (i*j = -k)".to_owned(),
        }),
        only(&left.constructor).map(|order| format!("takes {} in its constructor", letters(order))),
        only(&left.array).map(|order| format!("stores and prints {}", letters(order))),
        only(&left.rotate).map(|form| format!("rotates a column vector by {}", symbol(form))),
        only(&left.matrix).map(|form| matrix(form, only(&left.rotate))),
        only(&left.first_to_act).map(|side| {
            let operand = match side {
                Side::Left => "left operand a",
                Side::Right => "right operand b",
            };
            format!("lets the {operand} of a*b act first")
        }),
        only(&left.direction).map(|direction| {
            let (from, to) = match direction {
                Direction::BodyToWorld => ("body", "world"),
                Direction::WorldToBody => ("world", "body"),
            };
            format!("uses quaternions that take {from} coordinates to {to} coordinates")
        }),
        small_turns(only(&left.perturbation), only(&left.increment_sign)),
    ];
    let mut settled = Vec::new();
    for clause in clauses {
        settled.extend(clause);
    }
    let mut open = Vec::new();
    for (count, what) in [
        (left.handedness.len(), "the product"),
        (left.constructor.len(), "the order of the constructor"),
        (left.array.len(), "the order of the printed numbers"),
        (left.rotate.len(), "how it rotates a vector"),
        (left.matrix.len(), "what its matrix is"),
    ] {
        if count > 1 {
            open.push(what.to_owned());
        }
    }
    let mut sentences = Vec::new();
    if left.handedness.is_empty() {
        return format!("The observations of {name} contradict each other.");
    }
    if !settled.is_empty() {
        sentences.push(format!("{name} {}.", joined(&settled)));
    }
    if let (Some(hand), Some(action)) = (only(&left.handedness), only(&left.rotate)) {
        sentences.push(conclusion(Family::of(hand, action)).to_owned());
    }
    if !open.is_empty() {
        sentences.push(format!("Not settled: {}.", joined(&open)));
    }
    sentences.join(" ")
}

fn only<Value: Copy>(values: &[Value]) -> Option<Value> {
    match values {
        [value] => Some(*value),
        _ => None,
    }
}

const fn letters(order: ComponentOrder) -> &'static str {
    match order {
        ComponentOrder::ScalarFirst => "w x y z",
        ComponentOrder::ScalarLast => "x y z w",
    }
}

const fn symbol(form: CosineMatrix) -> &'static str {
    match form {
        CosineMatrix::Hamilton => "R(q)",
        CosineMatrix::Shuster => "C(q) = R(q)ᵀ",
    }
}

/// Printed as it acts, a matrix is for columns. Printed as the transpose of that, it may be for rows, or
/// the inverse: which, the numbers do not tell.
fn matrix(form: CosineMatrix, rotate: Option<CosineMatrix>) -> String {
    let symbol = match form {
        CosineMatrix::Hamilton => "R(q)",
        CosineMatrix::Shuster => "C(q)",
    };
    let vectors = match rotate {
        None => "",
        Some(rotate) if rotate == form => " (for column vectors)",
        Some(_) => {
            ", the transpose of what rotates (for row vectors, the inverse, or printed by columns)"
        }
    };
    format!("prints {symbol} as the matrix of q{vectors}")
}

/// On which axes a small turn is added, and which turn of the body it is.
fn small_turns(axes: Option<Perturbation>, sign: Option<IncrementSign>) -> Option<String> {
    if axes.is_none() && sign.is_none() {
        return None;
    }
    let axes = match axes {
        Some(Perturbation::Local) => " about the axes of the body",
        Some(Perturbation::Global) => " about the axes of the world",
        None => "",
    };
    let sign = match sign {
        Some(IncrementSign::Physical) => " with the physical sign (phi turns the body by phi)",
        Some(IncrementSign::Formal) => " with the formal sign (phi turns the body by -phi)",
        None => "",
    };
    Some(format!("adds small rotations{axes}{sign}"))
}

/// What product and rotation are together.
const fn conclusion(family: Family) -> &'static str {
    match family {
        Family::Hamilton => "That is Hamilton.",
        Family::Shuster => "That is JPL (Shuster).",
        Family::ReversedProduct => {
            "That is not JPL: the product is Shuster's, but the quaternion rotates by R(q)."
        }
        Family::TransposedMatrix => {
            "That is not all Hamilton: the product is, but the quaternion rotates by C(q)."
        }
    }
}

fn joined(parts: &[String]) -> String {
    match parts {
        [] => String::new(),
        [one] => one.clone(),
        [before @ .., end] => format!("{} and {end}", before.join(", ")),
    }
}
