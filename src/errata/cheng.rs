//! Witnesses for Cheng 2018. The printed formulas are transcribed to the letter, and stand nowhere
//! else.

use crate::convention::matrix::{CosineMatrix, MatrixConvention};
use crate::errata::witness::{
    EXAMPLE, EXAMPLE_TEXT, I, J, K, Sides, Witness, hamilton, known, turn,
};
use crate::rotation::Rotation;
use crate::rotation::nearest::NearestRotation;
use crate::rotation::quaternion::{hamilton_product, jpl_product};
use crate::rotation::tagged_matrix::TaggedMatrix;
use nalgebra::{Matrix3, Quaternion, Vector3};
use std::f64::consts::TAU;

/// E1: the two equalities of the chain.
pub(crate) fn product_of_j_and_i() -> Witness {
    let (ji, ij) = (jpl_product(&J, &I), jpl_product(&I, &J));
    let chain = |middle: &Quaternion<f64>| {
        Sides::new()
            .quaternion(&ji, &-middle)
            .quaternion(&-middle, &K)
    };
    Witness::new("the JPL products of i and j", chain(&ji), chain(&ij))
}

/// E2: `q ∘ q*` is the number |q|².
pub(crate) fn conjugate() -> Witness {
    let Quaternion { coords } = EXAMPLE;
    let statement = |conjugate: Quaternion<f64>| {
        Sides::new().quaternion(
            &hamilton_product(&EXAMPLE, &conjugate),
            &Quaternion::from_real(coords.norm_squared()),
        )
    };
    let printed = Quaternion::new(coords.w, coords.x, coords.y, coords.z);
    let corrected = Quaternion::new(coords.w, -coords.x, -coords.y, -coords.z);
    Witness::new(EXAMPLE_TEXT, statement(printed), statement(corrected))
}

/// E3: the quaternion after one more turn, and after two.
pub(crate) fn period() -> Witness {
    let (axis, angle) = ([2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0], 1.2);
    let after = |turns: f64| hamilton(&turn(axis, angle + turns * TAU));
    let q = after(0.0);
    Witness::new(
        "u = (2, 3, 6)/7, φ = 1.2, k = 1 and k = 2",
        Sides::new()
            .quaternion(&after(1.0), &q)
            .quaternion(&after(2.0), &q),
        Sides::new()
            .quaternion(&after(1.0), &-q)
            .quaternion(&after(2.0), &q),
    )
}

/// `diagonal I + 2 v vᵀ + 2 w [v]×`; for C(q) the last term is subtracted, so w is negated.
fn vector_form(diagonal: f64, w: f64, v: &Vector3<f64>) -> Matrix3<f64> {
    Matrix3::identity() * diagonal + v * v.transpose() * 2.0 + v.cross_matrix() * (2.0 * w)
}

/// E4 and E25, E5 and E26: the vector form against the matrix of the double product.
pub(crate) fn cosine_matrix(formula: CosineMatrix) -> Witness {
    let (w, v) = (EXAMPLE.w, Vector3::from(EXAMPLE.vector()));
    let sign = match formula {
        CosineMatrix::Hamilton => 1.0,
        CosineMatrix::Shuster => -1.0,
    };
    let statement = |diagonal| {
        let matrix = formula.of(&EXAMPLE).unwrap_or_default();
        Sides::new().matrix(&vector_form(diagonal, sign * w, &v), &matrix)
    };
    Witness::new(
        EXAMPLE_TEXT,
        statement(w * w - 1.0),
        statement(2.0 * w * w - 1.0),
    )
}

/// The quaternions `q_b^a` between the world w, the frame i and its estimate î.
struct ErrorFrames {
    w_to_i: Quaternion<f64>,
    w_to_estimate: Quaternion<f64>,
    i_to_estimate: Quaternion<f64>,
    estimate_to_i: Quaternion<f64>,
}

impl ErrorFrames {
    const TEXT: &'static str = "w and î turned by (0.2, −0.5, 0.8) and (−0.3, 0.4, 1.1), i from î by \
         (0.3, −0.2, 0.25)";

    fn example() -> Self {
        let axes = |vector| known(Rotation::from_rotation_vector_rad(vector));
        let world = axes([0.2, -0.5, 0.8]);
        let estimate = axes([-0.3, 0.4, 1.1]);
        let i = estimate * axes([0.3, -0.2, 0.25]);
        let [world, estimate, i] = [world, estimate, i].map(|axes| axes.body_to_world_matrix());
        Self {
            w_to_i: carrying(&world, &i),
            w_to_estimate: carrying(&world, &estimate),
            i_to_estimate: carrying(&i, &estimate),
            estimate_to_i: carrying(&estimate, &i),
        }
    }
}

/// `q_b^a` of eq. 2.20: the columns of `R(q_b^a)` are the axes of a in coordinates of b. The scalar
/// part is not negative.
fn carrying(b: &Matrix3<f64>, a: &Matrix3<f64>) -> Quaternion<f64> {
    let matrix = TaggedMatrix {
        entries: b.transpose() * a,
        convention: MatrixConvention::BODY_TO_WORLD,
    };
    let nearest = Rotation::nearest_to_matrix(&matrix);
    let q = hamilton(&known(
        nearest.map(|NearestRotation { rotation, .. }| rotation),
    ));
    if q.w < 0.0 { -q } else { q }
}

/// E6: the chain of matrices and that of quaternions.
pub(crate) fn jpl_error_chain() -> Witness {
    let frames = ErrorFrames::example();
    let c = |q| CosineMatrix::Shuster.of(q).unwrap_or_default();
    let statement = |error| {
        Sides::new()
            .matrix(&c(&frames.w_to_i), &(c(error) * c(&frames.w_to_estimate)))
            .quaternion(&frames.w_to_i, &jpl_product(error, &frames.w_to_estimate))
    };
    Witness::new(
        ErrorFrames::TEXT,
        statement(&frames.i_to_estimate),
        statement(&frames.estimate_to_i),
    )
}

/// E7: the same with Hamilton's matrices and product.
pub(crate) fn hamilton_error_chain() -> Witness {
    let frames = ErrorFrames::example();
    let r = |q| CosineMatrix::Hamilton.of(q).unwrap_or_default();
    let statement = |error| {
        let product = hamilton_product(&frames.w_to_estimate, error);
        Sides::new()
            .matrix(&r(&frames.w_to_i), &(r(&frames.w_to_estimate) * r(error)))
            .quaternion(&frames.w_to_i, &product)
    };
    Witness::new(
        ErrorFrames::TEXT,
        statement(&frames.i_to_estimate),
        statement(&frames.estimate_to_i),
    )
}

/// E8: the error quaternion of eq. 2.28, `q̂* ⊙ q`.
pub(crate) fn error_quaternion() -> Witness {
    let frames = ErrorFrames::example();
    let error = hamilton_product(&frames.w_to_estimate.conjugate(), &frames.w_to_i);
    Witness::new(
        ErrorFrames::TEXT,
        Sides::new().quaternion(&error, &frames.i_to_estimate),
        Sides::new().quaternion(&error, &frames.estimate_to_i),
    )
}

/// The listing of appendix B, of which three lines are open: the temporaries that R(1,2), R(2,0) and
/// R(2,1) take from `[twx, twy, twz]`.
fn listing(q: &Quaternion<f64>, open: impl Fn([f64; 3]) -> [f64; 3]) -> Matrix3<f64> {
    let (tx, ty, tz) = (2.0 * q.i, 2.0 * q.j, 2.0 * q.k);
    let (twx, twy, twz) = (tx * q.w, ty * q.w, tz * q.w);
    let (txx, txy, txz) = (tx * q.i, ty * q.i, tz * q.i);
    let (tyy, tyz, tzz) = (ty * q.j, tz * q.j, tz * q.k);
    let [in_1_2, in_2_0, in_2_1] = open([twx, twy, twz]);
    Matrix3::new(
        1.0 - (tyy + tzz),
        txy - twz,
        txz + twy,
        txy + twz,
        1.0 - (txx + tzz),
        tyz - in_1_2,
        txz - in_2_0,
        tyz + in_2_1,
        1.0 - (txx + tyy),
    )
}

/// E9: the matrix that the listing makes.
pub(crate) fn appendix_b() -> Witness {
    let matrix = CosineMatrix::Hamilton.of(&EXAMPLE).unwrap_or_default();
    let printed = listing(&EXAMPLE, |[_, _, twz]| [twz, twz, twz]);
    let corrected = listing(&EXAMPLE, |[twx, twy, _]| [twx, twy, twx]);
    Witness::new(
        EXAMPLE_TEXT,
        Sides::new().matrix(&printed, &matrix),
        Sides::new().matrix(&corrected, &matrix),
    )
}
