//! Small turns added to attitudes and taken between them: ⊕ and ⊖.
//!
//! The increment δ is the right-handed turn of the body, in radians, on the body's axes (*local*) or
//! on the world's (*global*). Where it enters depends on the convention (specification, tables 2.2
//! and 2.3): `Exp(σδ)` stands on the right of the quaternion if its operator is `R_WB` and the
//! increment local, or if it is `R_BW` and the increment global; on the left otherwise.
//!
//! A library may leave out that sign; then its numbers are `θ = σδ` (for matrices `τδ`). That is the
//! [`IncrementSign::Formal`](crate::IncrementSign::Formal) one, which the field guide's addition lines use. Local or global alone
//! does not tell which.

use crate::convention::matrix::MatrixConvention;
use crate::convention::side::{IncrementSign, Side};
use crate::convention::{Convention, Perturbation};
use crate::rotation::quaternion::{self, TaggedQuaternion};
use crate::rotation::tagged_matrix::TaggedMatrix;
use crate::rotation::{NoRotation, Rotation};
use nalgebra::{Matrix3, Quaternion, Vector3};

/// The Hamilton quaternion of a rotation vector, `[cos(|v|/2), sin(|v|/2) v/|v|]`.
///
/// Its numbers are the same in both products, as powers of one axis commute.
pub(crate) fn exponential(vector_rad: Vector3<f64>) -> Result<Quaternion<f64>, NoRotation> {
    let rotation = Rotation::from_rotation_vector_rad(vector_rad.into())?;
    Ok(rotation.to_tagged(Convention::HAMILTON).components)
}

fn logarithm(quaternion: &Quaternion<f64>) -> Result<Vector3<f64>, NoRotation> {
    let numbers = TaggedQuaternion {
        components: *quaternion,
        convention: Convention::HAMILTON,
    };
    Ok(Rotation::from_tagged(&numbers)?.rotation_vector_rad())
}

impl TaggedQuaternion {
    /// The quaternion after an increment, `q ⊕ δ`, on the axes that the convention's perturbation
    /// names; the norm stays.
    ///
    /// `q∘Exp(σδ)` or `Exp(σδ)∘q` (specification, FX-24 and table 2.2).
    ///
    /// # Errors
    ///
    /// [`NoRotation`] for an increment that is not finite.
    ///
    /// ```
    /// use quatlas::{Convention, IncrementSign, Rotation, TaggedQuaternion};
    /// use quatlas::nalgebra::Vector3;
    /// use std::f64::consts::FRAC_PI_2;
    /// // A quarter turn about z, then one about the body's x: JPL puts it on the left.
    /// let yawed = TaggedQuaternion::new(1.0, 0.0, 0.0, 1.0, Convention::JPL);
    /// let rolled = yawed.plus([FRAC_PI_2, 0.0, 0.0], IncrementSign::Physical)?;
    /// // The body's y axis, which pointed to −x, ends up.
    /// let up = Rotation::from_tagged(&rolled)?.body_to_world(Vector3::y());
    /// assert!((up - Vector3::z()).amax() < 5e-16);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[doc(alias("boxplus", "⊕", "retract"))]
    pub fn plus(&self, increment_rad: [f64; 3], sign: IncrementSign) -> Result<Self, NoRotation> {
        let factor = self.convention.increment_factor(sign);
        let increment = exponential(Vector3::from(increment_rad) * factor)?;
        let hand = self.convention.handedness;
        Ok(Self {
            components: match self.convention.increment_side() {
                Side::Right => quaternion::product(hand, &self.components, &increment),
                Side::Left => quaternion::product(hand, &increment, &self.components),
            },
            ..*self
        })
    }

    /// The increment that leads from an estimate to this quaternion, `q ⊖ q̂`: of at most π, with
    /// `q̂ ⊕ (q ⊖ q̂) = q` but for the sign.
    ///
    /// # Errors
    ///
    /// [`NoRotation`] where one of the two is zero or not finite.
    ///
    /// The convention is that of `self`; the estimate is converted to it first.
    #[doc(alias("boxminus", "⊖", "local coordinates"))]
    pub fn minus(&self, estimate: &Self, sign: IncrementSign) -> Result<Vector3<f64>, NoRotation> {
        let error = self.error_from(estimate)?;
        Ok(logarithm(&error.components)? * self.convention.increment_factor(sign))
    }

    /// The error quaternion δq of an estimate: `q = q̂∘δq` or `q = δq∘q̂`, on the side of the
    /// convention's increments, with norm 1.
    ///
    /// For small turns `δq ≈ [1, σδ/2]`, which [`small_angle_quaternion`] gives (Cheng 2018,
    /// eqs. 2.27 to 2.29).
    ///
    /// # Errors
    ///
    /// [`NoRotation`] where one of the two is zero or not finite.
    #[doc(alias("δq", "error state"))]
    pub fn error_from(&self, estimate: &Self) -> Result<Self, NoRotation> {
        let estimate = estimate.to_convention(self.convention);
        let inverse = estimate.normalize().ok_or(NoRotation)?.conjugate();
        let unit = self.normalize().ok_or(NoRotation)?;
        let hand = self.convention.handedness;
        let components = match self.convention.increment_side() {
            Side::Right => quaternion::product(hand, &inverse.components, &unit.components),
            Side::Left => quaternion::product(hand, &unit.components, &inverse.components),
        };
        Ok(Self {
            components,
            ..*self
        })
    }
}

impl TaggedMatrix {
    /// The matrix after an increment, `M ⊕ δ`: `M·Exp(τδ)` or `Exp(τδ)·M` (specification, table 2.3).
    ///
    /// # Errors
    ///
    /// [`NoRotation`] for an increment that is not finite.
    pub fn plus(
        &self,
        increment_rad: [f64; 3],
        axes: Perturbation,
        sign: IncrementSign,
    ) -> Result<Self, NoRotation> {
        let factor = self.convention.increment_factor(sign);
        let vector = Vector3::from(increment_rad) * factor;
        let increment = Rotation::from_rotation_vector_rad(vector.into())?.body_to_world_matrix();
        Ok(Self {
            entries: match self.convention.increment_side(axes) {
                Side::Right => self.entries * increment,
                Side::Left => increment * self.entries,
            },
            ..*self
        })
    }

    /// The increment that leads from an estimate to this matrix, `M ⊖ M̂`, of at most π
    /// (specification, FX-05).
    ///
    /// # Errors
    ///
    /// [`NoRotation`] where one of the two has no nearest rotation.
    pub fn minus(
        &self,
        estimate: &Self,
        axes: Perturbation,
        sign: IncrementSign,
    ) -> Result<Vector3<f64>, NoRotation> {
        let error = Self {
            entries: self.error_from(estimate, axes),
            convention: MatrixConvention::BODY_TO_WORLD,
        };
        let nearest = Rotation::nearest_to_matrix(&error).map_err(|_| NoRotation)?;
        Ok(nearest.rotation.rotation_vector_rad() * self.convention.increment_factor(sign))
    }

    /// The error matrix δM of an estimate: `M = M̂ δM` or `M = δM M̂`, on the side of the increments.
    ///
    /// For small turns `δM ≈ I + [τδ]×`, which [`small_angle_matrix`] gives (Cheng 2018, eqs. 2.30
    /// and 2.31).
    #[must_use]
    pub fn error_from(&self, estimate: &Self, axes: Perturbation) -> Matrix3<f64> {
        let inverse = estimate.to_convention(self.convention).entries.transpose();
        match self.convention.increment_side(axes) {
            Side::Right => inverse * self.entries,
            Side::Left => self.entries * inverse,
        }
    }
}

/// `[1, δ/2]`: the exponential of a small turn but for terms of second order (Cheng 2018, eq. 2.29).
///
/// Its norm is not 1.
#[must_use]
pub fn small_angle_quaternion(turn_rad: [f64; 3]) -> Quaternion<f64> {
    Quaternion::from_parts(1.0, Vector3::from(turn_rad) / 2.0)
}

/// `I + [δ]×`: the matrix of a small turn but for terms of second order (Cheng 2018, eq. 2.30).
///
/// It is not a rotation.
#[must_use]
pub fn small_angle_matrix(turn_rad: [f64; 3]) -> Matrix3<f64> {
    Matrix3::identity() + Vector3::from(turn_rad).cross_matrix()
}
