//! The sentences of problems of text and numbers.

use crate::problem::fault::{Fault, Words};
use crate::problem::sentences::matrix::numbers;
use crate::problem::{ProblemCode, QUOTED_CHARACTERS, Span, Wanted, shorten};

impl Fault {
    pub(crate) fn empty_text(span: Span, wanted: Wanted) -> Self {
        Self::told(ProblemCode::EmptyText, span, || {
            Words::new("the text is empty", wanted.in_words(), wanted.example())
        })
    }

    pub(crate) fn text_too_long(span: Span, bytes: usize, most: usize) -> Self {
        Self::told(ProblemCode::TextTooLong, span, || {
            Words::new(
                format!("the text has {bytes} bytes; at most {most} are read"),
                "one quaternion or one vector",
                "paste only the lines with the numbers",
            )
        })
    }

    pub(crate) fn nested_too_deep(span: Span, most: usize) -> Self {
        Self::told(ProblemCode::NestedTooDeep, span, || {
            Words::new(
                format!("more than {most} nested brackets"),
                format!("at most {most} nested brackets"),
                "remove the outer brackets",
            )
        })
    }

    pub(crate) fn method(span: Span) -> Self {
        Self::new(
            ProblemCode::UnexpectedCharacter,
            span,
            "calls on a value are not supported here",
            "the value alone",
            "write the resulting numbers",
        )
    }

    pub(crate) fn mixed_separators(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "commas between some numbers, only spaces between others",
            "commas between all numbers, or between none",
            "use a decimal point (0.92), or add the missing commas",
        )
    }

    pub(crate) fn commas_and_semicolons(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "commas and semicolons between these numbers: decimal commas, or a list",
            "numbers with decimal points, and one kind of separator",
            "use a decimal point (0.92), or separate all numbers alike",
        )
    }

    pub(crate) fn decimal_pairs(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "four numbers, or two with decimal commas",
            "a space after each comma that separates, a decimal point in each number",
            "write 0, 7, 0, 7 or 0.7, 0.7",
        )
    }

    /// `1 1/2`
    pub(crate) fn mixed_number(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "a whole number and a fraction: one number, or two",
            "commas between the numbers, or one fraction",
            "write 1, 1/2 for two numbers, 3/2 for one",
        )
    }

    /// `1/2/2026`
    pub(crate) fn date(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "two divisions in a row: a date, or a number",
            "the numbers of the rotation",
            "remove the date, or write the number that is meant",
        )
    }

    /// `0.6+0.8j`
    pub(crate) fn complex_number(span: Span) -> Self {
        Self::new(
            ProblemCode::UnknownWord,
            span,
            "a complex number, or a quaternion with one of its units",
            "all the units of a quaternion, or spaces around the sign",
            "write 0.6 + 0i + 0.8j + 0k if it is a quaternion",
        )
    }

    pub(crate) fn factor_before_line(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "this factor applies to all numbers on the next lines",
            "the numbers themselves",
            "multiply the numbers by it; for a quaternion it can be left out",
        )
    }

    pub(crate) fn several_values(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedNames,
            span,
            "these components belong to more than one value",
            "the components of one quaternion or one vector",
            "keep only one of them, such as the orientation",
        )
    }

    pub(crate) fn unexpected(span: Span, found: &str) -> Self {
        Self::told(ProblemCode::Unexpected, span, || {
            // `0..38`, or two numbers that touch.
            let is_fraction = found.starts_with('.');
            let found = shorten(found, QUOTED_CHARACTERS);
            let (message, hint) = if is_fraction {
                (
                    format!("unexpected “{found}” (did you mean 0{found}?)"),
                    "remove one point, or write a space between two numbers",
                )
            } else {
                (
                    format!("unexpected “{found}”"),
                    "remove it, or add what is missing before it",
                )
            };
            Words::new(message, "a number or a name", hint)
        })
    }

    pub(crate) fn list_for_number(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "unexpected list",
            "a number",
            "write the numbers one after the other, without these brackets",
        )
    }

    pub(crate) fn unit_for_number(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "unexpected imaginary unit",
            "a real number",
            "write the number without i, j or k",
        )
    }

    pub(crate) fn argument_count(span: Span, function: &str) -> Self {
        Self::told(ProblemCode::Unexpected, span, || {
            Words::new(
                format!("{function} takes one number"),
                "one number in the brackets",
                format!("write one number: {function}(0.5)"),
            )
        })
    }

    pub(crate) fn missing_sign(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "missing + or - before this term",
            "a sign between the terms, as in 0.92 + 0.38k",
            "write + or - before it",
        )
    }

    pub(crate) fn unexpected_end(span: Span) -> Self {
        Self::new(
            ProblemCode::UnexpectedEnd,
            span,
            "the text ends where a number is expected",
            "a number",
            "add the missing number, or remove the last sign",
        )
    }

    pub(crate) fn unclosed_bracket(span: Span, opening: &str, closing: &str) -> Self {
        Self::told(ProblemCode::UnclosedBracket, span, || {
            Words::new(
                format!("the bracket {opening} is never closed"),
                format!("a closing {closing}"),
                format!("add {closing} at the end, or remove this {opening}"),
            )
        })
    }

    pub(crate) fn unmatched_bracket(span: Span, found: &str, open: Option<&str>) -> Self {
        Self::told(ProblemCode::UnmatchedBracket, span, || match open {
            Some(closing) => Words::new(
                format!("{found} does not close the open bracket"),
                format!("a closing {closing}"),
                format!("write {closing} instead"),
            ),
            None => Words::new(
                format!("{found} without an opening bracket"),
                "an opening bracket before it",
                "remove it",
            ),
        })
    }

    pub(crate) fn unknown_word(span: Span, word: &str) -> Self {
        Self::told(ProblemCode::UnknownWord, span, || {
            let word = shorten(word, QUOTED_CHARACTERS);
            Words::new(
                format!("{word} is not a known number, unit or function"),
                "a number; i, j, k; pi, tau; sqrt, abs, sin, cos, tan, asin, acos, atan",
                "write the number",
            )
        })
    }

    pub(crate) fn duplicate_component(span: Span, name: &str) -> Self {
        Self::told(ProblemCode::DuplicateComponent, span, || {
            Words::new(
                format!("the component {name} appears twice"),
                "each component once",
                format!("remove one {name}, or rename it"),
            )
        })
    }

    pub(crate) fn missing_component(span: Span, wanted: Wanted, names: &[&str]) -> Self {
        Self::told(ProblemCode::MissingComponent, span, || {
            let missing = names.join(", ");
            let verb = if names.len() == 1 { "is" } else { "are" };
            Words::new(
                format!("{missing} {verb} missing"),
                format!("all of {}", wanted.names()),
                format!("add {}=0 if that is what you mean", names.join("=0, ")),
            )
        })
    }

    pub(crate) fn unknown_component(span: Span, wanted: Wanted, name: &str) -> Self {
        Self::told(ProblemCode::UnknownComponent, span, || {
            let name = shorten(name, QUOTED_CHARACTERS);
            Words::new(
                format!("{name} is not a component"),
                format!("the names {}", wanted.names()),
                format!("use the names {}, or numbers only", wanted.names()),
            )
        })
    }

    pub(crate) fn unknown_argument(span: Span, name: &str) -> Self {
        Self::told(ProblemCode::UnknownComponent, span, || {
            let name = shorten(name, QUOTED_CHARACTERS);
            Words::new(
                format!("unknown argument {name}, which may change the numbers"),
                "the numbers of the rotation and their unit",
                "remove it, or write the rotation in words: ZYX 30deg 20deg 10deg",
            )
        })
    }

    pub(crate) fn not_one_number(span: Span, found: usize) -> Self {
        Self::told(ProblemCode::WrongCount, span, || {
            Words::new(
                format!("{}: 1 is needed", numbers(found)),
                "one number",
                "0.5, 1/√2 or sin(pi/8)",
            )
        })
    }

    pub(crate) fn decimal_comma(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "a comma in this angle, which separates numbers here",
            "one angle, such as 45.5deg",
            "use a decimal point",
        )
    }

    pub(crate) fn mixed_names(span: Span) -> Self {
        Self::new(
            ProblemCode::MixedNames,
            span,
            "this number has no name, but others have",
            "a name for every number, or for none",
            "name it: w=, x=, y= or z=",
        )
    }

    pub(crate) fn division_by_zero(span: Span) -> Self {
        Self::new(
            ProblemCode::DivisionByZero,
            span,
            "division by zero",
            "a divisor other than zero",
            "write the number you mean",
        )
    }

    pub(crate) fn not_a_number(span: Span, written: &str) -> Self {
        Self::told(ProblemCode::NotANumber, span, || {
            let written = shorten(written, QUOTED_CHARACTERS);
            Words::new(
                format!("{written} is not a real number"),
                "a finite number",
                "check where it was computed: NaN often comes from a zero norm or acos beyond 1",
            )
        })
    }

    pub(crate) fn no_real_value(span: Span, function: &str) -> Self {
        Self::told(ProblemCode::NotANumber, span, || {
            Words::new(
                format!("{function} of this number is not real"),
                "sqrt of 0 or more; asin and acos of -1 to 1",
                "write the number you mean",
            )
        })
    }

    pub(crate) fn infinite(span: Span) -> Self {
        Self::new(
            ProblemCode::Infinite,
            span,
            "infinity is not allowed",
            "a finite number",
            "check where it was computed: infinity often comes from a division by zero",
        )
    }

    pub(crate) fn too_large(span: Span) -> Self {
        Self::new(
            ProblemCode::TooLarge,
            span,
            "too large for a double (more than about 1.8e308)",
            "a number in the range of a double",
            "write a smaller number; a quaternion may be divided by a common factor",
        )
    }

    pub(crate) fn too_small(span: Span) -> Self {
        Self::new(
            ProblemCode::TooSmall,
            span,
            "too small for a double (less than about 5e-324), but not zero",
            "a number in the range of a double, or 0",
            "write 0; a quaternion may be multiplied by a common factor",
        )
    }

    pub(crate) fn product_of_units(span: Span) -> Self {
        Self::new(
            ProblemCode::ProductOfUnits,
            span,
            "products of imaginary units depend on the convention (ij = k or ij = -k)",
            "at most one of i, j, k in each term",
            "write the components, or enter the two factors in Compose",
        )
    }
}
