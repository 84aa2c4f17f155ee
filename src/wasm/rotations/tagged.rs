//! Four numbers with their convention, in its order: the first from 0 on, the second from 4 on.

use crate::convention::side::Side;
use crate::rotation::quaternion::TaggedQuaternion;
use crate::wasm::registers::{leave, leave_rows, numbers};
use crate::wasm::{CallOutcome, chosen, convention, increment_sign, rate_axes};
use nalgebra::Quaternion;
use wasm_bindgen::prelude::*;

/// The quaternion from a place on.
#[inline(never)]
fn tagged(from: usize, convention_code: u8) -> TaggedQuaternion {
    TaggedQuaternion::from_array(numbers(from), convention(convention_code))
}

#[inline(never)]
fn leave_components(components: Quaternion<f64>, convention_code: u8) -> CallOutcome {
    let convention = convention(convention_code);
    leave(
        &TaggedQuaternion {
            components,
            convention,
        }
        .to_array(),
    )
}

#[inline(never)]
fn leave_some(found: Option<TaggedQuaternion>) -> CallOutcome {
    match found {
        Some(tagged) => leave(&tagged.to_array()),
        None => CallOutcome::NoRotation,
    }
}

/// The product in the algebra of the convention.
#[wasm_bindgen(js_name = taggedProduct)]
pub fn tagged_product(convention_code: u8) -> CallOutcome {
    let product = tagged(0, convention_code).product(&tagged(4, convention_code));
    leave_some(product.ok())
}

/// The conjugate.
#[wasm_bindgen(js_name = taggedConjugate)]
pub fn tagged_conjugate(convention_code: u8) -> CallOutcome {
    leave(&tagged(0, convention_code).conjugate().to_array())
}

/// The inverse.
#[wasm_bindgen(js_name = taggedInverse)]
pub fn tagged_inverse(convention_code: u8) -> CallOutcome {
    leave_some(tagged(0, convention_code).inverse())
}

/// The norm.
#[wasm_bindgen(js_name = taggedNorm)]
pub fn tagged_norm() -> f64 {
    tagged(0, 0).norm()
}

/// With norm 1.
#[wasm_bindgen(js_name = taggedNormalize)]
pub fn tagged_normalize(convention_code: u8) -> CallOutcome {
    leave_some(tagged(0, convention_code).normalize())
}

/// The same attitude, of the same norm, in another convention.
#[wasm_bindgen(js_name = taggedConvert)]
pub fn tagged_convert(from_code: u8, to_code: u8) -> CallOutcome {
    let converted = tagged(0, from_code).to_convention(convention(to_code));
    leave(&converted.to_array())
}

/// The matrix of a product with the quaternion as its left factor, or as its right one.
#[wasm_bindgen(js_name = taggedProductMatrix)]
pub fn tagged_product_matrix(convention_code: u8, is_right: u8) -> CallOutcome {
    let quaternion = tagged(0, convention_code);
    leave_rows(&match side(is_right) {
        Side::Left => quaternion.left_product_matrix(),
        Side::Right => quaternion.right_product_matrix(),
    })
}

fn side(place: u8) -> Side {
    chosen(&[Side::Left, Side::Right], place)
}

/// With a small turn from 4 on, on the axes of the convention.
#[wasm_bindgen(js_name = taggedPlus)]
pub fn tagged_plus(convention_code: u8, sign: u8) -> CallOutcome {
    let turned = tagged(0, convention_code).plus(numbers(4), increment_sign(sign));
    leave_some(turned.ok())
}

/// The small turn that leads here from the quaternion from 4 on, in radians.
#[wasm_bindgen(js_name = taggedMinus)]
pub fn tagged_minus(convention_code: u8, sign: u8) -> CallOutcome {
    let estimate = tagged(4, convention_code);
    match tagged(0, convention_code).minus(&estimate, increment_sign(sign)) {
        Ok(increment_rad) => leave(increment_rad.as_slice()),
        Err(_) => CallOutcome::NoRotation,
    }
}

/// The derivative at the rate from 4 on.
#[wasm_bindgen(js_name = taggedDerivative)]
pub fn tagged_derivative(convention_code: u8, axes: u8) -> CallOutcome {
    let derivative = tagged(0, convention_code).derivative(numbers(4), rate_axes(axes));
    leave_components(derivative, convention_code)
}

/// Ω of the rate from 0 on, for which the derivative is `½ Ω q`.
#[wasm_bindgen(js_name = rateMatrix)]
pub fn rate_matrix(convention_code: u8, axes: u8) -> CallOutcome {
    let matrix = convention(convention_code).rate_matrix(numbers(0), rate_axes(axes));
    leave_rows(&matrix)
}
