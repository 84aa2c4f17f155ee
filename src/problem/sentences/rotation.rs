//! The sentences of the problems that are about rotations and what stands for them.

use crate::convention::angle::AngleUnit;
use crate::problem::fault::Fault;
use crate::problem::sentences::matrix::{UPPER_LEFT, numbers};
use crate::problem::{ProblemCode, QUOTED_CHARACTERS, Span, Wanted, shorten};

/// The words that announce what the numbers are, each with an example.
const ANNOUNCEMENTS: &str = "say what they are: 45deg about z, rotvec 0 0 0.785, \
                             ZYX 30deg 20deg 10deg, rpy 10deg 20deg 30deg, matrix 1 0 0 …";

const AXIS: &str = "an axis: x, y, z, -x, …, or three numbers";

impl Fault {
    pub(crate) fn not_applied(span: Span, name: &str, wanted: Wanted) -> Self {
        let name = shorten(name, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::UnknownWord,
            span,
            format!("{name} is not applied here, so its numbers would mean something else"),
            wanted.in_words(),
            match wanted {
                Wanted::Quaternion => {
                    "write the numbers that come out of it, or the rotation in words: \
                     45deg about z, ZYX 30deg 20deg 10deg"
                }
                Wanted::Vector => "write the numbers of the vector",
            },
        )
    }

    pub(crate) fn not_a_quaternion(span: Span, what: &str) -> Self {
        Self::new(
            ProblemCode::NotAQuaternion,
            span,
            format!("this is {what}, and a quaternion is wanted here"),
            "a quaternion: four numbers, named components, or a sum such as 0.92 + 0.38k",
            "write the four numbers of its quaternion",
        )
    }

    pub(crate) fn number_before_list(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "a number stands before this list: a factor, a count or an index",
            "the list alone",
            "multiply the numbers by it if it is a factor; otherwise remove it",
        )
    }

    pub(crate) fn call_before_list(span: Span, name: &str) -> Self {
        let name = shorten(name, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::UnknownWord,
            span,
            format!("nothing says what {name} does with the list after it"),
            "the list alone, or a call that holds it",
            "write the numbers that come out of it; remove it if it only counts or numbers the list",
        )
    }

    pub(crate) fn angle_for_number(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "an angle cannot stand here",
            "a number without a unit",
            "say what the angle belongs to: 45° about z, ZYX 30° 20° 10°, cos(22.5°) + sin(22.5°) k",
        )
    }

    pub(crate) fn axis_and_angle(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "a vector and then a number in this call are an axis and an angle of unknown unit",
            "the four numbers of a quaternion",
            "write the turn in words: 45deg about [0, 0, 1]",
        )
    }

    pub(crate) fn axis_angle_or_quaternion(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "a vector of length 1 and a number are an axis and its angle, or a quaternion that is \
             not normalised",
            "a word that says which, or numbers that only one of them can have",
            "write axis-angle [0, 0, 1] 0.7 for the first, w=0.7, x=0, y=0, z=1 for the second",
        )
    }

    pub(crate) fn wrong_count(span: Span, wanted: Wanted, found: usize) -> Self {
        let (expected, hint) = match wanted {
            Wanted::Quaternion => count_of_rotation(found),
            Wanted::Vector if found > 3 => (
                "three numbers: x, y, z",
                "keep the three numbers of one vector; a decimal sign is a point, not a comma",
            ),
            Wanted::Vector => ("three numbers: x, y, z", "add what is missing: 1 0 0"),
        };
        let message = if wanted == Wanted::Quaternion && found > 5 && found != 9 {
            format!("{found} numbers are no quaternion, which has 4, and no matrix, which has 9")
        } else {
            format!("{} in place of {}", numbers(found), wanted.count())
        };
        Self::new(ProblemCode::WrongCount, span, message, expected, hint)
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

    pub(crate) fn zero_quaternion(span: Span) -> Self {
        Self::new(
            ProblemCode::ZeroQuaternion,
            span,
            "all four components are zero: this is not a rotation",
            "at least one component that is not zero",
            "the quaternion of no turn is w=1, x=0, y=0, z=0",
        )
    }

    pub(crate) fn zero_axis(span: Span) -> Self {
        Self::new(
            ProblemCode::ZeroAxis,
            span,
            "an axis of length zero names no direction",
            "at least one number that is not zero",
            "write the axis, such as [0, 0, 1]; no turn at all is 0 about z",
        )
    }

    pub(crate) fn no_axis(span: Span) -> Self {
        Self::new(
            ProblemCode::UnexpectedEnd,
            span,
            "there is no axis",
            AXIS,
            "write it: 45deg about z, 45deg about [1, 1, 0]",
        )
    }

    pub(crate) fn no_angle(span: Span) -> Self {
        Self::new(
            ProblemCode::UnexpectedEnd,
            span,
            "there is no angle",
            "an angle and an axis, as in 45deg about z",
            "write the angle, such as 45deg or pi/4",
        )
    }

    pub(crate) fn unknown_axis(span: Span, word: &str) -> Self {
        let word = shorten(word, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::UnknownWord,
            span,
            format!("{word} is not an axis"),
            AXIS,
            "write the axis as three numbers: [0, 0, 1] is z",
        )
    }

    pub(crate) fn count_of_angles(span: Span, found: usize, what: &str) -> Self {
        Self::new(
            ProblemCode::WrongCount,
            span,
            format!("{} in place of 3", numbers(found)),
            what,
            if found < 3 {
                "add what is missing; 0 is an angle too"
            } else {
                "keep the three of one rotation; a decimal sign is a point, not a comma"
            },
        )
    }

    pub(crate) fn one_angle(span: Span) -> Self {
        Self::new(
            ProblemCode::WrongCount,
            span,
            "these are several values in place of one angle",
            "one angle, such as 45deg, 0.785 or pi/4",
            "keep the angle alone",
        )
    }

    pub(crate) fn axis_angle_parts(span: Span) -> Self {
        Self::new(
            ProblemCode::WrongCount,
            span,
            "an axis and an angle were announced, and this is something else",
            "three numbers for the axis and one for the angle",
            "write axis-angle [0, 0, 1] 45deg, or 45deg about z",
        )
    }

    pub(crate) fn missing_part(span: Span, names: &[&str]) -> Self {
        let verb = if names.len() == 1 { "is" } else { "are" };
        let examples: Vec<_> = names.iter().map(|name| format!("{name}=0")).collect();
        Self::new(
            ProblemCode::MissingComponent,
            span,
            format!("{} {verb} missing", names.join(", ")),
            "all of roll, pitch and yaw",
            format!("add {} if that is what is meant", examples.join(", ")),
        )
    }

    pub(crate) fn duplicate_part(span: Span, name: &str) -> Self {
        Self::new(
            ProblemCode::DuplicateComponent,
            span,
            format!("{name} is given twice"),
            "each part once",
            format!("remove one {name}"),
        )
    }

    pub(crate) fn mixed_parts(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedNames,
            span,
            "this belongs to another description of a rotation than what stands before it",
            "axis and angle, or roll, pitch and yaw",
            "keep one of them",
        )
    }

    pub(crate) fn unknown_keyword(span: Span, word: &str) -> Self {
        let word = shorten(word, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::UnknownWord,
            span,
            format!("{word} does not say what these numbers are"),
            "four numbers of a quaternion, or a word that is known here before the numbers",
            ANNOUNCEMENTS,
        )
    }

    pub(crate) fn unknown_arguments(span: Span, name: &str, expected: &str) -> Self {
        let name = shorten(name, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::WrongCount,
            span,
            format!("these are not the arguments of {name}"),
            expected,
            "write them in this order, or the rotation in words: 45deg about z",
        )
    }

    pub(crate) fn axis_not_normalised(span: Span, name: &str) -> Self {
        let name = shorten(name, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::NotARotation,
            span,
            format!("{name} does not normalise its axis, so with this one it makes no rotation"),
            "an axis of length 1",
            "divide the axis by its length, or write the turn in words: 45deg about [1, 1, 0]",
        )
    }

    pub(crate) fn unit_of_tangents(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedUnits,
            span,
            "these three numbers are tangents of a part of the angle, which have no unit",
            "three numbers without a unit",
            "remove the unit, or write the angle itself: rotvec 0 0 45deg, halfangle 0 0 22.5deg",
        )
    }

    pub(crate) fn rodrigues_vector(span: Span) -> Self {
        Self::new(
            ProblemCode::UnknownWord,
            span,
            "a Rodrigues vector is the rotation vector for some (OpenCV) and the Gibbs vector, \
             tan(θ/2) times the axis, for others",
            "a name with one meaning",
            "write rotvec 0 0 0.785, or gibbs 0 0 0.414",
        )
    }

    pub(crate) fn second_unit(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedUnits,
            span,
            "this angle has a unit already",
            "one unit for each angle",
            "remove one of them",
        )
    }

    pub(crate) fn angle_and_number(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedUnits,
            span,
            "one term of this sum has a unit of angle and the other has none",
            "a unit beside every term",
            "write the unit after each of them: 45deg + 0.5deg",
        )
    }

    pub(crate) fn degrees_of_pi(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedUnits,
            span,
            "a multiple of π is an angle in radians, and here it is given in degrees",
            "a multiple of π without a unit, or a number of degrees",
            "remove the unit, or write the number of degrees",
        )
    }

    pub(crate) fn mixed_units(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedUnits,
            span,
            "this angle has another unit than the others",
            "all the angles in degrees, or all in radians",
            "write all of them in one unit (a π means radians)",
        )
    }

    pub(crate) fn missing_unit(span: Span, unit: AngleUnit) -> Self {
        let name = match unit {
            AngleUnit::Degrees => "deg",
            AngleUnit::Radians => "rad",
        };
        Self::new(
            ProblemCode::MixedUnits,
            span,
            "this angle has no unit while another has one",
            "a unit beside every angle, or one apart at the end for all",
            format!(
                "write {name} right after it, or a space and {name} once after the last number"
            ),
        )
    }
}

/// What a count of bare numbers may have been meant as.
fn count_of_rotation(found: usize) -> (&'static str, &'static str) {
    const FOUR: &str = "four numbers: w and x, y, z";
    const FOUR_OR_NINE: &str = "four numbers of a quaternion, or nine of a matrix";
    match found {
        3 => (FOUR, ANNOUNCEMENTS),
        0..=2 => (
            FOUR,
            "add what is missing, or name what is there: 0.92 + 0.38k",
        ),
        5 => (
            FOUR,
            "keep the four numbers of one quaternion; a decimal sign is a point, not a comma",
        ),
        12 | 16 => (FOUR_OR_NINE, UPPER_LEFT),
        _ => (
            FOUR_OR_NINE,
            "keep the numbers of one rotation; a decimal sign is a point, not a comma",
        ),
    }
}
