//! Poses between named frames, and composition along a path.
//!
//! A pose tells where a frame is in another one: `ᴾR_C` takes coordinates in the child C to
//! coordinates in the parent P, and `ᴾp_C` is the origin of C in coordinates of P (Yoosefian 2021,
//! section 2). So `ᴾx = ᴾR_C ᶜx + ᴾp_C`.

use crate::rotation::Rotation;
use nalgebra::Vector3;
use std::fmt;

/// The pose of a child frame in a parent frame.
#[derive(Clone, Debug, PartialEq)]
#[doc(alias("transform", "SE(3)", "extrinsics", "lever arm"))]
pub struct Pose {
    /// The frame in which the position is given.
    pub parent: String,
    /// The frame whose pose it is.
    pub child: String,
    /// The attitude of the child, as a body, in the parent, as a world.
    pub rotation: Rotation,
    /// The origin of the child in coordinates of the parent.
    pub position: Vector3<f64>,
}

/// Two poses were composed that share no frame where they should meet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FramesDoNotMeet {
    child: String,
    parent: String,
}

impl fmt::Display for FramesDoNotMeet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the first pose ends at {} and the next one begins at {}",
            self.child, self.parent
        )
    }
}

impl std::error::Error for FramesDoNotMeet {}

impl Pose {
    /// The pose of `child` in `parent`.
    #[must_use]
    pub fn new(parent: &str, child: &str, rotation: Rotation, position: [f64; 3]) -> Self {
        Self {
            parent: parent.to_owned(),
            child: child.to_owned(),
            rotation,
            position: position.into(),
        }
    }

    /// The coordinates in the parent of a point given in the child.
    #[must_use]
    pub fn to_parent(&self, point: Vector3<f64>) -> Vector3<f64> {
        self.rotation.body_to_world(point) + self.position
    }

    /// The pose of the parent in the child: `ᶜR_P = (ᴾR_C)ᵀ`, `ᶜp_P = −ᶜR_P ᴾp_C`.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self {
            parent: self.child.clone(),
            child: self.parent.clone(),
            rotation: self.rotation.inverse(),
            position: -self.rotation.world_to_body(self.position),
        }
    }

    /// The pose at the end of a path of two: of C in A, from that of B in A and that of C in B.
    ///
    /// `ᴬR_C = ᴬR_B ᴮR_C` and `ᴬp_C = ᴬp_B + ᴬR_B ᴮp_C`.
    ///
    /// # Errors
    ///
    /// [`FramesDoNotMeet`] where the child of this pose is not the parent of the next.
    ///
    /// ```
    /// use quatlas::{Pose, Rotation, nalgebra::Vector3};
    /// use std::f64::consts::FRAC_PI_2;
    /// let yawed = Rotation::from_axis_angle([0.0, 0.0, 1.0], FRAC_PI_2)?;
    /// // A camera one metre ahead of a body that looks along the world's y axis.
    /// let body = Pose::new("world", "body", yawed, [5.0, 0.0, 0.0]);
    /// let camera = Pose::new("body", "camera", yawed, [1.0, 0.0, 0.0]);
    /// let both = body.then(&camera)?;
    /// assert!((both.position - Vector3::new(5.0, 1.0, 0.0)).amax() < 1e-15);
    /// assert!(camera.then(&body).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn then(&self, next: &Self) -> Result<Self, FramesDoNotMeet> {
        if self.child != next.parent {
            return Err(FramesDoNotMeet {
                child: self.child.clone(),
                parent: next.parent.clone(),
            });
        }
        Ok(Self {
            parent: self.parent.clone(),
            child: next.child.clone(),
            rotation: self.rotation * next.rotation,
            position: self.to_parent(next.position),
        })
    }
}
