//! What two quaternions make together: both products, in both orders.
//!
//! In `left ∘ right` the right factor acts on a vector first, in both products,
//! because `(p∘q)∘x∘(p∘q)⁻¹ = p∘(q∘x∘q⁻¹)∘p⁻¹`. Which turn of the body comes
//! first is another question; its answer depends on the direction.

use crate::attitude::Attitude;
use crate::convention::{Convention, Direction, Handedness};
use crate::quaternion;
use crate::report::{
    Components, Frame, Operand, OrderMatters, OutOfRange, OutOfRangeNumber, Product, coordinates,
    rows3,
};
use crate::scaling::{self, UNIT_ROUNDOFF};
use nalgebra::{Quaternion, Vector3};

/// How far parallel directions of length 1 may seem apart by the rounding of their components, by
/// half a unit in the last place when typed and a few when normalised and multiplied.
const ROUNDING_OF_DIRECTIONS: f64 = 8.0 * UNIT_ROUNDOFF;

/// p ⊙ q, q ⊙ p, p ⊗ q, q ⊗ p, in this order.
const PRODUCTS: usize = 4;

/// The four products and what they have in common.
pub(crate) struct Composition {
    pub(crate) products: Vec<Product>,
    pub(crate) order_matters: OrderMatters,
    /// Present where the quaternions as typed have a product that a double cannot hold.
    pub(crate) out_of_range: Option<OutOfRange>,
}

/// Every product is taken in the preset of its own hand.
pub(crate) fn compose(p: &Attitude, q: &Attitude, vector: Vector3<f64>) -> Composition {
    let is_representable = |hand, left: &Attitude, right: &Attitude| {
        let (left, right) = (&left.tagged.components, &right.tagged.components);
        quaternion::representable_product(hand, left, right).is_some()
    };
    let as_typed = Handedness::ALL
        .iter()
        .all(|&hand| is_representable(hand, p, q) && is_representable(hand, q, p));

    let unit = |attitude: &Attitude| attitude.rotation.to_tagged(Convention::HAMILTON).components;
    let order_matters = order_matters(&unit(p), &unit(q));
    let mut products = Vec::with_capacity(PRODUCTS);
    for preset in [Convention::HAMILTON, Convention::JPL] {
        for (left, right) in [(Operand::P, Operand::Q), (Operand::Q, Operand::P)] {
            let pick = |operand| match operand {
                Operand::P => p,
                Operand::Q => q,
            };
            let shown = |operand| {
                let attitude = pick(operand);
                let quaternion = if as_typed {
                    attitude.tagged
                } else {
                    attitude.rotation.to_tagged(preset)
                };
                quaternion.to_convention(preset).components
            };
            let product = quaternion::product(preset.handedness, &shown(left), &shown(right));
            let (first, second) = (pick(right).rotation, pick(left).rotation);
            let direction = preset.operator();
            // Of the matrices of either direction, M(left) M(right).
            let both = match direction {
                Direction::BodyToWorld => second * first,
                Direction::WorldToBody => first * second,
            };
            let place = products.len();
            products.push(Product {
                convention: preset,
                left,
                right,
                quaternion: Components::of(&product, preset.order),
                matrix: rows3(&both.matrix(direction)),
                images: first
                    .rotate_within_range(vector, direction)
                    .zip(both.rotate_within_range(vector, direction))
                    .map(|(first, second)| [coordinates(&first), coordinates(&second)]),
                direction,
                frames: frames(direction),
                first_about_fixed_axes: match direction {
                    Direction::BodyToWorld => right,
                    Direction::WorldToBody => left,
                },
                // p ⊙ q = q ⊗ p for all quaternions (Cheng 2018, eq. 2.4), and these are the first
                // and the last; the others are the same only where p and q commute.
                equal_to: (0..PRODUCTS)
                    .filter(|&other| {
                        order_matters == OrderMatters::No
                            || other == place
                            || other + place == PRODUCTS - 1
                    })
                    .collect(),
            });
        }
    }
    Composition {
        order_matters,
        products,
        out_of_range: (!as_typed).then_some(OutOfRange {
            what: OutOfRangeNumber::Product,
        }),
    }
}

/// The frames on the way of a vector's coordinates; the right factor leads from the first to the
/// second.
const fn frames(direction: Direction) -> [Frame; 3] {
    match direction {
        Direction::BodyToWorld => [Frame::SecondBody, Frame::Body, Frame::World],
        Direction::WorldToBody => [Frame::World, Frame::Body, Frame::SecondBody],
    }
}

/// Whether p∘q and q∘p differ, for norm 1.
///
/// They differ by twice the cross product of their vector parts, and p∘q = −q∘p means that both
/// scalars are 0 and the axes perpendicular. Tested on the factors, since a small difference drowns
/// in the rounding of the products.
fn order_matters(p: &Quaternion<f64>, q: &Quaternion<f64>) -> OrderMatters {
    let axis = |quaternion: &Quaternion<f64>| scaling::direction(&quaternion.vector().into());
    let (Some(p_axis), Some(q_axis)) = (axis(p), axis(q)) else {
        return OrderMatters::No;
    };
    if p_axis.cross(&q_axis).amax() <= ROUNDING_OF_DIRECTIONS {
        return OrderMatters::No;
    }
    let are_half_turns = p.w.abs().max(q.w.abs()) <= ROUNDING_OF_DIRECTIONS;
    if are_half_turns && p_axis.dot(&q_axis).abs() <= ROUNDING_OF_DIRECTIONS {
        return OrderMatters::OnlyInSign;
    }
    OrderMatters::Yes
}
