//! A whole block that a program printed: the rotation is found in it, and what else stands there is told.
//!
//! Any text is taken apart without a grammar (`scan`, `outline`, `group`): runs of numbers and single numbers
//! by name, each with the names of what holds it. What they are is said by the formats (data, in
//! `text/formats`) whose marks stand in the text, by the names, and last by the numbers themselves: a matrix
//! that is orthonormal, four numbers of norm 1.

// What a program prints, as data.
pub(crate) mod format;

// What stands apart and belongs together.
mod apart;

// What a comment says that numbers are.
mod described;

// Quantities to what they are.
mod find;

// What is understood of a quantity.
mod found;

// The tree to quantities.
mod group;

// What names say.
mod meaning;

// Single numbers by name.
mod named;

// Names to their words.
mod names;

// What numbers are that stand together.
mod of_group;

// What single numbers are by their names.
mod of_named;

// Tokens to a tree.
mod outline;

// Numbers to a rotation, as parts say.
mod parts;

// Runs of numbers, and single numbers by name.
mod quantity;

// What is said outside of names.
mod remark;

// Numbers that are rows of one matrix by name.
mod rows;

// Any text to tokens.
mod scan;

// Sequences of Euler angles in names.
mod sequences;

// What words say of all numbers.
mod settings;

// Sums of units.
mod sums;

// Rows under names.
mod table;

// One turn after the other.
mod turns;

use crate::convention::angle::AngleUnit;
use crate::convention::euler_sequence::EulerSequence;
use crate::convention::order::ComponentOrder;
use crate::problem::Span;
use crate::text::description::ParsedRotation;
use crate::text::record::described::{Described, order_by_comment};
use crate::text::record::find::found;
use crate::text::record::format::{Field, Format};
use crate::text::record::found::{Context, Found};
use crate::text::record::group::Quantities;
use crate::text::record::names::{identifiers_of, is_factor, words_of};
use crate::text::record::outline::outline;
use crate::text::record::parts::Made;
use crate::text::record::quantity::Group;
use crate::text::record::remark::{code_above, remark_behind};
pub(crate) use crate::text::record::remark::{
    made_above, made_by_code, made_by_remark, marked_label,
};
use crate::text::record::scan::{Token, scan};
use crate::text::record::settings::{
    Settings, has_duplicate, is_balanced, is_plain, order_of_words, unknown_orientation,
};
use crate::text::record::sums::sums;
use crate::text::record::table::{Sentence, Table};

/// A rotation of a record.
#[derive(Clone, Debug)]
pub(crate) struct RecordRotation {
    pub(crate) rotation: ParsedRotation,
    /// Whether nine numbers stood column by column.
    pub(crate) by_columns: bool,
    pub(crate) label: String,
    pub(crate) span: Span,
    /// Whether its name says that it was made of a rotation, or a sign that computes stands at it.
    pub(crate) is_derived: bool,
    /// The format that said it; one that no word marks is only assumed.
    pub(crate) format: Option<&'static Format>,
    /// What divides the rows of nine numbers.
    pub(crate) has_rows: bool,
    /// What is said behind it in its line.
    pub(crate) remark: Span,
    /// The line of code above that printed it.
    pub(crate) code: Option<Span>,
}

/// What else stands in a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum What {
    Position,
    Scale,
}

/// A quantity beside the rotation.
#[derive(Clone, Debug)]
pub(crate) struct Beside {
    pub(crate) what: What,
    pub(crate) label: String,
    pub(crate) numbers: [f64; 3],
    /// Whether it is told of the world, whichever way the rotation leads.
    pub(crate) is_in_world: bool,
}

/// Three Euler angles of which no sequence is told.
#[derive(Clone, Debug)]
pub(crate) struct LooseAngles {
    pub(crate) label: String,
    pub(crate) span: Span,
    pub(crate) numbers: [f64; 3],
    /// As far as it is told.
    pub(crate) unit: Option<AngleUnit>,
}

/// What was found in a text.
#[derive(Debug)]
pub(crate) struct Record {
    pub(crate) rotations: Vec<RecordRotation>,
    pub(crate) beside: Vec<Beside>,
    /// Euler angles of which no sequence is told.
    pub(crate) angles: Vec<LooseAngles>,
    /// How many quantities stand in the text: numbers that stand together, or that have names together.
    pub(crate) quantities: usize,
    /// How many numbers stand together, or have names together, at most.
    pub(crate) most_numbers: usize,
    /// The rows of a file where there are several.
    pub(crate) rows: Vec<Span>,
    /// The names above them.
    pub(crate) head: Option<Span>,
    /// Where the text says that the orientation is not known.
    pub(crate) unknown_orientation: Option<Span>,
}

/// How many rotations of a text are looked at; which of so many is meant has to be asked in any case.
const MOST_ROTATIONS: usize = 24;

/// What is declared of a text.
#[derive(Clone, Copy)]
pub(crate) struct DeclaredFormat<'d> {
    /// The order of four numbers where nothing tells it.
    pub(crate) order: ComponentOrder,
    /// The id of the library that printed it.
    pub(crate) library: Option<&'d str>,
}

/// What is found in a text; `declared` is the order of four numbers where nothing tells it.
pub(crate) fn record_of(
    text: &str,
    declared: DeclaredFormat<'_>,
    formats: &'static [&'static [Format]],
    plain: &'static [Field],
) -> Record {
    let tokens = scan(text);
    let mut quantities = Quantities::of(&outline(text, &tokens));
    let words = Words::of(&tokens);
    let mut ordering = None;
    let mut asked: Vec<&'static Format> = Vec::new();
    let mut sentences: Vec<Sentence> = Vec::new();
    for family in formats {
        for format in *family {
            let is_marked = is_marked(format, &words, text);
            if !is_marked && declared.library != Some(format.id) {
                continue;
            }
            if is_marked && ordering.is_none() && format.order.is_some() {
                ordering = Some(format);
            }
            asked.push(format);
            for field in format.fields {
                if let Field::Sentence(begins, names) = field {
                    sentences.push((begins, names));
                }
            }
        }
    }
    let mut rows = Vec::new();
    let mut head = None;
    if let Some(table) = Table::of(text, &sentences) {
        let inside = |span: Span| {
            table.head.start <= span.start
                && table.rows.last().is_some_and(|last| span.end <= last.end)
        };
        quantities.replace(inside, table.groups);
        rows = table.rows;
        head = Some(table.head);
    }
    if rows.is_empty() {
        rows = quantities.take_first_row(text);
    }
    quantities.take_remarks(text);
    let mut settings = Settings::of(&quantities.values);
    let is_sequence = |span: Span| text[span.start..span.end].parse::<EulerSequence>().is_ok();
    // `degrees='1'`
    for named in &quantities.named {
        for number in &named.members {
            match number.name.as_str() {
                // `Sequence = '321'`
                "sequence" if is_sequence(number.span) => {
                    settings.letters = Some(text[number.span.start..number.span.end].to_owned());
                }
                "order" | "layout" | "sequence" => settings.is_doubtful |= number.value >= 100.0,
                "first" => settings.is_doubtful = true,
                "degrees" if number.value == 1.0 => settings.unit = Some(AngleUnit::Degrees),
                "degrees" => settings.unit = Some(AngleUnit::Radians),
                _ => {}
            }
        }
    }
    let by_comment = Described::by_comment(text);
    let context = Context {
        described: by_comment
            .map(|(described, _)| described)
            .or(settings.described),
        ordering,
        formats: asked,
        declared: declared.order,
        order: settings
            .order
            .or_else(|| order_by_comment(text))
            .or_else(|| order_of_words(&tokens)),
        unit: settings.unit.or(by_comment.and_then(|(_, unit)| unit)),
        letters: settings.letters,
    };
    let sums = sums(text);
    let is_in_sum = |span: Span| {
        sums.iter()
            .any(|sum| sum.span.start <= span.start && span.end <= sum.span.end)
    };
    quantities.groups.retain(|group| !is_in_sum(group.span));
    let mut all = found(text, &quantities, &context, plain);
    all.retain(|found| !is_in_sum(found.span));
    // `delta_q: [1, 0, 0, 0] (Roll: 0, …)`: what a line adds in brackets is of the same kind.
    for at in 1..all.len() {
        let (before, own) = (all[at - 1].span, all[at].span);
        let between = text.get(before.end..own.start).unwrap_or("\n");
        all[at].is_derived |= all[at - 1].is_derived
            && all[at].label.is_empty()
            && between.contains('(')
            && !between.contains('\n');
    }
    all.extend_from_slice(&sums);
    let is_one_line = !text.trim().contains('\n');
    let is_doubtful = settings.is_doubtful
        || is_one_line && context.unit.is_some() && all.iter().any(is_quaternion)
        || is_one_line && has_duplicate(&quantities)
        || is_one_line && !text.contains("*^") && is_plain(&quantities, &context)
        || is_one_line && (!is_balanced(&tokens) || quantities.groups.iter().any(is_computed));
    let mut record = Record {
        rotations: Vec::new(),
        beside: Vec::new(),
        angles: Vec::new(),
        quantities: quantities.groups.len() + quantities.named.len(),
        most_numbers: quantities.most_numbers(),
        rows,
        head,
        unknown_orientation: unknown_orientation(&quantities),
    };
    for found in all {
        record.take(text, found, is_doubtful);
    }
    record
}

impl Record {
    /// Takes what was found; rotations in doubt are none.
    fn take(&mut self, text: &str, found: Found, is_doubtful: bool) {
        let is_in_world = matches!(found.made, Made::Centre(_));
        let (rotation, by_columns) = match found.made {
            Made::Rotation(rotation) => (rotation, false),
            Made::Columns(rotation) => (rotation, true),
            Made::Position(numbers) | Made::Centre(numbers) => {
                return self.beside.push(Beside {
                    what: What::Position,
                    label: found.label,
                    numbers,
                    is_in_world,
                });
            }
            Made::Scale(numbers) => {
                return self.beside.push(Beside {
                    what: What::Scale,
                    label: found.label,
                    numbers,
                    is_in_world,
                });
            }
            Made::Angles(numbers, unit) => {
                return self.angles.push(LooseAngles {
                    label: found.label,
                    span: found.span,
                    numbers,
                    unit,
                });
            }
            Made::Nothing => return,
        };
        if is_doubtful || self.rotations.len() >= MOST_ROTATIONS {
            return;
        }
        self.rotations.push(RecordRotation {
            rotation,
            by_columns,
            label: found.label,
            span: found.span,
            is_derived: found.is_derived || found.is_computed,
            format: found.format,
            has_rows: found.has_rows,
            remark: remark_behind(text, found.span.end),
            code: code_above(text, found.span.start),
        });
    }
}

/// What stands beside the factors of a product is looked at with all of them (`turns.rs`).
fn is_computed(group: &Group<'_>) -> bool {
    group.is_computed && !group.path.iter().any(|key| is_factor(key))
}

fn is_quaternion(found: &Found) -> bool {
    matches!(found.made, Made::Rotation(ParsedRotation::Quaternion(_)))
}

/// The words of a text in small letters, in alphabetical order.
struct Words(Vec<String>);

impl Words {
    fn of(tokens: &[Token<'_>]) -> Self {
        let mut words = Self(Vec::new());
        for token in tokens {
            for word in words_of(token.text) {
                words.add(word);
            }
            for identifier in identifiers_of(token.text) {
                words.add(identifier);
            }
            words.add(token.text.to_ascii_lowercase());
        }
        words
    }

    fn add(&mut self, word: String) {
        if let Err(at) = self.place_of(&word) {
            self.0.insert(at, word);
        }
    }

    fn has(&self, word: &str) -> bool {
        self.place_of(word).is_ok()
    }

    fn place_of(&self, word: &str) -> Result<usize, usize> {
        self.0.binary_search_by(|known| known.as_str().cmp(word))
    }
}

/// Whether the words by which a format is known stand in a text.
fn is_marked(format: &Format, words: &Words, text: &str) -> bool {
    format.marks.iter().all(|mark| {
        mark.split('|').any(|name| match name.strip_prefix('~') {
            Some(written) => text.contains(written),
            None => name.split(' ').all(|word| words.has(word)),
        })
    })
}
