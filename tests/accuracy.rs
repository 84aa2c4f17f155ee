//! How good the numbers are: every conversion against references of 50 digits, and the same bits on
//! every machine.

#[path = "common/accuracy.rs"]
mod accuracy;

use accuracy::{OPERATIONS, cases};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn every_conversion_keeps_its_bound() {
    let mut failures = Vec::new();
    for operation in OPERATIONS {
        let mut worst = (0.0, String::new());
        for case in cases(operation.cases) {
            let got = (operation.run)(&case);
            let error = operation.measure.error(&case, &got);
            if error > worst.0 {
                worst = (
                    error,
                    format!(
                        "{} {:?} {:?} gives {got:?}",
                        case.group, case.sequence, case.input
                    ),
                );
            }
        }
        if worst.0 > operation.bound {
            failures.push(format!("{}: {:.3} u, {}", operation.name, worst.0, worst.1));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
