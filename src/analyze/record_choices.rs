//! What is asked of a text with several rotations: which of them.

use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::problem::suggestion::{Remedy, Suggestion};
use crate::text::mend::written::rotation_text;
use crate::text::{ParsedQuaternion, ParsedRotation, Record, RecordRotation};
use nalgebra::Quaternion;

/// That there are several rotations, each as a text of its own.
pub(crate) fn several_rotations(record: &Record, text: &str) -> Fault {
    let span = Span::of_trimmed(text);
    let mut offered = Vec::new();
    for found in &record.rotations {
        if found.is_derived {
            continue;
        }
        let is_same = |other: &&RecordRotation| other.label == found.label;
        let label = if found.label.is_empty() {
            (offered.len() + 1).to_string()
        } else if record.rotations.iter().filter(is_same).count() > 1 {
            // `left: {quaternion: …}`, `right: {quaternion: …}`
            first_name(text, found.span.start)
        } else {
            found.label.clone()
        };
        offered.push(kept(label, rotation_text(&found.rotation)));
    }
    Fault::several_rotations(span, offered.len()).offering(|| offered)
}

/// The first name of the line in which something stands.
fn first_name(text: &str, place: usize) -> String {
    let before = text.get(..place).unwrap_or("");
    let line = &before[before.rfind('\n').map_or(0, |at| at + 1)..];
    let end = line.find([':', '=', '(']).unwrap_or(line.len());
    line[..end]
        .trim_matches([' ', '"', '-', '{', ','])
        .to_owned()
}

/// One of several rotations as a text of its own.
fn kept(label: String, text: String) -> Suggestion {
    Suggestion {
        label: Some(label),
        ..Suggestion::new(Remedy::ThisRotation, text)
    }
}

/// Four numbers by the names that they have in the other order.
pub(crate) fn other_order(parsed: &ParsedQuaternion) -> Suggestion {
    let coordinates = &parsed.quaternion;
    let numbers = [coordinates.w, coordinates.i, coordinates.j, coordinates.k];
    let [w, x, y, z] = parsed.order.other().components(parsed.order.array(numbers));
    let text = rotation_text(&ParsedRotation::Quaternion(ParsedQuaternion {
        quaternion: Quaternion::new(w, x, y, z),
        ..parsed.clone()
    }));
    Suggestion::new(Remedy::OtherOrder, text)
}

/// That there are several rows of a file: the names above and one of them is a text of its own.
pub(crate) fn several_rows(record: &Record, text: &str) -> Fault {
    let span = record.rows[0].to(record.rows[record.rows.len() - 1]);
    let mut offered = Vec::new();
    for at in [0, record.rows.len() - 1] {
        let mut with_head = String::new();
        if let Some(head) = record.head {
            with_head = text[head.start..head.end].to_owned();
            with_head.push('\n');
        }
        with_head.push_str(&text[record.rows[at].start..record.rows[at].end]);
        offered.push(kept(format!("row {}", at + 1), with_head));
    }
    Fault::several_rows(span, record.rows.len()).offering(|| offered)
}
