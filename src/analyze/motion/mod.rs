//! What moves one attitude: a small turn, a rate, and time.

// A rate over time.
mod course;

// A covariance on other axes.
mod covariance;

// How it changes at a rate.
mod derivative;

// What a small turn makes of it.
mod increment;

// How well steps follow it.
mod integrators;

// Where it goes in time.
mod path;

// How the image of a point changes with it.
mod point;

// In which conventions, and with which sign.
mod sided;

// The texts of rates, small turns and times.
pub(crate) mod texts;

// Turns, and how far one is off.
mod turned;

use crate::analyze::attitude::{Attitude, Declared};
use crate::analyze::motion::course::{Course, MOST_TURNS};
use crate::analyze::motion::covariance::{covariance, of_covariance};
use crate::analyze::motion::derivative::of_rate;
use crate::analyze::motion::increment::of_increment;
use crate::analyze::motion::path::of_course;
use crate::analyze::motion::point::{of_point, point};
use crate::analyze::motion::texts::Reader;
use crate::contract::{MotionReport, MotionRequest};
use crate::problem::fault::Fault;
use crate::problem::{Field, Problem, Span};
use std::f64::consts::TAU;

/// What an increment, a rate and a duration make of an attitude; what is not asked is absent.
pub(crate) fn motion(request: &MotionRequest) -> Result<MotionReport, Vec<Problem>> {
    let declared = Declared::plain(request.convention, request.matrix);
    let attitude = Attitude::of_text(&request.quaternion, Field::Quaternion, declared);
    let mut reader = Reader::default();
    let attitude = reader.unless_problem(attitude);
    if let Some(attitude) = &attitude {
        reader.notes = attitude.notes(Field::Quaternion);
    }
    let increment = reader.vector(&request.increment, Field::Increment);
    let start = reader.vector(&request.rate, Field::Rate);
    let end = reader.vector(&request.rate_end, Field::RateEnd);
    let seconds = reader.duration(&request.duration);
    let covariance = reader.if_any(&request.covariance, Field::Covariance, covariance);
    let point = reader.if_any(&request.point, Field::Point, point);
    let mut course = None;
    if let (Some(start), Some(seconds)) = (start, seconds) {
        let way = Course::new(start, end.unwrap_or(start), request.rate_axes, seconds);
        if way.turn_rad() > MOST_TURNS * TAU {
            let span = Span::of_trimmed(&request.duration);
            reader.refuse(Fault::turns_too_far(span), Field::Duration);
        }
        course = Some(way);
    }
    let Reader { problems, notes } = reader;
    match attitude {
        Some(attitude) if problems.is_empty() => Ok(MotionReport {
            quaternion: attitude.as_read(),
            increment: increment
                .map(|increment| of_increment(&attitude, increment, request.increment_sign)),
            derivative: start
                .map(|start| of_rate(&attitude, start, request.rate_axes, request.euler)),
            path: course.map(|course| of_course(&attitude, &course, request)),
            covariance: covariance.map(|covariance| of_covariance(&attitude, &covariance)),
            point: point.map(|point| of_point(&attitude, point)),
            notes,
        }),
        _ => Err(problems),
    }
}
