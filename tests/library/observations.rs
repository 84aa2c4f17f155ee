//! The table of libraries: what each of them printed is computed again by this core.
//!
//! Every record that was run has its numbers in `src/library/observations.json`. Each test below takes one
//! thing that a record says, computes what a library of that kind prints, and compares.

use crate::recorded::{
    SINGLE_PRECISION, assert_same_rotation, for_each, matrix, numbers, of, product,
    product_of_turns, quaternion, vector,
};
use crate::support::{assert_close, wxyz};
use quatlas::nalgebra::{Quaternion, Vector3};
use quatlas::{
    AxisAngleSign, ComponentOrder, Convention, CosineMatrix, Handedness, Library, Side,
    TaggedQuaternion, VectorLayout, libraries, library,
};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn the_order_of_arrays_and_constructors() {
    for_each(|library, observed, inputs| {
        let id = &library.id;
        let in_order = |q: &Quaternion<f64>, order: ComponentOrder| {
            TaggedQuaternion {
                components: *q,
                convention: Convention {
                    order,
                    ..Convention::HAMILTON
                },
            }
            .to_array()
        };
        let a = quaternion(&inputs["a"]).expect("a");
        if let (Some(order), Some(printed)) = (library.array_order, numbers(&observed["arrayOfA"]))
        {
            assert_close(id, &printed, &in_order(&a, order), SINGLE_PRECISION);
        }
        if let (Some(order), Some(made)) = (
            library.constructor_order,
            quaternion(&observed["constructed1234"]),
        ) {
            // It took 0.1, 0.2, 0.3, 0.4. Some divide by the norm, some go through a matrix: only the
            // direction of the vector part is the same for all.
            let expected = match order {
                ComponentOrder::ScalarFirst => Vector3::new(2.0, 3.0, 4.0),
                ComponentOrder::ScalarLast => Vector3::new(1.0, 2.0, 3.0),
            };
            let got = made.vector().normalize();
            let expected = expected.normalize();
            assert_close(id, got.as_slice(), expected.as_slice(), SINGLE_PRECISION);
        }
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn the_product() {
    for_each(|library, observed, inputs| {
        let id = &library.id;
        let (a, b) = (
            quaternion(&inputs["a"]).expect("a"),
            quaternion(&inputs["b"]).expect("b"),
        );
        if let (Some(hand), Some(printed)) =
            (library.handedness, quaternion(&observed["productAB"]))
        {
            assert_same_rotation(id, &printed, &product(hand, &a, &b));
        }
        if let (Some(hand), Some(printed)) = (library.handedness, numbers(&observed["productIJ"])) {
            let sign = if hand == Handedness::Right { 1.0 } else { -1.0 };
            assert_close(id, &printed, &[0.0, 0.0, 0.0, sign], SINGLE_PRECISION);
        }
        let is_recorded = !observed["productAB"].is_null() || !observed["productIJ"].is_null();
        assert!(
            library.handedness.is_some() || !is_recorded,
            "{id}: a product without a hand"
        );
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn the_matrix() {
    for_each(|library, observed, inputs| {
        let Some(form) = library.matrix else { return };
        let (a, b) = (
            quaternion(&inputs["a"]).expect("a"),
            quaternion(&inputs["b"]).expect("b"),
        );
        let check = |what: &str, q: &Quaternion<f64>| {
            let Some(printed) = matrix(&observed[what]) else {
                return;
            };
            let expected = of(form, q);
            let what = format!("{}: {what}", library.id);
            assert_close(
                &what,
                printed.as_slice(),
                expected.as_slice(),
                SINGLE_PRECISION,
            );
        };
        check("matrixA", &a);
        check("matrixB", &b);
        if let Some(hand) = library.handedness {
            check("matrixAB", &product(hand, &a, &b));
        }
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn the_rotated_vector_and_which_operand_acts_first() {
    for_each(|library, observed, inputs| {
        let Some(form) = library.rotate else { return };
        let id = &library.id;
        let (a, b) = (
            quaternion(&inputs["a"]).expect("a"),
            quaternion(&inputs["b"]).expect("b"),
        );
        let v = vector(&inputs["v"]).expect("v");
        let check = |what: &str, expected: Vector3<f64>| {
            let Some(printed) = vector(&observed[what]) else {
                return;
            };
            let what = format!("{id}: {what}");
            assert_close(
                &what,
                printed.as_slice(),
                expected.as_slice(),
                SINGLE_PRECISION,
            );
        };
        let b_then_a = of(form, &a) * (of(form, &b) * v);
        let a_then_b = of(form, &b) * (of(form, &a) * v);
        check("rotateAV", of(form, &a) * v);
        check("rotateBThenA", b_then_a);
        check("rotateAThenB", a_then_b);
        let is_told = library.handedness.is_some();
        assert_eq!(library.first_to_act().is_some(), is_told, "{id}");
        if let Some(first) = library.first_to_act() {
            check(
                "rotateABV",
                if first == Side::Right {
                    b_then_a
                } else {
                    a_then_b
                },
            );
        }
    });
}

/// A matrix that acts on columns as it is printed, or on rows, does what the call that rotates does.
#[wasm_bindgen_test(unsupported = test)]
fn matrix_and_rotation_agree() {
    for library in libraries() {
        let (Some(rotate), Some(matrix), Some(vectors)) =
            (library.rotate, library.matrix, library.vectors)
        else {
            continue;
        };
        let acts = match vectors {
            VectorLayout::Column => matrix,
            VectorLayout::Row => matrix.transposed(),
        };
        assert_eq!(acts, rotate, "{}", library.id);
    }
}

/// A matrix that is printed as C for row vectors acts as R.
#[wasm_bindgen_test(unsupported = test)]
fn without_a_call_that_rotates_the_matrix_tells_the_action() {
    let record = |vectors| Library {
        rotate: None,
        matrix: Some(CosineMatrix::Shuster),
        vectors: Some(vectors),
        ..*library("eigen").expect("a record")
    };
    assert_eq!(
        record(VectorLayout::Row).action(),
        Some(CosineMatrix::Hamilton)
    );
    assert_eq!(
        record(VectorLayout::Column).action(),
        Some(CosineMatrix::Shuster)
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn a_turn_about_z() {
    for_each(|library, observed, inputs| {
        let Some(printed) = quaternion(&observed["axisAngleZ"]) else {
            assert_eq!(library.axis_angle, None, "{}", library.id);
            return;
        };
        let angle = inputs["axisAngle"].as_f64().expect("an angle");
        let (sin, cos) = (angle / 2.0).sin_cos();
        let sign = match library.axis_angle.expect(library.id) {
            AxisAngleSign::Positive => 1.0,
            AxisAngleSign::Negative => -1.0,
        };
        // Two of the libraries have a call for small turns only, to first order.
        let expected = [cos, 0.0, 0.0, sign * sin];
        assert_close(library.id, &wxyz(&printed), &expected, 1e-3);
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn euler_calls_mean_what_they_say() {
    for_each(|library, observed, _| {
        let none = Vec::new();
        let printed = observed["euler"].as_array().unwrap_or(&none);
        assert!(library.euler.len() <= printed.len(), "{}", library.id);
        for (call, observed) in library.euler.iter().zip(printed) {
            let got = match quaternion(&observed["out"]) {
                Some(quaternion) => of(CosineMatrix::Hamilton, &quaternion),
                None => matrix(&observed["out"]).expect(call.call),
            };
            let angles = numbers(&observed["args"]).expect("angles");
            let expected = product_of_turns(call.means, &angles);
            let what = format!("{}: {} {}", library.id, call.call, observed["call"]);
            assert_close(&what, got.as_slice(), expected.as_slice(), 1e-5);
        }
    });
}
