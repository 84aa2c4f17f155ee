//! How good the numbers are: every conversion against references of 50 digits, and the same bits on
//! every machine.

use crate::measured::operations::{OPERATIONS, slerp};
use crate::measured::{Measure, NO_BOUND, cases};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn every_conversion_keeps_its_bound() {
    let mut failures = Vec::new();
    for operation in OPERATIONS {
        for case in cases(operation.cases) {
            let got = (operation.run)(&case);
            let error = operation.measure.error(&case, &got);
            if error > operation.bound && case.group != NO_BOUND {
                failures.push(format!(
                    "{}: {error:.3} u of {} ({}, {:?} {:?} gives {got:?})",
                    operation.name, operation.bound, case.group, case.sequence, case.input
                ));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// At constant velocity an error of the velocity grows with the way: three roundoffs for each length.
#[wasm_bindgen_test(unsupported = test)]
fn slerp_keeps_its_bound_beyond_its_ends() {
    for case in cases("slerp_beyond") {
        let error = Measure::Relative.error(&case, &slerp(&case));
        let bound = 3.0 * case.input[8].abs().max(1.0);
        assert!(error <= bound, "{error:.3} u of {bound}: {:?}", case.input);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn nothing_finite_makes_a_number_that_is_not() {
    for operation in OPERATIONS {
        for case in cases(operation.cases) {
            let got = (operation.run)(&case);
            let is_finite = got.iter().all(|number| number.is_finite());
            assert!(is_finite, "{} of {:?}: {got:?}", operation.name, case.input);
        }
    }
}

/// One number for all bits of all results: a native build and the wasm must agree on it, and so must
/// every platform. It changes with the algorithms and the cases, and with nothing else.
#[wasm_bindgen_test(unsupported = test)]
fn every_machine_gives_the_same_bits() {
    let mut results = OPERATIONS
        .iter()
        .flat_map(|operation| {
            let run = operation.run;
            cases(operation.cases)
                .into_iter()
                .map(move |case| run(&case))
        })
        .flatten();
    // FNV-1a, 64 bits.
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for byte in results
        .by_ref()
        .flat_map(|number| number.to_bits().to_le_bytes())
    {
        hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }
    assert_eq!(
        hash,
        11_106_355_357_664_252_452,
        "the bits of {} operations",
        OPERATIONS.len()
    );
}
