//! The line of code of a library, written with numbers and read back.

use crate::contract::Components;
use crate::convention::order::ComponentOrder;
use crate::decimal::literal;
use crate::problem::Span;
use crate::text::is_decimal;

const PLACES: [&str; 4] = ["{w}", "{x}", "{y}", "{z}"];

/// The line with the numbers in their places, each as the shortest text that reads back.
pub(crate) fn write(template: &str, components: &Components) -> String {
    let Components { w, x, y, z, .. } = components;
    let numbers = PLACES.iter().zip([w, x, y, z]);
    numbers.fold(template.to_owned(), |line, (place, number)| {
        line.replace(place, &literal(*number))
    })
}

/// The line with its numbers in this order, whatever the template's: for lines that only hold numbers, of
/// which nothing but a word beside them tells the order.
pub(crate) fn write_in_order(
    template: &str,
    components: &Components,
    order: ComponentOrder,
) -> String {
    let mut written = std::iter::successors(next_place(template), |(at, place)| {
        let (next, place) = next_place(&template[at + place.len()..])
            .map(|(further, next)| (at + place.len() + further, next))?;
        Some((next, place))
    });
    let Components { w, x, y, z, .. } = components;
    let numbers = order.array([w, x, y, z]);
    let mut line = String::new();
    let mut rest = 0;
    for number in numbers {
        if let Some((at, place)) = written.next() {
            line.push_str(&template[rest..at]);
            line.push_str(&literal(*number));
            rest = at + place.len();
        }
    }
    line + &template[rest..]
}

/// A line that is written like a template.
pub(crate) struct Line {
    /// Its four numbers by the names of a quaternion: `qw: 1, qx: 0, …`.
    pub(crate) named: String,
    /// Where each number stands in that, and where in the line.
    places: [(Span, Span); 4],
}

impl Line {
    /// Where in the line it is what stands somewhere in the numbers by name, within one of them; nothing
    /// where several are meant.
    pub(crate) fn place(&self, named: Span) -> Option<Span> {
        let mut meant = Vec::new();
        for (place, line) in self.places {
            if place.start <= named.end && named.start <= place.end {
                meant.push((place, line));
            }
        }
        match &meant[..] {
            [(place, line)] if place.start <= named.start && named.end <= place.end => {
                let start = line.start + (named.start - place.start);
                Some(Span::from(start..start + (named.end - named.start)))
            }
            [(_, only)] => Some(*only),
            _ => None,
        }
    }

    /// The line with other numbers, by name as in `named`; nothing where these are not four numbers.
    pub(crate) fn with_numbers(&self, line: &str, named: &str) -> Option<String> {
        // One after the other as they stand in the line, where w may be the last.
        let mut numbers: Vec<(Span, &str)> = Vec::new();
        let mut names = self.named.split(", ");
        for new in named.split(", ") {
            let (name, number) = new.split_once(": ")?;
            let (_, place) = self.places.get(numbers.len())?;
            if !names.next()?.starts_with(name) {
                return None;
            }
            let before = numbers.partition_point(|(other, _)| other.start < place.start);
            numbers.insert(before, (*place, number));
        }
        if numbers.len() != PLACES.len() {
            return None;
        }
        let mut written = String::new();
        let mut rest = 0;
        for (place, number) in numbers {
            written.push_str(&line[rest..place.start]);
            written.push_str(number);
            rest = place.end;
        }
        Some(written + &line[rest..])
    }
}

/// The four numbers of a line that is written like the template.
///
/// White space does not matter, except inside a number, nor what stands before the first `=` of both.
pub(crate) fn read(template: &str, line: &str) -> Option<Line> {
    let mut template = template.to_owned();
    template.retain(|character| !character.is_whitespace());
    let mut characters = Vec::new();
    for (at, character) in line.char_indices() {
        if !character.is_whitespace() {
            characters.push((at, character));
        }
    }
    numbers(&template, &characters).or_else(|| {
        let (_, template) = template.split_once('=')?;
        let value = characters
            .iter()
            .position(|(_, character)| *character == '=')
            .map_or(&characters[..], |at| &characters[at + 1..]);
        numbers(template, value)
    })
}

/// `line` holds the characters that count, each with its place.
fn numbers(template: &str, line: &[(usize, char)]) -> Option<Line> {
    let (mut template, mut line) = (template, without_semicolons(line));
    let mut named = String::new();
    let mut places = Vec::new();
    while let Some((at, place)) = next_place(template) {
        line = after(&template[..at], line)?;
        template = &template[at + place.len()..];
        // A number ends where the text after its place goes on, or with an f of single precision.
        let end = line
            .iter()
            .position(|(_, c)| !(c.is_ascii_digit() || "+-.eE".contains(*c)));
        let (number, rest) = line.split_at(end.unwrap_or(line.len()));
        let (first, last) = (number.first()?.0, number.last()?.0);
        // Two numbers with white space between them are not one, and every character here has one byte.
        if last - first + 1 != number.len() {
            return None;
        }
        let mut written = String::new();
        for (_, character) in number {
            written.push(*character);
        }
        let number = written;
        if !is_decimal(&number) {
            return None;
        }
        if !named.is_empty() {
            named.push_str(", ");
        }
        named.push('q');
        named.push_str(place.trim_matches(['{', '}']));
        named.push_str(": ");
        let start = named.len();
        named.push_str(&number);
        places.push((Span::from(start..named.len()), Span::from(first..last + 1)));
        let template_has_suffix = template.starts_with('f');
        line = match rest.split_first() {
            Some(((_, 'f'), rest)) if !template_has_suffix => rest,
            Some(((_, 'f'), _)) => rest,
            _ if template_has_suffix => return None,
            _ => rest,
        };
    }
    let rest = after(template.trim_end_matches(';'), line)?;
    Some(Line {
        named,
        places: places.try_into().ok().filter(|_| rest.is_empty())?,
    })
}

fn without_semicolons(line: &[(usize, char)]) -> &[(usize, char)] {
    let end = line
        .iter()
        .rposition(|(_, character)| *character != ';')
        .map_or(0, |last| last + 1);
    &line[..end]
}

/// What follows a beginning; nothing where the line begins otherwise.
fn after<'line>(beginning: &str, line: &'line [(usize, char)]) -> Option<&'line [(usize, char)]> {
    let mut rest = line;
    for expected in beginning.chars() {
        let ((_, found), after) = rest.split_first()?;
        if *found != expected {
            return None;
        }
        rest = after;
    }
    Some(rest)
}

/// Where the next number stands in a template, and which.
fn next_place(template: &str) -> Option<(usize, &'static str)> {
    PLACES
        .iter()
        .filter_map(|place| template.find(place).map(|at| (at, *place)))
        .min()
}
