//! Where nalgebra is not used, and the case for each: its result is wrong, ours is right.
//!
//! A test that fails because nalgebra has become right is good news: use nalgebra then.

use crate::nearest::nearest;
use quatlas::nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};
use quatlas::{Convention, EulerSequence, MatrixConvention, Rotation, TaggedQuaternion};
use std::f64::consts::{FRAC_PI_2, PI};
use wasm_bindgen_test::wasm_bindgen_test;

fn rotation(w: f64, x: f64, y: f64, z: f64) -> Rotation {
    let q = TaggedQuaternion::new(w, x, y, z, Convention::HAMILTON);
    Rotation::from_tagged(&q).expect("not zero")
}

#[wasm_bindgen_test(unsupported = test)]
fn half_a_turn_about_an_oblique_axis_is_read_from_its_matrix() {
    // A case of `vectors/accuracy.json`, group "half turn".
    let half_turn = Matrix3::new(
        -0.808_198_207_595_688_8,
        -0.529_102_176_476_385_5,
        -0.258_585_661_023_707_4,
        -0.529_102_176_476_385_5,
        0.459_575_062_582_969_3,
        0.713_331_373_696_553_3,
        -0.258_585_661_023_707_4,
        0.713_331_373_696_553_3,
        -0.651_376_854_987_280_4,
    );
    let theirs = UnitQuaternion::from_matrix(&half_turn);
    assert_eq!(theirs, UnitQuaternion::identity());
    let turned = nearest(half_turn, MatrixConvention::BODY_TO_WORLD).body_to_world_matrix();
    assert!((turned - half_turn).amax() < 4e-16);
}

#[wasm_bindgen_test(unsupported = test)]
fn half_a_turn_has_a_rotation_vector() {
    // About (1, 1, 0)/√2.
    let half_turn = Matrix3::new(0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0);
    let theirs = Rotation3::from_matrix_unchecked(half_turn).scaled_axis();
    assert_eq!(theirs, Vector3::zeros());
    let ours = nearest(half_turn, MatrixConvention::BODY_TO_WORLD).rotation_vector_rad();
    let component = PI * 0.5_f64.sqrt();
    assert!((ours - Vector3::new(component, component, 0.0)).amax() < 1e-15);
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
fn proper_euler_sequences_have_angles() {
    let attitude = Rotation3::from_euler_angles(0.3, 0.4, 0.5);
    let theirs = std::panic::catch_unwind(|| {
        let axes = [Vector3::z_axis(), Vector3::y_axis(), Vector3::z_axis()];
        attitude.euler_angles_ordered(axes, false)
    });
    assert!(theirs.is_err(), "nalgebra panics");
    let sequence: EulerSequence = "ZYZ".parse().expect("a sequence");
    let angles = nearest(*attitude.matrix(), MatrixConvention::BODY_TO_WORLD)
        .euler(sequence)
        .angles_rad;
    let turn =
        |axis: quatlas::nalgebra::UnitVector3<f64>, angle| Rotation3::from_axis_angle(&axis, angle);
    let [a, b, c] = angles;
    let again =
        turn(Vector3::z_axis(), a) * turn(Vector3::y_axis(), b) * turn(Vector3::z_axis(), c);
    assert!((again.matrix() - attitude.matrix()).amax() < 1e-15);
}

#[wasm_bindgen_test(unsupported = test)]
fn euler_angles_near_gimbal_lock_describe_the_attitude() {
    let sequence = EulerSequence::AEROSPACE;
    let angles = [0.3, FRAC_PI_2 - 1e-9, 0.2];
    let attitude = Rotation::from_euler_rad(sequence, angles).expect("finite");
    let axes = [Vector3::z_axis(), Vector3::y_axis(), Vector3::x_axis()];
    let matrix = Rotation3::from_matrix_unchecked(attitude.body_to_world_matrix());
    let distance = |angles: [f64; 3]| {
        let again = Rotation::from_euler_rad(sequence, angles).expect("numbers");
        again.angle_to_rad(&attitude)
    };
    let (theirs, _) = matrix.euler_angles_ordered(axes, false);
    assert!(distance(theirs) > 1e-9, "{theirs:?}");
    assert!(distance(attitude.euler(sequence).angles_rad) < 2e-15);
}

#[wasm_bindgen_test(unsupported = test)]
fn slerp_between_near_attitudes_moves() {
    // A case of `vectors/accuracy.json`, group "small angle": 9e-9 rad apart.
    let a = Quaternion::new(
        -0.403_845_252_992_709,
        0.061_711_873_816_834_045,
        0.912_108_396_924_103_1,
        0.034_043_039_315_148_74,
    );
    let b = Quaternion::new(
        -0.403_845_249_029_018_47,
        0.061_711_876_047_890_63,
        0.912_108_398_575_116_7,
        0.034_043_038_055_903_946,
    );
    let t = 0.386_839_606_368_101_66;
    let theirs = UnitQuaternion::from_quaternion(a).slerp(&UnitQuaternion::from_quaternion(b), t);
    let moved = |q: &Quaternion<f64>| (q - a).norm() / ((b - a).norm() * t);
    assert!(moved(&theirs) < 1e-6, "nalgebra stays where it is");
    let ours = rotation(a.w, a.i, a.j, a.k).slerp(&rotation(b.w, b.i, b.j, b.k), t);
    let ours = ours
        .expect("a part")
        .to_tagged(Convention::HAMILTON)
        .components;
    assert!((moved(&ours) - 1.0).abs() < 1e-7, "{}", moved(&ours));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_angle_between_neighbours_is_not_lost() {
    let next = rotation(1.0, 1e-9, 0.0, 0.0);
    let matrices = [Rotation::identity(), next]
        .map(|rotation| Rotation3::from_matrix_unchecked(rotation.body_to_world_matrix()));
    let theirs = matrices[0].angle_to(&matrices[1]);
    assert!((theirs / 2e-9 - 1.0).abs() > 0.1, "{theirs}");
    let ours = Rotation::identity().angle_to_rad(&next);
    assert!((ours / 2e-9 - 1.0).abs() < 1e-15, "{ours}");
}

#[wasm_bindgen_test(unsupported = test)]
fn tiny_rotation_vectors_and_tiny_quaternions_are_kept() {
    let tiny = Vector3::new(0.0, 1e-16, 0.0);
    assert_eq!(UnitQuaternion::from_scaled_axis(tiny).j, 0.0);
    let kept = Rotation::from_rotation_vector_rad(tiny.into()).expect("finite");
    assert_eq!(kept.rotation_vector_rad(), tiny);

    let small: Quaternion<f64> = Quaternion::new(0.0, 3e-200, 4e-200, 0.0);
    assert!(!small.normalize().i.is_finite());
    let unit = rotation(0.0, 3e-200, 4e-200, 0.0).to_tagged(Convention::HAMILTON);
    assert_eq!(unit.to_array(), [0.0, 0.6, 0.8, 0.0]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_quarter_turn_has_an_exact_matrix() {
    let half = 0.5_f64.sqrt();
    let quarter = UnitQuaternion::new_unchecked(Quaternion::new(half, half, 0.0, 0.0));
    assert_eq!(
        quarter.to_rotation_matrix()[(2, 1)],
        1.000_000_000_000_000_2
    );
    let matrix = rotation(half, half, 0.0, 0.0).body_to_world_matrix();
    assert_eq!(
        matrix,
        Matrix3::new(1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0)
    );
}
