//! Lists of JavaScript, and numbers in place of a text.
//!
//! A program has numbers, and every text of a request may be a number, a list of numbers (an array or a typed
//! array), or rows of them. They are written as they would be typed and read as that, so that one reader
//! decides what numbers are, and a problem points into the text that they make: `[0.1, 0.2, 0.3, 0.4]`.

use crate::decimal::shortest;
use crate::problem::MAX_TEXT_BYTES;
use crate::wasm::refusal::{Typed, not_of_kind, refused};
use js_sys::Reflect;
use wasm_bindgen::prelude::*;

/// The most elements of a list: far more than anybody observes, few enough to answer in seconds.
const MOST_ELEMENTS: u32 = 10_000;

#[wasm_bindgen]
extern "C" {
    /// What is asked of a proxy that was revoked throws.
    #[wasm_bindgen(catch, js_namespace = Array, js_name = isArray)]
    fn is_array(value: &JsValue) -> Result<bool, JsValue>;

    #[wasm_bindgen(js_namespace = ArrayBuffer, js_name = isView)]
    fn is_view(value: &JsValue) -> bool;
}

/// A list, and how many elements of it are read. A proxy may say anything of its length.
pub(crate) struct List {
    list: JsValue,
    path: String,
    pub(crate) length: u32,
}

impl List {
    pub(crate) fn of(list: JsValue, path: String) -> Typed<Self> {
        if !is_array(&list)? {
            return Err(not_of_kind(&list, &path, "a list"));
        }
        Self::of_length(list, path)
    }

    fn of_length(list: JsValue, path: String) -> Typed<Self> {
        let told = Reflect::get(&list, &"length".into())?;
        let told = told.as_f64().unwrap_or_default();
        if !(0.0..=f64::from(MOST_ELEMENTS)).contains(&told) {
            let length = shortest(told);
            return Err(refused(&format!(
                "`{path}` has {length} elements; at most {MOST_ELEMENTS} are read"
            )));
        }
        let mut length = 0;
        while f64::from(length) < told {
            length += 1;
        }
        Ok(Self { list, path, length })
    }

    /// An element with its path.
    pub(crate) fn element(&self, at: u32) -> Typed<(String, JsValue)> {
        let path = format!("{}[{at}]", self.path);
        Ok((path, Reflect::get_u32(&self.list, at)?))
    }
}

/// The text of a number, of a list of numbers or of rows of them; nothing for what is none of these.
pub(crate) fn numbers_as_text(value: &JsValue, path: &str) -> Typed<Option<String>> {
    let mut text = String::new();
    let are_numbers = write_numbers(value, path, Inside::Text, &mut text)?;
    Ok(are_numbers.then_some(text))
}

/// How deep the numbers stand.
#[derive(Clone, Copy, PartialEq)]
enum Inside {
    Text,
    List,
    Row,
}

/// Whether it is numbers, which then stand at the end of the text. Of more than is read no more is written.
fn write_numbers(value: &JsValue, path: &str, inside: Inside, text: &mut String) -> Typed<bool> {
    if let Some(number) = value.as_f64() {
        text.push_str(&shortest(number));
        return Ok(true);
    }
    if inside == Inside::Row || !(is_view(value) || is_array(value)?) {
        return Ok(false);
    }
    let list = List::of_length(value.clone(), path.to_owned())?;
    text.push('[');
    for at in 0..list.length {
        if text.len() > MAX_TEXT_BYTES {
            break;
        }
        if at > 0 {
            text.push_str(", ");
        }
        let (path, element) = list.element(at)?;
        let deeper = match inside {
            Inside::Text => Inside::List,
            Inside::List | Inside::Row => Inside::Row,
        };
        if !write_numbers(&element, &path, deeper, text)? {
            return Err(not_of_kind(&element, &path, "a number"));
        }
    }
    text.push(']');
    Ok(true)
}
