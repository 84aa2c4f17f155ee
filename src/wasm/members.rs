//! The members of an object of JavaScript, each read once and by its name.
//!
//! Nothing else of an object is looked at, however deep it is or whatever it leads back to. What a getter
//! or a proxy throws is passed on as it is; all other refusals are a `TypeError`.

use crate::wasm::refusal::{Typed, no_such_choice, not_of_kind, too_long_together};
use crate::wasm::request_texts::{Texts, beginning};
use js_sys::{JsString, Reflect};
use wasm_bindgen::prelude::*;
#[cfg(feature = "libraries")]
use {
    crate::decimal::shortest,
    crate::wasm::list::{List, numbers_as_text},
    crate::wasm::refusal::refused,
    serde::de::{DeserializeOwned, IntoDeserializer},
    std::fmt,
};

/// How much of a name a message repeats.
const QUOTED_UNITS: usize = 40;

/// How many unknown members a message names.
#[cfg(feature = "libraries")]
const MOST_NAMED: usize = 3;

/// A name with more letters that are wrong, left out or swapped is another word.
#[cfg(feature = "libraries")]
const MOST_DIFFERENCES: usize = 2;

/// An object of a request.
pub(crate) struct Members<'r> {
    object: JsValue,
    /// Where the request holds it; empty for the request itself.
    path: String,
    texts: &'r Texts,
}

impl<'r> Members<'r> {
    pub(crate) fn of_request(request: &JsValue, texts: &'r Texts) -> Typed<Self> {
        Self::of(request.clone(), String::new(), texts)
    }

    fn of(object: JsValue, path: String, texts: &'r Texts) -> Typed<Self> {
        if !object.is_object() {
            return Err(not_of_kind(&object, &path, "an object"));
        }
        Ok(Self {
            object,
            path,
            texts,
        })
    }

    pub(crate) fn path_to(&self, name: &str) -> String {
        match &*self.path {
            "" => name.to_owned(),
            path => format!("{path}.{name}"),
        }
    }

    pub(crate) fn value(&self, name: &str) -> Typed<JsValue> {
        Reflect::get(&self.object, &name.into())
    }

    pub(crate) fn object(&self, name: &str) -> Typed<Self> {
        Self::of(self.value(name)?, self.path_to(name), self.texts)
    }

    /// Nothing where the member is undefined.
    pub(crate) fn object_if_any(&self, name: &str) -> Typed<Option<Self>> {
        let value = self.value(name)?;
        if value.is_undefined() {
            return Ok(None);
        }
        Self::of(value, self.path_to(name), self.texts).map(Some)
    }

    pub(crate) fn text(&self, name: &str) -> Typed<String> {
        self.text_of(&self.value(name)?, name)
    }

    fn text_of(&self, value: &JsValue, name: &str) -> Typed<String> {
        #[cfg(feature = "libraries")]
        if let Some(text) = numbers_as_text(value, &self.path_to(name))? {
            return self.texts.counted(text).ok_or_else(too_long_together);
        }
        self.name_of(value, name)
    }

    /// A text that is a name, which no numbers are.
    #[cfg(feature = "libraries")]
    pub(crate) fn name(&self, name: &str) -> Typed<String> {
        self.name_of(&self.value(name)?, name)
    }

    fn name_of(&self, value: &JsValue, name: &str) -> Typed<String> {
        let path = self.path_to(name);
        let text = self.texts.read(string_of(value, &path)?, &path);
        text.ok_or_else(too_long_together)
    }

    /// A text that is one of a few words, or the beginning of a longer one.
    pub(crate) fn word(&self, name: &str) -> Typed<String> {
        word(&self.value(name)?, &self.path_to(name))
    }

    /// One of these, by its name.
    pub(crate) fn choice<Choice: Copy, const COUNT: usize>(
        &self,
        name: &str,
        all: [Choice; COUNT],
        name_of: fn(Choice) -> &'static str,
    ) -> Typed<Choice> {
        let mut names = [""; COUNT];
        for (place, choice) in all.iter().enumerate() {
            names[place] = name_of(*choice);
        }
        let at = self.place_of_choice(name, &names)?;
        all.get(at).copied().ok_or(JsValue::UNDEFINED)
    }

    /// The names of JavaScript are in small letters.
    fn place_of_choice(&self, name: &str, names: &[&str]) -> Typed<usize> {
        let chosen = self.word(name)?;
        let mut small = names.iter().map(|name| name.to_ascii_lowercase());
        small
            .position(|name| name == chosen)
            .ok_or_else(|| no_such_choice(&self.path_to(name), &chosen, names))
    }
}

#[cfg(not(feature = "libraries"))]
impl Members<'_> {
    /// Refuses nothing: the small build has one caller, the page, whose compiler looks at the members.
    pub(crate) fn only(&self, _: &[&str]) -> Typed<()> {
        Ok(())
    }
}

#[cfg(feature = "libraries")]
impl<'r> Members<'r> {
    /// Refuses members of any other name, unless they are undefined: one that is misspelt would be a wish
    /// that nobody hears.
    pub(crate) fn only(&self, known: &[&str]) -> Typed<()> {
        let mut unknown = Vec::new();
        for key in Reflect::own_keys(&self.object)?.iter() {
            let Some(name) = key.dyn_ref::<JsString>() else {
                continue;
            };
            let name = quoted(name);
            if known.contains(&&*name) || Reflect::get(&self.object, &key)?.is_undefined() {
                continue;
            }
            unknown.push(match meant(&name, known) {
                Some(meant) => format!("`{name}` (is `{meant}` meant?)"),
                None => format!("`{name}`"),
            });
            if unknown.len() == MOST_NAMED {
                break;
            }
        }
        if unknown.is_empty() {
            return Ok(());
        }
        let whole = match &*self.path {
            "" => "it".to_owned(),
            path => format!("`{path}`"),
        };
        let unknown = unknown.join(", ");
        Err(refused(&format!("{whole} has no member {unknown}")))
    }

    /// Empty where the member is undefined.
    pub(crate) fn text_or_empty(&self, name: &str) -> Typed<String> {
        let value = self.value(name)?;
        if value.is_undefined() {
            return Ok(String::new());
        }
        self.text_of(&value, name)
    }

    /// Empty where the member is undefined.
    pub(crate) fn name_or_empty(&self, name: &str) -> Typed<String> {
        let value = self.value(name)?;
        if value.is_undefined() {
            return Ok(String::new());
        }
        self.name_of(&value, name)
    }

    /// Whether the member is true; it is not where it is undefined.
    #[cfg(feature = "whole")]
    pub(crate) fn is_set(&self, name: &str) -> Typed<bool> {
        let value = self.value(name)?;
        if value.is_undefined() {
            return Ok(false);
        }
        let chosen = value.as_bool();
        chosen.ok_or_else(|| not_of_kind(&value, &self.path_to(name), "true or false"))
    }

    /// One of those that serde knows, by its name.
    pub(crate) fn named<Choice: DeserializeOwned>(&self, name: &str) -> Typed<Choice> {
        named(&self.value(name)?, &self.path_to(name))
    }

    /// The usual one where the member is undefined.
    pub(crate) fn named_or_default<Choice: DeserializeOwned + Default>(
        &self,
        name: &str,
    ) -> Typed<Choice> {
        let value = self.value(name)?;
        if value.is_undefined() {
            return Ok(Choice::default());
        }
        named(&value, &self.path_to(name))
    }

    /// Nothing where the member is undefined, or null as in JSON.
    pub(crate) fn named_if_any<Choice: DeserializeOwned>(
        &self,
        name: &str,
    ) -> Typed<Option<Choice>> {
        let value = self.value(name)?;
        if value.is_undefined() || value.is_null() {
            return Ok(None);
        }
        named(&value, &self.path_to(name)).map(Some)
    }

    /// The place of one of these names; the first where the member is undefined.
    #[cfg(feature = "whole")]
    pub(crate) fn place_or_first(&self, name: &str, names: &[&str]) -> Typed<usize> {
        let value = self.value(name)?;
        if value.is_undefined() {
            return Ok(0);
        }
        let path = self.path_to(name);
        let chosen = word(&value, &path)?;
        let place = names.iter().position(|&known| known == chosen);
        place.ok_or_else(|| no_such_choice(&path, &chosen, names))
    }

    /// A whole number from 1 to the most; nothing where the member is undefined.
    #[cfg(feature = "whole")]
    pub(crate) fn count_if_any(&self, name: &str, most: u32) -> Typed<Option<u32>> {
        let value = self.value(name)?;
        if value.is_undefined() {
            return Ok(None);
        }
        let path = self.path_to(name);
        let told = value.as_f64();
        let told = told.ok_or_else(|| not_of_kind(&value, &path, "a number"))?;
        let count = (1..=most).find(|&count| f64::from(count) == told);
        count.map(Some).ok_or_else(|| {
            let told = shortest(told);
            refused(&format!(
                "`{path}` is {told}, not a whole number from 1 to {most}"
            ))
        })
    }

    /// The elements of a list that are all of these; none where the member is undefined.
    pub(crate) fn list_of_named<Choice: DeserializeOwned>(&self, name: &str) -> Typed<Vec<Choice>> {
        let value = self.value(name)?;
        if value.is_undefined() {
            return Ok(Vec::new());
        }
        let list = List::of(value, self.path_to(name))?;
        let mut all = Vec::new();
        for at in 0..list.length {
            let (path, element) = list.element(at)?;
            all.push(named(&element, &path)?);
        }
        Ok(all)
    }

    /// What is read of the objects of a list.
    pub(crate) fn list_of_objects<Read>(
        &self,
        name: &str,
        read: fn(&Self) -> Typed<Read>,
    ) -> Typed<Vec<Read>> {
        let list = List::of(self.value(name)?, self.path_to(name))?;
        let mut all = Vec::new();
        for at in 0..list.length {
            let (path, object) = list.element(at)?;
            all.push(read(&Self::of(object, path, self.texts)?)?);
        }
        Ok(all)
    }
}

#[cfg(feature = "libraries")]
fn named<Choice: DeserializeOwned>(value: &JsValue, path: &str) -> Typed<Choice> {
    let chosen = word(value, path)?;
    let found = Choice::deserialize(IntoDeserializer::<NoneOf>::into_deserializer(&*chosen));
    found.map_err(|NoneOf(names)| no_such_choice(path, &chosen, names))
}

/// The names that serde would have taken.
#[cfg(feature = "libraries")]
#[derive(Debug)]
struct NoneOf(&'static [&'static str]);

#[cfg(feature = "libraries")]
impl serde::de::Error for NoneOf {
    fn custom<Message: fmt::Display>(_: Message) -> Self {
        Self(&[])
    }

    fn unknown_variant(_: &str, names: &'static [&'static str]) -> Self {
        Self(names)
    }
}

#[cfg(feature = "libraries")]
impl std::error::Error for NoneOf {}

#[cfg(feature = "libraries")]
impl fmt::Display for NoneOf {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a name of none of these")
    }
}

pub(crate) fn word(value: &JsValue, path: &str) -> Typed<String> {
    string_of(value, path).map(quoted)
}

/// A name of JavaScript, or its beginning, which is no name that is known.
fn quoted(name: &JsString) -> String {
    if name.length() as usize <= QUOTED_UNITS {
        return String::from(name);
    }
    format!("{}…", beginning(name, QUOTED_UNITS))
}

/// The member that a misspelt name means: other letters in two places at the most, another way to join
/// words, or more words.
#[cfg(feature = "libraries")]
fn meant<'known>(name: &str, known: &[&'known str]) -> Option<&'known str> {
    let plain = |name: &str| name.replace(['_', '-', ' '], "").to_ascii_lowercase();
    let name = plain(name);
    let differences = |other: &str| {
        let other = plain(other);
        if name.starts_with(&other) && other.len() > 2 {
            return 1;
        }
        strsim::osa_distance(&name, &other)
    };
    let nearest = known
        .iter()
        .map(|&known| (differences(known), known))
        .min_by_key(|(differences, _)| *differences)?;
    (nearest.0 <= MOST_DIFFERENCES && 2 * nearest.0 < nearest.1.len()).then_some(nearest.1)
}

fn string_of<'value>(value: &'value JsValue, path: &str) -> Typed<&'value JsString> {
    let string = value.dyn_ref::<JsString>();
    string.ok_or_else(|| not_of_kind(value, path, "a text"))
}
