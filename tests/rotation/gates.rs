//! The edges of the core's gates: named conventions, what is no rotation, exact scales.

use quatlas::nalgebra::{Matrix3, Vector3};
use quatlas::{
    AxisVector, Convention, EulerSequence, IncrementSign, MatrixConvention, NoNearestRotation,
    NoRotation, NotFinite, Rotation, TaggedMatrix, TaggedQuaternion, right_jacobian,
    right_jacobian_inverse,
};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

/// Half a unit in the last place of 1.
const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// The named conventions of the specification, section 2.5.
#[wasm_bindgen_test(unsupported = test)]
fn every_named_convention_has_its_five_axes() {
    let named = [
        (
            "hamilton",
            Convention::HAMILTON,
            "scalar-first right passive body-to-world local",
        ),
        (
            "eigen",
            Convention::HAMILTON_SCALAR_LAST,
            "scalar-last right passive body-to-world local",
        ),
        (
            "ros",
            Convention::HAMILTON_SCALAR_LAST,
            "scalar-last right passive body-to-world local",
        ),
        (
            "jpl",
            Convention::JPL,
            "scalar-last left passive world-to-body local",
        ),
        (
            "jpl-eq18",
            Convention::JPL_BODY_TO_WORLD,
            "scalar-last left passive body-to-world local",
        ),
        (
            "my-lab",
            Convention::MY_LAB,
            "scalar-first right active world-to-body local",
        ),
    ];
    for (name, convention, words) in named {
        assert_eq!(convention.to_string(), words);
        assert_eq!(name.parse(), Ok(convention));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_not_finite_is_no_rotation() {
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..3 {
            let mut numbers = [0.1, 0.2, 0.3];
            numbers[place] = wrong;
            assert_eq!(Rotation::from_rotation_vector_rad(numbers), Err(NoRotation));
            assert_eq!(Rotation::from_axis_angle(numbers, 1.0), Err(NoRotation));
            let sequence = EulerSequence::AEROSPACE;
            assert_eq!(Rotation::from_euler_rad(sequence, numbers), Err(NoRotation));
            for reading in AxisVector::readings(numbers.into()) {
                assert_eq!(reading.to_rotation(), Err(NoRotation), "{reading:?}");
            }
            let mut rows = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            rows[place][2 - place] = wrong;
            let matrix = TaggedMatrix::from_rows(rows, MatrixConvention::BODY_TO_WORLD);
            let nearest = Rotation::nearest_to_matrix(&matrix);
            assert_eq!(nearest, Err(NoNearestRotation::NotFinite));
        }
        assert_eq!(
            Rotation::from_axis_angle([0.0, 0.0, 1.0], wrong),
            Err(NoRotation)
        );
        let q = TaggedQuaternion::new(1.0, wrong, 0.0, 0.0, Convention::JPL);
        assert_eq!(Rotation::from_tagged(&q), Err(NoRotation));
        assert_eq!(q.normalize(), None);
        let unit = TaggedQuaternion::new(1.0, 0.0, 0.0, 0.0, Convention::JPL);
        let turned = unit.plus([wrong, 0.0, 0.0], IncrementSign::Physical);
        assert_eq!(turned, Err(NoRotation));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn zero_is_no_rotation_and_has_no_inverse() {
    let zero = TaggedQuaternion::new(0.0, 0.0, 0.0, 0.0, Convention::HAMILTON);
    assert_eq!(Rotation::from_tagged(&zero), Err(NoRotation));
    assert_eq!((zero.inverse(), zero.normalize()), (None, None));
    assert_eq!(Rotation::from_axis_angle([0.0; 3], 1.0), Err(NoRotation));
    let still = Rotation::from_rotation_vector_rad([0.0; 3]).expect("no turn");
    assert_eq!(still, Rotation::identity());
}

#[wasm_bindgen_test(unsupported = test)]
fn a_norm_that_is_a_power_of_two_costs_no_digit() {
    let quaternion = |scale: f64| {
        TaggedQuaternion::new(0.6 * scale, 0.0, -0.8 * scale, 0.0, Convention::HAMILTON)
    };
    for exponent in [-900, -3, 0, 1, 40, 900] {
        let scale = 2.0_f64.powi(exponent);
        let q = quaternion(scale);
        assert_eq!(q.normalize(), Some(quaternion(1.0)));
        assert_eq!(q.inverse(), Some(quaternion(1.0 / scale).conjugate()));
        assert_eq!(q.norm(), scale);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn outer_angles_come_above_minus_pi_and_up_to_pi() {
    // Half a turn about z is a yaw of π, never of −π, from either sign of the quaternion.
    for sign in [1.0, -1.0] {
        let q = TaggedQuaternion::new(0.0, 0.0, 0.0, sign, Convention::HAMILTON);
        let half_turn = Rotation::from_tagged(&q).expect("not zero");
        let [yaw, pitch, roll] = half_turn.euler(EulerSequence::AEROSPACE).angles_rad;
        assert_eq!([yaw, pitch.abs(), roll.abs()], [PI, 0.0, 0.0]);
    }
}

/// From no turn to a quarter turn about z: a part t is 90° times t, by the exact cosines.
#[wasm_bindgen_test(unsupported = test)]
fn slerp_goes_on_beyond_its_ends() {
    let quarter = Rotation::from_axis_angle([0.0, 0.0, 1.0], FRAC_PI_2).expect("an axis");
    let half = 0.5_f64.sqrt();
    let expected = [
        (2.0, -1.0, 0.0),
        (-1.0, 0.0, -1.0),
        (1.5, -half, half),
        (-0.5, half, -half),
        (3.0, 0.0, -1.0),
        (4.0, 1.0, 0.0),
    ];
    for (t, cosine, sine) in expected {
        let end = Rotation::identity()
            .slerp(&quarter, t)
            .expect("a part")
            .body_to_world(Vector3::x());
        let off = (end - Vector3::new(cosine, sine, 0.0)).amax();
        assert!(off <= 6.0 * UNIT_ROUNDOFF * t.abs().max(1.0), "{t}: {end}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn slerp_takes_only_finite_parts_and_makes_rotations_of_all() {
    let from = Rotation::from_axis_angle([0.0, 0.0, 1.0], 0.4).expect("an axis");
    let to = Rotation::from_axis_angle([0.0, 1.0, 0.0], 0.8).expect("an axis");
    for t in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(from.slerp(&to, t), Err(NotFinite), "{t}");
    }
    // At the ends the attitudes themselves, and the ways to them have no step.
    for (t, end) in [
        (0.0, from),
        (-5e-324, from),
        (1.0, to),
        (1.0 + f64::EPSILON, to),
    ] {
        let part = from.slerp(&to, t).expect("a part");
        assert!(part.angle_to_rad(&end) < 1e-15, "{t}");
    }
    for t in [1e15, -1e20, f64::MAX, f64::MIN] {
        let array = from
            .slerp(&to, t)
            .expect("a part")
            .to_tagged(Convention::JPL)
            .to_array();
        let norm = array.iter().map(|number| number * number).sum::<f64>();
        assert!((norm - 1.0).abs() < 1e-15, "{t}: {array:?}");
        // No way, however often it is gone.
        assert_eq!(to.slerp(&to, t), Ok(to), "{t}");
    }
}

/// The path beyond the ends has no step in the sign of the quaternion either.
#[wasm_bindgen_test(unsupported = test)]
fn slerp_keeps_its_sign_beyond_the_other_end() {
    let tagged = |w: f64, z: f64| {
        let q = TaggedQuaternion::new(w, 0.0, 0.0, z, Convention::HAMILTON);
        Rotation::from_tagged(&q).expect("not zero")
    };
    // −q of a turn by 2 atan(3/4).
    let (from, to) = (tagged(1.0, 0.0), tagged(-0.8, -0.6));
    for (t, w, z) in [(1.0, 0.8, 0.6), (2.0, 0.28, 0.96), (-1.0, 0.8, -0.6)] {
        let q = from
            .slerp(&to, t)
            .expect("a part")
            .to_tagged(Convention::HAMILTON);
        let off = (q.components.w - w).abs().max((q.components.k - z).abs());
        assert!(off < 1e-15, "{t}: {q:?}");
    }
    // To half a turn the scalar of the way is 0, and the sign of the end stays.
    let (from, to, half) = (tagged(1.0, 0.0), tagged(0.0, -1.0), 0.5_f64.sqrt());
    for (t, w, z) in [(0.5, half, -half), (1.5, -half, -half)] {
        let q = from
            .slerp(&to, t)
            .expect("a part")
            .to_tagged(Convention::HAMILTON);
        let off = (q.components.w - w).abs().max((q.components.k - z).abs());
        assert!(off < 1e-15, "{t}: {q:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_jacobian_has_an_inverse_everywhere_but_at_whole_turns() {
    let along_x = |angle: f64| Vector3::new(angle, 0.0, 0.0);
    for quarter_turns in [1.0, 2.0, 3.0, 5.0, 6.0] {
        let v = along_x(quarter_turns * FRAC_PI_2);
        let inverse = right_jacobian_inverse(&v).expect("no whole turn");
        let product = right_jacobian(&v) * inverse;
        assert!((product - Matrix3::identity()).amax() < 1e-14, "{v}");
    }
    for turns in [1.0, 2.0] {
        let at = turns * TAU;
        assert_eq!(right_jacobian_inverse(&along_x(at)), None);
        assert_eq!(right_jacobian_inverse(&along_x(at + 0.9e-8)), None);
        assert!(right_jacobian_inverse(&along_x(at - 1.1e-8)).is_some());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn jacobians_of_tiny_and_of_long_vectors_are_numbers() {
    for length in [5e-324, 1e-200, 1e-9, 1e9, 1e200, f64::MAX] {
        let v = Vector3::new(length, -length, length);
        let jacobian = right_jacobian(&v);
        assert!(jacobian.iter().all(|entry| entry.is_finite()), "{jacobian}");
        // Along the axis it changes nothing.
        let axis = Vector3::new(1.0, -1.0, 1.0);
        assert!((jacobian * axis - axis).amax() < 1e-15, "{jacobian}");
    }
    assert_eq!(right_jacobian(&Vector3::zeros()), Matrix3::identity());
}
