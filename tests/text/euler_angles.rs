//! Every form of text of Euler angles, and the sequence and unit that it tells.

use crate::asked::{AS_DEGREES, AS_RADIANS, DEGREES, RADIANS, rotation};
use quatlas::{EulerFrame, EulerSequence, ParsedRotation, UnitSource};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6, PI};
use wasm_bindgen_test::wasm_bindgen_test;

/// 10° and 20° as the nearest doubles.
const TEN: f64 = PI / 18.0;
const TWENTY: f64 = PI / 9.0;

#[track_caller]
fn check_euler(cases: &[(&str, &str, [f64; 3], UnitSource)]) {
    for &(text, sequence, angles_rad, unit) in cases {
        let ParsedRotation::EulerAngles(parsed) = rotation(text) else {
            panic!("{text}: {:?}", rotation(text));
        };
        assert_eq!(parsed.sequence.to_string(), sequence, "{text}");
        assert_eq!(parsed.angles_rad, angles_rad, "{text}");
        assert_eq!(parsed.unit, unit, "{text}");
    }
}

/// Roll, pitch and yaw of 10°, 20° and 30°, and the same as yaw, pitch and roll.
const RPY: [f64; 3] = [TEN, TWENTY, FRAC_PI_6];
const YPR: [f64; 3] = [FRAC_PI_6, TWENTY, TEN];
const SMALL: [f64; 3] = [0.1, 0.2, 0.3];

#[wasm_bindgen_test(unsupported = test)]
fn roll_pitch_and_yaw() {
    check_euler(&[
        ("rpy 10deg 20deg 30deg", "xyz", RPY, DEGREES),
        (r#"rpy="0.1 0.2 0.3""#, "xyz", SMALL, AS_RADIANS),
        (r#"rpy="10 20 30""#, "xyz", [10.0, 20.0, 30.0], AS_RADIANS),
        (
            r#"<origin xyz="1 2 3" rpy="0.1 0.2 0.3"/>"#,
            "xyz",
            SMALL,
            AS_RADIANS,
        ),
        ("rpy=[0.1, 0.2, 0.3]", "xyz", SMALL, AS_RADIANS),
        (r#"{"rpy": [0.1, 0.2, 0.3]}"#, "xyz", SMALL, AS_RADIANS),
        (
            r#"{"rpy": [10, 20, 30], "unit": "deg"}"#,
            "xyz",
            RPY,
            DEGREES,
        ),
        (
            r#"{"unit": "deg", "frame_id": "map", "rpy": [10, 20, 30]}"#,
            "xyz",
            RPY,
            DEGREES,
        ),
        ("rpy (deg): 10, 20, 30", "xyz", RPY, DEGREES),
        ("imu_rpy_deg = [10, 20, 30]", "xyz", RPY, DEGREES),
        ("roll_deg=10 pitch_deg=20 yaw_deg=30", "xyz", RPY, DEGREES),
        ("heading=30 pitch=20 roll=10", "xyz", RPY, AS_DEGREES),
        ("roll pitch yaw 10 20 30", "xyz", RPY, AS_DEGREES),
        ("roll, pitch, yaw = 0.1, 0.2, 0.3", "xyz", SMALL, AS_RADIANS),
        ("ypr 30 20 10", "ZYX", YPR, AS_DEGREES),
        ("yaw-pitch-roll: 30° 20° 10°", "ZYX", YPR, DEGREES),
        ("roll=10deg pitch=20deg yaw=30deg", "xyz", RPY, DEGREES),
        ("yaw 30deg, roll 10deg, pitch 20deg", "xyz", RPY, DEGREES),
        ("roll: 0.1\npitch: 0.2\nyaw: 0.3", "xyz", SMALL, AS_RADIANS),
        (
            "euler:\n  roll: 0.1\n  pitch: 0.2\n  yaw: 0.3",
            "xyz",
            SMALL,
            AS_RADIANS,
        ),
        (
            r#"{"yaw": 0.3, "pitch": 0.2, "roll": 0.1}"#,
            "xyz",
            SMALL,
            AS_RADIANS,
        ),
        ("yaw=30 pitch=20 roll=10 deg", "xyz", RPY, DEGREES),
        (
            "roll = 10 deg, pitch = 20 deg, yaw = 30 deg",
            "xyz",
            RPY,
            DEGREES,
        ),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn euler_angles_by_their_sequence() {
    check_euler(&[
        ("ZYX 30 20 10", "ZYX", YPR, AS_DEGREES),
        ("zyx 30 20 10", "zyx", YPR, AS_DEGREES),
        ("ZYX 0.3 0.2 0.1", "ZYX", [0.3, 0.2, 0.1], AS_RADIANS),
        (
            "ZYX pi/2 -pi/4 1",
            "ZYX",
            [FRAC_PI_2, -FRAC_PI_4, 1.0],
            RADIANS,
        ),
        ("ZYX 3pi 0 -1", "ZYX", [3.0 * PI, 0.0, -1.0], RADIANS),
        ("3-2-1 30deg 20deg 10deg", "ZYX", YPR, DEGREES),
        ("Z-Y-X 30 20 10", "ZYX", YPR, AS_DEGREES),
        ("euler z-y-x 30 20 10", "zyx", YPR, AS_DEGREES),
        ("3-2-1: 30, 20, 10 deg", "ZYX", YPR, DEGREES),
        ("3-2-1, 30, 20, 10", "ZYX", YPR, AS_DEGREES),
        ("3-2-1; 30; 20; 10", "ZYX", YPR, AS_DEGREES),
        ("[3-1-3,30,20,10]", "ZXZ", YPR, AS_DEGREES),
        (
            "3-1-3 -30 20 10",
            "ZXZ",
            [-FRAC_PI_6, TWENTY, TEN],
            AS_DEGREES,
        ),
        ("euler 321 30 20 10", "ZYX", YPR, AS_DEGREES),
        ("euler ZYX 30 20 10", "ZYX", YPR, AS_DEGREES),
        ("Euler angles (ZYX): 30, 20, 10", "ZYX", YPR, AS_DEGREES),
        ("euler: zyx [30, 20, 10]", "zyx", YPR, AS_DEGREES),
        ("ZYX(30, 20, 10)", "ZYX", YPR, AS_DEGREES),
        ("euler_zyx = [30, 20, 10]", "zyx", YPR, AS_DEGREES),
        ("euler_angles_ZYX_deg: 30, 20, 10", "ZYX", YPR, DEGREES),
        ("intrinsic zyx 30 20 10", "ZYX", YPR, AS_DEGREES),
        ("extrinsic ZYX 30 20 10", "zyx", YPR, AS_DEGREES),
        ("ZYX extrinsic 30 20 10", "zyx", YPR, AS_DEGREES),
        ("fixed ZyX 30 20 10", "zyx", YPR, AS_DEGREES),
        ("sxyz 0.1 0.2 0.3", "xyz", SMALL, AS_RADIANS),
        ("rzyx 0.1 0.2 0.3", "ZYX", SMALL, AS_RADIANS),
        ("ZYX 30 20 10 deg", "ZYX", YPR, DEGREES),
        ("ZYX 30 20 10 (deg)", "ZYX", YPR, DEGREES),
        ("ZYX (deg) 30 20 10", "ZYX", YPR, DEGREES),
        ("ZYX [30, 20, 10]°", "ZYX", YPR, DEGREES),
        ("ZYX 30 20 10 rad", "ZYX", [30.0, 20.0, 10.0], RADIANS),
        ("ZYZ 60deg 0 0", "ZYZ", [FRAC_PI_3, 0.0, 0.0], DEGREES),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn all_24_sequences_and_their_frames_in_words() {
    for sequence in EulerSequence::all() {
        let capitals = sequence.to_string().to_ascii_uppercase();
        let word = match sequence.frame {
            EulerFrame::Intrinsic => "intrinsic",
            EulerFrame::Extrinsic => "extrinsic",
        };
        let letter = match sequence.frame {
            EulerFrame::Intrinsic => 'r',
            EulerFrame::Extrinsic => 's',
        };
        let small = capitals.to_ascii_lowercase();
        for text in [
            format!("{sequence} 0.3 0.2 0.1"),
            format!("{word} {capitals} 0.3 0.2 0.1"),
            format!("{word} {small}: 0.3, 0.2, 0.1"),
            format!("{letter}{small} 0.3 0.2 0.1"),
            format!("R.from_euler('{sequence}', [0.3, 0.2, 0.1])"),
        ] {
            let ParsedRotation::EulerAngles(parsed) = rotation(&text) else {
                panic!("{text}");
            };
            assert_eq!(parsed.sequence, sequence, "{text}");
            assert_eq!(parsed.angles_rad, [0.3, 0.2, 0.1], "{text}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn euler_angles_in_a_call() {
    check_euler(&[
        (
            "Rotation.from_euler('ZYX', [30, 20, 10], degrees=True)",
            "ZYX",
            YPR,
            DEGREES,
        ),
        (
            "r = R.from_euler('zyx', [30, 20, 10])",
            "zyx",
            [30.0, 20.0, 10.0],
            AS_RADIANS,
        ),
        (
            "R.from_euler(seq='ZYX', angles=[30, 20, 10], degrees=True)",
            "ZYX",
            YPR,
            DEGREES,
        ),
        ("q.setRPY(0.1, 0.2, 0.3);", "xyz", SMALL, RADIANS),
        ("PyKDL.Rotation.RPY(0.1, 0.2, 0.3)", "xyz", SMALL, RADIANS),
        (
            "quaternion_from_euler(0.1, 0.2, 0.3)",
            "xyz",
            SMALL,
            RADIANS,
        ),
        (
            "tf.transformations.quaternion_from_euler(0.1, 0.2, 0.3, 'rzyx')",
            "ZYX",
            SMALL,
            RADIANS,
        ),
        (
            "quaternion_from_euler(0.1, 0.2, 0.3, axes='szyx')",
            "zyx",
            SMALL,
            RADIANS,
        ),
        (
            "DQuat::from_euler(EulerRot::ZYX, 0.1, 0.2, 0.3)",
            "ZYX",
            SMALL,
            RADIANS,
        ),
        (
            "Quat::from_euler(glam::EulerRot::XYZEx, 0.1, 0.2, 0.3)",
            "xyz",
            SMALL,
            RADIANS,
        ),
        (
            "UnitQuaternion::from_euler_angles(0.1, 0.2, 0.3)",
            "xyz",
            SMALL,
            RADIANS,
        ),
        (
            "p.getQuaternionFromEuler([0.1, 0.2, 0.3])",
            "xyz",
            SMALL,
            RADIANS,
        ),
        ("new THREE.Euler(0.1, 0.2, 0.3)", "XYZ", SMALL, RADIANS),
        // three.js takes the angles in the order x, y, z whatever the sequence is.
        (
            "q.setFromEuler(new THREE.Euler(0.1, 0.2, 0.3, 'ZYX'))",
            "ZYX",
            [0.3, 0.2, 0.1],
            RADIANS,
        ),
    ]);
}
