//! The words of labels, and what each says of the numbers under it: the one list of them.
//!
//! A label is a name before a mark, as in `q_wxyz = …` or `worldToBody: …`. A word that stands in none of the
//! lists says nothing, so that any name may be given to a rotation.

use crate::convention::Direction;
use crate::convention::angle::AngleUnit;
use crate::convention::family::Family;
use crate::convention::order::ComponentOrder;

/// What a word of a label, or a few of them together, say of the numbers under it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LabelWord {
    /// `xyzw`, `scalar_last`
    Order(ComponentOrder),
    /// `zyxw`: an order of components that none of the two is.
    OtherOrder,
    /// `hamilton`, `jpl`
    Family(Family),
    /// `left_handed`, `lhs`
    LeftHanded,
    /// `world_to_body`, `c2w`, `body_from_world`
    Direction(Direction),
    /// `inv`, `qdot`, `covariance`: made of a rotation, or the opposite one.
    Derived(Derived),
    /// `column_major`, `columns`
    Columns,
    /// `row_major`, `rows`
    Rows,
    /// `deg`, `radians`
    Unit(AngleUnit),
    /// `position`, `rgba`: something else than a rotation, in words.
    Quantity(&'static str),
    /// `orientation`, `quat`: a rotation, whatever else is named.
    Rotation,
}

/// What numbers are that were made of a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Derived {
    Inverse,
    Conjugate,
    Transposed,
    Negative,
    /// A rate, a derivative, an acceleration.
    Rate,
    /// A variance, a noise, a bias.
    Spread,
}

impl Derived {
    pub(crate) const fn in_words(self) -> &'static str {
        match self {
            Self::Inverse => "an inverse",
            Self::Conjugate => "a conjugate",
            Self::Transposed => "a transpose",
            Self::Negative => "a negative",
            Self::Rate => "a rate or a derivative",
            Self::Spread => "a variance, a noise or a bias",
        }
    }
}

/// Words in small letters, separated by spaces, and what each of them says; words that say it only together
/// stand without what is between them: `scalarlast`.
const WORDS: &[(&str, LabelWord)] = &[
    (
        "scalarfirst realfirst wfirst",
        LabelWord::Order(ComponentOrder::ScalarFirst),
    ),
    (
        "scalarlast reallast wlast",
        LabelWord::Order(ComponentOrder::ScalarLast),
    ),
    ("hamilton hamiltonian", LabelWord::Family(Family::Hamilton)),
    ("jpl shuster", LabelWord::Family(Family::Shuster)),
    (
        "lefthanded lefthand lhs lefthandedness leftcoordinates",
        LabelWord::LeftHanded,
    ),
    (
        "inv inverse inverted minus1",
        LabelWord::Derived(Derived::Inverse),
    ),
    (
        "conj conjugate conjugated star bar",
        LabelWord::Derived(Derived::Conjugate),
    ),
    (
        "transpose transposed transp ᵀ ᵗ",
        LabelWord::Derived(Derived::Transposed),
    ),
    (
        "minus neg negative negated",
        LabelWord::Derived(Derived::Negative),
    ),
    (
        "dot ddot deriv derivative rate rates vel velocity velocities speed speeds acceleration \
         accelerations gradient grad jacobian hessian",
        LabelWord::Derived(Derived::Rate),
    ),
    (
        "cov covar covariance var variance std stddev stdev sigma sigmas noise bias biases",
        LabelWord::Derived(Derived::Spread),
    ),
    (
        "columnmajor colmajor column columns col cols fortran",
        LabelWord::Columns,
    ),
    ("rowmajor row rows", LabelWord::Rows),
    (
        "rotation rotations rot orientation orientations attitude quaternion quaternions quat quats q qw \
         rpy ypr euler rotvec rvec rodrigues mrp gibbs dcm heading",
        LabelWord::Rotation,
    ),
    (
        "rgb rgba rgbw bgr bgra argb hsv hsl color colors colour colours albedo tint diffuse specular \
         emissive emission",
        LabelWord::Quantity("a colour"),
    ),
    (
        "position positions pos translation translations trans tvec location locations point points \
         coord coords coordinate coordinates displacement displacements offset offsets centroid center \
         centre waypoint waypoints vertex vertices landmark landmarks xyz pivot eye lookat",
        LabelWord::Quantity("a position"),
    ),
    (
        "plane planes normal normals tangent tangents",
        LabelWord::Quantity("a plane or a direction"),
    ),
    (
        "gyro gyros gyroscope twist angvel linvel omega",
        LabelWord::Quantity("a velocity"),
    ),
    (
        "acc accel accelerometer gravity grav",
        LabelWord::Quantity("an acceleration"),
    ),
    (
        "mag magnetometer magnetic",
        LabelWord::Quantity("a magnetic field"),
    ),
    (
        "force forces torque torques wrench moment momentum impulse thrust effort",
        LabelWord::Quantity("a force or a torque"),
    ),
    (
        "scale scales scaling size sizes dimension dimensions extent extents radius radii",
        LabelWord::Quantity("a scale or a size"),
    ),
    (
        "inertia inertias mass masses",
        LabelWord::Quantity("a mass or an inertia"),
    ),
    (
        "wheel wheels motor motors rotor rotors rpm pwm throttle throttles",
        LabelWord::Quantity("a speed of wheels or motors"),
    ),
    (
        "joint joints",
        LabelWord::Quantity("the coordinates of joints"),
    ),
    (
        "weight weights prob probs probability probabilities gain gains confidence score scores",
        LabelWord::Quantity("a weight"),
    ),
    (
        "bbox box boxes rect roi bounds aabb viewport",
        LabelWord::Quantity("a box"),
    ),
    (
        "distortion homography projection intrinsics uv texcoord texcoords pixel pixels",
        LabelWord::Quantity("a quantity of an image"),
    ),
    (
        "gps latitude longitude altitude lat lon latlon",
        LabelWord::Quantity("a place on the Earth"),
    ),
    (
        "temperature temperatures voltage voltages pressure pressures battery",
        LabelWord::Quantity("a measurement of something else"),
    ),
];

/// Names of the frame that a rotation is told in, and of the one that turns.
const WORLDS: &str =
    "world w global inertial nav navigation map earth ecef eci ned enu odom ground";
const BODIES: &str =
    "body b local sensor imu camera cam c device vehicle child robot drone tool rig";

/// What a name says of a rotation before its word for what was made of it: `qdot`, `Rinv`, `invR`.
const STEMS: [&str; 6] = ["quat", "rot", "mat", "dcm", "q", "r"];

/// The words of a name: its parts between marks, capitals (`qInv`) and digits (`c2w`).
pub(crate) fn words_of(name: &str) -> impl Iterator<Item = &str> {
    let mut rest = name;
    std::iter::from_fn(move || {
        rest = rest.trim_start_matches(|character: char| !character.is_alphanumeric());
        let end = end_of_word(rest);
        let (word, after) = rest.split_at(end);
        rest = after;
        (!word.is_empty()).then_some(word)
    })
}

/// Where the word ends that a text begins with.
fn end_of_word(text: &str) -> usize {
    let mut before: Option<char> = None;
    let mut characters = text.char_indices().peekable();
    while let Some((at, character)) = characters.next() {
        let starts_lower =
            |next: Option<&(usize, char)>| next.is_some_and(|(_, next)| next.is_lowercase());
        let ends = !character.is_alphanumeric()
            || matches!(character, 'ᵀ' | 'ᵗ')
            || before.is_some_and(|before| {
                before.is_numeric() != character.is_numeric()
                    || (before.is_lowercase() && character.is_uppercase())
                    // `JPLQuat` is `JPL` and `Quat`.
                    || (before.is_uppercase()
                        && character.is_uppercase()
                        && starts_lower(characters.peek()))
            });
        if ends && at > 0 {
            return at;
        }
        before = Some(character);
    }
    text.len()
}

/// What one word says, or several that stand together, as in `scalarlast`; `None` where it is not known.
pub(crate) fn meaning_of_word(word: &str) -> Option<LabelWord> {
    let lower = word.to_lowercase();
    listed(&lower)
        .or_else(|| AngleUnit::named(&lower).map(LabelWord::Unit))
        .or_else(|| order_of_letters(&lower))
        .or_else(|| made_of_a_stem(&lower))
        .or_else(|| {
            let (one, other) = lower.split_once("to")?;
            between_frames(one, other)
        })
}

fn listed(lower: &str) -> Option<LabelWord> {
    let is_in = |words: &str| words.split_ascii_whitespace().any(|known| known == lower);
    let found = WORDS.iter().find(|(words, _)| is_in(words));
    found.map(|&(_, meaning)| meaning)
}

/// `xyzw`, also where other letters touch it (`fromxyzw`); `zyxw` where none do.
fn order_of_letters(lower: &str) -> Option<LabelWord> {
    match () {
        () if lower.contains("xyzw") => Some(LabelWord::Order(ComponentOrder::ScalarLast)),
        () if lower.contains("wxyz") => Some(LabelWord::Order(ComponentOrder::ScalarFirst)),
        () => {
            let is_permuted = lower.len() == 4 && "wxyz".chars().all(|axis| lower.contains(axis));
            is_permuted.then_some(LabelWord::OtherOrder)
        }
    }
}

/// `qdot`, `Rinv`, `conjq`
fn made_of_a_stem(lower: &str) -> Option<LabelWord> {
    let derived = |rest: &str| match listed(rest) {
        Some(meaning @ LabelWord::Derived(_)) => Some(meaning),
        _ => None,
    };
    STEMS.iter().find_map(|stem| {
        let after = lower.strip_prefix(stem).and_then(derived);
        after.or_else(|| lower.strip_suffix(stem).and_then(derived))
    })
}

/// The direction from one frame to another, where one is a world and one a body.
fn between_frames(from: &str, to: &str) -> Option<LabelWord> {
    let is_of =
        |frame: &str, frames: &str| frames.split_ascii_whitespace().any(|known| known == frame);
    let leads = |one: &str, other: &str| is_of(from, one) && is_of(to, other);
    let direction = match () {
        () if leads(WORLDS, BODIES) => Direction::WorldToBody,
        () if leads(BODIES, WORLDS) => Direction::BodyToWorld,
        () => return None,
    };
    Some(LabelWord::Direction(direction))
}

/// All that the words of a name say, one by one and together.
pub(crate) fn meanings_of(name: &str) -> Vec<LabelWord> {
    let words: Vec<String> = words_of(name).map(str::to_lowercase).collect();
    let mut meanings = Vec::new();
    let mut at = 0;
    while at < words.len() {
        let (meaning, length) = meaning_ahead(&words[at..]);
        meanings.extend(meaning);
        at += length;
    }
    meanings
}

/// What the first words say, and how many they are: the most that say something together.
fn meaning_ahead(words: &[String]) -> (Option<LabelWord>, usize) {
    if let [one, between, other, ..] = words {
        let direction = match between.as_str() {
            "to" | "2" => between_frames(one, other),
            "from" => between_frames(other, one),
            _ => None,
        };
        if direction.is_some() {
            return (direction, 3);
        }
    }
    if let [one, other, ..] = words {
        // `R_t`, `R.T`: perhaps at a time, perhaps transposed.
        if other == "t"
            && matches!(
                one.as_str(),
                "r" | "rot" | "m" | "mat" | "matrix" | "dcm" | "v"
            )
        {
            return (Some(LabelWord::Derived(Derived::Transposed)), 2);
        }
        let together = listed(&[one.as_str(), other].concat());
        if together.is_some() {
            return (together, 2);
        }
    }
    match &words[0] {
        word if word == "rt" => (Some(LabelWord::Derived(Derived::Transposed)), 1),
        word => (meaning_of_word(word), 1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use wasm_bindgen_test::wasm_bindgen_test;

    #[wasm_bindgen_test(unsupported = test)]
    fn a_name_is_split_at_marks_capitals_and_digits() {
        let split = |name| words_of(name).collect::<Vec<_>>().join(" ");
        assert_eq!(split("q_scalar.last-of:it"), "q scalar last of it");
        assert_eq!(split("qInv"), "q Inv");
        assert_eq!(split("worldToBodyJPLQuat"), "world To Body JPL Quat");
        assert_eq!(split("c2w"), "c 2 w");
        assert_eq!(split("Rᵀ"), "R ᵀ");
        assert_eq!(split("__"), "");
    }

    #[wasm_bindgen_test(unsupported = test)]
    fn words_say_what_they_say_alone_and_together() {
        use LabelWord::{Derived as Made, Direction as Leads, Order, Quantity, Rotation};
        let first = |name| meanings_of(name).first().copied();
        assert_eq!(first("scalarLast"), Some(Order(ComponentOrder::ScalarLast)));
        assert_eq!(
            first("scalar_first"),
            Some(Order(ComponentOrder::ScalarFirst))
        );
        assert_eq!(first("quatxyzw"), Some(Order(ComponentOrder::ScalarLast)));
        assert_eq!(first("zyxw"), Some(LabelWord::OtherOrder));
        assert_eq!(first("left_handed"), Some(LabelWord::LeftHanded));
        assert_eq!(
            first("left_wheel_frame"),
            Some(Quantity("a speed of wheels or motors"))
        );
        assert_eq!(first("world_to_body"), Some(Leads(Direction::WorldToBody)));
        assert_eq!(first("worldFromCam"), Some(Leads(Direction::BodyToWorld)));
        assert_eq!(first("c2w"), Some(Leads(Direction::BodyToWorld)));
        assert_eq!(first("body_to_camera"), None);
        assert_eq!(first("qdot"), Some(Made(Derived::Rate)));
        assert_eq!(first("R_t"), Some(Made(Derived::Transposed)));
        assert_eq!(first("q_t"), Some(Rotation));
        assert_eq!(first("columnMajor"), Some(LabelWord::Columns));
        assert_eq!(first("my_name"), None);
    }
}
