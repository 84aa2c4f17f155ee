//! A rotation that was read as a text that says what its numbers are.

use crate::convention::angle::{AngleUnit, degrees_in_radians};
use crate::text::description::ParsedRotation;
use crate::text::mend::number_text::{exact, exact_list, rows_text};
use nalgebra::Vector3;

/// A text that is read as the same rotation, whatever is declared of order and unit.
pub(crate) fn rotation_text(rotation: &ParsedRotation) -> String {
    match rotation {
        ParsedRotation::Quaternion(parsed) => {
            let quaternion = parsed.quaternion;
            let mut text = String::new();
            for (name, number) in [
                ("w=", quaternion.w),
                (" x=", quaternion.i),
                (" y=", quaternion.j),
                (" z=", quaternion.k),
            ] {
                text.push_str(name);
                text.push_str(&exact(number));
            }
            text
        }
        ParsedRotation::AxisAngle(parsed) => {
            let axis = list("axis-angle [", &parsed.axis, "]");
            axis + &angle(parsed.angle_rad, parsed.unit.unit())
        }
        ParsedRotation::RotationVector(parsed) => list("rotvec [", &parsed.vector_rad, "] rad"),
        ParsedRotation::HalfAngleVector(parsed) => list("halfangle [", &parsed.vector_rad, "] rad"),
        ParsedRotation::GibbsVector(vector) => list("gibbs ", vector, ""),
        ParsedRotation::ModifiedRodrigues(vector) => list("mrp ", vector, ""),
        ParsedRotation::EulerAngles(parsed) => {
            let mut text = parsed.sequence.to_string();
            for angle_rad in parsed.angles_rad {
                text.push_str(&angle(angle_rad, parsed.unit.unit()));
            }
            text
        }
        ParsedRotation::Matrix(matrix) => rows_text(&matrix.transpose().into()),
    }
}

fn list(before: &str, numbers: &Vector3<f64>, behind: &str) -> String {
    [before, &exact_list(numbers.as_slice()), behind].concat()
}

/// An angle behind a space.
fn angle(angle_rad: f64, unit: AngleUnit) -> String {
    let (number, word) = match unit {
        AngleUnit::Degrees => (degrees(angle_rad), "deg"),
        AngleUnit::Radians => (angle_rad, "rad"),
    };
    [" ", &exact(number), word].concat()
}

/// The angle in degrees as it was written, where few decimals are the same radians: 30.1, not
/// 30.100000000000001.
fn degrees(angle_rad: f64) -> f64 {
    let exact = angle_rad.to_degrees();
    let rounded = (exact * SHORT_DECIMALS).round() / SHORT_DECIMALS;
    if degrees_in_radians(rounded) == angle_rad {
        rounded
    } else {
        exact
    }
}

/// Ten decimals.
const SHORT_DECIMALS: f64 = 1e10;
