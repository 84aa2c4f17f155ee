//! How far two attitudes are apart, in the measures of the field.
//!
//! All but [`Rotation::quaternion_distance`] are distances between attitudes: q and −q give the
//! same. With θ the angle between them:
//!
//! | distance | is | range |
//! |---|---|---|
//! | geodesic ([`Rotation::angle_to_rad`]) | θ | 0 to π |
//! | chordal | `‖R_A − R_B‖ = 2√2 sin(θ/2)`, Frobenius | 0 to 2√2 |
//! | quaternion | `‖q_A − q_B‖ = 2 sin(θ/4)` or `2 cos(θ/4)`, by the sign | 0 to 2 |
//! | quaternion, shorter | `min ‖q_A ∓ q_B‖ = 2 sin(θ/4)` | 0 to √2 |
//!
//! (Field guide, notions of distance; each is symmetric, which the guide prints as an inequality.)

use crate::rotation::Rotation;
use crate::rotation::precise::Norm;
use nalgebra::Matrix3;
use std::f64::consts::{PI, SQRT_2};

impl Rotation {
    /// The angle of the turn that leads from one attitude to the other, from 0 to π radians.
    ///
    /// By the arc tangent, so that small angles keep their digits; exactly 0 between q and −q. This
    /// is the geodesic distance (field guide, rotation matrix, distance).
    #[must_use]
    #[doc(alias("distance", "geodesic"))]
    pub fn angle_to_rad(&self, other: &Self) -> f64 {
        self.turn_to(other).angle_rad()
    }

    /// The Frobenius norm of the difference of the two matrices, from 0 to 2√2.
    ///
    /// `2√2 sin(θ/2)` (specification, 004-RM.22), which keeps its digits where the matrices agree.
    ///
    /// ```
    /// use quatlas::Rotation;
    /// let yawed = Rotation::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2)?;
    /// assert!((yawed.chordal_distance(&Rotation::identity()) - 2.0).abs() < 1e-15);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[must_use]
    pub fn chordal_distance(&self, other: &Self) -> f64 {
        let relative = self.turn_to(other);
        let q = relative.canonical();
        let (vector, whole) = (
            Norm::of(q.vector().as_slice()),
            Norm::of(q.coords.as_slice()),
        );
        2.0 * SQRT_2 * (vector.value() / whole.value())
    }

    /// The norm of the difference of the two unit quaternions with the signs they were made with,
    /// from 0 to 2.
    ///
    /// A distance of quaternions, not of attitudes: between q and −q it is 2 (specification,
    /// 004-Q.20).
    ///
    /// ```
    /// use quatlas::{Convention, Rotation, TaggedQuaternion};
    /// let turn = |w, z| Rotation::from_tagged(&TaggedQuaternion::new(w, 0.0, 0.0, z, Convention::HAMILTON));
    /// assert_eq!(turn(0.6, 0.8)?.quaternion_distance(&turn(-0.6, -0.8)?), 2.0);
    /// assert_eq!(turn(0.6, 0.8)?.shorter_quaternion_distance(&turn(-0.6, -0.8)?), 0.0);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[must_use]
    pub fn quaternion_distance(&self, other: &Self) -> f64 {
        let quarter_angle = self.angle_to_rad(other) / 4.0;
        // The scalar of the relative quaternion is the inner product of the two.
        if self.turn_to(other).canonical().w < 0.0 {
            2.0 * libm::cos(quarter_angle)
        } else {
            2.0 * libm::sin(quarter_angle)
        }
    }

    /// The smaller of the distances of the unit quaternions p to q and to −q, from 0 to √2.
    ///
    /// A distance of attitudes: `2 sin(θ/4)` (specification, 004-Q.21).
    #[must_use]
    pub fn shorter_quaternion_distance(&self, other: &Self) -> f64 {
        2.0 * libm::sin(self.angle_to_rad(other) / 4.0)
    }
}

/// The angle of the turn between two matrices, in radians; π where they are farther apart than turns are.
pub(crate) fn angle_between_rad(one: &Matrix3<f64>, other: &Matrix3<f64>) -> f64 {
    let sine_of_half = (one - other).norm() / SQRT_2 / 2.0;
    if sine_of_half >= 1.0 {
        return PI;
    }
    2.0 * libm::asin(sine_of_half)
}
