//! Rotation vectors: composition, Jacobians, and the other vectors along the axis.
//!
//! Four vectors of three numbers describe a turn by θ about the unit axis u, and are told apart only
//! by a turn whose angle is known (specification, FX-19):
//!
//! | vector | length | a turn of 0.1 rad about z is | singular at |
//! |---|---|---|---|
//! | rotation vector | θ | (0, 0, 0.1) | its Jacobians, at 2π |
//! | half-angle vector η (Yoosefian 2021, eq. 3) | θ/2 | (0, 0, 0.05) | |
//! | Gibbs vector (Rodrigues parameters) | tan(θ/2) | (0, 0, 0.050042) | π |
//! | modified Rodrigues parameters | tan(θ/4) | (0, 0, 0.025005) | 2π |
//!
//! What the field guide calls Rodrigues is the rotation vector. None has convention-dependent
//! numbers; rotation vectors are coordinates of the Lie algebra so(3), not of the group, and do not
//! add.

use crate::rotation::precise::{self, Norm};
use crate::rotation::{NoRotation, Rotation};
use nalgebra::{Matrix3, Quaternion, Vector3};
use std::f64::consts::PI;

/// Below this angle the coefficients of the Jacobians are taken from their power series; above it
/// the closed forms lose at most three digits to cancellation (specification, NUM-01).
const SERIES_BELOW_RAD: f64 = 0.5;

/// Nearer to a whole turn than this, in radians, half of the digits of an inverse Jacobian depend on
/// the last digits of the vector (√u, with u = 2^-53), so there is none.
const WHOLE_TURN_RAD: f64 = 1e-8;

/// A vector along the axis whose length tells the angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AxisVector {
    /// Length θ, in radians.
    RotationVector(Vector3<f64>),
    /// Length θ/2, in radians: the logarithm of the quaternion itself.
    HalfAngle(Vector3<f64>),
    /// Length tan(θ/2).
    Gibbs(Vector3<f64>),
    /// Length tan(θ/4).
    ModifiedRodrigues(Vector3<f64>),
}

impl AxisVector {
    /// The four readings of the same three numbers.
    #[must_use]
    pub const fn readings(numbers: Vector3<f64>) -> [Self; 4] {
        [
            Self::RotationVector(numbers),
            Self::HalfAngle(numbers),
            Self::Gibbs(numbers),
            Self::ModifiedRodrigues(numbers),
        ]
    }

    /// The reading of three numbers that comes nearest to the turn that a program made of them, and
    /// how far away that turn is, in radians.
    ///
    /// (0, 0, 0.1) alone says nothing; that a program turns by 0.19934 rad for it says Gibbs
    /// (specification, FX-19). `None` for numbers that are not finite.
    ///
    /// ```
    /// use quatlas::{AxisVector, Rotation, nalgebra::Vector3};
    /// let numbers = Vector3::new(0.0, 0.0, 0.1);
    /// let turned = Rotation::from_axis_angle([0.0, 0.0, 1.0], 0.199_34)?;
    /// let (reading, _) = AxisVector::recognize(numbers, &turned).expect("finite");
    /// assert_eq!(reading, AxisVector::Gibbs(numbers));
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    #[must_use]
    pub fn recognize(numbers: Vector3<f64>, turned: &Rotation) -> Option<(Self, f64)> {
        Self::readings(numbers)
            .into_iter()
            .filter_map(|reading| Some((reading, reading.to_rotation().ok()?.angle_to_rad(turned))))
            .min_by(|(_, left), (_, right)| left.total_cmp(right))
    }

    /// The attitude that the vector describes.
    ///
    /// # Errors
    ///
    /// [`NoRotation`] for numbers that are not finite.
    ///
    /// ```
    /// use quatlas::{AxisVector, Rotation, nalgebra::Vector3};
    /// // One under the Gibbs vector's tangent of the half angle: a quarter turn.
    /// let quarter = AxisVector::Gibbs(Vector3::z()).to_rotation()?;
    /// assert_eq!(quarter.body_to_world(Vector3::x()), Vector3::y());
    /// let half = AxisVector::ModifiedRodrigues(Vector3::z()).to_rotation()?;
    /// assert_eq!(half.body_to_world(Vector3::x()), -Vector3::x());
    /// # Ok::<(), quatlas::NoRotation>(())
    /// ```
    pub fn to_rotation(self) -> Result<Rotation, NoRotation> {
        let of_parts = |scalar: f64, vector: Vector3<f64>| {
            let is_finite = vector.iter().all(|number| number.is_finite());
            is_finite
                .then(|| Rotation::from_canonical(&Quaternion::from_parts(scalar, vector)))
                .ok_or(NoRotation)
        };
        match self {
            Self::RotationVector(vector) => Rotation::from_rotation_vector_rad(vector.into()),
            Self::HalfAngle(vector) => half_angle_exponential(vector.into()),
            Self::Gibbs(vector) => of_parts(1.0, vector),
            Self::ModifiedRodrigues(vector) => {
                // [1 − |m|², 2m], squared by the half turn so that no |m| overflows.
                let quarter = of_parts(1.0, vector)?;
                Ok(quarter * quarter)
            }
        }
    }
}

/// The attitude `[cos|η|, sin|η| η/|η|]`: the exponential of the pure quaternion η, which is half
/// the rotation vector.
///
/// `exp_q` of Yoosefian 2021, eq. 3; the rotation vector of the result is `2η`. At η = 0, where the
/// equation divides 0 by 0, it is the identity.
///
/// # Errors
///
/// [`NoRotation`] for numbers that are not finite, or whose double is not.
///
/// ```
/// use quatlas::{half_angle_exponential, nalgebra::Vector3};
/// use std::f64::consts::FRAC_PI_4;
/// let quarter = half_angle_exponential([0.0, 0.0, FRAC_PI_4])?;
/// assert!((quarter.body_to_world(Vector3::x()) - Vector3::y()).amax() < 3e-16);
/// # Ok::<(), quatlas::NoRotation>(())
/// ```
pub fn half_angle_exponential(eta_rad: [f64; 3]) -> Result<Rotation, NoRotation> {
    let [x, y, z] = eta_rad;
    Rotation::from_rotation_vector_rad([2.0 * x, 2.0 * y, 2.0 * z])
}

impl Rotation {
    /// The Gibbs vector `tan(θ/2) u`; `None` at half a turn, where it is infinite.
    ///
    /// The vector part of the quaternion divided by its scalar (specification, FX-19).
    #[must_use]
    #[doc(alias("Rodrigues parameters", "Cayley"))]
    pub fn gibbs_vector(&self) -> Option<Vector3<f64>> {
        let q = self.canonical();
        let vector: Vector3<f64> = q.vector().into();
        let gibbs = vector.map(|number| number / q.w);
        gibbs
            .iter()
            .all(|number| number.is_finite())
            .then_some(gibbs)
    }

    /// The modified Rodrigues parameters `tan(θ/4) u`, of length 1 at most.
    #[must_use]
    #[doc(alias("MRP", "stereographic"))]
    pub fn modified_rodrigues_parameters(&self) -> Vector3<f64> {
        let q = self.canonical();
        let norm = Norm::of(q.coords.as_slice()).value();
        let denominator = norm + q.w.abs();
        self.shorter_vector_part()
            .map(|number| number / denominator)
    }
}

/// The rotation vector of two turns, each at most π long where it comes out:
/// `Exp(v) = Exp(first) Exp(second)`.
///
/// Through the quaternions (specification, FX-17): with the first the turn from A to B and the
/// second that from B to C on the axes of B, it is the turn from A to C. Vectors do not add:
/// `v = a + b + a×b/2 + …`.
///
/// # Errors
///
/// [`NoRotation`] for numbers that are not finite.
///
/// ```
/// use quatlas::compose_rotation_vectors;
/// use std::f64::consts::{FRAC_PI_2, TAU};
/// // Quarter turns about x and then the moved y: a third of a turn about (1, 1, 1).
/// let both = compose_rotation_vectors([FRAC_PI_2, 0.0, 0.0], [0.0, FRAC_PI_2, 0.0])?;
/// let third = TAU / 3.0 / 3.0_f64.sqrt();
/// assert!((both - quatlas::nalgebra::Vector3::new(third, third, third)).amax() < 1e-15);
/// # Ok::<(), quatlas::NoRotation>(())
/// ```
pub fn compose_rotation_vectors(
    first_rad: [f64; 3],
    second_rad: [f64; 3],
) -> Result<Vector3<f64>, NoRotation> {
    let first = Rotation::from_rotation_vector_rad(first_rad)?;
    let second = Rotation::from_rotation_vector_rad(second_rad)?;
    Ok((first * second).rotation_vector_rad())
}

/// The right Jacobian `J_r(v)` of the exponential: body rate from the rate of the vector,
/// `ω_B = J_r v̇`.
///
/// `I − (1−cos θ)/θ K + (1 − sin θ/θ) K²` with `K = [v/θ]×` (specification, FX-18);
/// `Exp(v + ε) ≈ Exp(v) Exp(J_r ε)`.
///
/// ```
/// use quatlas::{nalgebra::Vector3, right_jacobian};
/// use std::f64::consts::FRAC_PI_2;
/// // At a quarter turn about z: the mean of x seen from the body on its way, towards −y.
/// let seen = right_jacobian(&Vector3::new(0.0, 0.0, FRAC_PI_2)) * Vector3::x();
/// let mean = 1.0 / FRAC_PI_2;
/// assert!((seen - Vector3::new(mean, -mean, 0.0)).amax() < 2e-16);
/// ```
#[must_use]
pub fn right_jacobian(vector_rad: &Vector3<f64>) -> Matrix3<f64> {
    let angle = Norm::of(vector_rad.as_slice()).value().min(f64::MAX);
    let Some(axis) = precise::direction(vector_rad) else {
        return Matrix3::identity();
    };
    // On the unit axis, as θ² of a long vector would be larger than any double.
    let half_sine = libm::sin(angle / 2.0);
    let linear = 2.0 * half_sine * (half_sine / angle);
    in_powers(&axis, -linear, one_minus_sinc(angle))
}

/// The left Jacobian `J_l(v) = J_r(−v)`: world rate from the rate of the vector, `ω_W = J_l v̇`.
///
/// `Exp(v + ε) ≈ Exp(J_l ε) Exp(v)` (specification, FX-18).
#[must_use]
pub fn left_jacobian(vector_rad: &Vector3<f64>) -> Matrix3<f64> {
    right_jacobian(&-vector_rad)
}

/// The inverse of the right Jacobian: the rate of the vector from the body rate,
/// `v̇ = J_r⁻¹ ω_B`.
///
/// `I + θ/2 K + (1 − (θ/2) cot(θ/2)) K²` with `K = [v/θ]×` (specification, FX-18). `None` within 1e-8 of 2π and its
/// multiples, where the Jacobian has no inverse, and for a vector whose length is not finite.
#[must_use]
pub fn right_jacobian_inverse(vector_rad: &Vector3<f64>) -> Option<Matrix3<f64>> {
    let (axis, linear, quadratic) = powers_of_inverse(vector_rad)?;
    let inverse = in_powers(&axis, linear, quadratic);
    let is_finite = inverse.iter().all(|entry| entry.is_finite());
    is_finite.then_some(inverse)
}

/// `J_r⁻¹(v) ω_B`; `J_l⁻¹(v) ω_W` is that of `−v`. As [`right_jacobian_inverse`], without the matrix.
pub(crate) fn rotation_vector_rate(
    vector_rad: &Vector3<f64>,
    body_rate: &Vector3<f64>,
) -> Option<Vector3<f64>> {
    let (axis, linear, quadratic) = powers_of_inverse(vector_rad)?;
    let across = axis.cross(body_rate);
    Some(body_rate + across * linear + axis.cross(&across) * quadratic)
}

/// The unit axis, and a and b of `J_r⁻¹ = I + a K + b K²`; an axis of zeros for the zero vector.
fn powers_of_inverse(vector_rad: &Vector3<f64>) -> Option<(Vector3<f64>, f64, f64)> {
    let angle = Norm::of(vector_rad.as_slice()).value();
    if angle > PI && libm::sin(angle / 2.0).abs() <= WHOLE_TURN_RAD / 2.0 {
        return None;
    }
    // Rounded twice, which only the last digits of a correction to I can tell.
    let axis = vector_rad.map(|number| number / angle.max(f64::MIN_POSITIVE));
    let quadratic = one_minus_half_cotangent(angle);
    quadratic
        .is_finite()
        .then_some((axis, angle / 2.0, quadratic))
}

/// The inverse of the left Jacobian, `J_l⁻¹(v) = J_r⁻¹(−v)`: the rate of the vector from the world
/// rate, `v̇ = J_l⁻¹ ω_W`. `None` where [`right_jacobian_inverse`] is.
#[must_use]
pub fn left_jacobian_inverse(vector_rad: &Vector3<f64>) -> Option<Matrix3<f64>> {
    right_jacobian_inverse(&-vector_rad)
}

/// `I + a K + b K²` with `K = [u]×`.
fn in_powers(axis: &Vector3<f64>, linear: f64, quadratic: f64) -> Matrix3<f64> {
    let k = axis.cross_matrix();
    Matrix3::identity() + k * linear + k * k * quadratic
}

/// `1 − sin(θ)/θ`
fn one_minus_sinc(angle: f64) -> f64 {
    if angle >= SERIES_BELOW_RAD {
        return 1.0 - libm::sin(angle) / angle;
    }
    // θ² (1/3! − θ²/5! + θ⁴/7! − …); θ¹²/15! is below 2^-53 of the first.
    let coefficients = [
        1.0 / 6.0,
        -1.0 / 120.0,
        1.0 / 5_040.0,
        -1.0 / 362_880.0,
        1.0 / 39_916_800.0,
        -1.0 / 6_227_020_800.0,
    ];
    let square = angle * angle;
    square * polynomial(&coefficients, square)
}

/// `1 − (θ/2) cot(θ/2)`
fn one_minus_half_cotangent(angle: f64) -> f64 {
    if angle >= SERIES_BELOW_RAD {
        let half = angle / 2.0;
        return 1.0 - half / libm::tan(half);
    }
    // By the Bernoulli numbers, θ² Σ |B₂ₙ|/(2n)! θ²ⁿ⁻².
    let coefficients = [
        1.0 / 12.0,
        1.0 / 720.0,
        1.0 / 30_240.0,
        1.0 / 1_209_600.0,
        1.0 / 47_900_160.0,
        691.0 / 1_307_674_368_000.0,
        1.0 / 74_724_249_600.0,
    ];
    let square = angle * angle;
    square * polynomial(&coefficients, square)
}

fn polynomial(coefficients: &[f64], x: f64) -> f64 {
    let horner = |sum: f64, coefficient: &f64| sum * x + coefficient;
    coefficients.iter().rev().fold(0.0, horner)
}
