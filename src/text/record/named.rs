//! Single numbers by name, those together that stand together.

use crate::convention::angle::AngleUnit;
use crate::text::record::names::{name_and_stem, words_of};
use crate::text::record::quantity::{Group, Named, NamedNumber, is_named, own_key};
use crate::text::vocabulary::is_listed;

/// The single numbers by name, those together that stand together.
pub(crate) fn named<'t>(groups: &[Group<'t>]) -> Vec<Named<'t>> {
    let mut found: Vec<Named<'t>> = Vec::new();
    for group in groups {
        if group.numbers.len() != 1 || !is_named(group) {
            continue;
        }
        let (name, stem) = name_and_stem(own_key(group));
        let member = NamedNumber {
            name,
            value: group.numbers[0],
            span: group.span,
            is_computed: group.is_computed || group.is_of_unknown_call,
            has_length: group.has_lengths,
            // `roll_deg=10`
            unit: group.unit.or_else(|| {
                let words = words_of(own_key(group));
                words.last().and_then(|last| AngleUnit::named(last))
            }),
        };
        let path = &group.path[..group.path.len() - 1];
        // Of several that are told in turn, `DesRoll: 1, Roll: 2, DesPitch: …`, that with the same stem.
        let near = found.len().saturating_sub(NEAR);
        let last = found.len().saturating_sub(1);
        let own = (near..found.len()).rev().find(|&at| {
            (found[at].scope == group.scope
                || is_entry(&member.name) && is_entry(&found[at].members[0].name))
                && belongs(&found[at], &stem, &member, at == last)
        });
        if let Some(at) = own {
            found[at].others_have_stem |= !stem.is_empty();
            found[at].members.push(member);
        } else {
            found.push(Named {
                path: path.to_vec(),
                stem,
                members: vec![member],
                scope: group.scope,
                others_have_stem: false,
                remark: "",
            });
        }
    }
    found
}

/// How many names a name may stand behind those that it belongs to.
const NEAR: usize = 8;

/// How many names stand together at most.
const MOST_NAMES: usize = 64;

/// `Position: X 1 Y 2`: only the first is told; `Acc X: 1, Acc Y: 2, q0: 0.5`: the third is not of it.
fn belongs(named: &Named<'_>, stem: &str, member: &NamedNumber, is_last: bool) -> bool {
    let is_new = named.members.iter().all(|own| own.name != member.name);
    let follows = || {
        let last = named.members.last().map_or("", |last| &last.name);
        FOLLOWING
            .iter()
            .any(|names| is_listed(last, names) && is_listed(&member.name, names))
    };
    let tells_first_only = stem.is_empty() && !named.others_have_stem && is_last && follows();
    named.members.len() < MOST_NAMES && is_new && (stem == named.stem || tells_first_only)
}

/// Names that are told one after the other.
const FOLLOWING: [&str; 18] = [
    "w x y z p r",
    "qw qx qy qz",
    "q0 q1 q2 q3 q4 qs qc",
    "tx ty tz",
    "px py pz",
    "ox oy oz ow",
    "roll pitch yaw heading bank azimuth",
    "p y r h",
    "a b c d s t",
    "rx ry rz rw",
    "i j k real r",
    "real imag jmag kmag",
    "phi1 phi phi2",
    "phi theta psi",
    "omega phi kappa",
    "o a t",
    "e1 e2 e3",
    "rot0 rot1 rot2 rot3",
];

/// Whether a name is that of an entry of a matrix: `m12`; each row may stand in brackets of its own.
fn is_entry(name: &str) -> bool {
    let mut bytes = name.bytes();
    bytes.next() == Some(b'm') && name.len() == 3 && bytes.all(|byte| byte.is_ascii_digit())
}
