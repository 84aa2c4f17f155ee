//! Whatever is pasted is answered: the texts of the other tests, changed in a few places, in every view.

use crate::asked::read_request;
use crate::properties::answered::{check, probes};
use crate::properties::corpus::{changed, corpus};
use crate::properties::each::{for_all_of_each, sample};
use crate::support::all_conventions;
use proptest::prelude::*;
use quatlas::{
    ComposeRequest, Convention, Endpoint, IdentifyRequest, Request, TranslateRequest, libraries,
};

fn conventions() -> impl Strategy<Value = Convention> {
    prop::sample::select(all_conventions())
}

fn ends() -> impl Strategy<Value = Endpoint> {
    let ids: Vec<&str> = libraries().iter().map(|library| library.id).collect();
    prop_oneof![
        3 => prop::sample::select(ids).prop_map(Endpoint::library),
        1 => conventions().prop_map(Endpoint::convention),
    ]
}

#[test]
fn a_changed_text_is_read_or_has_a_problem_with_a_place() {
    for_all_of_each(
        &corpus(),
        2,
        |text| (changed(text), changed(text), conventions()),
        |(quaternion, vector, convention)| check(&read_request(&quaternion, &vector, convention)),
    );
}

#[test]
fn a_changed_text_is_composed_or_has_a_problem_with_a_place() {
    for_all_of_each(
        &corpus(),
        1,
        |text| (changed(text), conventions()),
        |(text, convention)| {
            check(&Request::Compose(ComposeRequest::new(
                &text, "0 0 1 2", "1 2 3", convention,
            )))?;
            check(&Request::Compose(ComposeRequest::new(
                "1e200 0 1 2",
                &text,
                &text,
                convention,
            )))
        },
    );
}

#[test]
fn a_changed_text_is_translated_or_has_a_problem_with_a_place() {
    let axes = [
        "",
        "NED to ENU",
        "y x -z",
        "x -y -z",
        "FRD to",
        "x x y",
        "🙂",
        "-z  to -y",
    ];
    for_all_of_each(
        &corpus(),
        1,
        move |text| {
            let axes = prop::sample::select(axes.to_vec());
            (changed(text), ends(), ends(), axes.clone(), axes)
        },
        |(text, from, to, world_axes, body_axes)| {
            check(&Request::Translate(TranslateRequest {
                world_axes: world_axes.to_owned(),
                body_axes: body_axes.to_owned(),
                ..TranslateRequest::new(&text, from, to)
            }))
        },
    );
}

/// Of a few texts: seven kinds of each take their time.
#[test]
fn a_changed_text_is_an_observation_or_has_a_problem_with_a_place() {
    for_all_of_each(
        &sample(corpus(), 32),
        1,
        |text| (changed(text), changed(text)),
        |(one, other)| {
            for texts in [
                [&one[..], "1 2 3", "1 0 0 0"],
                ["0 0.6 0 0.8", &one, &other],
            ] {
                check(&Request::Identify(IdentifyRequest::new(probes(texts))))?;
            }
            Ok(())
        },
    );
}
