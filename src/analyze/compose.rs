//! What two quaternions make together: both products, in both orders.
//!
//! In `left ∘ right` the right factor acts on a vector first, in both products,
//! because `(p∘q)∘v∘(p∘q)⁻¹ = p∘(q∘v∘q⁻¹)∘p⁻¹`. Which turn of the body comes
//! first is another question; its answer depends on the direction.

use crate::analyze::attitude::{Attitude, Declared};
use crate::analyze::describe::turn;
use crate::analyze::plain_numbers::{coordinates, rows3};
use crate::analyze::vector::TypedVector;
use crate::contract::request::ComposeRequest;
use crate::contract::{
    Components, ComposeReport, Fact, Frame, Note, Operand, OrderMatters, OutOfRange,
    OutOfRangeNumber, Product,
};
use crate::convention::{ComponentSign, Convention, Direction, Handedness};
use crate::problem::{Field, Problem};
use crate::rotation::precise::{self, UNIT_ROUNDOFF};
use crate::rotation::quaternion;
use nalgebra::{Quaternion, Vector3};

/// How far parallel directions of length 1 may seem apart by the rounding of their components, by
/// half a unit in the last place when typed and a few when normalised and multiplied.
const ROUNDING_OF_DIRECTIONS: f64 = 8.0 * UNIT_ROUNDOFF;

pub(crate) fn compose(request: &ComposeRequest) -> Result<ComposeReport, Vec<Problem>> {
    let declared = Declared::plain(request.convention, request.matrix);
    let p = Attitude::of_text(&request.p, Field::P, declared);
    let q = Attitude::of_text(&request.q, Field::Q, declared);
    let vector = TypedVector::of_text(&request.vector, Field::Vector);
    let (p, q, vector) = match (p, q, vector) {
        (Ok(p), Ok(q), Ok(vector)) => (p, q, vector),
        (p, q, vector) => {
            let mut problems = Vec::new();
            problems.extend(p.err());
            problems.extend(q.err());
            problems.extend(vector.err());
            return Err(problems);
        }
    };
    let TypedVector { vector, note } = vector;
    let composition = composition(&p, &q, vector);

    let mut notes = p.notes(Field::P);
    notes.extend(q.notes(Field::Q));
    notes.extend(note);
    let out_of_range = composition.out_of_range.map(Fact::OutOfRange);
    notes.extend(out_of_range.map(|fact| Note::new(Field::P, fact)));
    if composition
        .products
        .iter()
        .any(|product| product.images.is_none())
    {
        let what = OutOfRangeNumber::Image;
        let fact = Fact::OutOfRange(OutOfRange { what });
        notes.push(Note::new(Field::Vector, fact));
    }
    Ok(ComposeReport {
        p: p.as_read(),
        q: q.as_read(),
        p_turn: turn(&p.rotation),
        q_turn: turn(&q.rotation),
        vector: coordinates(&vector),
        declared: composition.declared,
        products: composition.products,
        order_matters: composition.order_matters,
        notes,
    })
}

/// The products and what they have in common.
struct Composition {
    /// `p∘q` in the declared convention.
    declared: Product,
    products: Vec<Product>,
    order_matters: OrderMatters,
    /// Present where the quaternions as typed have a product that a double cannot hold.
    out_of_range: Option<OutOfRange>,
}

/// Every product is taken in the convention it is for, of the same two attitudes.
fn composition(p: &Attitude, q: &Attitude, vector: Vector3<f64>) -> Composition {
    let unit = |attitude: &Attitude| attitude.rotation.to_tagged(Convention::HAMILTON).components;
    let order_matters = order_matters(&unit(p), &unit(q));
    let pair = Pair {
        p,
        q,
        vector,
        numbers: Numbers::of(p, q),
    };
    // p ⊙ q, q ⊙ p, p ⊗ q, q ⊗ p, in this order.
    let mut products = Vec::new();
    for preset in [Convention::HAMILTON, Convention::JPL] {
        products.push(pair.product(preset, Operand::P, Operand::Q));
        products.push(pair.product(preset, Operand::Q, Operand::P));
    }
    let mut declared = pair.product(p.tagged.convention, Operand::P, Operand::Q);
    // Two products have the same numbers where the signs of their conventions agree and they are the
    // same attitude: p ⊙ q = q ⊗ p for all quaternions (Cheng 2018, eq. 2.4), the others only where
    // p and q commute.
    let mut kinds = Vec::new();
    for product in &products {
        kinds.push(kind(product));
    }
    for product in products.iter_mut().chain([&mut declared]) {
        let (sign, first) = kind(product);
        for (other, (other_sign, other_first)) in kinds.iter().enumerate() {
            let same_attitude = *other_first == first || order_matters == OrderMatters::No;
            if *other_sign == sign && same_attitude {
                product.equal_to.push(other);
            }
        }
    }
    Composition {
        declared,
        products,
        order_matters,
        out_of_range: (pair.numbers == Numbers::OfNorm1).then_some(OutOfRange {
            what: OutOfRangeNumber::Product,
        }),
    }
}

/// The sign of a product's components, and the operand whose turn comes first about fixed axes.
const fn kind(product: &Product) -> (ComponentSign, Operand) {
    (
        product.convention.component_sign(),
        product.first_about_fixed_axes,
    )
}

/// Which numbers of the operands are multiplied.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Numbers {
    AsTyped,
    /// Those of norm 1, where the product of those typed is beyond a double.
    OfNorm1,
}

impl Numbers {
    fn of(p: &Attitude, q: &Attitude) -> Self {
        let (p, q) = (&p.tagged.components, &q.tagged.components);
        // The products in the other order are those of the other hand.
        let all = Handedness::ALL
            .iter()
            .all(|&hand| quaternion::representable_product(hand, p, q).is_some());
        if all { Self::AsTyped } else { Self::OfNorm1 }
    }
}

struct Pair<'a> {
    p: &'a Attitude,
    q: &'a Attitude,
    vector: Vector3<f64>,
    numbers: Numbers,
}

impl Pair<'_> {
    fn attitude(&self, operand: Operand) -> &Attitude {
        match operand {
            Operand::P => self.p,
            Operand::Q => self.q,
        }
    }

    fn components(&self, operand: Operand, convention: Convention) -> Quaternion<f64> {
        let attitude = self.attitude(operand);
        let quaternion = match self.numbers {
            Numbers::AsTyped => attitude.tagged.to_convention(convention),
            Numbers::OfNorm1 => attitude.rotation.to_tagged(convention),
        };
        quaternion.components
    }

    /// `left∘right` in a convention; what it is equal to is not known yet.
    fn product(&self, convention: Convention, left: Operand, right: Operand) -> Product {
        let product = quaternion::product(
            convention.handedness,
            &self.components(left, convention),
            &self.components(right, convention),
        );
        let direction = convention.operator();
        let (first, second) = (self.attitude(right).rotation, self.attitude(left).rotation);
        // Of the matrices of either direction, M(left) M(right).
        let both = match direction {
            Direction::BodyToWorld => second * first,
            Direction::WorldToBody => first * second,
        };
        Product {
            convention,
            left,
            right,
            quaternion: Components::of(&product, convention.order),
            turn: turn(&both),
            matrix: rows3(&both.matrix(direction)),
            images: first
                .rotate_within_range(self.vector, direction)
                .zip(both.rotate_within_range(self.vector, direction))
                .map(|(first, second)| [coordinates(&first), coordinates(&second)]),
            direction,
            frames: frames(direction),
            first_about_fixed_axes: match direction {
                Direction::BodyToWorld => right,
                Direction::WorldToBody => left,
            },
            equal_to: Vec::new(),
        }
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
    let axis = |quaternion: &Quaternion<f64>| precise::direction(&quaternion.vector().into());
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
