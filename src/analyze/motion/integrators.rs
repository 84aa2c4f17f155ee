//! How well steps of seven kinds follow a rate.

use crate::analyze::attitude::Attitude;
use crate::analyze::motion::course::Course;
use crate::analyze::motion::turned::{beyond_rounding, exponential, turned, unit};
use crate::contract::MotionRequest;
use crate::convention::Convention;
use crate::convention::euler_sequence::EulerSequence;
use crate::motion::integration::rotation_vector_runge_kutta_step;
use crate::motion::kinematics::IntegrationOrder;
use crate::rotation::Rotation;
use crate::rotation::quaternion::TaggedQuaternion;
use nalgebra::{UnitQuaternion, Vector3};

/// How often the asked number of steps is halved, or doubled, for the errors.
const MOST_DOUBLINGS: u32 = 4;

/// An error that is not this many times that of rounding shows no order.
const SHOWS_ORDER: f64 = 100.0;

/// What a step does.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    First,
    Second,
    Fourth,
    AddAndNormalise,
    RungeKuttaComponents,
    RungeKuttaAngles,
    RungeKuttaVector,
}

static KINDS: [Kind; 7] = [
    Kind::First,
    Kind::Second,
    Kind::Fourth,
    Kind::AddAndNormalise,
    Kind::RungeKuttaComponents,
    Kind::RungeKuttaAngles,
    Kind::RungeKuttaVector,
];

pub(super) fn integrators(
    attitude: &Attitude,
    course: &Course,
    end: &UnitQuaternion<f64>,
    steps: u32,
    sequence: EulerSequence,
) -> Vec<Vec<[f64; 5]>> {
    let run = Run {
        attitude,
        course,
        sequence,
    };
    // Of rounding where errors are compared, too.
    let rounding = course.rounding_rad(steps) + course.rounding_rad(MotionRequest::MOST_STEPS);
    let mut all = Vec::new();
    for &kind in &KINDS {
        all.push(run.errors(kind, end, steps, rounding));
    }
    all
}

struct Run<'a> {
    attitude: &'a Attitude,
    course: &'a Course,
    sequence: EulerSequence,
}

impl Run<'_> {
    /// What [`PathReport::integrators`](crate::PathReport::integrators) has of one kind.
    fn errors(
        &self,
        kind: Kind,
        end: &UnitQuaternion<f64>,
        steps: u32,
        rounding_rad: f64,
    ) -> Vec<[f64; 5]> {
        let mut finest = steps;
        let mut doublings = 0;
        while finest * 2 <= MotionRequest::MOST_STEPS && doublings < MOST_DOUBLINGS {
            finest *= 2;
            doublings += 1;
        }
        let mut errors: Vec<[f64; 5]> = Vec::new();
        for halvings in (0..=MOST_DOUBLINGS).rev() {
            let count = finest >> halvings;
            let mut norm_off = 0.0;
            let reached = self.reached(kind, count, &mut norm_off);
            let Some(reached) = reached.filter(|_| count > 0) else {
                continue;
            };
            let step = self.course.seconds / f64::from(count);
            let error_rad = beyond_rounding(end.angle_to(&reached), rounding_rad);
            let mut order = 0.0;
            if let Some(&[_, longer, before, ..]) = errors.last()
                && before.min(error_rad) > SHOWS_ORDER * rounding_rad
            {
                order = libm::log(before / error_rad) / libm::log(longer / step);
            }
            errors.push([f64::from(count), step, error_rad, norm_off, order]);
        }
        errors
    }

    /// The attitude at the end by so many steps; none where these numbers have no derivative on the way.
    fn reached(&self, kind: Kind, count: u32, norm_off: &mut f64) -> Option<UnitQuaternion<f64>> {
        let Course { axes, seconds, .. } = *self.course;
        let step = seconds / f64::from(count);
        let rate = |time| self.course.rate(time);
        let rotation = &self.attitude.rotation;
        let mut now = unit(self.attitude);
        let mut numbers = match kind {
            Kind::RungeKuttaAngles => rotation.euler(self.sequence).angles_rad.into(),
            _ => rotation.rotation_vector_rad(),
        };
        for at in 0..count {
            let time = step * f64::from(at);
            let order = match kind {
                Kind::First => IntegrationOrder::First,
                Kind::Second => IntegrationOrder::Second,
                Kind::Fourth => IntegrationOrder::Fourth,
                Kind::AddAndNormalise | Kind::RungeKuttaComponents => {
                    let tagged = TaggedQuaternion {
                        components: *now.quaternion(),
                        convention: Convention::HAMILTON,
                    };
                    let sum = if kind == Kind::AddAndNormalise {
                        let derivative = tagged.derivative(rate(time).into(), axes);
                        tagged.components + derivative * step
                    } else {
                        let sum = tagged.runge_kutta_sum(&rate, axes, time, step);
                        sum.ok()?.components
                    };
                    let (unit, norm) = UnitQuaternion::new_and_get(sum);
                    *norm_off = norm_off.max((norm - 1.0).abs());
                    now = unit;
                    continue;
                }
                Kind::RungeKuttaAngles => {
                    let sequence = self.sequence;
                    let angles = sequence.runge_kutta_step(numbers.into(), rate, axes, time, step);
                    numbers = angles.ok()?.into();
                    continue;
                }
                Kind::RungeKuttaVector => {
                    let vector = rotation_vector_runge_kutta_step(numbers, rate, axes, time, step);
                    numbers = vector.ok()?;
                    continue;
                }
            };
            now = turned(&now, axes, order.turn_rad(&rate, axes, time, step));
        }
        Some(match kind {
            Kind::RungeKuttaAngles => self.of_angles(numbers)?,
            Kind::RungeKuttaVector => exponential(numbers),
            _ => now,
        })
    }

    fn of_angles(&self, angles_rad: Vector3<f64>) -> Option<UnitQuaternion<f64>> {
        let rotation = Rotation::from_euler_rad(self.sequence, angles_rad.into()).ok()?;
        let unit = rotation.to_tagged(Convention::HAMILTON).components;
        Some(UnitQuaternion::new_unchecked(unit))
    }
}
