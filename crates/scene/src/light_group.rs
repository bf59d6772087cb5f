//! Light groups: surfaces and luminaires whose light is dimmed together.

use serde::Serialize;

/// The light group of a surface or a luminaire.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LightGroup {
    /// Its name, the same on all its members.
    pub name: String,
    /// Factor ≥ 0 on the emission of its members: 1 unless the group was dimmed
    /// ([`Scene::dimmed`](crate::Scene::dimmed)).
    pub factor: f64,
}

impl LightGroup {
    /// The group of that name, not dimmed.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), factor: 1.0 }
    }
}
