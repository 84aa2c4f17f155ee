//! The whole road: a request in, an outcome out.
//!
//! Text is parsed, tagged with its convention, turned into the canonical
//! rotation, and written back in every convention. Any step may stop with
//! problems; nothing is thrown and nothing is printed.

use crate::compose::compose;
use crate::convention::{ComponentOrder, Convention};
use crate::messages::Fault;
use crate::parse::{ParsedQuaternion, parse_quaternion, parse_vector};
use crate::problem::{Field, Problem, Span};
use crate::quaternion::{TaggedQuaternion, UNIT_NORM_TOLERANCE};
use crate::report::{
    Column, Components, ComposeReport, Fact, Normalised, Note, OrderAssumed, OrderFromText,
    OrderSource, OutOfRange, OutOfRangeNumber, Outcome, Problems, ReadQuaternion, ReadReport, Turn,
    UnknownConstructor, coordinates, plain, rows3, rows4,
};
use crate::request::{ComposeRequest, ReadRequest, Request};
use crate::rotation::Rotation;
use nalgebra::{Quaternion, Vector3};

/// A scalar part this small is a rounded cosine of 90°: the turn is half a turn.
const HALF_TURN_SCALAR: f64 = f64::EPSILON / 2.0;

/// The answer to a request: a report with notes, or the problems of its texts.
///
/// Nothing that is typed makes it panic, and no number of the answer is NaN, infinite or −0.
///
/// ```
/// use quatlas::{analyze, Convention, Outcome, ReadRequest, Request};
///
/// // Four numbers of a JPL filter: x y z w, world to body; a quarter turn about z.
/// let outcome = analyze(&Request::Read(ReadRequest {
///     quaternion: "0 0 1/√2 1/√2".into(),
///     vector: "1 0 0".into(),
///     convention: Convention::JPL,
/// }));
/// let Outcome::Read(report) = outcome else { panic!("{outcome:?}") };
///
/// // The world's x axis, seen from the body, is −y; the body's, seen from the world, is y.
/// assert_eq!(report.jpl.image, Some([0.0, -1.0, 0.0]));
/// assert_eq!(report.hamilton.image, Some([0.0, 1.0, 0.0]));
/// ```
#[must_use]
pub fn analyze(request: &Request) -> Outcome {
    let answered = match request {
        Request::Read(request) => read(request).map(|report| Outcome::Read(Box::new(report))),
        Request::Compose(request) => {
            answer_compose(request).map(|report| Outcome::Compose(Box::new(report)))
        }
    };
    answered.unwrap_or_else(|problems| Outcome::Problems(Problems { problems }))
}

fn read(request: &ReadRequest) -> Result<ReadReport, Vec<Problem>> {
    let attitude = Attitude::of_text(&request.quaternion, Field::Quaternion, request.convention);
    let vector = parse_vector(&request.vector, Field::Vector);
    let (attitude, vector) = match (attitude, vector) {
        (Ok(attitude), Ok(vector)) => (attitude, vector),
        (attitude, vector) => return Err(problems([attitude.err(), vector.err()])),
    };

    let mut notes = attitude.notes(Field::Quaternion);
    let hamilton = attitude.column(Convention::HAMILTON, vector);
    let jpl = attitude.column(Convention::JPL, vector);
    let mut left_out = |field, what, present: bool| {
        if !present {
            let fact = Fact::OutOfRange(OutOfRange { what });
            notes.push(Note { field, fact });
        }
    };
    left_out(
        Field::Quaternion,
        OutOfRangeNumber::Inverse,
        hamilton.inverse.is_some(),
    );
    left_out(
        Field::Vector,
        OutOfRangeNumber::Image,
        hamilton.image.is_some() && jpl.image.is_some(),
    );
    let same_matrix = Convention {
        direction: Convention::HAMILTON.direction,
        ..Convention::JPL
    };
    Ok(ReadReport {
        quaternion: attitude.as_read(),
        vector: coordinates(&vector),
        hamilton,
        jpl,
        declared: attitude.column(attitude.tagged.convention, vector),
        rules: rules(attitude.tagged.convention),
        euler: euler(&attitude.rotation, request.euler),
        jpl_with_same_matrix: Components::of(
            &attitude.tagged.to_convention(same_matrix).components,
            same_matrix.order,
        ),
        turn: turn(&attitude.rotation),
        notes,
    })
}

fn answer_compose(request: &ComposeRequest) -> Result<ComposeReport, Vec<Problem>> {
    let p = Attitude::of_text(&request.p, Field::P, request.convention);
    let q = Attitude::of_text(&request.q, Field::Q, request.convention);
    let vector = parse_vector(&request.vector, Field::Vector);
    let (p, q, vector) = match (p, q, vector) {
        (Ok(p), Ok(q), Ok(vector)) => (p, q, vector),
        (p, q, vector) => return Err(problems([p.err(), q.err(), vector.err()])),
    };
    let composition = compose(&p.tagged, &q.tagged, vector)
        .map_err(|_| vec![Fault::zero_quaternion(p.span).in_field(Field::P)])?;

    let mut notes = p.notes(Field::P);
    notes.extend(q.notes(Field::Q));
    notes.extend(composition.out_of_range.map(|out_of_range| Note {
        field: Field::P,
        fact: Fact::OutOfRange(out_of_range),
    }));
    if composition
        .products
        .iter()
        .any(|product| product.images.is_none())
    {
        notes.push(Note {
            field: Field::Vector,
            fact: Fact::OutOfRange(OutOfRange {
                what: OutOfRangeNumber::Image,
            }),
        });
    }
    Ok(ComposeReport {
        p: p.as_read(),
        q: q.as_read(),
        vector: coordinates(&vector),
        products: composition.products,
        order_matters: composition.order_matters,
        notes,
    })
}

fn problems<const COUNT: usize>(found: [Option<Problem>; COUNT]) -> Vec<Problem> {
    found.into_iter().flatten().collect()
}

/// A quaternion that was read and is a rotation.
struct Attitude {
    parsed: ParsedQuaternion,
    declared: Convention,
    /// As typed, with the order that was used.
    tagged: TaggedQuaternion,
    rotation: Rotation,
    /// Where the text stands, without the white space around it.
    span: Span,
}

impl Attitude {
    fn of_text(text: &str, field: Field, declared: Convention) -> Result<Self, Problem> {
        let parsed = parse_quaternion(text, field, declared.order)?;
        let span = Span::of_trimmed(text);
        let tagged = TaggedQuaternion {
            components: parsed.quaternion,
            convention: Convention {
                order: parsed.order,
                ..declared
            },
        };
        match Rotation::from_tagged(&tagged) {
            Ok(rotation) => Ok(Self {
                parsed,
                declared,
                tagged,
                rotation,
                span,
            }),
            Err(_) => Err(Fault::zero_quaternion(span).in_field(field)),
        }
    }

    fn as_read(&self) -> ReadQuaternion {
        ReadQuaternion {
            components: Components::of(&self.tagged.components, self.parsed.order),
            order_source: self.parsed.order_source,
            convention: self.tagged.convention,
            norm: self.norm(),
        }
    }

    /// The norm as typed, where a double can hold it.
    fn norm(&self) -> Option<f64> {
        let norm = self.tagged.norm();
        norm.is_finite().then_some(norm)
    }

    fn column(&self, convention: Convention, vector: Vector3<f64>) -> Column {
        let quaternion = self.tagged.to_convention(convention);
        let unit = self.rotation.to_tagged(convention);
        let direction = convention.operator();
        let shown =
            |tagged: &TaggedQuaternion| Components::of(&tagged.components, convention.order);
        let matrix = self.rotation.matrix(direction);
        Column {
            convention,
            quaternion: shown(&quaternion),
            unit: shown(&unit),
            conjugate: shown(&quaternion.conjugate()),
            inverse: quaternion.inverse().as_ref().map(shown),
            matrix: rows3(&matrix),
            inverse_matrix: rows3(&matrix.transpose()),
            image: self
                .rotation
                .rotate_within_range(vector, direction)
                .as_ref()
                .map(coordinates),
            left_product_matrix: rows4(&unit.left_product_matrix()),
            right_product_matrix: rows4(&unit.right_product_matrix()),
        }
    }

    fn notes(&self, field: Field) -> Vec<Note> {
        let mut facts = Vec::new();
        facts.extend(self.order_fact());
        let norm = self.norm();
        let deviation = norm.map(|norm| norm - 1.0);
        if deviation.is_none_or(|deviation| deviation.abs() > UNIT_NORM_TOLERANCE) {
            facts.push(Fact::Normalised(Normalised { norm, deviation }));
        }
        if self.tagged.components.w < 0.0 {
            facts.push(Fact::NegativeScalar);
        }
        if self.rotation.axis().is_none() {
            facts.push(Fact::NoTurn);
        } else if self.rotation.to_tagged(self.declared).components.w.abs() <= HALF_TURN_SCALAR {
            facts.push(Fact::HalfTurn);
        }
        facts.into_iter().map(|fact| Note { field, fact }).collect()
    }

    fn order_fact(&self) -> Option<Fact> {
        let ParsedQuaternion {
            order,
            order_source: source,
            ..
        } = self.parsed;
        if source != OrderSource::Declared {
            let differs = order != self.declared.order;
            return differs.then_some(Fact::OrderFromText(OrderFromText { source, order }));
        }
        if let Some(name) = self.parsed.unknown_constructor.clone() {
            return Some(Fact::UnknownConstructor(UnknownConstructor { name, order }));
        }
        let differs_by = self.rotation.angle_to_rad(&self.read_in_other_order()?);
        Some(if differs_by <= UNIT_NORM_TOLERANCE {
            Fact::OrderInvisible
        } else {
            Fact::OrderAssumed(OrderAssumed {
                order,
                other_order_differs_by_deg: plain(differs_by.to_degrees()),
            })
        })
    }

    /// The attitude if the same four numbers stood in the other order.
    fn read_in_other_order(&self) -> Option<Rotation> {
        let Quaternion { coords } = self.tagged.components;
        let (w, x, y, z) = (coords.w, coords.x, coords.y, coords.z);
        let moved = match self.parsed.order {
            ComponentOrder::ScalarFirst => Quaternion::new(z, w, x, y),
            ComponentOrder::ScalarLast => Quaternion::new(x, y, z, w),
        };
        Rotation::from_tagged(&TaggedQuaternion {
            components: moved,
            ..self.tagged
        })
        .ok()
    }
}

fn rules(convention: Convention) -> Rules {
    let side = |is_left| if is_left { Side::Left } else { Side::Right };
    Rules {
        is_canonical: convention.component_sign() == ComponentSign::Canonical,
        operator: convention.operator(),
        labelled_first: side(convention.first_label_is_left()),
        chain_first: side(convention.first_in_chain_is_left()),
        increment: convention.increment_side(),
        body_rate: convention.rate_side(RateAxes::Body),
    }
}

fn euler(rotation: &Rotation, sequence: EulerSequence) -> Euler {
    let found = rotation.euler(sequence);
    let angles_rad = found
        .gimbal_lock
        .map_or(found.angles_rad, |lock| lock.canonical_rad);
    Euler {
        sequence,
        angles_rad: angles_rad.map(plain),
        angles_deg: angles_rad.map(|angle| plain(angle.to_degrees())),
        gimbal_lock: found.gimbal_lock.map(|lock| ReadGimbalLock {
            survivor: lock.survivor,
            survivor_deg: plain(lock.survivor_rad.to_degrees()),
            lost: sequence.lost_at_lock(),
            distance_deg: plain(lock.distance_rad.to_degrees()),
        }),
    }
}

fn turn(rotation: &Rotation) -> Turn {
    let angle_rad = rotation.angle_rad();
    Turn {
        gibbs_vector: rotation.gibbs_vector().as_ref().map(coordinates),
        modified_rodrigues_parameters: coordinates(&rotation.modified_rodrigues_parameters()),
        angle_rad: plain(angle_rad),
        angle_deg: plain(angle_rad.to_degrees()),
        axis: rotation.axis().as_ref().map(coordinates),
        rotation_vector_rad: coordinates(&rotation.rotation_vector_rad()),
    }
}
