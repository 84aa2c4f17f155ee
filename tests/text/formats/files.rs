//! Other files: molecules, crystals.

use crate::formats::{Printed, check};
use wasm_bindgen_test::wasm_bindgen_test;

const PRINTED: &[Printed] = &[
    Printed {
        format: Some("PyMOL"),
        library: None,
        text: "set_view (\\\n    -0.2708922, 0.9583995, 0.0899318,\\\n    0.5585260, 0.0803990, 0.8255814,\\\n    0.7840064, 0.2738728, -0.5570705,\\\n    0.0, 0.0, -50.0,\\\n    1.0, 2.0, 3.0,\\\n    40.0, 60.0, -20.0 )",
        rotation: [
            0.251215158825,
            0.549039921176,
            0.690717332346,
            0.397939286484,
        ],
        position: None,
    },
    Printed {
        format: Some("LAMMPS"),
        library: None,
        text: "ITEM: ATOMS id type x y z c_orient[1] c_orient[2] c_orient[3] c_orient[4]\n17 1 -2.505 -0.848 -0.518 -0.382090 0.221677 -0.142864 -0.885696",
        rotation: [
            -0.382089811374,
            0.221676890565,
            -0.142863929472,
            -0.885695562758,
        ],
        position: Some([-2.505, -0.848, -0.518]),
    },
    Printed {
        format: Some("EDAX .ang"),
        library: None,
        text: "# NCOLS_ODD: 400\n#\n  1.08966  1.22658  2.48045     12.25      3.50 1184.3  0.412  1      1  0.891",
        rotation: [
            -0.173874430988,
            0.441916130291,
            -0.368755467566,
            0.799060211234,
        ],
        position: None,
    },
    Printed {
        format: Some("Oxford .ctf"),
        library: None,
        text: "Phase\tX\tY\tBands\tError\tEuler1\tEuler2\tEuler3\tMAD\tBC\tBS\n1\t12.2500\t3.5000\t8\t0\t-0.9278\t140.1234\t-119.0269\t0.4120\t118\t204",
        rotation: [
            0.170620742428,
            0.483469855849,
            0.806207435263,
            -0.29525418213,
        ],
        position: None,
    },
    Printed {
        format: Some("orix"),
        library: None,
        text: "Rotation (1,)\n[[0.329763 -0.570879 -0.437251 -0.611690]]",
        rotation: [
            0.329763072233,
            -0.570879125048,
            -0.437251095777,
            -0.611690133987,
        ],
        position: None,
    },
];

#[wasm_bindgen_test(unsupported = test)]
fn molecules_and_crystals_are_read() {
    check(PRINTED);
}
