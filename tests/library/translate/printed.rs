//! Libraries that print four numbers in another order than they store them in.

use super::{between, end, translate};
use quatlas::{ComponentOrder, Endpoint, Library, OrderSource, libraries};
use wasm_bindgen_test::wasm_bindgen_test;

const IN_A_USD_FILE: &str = "quatf xformOp:orient = (0.3120725, -0.7226505, 0.5967116, 0.155956)";
const BARE: &str = "(0.3120725, -0.7226505, 0.5967116, 0.155956)";

#[wasm_bindgen_test(unsupported = test)]
fn what_was_pasted_stands_in_the_printed_order() {
    for text in [IN_A_USD_FILE, BARE] {
        let report = between(text, "usd", "eigen");
        let q = &report.from.components;
        assert_eq!((q.w, q.x), (0.3120725, -0.7226505), "{text}");
        assert_eq!(report.from.order, ComponentOrder::ScalarFirst);
        assert_eq!(
            report.to.array,
            [-0.7226505, 0.5967116, 0.155956, 0.3120725]
        );
    }
}

/// Memory, where that is what was pasted, has to be said.
#[wasm_bindgen_test(unsupported = test)]
fn the_order_of_the_array_is_chosen() {
    let in_memory = end("usd", Some(ComponentOrder::ScalarLast), None);
    let report = translate(BARE, &in_memory, &Endpoint::library("eigen"));
    assert_eq!(
        (report.from.components.x, report.from.components.w),
        (0.3120725, 0.155956)
    );
}

/// Its constructor and what it says of itself stay what they are.
#[wasm_bindgen_test(unsupported = test)]
fn the_line_of_code_stays() {
    let report = between("0.1 -0.2 0.4 0.8", "eigen", "usd");
    let line = report.to.construct.expect("a line");
    assert_eq!(line, "q = Gf.Quatd(0.8, 0.1, -0.2, 0.4)");
    let back = between(&line, "usd", "eigen");
    assert_eq!(back.to.array, [0.1, -0.2, 0.4, 0.8]);
    assert_eq!(back.quaternion.order_source, OrderSource::Constructor);
}

/// What is shown of an end is read there again.
#[wasm_bindgen_test(unsupported = test)]
fn the_numbers_of_an_end_read_back() {
    let there = between("0.1 -0.2 0.4 0.8", "eigen", "usd").to;
    assert_eq!(there.array, [0.8, 0.1, -0.2, 0.4]);
    let text = there.array.map(|number| number.to_string()).join(" ");
    assert_eq!(
        between(&text, "usd", "eigen").to.array,
        [0.1, -0.2, 0.4, 0.8]
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn the_printed_order_is_told_only_where_it_is_another_one() {
    let printing = |library: &&Library| library.printed_order.is_some();
    let ids: Vec<_> = libraries()
        .iter()
        .filter(printing)
        .map(|library| library.id)
        .collect();
    assert_eq!(ids, ["usd"]);
    for library in libraries().iter().filter(printing) {
        assert!(library.array_order.is_some(), "{}", library.id);
        assert_ne!(library.printed_order, library.array_order, "{}", library.id);
    }
}
