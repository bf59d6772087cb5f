//! A scene that is looked at, as it was named.

use std::error::Error;

use radiosity::elements::{Discretization, Elements, Subdivide};
use radiosity::scene::Scene;
use radiosity::solve::Options;

/// A scene with its elements at the defaults.
pub(crate) struct Subject {
    pub(crate) name: String,
    pub(crate) scene: Scene,
    pub(crate) elements: Elements,
}

impl Subject {
    /// The scene of `NAME` or `NAME:PARAMETER=VALUE`.
    pub(crate) fn named(name: &str) -> Result<Self, Box<dyn Error>> {
        let (source, setting) =
            name.split_once(':').map_or((name, None), |(source, setting)| (source, Some(setting)));
        let setting = setting.map(parsed).transpose()?;
        let scene = radiosity::language::read(&radiosity::language::source(source, setting.as_slice())?)?;
        let Options { order, space, layers, .. } = Options::default();
        let occluded = Options::default().visibility(&scene).any_shadow();
        let how = Discretization {
            order,
            space,
            subdivide: Subdivide::Auto { occluded, near_layers: false },
            layers,
        };
        let elements = Elements::new(&scene, &how)?;
        Ok(Self { name: name.to_owned(), scene, elements })
    }

    /// Whether elements are planar, most of them and all.
    pub(crate) fn is_planar(&self) -> [bool; 2] {
        let list = self.elements.list();
        let planar = list.iter().filter(|element| element.plane.is_some()).count();
        [2 * planar > list.len(), planar == list.len()]
    }
}

/// Name and value of a parameter.
fn parsed(setting: &str) -> Result<(&str, f64), Box<dyn Error>> {
    let cure = || format!("'{setting}': write NAME=VALUE after the colon, as in temple:bays=3");
    let (name, value) = setting.split_once('=').ok_or_else(cure)?;
    Ok((name, value.parse().map_err(|_| cure())?))
}
