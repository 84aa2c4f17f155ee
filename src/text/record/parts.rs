//! Numbers to a rotation and what stands beside it, as a list of parts says.

use crate::convention::angle::{AngleUnit, UnitSource, degrees_in_radians, turn_in_radians};
use crate::convention::euler_sequence::{EulerFrame, EulerSequence};
use crate::convention::order::{ComponentOrder, OrderSource};
use crate::text::description::quaternion::ParsedQuaternion;
use crate::text::description::{
    ParsedAxisAngle, ParsedEulerAngles, ParsedRotation, ParsedRotationVector,
};
use crate::text::record::format::{Angles, Letters, Part, Places, Unit};
use nalgebra::{Matrix3, Quaternion, Vector3};

/// Entries of two decimals are off by less.
const NEARLY_ORTHONORMAL: f64 = 0.05;

/// A norm this far from 1 is that of four numbers which are no rounded quaternion.
const NEARLY_UNIT: f64 = 0.05;

/// A full turn in radians as people round it.
const FULL_TURN_RAD: f64 = 6.29;

/// What the words of a text say of the numbers of a part.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Said<'s> {
    /// The order of four numbers, and how it was told.
    pub(crate) order: (ComponentOrder, OrderSource),
    /// The order that the text tells once for all.
    pub(crate) order_of_text: Option<ComponentOrder>,
    pub(crate) unit: Option<AngleUnit>,
    /// The sequence that a name tells.
    pub(crate) sequence: Option<EulerSequence>,
    /// The letters of a sequence that is told beside the numbers.
    pub(crate) letters: Option<&'s str>,
}

/// What a part is.
#[derive(Clone, Debug)]
pub(crate) enum Made {
    Rotation(ParsedRotation),
    /// A rotation of nine numbers that stood column by column.
    Columns(ParsedRotation),
    Position([f64; 3]),
    /// Where the body is, in the world.
    Centre([f64; 3]),
    Scale([f64; 3]),
    /// Euler angles of which no sequence is told.
    Angles([f64; 3], Option<AngleUnit>),
    Nothing,
}

/// What numbers are of which these are the parts; `None` where they are not: a quaternion that is not of
/// norm 1, a matrix that is no rotation.
pub(crate) fn made(parts: &[Part], numbers: &[f64], said: Said<'_>) -> Option<Vec<Made>> {
    let mut rest = numbers;
    let mut found = Vec::new();
    for part in parts {
        let (own, after) = rest.split_at_checked(part.count())?;
        rest = after;
        match part {
            Part::HomogeneousRows(_) | Part::HomogeneousColumns(_) => {
                found.extend(homogeneous(*part, own)?);
            }
            Part::Homogeneous(count) => {
                let rows = homogeneous(Part::HomogeneousRows(*count), own);
                let columns = || homogeneous(Part::HomogeneousColumns(*count), own);
                found.extend(rows.or_else(columns)?);
            }
            _ => found.push(one(*part, own, said)?),
        }
    }
    rest.is_empty().then_some(found)
}

fn one(part: Part, numbers: &[f64], said: Said<'_>) -> Option<Made> {
    let three = || <[f64; 3]>::try_from(numbers).ok();
    Some(match part {
        Part::Skip(_) => Made::Nothing,
        Part::Time if numbers[0].abs() < LEAST_NANOSECONDS => Made::Nothing,
        Part::Nanoseconds if numbers[0] >= LEAST_NANOSECONDS => Made::Nothing,
        Part::Time | Part::Nanoseconds => return None,
        Part::Position => Made::Position(three()?),
        Part::Centre => Made::Centre(three()?),
        Part::Scale => Made::Scale(three()?),
        Part::Quaternion(order) => {
            let order = order.map_or(said.order, |order| (order, OrderSource::Format));
            Made::Rotation(quaternion(numbers, order)?)
        }
        Part::ScaledQuaternion(order) => {
            let array = <[f64; 4]>::try_from(numbers).ok()?;
            let [w, x, y, z] = order.components(array);
            Made::Rotation(ParsedRotation::Quaternion(ParsedQuaternion {
                quaternion: Quaternion::new(w, x, y, z),
                order,
                order_source: match said.order {
                    (_, OrderSource::Named) => OrderSource::Named,
                    _ => OrderSource::Format,
                },
                unknown_constructor: None,
                is_announced: true,
                unexplained_label: None,
            }))
        }
        Part::Euler(angles) => Made::Rotation(euler(three()?, angles, said)?),
        Part::RotationVector(unit) => {
            let unit = said.unit.unwrap_or(unit);
            Made::Rotation(rotation_vector(three()?, UnitSource::Written(unit)))
        }
        Part::ModifiedRodrigues => {
            Made::Rotation(ParsedRotation::ModifiedRodrigues(three()?.into()))
        }
        Part::Imaginary => {
            let [x, y, z] = three()?;
            let scalar_squared = 1.0 - Vector3::new(x, y, z).norm_squared();
            let scalar = scalar_squared.max(0.0).sqrt();
            let order = (ComponentOrder::ScalarFirst, OrderSource::Format);
            Made::Rotation(quaternion(&[scalar, x, y, z], order)?)
        }
        Part::AxisAngle(unit) => axis_angle(&numbers[..3], numbers[3], unit, said)?,
        Part::UnitAxisAngle(unit) => {
            let length = |numbers: &[f64]| {
                numbers
                    .iter()
                    .map(|number| number * number)
                    .sum::<f64>()
                    .sqrt()
            };
            let is_it = (length(&numbers[..3]) - 1.0).abs() <= NEARLY_UNIT
                && (length(numbers) - 1.0).abs() > NEARLY_UNIT;
            is_it
                .then(|| axis_angle(&numbers[..3], numbers[3], unit, said))
                .flatten()?
        }
        Part::AngleAxis(unit) => axis_angle(&numbers[1..], numbers[0], unit, said)?,
        Part::XyAxes => {
            let x = Vector3::from_column_slice(&numbers[..3]).try_normalize(0.0)?;
            let along = Vector3::from_column_slice(&numbers[3..]);
            let y = (along - x * x.dot(&along)).try_normalize(0.0)?;
            Made::Rotation(ParsedRotation::Matrix(Matrix3::from_columns(&[
                x,
                y,
                x.cross(&y),
            ])))
        }
        Part::Rows => Made::Rotation(ParsedRotation::Matrix(orthonormal(
            Matrix3::from_row_slice(numbers),
        )?)),
        Part::Columns => Made::Columns(ParsedRotation::Matrix(orthonormal(
            Matrix3::from_column_slice(numbers),
        )?)),
        Part::HomogeneousRows(_) | Part::HomogeneousColumns(_) | Part::Homogeneous(_) => {
            return None;
        }
    })
}

pub(crate) fn quaternion(
    numbers: &[f64],
    (order, order_source): (ComponentOrder, OrderSource),
) -> Option<ParsedRotation> {
    let array = <[f64; 4]>::try_from(numbers).ok()?;
    let [w, x, y, z] = order.components(array);
    let quaternion = Quaternion::new(w, x, y, z);
    let is_unit = (quaternion.norm() - 1.0).abs() <= NEARLY_UNIT;
    is_unit.then_some(ParsedRotation::Quaternion(ParsedQuaternion {
        quaternion,
        order,
        order_source,
        unknown_constructor: None,
        is_announced: false,
        unexplained_label: None,
    }))
}

fn euler(numbers: [f64; 3], angles: Angles, said: Said<'_>) -> Option<ParsedRotation> {
    let sequence: EulerSequence = match (angles.letters, said.sequence, said.letters) {
        (Letters::Ignored, ..) | (_, None, None) => angles.sequence.parse().ok()?,
        (_, Some(sequence), _) => sequence,
        (_, None, Some(letters)) => told_sequence(letters, angles.letters)?,
    };
    let places = match angles.places {
        Places::Listed([one, two, three]) => {
            [usize::from(one), usize::from(two), usize::from(three)]
        }
        Places::ByAxis if sequence.is_proper() => return None,
        Places::ByAxis => sequence.axes.places(),
    };
    let unit = unit(angles.unit, &numbers, said);
    let mut angles_rad = [0.0; 3];
    for (at, angle_rad) in angles_rad.iter_mut().enumerate() {
        let sign = f64::from(angles.signs[at]);
        *angle_rad = sign * turn(numbers[places[at]], unit.unit());
    }
    Some(ParsedRotation::EulerAngles(ParsedEulerAngles {
        sequence,
        angles_rad,
        unit,
    }))
}

/// The sequence that letters are, by what they say of the axes.
fn told_sequence(written: &str, letters: Letters) -> Option<EulerSequence> {
    let sequence: EulerSequence = written.parse().ok()?;
    // Neither three.js nor Blender has a sequence that names an axis twice.
    if matches!(letters, Letters::AllMove | Letters::AllFixed) && sequence.is_proper() {
        return None;
    }
    let frame = match (letters, sequence.frame) {
        (Letters::CapitalsMove | Letters::Ignored, frame) => frame,
        (Letters::AllMove, _) | (Letters::SmallMove, EulerFrame::Extrinsic) => {
            EulerFrame::Intrinsic
        }
        (Letters::AllFixed, _) | (Letters::SmallMove, EulerFrame::Intrinsic) => {
            EulerFrame::Extrinsic
        }
    };
    Some(EulerSequence { frame, ..sequence })
}

/// The unit of angles: a word in the text, then the format's, then their size.
fn unit(unit: Unit, angles: &[f64], said: Said<'_>) -> UnitSource {
    let is_small = angles.iter().all(|angle| angle.abs() <= FULL_TURN_RAD);
    match (unit, said.unit) {
        (Unit::Always(unit), _) | (_, Some(unit)) | (Unit::Usually(unit), None) => {
            UnitSource::Written(unit)
        }
        (Unit::BySize, None) if is_small => UnitSource::Assumed(AngleUnit::Radians),
        (Unit::BySize, None) => UnitSource::Assumed(AngleUnit::Degrees),
    }
}

fn turn(angle: f64, unit: AngleUnit) -> f64 {
    match unit {
        AngleUnit::Degrees => turn_in_radians(angle),
        AngleUnit::Radians => angle,
    }
}

pub(crate) fn rotation_vector(numbers: [f64; 3], unit: UnitSource) -> ParsedRotation {
    let mut vector_rad = Vector3::from(numbers);
    if unit.unit() == AngleUnit::Degrees {
        for angle in &mut vector_rad {
            *angle = degrees_in_radians(*angle);
        }
    }
    ParsedRotation::RotationVector(ParsedRotationVector { vector_rad, unit })
}

fn axis_angle(axis: &[f64], angle: f64, unit_of_format: Unit, said: Said<'_>) -> Option<Made> {
    let axis = Vector3::from_column_slice(axis);
    let unit = unit(unit_of_format, &[angle], said);
    (axis.amax() > 0.0).then(|| {
        Made::Rotation(ParsedRotation::AxisAngle(ParsedAxisAngle {
            axis,
            angle_rad: turn(angle, unit.unit()),
            unit,
        }))
    })
}

/// The matrix, where it is nearly a rotation or a reflection: one that is refused with its reason.
pub(crate) fn orthonormal(matrix: Matrix3<f64>) -> Option<Matrix3<f64>> {
    let error = (matrix.transpose() * matrix - Matrix3::identity()).amax();
    (error <= NEARLY_ORTHONORMAL).then_some(matrix)
}

/// Twelve, fifteen or sixteen numbers: the rotation, and the translation where there is one.
fn homogeneous(part: Part, numbers: &[f64]) -> Option<Vec<Made>> {
    let is_columns = matches!(part, Part::HomogeneousColumns(_));
    // Column by column twelve numbers are four columns of three, sixteen four of four.
    let entry = |row: usize, column: usize| {
        let at = match (is_columns, numbers.len()) {
            (false, 15) => 5 * row + [2, 3, 4, 1][column],
            (false, _) => 4 * row + column,
            (true, 12) => 3 * column + row,
            (true, _) => 4 * column + row,
        };
        numbers[at]
    };
    if numbers.len() == 16 {
        for column in 0..4 {
            let expected = if column == 3 { 1.0 } else { 0.0 };
            if (entry(3, column) - expected).abs() > ROUNDED_ZERO {
                return None;
            }
        }
    }
    let (matrix, scale) = unscaled(Matrix3::from_fn(entry))?;
    let translation = [entry(0, 3), entry(1, 3), entry(2, 3)];
    let rotation = ParsedRotation::Matrix(matrix);
    let mut made = vec![
        if is_columns {
            Made::Columns(rotation)
        } else {
            Made::Rotation(rotation)
        },
        Made::Position(translation),
    ];
    made.extend(scale.map(Made::Scale));
    Some(made)
}

/// The matrix and, where its columns have other lengths than 1 and stand upright on each other, their
/// lengths: a rotation behind a scale along the body's axes.
fn unscaled(matrix: Matrix3<f64>) -> Option<(Matrix3<f64>, Option<[f64; 3]>)> {
    if let Some(matrix) = orthonormal(matrix) {
        return Some((matrix, None));
    }
    let length = |column| matrix.column(column).norm();
    let scale = [length(0), length(1), length(2)];
    if scale
        .iter()
        .any(|length| *length < ROUNDED_ZERO || !length.is_finite())
    {
        return None;
    }
    let turned = Matrix3::from_fn(|row, column| matrix[(row, column)] / scale[column]);
    let error = (turned.transpose() * turned - Matrix3::identity()).amax();
    (error <= UPRIGHT).then_some((turned, Some(scale)))
}

/// Axes of a scaled rotation stand upright but for rounding; those of a projection do not.
const UPRIGHT: f64 = 1e-3;

/// What programs write for a zero that was computed.
const ROUNDED_ZERO: f64 = 1e-6;

/// Times of this size are in nanoseconds since 1970, not in seconds.
const LEAST_NANOSECONDS: f64 = 1e16;
