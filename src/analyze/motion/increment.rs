//! What a small turn makes of an attitude.

use crate::analyze::attitude::Attitude;
use crate::analyze::motion::sided::{conventions, sided, sigma};
use crate::analyze::motion::turned::{
    MISTAKES, axes_of, exponential, mistake, rounding_rad, turned, unit,
};
use crate::analyze::plain_numbers::{coordinates, plain3, rows3};
use crate::contract::{Components, IncrementReport};
use crate::convention::side::IncrementSign;
use crate::convention::{Direction, Perturbation};
use crate::motion::kinematics::RateAxes;
use crate::motion::perturbation::{small_angle_matrix, small_angle_quaternion};
use crate::rotation::Rotation;
use nalgebra::{UnitQuaternion, Vector3};

pub(super) fn of_increment(
    attitude: &Attitude,
    increment: Vector3<f64>,
    increment_sign: IncrementSign,
) -> IncrementReport {
    let declared = attitude.tagged.convention;
    let axes = match declared.perturbation {
        Perturbation::Local => RateAxes::Body,
        Perturbation::Global => RateAxes::World,
    };
    // The turn that the declared convention makes of these numbers is the same in all others.
    let turn = increment * declared.increment_factor(increment_sign) * sigma(declared);
    let (body, world) = attitude.on_both_axes(turn, axes);
    let mut plus = Vec::new();
    let mut minus = Vec::new();
    for perturbation in [Perturbation::Local, Perturbation::Global] {
        for convention in conventions(attitude, perturbation) {
            let formal = turn * sigma(convention);
            for (list, formal) in [(&mut plus, formal), (&mut minus, -formal)] {
                let factor = *exponential(formal).quaternion();
                list.push(sided(attitude, convention, factor, 1.0));
            }
        }
    }
    let q = unit(attitude);
    let after = turned(&q, axes, turn);
    let matrix = Rotation::from(after).matrix(Direction::BodyToWorld);
    let mut mistakes = Vec::new();
    for &(kind, factor) in &MISTAKES {
        let wrong = turn * factor;
        let rounding = rounding_rad(wrong.norm(), 1.0);
        let wrong = turned(&q, axes_of(kind, axes), wrong);
        mistakes.push(mistake(kind, &after, &wrong, rounding));
    }
    let exact = exponential(turn);
    let small = small_angle_quaternion(turn.into());
    let small_matrix = small_angle_matrix(turn.into());
    let exact_matrix = Rotation::from(exact).matrix(Direction::BodyToWorld);
    let formal = turn * sigma(declared);
    IncrementReport {
        body_rad: coordinates(&body),
        world_rad: coordinates(&world),
        plus,
        minus,
        body_to_world: rows3(&matrix),
        small_angle_quaternion: Components::of(
            &small_angle_quaternion(formal.into()),
            declared.order,
        ),
        small_angle_matrix: rows3(&small_matrix),
        small_angle_off: plain3([
            (exact.coords - small.coords).norm(),
            (exact_matrix - small_matrix).norm(),
            exact.angle_to(&UnitQuaternion::new_normalize(small)),
        ]),
        mistakes,
    }
}
