//! Which convention a library uses, from what it printed.
//!
//! Every observation is compared with what each of the 256 behaviours prints; those remain that agree
//! with all observations. The next probe is the one whose answer leaves the fewest, on average.

// Which convention a library of matrices uses.
pub(crate) mod matrix_library;

// Observations that do not agree.
mod disagreement;

// A probe as code.
mod probe_code;

// What a library is asked, and what it may answer.
mod prediction;

// A probe in texts to numbers.
pub(crate) mod observation;

/// What a library means by three angles, by a matrix and by a small turn.
pub mod recognition;

// What is settled, in words.
mod sentence;

use crate::analyze::identify::disagreement::{Agreeing, agreeing, contradiction};
use crate::analyze::identify::observation::{printed, question, rounding};
use crate::analyze::identify::prediction::{Printed, Question};
use crate::analyze::identify::probe_code::code;
use crate::analyze::identify::sentence::sentence;
use crate::contract::probe::{MatrixLayout, Probe};
use crate::contract::request::IdentifyRequest;
use crate::contract::{
    IdentifyReport, Labels, LibraryMatch, NextProbe, ObservationProblem, ObservationReport, Told,
    Unexplained, remaining,
};
use crate::convention::{Direction, Function};
use crate::library::behaviour::Behaviour;
use crate::library::{Language, essentials};
use crate::problem::is_too_long;

/// Noise of single precision, after a few operations on numbers of size 1.
const SINGLE_PRECISION: f64 = 1e-5;

/// What is farther from every behaviour than this is a mistake, unless the numbers are rounded: a
/// small turn to first order is up to this far from the exact one.
const FIRST_ORDER: f64 = 2e-3;

/// Of numbers with one decimal or none: how far the right ones may be off, and how far wrong ones are
/// still believed to be rounded.
const COARSEST: f64 = 0.05;
const COARSEST_BELIEVED: f64 = 0.1;

/// A behaviour that is this many times farther away than the nearest is not the one.
const CLEARLY_FARTHER: f64 = 3.0;

/// Four or nine rounded numbers of norm 1 or √3 are together this many roundings off, and more where
/// those that went in are rounded too.
const ROUNDINGS: f64 = 2.0;
const MOST_ROUNDINGS: f64 = 4.0;

/// What can be said of a library, whatever was entered.
pub(crate) fn identify(request: &IdentifyRequest) -> IdentifyReport {
    let mut read = Vec::new();
    let mut codes = Vec::new();
    for probe in &request.observations {
        read.push(Read::of(probe, request.language));
        codes.push(code(probe, request.language));
    }
    let mut told: Vec<(usize, &Agreeing)> = Vec::new();
    for (at, read) in read.iter().enumerate() {
        if let Some(agreeing) = &read.agreeing {
            told.push((at, agreeing));
        }
    }
    let possible = agreeing(&told);
    let left = remaining(&possible);
    // A kind that was told already is asked again only where no other can tell more, and the very same
    // question never.
    let was_told = |is_same: &dyn Fn(&Probe) -> bool| {
        told.iter()
            .any(|(at, _)| is_same(&request.observations[*at]))
    };
    let next = next_probe(request, &possible, &|probe| {
        was_told(&|other| other.kind() == probe.kind())
    })
    .or_else(|| {
        next_probe(request, &possible, &|probe| {
            was_told(&|other| other.asks_the_same(probe))
        })
    });
    let contradiction = contradiction(&told);
    let mut reports = Vec::new();
    for read in read {
        reports.push(read.report);
    }
    IdentifyReport {
        next,
        codes,
        possible: possible.len(),
        settled: left.settled(),
        labels: labels(&left.direction),
        libraries: matches(&possible),
        contradiction,
        sentence: sentence(&request.name, &left),
        family: left.family(),
        remaining: left,
        observations: reports,
    }
}

/// An observation, and the behaviours that agree with it.
struct Read {
    report: ObservationReport,
    /// Absent where it tells nothing: not made yet, or not understood.
    agreeing: Option<Agreeing>,
}

impl Read {
    fn of(probe: &Probe, language: Language) -> Self {
        let nothing = |report| Self {
            report,
            agreeing: None,
        };
        if !is_too_long(probe.printed()) && probe.printed().trim().is_empty() {
            return nothing(ObservationReport::Empty);
        }
        let both = question(probe, language).and_then(|asked| Ok((asked, printed(probe)?)));
        match both {
            Ok((question, printed)) => Self::of_observation(&question, &printed, rounding(probe)),
            Err(problem) => nothing(ObservationReport::Problem(ObservationProblem { problem })),
        }
    }

    fn of_observation(question: &Question, printed: &Printed, rounding: f64) -> Self {
        let mut known = [None; Behaviour::COUNT];
        let mut distances = Vec::new();
        let mut nearest = f64::INFINITY;
        for behaviour in Behaviour::all() {
            let key = question.key(&behaviour);
            let distance = known[key].unwrap_or_else(|| {
                let mut least = f64::INFINITY;
                for answer in question.answers(&behaviour) {
                    least = least.min(answer.distance(printed, behaviour.array));
                }
                least
            });
            known[key] = Some(distance);
            nearest = nearest.min(distance);
            distances.push(distance);
        }
        let believed = (MOST_ROUNDINGS * rounding).min(COARSEST_BELIEVED);
        let rounding = (ROUNDINGS * rounding).min(COARSEST);
        if nearest > FIRST_ORDER.max(believed) {
            let distance = nearest.is_finite().then_some(nearest);
            return Self {
                report: ObservationReport::Unexplained(Unexplained { distance }),
                agreeing: None,
            };
        }
        let near = SINGLE_PRECISION
            .max(rounding)
            .max(CLEARLY_FARTHER * nearest);
        let mut agreeing = Agreeing(Vec::new());
        for distance in distances {
            agreeing.0.push(distance <= near);
        }
        let possible = agreeing.behaviours();
        Self {
            report: ObservationReport::Told(Told {
                possible: possible.len(),
                settles: remaining(&possible).settled(),
                distance: nearest,
            }),
            agreeing: Some(agreeing),
        }
    }
}

/// What no numbers tell apart: each direction of the call that rotates has two names.
fn labels(directions: &[Direction]) -> Vec<Labels> {
    let mut labels = Vec::new();
    for &direction in directions {
        labels.push(Labels {
            function: Function::Passive,
            direction,
        });
        labels.push(Labels {
            function: Function::Active,
            direction: direction.reversed(),
        });
    }
    labels
}

/// The records of libraries that agree, those that say most first. Formats and devices have no calls, and
/// what has no quaternion agrees with everything.
fn matches(possible: &[Behaviour]) -> Vec<LibraryMatch> {
    let mut found: Vec<LibraryMatch> = Vec::new();
    for library in essentials() {
        let has_calls = library.kind.is_none() && library.numbers.is_none();
        let agrees = |behaviour: &Behaviour| behaviour.agrees_with(library);
        if has_calls && possible.iter().any(agrees) {
            let unestablished = library.unestablished();
            // A sort would add 2 kB to the wasm.
            let says_more = |other: &LibraryMatch| other.unestablished.len() <= unestablished.len();
            let place = found.partition_point(says_more);
            found.insert(
                place,
                LibraryMatch {
                    id: library.id.to_owned(),
                    unestablished,
                },
            );
        }
    }
    found
}

/// The probes that may be proposed; of equally good ones the first is.
///
/// Their numbers are easy to type and to read. The quaternion (½, ½, ½, ½) is the same in both orders;
/// it turns by 120° about (1, 1, 1), so it moves every axis onto another one.
#[must_use]
pub fn standard_probes() -> [Probe; 7] {
    let text = str::to_owned;
    let printed = String::new;
    [
        Probe::Product {
            a: text("0 1 0 0"),
            b: text("0 0 1 0"),
            printed: printed(),
        },
        Probe::Rotate {
            quaternion: text("0.5 0.5 0.5 0.5"),
            vector: text("1 2 3"),
            printed: printed(),
        },
        Probe::Matrix {
            quaternion: text("0.5 0.5 0.5 0.5"),
            printed: printed(),
            layout: MatrixLayout::AsWritten,
        },
        Probe::FromMatrix {
            matrix: text("0 0 1; 1 0 0; 0 1 0"),
            layout: MatrixLayout::AsWritten,
            printed: printed(),
        },
        Probe::Components {
            quaternion: text("0.1 0.5 0.5 0.7"),
            printed: printed(),
        },
        Probe::QuarterTurn { printed: printed() },
        Probe::Perturb {
            quaternion: text("0.5 0.5 0.5 0.5"),
            rotation_vector: text("0.1 0 0"),
            printed: printed(),
        },
    ]
}

/// The best of the standard probes, but for those that are left out.
fn next_probe(
    request: &IdentifyRequest,
    possible: &[Behaviour],
    is_left_out: &dyn Fn(&Probe) -> bool,
) -> Option<NextProbe> {
    let mut best: Option<((f64, f64), Probe, usize)> = None;
    for probe in standard_probes() {
        if request.unavailable.contains(&probe.kind()) || is_left_out(&probe) {
            continue;
        }
        let Ok(question) = question(&probe, request.language) else {
            continue;
        };
        let answers = question.groups(possible);
        if answers.len() < 2 {
            continue;
        }
        // First what the library itself does, then how its user means the attitude.
        let (mut of_library, mut of_all) = (0, 0);
        for left in &answers {
            let mut distinct = [false; Behaviour::COUNT];
            for behaviour in left {
                let is_there = &mut distinct[behaviour.of_library()];
                of_library += if *is_there { 0 } else { left.len() };
                *is_there = true;
            }
            of_all += left.len() * left.len();
        }
        let count = possible.len() as f64;
        let leaves = (of_library as f64 / count, of_all as f64 / count);
        let is_better = best.as_ref().is_none_or(|(least, _, _)| leaves < *least);
        if is_better {
            best = Some((leaves, probe, answers.len()));
        }
    }
    let ((_, leaves), probe, answers) = best?;
    Some(NextProbe {
        code: code(&probe, request.language).unwrap_or_default(),
        language: request.language,
        probe,
        answers,
        leaves,
    })
}
