//! A vector as three numbers, for what ranks send each other: `#[serde(with = "vector")]`.

use glam::DVec3;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Writes (x, y, z).
///
/// # Errors
/// Those of the serialiser.
pub fn serialize<S: Serializer>(vector: &DVec3, to: S) -> Result<S::Ok, S::Error> {
    vector.to_array().serialize(to)
}

/// Reads (x, y, z).
///
/// # Errors
/// Those of the deserialiser.
pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<DVec3, D::Error> {
    <[f64; 3]>::deserialize(from).map(DVec3::from_array)
}
