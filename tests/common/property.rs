//! Properties tried on many inputs, with a fixed seed.
//!
//! `npm run long` tries more of them: `QUATLAS_TIMES` times as many, from another seed with
//! `QUATLAS_SEED`.

#![allow(dead_code, reason = "each test file uses a part of this")]

use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestError, TestRng, TestRunner};

/// Tries a property on that many inputs and shrinks the first for which it fails.
#[track_caller]
pub(crate) fn for_all<S: Strategy>(
    cases: u32,
    strategy: S,
    test: impl Fn(S::Value) -> Result<(), TestCaseError>,
) {
    if let Err(failure) = tried(cases, 0, &strategy, test) {
        panic!("{failure}");
    }
}

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

fn tried<S: Strategy>(
    cases: u32,
    salt: u64,
    strategy: &S,
    test: impl Fn(S::Value) -> Result<(), TestCaseError>,
) -> Result<(), TestError<S::Value>> {
    let mut seed = [7; 32];
    seed[..4].copy_from_slice(&setting("QUATLAS_SEED", 0x0707_0707).to_le_bytes());
    for (byte, salt) in seed[8..16].iter_mut().zip(salt.to_le_bytes()) {
        *byte ^= salt;
    }
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &seed);
    let config = Config {
        cases: cases * setting("QUATLAS_TIMES", 1),
        failure_persistence: None,
        ..Config::default()
    };
    TestRunner::new_with_rng(config, rng).run(strategy, test)
}

fn setting(name: &str, otherwise: u32) -> u32 {
    std::env::var(name).map_or(otherwise, |value| value.parse().expect("a whole number"))
}
