//! What words say of all the numbers of a text, and where they leave it open.

use crate::convention::angle::AngleUnit;
use crate::convention::euler_sequence::EulerSequence;
use crate::convention::order::ComponentOrder;
use crate::problem::Span;
use crate::text::record::described::{Described, sequence};
use crate::text::record::found::Context;
use crate::text::record::group::Quantities;
use crate::text::record::names::words_of;
use crate::text::record::quantity::Value;
use crate::text::record::scan::{Mark, Token};
use crate::text::vocabulary::constructors::order_in_name;
use crate::text::vocabulary::is_listed;
use crate::text::vocabulary::labels::is_derived;

/// What words with a name say of all numbers: `angle="radian"`, `_order: 'XYZ'`, `rotation_format='quat_xyzw'`.
#[derive(Default)]
pub(crate) struct Settings {
    pub(crate) order: Option<ComponentOrder>,
    pub(crate) unit: Option<AngleUnit>,
    pub(crate) letters: Option<String>,
    /// `"sequence": "zyx", "frame": "intrinsic"`
    pub(crate) described: Option<Described>,
    /// Whether something was set that is not understood: it may change every number.
    pub(crate) is_doubtful: bool,
}

impl Settings {
    pub(crate) fn of(values: &[Value<'_>]) -> Self {
        let mut settings = Self::default();
        for value in values {
            settings.take(value);
        }
        if let Some(frame) = values.iter().find(|value| is_frame(value)) {
            let letters = settings.letters.as_deref().unwrap_or("");
            settings.described = sequence(letters, &[frame.text]).map(Described::Euler);
            settings.is_doubtful |= settings.described.is_none();
        }
        settings
    }

    fn take(&mut self, value: &Value<'_>) {
        let key = words_of(value.key);
        let is = |names: &[&str]| {
            key.last()
                .is_some_and(|last| names.contains(&last.as_str()))
        };
        if key.len() == 1
            && is(&["handedness", "hand"])
            && !value.text.to_ascii_lowercase().starts_with("right")
        {
            self.is_doubtful = true;
        }
        // `transpose=true`, `"type": "JPL"`.
        let is_turned = is(&[
            "transpose",
            "transposed",
            "inverse",
            "inverted",
            "conjugate",
        ]) && value.text.eq_ignore_ascii_case("true");
        // `"type": "conjugate"`, `"comment": "inverse of the attitude"`.
        let is_made = is(&["type", "kind", "form"]) && is_derived(value.text)
            || is(&["comment", "note", "description"])
                && value.text.split_whitespace().any(is_derived);
        self.is_doubtful |= is_turned || is_made || value.text.eq_ignore_ascii_case("jpl");
        let is_sequence = value.text.parse::<EulerSequence>().is_ok();
        // `inverse: ZYX roll=…`
        self.is_doubtful |= is_sequence && is_derived(value.key);
        let is_known_order = |text: &str| {
            let lower = text.to_ascii_lowercase();
            order_in_name(text).is_some()
                || text.parse::<EulerSequence>().is_ok()
                || ["c", "row", "rows", "row-major", "row_major", "rowmajor"]
                    .contains(&lower.as_str())
        };
        if key.len() == 1
            && is(&["order", "layout", "sequence", "seq"])
            && !is_known_order(value.text)
        {
            self.is_doubtful = true;
        }
        if is(&["order", "format", "convention", "layout", "components"]) {
            self.order = self.order.or_else(|| order_in_name(value.text));
        }
        if is(&["type"]) && key.iter().any(|word| word == "quaternion") {
            self.order = self.order.or(match value.text {
                "FIRST" => Some(ComponentOrder::ScalarFirst),
                "LAST" => Some(ComponentOrder::ScalarLast),
                _ => None,
            });
        }
        if is(&["angle", "unit", "units", "angles", "degrees"]) {
            let word = value.text.to_ascii_lowercase();
            let told = match (word.as_str(), is(&["degrees"])) {
                ("true" | "1", true) => Some(AngleUnit::Degrees),
                ("false" | "0", true) => Some(AngleUnit::Radians),
                _ => AngleUnit::named(&word),
            };
            // `unit: deg`, and then `units: rad`.
            self.is_doubtful |= told.is_some() && self.unit.is_some() && told != self.unit;
            self.unit = self.unit.or(told);
        }
        // `# angles in degrees`
        if value.key.is_empty() && value.text.starts_with("angles in ") {
            let last = value.text.rsplit(' ').next().unwrap_or("");
            self.unit = self.unit.or_else(|| AngleUnit::named(last));
        }
        // `toArray()` of three.js and the `repr` of Blender: `(0.1, 0.2, 0.3, 'XYZ')`.
        let is_alone = value.key.is_empty()
            && value.text.len() == 3
            && value.text.chars().all(|letter| "XYZ".contains(letter));
        if (is_alone || is(&["order", "sequence", "seq", "eulerseq", "axes"]))
            && self.letters.is_none()
        {
            let is_sequence = value.text.parse::<EulerSequence>().is_ok();
            self.letters = is_sequence.then(|| value.text.to_owned());
        }
    }
}

/// `{"frame": "extrinsic", …}`: with the letters of a sequence beside it.
fn is_frame(value: &Value<'_>) -> bool {
    ["intrinsic", "extrinsic"].contains(&value.text)
}

/// The order of four components that the words of a text tell anywhere: `in x, y, z, w order`, `qx qy qz qw`, `the
/// scalar comes last`; `None` where they tell none, or both.
pub(crate) fn order_of_words(tokens: &[Token<'_>]) -> Option<ComponentOrder> {
    let mut told = None;
    // The last single letters in a row, behind a q or alone.
    let mut letters = String::new();
    let mut are_of_q = false;
    // How many words ago the scalar was spoken of.
    let mut since_scalar = usize::MAX;
    for token in tokens {
        if matches!(token.mark, Mark::Number(_)) {
            letters.clear();
        }
        if !matches!(token.mark, Mark::Word | Mark::Flag) {
            continue;
        }
        let words = words_of(token.text);
        // `scalar_first=False` is a setting.
        if words.len() > 1 && words.iter().any(|word| word == "scalar") {
            continue;
        }
        for word in words {
            let letter = word.strip_prefix('q').unwrap_or(&word);
            if letter.is_empty() {
                continue;
            }
            since_scalar = since_scalar.saturating_add(1);
            let is_of_q = letter.len() < word.len();
            if letter.len() != 1 || !"wxyz".contains(letter) || is_of_q != are_of_q {
                letters.clear();
                are_of_q = is_of_q;
            }
            if letter.len() == 1 {
                letters.push_str(letter);
            }
            let last_four = letters.len().saturating_sub(4);
            let order = match word.as_str() {
                "scalar" => {
                    since_scalar = 0;
                    None
                }
                "last" if since_scalar <= NEAR_SCALAR => Some(ComponentOrder::ScalarLast),
                "first" if since_scalar <= NEAR_SCALAR => Some(ComponentOrder::ScalarFirst),
                _ => order_in_name(&word).or_else(|| order_in_name(&letters[last_four..])),
            };
            match (told, order) {
                (Some(one), Some(other)) if one != other => return None,
                (_, Some(order)) => told = Some(order),
                _ => {}
            }
        }
    }
    told
}

/// How many words stand at most between the scalar and its place: `scalar part comes last`.
const NEAR_SCALAR: usize = 4;

/// Where a text says that the orientation beside it is not known: `"isTracked": false`, and a covariance that
/// begins with −1 (`sensor_msgs/Imu`, REP 145).
pub(crate) fn unknown_orientation(quantities: &Quantities<'_>) -> Option<Span> {
    let ends_with = |key: &str, words: &[&str]| {
        let known = words_of(key);
        known
            .iter()
            .rev()
            .zip(words)
            .all(|(word, known)| word == known)
            && known.len() >= words.len()
    };
    for value in &quantities.values {
        if ends_with(value.key, &["tracked"]) && value.text.eq_ignore_ascii_case("false") {
            return Some(value.span);
        }
    }
    for group in &quantities.groups {
        let key = group.path.last().copied().unwrap_or("");
        if group.numbers.first() == Some(&-1.0) && ends_with(key, &["covariance", "orientation"]) {
            return Some(group.span);
        }
    }
    None
}

/// Whether a line holds one quantity, under no name or a word that announces a description: what the grammar
/// refuses of such a text, it refuses on purpose.
pub(crate) fn is_plain(quantities: &Quantities<'_>, context: &Context) -> bool {
    const ANNOUNCING: &str = "deg rad degrees radians rotvec rpy ypr mrp gibbs euler xyz zyx zyz zxz intrinsic extrinsic fixed static moving \
                              rotating axis angle axisangle halfangle";
    let is_marked = context.formats.iter().any(|format| format.has_marks());
    let announces = |path: &[&str]| {
        let first = path.iter().flat_map(|key| words_of(key)).next();
        first.is_none_or(|first| is_listed(&first, ANNOUNCING))
    };
    let is_alone = match (&quantities.groups[..], &quantities.named[..]) {
        // Rows of files have more numbers.
        ([group], []) => group.numbers.len() <= 4 && announces(&group.path),
        ([], [named]) => {
            let mut path = named.path.clone();
            path.push(&named.stem);
            announces(&path) && !named.stem.is_empty()
        }
        _ => false,
    };
    is_alone && !is_marked
}

/// Whether a component stands there twice, as in `{w: 0.9, z: 0.4, x: 0, y: 0, z: 0}`.
pub(crate) fn has_duplicate(quantities: &Quantities<'_>) -> bool {
    quantities.named.windows(2).any(|pair| {
        let [one, next] = pair else {
            return false;
        };
        let is_again = |name: &str| one.members.iter().any(|member| member.name == name);
        one.scope == next.scope
            && one.stem == next.stem
            && next.members.len() <= 2
            && next.members.iter().all(|member| is_again(&member.name))
    })
}

/// Whether every bracket is closed.
pub(crate) fn is_balanced(tokens: &[Token<'_>]) -> bool {
    let mut open = Vec::new();
    for token in tokens {
        match (token.mark, token.text) {
            (Mark::Open, "(" | "[" | "{") => open.push(token.text),
            (Mark::Close, close @ (")" | "]" | "}")) => {
                let opens = match close {
                    ")" => "(",
                    "]" => "[",
                    _ => "{",
                };
                if open.pop() != Some(opens) {
                    return false;
                }
            }
            _ => {}
        }
    }
    open.is_empty()
}
