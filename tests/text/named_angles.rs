//! Angles with the names roll, pitch and yaw, and what words beside them say of their order.

use crate::checked::{check_read, check_refused};
use quatlas::ProblemCode;
use wasm_bindgen_test::wasm_bindgen_test;

/// Roll is about x, pitch about y and yaw about z, whatever the order of the turns.
#[wasm_bindgen_test(unsupported = test)]
fn a_sequence_told_with_its_frame_orders_named_angles() {
    check_read(&[
        (
            "intrinsic xyz: roll=25°, pitch=-35°, yaw=50°",
            "XYZ 25deg -35deg 50deg",
        ),
        (
            "extrinsic zyx roll=25deg pitch=-35deg yaw=50deg",
            "zyx 50deg -35deg 25deg",
        ),
        (
            "moving yxz: yaw=50° pitch=-35° roll=25°",
            "YXZ -35deg 25deg 50deg",
        ),
        (
            "zxy extrinsic: roll=25° pitch=-35° yaw=50°",
            "zxy 50deg 25deg -35deg",
        ),
        (
            "euler_xyz intrinsic roll=25° pitch=-35° yaw=50°",
            "XYZ 25deg -35deg 50deg",
        ),
        ("rxyz roll=0.4 pitch=-0.6 yaw=0.9", "XYZ 0.4 -0.6 0.9"),
        (
            r#"{"order": "YXZ", "frame": "intrinsic", "roll": 0.4, "pitch": -0.6, "yaw": 0.9}"#,
            "YXZ -0.6 0.4 0.9",
        ),
        // These agree with what the names alone mean.
        ("rpy: roll=25° pitch=-35° yaw=50°", "xyz 25deg -35deg 50deg"),
        ("ypr: roll=25° pitch=-35° yaw=50°", "xyz 25deg -35deg 50deg"),
        (
            "extrinsic rpy roll=25° pitch=-35° yaw=50°",
            "xyz 25deg -35deg 50deg",
        ),
        (
            "intrinsic ypr roll=25° pitch=-35° yaw=50°",
            "xyz 25deg -35deg 50deg",
        ),
        ("extrinsic rpy 25deg -35deg 50deg", "xyz 25deg -35deg 50deg"),
        ("moving ypr 50deg -35deg 25deg", "xyz 25deg -35deg 50deg"),
        ("ZYX roll=25° pitch=-35° yaw=50°", "xyz 25deg -35deg 50deg"),
        ("xyz roll=25° pitch=-35° yaw=50°", "xyz 25deg -35deg 50deg"),
        (
            "3-2-1: roll=25° pitch=-35° yaw=50°",
            "xyz 25deg -35deg 50deg",
        ),
        (
            "fixed XYZ: roll=25° pitch=-35° yaw=50°",
            "xyz 25deg -35deg 50deg",
        ),
        (
            r#"{"roll": 0.4, "pitch": -0.6, "yaw": 0.9, "rotation_order": "ZYX"}"#,
            "xyz 0.4 -0.6 0.9",
        ),
        ("angle-axis: angle=25deg, axis=[0, 1, 0]", "25deg about y"),
        // Of an element of URDF without its brackets: the first is a translation.
        (r#"xyz="1 0 0" rpy="0.4 -0.6 0.9""#, "xyz 0.4 -0.6 0.9"),
        // A label that only holds the word of a frame is a label.
        ("fixed: 25deg about y", "25deg about y"),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_sequence_that_named_angles_cannot_have_is_refused() {
    use ProblemCode::{MixedNames, UnknownSequence};
    check_refused(&[
        (
            "XYZ roll=25deg pitch=-35deg yaw=50deg",
            UnknownSequence,
            "XYZ",
            "intrinsic XYZ",
        ),
        (
            "zyx: roll=25° pitch=-35° yaw=50°",
            UnknownSequence,
            "zyx",
            "extrinsic zyx",
        ),
        (
            "1-2-3 roll=25° pitch=-35° yaw=50°",
            UnknownSequence,
            "1-2-3",
            "intrinsic 1-2-3",
        ),
        (
            "euler_xyz: roll=0.4 pitch=-0.6 yaw=0.9",
            UnknownSequence,
            "euler_xyz",
            "extrinsic xyz",
        ),
        (
            "rotation_xyz: roll=0.4 pitch=-0.6 yaw=0.9",
            UnknownSequence,
            "rotation_xyz",
            "xyz",
        ),
        (
            "eulerYXZ: roll=0.4 pitch=-0.6 yaw=0.9",
            UnknownSequence,
            "eulerYXZ",
            "YXZ",
        ),
        (
            "euler_123 = {roll: 1, pitch: 2, yaw: 3}",
            UnknownSequence,
            "euler_123",
            "123",
        ),
        (
            "euler ZXZ roll=25deg pitch=-35deg yaw=50deg",
            UnknownSequence,
            "ZXZ",
            "twice",
        ),
        (
            "intrinsic zyz roll=25deg pitch=-35deg yaw=50deg",
            UnknownSequence,
            "zyz",
            "twice",
        ),
        (
            "fixed roll=0.4 pitch=-0.6 yaw=0.9",
            UnknownSequence,
            "fixed",
            "the order of the axes is missing",
        ),
        (
            "moving: roll=0.4 pitch=-0.6 yaw=0.9",
            UnknownSequence,
            "moving",
            "the order of the axes is missing",
        ),
        (
            r#"{"frame": "extrinsic", "roll": 0.4, "pitch": -0.6, "yaw": 0.9}"#,
            UnknownSequence,
            r#""extrinsic""#,
            "the order of the axes is missing",
        ),
        (
            "intrinsic rpy roll=0.4 pitch=-0.6 yaw=0.9",
            UnknownSequence,
            "intrinsic rpy",
            "intrinsic xyz",
        ),
        (
            "moving rpy 0.4 -0.6 0.9",
            UnknownSequence,
            "moving rpy",
            "intrinsic xyz",
        ),
        (
            "extrinsic ypr 0.9 -0.6 0.4",
            UnknownSequence,
            "extrinsic ypr",
            "extrinsic zyx",
        ),
        (
            r#"{"order": "XYZ", "roll": 0.4, "pitch": -0.6, "yaw": 0.9}"#,
            UnknownSequence,
            r#""order""#,
            "intrinsic XYZ",
        ),
        (
            r#"{"roll": 0.4, "pitch": -0.6, "yaw": 0.9, "eulerOrder": "YXZ"}"#,
            UnknownSequence,
            r#""eulerOrder""#,
            "intrinsic YXZ",
        ),
        (
            "attitude:\n  sequence: xyz\n  roll: 0.4\n  pitch: -0.6\n  yaw: 0.9",
            UnknownSequence,
            "sequence",
            "extrinsic xyz",
        ),
        (
            r#"{"euler": {"order": "XYZ", "roll": 0.4, "pitch": -0.6, "yaw": 0.9}}"#,
            UnknownSequence,
            r#""order""#,
            "intrinsic XYZ",
        ),
        (
            "rpy roll=1 pitch=2 yaw=3, order=ZYX",
            ProblemCode::UnknownComponent,
            "order",
            "unknown argument",
        ),
        (
            "axis-angle roll=0.4 pitch=-0.6 yaw=0.9",
            MixedNames,
            "roll",
            "two descriptions of a rotation are mixed here",
        ),
        (
            "rotvec: roll=0.4 pitch=-0.6 yaw=0.9",
            MixedNames,
            "roll",
            "two descriptions of a rotation are mixed here",
        ),
        (
            "quaternion: roll=0.4 pitch=-0.6 yaw=0.9",
            MixedNames,
            "roll",
            "two descriptions of a rotation are mixed here",
        ),
        (
            "matrix roll=0.4 pitch=-0.6 yaw=0.9",
            MixedNames,
            "roll",
            "two descriptions of a rotation are mixed here",
        ),
        (
            "rpy axis=[0, 0, 1] angle=0.4",
            MixedNames,
            "axis",
            "two descriptions of a rotation are mixed here",
        ),
        (
            "rotvec axis=[0, 0, 1] angle=0.4",
            MixedNames,
            "axis",
            "two descriptions of a rotation are mixed here",
        ),
        (
            "inverse: roll=0.4 pitch=-0.6 yaw=0.9",
            ProblemCode::OtherQuantity,
            "inverse",
            "an inverse",
        ),
        (
            "rate roll=0.4 pitch=-0.6 yaw=0.9",
            ProblemCode::OtherQuantity,
            "rate",
            "a rate",
        ),
        // Two attributes, with and without their element.
        // Two words are no type of the first angle.
        (
            "body rate roll=1 pitch=2 yaw=3",
            ProblemCode::UnknownWord,
            "body",
            "what these numbers are",
        ),
        (
            "roll=0.1, pitch=0.2, yaw=10 deg, unit: rad",
            ProblemCode::MixedUnits,
            "roll=0.1, pitch=0.2, yaw=10 deg, unit: rad",
            "the angles have different units",
        ),
        (
            "rotvec deg R.from_rotvec([0, 0, 1])",
            ProblemCode::MixedUnits,
            "rotvec deg",
            "the angles have different units",
        ),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn words_of_two_descriptions_are_refused_at_the_second() {
    use ProblemCode::{OtherQuantity, UnknownSequence, UnknownWord};
    check_refused(&[
        ("rpy mrp 0.1 0.2 0.3", UnknownWord, "mrp", "mrp is not"),
        (
            "ZYX rotvec 0.1 0.2 0.3",
            UnknownWord,
            "rotvec",
            "is not a known number, unit or function",
        ),
        ("mrp rpy 0.1 0.2 0.3", UnknownWord, "rpy", "rpy is not"),
        ("ypr rpy 0.1 0.2 0.3", UnknownWord, "rpy", "rpy is not"),
        (
            "mrp extrinsic 0.1 0.2 0.3",
            UnknownWord,
            "extrinsic",
            "extrinsic is not",
        ),
        (
            "euler 1-2-2 30 20 10",
            UnknownSequence,
            "1-2-2",
            "one axis twice in a row",
        ),
        ("rotvec ZYX 0.1 0.2 0.3", UnknownWord, "ZYX", "ZYX is not"),
        (
            "rpy euler_zyx 0.1 0.2 0.3",
            UnknownWord,
            "euler_zyx",
            "euler_zyx is not",
        ),
        (
            "inverse:\n  rpy: [0.1, 0.2, 0.3]",
            OtherQuantity,
            "inverse",
            "an inverse",
        ),
        (
            "inverse: ZYX roll=0.4 pitch=-0.6 yaw=0.9",
            OtherQuantity,
            "inverse",
            "an inverse",
        ),
        (
            "rpy rate roll=0.4 pitch=-0.6 yaw=0.9",
            OtherQuantity,
            "rate",
            "a rate",
        ),
        ("imu rate rpy: 0.1 0.2 0.3", OtherQuantity, "rate", "a rate"),
    ]);
    check_read(&[
        ("zyx = 0.4 -0.6 0.9", "zyx 0.4 -0.6 0.9"),
        // A sum with a unit is no sequence.
        ("1-2-3 j", "w=-1, x=0, y=-3, z=0"),
        ("3-2-1 k", "w=1, x=0, y=0, z=-1"),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn brackets_and_marks_around_words_are_not_passed_over() {
    use ProblemCode::{UnclosedBracket, Unexpected, UnknownWord, UnmatchedBracket};
    check_refused(&[
        ("[rpy 0.1 0.2 0.3", UnclosedBracket, "[", "never closed"),
        (
            ")(rpy 0.1 0.2 0.3))",
            UnmatchedBracket,
            ")",
            "without an opening bracket",
        ),
        (
            "(ZYX) rpy [0.1, 0.2, 0.3]",
            UnknownWord,
            "(ZYX)",
            "what these numbers are",
        ),
        (
            "(ZYX) 0.1 0.2 0.3",
            UnknownWord,
            "(ZYX)",
            "what these numbers are",
        ),
        (
            "ZYX, deg) 30 20 10",
            UnmatchedBracket,
            ")",
            "without an opening bracket",
        ),
        ("ZYX (deg, 30 20 10", UnclosedBracket, "(", "never closed"),
        // Only a unit or a sequence stands in brackets behind what they belong to.
        (
            "ZYX (euler) 30 20 10",
            UnknownWord,
            "(euler)",
            "euler is not",
        ),
        (
            "deg rpy 10 20 30",
            UnknownWord,
            "deg",
            "what these numbers are",
        ),
        (": rpy 0.1 0.2 0.3", Unexpected, ":", "unexpected “:”"),
        // An attribute of URDF has an equals sign and quotes, and stands alone or in an element.
        (
            r#"<origin rpy, "0.1 0.2 0.3"/>"#,
            Unexpected,
            ">",
            "unexpected “>”",
        ),
    ]);
}
