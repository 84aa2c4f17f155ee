//! The words of labels, and what each says of the numbers under it: the one list of them.
//!
//! A label is a name before a mark, as in `q_wxyz = …` or `worldToBody: …`. A word that stands in none of the
//! lists says nothing, so that any name may be given to a rotation.

use crate::character::{is_alphanumeric, parts_words};
use crate::convention::Direction;
use crate::convention::angle::AngleUnit;
use crate::convention::order::ComponentOrder;
use crate::text::vocabulary::constructors::order_in_name;
use crate::text::vocabulary::is_listed;
use crate::text::vocabulary::label_words::{BODIES, CONJUGATING, STEMS, WORDS, WORLDS};
pub(crate) use crate::text::vocabulary::label_words::{Derived, LabelWord};

/// The words of a name: its parts between marks, capitals (`qInv`) and digits (`c2w`).
pub(crate) fn words_of(name: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let mut rest = name;
    loop {
        rest = rest.trim_start_matches(parts_words);
        let (word, after) = rest.split_at(end_of_word(rest));
        if word.is_empty() {
            return words;
        }
        words.push(word);
        rest = after;
    }
}

/// Where the word ends that a text begins with.
fn end_of_word(text: &str) -> usize {
    let mut before: Option<char> = None;
    let mut characters = text.char_indices().peekable();
    while let Some((at, character)) = characters.next() {
        let starts_lower =
            |next: Option<&(usize, char)>| next.is_some_and(|(_, next)| next.is_ascii_lowercase());
        let ends = !is_alphanumeric(character)
            || matches!(character, 'ᵀ' | 'ᵗ')
            || before.is_some_and(|before| {
                before.is_ascii_digit() != character.is_ascii_digit()
                    || (before.is_ascii_lowercase() && character.is_ascii_uppercase())
                    // `JPLQuat` is `JPL` and `Quat`.
                    || (before.is_ascii_uppercase()
                        && character.is_ascii_uppercase()
                        && starts_lower(characters.peek()))
            });
        if ends && at > 0 {
            return at;
        }
        before = Some(character);
    }
    text.len()
}

/// What one word says, or several that stand together, as in `scalarlast`; `None` where it is not known.
pub(crate) fn meaning_of_word(word: &str) -> Option<LabelWord> {
    let lower = word.to_ascii_lowercase();
    listed(&lower)
        .or_else(|| AngleUnit::named(&lower).map(LabelWord::Unit))
        .or_else(|| order_of_letters(&lower))
        .or_else(|| made_of_a_stem(&lower))
        .or_else(|| {
            let (one, other) = lower.split_once("to")?;
            between_frames(one, other)
        })
}

fn listed(lower: &str) -> Option<LabelWord> {
    let found = WORDS.iter().find(|(words, _)| is_listed(lower, words));
    found.map(|&(_, meaning)| meaning)
}

/// `xyzw`, also where other letters touch it (`fromxyzw`); `zyxw` where none do.
fn order_of_letters(lower: &str) -> Option<LabelWord> {
    match () {
        () if lower.contains("xyzw") => Some(LabelWord::Order(ComponentOrder::ScalarLast)),
        () if lower.contains("wxyz") => Some(LabelWord::Order(ComponentOrder::ScalarFirst)),
        () => {
            let is_permuted = lower.len() == 4 && "wxyz".chars().all(|axis| lower.contains(axis));
            is_permuted.then_some(LabelWord::OtherOrder)
        }
    }
}

/// `qdot`, `Rinv`, `conjq`
fn made_of_a_stem(lower: &str) -> Option<LabelWord> {
    let derived = |rest: &str| match listed(rest) {
        Some(meaning @ LabelWord::Derived(_)) => Some(meaning),
        _ if CONJUGATING.contains(&rest) => Some(LabelWord::Derived(Derived::Conjugate)),
        _ => None,
    };
    STEMS.iter().find_map(|stem| {
        let after = lower.strip_prefix(stem).and_then(derived);
        after.or_else(|| lower.strip_suffix(stem).and_then(derived))
    })
}

/// The direction from one frame to another, where one is a world and one a body.
fn between_frames(from: &str, to: &str) -> Option<LabelWord> {
    let leads = |one: &str, other: &str| is_listed(from, one) && is_listed(to, other);
    let direction = match () {
        () if leads(WORLDS, BODIES) => Direction::WorldToBody,
        () if leads(BODIES, WORLDS) => Direction::BodyToWorld,
        () => return None,
    };
    Some(LabelWord::Direction(direction))
}

/// All that the words of a name say, one by one and together.
pub(crate) fn meanings_of(name: &str) -> Vec<LabelWord> {
    let mut words = Vec::new();
    for word in words_of(name) {
        words.push(word.to_ascii_lowercase());
    }
    let mut meanings = Vec::new();
    let mut at = 0;
    while at < words.len() {
        let (meaning, length) = meaning_ahead(&words[at..]);
        meanings.extend(meaning);
        at += length;
    }
    meanings
}

/// Whether a name says that what it names was made of a rotation: `qInv`, `R.T`, `rate`.
#[cfg(feature = "whole")]
pub(crate) fn is_derived(name: &str) -> bool {
    meanings_of(name)
        .iter()
        .any(|word| matches!(word, LabelWord::Derived(_)))
}

/// What the first words say, and how many they are: the most that say something together.
fn meaning_ahead(words: &[String]) -> (Option<LabelWord>, usize) {
    if let [one, between, other, ..] = words {
        let direction = match between.as_str() {
            "to" | "2" => between_frames(one, other),
            "from" => between_frames(other, one),
            _ => None,
        };
        if direction.is_some() {
            return (direction, 3);
        }
    }
    if let Some((direction, length)) = frames_ahead(words) {
        return (Some(direction), length);
    }
    if let [one, other, ..] = words {
        // `R_t`, `R.T`: perhaps at a time, perhaps transposed.
        if other == "t"
            && matches!(
                one.as_str(),
                "r" | "rot" | "m" | "mat" | "matrix" | "dcm" | "v"
            )
        {
            return (Some(LabelWord::Derived(Derived::Transposed)), 2);
        }
        if matches!(one.as_str(), "q" | "quat") && CONJUGATING.contains(&other.as_str()) {
            return (Some(LabelWord::Derived(Derived::Conjugate)), 2);
        }
        let together = listed(&[one.as_str(), other].concat());
        if together.is_some() {
            return (together, 2);
        }
    }
    match &words[0] {
        word if word == "rt" => (Some(LabelWord::Derived(Derived::Transposed)), 1),
        word => (meaning_of_word(word), 1),
    }
}

/// The frames at the start of which the first is led to the second, and how many words they are: `GtoI`. What stands
/// as an index, as in `R_WB`, is read by some as from W to B and by others the other way round: it says nothing.
fn frames_ahead(words: &[String]) -> Option<(LabelWord, usize)> {
    let [one, other, ..] = words else {
        return None;
    };
    let from = one.strip_suffix("to")?;
    Some((between_frames(from, other)?, 2))
}

/// What a label names in place of a rotation, where it does.
pub(crate) fn other_than_rotation(name: &str) -> Option<LabelWord> {
    // Without the feature `whole` only plain labels are read at all.
    if !cfg!(feature = "whole") {
        return None;
    }
    if name == "t" {
        return Some(LabelWord::Quantity("a translation or a time"));
    }
    let meanings = meanings_of(name);
    let is_rotation = meanings.contains(&LabelWord::Rotation);
    meanings.into_iter().find(|meaning| match meaning {
        LabelWord::Derived(_) | LabelWord::LeftHanded | LabelWord::OtherOrder => true,
        LabelWord::Quantity(_) => !is_rotation,
        _ => false,
    })
}

/// What a label names in place of a vector, where it does: of quantities any may be turned.
pub(crate) fn other_than_vector(name: &str) -> Option<LabelWord> {
    if !cfg!(feature = "whole") {
        return None;
    }
    let is_permuted = |word: &str| {
        let word = word.to_ascii_lowercase();
        word.len() == 3 && word != "xyz" && "xyz".chars().all(|axis| word.contains(axis))
    };
    if words_of(name).into_iter().any(is_permuted) {
        return Some(LabelWord::OtherOrder);
    }
    if !cfg!(feature = "whole") {
        return None;
    }
    meanings_of(name).into_iter().find(|meaning| match meaning {
        LabelWord::Derived(made) => *made != Derived::Rate,
        LabelWord::LeftHanded | LabelWord::OtherOrder => true,
        _ => false,
    })
}

/// Words that stand in names of rotations, besides those that say more.
#[cfg(feature = "whole")]
const OF_ROTATIONS: &str = "q r m n u v w x y z qw qx qy qz rotation pose attitude angle angles axis roll pitch \
    yaw vector parameters modified half halfangle axisangle axang matrix rotmat unit units order format sequence seq \
    intrinsic extrinsic fixed rotating moving double float const auto eigen quaterniond quaternionf matrix3d";

/// The longest name that is a symbol, which says as little as no name: `a`, `q0`, `foo`.
#[cfg(feature = "whole")]
const LONGEST_SYMBOL: usize = 3;

/// Whether a label has no word that is known of rotations, so that four numbers under it may be anything:
/// `Model coefficients`, `waypoint`, a word of another language.
#[cfg(feature = "whole")]
pub(crate) fn says_nothing(name: &str) -> bool {
    let is_known = |word: &str| {
        let lower = word.to_ascii_lowercase();
        is_listed(&lower, OF_ROTATIONS) || meaning_of_word(word).is_some()
    };
    let is_symbol = name.is_ascii() && name.len() <= LONGEST_SYMBOL;
    !is_symbol && !words_of(name).into_iter().any(is_known)
}

/// The order that a value is and nothing else: `xyzw`, `scalar_last`.
pub(crate) fn order_alone(value: &str) -> Option<ComponentOrder> {
    match value {
        "wxyz" => return Some(ComponentOrder::ScalarFirst),
        "xyzw" => return Some(ComponentOrder::ScalarLast),
        _ if !cfg!(feature = "whole") => return None,
        _ => {}
    }
    match listed(&value.replace(['_', '-', ' '], "")) {
        Some(LabelWord::Order(order)) => Some(order),
        _ => None,
    }
}

/// The order of components that a label tells.
pub(crate) fn order_of(name: &str) -> Option<ComponentOrder> {
    if !cfg!(feature = "whole") {
        return order_in_name(name);
    }
    meanings_of(name)
        .into_iter()
        .find_map(|meaning| match meaning {
            LabelWord::Order(order) => Some(order),
            _ => None,
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use wasm_bindgen_test::wasm_bindgen_test;

    #[wasm_bindgen_test(unsupported = test)]
    fn a_name_is_split_at_marks_capitals_and_digits() {
        let split = |name| words_of(name).join(" ");
        assert_eq!(split("q_scalar.last-of:it"), "q scalar last of it");
        assert_eq!(split("qInv"), "q Inv");
        assert_eq!(split("worldToBodyJPLQuat"), "world To Body JPL Quat");
        assert_eq!(split("c2w"), "c 2 w");
        assert_eq!(split("Rᵀ"), "R ᵀ");
        assert_eq!(split("__"), "");
    }

    #[wasm_bindgen_test(unsupported = test)]
    fn words_say_what_they_say_alone_and_together() {
        use LabelWord::{Derived as Made, Direction as Leads, Order, Quantity, Rotation};
        let first = |name| meanings_of(name).first().copied();
        assert_eq!(first("scalarLast"), Some(Order(ComponentOrder::ScalarLast)));
        assert_eq!(
            first("scalar_first"),
            Some(Order(ComponentOrder::ScalarFirst))
        );
        assert_eq!(first("quatxyzw"), Some(Order(ComponentOrder::ScalarLast)));
        assert_eq!(first("zyxw"), Some(LabelWord::OtherOrder));
        assert_eq!(first("left_handed"), Some(LabelWord::LeftHanded));
        assert_eq!(
            first("left_wheel_frame"),
            Some(Quantity("a speed of wheels or motors"))
        );
        assert_eq!(first("world_to_body"), Some(Leads(Direction::WorldToBody)));
        assert_eq!(first("worldFromCam"), Some(Leads(Direction::BodyToWorld)));
        assert_eq!(first("c2w"), Some(Leads(Direction::BodyToWorld)));
        assert_eq!(first("GtoI"), Some(Leads(Direction::WorldToBody)));
        // An index is read either way by one or the other.
        assert_eq!(first("R_WB"), None);
        assert_eq!(first("body_to_camera"), None);
        assert_eq!(first("qdot"), Some(Made(Derived::Rate)));
        assert_eq!(first("R_t"), Some(Made(Derived::Transposed)));
        assert_eq!(first("q_t"), Some(Rotation));
        assert_eq!(first("columnMajor"), Some(LabelWord::Columns));
        assert_eq!(first("my_name"), None);
    }
}
