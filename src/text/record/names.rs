//! Names to the words in them, and words that are numbers.

use crate::character::{is_alphabetic, is_alphanumeric, is_digit, is_of_name};
use crate::decimal::nearest_double;
use crate::text::vocabulary::decimal_words::is_decimal;
use crate::text::vocabulary::is_listed;

/// The words of a name, in small letters: `m_LocalRotation` is m, local, rotation.
pub(crate) fn words_of(name: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut before = ' ';
    let mut characters = name.chars().peekable();
    while let Some(mark) = characters.next() {
        let next_is_small = characters
            .peek()
            .is_some_and(|next| next.is_ascii_lowercase());
        let is_part = is_alphanumeric(mark) || mark == '°' || mark == '±';
        // `quat2eul` is quat, eul.
        if mark == '2'
            && is_alphabetic(before)
            && characters.peek().is_some_and(|next| is_alphabetic(*next))
        {
            before = ' ';
            continue;
        }
        let begins = !is_alphanumeric(before)
            || (before.is_ascii_lowercase() && mark.is_ascii_uppercase())
            || (before.is_ascii_uppercase() && mark.is_ascii_uppercase() && next_is_small)
            || (before.is_ascii_digit()
                && is_alphabetic(mark)
                && before != ' '
                && mark.is_ascii_uppercase());
        if is_part {
            if begins || words.is_empty() {
                words.push(String::new());
            }
            if let Some(word) = words.last_mut() {
                word.push(mark.to_ascii_lowercase());
            }
        }
        before = mark;
    }
    words
}

/// The names in a key as they are written, in small letters: `CFrame.new` is cframe, new.
pub(crate) fn identifiers_of(key: &str) -> impl Iterator<Item = String> + '_ {
    key.split(|mark| !is_of_name(mark))
        .filter(|name| !name.is_empty())
        .map(str::to_ascii_lowercase)
}

/// The number that a word is and no more; `None` where no double is so large.
pub(crate) fn finite_decimal(word: &str) -> Option<f64> {
    let number = is_decimal(word).then(|| nearest_double(word))?;
    number.is_finite().then_some(number)
}

/// Names that are written in another way.
const ALIASES: [(&str, &str); 11] = [
    ("hdg", "heading"),
    ("φ₁", "phi1"),
    ("φ1", "phi1"),
    ("φ₂", "phi2"),
    ("φ2", "phi2"),
    ("φ", "phi"),
    ("Φ", "phi"),
    ("θ", "theta"),
    ("ψ", "psi"),
    ("ω", "omega"),
    ("κ", "kappa"),
];

/// The name of a single number, and what stands before it: `pose.orientation.x` is x of pose, orientation.
pub(crate) fn name_and_stem(key: &str) -> (String, String) {
    let mut words = words_of(key);
    if words.len() > 1 && words.last().is_some_and(|last| is_addition(last)) {
        words.pop();
    }
    // `a yaw of 12°`
    while words.len() > 1
        && words
            .last()
            .is_some_and(|last| is_filler(last) && last != "a")
    {
        words.pop();
    }
    let mut name = words.pop().unwrap_or_default();
    if let Some((_, same)) = ALIASES.iter().find(|(alias, _)| *alias == name) {
        name = (*same).to_owned();
    }
    words.retain(|word| !is_filler(word));
    // `q[0]` is q0, `matrix[1][2]` and `M12` are m12.
    let is_place = |word: &str| word.len() == 1 && word.starts_with(is_digit);
    if is_place(&name) && words.last().is_some_and(|last| is_place(last)) {
        let row = words.pop().unwrap_or_default();
        name = format!("m{row}{name}");
    } else if name.len() == 2 && name.bytes().all(|byte| byte.is_ascii_digit()) {
        name.insert(0, 'm');
    } else if is_place(&name)
        && let Some(of) = words.pop()
    {
        name.insert_str(0, &of);
    }
    // `q_w`, `quat.w`, `qW`: the name says whose component it is.
    if name.len() == 1 && "wxyz".contains(&name) && words.last().is_some_and(|last| last == "q") {
        words.pop();
        name.insert(0, 'q');
    }
    (name, words.join(" "))
}

fn is_filler(word: &str) -> bool {
    [
        "of", "is", "was", "a", "an", "the", "and", "with", "by", "about", "in",
    ]
    .contains(&word)
}

/// What stands behind a name and says its unit or its type.
fn is_addition(word: &str) -> bool {
    [
        "val", "value", "deg", "degrees", "degree", "rad", "radians", "radian", "m", "mm", "°",
    ]
    .contains(&word)
}

/// Whether a column of this name is a component, an angle or a coordinate.
pub(crate) fn is_usual_name(cell: &str) -> bool {
    const NAMES: &str = "w x y z qw qx qy qz q0 q1 q2 q3 q4 qs qc qr qi qj qk tx ty tz px py pz roll pitch yaw heading \
                         rx ry rz a b c o t phi theta psi phi1 phi2 omega kappa quatw quati quatj quatk \
                         euler1 euler2 euler3 ox oy oz ow xposition yposition zposition xrotation yrotation zrotation orient1 orient2 orient3 orient4";
    let (name, _) = name_and_stem(cell);
    is_listed(&name, NAMES)
}

/// The names of a list of numbers where there are as many: `roll, pitch, yaw`, `φ₁, Φ, φ₂`, `X,Y,Z`.
pub(crate) fn names_of_list(key: &str, count: usize) -> Option<Vec<&str>> {
    const ANGLES: &str =
        "roll pitch yaw heading bank phi1 phi phi2 theta psi omega kappa azimuth x y z w p r a b c";
    if !(3..=7).contains(&count) {
        return None;
    }
    let mut names = Vec::new();
    for name in key.split(|mark: char| mark.is_whitespace() || ",;/|()[]".contains(mark)) {
        if !name.is_empty() {
            names.push(name);
        }
    }
    let is_one = |name: &&str| {
        let (own, stem) = name_and_stem(name);
        stem.is_empty() && is_listed(&own, ANGLES)
    };
    let distinct = |names: &[&str]| (1..names.len()).all(|at| !names[..at].contains(&names[at]));
    (names.len() == count && names.iter().all(is_one) && distinct(&names)).then_some(names)
}

/// Whether a name says no more than that it holds numbers.
pub(crate) fn is_holder(key: &str) -> bool {
    const HOLDERS: &str = "new array list tuple vector vector3 vec3 vec3f vec4 lvecbase3f double3 float3 data values value \
                           np numpy glm tensor torch matrix3 float32array float64array jnp eigen f32 f64 double float coords";
    identifiers_of(key).all(|word| is_listed(&word, HOLDERS))
}

/// Whether a call is a factor of a product of turns, or takes a product: Eigen, nalgebra and glam, MATLAB, `SciPy`.
pub(crate) fn is_factor(key: &str) -> bool {
    ["AngleAxis", "from_axis_angle", "axang2", "from_rotvec"]
        .iter()
        .any(|name| key.contains(name))
}
