//! The worst error of every conversion beside those of nalgebra and glam: `cargo bench`.
//!
//! In units of u = 2^-53, against references of 50 digits; the cases, the measures and the bounds are
//! those of the test. NaN and panics are counted, and are not an error in u.

#![allow(clippy::print_stdout, reason = "it is a report")]

#[path = "../tests/support/measured/mod.rs"]
mod measured;

use measured::operations::OPERATIONS;
use measured::{Case, NO_BOUND, cases};
use quatlas::nalgebra::{Matrix3, Quaternion, Rotation3, Unit, UnitQuaternion, Vector3};
use quatlas::{EulerFrame, EulerSequence};
use std::panic;

/// A peer's way of doing an operation; `None` where it has none.
type Run = fn(&Case) -> Option<Vec<f64>>;

/// What stands for the result of a computation that does not come to an end.
const ENDLESS: Vec<f64> = Vec::new();

/// The worst error and how often there was none because the result was no number.
struct Worst {
    error: f64,
    group: String,
    not_a_number: usize,
    panics: usize,
    endless: usize,
    answered: bool,
}

fn main() {
    // A peer that panics is counted, not heard.
    panic::set_hook(Box::new(|_| {}));
    println!("Worst error in u = 2^-53 (NaN, panic, endless: in how many cases)");
    println!(
        "{:<40} {:>6} {:>10} {:>28} {:>28}   quatlas' worst case is",
        "operation", "bound", "quatlas", "nalgebra", "glam"
    );
    for operation in OPERATIONS {
        let ours = worst(operation, |case| Some((operation.run)(case)));
        let peers = [nalgebra(operation.name), glam(operation.name)]
            .map(|run| worst(operation, run).shown());
        println!(
            "{:<40} {:>6} {:>10} {:>28} {:>28}   {}",
            operation.name,
            operation.bound,
            ours.shown(),
            peers[0],
            peers[1],
            ours.group
        );
    }
}

fn worst(
    operation: &measured::operations::Operation,
    run: impl Fn(&Case) -> Option<Vec<f64>>,
) -> Worst {
    let mut worst = Worst {
        error: 0.0,
        group: String::new(),
        not_a_number: 0,
        panics: 0,
        endless: 0,
        answered: false,
    };
    for case in cases(operation.cases)
        .iter()
        .filter(|case| case.group != NO_BOUND)
    {
        let got = panic::catch_unwind(panic::AssertUnwindSafe(|| run(case)));
        match got {
            Err(_) => worst.panics += 1,
            Ok(None) => {}
            Ok(Some(got)) if got == ENDLESS => worst.endless += 1,
            Ok(Some(got)) => {
                worst.answered = true;
                let error = operation.measure.error(case, &got);
                if error.is_infinite() {
                    worst.not_a_number += 1;
                } else if error > worst.error {
                    worst.error = error;
                    worst.group.clone_from(&case.group);
                }
            }
        }
    }
    worst
}

impl Worst {
    fn shown(&self) -> String {
        if !self.answered {
            return if self.panics > 0 {
                format!("{} panic", self.panics)
            } else {
                "—".to_owned()
            };
        }
        let mut text = if self.error < 1e4 {
            format!("{:.2}", self.error)
        } else {
            format!("{:.0e}", self.error)
        };
        let others = [
            (self.not_a_number, "NaN"),
            (self.panics, "panic"),
            (self.endless, "endless"),
        ];
        for (count, what) in others {
            if count > 0 {
                text += &format!(" +{count} {what}");
            }
        }
        text
    }
}

fn nalgebra(operation: &str) -> Run {
    fn quaternion(case: &Case, place: usize) -> Quaternion<f64> {
        case.quaternion(place).components
    }
    fn unit(case: &Case, place: usize) -> UnitQuaternion<f64> {
        UnitQuaternion::from_quaternion(quaternion(case, place))
    }
    fn wxyz(quaternion: &Quaternion<f64>) -> Option<Vec<f64>> {
        Some(vec![quaternion.w, quaternion.i, quaternion.j, quaternion.k])
    }
    fn matrix(case: &Case) -> Matrix3<f64> {
        Matrix3::from_row_slice(&case.input)
    }
    fn rotation(case: &Case) -> Option<Rotation3<f64>> {
        // It perturbs a rotation until its distance from the matrix changes, which from one of 1e100
        // it never does.
        let matrix = matrix(case);
        ends_for(&matrix).then(|| Rotation3::from_matrix(&matrix))
    }
    fn ends_for(matrix: &Matrix3<f64>) -> bool {
        (1e-3..1e3).contains(&matrix.amax())
    }
    fn axes(sequence: EulerSequence) -> [Unit<Vector3<f64>>; 3] {
        sequence.axes.axes().map(|axis| {
            let mut vector = Vector3::zeros();
            vector[axis.index()] = 1.0;
            Unit::new_unchecked(vector)
        })
    }
    fn euler(case: &Case) -> Option<Vec<f64>> {
        let is_extrinsic = case.sequence().frame == EulerFrame::Extrinsic;
        let rotation = unit(case, 0).to_rotation_matrix();
        let (angles, _) = rotation.euler_angles_ordered(axes(case.sequence()), is_extrinsic);
        Some(angles.to_vec())
    }
    match operation {
        "normalise" => |case| wxyz(&quaternion(case, 0).normalize()),
        "quaternion to matrix" => |case| {
            let matrix = unit(case, 0).to_rotation_matrix().into_inner();
            Some(matrix.transpose().as_slice().to_vec())
        },
        "product" => |case| wxyz(&(quaternion(case, 0) * quaternion(case, 4))),
        "rotate a vector" => |case| Some((unit(case, 0) * case.vector(4)).as_slice().to_vec()),
        "matrix to quaternion" => |case| match rotation(case) {
            Some(rotation) => wxyz(&UnitQuaternion::from_rotation_matrix(&rotation)),
            None => Some(ENDLESS),
        },
        "quaternion to rotation vector" => {
            |case| Some(unit(case, 0).scaled_axis().as_slice().to_vec())
        }
        "matrix to rotation vector" => |case| match rotation(case) {
            Some(rotation) => Some(rotation.scaled_axis().as_slice().to_vec()),
            None => Some(ENDLESS),
        },
        "rotation vector to quaternion" => {
            |case| wxyz(&UnitQuaternion::from_scaled_axis(case.vector(0)))
        }
        "Euler angles to quaternion" => |case| {
            let [i, j, k] = axes(case.sequence());
            let turn = |axis: &Unit<Vector3<f64>>, place: usize| {
                UnitQuaternion::from_axis_angle(axis, case.input[place])
            };
            let (first, second, third) = (turn(&i, 0), turn(&j, 1), turn(&k, 2));
            wxyz(&match case.sequence().frame {
                EulerFrame::Intrinsic => *(first * second * third),
                EulerFrame::Extrinsic => *(third * second * first),
            })
        },
        "quaternion to Euler angles, each angle" | "quaternion to Euler angles, the rotation" => {
            euler
        }
        "slerp" => |case| wxyz(&unit(case, 0).slerp(&unit(case, 4), case.input[8])),
        "angle between" => |case| Some(vec![unit(case, 0).angle_to(&unit(case, 4))]),
        _ => |_| None,
    }
}

fn glam(operation: &str) -> Run {
    use glam::{DMat3, DQuat, DVec3, EulerRot};
    fn quaternion(case: &Case, place: usize) -> DQuat {
        let q = case.quaternion(place).components;
        DQuat::from_xyzw(q.i, q.j, q.k, q.w)
    }
    fn unit(case: &Case, place: usize) -> DQuat {
        quaternion(case, place).normalize()
    }
    fn vector(case: &Case, place: usize) -> DVec3 {
        DVec3::from_array(case.array(place))
    }
    fn wxyz(quaternion: DQuat) -> Option<Vec<f64>> {
        Some(vec![quaternion.w, quaternion.x, quaternion.y, quaternion.z])
    }
    fn matrix(case: &Case) -> DQuat {
        DQuat::from_mat3(&DMat3::from_cols_array(&case.array(0)).transpose())
    }
    fn sequence(case: &Case) -> EulerRot {
        use EulerRot::{
            XYX, XYXEx, XYZ, XYZEx, XZX, XZXEx, XZY, XZYEx, YXY, YXYEx, YXZ, YXZEx, YZX, YZXEx,
            YZY, YZYEx, ZXY, ZXYEx, ZXZ, ZXZEx, ZYX, ZYXEx, ZYZ, ZYZEx,
        };
        match case.sequence().to_string().as_str() {
            "XYZ" => XYZ,
            "XZY" => XZY,
            "YXZ" => YXZ,
            "YZX" => YZX,
            "ZXY" => ZXY,
            "ZYX" => ZYX,
            "XYX" => XYX,
            "XZX" => XZX,
            "YXY" => YXY,
            "YZY" => YZY,
            "ZXZ" => ZXZ,
            "ZYZ" => ZYZ,
            "xyz" => XYZEx,
            "xzy" => XZYEx,
            "yxz" => YXZEx,
            "yzx" => YZXEx,
            "zxy" => ZXYEx,
            "zyx" => ZYXEx,
            "xyx" => XYXEx,
            "xzx" => XZXEx,
            "yxy" => YXYEx,
            "yzy" => YZYEx,
            "zxz" => ZXZEx,
            _ => ZYZEx,
        }
    }
    fn euler(case: &Case) -> Option<Vec<f64>> {
        let (first, second, third) = unit(case, 0).to_euler(sequence(case));
        Some(vec![first, second, third])
    }
    match operation {
        "normalise" => |case| wxyz(unit(case, 0)),
        "quaternion to matrix" => |case| {
            let matrix = DMat3::from_quat(unit(case, 0)).transpose();
            Some(matrix.to_cols_array().to_vec())
        },
        "product" => |case| wxyz(quaternion(case, 0) * quaternion(case, 4)),
        "rotate a vector" => |case| Some((unit(case, 0) * vector(case, 4)).to_array().to_vec()),
        "matrix to quaternion" => |case| wxyz(matrix(case)),
        "quaternion to rotation vector" => {
            |case| Some(unit(case, 0).to_scaled_axis().to_array().to_vec())
        }
        "matrix to rotation vector" => {
            |case| Some(matrix(case).to_scaled_axis().to_array().to_vec())
        }
        "rotation vector to quaternion" => |case| wxyz(DQuat::from_scaled_axis(vector(case, 0))),
        "Euler angles to quaternion" => |case| {
            let [a, b, c] = case.array(0);
            wxyz(DQuat::from_euler(sequence(case), a, b, c))
        },
        "quaternion to Euler angles, each angle" | "quaternion to Euler angles, the rotation" => {
            euler
        }
        "slerp" => |case| wxyz(unit(case, 0).slerp(unit(case, 4), case.input[8])),
        "angle between" => |case| Some(vec![unit(case, 0).angle_between(unit(case, 4))]),
        _ => |_| None,
    }
}
