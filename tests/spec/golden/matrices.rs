//! Golden cases of matrices and Euler angles: numbers that were not made by quatlas.

use crate::golden::{Case, exponential};
use crate::rows::row_major;
use crate::support::assert_close;
use quatlas::nalgebra::Matrix3;
use quatlas::{
    Axis, Convention, EulerFrame, EulerSequence, Handedness, IncrementSign, MatrixConvention,
    Perturbation, Rotation, TaggedMatrix,
};
use wasm_bindgen_test::wasm_bindgen_test;

/// The sequence that a case names by three digits.
fn sequence(case: &Case, frame: EulerFrame) -> EulerSequence {
    let digits: [f64; 3] = case.input("seq");
    let is_named = |axes: [Axis; 3]| {
        let places = axes.map(|axis| axis.index() + 1);
        places
            .into_iter()
            .zip(digits)
            .all(|(place, digit)| place as f64 == digit)
    };
    EulerSequence::all()
        .find(|sequence| sequence.frame == frame && is_named(sequence.axes.axes()))
        .expect("a sequence")
}

#[wasm_bindgen_test(unsupported = test)]
fn g12_to_g15_matrix_to_quaternion_where_each_component_is_the_largest() {
    for number in 12..=15 {
        let case = Case::find(&format!("G{number}"));
        // With the same function and direction on both sides only the hand decides.
        for (name, handedness) in [
            ("right_same", Handedness::Right),
            ("left_same", Handedness::Left),
        ] {
            for convention in MatrixConvention::all() {
                let matrix = TaggedMatrix {
                    entries: case.matrix("input", "M"),
                    convention,
                };
                let nearest = Rotation::nearest_to_matrix(&matrix).expect("a rotation");
                assert!(nearest.correction < 1e-15, "{}", case.id);
                let q = nearest.rotation.to_tagged(Convention {
                    handedness,
                    function: convention.function,
                    direction: convention.direction,
                    ..Convention::HAMILTON
                });
                // The sign is free: that of the scalar is positive in the case.
                let sign = q.components.w.signum();
                case.check(name, &q.to_array().map(|number| number * sign));
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn g20_to_g22_euler_angles_of_successive_and_of_fixed_axes() {
    for number in 20..=22 {
        let case = Case::find(&format!("G{number}"));
        for (name, frame) in [
            ("successive", EulerFrame::Intrinsic),
            ("fixed", EulerFrame::Extrinsic),
        ] {
            let sequence = sequence(&case, frame);
            let angles: [f64; 3] = case.input("angles");
            let attitude = Rotation::from_euler_rad(sequence, angles).expect("finite");
            let matrix = row_major(&attitude.body_to_world_matrix());
            case.check(&format!("R_{name}"), &matrix);
            let q = attitude.to_tagged(Convention::HAMILTON);
            case.check(&format!("q_{name}"), &q.to_array());

            let given = TaggedMatrix {
                entries: case.matrix("output", &format!("R_{name}")),
                convention: MatrixConvention::BODY_TO_WORLD,
            };
            let read = Rotation::nearest_to_matrix(&given).expect("a rotation");
            let euler = read.rotation.euler(sequence);
            assert_close(&case.id, &euler.angles_rad, &angles, case.tolerance);
            assert_eq!(euler.gimbal_lock, None, "{}", case.id);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn g23_a_pitch_of_a_quarter_turn_is_locked_and_has_a_canonical_triple() {
    let case = Case::find("G23");
    let given = TaggedMatrix {
        entries: case.matrix("input", "M"),
        convention: MatrixConvention::BODY_TO_WORLD,
    };
    let nearest = Rotation::nearest_to_matrix(&given).expect("a rotation");
    let euler = nearest.rotation.euler(EulerSequence::AEROSPACE);
    let lock = euler.gimbal_lock.expect("locked");
    case.check("angles", &lock.canonical_rad);
    let again = Rotation::from_euler_rad(EulerSequence::AEROSPACE, lock.canonical_rad);
    let matrix = again.expect("finite").body_to_world_matrix();
    case.check("R", &row_major(&matrix));
}

#[wasm_bindgen_test(unsupported = test)]
fn g33_a_turn_added_to_the_matrix_of_either_direction() {
    let case = Case::find("G33");
    let attitude = exponential(case.input("v_WB"));
    let delta: [f64; 3] = case.input("delta");
    for convention in MatrixConvention::all() {
        let name = if convention.operator() == MatrixConvention::BODY_TO_WORLD.operator() {
            "R_WB"
        } else {
            "R_BW"
        };
        let matrix = attitude.to_tagged_matrix(convention);
        for (axes, side) in [
            (Perturbation::Local, "local"),
            (Perturbation::Global, "global"),
        ] {
            let after = matrix
                .plus(delta, axes, IncrementSign::Physical)
                .expect("finite");
            case.check(&format!("{name}_{side}"), &row_major(&after.entries));
            let entries: Matrix3<f64> = case.matrix("output", &format!("{name}_{side}"));
            let difference = TaggedMatrix {
                entries,
                convention,
            }
            .minus(&matrix, axes, IncrementSign::Physical)
            .expect("rotations");
            assert_close(name, difference.as_slice(), &delta, case.tolerance);
        }
    }
}
