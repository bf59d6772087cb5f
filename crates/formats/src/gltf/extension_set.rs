//! Reading of the extensions at a place of a glTF file: values of those that are followed, and the others by their
//! names, whose values may be anything.

use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;

use serde::de::{Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::value::RawValue;

/// Extensions at a place of a file, by their names.
pub(super) type Extensions = BTreeMap<String, Box<RawValue>>;

/// The extensions at a place of a file.
pub(super) trait ExtensionSet: Default {
    /// Takes the value of the extension `name`, if it is followed; returns whether it is.
    fn take<'de, A: MapAccess<'de>>(&mut self, name: &str, map: &mut A) -> Result<bool, A::Error>;

    /// The others.
    fn others(&mut self) -> &mut Extensions;
}

impl ExtensionSet for Extensions {
    fn take<'de, A: MapAccess<'de>>(&mut self, _: &str, _: &mut A) -> Result<bool, A::Error> {
        Ok(false)
    }

    fn others(&mut self) -> &mut Extensions {
        self
    }
}

/// Reads the extensions at a place; none where there is something else than an object.
pub(super) fn extension_set<'de, D: Deserializer<'de>, E: ExtensionSet>(source: D) -> Result<E, D::Error> {
    source.deserialize_any(SetVisitor(PhantomData))
}

struct SetVisitor<E>(PhantomData<E>);

impl<'de, E: ExtensionSet> Visitor<'de> for SetVisitor<E> {
    type Value = E;

    fn expecting(&self, to: &mut fmt::Formatter) -> fmt::Result {
        to.write_str("extensions by their names")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<E, A::Error> {
        let mut set = E::default();
        while let Some(name) = map.next_key::<String>()? {
            if !set.take(&name, &mut map)? {
                let value = map.next_value()?;
                set.others().insert(name, value);
            }
        }
        Ok(set)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<E, A::Error> {
        while list.next_element::<IgnoredAny>()?.is_some() {}
        Ok(E::default())
    }

    fn visit_unit<F>(self) -> Result<E, F> {
        Ok(E::default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(json: &str) -> Vec<String> {
        let mut source = serde_json::Deserializer::from_str(json);
        extension_set::<_, Extensions>(&mut source).expect(json).into_keys().collect()
    }

    /// Values of extensions that are not followed may be anything, as before any was looked at.
    #[test]
    fn unknown_values_may_be_anything() {
        let deep = format!("{{\"A\": {}{}}}", "[".repeat(200), "]".repeat(200));
        for json in [r#"{"A": 1e400}"#, r#"{"A": "\ud800"}"#, r#"{"A": null}"#, deep.as_str()] {
            assert_eq!(read(json), ["A"], "{json}");
        }
        for json in ["null", "[]", "[1, {}]"] {
            assert!(read(json).is_empty(), "{json}");
        }
    }
}
