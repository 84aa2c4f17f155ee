//! The specification on kinematics and integration: the last columns of tables 2.2 and 2.3 (see
//! `table.md`).

use crate::reference::{
    CLOSE, SLOPE, assert_off, assert_order, assert_same, assert_turn, conjugate, eight,
    exponential_matrix, half_angle, hamilton, integrated_entries, jpl, logarithm, matrix, numbers,
    order, pairs, pure, sigma, slope, tau, turns, unskew, vector_part, vectors,
};
use crate::support::all_conventions;
use quatlas::nalgebra::{Matrix3, Matrix4, Quaternion, Vector3, Vector4};
use quatlas::{
    Convention, IntegrationOrder, MatrixConvention, RateAxes, Rotation, Side, TaggedMatrix,
    TaggedQuaternion, action_jacobian,
};
use wasm_bindgen_test::wasm_bindgen_test;

const RATE: [f64; 3] = [0.11, -0.23, 0.37];

fn attitude(v: &Vector3<f64>) -> Rotation {
    Rotation::from_rotation_vector_rad((*v).into()).expect("finite")
}

/// The rate on the given axes, for the rate `RATE` on those of the body.
fn rate_on(axes: RateAxes, v: &Vector3<f64>) -> [f64; 3] {
    match axes {
        RateAxes::Body => RATE,
        RateAxes::World => (exponential_matrix(v) * Vector3::from(RATE)).into(),
    }
}

/// MODEL-08, FX-25, 000-2.34, 000-2.35, 002-16, 002-X
#[wasm_bindgen_test(unsupported = test)]
fn the_derivative_of_a_quaternion_in_all_conventions_and_on_both_axes() {
    for (v, convention) in turns().flat_map(|v| all_conventions().into_iter().map(move |c| (v, c)))
    {
        let now = |time: f64| {
            let turn = half_angle(&(Vector3::from(RATE) * time));
            let turn = if time == 0.0 {
                Quaternion::new(1.0, 0.0, 0.0, 0.0)
            } else {
                turn
            };
            let canonical = hamilton(&half_angle(&v), &turn);
            if sigma(convention) > 0.0 {
                canonical
            } else {
                conjugate(&canonical)
            }
        };
        let tagged = |components| TaggedQuaternion {
            components,
            convention,
        };
        let expected = slope(|time| now(time).coords);
        let array = Vector4::from(tagged(now(0.0)).to_array());
        let expected_array = tagged(Quaternion { coords: expected }).to_array().into();
        for axes in [RateAxes::Body, RateAxes::World] {
            let what = format!("{convention} {axes:?}");
            let rate = rate_on(axes, &v);
            let derivative = tagged(now(0.0)).derivative(rate, axes);
            assert_same(&what, &derivative.coords, &expected, SLOPE);
            let by_matrix = convention.rate_matrix(rate, axes) * array / 2.0;
            assert_same(&what, &by_matrix, &expected_array, SLOPE);
            let is_plus = tau(convention.function, convention.direction) > 0.0;
            let is_right = is_plus == (axes == RateAxes::Body);
            assert_eq!(
                convention.rate_side(axes) == Side::Right,
                is_right,
                "{what}"
            );
        }
    }
}

/// 000-2.36, 002-9, 002-10, 002-17, 002-X: the printed entries. With Hamilton's Ω the product is
/// q⊙(0, ω); q⊗[ω; 0], as printed, is off. The JPL quaternion of eq. 18 has −½ q⊗[ω; 0].
#[wasm_bindgen_test(unsupported = test)]
fn the_rate_matrices_have_the_printed_entries() {
    let [x, y, z] = RATE;
    let omega = Vector3::from(RATE);
    let hamilton_first = Matrix4::new(
        0.0, -x, -y, -z, //
        x, 0.0, z, -y, //
        y, -z, 0.0, x, //
        z, y, -x, 0.0,
    );
    let jpl_last = Matrix4::new(
        0.0, z, -y, x, //
        -z, 0.0, x, y, //
        y, -x, 0.0, z, //
        -x, -y, -z, 0.0,
    );
    let of_hamilton = Convention::HAMILTON.rate_matrix(RATE, RateAxes::Body);
    let of_jpl = Convention::JPL.rate_matrix(RATE, RateAxes::Body);
    assert_eq!(of_hamilton, hamilton_first);
    assert_eq!(of_jpl, jpl_last);
    for q in numbers() {
        let product = |convention: Convention| {
            let array = TaggedQuaternion {
                components: q,
                convention,
            };
            let product =
                convention.rate_matrix(RATE, RateAxes::Body) * Vector4::from(array.to_array());
            TaggedQuaternion::from_array(product.into(), convention)
                .components
                .coords
        };
        let rate = pure(&omega);
        let right = product(Convention::HAMILTON);
        assert_same("q⊙(0, ω)", &right, &hamilton(&q, &rate).coords, CLOSE);
        assert_same(
            "[ω; 0]⊗q",
            &product(Convention::JPL),
            &jpl(&rate, &q).coords,
            CLOSE,
        );
        let of_eq_18 = product(Convention::JPL_BODY_TO_WORLD);
        assert_same("−q⊗[ω; 0]", &of_eq_18, &-jpl(&q, &rate).coords, CLOSE);
        if vector_part(&q).cross(&omega).norm() > 0.2 {
            assert_off("eq. 9 as printed", &jpl(&q, &rate).coords, &right);
            assert_off("eq. 16 for eq. 18", &jpl(&rate, &q).coords, &of_eq_18);
        }
    }
}

/// 000-1.9, 000-1.10, 000-1.11, 000-2.37, FX-06 and the last column of table 2.3
#[wasm_bindgen_test(unsupported = test)]
fn the_derivative_of_a_matrix_on_both_axes() {
    for v in turns() {
        let body_to_world =
            |time: f64| exponential_matrix(&v) * exponential_matrix(&(Vector3::from(RATE) * time));
        for convention in MatrixConvention::all() {
            let is_plus = tau(convention.function, convention.direction) > 0.0;
            let expected = slope(|time| {
                let r = body_to_world(time);
                if is_plus { r } else { r.transpose() }
            });
            let tagged = TaggedMatrix {
                entries: matrix(convention, &v),
                convention,
            };
            for axes in [RateAxes::Body, RateAxes::World] {
                let got = tagged.derivative(rate_on(axes, &v), axes);
                assert_same(&format!("{convention} {axes:?}"), &got, &expected, SLOPE);
            }
        }
        let tagged = attitude(&v).to_tagged_matrix(MatrixConvention::BODY_TO_WORLD);
        let spin = tagged.derivative(RATE, RateAxes::Body) * tagged.entries.transpose();
        assert_same("skew", &spin, &-spin.transpose(), CLOSE);
        let on_world = rate_on(RateAxes::World, &v).into();
        assert_same("ṘRᵀ = [ω_W]×", &unskew(&spin), &on_world, CLOSE);
    }
}

/// 000-1.12: a constant rate is one turn, in one step of the first order.
#[wasm_bindgen_test(unsupported = test)]
fn a_constant_rate_is_integrated_without_error() {
    let (rate, step) = (Vector3::new(0.9, -1.4, 0.6), 1.3);
    for v in turns() {
        let by_step = |axes, order| {
            let end = attitude(&v).step(|_| rate, axes, 0.2, step, order);
            end.expect("finite").body_to_world_matrix()
        };
        let turn = exponential_matrix(&(rate * step));
        use IntegrationOrder::{First, Fourth, Second};
        for order in [First, Second, Fourth] {
            let on_body = exponential_matrix(&v) * turn;
            assert_same(
                "R Exp(hω_B)",
                &by_step(RateAxes::Body, order),
                &on_body,
                CLOSE,
            );
            let on_world = turn * exponential_matrix(&v);
            assert_same(
                "Exp(hω_W) R",
                &by_step(RateAxes::World, order),
                &on_world,
                CLOSE,
            );
        }
    }
}

/// A rate whose direction changes.
fn changing_rate(time: f64) -> Vector3<f64> {
    Vector3::new(
        (1.7 * time).cos(),
        0.8 * (2.3 * time).sin(),
        0.5 + time * time,
    )
}

/// The attitude after a unit of time by 4000 Runge-Kutta steps on the nine entries.
fn fine_reference(start: &Vector3<f64>, axes: RateAxes) -> Matrix3<f64> {
    integrated_entries(exponential_matrix(start), changing_rate, axes, 1.0, 4000)
}

/// FX-06, FX-25: the orders 1, 2 and 4 of the step, on the body's axes and on the world's.
#[wasm_bindgen_test(unsupported = test)]
fn the_steps_have_the_orders_1_2_and_4() {
    let start = Vector3::new(0.4, -0.7, 1.1);
    for axes in [RateAxes::Body, RateAxes::World] {
        let expected = fine_reference(&start, axes);
        let error = |integration: IntegrationOrder| {
            move |step: f64| {
                let mut now = attitude(&start);
                let steps = (1.0 / step).round();
                let mut n = 0.0;
                while n < steps {
                    let next = now.step(changing_rate, axes, n * step, step, integration);
                    now = next.expect("finite");
                    n += 1.0;
                }
                (now.body_to_world_matrix() - expected).norm()
            }
        };
        assert_order(
            "first",
            order(1.0 / 64.0, error(IntegrationOrder::First)),
            1.0,
        );
        assert_order(
            "second",
            order(1.0 / 64.0, error(IntegrationOrder::Second)),
            2.0,
        );
        assert_order(
            "fourth",
            order(1.0 / 16.0, error(IntegrationOrder::Fourth)),
            4.0,
        );
    }
}

/// FX-25: Runge-Kutta on the four components with the derivative, then normalised, has order 4 in
/// each of the eight, on both axes.
#[wasm_bindgen_test(unsupported = test)]
fn runge_kutta_on_the_components_has_order_4() {
    let start = Vector3::new(0.4, -0.7, 1.1);
    for axes in [RateAxes::Body, RateAxes::World] {
        let expected = fine_reference(&start, axes);
        for convention in eight() {
            let error = |h: f64| {
                // Of no particular norm: the first step brings it to 1.
                let mut q = attitude(&start).to_tagged(convention);
                q.components *= 0.3;
                let mut time = 0.0;
                while time < 1.0 - h / 2.0 {
                    q = q
                        .runge_kutta_step(changing_rate, axes, time, h)
                        .expect("finite");
                    time += h;
                }
                assert!((q.norm() - 1.0).abs() < 1e-15, "{convention}");
                let end = Rotation::from_tagged(&q).expect("not zero");
                (end.body_to_world_matrix() - expected).norm()
            };
            let what = format!("{convention} {axes:?}");
            assert!(error(1.0 / 32.0) < 1e-5, "{what}: it goes there");
            assert_order(&what, order(1.0 / 32.0, error), 4.0);
        }
    }
}

/// FX-06, FX-25: the rate from two samples is that of the middle, to second order, and the whole turn.
#[wasm_bindgen_test(unsupported = test)]
fn the_rate_from_samples_is_of_second_order_in_the_middle() {
    let accelerated = |time: f64| {
        exponential_matrix(&Vector3::new(0.3, -0.5, 0.2))
            * exponential_matrix(&Vector3::new(
                0.5 * time + 0.4 * time.powi(3),
                0.3 * time.powi(2),
                -0.8 * time + time.powi(3),
            ))
    };
    let read = |entries| {
        Rotation::nearest_to_matrix(&TaggedMatrix {
            entries,
            convention: MatrixConvention::BODY_TO_WORLD,
        })
        .expect("a rotation")
        .rotation
    };
    let middle = 0.6;
    let derivative = slope(|time| accelerated(middle + time));
    let now = accelerated(middle);
    for (axes, spin) in [
        (RateAxes::Body, now.transpose() * derivative),
        (RateAxes::World, derivative * now.transpose()),
    ] {
        let error = |step: f64| {
            let (early, late) = (
                accelerated(middle - step / 2.0),
                accelerated(middle + step / 2.0),
            );
            (read(early).rate_to(&read(late), axes, step) - unskew(&spin)).norm()
        };
        assert_order("rate", order(0.1, error), 2.0);
        assert!(error(0.01) < 1e-4, "{axes:?}");
    }
}

/// FX-25: the change of q⊙x⊙q* with the components, for every norm.
#[wasm_bindgen_test(unsupported = test)]
fn the_jacobian_of_the_double_product_by_components() {
    for (q, x) in numbers().flat_map(|q| vectors().map(move |x| (q, x))) {
        let jacobian = action_jacobian(&q, &x);
        for (column, place) in [(0, 3), (1, 0), (2, 1), (3, 2)] {
            let change = slope(|size| {
                let mut near = q;
                near.coords[place] += size;
                vector_part(&hamilton(&hamilton(&near, &pure(&x)), &conjugate(&near)))
            });
            assert_same(
                "∂(q⊙x⊙q*)",
                &jacobian.column(column).into_owned(),
                &change,
                SLOPE,
            );
        }
    }
}

/// Slerp is the turn at constant speed about one axis, and the same path in every convention.
#[wasm_bindgen_test(unsupported = test)]
fn slerp_takes_one_path_in_all_conventions() {
    for (v, u) in pairs(turns()).into_iter().filter(|(v, u)| v != u) {
        let (a, b) = (exponential_matrix(&v), exponential_matrix(&u));
        let between = logarithm(&(a.transpose() * b));
        if between.norm() > 3.0 {
            continue;
        }
        for t in [0.25, 0.5, 0.9] {
            let part = attitude(&v).slerp(&attitude(&u), t).expect("a part");
            let expected = a * exponential_matrix(&(between * t));
            assert_same(
                "R_A Exp(t Log)",
                &part.body_to_world_matrix(),
                &expected,
                1e-12,
            );
            for convention in eight() {
                let [p, q] =
                    [v, u].map(|turn| attitude(&turn).to_tagged(convention).components.coords);
                let q = if p.dot(&q) < 0.0 { -q } else { q };
                let angle = p.dot(&q).acos();
                let sum = p * ((1.0 - t) * angle).sin() + q * (t * angle).sin();
                let path = Quaternion {
                    coords: sum / angle.sin(),
                };
                let got = part.to_tagged(convention).components;
                assert_turn(&convention.to_string(), &got, &path);
            }
        }
    }
}

/// The mean is the polar factor of the sum of the matrices.
#[wasm_bindgen_test(unsupported = test)]
fn the_mean_is_the_polar_factor_of_the_sum() {
    let near = [[0.4, -0.7, 1.1], [-0.6, 0.25, 0.9], [0.2, -0.1, 0.7]].map(Vector3::from);
    let rotations = near.map(|v| attitude(&v));
    let mut polar: Matrix3<f64> = near.iter().map(exponential_matrix).sum();
    for _ in 0..20 {
        polar = (polar + polar.try_inverse().expect("regular").transpose()) / 2.0;
    }
    let mean = Rotation::mean(&rotations).expect("one mean");
    assert_same("mean", &mean.body_to_world_matrix(), &polar, CLOSE);
}
