//! Libraries of graphics and of mathematics.

use crate::formats::{Printed, check};
use wasm_bindgen_test::wasm_bindgen_test;

const PRINTED: &[Printed] = &[
    Printed {
        format: Some("GLM"),
        library: None,
        text: "mat4x4((-0.2943796, 0.0498187, 0.9543892, 0), (-0.7795430, 0.5651894, -0.2699513, 0), (-0.5528592, -0.8234556, -0.1275444, 0), (0.2500000, 1.8700000, 1.9710000, 1))",
        rotation: [
            -0.534617930486,
            -0.258831715207,
            0.704825045804,
            -0.38782917169,
        ],
        position: Some([0.25, 1.87, 1.971]),
    },
    Printed {
        format: Some("GLM"),
        library: None,
        text: "glm::quat tilt(glm::vec3(-3.125546f, -0.793113f, 0.911450f));",
        rotation: [
            0.176631183357,
            -0.826868178852,
            -0.408728685936,
            -0.343556838326,
        ],
        position: None,
    },
    Printed {
        format: Some("three.js"),
        library: None,
        text: "Euler {isEuler: true, _x: -2.396127, _y: 0.183912, _z: 0.894067, _order: 'ZYX'}",
        rotation: [
            0.290019455632,
            -0.850724034455,
            -0.370754645961,
            0.233876730466,
        ],
        position: None,
    },
    Printed {
        format: Some("three.js"),
        library: None,
        text: "camera.rotation.toArray() // [-0.723883, -1.627261, 2.927411, 'YXZ']",
        rotation: [
            0.324533477248,
            -0.701800219799,
            0.169168554844,
            0.611176303277,
        ],
        position: None,
    },
    Printed {
        format: Some("CesiumJS"),
        library: None,
        text: "new Cesium.HeadingPitchRoll(-1.797219, 1.012634, 2.609966)",
        rotation: [
            -0.223079311605,
            0.625129353411,
            0.580929218238,
            0.471137087943,
        ],
        position: None,
    },
    Printed {
        format: Some("Babylon.js"),
        library: Some("babylon"),
        text: "mesh.rotation {X: -0.022547 Y: -2.382561 Z: -2.070763}",
        rotation: [
            0.179995647853,
            0.796677378431,
            -0.477456119292,
            -0.323948106339,
        ],
        position: None,
    },
    Printed {
        format: Some("JOML"),
        library: None,
        text: "new Quaternionf().rotationXYZ(-0.716403f, -0.337275f, 2.614115f)",
        rotation: [
            0.183873940925,
            -0.241850782173,
            0.292689154463,
            0.906659600881,
        ],
        position: None,
    },
    Printed {
        format: Some("JOML"),
        library: Some("joml"),
        text: "( 0.574079  0.428905  -0.697477 <| 1.693391 )",
        rotation: [
            0.662462144053,
            0.430039856065,
            0.32129070122,
            -0.522476712593,
        ],
        position: None,
    },
    Printed {
        format: Some("spatialmath"),
        library: Some("spatialmath"),
        text: "t = 1, 2, 3; eul = -42.0144°, 109.6122°, 102.6009°",
        rotation: [
            0.497648234528,
            0.77855409615,
            0.248353773207,
            0.290723506744,
        ],
        position: None,
    },
    Printed {
        format: Some("SymPy"),
        library: Some("sympy"),
        text: "q.a = -0.567792, q.b = -0.339441, q.c = 0.207700, q.d = 0.720592",
        rotation: [
            -0.567791980636,
            -0.339440988424,
            0.207699992916,
            0.720591975425,
        ],
        position: None,
    },
    Printed {
        format: Some("nalgebra"),
        library: None,
        text: "Quaternion { coords: [[0.441074, -0.361459, 0.127784, -0.811463]] }",
        rotation: [
            -0.811463067683,
            0.44107403679,
            -0.361459030149,
            0.127784010658,
        ],
        position: None,
    },
    Printed {
        format: Some("glam"),
        library: None,
        text: "Transform { translation: Vec3(2.939, -1.800, 1.555), rotation: Quat(0.139789, 0.352610, 0.901969, 0.206341), scale: Vec3(1.0, 1.0, 1.0) }",
        rotation: [
            0.20634105552,
            0.139789037613,
            0.352610094876,
            0.901969242692,
        ],
        position: Some([2.939, -1.8, 1.555]),
    },
    Printed {
        format: Some("Babylon.js"),
        library: None,
        text: "mesh.rotationQuaternion = BABYLON.Quaternion.RotationYawPitchRoll(0.7, -0.4, 1.9);",
        rotation: [
            0.480112726099,
            0.164802251281,
            0.347285279468,
            0.788495353744,
        ],
        position: None,
    },
    Printed {
        format: Some("React Three Fiber"),
        library: None,
        text: "<group quaternion={[0.231455, -0.612372, 0.433013, 0.619657]} scale={0.5} />",
        rotation: [
            0.619642767209,
            0.231449683751,
            -0.612357934536,
            0.433003054201,
        ],
        position: None,
    },
    Printed {
        format: Some("Dart vector_math"),
        library: None,
        text: "flutter: 0.231455, -0.612372, 0.433013 @ 0.619657",
        rotation: [
            0.619642767209,
            0.231449683751,
            -0.612357934536,
            0.433003054201,
        ],
        position: None,
    },
    Printed {
        format: Some("PyPose"),
        library: None,
        text: ">>> x\nSE3Type LieTensor:\nLieTensor([1.5, -2.5, 0.25, 0.231455, -0.612372, 0.433013, 0.619657])",
        rotation: [
            0.619642767209,
            0.231449683751,
            -0.612357934536,
            0.433003054201,
        ],
        position: Some([1.5, -2.5, 0.25]),
    },
    Printed {
        format: Some("GLM"),
        library: None,
        text: "viewMatrix = mat4x4((0.3624310, -0.6442703, -0.6734683, 0), (0.8974228, 0.4362671, 0.0656005, 0), (0.2515476, -0.6281614, 0.7362996, 0), (0.5, -1.5, 2.25, 1))",
        rotation: [
            0.796083797838,
            -0.217867113569,
            -0.290489480701,
            0.484149118812,
        ],
        position: Some([0.5, -1.5, 2.25]),
    },
    Printed {
        format: Some("React Three Fiber"),
        library: None,
        text: "<mesh position={[0.5, -1.5, 2.25]} rotation={[1.455, -1.121, -2.552]} castShadow>",
        rotation: [
            -0.154483878356,
            0.543549813915,
            0.423599731067,
            -0.70799124215,
        ],
        position: Some([0.5, -1.5, 2.25]),
    },
    Printed {
        format: Some("three.js"),
        library: None,
        text: "camera.rotation.set(1.127, -0.89, 2.624, 'ZXY');",
        rotation: [
            0.417551263337,
            0.475171431672,
            0.372942940652,
            0.678805285798,
        ],
        position: None,
    },
    Printed {
        format: Some("MATLAB"),
        library: None,
        text: "q = eul2quat([2.65 0.90 0.24])",
        rotation: [
            0.268034686451,
            -0.392628662295,
            0.209633131162,
            0.854432028147,
        ],
        position: None,
    },
    Printed {
        format: Some("MATLAB"),
        library: None,
        text: "R = axang2rotm([0.6823 -0.2634 0.6819 1.9883])",
        rotation: [
            0.545215637831,
            0.571997717779,
            -0.220818113532,
            0.571662382755,
        ],
        position: None,
    },
    Printed {
        format: Some("MATLAB"),
        library: None,
        text: "q = quaternion([35 -34 -153],'eulerd','ZYX','frame')",
        rotation: [
            0.29840114602,
            -0.866320187476,
            -0.344714774477,
            -0.20400444378,
        ],
        position: None,
    },
    Printed {
        format: Some("MATLAB"),
        library: None,
        text: "q = quaternion([0.35 -0.34 -1.53],'euler','YZX','frame')",
        rotation: [
            0.679724898102,
            -0.693378011444,
            0.239163527144,
            -0.00134291860078,
        ],
        position: None,
    },
    Printed {
        format: Some(".NET"),
        library: None,
        text: "Quaternion.CreateFromYawPitchRoll(-0.48f, 1.06f, -3.13f)",
        rotation: [
            0.125022326863,
            0.207934295503,
            0.489846712252,
            -0.83736667299,
        ],
        position: None,
    },
    Printed {
        format: Some("OpenGL"),
        library: None,
        text: "glRotatef(67.77, -0.8910, -0.2773, -0.3595);",
        rotation: [
            0.830158273978,
            -0.496753155574,
            -0.154601178497,
            -0.200429584095,
        ],
        position: None,
    },
    Printed {
        format: Some("VTK"),
        library: None,
        text: ">>> actor.GetOrientationWXYZ()\n(165.3453, 0.358299, 0.581890, 0.730086)",
        rotation: [
            0.127538072489,
            0.35537306515,
            0.577138180347,
            0.724123984837,
        ],
        position: None,
    },
];

#[wasm_bindgen_test(unsupported = test)]
fn prints_of_graphics_are_read() {
    check(PRINTED);
}
