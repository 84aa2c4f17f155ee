//! The canonical rotation, and the only two gates to and from tagged quaternions.
//!
//! Inside is the Hamilton quaternion of `R_WB`. Before [`Rotation::from_tagged`]
//! there are conventions; after it there are none, until [`Rotation::to_tagged`].

/// Attitudes from vectors that are known in the body and in the world.
pub mod alignment;

/// Rotation to and from axis, angle and rotation vector.
pub mod axis_angle;

/// How far two attitudes are apart.
pub mod distance;

/// Rotation to and from Euler angles.
pub mod euler;

/// Attitudes between attitudes.
pub mod interpolation;

/// Rotation to matrix.
pub mod matrix;

/// The rotation nearest to nine numbers.
pub mod nearest;

// Products with 106 bits.
pub(crate) mod products;

// Exact scaling, and sums of products that are rounded once.
pub(crate) mod precise;

/// Four numbers with the convention that says what they mean.
pub mod quaternion;

/// Attitudes drawn at random.
pub mod random;

/// Rotation vectors: composition, Jacobians, and their relatives.
pub mod rotation_vector;

/// A turn about a given axis, and the rest.
pub mod swing_twist;

/// Nine numbers with the convention that says what they mean.
pub mod tagged_matrix;

/// How much each of many counts.
pub mod weights;

use crate::convention::Convention;
use crate::rotation::quaternion::TaggedQuaternion;
use nalgebra::{Quaternion, UnitQuaternion};
use std::fmt;
use std::ops::Mul;
use twofloat::TwoFloat;

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
///
/// Two are equal where their unit quaternions are, sign included; see
/// [`Rotation::angle_to_rad`] for equality of the attitudes.
#[derive(Clone, Copy)]
#[doc(alias("attitude", "orientation"))]
pub struct Rotation {
    /// Hamilton, body to world, times some positive number: the components as they came, brought
    /// to a common size by a power of two. It is divided by its norm only where it leaves, so that
    /// every result is rounded once. (From a unit quaternion that was rounded first, a matrix can be
    /// wrong by one and a half roundoffs; from this one it is by half.)
    body_to_world: Quaternion<f64>,
}

impl fmt::Debug for Rotation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Rotation")
            .field(&self.to_tagged(Convention::HAMILTON).to_array())
            .finish()
    }
}

impl PartialEq for Rotation {
    fn eq(&self, other: &Self) -> bool {
        self.to_tagged(Convention::HAMILTON) == other.to_tagged(Convention::HAMILTON)
    }
}

impl From<UnitQuaternion<f64>> for Rotation {
    /// The attitude whose `R_WB` the quaternion acts with: nalgebra's quaternions are Hamilton's.
    fn from(body_to_world: UnitQuaternion<f64>) -> Self {
        Self::from_canonical(body_to_world.quaternion())
    }
}

impl From<Rotation> for UnitQuaternion<f64> {
    /// The quaternion that takes coordinates in the body to coordinates in the world.
    ///
    /// ```
    /// use quatlas::{Rotation, nalgebra::{UnitQuaternion, Vector3}};
    /// let yawed = Rotation::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2)?;
    /// let theirs = UnitQuaternion::from(yawed);
    /// assert!((theirs * Vector3::x() - Vector3::y()).amax() < 5e-16);
    /// assert_eq!(Rotation::from(theirs), yawed);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    fn from(rotation: Rotation) -> Self {
        Self::new_unchecked(rotation.to_tagged(Convention::HAMILTON).components)
    }
}

impl Mul for Rotation {
    type Output = Self;

    /// The attitude of C in the world, from that of B in the world and that of C in B:
    /// `R_WC = R_WB R_BC`.
    fn mul(self, second: Self) -> Self {
        let product = precise::hamilton_product(&self.body_to_world, &second.body_to_world);
        Self::from_precise(product)
    }
}

impl Rotation {
    /// The attitude in which the body axes are the world axes.
    #[must_use]
    pub fn identity() -> Self {
        Self::from_canonical(&Quaternion::new(1.0, 0.0, 0.0, 0.0))
    }

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
        let numbers = canonical.coords.as_slice();
        let is_rotation = numbers.iter().all(|number| number.is_finite())
            && numbers.iter().any(|&number| number != 0.0);
        is_rotation
            .then(|| Self::from_canonical(&canonical))
            .ok_or(NoRotation)
    }

    /// The attitude as a quaternion of norm 1 in a convention, each component within one roundoff.
    ///
    /// Of the two quaternions q and −q it is the one whose signs the rotation was made with.
    #[must_use]
    pub fn to_tagged(&self, convention: Convention) -> TaggedQuaternion {
        TaggedQuaternion {
            // The only quaternion without a direction is zero, which no gate lets in.
            components: quaternion::normalize(&self.body_to_world)
                .unwrap_or(Quaternion::new(1.0, 0.0, 0.0, 0.0)),
            convention: Convention::HAMILTON,
        }
        .to_convention(convention)
    }

    /// The rotation with this canonical quaternion, of any norm but zero.
    pub(crate) fn from_canonical(body_to_world: &Quaternion<f64>) -> Self {
        let scale = precise::working_scale(body_to_world.coords.as_slice());
        Self::of_canonical(precise::scale(body_to_world, scale))
    }

    /// The rotation whose [canonical](Self::canonical) quaternion this is, bit for bit.
    pub(crate) const fn of_canonical(body_to_world: Quaternion<f64>) -> Self {
        Self { body_to_world }
    }

    /// The rotation with this canonical quaternion `[w, x, y, z]`, rounded only once its norm is a
    /// power of two, so that no other rounding follows.
    ///
    /// Zero, which no two rotations make, is taken for the identity.
    pub(crate) fn from_precise(components: [TwoFloat; 4]) -> Self {
        match precise::rounded_direction(components) {
            Some(body_to_world) => Self::of_canonical(body_to_world),
            None => Self::identity(),
        }
    }

    /// The canonical quaternion, Hamilton, body to world; its norm is between 2^399 and 2^401.
    pub(crate) fn canonical(&self) -> &Quaternion<f64> {
        &self.body_to_world
    }

    /// The same attitude by that of q and −q whose scalar is not negative.
    pub(crate) fn with_scalar_not_negative(self) -> Self {
        if self.body_to_world.w < 0.0 {
            return Self {
                body_to_world: -self.body_to_world,
            };
        }
        self
    }

    /// The opposite turn, which carries the body axes onto the world axes.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self {
            body_to_world: self.body_to_world.conjugate(),
        }
    }

    /// The turn that leads from this attitude to the other, on the axes of this body:
    /// `R_WAᵀ R_WB`.
    ///
    /// With all its digits, however small it is.
    #[must_use]
    pub fn turn_to(&self, other: &Self) -> Self {
        self.inverse() * *other
    }
}
