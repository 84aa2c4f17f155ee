//! The build script: the table of libraries as Rust, so that no program reads JSON for it.
//!
//! What is wrong in a record stops the build.

use serde::Deserialize;
use serde_json::Value;
use std::path::Path;
use std::{env, fs, io};

#[expect(unreachable_pub, reason = "it is a part of the crate, too")]
#[path = "choices.rs"]
mod choices;

use choices::{
    AxisAngleSign, Group, HalfTurns, Known, Language, NonUnitResult, RecordKind, RecordNumbersKind,
    SignChoice, SlerpWay, VectorLayout, ZeroResult,
};

const JSON: &str = "src/library/libraries.json";

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed={JSON}");
    let folder = env::var_os("OUT_DIR").unwrap_or_default();
    match in_rust(&fs::read_to_string(JSON)?) {
        Ok(table) => fs::write(Path::new(&folder).join("libraries.rs"), table)?,
        Err(sentence) => println!("cargo::error={JSON}: {sentence}"),
    }
    Ok(())
}

/// The table as a reference to an array of records.
///
/// # Errors
///
/// What is wrong, after the id of the record and the path to the member: `"eigen".zero.matrix: …`.
pub(crate) fn in_rust(json: &str) -> Result<String, String> {
    let records: Vec<Value> = serde_json::from_str(json).map_err(|error| error.to_string())?;
    let mut reader = serde_json::Deserializer::from_str(json);
    let libraries: Result<Vec<Library>, _> = serde_path_to_error::deserialize(&mut reader);
    libraries.map(|all| all.in_rust()).map_err(|error| {
        let path = error.path().to_string();
        let named = records.iter().enumerate().find_map(|(at, record)| {
            let member = path.strip_prefix(&format!("[{at}]"))?;
            Some(format!("{}{member}", record["id"]))
        });
        format!("{}: {}", named.unwrap_or(path), error.inner())
    })
}

/// A value as an expression of Rust.
trait InRust {
    fn in_rust(&self) -> String;
}

impl InRust for String {
    fn in_rust(&self) -> String {
        format!("{self:?}")
    }
}

impl<Inner: InRust> InRust for Option<Inner> {
    fn in_rust(&self) -> String {
        match self {
            None => "None".to_owned(),
            Some(value) => format!("Some({})", value.in_rust()),
        }
    }
}

impl<Inner: InRust> InRust for Box<Inner> {
    fn in_rust(&self) -> String {
        format!("&{}", (**self).in_rust())
    }
}

impl<Inner: InRust> InRust for Vec<Inner> {
    fn in_rust(&self) -> String {
        let values: Vec<String> = self.iter().map(InRust::in_rust).collect();
        format!("&[{}]", values.join(", "))
    }
}

macro_rules! choices {
    ($($Choice:ident),* $(,)?) => {
        $(impl InRust for $Choice {
            fn in_rust(&self) -> String {
                format!("{}::{self:?}", stringify!($Choice))
            }
        })*
    };
}

choices!(
    AngleUnit,
    ComponentOrder,
    Handedness,
    CosineMatrix,
    Direction,
    AxisAngleSign,
    Group,
    HalfTurns,
    RecordKind,
    Known,
    Language,
    NonUnitResult,
    RecordNumbersKind,
    SignChoice,
    SlerpWay,
    VectorLayout,
    ZeroResult,
);

// Of the room `convention`.

#[derive(Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum AngleUnit {
    Degrees,
    Radians,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum ComponentOrder {
    ScalarFirst,
    ScalarLast,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Handedness {
    Right,
    Left,
}

#[derive(Debug, Deserialize)]
enum CosineMatrix {
    #[serde(rename = "R")]
    Hamilton,
    #[serde(rename = "C")]
    Shuster,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Direction {
    BodyToWorld,
    WorldToBody,
}

/// A type of `mod.rs` with the same members, of which the compiler misses none.
macro_rules! record {
    ($(#[$of_all:meta])* $Record:ident {
        $($(#[$of_one:meta])* $member:ident: $Kind:ty,)*
    }) => {
        #[derive(Deserialize)]
        #[serde(rename_all = "camelCase", deny_unknown_fields)]
        $(#[$of_all])*
        struct $Record {
            $($(#[$of_one])* $member: $Kind,)*
        }

        impl InRust for $Record {
            fn in_rust(&self) -> String {
                let members = [$(format!("{}: {}", stringify!($member), self.$member.in_rust())),*];
                format!("{} {{ {} }}", stringify!($Record), members.join(", "))
            }
        }
    };
}

record!(Library {
    id: String,
    name: String,
    #[serde(default)]
    words: Vec<String>,
    kind: Option<RecordKind>,
    group: Group,
    language: Language,
    version: String,
    known: Known,
    array_order: Option<ComponentOrder>,
    printed_order: Option<ComponentOrder>,
    numbers: Option<Box<RecordNumbers>>,
    constructor_order: Option<ComponentOrder>,
    handedness: Option<Handedness>,
    rotate: Option<CosineMatrix>,
    matrix: Option<CosineMatrix>,
    vectors: Option<VectorLayout>,
    direction: Option<Direction>,
    axes: Option<String>,
    #[serde(default)]
    euler: Vec<EulerCall>,
    axis_angle: Option<AxisAngleSign>,
    #[serde(default)]
    non_unit: NonUnit,
    #[serde(default)]
    zero: Zero,
    matrix_to_quaternion: Option<MatrixToQuaternion>,
    slerp: Option<SlerpWay>,
    #[serde(default)]
    code: Code,
    #[serde(default)]
    pasted: Vec<String>,
    calls: Option<String>,
    source: Option<Source>,
    note: Option<String>,
    doubt: Option<String>,
});

record!(RecordNumbers {
    kind: RecordNumbersKind,
    names: Option<String>,
    means: Option<String>,
    unit: Option<AngleUnit>,
});

record!(EulerCall {
    call: String,
    means: String,
});

record!(
    #[derive(Default)]
    NonUnit {
        construct: Option<NonUnitResult>,
        matrix: Option<NonUnitResult>,
        rotate: Option<NonUnitResult>,
    }
);

record!(
    #[derive(Default)]
    Zero {
        construct: Option<ZeroResult>,
        matrix: Option<ZeroResult>,
        rotate: Option<ZeroResult>,
        normalize: Option<ZeroResult>,
        inverse: Option<ZeroResult>,
    }
);

record!(MatrixToQuaternion {
    sign: SignChoice,
    half_turns: HalfTurns,
});

record!(
    #[derive(Default)]
    Code {
        construct: Option<String>,
        rotate: Option<String>,
        matrix: Option<String>,
        product: Option<String>,
        from_matrix: Option<String>,
        print: Option<String>,
    }
);

record!(Source {
    text: String,
    url: Option<String>,
});
