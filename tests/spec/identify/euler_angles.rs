//! FX-11: the sequence and the direction of a library of Euler angles.

use crate::reference::{CLOSE, assert_same, elementary};
use quatlas::nalgebra::Matrix3;
use quatlas::{AngleUnit, Direction, EulerFrame, EulerReading};
use std::f64::consts::PI;
use wasm_bindgen_test::wasm_bindgen_test;

/// What a library that reads angles so prints, with so many decimals.
fn rounded(matrix: Matrix3<f64>, decimals: i32) -> Matrix3<f64> {
    let unit = 10.0_f64.powi(decimals);
    matrix.map(|entry| (entry * unit).round() / unit)
}

/// The matrix of three angles by elementary turns alone.
fn by_elementary_turns(reading: EulerReading, angles: [f64; 3]) -> Matrix3<f64> {
    let axes = reading.sequence.axes.axes();
    let [a, b, c] = [0, 1, 2].map(|slot| {
        let angle_rad = match reading.unit {
            AngleUnit::Radians => angles[slot],
            AngleUnit::Degrees => angles[slot].to_radians(),
        };
        elementary(axes[slot].index(), angle_rad)
    });
    let body_to_world = match reading.sequence.frame {
        EulerFrame::Intrinsic => a * b * c,
        EulerFrame::Extrinsic => c * b * a,
    };
    match reading.direction {
        Direction::BodyToWorld => body_to_world,
        Direction::WorldToBody => body_to_world.transpose(),
    }
}

/// FX-11: 48 libraries, and as many that take degrees, by one print with four decimals.
#[wasm_bindgen_test(unsupported = test)]
fn the_sequence_and_direction_of_an_euler_library_are_told() {
    let all: Vec<EulerReading> = EulerReading::all().collect();
    assert_eq!(all.len(), 96);
    for (angles, margin_deg) in [([0.7, -0.4, 1.1], 9.0_f64), ([30.0, 20.0, 10.0], 2.78)] {
        let prints: Vec<Matrix3<f64>> = all
            .iter()
            .map(|reading| by_elementary_turns(*reading, angles))
            .collect();
        // In degrees the first are small turns, nearly the same in any order.
        let is_told =
            |reading: &EulerReading| angles[0] > 1.0 || reading.unit == AngleUnit::Radians;
        for (reading, print) in all
            .iter()
            .zip(&prints)
            .filter(|(reading, _)| is_told(reading))
        {
            assert_same(
                "the matrix",
                &reading.matrix(angles).expect("finite"),
                print,
                CLOSE,
            );
            let found = EulerReading::recognize(&[(angles, rounded(*print, 4))], 0.01);
            let [(told, off_rad)] = &found[..] else {
                panic!("{reading:?}: {found:?}")
            };
            assert_eq!(told, reading);
            assert!(*off_rad < 2e-4, "{off_rad}");
            // How near the nearest other one is, is what the tolerance may be.
            let found = EulerReading::recognize(&[(angles, *print)], PI);
            assert_eq!(found[0].0, *reading);
            assert!(found[1].1.to_degrees() > margin_deg, "{:?}", found[1]);
            assert!(found.is_sorted_by_key(|(_, off_rad)| *off_rad));
        }
    }
}

/// FX-11 by its steps: a small turn in each slot tells the axes and the direction, one set of angles the
/// frame; nothing that is no rotation is told.
#[wasm_bindgen_test(unsupported = test)]
fn small_turns_in_each_slot_leave_the_two_frames_of_a_sequence() {
    let recognize = |prints: &[([f64; 3], Matrix3<f64>)]| {
        let found = EulerReading::recognize(prints, 1e-3);
        found
            .into_iter()
            .map(|(reading, _)| reading)
            .collect::<Vec<_>>()
    };
    let in_radians = EulerReading::all().filter(|reading| reading.unit == AngleUnit::Radians);
    for reading in in_radians {
        let print = |angles| (angles, by_elementary_turns(reading, angles));
        let slots = [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]];
        let mut prints = slots.map(print).to_vec();
        let mut left = recognize(&prints);
        assert_eq!(left.len(), 2, "{reading:?}: {left:?}");
        left.retain(|other| other.sequence.frame == reading.sequence.frame);
        assert_eq!(left, [reading]);
        prints.push(print([0.7, -0.4, 1.1]));
        assert_eq!(recognize(&prints), [reading]);
        // The same print with another sign is that of no library.
        let (angles, matrix) = print([0.7, -0.4, 1.1]);
        assert_eq!(recognize(&[(angles, -matrix)]), []);
        assert_eq!(recognize(&[(angles, matrix * f64::NAN)]), []);
        assert_eq!(recognize(&[([f64::NAN; 3], matrix)]), []);
    }
}
