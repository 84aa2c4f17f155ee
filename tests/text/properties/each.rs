//! Properties tried on inputs that are made of many texts.

use crate::property::tried;
use proptest::prelude::*;

/// Tries a property on that many inputs made of each text.
///
/// The inputs of a text depend on nothing but that text, so one that is added changes no other's.
#[track_caller]
pub(crate) fn for_all_of_each<S: Strategy>(
    texts: &[String],
    cases: u32,
    strategy: impl Fn(&str) -> S,
    test: impl Fn(S::Value) -> Result<(), TestCaseError>,
) {
    let mut failures = Vec::new();
    for text in texts {
        if let Err(failure) = tried(cases, salt(text), &strategy(text), &test) {
            failures.push(format!("of {text:?}: {failure}"));
        }
    }
    let count = failures.len();
    assert!(
        failures.is_empty(),
        "{count} failures\n{}",
        failures.join("\n")
    );
}

/// One of so many texts; which, depends on nothing but each text.
pub(crate) fn sample(texts: Vec<String>, one_of: u64) -> Vec<String> {
    let is_chosen = |text: &String| salt(text).is_multiple_of(one_of);
    texts.into_iter().filter(is_chosen).collect()
}

/// FNV-1a: the same on every machine and with every compiler.
fn salt(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}
