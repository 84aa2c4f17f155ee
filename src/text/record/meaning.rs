//! What the name of numbers says that they are.

use crate::character::{is_alphanumeric, is_digit, is_of_name, parts_words};
use crate::convention::angle::AngleUnit;
use crate::convention::euler_sequence::EulerSequence;
use crate::convention::order::ComponentOrder;
use crate::text::record::names::{is_holder, words_of};
use crate::text::record::sequences::sequence_of;
use crate::text::vocabulary::constructors::{Call, call, is_matrix, order_in_name};
use crate::text::vocabulary::is_listed;
use crate::text::vocabulary::labels::is_derived;

/// What numbers are by their name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    Position,
    Scale,
    Time,
    /// A rotation in whichever description has so many numbers.
    Rotation,
    Quaternion,
    Euler,
    RotationVector,
    AxisAngle,
    Axis,
    Angle,
    Matrix,
    /// The scalar of a quaternion, and its vector.
    Scalar,
    Vector,
    /// Something that is no rotation, though it may hold one by its own names: a camera, a joint.
    Other,
    /// Something that is no rotation whatever its numbers are called: a velocity, a covariance, a colour.
    Rate,
    /// Something that was made of a rotation: its inverse, its derivative.
    Derived,
}

/// Words, and what numbers under them are.
const ROLES: &[(Role, &str)] = &[
    (
        Role::Position,
        "position pos translation translate trans tvec t xyz origin location loc p offset place \
         coordinates coordinate point center centre pinx target xyzposition tx displacement place pv lla \
         posx posy posz placement localposition cpos lookat",
    ),
    (Role::Scale, "scale scl scaling s scalefactor localscale"),
    (
        Role::Time,
        "time stamp timestamp epoch sec secs nanosec nsec nsecs seconds usec ms",
    ),
    (
        Role::Quaternion,
        "quaternion quat quaternions quats quatf quatd quath q qbn qnb attq quaternionf quaterniond fquat xyzw wxyz orient",
    ),
    (
        Role::Rotation,
        "rotation rot orientation attitude rotate rotations heading pose transform so3",
    ),
    (
        Role::Euler,
        "euler eulers rpy ypr rollpitchyaw yawpitchroll eulerangles angles rotator frotator hpr eul attangles",
    ),
    (
        Role::RotationVector,
        "rotvec rvec rotationvector rvecs axisanglevector",
    ),
    (
        Role::AxisAngle,
        "axisangle axang angleaxis rotate3d sfrotation aa",
    ),
    (Role::Axis, "axis"),
    (Role::Angle, "angle theta"),
    (
        Role::Matrix,
        "matrix r mat basis dcm rotmat rotationmatrix rotm matrix3d matrix4d transformmatrix tf extrinsic extrinsics \
         matrix3 matrix4 mat3 mat4 simd cbn cnb",
    ),
    (Role::Scalar, "real w scalar re"),
    (Role::Vector, "imag v vec vector im imaginary xyzvector"),
    (
        Role::Other,
        "field intrinsics intrinsic resolution rows cols mass size extents joint joints config conf plane \
         normal temperature pressure weight weights fov focal camera overlaps children mesh vertices vertex points corners normals landmarks keypoints tangent tangents uv polygon bbox box bounds \
         min max status calibration sys version id seq index port lat lon alt latitude longitude altitude hz \
         fps frames frame width height length radius joint1 extax axes_config k projection essential \
         fundamental homography battery",
    ),
    (
        Role::Rate,
        "covariance cov velocity vel linear angular twist acc accel acceleration gyro gyr mag magn magnetic \
         distortion coeffs color colour colors rgba rgb gravity uncertainty ± angvel linvel omega rate rates \
         rate0 omegas force torque wrench residual stdev std sigma variance skew pid gains percent \
         probability speed speeds wheel wheels shear bias noise limits lower upper effort jacobian hessian \
         inertia mrp gibbs crp δ turns mrad mdeg arcsec arcmin",
    ),
    (
        Role::Derived,
        "inverse inv inverted transpose transposed conj conjugate dot derivative qdot qinv delta dq residual drift",
    ),
];

/// What a word says.
fn role_of_word(word: &str) -> Option<Role> {
    // `MLMatrix44`, `vec3`: sizes say nothing.
    let bare = word.trim_end_matches(is_digit);
    let word = if bare == "matrix" { bare } else { word };
    // Four numbers of a vector have an order of their own.
    if word.starts_with("vector4") || word.starts_with("vec4") {
        return Some(Role::Vector);
    }
    if word.contains("euler") {
        return Some(Role::Euler);
    }
    ROLES
        .iter()
        .find(|(_, words)| is_listed(word, words))
        .map(|&(role, _)| role)
}

/// What names say, of those that hold numbers from the outermost to their own.
#[derive(Clone, Debug, Default)]
pub(crate) struct Meaning {
    pub(crate) role: Option<Role>,
    pub(crate) order: Option<ComponentOrder>,
    pub(crate) unit: Option<AngleUnit>,
    pub(crate) sequence: Option<EulerSequence>,
    pub(crate) by_columns: bool,
}

impl Meaning {
    /// What a path of names says; the inner ones say more than the outer ones.
    pub(crate) fn of(path: &[&str]) -> Self {
        let mut meaning = Self::default();
        for key in path.iter().rev() {
            meaning.take(key);
        }
        meaning
    }

    /// With what is said behind the numbers, where their names do not say it.
    pub(crate) fn with_remark(mut self, remark: &str) -> Self {
        if remark.is_empty() {
            return self;
        }
        let words = words_of(remark);
        let mut letters = String::new();
        for word in &words {
            letters.push_str(word.trim_start_matches('q'));
        }
        let order = order_in_name(&letters).or_else(|| order_in_prose(&words));
        self.order = self.order.or(order);
        for word in &words {
            self.unit = self.unit.or_else(|| AngleUnit::named(word));
        }
        self.by_columns |= tells_columns(&words);
        self
    }

    fn take(&mut self, key: &str) {
        // The words of a declaration say nothing: `VAR pose`, `const quat`.
        let key = [
            "VAR ", "PERS ", "CONST ", "LOCAL ", "TASK ", "let ", "const ", "static ",
        ]
        .into_iter()
        .find_map(|word| key.strip_prefix(word))
        .unwrap_or(key);
        let words = words_of(key);
        let joined = words.join("");
        if words.is_empty() {
            return;
        }
        self.order = self.order.or_else(|| order_in_name(&joined)).or_else(|| {
            // `rotation: Quat(…)`, `tf::Quaternion q(…)`: one of the words is the call.
            key.split([' ', '\t']).find_map(|name| match call(name) {
                Call::Ordered(order) => Some(order),
                _ => None,
            })
        });
        self.unit = self.unit.or_else(|| {
            let unit = words.iter().rev().find_map(|word| AngleUnit::named(word));
            let is_denied = words.windows(2).any(|pair| pair == ["degrees", "false"]);
            if is_denied {
                Some(AngleUnit::Radians)
            } else {
                unit
            }
        });
        self.sequence = self.sequence.or_else(|| sequence_of(key, &words));
        self.by_columns |= tells_columns(&words);
        let has = |order: &str| joined.contains(order);
        let tells_both = has("xyzw") && joined.replacen("xyzw", " ", 1).contains("wxyz");
        // spatialmath says in which order it turns: `rpy/zyx`.
        if tells_both || has_two_descriptions(&words) && !key.contains("rpy/zyx") {
            self.role = Some(Role::Rate);
            return;
        }
        // Of a line that was typed at a prompt no two words are one name.
        let derived = key
            .split(|mark: char| !is_alphanumeric(mark) && !"_.'ᵀ".contains(mark))
            .any(|name| is_derived(name) && !name.contains(WITH_COVARIANCE))
            || words
                .iter()
                .any(|word| role_of_word(word) == Some(Role::Derived));
        let own = if derived {
            Some(Role::Derived)
        } else {
            Self::role_in(without_arguments(key))
        };
        // `rpyOffset` is no position.
        let own = match own {
            None | Some(Role::Position)
                if sequence_of(key, &words).is_some()
                    && !key.to_ascii_lowercase().contains("xyz") =>
            {
                Some(Role::Euler)
            }
            own => own,
        };
        self.role = match (self.role, own) {
            (Some(Role::Derived), _) | (_, Some(Role::Derived)) => Some(Role::Derived),
            // `Rotation: in RPY`: the inner name is the nearer one.
            (Some(own), _) => Some(own),
            (None, outer) => outer,
        };
    }

    fn role_in(key: &str) -> Option<Role> {
        let words = words_of(key);
        let pairs = words.windows(2);
        // `T` is a transform and `t` a translation; `R` is a matrix.
        let first = key.split(parts_words).find(|word| !word.is_empty());
        if first == Some("T") {
            return Some(Role::Matrix);
        }
        // `orientation (x, y, z, w)`: letters behind the name are its components.
        let letters = words
            .iter()
            .rev()
            .take_while(|word| word.len() == 1 && "wxyz".contains(word.as_str()))
            .count();
        // `euler_from_quaternion`: what it was made of says nothing.
        let from = words
            .iter()
            .position(|word| word == "from")
            .filter(|&at| at > 0);
        let words = &words[..from.unwrap_or(words.len())];
        let words = if letters >= 3 {
            &words[..words.len() - letters]
        } else {
            words
        };
        if words.is_empty() {
            return (letters == 4).then_some(Role::Quaternion);
        }
        let two = pairs.rev().find_map(|pair| role_of_word(&pair.concat()));
        // A letter is a name only where it stands alone: `tGripper` is no translation.
        let stands_alone = |word: &str| {
            word.chars().count() > 1
                || word == "±"
                || key
                    .split(parts_words)
                    .any(|own| own.to_ascii_lowercase() == word)
        };
        // `omega_q`, `gyro_q`: another quantity in the same name is what it is.
        let last = key.rsplit([' ', '\t']).next().unwrap_or(key);
        let is_rate = words_of(last)
            .iter()
            .any(|word| word.chars().count() > 1 && role_of_word(word) == Some(Role::Rate));
        if is_rate {
            return Some(Role::Rate);
        }
        two.or_else(|| {
            let own = words.iter().rev().filter(|word| stands_alone(word));
            own.clone().find_map(|word| role_of_word(word))
        })
        // `r` alone is no matrix in the middle of a name.
        .filter(|role| !(*role == Role::Matrix && first == Some("r")))
    }
}

/// `scalar part last`, `where the last entry is the scalar`
fn order_in_prose(words: &[String]) -> Option<ComponentOrder> {
    let has = |own: &str| words.iter().any(|word| word == own);
    match (
        has("scalar") || has("real") || has("w"),
        has("first"),
        has("last"),
    ) {
        (true, true, false) => Some(ComponentOrder::ScalarFirst),
        (true, false, true) => Some(ComponentOrder::ScalarLast),
        _ => None,
    }
}

/// A type of ROS that has a covariance beside what it names.
const WITH_COVARIANCE: &str = "WithCovariance";

/// `column major`, `by columns`; of `column vectors` any matrix is one.
fn tells_columns(words: &[String]) -> bool {
    let mut tells = false;
    for (at, word) in words.iter().enumerate() {
        let of_vectors = words
            .get(at + 1)
            .is_some_and(|next| next.starts_with("vector"));
        tells |= matches!(word.as_str(), "column" | "columns" | "columnmajor") && !of_vectors;
    }
    tells
}

/// `rotm2axang(R)`: what a call is given says nothing of what it makes.
fn without_arguments(key: &str) -> &str {
    match key.split_once('(') {
        Some((name, _)) if name.ends_with(is_of_name) => name,
        _ => key,
    }
}

/// `ZYX rotvec`, `intrinsic rpy`: each word says something else of the numbers.
fn has_two_descriptions(words: &[String]) -> bool {
    let is = |names: &[&str]| words.iter().any(|word| names.contains(&word.as_str()));
    let is_sequence =
        |word: &String| word != "xyz" && word.len() == 3 && word.parse::<EulerSequence>().is_ok();
    let tells_sequence = words.iter().any(is_sequence);
    let is_named = is(&["rpy", "ypr", "rotvec", "rvec", "axisangle"]);
    let is_framed = is(&["intrinsic", "extrinsic"]);
    // `rpy axis=…`
    let is_axis = is(&["axis", "angle"]) && is(&["rpy", "ypr", "rotvec", "rvec"]);
    is_named && (tells_sequence || is_framed) || is_axis
}

/// Whether a call may make something else of its numbers: a verb that is not known, as in `flip(…)`.
pub(crate) fn may_compute(key: &str) -> bool {
    let name = key.rsplit([' ', '\t', '=']).next().unwrap_or(key);
    let last = name.rsplit(['.', ':']).next().unwrap_or(name);
    let role = Meaning::role_in(last);
    let is_known = !matches!(call(name), Call::Other)
        || !matches!(role, None | Some(Role::Derived))
        || is_matrix(last)
        || is_holder(last);
    last.starts_with(|first: char| first.is_ascii_lowercase()) && !is_known
}
