//! What goes wrong between two libraries, and by what angle.

use super::{TEXT, between, end, translate};
use crate::support::assert_close;
use quatlas::{
    Change, ComponentOrder, ComponentSign, Convention, Direction, Endpoint, LibraryEndpoint,
    MistakeKind, ProductOrder, Rotation, TaggedQuaternion, TranslateReport,
};
use wasm_bindgen_test::wasm_bindgen_test;

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
    let directed = translate(text, &Endpoint::library("openvins"), &eigen);
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
        &Endpoint::convention(Convention::HAMILTON_SCALAR_LAST),
        &Endpoint::convention(directed),
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
        let report = translate(TEXT, &Endpoint::convention(from), &Endpoint::convention(to));
        let copied = report.mistakes[0];
        assert_eq!(copied.kind, MistakeKind::Copied);
        assert!((copied.angle_deg - expected).abs() < 1e-12, "{copied:?}");
    }
}

/// The array is passed on to a constructor of the other order only where it stands as it did before:
/// numbers that were reordered are told by that mistake already.
#[wasm_bindgen_test(unsupported = test)]
fn the_order_of_a_constructor_is_a_mistake_of_its_own() {
    use quatlas::MistakeKind::ConstructorOrder;
    let has = |from: &str, to: &Endpoint| {
        let report = translate("0.1 0.7 -0.5 0.5", &Endpoint::library(from), to);
        report
            .mistakes
            .iter()
            .any(|mistake| mistake.kind == ConstructorOrder)
    };
    let eigen = Endpoint::library("eigen");
    // x y z w in both arrays, and Eigen's constructor takes w first.
    assert!(has("tf2", &eigen));
    // w first from drake: the array of Eigen is another one, so it is not what would be passed.
    assert!(!has("drake", &eigen));
    let as_constructed = end("eigen", Some(ComponentOrder::ScalarFirst), None);
    assert!(!has("drake", &as_constructed) && !has("tf2", &as_constructed));
}
