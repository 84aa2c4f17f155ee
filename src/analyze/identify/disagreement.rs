//! Observations that do not agree, and the choices about which they do not.

use crate::contract::{Contradiction, remaining};
use crate::library::behaviour::{Behaviour, BehaviourAxis};

/// Whether each behaviour agrees with an observation, in the order of [`Behaviour::all`].
pub(super) struct Agreeing(pub(super) Vec<bool>);

impl Agreeing {
    pub(super) fn behaviours(&self) -> Vec<Behaviour> {
        agreeing(&[(0, self)])
    }
}

/// The behaviours that agree with all of these.
pub(super) fn agreeing(told: &[(usize, &Agreeing)]) -> Vec<Behaviour> {
    let mut left = Vec::new();
    for (at, behaviour) in Behaviour::all().enumerate() {
        if told.iter().all(|(_, Agreeing(agrees))| agrees[at]) {
            left.push(behaviour);
        }
    }
    left
}

/// Observations that do not agree: a pair if there is one, or else a set of which none can be spared.
pub(super) fn contradiction(told: &[(usize, &Agreeing)]) -> Option<Contradiction> {
    if !agreeing(told).is_empty() {
        return None;
    }
    let disagreeing = pair(told).unwrap_or_else(|| without_bystanders(told));
    let mut observations = Vec::new();
    for (at, _) in &disagreeing {
        observations.push(*at);
    }
    Some(Contradiction {
        about: disputed(&disagreeing, told),
        observations,
    })
}

/// The first two observations that do not agree.
fn pair<'a>(told: &[(usize, &'a Agreeing)]) -> Option<Vec<(usize, &'a Agreeing)>> {
    for (at, one) in told.iter().enumerate() {
        for other in &told[at + 1..] {
            let pair = [*one, *other];
            if agreeing(&pair).is_empty() {
                return Some(pair.to_vec());
            }
        }
    }
    None
}

/// What is left of observations that do not agree when every one is taken out that is not needed for it.
fn without_bystanders<'a>(told: &[(usize, &'a Agreeing)]) -> Vec<(usize, &'a Agreeing)> {
    let mut needed = told.to_vec();
    let mut at = 0;
    while at < needed.len() {
        let taken_out = needed.remove(at);
        if !agreeing(&needed).is_empty() {
            needed.insert(at, taken_out);
            at += 1;
        }
    }
    needed
}

/// The choices about which some of the observations disagree.
fn disputed(disagreeing: &[(usize, &Agreeing)], told: &[(usize, &Agreeing)]) -> Vec<BehaviourAxis> {
    let mut alone = Vec::new();
    for (_, told) in disagreeing {
        alone.push(told.behaviours());
    }
    let disputed = settled_differently(&alone);
    let [one, another] = disagreeing else {
        return disputed;
    };
    if !disputed.is_empty() {
        return disputed;
    }
    // A small turn ties three choices together and settles none; all the other observations may.
    let without = |left_out: usize| {
        let mut counted = told.to_vec();
        counted.retain(|(at, _)| *at != left_out);
        agreeing(&counted)
    };
    let together = [without(another.0), without(one.0)];
    let sides = if together[0].is_empty() || together[1].is_empty() {
        &alone[..]
    } else {
        &together
    };
    match settled_differently(sides) {
        none if none.is_empty() => one_choice_apart(sides),
        disputed => disputed,
    }
}

/// The choices that two of these have settled to different values.
fn settled_differently(sides: &[Vec<Behaviour>]) -> Vec<BehaviourAxis> {
    let mut settled = Vec::new();
    for possible in sides {
        if let Some(first) = possible.first() {
            settled.push((remaining(possible).settled(), first));
        }
    }
    let mut disputed = Vec::new();
    for axis in BehaviourAxis::ALL {
        let mut is_there = [false; 2];
        for (settled, behaviour) in &settled {
            if settled.contains(&axis) {
                is_there[usize::from(axis.is_second(behaviour))] = true;
            }
        }
        if is_there == [true; 2] {
            disputed.push(axis);
        }
    }
    disputed
}

/// The choices of which another value makes what one side allows what the other allows.
fn one_choice_apart(sides: &[Vec<Behaviour>]) -> Vec<BehaviourAxis> {
    let [one, other] = sides else {
        return Vec::new();
    };
    let mut apart = Vec::new();
    for axis in BehaviourAxis::ALL {
        for behaviour in one {
            if other.contains(&behaviour.with_other(axis)) {
                apart.push(axis);
                break;
            }
        }
    }
    apart
}
