//! Which convention a library uses, told from what it prints: simulated libraries.

use crate::identify::{assert_among, assert_only, follow, identify};
use crate::simulated::{Noise, Simulated, every_probe, prints_the_same, random_probe};
use quatlas::{Behaviour, BehaviourAxis, ObservationReport, Probe, ProbeKind, libraries};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn all_256_behaviours_are_told_from_one_probe_of_each_kind() {
    let mut count = 0;
    for behaviour in Behaviour::all() {
        let mut library = Simulated::new(behaviour, Noise::None, count);
        let answers = every_probe()
            .iter()
            .map(|probe| library.answer(probe))
            .collect();
        assert_only(&identify(answers), behaviour);
        count += 1;
    }
    assert_eq!(count, 256);
}

/// In any order, in single precision, with q and −q, rounded to three decimals.
#[wasm_bindgen_test(unsupported = test)]
fn noise_and_signs_and_order_do_not_matter() {
    for noise in [Noise::Single, Noise::Rounded(4), Noise::Rounded(3)] {
        for (seed, behaviour) in (0..).zip(Behaviour::all()) {
            let mut library = Simulated::new(behaviour, noise, seed);
            let mut answers: Vec<Probe> = every_probe()
                .iter()
                .map(|probe| library.answer(probe))
                .collect();
            let places = answers.len();
            answers.rotate_left(usize::try_from(seed).expect("small") % places);
            assert_only(&identify(answers), behaviour);
        }
    }
}

/// Of equally good questions the first is asked: i*j, a rotated vector, a matrix; then a small turn, and
/// a quarter turn, without which its axes and its sign are not told.
#[wasm_bindgen_test(unsupported = test)]
fn the_tools_own_questions_tell_all_256_in_five() {
    for noise in [Noise::None, Noise::Rounded(2)] {
        for (seed, behaviour) in (0..).zip(Behaviour::all()) {
            let mut library = Simulated::new(behaviour, noise, seed);
            let (answers, report) = follow(&mut library, |report| report.possible == 1);
            assert_only(&report, behaviour);
            let kinds: Vec<ProbeKind> = answers.iter().map(Probe::kind).collect();
            assert_eq!(
                kinds,
                [
                    ProbeKind::Product,
                    ProbeKind::Rotate,
                    ProbeKind::Matrix,
                    ProbeKind::Perturb,
                    ProbeKind::QuarterTurn
                ]
            );
        }
    }
}

/// A record agrees with those behaviours that do all it says: of the eight choices it says five at most.
#[wasm_bindgen_test(unsupported = test)]
fn a_record_leaves_open_what_it_does_not_say() {
    for library in libraries() {
        let open = library.unestablished().len() + 3;
        let agreeing = Behaviour::all().filter(|behaviour| behaviour.is_of(library));
        assert_eq!(agreeing.count(), 1 << open, "{}", library.id);
    }
}

/// The guided path: three questions tell what the library itself does.
#[wasm_bindgen_test(unsupported = test)]
fn three_questions_tell_the_library() {
    for (seed, behaviour) in (0..).zip(Behaviour::all()) {
        let mut library = Simulated::new(behaviour, Noise::Single, seed);
        let (answers, report) = follow(&mut library, |report| {
            BehaviourAxis::ALL[..5]
                .iter()
                .all(|axis| report.settled.contains(axis))
        });
        assert_eq!(answers.len(), 3);
        assert_eq!(report.remaining.first_to_act, [behaviour.first_to_act()]);
    }
}

/// Any probes, of any numbers, in any order: what is left are the behaviours that print the same, and the
/// library is one of them.
#[wasm_bindgen_test(unsupported = test)]
fn the_truth_is_among_what_remains_after_any_probes() {
    let all: Vec<Behaviour> = Behaviour::all().collect();
    for (seed, behaviour) in (0..).zip(&all) {
        let mut library = Simulated::new(*behaviour, Noise::None, seed);
        let count = 1 + library.below(5);
        let answers: Vec<Probe> = (0..count)
            .map(|_| {
                let probe = random_probe(&mut library);
                library.answer(&probe)
            })
            .collect();
        let printing_the_same = all.iter().filter(|other| {
            let mut other = Simulated::new(**other, Noise::None, seed);
            answers
                .iter()
                .all(|answer| prints_the_same(&other.answer(answer), answer))
        });
        let report = identify(answers.clone());
        assert_among(&report, *behaviour);
        assert_eq!(report.possible, printing_the_same.count(), "{answers:#?}");
        // With the noise of single precision the truth is there as well.
        library.noise = Noise::Single;
        let answers: Vec<Probe> = answers.iter().map(|probe| library.answer(probe)).collect();
        let report = identify(answers);
        assert_among(&report, *behaviour);
        let is_told =
            |observation: &ObservationReport| matches!(observation, ObservationReport::Told(_));
        assert!(report.observations.iter().all(is_told), "{report:#?}");
    }
}

/// A file or a device has no calls to be asked about, and what has no quaternion would agree with all.
#[wasm_bindgen_test(unsupported = test)]
fn only_libraries_match() {
    let found = identify(vec![]).libraries;
    let ids: Vec<&str> = found.iter().map(|found| &*found.id).collect();
    for library in libraries() {
        let is_asked = library.kind.is_none() && library.numbers.is_none();
        assert_eq!(ids.contains(&library.id), is_asked, "{}", library.id);
    }
    assert!(ids.contains(&"airsim-quaternionr") && !ids.contains(&"carla-rotation"));
}
