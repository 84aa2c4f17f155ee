//! The table of libraries: it is whole, and says of itself what is true.

use crate::recorded::{for_each, numbers, recorded};
use quatlas::{
    ComponentOrder, CosineMatrix, Direction, Family, Known, Library, libraries, library,
};
use serde_json::{Value, json};
use std::collections::HashSet;
use wasm_bindgen_test::wasm_bindgen_test;

/// Every member of the file is in the table, and nothing else is.
#[wasm_bindgen_test(unsupported = test)]
fn the_table_is_that_of_the_file() {
    let file = include_str!("../../src/library/libraries.json");
    let file: Value = serde_json::from_str(file).expect("JSON");
    let table = serde_json::to_value(libraries()).expect("JSON");
    assert_eq!(without_what_is_left_out(table), file);
}

/// Without the members that are null or empty, which the file leaves out.
fn without_what_is_left_out(value: Value) -> Value {
    let empty = [Value::Null, json!([]), json!({})];
    match value {
        Value::Object(members) => members
            .into_iter()
            .map(|(name, value)| (name, without_what_is_left_out(value)))
            .filter(|(_, value)| !empty.contains(value))
            .collect(),
        Value::Array(values) => values.into_iter().map(without_what_is_left_out).collect(),
        value => value,
    }
}

/// How a record can be wrong without any number: ids, and what one field says of another.
#[wasm_bindgen_test(unsupported = test)]
fn the_table_is_whole() {
    let ids: HashSet<_> = libraries().iter().map(|library| library.id).collect();
    assert_eq!(ids.len(), libraries().len(), "every id once");
    assert!(libraries().len() >= 60);
    let run: HashSet<String> = recorded()
        .observations
        .iter()
        .map(|observation| observation["id"].as_str().expect("an id").to_owned())
        .collect();
    for library in libraries() {
        let id = library.id;
        assert_eq!(library.known == Known::Run, run.contains(id), "{id}: run");
        assert_eq!(
            library.known == Known::Run,
            library.calls.is_some(),
            "{id}: calls"
        );
        assert!(
            library.known == Known::Run || library.source.is_some(),
            "{id}: source"
        );
        assert!(
            library.matrix.is_some() || library.vectors.is_none(),
            "{id}: vectors"
        );
        let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        assert!(id.chars().all(plain), "{id}");
    }
}

/// What was recorded is in the record, and what is in the record was recorded.
#[wasm_bindgen_test(unsupported = test)]
fn nothing_is_claimed_that_was_not_recorded_nor_left_out() {
    for_each(|library, observed, _| {
        let printed = |key: &str| numbers(&observed[key]).is_some();
        let claims = [
            ("array", library.array_order.is_some(), printed("arrayOfA")),
            (
                "handedness",
                library.handedness.is_some(),
                printed("productAB") || printed("productIJ"),
            ),
            ("matrix", library.matrix.is_some(), printed("matrixA")),
            ("rotate", library.rotate.is_some(), printed("rotateAV")),
        ];
        for (name, claimed, recorded) in claims {
            assert_eq!(claimed, recorded, "{}: {name}", library.id);
        }
        // Some constructors refuse 0.1, 0.2, 0.3, 0.4, whose norm is not 1; their order shows elsewhere.
        assert!(library.constructor_order.is_some() || !printed("constructed1234"));
    });
}

/// The README counts the records.
#[wasm_bindgen_test(unsupported = test)]
fn the_counts_of_the_readme_are_true() {
    let readme = include_str!("../../README.md").replace('\n', " ");
    let count = |known| {
        let libraries = libraries().iter();
        libraries.filter(|library| library.known == known).count()
    };
    let of_libraries = libraries().iter().filter(|record| record.kind.is_none());
    let of_libraries = of_libraries.count();
    let others = libraries().len() - of_libraries;
    let sentences = [
        format!("two of {of_libraries} libraries and {others} formats and devices"),
        format!("{} were run", count(Known::Run)),
        format!("{} were read in their source", count(Known::Read)),
        format!("{} in their documentation", count(Known::Documented)),
    ];
    for sentence in sentences {
        assert!(readme.contains(&sentence), "{sentence}");
    }
}

/// Those that people would look for first.
#[wasm_bindgen_test(unsupported = test)]
fn what_people_look_for_is_there() {
    let wanted = [
        "geometry_msgs",
        "tf2",
        "tf.transformations",
        "Eigen",
        "SciPy",
        "scalar_first",
        "MATLAB",
        "MuJoCo",
        "Drake",
        "GTSAM",
        "Sophus",
        "manif",
        "Ceres",
        "KDL",
        "pinocchio",
        "PyBullet",
        "Bullet",
        "Isaac Lab 2",
        "Isaac Lab 3",
        "PX4",
        "ArduPilot",
        "MAVLink",
        "three",
        "gl-matrix",
        "Babylon",
        "Cesium",
        "Unity",
        "Unreal",
        "Godot",
        "Blender",
        "glam",
        "nalgebra",
        "cgmath",
        "GLM",
        "DirectXMath",
        "OpenSceneGraph",
        "USD",
        "Qt",
        "pyquaternion",
        "transforms3d",
        "Gohlke",
        "numpy-quaternion",
        "pytransform3d",
        "spatialmath",
        "ahrs",
        "navpy",
        "spiceypy",
        "Basilisk",
        "Hipparchus",
        "Orekit",
        "ANISE",
        "OpenVINS",
        "MSCKF",
        "Kalibr",
        "maplab",
        "kindr",
        "minkindr",
        "OpenXR",
        "DJI",
        "Android",
        "Apple",
        "TUM",
        "EuRoC",
        "KITTI",
        "COLMAP",
        "ORB-SLAM",
        "VINS",
        "OpenCV",
        "glTF",
        "URDF",
        "SDFormat",
        "CARLA",
        "AirSim",
        "CCSDS",
        "SPICE",
        "KUKA",
        "FANUC",
        "ABB",
        "Universal Robots",
        "Staubli",
        "Yaskawa",
        "Xsens",
        "VectorNav",
        "MicroStrain",
        "BNO055",
    ];
    for name in wanted {
        let lower = name.to_lowercase();
        let is_named = |library: &Library| {
            let mut names = [&library.id, &library.name]
                .into_iter()
                .chain(library.words);
            names.any(|found| found.to_lowercase().contains(&lower))
        };
        assert!(libraries().iter().any(is_named), "{name}");
    }
}

/// What engines and phones do was read: not their order alone.
#[wasm_bindgen_test(unsupported = test)]
fn engines_and_phones_are_whole() {
    let of = |id: &str| library(id).expect(id);
    for id in [
        "unity",
        "unreal",
        "apple-simd",
        "apple-core-motion",
        "android-sensor",
        "openxr",
    ] {
        let record = of(id);
        assert_eq!(record.known, Known::Read, "{id}");
        assert_eq!(
            record.order().is_some(),
            record.array_order.is_some(),
            "{id}"
        );
        assert!(
            record.array_order.is_some() && record.action().is_some(),
            "{id}"
        );
        assert_eq!(record.direction.is_some(), id != "apple-simd", "{id}");
    }
    for id in ["unity", "unreal", "apple-simd"] {
        assert_eq!(of(id).family(), Some(Family::Hamilton), "{id}");
    }
    // The matrix of the attitude of a phone leads to the phone, R of its quaternion to the world.
    assert_eq!(
        of("apple-core-motion").direction,
        Some(Direction::WorldToBody)
    );
    assert_eq!(
        of("apple-core-motion").action(),
        Some(CosineMatrix::Shuster)
    );
    // The event of the sensor and the array that is made of it are in two orders.
    let (event, array) = (of("android-rotation-vector"), of("android-sensor"));
    assert_eq!(event.array_order, Some(ComponentOrder::ScalarLast));
    assert_eq!(array.array_order, Some(ComponentOrder::ScalarFirst));
    let left_handed = |library: &&Library| {
        library
            .axes
            .is_some_and(|axes| axes.starts_with("left-handed"))
    };
    let ids: Vec<_> = libraries()
        .iter()
        .filter(left_handed)
        .map(|library| library.id)
        .collect();
    assert_eq!(
        ids,
        ["unity-mathematics", "unity", "unreal", "carla-rotation"]
    );
}

/// The families of the specification's survey, each with its libraries.
#[wasm_bindgen_test(unsupported = test)]
fn what_looks_like_jpl_and_is_not() {
    let family = |id: &str| library(id).expect(id).family();
    for id in ["directxmath", "openscenegraph", "panda3d"] {
        assert_eq!(family(id), Some(Family::ReversedProduct), "{id}");
    }
    for id in ["basilisk", "navpy", "matlab-aerospace"] {
        assert_eq!(family(id), Some(Family::TransposedMatrix), "{id}");
    }
    for id in ["openvins", "msckf-vio", "kalibr", "anise"] {
        assert_eq!(family(id), Some(Family::Shuster), "{id}");
    }
    for id in ["babylon", "usd", "eigen", "scipy"] {
        assert_eq!(family(id), Some(Family::Hamilton), "{id}");
    }
}

/// The names of the components in a line of code stand in the order of the constructor or the array.
#[wasm_bindgen_test(unsupported = test)]
fn lines_of_code_name_all_components_once() {
    for library in libraries() {
        let Some(line) = &library.code.construct else {
            continue;
        };
        let mut places: Vec<(usize, &str)> = ["w", "x", "y", "z"]
            .into_iter()
            .map(|name| {
                let place = format!("{{{name}}}");
                assert_eq!(line.matches(&place).count(), 1, "{}: {place}", library.id);
                (line.find(&place).expect("once"), name)
            })
            .collect();
        places.sort_unstable();
        let order: String = places.iter().map(|(_, name)| *name).collect();
        let orders = [library.constructor_order, library.array_order]
            .into_iter()
            .flatten();
        let known: Vec<&str> = orders
            .map(|order| match order {
                ComponentOrder::ScalarFirst => "wxyz",
                ComponentOrder::ScalarLast => "xyzw",
            })
            .collect();
        // Names or keywords may stand in any order.
        let names_them = ["w=", "w =", "w:", "real", ".w", "scalar"]
            .iter()
            .any(|mark| line.contains(mark));
        assert!(
            known.is_empty() || names_them || known.contains(&&*order),
            "{}: {line}",
            library.id
        );
    }
}

/// Without documentation, a quaternion that rotates by R(q) is taken for body to world.
#[wasm_bindgen_test(unsupported = test)]
fn documented_directions_are_few_and_known() {
    let direction = |id: &str| library(id).expect(id).direction;
    assert_eq!(direction("openvins"), Some(Direction::WorldToBody));
    assert_eq!(
        direction("px4-vehicle-attitude"),
        Some(Direction::BodyToWorld)
    );
    assert_eq!(direction("eigen"), None);
}
