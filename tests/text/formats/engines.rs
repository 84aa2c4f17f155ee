//! Game engines, scenes and modelling programs.

use crate::formats::{Printed, check};
use wasm_bindgen_test::wasm_bindgen_test;

const PRINTED: &[Printed] = &[
    Printed {
        format: Some("CARLA"),
        library: None,
        text: "Transform(Location(x=-0.131, y=-1.070, z=0.495), Rotation(pitch=15.8641, yaw=-85.4618, roll=145.3561))",
        rotation: [
            0.127219625261,
            -0.722405865531,
            0.61140255865,
            -0.296870078773,
        ],
        position: Some([-0.131, -1.07, 0.495]),
    },
    Printed {
        format: Some("Unreal"),
        library: None,
        text: "LogTemp: ActorRotation P=69.3058 Y=134.0595 R=-99.5486",
        rotation: [
            -0.192389847053,
            0.583193779355,
            0.434965627706,
            0.658540860681,
        ],
        position: None,
    },
    Printed {
        format: Some("Unreal"),
        library: None,
        text: "LogTemp: Spawn = -216.400,90.000,171.800|-41.5770,-115.4068,21.3710|1.0,1.0,1.0",
        rotation: [
            0.54648314392,
            0.202189246374,
            0.332874680626,
            -0.741397416411,
        ],
        position: Some([-216.4, 90.0, 171.8]),
    },
    Printed {
        format: Some("Godot"),
        library: None,
        text: "transform = Transform3D(-0.7119654, -0.1025952, 0.6946794, 0.3817704, -0.8868474, 0.2602941, 0.5893697, 0.4505285, 0.6705725, 2.759, 0.741, 2.026)",
        rotation: [
            0.133939993418,
            0.355073767505,
            0.196561378229,
            0.90407207809,
        ],
        position: Some([2.759, 0.741, 2.026]),
    },
    Printed {
        format: Some("Godot"),
        library: None,
        text: "rotation_degrees = Vector3(-9.7392, 49.7960, -37.3124)",
        rotation: [
            0.867727668016,
            -0.207141159523,
            0.372811748288,
            -0.255250141095,
        ],
        position: None,
    },
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
        format: Some("Blender"),
        library: None,
        text: "<Euler (x=-2.109319, y=0.720447, z=-0.663134), order='XZY'>",
        rotation: [
            0.336898288343,
            -0.826208181721,
            0.429432515514,
            0.139525260752,
        ],
        position: None,
    },
    Printed {
        format: Some("Blender"),
        library: None,
        text: "Euler((-1.571181, 0.487862, -1.770666), 'ZYX')",
        rotation: [
            0.30205566681,
            -0.566632861296,
            -0.423198651392,
            -0.639212387323,
        ],
        position: None,
    },
    Printed {
        format: Some("Blender"),
        library: None,
        text: "(Vector((-0.726019, -0.571247, 0.382849)), 2.501990)",
        rotation: [
            0.314377966766,
            -0.689208281017,
            -0.542283553056,
            0.363437735347,
        ],
        position: None,
    },
    Printed {
        format: Some("Unity"),
        library: None,
        text: "turret.localRotation = Quaternion.Euler(-57.1087f, 52.0140f, 30.2100f);",
        rotation: [
            0.707529855111,
            -0.314383811212,
            0.483785656374,
            0.408063428967,
        ],
        position: None,
    },
    Printed {
        format: Some("Unity"),
        library: Some("unity"),
        text: "transform.eulerAngles = (-70.1187, -11.5831, -121.8922)",
        rotation: [
            0.344817939312,
            -0.205329050724,
            -0.53969114381,
            -0.740050024627,
        ],
        position: None,
    },
    Printed {
        format: Some("Qt"),
        library: None,
        text: "auto q = QQuaternion::fromEulerAngles(-20.2831f, 35.9938f, 123.4694f);",
        rotation: [
            0.395432351514,
            0.188569918507,
            0.291523818163,
            0.850346108743,
        ],
        position: None,
    },
    Printed {
        format: Some("Bullet"),
        library: None,
        text: "btQuaternion rot(0.575361, 0.093868, 1.776178);",
        rotation: [
            0.614630797944,
            0.248276744835,
            0.143900938745,
            0.734765377533,
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
        format: Some("Panda3D"),
        library: None,
        text: "node.getHpr() LVecBase3f(-104.2646, -8.5619, -146.0689)",
        rotation: [
            0.234980984668,
            -0.766338440682,
            -0.568292879787,
            -0.185883119088,
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
        format: Some("OpenXR"),
        library: None,
        text: "XrPosef pose = {{0.627280f, -0.129721f, 0.208486f, 0.739071f}, {-2.420f, -0.079f, 0.319f}};",
        rotation: [
            0.739070966196,
            0.627279971309,
            -0.129720994067,
            0.208485990464,
        ],
        position: Some([-2.42, -0.079, 0.319]),
    },
];

#[wasm_bindgen_test(unsupported = test)]
fn prints_of_engines_are_read() {
    check(PRINTED);
}
