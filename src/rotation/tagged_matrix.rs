//! Rotation matrices as they are written, with the function and direction that say what they mean.

use crate::convention::Convention;
use crate::convention::matrix::{CosineMatrix, MatrixConvention};
use crate::rotation::Rotation;
use crate::rotation::nearest::{NearestRotation, NoNearestRotation};
use crate::rotation::quaternion::TaggedQuaternion;
use nalgebra::{Matrix3, Quaternion};

impl CosineMatrix {
    /// The matrix of these numbers by this formula; `None` for the zero quaternion and for numbers
    /// that are not finite.
    #[must_use]
    pub fn of(self, quaternion: &Quaternion<f64>) -> Option<Matrix3<f64>> {
        let numbers = TaggedQuaternion {
            components: *quaternion,
            convention: Convention::HAMILTON,
        };
        let matrix = Rotation::from_tagged(&numbers).ok()?.body_to_world_matrix();
        Some(match self {
            Self::Hamilton => matrix,
            Self::Shuster => matrix.transpose(),
        })
    }
}

/// Nine numbers with the convention that says what they mean.
///
/// They need not be a rotation: see [`TaggedMatrix::is_rotation`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaggedMatrix {
    /// The entries; they multiply a column of coordinates from the left.
    pub entries: Matrix3<f64>,
    /// What they mean.
    pub convention: MatrixConvention,
}

/// How far entries of `MᵀM` may be from those of I, and the determinant from 1, in a matrix that is
/// taken for a rotation: entries that were rounded to single precision (2^-24 each) stay within.
pub const ROTATION_TOLERANCE: f64 = 1e-6;

impl TaggedMatrix {
    /// The matrix with these rows.
    #[must_use]
    pub fn from_rows(rows: [[f64; 3]; 3], convention: MatrixConvention) -> Self {
        Self {
            entries: Matrix3::from(rows).transpose(),
            convention,
        }
    }

    /// The matrix of the same attitude in another convention: transposed if one of the two is
    /// `R_WB` and the other `R_BW`.
    #[must_use]
    pub fn to_convention(&self, convention: MatrixConvention) -> Self {
        let is_same = self.convention.operator() == convention.operator();
        Self {
            entries: if is_same {
                self.entries
            } else {
                self.entries.transpose()
            },
            convention,
        }
    }

    /// The largest magnitude among the entries of `MᵀM − I`: 0 for orthogonal columns of length 1.
    #[must_use]
    pub fn orthogonality_error(&self) -> f64 {
        (self.entries.transpose() * self.entries - Matrix3::identity()).amax()
    }

    /// Whether it is a rotation: `max |MᵀM − I|` and `|det M − 1|` are at most
    /// [`ROTATION_TOLERANCE`].
    ///
    /// The test of the ME 495 lecture leaves out the absolute values, and so takes the zero matrix,
    /// half a rotation and a reflection for rotations (specification, erratum E19).
    ///
    /// ```
    /// use quatlas::{MatrixConvention, TaggedMatrix};
    /// let diagonal = |x: f64, y: f64, z: f64| TaggedMatrix::from_rows(
    ///     [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]],
    ///     MatrixConvention::BODY_TO_WORLD,
    /// );
    /// assert!(diagonal(-1.0, -1.0, 1.0).is_rotation());
    /// assert!(!diagonal(1.0, 1.0, -1.0).is_rotation());
    /// assert!(!diagonal(0.5, 0.5, 0.5).is_rotation());
    /// assert!(!diagonal(0.0, 0.0, 0.0).is_rotation());
    /// ```
    #[must_use]
    #[doc(alias("SO(3)", "is_orthogonal"))]
    pub fn is_rotation(&self) -> bool {
        self.orthogonality_error() <= ROTATION_TOLERANCE
            && (self.entries.determinant() - 1.0).abs() <= ROTATION_TOLERANCE
    }
}

impl Rotation {
    /// The matrix of the attitude in a convention.
    ///
    /// ```
    /// use quatlas::{MatrixConvention, Rotation, nalgebra::Vector3};
    /// let yawed = Rotation::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2)?;
    /// // A body yawed by a quarter turn has its x axis along the world's y axis.
    /// let matrix = yawed.to_tagged_matrix(MatrixConvention::BODY_TO_WORLD).entries;
    /// assert!((matrix * Vector3::x() - Vector3::y()).amax() < 3e-16);
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[must_use]
    pub fn to_tagged_matrix(&self, convention: MatrixConvention) -> TaggedMatrix {
        TaggedMatrix {
            entries: self.matrix(convention.operator()),
            convention,
        }
    }

    /// The rotation that is nearest to a matrix, and how far away the matrix is.
    ///
    /// Nearest in the sum of squared differences: the polar factor of the matrix (specification,
    /// NUM-03). Within one roundoff of it for every matrix that has one, also for half turns, where
    /// the formulas by the trace divide 0 by 0, and for scaled ones.
    ///
    /// # Errors
    ///
    /// [`NoNearestRotation`] with the reason: a reflection, a matrix without inverse, an entry that
    /// is not finite.
    ///
    /// ```
    /// use quatlas::{MatrixConvention, Rotation, TaggedMatrix, nalgebra::Vector3};
    /// // A quarter turn about x, body to world, with two decimals of noise and twice as large.
    /// let noisy = TaggedMatrix::from_rows(
    ///     [[2.0, 0.02, 0.0], [0.0, 0.0, -2.0], [0.02, 2.0, 0.0]],
    ///     MatrixConvention::BODY_TO_WORLD,
    /// );
    /// let nearest = Rotation::nearest_to_matrix(&noisy)?;
    /// let turned = nearest.rotation.body_to_world(Vector3::y());
    /// assert!((turned - Vector3::z()).amax() < 0.01);
    /// # Ok::<(), quatlas::NoNearestRotation>(())
    /// ```
    #[doc(alias("polar decomposition", "orthogonalize", "SVD", "from_matrix"))]
    pub fn nearest_to_matrix(matrix: &TaggedMatrix) -> Result<NearestRotation, NoNearestRotation> {
        let body_to_world = matrix.to_convention(MatrixConvention::BODY_TO_WORLD);
        NearestRotation::of_body_to_world(&body_to_world.entries)
    }
}
