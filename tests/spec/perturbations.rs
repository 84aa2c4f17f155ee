//! The specification on increments: table 2.2, the third part of table 2.3, and error quaternions (see
//! `table.md`).

use crate::reference::{
    CLOSE, SLOPE, assert_off, assert_order, assert_quaternion, assert_same, assert_turn,
    components, conjugate, exponential_matrix, half_angle, hamilton, jpl, logarithm, matrix,
    matrix_of, order, pairs, product, sigma, skew, slope, tau, turns, unit, vectors,
};
use crate::support::all_conventions;
use quatlas::nalgebra::{Matrix3, Quaternion, Vector3};
use quatlas::{
    Convention, CosineMatrix, IncrementSign, MatrixConvention, Perturbation, RateAxes, Rotation,
    Side, TaggedMatrix, TaggedQuaternion, small_angle_matrix, small_angle_quaternion,
};
use wasm_bindgen_test::wasm_bindgen_test;

const DELTA: [f64; 3] = [0.12, -0.23, 0.31];

fn delta() -> Vector3<f64> {
    DELTA.into()
}

fn tagged(convention: Convention, v: &Vector3<f64>) -> TaggedQuaternion {
    TaggedQuaternion {
        components: components(convention, v),
        convention,
    }
}

fn of_matrix(convention: MatrixConvention, v: &Vector3<f64>) -> TaggedMatrix {
    TaggedMatrix {
        entries: matrix(convention, v),
        convention,
    }
}

/// `R_WB` after the body was turned on its axes or on the world's.
fn turned(v: &Vector3<f64>, turn: &Vector3<f64>, axes: Perturbation) -> Matrix3<f64> {
    match axes {
        Perturbation::Local => exponential_matrix(v) * exponential_matrix(turn),
        Perturbation::Global => exponential_matrix(turn) * exponential_matrix(v),
    }
}

/// The side of table 2.2: right iff (τ = +1) = (local).
fn is_right(tau: f64, axes: Perturbation) -> bool {
    (tau > 0.0) == (axes == Perturbation::Local)
}

/// Rotation vectors, each with all 32 conventions.
fn turns_in_every_convention() -> impl Iterator<Item = (Vector3<f64>, Convention)> {
    let with = |v| move |convention| (v, convention);
    turns().flat_map(move |v| all_conventions().into_iter().map(with(v)))
}

/// MODEL-06, FX-24, and the columns ⊕ and ⊖ of tables 2.2 and 2.4
#[wasm_bindgen_test(unsupported = test)]
fn a_physical_increment_of_a_quaternion_turns_the_body() {
    for (v, convention) in turns_in_every_convention() {
        let what = convention.to_string();
        let before = tagged(convention, &v);
        let after = before.plus(DELTA, IncrementSign::Physical).expect("finite");
        let operator = matrix_of(convention.handedness, &after.components);
        let sign = tau(convention.function, convention.direction);
        let body_to_world = if sign > 0.0 {
            operator
        } else {
            operator.transpose()
        };
        let expected = turned(&v, &delta(), convention.perturbation);
        assert_same(&what, &body_to_world, &expected, CLOSE);

        let increment = half_angle(&(delta() * sigma(convention)));
        let (side, by_table) = if is_right(sign, convention.perturbation) {
            (
                Side::Right,
                product(convention.handedness, &before.components, &increment),
            )
        } else {
            (
                Side::Left,
                product(convention.handedness, &increment, &before.components),
            )
        };
        assert_quaternion(&what, &after.components, &by_table);
        assert_eq!(convention.increment_side(), side, "{what}");

        for components in [after.components, -after.components] {
            let after = TaggedQuaternion {
                components,
                convention,
            };
            let difference = after
                .minus(&before, IncrementSign::Physical)
                .expect("not zero");
            assert_same(&what, &difference, &delta(), CLOSE);
        }
    }
}

/// MODEL-07 for quaternions: `θ_formal = σδ`, and with it the sign-free products.
#[wasm_bindgen_test(unsupported = test)]
fn a_formal_increment_of_a_quaternion_is_the_physical_one_times_sigma() {
    for (v, convention) in turns_in_every_convention() {
        let what = convention.to_string();
        let before = tagged(convention, &v);
        let after = before.plus(DELTA, IncrementSign::Formal).expect("finite");
        let sign = tau(convention.function, convention.direction);
        let increment = half_angle(&delta());
        let by_table = if is_right(sign, convention.perturbation) {
            product(convention.handedness, &before.components, &increment)
        } else {
            product(convention.handedness, &increment, &before.components)
        };
        assert_quaternion(&what, &after.components, &by_table);
        let formal = after
            .minus(&before, IncrementSign::Formal)
            .expect("not zero");
        let physical = after
            .minus(&before, IncrementSign::Physical)
            .expect("not zero");
        assert_same(&what, &formal, &delta(), CLOSE);
        assert_same(&what, &physical, &(delta() * sigma(convention)), CLOSE);
    }
}

/// FX-05, MODEL-06 and MODEL-07 for matrices, 004-I.P, 004-RM.17, 004-RM.18, 004-RM.19 and table 2.3
#[wasm_bindgen_test(unsupported = test)]
fn increments_of_a_matrix_turn_the_body_or_stand_as_they_are() {
    for (v, convention) in turns().flat_map(|v| MatrixConvention::all().map(move |c| (v, c))) {
        let sign = tau(convention.function, convention.direction);
        let before = of_matrix(convention, &v);
        for axes in [Perturbation::Local, Perturbation::Global] {
            let what = format!("{convention} {axes}");
            let after = before
                .plus(DELTA, axes, IncrementSign::Physical)
                .expect("finite");
            let expected = turned(&v, &delta(), axes);
            let expected = if sign > 0.0 {
                expected
            } else {
                expected.transpose()
            };
            assert_same(&what, &after.entries, &expected, CLOSE);
            let physical = after.minus(&before, axes, IncrementSign::Physical);
            assert_same(&what, &physical.expect("rotations"), &delta(), CLOSE);
            // The guide's lines have the formal sign: for R_BW θ is minus the turn of the body.
            let formal = after
                .minus(&before, axes, IncrementSign::Formal)
                .expect("rotations");
            assert_same(&what, &formal, &(delta() * sign), CLOSE);
            let by_formal = before
                .plus(DELTA, axes, IncrementSign::Formal)
                .expect("finite");
            let increment = exponential_matrix(&delta());
            let by_table = if is_right(sign, axes) {
                before.entries * increment
            } else {
                increment * before.entries
            };
            assert_same(&what, &by_formal.entries, &by_table, CLOSE);
            if sign < 0.0 {
                assert_off("without the sign", &by_formal.entries, &after.entries);
            }
        }
        // Local and global increments are one turn: δ_G = R_WB δ_L.
        let on_world = exponential_matrix(&v) * delta();
        let global = before.plus(
            on_world.into(),
            Perturbation::Global,
            IncrementSign::Physical,
        );
        let local = before.plus(DELTA, Perturbation::Local, IncrementSign::Physical);
        let (global, local) = (global.expect("finite"), local.expect("finite"));
        assert_same("δ_G = R_WB δ_L", &global.entries, &local.entries, CLOSE);
    }
}

/// 000-2.27, 000-2.28, 000-2.40, 000-2.41, 000-2.41n: the local error is `q_î^i`, on the right of ⊙ and
/// on the left of ⊗; the inverse, as printed, does not lead from the estimate to the truth.
#[wasm_bindgen_test(unsupported = test)]
fn the_error_quaternion_leads_from_the_estimate_to_the_truth() {
    for (estimate, v) in pairs(turns()).into_iter().filter(|(v, u)| v != u) {
        let of = |convention| {
            tagged(convention, &v)
                .error_from(&tagged(convention, &estimate))
                .expect("not zero")
                .components
        };
        let (truth, guess) = (half_angle(&v), half_angle(&estimate));
        let error = of(Convention::HAMILTON);
        assert_turn("q = q̂⊙δq", &hamilton(&guess, &error), &truth);
        assert_turn("q = δq⊗q̂", &jpl(&of(Convention::JPL), &guess), &truth);
        assert_turn("one error", &of(Convention::JPL), &error);
        let matrix = exponential_matrix(&estimate).transpose() * exponential_matrix(&v);
        use quatlas::Handedness::{Left, Right};
        assert_same("R = R̂ R(δq)", &matrix_of(Right, &error), &matrix, CLOSE);
        let c = [&v, &estimate].map(|turn| exponential_matrix(turn).transpose());
        let by_jpl = matrix_of(Left, &error) * c[1];
        assert_same("C = C(δq) Ĉ", &by_jpl, &c[0], CLOSE);
    }
    let [v, estimate] = [[0.4, -0.7, 1.1], [-0.6, 0.25, 0.9]].map(Vector3::from);
    let (truth, guess) = (half_angle(&v), half_angle(&estimate));
    let error =
        tagged(Convention::HAMILTON, &v).error_from(&tagged(Convention::HAMILTON, &estimate));
    let as_printed = conjugate(&error.expect("not zero").components);
    assert_off("2.41", &hamilton(&guess, &as_printed).coords, &truth.coords);
    assert_off("2.40", &jpl(&as_printed, &guess).coords, &truth.coords);
}

/// 000-2.29, 000-2.30, 000-2.31, 002-4, 004-RO.3b, 004-Q.5
#[wasm_bindgen_test(unsupported = test)]
fn small_angle_forms_err_in_the_second_order() {
    let small = |size: f64| delta() * size;
    let quaternion = order(0.1, |size| {
        let approximate = small_angle_quaternion(small(size).into());
        (approximate.coords - half_angle(&small(size)).coords).norm()
    });
    assert_order("[1, δ/2]", quaternion, 2.0);
    let matrix = order(0.1, |size| {
        (small_angle_matrix(small(size).into()) - exponential_matrix(&small(size))).norm()
    });
    assert_order("I + [δ]×", matrix, 2.0);
    for (formula, sign) in [(CosineMatrix::Hamilton, 1.0), (CosineMatrix::Shuster, -1.0)] {
        let cosine_matrix = order(0.1, |size| {
            let exact = formula.of(&half_angle(&small(size))).expect("not zero");
            (exact - small_angle_matrix((small(size) * sign).into())).norm()
        });
        assert_order("C(δq) ≈ I ± [δ]×", cosine_matrix, 2.0);
    }
    let half_angle_exponential = order(0.1, |size| {
        let exact = quatlas::half_angle_exponential(small(size).into()).expect("finite");
        let exact = exact.to_tagged(Convention::HAMILTON).components;
        (exact.coords - Quaternion::from_parts(1.0, small(size)).coords).norm()
    });
    assert_order("exp_q(η) ≈ [1, η]", half_angle_exponential, 2.0);
}

/// 004-Q.5j and the Jacobians of the action of FX-06, by differences of what the body does
#[wasm_bindgen_test(unsupported = test)]
fn the_jacobian_of_the_action_has_the_sign_of_the_matrix() {
    for (v, x) in turns().flat_map(|v| vectors().map(move |x| (v, x))) {
        for convention in MatrixConvention::all() {
            let sign = tau(convention.function, convention.direction);
            for axes in [Perturbation::Local, Perturbation::Global] {
                let got = of_matrix(convention, &v).action_jacobian(x.into(), axes);
                for axis in 0..3 {
                    let change = slope(|size| {
                        let r = turned(&v, &(unit(axis) * size), axes);
                        if sign > 0.0 { r * x } else { r.transpose() * x }
                    });
                    let column = got.column(axis).into_owned();
                    assert_same(&convention.to_string(), &column, &change, SLOPE);
                }
            }
        }
        // "My Lab": the error on the right of the quaternion, its passive matrix R_BW = C_S(q).
        let paired = of_matrix(MatrixConvention::WORLD_TO_BODY, &v);
        let jacobian = paired.action_jacobian(x.into(), Perturbation::Local);
        assert_same("+[Mx]×", &jacobian, &skew(&(paired.entries * x)), CLOSE);
        let of_passive = of_matrix(MatrixConvention::BODY_TO_WORLD, &v);
        let jacobian = of_passive.action_jacobian(x.into(), Perturbation::Local);
        assert_same(
            "−M[x]×",
            &jacobian,
            &-(of_passive.entries * skew(&x)),
            CLOSE,
        );
    }
}

/// FX-06: how the differences of a product and of an inverse change with their factors.
#[wasm_bindgen_test(unsupported = test)]
fn the_jacobians_of_a_product_and_of_an_inverse() {
    let attitude =
        |v: &Vector3<f64>| Rotation::from_rotation_vector_rad((*v).into()).expect("finite");
    for (first, second) in pairs(turns()) {
        let (a, b) = (attitude(&first), attitude(&second));
        let (r_a, r_b) = (exponential_matrix(&first), exponential_matrix(&second));
        for axis in 0..3 {
            let nudged = |rotation: &Rotation, size: f64| {
                let turn = (unit(axis) * size).into();
                rotation
                    .turned_by_rad(turn, RateAxes::Body)
                    .expect("finite")
            };
            let from =
                |before: Rotation, after: Rotation| before.turn_to(&after).rotation_vector_rad();
            let by_first = slope(|size| from(a * b, nudged(&a, size) * b));
            let column = r_b.transpose().column(axis).into_owned();
            assert_same("by A: Bᵀ", &by_first, &column, SLOPE);
            let by_second = slope(|size| from(a * b, a * nudged(&b, size)));
            assert_same("by B: I", &by_second, &unit(axis), SLOPE);
            let by_inverse = slope(|size| from(a.inverse(), nudged(&a, size).inverse()));
            let column = -r_a.column(axis).into_owned();
            assert_same("of Aᵀ: −A", &by_inverse, &column, SLOPE);
        }
    }
}

/// 000-2.33: the derivative of the local perturbation is the rate on the body's axes.
#[wasm_bindgen_test(unsupported = test)]
fn the_rate_is_the_derivative_of_the_perturbation() {
    let rate = Vector3::new(0.11, -0.23, 0.37);
    for v in turns() {
        for convention in [Convention::HAMILTON, Convention::JPL] {
            let before = tagged(convention, &v);
            let got = slope(|time| {
                let now = exponential_matrix(&v) * exponential_matrix(&(rate * time));
                let read = Rotation::nearest_to_matrix(&TaggedMatrix {
                    entries: now,
                    convention: MatrixConvention::BODY_TO_WORLD,
                });
                let now = read.expect("a rotation").rotation.to_tagged(convention);
                now.minus(&before, IncrementSign::Physical)
                    .expect("not zero")
            });
            assert_same("ω_B", &got, &rate, SLOPE);
        }
        let turn = exponential_matrix(&v) * exponential_matrix(&delta()) * exponential_matrix(&-v);
        assert_same(
            "on the world's axes",
            &logarithm(&turn),
            &(exponential_matrix(&v) * delta()),
            1e-13,
        );
    }
}
