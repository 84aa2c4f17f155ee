//! Names of frames that are nearly the same.

/// Whether two names are the same but for capitals and what joins words.
pub(crate) fn are_nearly_same(one: &str, other: &str) -> bool {
    plain(one) == plain(other)
}

fn plain(name: &str) -> String {
    let mut plain = String::new();
    for letter in name.chars() {
        if !" _-./".contains(letter) {
            plain.push(letter.to_ascii_lowercase());
        }
    }
    plain
}
