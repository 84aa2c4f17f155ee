//! The numbers that both sides see.

use crate::convention::Convention;
use crate::rotation::{Rotation, precise};
use crate::wasm::CallOutcome;
use nalgebra::Quaternion;
use std::array::from_fn;
use std::cell::Cell;
use wasm_bindgen::prelude::*;

/// The most that a call takes or leaves is 16: a matrix of products.
const COUNT: usize = 16;

thread_local! {
    static REGISTERS: [Cell<f64>; COUNT] = const { [const { Cell::new(0.0) }; COUNT] };
}

/// The address of the registers in the memory: 16 doubles.
#[wasm_bindgen]
pub fn registers() -> usize {
    REGISTERS.with(|registers| registers.as_ptr().addr())
}

/// The numbers from a place on.
pub(crate) fn numbers<const HOW_MANY: usize>(from: usize) -> [f64; HOW_MANY] {
    REGISTERS.with(|registers| from_fn(|place| registers[from + place].get()))
}

/// The attitude that four numbers from a place on are, as [`leave_rotation`] left them behind the unit quaternion.
pub(crate) fn rotation(from: usize) -> Rotation {
    let [w, x, y, z] = numbers(from);
    Rotation::of_canonical(Quaternion::new(w, x, y, z))
}

/// Leaves an answer.
pub(crate) fn leave(answer: &[f64]) -> CallOutcome {
    leave_from(0, answer)
}

/// Leaves a part of an answer from a place on.
#[inline(never)]
pub(crate) fn leave_from(place: usize, part: &[f64]) -> CallOutcome {
    REGISTERS.with(|registers| {
        for (register, &number) in registers.iter().skip(place).zip(part) {
            register.set(number);
        }
    });
    if part.iter().all(|number| number.is_finite()) {
        CallOutcome::Done
    } else {
        CallOutcome::TooLarge
    }
}

/// Leaves an attitude: the unit quaternion `[w, x, y, z]` of Hamilton, body to world, and behind it the
/// canonical one, whose norm is not 1 and which is what is computed with.
#[inline(never)]
pub(crate) fn leave_rotation(rotation: &Rotation) -> CallOutcome {
    let unit = rotation.to_tagged(Convention::HAMILTON).to_array();
    let canonical = rotation.canonical();
    leave(&[
        unit[0],
        unit[1],
        unit[2],
        unit[3],
        canonical.w,
        canonical.i,
        canonical.j,
        canonical.k,
    ])
}

/// Leaves an attitude that was rounded when its norm was 2^399, as products are: so it is divided exactly.
pub(crate) fn leave_product(rotation: &Rotation) -> CallOutcome {
    let canonical = rotation.canonical();
    let unit = precise::scale(canonical, -399);
    leave(&[
        unit.w,
        unit.i,
        unit.j,
        unit.k,
        canonical.w,
        canonical.i,
        canonical.j,
        canonical.k,
    ])
}

/// Leaves an attitude, or tells that there is none.
#[inline(never)]
pub(crate) fn leave_found<Reason>(found: Result<Rotation, Reason>) -> CallOutcome {
    match found {
        Ok(rotation) => leave_rotation(&rotation),
        Err(_) => CallOutcome::NoRotation,
    }
}

/// Leaves a matrix, row by row, of as many rows as columns.
#[inline(never)]
pub(crate) fn leave_rows<const SIDE: usize>(
    matrix: &nalgebra::SMatrix<f64, SIDE, SIDE>,
) -> CallOutcome {
    leave(matrix.transpose().as_slice())
}
