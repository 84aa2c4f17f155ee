//! Words that are decimal numbers.

/// Whether a text is a decimal number and no more: a sign, digits, a point, an exponent.
pub(crate) fn is_decimal(text: &str) -> bool {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (number, exponent) = match unsigned.split_once(['e', 'E']) {
        Some((number, exponent)) => (
            number,
            exponent.strip_prefix(['+', '-']).unwrap_or(exponent),
        ),
        None => (unsigned, "0"),
    };
    let (whole, part) = number.split_once('.').unwrap_or((number, ""));
    let are_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let is_empty = exponent.is_empty() || (whole.is_empty() && part.is_empty());
    !is_empty && are_digits(whole) && are_digits(part) && are_digits(exponent)
}

#[cfg(test)]
mod tests {
    use super::is_decimal;

    /// All texts of up to five of these characters; words for what is no number are none.
    #[test]
    fn a_decimal_number_is_what_rust_reads_as_a_double() {
        let mut texts = vec![String::new()];
        for _ in 0..5 {
            let shorter = texts.iter();
            let longer = shorter.flat_map(|text| {
                ["1", "+", "-", ".", "e", "E", " "].map(|next| format!("{text}{next}"))
            });
            texts = longer.collect();
            for text in &texts {
                assert_eq!(is_decimal(text), text.parse::<f64>().is_ok(), "{text}");
            }
        }
        for word in ["", "nan", "inf", "-infinity"] {
            assert!(!is_decimal(word), "{word}");
        }
    }
}
