//! Four or nine numbers as an attitude, or as one on other axes: renamed or reversed, in the world, in the
//! body, or in both.
//!
//! Every signed permutation of the four numbers of a quaternion is one of these, and so is every matrix
//! whose rows and columns were exchanged or changed their signs.

use crate::analyze::numbers::candidate::{COARSEST_RAD, Candidate, HALF_UNIT_RAD};
use crate::analyze::plain_numbers::{plain, rows3};
use crate::contract::{NumbersMeaning, OtherAxes, Reading};
use crate::convention::order::ComponentOrder;
use crate::convention::{Convention, Direction};
use crate::frames::axis_mapping::{AxesChange, AxesHand, AxisMapping};
use crate::rotation::Rotation;
use crate::text::mend::number_text::{exact, rows_text};

/// What was seen beside an attitude, and how its numbers are declared.
enum Seen {
    /// In each order in which the four numbers may stand.
    Quaternion(Vec<(ComponentOrder, Rotation)>, Convention),
    /// The turn of a matrix and its scale, negative where it is a reflection.
    Matrix(Rotation, f64, Direction),
}

/// One way from an attitude R to what was seen: `A_W R A_Bᵀ`, of R or of its inverse.
#[derive(Clone, Copy)]
struct Way {
    /// Which of the orders; 0 of a matrix.
    place: usize,
    direction: Direction,
    change: AxesChange,
}

/// All readings of four or nine numbers, beside an attitude.
pub(crate) struct Renamed {
    seen: Seen,
    ways: Vec<Way>,
    pub(crate) candidates: Vec<Candidate>,
}

impl Renamed {
    pub(crate) fn of_quaternion(
        orders: Vec<(ComponentOrder, Rotation)>,
        attitude: &Rotation,
        convention: Convention,
    ) -> Self {
        Self::of(Seen::Quaternion(orders, convention), attitude)
    }

    /// Of nine numbers, which a convention with this operator reads: of a rotation body to world times a
    /// scale, which is negative for a reflection.
    pub(crate) fn of_matrix(
        turn: &Rotation,
        scale: f64,
        attitude: &Rotation,
        operator: Direction,
    ) -> Self {
        let turn = turned(turn, operator);
        Self::of(Seen::Matrix(turn, scale, operator), attitude)
    }

    fn of(seen: Seen, attitude: &Rotation) -> Self {
        let mut renamed = Self {
            seen,
            ways: Vec::new(),
            candidates: Vec::new(),
        };
        let mut turns = Vec::new();
        for axes in AxisMapping::all() {
            if axes.hand() == AxesHand::Kept {
                turns.push((axes, axes.turn()));
            }
        }
        for (place, (seen, hand)) in renamed.seen.turns().into_iter().enumerate() {
            for direction in Direction::ALL {
                let described = turned(attitude, direction);
                for (world, world_turn) in &turns {
                    // `A_W R A_Bᵀ` is what was seen where A_B is this.
                    let left = seen.inverse() * *world_turn * described;
                    let nearest = nearest_of(&turns, &left);
                    for (body, body_turn) in &turns {
                        let change = with_hand(*world, *body, hand);
                        if !is_plain(&change) && *body != nearest {
                            continue;
                        }
                        let off_rad = left.angle_to_rad(body_turn);
                        if is_plain(&change) || off_rad <= COARSEST_RAD {
                            let way = Way {
                                place,
                                direction,
                                change,
                            };
                            renamed.candidates.push(way.candidate(off_rad));
                            renamed.ways.push(way);
                        }
                    }
                }
            }
        }
        renamed
    }

    /// What the candidate at a place is; how far off it is, is known there.
    pub(crate) fn reading(&self, at: usize) -> Reading {
        let way = self.ways[at];
        let (meaning, text) = match &self.seen {
            Seen::Quaternion(orders, convention) => {
                let (order, seen) = orders[way.place];
                let text = named(&way.back(&seen), *convention);
                (NumbersMeaning::Quaternion { order }, text)
            }
            Seen::Matrix(turn, scale, operator) => {
                let rows = rows3(&way.back(turn).matrix(*operator));
                let scale = scale.abs();
                (NumbersMeaning::Matrix { scale }, rows_text(&rows))
            }
        };
        let AxesChange { world, body } = way.change;
        Reading {
            meaning,
            direction: way.direction,
            world: way.other_axes(world, world),
            body: way.other_axes(body, body.inverse()),
            off_deg: 0.0,
            text: Some(text),
        }
    }
}

impl Seen {
    /// The turn in each order, and the hand that the axes have on one side and not on the other.
    fn turns(&self) -> Vec<(Rotation, AxesHand)> {
        let mut turns = Vec::new();
        match self {
            Self::Quaternion(orders, _) => {
                for (_, turn) in orders {
                    turns.push((*turn, AxesHand::Kept));
                }
            }
            Self::Matrix(turn, scale, _) if *scale < 0.0 => turns.push((*turn, AxesHand::Changed)),
            Self::Matrix(turn, _, _) => turns.push((*turn, AxesHand::Kept)),
        }
        turns
    }
}

/// The axes whose turn is the nearest: the cosine of half the angle between is the largest.
fn nearest_of(turns: &[(AxisMapping, Rotation)], turn: &Rotation) -> AxisMapping {
    let mut nearest = (AxisMapping::NONE, 0.0);
    for (axes, other) in turns {
        let other = other.canonical().coords;
        let cosine = turn.canonical().coords.dot(&other).abs() / other.norm();
        if cosine > nearest.1 {
            nearest = (*axes, cosine);
        }
    }
    nearest.0
}

/// The attitude or its inverse.
fn turned(attitude: &Rotation, direction: Direction) -> Rotation {
    match direction {
        Direction::BodyToWorld => *attitude,
        Direction::WorldToBody => attitude.inverse(),
    }
}

/// The change by two turns, of which one side times −1 makes a reflection; both sides times −1 is the same, and
/// is taken where it reverses fewer axes.
fn with_hand(world: AxisMapping, body: AxisMapping, hand: AxesHand) -> AxesChange {
    let body = match hand {
        AxesHand::Kept => body,
        AxesHand::Changed => body.opposite(),
    };
    let change = AxesChange { world, body };
    let opposite = AxesChange {
        world: world.opposite(),
        body: body.opposite(),
    };
    if reversed_axes(&opposite) < reversed_axes(&change) {
        opposite
    } else {
        change
    }
}

fn reversed_axes(change: &AxesChange) -> u8 {
    change.world.reversed_axes() + change.body.reversed_axes()
}

/// Whether the axes are as they were, but for one of the body that is reversed, or for all.
fn is_plain(change: &AxesChange) -> bool {
    let hand_of_none = change.body.reversed_axes() != 2;
    change.world == AxisMapping::NONE && change.body.keeps_places() && hand_of_none
}

impl Way {
    /// The attitude that was seen, on the axes of the attitude itself.
    fn back(&self, seen: &Rotation) -> Rotation {
        let AxesChange { world, body } = self.change;
        turned(
            &(world.turn().inverse() * *seen * body.turn()),
            self.direction,
        )
    }

    /// The simplest first: other axes on one side or the same on both, then few that are reversed. Another
    /// order is the same as other axes on both sides, which nobody means by it.
    fn candidate(&self, off_rad: f64) -> Candidate {
        let AxesChange { world, body } = self.change;
        let is_none = |axes: AxisMapping| axes == AxisMapping::NONE;
        let place = u8::from(self.place > 0);
        let is_different = world != body && !is_none(world) && !is_none(body);
        let is_inverse = self.direction == Direction::WorldToBody;
        Candidate {
            off_rad,
            half_unit_rad: HALF_UNIT_RAD,
            class: if is_none(world) && is_none(body) {
                place
            } else {
                2 + place
            },
            rank: 16 * u8::from(is_different)
                + 2 * reversed_axes(&self.change)
                + u8::from(is_inverse),
        }
    }

    /// Where one side alone changes the hand, it has no factor that is a turn.
    fn other_axes(&self, axes: AxisMapping, factor: AxisMapping) -> Option<OtherAxes> {
        if axes == AxisMapping::NONE {
            return None;
        }
        let is_turn = self.change.world.hand() == self.change.body.hand();
        Some(OtherAxes {
            axes: axes.to_string(),
            factor: is_turn.then(|| factor.turn_in_words()),
        })
    }
}

/// The four numbers by name, so that no order is to be declared.
fn named(rotation: &Rotation, convention: Convention) -> String {
    let q = rotation.to_tagged(convention).components;
    let mut text = String::new();
    for (name, number) in [("w: ", q.w), (", x: ", q.i), (", y: ", q.j), (", z: ", q.k)] {
        text.push_str(name);
        text.push_str(&exact(plain(number)));
    }
    text
}
