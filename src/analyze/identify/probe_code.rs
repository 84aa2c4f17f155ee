//! Probes as lines of code to paste, with names that stand for the library's own.

use crate::contract::probe::Probe;
use crate::library::Language;
use crate::problem::is_too_long;
use crate::text::is_decimal;

/// How a language writes what a probe does. `{n}` stands for four numbers, `{r1}` to `{r3}` for the
/// rows of a matrix, `{q}`, `{a}`, `{b}`, `{v}`, `{m}` for values and `{e}` for what is printed.
struct Idiom {
    quaternion: &'static str,
    vector: &'static str,
    matrix: &'static str,
    product: &'static str,
    rotate: &'static str,
    matrix_of: &'static str,
    from_matrix: &'static str,
    perturb: &'static str,
    print: &'static str,
    comment: &'static str,
}

const PYTHON: Idiom = Idiom {
    quaternion: "Quaternion({n})",
    vector: "[{n}]",
    matrix: "[[{r1}], [{r2}], [{r3}]]",
    product: "{a} * {b}",
    rotate: "{q}.rotate({v})",
    matrix_of: "{q}.to_matrix()",
    from_matrix: "Quaternion.from_matrix({m})",
    perturb: "{q}.plus({v})",
    print: "print({e})",
    comment: "#",
};

const CPP: Idiom = Idiom {
    quaternion: "Quaternion({n})",
    vector: "Vector3({n})",
    matrix: "Matrix3({r1}, {r2}, {r3})",
    product: "{a} * {b}",
    rotate: "{q} * {v}",
    matrix_of: "{q}.toRotationMatrix()",
    from_matrix: "Quaternion({m})",
    perturb: "{q}.plus({v})",
    print: "std::cout << ({e}) << std::endl;",
    comment: "//",
};

const C: Idiom = Idiom {
    quaternion: "quaternion({n})",
    vector: "vector({n})",
    matrix: "matrix({r1}, {r2}, {r3})",
    product: "multiply({a}, {b})",
    rotate: "rotate({q}, {v})",
    matrix_of: "matrix_of({q})",
    from_matrix: "quaternion_of({m})",
    perturb: "plus({q}, {v})",
    print: "print({e});",
    comment: "//",
};

const CSHARP: Idiom = Idiom {
    quaternion: "new Quaternion({n})",
    vector: "new Vector3({n})",
    matrix: "new Matrix3({r1}, {r2}, {r3})",
    product: "{a} * {b}",
    rotate: "{q} * {v}",
    matrix_of: "{q}.ToMatrix()",
    from_matrix: "Quaternion.FromMatrix({m})",
    perturb: "{q}.Plus({v})",
    print: "Console.WriteLine({e});",
    comment: "//",
};

const JAVA: Idiom = Idiom {
    quaternion: "new Quaternion({n})",
    vector: "new Vector3({n})",
    matrix: "new double[][] {{{r1}}, {{r2}}, {{r3}}}",
    product: "{a}.multiply({b})",
    rotate: "{q}.rotate({v})",
    matrix_of: "{q}.toMatrix()",
    from_matrix: "Quaternion.fromMatrix({m})",
    perturb: "{q}.plus({v})",
    print: "System.out.println({e});",
    comment: "//",
};

const JAVASCRIPT: Idiom = Idiom {
    quaternion: "new Quaternion({n})",
    vector: "[{n}]",
    matrix: "[[{r1}], [{r2}], [{r3}]]",
    product: "{a}.multiply({b})",
    rotate: "{q}.rotate({v})",
    matrix_of: "{q}.toMatrix()",
    from_matrix: "Quaternion.fromMatrix({m})",
    perturb: "{q}.plus({v})",
    print: "console.log({e});",
    comment: "//",
};

const MATLAB: Idiom = Idiom {
    quaternion: "[{n}]",
    vector: "[{n}]",
    matrix: "[{r1}; {r2}; {r3}]",
    product: "quatmultiply({a}, {b})",
    rotate: "quatrotate({q}, {v})",
    matrix_of: "quat2dcm({q})",
    from_matrix: "dcm2quat({m})",
    perturb: "plus({q}, {v})",
    print: "disp({e})",
    comment: "%",
};

const RUST: Idiom = Idiom {
    quaternion: "Quaternion::new({n})",
    vector: "Vector3::new({n})",
    matrix: "Matrix3::new({r1}, {r2}, {r3})",
    product: "{a} * {b}",
    rotate: "{q} * {v}",
    matrix_of: "{q}.to_rotation_matrix()",
    from_matrix: "Quaternion::from_matrix(&{m})",
    perturb: "{q}.plus({v})",
    print: "println!(\"{:?}\", {e});",
    comment: "//",
};

const SWIFT: Idiom = Idiom {
    quaternion: "Quaternion({n})",
    vector: "Vector3({n})",
    matrix: "Matrix3([[{r1}], [{r2}], [{r3}]])",
    product: "{a} * {b}",
    rotate: "{q}.act({v})",
    matrix_of: "{q}.matrix",
    from_matrix: "Quaternion({m})",
    perturb: "{q}.plus({v})",
    print: "print({e})",
    comment: "//",
};

/// What is done to the body before its quaternion is printed.
const TURN: &str = "turn the body by +90 degrees about the vertical z axis of the world";

/// The probe in a language: what goes in, what is called, printed; `None` where what goes in is not
/// written as plain numbers.
pub(crate) fn code(probe: &Probe, language: Language) -> Option<String> {
    let idiom = match language {
        // A message has no calls; Python is what most of its tools are written in.
        Language::Python | Language::Message => &PYTHON,
        Language::C => &C,
        Language::Cpp => &CPP,
        Language::Csharp => &CSHARP,
        Language::Java => &JAVA,
        Language::Javascript => &JAVASCRIPT,
        Language::Matlab => &MATLAB,
        Language::Rust => &RUST,
        Language::Swift => &SWIFT,
    };
    let list = |text: &str, count: usize| {
        if is_too_long(text) {
            return None;
        }
        let separators = |c: char| c.is_whitespace() || ",;[](){}".contains(c);
        let mut written = Vec::new();
        for number in text.split(separators).filter(|part| !part.is_empty()) {
            if written.len() == count || !is_decimal(number) {
                return None;
            }
            written.push(match language {
                Language::Rust if !number.contains('.') => format!("{number}.0"),
                _ => number.to_owned(),
            });
        }
        (written.len() == count).then_some(written)
    };
    let quaternion = |text: &str| Some(idiom.quaternion.replace("{n}", &list(text, 4)?.join(", ")));
    let vector = |text: &str| Some(idiom.vector.replace("{n}", &list(text, 3)?.join(", ")));
    let matrix = |text: &str| {
        let numbers = list(text, 9)?;
        let mut rows = idiom.matrix.to_owned();
        for (place, row) in ["{r1}", "{r2}", "{r3}"].iter().zip(numbers.chunks(3)) {
            rows = rows.replace(place, &row.join(", "));
        }
        Some(rows)
    };
    let expression = match probe {
        Probe::Components { quaternion: q, .. } => quaternion(q)?,
        Probe::Product { a, b, .. } => idiom
            .product
            .replace("{a}", &quaternion(a)?)
            .replace("{b}", &quaternion(b)?),
        Probe::Rotate {
            quaternion: q,
            vector: v,
            ..
        } => idiom
            .rotate
            .replace("{q}", &quaternion(q)?)
            .replace("{v}", &vector(v)?),
        Probe::Matrix { quaternion: q, .. } => idiom.matrix_of.replace("{q}", &quaternion(q)?),
        Probe::FromMatrix { matrix: m, .. } => idiom.from_matrix.replace("{m}", &matrix(m)?),
        Probe::QuarterTurn { .. } => {
            let print = idiom.print.replace("{e}", "body.orientation");
            return Some(format!("{} {TURN}, then:\n{print}", idiom.comment));
        }
        Probe::Perturb {
            quaternion: q,
            rotation_vector: v,
            ..
        } => idiom
            .perturb
            .replace("{q}", &quaternion(q)?)
            .replace("{v}", &vector(v)?),
    };
    Some(idiom.print.replace("{e}", &expression))
}
