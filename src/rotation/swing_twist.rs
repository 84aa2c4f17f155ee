//! An attitude as a turn about a given axis and the rest, which leaves no turn about it.

use crate::rotation::precise::{self, UNIT_ROUNDOFF};
use crate::rotation::{NoRotation, Rotation};
use nalgebra::{Quaternion, Vector3};
use std::f64::consts::TAU;

/// Scalar and part along the axis together, of a quaternion of norm 1, that are nothing but rounding.
const NO_TWIST_BELOW: f64 = 4.0 * UNIT_ROUNDOFF;

/// An attitude in two turns, of which one is about a given axis.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias("swing-twist decomposition", "heading", "tilt"))]
pub struct SwingTwist {
    /// The angle of the twist about the axis, right-handed, above −π and up to π. `None` where no twist
    /// is nearer to the attitude than the others: at half a turn about an axis that is perpendicular.
    pub twist_rad: Option<f64>,
    /// The turn about the axis, which is of all turns about it the nearest to the attitude.
    pub twist: Rotation,
    /// What follows it on the world's axes, `R_WB = R_swing R_twist`: about an axis perpendicular to the
    /// one that is given.
    pub swing: Rotation,
    /// The same angle on the axes of the twisted body, `R_WB = R_twist R_body_swing`.
    pub body_swing: Rotation,
}

impl Rotation {
    /// The attitude as a twist about an axis and a swing without any.
    ///
    /// With `q = [w, v]` and a of length 1, the twist is `[w, (v·a) a]` divided by its norm, and the swing
    /// `q ⊙ twist*` (Dobrowolski 2015, section 5). The axis has the same coordinates in the world and in
    /// the twisted body.
    ///
    /// # Errors
    ///
    /// [`NoRotation`] for an axis of length 0 or one that is not finite.
    ///
    /// ```
    /// use quatlas::{Rotation, nalgebra::Vector3};
    /// // Heading 65°, pitch 20°, roll −35°: the heading without the tilt is not the yaw angle.
    /// let angles = [65.0_f64, 20.0, -35.0].map(f64::to_radians);
    /// let attitude = Rotation::from_euler_rad("ZYX".parse()?, angles)?;
    /// let parts = attitude.swing_twist([0.0, 0.0, 1.0])?;
    /// let heading_deg = parts.twist_rad.expect("one is nearest").to_degrees();
    /// assert!((heading_deg - 71.3642).abs() < 1e-4);
    /// assert!((parts.swing.angle_rad().to_degrees() - 39.6685).abs() < 1e-4);
    /// // The tilt is about a horizontal axis, and follows the heading on the world's axes.
    /// assert!(parts.swing.rotation_vector_rad().z.abs() < 1e-15);
    /// assert!((parts.swing * parts.twist).angle_to_rad(&attitude) < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias("decompose", "twist"))]
    pub fn swing_twist(&self, axis: [f64; 3]) -> Result<SwingTwist, NoRotation> {
        let axis = Vector3::from(axis);
        let direction = precise::direction(&axis)
            .filter(|_| axis.iter().all(|number| number.is_finite()))
            .ok_or(NoRotation)?;
        let q = self.canonical();
        let along = q.vector().dot(&direction);
        let size = libm::hypot(q.w, along);
        let is_determined = size > NO_TWIST_BELOW * q.norm();
        let twist = if is_determined {
            Self::from_canonical(&Quaternion::from_parts(q.w, direction * along))
        } else {
            Self::identity()
        };
        let angle = 2.0 * libm::atan2(along, q.w);
        let angle = if angle > TAU / 2.0 {
            angle - TAU
        } else if angle <= -TAU / 2.0 {
            angle + TAU
        } else {
            angle
        };
        Ok(SwingTwist {
            twist_rad: is_determined.then_some(angle),
            twist,
            swing: *self * twist.inverse(),
            body_swing: twist.turn_to(self),
        })
    }
}
