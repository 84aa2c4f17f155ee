//! What is asked of a text with several rotations: which of them.

use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::problem::suggestion::{Remedy, Suggestion};
use crate::text::Record;
use crate::text::mend::written::rotation_text;

/// That there are several rotations, each as a text of its own.
pub(crate) fn several_rotations(record: &Record, text: &str) -> Fault {
    let span = Span::of_trimmed(text);
    let rotations = record.rotations.iter().filter(|found| !found.is_derived);
    let count = rotations.clone().count();
    Fault::several_rotations(span, count).offering(|| {
        rotations
            .enumerate()
            .map(|(at, found)| Suggestion {
                label: Some(if found.label.is_empty() {
                    format!("{}", at + 1)
                } else {
                    found.label.clone()
                }),
                ..Suggestion::new(Remedy::ThisRotation, rotation_text(&found.rotation))
            })
            .collect()
    })
}

/// That there are several rows of a file: the names above and one of them is a text of its own.
pub(crate) fn several_rows(record: &Record, text: &str) -> Fault {
    let span = record.rows[0].to(record.rows[record.rows.len() - 1]);
    Fault::several_rows(span, record.rows.len()).offering(|| {
        let head = record.head.map_or("", |head| &text[head.start..head.end]);
        let last = record.rows.len() - 1;
        [0, last]
            .into_iter()
            .map(|at| {
                let row = &text[record.rows[at].start..record.rows[at].end];
                let text = if head.is_empty() {
                    row.to_owned()
                } else {
                    format!("{head}\n{row}")
                };
                Suggestion {
                    label: Some(format!("row {}", at + 1)),
                    ..Suggestion::new(Remedy::ThisRotation, text)
                }
            })
            .collect()
    })
}
