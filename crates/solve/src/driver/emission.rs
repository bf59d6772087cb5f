//! Emission: what surfaces and luminaires of a scene emit, one light group after the other.

use std::sync::Arc;

use radiosity_elements::Element;
use radiosity_elements::coating::Coating;
use radiosity_light::emitters::{Emitters, Radiances};
use radiosity_light::first_bounce::DirectLightEntry;
use radiosity_light::point_lights::PointLights;
use radiosity_published::zatz1993::masked_light::MaskedLight;
use radiosity_scene::Scene;

use crate::checks::{Balance, BandLight};
use crate::solution::group_light::GroupLight;
use crate::system::Coefficients;

/// The emission of one light group, not dimmed.
#[derive(Debug)]
pub(super) struct Emission {
    /// Name of the group; None for surfaces and luminaires without a group.
    pub group: Option<String>,
    /// Reflectance of all elements and exitance of those of the group, per band.
    pub coatings: Vec<Coating>,
    /// The luminaires of the group.
    pub points: PointLights,
    /// Radiances that openings see, of all groups.
    pub radiances: Radiances,
}

impl Emission {
    /// Every group of `scene` that emits, and what emits without a group; at least one, which may be dark.
    /// Those of a frame are those of the scene that moves, dimmed to nothing or not.
    pub(super) fn all(scene: &Scene, elements: &[Element]) -> Vec<Self> {
        let mut groups: Vec<Option<&str>> =
            scene.light_groups().iter().map(|group| Some(group.name.as_str())).collect();
        let surfaces = || scene.surfaces.iter().any(|own| own.is_in(None) && own.is_source());
        let luminaires = || scene.luminaires.iter().any(|own| own.is_in(None) && own.is_source());
        if groups.is_empty() || surfaces() || luminaires() {
            groups.push(None);
        }
        let reflecting: Vec<Coating> =
            (0..scene.bands.len()).map(|band| Coating::reflecting(scene, elements, band)).collect();
        let radiances = Radiances::of(scene);
        let of = |group: Option<&str>| Self {
            group: group.map(str::to_owned),
            coatings: reflecting
                .iter()
                .enumerate()
                .map(|(band, own)| own.with_group(scene, elements, band, group))
                .collect(),
            points: PointLights::of_group(scene, group),
            radiances: radiances.clone(),
        };
        groups.into_iter().map(of).collect()
    }

    /// The coatings, band by band.
    pub(super) fn list(&self) -> Vec<&Coating> {
        self.coatings.iter().collect()
    }

    /// The emitters, whose surfaces are cut into `elements`.
    pub(super) fn emitters<'a>(&'a self, elements: &'a [Element]) -> Emitters<'a> {
        Emitters { elements, coatings: self.list(), radiances: &self.radiances, points: &self.points }
    }

    /// The light of this emission, which entered by `entry`, with the balance of its power.
    pub(super) fn lit(
        self,
        balance: &Balance,
        entry: &DirectLightEntry,
        light: Vec<Coefficients>,
        masked: Option<Arc<MaskedLight>>,
    ) -> GroupLight {
        let bands = self.coatings.iter().zip(&light).enumerate();
        let own: Vec<BandLight<'_>> = bands
            .map(|(band, (coating, coefficients))| {
                let flux = self.points.flux(band);
                BandLight { coating, flux, coefficients }
            })
            .collect();
        let powers = balance.powers(&own, entry);
        let bands = light.into_iter().map(Coefficients::into).collect();
        GroupLight { group: self.group, bands, powers, masked }
    }

    /// Whether the same elements and luminaires emit as much in `other`.
    pub(super) fn emits_as(&self, other: &Self) -> bool {
        let mut coatings = self.coatings.iter().zip(&other.coatings);
        let is_same =
            self.group == other.group && self.points == other.points && self.radiances == other.radiances;
        is_same && coatings.all(|(own, other)| own.emits_as(other))
    }

    /// The coatings of all `emissions`, band by band.
    pub(super) fn by_band(emissions: &[Self]) -> Vec<Vec<&Coating>> {
        let bands = emissions.first().map_or(0, |emission| emission.coatings.len());
        (0..bands).map(|band| emissions.iter().map(|emission| &emission.coatings[band]).collect()).collect()
    }
}
