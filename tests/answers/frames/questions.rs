//! What people ask of poses, with texts as files and programs have them.

use crate::frames::{answered, asked};
use crate::support::assert_close;
use quatlas::{Convention, Direction, Function, GivenPose, MatrixConvention, ProblemCode};
use wasm_bindgen_test::wasm_bindgen_test;

/// A row of COLMAP leads from the world to the camera; the camera stands at −Rᵀt.
#[wasm_bindgen_test(unsupported = test)]
fn a_camera_stands_where_its_row_says() {
    let row = "12 0.496224075 -0.330001337 -0.763643223 -0.248414597 1.800564 -2.70038 -0.763124 2 mill_0012.png";
    let mut pose = GivenPose::new("world", "camera", row, "");
    pose.convention = Some(Convention {
        direction: Direction::WorldToBody,
        ..Convention::HAMILTON
    });
    let report = asked(&[pose], "camera", "world");
    let position = answered(&report).position.expect("a position");
    assert_close("−Rᵀt", &position, &[1.920_395, 0.467_147, 2.6852], 1e-5);
    let back = answered(&report).inverse_homogeneous.expect("a position");
    let t = [back[0][3], back[1][3], back[2][3]];
    assert_close("t", &t, &[1.800_564, -2.700_38, -0.763_124], 1e-5);
}

/// Two extrinsics of Kalibr, and what takes the one camera to the other.
#[wasm_bindgen_test(unsupported = test)]
fn matrices_of_sixteen_numbers_are_chained() {
    let t_cam0_imu =
        "[[-0.515614, -0.825047, 0.231170, 0.168900], [0.724520, -0.563857, -0.396403, 0.124200],
        [0.457399, -0.036904, 0.888496, 0.050500], [0.0, 0.0, 0.0, 1.0]]";
    let t_cam1_imu =
        "[[0.622345, -0.372651, 0.688344, 0.152300], [-0.753767, -0.048262, 0.655367, -0.092700],
        [-0.211002, -0.926716, -0.310927, 0.033100], [0.0, 0.0, 0.0, 1.0]]";
    let poses = [
        GivenPose::new("cam0", "imu", t_cam0_imu, ""),
        GivenPose::new("cam1", "imu", t_cam1_imu, ""),
    ];
    let report = asked(&poses, "cam0", "cam1");
    let rows = answered(&report).homogeneous.expect("a position");
    let expected = [
        [0.145_689, 0.388_162, 0.910_003, 0.033_528],
        [0.579_972, -0.778_696, 0.2393, -0.106_028],
        [0.801_503, 0.492_913, -0.338_571, -0.146_396],
        [0.0, 0.0, 0.0, 1.0],
    ];
    for (got, wanted) in rows.iter().zip(&expected) {
        assert_close("T1 inverse(T0)", got, wanted, 2e-5);
    }
    assert_eq!(report.poses[0].position, Some([0.1689, 0.1242, 0.0505]));
    // Typed as what takes cam0 to the unit, the translation is that of the inverse.
    let mut inverse = GivenPose::new("imu", "cam0", t_cam0_imu, "");
    inverse.matrix = Some(MatrixConvention {
        function: Function::Passive,
        direction: Direction::WorldToBody,
    });
    let turned = asked(&[inverse, poses[1].clone()], "cam0", "cam1");
    let rows = answered(&turned).homogeneous.expect("a position");
    for (got, wanted) in rows.iter().zip(&expected) {
        assert_close("the same", got, wanted, 2e-5);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_position_is_told_once() {
    let homogeneous = "0 -1 0 5; 1 0 0 6; 0 0 1 7; 0 0 0 1";
    let report = asked(&[GivenPose::new("A", "B", homogeneous, "1 2 3")], "B", "A");
    let [problem] = &report.poses[0].problems[..] else {
        panic!("{:?}", report.poses[0]);
    };
    assert_eq!(problem.code, ProblemCode::TwoMeanings);
    assert_eq!(report.answer, None, "the pose takes no part");
}

/// A camera that is mounted on a body: the mounting stands on the right.
#[wasm_bindgen_test(unsupported = test)]
fn a_camera_stands_on_a_body() {
    let poses = [
        GivenPose::new("world", "body", "0.4952 -0.283 -0.15426 0.80678", ""),
        GivenPose::new("body", "camera", "yaw 90 deg pitch -30 deg roll 0 deg", ""),
    ];
    let report = asked(&poses, "camera", "world");
    let unit = answered(&report).hamilton.unit.array;
    let expected = [-0.189_252, -0.060_375, 0.144_954, 0.969_292];
    assert_close("q_WC", &unit, &expected, 1e-5);
}
