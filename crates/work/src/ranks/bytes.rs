//! Values as bytes, as ranks send them and journals keep them.

use serde::Serialize;
use serde::de::DeserializeOwned;

/// A value as bytes.
pub(super) fn encoded<T: Serialize>(value: &T) -> Vec<u8> {
    postcard::to_allocvec(value).expect("what ranks share has a length and no maps of unknown size")
}

/// The value of these bytes.
pub(super) fn decoded<T: DeserializeOwned>(bytes: &[u8]) -> T {
    postcard::from_bytes(bytes).expect("all ranks share the same things in the same order")
}

/// The value of these bytes, if they are one and nothing else.
pub(super) fn strictly_decoded<T: DeserializeOwned>(bytes: &[u8]) -> Option<T> {
    let (value, rest) = postcard::take_from_bytes(bytes).ok()?;
    rest.is_empty().then_some(value)
}
