//! The Rust that the page copies, compiled and run: nalgebra makes the rotation of the page of it.

use crate::rows::row_major;
use crate::support::assert_close;
use quatlas::nalgebra::{Matrix3, Quaternion, Unit, UnitQuaternion, Vector3};
use wasm_bindgen_test::wasm_bindgen_test;

/// What is copied, the matrix that nalgebra makes of it, and the one that is expected.
type Case = (&'static str, Matrix3<f64>, [[f64; 3]; 3]);

#[wasm_bindgen_test(unsupported = test)]
#[allow(
    clippy::approx_constant,
    clippy::let_and_return,
    clippy::unreadable_literal,
    clippy::excessive_precision,
    reason = "the texts are as people copy them"
)]
fn nalgebra_makes_the_rotation_of_the_page() {
    // Written by tests/browser/copied_texts.spec.ts, which compares it with what is copied.
    let copied: [Case; 22] = include!("../vectors/copied_nalgebra.rs");
    for (value, matrix, rows) in copied {
        assert_close(value, &row_major(&matrix), rows.as_flattened(), 1e-15);
    }
}
