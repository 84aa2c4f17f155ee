//! JSON that says in words what it holds.

use crate::problem::Span;
use crate::text::notation::latex::pad;
use crate::text::vocabulary::labels::is_derived;

/// JSON with what it says of itself as a comment, which says of the numbers what one in code would: a copy of the
/// page, or a test vector of it. Of that only the numbers are left: what was asked (`source`) and what comes out
/// (`expected`) stand beside them and are other rotations.
pub(super) fn of_json(text: &str) -> Option<String> {
    let is_test_vector = text.contains("\"testVector\"");
    let (before, says, after) = if is_test_vector {
        let numbers = value(text, "\"numbers\"", '}')?;
        let numbers = Span::from(numbers.start - 1..numbers.end + 1);
        (0, value(text, "\"is\"", '"')?, numbers)
    } else {
        let says = value(text, "\"comment\"", '"')?;
        let behind = says.end + 2;
        // What was made of a rotation is refused for its name.
        let mut words = text[says.start..says.end].split_whitespace();
        if text.get(says.end + 1..behind) != Some(",") || words.any(is_derived) {
            return None;
        }
        (
            text.find("\"comment\"")?,
            says,
            Span::from(behind..text.len()),
        )
    };
    let mut bare = text[..before].to_owned();
    for (start, part) in [
        (says.start - 2, "/*"),
        (says.start, &text[says.start..says.end]),
        (says.end, "*/"),
        (after.start, &text[after.start..after.end]),
        (text.len(), ""),
    ] {
        pad(&mut bare, start);
        bare.push_str(part);
    }
    (bare.len() == text.len()).then_some(bare)
}

/// The value of a member of JSON, without its quotes or braces.
fn value(text: &str, key: &str, close: char) -> Option<Span> {
    let behind = text.find(key)? + key.len();
    let start = behind + text[behind..].find(['"', '{'])? + 1;
    let end = start + text[start..].find(close)?;
    let value = &text[start..end];
    let is_plain = !value.contains(['\\', '{']) && !value.contains("*/");
    is_plain.then(|| Span::from(start..end))
}
