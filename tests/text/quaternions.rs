//! Every form of text of four numbers and of three, and the order that it tells.

use crate::support::{assert_close, wxyz};
use quatlas::{ComponentOrder, OrderSource, parse_quaternion, parse_vector};
use wasm_bindgen_test::wasm_bindgen_test;

/// √½, cos(π/8) and sin(π/8), as the nearest doubles.
pub(crate) const HALF_ROOT: f64 = std::f64::consts::FRAC_1_SQRT_2;
pub(crate) const COS: f64 = 0.923_879_532_511_286_7;
pub(crate) const SIN: f64 = 0.382_683_432_365_089_8;

/// One rounding of a number below 1 in the arithmetic of the text, and one in the reference.
pub(crate) const ARITHMETIC: f64 = 2.3e-16;

/// Texts of one quaternion, w = 0.92, x = 0.1, y = -0.2, z = 0.38, that tell their own order.
const TOLD: &[(&str, OrderSource)] = &[
    ("(w=0.92, x=0.1, y=-0.2, z=0.38)", OrderSource::Named),
    ("z: 0.38, y: -0.2, x: 0.1, w: 0.92", OrderSource::Named),
    ("x: 0.1\ny: -0.2\nz: 0.38\nw: 0.92", OrderSource::Named),
    (
        "orientation:\n  x: 0.1\n  y: -0.2\n  z: 0.38\n  w: 0.92\n---",
        OrderSource::Named,
    ),
    (
        "geometry_msgs.msg.Quaternion(x=0.1, y=-0.2, z=0.38, w=0.92)",
        OrderSource::Named,
    ),
    (
        r#"{"w": 0.92, "x": 0.1, "y": -0.2, "z": 0.38}"#,
        OrderSource::Named,
    ),
    (
        r#"{"orientation": {"x": 0.1, "y": -0.2, "z": 0.38, "w": 0.92}}"#,
        OrderSource::Named,
    ),
    (
        "{'qw': 0.92, 'qx': 0.1, 'qy': -0.2, 'qz': 0.38}",
        OrderSource::Named,
    ),
    (
        "q.w = 0.92; q.x = 0.1; q.y = -0.2; q.z = 0.38;",
        OrderSource::Named,
    ),
    ("0.92 + 0.1i - 0.2j + 0.38k", OrderSource::Named),
    ("0.38 k + 0.92 - 0.2 j + 0.1 i", OrderSource::Named),
    ("0.92 +0.1i -0.2j +0.38k", OrderSource::Named),
    ("0.92 + i/10 − j/5 + k*0.38", OrderSource::Named),
    ("0.92 + i·0.1 - 0.2·j + 0.38×k", OrderSource::Named),
    ("q = 0.92 + 0.1i - 0.2j + 0.38k", OrderSource::Named),
    ("0.92 [0.1, -0.2, 0.38]", OrderSource::Grouped),
    ("[0.92, (0.1, -0.2, 0.38)]", OrderSource::Grouped),
    ("[[0.1 -0.2 0.38], 0.92]", OrderSource::Grouped),
    (
        "Eigen::Quaterniond(0.92, 0.1, -0.2, 0.38)",
        OrderSource::Constructor,
    ),
    (
        "const Eigen::Quaterniond q(0.92, 0.1, -0.2, 0.38);",
        OrderSource::Constructor,
    ),
    (
        "Eigen::Quaternion<double> q{0.92, 0.1, -0.2, 0.38};",
        OrderSource::Constructor,
    ),
    (
        "auto q = Eigen::Quaternionf(0.92f, 0.1f, -0.2f, 0.38f);",
        OrderSource::Constructor,
    ),
    (
        "Sophus::SO3d(Eigen::Quaterniond(0.92, 0.1, -0.2, 0.38))",
        OrderSource::Constructor,
    ),
    (
        "Rotation.from_quat([0.1, -0.2, 0.38, 0.92])",
        OrderSource::Constructor,
    ),
    (
        "r = R.from_quat(np.array([0.1, -0.2, 0.38, 0.92]))",
        OrderSource::Constructor,
    ),
    (
        "R.from_quat([0.92, 0.1, -0.2, 0.38], scalar_first=True)",
        OrderSource::Constructor,
    ),
    (
        "new THREE.Quaternion(0.1, -0.2, 0.38, 0.92)",
        OrderSource::Constructor,
    ),
    (
        "tf2::Quaternion q(0.1, -0.2, 0.38, 0.92);",
        OrderSource::Constructor,
    ),
    (
        "let q = DQuat::from_xyzw(0.1, -0.2, 0.38, 0.92);",
        OrderSource::Constructor,
    ),
    (
        "UnitQuaternion::new_normalize(Quaternion::new(0.92, 0.1, -0.2, 0.38))",
        OrderSource::Constructor,
    ),
    (
        "mathutils.Quaternion((0.92, 0.1, -0.2, 0.38))",
        OrderSource::Constructor,
    ),
];

#[wasm_bindgen_test(unsupported = test)]
fn a_text_that_tells_its_order_is_read_alike_under_both_declarations() {
    check_told(TOLD);
}

fn check_told(texts: &[(&str, OrderSource)]) {
    for (text, source) in texts {
        for declared in ComponentOrder::ALL {
            let parsed = parse_quaternion(text, declared)
                .unwrap_or_else(|problem| panic!("{}", problem.render(text)));
            assert_close(
                text,
                &wxyz(&parsed.quaternion),
                &[0.92, 0.1, -0.2, 0.38],
                ARITHMETIC,
            );
            assert_eq!(parsed.order_source, *source, "{text}");
        }
    }
}

/// A whole message, of which the orientation is taken.
const POSE_STAMPED: &str = "header:
  seq: 7
  stamp:
    secs: 1
    nsecs: 2
  frame_id: \"map\"
pose:
  position:
    x: 1.0
    y: 2.0
    z: 3.0
  orientation:
    x: 0.1
    y: -0.2
    z: 0.38
    w: 0.92
--- ";

/// Texts as programs print them, of the same quaternion.
const PRINTED: &[(&str, OrderSource)] = &[
    (POSE_STAMPED, OrderSource::Named),
    (
        r#"{"position": {"x": 1, "y": 2, "z": 3}, "orientation": {"x": 0.1, "y": -0.2, "z": 0.38, "w": 0.92}}"#,
        OrderSource::Named,
    ),
    (
        "Quaternion { isQuaternion: true, _x: 0.1, _y: -0.2, _z: 0.38, _w: 0.92 }",
        OrderSource::Named,
    ),
    (
        "<Quaternion (w=0.9200, x=0.1000, y=-0.2000, z=0.3800)>",
        OrderSource::Named,
    ),
    ("wxyz: 0.92 0.1 -0.2 0.38", OrderSource::Named),
    (
        r#"{"rotation": [0.1, -0.2, 0.38, 0.92], "order": "xyzw"}"#,
        OrderSource::Named,
    ),
    (
        r#"{"format": "wxyz", "quaternion": [0.92, 0.1, -0.2, 0.38], "id": 7}"#,
        OrderSource::Named,
    ),
    (
        r#"{"type": "quaternion", "w": 0.92, "x": 0.1, "y": -0.2, "z": 0.38}"#,
        OrderSource::Named,
    ),
    (
        "orientation:\n  x: 0.1\n  y: -0.2\n  z: 0.38\n  w: 0.92\norientation_covariance: [1, 0, 0, 0, 1, 0, 0, 0, 1]",
        OrderSource::Named,
    ),
    ("q_xyzw = [0.1, -0.2, 0.38, 0.92]", OrderSource::Named),
    (
        "Gf.Quatd(0.92, Gf.Vec3d(0.1, -0.2, 0.38))",
        OrderSource::Grouped,
    ),
    (
        "Quaternion.from_wxyz(array([0.92, 0.1, -0.2, 0.38], dtype=float32))",
        OrderSource::Constructor,
    ),
];

#[wasm_bindgen_test(unsupported = test)]
fn what_programs_print_is_read_alike_under_both_declarations() {
    check_told(PRINTED);
}

/// Texts of four bare numbers a, b, c, d = 0.92, 0.1, -0.2, 0.38, in that order.
const BARE: &[&str] = &[
    "0.92 0.1 -0.2 0.38",
    "  0.92\t0.1\n-0.2  0.38 ",
    "0.92, 0.1, -0.2, 0.38",
    "0.92;0.1;-0.2;0.38;",
    "[0.92, 0.1, -0.2, 0.38]",
    "[0.92 0.1 -0.2 0.38]",
    "{0.92, 0.1, -0.2, 0.38}",
    "((0.92), 0.1, -0.2, 0.38)",
    "[[0.92], [0.1], [-0.2], [0.38]]",
    "q = [0.92, 0.1, -0.2, 0.38]",
    "array([ 0.92,  0.1 , -0.2 ,  0.38])",
    "[np.float64(0.92), np.float64(0.1), np.float64(-0.2), np.float64(0.38)]",
    "- 0.92\n- 0.1\n- -0.2\n- 0.38\n",
    "92e-2 +.1 −0.2 38.e-2",
    "orientation:\n- 0.92\n- 0.1\n- -0.2\n- 0.38\n",
    "9.2×10−1 1×10-1 −2×10^-1 .38",
    "0.92_f64, 0.1f32, -0.2f, 0.38F",
    "0.92 0.1 -0.2 0.38 # of the tool",
    "% as printed\n0.92 0.1 -0.2 0.38 % as MATLAB comments",
    "/* w */ 0.92, /* x */ 0.1, -0.2, 0.38",
    "double q[4] = {0.92, 0.1, -0.2, 0.38};",
    "array([0.92, 0.1, -0.2, 0.38], dtype=float32)",
    "<0.92, 0.1, -0.2, 0.38>",
    "46/50 1/10 -1/5 19/50",
    "1 - 0.08, 0.1, 0.3 - 0.5, 0.38",
];

#[wasm_bindgen_test(unsupported = test)]
fn bare_numbers_are_read_in_the_declared_order() {
    let read_as = |text: &str, declared| {
        let parsed = parse_quaternion(text, declared)
            .unwrap_or_else(|problem| panic!("{}", problem.render(text)));
        assert_eq!(parsed.order_source, OrderSource::Declared, "{text}");
        assert_eq!(parsed.order, declared, "{text}");
        wxyz(&parsed.quaternion)
    };
    for text in BARE {
        let first = read_as(text, ComponentOrder::ScalarFirst);
        assert_close(text, &first, &[0.92, 0.1, -0.2, 0.38], ARITHMETIC);
        let last = read_as(text, ComponentOrder::ScalarLast);
        assert_close(text, &last, &[0.38, 0.92, 0.1, -0.2], ARITHMETIC);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn arithmetic_is_computed() {
    let cases: &[(&str, [f64; 4])] = &[
        ("cos(pi/8) + sin(pi/8) k", [COS, 0.0, 0.0, SIN]),
        ("sin(pi/8)k+cos(pi/8)", [COS, 0.0, 0.0, SIN]),
        ("cos(22.5°) + sin(22.5 deg) k", [COS, 0.0, 0.0, SIN]),
        ("k sin(pi/8) + cos(pi/8)", [COS, 0.0, 0.0, SIN]),
        ("cos(np.deg2rad(22.5)) + k √½ √½", [COS, 0.0, 0.0, 0.5]),
        (
            "Math.SQRT1_2 0 0 -M_SQRT1_2",
            [HALF_ROOT, 0.0, 0.0, -HALF_ROOT],
        ),
        (
            "Math.cos(Math.PI/8), 0, 0, Math.sin(Math.PI/8)",
            [COS, 0.0, 0.0, SIN],
        ),
        ("1/sqrt(2) - i/2 - j/2", [HALF_ROOT, -0.5, -0.5, 0.0]),
        ("1/√2 − ½i − √2√2/4 j", [HALF_ROOT, -0.5, -0.5, 0.0]),
        ("√½ 0 0 −√½", [HALF_ROOT, 0.0, 0.0, -HALF_ROOT]),
        ("√(1/2) 0 -(1/2) 1-2/4", [HALF_ROOT, 0.0, -0.5, 0.5]),
        (
            "sqrt(1 -0.5) -0 2*-.25 +(1-0.5)",
            [HALF_ROOT, 0.0, -0.5, 0.5],
        ),
        (
            "cos(2pi/8) 0 -cos(tau/6) abs(-1/2)",
            [HALF_ROOT, 0.0, -0.5, 0.5],
        ),
        ("(1 + k)/√2", [HALF_ROOT, 0.0, 0.0, HALF_ROOT]),
        ("1/2k + 1", [1.0, 0.0, 0.0, 0.5]),
        (
            "tan(atan(1/2)) asin(sin(0.5)) acos(cos(0.5)) √√(1/16)",
            [0.5; 4],
        ),
    ];
    for (text, expected) in cases {
        let parsed = parse_quaternion(text, ComponentOrder::ScalarFirst)
            .unwrap_or_else(|problem| panic!("{}", problem.render(text)));
        assert_close(text, &wxyz(&parsed.quaternion), expected, ARITHMETIC);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn vectors_come_in_the_same_forms() {
    let texts = [
        "1 -2 0.5",
        "[1, -2, 1/2]",
        "x: 1\ny: -2\nz: 0.5",
        r#"{"x": 1, "z": 0.5, "y": -2}"#,
        "i - 2j + k/2",
        "Eigen::Vector3d v(1, -2, 0.5);",
        "np.array([1, -2, 0.5])",
        "x = [1, -2, 0.5]",
        "x = 1 -2 0.5",
        "v: [1, -2, 0.5]",
    ];
    for text in texts {
        let vector =
            parse_vector(text).unwrap_or_else(|problem| panic!("{}", problem.render(text)));
        assert_eq!(vector.as_slice(), [1.0, -2.0, 0.5], "{text}");
    }
}

/// What Node and nalgebra write around numbers is passed over; the place of a problem stays.
#[wasm_bindgen_test(unsupported = test)]
fn what_consoles_write_around_numbers() {
    let four = |text: &str| parse_quaternion(text, ComponentOrder::ScalarLast);
    let parsed = four("Float32Array(4) [ 0.1, -0.2, 0.38, 0.92 ]").expect("four numbers");
    assert_eq!((parsed.quaternion.w, parsed.quaternion.i), (0.92, 0.1));
    let vector = parse_vector("Vector3(3) [ 3, 1, 2 ]").expect("three numbers");
    assert_eq!(vector.as_slice(), [3.0, 1.0, 2.0]);
    let drawn = "\u{250c} 1 \u{2510}\n\u{2502} 2 \u{2502}\n\u{2514} 3 \u{2518}";
    let vector = parse_vector(drawn).expect("three numbers");
    assert_eq!(vector.as_slice(), [1.0, 2.0, 3.0]);
    let text = "\u{2502}\u{2502} Quaternion(4) [ 0, 0, oops, 1 ]";
    let problem = four(text).expect_err("a word");
    assert_eq!(&text[problem.span.start..problem.span.end], "oops");
    // A call with numbers is no list with its length.
    assert!(four("Quaternion(4) (0, 0, 0, 1)").is_err());
    // As much of it as there may be.
    let long = "\u{2502}[".repeat(20_000);
    assert!(four(&long).is_err());
    let long = "Array(1) [".repeat(6_500);
    assert!(four(&long).is_err());
}
