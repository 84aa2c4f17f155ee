//! Which of the observations are named where they do not agree, and about what.

use crate::identify::identify;
use quatlas::{BehaviourAxis, Probe};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn the_pair_that_contradicts_is_named() {
    let product = |printed: &str| Probe::Product {
        a: "0 1 0 0".to_owned(),
        b: "0 0 1 0".to_owned(),
        printed: printed.to_owned(),
    };
    let rotate = Probe::Rotate {
        quaternion: "0.5 0.5 0.5 0.5".to_owned(),
        vector: "1 2 3".to_owned(),
        printed: "3 1 2".to_owned(),
    };
    let report = identify(vec![product("0 0 0 1"), rotate, product("0 0 0 -1")]);
    let contradiction = report.contradiction.expect("they contradict");
    assert_eq!(contradiction.observations, [0, 2]);
    assert_eq!(contradiction.about, [BehaviourAxis::Handedness]);
    assert_eq!((report.possible, report.next), (0, None));
    assert!(report.libraries.is_empty());
    assert!(report.sentence.contains("contradict"));
}

/// Three that agree two by two and not all together.
#[wasm_bindgen_test(unsupported = test)]
fn three_that_contradict_only_together() {
    let components = |printed: &str| Probe::Components {
        quaternion: "0.1 0.5 0.5 0.7".to_owned(),
        printed: printed.to_owned(),
    };
    // The orders of constructor and array are the same ...
    let same = components("0.1 0.5 0.5 0.7");
    // ... the constructor takes the scalar first ...
    let first = Probe::Components {
        quaternion: "0.1 0.5 0.5 0.7".to_owned(),
        printed: "w: 0.1, x: 0.5, y: 0.5, z: 0.7".to_owned(),
    };
    // ... and the array has it last.
    let last = Probe::Components {
        quaternion: "w: 0.1, x: 0.5, y: 0.5, z: 0.7".to_owned(),
        printed: "0.5 0.5 0.7 0.1".to_owned(),
    };
    let pairs = [[&same, &first], [&same, &last], [&first, &last]];
    for pair in pairs {
        assert!(
            identify(pair.map(Clone::clone).to_vec())
                .contradiction
                .is_none()
        );
    }
    let together = [same, first, last];
    let report = identify(together.to_vec());
    assert_eq!(
        report.contradiction.expect("together").observations,
        [0, 1, 2]
    );
    // What has no part in it is not named, wherever it stands.
    let bystander = Probe::QuarterTurn {
        printed: "w: 1, x: 0, y: 0, z: 1".to_owned(),
    };
    for at in 0..=together.len() {
        let mut observations = together.to_vec();
        observations.insert(at, bystander.clone());
        let named: Vec<usize> = (0..4).filter(|&place| place != at).collect();
        let contradiction = identify(observations).contradiction.expect("together");
        assert_eq!(contradiction.observations, named);
    }
}

/// Of observations that do not agree a pair is named where one exists, though others need three.
#[wasm_bindgen_test(unsupported = test)]
fn a_pair_that_contradicts_is_named_before_three() {
    let components = |quaternion: &str, printed: &str| Probe::Components {
        quaternion: quaternion.to_owned(),
        printed: printed.to_owned(),
    };
    let product = |printed: &str| Probe::Product {
        a: "i".to_owned(),
        b: "j".to_owned(),
        printed: printed.to_owned(),
    };
    let (plain, with_names) = ("0.1 0.5 0.5 0.7", "w: 0.1, x: 0.5, y: 0.5, z: 0.7");
    let report = identify(vec![
        product("k"),
        product("-k"),
        // The same order in and out, the scalar first in, the scalar last out.
        components(plain, plain),
        components(plain, with_names),
        components(with_names, "0.5 0.5 0.7 0.1"),
    ]);
    let contradiction = report.contradiction.expect("they contradict");
    assert_eq!(contradiction.observations, [0, 1]);
    assert_eq!(contradiction.about, [BehaviourAxis::Handedness]);
}
