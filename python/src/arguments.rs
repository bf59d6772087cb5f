//! Arguments by name: checked, and taken one by one; what is left was not known.

use std::collections::BTreeMap;
use std::fmt::{self, Display, Formatter};
use std::marker::PhantomData;
use std::path::PathBuf;
use std::str::FromStr;

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat};
use serde::Deserializer;
use serde::de::{self, DeserializeOwned, DeserializeSeed, Error as _, IntoDeserializer, MapAccess, Visitor};
use serde::forward_to_deserialize_any;

use crate::error::Trouble;

/// Arguments that were given; those that are None are as good as not given.
pub(crate) struct Arguments<'py> {
    given: BTreeMap<String, Bound<'py, PyAny>>,
}

impl<'py> Arguments<'py> {
    /// The arguments in a dictionary, by name.
    ///
    /// # Errors
    /// Names that are no text.
    pub(crate) fn of(given: &Bound<'py, PyDict>) -> PyResult<Self> {
        let named = given.iter().filter(|(_, value)| !value.is_none());
        let named = named.map(|(name, value)| Ok((name.extract::<String>()?, value)));
        Ok(Self { given: named.collect::<PyResult<_>>()? })
    }

    /// A request made of the arguments that are its fields; fields that are not given stay as they usually are.
    pub(crate) fn fields<T: DeserializeOwned>(&mut self) -> PyResult<T> {
        T::deserialize(Fields(&mut self.given)).map_err(|fault| fault.told("arguments", "…"))
    }

    /// The value of an argument.
    pub(crate) fn value<T: DeserializeOwned>(&mut self, name: &str) -> PyResult<Option<T>> {
        let value = self.given.remove(name);
        value.map(|value| Argument { name, value: &value }.read(PhantomData)).transpose()
    }

    /// The value of an argument that a text says, or the written form of a number.
    pub(crate) fn parsed<T: FromStr<Err: Display>>(&mut self, name: &str) -> PyResult<Option<T>> {
        let Some(value) = self.given.remove(name) else { return Ok(None) };
        let parsed = text(&value)?.parse();
        parsed.map(Some).map_err(|expected: T::Err| Fault::custom(expected).told(name, &shown(&value)))
    }

    /// The two values of an argument.
    pub(crate) fn pair<T: DeserializeOwned>(&mut self, name: &str) -> PyResult<Option<[T; 2]>> {
        let Some(value) = self.given.remove(name) else { return Ok(None) };
        let pair: [Bound<'py, PyAny>; 2] =
            value.extract().map_err(|_| Fault::Type("two whole numbers").told(name, &shown(&value)))?;
        let read = |place: usize| {
            Argument { name: &format!("{name}[{place}]"), value: &pair[place] }.read(PhantomData)
        };
        Ok(Some([read(0)?, read(1)?]))
    }

    /// The truth value of an argument; false where it is not given.
    pub(crate) fn flag(&mut self, name: &str) -> PyResult<bool> {
        Ok(self.value(name)?.unwrap_or_default())
    }

    /// Refuses what was not taken, as Python refuses arguments that a function does not know.
    pub(crate) fn finish(self, function: &str) -> PyResult<()> {
        match self.given.keys().next() {
            None => Ok(()),
            Some(name) => {
                Err(PyTypeError::new_err(format!("{function}() got an unexpected keyword argument '{name}'")))
            }
        }
    }
}

/// An argument by its name.
struct Argument<'a, 'py> {
    name: &'a str,
    value: &'a Bound<'py, PyAny>,
}

impl Argument<'_, '_> {
    /// The value that the argument states.
    fn read<'de, S: DeserializeSeed<'de>>(&self, seed: S) -> PyResult<S::Value> {
        seed.deserialize(Value(self.value)).map_err(|fault| fault.told(self.name, &shown(self.value)))
    }
}

/// Reads a structure from the arguments that are its fields, and takes them.
struct Fields<'a, 'py>(&'a mut BTreeMap<String, Bound<'py, PyAny>>);

impl<'de> Deserializer<'de> for Fields<'_, '_> {
    type Error = Fault;

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        let given = fields.iter().filter_map(|name| Some((*name, self.0.remove(*name)?))).collect();
        visitor.visit_map(GivenFields { given, value: None })
    }

    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Fault> {
        Err(Fault::custom("expected a structure of fields"))
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit
        unit_struct newtype_struct seq tuple tuple_struct map enum identifier ignored_any
    }
}

/// The fields that are given, and the one whose value comes next.
struct GivenFields<'py> {
    given: Vec<(&'static str, Bound<'py, PyAny>)>,
    value: Option<(&'static str, Bound<'py, PyAny>)>,
}

impl<'de> MapAccess<'de> for GivenFields<'_> {
    type Error = Fault;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Fault> {
        self.value = self.given.pop();
        let name = self.value.as_ref().map(|(name, _)| seed.deserialize((*name).into_deserializer()));
        name.transpose()
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Fault> {
        let (name, value) = self.value.take().ok_or_else(|| Fault::custom("expected a value"))?;
        Ok(Argument { name, value: &value }.read(seed)?)
    }
}

/// The value of an argument: a number, a truth value, a path, or what its text says.
struct Value<'a, 'py>(&'a Bound<'py, PyAny>);

impl<'de> Deserializer<'de> for Value<'_, '_> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_string(text(self.0)?)
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_bool(self.0.extract().map_err(|_| Fault::Type("True or False"))?)
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_f64(self.0.extract().map_err(|_| Fault::Type("a number"))?)
    }

    fn deserialize_i128<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_i128(whole(self.0).ok_or(Fault::Type("a whole number"))?)
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        let path: PathBuf = self.0.extract().map_err(|_| Fault::Type("a path"))?;
        visitor
            .visit_string(path.into_os_string().into_string().map_err(|_| Fault::Type("a path in Unicode"))?)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_some(self)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        visitor.visit_enum(text(self.0)?.into_deserializer())
    }

    forward_to_deserialize_any! {
        i8 i16 i32 i64 u8 u16 u32 u64 u128 f32 char str bytes byte_buf unit unit_struct newtype_struct seq
        tuple tuple_struct map struct identifier ignored_any
    }
}

/// Fault of an argument.
#[derive(Debug)]
enum Fault {
    /// The value is of another type than this.
    Type(&'static str),
    /// The value is not one of those expected.
    Expected(String),
    /// The error that Python gets.
    Told(PyErr),
}

impl Fault {
    /// The error of the argument that was given as `name=shown`.
    fn told(self, name: &str, shown: &str) -> PyErr {
        match self {
            Self::Type(expected) => PyTypeError::new_err(format!("{name}={shown}: expected {expected}")),
            Self::Expected(expected) => Trouble::new(format!("{name}={shown} cannot be"), expected).into(),
            Self::Told(error) => error,
        }
    }
}

impl Display for Fault {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Type(expected) => expected.fmt(to),
            Self::Expected(expected) => expected.fmt(to),
            Self::Told(error) => error.fmt(to),
        }
    }
}

impl std::error::Error for Fault {}

impl de::Error for Fault {
    fn custom<T: Display>(expected: T) -> Self {
        Self::Expected(expected.to_string())
    }
}

impl From<PyErr> for Fault {
    fn from(error: PyErr) -> Self {
        Self::Told(error)
    }
}

/// The text of a value, or the written form of a number: 8e9 without a fraction.
fn text(value: &Bound<'_, PyAny>) -> PyResult<String> {
    match whole(value).filter(|_| value.is_instance_of::<PyFloat>()) {
        Some(number) => Ok(number.to_string()),
        None => Ok(value.str()?.to_string()),
    }
}

/// A whole number, or a float that is one, such as 1e6.
fn whole(value: &Bound<'_, PyAny>) -> Option<i128> {
    let of_float =
        || value.extract::<f64>().ok().filter(|number| number.fract() == 0.0).map(|number| number as i128);
    value.extract::<i128>().ok().or_else(of_float)
}

/// The argument as it was given.
fn shown(value: &Bound<'_, PyAny>) -> String {
    value.repr().map_or_else(|_| "…".to_owned(), |text| text.to_string())
}
