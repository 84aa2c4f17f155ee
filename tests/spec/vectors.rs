//! The specification on rotation vectors, axis and angle, id by id (see `table.md`).

use crate::reference::{
    self, CLOSE, SLOPE, assert_off, assert_order, assert_same, exponential_matrix,
    integrated_entries, logarithm, order, pairs, sigma, skew, slope, tau, turns, unskew, vectors,
};
use crate::support::{all_conventions, assert_close};
use quatlas::nalgebra::{Matrix3, Vector3};
use quatlas::{
    ComponentOrder, Direction, Function, Handedness, MatrixConvention, NoStep, RateAxes, Rotation,
    TaggedQuaternion, compose_rotation_vectors, half_angle_exponential, left_jacobian,
    left_jacobian_inverse, right_jacobian, right_jacobian_inverse,
    rotation_vector_runge_kutta_step,
};
use std::f64::consts::{PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

fn attitude(v: &Vector3<f64>) -> Rotation {
    Rotation::from_rotation_vector_rad((*v).into()).expect("finite")
}

fn matrix(v: &Vector3<f64>) -> Matrix3<f64> {
    attitude(v).body_to_world_matrix()
}

/// 000-1.6, 000-Fig2, 000-1.13, 000-1.14, 000-1.15, 003-S4.2.h, 003-S5.2.8, 003-S5.2.4, 004-RO.3a
#[wasm_bindgen_test(unsupported = test)]
fn the_exponential_is_the_matrix_of_axis_and_angle() {
    for v in turns() {
        let (angle, u) = (v.norm(), v.normalize());
        let (s, c) = angle.sin_cos();
        let k = skew(&u);
        let by_skew = Matrix3::identity() + k * s + k * k * (1.0 - c);
        let by_outer = Matrix3::from_diagonal_element(c) + k * s + u * u.transpose() * (1.0 - c);
        let elements = Matrix3::from_fn(|row, column| {
            let diagonal = if row == column { c } else { 0.0 };
            diagonal + u[row] * u[column] * (1.0 - c) + k[(row, column)] * s
        });
        let by_axis = Rotation::from_axis_angle((u * 3.0).into(), angle).expect("an axis");
        for got in [matrix(&v), by_axis.body_to_world_matrix()] {
            assert_same("exp [v]×", &got, &exponential_matrix(&v), CLOSE);
            assert_same("I + s K + (1−c) K²", &got, &by_skew, CLOSE);
            assert_same("c I + s K + (1−c) u uᵀ", &got, &by_outer, CLOSE);
            assert_same("nine elements", &got, &elements, CLOSE);
            assert_close("det", &[got.determinant()], &[1.0], CLOSE);
        }
        // Onto: the logarithm finds a vector of at most π.
        let long = v * 5.0;
        let shorter = attitude(&long).rotation_vector_rad();
        assert!(shorter.norm() <= PI);
        assert_same(
            "exp log",
            &exponential_matrix(&shorter),
            &exponential_matrix(&long),
            1e-12,
        );
    }
}

/// 000-1.1, 000-1.2, 000-1.3, 000-S1.1.2
#[wasm_bindgen_test(unsupported = test)]
fn a_vector_is_turned_by_the_formulas_of_rodrigues_and_linearly() {
    for v in turns() {
        let (angle, u) = (v.norm(), v.normalize());
        let (s, c) = angle.sin_cos();
        for (x, y) in pairs(vectors()) {
            let along = u * u.dot(&x);
            let split = along + (x - along) * c + u.cross(&x) * s;
            let formula = x * c + u.cross(&x) * s + u * (u.dot(&x) * (1.0 - c));
            let got = attitude(&v).body_to_world(x);
            assert_same("split", &got, &split, CLOSE);
            assert_same("in vectors", &got, &formula, CLOSE);
            let sum = attitude(&v).body_to_world(x * 2.5 - y * 0.7);
            let images = got * 2.5 - attitude(&v).body_to_world(y) * 0.7;
            assert_same("linear", &sum, &images, CLOSE);
            // Only the end counts, not the path: in ten parts, or by way of Euler angles.
            let tenth = attitude(&(v / 10.0));
            let by_parts = (0..10).fold(Rotation::identity(), |turn, _| turn * tenth);
            assert_same("in ten parts", &by_parts.body_to_world(x), &got, CLOSE);
        }
    }
}

/// 000-S1.1.3, 000-S1.3.1, 004-RO.14
#[wasm_bindgen_test(unsupported = test)]
fn many_axes_and_angles_are_one_attitude() {
    for v in turns() {
        let (angle, u) = (v.norm(), v.normalize());
        for (axis, angle) in [
            (u, angle + TAU),
            (u, angle - 3.0 * TAU),
            (-u, -angle),
            (-u, TAU - angle),
        ] {
            let turn = Rotation::from_axis_angle(axis.into(), angle).expect("an axis");
            assert_same(
                "axis",
                &turn.body_to_world_matrix(),
                &exponential_matrix(&v),
                CLOSE,
            );
            assert_same(
                "vector",
                &matrix(&(axis * angle)),
                &exponential_matrix(&v),
                CLOSE,
            );
        }
    }
}

/// 003-S4.t, 004-RO.1, 004-RO.2, 004-RM.7e: one axis, with the same components in both frames.
#[wasm_bindgen_test(unsupported = test)]
fn every_attitude_is_one_turn_about_an_axis_that_both_frames_share() {
    for (first, second) in pairs(turns()) {
        let turn = attitude(&first) * attitude(&second);
        let r = exponential_matrix(&first) * exponential_matrix(&second);
        let axis = turn.axis().expect("a turn");
        assert_same("Ru = u", &(r * axis), &axis, CLOSE);
        assert_same("u = Rᵀu", &turn.world_to_body(axis), &axis, CLOSE);
        let again = Rotation::from_axis_angle((axis * 0.2).into(), turn.angle_rad());
        let again = again.expect("an axis");
        assert_same("θ u/|u|", &again.body_to_world_matrix(), &r, CLOSE);
        assert_same(
            "θ u",
            &turn.rotation_vector_rad(),
            &(axis * turn.angle_rad()),
            CLOSE,
        );
    }
}

/// FX-12, FX-13: cos θ I ∓ sin θ [u]× + (1 − cos θ) u uᵀ, and to first order I ∓ [θu]×.
#[wasm_bindgen_test(unsupported = test)]
fn the_matrix_of_a_rotation_vector_in_each_function_and_direction() {
    for v in turns() {
        let (angle, u) = (v.norm(), v.normalize());
        let (s, c) = angle.sin_cos();
        for convention in MatrixConvention::all() {
            let sign = tau(convention.function, convention.direction);
            let even = Matrix3::from_diagonal_element(c) + u * u.transpose() * (1.0 - c);
            let got = attitude(&v).to_tagged_matrix(convention).entries;
            let expected = even + skew(&u) * (s * sign);
            assert_same(&convention.to_string(), &got, &expected, CLOSE);
            let error = |size: f64| {
                let exact = attitude(&(u * size)).to_tagged_matrix(convention).entries;
                (exact - Matrix3::identity() - skew(&u) * (size * sign)).norm()
            };
            assert_order("I ± [θu]×", order(0.01, error), 2.0);
        }
    }
}

/// 004-RO.7, FX-15, FX-16: cos(θ/2) and ± sin(θ/2) u for all 32, by the signs of the text.
#[wasm_bindgen_test(unsupported = test)]
fn the_quaternion_of_a_rotation_vector_in_each_convention() {
    for (v, convention) in turns().flat_map(|v| all_conventions().into_iter().map(move |c| (v, c)))
    {
        use Direction::{BodyToWorld, WorldToBody};
        use Function::{Active, Passive};
        let of_right = match (convention.function, convention.direction) {
            (Passive, BodyToWorld) | (Active, WorldToBody) => 1.0,
            (Passive, WorldToBody) | (Active, BodyToWorld) => -1.0,
        };
        let sign = match convention.handedness {
            Handedness::Right => of_right,
            Handedness::Left => -of_right,
        };
        let (sine, w) = (v.norm() / 2.0).sin_cos();
        let [x, y, z]: [f64; 3] = (v.normalize() * (sine * sign)).into();
        let expected = match convention.order {
            ComponentOrder::ScalarFirst => [w, x, y, z],
            ComponentOrder::ScalarLast => [x, y, z, w],
        };
        let got = attitude(&v).to_tagged(convention).to_array();
        assert_close(&convention.to_string(), &got, &expected, CLOSE);
    }
}

/// FX-22: `θu = σ 2 atan2(n, w)/n q_v` with w ≥ 0, near 0 too.
#[wasm_bindgen_test(unsupported = test)]
fn the_rotation_vector_of_a_quaternion_in_each_convention() {
    let tiny = [1e-5, 1e-9, 1e-150].map(|size| Vector3::new(0.6, 0.0, -0.8) * size);
    for v in turns().chain(tiny) {
        for convention in all_conventions() {
            for sign in [1.0, -1.0] {
                let components = reference::components(convention, &v) * (sign * 0.8);
                let q = TaggedQuaternion {
                    components,
                    convention,
                };
                let positive = components * components.w.signum();
                let vector = reference::vector_part(&positive);
                let n = vector.norm();
                let formula = vector * (sigma(convention) * 2.0 * n.atan2(positive.w) / n);
                let got = Rotation::from_tagged(&q)
                    .expect("not zero")
                    .rotation_vector_rad();
                let scale = v.norm();
                assert_same(&convention.to_string(), &(got / scale), &(v / scale), CLOSE);
                if n > 1e-100 {
                    assert_same("formula", &(got / scale), &(formula / scale), CLOSE);
                }
            }
        }
    }
}

/// FX-17, 004-RO.13: rotation vectors compose by their half angles, and do not add.
#[wasm_bindgen_test(unsupported = test)]
fn rotation_vectors_compose_and_do_not_add() {
    for (a, b) in pairs(turns()) {
        let (alpha, beta) = (a.norm() / 2.0, b.norm() / 2.0);
        let (u, v) = (a.normalize(), b.normalize());
        let w = alpha.cos() * beta.cos() - alpha.sin() * beta.sin() * u.dot(&v);
        let p = u * (alpha.sin() * beta.cos())
            + v * (alpha.cos() * beta.sin())
            + u.cross(&v) * (alpha.sin() * beta.sin());
        let (w, p) = if w < 0.0 { (-w, -p) } else { (w, p) };
        let expected = p * (2.0 * p.norm().atan2(w) / p.norm());
        let got = compose_rotation_vectors(a.into(), b.into()).expect("finite");
        let product = exponential_matrix(&a) * exponential_matrix(&b);
        assert_same("half angles", &got, &expected, CLOSE);
        assert_same("Exp", &exponential_matrix(&got), &product, 1e-13);
    }
    let [a, b] = [[0.4, -0.7, 1.1], [-0.6, 0.25, 0.9]].map(Vector3::from);
    let product = exponential_matrix(&a) * exponential_matrix(&b);
    assert_off("Exp(a + b)", &exponential_matrix(&(a + b)), &product);
    let remainder = |size: f64| {
        let (a, b) = (a * size, b * size);
        let series =
            a + b + a.cross(&b) / 2.0 + (a.cross(&a.cross(&b)) + b.cross(&b.cross(&a))) / 12.0;
        let exact = compose_rotation_vectors(a.into(), b.into()).expect("finite");
        (exact - series).norm()
    };
    assert_order("series", order(0.1, remainder), 4.0);
}

/// 004-RO.11
#[wasm_bindgen_test(unsupported = test)]
fn the_inverse_turn_has_the_opposite_vector() {
    for v in turns() {
        let inverse = attitude(&v).inverse();
        assert_same("−θu", &inverse.rotation_vector_rad(), &-v, CLOSE);
        let transpose = exponential_matrix(&v).transpose();
        assert_same("Exp(−v)", &matrix(&-v), &transpose, CLOSE);
    }
}

/// FX-18: `ω_B = J_r v̇` and `ω_W = J_l v̇`, by differences, and their inverses; NUM-01: at all angles.
#[wasm_bindgen_test(unsupported = test)]
fn the_jacobians_of_the_exponential() {
    let change = Vector3::new(0.3, -0.2, 0.5);
    for v in turns() {
        let derivative = slope(|time| exponential_matrix(&(v + change * time)));
        let r = exponential_matrix(&v);
        let on_body = unskew(&(r.transpose() * derivative));
        let on_world = unskew(&(derivative * r.transpose()));
        assert_same("J_r v̇", &(right_jacobian(&v) * change), &on_body, SLOPE);
        assert_same("J_l v̇", &(left_jacobian(&v) * change), &on_world, SLOPE);
        let right = right_jacobian_inverse(&v).expect("not a whole turn");
        let left = left_jacobian_inverse(&v).expect("not a whole turn");
        assert_same("J_r⁻¹ ω_B", &(right * on_body), &change, SLOPE);
        assert_same("J_l⁻¹ ω_W", &(left * on_world), &change, SLOPE);
        assert_same(
            "J_l = J_rᵀ",
            &left_jacobian(&v),
            &right_jacobian(&v).transpose(),
            1e-15,
        );
        let after = slope(|size| logarithm(&(r * exponential_matrix(&(change * size)))));
        assert_same("Log(Exp(v)Exp(δ))", &after, &(right * change), 1e-8);
        let before = slope(|size| logarithm(&(exponential_matrix(&(change * size)) * r)));
        assert_same("Log(Exp(δ)Exp(v))", &before, &(left * change), 1e-8);
    }
    let axis = Vector3::new(0.48, -0.6, 0.64);
    for angle in [
        1e-12, 1e-8, 1e-4, 0.1, 0.499_999, 0.5, 1.0, 3.0, PI, 5.0, 6.2,
    ] {
        let v = axis * angle;
        let inverse = right_jacobian_inverse(&v).expect("not a whole turn");
        // Near 2π the inverse is large.
        let tolerance = CLOSE * inverse.norm();
        let product = right_jacobian(&v) * inverse;
        assert_same("J J⁻¹", &product, &Matrix3::identity(), tolerance);
    }
}

/// 004-EU.13, FX-18: at a whole turn the Jacobian keeps one direction of three, and has no inverse.
#[wasm_bindgen_test(unsupported = test)]
fn at_a_whole_turn_the_jacobian_has_rank_1() {
    for v in turns() {
        let whole = v.normalize() * TAU;
        assert_eq!(right_jacobian(&whole).rank(1e-9), 1);
        assert_eq!(right_jacobian(&(whole * 0.9)).rank(1e-9), 3);
        assert_eq!(right_jacobian_inverse(&whole), None);
        assert_eq!(left_jacobian_inverse(&(whole * -3.0)), None);
    }
}

/// FX-18: Runge-Kutta on the vector, brought back below π after each step, has order 4 on both axes.
#[wasm_bindgen_test(unsupported = test)]
fn the_rotation_vector_is_integrated_with_order_4() {
    let rate = |time: f64| Vector3::new(1.1 * (1.7 * time).cos(), 0.8 * (2.3 * time).sin(), 2.0);
    let start = Vector3::new(0.4, -0.7, 1.1);
    for axes in [RateAxes::Body, RateAxes::World] {
        let integrate = |steps: u32| {
            let h = 2.0 / f64::from(steps);
            let (mut v, mut wraps) = (start, 0);
            for n in 0..steps {
                let next = rotation_vector_runge_kutta_step(v, rate, axes, f64::from(n) * h, h)
                    .expect("below a whole turn");
                assert!(next.norm() <= PI + 1e-15);
                wraps += i32::from(next.dot(&v) < 0.0);
                v = next;
            }
            (exponential_matrix(&v), wraps)
        };
        // Fine steps on the nine entries.
        let r = integrated_entries(exponential_matrix(&start), rate, axes, 2.0, 8000);
        let error = |steps: u32| (integrate(steps).0 - r).norm();
        assert!(integrate(64).1 > 0, "π is passed");
        assert!(error(64) < 1e-4, "it goes there");
        assert_order("RK4", (error(64) / error(128)).log2(), 4.0);
    }
}

/// FX-18: vectors longer than half a turn are brought back first, a step through a whole turn is
/// refused, and so are numbers that are not finite.
#[wasm_bindgen_test(unsupported = test)]
fn a_rotation_vector_of_whole_turns_takes_no_step_through_them() {
    let (axis, still) = (Vector3::new(0.48, -0.6, 0.64), |_time: f64| {
        Vector3::zeros()
    });
    let step = |v, rate: &dyn Fn(f64) -> Vector3<f64>| {
        rotation_vector_runge_kutta_step(v, rate, RateAxes::Body, 0.0, 1.0)
    };
    for (angle, shortest) in [
        (PI, PI),
        (4.0, 4.0 - TAU),
        (TAU, 0.0),
        (15.0, 15.0 - 2.0 * TAU),
    ] {
        let end = step(axis * angle, &still).expect("no whole turn is near");
        assert_same("shortest", &end, &(axis * shortest), 1e-14);
    }
    let whole = |_time: f64| axis * TAU;
    let refused = step(axis * 0.0, &|time| {
        whole(time) * if time < 0.6 { 1.0 } else { 0.0 }
    });
    assert_eq!(refused, Err(NoStep::Singular));
    assert_eq!(step(axis * f64::INFINITY, &still), Err(NoStep::NotFinite));
    assert_eq!(step(axis, &|_| axis * f64::NAN), Err(NoStep::NotFinite));
}

/// 002-3: the exponential of the pure quaternion η is the turn by 2η, and at η = 0 no quotient 0/0.
#[wasm_bindgen_test(unsupported = test)]
fn the_half_angle_exponential_turns_by_twice_the_vector() {
    for v in turns() {
        let q = half_angle_exponential(v.into()).expect("finite");
        assert_same(
            "Exp(2η)",
            &q.body_to_world_matrix(),
            &exponential_matrix(&(v * 2.0)),
            CLOSE,
        );
        if v.norm() > 0.1 {
            assert_off("Exp(η)", &exponential_matrix(&v), &q.body_to_world_matrix());
        }
    }
    let none = half_angle_exponential([0.0; 3]).expect("finite");
    assert_eq!(none, Rotation::identity());
}
