//! FX-07: the convention of a library of matrices.

use super::{attitude, sign_of};
use crate::reference::{CLOSE, elementary, tau, unit};
use quatlas::nalgebra::Vector3;
use quatlas::{
    Direction, Function, IncrementSign, MatrixConvention, Perturbation, Rotation, TaggedMatrix,
    direction_of_yawed, function_of_chain, increment_of,
};
use std::f64::consts::FRAC_PI_2;
use wasm_bindgen_test::wasm_bindgen_test;

/// FX-07: 16 libraries.
#[wasm_bindgen_test(unsupported = test)]
fn the_convention_of_a_matrix_library_is_told() {
    let yawed = attitude(unit(2) * FRAC_PI_2);
    let rolled = attitude(unit(0) * 0.8);
    let mut told = 0;
    for convention in MatrixConvention::all() {
        let of = |rotation: Rotation| rotation.to_tagged_matrix(convention).entries;
        // (2) Where x goes.
        let image = of(yawed) * unit(0);
        let operator = direction_of_yawed(image.into()).expect("one or the other");
        let seen_tau = sign_of(image.y);
        assert_eq!(seen_tau, tau(convention.function, convention.direction));
        assert_eq!(operator, convention.operator());
        // (3) The labelled chain W → B → C with labels in the library's direction.
        let (m_wb, m_bc, m_wc) = (of(yawed), of(rolled), of(yawed * rolled));
        let (m_ab, m_bc, m_ac) = match convention.direction {
            Direction::WorldToBody => (m_wb, m_bc, m_wc),
            // The labels are C → B → W: A is C.
            Direction::BodyToWorld => (m_bc, m_wb, m_wc),
        };
        let function = function_of_chain(&m_ab, &m_bc, &m_ac, CLOSE).expect("one or the other");
        let direction = match function {
            Function::Passive => operator,
            Function::Active => operator.reversed(),
        };
        let seen = MatrixConvention {
            function,
            direction,
        };
        assert_eq!(seen, convention);
        for axes in [Perturbation::Local, Perturbation::Global] {
            for sign in [IncrementSign::Physical, IncrementSign::Formal] {
                let before = yawed.to_tagged_matrix(convention);
                let after = before.plus([0.01, 0.0, 0.0], axes, sign).expect("finite");
                // (4) The turn that was added, by what (2) and (3) told.
                let [before, after] = [before, after].map(|matrix| {
                    let matrix = TaggedMatrix {
                        convention: seen,
                        ..matrix
                    };
                    Rotation::nearest_to_matrix(&matrix)
                        .expect("a rotation")
                        .rotation
                });
                // Without a sign, τδ is δ where τ = 1.
                let expected = if sign == IncrementSign::Formal && seen_tau < 0.0 {
                    IncrementSign::Formal
                } else {
                    IncrementSign::Physical
                };
                assert_eq!(
                    increment_of(&before, &after, [0.01, 0.0, 0.0]),
                    Some((axes, expected)),
                    "{convention} {sign:?}"
                );
                told += 1;
            }
        }
    }
    assert_eq!(told, 16);
}

/// FX-07: what is neither one nor the other is not told.
#[wasm_bindgen_test(unsupported = test)]
fn what_tells_nothing_of_a_matrix_library_is_not_told() {
    assert_eq!(
        direction_of_yawed([0.0, 0.91, 0.0]),
        Some(Direction::BodyToWorld)
    );
    assert_eq!(direction_of_yawed([0.0, 0.89, 0.0]), None);
    assert_eq!(
        direction_of_yawed([0.0, -0.91, 0.09]),
        Some(Direction::WorldToBody)
    );
    assert_eq!(direction_of_yawed([0.11, -1.0, 0.0]), None);
    assert_eq!(direction_of_yawed([f64::NAN, 1.0, 0.0]), None);
    // Turns about one axis commute; and no chain is whole whose last matrix is another.
    let [once, twice] = [1.0, 2.0].map(|times| elementary(2, 0.3 * times));
    assert_eq!(function_of_chain(&once, &once, &twice, CLOSE), None);
    assert_eq!(
        function_of_chain(&once, &elementary(0, 0.3), &twice, CLOSE),
        None
    );
    // About the body's own axis, twice the turn, and another one.
    let yawed = attitude(unit(2) * FRAC_PI_2);
    let told = |turn: Vector3<f64>, increment: [f64; 3]| {
        increment_of(&yawed, &(yawed * attitude(turn)), increment)
    };
    let physical = Some((Perturbation::Local, IncrementSign::Physical));
    assert_eq!(told(unit(0) * 0.1, [0.1, 0.0, 0.0]), physical);
    assert_eq!(
        told(unit(0) * 0.124, [0.1, 0.0, 0.0]),
        physical,
        "a quarter off"
    );
    assert_eq!(told(unit(0) * 0.126, [0.1, 0.0, 0.0]), None);
    assert_eq!(told(unit(2) * 0.1, [0.0, 0.0, 0.1]), None, "on either axes");
    assert_eq!(told(unit(2) * 0.1, [0.1, 0.0, 0.0]), None);
    assert_eq!(told(unit(0) * 0.1, [f64::INFINITY, 0.0, 0.0]), None);
    assert_eq!(told(unit(0) * 0.0, [0.0; 3]), None);
}
