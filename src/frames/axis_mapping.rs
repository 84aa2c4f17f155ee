//! Other names for the same axes: a frame mapping, by a signed permutation.
//!
//! A mapping takes the coordinates of a vector on one set of axes to those of the same vector on
//! another set: NED to ENU is `y x −z`, for east is the old y, north the old x and up the opposite of
//! down. It is a step of its own, apart from the conventions of quaternions.
//!
//! For a rotation matrix `R_WB`, new world axes make `A_W R_WB`, new body axes `R_WB A_Bᵀ`. If a
//! mapping changes the hand of the axes (determinant −1) on one side only, the product is a
//! reflection, which has no quaternion.

use crate::convention::euler_sequence::Axis;
use crate::rotation::Rotation;
use crate::rotation::nearest::davenport;
use nalgebra::{Matrix3, Matrix4, Quaternion};
use serde::{Deserialize, Serialize};
use std::fmt;
use twofloat::TwoFloat;

/// One new axis: an old one, or its opposite.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SignedAxis {
    /// The old axis.
    pub axis: Axis,
    /// Along it or against it.
    pub sense: Sense,
}

/// Along an axis or against it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum Sense {
    /// Along it.
    Along,
    /// Against it.
    Against,
}

impl Sense {
    fn sign(self) -> f64 {
        match self {
            Self::Along => 1.0,
            Self::Against => -1.0,
        }
    }
}

/// A signed permutation of the axes: which old axis each new one is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct AxisMapping {
    /// The new x, y and z.
    pub axes: [SignedAxis; 3],
}

/// Whether a mapping keeps the hand of the axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum AxesHand {
    /// Determinant +1: right-handed axes stay right-handed.
    Kept,
    /// Determinant −1: right-handed axes become left-handed.
    Changed,
}

/// One side has axes of the other hand and the other side has not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OneSidedReflection;

impl fmt::Display for OneSidedReflection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("only one side changes handedness: a reflection, which has no quaternion")
    }
}

impl std::error::Error for OneSidedReflection {}

impl AxisMapping {
    /// The one that changes nothing.
    pub const NONE: Self = Self {
        axes: [
            SignedAxis::along(Axis::X),
            SignedAxis::along(Axis::Y),
            SignedAxis::along(Axis::Z),
        ],
    };

    /// The matrix A that takes old coordinates to new ones.
    ///
    /// ```
    /// use quatlas::{AxisMapping, nalgebra::Vector3};
    /// let ned_to_enu: AxisMapping = "NED to ENU".parse()?;
    /// // One metre north, two east, three down.
    /// let enu = ned_to_enu.matrix() * Vector3::new(1.0, 2.0, 3.0);
    /// assert_eq!(enu.as_slice(), [2.0, 1.0, -3.0]);
    /// # Ok::<(), quatlas::UnknownAxes>(())
    /// ```
    #[must_use]
    pub fn matrix(&self) -> Matrix3<f64> {
        let row = |at: usize| {
            let SignedAxis { axis, sense } = self.axes[at];
            let mut row = [0.0; 3];
            row[axis.index()] = sense.sign();
            row
        };
        Matrix3::from([row(0), row(1), row(2)]).transpose()
    }

    /// +1 or −1.
    #[must_use]
    pub fn determinant(&self) -> i8 {
        match self.hand() {
            AxesHand::Kept => 1,
            AxesHand::Changed => -1,
        }
    }

    /// Whether the new axes have the same hand as the old ones.
    #[must_use]
    pub fn hand(&self) -> AxesHand {
        if self.matrix().determinant() > 0.0 {
            AxesHand::Kept
        } else {
            AxesHand::Changed
        }
    }

    /// All 48.
    pub(crate) fn all() -> Vec<Self> {
        let mut all = Vec::new();
        for x in SignedAxis::ALL {
            for y in SignedAxis::ALL {
                for z in SignedAxis::ALL {
                    let mapping = Self { axes: [x, y, z] };
                    if mapping.has_every_axis() {
                        all.push(mapping);
                    }
                }
            }
        }
        all
    }

    pub(super) fn has_every_axis(&self) -> bool {
        let [x, y, z] = self.axes;
        x.axis != y.axis && y.axis != z.axis && x.axis != z.axis
    }

    /// Whether every new axis is the old one, or its opposite.
    pub(crate) fn keeps_places(&self) -> bool {
        let [x, y, z] = self.axes;
        (x.axis, y.axis, z.axis) == (Axis::X, Axis::Y, Axis::Z)
    }

    /// The new axes reversed, all three.
    pub(crate) fn opposite(&self) -> Self {
        Self {
            axes: self.axes.map(|SignedAxis { axis, sense }| SignedAxis {
                axis,
                sense: match sense {
                    Sense::Along => Sense::Against,
                    Sense::Against => Sense::Along,
                },
            }),
        }
    }

    /// The old axes in terms of the new.
    pub(crate) fn inverse(&self) -> Self {
        let mut inverse = Self::NONE;
        for (new, SignedAxis { axis, sense }) in Self::NONE.axes.into_iter().zip(self.axes) {
            inverse.axes[axis.index()] = SignedAxis { sense, ..new };
        }
        inverse
    }

    /// How many of the new axes are against old ones.
    pub(crate) fn reversed_axes(&self) -> u8 {
        let mut reversed = 0;
        for signed in self.axes {
            reversed += u8::from(signed.sense == Sense::Against);
        }
        reversed
    }

    /// The turn whose matrix takes old coordinates to new ones, or of the mapping times −1 where that is one.
    pub(crate) fn turn(&self) -> Rotation {
        Rotation::from_canonical(&self.quaternion())
    }

    /// The same turn as a text: `180deg about x`.
    pub(crate) fn turn_in_words(&self) -> String {
        let Quaternion { coords } = self.quaternion();
        let mut axis = Vec::new();
        let mut turned = 0;
        for entry in [coords.x, coords.y, coords.z] {
            turned += u8::from(entry != 0.0);
            axis.push(if entry == 0.0 {
                "0"
            } else if entry > 0.0 {
                "1"
            } else {
                "-1"
            });
        }
        let degrees = match (coords.w == 0.0, turned) {
            (_, 0) => "0",
            (true, _) => "180",
            (false, 1) => "90",
            (false, _) => "120",
        };
        format!("{degrees}deg about [{}]", axis.join(", "))
    }

    /// The quaternion of the mapping, or of the mapping times −1 where that is the rotation. Its norm
    /// is not 1, so it is exact: those of its components that are not 0 have one size, and the first
    /// of them is positive.
    fn quaternion(&self) -> Quaternion<f64> {
        let rotation = self.matrix() * f64::from(self.determinant());
        // Of a rotation Davenport's matrix is 4 q qᵀ − I; the column with the largest diagonal is never
        // zero (Shepperd's method).
        let k = davenport(&rotation.map(TwoFloat::from)).map(|entry| entry.hi());
        let columns = k + Matrix4::identity();
        let [w, x, y, z] = columns
            .column(columns.diagonal().imax())
            .into_owned()
            .into();
        Quaternion::new(w, x, y, z)
    }
}

impl SignedAxis {
    const ALL: [Self; 6] = [
        Self::along(Axis::X),
        Self::along(Axis::Y),
        Self::along(Axis::Z),
        Self::against(Axis::X),
        Self::against(Axis::Y),
        Self::against(Axis::Z),
    ];

    const fn against(axis: Axis) -> Self {
        Self {
            axis,
            sense: Sense::Against,
        }
    }

    const fn along(axis: Axis) -> Self {
        Self {
            axis,
            sense: Sense::Along,
        }
    }
}

/// The axes of the world and of the body under new names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AxesChange {
    /// The new world axes.
    pub world: AxisMapping,
    /// The new body axes.
    pub body: AxisMapping,
}

impl AxesChange {
    /// The one that changes nothing.
    pub const NONE: Self = Self {
        world: AxisMapping::NONE,
        body: AxisMapping::NONE,
    };

    /// The attitude of the new body axes in the new world axes: `A_W R_WB A_Bᵀ`.
    ///
    /// # Errors
    ///
    /// [`OneSidedReflection`] where exactly one of the two changes the hand of the axes.
    ///
    /// ```
    /// use quatlas::{AxesChange, Rotation, nalgebra::Vector3};
    /// use std::f64::consts::FRAC_PI_2;
    ///
    /// // PX4 to ROS: a body (forward, right, down) that heads east, seen from north, east, down.
    /// let heading_east = Rotation::from_axis_angle([0.0, 0.0, 1.0], FRAC_PI_2)?;
    /// let change = AxesChange { world: "NED to ENU".parse()?, body: "FRD to FLU".parse()? };
    /// let in_ros = change.apply(&heading_east)?;
    /// // Forward (x) is east (x): no turn at all.
    /// assert!((in_ros.body_to_world(Vector3::x()) - Vector3::x()).amax() < 1e-15);
    /// assert!((in_ros.body_to_world(Vector3::z()) - Vector3::z()).amax() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn apply(&self, attitude: &Rotation) -> Result<Rotation, OneSidedReflection> {
        if self.world.hand() != self.body.hand() {
            return Err(OneSidedReflection);
        }
        // The two factors −1 of mappings that change the hand cancel.
        Ok(self.world.turn() * *attitude * self.body.turn().inverse())
    }
}
