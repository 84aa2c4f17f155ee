//! The line of code of a library, written with numbers and read back.

use crate::report::Components;

const PLACES: [&str; 4] = ["{w}", "{x}", "{y}", "{z}"];

/// The line with the numbers in their places, each as the shortest text that reads back.
pub(crate) fn write(template: &str, components: &Components) -> String {
    let Components { w, x, y, z, .. } = components;
    let numbers = PLACES.iter().zip([w, x, y, z]);
    numbers.fold(template.to_owned(), |line, (place, number)| {
        line.replace(place, &format!("{number:?}"))
    })
}

/// The four numbers of a line that is written like the template, by name: `w: 1, x: 0, …`.
///
/// White space does not matter, nor what stands before the first `=` of both.
pub(crate) fn read(template: &str, line: &str) -> Option<String> {
    let compact = |text: &str| text.split_whitespace().collect::<String>();
    let (template, line) = (compact(template), compact(line));
    numbers(&template, &line).or_else(|| {
        let (_, template) = template.split_once('=')?;
        let line = line.split_once('=').map_or(&*line, |(_, line)| line);
        numbers(template, line)
    })
}

fn numbers(template: &str, line: &str) -> Option<String> {
    let (mut template, mut line) = (template, line.trim_end_matches(';'));
    let mut named = Vec::new();
    while let Some((at, place)) = next_place(template) {
        line = line.strip_prefix(&template[..at])?;
        template = &template[at + place.len()..];
        // A number ends where the text after its place goes on, or with an f of single precision.
        let end = line.find(|c: char| !(c.is_ascii_digit() || "+-.eE".contains(c)));
        let (number, rest) = line.split_at(end.unwrap_or(line.len()));
        number.parse::<f64>().ok()?;
        named.push(format!("{}: {number}", place.trim_matches(['{', '}'])));
        let template_has_suffix = template.starts_with('f');
        line = match rest.strip_prefix('f') {
            Some(rest) if !template_has_suffix => rest,
            None if template_has_suffix => return None,
            _ => rest,
        };
    }
    (line == template.trim_end_matches(';') && named.len() == PLACES.len())
        .then(|| named.join(", "))
}

/// Where the next number stands in a template, and which.
fn next_place(template: &str) -> Option<(usize, &'static str)> {
    PLACES
        .iter()
        .filter_map(|place| template.find(place).map(|at| (at, *place)))
        .min()
}
