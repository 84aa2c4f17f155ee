//! Rotation to and from axis and angle, and rotation vector.
//!
//! The turn is the right-handed one that carries the world axes onto the body
//! axes. Its axis has the same coordinates in both frames, and no convention
//! changes its numbers.

use crate::convention::angle::{AngleUnit, half_angle_sincos};
use crate::rotation::precise::{self, Norm};
use crate::rotation::{NoRotation, Rotation};
use nalgebra::{Quaternion, Vector3};

/// Below this half-angle `a`, `sin(a)/a` and `cos(a)` are 1 to the last digit, since `a²/2 < 2^-54`;
/// the quotient of two numbers that may be subnormal is then avoided.
const SINC_IS_ONE_BELOW: f64 = 7e-9;

impl Rotation {
    /// The turn by an angle, in radians, about an axis of any length.
    ///
    /// Right-handed: a positive angle about z turns x towards y (Cheng 2018, section 1.1).
    ///
    /// # Errors
    ///
    /// [`NoRotation`] for the zero axis and for numbers that are not finite.
    ///
    /// ```
    /// use quatlas::{Rotation, nalgebra::Vector3};
    /// use std::f64::consts::FRAC_PI_2;
    /// let yawed = Rotation::from_axis_angle([0.0, 0.0, 9.0], FRAC_PI_2)?;
    /// assert!((yawed.body_to_world(Vector3::x()) - Vector3::y()).amax() < 3e-16);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    pub fn from_axis_angle(axis: [f64; 3], angle_rad: f64) -> Result<Self, NoRotation> {
        Self::from_axis_angle_in(AngleUnit::Radians, axis, angle_rad)
    }

    /// The same of an angle that was written in this unit: whole quarter turns of degrees are exact.
    pub(crate) fn from_axis_angle_in(
        written_in: AngleUnit,
        axis: [f64; 3],
        angle_rad: f64,
    ) -> Result<Self, NoRotation> {
        if !(axis.iter().all(|number| number.is_finite()) && angle_rad.is_finite()) {
            return Err(NoRotation);
        }
        let unit = precise::direction(&axis.into()).ok_or(NoRotation)?;
        let (sine, cosine) = half_angle_sincos(angle_rad, written_in);
        Ok(Self::from_canonical(&Quaternion::from_parts(
            cosine,
            unit * sine,
        )))
    }

    /// The turn by `|v|` radians about `v`: the exponential of the rotation vector.
    ///
    /// Any length; beyond π the same attitude has a shorter vector as well. The quaternion is
    /// `[cos(|v|/2), sin(|v|/2) v/|v|]` (Cheng 2018, eq. 2.10). Within three roundoffs up to a
    /// length of 1e15: the sine is of the length with 106 bits, as a double of that size is a tenth
    /// of a radian away from the next.
    ///
    /// # Errors
    ///
    /// [`NoRotation`] for numbers that are not finite.
    ///
    /// ```
    /// use quatlas::{Rotation, nalgebra::Vector3};
    /// use std::f64::consts::FRAC_PI_2;
    /// // A quarter turn about z leads x to y.
    /// let yawed = Rotation::from_rotation_vector_rad([0.0, 0.0, FRAC_PI_2])?;
    /// assert!((yawed.body_to_world(Vector3::x()) - Vector3::y()).amax() < 3e-16);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[doc(alias("exp", "from_scaled_axis"))]
    pub fn from_rotation_vector_rad(vector: [f64; 3]) -> Result<Self, NoRotation> {
        let norm = Norm::of(&vector);
        let half_angle = norm.fraction * precise::times_power_of_two(0.5, norm.exponent);
        if !half_angle.hi().is_finite() {
            return Err(NoRotation);
        }
        if half_angle.hi() < SINC_IS_ONE_BELOW {
            // [1, v/2] times 2, which a subnormal v survives.
            return Ok(Self::from_canonical(&Quaternion::from_parts(
                2.0,
                Vector3::from(vector),
            )));
        }
        // The sine and cosine of a sum; the second term is up to 1/16 where the length is 1e15.
        let (sine, cosine) = libm::sincos(half_angle.hi());
        let (sine_rest, cosine_rest) = libm::sincos(half_angle.lo());
        let direction = Vector3::from(vector).map(|number| norm.divide(number));
        Ok(Self::from_canonical(&Quaternion::from_parts(
            cosine * cosine_rest - sine * sine_rest,
            direction * (sine * cosine_rest + cosine * sine_rest),
        )))
    }

    /// The angle of the turn, from 0 to π radians.
    ///
    /// `2 atan2(|v|, |w|)`, which keeps its digits near 0 and near π, where an arc cosine loses
    /// half of them (specification FX-22 and NUM-02).
    #[must_use]
    pub fn angle_rad(&self) -> f64 {
        let q = self.canonical();
        let vector_norm = Norm::of(q.vector().as_slice()).value();
        2.0 * libm::atan2(vector_norm, q.w.abs())
    }

    /// The axis of the turn, of length 1; `None` where the angle is 0.
    ///
    /// At π the axis and its opposite are equally right; the one given is the vector part's own.
    #[must_use]
    pub fn axis(&self) -> Option<Vector3<f64>> {
        precise::direction(&self.shorter_vector_part())
    }

    /// The rotation vector: the angle, at most π radians, times the axis. The logarithm.
    ///
    /// `2 atan2(|v|, w)/|v| · v` with `w ≥ 0`, and 0 for no turn (specification FX-22).
    ///
    /// ```
    /// use quatlas::{Convention, Rotation, TaggedQuaternion};
    /// // JPL and Hamilton give a quarter turn about −y the same rotation vector.
    /// let q = TaggedQuaternion::new(1.0, 0.0, -1.0, 0.0, Convention::JPL);
    /// let vector = Rotation::from_tagged(&q)?.rotation_vector_rad();
    /// assert!((vector.y + std::f64::consts::FRAC_PI_2).abs() < 3e-16);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[must_use]
    #[doc(alias("log", "scaled_axis", "rotvec"))]
    pub fn rotation_vector_rad(&self) -> Vector3<f64> {
        let vector = self.shorter_vector_part();
        let scalar = self.canonical().w.abs();
        let norm = Norm::of(vector.as_slice()).value();
        if norm < SINC_IS_ONE_BELOW * scalar {
            return vector.map(|number| 2.0 * (number / scalar));
        }
        let angle = 2.0 * libm::atan2(norm, scalar);
        vector.map(|number| angle * (number / norm))
    }

    /// The vector part of q or of −q, whichever has a scalar that is not negative.
    pub(crate) fn shorter_vector_part(&self) -> Vector3<f64> {
        let q = self.canonical();
        let vector: Vector3<f64> = q.vector().into();
        if q.w < 0.0 { -vector } else { vector }
    }
}
