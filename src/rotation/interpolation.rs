//! Attitudes between attitudes: along the shortest way between two, and in the middle of many.

use crate::rotation::Rotation;
use crate::rotation::nearest;
use crate::rotation::precise::Norm;
use crate::rotation::weights::{self, UnusableWeights};
use nalgebra::{Matrix3, Quaternion};
use std::fmt;
use twofloat::TwoFloat;

/// Below this half angle θ, `sin(tθ)/sin(θ)` is t to the last digit, since `θ²/6 < 2^-54`.
const WEIGHTS_ARE_LINEAR_BELOW: f64 = 1e-8;

/// The part of a way is infinite or not a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotFinite;

impl fmt::Display for NotFinite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the part of the way between two attitudes needs to be a finite number")
    }
}

impl std::error::Error for NotFinite {}

/// Why there is no attitude in the middle of many.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoMean {
    /// There is no attitude.
    Empty,
    /// The weights cannot be used.
    Weights(UnusableWeights),
    /// No attitude is nearer to all than every other, or hardly.
    Undetermined,
}

impl fmt::Display for NoMean {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Empty => "a mean needs at least one rotation",
            Self::Weights(unusable) => unusable.message(),
            Self::Undetermined => "no rotation is nearer to all of them than every other",
        })
    }
}

impl std::error::Error for NoMean {}

impl Rotation {
    /// The attitude a part `t` of the way to another, at constant angular velocity about one axis.
    ///
    /// Spherical linear interpolation along the short way, `[sin((1−t)θ) a ± sin(tθ) b] / sin(θ)`
    /// with θ the half angle between (Shoemake 1985): `t = 0` is this attitude, with its sign, and
    /// `t = 1` the other. Beyond these the turn goes on as it was, `a ∘ Exp(2tθ u)` about the same
    /// axis u: `t = 2` is as far behind the other attitude as this one is before it, and `t = −1` as far
    /// before this one. No convention enters: the quaternions of every convention take the same
    /// path. At half a turn between the two, both ways are equally short, and the one is taken that
    /// the signs name. θ comes from an arc tangent and the sum has 106 bits, so that three roundoffs
    /// hold for neighbours and for −q too, and beyond the ends |t| times three; nalgebra, which takes
    /// an arc cosine, is 2e-8 off between neighbours.
    ///
    /// # Errors
    ///
    /// [`NotFinite`] where `t` is NaN or infinite.
    ///
    /// ```
    /// use quatlas::{NotFinite, Rotation, nalgebra::Vector3};
    /// use std::f64::consts::FRAC_PI_2;
    /// let yawed = Rotation::from_axis_angle([0.0, 0.0, 1.0], FRAC_PI_2)?;
    /// let at = |t: f64| Rotation::identity().slerp(&yawed, t);
    /// let third = at(1.0 / 3.0)?.body_to_world(Vector3::x());
    /// assert!((third - Vector3::new(30.0_f64.to_radians().cos(), 0.5, 0.0)).amax() < 3e-16);
    /// // The turn goes on before the first attitude: a quarter turn the other way.
    /// let before = at(-1.0)?.body_to_world(Vector3::x());
    /// assert!((before + Vector3::y()).amax() < 5e-16);
    /// assert_eq!(at(f64::INFINITY), Err(NotFinite));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias("interpolate", "extrapolate", "SLERP"))]
    pub fn slerp(&self, other: &Self, t: f64) -> Result<Self, NotFinite> {
        if !t.is_finite() {
            return Err(NotFinite);
        }
        let relative = self.turn_to(other);
        let q = relative.canonical();
        let half_angle = libm::atan2(Norm::of(q.vector().as_slice()).value(), q.w.abs());
        // From the nearer end, so that the error grows with the way beyond it.
        if t < 0.0 {
            return Ok(*self * relative.part_of_shorter_turn(t, half_angle));
        }
        if t > 1.0 {
            let turn = relative.part_of_shorter_turn(t - 1.0, half_angle);
            return Ok(other.with_sign_of(q.w) * turn);
        }
        let (to_self, mut to_other) = if half_angle < WEIGHTS_ARE_LINEAR_BELOW {
            (1.0 - t, t)
        } else {
            let sine = libm::sin(half_angle);
            (
                libm::sin((1.0 - t) * half_angle) / sine,
                libm::sin(t * half_angle) / sine,
            )
        };
        if q.w < 0.0 {
            to_other = -to_other;
        }
        let (a, b) = (self.precise_unit(), other.precise_unit());
        let sum = [0, 1, 2, 3].map(|place| a[place] * to_self + b[place] * to_other);
        Ok(Self::from_precise(sum))
    }

    /// The turn about the same axis by `t` times the angle: `R^t`.
    ///
    /// `Exp(t Log(R))`, of the shorter way where the quaternion tells the longer one: `t = 0` is the identity,
    /// `t = −1` the inverse, `t = 3` three turns one after the other, and between 0 and 1 it is the part `t` of
    /// the way from the identity ([`Rotation::slerp`]). No convention enters, as axis and angle have none. At
    /// half a turn both ways are equally short, and the axis is that of [`Rotation::axis`]. Within three
    /// roundoffs, |t| times three beyond 1, however small the turn is.
    ///
    /// # Errors
    ///
    /// [`NotFinite`] where `t` is NaN or infinite.
    ///
    /// ```
    /// use quatlas::{NotFinite, Rotation, nalgebra::Vector3};
    /// // 80° about z, by −1.5: 120° the other way, which leads y to cos(30°), −1/2.
    /// let yawed = Rotation::from_axis_angle([0.0, 0.0, 1.0], 80_f64.to_radians())?;
    /// let turned = yawed.power(-1.5)?.body_to_world(Vector3::y());
    /// assert!((turned - Vector3::new(0.75_f64.sqrt(), -0.5, 0.0)).amax() < 1e-15);
    /// // 300° are 60° the other way, and half of these are −30°.
    /// let yawed = Rotation::from_axis_angle([0.0, 0.0, 1.0], 300_f64.to_radians())?;
    /// assert!((yawed.power(0.5)?.rotation_vector_rad().z.to_degrees() + 30.0).abs() < 1e-13);
    /// assert_eq!(yawed.power(f64::NAN), Err(NotFinite));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias("pow", "powf", "fractional power", "scale"))]
    pub fn power(&self, t: f64) -> Result<Self, NotFinite> {
        if !t.is_finite() {
            return Err(NotFinite);
        }
        let vector = self.shorter_vector_part();
        let scalar = self.canonical().w.abs();
        let half_angle = libm::atan2(Norm::of(vector.as_slice()).value(), scalar);
        if half_angle * t.abs().max(1.0) < WEIGHTS_ARE_LINEAR_BELOW {
            // [w, t v], which no turn is too small for: its angle may be less than the smallest double.
            return Ok(Self::from_canonical(&Quaternion::from_parts(
                scalar,
                vector * t,
            )));
        }
        Ok(self.part_of_shorter_turn(t, half_angle))
    }

    /// `[cos(tθ), sin(tθ) u]` with u the axis of the shorter way of this turn and θ half its angle.
    fn part_of_shorter_turn(&self, t: f64, half_angle: f64) -> Self {
        let Some(axis) = self.axis() else {
            return Self::identity();
        };
        // Where the product is too large for a double, t has no digit left that tells the angle.
        let phase = (t * half_angle).clamp(f64::MIN, f64::MAX);
        let (sine, cosine) = (libm::sin(phase), libm::cos(phase));
        Self::from_canonical(&Quaternion::from_parts(cosine, axis * sine))
    }

    /// The same attitude by the other quaternion where the number is negative.
    fn with_sign_of(&self, number: f64) -> Self {
        if number < 0.0 {
            Self::from_canonical(&-self.canonical())
        } else {
            *self
        }
    }

    /// The attitude in the middle of many: that for which the sum of the squared chordal distances
    /// is least.
    ///
    /// The rotation nearest to the sum of the matrices (Markley et al. 2007 in matrices), which does
    /// not depend on the signs of the quaternions or on the order. `None` for an empty list and
    /// where no attitude is nearer than all others, as for two that are half a turn apart.
    ///
    /// ```
    /// use quatlas::Rotation;
    /// let yawed = |angle: f64| Rotation::from_axis_angle([0.0, 0.0, 1.0], angle.to_radians());
    /// let mean = Rotation::mean(&[yawed(10.0)?, yawed(60.0)?, yawed(20.0)?, yawed(70.0)?]);
    /// let angle = mean.expect("one middle").rotation_vector_rad().z.to_degrees();
    /// assert!((angle - 40.0).abs() < 1e-13);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[must_use]
    #[doc(alias("average", "barycenter"))]
    pub fn mean(rotations: &[Self]) -> Option<Self> {
        let sum: Matrix3<f64> = rotations.iter().map(Self::body_to_world_matrix).sum();
        nearest::nearest(&sum)
    }

    /// The attitude in the middle of many that count for more or less: that for which the sum of weight
    /// times squared chordal distance is least.
    ///
    /// The rotation nearest to the weighted sum of the matrices, summed with 106 bits (Markley et al. 2007).
    /// Only the ratios of the weights matter; one of weight 0 is left out, and with equal weights it is
    /// [`Rotation::mean`].
    ///
    /// # Errors
    ///
    /// [`NoMean`] for an empty list, for weights that cannot be used, and where no attitude is nearer than all
    /// others, as for two of equal weight that are half a turn apart.
    ///
    /// ```
    /// use quatlas::{NoMean, Rotation, UnusableWeights};
    /// let yawed = |angle: f64| Rotation::from_axis_angle([0.0, 0.0, 1.0], angle.to_radians());
    /// // The directions of 0° and 90° with weights 3 and √3 add up to a direction of 30°.
    /// let both = [yawed(0.0)?, yawed(90.0)?];
    /// let mean = Rotation::mean_weighted(&both, &[3.0, 3_f64.sqrt()])?;
    /// assert!((mean.rotation_vector_rad().z.to_degrees() - 30.0).abs() < 1e-13);
    /// let negative = Rotation::mean_weighted(&both, &[3.0, -1.0]);
    /// assert_eq!(negative, Err(NoMean::Weights(UnusableWeights::NegativeOrNotFinite)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias("average", "barycenter", "weighted mean"))]
    pub fn mean_weighted(rotations: &[Self], weights: &[f64]) -> Result<Self, NoMean> {
        if rotations.is_empty() {
            return Err(NoMean::Empty);
        }
        let weights = weights::at_unit_size(weights, rotations.len()).map_err(NoMean::Weights)?;
        let mut sum = Matrix3::from_element(TwoFloat::from(0.0));
        for (rotation, weight) in rotations.iter().zip(weights) {
            sum += rotation.precise_matrix().map(|entry| entry * weight);
        }
        nearest::nearest_to_sum(&sum).ok_or(NoMean::Undetermined)
    }

    /// The canonical quaternion with norm 1 and 106 bits, `[w, x, y, z]`.
    fn precise_unit(&self) -> [TwoFloat; 4] {
        let q = self.canonical();
        let norm = Norm::of(q.coords.as_slice());
        [q.w, q.i, q.j, q.k].map(|number| norm.divide_precisely(number))
    }
}
