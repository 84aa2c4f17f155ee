//! What two quaternions make together: both products, in both orders.
//!
//! In `left ∘ right` the right factor acts on a vector first, in both products,
//! because `(p∘q)∘x∘(p∘q)⁻¹ = p∘(q∘x∘q⁻¹)∘p⁻¹`. Which turn of the body comes
//! first is another question; its answer depends on the direction.

use crate::convention::{Convention, Direction, Handedness};
use crate::quaternion::{self, TaggedQuaternion};
use crate::report::{
    Components, Frame, Operand, OrderMatters, OutOfRange, OutOfRangeNumber, Product, coordinates,
    rows3,
};
use crate::rotation::{NoRotation, Rotation};
use nalgebra::{Quaternion, Vector3};

/// How far two products of the same numbers may differ by rounding alone, relative to their norm:
/// each component is a sum of four products, so it takes seven roundings of 2^-53 in each of two.
const ROUNDING_OF_TWO_PRODUCTS: f64 = 14.0 * (f64::EPSILON / 2.0);

/// The four products and what they have in common.
pub(crate) struct Composition {
    pub(crate) products: Vec<Product>,
    pub(crate) order_matters: OrderMatters,
    /// Present where the quaternions as typed have a product that a double cannot hold.
    pub(crate) out_of_range: Option<OutOfRange>,
}

/// `p` and `q` are in one convention; every product is taken in the preset of its own hand.
pub(crate) fn compose(
    p: &TaggedQuaternion,
    q: &TaggedQuaternion,
    vector: Vector3<f64>,
) -> Result<Composition, NoRotation> {
    let unit_p = p.normalize().ok_or(NoRotation)?;
    let unit_q = q.normalize().ok_or(NoRotation)?;
    let is_representable = |hand, left: &TaggedQuaternion, right: &TaggedQuaternion| {
        quaternion::scaled_product(hand, &left.components, &right.components).is_some()
    };
    let as_typed = Handedness::ALL
        .iter()
        .all(|&hand| is_representable(hand, p, q) && is_representable(hand, q, p));
    let (shown_p, shown_q) = if as_typed { (p, q) } else { (&unit_p, &unit_q) };

    let mut products = Vec::new();
    let mut quaternions = Vec::new();
    for preset in [Convention::HAMILTON, Convention::JPL] {
        for (left, right) in [(Operand::P, Operand::Q), (Operand::Q, Operand::P)] {
            let pick = |operand, p: &TaggedQuaternion, q: &TaggedQuaternion| match operand {
                Operand::P => p.to_convention(preset),
                Operand::Q => q.to_convention(preset),
            };
            let multiply = |p, q| {
                quaternion::scaled_product(
                    preset.handedness,
                    &pick(left, p, q).components,
                    &pick(right, p, q).components,
                )
            };
            let typed_product = multiply(shown_p, shown_q).ok_or(NoRotation)?;
            let unit_product = TaggedQuaternion {
                components: multiply(&unit_p, &unit_q).ok_or(NoRotation)?,
                convention: preset,
            };
            let direction = preset.operator();
            let after_right = Rotation::from_tagged(&pick(right, &unit_p, &unit_q))?
                .turn_within_range(direction, vector);
            let after_both = Rotation::from_tagged(&unit_product)?;
            quaternions.push(typed_product);
            products.push(Product {
                convention: preset,
                left,
                right,
                quaternion: Components::of(&typed_product, preset.order),
                matrix: rows3(&after_both.matrix(direction)),
                images: after_right
                    .zip(after_both.turn_within_range(direction, vector))
                    .map(|(first, second)| [coordinates(&first), coordinates(&second)]),
                direction,
                frames: frames(direction),
                first_about_fixed_axes: match direction {
                    Direction::BodyToWorld => right,
                    Direction::WorldToBody => left,
                },
                equal_to: Vec::new(),
            });
        }
    }
    for (product, quaternion) in products.iter_mut().zip(&quaternions) {
        product.equal_to = (0..quaternions.len())
            .filter(|&other| are_equal(quaternion, &quaternions[other]))
            .collect();
    }
    Ok(Composition {
        order_matters: order_matters(&quaternions[0], &quaternions[1]),
        products,
        out_of_range: (!as_typed).then_some(OutOfRange {
            what: OutOfRangeNumber::Product,
        }),
    })
}

/// The frames on the way of a vector's coordinates; the right factor leads from the first to the
/// second.
const fn frames(direction: Direction) -> [Frame; 3] {
    match direction {
        Direction::BodyToWorld => [Frame::SecondBody, Frame::Body, Frame::World],
        Direction::WorldToBody => [Frame::World, Frame::Body, Frame::SecondBody],
    }
}

fn are_equal(one: &Quaternion<f64>, other: &Quaternion<f64>) -> bool {
    let largest = one.coords.amax().max(other.coords.amax());
    // Halved, so that the difference of two large numbers of opposite sign stays finite.
    (one.coords / 2.0 - other.coords / 2.0).amax() <= ROUNDING_OF_TWO_PRODUCTS / 2.0 * largest
}

fn order_matters(pq: &Quaternion<f64>, qp: &Quaternion<f64>) -> OrderMatters {
    if are_equal(pq, qp) {
        OrderMatters::No
    } else if are_equal(pq, &-qp) {
        OrderMatters::OnlyInSign
    } else {
        OrderMatters::Yes
    }
}
