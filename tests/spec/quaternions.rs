//! The specification on the algebra and the action of quaternions, id by id (see `table.md`).

use crate::reference::{
    self, CLOSE, assert_off, assert_quaternion, assert_same, assert_turn, conjugate,
    exponential_matrix, half_angle, hamilton, inverse, jpl, matrix_of, numbers, pairs, pure, skew,
    turned, turns, vector_part, vectors,
};
use crate::support::{all_conventions, assert_close};
use quatlas::nalgebra::{Matrix3, Matrix4, Quaternion, Vector4};
use quatlas::{
    ComponentOrder, Convention, CosineMatrix, Handedness, Rotation, TaggedQuaternion,
    hamilton_product, jpl_product,
};
use std::f64::consts::TAU;
use wasm_bindgen_test::wasm_bindgen_test;

const ONE: Quaternion<f64> = Quaternion::new(1.0, 0.0, 0.0, 0.0);

fn tagged(components: Quaternion<f64>, convention: Convention) -> TaggedQuaternion {
    TaggedQuaternion {
        components,
        convention,
    }
}

fn attitude(components: Quaternion<f64>) -> Rotation {
    Rotation::from_tagged(&tagged(components, Convention::HAMILTON)).expect("not zero")
}

fn unit_quaternions() -> impl Iterator<Item = Quaternion<f64>> {
    numbers().map(|q| q / q.coords.norm())
}

/// 000-2.2, 000-2.3, 000-2.4, 002-5, 002-12, 003-S4.1.b, 003-S4.1.c
#[wasm_bindgen_test(unsupported = test)]
fn both_products_in_vectors_in_components_and_by_the_table() {
    for (p, q) in pairs(numbers()) {
        let (a, b) = (vector_part(&p), vector_part(&q));
        let scalar = p.w * q.w - a.dot(&b);
        let sum = b * p.w + a * q.w;
        let right = Quaternion::from_parts(scalar, sum + a.cross(&b));
        let left = Quaternion::from_parts(scalar, sum - a.cross(&b));
        assert_quaternion("⊙ in vectors", &hamilton_product(&p, &q), &right);
        assert_quaternion("⊗ in vectors", &jpl_product(&p, &q), &left);
        assert_quaternion(
            "⊙ by the table",
            &hamilton_product(&p, &q),
            &hamilton(&p, &q),
        );
        assert_quaternion("⊗ by the table", &jpl_product(&p, &q), &jpl(&p, &q));
        assert_quaternion("p⊙q = q⊗p", &hamilton_product(&p, &q), &jpl(&q, &p));
    }
}

/// 002-5n: the products differ by twice the cross product.
#[wasm_bindgen_test(unsupported = test)]
fn the_product_does_not_commute() {
    for (p, q) in pairs(numbers()) {
        let commutator = hamilton_product(&p, &q) - hamilton_product(&q, &p);
        let cross = vector_part(&p).cross(&vector_part(&q)) * 2.0;
        assert_quaternion("p⊙q − q⊙p", &commutator, &pure(&cross));
    }
}

/// 000-S2.2.H, 000-S2.2.J, 003-S4.b, 003-S4.d: as printed, k·i = −k·i, k would be 0.
#[wasm_bindgen_test(unsupported = test)]
fn the_units_square_to_minus_one_and_anticommute() {
    let [i, j, k] = [0, 1, 2].map(|axis| pure(&reference::unit(axis)));
    for unit in [i, j, k] {
        assert_eq!(hamilton_product(&unit, &unit), -ONE);
        assert_eq!(jpl_product(&unit, &unit), -ONE);
    }
    for (first, second, third) in [(i, j, k), (j, k, i), (k, i, j)] {
        assert_eq!(hamilton_product(&first, &second), third);
        assert_eq!(hamilton_product(&second, &first), -third);
        assert_eq!(jpl_product(&second, &first), third);
        assert_eq!(jpl_product(&first, &second), -third);
    }
    assert_eq!(hamilton_product(&hamilton_product(&i, &j), &k), -ONE);
    assert_eq!(jpl_product(&jpl_product(&i, &j), &k), ONE);
}

/// 000-2.5, 003-S4.h, 003-S4.c
#[wasm_bindgen_test(unsupported = test)]
fn one_and_the_real_numbers_commute_with_all() {
    for q in numbers() {
        for product in [hamilton_product, jpl_product] {
            assert_eq!(product(&ONE, &q), q);
            assert_eq!(product(&q, &ONE), q);
            assert_quaternion("a q", &product(&(ONE * 2.5), &q), &(q * 2.5));
            assert_quaternion("q a", &product(&q, &(ONE * 2.5)), &(q * 2.5));
        }
    }
}

/// 000-2.6, 000-2.7, 000-2.8, 000-2.9, 000-2.11, 003-S4.e, 003-S4.f, 003-S4.g, 004-Q.17, 004-Q.18
#[wasm_bindgen_test(unsupported = test)]
fn conjugate_norm_and_inverse() {
    for convention in [Convention::HAMILTON, Convention::JPL] {
        let of = |q| tagged(q, convention);
        for (p, q) in pairs(numbers()) {
            let Quaternion { coords } = of(q).conjugate().components;
            assert_eq!(
                [coords.w, coords.x, coords.y, coords.z],
                [q.w, -q.i, -q.j, -q.k]
            );
            let product = of(p).product(&of(q)).expect("one convention");
            let reversed = of(q).conjugate().product(&of(p).conjugate());
            let reversed = reversed.expect("one convention").components;
            assert_quaternion("(p∘q)*", &product.conjugate().components, &reversed);
            let square = q.coords.norm_squared();
            let real = of(q).product(&of(q).conjugate()).expect("one convention");
            assert_quaternion("q∘q*", &real.components, &(ONE * square));
            assert_close("|q|", &[of(q).norm()], &[square.sqrt()], CLOSE);

            let undone = of(q).inverse().expect("not zero");
            assert_quaternion("q⁻¹ = q*/|q|²", &undone.components, &inverse(&q));
            let one = of(q).product(&undone).expect("one convention");
            assert_quaternion("q∘q⁻¹", &one.components, &ONE);
            let factors = [q, p].map(|factor| of(factor).inverse().expect("not zero"));
            let reversed = factors[0].product(&factors[1]).expect("one convention");
            let whole = product.inverse().expect("not zero").components;
            assert_turn("(p∘q)⁻¹", &reversed.components, &whole);
        }
        for q in unit_quaternions() {
            let undone = of(q).inverse().expect("not zero").components;
            assert_quaternion("q⁻¹ = q* of norm 1", &undone, &conjugate(&q));
        }
    }
    let long = Quaternion::new(1.0, 2.0, 3.0, 4.0);
    assert_off(
        "q⁻¹ = q* of norm √30",
        &conjugate(&long).coords,
        &inverse(&long).coords,
    );
    let square = hamilton(&long, &long);
    assert!(
        vector_part(&square).amax() > 1.0,
        "with q* as printed q∘q* is not real"
    );
}

/// 002-6, 002-7, 002-13, 002-14, 002-15, 004-Q.11, 004-Q.12, 004-Q.13, 004-Q.14, 004-Q.15, and the
/// Jacobians of a product of FX-25
#[wasm_bindgen_test(unsupported = test)]
fn product_matrices_have_the_printed_blocks_in_both_hands_and_orders() {
    for convention in all_conventions() {
        let hand = match convention.handedness {
            Handedness::Right => 1.0,
            Handedness::Left => -1.0,
        };
        // [[w, −vᵀ], [v, w I ± [v]×]], with the scalar first.
        let blocks = |q: &Quaternion<f64>, sign: f64| {
            let v = vector_part(q);
            let mut m = Matrix4::from_diagonal_element(q.w);
            m.fixed_view_mut::<1, 3>(0, 1).copy_from(&-v.transpose());
            m.fixed_view_mut::<3, 1>(1, 0).copy_from(&v);
            let vector = Matrix3::from_diagonal_element(q.w) + skew(&v) * sign;
            m.fixed_view_mut::<3, 3>(1, 1).copy_from(&vector);
            match convention.order {
                ComponentOrder::ScalarFirst => m,
                ComponentOrder::ScalarLast => {
                    Matrix4::from_fn(|row, column| m[((row + 1) % 4, (column + 1) % 4)])
                }
            }
        };
        for (p, q) in pairs(numbers()) {
            let (tagged_p, tagged_q) = (tagged(p, convention), tagged(q, convention));
            let (left, right) = (
                tagged_p.left_product_matrix(),
                tagged_q.right_product_matrix(),
            );
            assert_same("[p]_L", &left, &blocks(&p, hand), CLOSE);
            assert_same("[q]_R", &right, &blocks(&q, -hand), CLOSE);
            let product = tagged(
                reference::product(convention.handedness, &p, &q),
                convention,
            );
            let product = Vector4::from(product.to_array());
            let (p, q) = (tagged_p.to_array(), tagged_q.to_array());
            assert_same("p∘q = [p]_L q", &(left * Vector4::from(q)), &product, CLOSE);
            assert_same(
                "p∘q = [q]_R p",
                &(right * Vector4::from(p)),
                &product,
                CLOSE,
            );
        }
    }
}

/// 000-2.10, 000-2.10n, 000-2.10u, 003-S4.2.d, 000-S2.3.i
#[wasm_bindgen_test(unsupported = test)]
fn the_exponential_is_the_half_angle_in_both_products() {
    for v in turns() {
        let rotation = Rotation::from_axis_angle(v.into(), v.norm()).expect("an axis");
        let q = rotation.to_tagged(Convention::HAMILTON).components;
        assert_quaternion("[cos φ/2, u sin φ/2]", &q, &half_angle(&v));
        assert_close("|q|", &[q.coords.norm()], &[1.0], 3e-16);
        // The power series of e^{v/2}, in either product.
        for product in [hamilton, jpl] {
            let (mut term, mut sum) = (ONE, ONE);
            for n in 1..30 {
                term = product(&term, &pure(&(v / 2.0))) / f64::from(n);
                sum += term;
            }
            assert_quaternion("e^{v/2}", &q, &sum);
        }
        let opposite = rotation.inverse();
        assert_close("φ", &[opposite.angle_rad()], &[rotation.angle_rad()], 0.0);
        assert_eq!(opposite.axis(), rotation.axis().map(|axis| -axis));
    }
}

/// 000-2.12, 000-S2.3.p, 000-S2.3.4, 003-S4.2.i, 004-Q.4: q and −q are one attitude; a whole turn more
/// about the axis makes −q of q, and two make q.
#[wasm_bindgen_test(unsupported = test)]
fn two_quaternions_are_one_attitude() {
    for q in numbers() {
        let matrix = attitude(q).body_to_world_matrix();
        assert_eq!(attitude(-q).body_to_world_matrix(), matrix);
        let inverse = attitude(conjugate(&q)).body_to_world_matrix();
        assert_same("R(q*)", &inverse, &matrix.transpose(), 0.0);
    }
    for v in turns() {
        let more = |whole_turns: f64| {
            let angle = v.norm() + whole_turns * TAU;
            let turn = Rotation::from_axis_angle(v.into(), angle).expect("an axis");
            turn.to_tagged(Convention::HAMILTON).components
        };
        assert_quaternion("φ + 2π", &more(1.0), &-half_angle(&v));
        assert_quaternion("φ + 4π", &more(2.0), &half_angle(&v));
        assert_quaternion("φ − 2π", &more(-1.0), &-half_angle(&v));
    }
}

/// 000-2.13, 000-2.14, 000-2.15, 000-S2.4.o, 003-S4.2.e, 003-S5.2.11: the double product of
/// the same numbers in the other hand is the opposite turn.
#[wasm_bindgen_test(unsupported = test)]
fn the_double_product_turns_a_vector() {
    for (q, x) in numbers().flat_map(|q| vectors().map(move |x| (q, x))) {
        let by_hamilton = turned(Handedness::Right, &q, &x);
        let by_jpl = turned(Handedness::Left, &q, &x);
        assert_same(
            "q⊙x⊙q⁻¹",
            &attitude(q).body_to_world(x),
            &by_hamilton,
            CLOSE,
        );
        assert_same("q⊗x⊗q⁻¹", &attitude(q).world_to_body(x), &by_jpl, CLOSE);
        let jpl_numbers = tagged(q, Convention::JPL);
        let read = Rotation::from_tagged(&jpl_numbers).expect("not zero");
        assert_same("S of JPL", &read.world_to_body(x), &by_jpl, CLOSE);

        // q⊗x⊗q* = q*⊙x⊙q for all, and x turned by q* only for norm 1.
        let double = jpl(&jpl(&q, &pure(&x)), &conjugate(&q));
        let chain = hamilton(&hamilton(&conjugate(&q), &pure(&x)), &q);
        assert_quaternion("eq. 2.14", &double, &chain);
        let square = q.coords.norm_squared();
        let expected = attitude(q).world_to_body(x) * square;
        assert_same("|q|² C x", &vector_part(&double), &expected, CLOSE);
        let double = hamilton(&hamilton(&q, &pure(&x)), &conjugate(&q));
        let expected = attitude(q).body_to_world(x) * square;
        assert_same("|q|² R x", &vector_part(&double), &expected, CLOSE);
        // Eq. 2.15 with the inverse and its conjugate: of norm 1 alone.
        let undone = inverse(&q);
        let double = hamilton(&hamilton(&undone, &pure(&x)), &conjugate(&undone));
        let expected = attitude(q).world_to_body(x) / square;
        assert_same("C x/|q|²", &vector_part(&double), &expected, 1e-12);
    }
}

/// 004-Q.9: a scalar part of 1 stays, in both hands.
#[wasm_bindgen_test(unsupported = test)]
fn the_homogeneous_one_stays() {
    for (q, x) in numbers().flat_map(|q| vectors().map(move |x| (q, x))) {
        let point = Quaternion::from_parts(1.0, x);
        for convention in [Convention::HAMILTON, Convention::JPL] {
            let q = tagged(q, convention);
            let moved = q
                .product(&tagged(point, convention))
                .and_then(|product| product.product(&q.inverse().expect("not zero")))
                .expect("one convention");
            let attitude = Rotation::from_tagged(&q).expect("not zero");
            let image = attitude.matrix(convention.operator()) * x;
            let expected = Quaternion::from_parts(1.0, image);
            assert_quaternion("[v; 1]", &moved.components, &expected);
        }
    }
}

/// 000-2.16, 000-2.17, 000-2.18, 000-B.u, 002-2, 004-Q.1, 004-Q.1m, 004-Q.3, 004-Q.3m, 000-2.32: and
/// that `(w² − 1) I`, as printed, is off.
#[wasm_bindgen_test(unsupported = test)]
fn the_cosine_matrices_in_vectors_and_in_elements() {
    for q in numbers() {
        let c_h = CosineMatrix::Hamilton.of(&q).expect("not zero");
        let c_s = CosineMatrix::Shuster.of(&q).expect("not zero");
        assert_same(
            "by the product ⊙",
            &c_h,
            &matrix_of(Handedness::Right, &q),
            CLOSE,
        );
        assert_same(
            "by the product ⊗",
            &c_s,
            &matrix_of(Handedness::Left, &q),
            CLOSE,
        );
        assert_same("C_S = C_Hᵀ", &c_s, &c_h.transpose(), 0.0);

        let v = vector_part(&q);
        let (square, outer) = (q.coords.norm_squared(), v * v.transpose() * 2.0);
        let any_norm = Matrix3::from_diagonal_element(q.w * q.w - v.dot(&v)) + outer;
        let skew = skew(&v) * (2.0 * q.w);
        assert_same("C_H", &c_h, &((any_norm + skew) / square), CLOSE);
        assert_same("C_S", &c_s, &((any_norm - skew) / square), CLOSE);
    }
    let elements = |q: &Quaternion<f64>| {
        let (w, x, y, z) = (q.w, q.i, q.j, q.k);
        Matrix3::new(
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
            2.0 * (x * y + w * z),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - w * x),
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            1.0 - 2.0 * (x * x + y * y),
        )
    };
    for q in unit_quaternions() {
        let (c_h, c_s) = (
            attitude(q).body_to_world_matrix(),
            attitude(q).world_to_body_matrix(),
        );
        assert_same("elements of C_H", &c_h, &elements(&q), CLOSE);
        assert_same("elements of C_S", &c_s, &elements(&q).transpose(), CLOSE);
        let printed = c_h - Matrix3::from_diagonal_element(q.w * q.w);
        assert!((printed.determinant() - 1.0).abs() > 0.01, "no rotation");
    }
    let long = Quaternion::new(1.0, 2.0, 3.0, 4.0);
    let right = attitude(long).body_to_world_matrix();
    assert_off("the elements of norm √30", &elements(&long), &right);
}

/// 003-S4.3.a, 000-2.19
#[wasm_bindgen_test(unsupported = test)]
fn products_of_quaternions_compose_without_matrices() {
    for (p, q) in pairs(turns()) {
        for x in vectors() {
            // Eq. 2.19: of the quaternion of an axis and angle, the turn by these.
            let image = attitude(half_angle(&p)).body_to_world(x);
            assert_same("R(u, φ) x", &image, &(exponential_matrix(&p) * x), CLOSE);
        }
        let product = hamilton_product(&half_angle(&p), &half_angle(&q));
        let expected = exponential_matrix(&p) * exponential_matrix(&q);
        let got = attitude(product).body_to_world_matrix();
        assert_same("R(PQ)", &got, &expected, CLOSE);
    }
}

/// 004-Q.20, 004-Q.21
#[wasm_bindgen_test(unsupported = test)]
fn quaternion_distances_by_components() {
    for (v, u) in pairs(turns()) {
        for sign in [1.0, -1.0] {
            let (p, q) = (half_angle(&v), half_angle(&u) * sign);
            let (near, far) = ((p - q).coords.norm(), (p + q).coords.norm());
            let (a, b) = (attitude(p), attitude(q));
            assert_close("‖p−q‖", &[a.quaternion_distance(&b)], &[near], CLOSE);
            let least = near.min(far);
            assert_close("min", &[a.shorter_quaternion_distance(&b)], &[least], CLOSE);
        }
    }
}
