//! Attitudes from vectors whose coordinates are known in the body and in the world.

use crate::rotation::nearest;
use crate::rotation::precise::{self, Norm};
use crate::rotation::weights::{self, UnusableWeights};
use crate::rotation::{NoRotation, Rotation};
use nalgebra::{Matrix3, Quaternion, Vector3};
use std::fmt;
use twofloat::TwoFloat;

/// The attitude that fits many vectors best, and how well.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alignment {
    /// The attitude.
    pub rotation: Rotation,
    /// The root of the sum of weight times squared distance, `√(Σ w |world − R_WB body|²)`: nothing but
    /// rounding where all fit, and infinite where a double cannot hold it.
    #[doc(alias("root sum squared distance", "residual"))]
    pub rssd: f64,
    /// How a small turn of the attitude, on the axes of the world, follows from errors of the vectors: times
    /// the harmonic mean of their variances it is the covariance of that turn, in rad², where the weights are
    /// as the inverse of the variances.
    #[doc(alias("covariance"))]
    pub sensitivity: Matrix3<f64>,
}

/// Why vectors give no attitude.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoAlignment {
    /// There is no pair of vectors.
    Empty,
    /// There is not one vector in the world for each in the body.
    CountsDiffer,
    /// A coordinate is not finite.
    NotFinite,
    /// The weights cannot be used.
    Weights(UnusableWeights),
    /// Other attitudes fit as well, or nearly: as where all vectors lie along one line, or where the vectors in
    /// the world are a mirror image of three of one length that are perpendicular to each other.
    Undetermined,
}

impl fmt::Display for NoAlignment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Empty => "an attitude needs at least two pairs of vectors",
            Self::CountsDiffer => "the number of vectors in the body is another than in the world",
            Self::NotFinite => "a coordinate of a vector is not finite",
            Self::Weights(unusable) => unusable.message(),
            Self::Undetermined => {
                "the vectors do not determine an attitude: another one fits as well"
            }
        })
    }
}

impl std::error::Error for NoAlignment {}

impl Rotation {
    /// The shortest turn for which the direction with these coordinates in the body has those in the world.
    ///
    /// [`Rotation::body_to_world`] of the first is parallel to the second; both may have any length. Of the
    /// attitudes that do so, which differ by a turn about the direction, it is the one with the smallest
    /// angle, and its axis is perpendicular to both. The quaternion is `[|b||w| + b·w, b×w]`, and beyond a
    /// right angle the same without a difference, `[(b×w)·(b×w), (|b||w| − b·w) b×w]`, with 106 bits: each
    /// component is within one roundoff, for directions that are nearly the same or nearly opposite too.
    ///
    /// Between opposite directions it is half a turn about `body × e`, with e that of the axes x, y and z
    /// along which `body` has the smallest coordinate, in magnitude, and the first of several: for x about z,
    /// for y about −z, for z about y.
    ///
    /// # Errors
    ///
    /// [`NoRotation`] for a vector of length 0 and for numbers that are not finite.
    ///
    /// ```
    /// use quatlas::{NoRotation, Rotation, nalgebra::Vector3};
    /// // The body's z has to be seen along the world's −3x: a quarter turn about −y.
    /// let tipped = Rotation::from_two_vectors([0.0, 0.0, 2.0], [-3.0, 0.0, 0.0])?;
    /// assert!((tipped.body_to_world(Vector3::z()) + Vector3::x()).amax() < 5e-16);
    /// assert!((tipped.body_to_world(Vector3::x()) - Vector3::z()).amax() < 5e-16);
    /// assert_eq!(tipped.body_to_world(Vector3::y()), Vector3::y());
    /// assert_eq!(Rotation::from_two_vectors([0.0; 3], [-3.0, 0.0, 0.0]), Err(NoRotation));
    /// # Ok::<(), NoRotation>(())
    /// ```
    #[doc(alias("setFromUnitVectors", "rotationTo", "rotation_between", "shortest arc"))]
    pub fn from_two_vectors(body: [f64; 3], world: [f64; 3]) -> Result<Self, NoRotation> {
        if !(all_finite(&[body]) && all_finite(&[world])) {
            return Err(NoRotation);
        }
        let (body_norm, world_norm) = (Norm::of(&body), Norm::of(&world));
        if body_norm.is_zero() || world_norm.is_zero() {
            return Err(NoRotation);
        }
        let body = scaled(body, precise::working_scale(&body));
        let world = scaled(world, precise::working_scale(&world));
        let times = |row: usize, column: usize| TwoFloat::new_mul(body[row], world[column]);
        let inner = times(0, 0) + times(1, 1) + times(2, 2);
        let lengths = body_norm.fraction * world_norm.fraction;
        let cross = Vector3::new(
            times(1, 2) - times(2, 1),
            times(2, 0) - times(0, 2),
            times(0, 1) - times(1, 0),
        );
        if inner.hi() >= 0.0 {
            let [x, y, z] = cross.into();
            return Ok(Self::from_precise([lengths + inner, x, y, z]));
        }
        let exponent = precise::binary_exponent(cross.map(|number| number.hi()).as_slice());
        // At a size whose squares are far from underflow.
        let unit_size = |number| precise::precisely_times_power_of_two(number, -exponent);
        let cross = cross.map(unit_size);
        let square = cross.dot(&cross);
        if square.hi() == 0.0 {
            let least = Vector3::ith(body.iamin(), 1.0);
            return Ok(Self::from_canonical(&Quaternion::from_imag(
                body.cross(&least),
            )));
        }
        let [x, y, z] = cross.map(|number| number * (lengths - inner)).into();
        let scalar = precise::precisely_times_power_of_two(square, exponent);
        Ok(Self::from_precise([scalar, x, y, z]))
    }

    /// The attitude that fits many vectors best, of each of which the coordinates in the body and in the
    /// world are known: Wahba's problem.
    ///
    /// The sum of `weight |world − R_WB body|²` is the least, which makes it the rotation nearest to
    /// `Σ weight world bodyᵀ` (Wahba 1965, Davenport's q-method). That sum has 106 bits, so that all digits
    /// hold, and two directions are enough that are a few millionths of a radian apart. A longer vector counts
    /// for more, in proportion to the product of both lengths; without weights each weight is 1. `SciPy`'s
    /// `align_vectors(a, b, weights)` is this with `a` in the world and `b` in the body; it takes an infinite
    /// weight and a single pair too, for which there is [`Rotation::from_two_vectors`].
    ///
    /// # Errors
    ///
    /// [`NoAlignment`] for lists that are empty or not equally long, coordinates that are not finite, weights
    /// that cannot be used, and vectors that do not determine an attitude.
    ///
    /// ```
    /// use quatlas::{NoAlignment, Rotation, nalgebra::Matrix3};
    /// // The example of SciPy's documentation.
    /// let world = [[0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [0.0, 1.0, 1.0]];
    /// let body = [[1.0, 0.0, 0.0], [1.0, 1.1, 0.0], [1.0, 0.9, 0.0]];
    /// let fit = Rotation::align_vectors(&body, &world, None)?;
    /// assert!((fit.rotation.body_to_world_matrix() - Matrix3::new(
    ///     0.0, 0.0, 1.0,
    ///     1.0, 0.0, 0.0,
    ///     0.0, 1.0, 0.0,
    /// )).amax() < 1e-15);
    /// assert!((fit.rssd - 0.02_f64.sqrt()).abs() < 1e-15);
    /// assert!((fit.sensitivity - Matrix3::new(
    ///     0.2, 0.0, 0.0,
    ///     0.0, 1.5, 1.0,
    ///     0.0, 1.0, 1.0,
    /// )).amax() < 1e-14);
    /// // The first pair alone leaves all turns about it.
    /// let one = Rotation::align_vectors(&body[..1], &world[..1], None);
    /// assert_eq!(one, Err(NoAlignment::Undetermined));
    /// # Ok::<(), NoAlignment>(())
    /// ```
    #[doc(alias("Wahba", "Kabsch", "Procrustes", "TRIAD", "QUEST", "SVD method"))]
    pub fn align_vectors(
        body: &[[f64; 3]],
        world: &[[f64; 3]],
        weights: Option<&[f64]>,
    ) -> Result<Alignment, NoAlignment> {
        if body.len() != world.len() {
            return Err(NoAlignment::CountsDiffer);
        }
        if body.is_empty() {
            return Err(NoAlignment::Empty);
        }
        if !(all_finite(body) && all_finite(world)) {
            return Err(NoAlignment::NotFinite);
        }
        let ones = vec![1.0; body.len()];
        let weights = weights.unwrap_or(&ones);
        let parts = weights::at_unit_size(weights, body.len()).map_err(NoAlignment::Weights)?;
        let profile = Profile::of(body, world, &parts);
        let rotation =
            nearest::nearest_to_precise(&profile.matrix).ok_or(NoAlignment::Undetermined)?;
        Ok(Alignment {
            rotation,
            rssd: root_sum_squared_distance(&rotation, body, world, weights),
            sensitivity: profile.sensitivity(&rotation, &parts),
        })
    }
}

/// The attitude profile matrix of pairs, `Σ weight world bodyᵀ`, as `matrix * 2^exponent` with a largest
/// entry between 1/2 and 1.
struct Profile {
    matrix: Matrix3<TwoFloat>,
    exponent: i32,
}

impl Profile {
    fn of(body: &[[f64; 3]], world: &[[f64; 3]], weights: &[f64]) -> Self {
        let [body_exponent, world_exponent] =
            [body, world].map(|vectors| precise::binary_exponent(vectors.as_flattened()));
        let mut sum = Matrix3::from_element(TwoFloat::from(0.0));
        for ((&body, &world), &weight) in body.iter().zip(world).zip(weights) {
            let (body, world) = (scaled(body, -body_exponent), scaled(world, -world_exponent));
            let entry = |row, column| TwoFloat::new_mul(world[row], body[column]) * weight;
            sum += Matrix3::from_fn(entry);
        }
        let exponent = precise::binary_exponent(sum.map(|entry| entry.hi()).as_slice());
        let unit_size = |entry| precise::precisely_times_power_of_two(entry, -exponent);
        Self {
            matrix: sum.map(unit_size),
            exponent: exponent + body_exponent + world_exponent,
        }
    }

    /// `mean weight (tr(S) I − S)⁻¹` with `S = B Rᵀ`, symmetric for the nearest rotation R.
    ///
    /// `SciPy` writes `(κ I + B Bᵀ)/ζ` with the singular values of B, which is the same; here no digit is lost
    /// where two of them are small.
    fn sensitivity(&self, rotation: &Rotation, weights: &[f64]) -> Matrix3<f64> {
        let transposed = rotation.precise_matrix().transpose();
        let column = |at| precise::product(&self.matrix, transposed.column(at).into());
        let s = Matrix3::from_columns(&[column(0), column(1), column(2)]);
        let off = |row, column| (s[(row, column)] + s[(column, row)]) * -0.5;
        let (xx, yy, zz) = (s[(0, 0)], s[(1, 1)], s[(2, 2)]);
        let x = Vector3::new(yy + zz, off(0, 1), off(0, 2));
        let y = Vector3::new(off(0, 1), zz + xx, off(1, 2));
        let z = Vector3::new(off(0, 2), off(1, 2), xx + yy);
        let adjugate = [y.cross(&z), z.cross(&x), x.cross(&y)];
        let determinant = x.dot(&adjugate[0]);
        let mut mean_weight = 0.0;
        for weight in weights {
            mean_weight += weight;
        }
        mean_weight /= weights.len() as f64;
        Matrix3::from_columns(&adjugate).map(|entry| {
            let inverse = precise::quotient(entry, determinant).hi();
            precise::times_power_of_two(inverse * mean_weight, -self.exponent)
        })
    }
}

fn root_sum_squared_distance(
    rotation: &Rotation,
    body: &[[f64; 3]],
    world: &[[f64; 3]],
    weights: &[f64],
) -> f64 {
    // With 106 bits: the sum is least here, so the rounding of the rotation does not change its digits.
    let matrix = rotation.precise_matrix();
    // All at one size, at which a turned vector is far from overflow.
    let exponent = precise::binary_exponent(body.as_flattened())
        .max(precise::binary_exponent(world.as_flattened()));
    let mut distances = Vec::new();
    for ((&body, &world), weight) in body.iter().zip(world).zip(weights) {
        let turned = precise::product(&matrix, scaled(body, -exponent).map(TwoFloat::from));
        let difference = scaled(world, -exponent).map(TwoFloat::from) - turned;
        let distance = difference.map(|number| number.hi() * weight.sqrt());
        distances.extend_from_slice(distance.as_slice());
    }
    precise::times_power_of_two(Norm::of(&distances).value(), exponent)
}

/// The vector times `2^exponent`.
fn scaled(vector: [f64; 3], exponent: i32) -> Vector3<f64> {
    vector
        .map(|number| precise::times_power_of_two(number, exponent))
        .into()
}

fn all_finite(vectors: &[[f64; 3]]) -> bool {
    let mut numbers = vectors.as_flattened().iter();
    numbers.all(|number| number.is_finite())
}
