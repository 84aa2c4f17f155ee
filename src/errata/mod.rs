//! Errata of the documents that this project follows: what is printed, why it does not hold, what
//! does, and a number that shows it.
//!
//! No result is written down: every [`Witness`] evaluates both sides of the printed and of the
//! corrected statement for one example, the corrected ones by the functions of this crate. The 27 are
//! those of the specification (section 4.1); statements that need a reading or a guard (4.2 and 4.3)
//! are not among them.

// Those of Cheng 2018.
mod cheng;

// Those of the field guide.
mod field_guide;

// Those of the lecture.
mod lecture;

// The two sides of a statement.
mod witness;

// Those of Yoosefian 2021.
mod yoosefian;

use crate::convention::matrix::CosineMatrix::{Hamilton, Shuster};
use crate::convention::names;
use serde::Serialize;
use strum::VariantArray;

pub use crate::errata::witness::{Sides, Witness};

/// One of the documents that equations are cited from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, VariantArray)]
#[serde(rename_all = "kebab-case")]
pub enum SourceDocument {
    /// *Cheng 2018*.
    Cheng2018,
    /// *Yoosefian 2021*.
    Yoosefian2021,
    /// The lecture *ME 495*.
    Me495Lecture,
    /// The *field guide*.
    FieldGuide,
}

impl SourceDocument {
    /// All four, in the order of their errata.
    pub const ALL: [Self; 4] = names::all(VariantArray::VARIANTS);

    /// Author, title, origin and year, as far as the document tells them.
    #[must_use]
    pub const fn citation(self) -> &'static str {
        match self {
            Self::Cheng2018 => {
                "H. Cheng, “Standardised Use of Quaternion for SO(3) Representation” (draft), \
                 National University of Singapore, 2018"
            }
            Self::Yoosefian2021 => {
                "M. H. Yoosefian Nooshabadi, “A Concise Note on Coordinate Frames Transformation and \
                 Quaternion Conventions”, 27 December 2021"
            }
            Self::Me495Lecture => {
                "J. Schultz, “Quaternions and More Geometry”, lecture of the course ME 495: Embedded \
                 Systems in Robotics"
            }
            Self::FieldGuide => "“Implementing Rotations: A Robotics Field Guide”",
        }
    }
}

/// A statement that does not hold as it is printed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Erratum {
    /// 4 for E4.
    pub number: u8,
    /// The specification's name of the statement.
    pub id: &'static str,
    /// Where it is printed ...
    pub document: SourceDocument,
    /// ... and where in it.
    pub place: &'static str,
    /// The statement as it is printed, as one line of text; *in words* where it is no formula.
    pub printed: &'static str,
    /// Why it does not hold, in one sentence.
    pub reason: &'static str,
    /// The statement that holds.
    pub correct: &'static str,
    /// Both statements in numbers.
    pub witness: Witness,
}

/// How far apart the sides of a corrected statement may be: eight roundings of numbers near 1.
pub const CORRECTED_TOLERANCE: f64 = 4.0 * f64::EPSILON;

/// All errata, in the order of their numbers.
///
/// ```
/// use quatlas::errata::{CORRECTED_TOLERANCE, errata};
/// // Cheng 2018, eq. 2.16: without its factor 2 the matrix is wrong by w² on the diagonal.
/// let [_, _, _, matrix, ..] = errata();
/// assert_eq!(matrix.place, "eq. 2.16");
/// assert!((matrix.witness.printed_error - 0.8 * 0.8).abs() < CORRECTED_TOLERANCE);
/// assert!(matrix.witness.corrected_error < CORRECTED_TOLERANCE);
/// ```
#[must_use]
pub fn errata() -> [Erratum; 27] {
    [
        Erratum {
            number: 1,
            id: "000-S2.2.J",
            document: SourceDocument::Cheng2018,
            place: "section 2.2 and the tag of eq. 2.3",
            printed: "ji = −ji = k",
            reason: "The same product stands with both signs, so that k would be −k.",
            correct: "ji = −ij = k",
            witness: cheng::product_of_j_and_i(),
        },
        Erratum {
            number: 2,
            id: "000-2.6",
            document: SourceDocument::Cheng2018,
            place: "eq. 2.6",
            printed: "q* = q_w − q_v = [q_w ; q_v]",
            reason: "The column is q itself for want of a minus sign, and q ∘ q is not a number.",
            correct: "q* = [q_w ; −q_v]",
            witness: cheng::conjugate(),
        },
        Erratum {
            number: 3,
            id: "000-S2.3.p",
            document: SourceDocument::Cheng2018,
            place: "section 2.3, after eq. 2.12",
            printed: "q(φ + 2πk) = q(φ) for every integer k (in words)",
            reason: "The components are those of half the angle: a full turn leads to −q, which is \
                     the same rotation, and only two turns lead back to q.",
            correct: "q(φ + 2πk) = (−1)ᵏ q(φ)",
            witness: cheng::period(),
        },
        Erratum {
            number: 4,
            id: "000-2.16",
            document: SourceDocument::Cheng2018,
            place: "eq. 2.16",
            printed: "R(q) = (q_w² − 1) I + 2 q_v q_vᵀ + 2 q_w [q_v]×",
            reason: "The square lacks its factor 2, which leaves R(q) − q_w² I: no rotation.",
            correct: "R(q) = (2 q_w² − 1) I + 2 q_v q_vᵀ + 2 q_w [q_v]× for |q| = 1",
            witness: cheng::cosine_matrix(Hamilton),
        },
        Erratum {
            number: 5,
            id: "000-2.17",
            document: SourceDocument::Cheng2018,
            place: "eq. 2.17",
            printed: "C(q) = (q_w² − 1) I + 2 q_v q_vᵀ − 2 q_w [q_v]×",
            reason: "The square lacks its factor 2, as in eq. 2.16.",
            correct: "C(q) = (2 q_w² − 1) I + 2 q_v q_vᵀ − 2 q_w [q_v]× for |q| = 1",
            witness: cheng::cosine_matrix(Shuster),
        },
        Erratum {
            number: 6,
            id: "000-2.40",
            document: SourceDocument::Cheng2018,
            place: "eq. 2.40",
            printed: "C(q_w^i) = C(q_i^î) C(q_w^î), q_w^i = q_i^î ⊗ q_w^î",
            reason: "From w by way of î to i (eqs. 2.25 and 2.26) the last step is q_î^i; its inverse \
                     doubles the error instead of removing it.",
            correct: "C(q_w^i) = C(q_î^i) C(q_w^î), q_w^i = q_î^i ⊗ q_w^î",
            witness: cheng::jpl_error_chain(),
        },
        Erratum {
            number: 7,
            id: "000-2.41",
            document: SourceDocument::Cheng2018,
            place: "eq. 2.41",
            printed: "R(q_w^i) = R(q_w^î) R(q_i^î), q_w^i = q_w^î ⊙ q_i^î",
            reason: "The frames of the error are exchanged as in eq. 2.40 (here eqs. 2.23 and 2.24 \
                     are the rule).",
            correct: "R(q_w^i) = R(q_w^î) R(q_î^i), q_w^i = q_w^î ⊙ q_î^i",
            witness: cheng::hamilton_error_chain(),
        },
        Erratum {
            number: 8,
            id: "000-2.41n",
            document: SourceDocument::Cheng2018,
            place: "section 2.7, last sentence",
            printed: "δq = q_i^î",
            reason: "By eq. 2.28 δq is q̂* ⊙ q, and this is the inverse of what is printed.",
            correct: "δq = q_î^i",
            witness: cheng::error_quaternion(),
        },
        Erratum {
            number: 9,
            id: "000-B",
            document: SourceDocument::Cheng2018,
            place: "appendix B, listing",
            printed: "R(1,2) = tyz − twz, R(2,0) = txz − twz, R(2,1) = tyz + twz",
            reason: "Three entries take the product of w with z where those with x, y and x belong, \
                     so that the matrix is no rotation.",
            correct: "R(1,2) = tyz − twx, R(2,0) = txz − twy, R(2,1) = tyz + twx",
            witness: cheng::appendix_b(),
        },
        Erratum {
            number: 10,
            id: "002-S2.4",
            document: SourceDocument::Yoosefian2021,
            place: "section 2, path from G by I₁, C₁ and C₂ to I₂",
            printed: "ᴳp_I2 = ᴳp_I1 + ᴳR_I1 ᴵp_C + ᴳR_C1 ᶜ¹p_C2 − ᴳR_C2 ᴵp_C",
            reason: "In the last term a matrix that takes coordinates in C is given some in I.",
            correct: "ᴳp_I2 = ᴳp_I1 + ᴳR_I1 ᴵp_C + ᴳR_C1 ᶜ¹p_C2 − ᴳR_I2 ᴵp_C with \
                      ᴳR_I2 = ᴳR_C2 (ᴵR_C)⁻¹",
            witness: yoosefian::camera_path(),
        },
        Erratum {
            number: 11,
            id: "002-9",
            document: SourceDocument::Yoosefian2021,
            place: "eq. 9",
            printed: "Ω(ω) q = q ⊗ [ω ; 0]",
            reason: "The product and the place of the scalar are JPL's, while the matrix of eq. 10 \
                     and all around it are Hamilton's.",
            correct: "Ω(ω) q = q ⊙ [0 ; ω]",
            witness: yoosefian::rate_product(),
        },
        Erratum {
            number: 12,
            id: "003-S2.1.c",
            document: SourceDocument::Me495Lecture,
            place: "section 2.1",
            printed: "each column of R has length 1 ⇒ det R = ±1",
            reason: "Columns of length 1 may lie in a plane or on a line; that they are also \
                     perpendicular is what makes the determinant.",
            correct: "RᵀR = I ⇒ det R = ±1",
            witness: lecture::determinant(),
        },
        Erratum {
            number: 13,
            id: "003-S4.d",
            document: SourceDocument::Me495Lecture,
            place: "section 4, products of the units",
            printed: "k·i = −k·i = j",
            reason: "The factors of the second product are not exchanged, so that j would be −j.",
            correct: "k·i = −i·k = j",
            witness: lecture::product_of_k_and_i(),
        },
        Erratum {
            number: 14,
            id: "003-S4.2.c",
            document: SourceDocument::Me495Lecture,
            place: "section 4.2, before the display of p′",
            printed: "p′ = R(θ) p for the components of p in a frame turned by θ",
            reason: "R(θ) turns the vector; when the frame turns, the components turn the other way.",
            correct: "p′ = R(θ)ᵀ p in the turned frame; p′ = R(θ) p for the turned vector",
            witness: lecture::turned_frame(),
        },
        Erratum {
            number: 15,
            id: "003-S4.2.f",
            document: SourceDocument::Me495Lecture,
            place: "section 4.2, why there are two factors",
            printed: "Q·P is P turned and stretched, and ·Q⁻¹ undoes the stretching (in words)",
            reason: "A product with a unit quaternion keeps all lengths; Q·P leaves the vectors for \
                     the scalar −q·p, which the second factor takes back.",
            correct: "|Q·P| = |P|; Q·P and P·Q⁻¹ both turn the part of p across the axis by θ/2, and \
                      their effects on the part along it cancel",
            witness: lecture::one_sided_product(),
        },
        Erratum {
            number: 16,
            id: "003-S4.2.i",
            document: SourceDocument::Me495Lecture,
            place: "section 4.2",
            printed: "(q₀, q) = (−q₀, −q)",
            reason: "Only zero is its own opposite; what is equal are the rotations.",
            correct: "R(Q) = R(−Q)",
            witness: lecture::two_quaternions(),
        },
        Erratum {
            number: 17,
            id: "003-S5.1.1.b",
            document: SourceDocument::Me495Lecture,
            place: "section 5.1.1",
            printed: "z_ab = [0 0 0]ᵀ",
            reason: "An axis has length 1, as in the matrix that is printed next.",
            correct: "z_ab = [0 0 1]ᵀ",
            witness: lecture::third_axis(),
        },
        Erratum {
            number: 18,
            id: "003-S5.1.3.b",
            document: SourceDocument::Me495Lecture,
            place: "section 5.1.3",
            printed: "P_b = Q_ab P_a Q_ab⁻¹ = (0; 1, 0, 0)",
            reason: "This product turns p_a on by 45°; coordinates in the turned frame need the \
                     inverse, which is what the listing in section 5.2 really uses.",
            correct: "P_b = Q_ab⁻¹ P_a Q_ab = (0; 1, 0, 0), while Q_ab P_a Q_ab⁻¹ = (0; 0, 1, 0)",
            witness: lecture::change_of_frame(),
        },
        Erratum {
            number: 19,
            id: "003-S5.2.3",
            document: SourceDocument::Me495Lecture,
            place: "section 5.2, listing: test of a rotation matrix",
            printed: "max(RᵀR − I) < 10⁻¹² and det R − 1 < 10⁻¹²",
            reason: "Without absolute values everything that is too small passes, zero included.",
            correct: "max |RᵀR − I| < tolerance and |det R − 1| < tolerance",
            witness: lecture::acceptance(),
        },
        Erratum {
            number: 20,
            id: "003-S5.2.9",
            document: SourceDocument::Me495Lecture,
            place: "section 5.2, listing: rotation matrix to axis and angle",
            printed: "θ = arccos((tr R − 1)/2), w = (r₃₂ − r₂₃, r₁₃ − r₃₁, r₂₁ − r₁₂)/(2 sin θ); not \
                      finite ⇒ θ = 0",
            reason: "At half a turn the axis is nothing divided by a rounding error, and the guard \
                     either lets it pass or returns no turn.",
            correct: "matrix to quaternion by its largest component, then \
                      θ w = 2 atan2(|q_v|, q_w) q_v/|q_v|",
            witness: lecture::half_turn(),
        },
        Erratum {
            number: 21,
            id: "004-T1n",
            document: SourceDocument::FieldGuide,
            place: "table 1, footnote",
            printed: "3³ = 27 orderings of Euler angles, of which many are redundant (in words)",
            reason: "In 15 of the strings an axis follows itself, so that they reach only a curve or \
                     a surface of attitudes and none of them is an ordering.",
            correct: "12 sequences, 24 with moving and fixed axes",
            witness: field_guide::euler_sequences(),
        },
        Erratum {
            number: 22,
            id: "004-D.2",
            document: SourceDocument::FieldGuide,
            place: "notions of distance",
            printed: "symmetry: dist(a, b) ≥ dist(b, a)",
            reason: "For one order of a and b it lets the way back be shorter, and only demanded of \
                     both orders does it mean that the two are equal.",
            correct: "dist(a, b) = dist(b, a)",
            witness: field_guide::symmetry(),
        },
        Erratum {
            number: 23,
            id: "004-EU.6",
            document: SourceDocument::FieldGuide,
            place: "Euler angles, intrinsic and extrinsic",
            printed: "R₂¹ = (R₁⁰)⁻¹ R₂⁰ R₁⁰, R₂⁰ = R₁⁰ R₂¹ = R₂⁰ R₁⁰",
            reason: "R₂⁰ is the whole rotation on the left and only the second one on the right; if \
                     it were one matrix, R₁⁰ would be I.",
            correct: "A then Q about fixed axes: A (A⁻¹ Q A) = Q A, where A⁻¹ Q A is Q about the moved \
                      axes",
            witness: field_guide::similarity(),
        },
        Erratum {
            number: 24,
            id: "004-RO.13",
            document: SourceDocument::FieldGuide,
            place: "Rodrigues, strengths",
            printed: "rotation vectors are the Lie group SO(3) (in words)",
            reason: "They are its Lie algebra: their sum is not the composition, and many of them \
                     give one rotation.",
            correct: "rotation vectors are coordinates of so(3), which Exp maps onto SO(3)",
            witness: field_guide::rotation_vectors(),
        },
        Erratum {
            number: 25,
            id: "004-Q.1",
            document: SourceDocument::FieldGuide,
            place: "quaternions to rotation matrix, body to world",
            printed: "C_H = (q_w² − 1) I + 2 q_w [q_v]× + 2 q_v q_vᵀ",
            reason: "The square lacks its factor 2, so that the elements printed beside it differ.",
            correct: "C_H = (2 q_w² − 1) I + 2 q_w [q_v]× + 2 q_v q_vᵀ",
            witness: cheng::cosine_matrix(Hamilton),
        },
        Erratum {
            number: 26,
            id: "004-Q.3",
            document: SourceDocument::FieldGuide,
            place: "quaternions to rotation matrix, world to body, active",
            printed: "C_S = (q_w² − 1) I − 2 q_w [q_v]× + 2 q_v q_vᵀ",
            reason: "The square lacks its factor 2, so that the elements printed beside it differ.",
            correct: "C_S = (2 q_w² − 1) I − 2 q_w [q_v]× + 2 q_v q_vᵀ",
            witness: cheng::cosine_matrix(Shuster),
        },
        Erratum {
            number: 27,
            id: "004-Q.23",
            document: SourceDocument::FieldGuide,
            place: "quaternions, strengths",
            printed: "a minimal representation without singularities (in words)",
            reason: "A rotation has three degrees of freedom and a quaternion four numbers; the guide \
                     itself says that three numbers are never without singularities.",
            correct: "four numbers with one constraint, without singularities",
            witness: field_guide::minimality(),
        },
    ]
}
