//! Problems as lines of text, with carets under the place.

use crate::problem::fault::Fault;
use crate::problem::suggestion::Suggestion;
use crate::problem::{Problem, floor_boundary, shorten};
use unicode_width::UnicodeWidthStr;

/// How much of a long line [`Problem::render`] shows on each side of the place, in characters.
const EXCERPT_CHARACTERS: usize = 32;

impl Problem {
    /// The problem as lines of text: the message, the line at fault with carets under the place,
    /// what was expected and what to try, and the texts to write where there are any.
    ///
    /// ```
    /// # use quatlas::{analyze, Convention, Outcome, ReadRequest, Request};
    /// let text = "🙂 0 0 1";
    /// let request = Request::Read(ReadRequest::new(text, "1 0 0", Convention::HAMILTON));
    /// let Outcome::Problems(found) = analyze(&request) else { panic!() };
    /// let lines = found.problems[0].render(text);
    /// assert!(lines.contains("\n  | 🙂 0 0 1\n  | ^^\n"), "{lines}");
    /// ```
    #[must_use]
    pub fn render(&self, text: &str) -> String {
        self.fault().render(text)
    }

    /// The same without its field.
    fn fault(&self) -> Fault {
        Fault {
            code: self.code,
            span: self.span,
            message: self.message.clone(),
            expected: self.expected.clone(),
            hint: self.hint.clone(),
            suggestion: self.suggestion.clone(),
            choices: self.choices.clone(),
        }
    }
}

impl Fault {
    /// The same lines as those of [`Problem::render`].
    ///
    /// ```
    /// # use quatlas::parse_vector;
    /// let lines = parse_vector("1 0 ½3").unwrap_err().render("1 0 ½3");
    /// assert!(lines.contains("\n  | 1 0 ½3\n  |     "), "{lines}");
    /// ```
    #[must_use]
    pub fn render(&self, text: &str) -> String {
        let start = floor_boundary(text, self.span.start);
        let end = floor_boundary(text, self.span.end).max(start);
        let line_start = text[..start].rfind('\n').map_or(0, |at| at + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |at| start + at);
        // A tab would move the carets: every control character is shown as one space.
        let plain = |part: &str| part.replace(char::is_control, " ");
        let before = plain(&text[line_start..start]);
        let marked = plain(&text[start..end.min(line_end)]);
        let after = plain(&text[end.min(line_end)..line_end]);

        let lead = match before.char_indices().nth_back(EXCERPT_CHARACTERS - 1) {
            Some((at, _)) if at > 0 => format!("…{}", &before[at..]),
            _ => before,
        };
        let marked = shorten(&marked, EXCERPT_CHARACTERS);
        let tail = shorten(&after, EXCERPT_CHARACTERS);
        let carets = "^".repeat(marked.width().max(1));
        let suggestions = self.suggestion.as_deref().into_iter();
        let write: String = suggestions.chain(&self.choices).map(to_write).collect();
        format!(
            "{}: {}\n  | {}{}{}\n  | {}{}\nexpected: {}\ntry: {}\n{write}",
            self.code.name(),
            self.message,
            lead,
            marked,
            tail,
            " ".repeat(lead.width()),
            carets,
            self.expected,
            self.hint,
        )
    }
}

/// `write:` or, of one of several, `write row 2:`, and the text on the next line.
fn to_write(Suggestion { text, label, .. }: &Suggestion) -> String {
    let label = label.iter().map(|label| format!(" {label}"));
    format!("write{}:\n{text}\n", label.collect::<String>())
}
