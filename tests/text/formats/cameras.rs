//! Cameras, structure from motion and visual odometry.

use crate::formats::{Printed, check};
use wasm_bindgen_test::wasm_bindgen_test;

const PRINTED: &[Printed] = &[
    Printed {
        format: Some("COLMAP images.txt"),
        library: None,
        text: "7 0.730496 -0.361603 -0.485520 0.316051 -0.447 2.991 -0.245 1 frame_0007.jpg",
        rotation: [
            0.73049635041,
            -0.361603173456,
            -0.485520232898,
            0.316051151606,
        ],
        position: Some([-0.447, 2.991, -0.245]),
    },
    Printed {
        format: None,
        library: None,
        text: "Rigid3d(rotation_xyzw=[0.292509, 0.343728, -0.738316, 0.501178], translation=[1.414, 2.593, -2.540])",
        rotation: [
            0.501177910639,
            0.292508947845,
            0.343727938712,
            -0.738315868356,
        ],
        position: Some([1.414, 2.593, -2.54]),
    },
    Printed {
        format: Some("EuRoC ground truth"),
        library: None,
        text: "1403636580838555648,0.050,-0.869,2.728,-0.288790,0.330072,-0.761535,0.477197,0.1,0.2,0.3,0,0,0,0,0,0",
        rotation: [
            -0.288790040096,
            0.330072045828,
            -0.761535105732,
            0.477197066255,
        ],
        position: Some([0.05, -0.869, 2.728]),
    },
    Printed {
        format: Some("TUM trajectory"),
        library: None,
        text: "1305031102.1758 -0.406 1.388 0.130 -0.178032 0.619965 0.362775 0.672564",
        rotation: [
            0.672563990258,
            -0.178031997421,
            0.61996499102,
            0.362774994745,
        ],
        position: Some([-0.406, 1.388, 0.13]),
    },
    Printed {
        format: Some("KITTI poses"),
        library: None,
        text: "12 0.659751 -0.017729 0.751275 -2.515000 0.654845 0.503995 -0.563175 -2.064000 -0.368654 0.863525 0.344121 -2.539000",
        rotation: [
            0.791812331238,
            0.450453969533,
            0.353596808734,
            0.212352890926,
        ],
        position: Some([-2.515, -2.064, -2.539]),
    },
    Printed {
        format: Some("VisualSFM NVM"),
        library: None,
        text: "NVM_V3\n\n1\nimg/07.jpg 3411.2 -0.718113 0.304209 0.472397 -0.410624 0.401 0.136 -0.219 -0.08 0",
        rotation: [
            -0.718112859453,
            0.304208940461,
            0.472396907544,
            -0.410623919634,
        ],
        position: Some([0.401, 0.136, -0.219]),
    },
    Printed {
        format: Some("Bundler"),
        library: None,
        text: "# Bundle file v0.3\n1 0\n671.2 -0.17 0.05\n-0.227910216 -0.664043752 0.712111528\n-0.928949069 -0.070839672 -0.363366712\n0.291737142 -0.744330327 -0.600717741\n1.740 1.031 0.973",
        rotation: [
            0.15853420078,
            -0.600759352148,
            0.662908041291,
            -0.417741590917,
        ],
        position: Some([1.74, 1.031, 0.973]),
    },
    Printed {
        format: None,
        library: None,
        text: "0001.jpg\nimg/01.jpg\n3411.2\n1536 1024\n-1.200 -2.746 -2.016\n-1.759832995 -1.537672151 2.753783611\n-0.998773962 0.410989410 -1.620611000\n-0.562193167 0.424124622 -0.174524702 0.688184769\n-0.008114295 0.625745102 0.779985401\n-0.921825996 -0.306959942 0.236669445\n0.387519020 -0.717090413 0.579318866\n-0.08\n0 0 0",
        rotation: [
            -0.562193167028,
            0.424124622021,
            -0.174524702009,
            0.688184769034,
        ],
        position: Some([-1.2, -2.746, -2.016]),
    },
    Printed {
        format: Some("nuScenes"),
        library: None,
        text: r#"{"token": "ab12", "ego_pose_token": "cd34", "translation": [0.766, 0.971, 0.222], "rotation": [0.181582, -0.706910, -0.596395, 0.334095]}"#,
        rotation: [
            0.181581978585,
            -0.706909916629,
            -0.596394929663,
            0.334094960598,
        ],
        position: Some([0.766, 0.971, 0.222]),
    },
    Printed {
        format: Some("Gaussian splat"),
        library: None,
        text: "rot_0 0.518010 rot_1 -1.273883 rot_2 -0.754000 rot_3 -0.656028",
        rotation: [
            0.304711712274,
            -0.749342812236,
            -0.443529335446,
            -0.385898757127,
        ],
        position: None,
    },
];

#[wasm_bindgen_test(unsupported = test)]
fn poses_of_cameras_are_read() {
    check(PRINTED);
}
