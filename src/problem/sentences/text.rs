//! The sentences of problems of text and numbers.

use crate::problem::fault::Fault;
use crate::problem::sentences::matrix::numbers;
use crate::problem::{ProblemCode, QUOTED_CHARACTERS, Span, Wanted, shorten};

impl Fault {
    pub(crate) fn empty_text(span: Span, wanted: Wanted) -> Self {
        Self::new(
            ProblemCode::EmptyText,
            span,
            "there is no text here",
            wanted.in_words(),
            wanted.example(),
        )
    }

    pub(crate) fn text_too_long(span: Span, bytes: usize, most: usize) -> Self {
        Self::new(
            ProblemCode::TextTooLong,
            span,
            format!("the text has {bytes} bytes; at most {most} are read"),
            "one quaternion or one vector",
            "paste only the lines that hold the numbers",
        )
    }

    pub(crate) fn nested_too_deep(span: Span, most: usize) -> Self {
        Self::new(
            ProblemCode::NestedTooDeep,
            span,
            format!("more than {most} brackets are open at this place"),
            format!("at most {most} brackets inside each other"),
            "remove the outer brackets",
        )
    }

    pub(crate) fn method(span: Span) -> Self {
        Self::new(
            ProblemCode::UnexpectedCharacter,
            span,
            "nothing that follows the value is applied here",
            "the value alone",
            "write the numbers that come out of it",
        )
    }

    pub(crate) fn mixed_separators(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "commas stand between some of the numbers and only spaces between others",
            "commas between all the numbers, or between none",
            "write a point for the decimal sign (0.92), or put in the missing commas",
        )
    }

    pub(crate) fn factor_before_line(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "this factor belongs to all the numbers of the next lines",
            "the numbers themselves",
            "multiply the numbers by it (a common factor of a quaternion does not change the rotation)",
        )
    }

    pub(crate) fn several_values(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedNames,
            span,
            "these components belong to more than one value",
            "the components of one quaternion or one vector",
            "keep only its lines, such as those of the orientation",
        )
    }

    pub(crate) fn unexpected(span: Span, found: &str) -> Self {
        let found = shorten(found, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::Unexpected,
            span,
            format!("{found} cannot stand here"),
            "a number or a name",
            "remove it, or write what is missing before it",
        )
    }

    pub(crate) fn list_for_number(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "a list cannot stand here",
            "a number",
            "write the numbers one after the other, without these brackets",
        )
    }

    pub(crate) fn unit_for_number(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "an imaginary unit cannot stand here",
            "a real number",
            "write the number alone: the name says which component it is",
        )
    }

    pub(crate) fn argument_count(span: Span, function: &str) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            format!("{function} takes one number"),
            "one number in the brackets",
            format!("write {function} of one number"),
        )
    }

    pub(crate) fn missing_sign(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "there is no + or - before this term",
            "a sign between the terms of a sum, as in 0.92 + 0.38k",
            "write + or - before it",
        )
    }

    pub(crate) fn unexpected_end(span: Span) -> Self {
        Self::new(
            ProblemCode::UnexpectedEnd,
            span,
            "the text stops where a number should follow",
            "a number",
            "write the number that is missing, or remove the last sign",
        )
    }

    pub(crate) fn unclosed_bracket(span: Span, opening: &str, closing: &str) -> Self {
        Self::new(
            ProblemCode::UnclosedBracket,
            span,
            format!("the bracket {opening} is never closed"),
            format!("a closing {closing}"),
            format!("add {closing} at the end, or remove this {opening}"),
        )
    }

    pub(crate) fn unmatched_bracket(span: Span, found: &str, open: Option<&str>) -> Self {
        match open {
            Some(closing) => Self::new(
                ProblemCode::UnmatchedBracket,
                span,
                format!("the bracket that is open here is not closed by {found}"),
                format!("a closing {closing}"),
                format!("write {closing} in its place"),
            ),
            None => Self::new(
                ProblemCode::UnmatchedBracket,
                span,
                format!("the bracket {found} closes nothing"),
                "an opening bracket before it",
                "remove it",
            ),
        }
    }

    pub(crate) fn unknown_word(span: Span, word: &str) -> Self {
        let word = shorten(word, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::UnknownWord,
            span,
            format!("{word} is not a number, a unit or a function that is known here"),
            "a number; i, j, k; pi, tau; sqrt, abs, sin, cos, tan, asin, acos, atan",
            "write the number itself",
        )
    }

    pub(crate) fn duplicate_component(span: Span, name: &str) -> Self {
        Self::new(
            ProblemCode::DuplicateComponent,
            span,
            format!("the component {name} is given twice"),
            "each component once",
            format!("remove one {name}, or rename it"),
        )
    }

    pub(crate) fn missing_component(span: Span, wanted: Wanted, names: &[&str]) -> Self {
        let missing = names.join(", ");
        let verb = if names.len() == 1 { "is" } else { "are" };
        Self::new(
            ProblemCode::MissingComponent,
            span,
            format!("{missing} {verb} missing"),
            format!("all of {}", wanted.names()),
            format!("add {}=0 if that is what is meant", names.join("=0, ")),
        )
    }

    pub(crate) fn unknown_component(span: Span, wanted: Wanted, name: &str) -> Self {
        let name = shorten(name, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::UnknownComponent,
            span,
            format!("{name} is not a component"),
            format!("the names {}", wanted.names()),
            format!("use the names {}, or only numbers", wanted.names()),
        )
    }

    pub(crate) fn derived_label(span: Span, name: &str) -> Self {
        let name = shorten(name, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::UnknownWord,
            span,
            format!("{name} names what was made of a rotation: a rate, a spread, an inverse"),
            "the numbers of the rotation itself",
            "write them without this name if they are what you want to read",
        )
    }

    pub(crate) fn unknown_argument(span: Span, name: &str) -> Self {
        let name = shorten(name, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::UnknownComponent,
            span,
            format!("the argument {name} is not known here, and it may change the numbers"),
            "the numbers of the rotation and their unit",
            "remove it, or write the rotation in words: ZYX 30deg 20deg 10deg",
        )
    }

    pub(crate) fn not_one_number(span: Span, found: usize) -> Self {
        Self::new(
            ProblemCode::WrongCount,
            span,
            format!("{} in place of 1", numbers(found)),
            "one number",
            "0.5, 1/√2 or sin(pi/8)",
        )
    }

    pub(crate) fn decimal_comma(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "a comma stands in this angle, and it separates numbers here",
            "one angle, such as 45.5deg",
            "write a point for the decimal sign",
        )
    }

    pub(crate) fn mixed_names(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedNames,
            span,
            "this number has no name while others have one",
            "a name for every number, or for none",
            "name it: w=, x=, y= or z=",
        )
    }

    pub(crate) fn division_by_zero(span: Span) -> Self {
        Self::new(
            ProblemCode::DivisionByZero,
            span,
            "this divides by zero",
            "a divisor that is not zero",
            "write the number that is meant",
        )
    }

    pub(crate) fn not_a_number(span: Span, written: &str) -> Self {
        let written = shorten(written, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::NotANumber,
            span,
            format!("{written} is not a real number"),
            "a finite number",
            "look where it was computed: a NaN often comes from a zero norm or an acos beyond 1",
        )
    }

    pub(crate) fn no_real_value(span: Span, function: &str) -> Self {
        Self::new(
            ProblemCode::NotANumber,
            span,
            format!("{function} of this number is not a real number"),
            "sqrt of 0 or more; asin and acos of -1 to 1",
            "write the number that is meant",
        )
    }

    pub(crate) fn infinite(span: Span) -> Self {
        Self::new(
            ProblemCode::Infinite,
            span,
            "infinity is not a component of a rotation",
            "a finite number",
            "look where it was computed: an infinity often comes from a division by zero",
        )
    }

    pub(crate) fn too_large(span: Span) -> Self {
        Self::new(
            ProblemCode::TooLarge,
            span,
            "this is larger than any double (about 1.8e308)",
            "a number that a double can hold",
            "write a smaller number; the numbers of a quaternion may be divided by a common factor",
        )
    }

    pub(crate) fn too_small(span: Span) -> Self {
        Self::new(
            ProblemCode::TooSmall,
            span,
            "this is not zero, yet a double would make it zero (below about 5e-324)",
            "a number that a double can hold, or 0",
            "write 0; the numbers of a quaternion may be multiplied by a common factor",
        )
    }

    pub(crate) fn product_of_units(span: Span) -> Self {
        Self::new(
            ProblemCode::ProductOfUnits,
            span,
            "a product of imaginary units has another sign in each convention (ij = k or ij = -k)",
            "at most one of i, j, k in each term",
            "write the components, or put the two factors into the Compose view",
        )
    }
}
