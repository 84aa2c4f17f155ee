//! Many attitudes one after the other, and the one in the middle of them.

use crate::analyze::attitude::{Attitude, Declared, column_alone};
use crate::analyze::describe::{euler, turn};
use crate::contract::request::ChainRequest;
use crate::contract::{ChainReport, Components, Fact, Note, OutOfRange, OutOfRangeNumber};
use crate::convention::{Convention, Direction};
use crate::problem::{Field, Problem};
use crate::rotation::Rotation;
use crate::rotation::quaternion::{TaggedQuaternion, representable_product};

pub(crate) fn chain(request: &ChainRequest) -> Result<ChainReport, Vec<Problem>> {
    let declared = Declared::plain(request.convention, request.matrix);
    let mut factors = Vec::new();
    let mut problems = Vec::new();
    let mut product = Product::one(request.convention);
    let mut standing = Vec::new();
    let mut notes = Vec::new();
    let mut noted = Vec::new();
    for (at, factor) in request.factors.iter().enumerate() {
        match Attitude::of_text(&factor.text, Field::Factor, declared) {
            Ok(attitude) => {
                notes.extend(attitude.notes(Field::Factor));
                noted.resize(notes.len(), at);
                factors.push(attitude.as_read());
                standing.push(product.multiply(&attitude, factor.inverse));
            }
            Err(problem) => {
                let at = u8::try_from(at).unwrap_or(u8::MAX);
                problems.push(Problem { at, ..problem });
            }
        }
    }
    if !problems.is_empty() {
        return Err(problems);
    }
    let rotation = product.rotation;
    let typed = product.typed.unwrap_or_else(|| {
        let what = OutOfRangeNumber::Product;
        notes.push(Note::new(
            Field::Factor,
            Fact::OutOfRange(OutOfRange { what }),
        ));
        noted.push(0);
        rotation.to_tagged(request.convention)
    });
    let shown = |preset: Convention| {
        let perturbation = request.convention.perturbation;
        let convention = Convention {
            perturbation,
            ..preset
        };
        column_alone(&typed, &rotation, convention)
    };
    Ok(ChainReport {
        factors,
        declared: shown(request.convention),
        hamilton: shown(Convention::HAMILTON),
        jpl: shown(Convention::JPL),
        turn: turn(&rotation),
        euler: euler(&rotation, request.euler),
        mean: Rotation::mean(&standing).map(|mean| {
            let numbers = mean.to_tagged(request.convention).components;
            Components::of(&numbers, request.convention.order)
        }),
        noted,
        notes,
    })
}

/// The factors so far, multiplied out.
struct Product {
    rotation: Rotation,
    /// With the norms that were typed, as long as a double holds it.
    typed: Option<TaggedQuaternion>,
}

impl Product {
    fn one(convention: Convention) -> Self {
        Self {
            rotation: Rotation::identity(),
            typed: Some(TaggedQuaternion::new(1.0, 0.0, 0.0, 0.0, convention)),
        }
    }

    /// Puts a factor on the right of those so far, and returns the attitude that it is there.
    fn multiply(&mut self, attitude: &Attitude, inverse: bool) -> Rotation {
        let convention = attitude.declared;
        let (rotation, typed) = if inverse {
            (attitude.rotation.inverse(), attitude.tagged.inverse())
        } else {
            (attitude.rotation, Some(attitude.tagged))
        };
        // Of the matrices of either direction, M(left) M(right).
        self.rotation = match convention.operator() {
            Direction::BodyToWorld => self.rotation * rotation,
            Direction::WorldToBody => rotation * self.rotation,
        };
        self.typed = self.typed.zip(typed).and_then(|(left, right)| {
            let hand = convention.handedness;
            let components = representable_product(hand, &left.components, &right.components)?;
            Some(TaggedQuaternion { components, ..left })
        });
        rotation
    }
}
