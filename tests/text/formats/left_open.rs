//! What looks like a print of a program and leaves open what it is: no rotation is read, or the reader is stopped.

use crate::asked::read_request;
use quatlas::{Convention, Outcome, analyze};
use wasm_bindgen_test::wasm_bindgen_test;

const LEFT_OPEN: &[&str] = &[
    // FANUC's and Comau's in one form; the string that tells them is not there.
    "POS(310.5, -120.25, 95, -56.5, 39.4, 110.3)",
    // Another order than the usual one.
    "basis = Basis.from_euler(Vector3(-0.476, 1.329, -1.05), EULER_ORDER_XYZ)",
    // Of points, not of frames.
    "q = quaternion([35 -34 -153],'eulerd','ZYX','point')",
    // The call is given to another one, which may change the order.
    ">>> np.roll(r.as_quat(), 1)\narray([0.231455, -0.612372, 0.433013, 0.619657])",
    // What is computed is no number.
    "<mesh rotation={[-Math.PI / 2, 0.1, 0.2]}>",
    "<origin rpy=\"${yaw} 0.1 0.2\" xyz=\"0 0 0.1\"/>",
    // Three.js and Babylon.js have this call, each with axes of its own.
    "camera.rotation.set(1.127, -0.89, 2.624);",
    // PolyScope shows a rotation vector or roll, pitch and yaw under these names.
    "X  -120.34 mm\nY  412.10 mm\nZ  305.77 mm\nRX  -0.7739 rad\nRY  0.9719 rad\nRZ  1.3751 rad",
    // KUKA's and Mitsubishi's letters.
    "X  72.0 mm\nY  232.8 mm\nZ  -252.9 mm\nA  -80.86 °\nB  -27.03 °\nC  -118.07 °",
    // Four numbers are no modified Rodrigues parameters.
    "sigma_BN: 0.5 0.5 0.5 0.5",
];

#[wasm_bindgen_test(unsupported = test)]
fn what_no_mark_tells_is_not_read() {
    for text in LEFT_OPEN {
        if let Outcome::Read(report) = analyze(&read_request(text, "1 0 0", Convention::HAMILTON)) {
            let stops = report.notes.iter().any(|note| note.stops);
            assert!(stops, "{text}: {:?}", report.notes);
        }
    }
}

/// Two numbers between bars are no quaternion of libGDX: the order stays the declared one.
#[wasm_bindgen_test(unsupported = test)]
fn bars_of_a_log_tell_no_order() {
    let text = "[12|34] q=0.231455 -0.612372 0.433013 0.619657";
    let request = read_request(text, "1 0 0", Convention::HAMILTON);
    let Outcome::Read(report) = analyze(&request) else {
        panic!("{text} has no report");
    };
    assert!((report.hamilton.unit.w - 0.231455).abs() < 1e-3);
}
