//! Scenes and drawings.

use crate::formats::{Printed, check};
use wasm_bindgen_test::wasm_bindgen_test;

const PRINTED: &[Printed] = &[
    Printed {
        format: Some("3MF"),
        library: None,
        text: r#"<item objectid="1" transform="-0.5207263 0.1612721 -0.8383528 -0.8532381 -0.1314287 0.5046893 -0.0287913 0.9781195 0.2060419 2.6600000 2.2920000 -0.7460000"/>"#,
        rotation: [
            0.372117893224,
            -0.318064666376,
            0.543887784986,
            0.681578475958,
        ],
        position: Some([2.66, 2.292, -0.746]),
    },
    Printed {
        format: Some("glTF"),
        library: None,
        text: r#"{"name": "arm", "matrix": [-0.7545035, -0.6105634, 0.2407006, 0, 0.1128442, 0.2406041, 0.9640414, 0, -0.6465220, 0.7545343, -0.1126382, 0, 0.1550000, -0.0720000, 2.3170000, 1]}"#,
        rotation: [
            -0.305557879316,
            -0.171413621841,
            0.725903880925,
            0.591874402465,
        ],
        position: Some([0.155, -0.072, 2.317]),
    },
    Printed {
        format: Some("glTF"),
        library: None,
        text: r#"{"mesh": 0, "rotation": [0.260091, -0.566274, 0.375733, 0.685939], "translation": [-1.503, -2.356, 2.443]}"#,
        rotation: [
            0.6859385986,
            0.260090847799,
            -0.566273668626,
            0.375732780127,
        ],
        position: Some([-1.503, -2.356, 2.443]),
    },
    Printed {
        format: Some("USD"),
        library: Some("usd"),
        text: "quatf xformOp:orient = (0.764306, 0.198804, -0.348326, -0.504958)",
        rotation: [
            0.764305894491,
            0.198803972556,
            -0.348325951915,
            -0.504957930293,
        ],
        position: None,
    },
    Printed {
        format: Some("USD"),
        library: None,
        text: "matrix4d xformOp:transform = ( (0.1583361, -0.7410767, 0.6524837, 0), (-0.9700153, -0.2401537, -0.0373708, 0), (0.1843910, -0.6270020, -0.7568808, 0), (-0.4770000, -2.1600000, 2.9450000, 1) )",
        rotation: [
            0.200811913862,
            0.734059014854,
            -0.582750148079,
            0.285016144941,
        ],
        position: Some([-0.477, -2.16, 2.945]),
    },
    Printed {
        format: Some("USD"),
        library: None,
        text: "float3 xformOp:rotateXYZ = (118.9181, -11.8256, 89.4286)",
        rotation: [
            0.296762149792,
            0.645610346383,
            0.565539738252,
            0.418669692659,
        ],
        position: None,
    },
    Printed {
        format: Some("Roblox CFrame"),
        library: None,
        text: "CFrame.new(0.363, 1.754, 2.969, -0.2476368, 0.4834973, -0.8395870, -0.0362220, 0.8613523, 0.5067151, 0.9681756, 0.1558928, -0.1957893)",
        rotation: [-0.595383531988, 0.147309365225, 0.7590748307, 0.21822878397],
        position: Some([0.363, 1.754, 2.969]),
    },
    Printed {
        format: Some("X3D"),
        library: None,
        text: "DEF Arm Transform {\n  translation 2.935 0.381 -1.198\n  rotation -0.447066 0.801138 0.397882 2.814162\n}",
        rotation: [
            0.162984970569,
            -0.441088038417,
            0.790425549966,
            0.392561704315,
        ],
        position: Some([2.935, 0.381, -1.198]),
    },
    Printed {
        format: Some("X3D"),
        library: None,
        text: r#"<Viewpoint position="-2.437 2.260 -1.573" orientation="-0.631202 0.693030 -0.348272 2.713040"/>"#,
        rotation: [
            0.212640360859,
            -0.616766767244,
            0.677180795852,
            -0.34030721633,
        ],
        position: Some([-2.437, 2.26, -1.573]),
    },
    Printed {
        format: Some("FreeCAD"),
        library: None,
        text: r#"<PropertyPlacement Px="2.563" Py="-1.574" Pz="-2.474" Q0="0.304790" Q1="0.169241" Q2="0.861142" Q3="-0.369992"/>"#,
        rotation: [
            -0.369992169381,
            0.304790139532,
            0.169241077478,
            0.861142394227,
        ],
        position: Some([2.563, -1.574, -2.474]),
    },
    Printed {
        format: Some("FreeCAD"),
        library: None,
        text: "Placement [Pos=(-0.024,-2.650,1.796), Yaw-Pitch-Roll=(-156.3263,44.3109,166.2118)]",
        rotation: [
            -0.343628664758,
            0.232911288443,
            -0.890630255559,
            -0.185605550444,
        ],
        position: Some([-0.024, -2.65, 1.796]),
    },
    Printed {
        format: Some("Maya"),
        library: None,
        text: "createNode transform -n \"arm\";\n\tsetAttr \".t\" -type \"double3\" 0.368 0.331 -2.865 ;\n\tsetAttr \".r\" -type \"double3\" -176.1630 -73.2808 -42.2057 ;",
        rotation: [
            -0.189689005495,
            -0.755358423028,
            0.27009621415,
            -0.566126990221,
        ],
        position: Some([0.368, 0.331, -2.865]),
    },
    Printed {
        format: Some("A-Frame"),
        library: None,
        text: "<a-entity gltf-model=\"#arm\" position=\"2.649 0.457 -0.212\" rotation=\"-44.1698 -95.9407 -17.9396\"></a-entity>",
        rotation: [
            0.569261067189,
            -0.14133077124,
            -0.71912754398,
            -0.372589621397,
        ],
        position: Some([2.649, 0.457, -0.212]),
    },
    Printed {
        format: Some("COLLADA"),
        library: None,
        text: r#"<rotate sid="jointOrient">-0.696026 0.538365 0.475090 155.124084</rotate>"#,
        rotation: [
            0.215382317643,
            -0.679690277828,
            0.525729579675,
            0.463939643194,
        ],
        position: None,
    },
    Printed {
        format: Some("OpenSCAD"),
        library: None,
        text: "rotate([107.7170, -54.3010, -18.5908]) cube(3);",
        rotation: [
            0.577426926504,
            0.665670586809,
            -0.38166856255,
            0.278908448721,
        ],
        position: None,
    },
    Printed {
        format: Some("OpenSCAD"),
        library: None,
        text: "multmatrix([[-0.4596377, -0.6614831, 0.5925988, 0.3160000], [-0.8877487, 0.3232703, -0.3277173, -0.6370000], [0.0252098, -0.6767100, -0.7358180, -0.7340000], [0, 0, 0, 1]]) cube(3);",
        rotation: [
            0.178755917717,
            -0.488085534054,
            0.793524724067,
            -0.316444854001,
        ],
        position: Some([0.316, -0.637, -0.734]),
    },
    Printed {
        format: Some("OpenRAVE"),
        library: None,
        text: "<Body name=\"base\">\n  <Translation>0.9 -0.5 0.3</Translation>\n  <RotationAxis>0.36 0.48 -0.8 75.5</RotationAxis>\n</Body>",
        rotation: [
            0.790689573744,
            0.220398220812,
            0.293864294417,
            -0.489773824028,
        ],
        position: Some([0.9, -0.5, 0.3]),
    },
    Printed {
        format: Some("CZML"),
        library: None,
        text: "\"orientation\": {\n  \"unitQuaternion\": [0.231455, -0.612372, 0.433013, 0.619657]\n}",
        rotation: [
            0.619642767209,
            0.231449683751,
            -0.612357934536,
            0.433003054201,
        ],
        position: None,
    },
    Printed {
        format: Some("USD"),
        library: None,
        text: "double3 xformOp:translate = (0.5, -1.5, 2.25)\nfloat3 xformOp:rotateZXY = (-42.0612, 156.8808, 128.7781)\nuniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:rotateZXY\"]",
        rotation: [
            -0.236194846086,
            0.793526688483,
            0.460128197893,
            0.320639097509,
        ],
        position: Some([0.5, -1.5, 2.25]),
    },
    Printed {
        format: Some("USD"),
        library: None,
        text: "float3 xformOp:rotateZYX = (-144.9421, -13.6222, -89.5845)",
        rotation: [
            0.291909903556,
            -0.646770825726,
            -0.69243065363,
            -0.130444996489,
        ],
        position: None,
    },
    Printed {
        format: Some("USD"),
        library: None,
        text: "Gf.Rotation(Gf.Vec3d(-0.19667269, 0.70103258, 0.68547296), 119.236424)",
        rotation: [
            0.505759580517,
            -0.169664508891,
            0.604762910408,
            0.591340023449,
        ],
        position: None,
    },
];

#[wasm_bindgen_test(unsupported = test)]
fn nodes_of_scenes_are_read() {
    check(PRINTED);
}
