//! What programs print, format by format: a text of each with three different angles, whose rotation was
//! computed from the printed numbers with `NumPy` and `SciPy`.

use crate::asked::read_request;
use quatlas::{Convention, Fact, Outcome, Request, analyze};
use serde_json::json;

mod autopilots;
mod cameras;
mod devices;
mod engines;
mod files;
mod graphics;
mod left_open;
mod plain;
mod robots;
mod ros;
mod scenes;
mod space;

/// What a program prints, and what it is.
pub(crate) struct Printed {
    /// What is told of the format.
    pub(crate) format: Option<&'static str>,
    /// The library that is declared; without one it is a quaternion w, x, y, z, Hamilton.
    pub(crate) library: Option<&'static str>,
    pub(crate) text: &'static str,
    /// w, x, y, z, body to world, up to the sign.
    pub(crate) rotation: [f64; 4],
    /// The three numbers beside the rotation.
    pub(crate) position: Option<[f64; 3]>,
}

/// The expected numbers have twelve digits.
const TOLERANCE: f64 = 1e-9;

#[track_caller]
pub(crate) fn check(all: &[Printed]) {
    for printed in all {
        let text = printed.text;
        let (read, facts) = read(printed);
        let norm = read.iter().map(|part| part * part).sum::<f64>().sqrt();
        let off = |sign: f64| {
            let parts = read.iter().zip(printed.rotation);
            parts
                .map(|(own, expected)| (own / norm - sign * expected).abs())
                .fold(0.0, f64::max)
        };
        assert!(off(1.0).min(off(-1.0)) < TOLERANCE, "{text}: {read:?}");
        let found = facts.iter().find_map(|fact| match fact {
            Fact::FoundInText(found) => Some(found),
            _ => None,
        });
        let format = found.and_then(|found| found.format.as_deref());
        if printed.format.is_some() {
            assert_eq!(format, printed.format, "{text}");
        }
        if let Some(position) = printed.position {
            let beside = found.map(|found| &found.beside[..]).unwrap_or_default();
            assert!(
                beside.iter().any(|beside| beside.numbers == position),
                "{text}: {beside:?}"
            );
        }
    }
}

fn read(printed: &Printed) -> ([f64; 4], Vec<Fact>) {
    let text = printed.text;
    let request: Request = match printed.library {
        None => read_request(text, "1 0 0", Convention::HAMILTON),
        Some(library) => {
            let hamilton = serde_json::to_value(Convention::HAMILTON).expect("JSON");
            serde_json::from_value(json!({
                "view": "translate",
                "quaternion": text,
                "from": {"kind": "library", "id": library},
                "to": {"kind": "convention", "convention": hamilton},
            }))
            .expect("a request")
        }
    };
    let (unit, notes) = match analyze(&request) {
        Outcome::Read(report) => (report.hamilton.unit, report.notes),
        Outcome::Translate(report) => (report.to.components, report.notes),
        other => panic!("{text:?} has no report: {other:?}"),
    };
    let facts = notes.into_iter().map(|note| note.fact).collect();
    ([unit.w, unit.x, unit.y, unit.z], facts)
}
