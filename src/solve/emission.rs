//! Emission: what a scene's surfaces emit, one light group after the other.

use crate::elements::Element;
use crate::elements::coating::Coating;
use crate::scene::Scene;

/// The emission of one light group, not dimmed.
#[derive(Debug)]
pub(super) struct Emission {
    /// Its name; None for surfaces without a group.
    pub group: Option<String>,
    /// Reflectance of all elements and exitance of those of the group, per band.
    pub coatings: Vec<Coating>,
}

impl Emission {
    /// Every group of `scene` that emits, and what emits without a group; at least one, which may be dark.
    pub(super) fn all(scene: &Scene, elements: &[Element]) -> Vec<Self> {
        let mut groups: Vec<Option<&str>> =
            scene.light_groups().iter().map(|group| Some(group.name.as_str())).collect();
        if groups.is_empty() || scene.surfaces.iter().any(|own| own.is_in(None) && own.material.emits()) {
            groups.push(None);
        }
        let of = |group: Option<&str>| Self {
            group: group.map(str::to_owned),
            coatings: (0..scene.bands.len())
                .map(|band| Coating::of_group(scene, elements, band, group))
                .collect(),
        };
        groups.into_iter().map(of).collect()
    }

    /// The coatings, band by band.
    pub(super) fn list(&self) -> Vec<&Coating> {
        self.coatings.iter().collect()
    }

    /// Whether the same elements emit as much in `other`.
    pub(super) fn emits_as(&self, other: &Self) -> bool {
        let mut coatings = self.coatings.iter().zip(&other.coatings);
        self.group == other.group && coatings.all(|(own, other)| own.exitance == other.exitance)
    }

    /// For each band the coatings of all `emissions`.
    pub(super) fn by_band(emissions: &[Self]) -> Vec<Vec<&Coating>> {
        let bands = emissions.first().map_or(0, |emission| emission.coatings.len());
        (0..bands).map(|band| emissions.iter().map(|emission| &emission.coatings[band]).collect()).collect()
    }
}
