//! ROS and what belongs to it.

use crate::formats::{Printed, check};
use wasm_bindgen_test::wasm_bindgen_test;

const PRINTED: &[Printed] = &[
    Printed {
        format: Some("tf_echo"),
        library: None,
        text: "At time 1263248513.809\n- Translation: [2.398, 6.783, -0.120]\n- Rotation: in Quaternion [-0.3974505303, 0.0057871595, 0.8193180082, 0.4131798473]\n            in RPY (radian) [-0.436, 0.716, 2.042]\n            in RPY (degree) [-25.000, 41.000, 117.000]",
        rotation: [
            0.413179847314,
            -0.397450530295,
            0.005787159465,
            0.819318008179,
        ],
        position: Some([2.398, 6.783, -0.12]),
    },
    Printed {
        format: Some("tf_echo"),
        library: None,
        text: "At time 0.0\n- Translation: [0.100, -0.200, 0.300]\n- Rotation: in Quaternion (xyzw) [0.2365599794, 0.1953436584, -0.5114284748, 0.8026961732]\n- Rotation: in RPY (radian) [0.218, 0.589, -1.068]\n- Rotation: in RPY (degree) [12.500, 33.750, -61.200]",
        rotation: [
            0.802696173189,
            0.236559979419,
            0.195343658385,
            -0.511428474778,
        ],
        position: Some([0.1, -0.2, 0.3]),
    },
    Printed {
        format: Some("static_transform_publisher"),
        library: None,
        text: "rosrun tf static_transform_publisher -1.854 2.817 -2.638 -0.734994 -1.146706 0.173511 base_link laser 50",
        rotation: [
            0.797932152383,
            -0.126229028596,
            -0.530480573214,
            -0.256828491363,
        ],
        position: Some([-1.854, 2.817, -2.638]),
    },
    Printed {
        format: Some("static_transform_publisher"),
        library: None,
        text: "ros2 run tf2_ros static_transform_publisher -2.856 1.298 0.810 -0.692759 -0.498469 -0.330468 0.402993 map odom",
        rotation: [
            0.402993235123,
            -0.692759404185,
            -0.498469290828,
            -0.330468192809,
        ],
        position: Some([-2.856, 1.298, 0.81]),
    },
    Printed {
        format: Some("URDF"),
        library: None,
        text: r#"<origin xyz="2.555 -1.833 -0.994" rpy="0.836311 0.450842 2.751014"/>"#,
        rotation: [
            0.261883827217,
            -0.123570281047,
            0.427914741319,
            0.856175344685,
        ],
        position: Some([2.555, -1.833, -0.994]),
    },
    Printed {
        format: Some("SDFormat"),
        library: None,
        text: "<pose>1.554 -2.404 2.622 -0.821365 -0.634808 0.632206</pose>",
        rotation: [
            0.866628222171,
            -0.271546585295,
            -0.389880962103,
            0.152350949919,
        ],
        position: Some([1.554, -2.404, 2.622]),
    },
    Printed {
        format: Some("SDFormat"),
        library: None,
        text: "<pose rotation_format='quat_xyzw'>2.536 2.007 1.811 -0.279616 -0.849353 -0.384936 0.228557</pose>",
        rotation: [
            0.228557039722,
            -0.279616048596,
            -0.849353147613,
            -0.3849360669,
        ],
        position: Some([2.536, 2.007, 1.811]),
    },
    Printed {
        format: Some("g2o"),
        library: None,
        text: "VERTEX_SE3:QUAT 7 0.806 0.896 0.738 0.128887 -0.866284 0.384722 -0.291427",
        rotation: [
            -0.291426921163,
            0.128886965134,
            -0.866283765654,
            0.384721895925,
        ],
        position: Some([0.806, 0.896, 0.738]),
    },
    Printed {
        format: Some("MuJoCo"),
        library: None,
        text: r#"<body name="arm" pos="1.629 -0.980 1.342" quat="0.700668 0.436889 0.490022 0.279412"/>"#,
        rotation: [
            0.700667905139,
            0.436888940851,
            0.490021933658,
            0.279411962171,
        ],
        position: Some([1.629, -0.98, 1.342]),
    },
    Printed {
        format: Some("MuJoCo"),
        library: None,
        text: r#"<body name="arm" pos="2.445 -0.047 1.698" euler="113.3835 -38.2814 179.7538"/>"#,
        rotation: [
            0.275140141563,
            -0.178361323125,
            -0.789911124283,
            0.518194516227,
        ],
        position: Some([2.445, -0.047, 1.698]),
    },
    Printed {
        format: Some("MuJoCo"),
        library: None,
        text: r#"<camera name="top" pos="1.148 -1.408 2.951" xyaxes="-0.391973 -0.837627 -0.380445 0.265136 0.293138 -0.918571"/>"#,
        rotation: [
            0.502082511173,
            -0.227874249789,
            0.628077923368,
            -0.549094345659,
        ],
        position: Some([1.148, -1.408, 2.951]),
    },
    Printed {
        format: Some("MuJoCo"),
        library: None,
        text: r#"<geom axisangle="-0.699268 0.452337 -0.553548 149.827169"/>"#,
        rotation: [
            0.260275593311,
            -0.675167324934,
            0.436746944317,
            -0.534469648808,
        ],
        position: None,
    },
    Printed {
        format: Some("tf.transformations"),
        library: None,
        text: ">>> tf.transformations.euler_from_quaternion(q)\n(2.11879092, 0.57113130, -1.42474273)",
        rotation: [
            0.194814188244,
            0.723371240859,
            -0.442583555478,
            -0.492850156109,
        ],
        position: None,
    },
    Printed {
        format: Some("PyBullet"),
        library: None,
        text: ">>> p.getEulerFromQuaternion(q)\n(0.72555862, -0.76687779, -0.91156345)",
        rotation: [
            0.836953152016,
            0.14155548062,
            -0.458917734895,
            -0.262423283714,
        ],
        position: None,
    },
    Printed {
        format: Some("RViz"),
        library: None,
        text: "[ INFO] [1672531200.123]: Setting goal: Frame:map, Position(1.250, -0.500, 0.000), Orientation(0.000, 0.000, 0.600, 0.800) = Angle: 1.287",
        rotation: [0.8, 0.000000000000000, 0.000000000000000, 0.6],
        position: Some([1.25, -0.5, 0.0]),
    },
    Printed {
        format: Some("tf"),
        library: None,
        text: ">>> (trans, rot) = listener.lookupTransform(\"/map\", \"/base_link\", rospy.Time(0))\n>>> trans, rot\n([0.5, -0.25, 1.75], [0.231455, -0.612372, 0.433013, 0.619657])",
        rotation: [
            0.619642767209,
            0.231449683751,
            -0.612357934536,
            0.433003054201,
        ],
        position: Some([0.5, -0.25, 1.75]),
    },
    Printed {
        format: Some("CoppeliaSim"),
        library: None,
        text: "> sim.getObjectQuaternion(h, -1)\n{0.231455, -0.612372, 0.433013, 0.619657}",
        rotation: [
            0.619642767209,
            0.231449683751,
            -0.612357934536,
            0.433003054201,
        ],
        position: None,
    },
    Printed {
        format: Some("SciPy"),
        library: None,
        text: ">>> r.as_quat()\narray([0.231455, -0.612372, 0.433013, 0.619657])",
        rotation: [
            0.619642767209,
            0.231449683751,
            -0.612357934536,
            0.433003054201,
        ],
        position: None,
    },
    Printed {
        format: Some("SciPy"),
        library: None,
        text: ">>> r.as_quat(scalar_first=True)\narray([0.231455, -0.612372, 0.433013, 0.619657])",
        rotation: [
            0.231449683751,
            -0.612357934536,
            0.433003054201,
            0.619642767209,
        ],
        position: None,
    },
    Printed {
        format: Some("RViz"),
        library: None,
        text: "Position\t0.5; -1.5; 2.25\nOrientation\t0.231455; -0.612372; 0.433013; 0.619657",
        rotation: [
            0.619642767209,
            0.231449683751,
            -0.612357934536,
            0.433003054201,
        ],
        position: Some([0.5, -1.5, 2.25]),
    },
    Printed {
        format: None,
        library: None,
        text: "rostopic pub /initialpose geometry_msgs/PoseWithCovarianceStamped '{pose: {pose: {position: {x: 0.5, y: -1.5, z: 2.25}, orientation: {x: 0.231455, y: -0.612372, z: 0.433013, w: 0.619657}}}}'",
        rotation: [
            0.619642767209,
            0.231449683751,
            -0.612357934536,
            0.433003054201,
        ],
        position: Some([0.5, -1.5, 2.25]),
    },
    Printed {
        format: Some("URDF"),
        library: None,
        text: r#"<origin rpy="${pi/2} 0.3 ${-3*pi/4}" xyz="0.5 -1.5 2.25"/>"#,
        rotation: [
            0.169934360943,
            0.365184690373,
            -0.605508168332,
            -0.68638350284,
        ],
        position: Some([0.5, -1.5, 2.25]),
    },
];

#[wasm_bindgen_test(unsupported = test)]
fn prints_of_ros_are_read() {
    check(PRINTED);
}
