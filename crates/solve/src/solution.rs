//! The solution: polynomials of irradiance and radiosity on every element, per band.
//!
//! E(x) = Σ_k h_k φ_k(x) is the irradiance, B(x) = E₀ + ρ E(x) the radiosity, both in W m⁻²; the coefficients
//! h_k are in W m⁻² times length. Where direct light goes through shadow masks
//! ([`radiosity_published::zatz1993::masked_light`]), E is that light plus the polynomials of the rest.
//!
//! Where a scene has light groups, the light of each is kept ([`group_light`]), and the whole follows from it
//! at any factors.

pub mod powers;
pub mod group_light;

use std::sync::Arc;

use radiosity_core::dot;
use radiosity_elements::Elements;
use radiosity_elements::coating::Coating;
use radiosity_geom::DVec3;
use radiosity_light::emitters::{Emitters, Radiances};
use radiosity_light::point_lights::PointLights;
use radiosity_light::reflected::scale;
use radiosity_published::zatz1993::masked_light::MaskedLight;
use radiosity_scene::Scene;
use radiosity_work::ranks::vector;
use serde::{Deserialize, Serialize};

use crate::system::Coefficients;

use group_light::{DimmedGroup, GroupLight, Incident};
use powers::Powers;

/// A place on a surface.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct SurfacePlace {
    /// Index of the surface.
    pub surface: usize,
    /// Parameters of the place, in [−1, 1]².
    pub parameters: [f64; 2],
    /// Point of the place (scene length).
    #[serde(with = "vector")]
    pub position: DVec3,
}

/// Irradiance and radiosity of a scene.
#[derive(Clone, Debug)]
pub struct Solution {
    elements: Arc<Elements>,
    bands: Vec<Band>,
    /// The luminaires and the sun, at their factors.
    points: PointLights,
    /// Radiances that openings to a sky see.
    radiances: Radiances,
    masked: Option<MaskedLight>,
    /// The light of each group, where the scene has any.
    groups: Arc<[GroupLight]>,
    powers: Option<Powers>,
    /// The light that is reflected towards readers, where it is other than this: one reflection less.
    sent: Option<Box<Self>>,
}

/// The solution in one band.
#[derive(Clone, Debug)]
pub struct Band {
    /// Name of the band.
    pub name: String,
    /// Reflectance and exitance per element.
    pub coating: Coating,
    /// Coefficients in the orthonormal bases, element by element.
    pub coefficients: Coefficients,
    /// Coefficients of the irradiance in the raw polynomials, per element, for evaluation.
    raw: Vec<Vec<f64>>,
    /// Coefficients of the reflected irradiance in the raw polynomials, per element: `raw` without the light
    /// that comes straight from the emitters.
    raw_indirect: Vec<Vec<f64>>,
}

/// Coefficients in the raw polynomials of each element.
fn raw(elements: &Elements, coefficients: &[f64]) -> Vec<Vec<f64>> {
    let mut rest = coefficients;
    let mut raw = Vec::with_capacity(elements.list().len());
    for element in elements.list() {
        let (own, others) = rest.split_at(element.basis.len());
        raw.push(element.basis.to_raw(own));
        rest = others;
    }
    raw
}

impl Band {
    /// A band with its coefficients over `elements`.
    pub fn new(name: String, elements: &Elements, coating: Coating, coefficients: Coefficients) -> Self {
        let Coefficients { irradiance, direct, .. } = &coefficients;
        let indirect: Vec<f64> = irradiance.iter().zip(direct).map(|(h, d)| h - d).collect();
        let (raw, raw_indirect) = (raw(elements, irradiance), raw(elements, &indirect));
        Self { name, coating, coefficients, raw, raw_indirect }
    }
}

/// The factors of `groups` in `scene`; 1 for light of no group.
fn factors(scene: &Scene, groups: &[GroupLight]) -> Vec<f64> {
    let known = scene.light_groups();
    let factor = |group: &GroupLight| {
        let own = known.iter().find(|own| Some(own.name.as_str()) == group.group.as_deref());
        own.map_or(1.0, |own| own.factor)
    };
    groups.iter().map(factor).collect()
}

impl Solution {
    /// The solution of all bands over `elements`, in a scene without luminaires and sky.
    pub fn new(elements: impl Into<Arc<Elements>>, bands: Vec<Band>) -> Self {
        let elements = elements.into();
        Self {
            elements,
            bands,
            points: PointLights::default(),
            radiances: Radiances::default(),
            masked: None,
            groups: Arc::default(),
            powers: None,
            sent: None,
        }
    }

    /// A solution of other light over the same elements.
    pub fn with_bands(&self, bands: Vec<Band>) -> Self {
        Self::new(Arc::clone(&self.elements), bands)
    }

    /// The light of `groups` together, at their factors in `scene`, of which `elements` are. It stays apart
    /// where the scene has light groups.
    pub fn of_groups(
        elements: impl Into<Arc<Elements>>,
        scene: &Scene,
        groups: impl Into<Arc<[GroupLight]>>,
    ) -> Self {
        let (elements, groups) = (elements.into(), groups.into());
        let factors = factors(scene, &groups);
        let coating = |band: usize| Coating::of(scene, elements.list(), band);
        let lit = factors.into_iter().zip(groups.iter());
        let lit: Vec<DimmedGroup> = lit.map(|(factor, light)| DimmedGroup { light, factor }).collect();
        let whole = Self::together(Arc::clone(&elements), scene, &lit, &coating, PointLights::of(scene));
        let is_apart = groups.iter().any(|group| group.group.is_some());
        Self { groups: if is_apart { groups } else { Arc::default() }, ..whole }
    }

    /// The light of one of its groups alone ([`Solution::groups`]), not dimmed, in the scene of this
    /// solution.
    pub fn of_group(&self, scene: &Scene, group: &GroupLight) -> Self {
        let name = group.group.as_deref();
        let coating = |band: usize| Coating::of_group(scene, self.elements.list(), band, name);
        let points = PointLights::of_group(scene, name);
        let lit = [DimmedGroup { light: group, factor: 1.0 }];
        Self::together(Arc::clone(&self.elements), scene, &lit, &coating, points)
    }

    /// The light of groups at these factors, with the coating of each band and the luminaires.
    fn together(
        elements: Arc<Elements>,
        scene: &Scene,
        lit: &[DimmedGroup],
        coating: &dyn Fn(usize) -> Coating,
        points: PointLights,
    ) -> Self {
        let factors: Vec<f64> = lit.iter().map(|group| group.factor).collect();
        let bands: Vec<Band> = (0..scene.bands.len())
            .map(|band| {
                let parts = lit.iter().map(|group| &group.light.bands[band]);
                let Incident { irradiance, direct, residual } = Incident::together(&factors, parts);
                let coating = coating(band);
                let list = elements.list();
                let whole = Coefficients::of_irradiance(list, &coating, irradiance, direct, residual);
                Band::new(scene.bands[band].clone(), &elements, coating, whole)
            })
            .collect();
        let masks = lit.iter().filter_map(|group| Some((group.factor, group.light.masked.as_deref()?)));
        let masked = MaskedLight::together(masks);
        let powers = lit.iter().map(|group| group.factor * group.light.powers);
        let powers = powers.reduce(|sum, part| sum + part);
        let radiances = Radiances::of(scene);
        let groups = Arc::default();
        Self { elements, bands, points, radiances, masked, groups, powers, sent: None }
    }

    /// The solution at the factors of the groups of `scene`. None if the light of its groups is not kept
    /// apart.
    pub fn relight(&self, scene: &Scene) -> Option<Self> {
        let wanted = scene.light_groups();
        if wanted.is_empty() {
            return Some(self.clone());
        }
        let is_kept = |name: &str| self.groups.iter().any(|group| group.group.as_deref() == Some(name));
        let all = wanted.iter().all(|group| is_kept(&group.name));
        all.then(|| Self::of_groups(Arc::clone(&self.elements), scene, Arc::clone(&self.groups)))
    }

    /// The solution as light of the first reflections alone; `before` is that of one reflection less, None if
    /// nothing was reflected. It has no groups.
    pub(crate) fn truncated(self, before: Option<Self>) -> Self {
        let sent = before.unwrap_or_else(|| {
            let black = |band: &Band| Band { coating: band.coating.black(), ..band.clone() };
            self.with_bands(self.bands.iter().map(black).collect())
        });
        Self { groups: Arc::default(), sent: Some(Box::new(sent)), ..self }
    }

    /// The solution whose light surfaces reflect towards readers that gather: this one, or one of fewer
    /// reflections.
    pub(crate) fn sent(&self) -> &Self {
        self.sent.as_deref().unwrap_or(self)
    }

    /// Whether the solution is light of the first reflections alone.
    pub(crate) fn is_truncated(&self) -> bool {
        self.sent.is_some()
    }

    /// The light of each group, not dimmed; empty in scenes without groups.
    pub fn groups(&self) -> &[GroupLight] {
        &self.groups
    }

    /// The light of each group, to be kept.
    pub fn shared_groups(&self) -> Arc<[GroupLight]> {
        Arc::clone(&self.groups)
    }

    /// The light of each group; of all together where the scene has none. None where direct light goes
    /// through masks.
    pub(crate) fn light(&self) -> Option<Vec<GroupLight>> {
        if self.masked.is_some() {
            return None;
        }
        if !self.groups.is_empty() {
            return Some(self.groups.to_vec());
        }
        let incident = |band: &Band| Incident::from(band.coefficients.clone());
        Some(vec![GroupLight {
            group: None,
            bands: self.bands.iter().map(incident).collect(),
            powers: self.powers.unwrap_or_default(),
            masked: None,
        }])
    }

    /// The balance of power of all groups together, at their factors; None if it was made of bands
    /// ([`Solution::new`]).
    pub(crate) fn powers(&self) -> Option<Powers> {
        self.powers
    }

    /// Mean radiosity (W m⁻²) of each band over the scene, by which errors are judged; 1 where nothing shines.
    pub(crate) fn mean_radiosity(&self) -> Vec<f64> {
        let sent = |band: &Band| scale(self.elements.list(), band.coefficients.radiosity.iter().copied());
        self.bands.iter().map(sent).collect()
    }

    /// Mean irradiance (W m⁻²) of each band over all surfaces.
    pub fn mean_arriving(&self) -> Vec<f64> {
        let area: f64 = self.elements.list().iter().map(|element| element.area).sum();
        let ones = self.elements.constant();
        let arriving = |band: &Band| dot(&band.coefficients.irradiance, &ones) / area;
        self.bands.iter().map(arriving).collect()
    }

    /// Direct light with its shadow masks, where there are any.
    pub fn masked(&self) -> Option<&MaskedLight> {
        self.masked.as_ref()
    }

    /// The elements that carry the polynomials.
    pub fn elements(&self) -> &Elements {
        &self.elements
    }

    /// The elements, to be kept.
    pub(crate) fn shared_elements(&self) -> Arc<Elements> {
        Arc::clone(&self.elements)
    }

    /// Relative residual of the linear systems, largest over the bands.
    pub(crate) fn residual(&self) -> f64 {
        self.bands.iter().map(|band| band.coefficients.residual).fold(0.0, f64::max)
    }

    /// The bands, in the scene's order.
    pub fn bands(&self) -> &[Band] {
        &self.bands
    }

    /// Reflectance and exitance per element, band after band.
    pub fn coatings(&self) -> Vec<&Coating> {
        self.bands.iter().map(|band| &band.coating).collect()
    }

    /// The emitters: the elements with their coatings, and the luminaires.
    pub fn emitters(&self) -> Emitters<'_> {
        Emitters {
            elements: self.elements.list(),
            coatings: self.coatings(),
            radiances: &self.radiances,
            points: &self.points,
        }
    }

    /// Irradiance (W m⁻²) of one band on element `element`, at a place of its surface.
    pub fn irradiance(&self, band: usize, element: usize, place: &SurfacePlace) -> f64 {
        if let Some(masked) = &self.masked {
            let list = self.elements.list();
            let direct = masked.at(band, list, element, place.position, place.parameters);
            return direct + self.indirect(band, element, place);
        }
        let raw = &self.bands[band].raw[element];
        self.elements.list()[element].evaluate(raw, place.position, place.parameters)
    }

    /// Mean irradiance (W m⁻²) of one band over surface `surface`: Σ_k h_k ∫φ_k dA / A.
    pub fn mean_irradiance(&self, band: usize, surface: usize) -> f64 {
        let list = self.elements.list();
        let own = self.elements.of_surface(surface);
        let start: usize = list[..own.start].iter().map(|element| element.basis.len()).sum();
        let integrals = list[own.clone()].iter().flat_map(|element| &element.constant);
        let power: f64 =
            integrals.zip(&self.bands[band].coefficients.irradiance[start..]).map(|(c, h)| c * h).sum();
        power / list[own].iter().map(|element| element.area).sum::<f64>()
    }

    /// Irradiance (W m⁻²) that was reflected at least once, of one band on element `element`.
    pub fn indirect(&self, band: usize, element: usize, place: &SurfacePlace) -> f64 {
        let raw = &self.bands[band].raw_indirect[element];
        self.elements.list()[element].evaluate(raw, place.position, place.parameters)
    }

    /// The irradiance of [`Solution::indirect`] of all bands, into `out`.
    pub fn indirect_bands(&self, element: usize, place: &SurfacePlace, out: &mut [f64]) {
        self.evaluate_bands(element, place, |band| &band.raw_indirect[element], out);
    }

    /// Irradiance (W m⁻²) of all bands on element `element` by its polynomials, into `out`.
    pub fn irradiance_bands(&self, element: usize, place: &SurfacePlace, out: &mut [f64]) {
        self.evaluate_bands(element, place, |band| &band.raw[element], out);
    }

    fn evaluate_bands<'a>(
        &'a self,
        element: usize,
        place: &SurfacePlace,
        raw: impl Fn(&'a Band) -> &'a [f64],
        out: &mut [f64],
    ) {
        let values = self.elements.list()[element].raw_values(place.position, place.parameters);
        for (band, out) in self.bands.iter().zip(out) {
            *out = dot(&values, raw(band));
        }
    }

    /// The element and the place on the other side of an element that lets light through in some band.
    pub fn behind(&self, element: usize, place: &SurfacePlace) -> Option<(usize, SurfacePlace)> {
        let behind = self.bands.iter().find_map(|band| band.coating.behind(element, place.parameters))?;
        Some((behind, SurfacePlace { surface: self.elements.list()[behind].surface, ..*place }))
    }

    /// Radiosity (W m⁻²) of one band on element `element`, at a place of its surface.
    pub fn radiosity(&self, band: usize, element: usize, place: &SurfacePlace) -> f64 {
        let behind = self.behind(element, place);
        let behind = behind.map_or(0.0, |(element, place)| self.irradiance(band, element, &place));
        let irradiance = self.irradiance(band, element, place);
        self.bands[band].coating.radiosity(element, place.parameters, irradiance, behind)
    }
}
