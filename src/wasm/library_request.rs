//! What Translate and Identify are asked, and of what numbers are, member by member.

use crate::contract::probe::{Probe, ProbeKind};
use crate::contract::request::{
    IdentifyRequest, MatricesRequest, NumbersRequest, TranslateRequest,
};
use crate::library::endpoint::{ConventionEndpoint, Endpoint, LibraryEndpoint};
use crate::wasm::members::Members;
use crate::wasm::refusal::{Typed, no_such_choice};
use crate::wasm::request::{convention, matrix};

pub(crate) const TRANSLATE: [&str; 6] =
    ["view", "quaternion", "from", "to", "worldAxes", "bodyAxes"];
pub(crate) const IDENTIFY: [&str; 5] = ["view", "observations", "name", "language", "unavailable"];

pub(crate) const MATRICES: [&str; 8] = [
    "view",
    "yawed",
    "a",
    "b",
    "product",
    "matrix",
    "rotationVector",
    "printed",
];
pub(crate) const NUMBERS: [&str; 5] = ["view", "numbers", "quaternion", "convention", "matrix"];

pub(crate) fn numbers_request(request: &Members<'_>) -> Typed<NumbersRequest> {
    request.only(&NUMBERS)?;
    Ok(NumbersRequest {
        numbers: request.text("numbers")?,
        quaternion: request.text_or_empty("quaternion")?,
        convention: convention(&request.object("convention")?)?,
        matrix: matrix(request)?,
    })
}

pub(crate) fn translate_request(request: &Members<'_>) -> Typed<TranslateRequest> {
    request.only(&TRANSLATE)?;
    Ok(TranslateRequest {
        quaternion: request.text("quaternion")?,
        from: endpoint(&request.object("from")?)?,
        to: endpoint(&request.object("to")?)?,
        world_axes: request.name_or_empty("worldAxes")?,
        body_axes: request.name_or_empty("bodyAxes")?,
    })
}

fn endpoint(members: &Members<'_>) -> Typed<Endpoint> {
    const LIBRARY: [&str; 4] = ["kind", "id", "order", "direction"];
    const CONVENTION: [&str; 2] = ["kind", "convention"];
    // Of both kinds, so that a misspelt kind is told before it is missed.
    members.only(&[&LIBRARY[..], &CONVENTION].concat())?;
    match &*members.word("kind")? {
        "library" => {
            members.only(&LIBRARY)?;
            Ok(Endpoint::Library(LibraryEndpoint {
                id: members.name("id")?,
                order: members.named_if_any("order")?,
                direction: members.named_if_any("direction")?,
            }))
        }
        "convention" => {
            members.only(&CONVENTION)?;
            let convention = convention(&members.object("convention")?)?;
            Ok(Endpoint::Convention(ConventionEndpoint { convention }))
        }
        other => Err(no_such_choice(
            &members.path_to("kind"),
            other,
            &["library", "convention"],
        )),
    }
}

pub(crate) fn identify_request(request: &Members<'_>) -> Typed<IdentifyRequest> {
    request.only(&IDENTIFY)?;
    Ok(IdentifyRequest {
        observations: request.list_of_objects("observations", probe)?,
        name: request.name_or_empty("name")?,
        language: request.named_or_default("language")?,
        unavailable: request.list_of_named("unavailable")?,
    })
}

pub(crate) fn matrices_request(request: &Members<'_>) -> Typed<MatricesRequest> {
    request.only(&MATRICES)?;
    let mut texts: [String; 7] = Default::default();
    for (text, name) in texts.iter_mut().zip(&MATRICES[1..]) {
        *text = request.text_or_empty(name)?;
    }
    let [yawed, a, b, product, matrix, rotation_vector, printed] = texts;
    Ok(MatricesRequest {
        yawed,
        a,
        b,
        product,
        matrix,
        rotation_vector,
        printed,
    })
}

fn probe(members: &Members<'_>) -> Typed<Probe> {
    const PROBE: [&str; 9] = [
        "probe",
        "printed",
        "quaternion",
        "a",
        "b",
        "vector",
        "matrix",
        "layout",
        "rotationVector",
    ];
    // Of all kinds, so that a misspelt `probe` is told before it is missed.
    members.only(&PROBE)?;
    let kind: ProbeKind = members.named("probe")?;
    let (inputs, has_layout): (&[&str], bool) = match kind {
        ProbeKind::Components => (&["quaternion"], false),
        ProbeKind::Product => (&["a", "b"], false),
        ProbeKind::Rotate => (&["quaternion", "vector"], false),
        ProbeKind::Matrix => (&["quaternion"], true),
        ProbeKind::FromMatrix => (&["matrix"], true),
        ProbeKind::QuarterTurn => (&[], false),
        ProbeKind::Perturb => (&["quaternion", "rotationVector"], false),
    };
    let layout: &[&str] = if has_layout { &["layout"] } else { &[] };
    members.only(&[&["probe", "printed"], inputs, layout].concat())?;
    let text = |name| members.text(name);
    let printed = text("printed")?;
    Ok(match kind {
        ProbeKind::Components => Probe::Components {
            quaternion: text("quaternion")?,
            printed,
        },
        ProbeKind::Product => Probe::Product {
            a: text("a")?,
            b: text("b")?,
            printed,
        },
        ProbeKind::Rotate => Probe::Rotate {
            quaternion: text("quaternion")?,
            vector: text("vector")?,
            printed,
        },
        ProbeKind::Matrix => Probe::Matrix {
            quaternion: text("quaternion")?,
            printed,
            layout: members.named_or_default("layout")?,
        },
        ProbeKind::FromMatrix => Probe::FromMatrix {
            matrix: text("matrix")?,
            layout: members.named_or_default("layout")?,
            printed,
        },
        ProbeKind::QuarterTurn => Probe::QuarterTurn { printed },
        ProbeKind::Perturb => Probe::Perturb {
            quaternion: text("quaternion")?,
            rotation_vector: text("rotationVector")?,
            printed,
        },
    })
}
