//! What the crates of tests share.

use quatlas::nalgebra::Quaternion;
use quatlas::{ComponentOrder, Convention, Direction, Function, Handedness, Perturbation};

/// All 32 conventions, in the order of the table of the specification (section 2.4).
pub(crate) fn all_conventions() -> Vec<Convention> {
    let mut all = Vec::new();
    for order in ComponentOrder::ALL {
        for handedness in Handedness::ALL {
            for function in Function::ALL {
                for direction in Direction::ALL {
                    for perturbation in Perturbation::ALL {
                        all.push(Convention {
                            order,
                            handedness,
                            function,
                            direction,
                            perturbation,
                        });
                    }
                }
            }
        }
    }
    all
}

/// Compares lists of numbers with a tolerance that is absolute and scaled by max(1, |expected|).
#[track_caller]
pub(crate) fn assert_close(what: &str, got: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(
        got.len(),
        expected.len(),
        "{what}: got {got:?}, expected {expected:?}"
    );
    for (number, wanted) in got.iter().zip(expected) {
        assert!(
            (number - wanted).abs() <= tolerance * wanted.abs().max(1.0),
            "{what}: got {got:?}, expected {expected:?}"
        );
    }
}

pub(crate) fn wxyz(quaternion: &Quaternion<f64>) -> [f64; 4] {
    [quaternion.w, quaternion.i, quaternion.j, quaternion.k]
}
