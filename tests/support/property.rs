//! Properties tried on many inputs, with a fixed seed.
//!
//! `npm run long` tries more of them: `QUATLAS_TIMES` times as many, from another seed with
//! `QUATLAS_SEED`.

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

pub(crate) fn tried<S: Strategy>(
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
