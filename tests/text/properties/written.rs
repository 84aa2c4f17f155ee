//! Rotations as people and programs write them, each with the rotation that is meant.
//!
//! What is meant is worked out by nalgebra from three angles, and never by quatlas.

use crate::turned::{angles, sequences, turned};
use proptest::prelude::*;
use quatlas::nalgebra::{Matrix3, Unit, Vector3};
use quatlas::{EulerFrame, EulerSequence};
use std::fmt;

/// A text, read as Hamilton's w x y z, and its matrix body to world.
#[derive(Clone)]
pub(crate) struct Written {
    pub(crate) text: String,
    pub(crate) body_to_world: Matrix3<f64>,
    /// What the rounding of the numbers may move an entry of the matrix by.
    pub(crate) tolerance: f64,
}

impl fmt::Debug for Written {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?} for {}", self.text, self.body_to_world)
    }
}

/// The forms; what stands in braces is a number or a name (see [`filled`]). `{+x}` has its sign apart.
const FORMS: &[&str] = &[
    // Four numbers.
    "{w} {x} {y} {z}",
    "{w}, {x}, {y}, {z}",
    "[{w}, {x}, {y}, {z}]",
    "({w}; {x}; {y}; {z})",
    "<{w} {x} {y} {z}>",
    "{w}\n{x}\n{y}\n{z}\n",
    "q = [{w} {x} {y} {z}];",
    "{w}\t{x}\t{y}\t{z}",
    "{w} [{x}, {y}, {z}]",
    "[[{x} {y} {z}], {w}]",
    "{w} + {x}i + {y}j + {z}k",
    "{w} {+x}*i {+y}*j {+z}*k",
    "{x} i {+y} j {+z} k {+w}",
    "w={w} x={x} y={y} z={z}",
    "(x={x}, y={y}, z={z}, w={w})",
    "qx: {x}, qy: {y}, qz: {z}, qw: {w}",
    "orientation:\n  x: {x}\n  y: {y}\n  z: {z}\n  w: {w}\n",
    "{\"w\": {w}, \"x\": {x}, \"y\": {y}, \"z\": {z}}",
    "{\"rotation\": {\"x\": {x}, \"y\": {y}, \"z\": {z}, \"w\": {w}}}",
    "- {w}\n- {x}\n- {y}\n- {z}",
    "Eigen::Quaterniond q({w}, {x}, {y}, {z});",
    "Rotation.from_quat([{x}, {y}, {z}, {w}])",
    "new THREE.Quaternion({x}, {y}, {z}, {w})",
    "tf2::Quaternion q({x}, {y}, {z}, {w});",
    "np.array([{w}, {x}, {y}, {z}])",
    "order: xyzw\n{x} {y} {z} {w}",
    "// as logged\n{w}, {x}, {y}, {z} # w first",
    // An axis and an angle.
    "axis-angle [{ux}, {uy}, {uz}] {angle} rad",
    "axis-angle {ux} {uy} {uz} {angle°}°",
    "angle-axis {angle} rad [{ux}, {uy}, {uz}]",
    "{angle°}deg about ({ux}, {uy}, {uz})",
    "{angle} rad about [{ux} {uy} {uz}]",
    "axis=[{ux}, {uy}, {uz}], angle={angle°}°",
    "Eigen::AngleAxisd({angle}, Eigen::Vector3d({ux}, {uy}, {uz}))",
    // A rotation vector.
    "rotvec {rx} {ry} {rz}",
    "rotvec [{rx}, {ry}, {rz}] rad",
    "rotvec [{rx°} {ry°} {rz°}] deg",
    "Rotation.from_rotvec([{rx}, {ry}, {rz}])",
    // Euler angles.
    "{sequence} {a} {b} {c} rad",
    "{sequence} {a°} {b°} {c°} deg",
    "{sequence} {a°}° {b°}° {c°}°",
    "euler {sequence}: {a} rad, {b} rad, {c} rad",
    "{frame} {letters} [{a°}, {b°}, {c°}] deg",
    "R.from_euler('{sequence}', [{a°}, {b°}, {c°}], degrees=True)",
    // A matrix.
    "{m00} {m01} {m02}\n{m10} {m11} {m12}\n{m20} {m21} {m22}",
    "[[{m00}, {m01}, {m02}], [{m10}, {m11}, {m12}], [{m20}, {m21}, {m22}]]",
    "[{m00} {m01} {m02}; {m10} {m11} {m12}; {m20} {m21} {m22}]",
    "R = np.array([[{m00}, {m01}, {m02}],\n              [{m10}, {m11}, {m12}],\n              [{m20}, {m21}, {m22}]])",
    "matrix {m00}, {m01}, {m02}, {m10}, {m11}, {m12}, {m20}, {m21}, {m22}",
    "R << {m00}, {m01}, {m02},\n     {m10}, {m11}, {m12},\n     {m20}, {m21}, {m22};",
];

/// Forms whose words tell the sequence: about the fixed axes x, y, z, or the moving axes z, y, x.
const ROLL_PITCH_YAW: &[&str] = &[
    "rpy {a} {b} {c}",
    "rpy=\"{a} {b} {c}\"",
    "roll: {a} rad, pitch: {b} rad, yaw: {c} rad",
    "roll={a°}deg pitch={b°}deg yaw={c°}deg",
    "yaw={c°}° pitch={b°}° roll={a°}°",
];

const YAW_PITCH_ROLL: &[&str] = &["ypr {a°} {b°} {c°} deg", "3-2-1 {a} {b} {c} rad"];

/// How numbers are printed, and by how much of their unit that may round them.
#[derive(Clone, Copy, Debug)]
enum Digits {
    All,
    Exponent,
    Decimals(usize),
}

impl Digits {
    fn print(self, number: f64) -> String {
        // What rounds to no number has no sign either.
        let text = match self {
            Self::All => format!("{number:?}"),
            Self::Exponent => format!("{number:e}"),
            Self::Decimals(count) => format!("{number:.count$}"),
        };
        if text.parse() == Ok(0.0) {
            text.replace('-', "")
        } else {
            text
        }
    }

    /// Of an entry of the matrix, with eight times the rounding of a number for all that meet in it.
    fn tolerance(self) -> f64 {
        match self {
            Self::All | Self::Exponent => 4e-15,
            Self::Decimals(count) => 8.0 * 10_f64.powf(-(count as f64)),
        }
    }
}

/// A rotation in one of the forms.
pub(crate) fn written() -> impl Strategy<Value = Written> {
    let of_any = (prop::sample::select(FORMS), sequences());
    let of_names =
        prop::sample::select(ROLL_PITCH_YAW).prop_map(|form| (form, EulerSequence::ROLL_PITCH_YAW));
    let of_letters =
        prop::sample::select(YAW_PITCH_ROLL).prop_map(|form| (form, EulerSequence::AEROSPACE));
    let digits = prop_oneof![
        2 => Just(Digits::All),
        1 => Just(Digits::Exponent),
        1 => (6..17_usize).prop_map(Digits::Decimals),
    ];
    (
        prop_oneof![10 => of_any, 1 => of_names, 1 => of_letters],
        angles(),
        digits,
    )
        .prop_map(|((form, sequence), angles, digits)| filled(form, sequence, angles, digits))
}

fn filled(form: &str, sequence: EulerSequence, angles: [f64; 3], digits: Digits) -> Written {
    let rotation = turned(sequence, angles);
    let (axis, angle) = rotation
        .axis_angle()
        .unwrap_or((Unit::new_unchecked(Vector3::z()), 0.0));
    let vector = axis.into_inner() * angle;
    let matrix = rotation.to_rotation_matrix().into_inner();
    let mut numbers = vec![
        ("w", rotation.w),
        ("x", rotation.i),
        ("y", rotation.j),
        ("z", rotation.k),
        ("ux", axis.x),
        ("uy", axis.y),
        ("uz", axis.z),
        ("angle", angle),
        ("rx", vector.x),
        ("ry", vector.y),
        ("rz", vector.z),
        ("a", angles[0]),
        ("b", angles[1]),
        ("c", angles[2]),
    ]
    .into_iter()
    .map(|(name, number)| (name.to_owned(), number))
    .collect::<Vec<_>>();
    for row in 0..3 {
        for column in 0..3 {
            numbers.push((format!("m{row}{column}"), matrix[(row, column)]));
        }
    }
    let frame = match sequence.frame {
        EulerFrame::Intrinsic => "intrinsic",
        EulerFrame::Extrinsic => "extrinsic",
    };
    let mut text = form
        .replace("{sequence}", &sequence.to_string())
        .replace("{letters}", &sequence.to_string().to_ascii_lowercase())
        .replace("{frame}", frame);
    for (name, number) in &numbers {
        let number = number + 0.0;
        text = text
            .replace(&format!("{{{name}}}"), &digits.print(number))
            .replace(
                &format!("{{{name}°}}"),
                &digits.print(number.to_degrees() + 0.0),
            );
        let sign = if number < 0.0 { '-' } else { '+' };
        let apart = format!("{sign} {}", digits.print(number.abs()));
        text = text.replace(&format!("{{+{name}}}"), &apart);
    }
    Written {
        text,
        body_to_world: matrix,
        tolerance: digits.tolerance(),
    }
}
