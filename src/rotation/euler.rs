//! Rotation to and from Euler angles, in all 24 sequences and at any distance from gimbal lock.

use crate::convention::angle::{AngleUnit, half_angle_sincos};
use crate::convention::euler_sequence::{Axis, EulerAxes, EulerFrame, EulerSequence};
use crate::rotation::precise::Norm;
use crate::rotation::{NoRotation, Rotation};
use nalgebra::Quaternion;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};
use twofloat::TwoFloat;

/// Nearer to gimbal lock than this, in radians, half of the digits of the outer angles depend on the
/// last digits of the input (√u, with u = 2^-53), so they are told as locked.
pub const GIMBAL_LOCK_RAD: f64 = 1e-8;

/// Farther from its lock than this, in radians, a sequence is free: an error of the attitude is at most
/// twice as large in its outer angles.
const FREE_RAD: f64 = PI / 6.0;

/// Distances that differ by less, in radians, are equally far: at the lock of one sequence two others are
/// at exactly π/2, and near it, within a hundredth, nearly so.
const AS_FREE_RAD: f64 = 0.05;

/// Three angles about the axes of a sequence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerAngles {
    /// The axes and whether they move.
    pub sequence: EulerSequence,
    /// The angles in the order of the sequence: the outer ones above −π and up to π, the middle one
    /// from −π/2 to π/2, or from 0 to π where the outer axes are the same.
    pub angles_rad: [f64; 3],
    /// How far the middle angle is from gimbal lock, at most π/2: a small error of the attitude moves
    /// the outer angles by up to that error divided by this distance.
    pub lock_distance_rad: f64,
    /// Present where the sequence is locked, or so near that the outer angles mean little.
    pub gimbal_lock: Option<GimbalLock>,
}

/// The outer axes are the same line, so only the sum or the difference of their angles is left.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "singularity")]
pub struct GimbalLock {
    /// What the outer angles still determine together.
    pub survivor: Survivor,
    /// The sum or difference that survives, above −π and up to π.
    pub survivor_rad: f64,
    /// How far the middle angle is from the lock.
    pub distance_rad: f64,
    /// The same attitude with the angle of the roll-like axis (the third of an intrinsic sequence,
    /// the first of an extrinsic one) set to 0, but for `distance_rad`.
    pub canonical_rad: [f64; 3],
}

/// Which combination of the outer angles an attitude in gimbal lock determines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum Survivor {
    /// First plus third.
    Sum,
    /// First minus third.
    Difference,
}

impl Rotation {
    /// The attitude that Euler angles describe, within four roundoffs.
    ///
    /// `q_i(a) ⊙ q_j(b) ⊙ q_k(c)` for an intrinsic sequence, the reversed product for an extrinsic
    /// one, with `q_n(a) = [cos(a/2), sin(a/2) e_n]` (specification, FX-09). Angles of any size.
    ///
    /// # Errors
    ///
    /// [`NoRotation`] for numbers that are not finite.
    ///
    /// ```
    /// use quatlas::{EulerSequence, Rotation, nalgebra::Vector3};
    /// use std::f64::consts::FRAC_PI_2;
    /// // Yaw and then pitch, both by a quarter turn about the moving axes: the nose, first turned
    /// // to y, ends pointing down (z is up, and pitch is positive about y).
    /// let angles = [FRAC_PI_2, FRAC_PI_2, 0.0];
    /// let attitude = Rotation::from_euler_rad(EulerSequence::AEROSPACE, angles)?;
    /// assert!((attitude.body_to_world(Vector3::x()) + Vector3::z()).amax() < 3e-16);
    /// // About the fixed axes z, y, x the nose is left at y by the second turn.
    /// let attitude = Rotation::from_euler_rad("zyx".parse()?, angles)?;
    /// assert!((attitude.body_to_world(Vector3::x()) - Vector3::y()).amax() < 3e-16);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias("eul2quat", "quaternion_from_euler", "setRPY"))]
    pub fn from_euler_rad(
        sequence: EulerSequence,
        angles_rad: [f64; 3],
    ) -> Result<Self, NoRotation> {
        Self::from_euler_in(AngleUnit::Radians, sequence, angles_rad)
    }

    /// The same of angles that were written in this unit: whole quarter turns of degrees are exact.
    pub(crate) fn from_euler_in(
        written_in: AngleUnit,
        sequence: EulerSequence,
        angles_rad: [f64; 3],
    ) -> Result<Self, NoRotation> {
        if !angles_rad.iter().all(|angle| angle.is_finite()) {
            return Err(NoRotation);
        }
        let axes = sequence.axes.axes();
        let turn = |place: usize| {
            let (sine, cosine) = half_angle_sincos(angles_rad[place], written_in);
            let mut vector = [0.0; 3];
            vector[axes[place].index()] = sine;
            Self::from_canonical(&Quaternion::from_parts(cosine, vector.into()))
        };
        Ok(match sequence.frame {
            EulerFrame::Intrinsic => turn(0) * turn(1) * turn(2),
            EulerFrame::Extrinsic => turn(2) * turn(1) * turn(0),
        })
    }

    /// The Euler angles of the attitude.
    ///
    /// The half sum and half difference of the outer angles are angles in two planes of the
    /// quaternion's space (Bernardes & Viollet 2022), which are taken with 106 bits and without a
    /// threshold: so each angle is within twelve roundoffs and the attitude within sixteen, at any
    /// distance from gimbal lock. Exactly at the lock [`GimbalLock::canonical_rad`] is given.
    ///
    /// ```
    /// use quatlas::{Convention, EulerSequence, Rotation, TaggedQuaternion};
    /// // A body yawed by a quarter turn and then rolled by a half.
    /// let q = TaggedQuaternion::new(0.0, 1.0, 1.0, 0.0, Convention::HAMILTON);
    /// let angles = Rotation::from_tagged(&q)?.euler(EulerSequence::AEROSPACE);
    /// assert_eq!(angles.angles_rad.map(f64::to_degrees), [90.0, 0.0, 180.0]);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[must_use]
    #[doc(alias("quat2eul", "euler_from_quaternion", "as_euler"))]
    pub fn euler(&self, sequence: EulerSequence) -> EulerAngles {
        // An intrinsic sequence is the extrinsic one of the axes in reverse, with reversed angles.
        let mut axes = sequence.axes.axes();
        if sequence.frame == EulerFrame::Intrinsic {
            axes.reverse();
        }
        let extrinsic = Extrinsic::of(self.canonical(), axes);
        let in_order = |mut angles: [f64; 3]| {
            if sequence.frame == EulerFrame::Intrinsic {
                angles.reverse();
            }
            angles
        };
        let distance_rad = extrinsic.distance_rad();
        let gimbal_lock = (distance_rad <= GIMBAL_LOCK_RAD).then(|| {
            let (survivor, survivor_rad) = extrinsic.survivor(sequence.frame);
            GimbalLock {
                survivor,
                survivor_rad,
                distance_rad,
                canonical_rad: in_order(extrinsic.canonical()),
            }
        });
        EulerAngles {
            sequence,
            angles_rad: in_order(extrinsic.angles()),
            lock_distance_rad: distance_rad,
            gimbal_lock,
        }
    }

    /// A sequence of the same frame that is free at this attitude, where another one may be locked: that
    /// whose middle angle is farthest from its lock.
    ///
    /// Of those about the same axes where one of them is free. With three different axes one always is:
    /// at the lock of one, two others are as far from theirs as can be, since a row and a column of the
    /// matrix have but one entry of ±1. With two axes there may be none, as where the body has not turned;
    /// then it is one of all twelve. (The lecture's remedy: an atlas of charts, ME 495, section 4.3.)
    ///
    /// ```
    /// use quatlas::{EulerSequence, Rotation};
    /// use std::f64::consts::FRAC_PI_2;
    /// // Nose up: yaw and roll are about one line. About z, x and y the middle angle is 0.
    /// let up = Rotation::from_euler_rad(EulerSequence::AEROSPACE, [0.3, FRAC_PI_2, 0.1])?;
    /// let free = up.free_euler_sequence(EulerSequence::AEROSPACE);
    /// assert_eq!(free.to_string(), "YZX");
    /// assert!((up.euler(free).lock_distance_rad - FRAC_PI_2).abs() < 1e-15);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[must_use]
    #[doc(alias("atlas of charts", "gimbal lock"))]
    pub fn free_euler_sequence(&self, locked: EulerSequence) -> EulerSequence {
        let farthest = |axes: &dyn Fn(EulerSequence) -> bool| {
            let mut best: Option<(f64, EulerSequence)> = None;
            for axes_of_other in EulerAxes::ALL {
                let sequence = EulerSequence {
                    axes: axes_of_other,
                    ..locked
                };
                if !axes(sequence) {
                    continue;
                }
                let distance_rad = self.euler(sequence).lock_distance_rad;
                // The first of those that are as far.
                if best.is_none_or(|(farthest_rad, _)| distance_rad > farthest_rad + AS_FREE_RAD) {
                    best = Some((distance_rad, sequence));
                }
            }
            best
        };
        farthest(&|sequence| sequence.has_axes_of(locked))
            .filter(|(distance_rad, _)| *distance_rad > FREE_RAD)
            .or_else(|| farthest(&|_| true))
            .map_or(locked, |(_, sequence)| sequence)
    }
}

/// The angles of an extrinsic sequence i-j-k as two angles in planes.
///
/// With equal outer axes, m the remaining one and ε the sign of i-j-m, the quaternion
/// `q_i(a₃) q_j(a₂) q_i(a₁)` is `[w, q_i, q_j, ε q_m] =
/// [cos(a₂/2) cos σ, cos(a₂/2) sin σ, sin(a₂/2) cos δ, sin(a₂/2) sin δ]` with `σ = (a₃ + a₁)/2` and
/// `δ = (a₃ − a₁)/2`. Different outer axes become equal ones by a quarter turn more about j:
/// `q ⊙ (1 + e_j)` has the outer axes k and the angles `ε a₁, a₂ + π/2, a₃`.
struct Extrinsic {
    /// `cos(a₂/2)` times cosine and sine of the half sum, but for a common factor.
    sum: [f64; 2],
    /// `sin(a₂/2)` times cosine and sine of the half difference, with the same factor.
    difference: [f64; 2],
    /// The norms of the two.
    sum_size: f64,
    difference_size: f64,
    /// ε where the outer axes differ, 1 where they are the same.
    sign: f64,
    middle: f64,
}

impl Extrinsic {
    fn of(q: &Quaternion<f64>, axes: [Axis; 3]) -> Self {
        let part = |axis: usize| q.vector()[axis];
        let [i, j, k] = [axes[0].index(), axes[1].index(), axes[2].index()];
        // ε: 1 for x-y-z and its rotations.
        let sign = if (j + 3 - i) % 3 == 1 { 1.0 } else { -1.0 };
        let (sum, difference) = if i == k {
            let other = 3 - i - j;
            ([q.w, part(i)], [part(j), sign * part(other)])
        } else {
            let q_i = sign * part(i);
            (
                [q.w - part(j), part(k) + q_i],
                [q.w + part(j), part(k) - q_i],
            )
        };
        let sum_size = Norm::of(&sum).value();
        let difference_size = Norm::of(&difference).value();
        let middle = if i == k {
            2.0 * libm::atan2(difference_size, sum_size)
        } else {
            // sin(a₂) and cos(a₂) times |q|²; the tangent of the half would lose a small angle.
            let sine = TwoFloat::new_mul(q.w, part(j)) - TwoFloat::new_mul(part(k), sign * part(i));
            libm::atan2(2.0 * sine.hi(), sum_size * difference_size)
        };
        Self {
            sum,
            difference,
            sum_size,
            difference_size,
            sign: if i == k { 1.0 } else { sign },
            middle,
        }
    }

    fn half_sum(&self) -> f64 {
        libm::atan2(self.sum[1], self.sum[0])
    }

    fn half_difference(&self) -> f64 {
        libm::atan2(self.difference[1], self.difference[0])
    }

    fn with_outer(&self, first: f64, third: f64) -> [f64; 3] {
        [wrapped(self.sign * first), self.middle, wrapped(third)]
    }

    fn angles(&self) -> [f64; 3] {
        if self.sum_size == 0.0 || self.difference_size == 0.0 {
            return self.canonical();
        }
        let (sum, difference) = (self.half_sum(), self.half_difference());
        self.with_outer(sum - difference, sum + difference)
    }

    /// Whether the half sum is what is known better.
    fn keeps_sum(&self) -> bool {
        self.sum_size > self.difference_size
    }

    fn canonical(&self) -> [f64; 3] {
        let third = if self.keeps_sum() {
            2.0 * self.half_sum()
        } else {
            2.0 * self.half_difference()
        };
        self.with_outer(0.0, third)
    }

    /// The middle angle's distance from the lock.
    fn distance_rad(&self) -> f64 {
        let small = self.sum_size.min(self.difference_size);
        let large = self.sum_size.max(self.difference_size);
        2.0 * libm::atan2(small, large)
    }

    fn survivor(&self, frame: EulerFrame) -> (Survivor, f64) {
        let [_, _, third] = self.canonical();
        // Of a₁ + a₃ and a₁ − a₃ where a₁ = 0.
        match (self.keeps_sum() == (self.sign > 0.0), frame) {
            (true, _) => (Survivor::Sum, third),
            (false, EulerFrame::Intrinsic) => (Survivor::Difference, third),
            (false, EulerFrame::Extrinsic) => (Survivor::Difference, wrapped(-third)),
        }
    }
}

/// The same angle above −π and up to π.
fn wrapped(angle: f64) -> f64 {
    let turned = if angle > PI {
        angle - TAU
    } else if angle <= -PI {
        angle + TAU
    } else {
        angle
    };
    turned.clamp(-PI, PI)
}
