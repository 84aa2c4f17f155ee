//! The specification on the ME 495 lecture: its worked example, its listing, and what it says of
//! one-sided products (see `table.md`).

use crate::reference::{
    self, CLOSE, assert_off, assert_quaternion, assert_same, elementary, exponential_matrix,
    half_angle, pure, skew, turns, unskew, vectors,
};
use crate::support::{assert_close, wxyz};
use quatlas::nalgebra::{Matrix3, Quaternion, Vector3, Vector4};
use quatlas::{
    Convention, MatrixConvention, Rotation, TaggedMatrix, TaggedQuaternion, hamilton_product,
    small_angle_matrix,
};
use std::f64::consts::FRAC_PI_2;
use wasm_bindgen_test::wasm_bindgen_test;

fn attitude(components: Quaternion<f64>) -> Rotation {
    let q = TaggedQuaternion {
        components,
        convention: Convention::HAMILTON,
    };
    Rotation::from_tagged(&q).expect("not zero")
}

/// 003-S5.1.1.a, 003-S5.1.1.b, 003-S5.1.1.c, 003-S5.1.1.d, 003-S5.1.3.a, 003-S5.1.3.b, 003-S5.2.13,
/// 003-S5.1.2.b: the worked example by hand.
#[wasm_bindgen_test(unsupported = test)]
fn the_worked_example_of_the_lecture_with_its_right_numbers() {
    let root = 0.5_f64.sqrt();
    let turn = Rotation::from_axis_angle([0.0, 0.0, 1.0], FRAC_PI_2 / 2.0).expect("an axis");
    let x_ab = Vector3::new(root, root, 0.0);
    let y_ab = Vector3::new(-root, root, 0.0);
    let z_ab = Vector3::new(0.0, 0.0, 1.0);
    let columns = Matrix3::from_columns(&[x_ab, y_ab, z_ab]);
    assert_same("R_ab", &turn.body_to_world_matrix(), &columns, CLOSE);
    let k = skew(&z_ab);
    let rodrigues = Matrix3::identity() + k * root + k * k * (1.0 - root);
    assert_same("I + K sin θ + K² (1 − cos θ)", &rodrigues, &columns, CLOSE);
    let q = wxyz(&turn.to_tagged(Convention::HAMILTON).components);
    assert_close("0.924 + 0.383 k", &q, &[0.924, 0.0, 0.0, 0.383], 4e-4);
    let p_a = Vector3::new(root, root, 0.0);
    assert_same(
        "p_b = R_abᵀ p_a",
        &turn.world_to_body(p_a),
        &Vector3::x(),
        CLOSE,
    );
    assert_same("Q P Q⁻¹", &turn.body_to_world(p_a), &Vector3::y(), CLOSE);
}

/// 003-S4.1.a, 003-S4.2.a, 003-S4.2.b, 003-S4.2.c: about one axis quaternions multiply as complex
/// numbers; the components in the turned frame are those of the opposite turn.
#[wasm_bindgen_test(unsupported = test)]
fn turns_about_one_axis_are_complex_numbers() {
    let (a, b, c, d) = (0.3, -1.2, 0.7, 0.4);
    let complex = |re, im| Quaternion::new(re, 0.0, 0.0, im);
    let product = hamilton_product(&complex(a, b), &complex(c, d));
    assert_quaternion(
        "(a+bi)(c+di)",
        &product,
        &complex(a * c - b * d, b * c + a * d),
    );
    let angle = 0.8;
    let turn = Rotation::from_axis_angle([0.0, 0.0, 1.0], angle).expect("an axis");
    let p = Vector3::new(c, d, 0.0);
    let (sine, cosine) = angle.sin_cos();
    let moved = Vector3::new(c * cosine - d * sine, c * sine + d * cosine, 0.0);
    assert_same("u·v", &turn.body_to_world(p), &moved, CLOSE);
    let seen = elementary(2, angle).transpose() * p;
    assert_same("in the turned frame", &turn.world_to_body(p), &seen, CLOSE);
    assert_off("as printed", &moved, &seen);
}

/// 003-S4.2.f: one-sided multiplication stretches nothing; both sides turn what is across the axis by
/// half the angle, and undo each other along it.
#[wasm_bindgen_test(unsupported = test)]
fn one_sided_multiplication_keeps_lengths_and_turns_by_half() {
    for v in turns() {
        let q = attitude(half_angle(&v)).to_tagged(Convention::HAMILTON);
        let singular_values = q.left_product_matrix().singular_values();
        assert_same("isometry", &singular_values, &Vector4::repeat(1.0), CLOSE);
        let axis = v.normalize();
        let across = axis.cross(&Vector3::new(0.3, 0.1, -0.8));
        let half_turned = exponential_matrix(&(v / 2.0)) * across;
        let left = hamilton_product(&q.components, &pure(&across));
        assert_quaternion("QP", &left, &pure(&half_turned));
        let right = hamilton_product(&pure(&across), &q.conjugate().components);
        assert_quaternion("PQ⁻¹", &right, &pure(&half_turned));
        let along = hamilton_product(&q.components, &pure(&axis));
        assert_close("scalar part", &[along.w], &[-(v.norm() / 2.0).sin()], CLOSE);
    }
}

/// 000-1.7, 002-8, 003-S5.1.2.a, 003-S5.2.6, 003-S5.2.7: the skew matrix, as I + [δ]× holds it.
#[wasm_bindgen_test(unsupported = test)]
fn the_skew_matrix_and_back() {
    for (a, b) in reference::pairs(vectors()) {
        let hat = small_angle_matrix(a.into()) - Matrix3::identity();
        assert_same("[u]× a = u×a", &(hat * b), &a.cross(&b), CLOSE);
        assert_same("entries", &hat, &skew(&a), 1e-15);
        let [x, y, z] = [-hat[(1, 2)], hat[(0, 2)], -hat[(0, 1)]];
        assert_same("unhat", &Vector3::new(x, y, z), &a, 1e-15);
        assert_same("unskew", &unskew(&hat), &a, 1e-15);
    }
}

/// 003-S4.2.g, 003-S5.2.5, 000-A: the angle by the arc cosine of the scalar is lost for small turns,
/// and NaN for a scalar one rounding above 1; by the arc tangent it is not.
#[wasm_bindgen_test(unsupported = test)]
fn the_angle_by_the_arc_tangent_keeps_what_the_arc_cosine_loses() {
    for v in turns() {
        for sign in [1.0, -1.0] {
            let turn = attitude(half_angle(&v) * (sign * 1.7));
            assert_close("θ", &[turn.angle_rad()], &[v.norm()], CLOSE);
            assert_same("u", &turn.axis().expect("a turn"), &v.normalize(), CLOSE);
        }
    }
    for angle in [1e-8, 1e-12, 1e-150] {
        let q = half_angle(&Vector3::new(0.0, angle, 0.0));
        assert_eq!(2.0 * q.w.acos(), 0.0, "by the arc cosine");
        let relative = attitude(q).angle_rad() / angle;
        assert_close("θ", &[relative], &[1.0], 1e-15);
    }
    let above = 1.0 + f64::EPSILON;
    assert!((2.0 * above.acos()).is_nan());
    assert_eq!(
        attitude(Quaternion::new(above, 0.0, 0.0, 0.0)).angle_rad(),
        0.0
    );
    assert_eq!(attitude(Quaternion::new(1.0, 0.0, 0.0, 0.0)).axis(), None);
}

/// 003-S4.2.j, 003-S5.2.9, 003-S5.2.10: half turns have no axis by the quotient of the lecture, and
/// theirs by the nearest rotation.
#[wasm_bindgen_test(unsupported = test)]
fn half_turns_keep_their_axis_from_matrix_to_vector() {
    let read = |entries| {
        let matrix = TaggedMatrix {
            entries,
            convention: MatrixConvention::BODY_TO_WORLD,
        };
        let nearest = Rotation::nearest_to_matrix(&matrix).expect("a rotation");
        nearest.rotation.rotation_vector_rad()
    };
    for direction in turns().chain((0..3).map(reference::unit)) {
        let axis = direction.normalize();
        let half_turn = axis * axis.transpose() * 2.0 - Matrix3::identity();
        let by_quotient = unskew(&(half_turn - half_turn.transpose()));
        assert!(by_quotient.amax() < 1e-15, "0/0");
        let v = read(half_turn);
        assert_close("π", &[v.norm()], &[std::f64::consts::PI], CLOSE);
        assert_close("along the axis", &[v.dot(&axis).abs()], &[v.norm()], CLOSE);
    }
    for v in turns() {
        assert_same("others", &read(exponential_matrix(&v)), &v, 1e-13);
    }
}

/// 003-S5.2.14: matrices and quaternions of the same axis and angle move points alike.
#[wasm_bindgen_test(unsupported = test)]
fn the_random_test_of_the_listing_on_a_grid() {
    for direction in turns() {
        for step in 0..16 {
            let angle = f64::from(step) * std::f64::consts::PI / 8.0;
            let axis = direction.normalize();
            let turn = Rotation::from_axis_angle(axis.into(), angle).expect("an axis");
            let matrix = exponential_matrix(&(axis * angle));
            for p in vectors() {
                assert_same(
                    "R_abᵀ p",
                    &turn.world_to_body(p),
                    &(matrix.transpose() * p),
                    1e-13,
                );
            }
        }
    }
}

/// 003-S5.2.2: a norm of 1 is told within 1e-12.
#[wasm_bindgen_test(unsupported = test)]
fn the_norm_tells_unit_quaternions() {
    for v in turns() {
        let q = attitude(half_angle(&v)).to_tagged(Convention::HAMILTON);
        assert!((q.norm() - 1.0).abs() < 1e-12);
        let longer = TaggedQuaternion {
            components: q.components * (1.0 + 1e-11),
            ..q
        };
        assert!((longer.norm() - 1.0).abs() > 1e-12);
    }
}
