//! Axes by their names, and by the old ones.

use crate::support::assert_close;
use quatlas::nalgebra::{Matrix3, Vector3};
use quatlas::{
    AxesChange, AxesHand, AxisMapping, Convention, MatrixConvention, OneSidedReflection, Rotation,
    UnknownAxes,
};
use wasm_bindgen_test::wasm_bindgen_test;

fn mapping(text: &str) -> Result<String, String> {
    let read: Result<AxisMapping, UnknownAxes> = text.parse();
    read.map(|mapping| mapping.to_string())
        .map_err(|unknown| unknown.message)
}

/// Where x, y and z point, in forward, left, up: written down here by hand, from what each says of itself.
const NAMED: [(&str, [[f64; 3]; 3]); 8] = [
    ("ROS", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
    ("PX4", [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]]),
    (
        "aerospace",
        [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]],
    ),
    (
        "Unreal",
        [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]],
    ),
    (
        "Unity",
        [[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]],
    ),
    (
        "OpenGL",
        [[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]],
    ),
    (
        "Godot",
        [[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]],
    ),
    (
        "OpenCV",
        [[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]],
    ),
];

/// By an arrow that each system names.
#[wasm_bindgen_test(unsupported = test)]
fn every_named_system_names_the_same_arrow() {
    // Forward, left, up.
    let arrow = Vector3::new(1.0, 2.0, 3.0);
    let seen = |axes: [[f64; 3]; 3]| Matrix3::from(axes).transpose() * arrow;
    for (from, old) in NAMED {
        for (to, new) in NAMED {
            let text = format!("{from} to {to}");
            let mapping: AxisMapping = text.parse().expect(&text);
            let got = mapping.matrix() * seen(old);
            assert_close(&text, got.as_slice(), seen(new).as_slice(), 0.0);
        }
    }
}

/// As the bridges between them write it.
#[wasm_bindgen_test(unsupported = test)]
fn well_known_pairs() {
    for (text, expected) in [
        ("PX4 to ROS", "x -y -z"),
        ("aerospace to ROS", "x -y -z"),
        ("ROS to PX4", "x -y -z"),
        ("FRD to FLU", "x -y -z"),
        ("NED to ENU", "y x -z"),
        ("ENU \u{2192} NED", "y x -z"),
        ("Unreal -> ROS", "x -y z"),
        ("ROS to Unity", "-y z x"),
        ("Unity to ROS", "z -x y"),
        ("OpenCV to OpenGL", "x -y -z"),
        ("OpenCV to ROS", "z -x -y"),
        ("Godot to OpenGL", "x y z"),
        ("Unreal to Unity", "y z x"),
        ("NWU to ENU", "-y x z"),
        ("SEU to NED", "-x y -z"),
        ("BLD to FRU", "-x -y -z"),
    ] {
        assert_eq!(mapping(text).as_deref(), Ok(expected), "{text}");
    }
    let left: AxisMapping = "Unreal to ROS".parse().expect("both are known");
    assert_eq!(left.hand(), AxesHand::Changed);
}

#[wasm_bindgen_test(unsupported = test)]
fn new_axes_in_terms_of_the_old() {
    for (text, expected) in [
        ("y x -z", "y x -z"),
        ("[+y, +x, \u{2212}z]", "y x -z"),
        ("(-Z; X; Y)", "-z x y"),
        ("zx-y", "z x -y"),
        ("", "x y z"),
        ("none", "x y z"),
        (" Same ", "x y z"),
    ] {
        assert_eq!(mapping(text).as_deref(), Ok(expected), "{text}");
    }
    for text in [
        "y x", "y x z x", "y x z-", "--x y z", "x.y.z", "no", "a b c",
    ] {
        let unknown = text.parse::<AxisMapping>().expect_err(text);
        assert_eq!(
            unknown.to_string(),
            "this is not a mapping of axes",
            "{text}"
        );
    }
}

/// All 48 signed permutations, as text and as matrix.
fn signed_permutations() -> Vec<(String, Matrix3<f64>)> {
    let mut all = Vec::new();
    for order in [
        [0, 1, 2],
        [1, 2, 0],
        [2, 0, 1],
        [0, 2, 1],
        [2, 1, 0],
        [1, 0, 2],
    ] {
        for bits in 0..8 {
            let is_against = |new: usize| bits >> new & 1 == 1;
            let name = |new: usize| {
                let sign = if is_against(new) { "-" } else { "" };
                format!("{sign}{}", ["x", "y", "z"][order[new]])
            };
            let matrix = Matrix3::from_fn(|new, old| match (order[new] == old, is_against(new)) {
                (true, false) => 1.0,
                (true, true) => -1.0,
                _ => 0.0,
            });
            all.push(([0, 1, 2].map(name).join(" "), matrix));
        }
    }
    all
}

/// `A_W R_WB A_Bᵀ` without a rounding, for all pairs; of q and −q the one whose first component that is
/// not 0 is positive.
#[wasm_bindgen_test(unsupported = test)]
fn new_axes_turn_the_attitude_exactly() {
    let all = signed_permutations();
    let mapping = |text: &str| text.parse::<AxisMapping>().expect(text);
    let (mut turns, mut reflections) = (0, 0);
    for (world, a_w) in &all {
        for (body, a_b) in &all {
            let change = AxesChange {
                world: mapping(world),
                body: mapping(body),
            };
            let expected = a_w * a_b.transpose();
            let Ok(rotation) = change.apply(&Rotation::identity()) else {
                assert_eq!(expected.determinant(), -1.0, "{world}, {body}");
                reflections += 1;
                continue;
            };
            let got = rotation.to_tagged_matrix(MatrixConvention::BODY_TO_WORLD);
            assert_eq!(got.entries, expected, "{world}, {body}");
            turns += 1;
            if change.body == AxisMapping::NONE {
                let q = rotation.to_tagged(Convention::HAMILTON).to_array();
                let first = q.into_iter().find(|&number| number != 0.0);
                assert!(first > Some(0.0), "{world}: {q:?}");
            }
        }
    }
    assert_eq!((turns, reflections), (1152, 1152));
    assert_eq!(
        OneSidedReflection.to_string(),
        "only one side changes handedness: a reflection, which has no quaternion"
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn an_old_axis_stands_once() {
    let lost = Err("one axis appears twice, so another one is missing".to_owned());
    for text in [
        "x y x", "x x y", "y x x", "z y z", "-x y x", "y -y z", "x x x",
    ] {
        assert_eq!(mapping(text), lost, "{text}");
    }
}

/// Three of forward, right, up or of north, east, up and their opposites, one of each pair.
#[wasm_bindgen_test(unsupported = test)]
fn axes_of_a_body_and_of_the_world_are_not_mixed() {
    for (text, name) in [
        ("FNU to UNF", "fnu"),
        ("NRU to RNU", "nru"),
        ("FEU to FEU", "feu"),
        ("FRN to FRN", "frn"),
        ("NEF to NEF", "nef"),
        ("FBU to FRU", "fbu"),
        ("NSU to ENU", "nsu"),
        ("UDN to ENU", "udn"),
        ("FRX to FRX", "frx"),
        ("XYZ to XYZ", "xyz"),
        ("FR to FRU", "fr"),
        ("FRUD to FRU", "frud"),
    ] {
        assert_eq!(
            mapping(text),
            Err(format!("{name} is not a known system of axes")),
            "{text}"
        );
    }
    let mixed = "one system is of a body and the other of the world";
    assert_eq!(mapping("NED to FRD"), Err(mixed.to_owned()));
    assert_eq!(mapping("ROS to ENU"), Err(mixed.to_owned()));
}
