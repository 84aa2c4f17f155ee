//! Rotation to 3×3 matrix.
//!
//! A matrix here multiplies a column of coordinates from the left; `m[(row,
//! column)]`. Its columns are the axes of the frame it takes from, in
//! coordinates of the frame it leads to.

use crate::convention::Direction;
use crate::rotation::Rotation;
use crate::rotation::precise;
use nalgebra::{Matrix3, Vector3};
use twofloat::TwoFloat;

impl Rotation {
    /// The matrix `R_WB`, which is `R(q)` of the canonical quaternion: body coordinates to world
    /// coordinates.
    ///
    /// `[(w² − v·v) I + 2 w [v]× + 2 v vᵀ] / |q|²` with `v = (x, y, z)` (specification, section
    /// 1.4, any norm), each entry rounded once. `nalgebra` leaves out the division, and so gives
    /// 1.0000000000000002 for a quarter turn; with it every entry of that matrix is exact.
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
        self.precise_matrix().map(|entry| entry.hi())
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

    /// The coordinates in the world of a vector given in body coordinates: `R(q) v`.
    ///
    /// Within 1.2 roundoffs of the vector's length. Infinite where a double cannot hold it.
    #[must_use]
    pub fn body_to_world(&self, vector: Vector3<f64>) -> Vector3<f64> {
        self.rotate(vector, Direction::BodyToWorld)
    }

    /// The coordinates in the body of a vector given in world coordinates: `C(q) v`.
    ///
    /// Within 1.2 roundoffs of the vector's length. Infinite where a double cannot hold it.
    #[must_use]
    pub fn world_to_body(&self, vector: Vector3<f64>) -> Vector3<f64> {
        self.rotate(vector, Direction::WorldToBody)
    }

    /// The vector's coordinates after the passive matrix with this direction.
    pub(crate) fn rotate(&self, vector: Vector3<f64>, direction: Direction) -> Vector3<f64> {
        let exponent = precise::binary_exponent(vector.as_slice());
        let scaled = |number| TwoFloat::from(precise::times_power_of_two(number, -exponent));
        let matrix = match direction {
            Direction::BodyToWorld => self.precise_matrix(),
            Direction::WorldToBody => self.precise_matrix().transpose(),
        };
        precise::product(&matrix, vector.map(scaled))
            .map(|number| precise::times_power_of_two(number.hi(), exponent))
    }

    /// The same as [`Rotation::rotate`]; `None` where a double cannot hold it.
    pub(crate) fn rotate_within_range(
        &self,
        vector: Vector3<f64>,
        direction: Direction,
    ) -> Option<Vector3<f64>> {
        let turned = self.rotate(vector, direction);
        let is_finite = turned.iter().all(|number| number.is_finite());
        is_finite.then_some(turned)
    }

    /// `R_WB` with 106 bits.
    pub(crate) fn precise_matrix(&self) -> Matrix3<TwoFloat> {
        let [w, x, y, z] = precise::split(self.canonical());
        let twice = |number: TwoFloat| number + number;
        let (ww, xx, yy, zz) = (w.times(w), x.times(x), y.times(y), z.times(z));
        let (xy, xz, yz) = (x.times(y), x.times(z), y.times(z));
        let (wx, wy, wz) = (w.times(x), w.times(y), w.times(z));
        let norm_squared = (ww + xx) + (yy + zz);
        Matrix3::new(
            (ww + xx) - (yy + zz),
            twice(xy - wz),
            twice(xz + wy),
            twice(xy + wz),
            (ww + yy) - (xx + zz),
            twice(yz - wx),
            twice(xz - wy),
            twice(yz + wx),
            (ww + zz) - (xx + yy),
        )
        .map(|numerator| precise::quotient(numerator, norm_squared))
    }
}
