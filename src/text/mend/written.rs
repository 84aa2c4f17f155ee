//! A rotation that was read as a text that says what its numbers are.

use crate::convention::angle::AngleUnit;
use crate::text::description::ParsedRotation;
use crate::text::mend::number_text::{exact, rows_text};

/// A text that is read as the same rotation, whatever is declared of order and unit.
pub(crate) fn rotation_text(rotation: &ParsedRotation) -> String {
    let list = |numbers: [f64; 3]| numbers.map(exact).join(" ");
    match rotation {
        ParsedRotation::Quaternion(parsed) => {
            let quaternion = parsed.quaternion;
            let [w, x, y, z] = [quaternion.w, quaternion.i, quaternion.j, quaternion.k].map(exact);
            format!("w={w} x={x} y={y} z={z}")
        }
        ParsedRotation::AxisAngle(parsed) => format!(
            "axis-angle [{}] {}",
            list(parsed.axis.into()),
            angle(parsed.angle_rad, parsed.unit.unit())
        ),
        ParsedRotation::RotationVector(parsed) => {
            format!("rotvec [{}] rad", list(parsed.vector_rad.into()))
        }
        ParsedRotation::HalfAngleVector(parsed) => {
            format!("halfangle [{}] rad", list(parsed.vector_rad.into()))
        }
        ParsedRotation::GibbsVector(vector) => format!("gibbs {}", list((*vector).into())),
        ParsedRotation::ModifiedRodrigues(vector) => format!("mrp {}", list((*vector).into())),
        ParsedRotation::EulerAngles(parsed) => {
            let angles = parsed
                .angles_rad
                .map(|angle_rad| angle(angle_rad, parsed.unit.unit()));
            format!("{} {}", parsed.sequence, angles.join(" "))
        }
        ParsedRotation::Matrix(matrix) => {
            let rows = [0, 1, 2].map(|row| [0, 1, 2].map(|column| matrix[(row, column)]));
            rows_text(&rows)
        }
    }
}

fn angle(angle_rad: f64, unit: AngleUnit) -> String {
    match unit {
        AngleUnit::Degrees => format!("{}deg", exact(angle_rad.to_degrees())),
        AngleUnit::Radians => format!("{}rad", exact(angle_rad)),
    }
}
