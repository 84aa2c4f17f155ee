//! Translations to other axes of the world and of the body.

use super::{TEXT, problems, report};
use crate::support::assert_close;
use quatlas::nalgebra::Vector3;
use quatlas::{
    AxesChange, AxesHand, AxisMapping, Endpoint, Field, MistakeKind, Outcome, ProblemCode,
    ProductOrder, Request, Rotation, TranslateRequest, analyze,
};
use wasm_bindgen_test::wasm_bindgen_test;

fn with_axes(text: &str, from: &str, to: &str, world: &str, body: &str) -> TranslateRequest {
    TranslateRequest {
        world_axes: world.to_owned(),
        body_axes: body.to_owned(),
        ..TranslateRequest::new(text, Endpoint::library(from), Endpoint::library(to))
    }
}

/// By the rotated vector: the same arrow, named on the new axes.
#[wasm_bindgen_test(unsupported = test)]
fn new_axes_name_the_same_arrows() {
    let mappings = [
        "",
        "NED to ENU",
        "FRD -> FLU",
        "y z x",
        "-y z x",
        "ROS to Unity",
        "z -y x",
    ];
    let attitude = Rotation::from_rotation_vector_rad([0.4, -0.7, 1.1]).expect("finite");
    let mut applied = 0;
    for (world, body) in mappings.iter().flat_map(|w| mappings.map(|b| (*w, b))) {
        let [world, body] = [world, body].map(|text| text.parse::<AxisMapping>().expect(text));
        let change = AxesChange { world, body };
        let Ok(renamed) = change.apply(&attitude) else {
            assert_ne!(world.determinant(), body.determinant());
            continue;
        };
        for arrow in [Vector3::x(), Vector3::y(), Vector3::z()] {
            let in_world = attitude.body_to_world(arrow);
            let got = renamed.body_to_world(body.matrix() * arrow);
            let expected = world.matrix() * in_world;
            assert_close("arrow", got.as_slice(), expected.as_slice(), 1e-15);
        }
        applied += 1;
    }
    assert!(applied > 20);
}

#[wasm_bindgen_test(unsupported = test)]
fn well_known_changes_of_axes() {
    // ROS to Unity: (x, y, z, w) becomes (y, −z, −x, w), as the bridges between them write it.
    let unity = report(with_axes(
        TEXT,
        "tf2",
        "unity",
        "ROS to Unity",
        "ROS to Unity",
    ));
    assert_close("Unity", &unity.to.array, &[0.7, 0.5, -0.1, 0.5], 1e-15);
    let axes = unity.axes.expect("asked for");
    assert_eq!(
        (axes.world.determinant, axes.world.hand),
        (-1, AxesHand::Changed)
    );
    assert_eq!(axes.world.text, "-y z x");
    // PX4 to ROS: north-east-down and forward-right-down to east-north-up and forward-left-up. Heading
    // north is a quarter turn to the left of east.
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let ros = report(with_axes(
        "1 0 0 0",
        "px4-matrix",
        "tf2",
        "NED to ENU",
        "FRD to FLU",
    ));
    let sign = ros.to.array[3].signum();
    assert_close(
        "ROS",
        &ros.to.array.map(|n| n * sign),
        &[0.0, 0.0, half, half],
        1e-15,
    );
    // Forgotten, the body heads and tilts elsewhere.
    let last = ros.mistakes.last().expect("a step");
    assert_eq!(last.kind, MistakeKind::AxesKept);
    assert!((last.angle_deg - 90.0).abs() < 1e-12);
    // A camera of OpenCV to one of OpenGL: half a turn about x, on the body side only.
    let opengl = report(with_axes(
        "1 0 0 0",
        "scipy-scalar-first",
        "glm",
        "",
        "OpenCV to OpenGL",
    ));
    assert_close(
        "OpenGL",
        &opengl.to.array.map(f64::abs),
        &[1.0, 0.0, 0.0, 0.0],
        1e-15,
    );
}

/// `A_W a A_Bᵀ` times `A_W b A_Bᵀ` is not `A_W a b A_Bᵀ`, unless the two are the same.
#[wasm_bindgen_test(unsupported = test)]
fn a_product_survives_only_the_same_change_on_both_sides() {
    let product =
        |world: &str, body: &str| report(with_axes(TEXT, "tf2", "eigen", world, body)).product;
    assert_eq!(product("", ""), ProductOrder::Same);
    assert_eq!(product("ROS to Unity", "ROS to Unity"), ProductOrder::Same);
    assert_eq!(product("NED to ENU", "FRD to FLU"), ProductOrder::Neither);
    assert_eq!(product("", "FRD to FLU"), ProductOrder::Neither);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_norm_is_kept_on_every_way() {
    for axes in ["", "FRD to FLU"] {
        let report = report(with_axes("0.2 0.2 0.2 1.8", "tf2", "eigen", axes, axes));
        let norm = |numbers: [f64; 4]| numbers.iter().map(|n| n * n).sum::<f64>().sqrt();
        assert!(
            (norm(report.to.array) - norm(report.from.array)).abs() < 1e-15,
            "{axes}"
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn axes_that_cannot_be() {
    let found = problems(with_axes(TEXT, "tf2", "unity", "", "ROS to Unity"));
    assert_eq!(found[0].code, ProblemCode::OneSidedReflection);
    let texts = [
        ("x y", "this is not a mapping of axes"),
        ("x x z", "one axis appears twice, so another one is missing"),
        (
            "NED to FLU",
            "one system is of a body and the other of the world",
        ),
        ("NED to EEU", "eeu is not a known system of axes"),
        ("FOO to ENU", "foo is not a known system of axes"),
        ("- - x y z", "this is not a mapping of axes"),
        ("x y z -", "this is not a mapping of axes"),
    ];
    for (text, message) in texts {
        let found = problems(with_axes("oops", "tf2", "tf2", text, "\u{1F642}"));
        let fields: Vec<_> = found.iter().map(|problem| problem.field).collect();
        assert_eq!(
            fields,
            [Field::Quaternion, Field::WorldAxes, Field::BodyAxes]
        );
        assert_eq!(found[1].message, message, "{text}");
    }
    let found = problems(with_axes(TEXT, "tf3", "tf2", "", ""));
    assert_eq!(
        (found[0].code, found[0].field),
        (ProblemCode::UnknownLibrary, Field::From)
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn every_signed_permutation_is_read_as_it_is_written() {
    let mut determinants = 0;
    let signs = ["", "-"];
    for letters in ["xyz", "xzy", "yxz", "yzx", "zxy", "zyx"] {
        for bits in 0..8 {
            let text: Vec<String> = letters
                .chars()
                .enumerate()
                .map(|(at, letter)| format!("{}{letter}", signs[bits >> at & 1]))
                .collect();
            let text = text.join(" ");
            let mapping: AxisMapping = text.parse().expect(&text);
            assert_eq!(mapping.to_string(), text);
            let determinant = mapping.matrix().determinant();
            assert_eq!(f64::from(mapping.determinant()), determinant, "{text}");
            determinants += i32::from(mapping.determinant());
        }
    }
    assert_eq!(determinants, 0, "half of the 48 change the hand");
}

/// The turn is that of what was typed, on the axes on which it was typed.
#[wasm_bindgen_test(unsupported = test)]
fn the_turn_is_that_of_the_first_end() {
    let [from, to] = ["tf2", "eigen"].map(Endpoint::library);
    let request = TranslateRequest {
        body_axes: "FRD to FLU".to_owned(),
        ..TranslateRequest::new("0 0 0.6 0.8", from, to)
    };
    let Outcome::Translate(report) = analyze(&Request::Translate(request)) else {
        panic!("it is read")
    };
    assert_close(
        "the axis",
        &report.turn.axis.expect("a turn"),
        &[0.0, 0.0, 1.0],
        1e-15,
    );
    // cos θ/2 = 0.8, so cos θ = 2 · 0.64 − 1.
    assert!((report.turn.angle_rad - 0.28_f64.acos()).abs() < 1e-15);
}

/// New axes make other numbers that are as long as those that were typed, however long these are.
#[wasm_bindgen_test(unsupported = test)]
fn a_change_of_axes_keeps_any_norm() {
    let [from, to] = ["tf2", "eigen"].map(Endpoint::library);
    for norm in [0.01, 0.8, 0.999, 1.001, 1.3, 1.6, 40.0] {
        let text = format!("0 0 {:?} {:?}", 0.6 * norm, 0.8 * norm);
        for axes in ["FRD to FLU", "y z x"] {
            let request = TranslateRequest {
                world_axes: axes.to_owned(),
                body_axes: axes.to_owned(),
                ..TranslateRequest::new(&text, from.clone(), to.clone())
            };
            let Outcome::Translate(report) = analyze(&Request::Translate(request)) else {
                panic!("it is read")
            };
            let squares = report.to.array.iter().map(|number| number * number);
            let got = squares.sum::<f64>().sqrt();
            assert!(
                (got - norm).abs() <= 4.0 * f64::EPSILON * norm,
                "{norm}: {got}"
            );
        }
    }
}

/// A norm that is 1 but for rounding does not round the new numbers once more; any other is kept.
#[wasm_bindgen_test(unsupported = test)]
fn a_change_of_axes_makes_no_rounding_of_a_norm_its_own() {
    let [from, to] = ["tf2", "eigen"].map(Endpoint::library);
    // Four units of roundoff above 1, and six.
    for (text, scalar) in [
        ("0 0 0 1.0000000000000004", 1.0),
        ("0 0 0 1.0000000000000007", 1.000_000_000_000_000_7),
    ] {
        let request = TranslateRequest {
            body_axes: "FRD to FLU".to_owned(),
            world_axes: "FRD to FLU".to_owned(),
            ..TranslateRequest::new(text, from.clone(), to.clone())
        };
        let Outcome::Translate(report) = analyze(&Request::Translate(request)) else {
            panic!("it is read")
        };
        assert_eq!(report.to.array, [0.0, 0.0, 0.0, scalar], "{text}");
    }
}
