//! Arguments by name: checked, and taken one by one; what is left was not known.

use std::collections::BTreeMap;
use std::fmt::Display;
use std::ops::RangeInclusive;
use std::path::PathBuf;

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use radiosity::request::ranges;
use serde::de::value::Error as Unknown;
use serde::de::{DeserializeOwned, IntoDeserializer};

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

    /// The number of an argument, if `check` lets it pass.
    pub(crate) fn number(
        &mut self,
        name: &str,
        check: fn(f64) -> Result<f64, &'static str>,
    ) -> PyResult<Option<f64>> {
        let Some(value) = self.given.remove(name) else { return Ok(None) };
        let number = value.extract::<f64>().map_err(|_| wrong_type(name, "a number", &value))?;
        Ok(Some(check(number).map_err(|expected| out_of_range(name, &value, expected))?))
    }

    /// The whole number of an argument, within a range.
    pub(crate) fn whole(&mut self, name: &str, range: &RangeInclusive<u64>) -> PyResult<Option<u64>> {
        let Some(value) = self.given.remove(name) else { return Ok(None) };
        let expected = ranges::whole(range);
        let number = whole(&value).ok_or_else(|| wrong_type(name, "a whole number", &value))?;
        let number = u64::try_from(number).ok().filter(|number| range.contains(number));
        Ok(Some(number.ok_or_else(|| out_of_range(name, &value, &expected))?))
    }

    /// The bytes of an argument: a whole number, or a text such as "2G".
    pub(crate) fn bytes(&mut self, name: &str) -> PyResult<Option<u64>> {
        match self.given.get(name).is_some_and(|value| value.is_instance_of::<PyString>()) {
            true => self.read(name, ranges::bytes),
            false => self.whole(name, &(1..=u64::MAX)),
        }
    }

    /// The path of a file in an argument.
    pub(crate) fn path(&mut self, name: &str) -> PyResult<Option<PathBuf>> {
        let Some(value) = self.given.remove(name) else { return Ok(None) };
        Ok(Some(value.extract().map_err(|_| wrong_type(name, "a path", &value))?))
    }

    /// The two whole numbers of an argument, both within a range.
    pub(crate) fn pair(&mut self, name: &str, range: &RangeInclusive<u64>) -> PyResult<Option<[usize; 2]>> {
        let Some(value) = self.given.remove(name) else { return Ok(None) };
        let both: [Bound<'py, PyAny>; 2] =
            value.extract().map_err(|_| wrong_type(name, "two whole numbers", &value))?;
        for (place, one) in ["0", "1"].into_iter().zip(both) {
            self.given.insert(format!("{name}[{place}]"), one);
        }
        let mut one = |place| self.count(&format!("{name}[{place}]"), range);
        Ok(one(0)?.zip(one(1)?).map(<[usize; 2]>::from))
    }

    /// The whole number of an argument, within a range, as an index.
    pub(crate) fn count(&mut self, name: &str, range: &RangeInclusive<u64>) -> PyResult<Option<usize>> {
        // On machines of fewer bits no range is so wide.
        Ok(self.whole(name, range)?.map(|number| number as usize))
    }

    /// The truth value of an argument; false where it is not given.
    pub(crate) fn flag(&mut self, name: &str) -> PyResult<bool> {
        let Some(value) = self.given.remove(name) else { return Ok(false) };
        value.extract::<bool>().map_err(|_| wrong_type(name, "True or False", &value))
    }

    /// The value of an argument that names one of several modes.
    pub(crate) fn named<T: DeserializeOwned>(&mut self, name: &str) -> PyResult<Option<T>> {
        self.read(name, |text| {
            T::deserialize(IntoDeserializer::<Unknown>::into_deserializer(text))
                .map_err(|unknown| unknown.to_string())
        })
    }

    /// The value that `read` gives an argument, which is a text, or a number in its written form.
    pub(crate) fn read<T, E: Display>(
        &mut self,
        name: &str,
        read: impl FnOnce(&str) -> Result<T, E>,
    ) -> PyResult<Option<T>> {
        let Some(value) = self.given.remove(name) else { return Ok(None) };
        let text = value.str()?.to_string();
        Ok(Some(read(&text).map_err(|expected| out_of_range(name, &value, &expected.to_string()))?))
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

fn wrong_type(name: &str, expected: &str, value: &Bound<'_, PyAny>) -> PyErr {
    PyTypeError::new_err(format!("{name}={}: expected {expected}", shown(value)))
}

fn out_of_range(name: &str, value: &Bound<'_, PyAny>, expected: &str) -> PyErr {
    Trouble::new(format!("{name}={} cannot be", shown(value)), expected).into()
}
