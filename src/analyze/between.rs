//! From one attitude to another: what they are to each other, the turn between, and the way.

use crate::analyze::attitude::{Attitude, Declared, computed_column};
use crate::analyze::describe::{euler, turn};
use crate::analyze::motion::texts::Reader;
use crate::analyze::plain_numbers::{coordinates, plain};
use crate::contract::request::BetweenRequest;
use crate::contract::{BetweenReport, Form, Mistake, MistakeKind, RateBetween, Verdict};
use crate::convention::{Convention, Perturbation};
use crate::motion::kinematics::RateAxes;
use crate::problem::fault::Fault;
use crate::problem::{Field, Problem, Span};
use crate::rotation::Rotation;
use crate::rotation::quaternion::TaggedQuaternion;
use crate::text::parse_number;

/// Two attitudes nearer than this are one, rounded: four decimals are off by half as much each.
const SAME_RAD: f64 = 2e-4;

/// Of more times the way the digits are those of rounding.
const MOST_WAYS: f64 = 1000.0;

pub(crate) fn between(request: &BetweenRequest) -> Result<BetweenReport, Vec<Problem>> {
    let declared = Declared::plain(request.convention, request.matrix);
    let p = Attitude::of_text(&request.p, Field::P, declared);
    let q = Attitude::of_text(&request.q, Field::Q, declared);
    let mut reader = Reader::default();
    let p = reader.unless_problem(p);
    let q = reader.unless_problem(q);
    let part = reader.unless_problem(part(&request.part));
    let duration_s = reader.duration(&request.duration);
    let (Some(p), Some(q), Some(part), true) = (p, q, part, reader.problems.is_empty()) else {
        return Err(reader.problems);
    };
    let local = p.rotation.turn_to(&q.rotation);
    let global = q.rotation * p.rotation.inverse();
    let error = match request.convention.perturbation {
        Perturbation::Local => &local,
        Perturbation::Global => &global,
    };
    let perturbed = |preset: Convention| {
        let perturbation = request.convention.perturbation;
        let convention = Convention {
            perturbation,
            ..preset
        };
        computed_column(error, convention)
    };
    let shorter = p.rotation.shorter_quaternion_distance(&q.rotation);
    let typed = p.rotation.quaternion_distance(&q.rotation);
    let longer = 2.0 * libm::cos(local.angle_rad() / 4.0);
    let at = |part: f64| {
        let way = p.rotation.slerp(&q.rotation, part).unwrap_or(p.rotation);
        computed_column(&way, p.tagged.convention)
    };
    let p_euler = euler(&p.rotation, request.euler);
    let q_euler = euler(&q.rotation, request.euler);
    let mut differences = q_euler.angles_deg;
    for (difference, subtracted) in differences.iter_mut().zip(p_euler.angles_deg) {
        *difference = shorter_way_deg(*difference - subtracted);
    }
    let mut notes = p.notes(Field::P);
    notes.extend(q.notes(Field::Q));
    Ok(BetweenReport {
        verdict: verdict(&p, &q),
        local: turn(&local),
        global: turn(&global),
        declared: computed_column(error, p.tagged.convention),
        hamilton: perturbed(Convention::HAMILTON),
        jpl: perturbed(Convention::JPL),
        chordal_distance: plain(p.rotation.chordal_distance(&q.rotation)),
        quaternion_distance: plain(typed),
        negated_quaternion_distance: plain(if typed > shorter { shorter } else { longer }),
        part,
        rate: duration_s.map(|duration_s| rate(&p.rotation, &q.rotation, duration_s)),
        way: at(part),
        halfway: at(0.5),
        p_euler,
        q_euler,
        euler_differences_deg: differences,
        notes,
        p: p.as_read(),
        q: q.as_read(),
    })
}

fn rate(p: &Rotation, q: &Rotation, duration_s: f64) -> RateBetween {
    let on = |axes| coordinates(&p.rate_to(q, axes, duration_s));
    // The rate taken of half of the turn leads half of the way.
    let half_forgotten = Mistake {
        kind: MistakeKind::HalfForgotten,
        angle_deg: plain(p.angle_to_rad(q).to_degrees() / 2.0),
    };
    RateBetween {
        duration_s,
        body_rad: on(RateAxes::Body),
        world_rad: on(RateAxes::World),
        mistakes: vec![half_forgotten],
    }
}

/// The part that a text holds; half of the way where it is empty.
fn part(text: &str) -> Result<f64, Problem> {
    if text.is_empty() {
        return Ok(0.5);
    }
    let told = parse_number(text).and_then(|part| {
        if part.abs() > MOST_WAYS {
            return Err(Fault::too_far(Span::of_trimmed(text)));
        }
        Ok(plain(part))
    });
    told.map_err(|fault| fault.in_field(Field::Part))
}

/// The same difference of angles above −180 and up to 180 degrees.
fn shorter_way_deg(difference: f64) -> f64 {
    let difference = plain(difference);
    if difference > 180.0 {
        difference - 360.0
    } else if difference <= -180.0 {
        difference + 360.0
    } else {
        difference
    }
}

fn verdict(p: &Attitude, q: &Attitude) -> Verdict {
    let is_q = |rotation: &Rotation| rotation.angle_to_rad(&q.rotation) <= SAME_RAD;
    let are_quaternions = p.form == Form::Quaternion && q.form == Form::Quaternion;
    if is_q(&p.rotation) {
        // Of other descriptions the sign is not theirs.
        let is_opposite = are_quaternions && p.rotation.quaternion_distance(&q.rotation) > 1.0;
        return if is_opposite {
            Verdict::Opposite
        } else {
            Verdict::Equal
        };
    }
    if is_q(&p.rotation.inverse()) {
        return Verdict::Conjugated;
    }
    if are_quaternions {
        // The scalar went from one end to the other, of p or of q.
        let moved = [(scalar_moved(p), q.rotation), (scalar_moved(q), p.rotation)];
        for (moved, other) in moved {
            if moved.angle_to_rad(&other) <= SAME_RAD {
                return Verdict::ScalarMoved;
            }
            if moved.inverse().angle_to_rad(&other) <= SAME_RAD {
                return Verdict::ScalarMovedAndConjugated;
            }
        }
    }
    Verdict::Different
}

/// The attitude of the same array, read in the other order.
fn scalar_moved(attitude: &Attitude) -> Rotation {
    let convention = attitude.tagged.convention;
    let other = Convention {
        order: convention.order.other(),
        ..convention
    };
    let moved = TaggedQuaternion::from_array(attitude.tagged.to_array(), other);
    Rotation::from_tagged(&moved).unwrap_or(attitude.rotation)
}
