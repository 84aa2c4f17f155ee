//! The declared convention, Hamilton and JPL, and what an increment or a rate makes in each.

use crate::analyze::attitude::Attitude;
use crate::analyze::plain_numbers::rows4;
use crate::contract::{Components, SidedQuaternion};
use crate::convention::side::{IncrementSign, Side};
use crate::convention::{Convention, Perturbation};
use crate::rotation::quaternion::{self, TaggedQuaternion};
use nalgebra::Quaternion;

/// The declared convention, Hamilton and JPL, with small turns on these axes.
pub(super) fn conventions(attitude: &Attitude, perturbation: Perturbation) -> [Convention; 3] {
    let mut all = [
        attitude.tagged.convention,
        Convention::HAMILTON,
        Convention::JPL,
    ];
    for convention in &mut all {
        convention.perturbation = perturbation;
    }
    all
}

/// σ of a convention.
pub(super) fn sigma(convention: Convention) -> f64 {
    convention.increment_factor(IncrementSign::Physical)
}

/// The product of the attitude and this factor, times `scale`, in a convention: the factor stands where
/// small turns on the axes of that do.
pub(super) fn sided(
    attitude: &Attitude,
    convention: Convention,
    factor: Quaternion<f64>,
    scale: f64,
) -> SidedQuaternion {
    let unit = attitude.rotation.to_tagged(convention).components;
    let side = convention.increment_side();
    let hand = convention.handedness;
    let tagged = TaggedQuaternion {
        components: factor,
        convention,
    };
    let (product, matrix) = match side {
        Side::Right => (
            quaternion::product(hand, &unit, &factor),
            tagged.right_product_matrix(),
        ),
        Side::Left => (
            quaternion::product(hand, &factor, &unit),
            tagged.left_product_matrix(),
        ),
    };
    SidedQuaternion {
        convention,
        quaternion: Components::of(&(product * scale), convention.order),
        side,
        sign: if sigma(convention) < 0.0 { -1 } else { 1 },
        factor: Components::of(&factor, convention.order),
        matrix: rows4(&matrix),
    }
}
