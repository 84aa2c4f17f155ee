//! Attitudes between attitudes: along the shortest way between two, and in the middle of many.

use crate::nearest_rotation;
use crate::rotation::Rotation;
use crate::scaling::Norm;
use nalgebra::Matrix3;
use twofloat::TwoFloat;

/// Below this half angle θ, `sin(tθ)/sin(θ)` is t to the last digit, since `θ²/6 < 2^-54`.
const WEIGHTS_ARE_LINEAR_BELOW: f64 = 1e-8;

impl Rotation {
    /// The attitude a part `t` of the way to another, at constant angular velocity about one axis.
    ///
    /// Spherical linear interpolation along the short way, `[sin((1−t)θ) a ± sin(tθ) b] / sin(θ)`
    /// with θ the half angle between (Shoemake 1985): `t = 0` is this attitude, with its sign, and
    /// `t = 1` the other; beyond these it stays there. No convention enters: the quaternions of every convention take the same
    /// path. At half a turn between the two, both ways are equally short, and the one is taken that
    /// the signs name. θ comes from an arc tangent and the sum has 106 bits, so that three roundoffs
    /// hold for neighbours and for −q too; nalgebra, which takes an arc cosine, is 2e-8 off there.
    ///
    /// ```
    /// use quatlas::{Rotation, nalgebra::Vector3};
    /// use std::f64::consts::FRAC_PI_2;
    /// let quarter = Rotation::from_axis_angle([0.0, 0.0, 1.0], FRAC_PI_2)?;
    /// let third = Rotation::identity().slerp(&quarter, 1.0 / 3.0);
    /// let expected = Vector3::new(30.0_f64.to_radians().cos(), 0.5, 0.0);
    /// assert!((third.body_to_world(Vector3::x()) - expected).amax() < 3e-16);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[must_use]
    pub fn slerp(&self, other: &Self, t: f64) -> Self {
        let t = if t.is_nan() { 0.0 } else { t.clamp(0.0, 1.0) };
        let relative = self.turn_to(other);
        let q = relative.canonical();
        let half_angle = libm::atan2(Norm::of(q.vector().as_slice()).value(), q.w.abs());
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
        Self::from_precise(sum)
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
        nearest_rotation::nearest(&sum)
    }

    /// The canonical quaternion with norm 1 and 106 bits, `[w, x, y, z]`.
    fn precise_unit(&self) -> [TwoFloat; 4] {
        let q = self.canonical();
        let norm = Norm::of(q.coords.as_slice());
        [q.w, q.i, q.j, q.k].map(|number| norm.divide_precisely(number))
    }
}
