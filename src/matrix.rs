//! Rotation to 3×3 matrix.
//!
//! A matrix here multiplies a column of coordinates from the left; `m[(row,
//! column)]`. Its columns are the axes of the frame it takes from, in
//! coordinates of the frame it leads to.

use crate::convention::Direction;
use crate::rotation::Rotation;
use crate::scaling;
use nalgebra::{Matrix3, Vector3};

impl Rotation {
    /// The matrix `R_WB`, which is `R(q)` of the canonical quaternion: body coordinates to world
    /// coordinates.
    ///
    /// `[(w² − v·v) I + 2 w [v]× + 2 v vᵀ] / |q|²` with `v = (x, y, z)` (specification, section
    /// 1.4, any norm). `nalgebra` leaves out the division, and so gives 1.0000000000000002 for a
    /// quarter turn; with it every entry of that matrix is exact.
    ///
    /// ```
    /// use quatlas::{Convention, Rotation, TaggedQuaternion, nalgebra::Matrix3};
    /// let half = 0.5_f64.sqrt();
    /// let q = TaggedQuaternion::new(half, half, 0.0, 0.0, Convention::HAMILTON);
    /// // A quarter turn about x leads y to z.
    /// assert_eq!(Rotation::from_tagged(&q)?.body_to_world_matrix(), Matrix3::new(
    ///     1.0, 0.0,  0.0,
    ///     0.0, 0.0, -1.0,
    ///     0.0, 1.0,  0.0,
    /// ));
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[must_use]
    #[doc(alias("R(q)", "direction cosine matrix", "DCM"))]
    pub fn body_to_world_matrix(&self) -> Matrix3<f64> {
        let q = self.canonical();
        let (w, v) = (q.w, q.vector());
        let (ww, xx, yy, zz) = (w * w, v.x * v.x, v.y * v.y, v.z * v.z);
        let twice = |a: f64, b: f64| 2.0 * (a + b);
        Matrix3::new(
            (ww + xx) - (yy + zz),
            twice(v.x * v.y, -w * v.z),
            twice(v.x * v.z, w * v.y),
            twice(v.x * v.y, w * v.z),
            (ww + yy) - (xx + zz),
            twice(v.y * v.z, -w * v.x),
            twice(v.x * v.z, -w * v.y),
            twice(v.y * v.z, w * v.x),
            (ww + zz) - (xx + yy),
        ) / (ww + xx + yy + zz)
    }

    /// The matrix `R_BW`, which is `C(q)` of the canonical quaternion: world coordinates to body
    /// coordinates. The transpose of [`Rotation::body_to_world_matrix`].
    #[must_use]
    #[doc(alias("C(q)", "attitude matrix"))]
    pub fn world_to_body_matrix(&self) -> Matrix3<f64> {
        self.body_to_world_matrix().transpose()
    }

    /// The passive matrix with this direction.
    #[must_use]
    pub fn matrix(&self, direction: Direction) -> Matrix3<f64> {
        match direction {
            Direction::BodyToWorld => self.body_to_world_matrix(),
            Direction::WorldToBody => self.world_to_body_matrix(),
        }
    }
}

/// The matrix times the vector; `None` where a double cannot hold it.
///
/// Computed on a scaled copy, so that only the result itself can be too large.
pub(crate) fn times_within_range(
    matrix: &Matrix3<f64>,
    vector: Vector3<f64>,
) -> Option<Vector3<f64>> {
    let exponent = scaling::binary_exponent(vector.as_slice());
    let scale = |exponent| move |number| scaling::times_power_of_two(number, exponent);
    let turned = (matrix * vector.map(scale(-exponent))).map(scale(exponent));
    turned
        .iter()
        .all(|number| number.is_finite())
        .then_some(turned)
}
