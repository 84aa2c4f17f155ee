//! Four or nine numbers as an attitude, or as one on other axes: renamed or reversed, in the world, in the
//! body, or in both.
//!
//! Every signed permutation of the four numbers of a quaternion is one of these, and so is every matrix
//! whose rows and columns were exchanged or changed their signs.

use crate::analyze::numbers::candidate::{COARSEST_RAD, Candidate, HALF_UNIT_RAD};
use crate::analyze::numbers::printed::SeenMatrix;
use crate::analyze::plain_numbers::{plain, rows3};
use crate::contract::{NumbersMeaning, OtherAxes, Reading};
use crate::convention::order::ComponentOrder;
use crate::convention::{Convention, Direction};
use crate::frames::axis_mapping::{AxesChange, AxesHand, AxisMapping};
use crate::rotation::Rotation;
use crate::rotation::distance::angle_between_rad;
use crate::rotation::nearest::nearest;
use crate::text::mend::{exact, rows_text};
use nalgebra::Matrix3;

/// The readings of four numbers, in each order that they may have.
pub(crate) fn of_quaternion(
    seen: &[(ComponentOrder, Rotation)],
    attitude: &Rotation,
    convention: Convention,
) -> Vec<Candidate> {
    let mut candidates = Vec::new();
    for (place, (order, rotation)) in (0..).zip(seen) {
        let matrix = rotation.body_to_world_matrix();
        for way in ways(attitude, &matrix) {
            let meaning = NumbersMeaning::Quaternion {
                order: *order,
                world: way.world(),
                body: way.body(),
            };
            // Another order is the same as other axes on both sides, which nobody means by it.
            let class = if way.change == AxesChange::NONE {
                place
            } else {
                2 + place
            };
            let text = way.back(&matrix).map(|back| named(&back, convention));
            candidates.push(way.candidate(meaning, class, text));
        }
    }
    candidates
}

/// The readings of nine numbers, which a convention with this operator reads.
pub(crate) fn of_matrix(
    seen: &SeenMatrix,
    attitude: &Rotation,
    operator: Direction,
) -> Vec<Candidate> {
    let body_to_world = |matrix: Matrix3<f64>| match operator {
        Direction::BodyToWorld => matrix,
        Direction::WorldToBody => matrix.transpose(),
    };
    let matrix = body_to_world(seen.turn) * seen.scale.signum();
    let candidate = |way: Way| {
        let meaning = NumbersMeaning::Matrix {
            scale: seen.scale.abs(),
            world: way.world(),
            body: way.body(),
        };
        let back = way.back(&matrix);
        let text = back.map(|back| rows_text(&rows3(&back.matrix(operator))));
        let class = u8::from(way.change != AxesChange::NONE);
        way.candidate(meaning, class, text)
    };
    ways(attitude, &matrix).into_iter().map(candidate).collect()
}

/// One way from an attitude to a matrix: `A_W R A_Bᵀ` of the attitude R, or of its inverse.
struct Way {
    direction: Direction,
    change: AxesChange,
    off_rad: f64,
}

/// The plain ways, however far they lead off, and those over other axes that lead to the matrix.
fn ways(attitude: &Rotation, seen: &Matrix3<f64>) -> Vec<Way> {
    let hand = if seen.determinant() > 0.0 {
        AxesHand::Kept
    } else {
        AxesHand::Changed
    };
    let mut ways = Vec::new();
    for direction in Direction::ALL {
        let described = attitude.matrix(direction);
        let way = |change: AxesChange| {
            let there = change.world.matrix() * described * change.body.matrix().transpose();
            Way {
                direction,
                change,
                off_rad: angle_between_rad(&there, seen),
            }
        };
        let plain = AxisMapping::all().filter(|body| body.hand() == hand && is_plain(*body));
        ways.extend(plain.map(|body| {
            way(AxesChange {
                body,
                ..AxesChange::NONE
            })
        }));
        for world in AxisMapping::all().filter(|world| world.hand() == AxesHand::Kept) {
            // Of R A_Bᵀ = A_Wᵀ M.
            let left = described.transpose() * world.matrix().transpose() * seen;
            let Some(body) = AxisMapping::nearest_to_matrix(&left.transpose()) else {
                continue;
            };
            let change = with_fewest_signs(AxesChange { world, body });
            let is_new = !(change.world == AxisMapping::NONE && is_plain(change.body));
            let way = way(change);
            if is_new && way.off_rad <= COARSEST_RAD {
                ways.push(way);
            }
        }
    }
    ways
}

/// Whether the axes are as they were, but for one that is reversed, or for all.
fn is_plain(axes: AxisMapping) -> bool {
    let unsigned = axes.matrix().abs();
    unsigned == Matrix3::identity() && axes.reversed_axes() != 2
}

/// The same with both matrices times −1, where that reverses fewer axes.
fn with_fewest_signs(change: AxesChange) -> AxesChange {
    let opposite = AxesChange {
        world: change.world.opposite(),
        body: change.body.opposite(),
    };
    let reversed = |change: &AxesChange| change.world.reversed_axes() + change.body.reversed_axes();
    if reversed(&opposite) < reversed(&change) {
        opposite
    } else {
        change
    }
}

impl Way {
    fn world(&self) -> Option<OtherAxes> {
        self.other_axes(self.change.world, self.change.world)
    }

    fn body(&self) -> Option<OtherAxes> {
        self.other_axes(self.change.body, self.change.body.inverse())
    }

    /// Both sides change the hand, or none, so that each is a turn; or there is none.
    fn other_axes(&self, axes: AxisMapping, factor: AxisMapping) -> Option<OtherAxes> {
        let is_turn = self.change.world.hand() == self.change.body.hand();
        (axes != AxisMapping::NONE).then(|| OtherAxes {
            axes: axes.to_string(),
            factor: is_turn.then(|| factor.turn_in_words()),
        })
    }

    /// The attitude that was seen, on the axes of the attitude itself.
    fn back(&self, seen: &Matrix3<f64>) -> Option<Rotation> {
        let AxesChange { world, body } = self.change;
        let back = nearest(&(world.matrix().transpose() * seen * body.matrix()))?;
        Some(match self.direction {
            Direction::BodyToWorld => back,
            Direction::WorldToBody => back.inverse(),
        })
    }

    /// The simplest first: other axes on one side or the same on both, then few that are reversed.
    fn candidate(self, meaning: NumbersMeaning, class: u8, text: Option<String>) -> Candidate {
        let AxesChange { world, body } = self.change;
        let is_different = world != body && world != AxisMapping::NONE && body != AxisMapping::NONE;
        let inverse = u8::from(self.direction == Direction::WorldToBody);
        Candidate {
            class,
            rank: 16 * u8::from(is_different)
                + 2 * (world.reversed_axes() + body.reversed_axes())
                + inverse,
            half_unit_rad: HALF_UNIT_RAD,
            off_rad: self.off_rad,
            reading: Reading {
                meaning,
                direction: self.direction,
                off_deg: self.off_rad.to_degrees(),
                text,
            },
        }
    }
}

/// The four numbers by name, so that no order is to be declared.
fn named(rotation: &Rotation, convention: Convention) -> String {
    let q = rotation.to_tagged(convention).components;
    let [w, x, y, z] = [q.w, q.i, q.j, q.k].map(|number| exact(plain(number)));
    format!("w: {w}, x: {x}, y: {y}, z: {z}")
}
