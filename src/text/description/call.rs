//! Calls of known libraries that make a rotation of something else than four numbers.

use crate::convention::angle::AngleUnit;
use crate::convention::euler_sequence::{EulerFrame, EulerSequence};
use crate::problem::fault::Fault;
use crate::problem::{Span, Wanted};
use crate::text::description;
use crate::text::description::angle::{Angle, UnitRule};
use crate::text::description::axis::{alone, axis_of_node, letter_axis};
use crate::text::description::label;
use crate::text::description::list::held;
use crate::text::description::matrix;
use crate::text::description::named_members::component;
use crate::text::description::vector::vector;
use crate::text::description::{
    ParsedRotation, THREE_ANGLES, THREE_NUMBERS, euler_angles, rotation_vector, three,
};
use crate::text::grammar::tree::{Entry, Key, Node, NodeKind};
use crate::text::vocabulary::calls::{
    self,
    Takes::{
        self, AngleThenAxis, Angles, AnglesThenAxes, AnyAxisThenAngle, AxisThenAngle, Matrix,
        ModifiedRodrigues, Rotation, RotationVector, RowsOrColumns, SequenceThenAngles, ThreeEuler,
    },
};
use crate::text::vocabulary::constructors::{self, Call};
use crate::text::vocabulary::phrases::euler_sequence;

/// How far from 1 the length of an axis may be that was rounded to three decimals.
const ROUNDED_LENGTH: f64 = 1e-3;

/// How many calls inside each other are looked through; the brackets themselves are limited too.
const MOST_CALLS: usize = 8;

/// The rotation that one call makes, perhaps under a label or inside another constructor.
pub(crate) fn rotation(entries: &[Entry<'_>]) -> Result<Option<ParsedRotation>, Fault> {
    // Without the feature `whole` there is no call.
    if !cfg!(feature = "whole") {
        return Ok(None);
    }
    let Some((mut node, labels)) = named_node(entries) else {
        return Ok(None);
    };
    for _ in 0..MOST_CALLS {
        let NodeKind::Call {
            name, arguments, ..
        } = &node.kind
        else {
            return Ok(None);
        };
        let call = RotationCall::of(name, arguments, node.span);
        if let Some(rotation) = call.rotation()? {
            for key in labels {
                label::check(key.name, key.span, Wanted::Quaternion)?;
            }
            return Ok(Some(rotation));
        }
        match call.only_argument() {
            Some(inner) => node = inner,
            None => return Ok(None),
        }
    }
    Ok(None)
}

/// The only node of a text, perhaps under names, in braces too: `{"q": Quaternion(…)}`; and these names.
fn named_node<'e, 't>(mut entries: &'e [Entry<'t>]) -> Option<(&'e Node<'t>, Vec<Key<'t>>)> {
    let mut labels = Vec::new();
    while let [only] = entries
        && only.key.is_none_or(|key| component(key.name).is_none())
    {
        labels.extend(only.key);
        match &only.node.kind {
            NodeKind::List(inner) => entries = inner,
            _ => return Some((&only.node, labels)),
        }
    }
    None
}

struct RotationCall<'e, 't> {
    name: &'t str,
    takes: Option<Takes>,
    positional: Vec<&'e Node<'t>>,
    named: Vec<(Key<'t>, &'e Node<'t>)>,
    span: Span,
}

impl<'e, 't> RotationCall<'e, 't> {
    fn of(name: &'t str, arguments: &'e [Entry<'t>], span: Span) -> Self {
        let (mut positional, mut named) = (Vec::new(), Vec::new());
        for entry in arguments {
            match entry.key {
                Some(key) => named.push((key, &entry.node)),
                None => positional.push(&entry.node),
            }
        }
        Self {
            name,
            takes: calls::takes(name)
                .or_else(|| constructors::is_matrix(name).then_some(RowsOrColumns)),
            positional,
            named,
            span,
        }
    }

    /// The one call inside a constructor, which makes the same rotation.
    fn only_argument(&self) -> Option<&'e Node<'t>> {
        let makes_a_quaternion = matches!(
            constructors::call(self.name),
            Call::Ordered(_) | Call::Unordered
        );
        let keeps =
            makes_a_quaternion || matches!(self.takes, Some(Matrix | RowsOrColumns | Rotation));
        match self.positional[..] {
            [inner] if keeps && self.named.is_empty() => Some(inner),
            _ => None,
        }
    }

    fn rotation(&self) -> Result<Option<ParsedRotation>, Fault> {
        let makes_a_quaternion = matches!(
            constructors::call(self.name),
            Call::Ordered(_) | Call::Unordered
        );
        // pyquaternion: Quaternion(axis=[0, 0, 1], degrees=90), Quaternion(matrix=…)
        if makes_a_quaternion && self.named("axis").is_some() {
            return self.by_names().map(Some);
        }
        if makes_a_quaternion
            && let (Some(matrix), []) = (self.named("matrix"), &self.positional[..])
        {
            self.check_names(&["matrix"])?;
            return matrix_of(matrix).map(Some);
        }
        let Some(takes) = self.takes else {
            return Ok(None);
        };
        let rotation = match takes {
            AngleThenAxis => {
                self.check_names(&[])?;
                let [angle, axis] = self.positional[..] else {
                    return Err(self.arguments("an angle in radians and an axis"));
                };
                self.axis_angle(axis, angle, takes)
            }
            AxisThenAngle | AnyAxisThenAngle => match self.positional[..] {
                [axis, angle] if held(axis).is_some() || !makes_a_quaternion => {
                    self.check_names(&[])?;
                    self.axis_angle(axis, angle, takes)
                }
                _ if makes_a_quaternion => return Ok(None),
                _ => return Err(self.arguments("an axis and an angle in radians")),
            },
            RotationVector => {
                self.check_names(&["degrees"])?;
                let angles = self.three(&self.positional, THREE_NUMBERS)?;
                rotation_vector(angles, self.unit()?)
            }
            ModifiedRodrigues => {
                self.check_names(&[])?;
                let entries = all_alone(&self.positional);
                vector(&entries, self.span).map(ParsedRotation::ModifiedRodrigues)
            }
            SequenceThenAngles => self.sequence_then_angles(),
            AnglesThenAxes => self.angles_then_axes(),
            ThreeEuler => self.three_euler(),
            Angles(sequence) => {
                self.check_names(&[])?;
                euler_angles(
                    sequence,
                    self.three(&self.positional, THREE_ANGLES)?,
                    RADIANS,
                )
            }
            Matrix | RowsOrColumns if self.holds_a_call_to_look_into() => return Ok(None),
            RowsOrColumns => return Err(Fault::rows_or_columns(self.span, self.name)),
            Matrix => {
                self.check_names(&["dtype"])?;
                let entries = all_alone(&self.positional);
                matrix::matrix(&entries, self.span).map(ParsedRotation::Matrix)
            }
            Rotation => return Ok(None),
        };
        rotation.map(Some)
    }

    /// `Eigen::Matrix3d(Eigen::AngleAxisd(…))`
    fn holds_a_call_to_look_into(&self) -> bool {
        matches!(self.positional[..], [inner] if matches!(inner.kind, NodeKind::Call { .. }) && held(inner).is_none())
    }

    fn named(&self, name: &str) -> Option<&'e Node<'t>> {
        let found = self.named.iter().find(|(key, _)| key.name == name);
        found.map(|(_, node)| *node)
    }

    /// Every name that is not among these may change the numbers.
    fn check_names(&self, known: &[&str]) -> Result<(), Fault> {
        match self
            .named
            .iter()
            .find(|(key, _)| !known.contains(&key.name))
        {
            Some((key, _)) => Err(Fault::unknown_argument(key.span, key.name)),
            None => Ok(()),
        }
    }

    fn arguments(&self, expected: &str) -> Fault {
        Fault::unknown_arguments(self.span, self.name, expected)
    }

    fn axis_angle(
        &self,
        axis: &Node<'_>,
        angle: &Node<'_>,
        takes: Takes,
    ) -> Result<ParsedRotation, Fault> {
        let angle = (angle.angle()?, angle.span);
        let vector = axis_of_node(axis)?;
        let is_unit = (vector.norm() - 1.0).abs() <= ROUNDED_LENGTH;
        if takes != AnyAxisThenAngle && !is_unit {
            return Err(Fault::axis_not_normalised(axis.span, self.name));
        }
        description::axis_angle(vector, angle, RADIANS)
    }

    fn by_names(&self) -> Result<ParsedRotation, Fault> {
        self.check_names(&["axis", "angle", "radians", "degrees"])?;
        let angles = (
            self.named("angle"),
            self.named("radians"),
            self.named("degrees"),
        );
        let (angle, unit) = match angles {
            (Some(angle), None, None) => (angle, RADIANS),
            (None, Some(angle), None) => (angle, UnitRule::ForAll(AngleUnit::Radians)),
            (None, None, Some(angle)) => (angle, UnitRule::ForAll(AngleUnit::Degrees)),
            _ => return Err(self.arguments("axis= and one of degrees=, radians=, angle=")),
        };
        let (Some(axis), []) = (self.named("axis"), &self.positional[..]) else {
            return Err(self.arguments("axis= and one of degrees=, radians=, angle="));
        };
        let angle = (angle.angle()?, angle.span);
        description::axis_angle(axis_of_node(axis)?, angle, unit)
    }

    fn three(&self, nodes: &[&Node<'_>], what: &str) -> Result<[Angle; 3], Fault> {
        three(&all_alone(nodes), self.span, what)
    }

    /// Radians, or degrees where `degrees=True` says so.
    fn unit(&self) -> Result<UnitRule, Fault> {
        let Some(node) = self.named("degrees") else {
            return Ok(RADIANS);
        };
        match node.truth() {
            Some(true) => Ok(UnitRule::Library(AngleUnit::Degrees)),
            Some(false) => Ok(UnitRule::ForAll(AngleUnit::Radians)),
            None => Err(Fault::unknown_argument(node.span, "degrees")),
        }
    }

    fn sequence_then_angles(&self) -> Result<ParsedRotation, Fault> {
        self.check_names(&["degrees", "seq", "angles"])?;
        let mut nodes = Vec::new();
        nodes.extend(self.named("seq"));
        nodes.extend(self.positional.iter().copied());
        nodes.extend(self.named("angles"));
        let Some((sequence, angles)) = nodes.split_first() else {
            return Err(Fault::no_sequence(self.span));
        };
        let NodeKind::Word(letters) = sequence.kind else {
            return Err(Fault::no_sequence(sequence.span));
        };
        if let (Some(axis), [angle]) = (single_axis(sequence), angles) {
            let angle = (angle.angle()?, angle.span);
            return description::axis_angle(axis, angle, self.unit()?);
        }
        let sequence = match letters.split_once("EulerRot::") {
            Some((_, letters)) => {
                let extrinsic = letters.strip_suffix("Ex");
                let frame = match extrinsic {
                    Some(_) => EulerFrame::Extrinsic,
                    None => EulerFrame::Intrinsic,
                };
                euler_sequence(extrinsic.unwrap_or(letters), sequence.span, Some(frame))?
            }
            None => euler_sequence(letters, sequence.span, None)?,
        };
        euler_angles(sequence, self.three(angles, THREE_ANGLES)?, self.unit()?)
    }

    fn angles_then_axes(&self) -> Result<ParsedRotation, Fault> {
        self.check_names(&["axes"])?;
        let (angles, letters) = self.with_letters("axes");
        let sequence = match letters {
            Some((letters, span)) => euler_sequence(letters, span, None)?,
            None => EulerSequence::ROLL_PITCH_YAW,
        };
        euler_angles(sequence, self.three(angles, THREE_ANGLES)?, RADIANS)
    }

    /// `THREE.Euler(x, y, z, "ZYX")`: the angles stand in the order x, y, z whatever the sequence.
    fn three_euler(&self) -> Result<ParsedRotation, Fault> {
        self.check_names(&[])?;
        let (angles, letters) = self.with_letters("order");
        let (letters, span) = letters.unwrap_or(("XYZ", self.span));
        let sequence = euler_sequence(letters, span, None)?;
        let by_axis = self.three(angles, THREE_ANGLES)?;
        let [one, two, three] = sequence.axes.places();
        if sequence.is_proper() || sequence.frame == EulerFrame::Extrinsic {
            return Err(self.arguments("three angles and three different letters, as in 'XYZ'"));
        }
        let angles = [by_axis[one], by_axis[two], by_axis[three]];
        euler_angles(sequence, angles, RADIANS)
    }

    /// The angles, and the letters that stand after them or under this name.
    fn with_letters(&self, name: &str) -> (&[&'e Node<'t>], Option<(&'t str, Span)>) {
        let letters = |node: &Node<'t>| match node.kind {
            NodeKind::Word(letters) => Some((letters, node.span)),
            _ => None,
        };
        let by_name = self.named(name).and_then(letters);
        match self.positional.split_last() {
            Some((last, angles)) if by_name.is_none() && letters(last).is_some() => {
                (angles, letters(last))
            }
            _ => (&self.positional, by_name),
        }
    }
}

const RADIANS: UnitRule = UnitRule::Library(AngleUnit::Radians);

/// `'z'`, as in `from_euler('z', 90, degrees=True)`
fn single_axis(node: &Node<'_>) -> Option<nalgebra::Vector3<f64>> {
    match node.kind {
        NodeKind::Word(word) => letter_axis(word),
        _ => None,
    }
}

fn matrix_of(node: &Node<'_>) -> Result<ParsedRotation, Fault> {
    matrix::matrix(&[alone(node)], node.span).map(ParsedRotation::Matrix)
}

fn all_alone<'t>(nodes: &[&Node<'t>]) -> Vec<Entry<'t>> {
    let mut entries = Vec::new();
    for node in nodes {
        entries.push(alone(node));
    }
    entries
}
