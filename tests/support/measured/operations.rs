//! The operations of the core, each with the bound of its error.

use super::{Case, Measure};
use quatlas::{Convention, MatrixConvention, Rotation, TaggedMatrix, hamilton_product};

/// An operation of the core with the bound that it must keep, in u.
pub(crate) struct Operation {
    pub(crate) name: &'static str,
    /// Where its cases are.
    pub(crate) cases: &'static str,
    pub(crate) measure: Measure,
    pub(crate) bound: f64,
    pub(crate) run: fn(&Case) -> Vec<f64>,
}

fn hamilton(rotation: &Rotation) -> Vec<f64> {
    rotation.to_tagged(Convention::HAMILTON).to_array().to_vec()
}

fn matrix(case: &Case) -> Rotation {
    let [a, b, c, d, e, f, g, h, i] = case.array(0);
    let matrix = TaggedMatrix::from_rows(
        [[a, b, c], [d, e, f], [g, h, i]],
        MatrixConvention::BODY_TO_WORLD,
    );
    Rotation::nearest_to_matrix(&matrix)
        .expect("a nearest rotation")
        .rotation
}

fn euler(case: &Case) -> Vec<f64> {
    case.rotation(0).euler(case.sequence()).angles_rad.to_vec()
}

pub(crate) fn slerp(case: &Case) -> Vec<f64> {
    let part = case.rotation(0).slerp(&case.rotation(4), case.input[8]);
    hamilton(&part.expect("finite"))
}

/// All operations with a bound.
pub(crate) const OPERATIONS: &[Operation] = &[
    Operation {
        name: "normalise",
        cases: "normalize",
        measure: Measure::EachRelative,
        bound: 1.0,
        run: |case| {
            let unit = case.quaternion(0).normalize().expect("not zero");
            unit.to_array().to_vec()
        },
    },
    Operation {
        name: "quaternion to matrix",
        cases: "matrix",
        measure: Measure::EachAbsolute,
        bound: 1.0,
        run: |case| {
            let matrix = case.rotation(0).body_to_world_matrix();
            matrix.transpose().as_slice().to_vec()
        },
    },
    Operation {
        name: "product",
        cases: "product",
        measure: Measure::Relative,
        bound: 1.0,
        run: |case| {
            let (p, q) = (case.quaternion(0), case.quaternion(4));
            let product = hamilton_product(&p.components, &q.components);
            vec![product.w, product.i, product.j, product.k]
        },
    },
    Operation {
        name: "rotate a vector",
        cases: "rotate",
        measure: Measure::OfInputVector(4),
        bound: 1.2,
        run: |case| {
            let turned = case.rotation(0).body_to_world(case.vector(4));
            turned.as_slice().to_vec()
        },
    },
    Operation {
        name: "matrix to quaternion",
        cases: "quaternion_from_matrix",
        measure: Measure::RelativeUpToSign,
        bound: 1.0,
        run: |case| hamilton(&matrix(case)),
    },
    Operation {
        name: "quaternion to rotation vector",
        cases: "rotation_vector_from_quaternion",
        measure: Measure::Relative,
        bound: 4.0,
        run: |case| case.rotation(0).rotation_vector_rad().as_slice().to_vec(),
    },
    Operation {
        name: "matrix to rotation vector",
        cases: "rotation_vector_from_matrix",
        measure: Measure::RelativeUpToSign,
        bound: 6.0,
        run: |case| matrix(case).rotation_vector_rad().as_slice().to_vec(),
    },
    Operation {
        name: "rotation vector to quaternion",
        cases: "quaternion_from_rotation_vector",
        measure: Measure::Relative,
        bound: 3.0,
        run: |case| {
            let rotation = Rotation::from_rotation_vector_rad(case.array(0));
            hamilton(&rotation.expect("finite"))
        },
    },
    Operation {
        name: "Euler angles to quaternion",
        cases: "quaternion_from_euler",
        measure: Measure::Relative,
        bound: 4.0,
        run: |case| {
            let rotation = Rotation::from_euler_rad(case.sequence(), case.array(0));
            hamilton(&rotation.expect("finite"))
        },
    },
    Operation {
        name: "quaternion to Euler angles, each angle",
        cases: "euler_from_quaternion",
        measure: Measure::EachAngle,
        bound: 12.0,
        run: euler,
    },
    Operation {
        name: "quaternion to Euler angles, the rotation",
        cases: "euler_from_quaternion",
        measure: Measure::EulerRotation,
        bound: 16.0,
        run: euler,
    },
    Operation {
        name: "slerp",
        cases: "slerp",
        measure: Measure::Relative,
        bound: 3.0,
        run: slerp,
    },
    Operation {
        name: "angle between",
        cases: "angle_between",
        measure: Measure::Relative,
        bound: 6.0,
        run: |case| vec![case.rotation(0).angle_to_rad(&case.rotation(4))],
    },
];
