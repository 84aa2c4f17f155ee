//! Witnesses for the ME 495 lecture. The printed formulas are transcribed to the letter, and stand
//! nowhere else.

use crate::convention::matrix::{CosineMatrix, MatrixConvention};
use crate::errata::witness::{
    EXAMPLE, EXAMPLE_TEXT, I, J, K, Sides, Witness, exponential, hamilton, known, pure, turn,
};
use crate::rotation::Rotation;
use crate::rotation::quaternion::hamilton_product;
use crate::rotation::tagged_matrix::TaggedMatrix;
use nalgebra::{Matrix3, Quaternion, Vector3};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// E12: the premise and the conclusion for three equal columns; for a rotation and its mirror image.
pub(crate) fn determinant() -> Witness {
    let unit: Vector3<f64> = Vector3::new(2.0, 3.0, 6.0) / 7.0;
    let equal = Matrix3::from_columns(&[unit, unit, unit]);
    let lengths = equal.column_iter().fold(Sides::new(), |sides, column| {
        sides.number(column.norm(), 1.0)
    });
    let rotation = exponential(Vector3::new(0.4, -0.7, 1.1)).body_to_world_matrix();
    let mirrored = rotation * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, -1.0));
    let corrected = [rotation, mirrored]
        .iter()
        .fold(Sides::new(), |sides, matrix| {
            sides
                .matrix(&(matrix.transpose() * matrix), &Matrix3::identity())
                .number(matrix.determinant().abs(), 1.0)
        });
    Witness::new(
        "three columns (2, 3, 6)/7; the turn by (0.4, −0.7, 1.1), and its mirror image",
        lengths.number(equal.determinant().abs(), 1.0),
        corrected,
    )
}

/// E13: the two equalities of the chain.
pub(crate) fn product_of_k_and_i() -> Witness {
    let (ki, ik) = (hamilton_product(&K, &I), hamilton_product(&I, &K));
    let chain = |middle: &Quaternion<f64>| {
        Sides::new()
            .quaternion(&ki, &-middle)
            .quaternion(&-middle, &J)
    };
    Witness::new("the Hamilton products of k and i", chain(&ki), chain(&ik))
}

/// E14: the components of p on the turned axes, by their definition.
pub(crate) fn turned_frame() -> Witness {
    let (angle, p) = (0.5, Vector3::new(2.0, 1.0, 0.0));
    let (sine, cosine) = libm::sincos(angle);
    let frame = turn(Z, angle);
    let on_axes = [Vector3::x(), Vector3::y(), Vector3::z()]
        .map(|axis| frame.body_to_world(axis).dot(&p))
        .into();
    let printed = Vector3::new(cosine * p.x - sine * p.y, sine * p.x + cosine * p.y, p.z);
    Witness::new(
        "θ = 0.5, p = (2, 1)",
        Sides::new().vector(&printed, &on_axes),
        Sides::new().vector(&frame.world_to_body(p), &on_axes),
    )
}

/// E15: `Q P` would be a vector if it were P turned and stretched; it is as long as P and none.
pub(crate) fn one_sided_product() -> Witness {
    let (q, p) = (EXAMPLE, Vector3::new(1.0, 2.0, 3.0));
    let v = Vector3::from(q.vector());
    let axis = v / v.norm();
    let along = axis * axis.dot(&p);
    let across = p - along;
    // Half the angle of the rotation is the angle whose cosine is w.
    let half_turned = turn(axis.into(), libm::atan2(v.norm(), q.w)).body_to_world(across);
    let (left, inverse) = (hamilton_product(&q, &pure(&p)), q.conjugate());
    let along_both = hamilton_product(&hamilton_product(&q, &pure(&along)), &inverse);
    Witness::new(
        "Q = (0.8, 0.2, 0.4, 0.4), p = (1, 2, 3)",
        Sides::new().number(left.w, 0.0),
        Sides::new()
            .number(left.norm(), p.norm())
            .number(left.w, -v.dot(&p))
            .quaternion(&hamilton_product(&q, &pure(&across)), &pure(&half_turned))
            .quaternion(
                &hamilton_product(&pure(&across), &inverse),
                &pure(&half_turned),
            )
            .quaternion(&along_both, &pure(&along)),
    )
}

/// E16: the quaternions, and their matrices.
pub(crate) fn two_quaternions() -> Witness {
    let matrix = |q| CosineMatrix::Hamilton.of(q).unwrap_or_default();
    Witness::new(
        EXAMPLE_TEXT,
        Sides::new().quaternion(&EXAMPLE, &-EXAMPLE),
        Sides::new().matrix(&matrix(&EXAMPLE), &matrix(&-EXAMPLE)),
    )
}

/// E17: the third axis, and the determinant of the matrix whose columns are all three.
pub(crate) fn third_axis() -> Witness {
    let (sine, cosine) = libm::sincos(FRAC_PI_4);
    let turned = turn(Z, FRAC_PI_4).body_to_world(Vector3::z());
    let statement = |third: Vector3<f64>| {
        let x = Vector3::new(cosine, sine, 0.0);
        let y = Vector3::new(-sine, cosine, 0.0);
        let determinant = Matrix3::from_columns(&[x, y, third]).determinant();
        Sides::new()
            .vector(&third, &turned)
            .number(determinant, 1.0)
    };
    Witness::new(
        "θ = π/4",
        statement(Vector3::new(0.0, 0.0, 0.0)),
        statement(Vector3::new(0.0, 0.0, 1.0)),
    )
}

/// E18: the double product with the quaternion and with its inverse.
pub(crate) fn change_of_frame() -> Witness {
    let q = hamilton(&turn(Z, FRAC_PI_4));
    let p = pure(&Vector3::new(FRAC_1_SQRT_2, FRAC_1_SQRT_2, 0.0));
    let sandwich =
        |left: &Quaternion<f64>| hamilton_product(&hamilton_product(left, &p), &left.conjugate());
    Witness::new(
        "θ = π/4 about z, p_a = (1, 1, 0)/√2",
        Sides::new().quaternion(&sandwich(&q), &I),
        Sides::new()
            .quaternion(&sandwich(&q.conjugate()), &I)
            .quaternion(&sandwich(&q), &J),
    )
}

/// `max(RᵀR − I) < 1e-12` and `det(R) − 1 < 1e-12`, without absolute values.
fn passes_as_printed(matrix: &Matrix3<f64>) -> bool {
    let largest = (matrix.transpose() * matrix - Matrix3::identity()).max();
    largest < 1e-12 && matrix.determinant() - 1.0 < 1e-12
}

/// E19: what the test says (1 for yes) about a rotation and four matrices that are none.
pub(crate) fn acceptance() -> Witness {
    let rotation = exponential(Vector3::new(0.4, -0.7, 1.1)).body_to_world_matrix();
    let others = [
        Matrix3::zeros(),
        rotation * 0.5,
        Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, -1.0)),
        -Matrix3::identity(),
    ];
    let statement = |passes: fn(&Matrix3<f64>) -> bool| {
        let verdict = |matrix| f64::from(u8::from(passes(matrix)));
        let accepted = Sides::new().number(verdict(&rotation), 1.0);
        others
            .iter()
            .fold(accepted, |sides, matrix| sides.number(verdict(matrix), 0.0))
    };
    Witness::new(
        "R, the turn by (0.4, −0.7, 1.1); the zero matrix, R/2, diag(1, 1, −1) and −I",
        statement(passes_as_printed),
        statement(|matrix| tagged(matrix).is_rotation()),
    )
}

fn tagged(matrix: &Matrix3<f64>) -> TaggedMatrix {
    TaggedMatrix {
        entries: *matrix,
        convention: MatrixConvention::BODY_TO_WORLD,
    }
}

/// The listing `so3_to_axis_angle`.
fn axis_angle_as_printed(r: &Matrix3<f64>) -> (Vector3<f64>, f64) {
    let no_turn = (Vector3::repeat(1.0 / 3.0_f64.sqrt()), 0.0);
    let angle = libm::acos((r.trace() - 1.0) / 2.0);
    if angle <= 1e-12 {
        return no_turn;
    }
    let differences = Vector3::new(
        r[(2, 1)] - r[(1, 2)],
        r[(0, 2)] - r[(2, 0)],
        r[(1, 0)] - r[(0, 1)],
    );
    let axis = differences * (1.0 / (2.0 * libm::sin(angle)));
    if axis.iter().any(|number| !number.is_finite()) {
        return no_turn;
    }
    (axis, angle)
}

/// The listing `axis_angle_to_so3`, which is in order.
fn rodrigues(axis: &Vector3<f64>, angle: f64) -> Matrix3<f64> {
    let (sine, cosine) = libm::sincos(angle);
    let hat = axis.cross_matrix();
    Matrix3::identity() + hat * sine + hat * hat * (1.0 - cosine)
}

/// E20: to axis and angle and back, for a turn where the listing holds and for half a turn.
pub(crate) fn half_turn() -> Witness {
    let turned = exponential(Vector3::new(0.4, -0.7, 1.1)).body_to_world_matrix();
    let half_turned = Matrix3::new(-7.0, 4.0, 4.0, 4.0, -1.0, 8.0, 4.0, 8.0, -1.0) / 9.0;
    let statement = |there_and_back: fn(&Matrix3<f64>) -> Matrix3<f64>| {
        Sides::new()
            .matrix(&there_and_back(&turned), &turned)
            .matrix(&there_and_back(&half_turned), &half_turned)
    };
    Witness::new(
        "the turn by (0.4, −0.7, 1.1), and half a turn about (1, 2, 2)/3",
        statement(|matrix| {
            let (axis, angle) = axis_angle_as_printed(matrix);
            rodrigues(&axis, angle)
        }),
        statement(|matrix| {
            let nearest = Rotation::nearest_to_matrix(&tagged(matrix));
            let vector = known(nearest.map(|nearest| nearest.rotation)).rotation_vector_rad();
            exponential(vector).body_to_world_matrix()
        }),
    )
}
