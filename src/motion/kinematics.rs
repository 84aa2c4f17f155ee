//! How attitudes change in time: derivatives, integration, and rates from samples.
//!
//! The angular velocity ω is that of the body against the world, right-handed, in radians per unit
//! of time, with components on the body's axes (`ω_B`, what a gyroscope measures) or on the world's
//! (`ω_W = R_WB ω_B`). On which side it stands follows the increments of the same axes: the
//! derivative of `q∘Exp(σδ)` is `(σ/2) q∘ω` (specification, FX-25 and table 2.2).

use crate::convention::side::{IncrementSign, Side};
use crate::convention::{Convention, Handedness, Perturbation};
use crate::rotation::quaternion::TaggedQuaternion;
use crate::rotation::tagged_matrix::TaggedMatrix;
use crate::rotation::{NoRotation, Rotation};
use nalgebra::{Matrix3, Matrix3x4, Matrix4, Quaternion, Vector3};
use serde::{Deserialize, Serialize};

/// On which axes an angular velocity is given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[doc(alias("gyroscope", "angular rate"))]
pub enum RateAxes {
    /// The axes of the body: `ω_B`.
    #[default]
    Body,
    /// The axes of the world: `ω_W`.
    World,
}

impl RateAxes {
    /// The increments that are on the same axes.
    pub(crate) const fn perturbation(self) -> Perturbation {
        match self {
            Self::Body => Perturbation::Local,
            Self::World => Perturbation::Global,
        }
    }
}

/// How the rate is sampled in a step, and how fast the error vanishes with the step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum IntegrationOrder {
    /// The rate at the beginning; exact where it is constant.
    First,
    /// The rate in the middle.
    Second,
    /// The rates at the two Gauss points, with the term by which turns do not commute (Magnus).
    Fourth,
}

impl IntegrationOrder {
    /// The rotation vector of a step, see [`Rotation::step`].
    pub(crate) fn turn_rad(
        self,
        rate_rad: &dyn Fn(f64) -> Vector3<f64>,
        axes: RateAxes,
        time: f64,
        step: f64,
    ) -> Vector3<f64> {
        match self {
            Self::First => rate_rad(time) * step,
            Self::Second => rate_rad(time + step / 2.0) * step,
            Self::Fourth => {
                let root = 3.0_f64.sqrt();
                let early = rate_rad(time + (0.5 - root / 6.0) * step);
                let late = rate_rad(time + (0.5 + root / 6.0) * step);
                let commutator = early.cross(&late) * (root / 12.0 * step * step);
                let mean = (early + late) * (step / 2.0);
                match axes {
                    RateAxes::Body => mean + commutator,
                    RateAxes::World => mean - commutator,
                }
            }
        }
    }
}

impl Convention {
    /// The matrix `Ω(ω)` with `q̇ = ½ Ω(ω) q`, for arrays in the order of this convention.
    ///
    /// Cheng 2018, eq. 2.36, and Yoosefian 2021, eq. 10, print that of Hamilton with the body's
    /// rate; Yoosefian's eq. 17 is that of JPL.
    ///
    /// ```
    /// use quatlas::{Convention, RateAxes};
    /// let rows = |matrix: quatlas::nalgebra::Matrix4<f64>| -> [[f64; 4]; 4] { matrix.transpose().into() };
    /// let jpl = Convention::JPL.rate_matrix([1.0, 2.0, 3.0], RateAxes::Body);
    /// assert_eq!(rows(jpl)[0], [0.0, 3.0, -2.0, 1.0]);
    /// let hamilton = Convention::HAMILTON.rate_matrix([1.0, 2.0, 3.0], RateAxes::Body);
    /// assert_eq!(rows(hamilton)[1], [1.0, 0.0, 3.0, -2.0]);
    /// ```
    #[must_use]
    #[doc(alias("Omega", "Ω"))]
    pub fn rate_matrix(self, rate_rad: [f64; 3], axes: RateAxes) -> Matrix4<f64> {
        let rate = self.signed_rate(rate_rad);
        match self.rate_side(axes) {
            Side::Right => rate.right_product_matrix(),
            Side::Left => rate.left_product_matrix(),
        }
    }

    /// The side on which the rate stands in `q̇`.
    #[must_use]
    pub const fn rate_side(self, axes: RateAxes) -> Side {
        Self {
            perturbation: axes.perturbation(),
            ..self
        }
        .increment_side()
    }

    /// The pure quaternion σω.
    fn signed_rate(self, rate_rad: [f64; 3]) -> TaggedQuaternion {
        let sign = self.increment_factor(IncrementSign::Physical);
        TaggedQuaternion {
            components: Quaternion::from_parts(0.0, Vector3::from(rate_rad) * sign),
            convention: self,
        }
    }
}

impl TaggedQuaternion {
    /// The derivative `q̇` of the components, by name, for an angular velocity.
    ///
    /// `(σ/2) q∘ω` or `(σ/2) ω∘q` (specification, table 2.2; Cheng 2018, eq. 2.34).
    ///
    /// ```
    /// use quatlas::{Convention, RateAxes, TaggedQuaternion};
    /// // Yawed by a quarter turn, rolling about the body's x: the numbers of Hamilton and JPL
    /// // agree, and so do their derivatives.
    /// for convention in [Convention::HAMILTON, Convention::JPL] {
    ///     let q = TaggedQuaternion::new(0.5, 0.0, 0.0, 0.5, convention);
    ///     let derivative = q.derivative([4.0, 0.0, 0.0], RateAxes::Body);
    ///     assert_eq!((derivative.i, derivative.j), (1.0, 1.0));
    /// }
    /// ```
    #[must_use]
    #[doc(alias("q_dot", "qdot"))]
    pub fn derivative(&self, rate_rad: [f64; 3], axes: RateAxes) -> Quaternion<f64> {
        let rate = self.convention.signed_rate(rate_rad).components;
        // p ⊗ q = q ⊙ p (Cheng 2018, eq. 2.4), and nalgebra multiplies as Hamilton.
        let is_right = self.convention.rate_side(axes) == Side::Right;
        let is_hamilton = self.convention.handedness == Handedness::Right;
        let product = if is_right == is_hamilton {
            self.components * rate
        } else {
            rate * self.components
        };
        product / 2.0
    }
}

impl TaggedMatrix {
    /// The derivative `Ṁ` for an angular velocity.
    ///
    /// `M [ω_B]× = [ω_W]× M` where M is `R_WB`, `−[ω_B]× M = −M [ω_W]×` where it is `R_BW`
    /// (specification, FX-06; Cheng 2018, eqs. 1.10 and 2.37, which write both rates ω).
    ///
    /// ```
    /// use quatlas::{MatrixConvention, RateAxes, Rotation, nalgebra::Vector3};
    /// // The body's x axis points along y and the body yaws: the tip moves along −x.
    /// let yawed = Rotation::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2)?;
    /// let matrix = yawed.to_tagged_matrix(MatrixConvention::BODY_TO_WORLD);
    /// let velocity = matrix.derivative([0.0, 0.0, 2.0], RateAxes::Body) * Vector3::x();
    /// assert!((velocity - Vector3::new(-2.0, 0.0, 0.0)).amax() < 1e-15);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[must_use]
    #[doc(alias("R_dot"))]
    pub fn derivative(&self, rate_rad: [f64; 3], axes: RateAxes) -> Matrix3<f64> {
        let skew = Vector3::from(rate_rad).cross_matrix();
        let signed = skew * self.convention.increment_factor(IncrementSign::Physical);
        match self.convention.increment_side(axes.perturbation()) {
            Side::Right => self.entries * signed,
            Side::Left => signed * self.entries,
        }
    }

    /// The change of `M x` with an increment of the attitude, `∂(M x)/∂δ`: `−τ M [x]×` where the
    /// increment stands on the right, `−τ [M x]×` where it stands on the left (specification, FX-06).
    ///
    /// In the pairing of an active quaternion with the passive matrix world to body, as in the field
    /// guide's "My Lab", it has the other sign than with `R_WB`.
    #[must_use]
    pub fn action_jacobian(&self, vector: [f64; 3], axes: Perturbation) -> Matrix3<f64> {
        let vector = Vector3::from(vector);
        let by_formal_increment = match self.convention.increment_side(axes) {
            Side::Right => -(self.entries * vector.cross_matrix()),
            Side::Left => -(self.entries * vector).cross_matrix(),
        };
        by_formal_increment * self.convention.increment_factor(IncrementSign::Physical)
    }
}

/// The change of `q ⊙ x ⊙ q*` with the four components of q, columns w, x, y, z; for every norm.
///
/// `2 [w x + v×x | (v·x) I + v xᵀ − x vᵀ − w [x]×]` (specification, FX-25).
/// The Jacobians of a product are its product matrices: `∂(p∘q)/∂q` is
/// [`TaggedQuaternion::left_product_matrix`] of p, `∂(p∘q)/∂p` the right one of q.
///
/// ```
/// use quatlas::{action_jacobian, nalgebra::{Quaternion, Vector3}};
/// // q = 1 and a little k turns x towards y, twice as fast.
/// let jacobian = action_jacobian(&Quaternion::new(1.0, 0.0, 0.0, 0.0), &Vector3::x());
/// assert_eq!(jacobian.column(3), 2.0 * Vector3::y());
/// ```
#[must_use]
pub fn action_jacobian(quaternion: &Quaternion<f64>, vector: &Vector3<f64>) -> Matrix3x4<f64> {
    let (w, v): (f64, Vector3<f64>) = (quaternion.w, quaternion.vector().into());
    let by_scalar = vector * w + v.cross(vector);
    let by_vector = Matrix3::from_diagonal_element(v.dot(vector)) + v * vector.transpose()
        - vector * v.transpose()
        - vector.cross_matrix() * w;
    let mut jacobian = Matrix3x4::zeros();
    jacobian.set_column(0, &(by_scalar * 2.0));
    jacobian
        .fixed_columns_mut::<3>(1)
        .copy_from(&(by_vector * 2.0));
    jacobian
}

impl Rotation {
    /// The attitude after this one turned by a rotation vector on the given axes:
    /// `R_WB Exp(v)` on those of the body, `Exp(v) R_WB` on those of the world.
    ///
    /// # Errors
    ///
    /// [`NoRotation`] for numbers that are not finite.
    pub fn turned_by_rad(&self, vector_rad: [f64; 3], axes: RateAxes) -> Result<Self, NoRotation> {
        let turn = Self::from_rotation_vector_rad(vector_rad)?;
        Ok(match axes {
            RateAxes::Body => *self * turn,
            RateAxes::World => turn * *self,
        })
    }

    /// The attitude one step later, for a rate that is a function of time.
    ///
    /// With h the step: `h ω(t)`; `h ω(t + h/2)`; or `h (ω_a + ω_b)/2 ± (√3/12) h² ω_a×ω_b` with the
    /// rates at `t + (½ ∓ √3/6) h`, plus for the body's rate (specification, FX-06). The result is a
    /// rotation; nothing has to be normalised.
    ///
    /// # Errors
    ///
    /// [`NoRotation`] for a rate or a step that is not finite.
    ///
    /// ```
    /// use quatlas::{IntegrationOrder, RateAxes, Rotation, nalgebra::Vector3};
    /// // One second at a quarter turn per second about the body's z.
    /// let rate = |_time| Vector3::new(0.0, 0.0, std::f64::consts::FRAC_PI_2);
    /// let start = Rotation::identity();
    /// let end = start.step(rate, RateAxes::Body, 0.0, 1.0, IntegrationOrder::First)?;
    /// assert!((end.body_to_world(Vector3::x()) - Vector3::y()).amax() < 3e-16);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[doc(alias("integrate", "propagate", "Magnus"))]
    pub fn step(
        &self,
        rate_rad: impl Fn(f64) -> Vector3<f64>,
        axes: RateAxes,
        time: f64,
        step: f64,
        order: IntegrationOrder,
    ) -> Result<Self, NoRotation> {
        let turn = order.turn_rad(&rate_rad, axes, time, step);
        self.turned_by_rad(turn.into(), axes)
    }

    /// The mean angular velocity that leads from this attitude to a later one, in radians per unit
    /// of the step.
    ///
    /// `Log(R_kᵀ R_k+1)/h` on the axes of the body, `Log(R_k+1 R_kᵀ)/h` on those of the world: of
    /// second order at the middle of the step (specification, FX-06). It is that of the shorter turn.
    ///
    /// ```
    /// use quatlas::{RateAxes, Rotation};
    /// use std::f64::consts::FRAC_PI_2;
    /// // Yawed by a quarter turn, then rolled about the body's x, which is the world's y.
    /// let yawed = Rotation::from_axis_angle([0.0, 0.0, 1.0], FRAC_PI_2)?;
    /// let rolled = yawed.turned_by_rad([0.3, 0.0, 0.0], RateAxes::Body)?;
    /// assert!((yawed.rate_to(&rolled, RateAxes::Body, 0.1).x - 3.0).abs() < 1e-14);
    /// assert!((yawed.rate_to(&rolled, RateAxes::World, 0.1).y - 3.0).abs() < 1e-14);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[must_use]
    #[doc(alias("angular velocity from samples"))]
    pub fn rate_to(&self, later: &Self, axes: RateAxes, step: f64) -> Vector3<f64> {
        let turn = match axes {
            RateAxes::Body => self.inverse() * *later,
            RateAxes::World => *later * self.inverse(),
        };
        turn.rotation_vector_rad() / step
    }
}
