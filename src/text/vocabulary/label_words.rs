//! The lists of the words of labels, and what each may say.

use crate::convention::angle::AngleUnit;
use crate::convention::order::ComponentOrder;
use crate::convention::{Direction, Handedness};

/// What a word of a label, or a few of them together, say of the numbers under it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LabelWord {
    /// `xyzw`, `scalar_last`
    Order(ComponentOrder),
    /// `zyxw`: an order of components that none of the two is.
    OtherOrder,
    /// `hamilton`, `jpl`: by the product, which tells the two.
    Handedness(Handedness),
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
    /// `elements`: what three.js calls the numbers of a matrix, column by column.
    Elements,
    /// `deg`, `radians`
    Unit(AngleUnit),
    /// `position`, `rgba`: something else than a rotation, in words.
    Quantity(&'static str),
    /// `orientation`, `quat`: a rotation, whatever else is named.
    Rotation,
}

impl LabelWord {
    /// What it names, for a sentence.
    pub(crate) const fn in_words(self) -> &'static str {
        match self {
            Self::Derived(made) => made.in_words(),
            Self::Quantity(what) => what,
            Self::LeftHanded => "left-handed axes",
            Self::OtherOrder => "another order of components",
            Self::Handedness(Handedness::Left) => "JPL",
            Self::Handedness(Handedness::Right) => "Hamilton",
            Self::Direction(Direction::BodyToWorld) => "body to world",
            Self::Direction(Direction::WorldToBody) => "world to body",
            Self::Columns | Self::Elements => "columns",
            Self::Rows => "rows",
            Self::Order(_) | Self::Unit(_) => "an order or a unit",
            Self::Rotation => "a rotation",
        }
    }
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
    /// A logarithm, a square root.
    Function,
    /// Several of them, each in three numbers.
    Several,
    /// An error, what is left between two.
    Difference,
    /// A dual quaternion, which moves too.
    Dual,
}

impl Derived {
    const fn in_words(self) -> &'static str {
        match self {
            Self::Inverse => "an inverse",
            Self::Conjugate => "a conjugate",
            Self::Transposed => "a transpose",
            Self::Negative => "a negative",
            Self::Rate => "a rate or a derivative",
            Self::Spread => "a variance, a noise or a bias",
            Self::Function => "a logarithm or a root",
            Self::Several => "several rotations",
            Self::Difference => "an error or a difference",
            Self::Dual => "a dual quaternion",
        }
    }
}

/// Words in small letters, separated by spaces, and what each of them says; words that say it only together
/// stand without what is between them: `scalarlast`.
pub(super) const WORDS: &[(&str, LabelWord)] = &[
    (
        "scalarfirst realfirst wfirst",
        LabelWord::Order(ComponentOrder::ScalarFirst),
    ),
    (
        "scalarlast reallast wlast",
        LabelWord::Order(ComponentOrder::ScalarLast),
    ),
    (
        "hamilton hamiltonian",
        LabelWord::Handedness(Handedness::Right),
    ),
    ("jpl shuster", LabelWord::Handedness(Handedness::Left)),
    (
        "lefthanded lefthand lhs lefthandedness leftcoordinates clockwise",
        LabelWord::LeftHanded,
    ),
    // What leads to the camera.
    (
        "viewmatrix viewmat",
        LabelWord::Direction(Direction::WorldToBody),
    ),
    (
        "inv inverse inverted minus1",
        LabelWord::Derived(Derived::Inverse),
    ),
    (
        "conj conjugate conjugated",
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
        "dot ddot deriv derivative omegaq qomega omegaquat rate rates vel velocity velocities speed speeds acceleration \
         accelerations persecond persec gradient grad jacobian hessian",
        LabelWord::Derived(Derived::Rate),
    ),
    (
        "cov covar covariance var variance std stddev stdev sigma sigmas noise bias biases",
        LabelWord::Derived(Derived::Spread),
    ),
    (
        "logq logquat qlog quatlog lnq sqrtq sqrtquat qsqrt quatsqrt logr logrotation sqrtr",
        LabelWord::Derived(Derived::Function),
    ),
    (
        "qerr qerror errq errorq quaterror quaternionerror errorquaternion attitudeerror rotationerror orientationerror \
         residualrotation rotationresidual residualquaternion driftquaternion qdiff qdelta deltaq deltaquat deltaquaternion",
        LabelWord::Derived(Derived::Difference),
    ),
    ("dualquaternion dualquat", LabelWord::Derived(Derived::Dual)),
    (
        "rvecs rotvecs eulers rpys",
        LabelWord::Derived(Derived::Several),
    ),
    (
        "columnmajor colmajor columns cols columnwise colwise",
        LabelWord::Columns,
    ),
    ("rowmajor rows rowwise", LabelWord::Rows),
    ("elements", LabelWord::Elements),
    (
        "rotation rotations rot orientation orientations attitude quaternion quaternions quat quats q \
         rpy ypr euler rotvec rvec rodrigues mrp gibbs dcm heading modelview",
        LabelWord::Rotation,
    ),
    // The attitude of Basilisk.
    (
        "sigmabn",
        LabelWord::Quantity("three modified Rodrigues parameters"),
    ),
    (
        "rgb rgba rgbw bgr bgra argb hsv hsl color colors colour colours albedo tint diffuse specular \
         emissive emission",
        LabelWord::Quantity("a colour"),
    ),
    (
        "position positions pos translation translations trans tvec location locations point points \
         coord coords coordinate coordinates displacement displacements offset offsets centroid center \
         centre waypoint waypoints vertex vertices landmark landmarks pivot eye lookat",
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
        "stress strain metric iron cell triangle triangles confusion adjacency permutation stiffness correlation affinity similarity",
        LabelWord::Quantity("another matrix"),
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
pub(super) const WORLDS: &str =
    "world w global g inertial i nav navigation n map earth ecef eci ned enu odom ground";
pub(super) const BODIES: &str =
    "body b local sensor imu i camera cam c device vehicle child robot drone tool rig";

/// What stands behind the name of a quaternion for its conjugate: `q_star`, `qbar`. Alone it is a star tracker.
pub(super) const CONJUGATING: [&str; 2] = ["star", "bar"];

/// What a name says of a rotation before its word for what was made of it: `qdot`, `Rinv`, `invR`.
pub(super) const STEMS: [&str; 6] = ["quat", "rot", "mat", "dcm", "q", "r"];
