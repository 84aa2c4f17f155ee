//! Four numbers as they are written, with the convention that says what they mean.
//!
//! What comes in and goes out is numbers in their own convention; nothing here
//! knows which rotation they stand for.

use crate::convention::{Convention, Handedness};
use crate::rotation::precise::{self, Norm, UNIT_ROUNDOFF, quotient};
use nalgebra::{Matrix4, Quaternion};
use std::fmt;

/// Two quaternions of different conventions were multiplied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MixedConventions {
    left: Convention,
    right: Convention,
}

impl fmt::Display for MixedConventions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the left factor is {} and the right factor is {}: convert one of them first",
            self.left, self.right
        )
    }
}

impl std::error::Error for MixedConventions {}

/// A quaternion of any norm with the convention of its numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaggedQuaternion {
    /// The components by name: `w`, and `i`, `j`, `k` for x, y, z.
    pub components: Quaternion<f64>,
    /// What they mean.
    pub convention: Convention,
}

/// The Hamilton product `p ⊙ q`, in which `ij = k`.
///
/// For all quaternions; the first factor is the left one (Cheng 2018, eq. 2.2). Each component is
/// rounded once, so that the error is half a unit in the last place where `nalgebra` is off by two;
/// nothing overflows on the way.
///
/// ```
/// use quatlas::{hamilton_product, nalgebra::Quaternion};
/// let p = Quaternion::new(1.0, 2.0, 3.0, 4.0);
/// let q = Quaternion::new(5.0, 6.0, 7.0, 8.0);
/// assert_eq!(hamilton_product(&p, &q), Quaternion::new(-60.0, 12.0, 30.0, 24.0));
/// ```
#[must_use]
#[doc(alias = "⊙")]
pub fn hamilton_product(left: &Quaternion<f64>, right: &Quaternion<f64>) -> Quaternion<f64> {
    let left_scale = precise::working_scale(left.coords.as_slice());
    let right_scale = precise::working_scale(right.coords.as_slice());
    let product = precise::hamilton_product(
        &precise::scale(left, left_scale),
        &precise::scale(right, right_scale),
    );
    precise::scale(&precise::rounded(product), -left_scale - right_scale)
}

/// The JPL (Shuster) product `p ⊗ q`, in which `ij = -k`.
///
/// For all quaternions `p ⊗ q = q ⊙ p` (Cheng 2018, eqs. 2.3 and 2.4).
///
/// ```
/// use quatlas::{jpl_product, nalgebra::Quaternion};
/// let p = Quaternion::new(1.0, 2.0, 3.0, 4.0);
/// let q = Quaternion::new(5.0, 6.0, 7.0, 8.0);
/// assert_eq!(jpl_product(&p, &q), Quaternion::new(-60.0, 20.0, 14.0, 32.0));
/// ```
#[must_use]
#[doc(alias("⊗", "shuster_product"))]
pub fn jpl_product(left: &Quaternion<f64>, right: &Quaternion<f64>) -> Quaternion<f64> {
    hamilton_product(right, left)
}

impl TaggedQuaternion {
    /// The quaternion with these components by name.
    #[must_use]
    pub const fn new(w: f64, x: f64, y: f64, z: f64, convention: Convention) -> Self {
        Self {
            components: Quaternion::new(w, x, y, z),
            convention,
        }
    }

    /// The quaternion written as an array in the order of its convention.
    ///
    /// ```
    /// use quatlas::{Convention, TaggedQuaternion};
    /// let jpl = TaggedQuaternion::from_array([1.0, 2.0, 3.0, 4.0], Convention::JPL);
    /// assert_eq!(jpl.components.w, 4.0);
    /// ```
    #[must_use]
    pub const fn from_array(array: [f64; 4], convention: Convention) -> Self {
        let [w, x, y, z] = convention.order.components(array);
        Self::new(w, x, y, z, convention)
    }

    /// The components as an array in the order of the convention.
    #[must_use]
    pub fn to_array(&self) -> [f64; 4] {
        let Quaternion { coords } = self.components;
        let components = [coords.w, coords.x, coords.y, coords.z];
        self.convention.order.array(components)
    }

    /// The quaternion of the same attitude in another convention, with the same norm.
    ///
    /// Conjugated if the component signs differ, reordered if the orders differ, and nothing else
    /// (specification, section 1.4). See the [module of conventions](crate::convention).
    #[must_use]
    pub fn to_convention(&self, convention: Convention) -> Self {
        let same_sign = self.convention.component_sign() == convention.component_sign();
        Self {
            components: if same_sign {
                self.components
            } else {
                self.components.conjugate()
            },
            convention,
        }
    }

    /// The product `self ∘ right` in the product of their convention.
    ///
    /// # Errors
    ///
    /// [`MixedConventions`] where the two conventions differ: their product would mean nothing.
    pub fn product(&self, right: &Self) -> Result<Self, MixedConventions> {
        if self.convention != right.convention {
            return Err(MixedConventions {
                left: self.convention,
                right: right.convention,
            });
        }
        Ok(Self {
            components: product(
                self.convention.handedness,
                &self.components,
                &right.components,
            ),
            convention: self.convention,
        })
    }

    /// The conjugate `q*`: the vector part changes its sign. For norm 1 it is the inverse.
    #[must_use]
    pub fn conjugate(&self) -> Self {
        Self {
            components: self.components.conjugate(),
            ..*self
        }
    }

    /// The inverse `q⁻¹ = q*/|q|²`, for which `q∘q⁻¹ = 1` in both products (Cheng 2018, eq. 2.8).
    ///
    /// For every norm that is not zero, without overflow or underflow on the way. `None` for the
    /// zero quaternion, and where a component of the inverse is too large or the whole of it too
    /// small for a double. Where the norm is 1 but for rounding, it is the conjugate exactly.
    ///
    /// ```
    /// use quatlas::{Convention, TaggedQuaternion};
    /// let q = TaggedQuaternion::new(0.0, 0.0, 4e300, 0.0, Convention::HAMILTON);
    /// let inverse = q.inverse().expect("not zero");
    /// assert!((inverse.components.j / -2.5e-301 - 1.0).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn inverse(&self) -> Option<Self> {
        let norm = Norm::of(self.components.coords.as_slice());
        let inverse = match norm.rounded_power_of_two() {
            _ if norm.is_zero() => return None,
            Some(exponent) => precise::scale(&self.components.conjugate(), -2 * exponent),
            None => Quaternion {
                coords: self.components.conjugate().coords.map(|number| {
                    let inverse = quotient(norm.divide_precisely(number), norm.fraction);
                    precise::times_power_of_two(inverse.hi(), -norm.exponent)
                }),
            },
        };
        is_representable(&inverse).then_some(Self {
            components: inverse,
            ..*self
        })
    }

    /// The norm `|q|`, the square root of the sum of the squares.
    ///
    /// Infinite only where the norm itself is larger than any double.
    #[must_use]
    pub fn norm(&self) -> f64 {
        Norm::of(self.components.coords.as_slice()).value()
    }

    /// The quaternion of norm 1 with the same direction; `None` for zero and for numbers that are
    /// not finite.
    ///
    /// Components from the smallest to the largest double neither overflow nor underflow, which
    /// `nalgebra` does: it makes NaN of `1e-200`.
    #[must_use]
    pub fn normalize(&self) -> Option<Self> {
        let components = normalize(&self.components)?;
        Some(Self {
            components,
            ..*self
        })
    }

    /// The matrix `L` with `q∘p = L p`, for arrays in the order of this convention.
    ///
    /// ```
    /// use quatlas::{Convention, TaggedQuaternion};
    /// let q = TaggedQuaternion::new(1.0, 2.0, 3.0, 4.0, Convention::JPL);
    /// let matrix = q.left_product_matrix();
    /// assert_eq!(matrix.row(0).iter().copied().collect::<Vec<_>>(), [1.0, 4.0, -3.0, 2.0]);
    /// ```
    #[must_use]
    pub fn left_product_matrix(&self) -> Matrix4<f64> {
        self.matrix_of(|basis| product(self.convention.handedness, &self.components, basis))
    }

    /// The matrix `R` with `p∘q = R p`, for arrays in the order of this convention.
    #[must_use]
    pub fn right_product_matrix(&self) -> Matrix4<f64> {
        self.matrix_of(|basis| product(self.convention.handedness, basis, &self.components))
    }

    /// The matrix of a linear map, column by column: the images of the four basis arrays.
    fn matrix_of(&self, map: impl Fn(&Quaternion<f64>) -> Quaternion<f64>) -> Matrix4<f64> {
        let column = |place: usize| {
            let mut array = [0.0; 4];
            array[place] = 1.0;
            let basis = Self::from_array(array, self.convention);
            let image = Self {
                components: map(&basis.components),
                ..*self
            };
            image.to_array().into()
        };
        Matrix4::from_columns(&[column(0), column(1), column(2), column(3)])
    }
}

/// The product of one hand.
pub(crate) fn product(
    handedness: Handedness,
    left: &Quaternion<f64>,
    right: &Quaternion<f64>,
) -> Quaternion<f64> {
    match handedness {
        Handedness::Right => hamilton_product(left, right),
        Handedness::Left => jpl_product(left, right),
    }
}

/// The product, `None` where a double cannot hold it.
pub(crate) fn representable_product(
    handedness: Handedness,
    left: &Quaternion<f64>,
    right: &Quaternion<f64>,
) -> Option<Quaternion<f64>> {
    Some(product(handedness, left, right)).filter(is_representable)
}

/// How far a typed norm may be from 1 without a word: the components of a unit quaternion that some
/// program computed are off by a few roundings each.
pub(crate) const UNIT_NORM_TOLERANCE: f64 = 4.0 * UNIT_ROUNDOFF;

/// Each component within one roundoff of the exact quotient by the norm.
///
/// A quaternion whose norm is 1 but for the rounding of its components is left as it is, which is
/// as near. So is one that is such a quaternion times a power of two.
pub(crate) fn normalize(quaternion: &Quaternion<f64>) -> Option<Quaternion<f64>> {
    let numbers = quaternion.coords.as_slice();
    let norm = Norm::of(numbers);
    if norm.is_zero() || !numbers.iter().all(|number| number.is_finite()) {
        return None;
    }
    Some(match norm.rounded_power_of_two() {
        Some(exponent) => precise::scale(quaternion, -exponent),
        None => Quaternion {
            coords: quaternion.coords.map(|number| norm.divide(number)),
        },
    })
}

/// Whether the numbers are finite, and the largest of them not subnormal (it would have lost digits).
pub(crate) fn is_representable(quaternion: &Quaternion<f64>) -> bool {
    let largest = quaternion.coords.amax();
    largest.is_finite() && largest >= f64::MIN_POSITIVE
}
