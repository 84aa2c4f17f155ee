//! Inertial sensors, motion capture and navigation.

use crate::formats::{Printed, check};
use wasm_bindgen_test::wasm_bindgen_test;

const PRINTED: &[Printed] = &[
    Printed {
        format: Some("VectorNav"),
        library: None,
        text: "$VNQTN,-0.795950,0.317997,-0.490317,-0.157893*5A",
        rotation: [
            -0.15789304307,
            -0.795950217117,
            0.317997086742,
            -0.490317133747,
        ],
        position: None,
    },
    Printed {
        format: Some("VectorNav"),
        library: None,
        text: "$VNYPR,125.963,10.872,-119.106*5A",
        rotation: [
            0.156409719444,
            -0.432637310613,
            -0.742746901789,
            0.486505906451,
        ],
        position: None,
    },
    Printed {
        format: Some("ART DTrack"),
        library: None,
        text: "6d 1 [0 1.000][-2.945 1.619 -2.584 10.1 20.2 30.3][-0.858389 -0.454491 -0.237921 -0.024794 0.499997 -0.865672 0.512399 -0.737185 -0.440460]",
        rotation: [
            0.224247236279,
            -0.14324310322,
            0.836487651818,
            -0.479043838032,
        ],
        position: Some([-2.945, 1.619, -2.584]),
    },
    Printed {
        format: Some("Xsens"),
        library: None,
        text: "PacketCounter: 1024\nQuaternion: 0.205193 -0.713710 0.502755 0.442438",
        rotation: [
            0.205192989205,
            -0.713709962452,
            0.502754973551,
            0.442437976724,
        ],
        position: None,
    },
    Printed {
        format: None,
        library: None,
        text: "$PASHR,144012.251,34.64,T,44.13,-49.02,+0.01,0.029,0.029,0.059,1,1*0C",
        rotation: [
            0.758616046621,
            0.440767763807,
            -0.265275849063,
            0.399817703587,
        ],
        position: None,
    },
    Printed {
        format: None,
        library: None,
        text: "$PSAT,HPR,144012.25,-111.72,-46.24,175.47,N*25",
        rotation: [
            0.345135664667,
            0.502895178389,
            -0.769308585764,
            0.190110789797,
        ],
        position: None,
    },
    Printed {
        format: Some("Android sensors"),
        library: None,
        text: "SensorManager.getOrientation -> azimuth=2.996645, pitch=-0.533504, roll=-2.590153",
        rotation: [
            -0.233961800144,
            -0.920564570878,
            -0.138785060758,
            -0.280288162127,
        ],
        position: None,
    },
    Printed {
        format: Some("Android sensors"),
        library: None,
        text: "TYPE_ROTATION_VECTOR values=[0.751805, 0.263002, -0.591128, 0.127228, 0.0523]",
        rotation: [
            0.127227994504,
            0.751804967523,
            0.263001988639,
            -0.591127974464,
        ],
        position: None,
    },
    Printed {
        format: None,
        library: Some("dji"),
        text: "quaternion: [0.545918, 0.372456, 0.729608, 0.175845], ts: 7",
        rotation: [
            0.545918209537,
            0.372456142958,
            0.729608280042,
            0.175845067494,
        ],
        position: None,
    },
    Printed {
        format: Some("Xsens"),
        library: None,
        text: "PacketCounter,SampleTimeFine,Euler_X,Euler_Y,Euler_Z\n1,3120774,-172.9655,-36.5637,-133.2355",
        rotation: [
            -0.264269948897,
            -0.393786280776,
            0.862268463486,
            -0.177726914284,
        ],
        position: None,
    },
];

#[wasm_bindgen_test(unsupported = test)]
fn prints_of_devices_are_read() {
    check(PRINTED);
}
