//! Materials with their names, of scenes in the making.

use std::sync::Arc;

use crate::material::Material;

/// A material of a scene in the making, given to its surfaces.
#[derive(Clone, Debug)]
pub struct NamedMaterial(Arc<Named>);

#[derive(Debug)]
struct Named {
    name: String,
    material: Material,
}

impl NamedMaterial {
    pub(super) fn new(name: String, material: Material) -> Self {
        Self(Arc::new(Named { name, material }))
    }

    pub(super) fn name(&self) -> &str {
        &self.0.name
    }

    pub(super) fn material(&self) -> &Material {
        &self.0.material
    }

    /// Whether both are one material in memory, and not only equal.
    pub(super) fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}
