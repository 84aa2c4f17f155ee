//! The specification on Euler angles in all 24 sequences, id by id (see `table.md`).

use crate::nearest::nearest;
use crate::reference::{
    self, CLOSE, assert_off, assert_same, assert_turn, elementary, exponential_matrix, half_angle,
    hamilton, logarithm, sigma, slope, tau, turns, unit, unskew,
};
use crate::support::{all_conventions, assert_close};
use quatlas::nalgebra::Matrix3;
use quatlas::{
    Convention, EulerFrame, EulerSequence, MatrixConvention, Rotation, Survivor, TaggedQuaternion,
};
use std::f64::consts::{FRAC_PI_2, PI};
use wasm_bindgen_test::wasm_bindgen_test;

/// Angles within the range of the middle one for both kinds of sequences.
const ANGLES: [[f64; 3]; 4] = [
    [0.7, 0.4, 1.1],
    [-2.1, 1.3, 0.2],
    [3.0, 0.9, -1.7],
    [-0.3, 0.05, -3.1],
];

fn fixed(name: &str) -> EulerSequence {
    name.parse().expect("a sequence")
}

/// The places of the turns from the one that is applied last on fixed axes.
fn places(sequence: EulerSequence) -> [usize; 3] {
    match sequence.frame {
        EulerFrame::Intrinsic => [0, 1, 2],
        EulerFrame::Extrinsic => [2, 1, 0],
    }
}

fn axes(sequence: EulerSequence) -> [usize; 3] {
    sequence.axes.axes().map(|axis| axis.index())
}

/// `R_WB` by elementary turns: intrinsic `R_i R_j R_k`, extrinsic `R_k R_j R_i`.
fn product(sequence: EulerSequence, angles: [f64; 3]) -> Matrix3<f64> {
    let [a, b, c] = places(sequence).map(|place| elementary(axes(sequence)[place], angles[place]));
    a * b * c
}

fn attitude(sequence: EulerSequence, angles: [f64; 3]) -> Rotation {
    Rotation::from_euler_rad(sequence, angles).expect("finite")
}

fn every() -> impl Iterator<Item = (EulerSequence, [f64; 3])> {
    EulerSequence::all().flat_map(|sequence| ANGLES.map(|angles| (sequence, angles)))
}

/// FX-09, 004-EU.1, 004-EU.2, 004-EU.5, 004-EU.7, 003-S3.c, 003-S3.d
#[wasm_bindgen_test(unsupported = test)]
fn every_sequence_is_the_product_of_its_elementary_turns() {
    for (sequence, angles) in every() {
        let got = attitude(sequence, angles);
        let what = sequence.to_string();
        assert_same(
            &what,
            &got.body_to_world_matrix(),
            &product(sequence, angles),
            CLOSE,
        );
        let [a, b, c] = places(sequence)
            .map(|place| half_angle(&(unit(axes(sequence)[place]) * angles[place])));
        let q = hamilton(&hamilton(&a, &b), &c);
        assert_turn(&what, &got.to_tagged(Convention::HAMILTON).components, &q);
    }
    let [roll, pitch, yaw] = [0.3, -0.4, 0.9];
    let r = elementary(2, yaw) * elementary(1, pitch) * elementary(0, roll);
    let fixed = attitude(EulerSequence::ROLL_PITCH_YAW, [roll, pitch, yaw]);
    let moving = attitude(EulerSequence::AEROSPACE, [yaw, pitch, roll]);
    assert_same("fixed XYZ", &fixed.body_to_world_matrix(), &r, CLOSE);
    assert_same("relative ZYX", &moving.body_to_world_matrix(), &r, CLOSE);
}

/// FX-09: the four components of 3-2-1, k = 1 for successive and −1 for fixed axes, with σ.
#[wasm_bindgen_test(unsupported = test)]
fn the_components_of_yaw_pitch_and_roll_by_half_angles() {
    for ([psi, theta, phi], convention) in ANGLES
        .into_iter()
        .flat_map(|a| all_conventions().into_iter().map(move |c| (a, c)))
    {
        for (name, k) in [("ZYX", 1.0), ("zyx", -1.0)] {
            let ((s_psi, c_psi), (s_theta, c_theta), (s_phi, c_phi)) = (
                (psi / 2.0).sin_cos(),
                (theta / 2.0).sin_cos(),
                (phi / 2.0).sin_cos(),
            );
            let w = c_phi * c_theta * c_psi + k * s_phi * s_theta * s_psi;
            let x = s_phi * c_theta * c_psi - k * c_phi * s_theta * s_psi;
            let y = c_phi * s_theta * c_psi + k * s_phi * c_theta * s_psi;
            let z = c_phi * c_theta * s_psi - k * s_phi * s_theta * c_psi;
            let [x, y, z] = [x, y, z].map(|number| number * sigma(convention));
            let expected = TaggedQuaternion::new(w, x, y, z, convention);
            let got = attitude(fixed(name), [psi, theta, phi]).to_tagged(convention);
            assert_turn(name, &got.components, &expected.components);
        }
    }
}

/// 004-EU.0, 004-EU.3, 004-EU.4: the angles describe the turn from world to body; only the matrix that
/// is made of them is transposed.
#[wasm_bindgen_test(unsupported = test)]
fn function_and_direction_change_the_matrix_and_not_the_angles() {
    for (sequence, angles) in every() {
        for convention in MatrixConvention::all() {
            let factors = places(sequence).map(|place| {
                let turn = elementary(axes(sequence)[place], angles[place]);
                (turn, turn.transpose())
            });
            let [(a, a_t), (b, b_t), (c, c_t)] = factors;
            let expected = if tau(convention.function, convention.direction) > 0.0 {
                a * b * c
            } else {
                c_t * b_t * a_t
            };
            let got = attitude(sequence, angles)
                .to_tagged_matrix(convention)
                .entries;
            assert_same(&format!("{sequence} {convention}"), &got, &expected, CLOSE);
            let back = nearest(expected, convention).euler(sequence).angles_rad;
            let angles = within_range(sequence, angles);
            assert_close(&format!("{sequence} {convention}"), &back, &angles, 1e-13);
        }
    }
}

/// The same attitude with the middle angle in its range; the angles of this file are.
fn within_range(sequence: EulerSequence, angles: [f64; 3]) -> [f64; 3] {
    let least = if sequence.is_proper() {
        0.0
    } else {
        -FRAC_PI_2
    };
    assert!(angles[1] > least && angles[1] < FRAC_PI_2 && angles.iter().all(|a| a.abs() <= PI));
    angles
}

/// 004-EU.6: on the moving axes the second turn is A⁻¹QA, and both make A(A⁻¹QA) = QA.
#[wasm_bindgen_test(unsupported = test)]
fn the_second_turn_on_moving_axes_is_the_fixed_one_seen_from_there() {
    let (alpha, beta) = (0.7, -0.4);
    let on_fixed = attitude(fixed("zyx"), [alpha, beta, 0.0]).body_to_world_matrix();
    let (a, q) = (elementary(2, alpha), elementary(1, beta));
    assert_same("QA", &on_fixed, &(q * a), CLOSE);
    assert_same("A(A⁻¹QA)", &on_fixed, &(a * (a.transpose() * q * a)), CLOSE);
    let composite = q * a;
    let as_printed = a * (a.transpose() * composite * a);
    assert_off("with the composite in both places", &as_printed, &on_fixed);
}

/// FX-01: the printed quotients for 3-2-1, and their canonical triple.
#[wasm_bindgen_test(unsupported = test)]
fn the_angles_of_a_matrix_by_the_printed_formulas() {
    for v in turns() {
        let t = exponential_matrix(&v);
        let at = |row: usize, column: usize| t[(row - 1, column - 1)];
        let successive = [
            at(2, 1).atan2(at(1, 1)),
            (-at(3, 1)).atan2(at(1, 1).hypot(at(2, 1))),
            at(3, 2).atan2(at(3, 3)),
        ];
        let on_fixed = [
            (-at(1, 2)).atan2(at(1, 1)),
            at(1, 3).atan2(at(1, 1).hypot(at(1, 2))),
            (-at(2, 3)).atan2(at(3, 3)),
        ];
        let rotation = nearest(t, MatrixConvention::BODY_TO_WORLD);
        let got = rotation.euler(EulerSequence::AEROSPACE);
        assert_close("3-2-1 successive", &got.angles_rad, &successive, 1e-13);
        let got = rotation.euler(fixed("zyx"));
        assert_close("3-2-1 fixed", &got.angles_rad, &on_fixed, 1e-13);
        let sine = at(1, 3).hypot(at(2, 3));
        let proper = [
            at(2, 3).atan2(at(1, 3)),
            sine.atan2(at(3, 3)),
            at(3, 2).atan2(-at(3, 1)),
        ];
        assert_close(
            "3-2-3",
            &rotation.euler(fixed("ZYZ")).angles_rad,
            &proper,
            1e-12,
        );
        let proper = [
            at(1, 3).atan2(-at(2, 3)),
            sine.atan2(at(3, 3)),
            at(3, 1).atan2(at(3, 2)),
        ];
        assert_close(
            "3-1-3",
            &rotation.euler(fixed("ZXZ")).angles_rad,
            &proper,
            1e-12,
        );
    }
}

/// FX-08, FX-14, FX-21
#[wasm_bindgen_test(unsupported = test)]
fn angles_to_and_from_the_rotation_vector_and_the_components() {
    for (sequence, angles) in every() {
        let v = attitude(sequence, angles).rotation_vector_rad();
        let expected = logarithm(&product(sequence, angles));
        assert_same(&sequence.to_string(), &v, &expected, 1e-12);
    }
    for v in turns() {
        let u = v.normalize();
        let (s, c) = v.norm().sin_cos();
        let expected = [
            (u.x * u.y * (1.0 - c) + u.z * s).atan2(c + u.x * u.x * (1.0 - c)),
            (u.y * s - u.x * u.z * (1.0 - c)).asin(),
            (u.y * u.z * (1.0 - c) + u.x * s).atan2(c + u.z * u.z * (1.0 - c)),
        ];
        let rotation = Rotation::from_rotation_vector_rad(v.into()).expect("finite");
        let got = rotation.euler(EulerSequence::AEROSPACE).angles_rad;
        assert_close("of the vector", &got, &expected, 1e-12);
        for convention in all_conventions() {
            let q = reference::components(convention, &v);
            let (w, x, y, z) = (q.w * sigma(convention), q.i, q.j, q.k);
            let level = 1.0 - 2.0 * (y * y + z * z);
            let ahead = 2.0 * (w * z + x * y);
            let expected = [
                ahead.atan2(level),
                (2.0 * (w * y - x * z)).atan2(level.hypot(ahead)),
                (2.0 * (w * x + y * z)).atan2(1.0 - 2.0 * (x * x + y * y)),
            ];
            let tagged = TaggedQuaternion {
                components: q,
                convention,
            };
            let got = Rotation::from_tagged(&tagged).expect("not zero");
            let got = got.euler(EulerSequence::AEROSPACE).angles_rad;
            assert_close("of the components", &got, &expected, 1e-12);
        }
    }
}

/// 004-EU.12, 003-S4.3.b, FX-01, FX-21: at the lock a sum or difference of the outer angles is all that
/// the attitude has. It is told which, and its value; the canonical triple is the same attitude.
#[wasm_bindgen_test(unsupported = test)]
fn gimbal_lock_is_named_and_resolved_in_all_24_sequences() {
    for sequence in EulerSequence::all() {
        for middle in sequence.locks_rad() {
            let [first, third] = [0.9, -0.3];
            let r = product(sequence, [first, middle, third]);
            let moved = |sign: f64| product(sequence, [first + 0.4, middle, third + sign * 0.4]);
            let (survivor, value) = if (moved(1.0) - r).amax() < CLOSE {
                (Survivor::Difference, first - third)
            } else {
                assert_same("the sum survives", &moved(-1.0), &r, CLOSE);
                (Survivor::Sum, first + third)
            };
            let what = format!("{sequence} at {middle}");
            let euler = attitude(sequence, [first, middle, third]).euler(sequence);
            let lock = euler
                .gimbal_lock
                .unwrap_or_else(|| panic!("{what} is locked"));
            assert_eq!(lock.survivor, survivor, "{what}");
            assert_close(&what, &[lock.survivor_rad], &[value], CLOSE);
            assert!(lock.distance_rad < 1e-15, "{what}: {lock:?}");
            // The third angle of successive axes is 0, the first of fixed ones.
            let zero = match sequence.frame {
                EulerFrame::Intrinsic => 2,
                EulerFrame::Extrinsic => 0,
            };
            assert_eq!(lock.canonical_rad[zero], 0.0, "{what}");
            assert_same(&what, &product(sequence, lock.canonical_rad), &r, CLOSE);
            assert_same(&what, &product(sequence, euler.angles_rad), &r, CLOSE);

            let apart = [first, middle + 1e-3, third];
            assert_eq!(
                attitude(sequence, apart).euler(sequence).gimbal_lock,
                None,
                "{what}"
            );
        }
    }
    // FX-21: ψ = ∓2 atan2(σx, w) at θ = ±π/2.
    for (sign, convention) in [1.0, -1.0]
        .into_iter()
        .flat_map(|s| all_conventions().into_iter().map(move |c| (s, c)))
    {
        let locked = attitude(EulerSequence::AEROSPACE, [0.3, sign * FRAC_PI_2, 1.0]);
        let q = locked.to_tagged(convention).components;
        let psi = -sign * 2.0 * (sigma(convention) * q.i).atan2(q.w);
        let canonical = locked
            .euler(EulerSequence::AEROSPACE)
            .gimbal_lock
            .expect("locked");
        assert_close("ψ", &[canonical.canonical_rad[0]], &[psi], CLOSE);
    }
}

/// 004-EU.10
#[wasm_bindgen_test(unsupported = test)]
fn angles_neither_add_nor_negate() {
    for sequence in EulerSequence::all() {
        let [a, b] = [[0.7, 0.4, 1.1], [0.5, 0.8, -0.6]];
        let both = attitude(sequence, a) * attitude(sequence, b);
        let sum: Vec<f64> = a.iter().zip(b).map(|(a, b)| a + b).collect();
        let added = product(sequence, [sum[0], sum[1], sum[2]]);
        assert_off("added", &added, &both.body_to_world_matrix());
        let by_matrix = product(sequence, a) * product(sequence, b);
        assert_same(
            "by matrices",
            &both.body_to_world_matrix(),
            &by_matrix,
            CLOSE,
        );
        let negated = product(sequence, a.map(|angle| -angle));
        assert_off("negated", &negated, &product(sequence, a).transpose());
    }
}

/// 003-S3.b, 004-T1n: of 27 strings 12 are sequences, each about moving or fixed axes; in the others
/// an axis follows itself and the turns reach fewer than three dimensions.
#[wasm_bindgen_test(unsupported = test)]
fn twelve_of_27_strings_are_sequences() {
    let mut ranks = [0; 4];
    for number in 0..27 {
        let places = [number / 9, number / 3 % 3, number % 3];
        let rates = |time: f64, place: usize| {
            let turns =
                [0, 1, 2].map(|n| elementary(places[n], 0.4 + if n == place { time } else { 0.0 }));
            turns[0] * turns[1] * turns[2]
        };
        let columns = [0, 1, 2].map(|place| {
            unskew(&(rates(0.0, place).transpose() * slope(|time| rates(time, place))))
        });
        let rank = Matrix3::from_columns(&columns).rank(1e-6);
        ranks[rank] += 1;
        for names in ["XYZ", "xyz"] {
            let name: String = places.iter().map(|&place| &names[place..=place]).collect();
            assert_eq!(name.parse::<EulerSequence>().is_ok(), rank == 3, "{name}");
        }
    }
    assert_eq!(ranks, [0, 3, 12, 12]);
    assert_eq!(
        "xzz"
            .parse::<EulerSequence>()
            .map_err(|unknown| unknown.to_string()),
        Err(
            "\"xzz\" is no Euler sequence: three axes, none after itself, as in ZYX or xyz"
                .to_owned()
        )
    );
}
