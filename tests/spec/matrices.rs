//! The specification on rotation matrices, id by id (see `table.md`).

use crate::nearest::nearest;
use crate::reference::{
    CLOSE, assert_same, assert_turn, components, elementary, exponential_matrix, logarithm, matrix,
    matrix_of, pairs, slope, tau, turns, unit, unskew, vectors,
};
use crate::support::{all_conventions, assert_close};
use quatlas::nalgebra::{Matrix3, Quaternion, SMatrix, Vector3};
use quatlas::{
    ComponentSign, Convention, CosineMatrix, Direction, Function, Handedness, MatrixConvention,
    NoNearestRotation, Rotation, TaggedMatrix,
};
use wasm_bindgen_test::wasm_bindgen_test;

fn attitude(v: &Vector3<f64>) -> Rotation {
    Rotation::from_rotation_vector_rad((*v).into()).expect("finite")
}

fn body_to_world(entries: Matrix3<f64>) -> TaggedMatrix {
    TaggedMatrix {
        entries,
        convention: MatrixConvention::BODY_TO_WORLD,
    }
}

/// 000-S1.a, 000-S1.b, 000-1.4, 000-1.8, 003-S2.a, 003-S2.1.b, 003-S2.1.d, 003-S2.1.e, 004-RM.16
#[wasm_bindgen_test(unsupported = test)]
fn a_rotation_keeps_inner_products_cross_products_lengths_and_handedness() {
    for v in turns() {
        let r = attitude(&v).body_to_world_matrix();
        for (a, b) in pairs(vectors()) {
            assert_close("(Ra)·(Rb)", &[(r * a).dot(&(r * b))], &[a.dot(&b)], CLOSE);
            let cross = (r * a).cross(&(r * b));
            assert_same("R(a×b)", &cross, &(r * a.cross(&b)), CLOSE);
            let distance = (r * a - r * b).norm();
            assert_close("distance", &[distance], &[(a - b).norm()], CLOSE);
        }
        assert_same("RRᵀ", &(r * r.transpose()), &Matrix3::identity(), CLOSE);
        assert_same("RᵀR", &(r.transpose() * r), &Matrix3::identity(), CLOSE);
        assert_close("det R", &[r.determinant()], &[1.0], CLOSE);
        let inverse = attitude(&v).inverse().body_to_world_matrix();
        assert_same("R⁻¹", &inverse, &exponential_matrix(&-v), CLOSE);
    }
}

/// 000-1.5, 003-S2.1.a, 004-RM.1, 004-RM.13: the columns of the passive matrix from A to B are the
/// axes of A in coordinates of B. 004-RM.2: the active one from A to B has the axes of B in A.
#[wasm_bindgen_test(unsupported = test)]
fn the_columns_are_the_axes_that_function_and_direction_name() {
    for v in turns() {
        let body_axes_in_world = exponential_matrix(&v);
        let world_axes_in_body = body_axes_in_world.transpose();
        for convention in MatrixConvention::all() {
            let columns = match (convention.function, convention.direction) {
                (Function::Passive, Direction::BodyToWorld) => body_axes_in_world,
                (Function::Passive, Direction::WorldToBody) => world_axes_in_body,
                (Function::Active, Direction::WorldToBody) => body_axes_in_world,
                (Function::Active, Direction::BodyToWorld) => world_axes_in_body,
            };
            let got = attitude(&v).to_tagged_matrix(convention).entries;
            assert_same(&convention.to_string(), &got, &columns, CLOSE);
            let read = nearest(columns, convention);
            assert_same("read", &read.rotation_vector_rad(), &v, 1e-13);
        }
        for x in vectors() {
            let in_world: Vector3<f64> = (0..3).map(|n| body_axes_in_world.column(n) * x[n]).sum();
            assert_same("v_W", &attitude(&v).body_to_world(x), &in_world, CLOSE);
        }
    }
}

/// 004-RM.3, 004-RM.4, 004-RM.5, 003-S3.a, 000-S1.1.1
#[wasm_bindgen_test(unsupported = test)]
fn the_negative_sine_is_below_the_one_for_r_wb_and_above_it_for_r_bw() {
    let angle = 0.6_f64;
    for axis in 0..3 {
        let turn = attitude(&(unit(axis) * angle));
        let (below, above) = ((axis + 1) % 3, (axis + 2) % 3);
        for convention in MatrixConvention::all() {
            let m = turn.to_tagged_matrix(convention).entries;
            let place = if tau(convention.function, convention.direction) > 0.0 {
                (below, above)
            } else {
                (above, below)
            };
            assert_close("the 1", &[m[(axis, axis)]], &[1.0], 0.0);
            assert_close(&convention.to_string(), &[m[place]], &[-angle.sin()], CLOSE);
            let mirrored = m[(place.1, place.0)];
            assert_close(&convention.to_string(), &[mirrored], &[angle.sin()], CLOSE);
        }
        let r = turn.body_to_world_matrix();
        assert_same("elementary", &r, &elementary(axis, angle), CLOSE);
    }
}

/// 004-RM.7, 004-RM.7e, FX-02, FX-03
#[wasm_bindgen_test(unsupported = test)]
fn the_logarithm_of_a_matrix_has_the_sign_of_its_function_and_direction() {
    for v in turns() {
        for convention in MatrixConvention::all() {
            let m = matrix(convention, &v);
            let got = nearest(m, convention).rotation_vector_rad();
            let by_trace = logarithm(&m) * tau(convention.function, convention.direction);
            assert_same(&convention.to_string(), &got, &by_trace, 1e-12);
            assert_same(&convention.to_string(), &got, &v, 1e-13);
        }
        let axis = attitude(&v).axis().expect("a turn");
        assert_same("Ru = u", &(exponential_matrix(&v) * axis), &axis, CLOSE);
    }
    // At half a turn the formula by the trace is 0/0, and with a guard the zero vector.
    let half_turn = Matrix3::from_diagonal(&Vector3::new(-1.0, 1.0, -1.0));
    let v = nearest(half_turn, MatrixConvention::WORLD_TO_BODY).rotation_vector_rad();
    assert_close(
        "π",
        &v.map(f64::abs).data.0[0],
        &[0.0, std::f64::consts::PI, 0.0],
        0.0,
    );
}

/// The four branches with their divisors; g = 1 makes the quaternion of M, g = −1 that of Mᵀ.
fn four_branches(m: &Matrix3<f64>, g: f64) -> (usize, Quaternion<f64>) {
    let (a, b, c) = (m[(0, 0)], m[(1, 1)], m[(2, 2)]);
    let x = g * (m[(2, 1)] - m[(1, 2)]);
    let y = g * (m[(0, 2)] - m[(2, 0)]);
    let z = g * (m[(1, 0)] - m[(0, 1)]);
    let (xy, xz, yz) = (
        m[(1, 0)] + m[(0, 1)],
        m[(2, 0)] + m[(0, 2)],
        m[(2, 1)] + m[(1, 2)],
    );
    let divisor = |square: f64| 2.0 * (1.0 + square).sqrt();
    if a + b + c > 0.0 {
        let s = divisor(a + b + c);
        (0, Quaternion::new(s / 4.0, x / s, y / s, z / s))
    } else if a >= b && a >= c {
        let s = divisor(a - b - c);
        (1, Quaternion::new(x / s, s / 4.0, xy / s, xz / s))
    } else if b >= c {
        let s = divisor(b - a - c);
        (2, Quaternion::new(y / s, xy / s, s / 4.0, yz / s))
    } else {
        let s = divisor(c - a - b);
        (3, Quaternion::new(z / s, xz / s, yz / s, s / 4.0))
    }
}

/// 004-RM.10, 004-RM.12, FX-04: with equal function and direction Right has the differences as they
/// are and Left the reversed ones.
#[wasm_bindgen_test(unsupported = test)]
fn matrix_to_quaternion_has_the_differences_of_its_hand_in_all_four_branches() {
    let mut branches = [false; 4];
    for v in turns() {
        for convention in MatrixConvention::all() {
            let m = matrix(convention, &v);
            for (handedness, g) in [(Handedness::Right, 1.0), (Handedness::Left, -1.0)] {
                let (branch, expected) = four_branches(&m, g);
                branches[branch] = true;
                let q = nearest(m, convention).to_tagged(Convention {
                    handedness,
                    function: convention.function,
                    direction: convention.direction,
                    ..Convention::HAMILTON
                });
                assert_turn(&q.convention.to_string(), &q.components, &expected);
                assert_same("S(q)", &matrix_of(handedness, &expected), &m, CLOSE);
            }
        }
        // "My Lab": the active quaternion of the passive matrix has reversed differences.
        let m = matrix(MatrixConvention::WORLD_TO_BODY, &v);
        let q = nearest(m, MatrixConvention::WORLD_TO_BODY).to_tagged(Convention::MY_LAB);
        assert_turn("My Lab", &q.components, &four_branches(&m, -1.0).1);
    }
    assert_eq!(branches, [true; 4], "every branch is taken");
}

/// MODEL-09, MODEL-17, 000-S2.5
#[wasm_bindgen_test(unsupported = test)]
fn all_pairings_of_a_quaternion_convention_with_a_matrix_convention() {
    for v in turns() {
        for quaternion in all_conventions() {
            let q = components(quaternion, &v);
            for paired in MatrixConvention::all() {
                let what = format!("{quaternion} with {paired}");
                let m = matrix(paired, &v);
                let formula = quaternion.cosine_matrix(paired);
                assert_same(&what, &formula.of(&q).expect("not zero"), &m, CLOSE);
                let other = match formula {
                    CosineMatrix::Hamilton => CosineMatrix::Shuster,
                    CosineMatrix::Shuster => CosineMatrix::Hamilton,
                };
                let other = other.of(&q).expect("not zero");
                assert_same(&what, &other, &m.transpose(), CLOSE);
                let back = nearest(m, paired).to_tagged(quaternion);
                assert_turn(&what, &back.components, &q);

                let is_same = quaternion.function == paired.function
                    && quaternion.direction == paired.direction;
                let by_hand = match quaternion.handedness {
                    Handedness::Right => CosineMatrix::Hamilton,
                    Handedness::Left => CosineMatrix::Shuster,
                };
                assert!(!is_same || formula == by_hand, "{what}");
            }
        }
    }
    let canonical = ComponentSign::Canonical;
    assert_eq!(Convention::MY_LAB.component_sign(), canonical);
}

/// 004-RM.14: the vector is moved by the turn of the world's axes onto the body's, so that it has in
/// the body the coordinates that it had in the world.
#[wasm_bindgen_test(unsupported = test)]
fn an_active_matrix_moves_the_vector_with_the_axes() {
    for (v, x) in turns().flat_map(|v| vectors().map(move |x| (v, x))) {
        let moving = MatrixConvention {
            function: Function::Active,
            direction: Direction::WorldToBody,
        };
        let moved = attitude(&v).to_tagged_matrix(moving).entries * x;
        let seen_from_body = exponential_matrix(&v).transpose() * moved;
        assert_same("moved", &seen_from_body, &x, CLOSE);
        assert_same("by the turn", &moved, &(exponential_matrix(&v) * x), CLOSE);
    }
}

/// 004-RM.15
#[wasm_bindgen_test(unsupported = test)]
fn matrices_of_a_chain_multiply_in_the_order_of_their_operator() {
    for (first, second) in pairs(turns()) {
        let chain = attitude(&first) * attitude(&second);
        for convention in MatrixConvention::all() {
            let (m_wb, m_bc) = (matrix(convention, &first), matrix(convention, &second));
            let expected = if tau(convention.function, convention.direction) > 0.0 {
                m_wb * m_bc
            } else {
                m_bc * m_wb
            };
            let got = chain.to_tagged_matrix(convention).entries;
            assert_same(&convention.to_string(), &got, &expected, CLOSE);
        }
    }
}

/// 004-RM.21, 004-RM.22, 004-D.1, 004-D.2
#[wasm_bindgen_test(unsupported = test)]
fn three_distances_of_attitudes_are_those_of_their_matrices_and_metrics() {
    type Distance = fn(&Rotation, &Rotation) -> f64;
    let distances: [Distance; 3] = [
        Rotation::angle_to_rad,
        Rotation::chordal_distance,
        Rotation::shorter_quaternion_distance,
    ];
    for (v, u) in pairs(turns()).into_iter().filter(|(v, u)| v != u) {
        let (a, b) = (attitude(&v), attitude(&u));
        let (m, n) = (exponential_matrix(&v), exponential_matrix(&u));
        let between = m.transpose() * n;
        let double_sine = unskew(&(between - between.transpose())).norm();
        let angle = double_sine.atan2(between.trace() - 1.0);
        assert_close("geodesic", &[a.angle_to_rad(&b)], &[angle], CLOSE);
        assert_close(
            "chordal",
            &[a.chordal_distance(&b)],
            &[(m - n).norm()],
            CLOSE,
        );
        let by_angle = 2.0 * 2.0_f64.sqrt() * (angle / 2.0).sin();
        assert_close("chordal", &[a.chordal_distance(&b)], &[by_angle], CLOSE);
        for distance in distances {
            assert!(distance(&a, &b) > 0.01, "different");
            assert_close("to itself", &[distance(&a, &a)], &[0.0], 0.0);
            assert_close("symmetric", &[distance(&a, &b)], &[distance(&b, &a)], 1e-15);
            for c in turns().map(|w| attitude(&w)) {
                let detour = distance(&a, &c) + distance(&c, &b);
                assert!(distance(&a, &b) <= detour + CLOSE, "triangle");
            }
        }
    }
}

/// 003-S2.1.c, 003-S5.2.3, FX-07 (5)
#[wasm_bindgen_test(unsupported = test)]
fn what_the_lectures_test_accepts_without_absolute_values_is_no_rotation() {
    let r = exponential_matrix(&Vector3::new(0.4, -0.7, 1.1));
    assert!(body_to_world(r).is_rotation());
    // Entries in single precision are off by 6e-8; those of a length that is off by 1e-6 are none.
    for scale in [1.0 + 3e-7, 1.0 - 3e-7] {
        assert!(body_to_world(r * scale).is_rotation());
    }
    let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, -1.0));
    let equal_columns = Matrix3::from_columns(&[r.column(0), r.column(0), r.column(0)]);
    assert!(
        equal_columns.determinant().abs() < CLOSE,
        "unit columns, determinant 0"
    );
    for m in [
        Matrix3::zeros(),
        r / 2.0,
        r * mirror,
        -r,
        equal_columns,
        r * 1.001,
        r * (1.0 + 6e-7),
        r * (1.0 - 6e-7),
    ] {
        assert!(!body_to_world(m).is_rotation(), "{m}");
    }
    for reflected in [mirror, r * mirror, -r, r * mirror * 1e-100] {
        let nearest = Rotation::nearest_to_matrix(&body_to_world(reflected));
        assert_eq!(nearest, Err(NoNearestRotation::Reflection), "{reflected}");
    }
    let nearest = Rotation::nearest_to_matrix(&body_to_world(equal_columns));
    assert_eq!(nearest, Err(NoNearestRotation::Singular));
    // A part in a million tells the turn about the only long column, whatever its length, and less
    // does not.
    for (second, is_told) in [(0.6e-6, true), (0.4e-6, false)] {
        let flat = Matrix3::from_diagonal(&Vector3::new(1.0, second, 0.0));
        for m in [flat, r * flat, flat * 0.75] {
            let nearest = Rotation::nearest_to_matrix(&body_to_world(m));
            assert_eq!(nearest.is_ok(), is_told, "{m}: {nearest:?}");
        }
    }
}

/// NUM-03: the nearest rotation is the polar factor, the limit of `X ← (X + X⁻ᵀ)/2`.
#[wasm_bindgen_test(unsupported = test)]
fn the_nearest_rotation_is_the_polar_factor() {
    let noise = Matrix3::new(0.02, -0.05, 0.01, 0.03, 0.04, -0.02, -0.06, 0.01, 0.05);
    for v in turns() {
        let noisy = exponential_matrix(&v) + noise;
        let mut polar = noisy;
        for _ in 0..12 {
            polar = (polar + polar.try_inverse().expect("regular").transpose()) / 2.0;
        }
        let nearest = Rotation::nearest_to_matrix(&body_to_world(noisy)).expect("one");
        let r = nearest.rotation.body_to_world_matrix();
        assert_same("polar factor", &r, &polar, CLOSE);
        assert_close(
            "correction",
            &[nearest.correction],
            &[(noisy - polar).norm()],
            CLOSE,
        );
    }
}

/// NUM-02: by the largest component and the arc tangent the logarithm keeps its digits, where the
/// arc cosine of the trace loses them.
#[wasm_bindgen_test(unsupported = test)]
fn the_logarithm_of_a_matrix_keeps_its_digits_at_all_angles() {
    let axis = Vector3::new(0.48, -0.6, 0.64);
    let before_pi = [0.1, 1e-3, 1e-5, 1e-7].map(|rest| std::f64::consts::PI - rest);
    let others = [1e-9, 1e-7, 1e-5, 1e-3, 0.1, 1.0, 2.0];
    for angle in others.into_iter().chain(before_pi) {
        let m = attitude(&(axis * angle)).body_to_world_matrix();
        let error = |v: Vector3<f64>| (v / angle - axis).amax();
        let got = error(nearest(m, MatrixConvention::BODY_TO_WORLD).rotation_vector_rad());
        assert!(got < 1e-15, "{angle}: {got}");
        let by_trace = error(logarithm(&m));
        let keeps = (1e-8..3.1).contains(&angle);
        assert!(
            keeps || by_trace.is_nan() || by_trace > 1e-12,
            "{angle}: {by_trace}"
        );
    }
}

/// 000-S1.3.a, 000-S2.1, 004-RM.24, 004-Q.23: nine and four numbers, three degrees of freedom.
#[wasm_bindgen_test(unsupported = test)]
fn nine_numbers_and_four_numbers_change_in_three_independent_ways() {
    for v in turns() {
        let mut by_matrix = SMatrix::<f64, 9, 3>::zeros();
        let mut by_quaternion = SMatrix::<f64, 4, 3>::zeros();
        for axis in 0..3 {
            let moved = |size: f64| attitude(&v) * attitude(&(unit(axis) * size));
            let nine = |size| {
                let m = moved(size).body_to_world_matrix();
                SMatrix::<f64, 9, 1>::from_column_slice(m.as_slice())
            };
            let four = |size| {
                moved(size)
                    .to_tagged(Convention::HAMILTON)
                    .components
                    .coords
            };
            by_matrix.set_column(axis, &slope(nine));
            by_quaternion.set_column(axis, &slope(four));
        }
        assert_eq!(by_matrix.rank(1e-6), 3);
        assert_eq!(by_quaternion.rank(1e-6), 3);
    }
}
