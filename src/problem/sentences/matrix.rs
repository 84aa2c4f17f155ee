//! The sentences of problems of matrices.

use crate::problem::fault::{Fault, Words};
use crate::problem::{ProblemCode, QUOTED_CHARACTERS, Span, shorten};

const THREE_ROWS: &str = "a rotation matrix: three rows of three numbers";

pub(crate) const POSE: &str =
    "a pose has a rotation as its upper left 3 by 3, and 0 0 0 1 as its last row";

const AXES: [&str; 3] = ["x", "y", "z"];
const ORDINALS: [&str; 3] = ["first", "second", "third"];

/// What a reflection flips.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mirror {
    All,
    /// The axis that stands against itself.
    Axis(usize),
    /// The matrix alone does not tell which; with this one flipped the rotation is smallest.
    Nearest(usize),
}

impl Fault {
    pub(crate) fn matrix_count(span: Span, found: usize) -> Self {
        Self::told(ProblemCode::WrongCount, span, || {
            let (shape, hint) = match found {
                16 => (" (4 by 4)", POSE),
                12 => (" (3 by 4)", POSE),
                _ => (
                    "",
                    "write the three rows one after the other: 0 -1 0  1 0 0  0 0 1",
                ),
            };
            Words::new(
                format!("{}{shape}: a rotation matrix has 9", numbers(found)),
                THREE_ROWS,
                hint,
            )
        })
    }

    pub(crate) fn missing_vector(span: Span, names: &[String]) -> Self {
        Self::told(ProblemCode::MissingComponent, span, || {
            let verb = if names.len() == 1 { "is" } else { "are" };
            Words::new(
                format!("{} {verb} missing", names.join(" and ")),
                "three vectors of three numbers",
                "add it; right-handed axes have z = x × y, x = y × z and y = z × x",
            )
        })
    }

    pub(crate) fn matrix_shape(span: Span, rows: &[usize]) -> Self {
        Self::told(ProblemCode::WrongCount, span, || {
            let first = rows.first().copied().unwrap_or_default();
            let is_even = rows.iter().all(|length| *length == first);
            let message = if is_even {
                format!(
                    "{} rows of {first}: a rotation matrix is 3 by 3",
                    rows.len()
                )
            } else {
                "rows of different lengths: a rotation matrix is 3 by 3".to_owned()
            };
            let hint = match (rows.len(), is_even, first) {
                (3 | 4, true, 4) => POSE,
                _ => "write the three rows: [[0, -1, 0], [1, 0, 0], [0, 0, 1]]",
            };
            Words::new(message, THREE_ROWS, hint)
        })
    }

    pub(crate) fn rows_or_columns(span: Span, name: &str) -> Self {
        Self::told(ProblemCode::UnknownWord, span, || {
            let name = shorten(name, QUOTED_CHARACTERS);
            Words::new(
                format!(
                    "the layout of {name} depends on the library: rows, columns or row vectors"
                ),
                "a known layout, such as Eigen::Matrix3d or nalgebra::Matrix3::new",
                "write the three rows: [[0, -1, 0], [1, 0, 0], [0, 0, 1]]",
            )
        })
    }

    /// The scale is 1 where the matrix has none.
    pub(crate) fn reflection(span: Span, mirror: Mirror, scale: f64) -> Self {
        Self::told(ProblemCode::Reflection, span, || {
            let (what, hint) = match mirror {
                Mirror::All => (
                    "all three axes are flipped".to_owned(),
                    "change the sign of all nine numbers".to_owned(),
                ),
                Mirror::Axis(axis) => (
                    format!("the {} axis is flipped", AXES[axis]),
                    format!("change the sign of the {} column", ORDINALS[axis]),
                ),
                Mirror::Nearest(axis) => (
                    format!("one axis is flipped, perhaps {}", AXES[axis]),
                    format!("change the sign of the {} column", ORDINALS[axis]),
                ),
            };
            let times = match short(scale).as_str() {
                "1" => String::new(),
                times => format!(" times {times}"),
            };
            Words::new(
                format!("this matrix is a reflection{times}, not a rotation: {what}"),
                "a determinant of +1",
                format!("{hint}, or check for left-handed axes"),
            )
        })
    }

    pub(crate) fn singular_matrix(span: Span) -> Self {
        Self::new(
            ProblemCode::NotARotation,
            span,
            "the columns of this matrix lie in a plane: no single rotation is nearest",
            THREE_ROWS,
            "check for a repeated row, or for zeros that should be numbers",
        )
    }

    pub(crate) fn scaled_rotation(span: Span, scale: f64) -> Self {
        Self::told(ProblemCode::NotARotation, span, || {
            Words::new(
                format!("this is a rotation matrix times {}", short(scale)),
                "columns of length 1",
                format!("divide all nine numbers by {}", short(scale)),
            )
        })
    }

    pub(crate) fn scaled_columns(span: Span, lengths: [f64; 3]) -> Self {
        Self::told(ProblemCode::NotARotation, span, || {
            let [x, y, z] = [short(lengths[0]), short(lengths[1]), short(lengths[2])];
            Words::new(
                format!(
                    "the columns of this matrix are those of a rotation times {x}, {y} and {z}"
                ),
                "columns of length 1",
                format!("divide the columns by {x}, {y} and {z}"),
            )
        })
    }

    pub(crate) fn zero_matrix(span: Span) -> Self {
        Self::new(
            ProblemCode::NotARotation,
            span,
            "all nine numbers are zero: this is not a rotation",
            THREE_ROWS,
            "write the identity: 1 0 0 0 1 0 0 0 1",
        )
    }

    pub(crate) fn not_a_rotation(span: Span, lengths: [f64; 3], correction: Option<f64>) -> Self {
        Self::told(ProblemCode::NotARotation, span, || {
            let [x, y, z] = [short(lengths[0]), short(lengths[1]), short(lengths[2])];
            let far = match correction {
                Some(correction) => format!("{} away from the nearest rotation", short(correction)),
                None => "far from a rotation".to_owned(),
            };
            Words::new(
                format!("this matrix is {far}: column lengths {x}, {y}, {z}"),
                "columns of length 1 at right angles",
                "check for a missing sign, or for numbers of something else",
            )
        })
    }
}

/// A number with about four digits, for a sentence. By whole numbers: how floating-point numbers are
/// written exactly is 9 kB of compressed wasm that nothing else needs.
pub(crate) fn short(number: f64) -> String {
    if number == 0.0 || (1e-2..1e6).contains(&number) {
        let (whole, part) = whole_and_part(number, 10_000);
        return without_zeros(&format!("{whole}.{part:04}")).to_owned();
    }
    let (mut mantissa, mut exponent) = (number, 0);
    while mantissa >= 10.0 && mantissa.is_finite() {
        (mantissa, exponent) = (mantissa / 10.0, exponent + 1);
    }
    while mantissa < 1.0 && mantissa > 0.0 {
        (mantissa, exponent) = (mantissa * 10.0, exponent - 1);
    }
    // 9.9999 is 10.000 when it is rounded.
    if mantissa >= 9.9995 {
        (mantissa, exponent) = (mantissa / 10.0, exponent + 1);
    }
    let (whole, part) = whole_and_part(mantissa, 1000);
    let mantissa = format!("{whole}.{part:03}");
    format!("{}e{exponent}", without_zeros(&mantissa))
}

fn without_zeros(decimal: &str) -> &str {
    decimal.trim_end_matches('0').trim_end_matches('.')
}

/// A number from 0 to 10⁶ as a whole number and as many thousandths or such.
fn whole_and_part(number: f64, parts: u32) -> (u64, u64) {
    #[expect(clippy::cast_possible_truncation, reason = "parts are 10^4 at most")]
    let rounded = (number * f64::from(parts)).round() as u64;
    (rounded / u64::from(parts), rounded % u64::from(parts))
}

/// A count of numbers in words.
pub(crate) fn numbers(count: usize) -> String {
    match count {
        1 => "1 number".to_owned(),
        _ => format!("{count} numbers"),
    }
}
