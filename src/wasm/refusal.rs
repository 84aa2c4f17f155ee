//! What is thrown where a caller breaks the types of a request.

use js_sys::TypeError;
use wasm_bindgen::prelude::*;

/// A value of its type, or what is thrown instead.
pub(crate) type Typed<Kind> = Result<Kind, JsValue>;

pub(crate) fn too_long_together() -> JsValue {
    refused("all its texts together are too long")
}

/// `path` is empty for the request itself.
pub(crate) fn not_of_kind(value: &JsValue, path: &str, wanted: &str) -> JsValue {
    let kind = match value.js_typeof().as_string().unwrap_or_default() {
        _ if value.is_null() => "null".to_owned(),
        kind if kind == "undefined" && !path.is_empty() => {
            return refused(&format!("`{path}` is missing"));
        }
        kind if kind == "undefined" => kind,
        kind if kind == "object" => "an object".to_owned(),
        kind => format!("a {kind}"),
    };
    refused(&match path {
        "" => format!("it is {kind}, not {wanted}"),
        path => format!("`{path}` is {kind}, not {wanted}"),
    })
}

pub(crate) fn no_such_choice(path: &str, chosen: &str, names: &[&str]) -> JsValue {
    let names = format!("`{}`", names.join("`, `"));
    refused(&format!(
        "`{path}` cannot be `{chosen}`, but one of {names}"
    ))
}

pub(crate) fn refused(reason: &str) -> JsValue {
    TypeError::new(&format!("this is not a request: {reason}")).into()
}
