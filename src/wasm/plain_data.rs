//! Reports as plain objects and lists of JavaScript.
//!
//! What is absent is undefined, and a choice is the word for it. Unlike `serde-wasm-bindgen` it knows no error,
//! which would be looked for after every member, and nothing that no report has: maps and bytes.

use js_sys::{Array, JsString, Object};
use serde::ser::{self, Impossible, Serialize};
use std::cell::RefCell;
use std::fmt;
use std::ptr;
use wasm_bindgen::prelude::*;

/// So many times as many as there are names of members and words of choices, that few share a place.
const PLACES: usize = 4093;

pub(crate) fn to_js(value: &(impl Serialize + ?Sized)) -> JsValue {
    let Ok(value) = value.serialize(ToJs);
    value
}

#[wasm_bindgen]
extern "C" {
    /// An object whose members can be set without an error.
    type Plain;

    #[wasm_bindgen(method, indexing_setter)]
    fn set(this: &Plain, name: &JsString, value: JsValue);
}

thread_local! {
    /// The names that were written so far, each at the place that follows from its address.
    static NAMES: RefCell<Vec<Option<(&'static str, JsString)>>> = const { RefCell::new(Vec::new()) };
}

/// A name as JavaScript has it, made anew only where another one took its place.
fn with_name<T>(name: &'static str, then: impl FnOnce(&JsString) -> T) -> T {
    NAMES.with_borrow_mut(|names| {
        names.resize(PLACES, None);
        let place = &mut names[name.as_ptr().addr() % PLACES];
        match place {
            Some((known, text)) if ptr::eq(*known, name) => then(text),
            _ => then(&place.insert((name, name.into())).1),
        }
    })
}

fn set(object: &Plain, name: &'static str, value: JsValue) {
    with_name(name, |name| object.set(name, value));
}

/// No report refuses to be written.
#[derive(Debug)]
pub(crate) enum Never {}

impl fmt::Display for Never {
    fn fmt(&self, _: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {}
    }
}

impl std::error::Error for Never {}

impl ser::Error for Never {
    fn custom<T: fmt::Display>(_: T) -> Self {
        std::process::abort()
    }
}

type Written<T = JsValue> = Result<T, Never>;

/// What no report has.
fn never<T>() -> Written<T> {
    std::process::abort()
}

/// An object in the making.
pub(crate) struct Members(Plain);

impl Members {
    fn new() -> Self {
        Self(Object::new().unchecked_into())
    }
}

impl ser::SerializeStruct for Members {
    type Ok = JsValue;
    type Error = Never;

    fn serialize_field<T: Serialize + ?Sized>(
        &mut self,
        name: &'static str,
        value: &T,
    ) -> Written<()> {
        set(&self.0, name, to_js(value));
        Ok(())
    }

    fn end(self) -> Written {
        Ok(self.0.into())
    }
}

/// A list in the making.
pub(crate) struct Items {
    list: Array,
    count: u32,
}

impl ser::SerializeSeq for Items {
    type Ok = JsValue;
    type Error = Never;

    fn serialize_element<T: Serialize + ?Sized>(&mut self, value: &T) -> Written<()> {
        self.list.set(self.count, to_js(value));
        self.count += 1;
        Ok(())
    }

    fn end(self) -> Written {
        Ok(self.list.into())
    }
}

impl ser::SerializeTuple for Items {
    type Ok = JsValue;
    type Error = Never;

    fn serialize_element<T: Serialize + ?Sized>(&mut self, value: &T) -> Written<()> {
        ser::SerializeSeq::serialize_element(self, value)
    }

    fn end(self) -> Written {
        ser::SerializeSeq::end(self)
    }
}

impl ser::SerializeTupleStruct for Items {
    type Ok = JsValue;
    type Error = Never;

    fn serialize_field<T: Serialize + ?Sized>(&mut self, value: &T) -> Written<()> {
        ser::SerializeSeq::serialize_element(self, value)
    }

    fn end(self) -> Written {
        ser::SerializeSeq::end(self)
    }
}

struct ToJs;

/// As a number, which each of these is without a loss, or as itself.
macro_rules! plain {
    ($($name:ident: $type:ty as $plain:ty,)*) => {
        $(fn $name(self, value: $type) -> Written {
            Ok(<$plain>::from(value).into())
        })*
    };
}

impl ser::Serializer for ToJs {
    type Ok = JsValue;
    type Error = Never;
    type SerializeSeq = Items;
    type SerializeTuple = Items;
    type SerializeTupleStruct = Items;
    type SerializeTupleVariant = Impossible<JsValue, Never>;
    type SerializeMap = Impossible<JsValue, Never>;
    type SerializeStruct = Members;
    type SerializeStructVariant = Impossible<JsValue, Never>;

    plain! {
        serialize_bool: bool as bool,
        serialize_i8: i8 as f64,
        serialize_i16: i16 as f64,
        serialize_i32: i32 as f64,
        serialize_u8: u8 as f64,
        serialize_u16: u16 as f64,
        serialize_u32: u32 as f64,
        serialize_f32: f32 as f64,
        serialize_f64: f64 as f64,
        serialize_char: char as String,
    }

    fn serialize_i64(self, _: i64) -> Written {
        never()
    }

    fn serialize_u64(self, value: u64) -> Written {
        // Places in lists, which are counted in 32 bits here.
        u32::try_from(value).map_or_else(|_| never(), |value| Ok(value.into()))
    }

    fn serialize_str(self, value: &str) -> Written {
        Ok(value.into())
    }

    fn serialize_bytes(self, _: &[u8]) -> Written {
        never()
    }

    fn serialize_none(self) -> Written {
        Ok(JsValue::UNDEFINED)
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Written {
        value.serialize(self)
    }

    fn serialize_unit(self) -> Written {
        Ok(JsValue::UNDEFINED)
    }

    fn serialize_unit_struct(self, _: &'static str) -> Written {
        Ok(JsValue::UNDEFINED)
    }

    fn serialize_unit_variant(self, _: &'static str, _: u32, word: &'static str) -> Written {
        Ok(with_name(word, |word| word.into()))
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        value: &T,
    ) -> Written {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        word: &'static str,
        value: &T,
    ) -> Written {
        let Members(object) = Members::new();
        set(&object, word, to_js(value));
        Ok(object.into())
    }

    fn serialize_seq(self, _: Option<usize>) -> Written<Items> {
        Ok(Items {
            list: Array::new(),
            count: 0,
        })
    }

    fn serialize_tuple(self, _: usize) -> Written<Items> {
        self.serialize_seq(None)
    }

    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Written<Items> {
        self.serialize_seq(None)
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Written<Self::SerializeTupleVariant> {
        never()
    }

    fn serialize_map(self, _: Option<usize>) -> Written<Self::SerializeMap> {
        never()
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Written<Members> {
        Ok(Members::new())
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Written<Self::SerializeStructVariant> {
        never()
    }
}
