//! What a library means by three angles, by a matrix and by a small turn, told from what it printed.
//!
//! These are the unit tests of the field guide for libraries of Euler angles (specification, FX-11) and of
//! matrices (FX-07). Whoever has a quaternion asks [`IdentifyRequest`](crate::IdentifyRequest); which
//! vector along the axis three numbers are, [`AxisVector::recognize`](crate::AxisVector::recognize) says.

use crate::convention::angle::{AngleUnit, degrees_in_radians};
use crate::convention::euler_sequence::EulerSequence;
use crate::convention::side::IncrementSign;
use crate::convention::{Direction, Function, Perturbation};
use crate::rotation::distance::angle_between_rad;
use crate::rotation::{NoRotation, Rotation};
use nalgebra::{Matrix3, Vector3};

/// A vector of length 1 that is printed with one decimal may be this far from where it is.
pub(crate) const ONE_DECIMAL: f64 = 0.1;

/// Of the four turns that an increment may be, one is told if it alone is nearer than this part of the
/// increment: for a body yawed by +90° the nearest two are √2 of it apart, so rounding has room.
const PART_OF_INCREMENT: f64 = 0.25;

/// One way in which a library may make a matrix of three angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct EulerReading {
    /// About which axes the angles turn, in their order, and whether the axes turn too.
    pub sequence: EulerSequence,
    /// The unit of the angles.
    pub unit: AngleUnit,
    /// Which coordinates to which the matrix takes: `R_WB` or `R_BW`.
    pub direction: Direction,
}

impl EulerReading {
    /// All 96: of each sequence in each unit the matrix and its transpose.
    pub fn all() -> impl Iterator<Item = Self> {
        EulerSequence::all().flat_map(|sequence| {
            [AngleUnit::Radians, AngleUnit::Degrees]
                .into_iter()
                .flat_map(move |unit| {
                    Direction::ALL.map(|direction| Self {
                        sequence,
                        unit,
                        direction,
                    })
                })
        })
    }

    /// The matrix that a library makes of these angles, if it reads them so.
    ///
    /// # Errors
    ///
    /// [`NoRotation`] for angles that are not finite.
    pub fn matrix(self, angles: [f64; 3]) -> Result<Matrix3<f64>, NoRotation> {
        let angles_rad = match self.unit {
            AngleUnit::Radians => angles,
            AngleUnit::Degrees => angles.map(degrees_in_radians),
        };
        Ok(Rotation::from_euler_rad(self.sequence, angles_rad)?.matrix(self.direction))
    }

    /// The readings that are nowhere farther than this from what a library printed, the nearest first, each
    /// with how far it is at most, in radians.
    ///
    /// A print is three angles as they were put in and the matrix that came out, row by row. One is enough:
    /// of (30, 20, 10) no two readings are nearer to each other than 2.78°, in either unit; of (0.7, −0.4, 1.1)
    /// none is nearer than 9° to one in radians, while in degrees those are small turns, which are nearly the
    /// same in any order. Half of that is the most that a tolerance should be. Of small turns in one slot,
    /// with which the field guide's test begins, it takes several (specification, FX-11).
    ///
    /// How far a matrix is off is the angle of the turn between, `2 asin(‖A − B‖ / 2√2)`, and π for what no
    /// turn is as far from.
    ///
    /// ```
    /// use quatlas::{AngleUnit, Direction, EulerReading, nalgebra::Matrix3};
    /// // SciPy: Rotation.from_euler("XYZ", [0.7, -0.4, 1.1]).as_matrix()
    /// let printed = Matrix3::new(
    ///     0.4178, -0.8209, -0.3894,
    ///     0.5678, 0.5705, -0.5934,
    ///     0.7092, 0.0268, 0.7045,
    /// );
    /// let found = EulerReading::recognize(&[([0.7, -0.4, 1.1], printed)], 0.01);
    /// let [(reading, off_rad)] = &found[..] else { panic!("one alone") };
    /// assert_eq!(reading.sequence.to_string(), "XYZ");
    /// assert_eq!((reading.unit, reading.direction), (AngleUnit::Radians, Direction::BodyToWorld));
    /// assert!(*off_rad < 1e-4);
    /// ```
    #[must_use]
    pub fn recognize(prints: &[([f64; 3], Matrix3<f64>)], tolerance_rad: f64) -> Vec<(Self, f64)> {
        let off_rad = |reading: Self| {
            prints.iter().try_fold(0.0, |most: f64, (angles, printed)| {
                let off_rad = angle_between_rad(&reading.matrix(*angles).ok()?, printed);
                // A comparison with what is not a number fails.
                (off_rad <= tolerance_rad).then(|| most.max(off_rad))
            })
        };
        let mut found: Vec<(Self, f64)> = Self::all()
            .filter_map(|reading| Some((reading, off_rad(reading)?)))
            .collect();
        found.sort_by(|(_, one), (_, other)| one.total_cmp(other));
        found
    }
}

/// Nothing that is not a number is within anything.
fn is_within(differences: &[f64], tolerance: f64) -> bool {
    differences
        .iter()
        .all(|difference| difference.abs() <= tolerance)
}

/// Which coordinates to which a library's matrix takes, from what it makes of (1, 0, 0) where the matrix is
/// that of a body yawed by +90° about the world's z axis.
///
/// (0, 1, 0) is body to world, `R_WB` (τ = +1), and (0, −1, 0) world to body, `R_BW` (τ = −1), of vectors that
/// stand as columns on the right of the matrix (specification, FX-07, step 2). `None` for anything else, to
/// one decimal. Function and direction of its [`MatrixConvention`](crate::MatrixConvention) are
/// told with [`function_of_chain`].
///
/// ```
/// use quatlas::{Direction, direction_of_yawed};
/// assert_eq!(direction_of_yawed([0.0, 1.0, 0.0]), Some(Direction::BodyToWorld));
/// assert_eq!(direction_of_yawed([0.0, -1.0, 0.0]), Some(Direction::WorldToBody));
/// // Rolled, not yawed.
/// assert_eq!(direction_of_yawed([1.0, 0.0, 0.0]), None);
/// ```
#[must_use]
#[doc(alias = "tau")]
pub fn direction_of_yawed(image_of_x: [f64; 3]) -> Option<Direction> {
    let image = Vector3::from(image_of_x);
    let is = |expected: Vector3<f64>| is_within((image - expected).as_slice(), ONE_DECIMAL);
    if is(Vector3::y()) {
        Some(Direction::BodyToWorld)
    } else if is(-Vector3::y()) {
        Some(Direction::WorldToBody)
    } else {
        None
    }
}

/// Whether labelled matrices change coordinates or move vectors, from three of a chain A, B, C.
///
/// `M_BC M_AB = M_AC` is passive and `M_AB M_BC = M_AC` active (specification, FX-07, step 3); each entry may
/// be so far off. `None` where neither holds, and where both do, as for turns about one axis.
///
/// With it and [`direction_of_yawed`] all is told: of a passive matrix that direction is its label, of an
/// active one the reverse.
///
/// ```
/// use quatlas::{Function, Rotation, function_of_chain};
/// use std::f64::consts::FRAC_PI_2;
/// let yawed = Rotation::from_axis_angle([0.0, 0.0, 1.0], FRAC_PI_2)?;
/// let rolled = Rotation::from_axis_angle([1.0, 0.0, 0.0], FRAC_PI_2)?;
/// // World, body, camera: the coordinates of the camera are taken to those of the world.
/// let [cb, bw, cw] = [rolled, yawed, yawed * rolled].map(|turn| turn.body_to_world_matrix());
/// assert_eq!(function_of_chain(&cb, &bw, &cw, 1e-12), Some(Function::Passive));
/// // With the labels of the way back the same numbers move vectors.
/// assert_eq!(function_of_chain(&bw, &cb, &cw, 1e-12), Some(Function::Active));
/// # Ok::<(), quatlas::NoRotation>(())
/// ```
#[must_use]
pub fn function_of_chain(
    a_to_b: &Matrix3<f64>,
    b_to_c: &Matrix3<f64>,
    a_to_c: &Matrix3<f64>,
    tolerance: f64,
) -> Option<Function> {
    let is_whole = |product: Matrix3<f64>| is_within((product - a_to_c).as_slice(), tolerance);
    match (is_whole(b_to_c * a_to_b), is_whole(a_to_b * b_to_c)) {
        (true, false) => Some(Function::Passive),
        (false, true) => Some(Function::Active),
        _ => None,
    }
}

/// On whose axes a library adds a small turn, and with which sign, from the attitudes before and after.
///
/// On the axes of the body (*local*) or of the world (*global*); the body turned by the increment is the
/// physical sign, and the body turned back the formal one (specification, FX-07, step 4, and FX-26, step 6).
/// Best for a body that is yawed by +90° and an increment about x. `None` where more than one of the four
/// fits, as for an increment about the axis of the attitude, or none does: the body was turned by something
/// else, or not at all.
///
/// ```
/// use quatlas::{IncrementSign, Perturbation, Rotation, increment_of};
/// use std::f64::consts::FRAC_PI_2;
/// let yawed = Rotation::from_axis_angle([0.0, 0.0, 1.0], FRAC_PI_2)?;
/// // The body's x axis points to the world's y.
/// let after = Rotation::from_axis_angle([0.0, 1.0, 0.0], -0.01)? * yawed;
/// let told = increment_of(&yawed, &after, [0.01, 0.0, 0.0]);
/// assert_eq!(told, Some((Perturbation::Local, IncrementSign::Formal)));
/// # Ok::<(), quatlas::NoRotation>(())
/// ```
#[must_use]
pub fn increment_of(
    before: &Rotation,
    after: &Rotation,
    increment_rad: [f64; 3],
) -> Option<(Perturbation, IncrementSign)> {
    match increments_that_fit(before, after, increment_rad)[..] {
        [told] => Some(told),
        _ => None,
    }
}

/// The axes and signs with which an increment leads from one attitude to the other.
pub(crate) fn increments_that_fit(
    before: &Rotation,
    after: &Rotation,
    increment_rad: [f64; 3],
) -> Vec<(Perturbation, IncrementSign)> {
    let Ok(turn) = Rotation::from_rotation_vector_rad(increment_rad) else {
        return Vec::new();
    };
    let nearer_than_rad = PART_OF_INCREMENT * Rotation::identity().angle_to_rad(&turn);
    let fits = |(axes, sign): &(Perturbation, IncrementSign)| {
        let of_body = match sign {
            IncrementSign::Physical => turn,
            IncrementSign::Formal => turn.inverse(),
        };
        let turned = match axes {
            Perturbation::Local => *before * of_body,
            Perturbation::Global => of_body * *before,
        };
        turned.angle_to_rad(after) < nearer_than_rad
    };
    let mut fitting = Vec::new();
    for axes in Perturbation::ALL {
        for sign in IncrementSign::ALL {
            if fits(&(axes, sign)) {
                fitting.push((axes, sign));
            }
        }
    }
    fitting
}
