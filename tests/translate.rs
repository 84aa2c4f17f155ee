//! From one library or convention to another.

mod common;
#[path = "common/simulated.rs"]
mod simulated;

use common::{all_conventions, assert_close, wasm_bindgen_test};
use quatlas::nalgebra::{Matrix3, Vector3};
use quatlas::{
    AxesChange, AxesHand, AxisMapping, Change, ComponentOrder, ComponentSign, Convention,
    CosineMatrix, Direction, Endpoint, Fact, Family, Field, Handedness, LibraryEndpoint,
    MistakeKind, Outcome, Problem, ProblemCode, ProductOrder, Request, Rotation, Side,
    TaggedQuaternion, TranslateReport, TranslateRequest, TranslatedEnd, analyze, libraries,
    library,
};
use simulated::{active_matrix, hamilton};

fn answer(request: TranslateRequest) -> Outcome {
    analyze(&Request::Translate(request))
}

#[track_caller]
fn report(request: TranslateRequest) -> TranslateReport {
    match answer(request) {
        Outcome::Translate(report) => *report,
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn translate(text: &str, from: Endpoint, to: Endpoint) -> TranslateReport {
    report(TranslateRequest::new(text, from, to))
}

#[track_caller]
fn between(text: &str, from: &str, to: &str) -> TranslateReport {
    translate(text, Endpoint::library(from), Endpoint::library(to))
}

fn problems(request: TranslateRequest) -> Vec<Problem> {
    match answer(request) {
        Outcome::Problems(found) => found.problems,
        other => panic!("{other:?}"),
    }
}

/// `R_WB` from the numbers of one end, by what the end says of them.
fn body_to_world(end: &TranslatedEnd) -> Matrix3<f64> {
    let q = &end.components;
    let active = active_matrix([q.w, q.x, q.y, q.z]);
    let acts = match end.action {
        CosineMatrix::Hamilton => active,
        CosineMatrix::Shuster => active.transpose(),
    };
    match end.direction {
        Direction::BodyToWorld => acts,
        Direction::WorldToBody => acts.transpose(),
    }
}

fn ends() -> Vec<Endpoint> {
    let of_libraries = libraries().iter().flat_map(|library| {
        Direction::ALL.map(|direction| {
            Endpoint::Library(LibraryEndpoint {
                id: library.id.clone(),
                order: None,
                direction: Some(direction),
            })
        })
    });
    let of_conventions = all_conventions().into_iter().map(Endpoint::convention);
    of_libraries.chain(of_conventions).collect()
}

const TEXT: &str = "0.1 0.7 -0.5 0.5";

/// From every end to three that differ in everything, and back.
#[wasm_bindgen_test(unsupported = test)]
fn both_ends_are_one_attitude_and_the_way_back_is_exact() {
    let partners = ["openvins", "directxmath", "basilisk"].map(Endpoint::library);
    for end in ends() {
        for partner in &partners {
            for (from, to) in [(&end, partner), (partner, &end)] {
                let there = translate(TEXT, from.clone(), to.clone());
                let expected = body_to_world(&there.from);
                let what = format!("{from:?} {to:?}");
                let got = body_to_world(&there.to);
                assert_close(&what, got.as_slice(), expected.as_slice(), 1e-15);
                let array = there.to.array.map(|number| format!("{number:?}")).join(" ");
                let back = translate(&array, to.clone(), from.clone());
                assert_eq!(back.to.array, [0.1, 0.7, -0.5, 0.5], "{what}");
                assert_eq!(back.change, there.change, "{what}");
                assert_eq!(back.product, there.product, "{what}");
            }
        }
    }
}

/// The product of one end, translated, is the product of the other in the order that is said.
#[wasm_bindgen_test(unsupported = test)]
fn a_product_is_written_in_the_order_that_is_said() {
    let product = |hand: Handedness, a, b| match hand {
        Handedness::Right => hamilton(a, b),
        Handedness::Left => hamilton(b, a),
    };
    let (a, b) = ([0.8, 0.2, -0.4, 0.4], [0.1, 0.7, -0.5, 0.5]);
    let mut seen = [0, 0, 0];
    for from in ends() {
        for to in ["openvins", "directxmath", "basilisk", "scipy"].map(Endpoint::library) {
            let report = translate(TEXT, from.clone(), to);
            let (Some(here), Some(there)) = (report.from.handedness, report.to.handedness) else {
                assert_eq!(report.product, ProductOrder::NotEstablished);
                seen[2] += 1;
                continue;
            };
            let is_conjugated = report.from.sign != report.to.sign;
            let over = |[w, x, y, z]: [f64; 4]| {
                if is_conjugated {
                    [w, -x, -y, -z]
                } else {
                    [w, x, y, z]
                }
            };
            let expected = over(product(here, a, b));
            let got = match report.product {
                ProductOrder::Same => product(there, over(a), over(b)),
                ProductOrder::Reversed => product(there, over(b), over(a)),
                other => panic!("{other:?}: both are known"),
            };
            assert_close(&format!("{from:?}"), &got, &expected, 1e-15);
            seen[usize::from(report.product == ProductOrder::Reversed)] += 1;
        }
    }
    assert!(seen.iter().all(|&count| count > 10), "{seen:?}");
}

/// The matrix that an end prints is `R` or `C` of its own numbers.
#[wasm_bindgen_test(unsupported = test)]
fn the_printed_matrix_is_that_of_the_ends_own_numbers() {
    for end in ends() {
        let report = translate(TEXT, end.clone(), Endpoint::library("eigen"));
        let q = &report.from.components;
        let Some(printed) = report.from.matrix else {
            continue;
        };
        let active = active_matrix([q.w, q.x, q.y, q.z]);
        let expected = match printed.form {
            CosineMatrix::Hamilton => active,
            CosineMatrix::Shuster => active.transpose(),
        };
        let got = Matrix3::from(printed.rows).transpose();
        assert_close(
            &format!("{end:?}"),
            got.as_slice(),
            expected.as_slice(),
            1e-15,
        );
        // Read back as nine numbers, it is the same attitude.
        let rows = printed
            .rows
            .concat()
            .iter()
            .map(|n| format!("{n:?}"))
            .collect::<Vec<_>>();
        let again = translate(&rows.join(" "), end, Endpoint::library("eigen"));
        let (one, other) = (body_to_world(&report.to), body_to_world(&again.to));
        assert_close("read back", one.as_slice(), other.as_slice(), 1e-15);
    }
}

/// Between the 32 conventions it is what `to_convention` does.
#[wasm_bindgen_test(unsupported = test)]
fn between_conventions_it_is_the_same_as_ever() {
    for one in all_conventions() {
        for other in all_conventions() {
            let [from, to] = [one, other].map(Endpoint::convention);
            let expected = TaggedQuaternion::from_array([0.1, 0.7, -0.5, 0.5], one)
                .to_convention(other)
                .to_array();
            assert_eq!(
                translate(TEXT, from, to).to.array,
                expected,
                "{one} to {other}"
            );
        }
    }
}

/// Without documentation: R(q) body to world, C(q) world to body.
#[wasm_bindgen_test(unsupported = test)]
fn customary_directions() {
    let direction = |id: &str| {
        assert_eq!(library(id).expect(id).direction, None);
        between(TEXT, id, "eigen").from.direction
    };
    assert_eq!(direction("orekit"), Direction::WorldToBody);
    assert_eq!(direction("directxmath"), Direction::BodyToWorld);
    assert_eq!(direction("scipy"), Direction::BodyToWorld);
}

/// The mistake that this view is for: with the customary directions nothing is conjugated.
#[wasm_bindgen_test(unsupported = test)]
fn a_jpl_filter_to_eigen() {
    // A body yawed by a quarter turn. OpenVINS stores the world-to-body quaternion x y z w.
    let text = "0 0 0.6 0.8";
    let customary = between(text, "openvins", "eigen");
    assert_eq!(customary.change, Change::Copied, "coeffs() is x y z w too");
    assert_eq!(customary.to.array, [0.0, 0.0, 0.6, 0.8]);
    assert_eq!(
        customary.to.construct.as_deref(),
        Some("Eigen::Quaterniond q(0.8, 0.0, 0.0, 0.6);")
    );
    assert_eq!(customary.from.direction, Direction::WorldToBody);
    assert_eq!(customary.to.direction, Direction::BodyToWorld);
    assert_eq!(customary.product, ProductOrder::Reversed);
    // Passed to the constructor, which takes w first, they are another attitude.
    let kinds: Vec<_> = customary
        .mistakes
        .iter()
        .map(|mistake| mistake.kind)
        .collect();
    assert_eq!(
        kinds,
        [
            MistakeKind::ConjugatedNeedlessly,
            MistakeKind::ConstructorOrder
        ]
    );
    let read_by_the_constructor = between(text, "drake", "eigen");
    let angle = |report: &TranslateReport| report.turn.angle_deg;
    assert!(angle(&read_by_the_constructor) > 90.0 && customary.mistakes[1].angle_deg > 90.0);
    // C(q) of the one is the transpose of R(q) of the other.
    let [from, to] = [&customary.from, &customary.to].map(|end| end.matrix.clone().expect("known"));
    assert_close("R", &to.rows[0], &[0.28, -0.96, 0.0], 1e-15);
    assert_close("C", &from.rows[0], &[0.28, 0.96, 0.0], 1e-15);

    // The same directed matrix, world to body on both sides, takes the conjugate.
    let eigen = Endpoint::Library(LibraryEndpoint {
        id: "eigen".to_owned(),
        order: Some(ComponentOrder::ScalarFirst),
        direction: Some(Direction::WorldToBody),
    });
    let directed = translate(text, Endpoint::library("openvins"), eigen);
    assert_eq!(directed.change, Change::ReorderedAndConjugated);
    assert_eq!(directed.to.array, [0.8, 0.0, 0.0, -0.6]);
    assert_eq!(directed.to.sign, ComponentSign::Conjugated);
    assert_eq!(directed.to.matrix.expect("known").rows, from.rows);
}

#[wasm_bindgen_test(unsupported = test)]
fn what_goes_wrong_is_an_angle() {
    // A quarter turn about x, and the same numbers one place on.
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let text = format!("{half:?} {half:?} 0 0");
    let report = between(&text, "isaac-lab-2", "isaac-lab-3");
    assert_eq!(report.change, Change::Reordered);
    assert_eq!(report.to.array, [half, 0.0, 0.0, half]);
    let [forgotten, needless] = report.mistakes[..] else {
        panic!("two mistakes")
    };
    assert_eq!(forgotten.kind, MistakeKind::NotReordered);
    // The inverse of a quarter turn is half a turn away.
    assert_eq!(needless.kind, MistakeKind::ConjugatedNeedlessly);
    assert!((needless.angle_deg - 180.0).abs() < 1e-12, "{needless:?}");
    // Read as x y z w it is half a turn about (1, 1, 0); from there to the quarter turn about x:
    // |w| of the relative quaternion is 0·√½ + √½·√½ = ½, which is 60° of half the angle.
    assert!((forgotten.angle_deg - 120.0).abs() < 1e-12, "{forgotten:?}");
    // The identity in one order is half a turn in the other; (½, ½, ½, ½) hides the mistake.
    let angle = |text| between(text, "isaac-lab-2", "isaac-lab-3").mistakes[0].angle_deg;
    assert_eq!(angle("1 0 0 0"), 180.0);
    assert_eq!(angle("0.5 0.5 0.5 0.5"), 0.0);

    let directed = Convention {
        direction: Direction::WorldToBody,
        ..Convention::HAMILTON
    };
    let report = translate(
        "0.6 0 0.8 0",
        Endpoint::convention(Convention::HAMILTON_SCALAR_LAST),
        Endpoint::convention(directed),
    );
    let steps: Vec<_> = report
        .mistakes
        .iter()
        .map(|forgotten| forgotten.kind)
        .collect();
    assert_eq!(report.change, Change::ReorderedAndConjugated);
    assert_eq!(
        steps,
        [
            MistakeKind::Copied,
            MistakeKind::NotConjugated,
            MistakeKind::NotReordered
        ]
    );
    // A half turn about (0.6, 0, 0.8): its conjugate is its opposite, the same rotation.
    assert_eq!(report.mistakes[1].angle_deg, 0.0);
}

/// Copied as they are, the numbers are read in the other order.
#[wasm_bindgen_test(unsupported = test)]
fn the_angle_is_that_to_the_attitude_that_is_read_by_mistake() {
    let attitude = |convention| {
        let tagged = TaggedQuaternion::from_array([0.1, 0.7, -0.5, 0.5], convention);
        Rotation::from_tagged(&tagged).expect("not zero")
    };
    let first = attitude(Convention::HAMILTON);
    let last = attitude(Convention::HAMILTON_SCALAR_LAST);
    let expected = first.angle_to_rad(&last).to_degrees();
    for (from, to) in [
        ("isaac-lab-2", "isaac-lab-3"),
        ("isaac-lab-3", "isaac-lab-2"),
    ] {
        let [mistake, _] = between(TEXT, from, to).mistakes[..] else {
            panic!("two mistakes")
        };
        assert!(
            (mistake.angle_deg - expected).abs() < 1e-12,
            "{from}: {mistake:?}"
        );
    }
}

/// So are they where they should have been conjugated too; then the way they are shifted matters.
#[wasm_bindgen_test(unsupported = test)]
fn the_angle_of_numbers_that_are_copied_as_they_are() {
    let directed = |order| Convention {
        order,
        direction: Direction::WorldToBody,
        ..Convention::HAMILTON
    };
    let pairs = [
        (Convention::HAMILTON, directed(ComponentOrder::ScalarLast)),
        (
            Convention::HAMILTON_SCALAR_LAST,
            directed(ComponentOrder::ScalarFirst),
        ),
    ];
    for (from, to) in pairs {
        let attitude = |convention| {
            let tagged = TaggedQuaternion::from_array([0.1, 0.7, -0.5, 0.5], convention);
            Rotation::from_tagged(&tagged).expect("not zero")
        };
        let expected = attitude(from).angle_to_rad(&attitude(to)).to_degrees();
        let report = translate(TEXT, Endpoint::convention(from), Endpoint::convention(to));
        let copied = report.mistakes[0];
        assert_eq!(copied.kind, MistakeKind::Copied);
        assert!((copied.angle_deg - expected).abs() < 1e-12, "{copied:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn families_that_labels_do_not_name() {
    let family = |id| between(TEXT, id, "eigen").from;
    let directx = family("directxmath");
    assert_eq!(
        (directx.family, directx.first_to_act),
        (Some(Family::ReversedProduct), Some(Side::Left))
    );
    assert_eq!(directx.sign, ComponentSign::Canonical);
    let basilisk = family("basilisk");
    assert_eq!(
        (basilisk.family, basilisk.direction),
        (Some(Family::TransposedMatrix), Direction::WorldToBody)
    );
    assert_eq!(basilisk.sign, ComponentSign::Canonical);
    // Neither is conjugated on the way to Eigen, though one has ij = −k and the other prints C.
    assert_eq!(between(TEXT, "directxmath", "eigen").change, Change::Copied);
    assert_eq!(between(TEXT, "basilisk", "eigen").change, Change::Reordered);
    assert_eq!(
        between(TEXT, "directxmath", "eigen").product,
        ProductOrder::Reversed
    );
    assert_eq!(
        between(TEXT, "basilisk", "eigen").product,
        ProductOrder::Same
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_not_established_is_said() {
    let report = between(TEXT, "ros-geometry-msgs", "scipy");
    assert!(!report.from.assumed.is_empty());
    assert_eq!(report.from.matrix, None);
    assert_eq!(report.product, ProductOrder::NotEstablished);
    assert!(between(TEXT, "eigen", "scipy").from.assumed.is_empty());
}

#[wasm_bindgen_test(unsupported = test)]
fn a_pasted_call_proposes_its_library() {
    let proposed = |text, from| between(text, from, "scipy").proposed;
    let eigen = "Eigen::Quaterniond q(0.8, 0, 0, 0.6);";
    assert_eq!(proposed(eigen, "three").as_deref(), Some("eigen"));
    assert_eq!(proposed(eigen, "eigen"), None);
    assert_eq!(
        proposed("new THREE.Quaternion(0, 0, 0.6, 0.8)", "eigen").as_deref(),
        Some("three")
    );
    assert_eq!(proposed("0 0 0.6 0.8", "eigen"), None);
    let matrix = "Rotation.from_matrix([[0, -0.6, 0.8], [0.8, 0.48, 0.36], [-0.6, 0.64, 0.48]])";
    let from_babylon = between(matrix, "babylon", "three");
    assert_eq!(from_babylon.proposed.as_deref(), Some("scipy"));
    // The call tells its order, whatever the end is.
    let report = between(eigen, "three", "three");
    assert_eq!(report.to.array, [0.0, 0.0, 0.6, 0.8]);
    assert!(
        report
            .notes
            .iter()
            .any(|note| matches!(note.fact, Fact::OrderFromText(_)))
    );
}

/// nalgebra's `{:?}` and glam's print columns in lists of lists.
#[wasm_bindgen_test(unsupported = test)]
fn lists_that_may_be_columns_are_read_as_rows_and_that_is_said() {
    let text = "[[0, 0.8, -0.6], [-0.6, 0.48, 0.64], [0.8, 0.36, 0.48]]";
    let says_so = |from| {
        let notes = between(text, from, "scipy").notes;
        notes
            .iter()
            .any(|note| matches!(note.fact, Fact::RowsAssumed(_)))
    };
    assert!(says_so("nalgebra") && says_so("eigen") && !says_so("scipy"));
}

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

/// What was chosen stands in the report, also where its numbers are those of another convention.
#[wasm_bindgen_test(unsupported = test)]
fn an_active_convention_stays_active() {
    let active: Convention = "xyzw left active body-to-world global"
        .parse()
        .expect("five words");
    let report = translate(
        TEXT,
        Endpoint::convention(active),
        Endpoint::library("eigen"),
    );
    assert_eq!(report.from.convention, active);
    assert_eq!(report.from.direction, Direction::WorldToBody);
}

#[wasm_bindgen_test(unsupported = test)]
fn axes_that_cannot_be() {
    let found = problems(with_axes(TEXT, "tf2", "unity", "", "ROS to Unity"));
    assert_eq!(found[0].code, ProblemCode::OneSidedReflection);
    let texts = [
        ("x y", "this is no mapping of axes"),
        ("x x z", "an old axis stands twice, so another one is lost"),
        (
            "NED to FLU",
            "one of the two is of a body and the other of the world",
        ),
        ("NED to EEU", "eeu names no axes"),
        ("FOO to ENU", "foo names no axes"),
        ("- - x y z", "this is no mapping of axes"),
        ("x y z -", "this is no mapping of axes"),
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

/// Every line of code that this core wrote is read back as the same attitude, at both ends.
#[wasm_bindgen_test(unsupported = test)]
fn every_line_of_code_is_read_back() {
    for library in libraries() {
        let there = between(TEXT, "openvins", &library.id);
        let line = there.to.construct.expect(&library.id);
        for from in [&library.id, "openvins"] {
            // Elsewhere it must say of itself what it is, or be refused.
            let request = TranslateRequest::new(
                &line,
                Endpoint::library(from),
                Endpoint::library("openvins"),
            );
            let Outcome::Translate(back) = answer(request) else {
                assert_ne!(from, library.id, "{line}");
                continue;
            };
            if from == library.id || back.proposed.as_ref() == Some(&library.id) {
                let what = format!("{line} at {from}");
                assert_close(&what, &back.to.array, &[0.1, 0.7, -0.5, 0.5], 1e-15);
            }
        }
    }
}
