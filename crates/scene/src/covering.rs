//! Coverings: what a side of a surface is covered with.

use crate::{material::Material, named_material::NamedMaterial, thermal::Thermal};

/// A material with what it says of the surfaces that say nothing else.
#[derive(Clone, Debug)]
pub struct Covering {
    /// The material.
    pub material: Material,
    /// Its name; none where nothing was given.
    pub name: Option<String>,
    /// Its emissivity and its condition.
    pub thermal: Thermal,
    /// The light group of what emits.
    pub group: Option<String>,
}

impl Covering {
    /// The material of that name, of which nothing else is known.
    pub fn new(name: impl Into<String>, material: Material) -> Self {
        Self { name: Some(name.into()), ..Self::plain(material) }
    }

    /// Neither reflects nor emits, and has no name.
    pub fn black(bands: usize) -> Self {
        Self::plain(Material::black(bands))
    }

    fn plain(material: Material) -> Self {
        Self { material, name: None, thermal: Thermal::default(), group: None }
    }
}

impl From<&NamedMaterial> for Covering {
    fn from(named: &NamedMaterial) -> Self {
        Self::new(named.name(), named.material().clone())
    }
}
