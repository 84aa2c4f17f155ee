//! Reports to JavaScript, member by member.
//!
//! It takes the place of `serde_wasm_bindgen`, which may refuse a value: its error needs a way out after every
//! member, 7 kB of the whole core, compressed, and 4 of the small one. Here an error has no value.

use js_sys::{Array, Object};
use serde::Serialize;
use serde::ser::{
    self, Impossible, SerializeSeq, SerializeStruct, SerializeTuple, SerializeTupleStruct,
};
use std::cell::RefCell;
use std::fmt;
use wasm_bindgen::prelude::*;

/// A report as JavaScript has it; what is absent is undefined.
pub(crate) fn to_js(report: &impl Serialize) -> JsValue {
    let Ok(value) = report.serialize(ToJs);
    value
}

#[derive(Clone, Copy)]
struct ToJs;

/// The error of what cannot fail.
#[derive(Debug)]
enum Never {}

impl fmt::Display for Never {
    fn fmt(&self, _: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {}
    }
}

impl std::error::Error for Never {}

impl ser::Error for Never {
    fn custom<T: fmt::Display>(_: T) -> Self {
        unsaid()
    }
}

/// For the kinds of values that no report has.
fn unsaid() -> ! {
    wasm_bindgen::throw_str("no report has this kind of value")
}

#[wasm_bindgen]
extern "C" {
    /// An object, whose members are set without a function that looks for setters.
    type Members;

    #[wasm_bindgen(method, structural, indexing_setter)]
    fn set(this: &Members, key: JsValue, value: JsValue);
}

thread_local! {
    /// Keys and names, sorted by where they stand in the program: each is made once.
    static KEPT: RefCell<Vec<((*const u8, usize), JsValue)>> = const { RefCell::new(Vec::new()) };
}

/// The string of JavaScript for a name that stands in the program.
fn kept(name: &'static str) -> JsValue {
    KEPT.with_borrow_mut(|kept| {
        let place = (name.as_ptr(), name.len());
        match kept.binary_search_by_key(&place, |(known, _)| *known) {
            Ok(at) => kept[at].1.clone(),
            Err(at) => {
                let value = JsValue::from(name);
                kept.insert(at, (place, value.clone()));
                value
            }
        }
    })
}

type Done = Result<JsValue, Never>;

/// An object or a list that is filled.
struct Filled {
    target: JsValue,
    length: u32,
}

impl Filled {
    fn of(target: impl Into<JsValue>) -> Self {
        Self {
            target: target.into(),
            length: 0,
        }
    }

    fn push(&mut self, value: JsValue) {
        self.target.unchecked_ref::<Array>().set(self.length, value);
        self.length += 1;
    }
}

macro_rules! as_number {
    ($($name:ident($number:ty);)*) => {
        $(fn $name(self, number: $number) -> Done {
            self.serialize_f64(number as f64)
        })*
    };
}

impl ser::Serializer for ToJs {
    type Ok = JsValue;
    type Error = Never;
    type SerializeSeq = Filled;
    type SerializeTuple = Filled;
    type SerializeTupleStruct = Filled;
    type SerializeTupleVariant = Impossible<JsValue, Never>;
    type SerializeMap = Impossible<JsValue, Never>;
    type SerializeStruct = Filled;
    type SerializeStructVariant = Impossible<JsValue, Never>;

    as_number! {
        serialize_i8(i8);
        serialize_i16(i16);
        serialize_i32(i32);
        serialize_i64(i64);
        serialize_u8(u8);
        serialize_u16(u16);
        serialize_u32(u32);
        serialize_u64(u64);
        serialize_f32(f32);
    }

    fn serialize_bool(self, value: bool) -> Done {
        Ok(value.into())
    }

    fn serialize_f64(self, number: f64) -> Done {
        Ok(number.into())
    }

    fn serialize_char(self, character: char) -> Done {
        self.serialize_str(character.encode_utf8(&mut [0; 4]))
    }

    fn serialize_str(self, string: &str) -> Done {
        Ok(string.into())
    }

    fn serialize_bytes(self, _: &[u8]) -> Done {
        unsaid()
    }

    fn serialize_none(self) -> Done {
        Ok(JsValue::UNDEFINED)
    }

    fn serialize_some<T: ?Sized + Serialize>(self, value: &T) -> Done {
        value.serialize(self)
    }

    fn serialize_unit(self) -> Done {
        self.serialize_none()
    }

    fn serialize_unit_struct(self, _: &'static str) -> Done {
        self.serialize_none()
    }

    fn serialize_unit_variant(self, _: &'static str, _: u32, variant: &'static str) -> Done {
        Ok(kept(variant))
    }

    fn serialize_newtype_struct<T: ?Sized + Serialize>(self, _: &'static str, value: &T) -> Done {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: ?Sized + Serialize>(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: &T,
    ) -> Done {
        unsaid()
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Filled, Never> {
        Ok(Filled::of(Array::new()))
    }

    fn serialize_tuple(self, _: usize) -> Result<Filled, Never> {
        self.serialize_seq(None)
    }

    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Filled, Never> {
        self.serialize_seq(None)
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Self::SerializeTupleVariant, Never> {
        unsaid()
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Self::SerializeMap, Never> {
        unsaid()
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Filled, Never> {
        Ok(Filled::of(Object::new()))
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Self::SerializeStructVariant, Never> {
        unsaid()
    }
}

impl SerializeSeq for Filled {
    type Ok = JsValue;
    type Error = Never;

    fn serialize_element<T: ?Sized + Serialize>(&mut self, value: &T) -> Result<(), Never> {
        let Ok(value) = value.serialize(ToJs);
        self.push(value);
        Ok(())
    }

    fn end(self) -> Done {
        Ok(self.target)
    }
}

impl SerializeTuple for Filled {
    type Ok = JsValue;
    type Error = Never;

    fn serialize_element<T: ?Sized + Serialize>(&mut self, value: &T) -> Result<(), Never> {
        SerializeSeq::serialize_element(self, value)
    }

    fn end(self) -> Done {
        Ok(self.target)
    }
}

impl SerializeTupleStruct for Filled {
    type Ok = JsValue;
    type Error = Never;

    fn serialize_field<T: ?Sized + Serialize>(&mut self, value: &T) -> Result<(), Never> {
        SerializeSeq::serialize_element(self, value)
    }

    fn end(self) -> Done {
        Ok(self.target)
    }
}

impl SerializeStruct for Filled {
    type Ok = JsValue;
    type Error = Never;

    fn serialize_field<T: ?Sized + Serialize>(
        &mut self,
        key: &'static str,
        value: &T,
    ) -> Result<(), Never> {
        let Ok(value) = value.serialize(ToJs);
        self.target.unchecked_ref::<Members>().set(kept(key), value);
        Ok(())
    }

    fn end(self) -> Done {
        Ok(self.target)
    }
}
