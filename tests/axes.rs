//! Axes by their names, and by the old ones.

mod common;

use common::{assert_close, wasm_bindgen_test};
use quatlas::nalgebra::{Matrix3, Vector3};
use quatlas::{AxesHand, AxisMapping, UnknownAxes};

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
fn an_old_axis_stands_once() {
    let lost = Err("an old axis stands twice, so another one is lost".to_owned());
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
        ("FR to FRU", "fr"),
        ("FRUD to FRU", "frud"),
    ] {
        assert_eq!(
            mapping(text),
            Err(format!("{name} names no axes")),
            "{text}"
        );
    }
    let mixed = "one of the two is of a body and the other of the world";
    assert_eq!(mapping("NED to FRD"), Err(mixed.to_owned()));
    assert_eq!(mapping("ROS to ENU"), Err(mixed.to_owned()));
}
