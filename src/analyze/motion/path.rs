//! Where an attitude goes in time.

use crate::analyze::attitude::Attitude;
use crate::analyze::describe::turn;
use crate::analyze::motion::course::Course;
use crate::analyze::motion::integrators::integrators;
use crate::analyze::motion::turned::{MISTAKES, axes_of, mistake, unit};
use crate::contract::{Components, MotionRequest, PathReport};
use crate::rotation::Rotation;
use nalgebra::{Quaternion, UnitQuaternion};

/// The last attitude of a path.
fn last(moments: &[[f64; 5]], otherwise: &UnitQuaternion<f64>) -> UnitQuaternion<f64> {
    moments.last().map_or(*otherwise, |&[_, w, x, y, z]| {
        UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z))
    })
}

pub(super) fn of_course(
    attitude: &Attitude,
    course: &Course,
    request: &MotionRequest,
) -> PathReport {
    let steps = request.steps.clamp(1, MotionRequest::MOST_STEPS);
    let from = unit(attitude);
    let moments = course.followed(&from, steps);
    let end = last(&moments, &from);
    let mut ways = vec![moments];
    let mut mistakes = Vec::new();
    // Degrees that are taken for radians turn so often that nobody sees how.
    for &(kind, factor) in &MISTAKES[..3] {
        let wrong = course.times(factor, axes_of(kind, course.axes));
        let way = wrong.followed(&from, steps);
        let rounding = wrong.rounding_rad(steps) + course.rounding_rad(steps);
        mistakes.push(mistake(kind, &end, &last(&way, &from), rounding));
        ways.push(way);
    }
    let rotation = Rotation::from(end);
    let declared = attitude.tagged.convention;
    PathReport {
        ways,
        end: Components::of(&rotation.to_tagged(declared).components, declared.order),
        turn: turn(&rotation),
        integrators: integrators(attitude, course, &end, steps, request.euler),
        mistakes,
    }
}
