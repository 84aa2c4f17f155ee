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
    Printed {
        format: Some("Unreal"),
        library: None,
        text: "P=12.500000 Y=-71.250000 R=33.000000",
        rotation: [
            0.756730979887,
            -0.290289953896,
            0.0796013773745,
            -0.580304736726,
        ],
        position: None,
    },
    Printed {
        format: Some("Godot"),
        library: None,
        text: "[node name=\"Arm\" type=\"Node3D\"]\nrotation = Quaternion(0.231455, -0.612372, 0.433013, 0.619657)\nposition = Vector3(0.5, 1.5, -2)",
        rotation: [
            0.619642767209,
            0.231449683751,
            -0.612357934536,
            0.433003054201,
        ],
        position: Some([0.5, 1.5, -2.0]),
    },
    Printed {
        format: Some("LSL"),
        library: None,
        text: "[14:02] Object: llGetRot() = <0.231455, -0.612372, 0.433013, 0.619657>",
        rotation: [
            0.619642767209,
            0.231449683751,
            -0.612357934536,
            0.433003054201,
        ],
        position: None,
    },
    Printed {
        format: Some("Blender"),
        library: None,
        text: ">>> C.object.rotation_axis_angle[:]\n(1.3, 0.36, 0.48, -0.8)",
        rotation: [
            0.796083798549,
            0.217867106065,
            0.290489474753,
            -0.484149124589,
        ],
        position: None,
    },
    Printed {
        format: None,
        library: None,
        text: "const FQuat Rot = FQuat(0.231455, -0.612372, 0.433013, 0.619657);",
        rotation: [
            0.619642767209,
            0.231449683751,
            -0.612357934536,
            0.433003054201,
        ],
        position: None,
    },
    Printed {
        format: Some("Unreal"),
        library: None,
        text: "SetActorRotation(FRotator(-27.2f, 114.5f, 43.6f));",
        rotation: [
            0.41476042707,
            -0.378888252893,
            -0.185468424536,
            0.806237522977,
        ],
        position: None,
    },
    Printed {
        format: Some("Unity"),
        library: None,
        text: "Quaternion.AngleAxis(139.78f, new Vector3(0.3378f, 0.4335f, -0.8354f))",
        rotation: [
            0.343823592217,
            0.317217787156,
            0.407086769486,
            -0.784498932476,
        ],
        position: None,
    },
    Printed {
        format: Some("Godot"),
        library: None,
        text: "basis = Basis.from_euler(Vector3(-0.476, 1.329, -1.05))",
        rotation: [
            0.734871373558,
            -0.460968766161,
            0.425550620052,
            -0.257640312687,
        ],
        position: None,
    },
    Printed {
        format: Some("libGDX"),
        library: None,
        text: "rotation: [0.231455|-0.612372|0.433013|0.619657]",
        rotation: [
            0.619642767209,
            0.231449683751,
            -0.612357934536,
            0.433003054201,
        ],
        position: None,
    },
    Printed {
        format: Some("Unity"),
        library: None,
        text: "Instantiate(prefab, new Vector3(0.5f, -1.5f, 2.25f), Quaternion.Euler(new Vector3(12.5f, -71.25f, 33f)));",
        rotation: [
            0.756730979887,
            -0.0796013773745,
            -0.580304736726,
            0.290289953896,
        ],
        position: None,
    },
];

#[wasm_bindgen_test(unsupported = test)]
fn prints_of_engines_are_read() {
    check(PRINTED);
}
