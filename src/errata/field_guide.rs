//! Witnesses for the field guide; its two cosine matrices are those of Cheng 2018. The printed
//! formulas are transcribed to the letter, and stand nowhere else.

use crate::convention::Convention;
use crate::convention::euler_sequence::{EulerAxes, EulerSequence};
use crate::errata::witness::{EXAMPLE, Sides, Witness, exponential, hamilton, known, turn};
use crate::rotation::Rotation;
use crate::rotation::quaternion::TaggedQuaternion;
use nalgebra::{Matrix3, Matrix4, Vector3, Vector4};
use std::f64::consts::FRAC_PI_2;

/// A singular value below this counts as nothing: each of the examples is below 1e-13 or above 0.4.
const RANK_TOLERANCE: f64 = 1e-6;

/// How many of all strings of three axes reach every attitude near the example.
fn usable_strings() -> usize {
    let strings = (0..27).map(|number: usize| [number / 9, number / 3 % 3, number % 3]);
    strings.filter(|axes| rank_of_rates(*axes) == 3).count()
}

/// How many of the three axes, each as the turns before it have left it, are independent.
fn rank_of_rates(axes: [usize; 3]) -> usize {
    let units = axes.map(|axis| {
        let mut unit = Vector3::zeros();
        unit[axis] = 1.0;
        unit
    });
    let first = turn(units[0].into(), 0.3);
    let second = first * turn(units[1].into(), 0.7);
    let columns = [
        units[0],
        first.body_to_world(units[1]),
        second.body_to_world(units[2]),
    ];
    Matrix3::from_columns(&columns).rank(RANK_TOLERANCE)
}

fn count(number: usize) -> f64 {
    number as f64
}

/// E21: the count, and how many of the 27 strings have a rate map of rank 3.
pub(crate) fn euler_sequences() -> Witness {
    let usable = count(usable_strings());
    Witness::new(
        "all 27 strings of three axes, at the angles 0.3, 0.7 and any third",
        Sides::new().number(3.0 * 3.0 * 3.0, usable),
        Sides::new()
            .number(count(EulerAxes::ALL.len()), usable)
            .number(count(EulerSequence::all().count()), 2.0 * usable),
    )
}

/// E22: the two directions, for a function that the printed line takes for symmetric; for the angle
/// between two attitudes.
pub(crate) fn symmetry() -> Witness {
    let f = |a: f64, b: f64| (a - b).max(0.0) + 2.0 * (b - a).max(0.0);
    let a = exponential(Vector3::new(0.4, -0.7, 1.1));
    let b = exponential(Vector3::new(-0.3, 0.5, 0.2));
    Witness::new(
        "f(a, b) = max(a − b, 0) + 2 max(b − a, 0) at 0 and 1; the angle between the turns by \
         (0.4, −0.7, 1.1) and (−0.3, 0.5, 0.2)",
        Sides::new().number(f(0.0, 1.0), f(1.0, 0.0)),
        Sides::new().number(a.angle_to_rad(&b), b.angle_to_rad(&a)),
    )
}

/// E23: the printed chain with `R_2^0` the composite; the turn about the moved axis.
pub(crate) fn similarity() -> Witness {
    let (first, axis, angle) = (
        exponential(Vector3::new(0.4, -0.7, 1.1)),
        Vector3::new(2.0, 3.0, 6.0) / 7.0,
        0.9,
    );
    let fixed = turn(axis.into(), angle);
    let moving = turn(first.world_to_body(axis).into(), angle).body_to_world_matrix();
    let composite = (fixed * first).body_to_world_matrix();
    let (a, q) = (first.body_to_world_matrix(), fixed.body_to_world_matrix());
    let seen_from_1 = |rotation: Matrix3<f64>| a.transpose() * rotation * a;
    Witness::new(
        "A the turn by (0.4, −0.7, 1.1), Q that by 0.9 about (2, 3, 6)/7",
        Sides::new().matrix(&composite, &(a * seen_from_1(composite))),
        Sides::new()
            .matrix(&moving, &seen_from_1(q))
            .matrix(&composite, &(a * seen_from_1(q))),
    )
}

/// E24: the sum of two rotation vectors and the product of their rotations; Exp of Log.
pub(crate) fn rotation_vectors() -> Witness {
    let (a, b) = (Vector3::x() * FRAC_PI_2, Vector3::y() * FRAC_PI_2);
    let product = exponential(a) * exponential(b);
    let matrix = |rotation: Rotation| rotation.body_to_world_matrix();
    Witness::new(
        "a and b quarter turns about x and y",
        Sides::new().matrix(&matrix(exponential(a + b)), &matrix(product)),
        Sides::new().matrix(
            &matrix(exponential(product.rotation_vector_rad())),
            &matrix(product),
        ),
    )
}

/// How far the attitude is turned each way for a difference of its quaternions.
const STEP_RAD: f64 = 1e-3;

/// E27: the numbers, and in how many independent directions they move when the attitude is turned
/// about as many axes.
pub(crate) fn minimality() -> Witness {
    let attitude = known(Rotation::from_tagged(&TaggedQuaternion {
        components: EXAMPLE,
        convention: Convention::HAMILTON,
    }));
    let axes = [
        Vector3::x(),
        Vector3::y(),
        Vector3::z(),
        Vector3::new(2.0, 3.0, 6.0) / 7.0,
    ];
    let directions = axes.map(|axis| -> Vector4<f64> {
        let moved = |step: f64| hamilton(&(attitude * exponential(axis * step))).coords;
        (moved(STEP_RAD) - moved(-STEP_RAD)) / (2.0 * STEP_RAD)
    });
    let freedom = count(Matrix4::from_columns(&directions).rank(RANK_TOLERANCE));
    let numbers = count(EXAMPLE.coords.len());
    Witness::new(
        "q = (0.8, 0.2, 0.4, 0.4), turned a little about x, y, z and (2, 3, 6)/7",
        Sides::new().number(numbers, freedom),
        Sides::new().number(numbers - 1.0, freedom),
    )
}
