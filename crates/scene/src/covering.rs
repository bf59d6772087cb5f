//! Coverings: the materials of sides of surfaces, with light group and heat.

use crate::{material::Material, named_material::NamedMaterial, thermal::Thermal};

/// A material, with the light group and the heat of the surfaces that state none of their own.
#[derive(Clone, Debug)]
pub struct Covering {
    /// The material.
    pub material: Material,
    /// Its name; none where nothing was given.
    pub name: Option<String>,
    /// Its emissivity and its thermal condition.
    pub thermal: Thermal,
    /// Name of its light group, if it has one.
    pub group: Option<String>,
}

impl Covering {
    /// A covering of the material of that name, without light group and heat.
    pub fn new(name: impl Into<String>, material: Material) -> Self {
        Self { name: Some(name.into()), ..Self::plain(material) }
    }

    /// A covering without a name that neither reflects nor emits.
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
