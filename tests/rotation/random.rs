//! Attitudes drawn at random: which they are, and that none is more likely than another.

use crate::support::assert_close;
use quatlas::nalgebra::{Matrix3, Vector3};
use quatlas::{Convention, EulerSequence, Rotation, TaggedQuaternion};
use serde_json::Value;
use std::f64::consts::{PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

const COUNT: u32 = 20_000;

/// Kolmogorov's statistic is above this for one sample in a thousand.
const ONE_IN_A_THOUSAND: f64 = 1.95;

/// The largest distance of the sample's distribution from the cumulated one, times the root of their number.
fn kolmogorov(mut sample: Vec<f64>, cumulated: fn(f64) -> f64) -> f64 {
    sample.sort_by(f64::total_cmp);
    let count = sample.len() as f64;
    let distances = sample.iter().enumerate().map(|(at, &number)| {
        let expected = cumulated(number);
        let (below, above) = (at as f64 / count, (at + 1) as f64 / count);
        (expected - below).abs().max((expected - above).abs())
    });
    distances.fold(0.0, f64::max) * count.sqrt()
}

/// Of the angle between two uniform attitudes.
fn of_angle(angle: f64) -> f64 {
    (angle - angle.sin()) / PI
}

/// Of a coordinate of a uniform direction (Archimedes).
fn of_height(height: f64) -> f64 {
    f64::midpoint(1.0, height)
}

/// The statistics of the angle, and of each coordinate of each axis.
fn statistics(attitudes: &[Rotation]) -> Vec<f64> {
    let matrices: Vec<Matrix3<f64>> = attitudes
        .iter()
        .map(Rotation::body_to_world_matrix)
        .collect();
    let angles = attitudes.iter().map(Rotation::angle_rad).collect();
    let mut all = vec![kolmogorov(angles, of_angle)];
    for place in 0..9 {
        let heights = matrices.iter().map(|matrix| matrix[place]).collect();
        all.push(kolmogorov(heights, of_height));
    }
    all
}

fn drawn() -> Vec<Rotation> {
    (0..u64::from(COUNT)).map(Rotation::random).collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn a_seed_gives_the_same_attitude_on_every_machine() {
    let file: Value =
        serde_json::from_str(include_str!("../vectors/alignment.json")).expect("JSON");
    for case in file["random"].as_array().expect("cases") {
        let seed: u64 = case["seed"]
            .as_str()
            .expect("digits")
            .parse()
            .expect("a seed");
        let got = Rotation::random(seed).to_tagged(Convention::HAMILTON);
        let expected: Vec<f64> = case["quaternion"]
            .as_array()
            .expect("four numbers")
            .iter()
            .map(|number| number.as_f64().expect("a number"))
            .collect();
        assert_close(&seed.to_string(), &got.to_array(), &expected, 1e-15);
    }
    // FNV-1a, 64 bits, of all bits of the first thousand.
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for rotation in (0..1000).map(Rotation::random) {
        for number in rotation.to_tagged(Convention::HAMILTON).to_array() {
            for byte in number.to_bits().to_le_bytes() {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
            }
        }
    }
    assert_eq!(hash, 9_696_510_108_817_065_536);
}

/// Their axes are random unit vectors (003-S5.2.12).
#[wasm_bindgen_test(unsupported = test)]
fn no_attitude_is_more_likely_than_another() {
    let attitudes = drawn();
    let found = statistics(&attitudes);
    let worst = found.iter().copied().fold(0.0, f64::max);
    assert!(worst < ONE_IN_A_THOUSAND, "{found:?}");

    // Neighbouring seeds are independent: the turn from one to the next is uniform too.
    let steps: Vec<Rotation> = attitudes
        .windows(2)
        .map(|pair| pair[0].turn_to(&pair[1]))
        .collect();
    let found = statistics(&steps);
    let worst = found.iter().copied().fold(0.0, f64::max);
    assert!(worst < ONE_IN_A_THOUSAND, "{found:?}");

    // The mean of each entry is 0 and of its square 1/3; four standard deviations.
    let count = f64::from(COUNT);
    let matrices = attitudes.iter().map(Rotation::body_to_world_matrix);
    let (mut sum, mut squares) = (Matrix3::zeros(), Matrix3::zeros());
    for matrix in matrices {
        sum += matrix;
        squares += matrix.component_mul(&matrix);
    }
    assert!(
        (sum / count).amax() < 4.0 * (1.0 / 3.0 / count).sqrt(),
        "{sum}"
    );
    let off = (squares / count).map(|square| square - 1.0 / 3.0);
    assert!(off.amax() < 4.0 * (4.0 / 45.0 / count).sqrt(), "{off}");
}

/// What is often written instead is told from it by the same statistics.
#[wasm_bindgen_test(unsupported = test)]
fn uniform_angles_and_uniform_components_are_found_out() {
    // Numbers that fill a cube evenly: multiples of roots that have no ratio.
    let even = |at: u32, place: usize| {
        let root = [2.0_f64, 3.0, 5.0, 7.0][place].sqrt();
        (f64::from(at) * root).fract()
    };
    let angles = |at| {
        let [yaw, pitch, roll] = [0, 1, 2].map(|place| TAU * even(at, place) - PI);
        let angles = [yaw, pitch / 2.0, roll];
        Rotation::from_euler_rad(EulerSequence::AEROSPACE, angles).expect("finite")
    };
    let components = |at| {
        let [w, x, y, z] = [0, 1, 2, 3].map(|place| 2.0 * even(at, place) - 1.0);
        let q = TaggedQuaternion::new(w, x, y, z, Convention::HAMILTON);
        Rotation::from_tagged(&q).expect("not zero")
    };
    let axis_and_angle = |at| {
        let direction = Rotation::random(u64::from(at)).body_to_world(Vector3::z());
        Rotation::from_axis_angle(direction.into(), PI * even(at, 0)).expect("an axis")
    };
    let naive: [Vec<Rotation>; 3] = [
        (1..=COUNT).map(angles).collect(),
        (1..=COUNT).map(components).collect(),
        (1..=COUNT).map(axis_and_angle).collect(),
    ];
    for attitudes in naive {
        let found = statistics(&attitudes);
        let worst = found.iter().copied().fold(0.0, f64::max);
        assert!(
            found[0] > 1.5 * ONE_IN_A_THOUSAND && worst > 4.0,
            "{found:?}"
        );
    }
}
