//! The canonical rotation, and the only two gates to and from tagged quaternions.
//!
//! Inside is the Hamilton quaternion of `R_WB`. Before [`Rotation::from_tagged`]
//! there are conventions; after it there are none, until [`Rotation::to_tagged`].

use crate::convention::Convention;
use crate::quaternion::{self, TaggedQuaternion};
use nalgebra::{UnitQuaternion, Vector3};
use std::fmt;

/// These numbers are not a rotation: they are all zero, or not all finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoRotation;

impl fmt::Display for NoRotation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a rotation needs finite numbers that are not all zero")
    }
}

impl std::error::Error for NoRotation {}

/// The attitude of a body in the world, free of any convention.
///
/// It is the turn that carries the world axes onto the body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias("attitude", "orientation"))]
pub struct Rotation {
    body_to_world: UnitQuaternion<f64>,
}

impl Rotation {
    /// The attitude that a quaternion of any norm stands for.
    ///
    /// # Errors
    ///
    /// [`NoRotation`] for the zero quaternion and for numbers that are not finite.
    ///
    /// ```
    /// use quatlas::{Convention, Rotation, TaggedQuaternion, nalgebra::Vector3};
    ///
    /// // A quarter turn about z in JPL, world to body, with norm √2.
    /// let jpl = TaggedQuaternion::from_array([0.0, 0.0, 1.0, 1.0], Convention::JPL);
    /// let rotation = Rotation::from_tagged(&jpl)?;
    /// assert_eq!(rotation.world_to_body(Vector3::y()), Vector3::x());
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    pub fn from_tagged(tagged: &TaggedQuaternion) -> Result<Self, NoRotation> {
        let canonical = tagged.to_convention(Convention::HAMILTON).components;
        let unit = quaternion::normalize(&canonical).ok_or(NoRotation)?;
        Ok(Self {
            body_to_world: UnitQuaternion::new_unchecked(unit),
        })
    }

    /// The attitude as a quaternion of norm 1 in a convention.
    ///
    /// Of the two quaternions q and −q it is the one whose signs the rotation was made with.
    #[must_use]
    pub fn to_tagged(&self, convention: Convention) -> TaggedQuaternion {
        TaggedQuaternion {
            components: *self.body_to_world.quaternion(),
            convention: Convention::HAMILTON,
        }
        .to_convention(convention)
    }

    /// The rotation with this canonical quaternion, which must have norm 1.
    pub(crate) fn from_canonical(body_to_world: UnitQuaternion<f64>) -> Self {
        Self { body_to_world }
    }

    /// The canonical quaternion: Hamilton, body to world.
    pub(crate) fn canonical(&self) -> &nalgebra::Quaternion<f64> {
        self.body_to_world.quaternion()
    }

    /// The opposite turn, which carries the body axes onto the world axes.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self {
            body_to_world: self.body_to_world.inverse(),
        }
    }

    /// The angle of the turn that leads from one attitude to the other, from 0 to π radians.
    ///
    /// By the arc tangent, so that small angles keep their digits; q and −q are the same.
    #[must_use]
    #[doc(alias("distance", "geodesic"))]
    pub fn angle_to_rad(&self, other: &Self) -> f64 {
        Self::from_canonical(self.body_to_world.inverse() * other.body_to_world).angle_rad()
    }

    /// The coordinates in the world of a vector given in body coordinates: `R(q) x`.
    #[must_use]
    pub fn body_to_world(&self, vector: Vector3<f64>) -> Vector3<f64> {
        self.body_to_world_matrix() * vector
    }

    /// The coordinates in the body of a vector given in world coordinates: `C(q) x`.
    #[must_use]
    pub fn world_to_body(&self, vector: Vector3<f64>) -> Vector3<f64> {
        self.world_to_body_matrix() * vector
    }
}
