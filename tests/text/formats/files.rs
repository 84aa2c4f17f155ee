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
    Printed {
        format: Some("NIfTI"),
        library: None,
        text: "  quatern_b           0.403947\n  quatern_c           0.152686\n  quatern_d           -0.664449\n  qoffset_x           -90.0\n  qoffset_y           -126.0\n  qoffset_z           -72.0",
        rotation: [0.609935515439, 0.403947, 0.152686, -0.664449],
        position: Some([-90.0, -126.0, -72.0]),
    },
    Printed {
        format: Some("ITK"),
        library: None,
        text: "#Insight Transform File V1.0\n#Transform 0\nTransform: VersorRigid3DTransform_double_3_3\nParameters: -0.283697758 0.637583967 -0.569976034 12.3 -4.5 6.7\nFixedParameters: 0 0 0",
        rotation: [0.433739078013, -0.283697758, 0.637583967, -0.569976034],
        position: Some([12.3, -4.5, 6.7]),
    },
    Printed {
        format: Some("TM-align"),
        library: None,
        text: "------ The rotation matrix to rotate Chain_1 to Chain_2 ------\nm               t[m]        u[m][0]        u[m][1]        u[m][2]\n0  0.5000000000  0.3624309804  0.8974227507  0.2515475916\n1  -1.5000000000  -0.6442703459  0.4362670985  -0.6281613966\n2  2.2500000000  -0.6734682664  0.0656004969  0.7362995783",
        rotation: [
            0.796083798538,
            0.217867106074,
            0.290489474767,
            -0.484149124595,
        ],
        position: Some([0.5, -1.5, 2.25]),
    },
    Printed {
        format: Some("PCD"),
        library: None,
        text: "WIDTH 213\nHEIGHT 1\nVIEWPOINT 0.5 -1.5 2.25 0.231455 -0.612372 0.433013 0.619657\nPOINTS 213\nDATA ascii",
        rotation: [
            0.231449683751,
            -0.612357934536,
            0.433003054201,
            0.619642767209,
        ],
        position: Some([0.5, -1.5, 2.25]),
    },
    Printed {
        format: Some("HALCON"),
        library: None,
        text: "# 3D POSE PARAMETERS: rotation and translation\n\n# Used representation type:\nf 0\n\n# Rotation angles [deg] or Rodriguez vector:\nr 50.7057 -28.9307 78.1277\n\n# Translation vector (x y z [m]):\nt 0.5 -1.5 2.25",
        rotation: [
            0.746824376658,
            0.17967147337,
            -0.436557734525,
            0.468389641766,
        ],
        position: Some([0.5, -1.5, 2.25]),
    },
    Printed {
        format: Some("HALCON"),
        library: None,
        text: "Pose := [0.5, -1.5, 2.25, -29.862, -87.640, 89.309, 0]",
        rotation: [
            0.370544164233,
            -0.60244943776,
            -0.345252488626,
            0.616889306434,
        ],
        position: Some([0.5, -1.5, 2.25]),
    },
];

#[wasm_bindgen_test(unsupported = test)]
fn molecules_and_crystals_are_read() {
    check(PRINTED);
}
