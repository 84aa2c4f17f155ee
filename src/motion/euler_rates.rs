//! Euler angle rates: to angular velocity, and back except at gimbal lock.

use crate::convention::euler_sequence::{EulerFrame, EulerSequence};
use crate::motion::kinematics::RateAxes;
use crate::rotation::NoRotation;
use crate::rotation::euler::GIMBAL_LOCK_RAD;
use nalgebra::{Matrix3, Unit, UnitQuaternion, Vector3};
use std::fmt;

/// The angle rates are infinite: the axes of the three angles lie in a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingularRates {
    /// The determinant of the map, the volume that the three axes span; 0 at the lock.
    pub determinant: f64,
}

impl fmt::Display for SingularRates {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("at gimbal lock the angle rates are not determined by the angular velocity")
    }
}

impl std::error::Error for SingularRates {}

impl EulerSequence {
    /// The matrix that makes the angular velocity of the angle rates, in the order of the sequence.
    ///
    /// Its columns are the axes of the three angles, on the body's axes or on the world's:
    /// `ω_B = (R_j R_k)ᵀ e_i ȧ + R_kᵀ e_j ḃ + e_k ċ` for an intrinsic sequence (specification,
    /// FX-10). Its determinant is `∓cos` of the middle angle, or `∓sin` where the outer axes are the
    /// same.
    ///
    /// # Errors
    ///
    /// [`NoRotation`] for angles that are not finite.
    ///
    /// ```
    /// use quatlas::{EulerSequence, RateAxes, nalgebra::Vector3};
    /// use std::f64::consts::FRAC_PI_2;
    /// // Rolled by a quarter turn, the nose level: yawing is a turn about the body's y.
    /// let angles = [0.0, 0.0, FRAC_PI_2];
    /// let map = EulerSequence::AEROSPACE.rate_matrix(angles, RateAxes::Body)?;
    /// assert!((map * Vector3::x() - Vector3::y()).amax() < 3e-16);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    pub fn rate_matrix(
        self,
        angles_rad: [f64; 3],
        axes: RateAxes,
    ) -> Result<Matrix3<f64>, NoRotation> {
        if !angles_rad.iter().all(|angle| angle.is_finite()) {
            return Err(NoRotation);
        }
        // The turns from the outermost inwards on the world's axes, and back from the innermost on the
        // body's; those that are passed turn the axis of the next.
        let (mut places, forward) = match axes {
            RateAxes::World => ([0, 1, 2], 1.0),
            RateAxes::Body => ([2, 1, 0], -1.0),
        };
        if self.frame == EulerFrame::Extrinsic {
            places.reverse();
        }
        let names = self.axes.axes();
        let mut matrix = Matrix3::zeros();
        let mut passed = UnitQuaternion::identity();
        for place in places {
            let mut axis = Vector3::zeros();
            axis[names[place].index()] = 1.0;
            matrix.set_column(place, &(passed * axis));
            let angle = forward * angles_rad[place];
            passed *= UnitQuaternion::from_axis_angle(&Unit::new_unchecked(axis), angle);
        }
        Ok(matrix)
    }

    /// The angle rates for an angular velocity, in the order of the sequence.
    ///
    /// # Errors
    ///
    /// [`SingularRates`] within [`GIMBAL_LOCK_RAD`] of gimbal lock, where the rates grow beyond all
    /// bounds: turn to another sequence or to quaternions there. Also for angles that are not
    /// finite.
    ///
    /// ```
    /// use quatlas::{EulerSequence, RateAxes};
    /// // 3-2-1 with the nose 60° up: a turn about the world's z is yaw alone, and one about the
    /// // body's x is roll alone.
    /// let angles = [0.2, -60.0_f64.to_radians(), 0.3];
    /// let rates = EulerSequence::AEROSPACE.angle_rates(angles, [1.0, 0.0, 0.0], RateAxes::Body)?;
    /// assert!(rates[0].abs() < 1e-15 && (rates[2] - 1.0).abs() < 1e-15);
    /// # Ok::<(), quatlas::SingularRates>(())
    /// ```
    pub fn angle_rates(
        self,
        angles_rad: [f64; 3],
        rate_rad: [f64; 3],
        axes: RateAxes,
    ) -> Result<[f64; 3], SingularRates> {
        let (rates, determinant) = self.rates_and_determinant(angles_rad, rate_rad, axes);
        rates.ok_or(SingularRates { determinant })
    }

    /// The angle rates, unless they are infinite, and the determinant of the matrix of the rates.
    pub(crate) fn rates_and_determinant(
        self,
        angles_rad: [f64; 3],
        rate_rad: [f64; 3],
        axes: RateAxes,
    ) -> (Option<[f64; 3]>, f64) {
        let Ok(map) = self.rate_matrix(angles_rad, axes) else {
            return (None, 0.0);
        };
        // By Cramer's rule, as the determinant is of use in itself.
        let [first, middle, third] = [map.column(0), map.column(1), map.column(2)];
        let across = [
            middle.cross(&third),
            third.cross(&first),
            first.cross(&middle),
        ];
        let determinant = first.dot(&across[0]);
        let rate = Vector3::from(rate_rad);
        let rates = across.map(|normal| normal.dot(&rate) / determinant);
        let is_free = determinant.abs() > GIMBAL_LOCK_RAD;
        (is_free.then_some(rates), determinant)
    }
}
