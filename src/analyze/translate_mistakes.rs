//! What is to be done on the way from one end of a translation to the other, and what comes of leaving it out.

use crate::analyze::plain_numbers::plain;
use crate::contract::{Change, Mistake, MistakeKind, ProductOrder};
use crate::convention::Convention;
use crate::library::endpoint::Meaning;
use crate::rotation::Rotation;
use crate::rotation::quaternion::TaggedQuaternion;

pub(crate) fn change_between(from: &Meaning, to: &Meaning) -> Change {
    let reordered = from.order != to.order;
    let conjugated = from.numbers().component_sign() != to.numbers().component_sign();
    match (reordered, conjugated) {
        (false, false) => Change::Copied,
        (true, false) => Change::Reordered,
        (false, true) => Change::Conjugated,
        (true, true) => Change::ReorderedAndConjugated,
    }
}

/// What comes of the numbers when a step is left out, or a conjugation done that is not needed; nothing
/// where an end has no four numbers.
pub(crate) fn mistakes(
    from: &Meaning,
    to: &Meaning,
    right: &TaggedQuaternion,
    rotation: &Rotation,
) -> Vec<Mistake> {
    if !(from.has_quaternion() && to.has_quaternion()) {
        return Vec::new();
    }
    let not_reordered = |numbers: &TaggedQuaternion| {
        // As they stood at the first end, in places that are those of the other order.
        let array = from.order.array(numbers.to_array());
        let array = from.order.other().components(array);
        TaggedQuaternion::from_array(array, numbers.convention)
    };
    let passed_on = match to.library.and_then(|library| library.constructor_order) {
        Some(order) if order != to.order && to.order == from.order => {
            let array = right.to_array();
            let wrong = TaggedQuaternion::from_array(
                array,
                Convention {
                    order,
                    ..right.convention
                },
            );
            Some((MistakeKind::ConstructorOrder, wrong))
        }
        _ => None,
    };
    // Its own inverse: the mistake that undoes a needed conjugation is the one that adds another.
    let conjugated = right.conjugate();
    let mut made = match change_between(from, to) {
        Change::Copied => vec![(MistakeKind::ConjugatedNeedlessly, conjugated)],
        Change::Reordered => vec![
            (MistakeKind::NotReordered, not_reordered(right)),
            (MistakeKind::ConjugatedNeedlessly, conjugated),
        ],
        Change::Conjugated => vec![(MistakeKind::NotConjugated, conjugated)],
        Change::ReorderedAndConjugated => vec![
            (MistakeKind::Copied, not_reordered(&conjugated)),
            (MistakeKind::NotConjugated, conjugated),
            (MistakeKind::NotReordered, not_reordered(right)),
        ],
    };
    made.extend(passed_on);
    let mut mistakes = Vec::new();
    for (kind, wrong) in made {
        if let Ok(wrong) = Rotation::from_tagged(&wrong) {
            let angle_deg = angle_deg(rotation, &wrong);
            mistakes.push(Mistake { kind, angle_deg });
        }
    }
    mistakes
}

pub(crate) fn angle_deg(right: &Rotation, wrong: &Rotation) -> f64 {
    plain(right.angle_to_rad(wrong).to_degrees())
}

/// A conjugation turns a product round, and so does the other hand; both together do not.
pub(crate) fn product_order(from: &Meaning, to: &Meaning) -> ProductOrder {
    let (Some(one), Some(other)) = (from.handedness, to.handedness) else {
        return ProductOrder::NotEstablished;
    };
    let sign = |meaning: &Meaning| meaning.numbers().component_sign();
    if (one == other) == (sign(from) == sign(to)) {
        ProductOrder::Same
    } else {
        ProductOrder::Reversed
    }
}
