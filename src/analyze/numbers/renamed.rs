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

/// What was seen beside an attitude.
enum Seen {
    /// In each order in which the four numbers may stand.
    Quaternion(Vec<(ComponentOrder, Rotation)>, Convention),
    /// A matrix body to world, the scale that was taken out, and how it was declared.
    Matrix(Matrix3<f64>, f64, Direction),
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
        let matrices: Vec<_> = orders
            .iter()
            .map(|(_, seen)| seen.body_to_world_matrix())
            .collect();
        Self::of(Seen::Quaternion(orders, convention), &matrices, attitude)
    }

    /// Of nine numbers, which a convention with this operator reads.
    pub(crate) fn of_matrix(seen: &SeenMatrix, attitude: &Rotation, operator: Direction) -> Self {
        let body_to_world = match operator {
            Direction::BodyToWorld => seen.turn,
            Direction::WorldToBody => seen.turn.transpose(),
        };
        let matrix = body_to_world * seen.scale.signum();
        let seen = Seen::Matrix(matrix, seen.scale.abs(), operator);
        Self::of(seen, &[matrix], attitude)
    }

    fn of(seen: Seen, matrices: &[Matrix3<f64>], attitude: &Rotation) -> Self {
        let mut renamed = Self {
            seen,
            ways: Vec::new(),
            candidates: Vec::new(),
        };
        for (place, matrix) in matrices.iter().enumerate() {
            for direction in Direction::ALL {
                renamed.add_all(place, matrix, direction, &attitude.matrix(direction));
            }
        }
        renamed
    }

    /// The plain ways, however far they lead off, and those over other axes that lead to the matrix.
    fn add_all(
        &mut self,
        place: usize,
        seen: &Matrix3<f64>,
        direction: Direction,
        described: &Matrix3<f64>,
    ) {
        let hand = if seen.determinant() > 0.0 {
            AxesHand::Kept
        } else {
            AxesHand::Changed
        };
        for mapping in AxisMapping::all() {
            let mut changes = [None, None];
            if mapping.hand() == hand && is_plain(mapping) {
                changes[0] = Some(AxesChange {
                    body: mapping,
                    ..AxesChange::NONE
                });
            }
            if mapping.hand() == AxesHand::Kept {
                // Of R A_Bᵀ = A_Wᵀ M.
                let body = seen.transpose() * mapping.matrix() * described;
                changes[1] = AxisMapping::nearest_to_matrix(&body)
                    .map(|body| {
                        with_fewest_signs(AxesChange {
                            world: mapping,
                            body,
                        })
                    })
                    .filter(|change| !(change.world == AxisMapping::NONE && is_plain(change.body)));
            }
            for change in changes.into_iter().flatten() {
                let way = Way {
                    place,
                    direction,
                    change,
                };
                let off_rad = angle_between_rad(&way.there(described), seen);
                if is_plain(change.body) && change.world == AxisMapping::NONE
                    || off_rad <= COARSEST_RAD
                {
                    self.candidates.push(way.candidate(off_rad));
                    self.ways.push(way);
                }
            }
        }
    }

    /// What the candidate at a place is; how far off it is, is known there.
    pub(crate) fn reading(&self, at: usize) -> Reading {
        let way = self.ways[at];
        let (world, body) = (way.world(), way.body());
        let (meaning, text) = match &self.seen {
            Seen::Quaternion(orders, convention) => {
                let (order, seen) = orders[way.place];
                let back = way.back(&seen.body_to_world_matrix());
                let text = back.map(|back| named(&back, *convention));
                (NumbersMeaning::Quaternion { order, world, body }, text)
            }
            Seen::Matrix(matrix, scale, operator) => {
                let back = way.back(matrix);
                let text = back.map(|back| rows_text(&rows3(&back.matrix(*operator))));
                let scale = *scale;
                (NumbersMeaning::Matrix { scale, world, body }, text)
            }
        };
        Reading {
            meaning,
            direction: way.direction,
            off_deg: 0.0,
            text,
        }
    }
}

/// Whether the axes are as they were, but for one that is reversed, or for all.
fn is_plain(axes: AxisMapping) -> bool {
    axes.keeps_places() && axes.reversed_axes() != 2
}

/// The same with both matrices times −1, where that reverses fewer axes.
fn with_fewest_signs(change: AxesChange) -> AxesChange {
    let opposite = AxesChange {
        world: change.world.opposite(),
        body: change.body.opposite(),
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

impl Way {
    /// What the attitude becomes, or its inverse.
    fn there(&self, described: &Matrix3<f64>) -> Matrix3<f64> {
        self.change.world.matrix() * described * self.change.body.matrix().transpose()
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

    fn world(&self) -> Option<OtherAxes> {
        self.other_axes(self.change.world, self.change.world)
    }

    fn body(&self) -> Option<OtherAxes> {
        self.other_axes(self.change.body, self.change.body.inverse())
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
