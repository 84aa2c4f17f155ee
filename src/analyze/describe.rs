//! A rotation in the representations that need no text: a turn, Euler angles, and what a convention
//! multiplies.

use crate::analyze::plain_numbers::{coordinates, plain};
use crate::contract::{ConventionDescription, Euler, ReadGimbalLock, Rules, Turn};
use crate::convention::euler_sequence::EulerSequence;
use crate::convention::side::Side;
use crate::convention::{ComponentSign, Convention, Direction};
use crate::motion::kinematics::RateAxes;
use crate::rotation::Rotation;
use crate::rotation::precise::UNIT_ROUNDOFF;

/// A scalar part this small is a rounded cosine of 90°: the turn is half a turn.
pub(crate) const HALF_TURN_SCALAR: f64 = UNIT_ROUNDOFF;

/// Nearer to gimbal lock than this, in radians, an error of the attitude is a hundred times as large in
/// the outer angles: of six decimals four are left.
const NEAR_LOCK_RAD: f64 = 1e-2;

pub(crate) fn rules(convention: Convention) -> Rules {
    let side = |is_left| if is_left { Side::Left } else { Side::Right };
    Rules {
        is_canonical: convention.component_sign() == ComponentSign::Canonical,
        operator: convention.operator(),
        labelled_first: side(convention.first_label_is_left()),
        chain_first: side(convention.first_in_chain_is_left()),
        increment: convention.increment_side(),
        body_rate: convention.rate_side(RateAxes::Body),
    }
}

/// What a convention is called and does, whatever the attitude.
///
/// ```
/// use quatlas::{Convention, Direction, NamedConvention, describe_convention};
/// let described = describe_convention(Convention::JPL);
/// assert_eq!(described.named, Some(NamedConvention::Jpl));
/// // It acts from world to body by C(q); the R(q) of its numbers is the other way round.
/// assert_eq!(described.rules.operator, Direction::WorldToBody);
/// assert_eq!(described.hamilton_matrix, Direction::BodyToWorld);
/// ```
#[must_use]
pub fn describe_convention(convention: Convention) -> ConventionDescription {
    ConventionDescription {
        named: convention.named(),
        preset: convention.preset(),
        hamilton_matrix: match convention.component_sign() {
            ComponentSign::Canonical => Direction::BodyToWorld,
            ComponentSign::Conjugated => Direction::WorldToBody,
        },
        reversed: convention.reversed(),
        rules: rules(convention),
    }
}

pub(crate) fn euler(rotation: &Rotation, sequence: EulerSequence) -> Euler {
    let found = rotation.euler(sequence);
    let angles_rad = found
        .gimbal_lock
        .map_or(found.angles_rad, |lock| lock.canonical_rad);
    let distance_rad = found.lock_distance_rad;
    let is_near = found.gimbal_lock.is_none() && distance_rad < NEAR_LOCK_RAD;
    Euler {
        sequence,
        angles_rad: angles_rad.map(plain),
        angles_deg: angles_rad.map(|angle| plain(angle.to_degrees())),
        gimbal_lock: found.gimbal_lock.map(|lock| ReadGimbalLock {
            survivor: lock.survivor,
            survivor_deg: plain(lock.survivor_rad.to_degrees()),
            lost: sequence.lost_at_lock(),
            distance_deg: plain(lock.distance_rad.to_degrees()),
        }),
        near_lock_deg: is_near.then(|| distance_rad.to_degrees()),
        free_sequence: (is_near || found.gimbal_lock.is_some())
            .then(|| rotation.free_euler_sequence(sequence)),
    }
}

pub(crate) fn turn(rotation: &Rotation) -> Turn {
    let angle_rad = rotation.angle_rad();
    let gibbs_vector = rotation.gibbs_vector().filter(|_| !is_half_turn(rotation));
    Turn {
        gibbs_vector: gibbs_vector.as_ref().map(coordinates),
        modified_rodrigues_parameters: coordinates(&rotation.modified_rodrigues_parameters()),
        angle_rad: plain(angle_rad),
        angle_deg: plain(angle_rad.to_degrees()),
        axis: rotation.axis().as_ref().map(coordinates),
        rotation_vector_rad: coordinates(&rotation.rotation_vector_rad()),
    }
}

/// Whether the turn is half a turn but for the rounding of a cosine.
pub(crate) fn is_half_turn(rotation: &Rotation) -> bool {
    let unit = rotation.to_tagged(Convention::HAMILTON).components;
    unit.w.abs() <= HALF_TURN_SCALAR
}
