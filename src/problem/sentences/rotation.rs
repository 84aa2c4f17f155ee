//! The sentences of the problems that are about rotations and what stands for them.

use crate::convention::angle::AngleUnit;
use crate::problem::fault::{Fault, Words};
use crate::problem::sentences::matrix::{POSE, numbers};
use crate::problem::{ProblemCode, QUOTED_CHARACTERS, Span, Wanted, shorten};

/// The words that announce what the numbers are, each with an example.
const ANNOUNCEMENTS: &str =
    "say what they are: rotvec 0 0 0.785, rpy 10deg 20deg 30deg, 45deg about z";

const AXIS: &str = "an axis: x, y, z, -x, …, or three numbers";

impl Fault {
    pub(crate) fn not_applied(span: Span, name: &str, wanted: Wanted) -> Self {
        Self::told(ProblemCode::UnknownWord, span, || {
            let name = shorten(name, QUOTED_CHARACTERS);
            Words::new(
                format!("{name} is not supported here"),
                wanted.in_words(),
                match wanted {
                    Wanted::Quaternion => {
                        "write the resulting numbers, or the rotation in words: 45deg about z"
                    }
                    Wanted::Vector => "write the numbers of the vector",
                },
            )
        })
    }

    pub(crate) fn vector_for_quaternion(span: Span, name: &str) -> Self {
        Self::told(ProblemCode::NotAQuaternion, span, || {
            let name = shorten(name, QUOTED_CHARACTERS);
            Words::new(
                format!("{name} holds a vector or a point, which is not a rotation"),
                Wanted::Quaternion.in_words(),
                "write the numbers alone if they are a rotation all the same",
            )
        })
    }

    pub(crate) fn not_a_quaternion(span: Span, what: &str) -> Self {
        Self::told(ProblemCode::NotAQuaternion, span, || {
            Words::new(
                format!("this is {what}, a quaternion is needed here"),
                "a quaternion: four numbers, named components, or a sum such as 0.92 + 0.38k",
                "write the four numbers of its quaternion",
            )
        })
    }

    pub(crate) fn number_before_list(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "a number before this list: a factor, a count or an index",
            "the list alone",
            "multiply the numbers by it if it is a factor, otherwise remove it",
        )
    }

    pub(crate) fn call_before_list(span: Span, name: &str) -> Self {
        Self::told(ProblemCode::UnknownWord, span, || {
            let name = shorten(name, QUOTED_CHARACTERS);
            Words::new(
                format!("{name} is not supported before a list"),
                "the list alone, or a call that holds it",
                "write the resulting numbers, or remove it if it only counts",
            )
        })
    }

    pub(crate) fn angle_for_number(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "unexpected angle",
            "a number without a unit",
            "say what the angle is: 45° about z, ZYX 30° 20° 10°, cos(22.5°) + sin(22.5°) k",
        )
    }

    pub(crate) fn axis_and_angle(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "a vector and a number in this call: an axis and an angle of unknown unit",
            "the four numbers of a quaternion",
            "write the rotation in words: 45deg about [0, 0, 1]",
        )
    }

    pub(crate) fn axis_angle_or_quaternion(span: Span) -> Self {
        Self::new(
            ProblemCode::TwoMeanings,
            span,
            "a unit vector and a number: axis and angle, or a quaternion not of norm 1",
            "a word that says which",
            "write axis-angle [0, 0, 1] 0.7, or q = [0, 0, 1] 0.7",
        )
    }

    pub(crate) fn wrong_count(span: Span, wanted: Wanted, found: usize) -> Self {
        Self::told(ProblemCode::WrongCount, span, || {
            let (expected, hint) = match wanted {
                Wanted::Quaternion => count_of_rotation(found),
                Wanted::Vector if found > 3 => (
                    "three numbers: x, y, z",
                    "keep the three numbers of one vector; the decimal sign is a point",
                ),
                Wanted::Vector => ("three numbers: x, y, z", "add the missing numbers: 1 0 0"),
            };
            let message = if wanted == Wanted::Quaternion && found > 5 && found != 9 {
                format!("{found} numbers: a quaternion has 4, a matrix 9")
            } else {
                format!(
                    "{}: a {} has {}",
                    numbers(found),
                    wanted.name(),
                    wanted.count()
                )
            };
            Words::new(message, expected, hint)
        })
    }

    pub(crate) fn scalar_in_vector(span: Span) -> Self {
        Self::new(
            ProblemCode::ScalarInVector,
            span,
            "a vector has no scalar part",
            "x, y and z, or a sum of i, j and k",
            "remove the scalar",
        )
    }

    pub(crate) fn zero_axis(span: Span) -> Self {
        Self::new(
            ProblemCode::ZeroAxis,
            span,
            "the axis has length zero",
            "at least one number other than zero",
            "write an axis such as [0, 0, 1]; no rotation is 0 about z",
        )
    }

    pub(crate) fn no_axis(span: Span) -> Self {
        Self::new(
            ProblemCode::UnexpectedEnd,
            span,
            "the axis is missing",
            AXIS,
            "write it: 45deg about z, 45deg about [1, 1, 0]",
        )
    }

    pub(crate) fn no_angle(span: Span) -> Self {
        Self::new(
            ProblemCode::UnexpectedEnd,
            span,
            "the angle is missing",
            "an angle and an axis, as in 45deg about z",
            "write the angle, such as 45deg or pi/4",
        )
    }

    pub(crate) fn unknown_axis(span: Span, word: &str) -> Self {
        Self::told(ProblemCode::UnknownWord, span, || {
            let word = shorten(word, QUOTED_CHARACTERS);
            Words::new(
                format!("{word} is not an axis"),
                AXIS,
                "write the axis as three numbers: [0, 0, 1] is z",
            )
        })
    }

    pub(crate) fn count_of_angles(span: Span, found: usize, what: &str) -> Self {
        Self::told(ProblemCode::WrongCount, span, || {
            Words::new(
                format!("{}: 3 are needed", numbers(found)),
                what,
                if found < 3 {
                    "add what is missing; it may be 0"
                } else {
                    "keep the three of one rotation; the decimal sign is a point"
                },
            )
        })
    }

    pub(crate) fn not_numbers(span: Span, found: usize) -> Self {
        Self::told(ProblemCode::WrongCount, span, || {
            Words::new(
                format!("{} beside the attitude", numbers(found)),
                "three, four or nine numbers, or four names of components",
                "30 20 10, or (-q2, q1, -q4, q3)",
            )
        })
    }

    pub(crate) fn one_angle(span: Span) -> Self {
        Self::new(
            ProblemCode::WrongCount,
            span,
            "several values: one angle is needed",
            "one angle, such as 45deg, 0.785 or pi/4",
            "keep only the angle",
        )
    }

    pub(crate) fn axis_angle_parts(span: Span) -> Self {
        Self::new(
            ProblemCode::WrongCount,
            span,
            "this is not an axis and an angle",
            "three numbers for the axis and one for the angle",
            "write axis-angle [0, 0, 1] 45deg, or 45deg about z",
        )
    }

    pub(crate) fn missing_part(span: Span, names: &[&str]) -> Self {
        Self::told(ProblemCode::MissingComponent, span, || {
            let verb = if names.len() == 1 { "is" } else { "are" };
            let examples: Vec<_> = names.iter().map(|name| format!("{name}=0")).collect();
            Words::new(
                format!("{} {verb} missing", names.join(", ")),
                "all of roll, pitch and yaw",
                format!("add {} if that is what you mean", examples.join(", ")),
            )
        })
    }

    pub(crate) fn duplicate_part(span: Span, name: &str) -> Self {
        Self::told(ProblemCode::DuplicateComponent, span, || {
            Words::new(
                format!("{name} appears twice"),
                "each name once",
                format!("remove one {name}"),
            )
        })
    }

    pub(crate) fn mixed_parts(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedNames,
            span,
            "two descriptions of a rotation are mixed here",
            "axis and angle, or roll, pitch and yaw",
            "keep one of them",
        )
    }

    pub(crate) fn unknown_keyword(span: Span, word: &str) -> Self {
        Self::told(ProblemCode::UnknownWord, span, || {
            let word = shorten(word, QUOTED_CHARACTERS);
            Words::new(
                format!("{word} does not say what these numbers are"),
                "four numbers, or a known word before the numbers",
                ANNOUNCEMENTS,
            )
        })
    }

    pub(crate) fn unknown_arguments(span: Span, name: &str, expected: &str) -> Self {
        Self::told(ProblemCode::WrongCount, span, || {
            let name = shorten(name, QUOTED_CHARACTERS);
            Words::new(
                format!("wrong arguments for {name}"),
                expected,
                "write them in this order, or the rotation in words: 45deg about z",
            )
        })
    }

    pub(crate) fn axis_not_normalised(span: Span, name: &str) -> Self {
        Self::told(ProblemCode::NotARotation, span, || {
            let name = shorten(name, QUOTED_CHARACTERS);
            Words::new(
                format!("{name} does not normalise its axis: this one makes no rotation"),
                "an axis of length 1",
                "divide the axis by its length, or write the rotation in words: 45deg about [1, 1, 0]",
            )
        })
    }

    pub(crate) fn unit_of_tangents(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedUnits,
            span,
            "these three numbers are tangents, which have no unit",
            "three numbers without a unit",
            "remove the unit, or write the angle: rotvec 0 0 45deg, halfangle 0 0 22.5deg",
        )
    }

    pub(crate) fn rodrigues_vector(span: Span) -> Self {
        Self::new(
            ProblemCode::UnknownWord,
            span,
            "a Rodrigues vector may be a rotation vector (OpenCV) or a Gibbs vector",
            "a name with one meaning",
            "write rotvec 0 0 0.785, or gibbs 0 0 0.414",
        )
    }

    pub(crate) fn second_unit(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedUnits,
            span,
            "this angle already has a unit",
            "one unit for each angle",
            "remove one of them",
        )
    }

    pub(crate) fn angle_and_number(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedUnits,
            span,
            "one term of this sum has a unit, the other has none",
            "a unit after every term",
            "write a unit after both: 45deg + 0.5deg",
        )
    }

    pub(crate) fn degrees_of_pi(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedUnits,
            span,
            "a multiple of π is in radians, but the unit is degrees",
            "a multiple of π without a unit, or a number of degrees",
            "remove the unit, or write the number of degrees",
        )
    }

    pub(crate) fn mixed_units(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedUnits,
            span,
            "the angles have different units",
            "all angles in degrees, or all in radians",
            "use one unit for all of them (π means radians)",
        )
    }

    pub(crate) fn missing_unit(span: Span, unit: AngleUnit) -> Self {
        Self::told(ProblemCode::MixedUnits, span, || {
            let name = match unit {
                AngleUnit::Degrees => "deg",
                AngleUnit::Radians => "rad",
            };
            Words::new(
                "this angle has no unit, but another one has",
                "a unit after every angle, or one at the end for all, after a space",
                format!("write {name} right after it, or once at the end after a space"),
            )
        })
    }
}

/// What a count of bare numbers may have been meant as.
fn count_of_rotation(found: usize) -> (&'static str, &'static str) {
    const FOUR: &str = "the four numbers of a quaternion";
    const FOUR_OR_NINE: &str = "four numbers of a quaternion, or nine of a matrix";
    match found {
        3 => (FOUR, ANNOUNCEMENTS),
        0..=2 => (FOUR, "add the missing numbers, or name them: 0.92 + 0.38k"),
        5 => (
            FOUR,
            "keep the four numbers of one quaternion; the decimal sign is a point",
        ),
        7 | 8 => (
            FOUR_OR_NINE,
            "keep the four numbers of a pose's quaternion, without time and position",
        ),
        12 | 16 => (FOUR_OR_NINE, POSE),
        _ => (
            FOUR_OR_NINE,
            "keep the numbers of one rotation; the decimal sign is a point",
        ),
    }
}
