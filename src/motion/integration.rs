//! Attitudes after a step by the classical Runge–Kutta method, in the numbers that programs keep.
//!
//! [`Rotation::step`](crate::Rotation::step) multiplies by turns, and is what to use where there is a
//! choice: its result is a rotation, and nothing is singular. Many programs integrate their own
//! numbers instead: four components, three angles, or a rotation vector, each with its derivative.
//! These are here to be compared with and to be tested against. All three have fourth order where
//! their derivative is smooth: half the step, a sixteenth of the error.
//!
//! | numbers | derivative | singular | after the step |
//! |---|---|---|---|
//! | components | `q̇ = (σ/2) q∘ω` or `(σ/2) ω∘q` | nowhere | divided by the norm |
//! | Euler angles | by the inverse of the matrix of the rates | at gimbal lock | left as they are |
//! | rotation vector | `v̇ = J_r⁻¹ ω_B = J_l⁻¹ ω_W` | at 2π | brought back below π |
//!
//! (Specification, FX-25, FX-10 and FX-18, which fill places of the field guide that are empty.) The
//! rates are right-handed, in radians per unit of time, and functions of time.

use crate::convention::euler_sequence::EulerSequence;
use crate::motion::kinematics::RateAxes;
use crate::rotation::precise::Norm;
use crate::rotation::quaternion::TaggedQuaternion;
use crate::rotation::rotation_vector::rotation_vector_rate;
use nalgebra::{Quaternion, Vector3, Vector4};
use std::f64::consts::{PI, TAU};
use std::fmt;

/// A step that cannot be taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoStep {
    /// The numbers have no finite derivative there: Euler angles at gimbal lock, a rotation vector
    /// of a whole turn.
    Singular,
    /// What comes in or out is not finite, or the quaternion is zero.
    NotFinite,
}

impl fmt::Display for NoStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Singular => {
                "the step leads through a place where these numbers have no derivative"
            }
            Self::NotFinite => "a step needs finite numbers, and a quaternion that is not zero",
        })
    }
}

impl std::error::Error for NoStep {}

impl TaggedQuaternion {
    /// The quaternion of norm 1 one step later, by the classical Runge–Kutta method on the four
    /// components, divided by their norm at the end.
    ///
    /// On `q̇ = (σ/2) q∘ω` or `(σ/2) ω∘q`, the side by the convention and the axes of the rate
    /// (specification, FX-25 and table 2.2; Cheng 2018, eq. 2.34; Yoosefian 2021, eqs. 9 and 16).
    ///
    /// # Errors
    ///
    /// [`NoStep::NotFinite`] for the zero quaternion, and for a rate or a step that is not finite.
    ///
    /// ```
    /// use quatlas::{Convention, RateAxes, TaggedQuaternion, nalgebra::Vector3};
    /// // JPL, yawed by a quarter turn; a hundredth of a second at 2 rad/s about the body's x.
    /// let yawed = TaggedQuaternion::new(1.0, 0.0, 0.0, 1.0, Convention::JPL);
    /// let rate = |_time| Vector3::new(2.0, 0.0, 0.0);
    /// let rolled = yawed.runge_kutta_step(rate, RateAxes::Body, 0.0, 0.01)?;
    /// // (cos + sin k)(cos + sin i) of the half angles: the body's x is the world's y.
    /// let (half, small) = (0.5_f64.sqrt(), 0.01_f64);
    /// let expected = [small.sin(), small.sin(), small.cos(), small.cos()].map(|part| part * half);
    /// for (got, wanted) in rolled.to_array().into_iter().zip(expected) {
    ///     assert!((got - wanted).abs() < 1e-12);
    /// }
    /// # Ok::<(), quatlas::NoStep>(())
    /// ```
    #[doc(alias("RK4", "integrate", "propagate"))]
    pub fn runge_kutta_step(
        &self,
        rate_rad: impl Fn(f64) -> Vector3<f64>,
        axes: RateAxes,
        time: f64,
        step: f64,
    ) -> Result<Self, NoStep> {
        let start = self.normalize().ok_or(NoStep::NotFinite)?;
        let end = start.runge_kutta_sum(&rate_rad, axes, time, step)?;
        end.normalize().ok_or(NoStep::NotFinite)
    }

    /// The same of a quaternion of norm 1, before the end is divided by its norm, which is 1 but for an error
    /// of fifth order.
    pub(crate) fn runge_kutta_sum(
        &self,
        rate_rad: &dyn Fn(f64) -> Vector3<f64>,
        axes: RateAxes,
        time: f64,
        step: f64,
    ) -> Result<Self, NoStep> {
        let of = |coords| Self {
            components: Quaternion { coords },
            ..*self
        };
        let derivative = |time, coords: Numbers| {
            let rate = rate_rad(time).into();
            Ok(of(coords).derivative(rate, axes).coords)
        };
        runge_kutta(time, step, self.components.coords, &derivative).map(of)
    }
}

impl EulerSequence {
    /// The angles one step later, in the order of the sequence, by the classical Runge–Kutta method on
    /// the three angles.
    ///
    /// On the rates of [`EulerSequence::angle_rates`] (specification, FX-10). Near gimbal lock the rates
    /// are large, and with them the error: take another sequence there, or quaternions. Angles that pass
    /// π are not brought back.
    ///
    /// # Errors
    ///
    /// [`NoStep::Singular`] where the step meets gimbal lock; [`NoStep::NotFinite`] for angles, a rate or
    /// a step that are not finite.
    ///
    /// ```
    /// use quatlas::{EulerSequence, RateAxes, nalgebra::Vector3};
    /// // Rolled by a quarter turn, the nose level: a turn about the body's y is yaw.
    /// let angles = [0.3, 0.0, std::f64::consts::FRAC_PI_2];
    /// let rate = |_time| Vector3::new(0.0, 0.2, 0.0);
    /// let [yaw, pitch, roll] =
    ///     EulerSequence::AEROSPACE.runge_kutta_step(angles, rate, RateAxes::Body, 0.0, 0.5)?;
    /// assert!((yaw - 0.4).abs() < 1e-15 && pitch.abs() < 1e-15 && roll == angles[2]);
    /// # Ok::<(), quatlas::NoStep>(())
    /// ```
    pub fn runge_kutta_step(
        self,
        angles_rad: [f64; 3],
        rate_rad: impl Fn(f64) -> Vector3<f64>,
        axes: RateAxes,
        time: f64,
        step: f64,
    ) -> Result<[f64; 3], NoStep> {
        let derivative = |time, angles: Numbers| {
            if !is_finite(&angles) {
                return Err(NoStep::NotFinite);
            }
            self.angle_rates(angles.xyz().into(), rate_rad(time).into(), axes)
                .map(|rates| Vector3::from(rates).push(0.0))
                .map_err(|_| NoStep::Singular)
        };
        let start = Vector3::from(angles_rad).push(0.0);
        runge_kutta(time, step, start, &derivative).map(|end| end.xyz().into())
    }
}

/// The rotation vector one step later, of at most π, by the classical Runge–Kutta method on its three
/// coordinates.
///
/// On `v̇ = J_r⁻¹(v) ω_B` or `J_l⁻¹(v) ω_W`; where it comes out longer than π it is brought back by whole
/// turns, `v ← (1 − 2π/|v|) v`, which is the same attitude (specification, FX-18). So it stays away from
/// 2π, where the Jacobian has no inverse.
///
/// # Errors
///
/// [`NoStep::Singular`] where a step is so long that it meets a whole turn; [`NoStep::NotFinite`] for a
/// vector, a rate or a step that are not finite.
///
/// ```
/// use quatlas::{RateAxes, nalgebra::Vector3, rotation_vector_runge_kutta_step};
/// use std::f64::consts::PI;
/// // About one axis the angle grows by the rate, and past half a turn it is counted from the other side.
/// let start = Vector3::new(0.0, 0.0, PI - 0.1);
/// let rate = |_time| Vector3::new(0.0, 0.0, 2.0);
/// let end = rotation_vector_runge_kutta_step(start, rate, RateAxes::World, 0.0, 0.25)?;
/// assert!((end - Vector3::new(0.0, 0.0, 0.4 - PI)).amax() < 1e-15);
/// # Ok::<(), quatlas::NoStep>(())
/// ```
#[doc(alias("RK4", "Bortz equation"))]
pub fn rotation_vector_runge_kutta_step(
    vector_rad: Vector3<f64>,
    rate_rad: impl Fn(f64) -> Vector3<f64>,
    axes: RateAxes,
    time: f64,
    step: f64,
) -> Result<Vector3<f64>, NoStep> {
    let derivative = |time, vector: Numbers| {
        if !is_finite(&vector) {
            return Err(NoStep::NotFinite);
        }
        let sign = match axes {
            RateAxes::Body => 1.0,
            RateAxes::World => -1.0,
        };
        let slope = rotation_vector_rate(&(vector.xyz() * sign), &rate_rad(time));
        Ok(slope.ok_or(NoStep::Singular)?.push(0.0))
    };
    let start = within_half_a_turn(vector_rad)?.push(0.0);
    within_half_a_turn(runge_kutta(time, step, start, &derivative)?.xyz())
}

/// The shortest vector of the same turn, up to π long.
fn within_half_a_turn(vector_rad: Vector3<f64>) -> Result<Vector3<f64>, NoStep> {
    let angle = Norm::of(vector_rad.as_slice()).value();
    if !angle.is_finite() {
        return Err(NoStep::NotFinite);
    }
    if angle <= PI {
        return Ok(vector_rad);
    }
    let whole_turns = (angle / TAU).round();
    Ok(vector_rad * (1.0 - whole_turns * TAU / angle))
}

/// Four components, or three numbers and 0: one size, so that the method is compiled once.
type Numbers = Vector4<f64>;

/// The numbers one step later by the classical Runge–Kutta method; never such as are not finite.
fn runge_kutta(
    time: f64,
    step: f64,
    start: Numbers,
    derivative: &dyn Fn(f64, Numbers) -> Result<Numbers, NoStep>,
) -> Result<Numbers, NoStep> {
    let mut slope = Numbers::zeros();
    let mut sum = Numbers::zeros();
    for (part, weight) in [(0.0, 1.0), (0.5, 2.0), (0.5, 2.0), (1.0, 1.0)] {
        let forward = part * step;
        slope = derivative(time + forward, start + slope * forward)?;
        sum += slope * weight;
    }
    let end = start + sum * (step / 6.0);
    is_finite(&end).then_some(end).ok_or(NoStep::NotFinite)
}

fn is_finite(numbers: &Numbers) -> bool {
    numbers.iter().all(|number| number.is_finite())
}
