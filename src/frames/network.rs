//! What is known between frames, as a network: every pose that follows from it, the path to each, and the
//! loops that have to close.

use crate::convention::Direction;
use crate::rotation::Rotation;
use nalgebra::Vector3;

/// Nearer than this, in radians and relative to the lengths on the way, a loop closes but for rounding.
const CLOSED: f64 = 1e-9;

/// In so many open loops it is looked for what would close them; it takes the square of their length.
const MOST_LOOKED: usize = 4;

/// A row is taken for turned round where that leaves a loop a tenth as open.
const MUCH_NEARER: f64 = 0.1;

/// Where a frame stands in another: `ᴾR_C`, and the origin `ᴾp_C` where it is known.
#[derive(Clone, Copy)]
pub(crate) struct Placement {
    pub(crate) rotation: Rotation,
    /// Absent where it is not known, or where a double cannot hold it.
    pub(crate) origin: Option<Vector3<f64>>,
}

/// The pose of a child in a parent, both by their places in a list of frames.
pub(crate) struct Link {
    pub(crate) parent: usize,
    pub(crate) child: usize,
    pub(crate) pose: Placement,
}

/// One step of a path.
#[derive(Clone, Copy)]
pub(crate) struct Step {
    /// The place of its link.
    pub(crate) link: usize,
    /// Whether it leads from the child of the link to its parent.
    pub(crate) is_inverse: bool,
    /// The frame that it leads to.
    pub(crate) to: usize,
    from: usize,
}

/// A frame that is joined to a root.
#[derive(Clone, Copy)]
pub(crate) struct Joined {
    pub(crate) root: usize,
    /// Its pose in the root.
    pub(crate) pose: Placement,
    /// The last step of the path to it; absent at the root.
    last: Option<Step>,
}

/// A link beyond those that suffice, and how far it is from what the others say.
pub(crate) struct Loop {
    pub(crate) link: usize,
    /// From its parent to its child, over the other links.
    pub(crate) path: Vec<Step>,
    pub(crate) angle_rad: f64,
    /// Absent where a position on the way is not known.
    pub(crate) distance: Option<f64>,
    /// The link whose inverse closes it.
    pub(crate) inverse_closes: Option<usize>,
    /// The link that closes it with the inverse of its rotation and its position as it is.
    pub(crate) transpose_closes: Option<usize>,
}

impl Placement {
    fn identity() -> Self {
        Self {
            rotation: Rotation::identity(),
            origin: Some(Vector3::zeros()),
        }
    }

    /// The inverse with the position only taken back, and not turned: `−ᴾp_C` for `ᶜp_P`, as Yoosefian 2021
    /// prints it at the end of the path over the cameras (section 2, `ᴳp_I2`).
    pub(crate) fn misprinted_inverse(&self) -> Self {
        Self {
            rotation: self.rotation.inverse(),
            origin: self.origin.map(|origin| -origin),
        }
    }

    /// The coordinates in the parent of a point given in the child.
    pub(crate) fn point(&self, point: Vector3<f64>) -> Option<Vector3<f64>> {
        finite(self.rotation.body_to_world(point) + self.origin?)
    }

    /// `ᴬR_C = ᴬR_B ᴮR_C` and `ᴬp_C = ᴬp_B + ᴬR_B ᴮp_C` (Yoosefian 2021, section 2).
    pub(crate) fn then(&self, next: &Self) -> Self {
        Self {
            rotation: self.rotation * next.rotation,
            origin: next.origin.and_then(|origin| self.point(origin)),
        }
    }

    /// `ᶜR_P = (ᴾR_C)ᵀ` and `ᶜp_P = −ᶜR_P ᴾp_C`.
    pub(crate) fn inverse(&self) -> Self {
        let back = |origin: Vector3<f64>| self.rotation.rotate(-origin, Direction::WorldToBody);
        Self {
            rotation: self.rotation.inverse(),
            origin: self.origin.map(back).and_then(finite),
        }
    }

    fn transposed(&self) -> Self {
        Self {
            rotation: self.rotation.inverse(),
            ..*self
        }
    }
}

fn finite(vector: Vector3<f64>) -> Option<Vector3<f64>> {
    let is_finite = vector.iter().all(|number| number.is_finite());
    is_finite.then_some(vector)
}

/// Every frame with its pose in a root: the first frame of the list, and of those that are not joined to it
/// the first that is left. Each by a path of the fewest steps.
pub(crate) fn joined(links: &[Link], frames: usize) -> Vec<Joined> {
    let mut found = Vec::new();
    let mut is_found = Vec::new();
    for root in 0..frames {
        let pose = Placement::identity();
        found.push(Joined {
            root,
            pose,
            last: None,
        });
        is_found.push(false);
    }
    for root in 0..frames {
        if is_found[root] {
            continue;
        }
        is_found[root] = true;
        let mut waiting = vec![root];
        let mut next = 0;
        while let Some(&from) = waiting.get(next) {
            next += 1;
            for (link, Link { parent, child, .. }) in links.iter().enumerate() {
                let is_inverse = *child == from;
                let to = if is_inverse { *parent } else { *child };
                if (!is_inverse && *parent != from) || is_found[to] {
                    continue;
                }
                is_found[to] = true;
                let last = Step {
                    link,
                    is_inverse,
                    to,
                    from,
                };
                let pose = found[from].pose.then(&last.pose(&links[link].pose));
                found[to] = Joined {
                    root,
                    pose,
                    last: Some(last),
                };
                waiting.push(to);
            }
        }
    }
    found
}

impl Step {
    /// The pose that it leads over, of that which its link is given.
    pub(crate) fn pose(&self, given: &Placement) -> Placement {
        if self.is_inverse {
            given.inverse()
        } else {
            *given
        }
    }
}

/// The steps from one frame to another that is joined to the same root.
pub(crate) fn path(joined: &[Joined], from: usize, to: usize) -> Vec<Step> {
    let mut up = above(joined, from);
    let mut down = above(joined, to);
    // What both have in common lies at their ends.
    while let (Some(one), Some(other)) = (up.last(), down.last())
        && one.link == other.link
    {
        up.pop();
        down.pop();
    }
    let mut path = Vec::new();
    for step in up {
        path.push(Step {
            is_inverse: !step.is_inverse,
            to: step.from,
            from: step.to,
            ..step
        });
    }
    while let Some(step) = down.pop() {
        path.push(step);
    }
    path
}

/// The steps that lead to a frame, the last one first.
fn above(joined: &[Joined], frame: usize) -> Vec<Step> {
    let mut steps = Vec::new();
    let mut at = frame;
    while let Some(step) = joined[at].last {
        steps.push(step);
        at = step.from;
    }
    steps
}

/// The pose at the end of a path, of the pose that each step has.
pub(crate) fn along(path: &[Step], pose_of: &dyn Fn(&Step) -> Placement) -> Placement {
    let mut pose = Placement::identity();
    for step in path {
        pose = pose.then(&pose_of(step));
    }
    pose
}

/// The angle by which a link is off the path over the others, and the distance, where one of all of them is
/// another than it is given.
fn off(
    links: &[Link],
    (link, path): (usize, &[Step]),
    changed: usize,
    change: fn(&Placement) -> Placement,
) -> (f64, Option<f64>) {
    let given = |link: usize| {
        let given = &links[link].pose;
        if link == changed {
            change(given)
        } else {
            *given
        }
    };
    let by_path = along(path, &|step| step.pose(&given(step.link)));
    let by_link = given(link);
    let angle_rad = by_link.rotation.angle_to_rad(&by_path.rotation);
    let origins = by_link.origin.zip(by_path.origin);
    let distance = origins.map(|(one, other)| (one - other).norm());
    (angle_rad, distance.filter(|distance| distance.is_finite()))
}

/// Every loop: one for each link that is no step to any frame.
pub(crate) fn loops(links: &[Link], joined: &[Joined]) -> Vec<Loop> {
    let mut loops = Vec::new();
    let mut looked = 0;
    for (link, Link { parent, child, .. }) in links.iter().enumerate() {
        let leads_to = |frame: usize| joined[frame].last.is_some_and(|step| step.link == link);
        if leads_to(*parent) || leads_to(*child) {
            continue;
        }
        let path = path(joined, *parent, *child);
        let (angle_rad, distance) = off(links, (link, &path), links.len(), Placement::inverse);
        let mut length = 0.0;
        for step in &path {
            length += links[step.link]
                .pose
                .origin
                .map_or(0.0, |origin| origin.norm());
        }
        let least = [CLOSED, CLOSED * length];
        let far = distance.unwrap_or_default();
        let is_open = (angle_rad > least[0] || far > least[1]) && looked < MOST_LOOKED;
        looked += usize::from(is_open);
        let mut closes = [None; 2];
        let changes = [Placement::inverse, Placement::transposed];
        for place in 0..=path.len() {
            if !is_open {
                break;
            }
            let changed = path.get(place).map_or(link, |step| step.link);
            for (found, change) in closes.iter_mut().zip(changes) {
                let (angle, left) = off(links, (link, &path), changed, change);
                let is_closed = angle <= MUCH_NEARER * angle_rad + least[0]
                    && left.unwrap_or_default() <= MUCH_NEARER * far + least[1];
                if is_closed && found.is_none() {
                    *found = Some(changed);
                }
            }
        }
        let [inverse_closes, transpose_closes] = closes;
        loops.push(Loop {
            link,
            path,
            angle_rad,
            distance,
            inverse_closes,
            transpose_closes,
        });
    }
    loops
}
