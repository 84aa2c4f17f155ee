//! Text to numbers: everything people paste, as what they describe; no rotation is computed here.
//!
//! What comes in is text as typed; what goes out is finite numbers by name, what they describe
//! (a quaternion, an axis with its angle, a rotation vector or another vector along the axis, Euler
//! angles, a matrix or a vector), and how the text told it.
//!
//! # What is accepted
//!
//! | form | example |
//! |---|---|
//! | numbers, in any brackets or none | `0.92 0 0 0.38`, `[0, 0, 0.38, 0.92]` |
//! | named components, in any order | `(w=0.92, x=0, y=0, z=0.38)`, `qx: 0 …` |
//! | a ROS message, YAML, JSON, a dictionary | `x: 0.0⏎y: 0.0⏎z: 0.38⏎w: 0.92`, `{"w": 0.92, …}` |
//! | a sum of units, in any order | `0.92 + 0.38k`, `k sin(pi/8) + cos(pi/8)` |
//! | scalar and vector | `0.92 [0, 0, 0.38]`, `[[0, 0, 0.38], 0.92]` |
//! | a constructor call | `Eigen::Quaterniond(0.92, 0, 0, 0.38)`, `Rotation.from_quat([0, 0, 0.38, 0.92])` |
//! | axis and angle | `45deg about z`, `45deg [0, 0, 1]`, `axis-angle [0, 0, 1] pi/4`, `axis=z, angle=45°` |
//! | | `Eigen::AngleAxisd(0.785, Eigen::Vector3d::UnitZ())` |
//! | rotation vector | `rotvec 0 0 0.785`, `rotvec [0 0 45] deg`, `Rotation.from_rotvec([0, 0, 0.785])` |
//! | half-angle vector | `halfangle 0 0 0.393`, `half-angle vector 0 0 22.5deg` |
//! | Gibbs vector, Rodrigues parameters | `gibbs 0 0 0.414`, `Rodrigues parameters: 0 0 0.414` |
//! | modified Rodrigues parameters | `mrp 0 0 0.199`, `Rotation.from_mrp([0, 0, 0.199])` |
//! | Euler angles | `ZYX 30° 20° 10°`, `3-2-1 30 20 10`, `intrinsic zyx …`, `sxyz …`, `rpy 0.1 0.2 0.3` |
//! | | `roll=10deg pitch=20deg yaw=30deg`, `R.from_euler('ZYX', [30, 20, 10], degrees=True)` |
//! | matrix, column by column | `x: 0 1 0, y: -1 0 0, z: 0 0 1`: the turned axes by name; `col(0) …` |
//! | LaTeX; JSON with a comment; a test vector | `q = \begin{bmatrix} 0.92 & 0 & 0 & 0.38 \end{bmatrix}^T` |
//! | matrix, row by row | nine numbers, `[[…], […], […]]`, `[0 -1 0; 1 0 0; 0 0 1]`, `R << …` |
//!
//! | a block that a program printed | see "Whole blocks" |
//!
//! Without the feature `whole` blocks, calls, what consoles print before a list, and a matrix column by column are
//! refused.
//!
//! # Whole blocks
//!
//! What is not read as one of these, or holds more, is taken apart without a grammar (`record`): runs of numbers and
//! single numbers by name, each with the names of what holds it. What they are is said by formats (`formats`, data)
//! whose words stand in the text, then by names, last by the numbers themselves: a matrix that is orthonormal, four
//! numbers of norm 1. [`analyze`](fn@crate::analyze) tells what stands beside the rotation: position, scale, and
//! whether a second description agrees with it. Several rotations, rows of a file and what only may be a rotation
//! are asked; a text whose words say that it is none is refused.
//!
//! # Degrees or radians
//!
//! What is written wins: a unit beside each angle, or once for all (`ZYX 30 20 10 deg`). A π means
//! radians, and the call of a library has the library's unit (beyond a full turn in radians only assumed). Otherwise a rotation vector, a half-angle
//! vector and an attribute `rpy="…"` are radians; other angles are radians where none is larger than a full turn
//! (6.29, so that 6.2832 is one), and degrees otherwise. [`UnitSource`](crate::UnitSource) tells which of these it was.
//! Inside `sin`, `cos` and `tan` a number without a unit is radians whatever its size; beyond a full turn
//! [`analyze`](fn@crate::analyze) says so.
//!
//! # Named words beside the numbers
//!
//! `unit`, `degrees`, `order` and `format` with a value that is known here count for all the numbers.
//! What programs print besides (`frame_id`, `dtype`, …) is read past. Any other named word, such as
//! `layout` or `handedness`, may change the numbers and is refused, but in a whole block.
//!
//! # What labels and comments say
//!
//! A label is read word by word, also `qInv` and `worldToBody`. What it says of an order (`q_scalar_last`) or of
//! columns (`column_major`, and three.js's `elements`) is used; what names something else than a rotation
//! (`position`, `rgba`, `qdot`, `R.T`), left-handed axes or another order is refused. A direction
//! (`world_to_body`) wins over the declared one in [`analyze`](fn@crate::analyze), and with it and an order the product
//! (`# JPL, world to body`); a product alone (`q_jpl`) is refused where another is declared. Of a comment, and of what
//! is said behind numbers in their line (`(scalar last)`), the same words count, but for what it says is made "of
//! them", and a unit for all the angles (`rpy 5 4 3 # deg`). Marks on a name (`q⁻¹`, `Rᵀ`, `2q`) and the code above
//! numbers that printed them (`>>> R.T`) refuse them where they make something else of the rotation. Any other word
//! says nothing. Of a whole block the order of components is that which the text tells anywhere, and
//! [`analyze`](fn@crate::analyze) stops at a line apart from the numbers that may say something of them.
//!
//! # Which sequence
//!
//! Capitals are axes that move (intrinsic), small letters axes that stay (extrinsic), as in `SciPy`;
//! the words `intrinsic` and `extrinsic` win over the letters. `rpy` and named roll, pitch and yaw
//! are turns about the fixed axes x, y, z, as in ROS; `ypr` is `ZYX`. Beside names another sequence
//! counts only with a word for its frame (`intrinsic xyz: roll=…`); roll is then about x, pitch about
//! y and yaw about z. In `ZYX: 30, 20, 10` and
//! `3-2-1 30 20 10` the sequence is no name and no difference, whatever follows.
//!
//! # Grammar
//!
//! ```text
//! text     = members
//! members  = { member [","] }              white space, "," and ";" separate
//! member   = { name (":" | "=") } sum
//! sum      = product { ("+" | "-") product }
//! product  = signed { ("*" | "/") signed | atom | unit }
//! signed   = [ "+" | "-" ] atom
//! atom     = number | "i" | "j" | "k" | "pi" | "tau"
//!          | function "(" sum ")" | "√" atom
//!          | ("(" | "[" | "{" | "<") members (")" | "]" | "}" | ">")
//!          | name { name } "(" members ")"
//! unit     = "deg" | "°" | "rad"
//! function = "sqrt" | "abs" | "sin" | "cos" | "tan" | "asin" | "acos" | "atan"
//! ```
//!
//! - `1 -2` is two numbers, as in MATLAB, and `1-2` is one. Between numbers that only white space
//!   separates, a sign with space on both sides is refused, since it may be a minus, a difference or
//!   the dash of a list; with commas, or in a sum of units, it is read. So is a sign between two typed
//!   numbers that touch it (`0.5-0.5`, perhaps columns that run together), and one behind its number.
//!   Two signs in a row are read only in a sum of units (`0.92 + -0.38k`).
//! - A name or a root that touches what stands before it is a factor: `0.38k`, `2pi`, `2√3`; beside
//!   a unit a space may stand between: `√2/2 k`, `k sin(pi/8)`. It binds like `*`, from left to
//!   right: `1/2k` is half of k.
//! - `−` (U+2212), `–`, `·`, `×`, `÷`, `√`, `π`, `½` mean what they look like. Drawn frames are read
//!   past where they touch nothing; a character that is not seen, or a narrow space, between two
//!   digits is refused.
//! - Commas stand between all the numbers of a list or between none, so that a decimal comma is not
//!   read as two numbers; `0,7;0,7` and `0,7,0,7` are refused. `(0.92; 0.1, -0.2, 0.38)` is a scalar and a vector.
//! - `1 1/2` is refused, since it may be one number; so is `0.6+0.8j`, a complex number in many programs.
//! - A call is read only if it is known what it makes of its numbers: `inverse(…)`, `exp(…)` and the
//!   like are refused, because they are not applied here.
//! - The words that announce a description (`about`, `rotvec`, `rpy`, a sequence, …) are read before
//!   the grammar, which then reads the pieces between them.
//! - Of several values under headings, as in a ROS pose, the orientation is taken.
//! - The numbers of comments (`#`, `//`, `/* */`, and `%` with a space), R's indices (`[1] 0.92 …`), the words of a declaration
//!   (`const Eigen::Quaterniond q(…);`), types of numbers (`Quaternion<double>`), float suffixes
//!   (`0.5f`), casts (`np.float64(0.5)`) and what consoles print before a list (`Float32Array(4) […]`,
//!   with the count of its members) are read past. Any other word or number before a list is refused.
//!
//! # Which number is the scalar
//!
//! Names, units, groups and known constructors tell it; then the text wins over the declared order,
//! and [`ParsedQuaternion::order_source`] says so. Otherwise the declared order is used.
//!
//! # Whether four numbers are a quaternion
//!
//! The word quaternion tells it, a label such as `q` or `quat`, a constructor, the units i, j and k, or names
//! such as `qw`; so do the names w, x, y and z under `orientation`. [`ParsedQuaternion::is_announced`] is
//! true then. Where nothing does, four numbers are read as one, and of a norm outside 0.9 to 1.1
//! [`analyze`](fn@crate::analyze) asks what else they may be.

// Members to a description of a rotation.
pub(crate) mod description;

// Tokens, and the tree that they make.
pub(crate) mod grammar;

// A text that has a problem, rewritten so that it is read.
pub(crate) mod mend;

// What programs print, as data.
#[cfg(feature = "whole")]
mod formats;

// LaTeX, and JSON with words.
#[cfg(feature = "whole")]
mod notation;

// Tokens to a rotation: which description they are.
mod readers;

// Whole blocks that programs print.
#[cfg(feature = "whole")]
mod record;

// The units of rates, small turns and times.
#[cfg(feature = "whole")]
pub(crate) mod units;

// Words and names that are known.
mod vocabulary;

use crate::convention::order::ComponentOrder;
use crate::problem::fault::Fault;
use crate::problem::{MAX_TEXT_BYTES, Span, Wanted, is_too_long};
pub use crate::text::description::ParsedRotation;
pub(crate) use crate::text::description::list::only_numbers;
pub(crate) use crate::text::description::matrix::RowMarks;
pub use crate::text::description::quaternion::ParsedQuaternion;
pub(crate) use crate::text::description::told::Told;
#[cfg(feature = "whole")]
pub(crate) use crate::text::description::told::is_for_rows;
use crate::text::description::told::{Layout, check_plain};
use crate::text::description::{list, vector};
#[cfg(feature = "whole")]
pub(crate) use crate::text::formats::{FORMATS, PLAIN};
#[cfg(feature = "whole")]
pub(crate) use crate::text::notation::in_known_notation;
use crate::text::readers::rotation;
#[cfg(feature = "whole")]
pub(crate) use crate::text::record::{
    DeclaredFormat, Record, RecordRotation, What, made_above, made_by_code, made_by_remark,
    marked_label, record_of,
};
#[cfg(feature = "whole")]
pub(crate) use crate::text::vocabulary::Comment;
use crate::text::vocabulary::Telling;
#[cfg(feature = "whole")]
pub(crate) use crate::text::vocabulary::comments_of;
pub(crate) use crate::text::vocabulary::decimal_words::is_decimal;
#[cfg(feature = "whole")]
pub(crate) use crate::text::vocabulary::labels::{
    LabelWord, meanings_of, other_than_rotation, says_nothing,
};
use nalgebra::Vector3;

/// The rotation that a text holds, in whichever description it is written.
///
/// `declared` is used for the numbers of a quaternion where the text itself does not tell their
/// order; it changes no other description.
///
/// # Errors
///
/// The first problem of the text; its span counts bytes. A zero axis is one; a zero quaternion and
/// a matrix that is no rotation are none here.
///
/// ```
/// use quatlas::{AngleUnit, ComponentOrder, EulerSequence, ParsedRotation, UnitSource};
/// use quatlas::parse_rotation;
///
/// // Three different angles: yaw first, about the moving axes z, y, x.
/// let parsed = parse_rotation("ZYX 30deg 20deg 10deg", ComponentOrder::ScalarFirst)?;
/// let ParsedRotation::EulerAngles(euler) = parsed else { panic!("{parsed:?}") };
/// assert_eq!(euler.sequence, EulerSequence::AEROSPACE);
/// assert_eq!(euler.angles_rad[0], std::f64::consts::FRAC_PI_6);
/// assert_eq!(euler.unit, UnitSource::Written(AngleUnit::Degrees));
///
/// // Rows as written: a quarter turn about z.
/// let parsed = parse_rotation("[0 -1 0; 1 0 0; 0 0 1]", ComponentOrder::ScalarLast)?;
/// let ParsedRotation::Matrix(matrix) = parsed else { panic!("{parsed:?}") };
/// assert_eq!((matrix[(0, 1)], matrix[(1, 0)]), (-1.0, 1.0));
/// # Ok::<(), quatlas::Fault>(())
/// ```
pub fn parse_rotation(text: &str, declared: ComponentOrder) -> Result<ParsedRotation, Fault> {
    read_rotation(text, declared).map(|read| read.rotation)
}

/// What a text holds that holds a rotation.
pub(crate) struct RotationText<'t> {
    pub(crate) rotation: ParsedRotation,
    /// What marks the rows of a matrix.
    pub(crate) row_marks: RowMarks,
    /// What labels and comments tell besides.
    pub(crate) told: Told<'t>,
}

/// The rotation that a text holds, and what else it tells.
pub(crate) fn read_rotation(
    text: &str,
    declared: ComponentOrder,
) -> Result<RotationText<'_>, Fault> {
    let (telling, span) = telling_of(text, Wanted::Quaternion)?;
    let told = Told::of(&telling, text, Wanted::Quaternion)?;
    let mut rotation = rotation(&telling, text, span, declared, &told)?;
    let mut row_marks = match rotation {
        ParsedRotation::Matrix(_) => RowMarks::among(text, &telling),
        _ => RowMarks::None,
    };
    // Without the feature `whole` no label that says so is read.
    if cfg!(feature = "whole") {
        let layout = told.layout_of(&rotation, row_marks != RowMarks::None)?;
        match (layout, &mut rotation) {
            (Some(Layout::Columns), ParsedRotation::Matrix(matrix)) => {
                matrix.transpose_mut();
                row_marks = RowMarks::Columns;
            }
            (Some(Layout::Rows), _) if row_marks == RowMarks::None => row_marks = RowMarks::Lines,
            _ => {}
        }
    }
    Ok(RotationText {
        rotation,
        row_marks,
        told,
    })
}

/// The quaternion that a text holds.
///
/// `declared` is used where the text itself does not tell its order.
///
/// # Errors
///
/// The first problem of the text; its span counts bytes. Another description of a rotation is one;
/// a zero quaternion is none here.
///
/// ```
/// use quatlas::{ComponentOrder, OrderSource, parse_quaternion};
///
/// // The constructor's order wins: the scalar is the first number.
/// let text = "Eigen::Quaterniond(1/2, -1/2, 1/√2, 0)";
/// let parsed = parse_quaternion(text, ComponentOrder::ScalarLast)?;
/// assert_eq!((parsed.quaternion.w, parsed.quaternion.i), (0.5, -0.5));
/// assert_eq!(parsed.order_source, OrderSource::Constructor);
///
/// let refused = |text| {
///     let parsed = parse_quaternion(text, ComponentOrder::ScalarFirst);
///     parsed.unwrap_err().to_string()
/// };
/// assert_eq!(refused("1 0 0"), "3 numbers: a quaternion has 4");
/// assert_eq!(
///     refused("rotvec 0 0 1"),
///     "this is a rotation vector, a quaternion is needed here"
/// );
/// # Ok::<(), quatlas::Fault>(())
/// ```
pub fn parse_quaternion(text: &str, declared: ComponentOrder) -> Result<ParsedQuaternion, Fault> {
    match parse_rotation(text, declared)? {
        ParsedRotation::Quaternion(quaternion) => Ok(quaternion),
        other => {
            let span = Span::of_trimmed(text);
            Err(Fault::not_a_quaternion(span, other.in_words()))
        }
    }
}

/// The vector that a text holds: three numbers, named components, or a sum of i, j and k.
///
/// # Errors
///
/// The first problem of the text; its span counts bytes.
///
/// ```
/// use quatlas::parse_vector;
/// assert_eq!(parse_vector("2k - i")?.as_slice(), [-1.0, 0.0, 2.0]);
/// # Ok::<(), quatlas::Fault>(())
/// ```
pub fn parse_vector(text: &str) -> Result<Vector3<f64>, Fault> {
    let (telling, span) = telling_of(text, Wanted::Vector)?;
    if cfg!(feature = "whole") {
        Told::of(&telling, text, Wanted::Vector)?;
    } else {
        check_plain(&telling.tokens, Wanted::Vector)?;
    }
    vector::vector(&grammar::entries(&telling.tokens)?, span)
}

/// The one number that a text holds, computed where it is an expression.
///
/// # Errors
///
/// The first problem of the text; its span counts bytes. An angle with its unit is one, and so are several
/// numbers.
///
/// ```
/// use quatlas::parse_number;
/// assert_eq!(parse_number("-1/4")?, -0.25);
/// assert_eq!(parse_number("1 2").unwrap_err().to_string(), "2 numbers: 1 is needed");
/// # Ok::<(), quatlas::Fault>(())
/// ```
pub fn parse_number(text: &str) -> Result<f64, Fault> {
    let (telling, span) = telling(text)?;
    list::number(&grammar::entries(&telling.tokens)?, span)
}

/// The tokens of a text that is not empty, and its place without the space around it.
fn telling_of(text: &str, wanted: Wanted) -> Result<(Telling<'_>, Span), Fault> {
    let (telling, span) = telling(text)?;
    if telling.tokens.is_empty() {
        return Err(Fault::empty_text(Span::from(0..text.len()), wanted));
    }
    Ok((telling, span))
}

/// A text is measured before anything is done with it: of megabytes even a look at each takes a while.
fn telling(text: &str) -> Result<(Telling<'_>, Span), Fault> {
    let span = Span::of_trimmed(text);
    if is_too_long(text) {
        return Err(Fault::text_too_long(span, text.len(), MAX_TEXT_BYTES));
    }
    Ok((Telling::of(text)?, span))
}
