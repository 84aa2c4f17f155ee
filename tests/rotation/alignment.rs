//! Attitudes from vectors, weighted means and powers, against numbers that were made elsewhere (see
//! `vectors/README.md`).

use crate::support::assert_close;
use quatlas::nalgebra::Vector3;
use quatlas::{
    Convention, NoAlignment, NoMean, NoRotation, NotFinite, Rotation, TaggedQuaternion,
    UnusableWeights,
};
use serde_json::Value;
use std::f64::consts::{FRAC_PI_2, PI};
use wasm_bindgen_test::wasm_bindgen_test;

/// Half a unit in the last place of 1.
const U: f64 = f64::EPSILON / 2.0;

fn cases(operation: &str) -> Vec<Value> {
    let file: Value =
        serde_json::from_str(include_str!("../vectors/alignment.json")).expect("JSON");
    file[operation].as_array().expect("cases").clone()
}

fn numbers<const COUNT: usize>(value: &Value) -> [f64; COUNT] {
    let list = value.as_array().expect("a list");
    let numbers: Vec<f64> = list
        .iter()
        .map(|number| number.as_f64().expect("a number"))
        .collect();
    numbers.try_into().expect("as many numbers")
}

fn lists<const COUNT: usize>(value: &Value) -> Vec<[f64; COUNT]> {
    value
        .as_array()
        .expect("a list")
        .iter()
        .map(numbers)
        .collect()
}

fn weights(case: &Value) -> Option<Vec<f64>> {
    let list = case["weights"].as_array()?;
    Some(
        list.iter()
            .map(|weight| weight.as_f64().expect("a number"))
            .collect(),
    )
}

fn rotation([w, x, y, z]: [f64; 4]) -> Rotation {
    let q = TaggedQuaternion::new(w, x, y, z, Convention::HAMILTON);
    Rotation::from_tagged(&q).expect("not zero")
}

/// Each component within so many roundoffs of itself, up to one sign of all.
#[track_caller]
fn assert_digits(case: &Value, got: &Rotation, roundoffs: f64) {
    let expected: [f64; 4] = numbers(&case["quaternion"]);
    let got = got.to_tagged(Convention::HAMILTON).components;
    let got = [got.w, got.i, got.j, got.k];
    let inner: f64 = got
        .iter()
        .zip(expected)
        .map(|(one, other)| one * other)
        .sum();
    for (number, wanted) in got
        .map(|number| number * inner.signum())
        .iter()
        .zip(expected)
    {
        let error = (number - wanted).abs();
        assert!(
            error <= roundoffs * U * wanted.abs() + 5e-324,
            "{}: {got:?} is {} u from {expected:?}",
            case["name"],
            error / wanted.abs() / U
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn vectors_are_aligned_as_by_scipy() {
    for case in cases("align_vectors") {
        let (body, world) = (lists(&case["body"]), lists(&case["world"]));
        let fit = Rotation::align_vectors(&body, &world, weights(&case).as_deref());
        let fit = fit.expect("one attitude");
        assert_digits(&case, &fit.rotation, 2.0);
        let name = case["name"].to_string();
        let rssd = case["rssd"].as_f64().expect("a number");
        // Where all fit it is what the rounding of the quaternion leaves.
        let is_close = (fit.rssd - rssd).abs() <= 4.0 * U * rssd;
        let is_fit = rssd < U && fit.rssd < 2.0 * U;
        assert!(is_close || is_fit, "{name}: {} of {rssd}", fit.rssd);
        let expected: [f64; 9] = numbers(&case["sensitivity"]);
        let largest = expected.iter().fold(0.0_f64, |most, n| most.max(n.abs()));
        let scaled = |numbers: &[f64]| numbers.iter().map(|n| n / largest).collect::<Vec<_>>();
        let got = scaled(fit.sensitivity.as_slice());
        assert_close(&name, &got, &scaled(&expected), 1e-14);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_shortest_turn_between_two_directions_has_all_its_digits() {
    for case in cases("from_two_vectors") {
        let [body, world] = ["body", "world"].map(|name| numbers(&case[name]));
        let turn = Rotation::from_two_vectors(body, world).expect("directions");
        assert_digits(&case, &turn, 2.0);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn weighted_means_are_those_of_scipy() {
    for case in cases("mean_weighted") {
        let all: Vec<Rotation> = lists(&case["quaternions"])
            .into_iter()
            .map(rotation)
            .collect();
        let weights = weights(&case).expect("weights");
        let mean = Rotation::mean_weighted(&all, &weights).expect("one mean");
        assert_digits(&case, &mean, 2.0);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn powers_turn_by_so_many_times_the_angle() {
    for case in cases("power") {
        let t = case["t"].as_f64().expect("a number");
        let turn = rotation(numbers(&case["input"]));
        let power = turn.power(t).expect("finite");
        // An angle of more than one turn moves the smaller components by more than themselves.
        assert_digits(&case, &power, 4.0 * t.abs().max(1.0));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn opposite_directions_are_half_a_turn_apart_about_the_axis_of_the_rule() {
    // body × the axis of the smallest coordinate, computed by hand.
    for (body, axis) in [
        ([2.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        ([0.0, 2.0, 0.0], [0.0, 0.0, -1.0]),
        ([0.0, 0.0, -2.0], [0.0, -1.0, 0.0]),
        ([5.0, 5.0, 5.0], [0.0, 1.0, -1.0]),
        ([1.0, -2.0, 3.0], [0.0, 3.0, 2.0]),
        ([3.0, -1.0, 2.0], [-2.0, 0.0, 3.0]),
        ([3.0, 2.0, -1.0], [2.0, -3.0, 0.0]),
    ] {
        let turn = Rotation::from_two_vectors(body, body.map(|number| -0.25 * number));
        let turn = turn.expect("directions");
        assert_eq!(turn.angle_rad(), PI, "{body:?}");
        let expected = Vector3::from(axis).normalize();
        let got = turn.axis().expect("half a turn");
        assert!((got - expected).amax() < 2.0 * U, "{body:?}: {got}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn two_directions_have_a_turn_unless_one_of_them_is_none() {
    for nothing in [[0.0; 3], [f64::NAN, 1.0, 0.0], [1.0, 0.0, f64::INFINITY]] {
        let here = [1.0, 2.0, 3.0];
        assert_eq!(Rotation::from_two_vectors(nothing, here), Err(NoRotation));
        assert_eq!(Rotation::from_two_vectors(here, nothing), Err(NoRotation));
    }
    let [smallest, largest] = [[5e-324, 0.0, 0.0], [0.0, -f64::MAX, 0.0]];
    let turn = Rotation::from_two_vectors(smallest, largest).expect("directions");
    let vector = turn.rotation_vector_rad();
    assert!((vector - Vector3::new(0.0, 0.0, -FRAC_PI_2)).amax() < 2.0 * U);
}

#[wasm_bindgen_test(unsupported = test)]
fn powers_of_quarter_turns_are_turns_about_the_same_axis() {
    for axis in 0..3 {
        let about = |angle: f64| {
            let mut vector = [0.0; 3];
            vector[axis] = angle;
            Rotation::from_rotation_vector_rad(vector).expect("finite")
        };
        let quarter = about(FRAC_PI_2);
        for t in [-7.0, -1.0, -0.5, 0.0, 0.25, 1.0, 2.0, 3.0, 6.0] {
            let power = quarter.power(t).expect("finite");
            assert!(power.angle_to_rad(&about(t * FRAC_PI_2)) < 8.0 * U * t.abs() + U);
        }
        let [none, back] = [0.0, -1.0].map(|t| quarter.power(t).expect("finite"));
        assert_eq!(none, Rotation::identity());
        assert!(back.angle_to_rad(&quarter.inverse()) < 2.0 * U);
    }
    let identity = Rotation::identity();
    assert_eq!(identity.power(f64::MAX), Ok(identity));
    for t in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(identity.power(t), Err(NotFinite));
    }
}

/// A pair of axes that are seen elsewhere: north east down on forward right down, at heading 90°.
#[wasm_bindgen_test(unsupported = test)]
fn an_alignment_leads_from_the_body_to_the_world() {
    let forward_and_down = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let east_and_down = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let fit = Rotation::align_vectors(&forward_and_down, &east_and_down, None).expect("one");
    let heading = fit.rotation.rotation_vector_rad();
    assert!((heading - Vector3::new(0.0, 0.0, FRAC_PI_2)).amax() < 2.0 * U);
    let back = Rotation::align_vectors(&east_and_down, &forward_and_down, None).expect("one");
    assert!((back.rotation.rotation_vector_rad() + heading).amax() < 2.0 * U);
}

#[wasm_bindgen_test(unsupported = test)]
fn only_the_ratios_of_weights_matter_and_zero_leaves_one_out() {
    let body = [[1.0, 0.2, -0.4], [0.3, 1.5, 0.6], [-0.7, 0.4, 2.0]];
    let world = [[0.4, 0.7, -0.8], [-1.4, 0.8, -0.4], [9.0, 9.0, 9.0]];
    let fit = |weights: [f64; 3]| {
        Rotation::align_vectors(&body, &world, Some(&weights)).expect("one attitude")
    };
    let two = Rotation::align_vectors(&body[..2], &world[..2], Some(&[1.0, 2.0])).expect("one");
    let three = fit([1.0, 2.0, 0.0]);
    assert_eq!((three.rotation, three.rssd), (two.rotation, two.rssd));
    let large = 2.0_f64.powi(1000);
    let scaled = fit([large, 2.0 * large, 0.0]);
    assert_eq!(scaled.rotation, three.rotation);
    assert_eq!(scaled.rssd, three.rssd * 2.0_f64.powi(500));
    assert_eq!(scaled.sensitivity, three.sensitivity);
}

#[wasm_bindgen_test(unsupported = test)]
fn sizes_whose_products_are_nearly_nothing_are_aligned() {
    // A quarter turn about z; the sum is of 1e-320 alone.
    let body = [[1.0, 0.0, 0.0], [0.0, 1e-320, 0.0]];
    let world = [[0.0, 1e-320, 0.0], [-1.0, 0.0, 0.0]];
    let fit = Rotation::align_vectors(&body, &world, None).expect("one attitude");
    let vector = fit.rotation.rotation_vector_rad();
    assert!((vector - Vector3::new(0.0, 0.0, FRAC_PI_2)).amax() < 2.0 * U);
    assert!((fit.rssd - 2.0_f64.sqrt()).abs() < 4.0 * U);
    assert_eq!(fit.sensitivity[(2, 2)], f64::INFINITY);
}

#[wasm_bindgen_test(unsupported = test)]
fn vectors_that_give_no_attitude_are_an_error() {
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let (zero, mirrored, nearly_x) = ([0.0; 3], [0.0, 0.0, -1.0], [1.0, 1e-6, 0.0]);
    let error = |body: &[[f64; 3]], world: &[[f64; 3]], weights: Option<&[f64]>| {
        Rotation::align_vectors(body, world, weights).expect_err("no attitude")
    };
    let (two, unusable) = ([x, y], NoAlignment::Weights);
    assert_eq!(error(&[], &[], None), NoAlignment::Empty);
    assert_eq!(error(&two, &[x], None), NoAlignment::CountsDiffer);
    assert_eq!(
        error(&two, &[x, [0.0, f64::NAN, 0.0]], None),
        NoAlignment::NotFinite
    );
    for (weights, expected) in [
        (vec![1.0], UnusableWeights::CountsDiffer),
        (vec![1.0, -1e-300], UnusableWeights::NegativeOrNotFinite),
        (
            vec![1.0, f64::INFINITY],
            UnusableWeights::NegativeOrNotFinite,
        ),
        (vec![f64::NAN, 1.0], UnusableWeights::NegativeOrNotFinite),
        (vec![0.0, -0.0], UnusableWeights::AllZero),
    ] {
        assert_eq!(error(&two, &two, Some(&weights)), unusable(expected));
        let rotations = [Rotation::identity(); 2];
        let mean = Rotation::mean_weighted(&rotations, &weights);
        assert_eq!(mean, Err(NoMean::Weights(expected)));
    }
    for (body, world) in [
        (vec![x], vec![y]),
        (vec![x, x], vec![y, z]),
        (vec![x, nearly_x], vec![x, nearly_x]),
        (vec![zero, zero], vec![x, y]),
        (vec![x, y, z], vec![x, y, mirrored]),
    ] {
        assert_eq!(error(&body, &world, None), NoAlignment::Undetermined);
    }
    assert_eq!(
        error(&two, &two, Some(&[1.0, 0.0])),
        NoAlignment::Undetermined
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn attitudes_without_a_middle_have_no_weighted_mean() {
    let half_turn = rotation([0.0, 0.6, 0.0, 0.8]);
    let apart = [Rotation::identity(), half_turn];
    assert_eq!(Rotation::mean_weighted(&[], &[]), Err(NoMean::Empty));
    let even = Rotation::mean_weighted(&apart, &[2.0, 2.0]);
    assert_eq!(even, Err(NoMean::Undetermined));
    let uneven = Rotation::mean_weighted(&apart, &[2.0, 3.0]);
    assert_eq!(uneven.map(|mean| mean.angle_to_rad(&half_turn)), Ok(0.0));
}
