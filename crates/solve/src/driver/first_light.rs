//! The light that comes straight from emitters, and its first bounce, where they are masked or split off.

use std::sync::Arc;

use radiosity_elements::Elements;
use radiosity_elements::coating::Coating;
use radiosity_elements::patch::Node;
use radiosity_light::emitters::Emitters;
use radiosity_light::first_bounce::{
    Bounce, CoatedBounce, DirectLightEntry, GivenLight, NumberedNode, arrived, lit_by,
};
use radiosity_published::bases::Subspace;
use radiosity_published::zatz1993::mask_setting::Setting;
use radiosity_published::zatz1993::masked_light::MaskedLight;
use radiosity_published::zatz1993::masked_pairs::{MaskedPairs, ReflectedLight};
use radiosity_scene::Scene;
use radiosity_visibility::Visibility;
use radiosity_work::ranks::Ranks;

use super::direct::DirectWay;
use super::emission::Emission;
use super::options::Options;
use crate::gather::direct_by_rays::DirectByRays;
use crate::system::Coefficients;
use crate::tolerances::POINT_OVER_BLOCK;

/// The scene, as direct light is computed from it.
#[derive(Clone, Copy, Debug)]
pub(super) struct LitScene<'a> {
    pub scene: &'a Scene,
    pub elements: &'a Elements,
    pub visibility: &'a Visibility,
    pub options: &'a Options,
    pub ranks: &'a Ranks,
}

/// The first light of all emissions of a scene.
#[derive(Debug)]
pub(super) struct FirstLight {
    /// Knowledge of direct light; split off where it is masked.
    way: DirectWay,
    emissions: Vec<Emission>,
    sources: Vec<EmissionLight>,
}

/// The first light of one emission.
#[derive(Debug)]
struct EmissionLight {
    masks: Option<Arc<MaskedPairs>>,
    masked: Option<Arc<MaskedLight>>,
    direct: DirectEntry,
}

/// Ways in which the direct light of a source enters the system, whatever reflects it.
#[derive(Debug)]
enum DirectEntry {
    Carried,
    /// Direct irradiance that enters as in [`DirectLightEntry::Lit`].
    Lit(Vec<Vec<f64>>),
    /// Direct irradiance that enters as in [`DirectLightEntry::Arrived`].
    Arrived(Vec<Vec<f64>>),
    Split(CoatedBounce),
}

/// The first light of one emission for certain reflectances.
#[derive(Debug)]
pub(super) struct EnteringLight {
    /// The masks, where light is masked.
    pub masks: Option<Arc<MaskedPairs>>,
    pub masked: Option<Arc<MaskedLight>>,
    pub entry: DirectLightEntry,
}

impl EnteringLight {
    /// Whether light that emitters reflect goes through masks.
    pub(super) fn is_reflected(&self) -> bool {
        self.masks.as_ref().is_some_and(|masks| masks.reflect())
    }

    /// This light of `emission` where the solution `light` of all bands tells what emitters reflect through
    /// masks. It is unchanged where none do.
    pub(super) fn again(self, lit_scene: &LitScene<'_>, emission: &Emission, light: &[Coefficients]) -> Self {
        let Some(masks) = self.masks.as_ref().filter(|masks| masks.reflect()) else { return self };
        let DirectLightEntry::Split(Bounce { apart, .. }) = &self.entry else { return self };
        let elements = lit_scene.elements;
        let starts = elements.starts();
        let bands = || emission.coatings.iter().zip(light);
        let reflected =
            |(coating, own): (&Coating, &Coefficients)| coating.reflected(&starts, &own.irradiance);
        let again = |(coating, own): (&Coating, &Coefficients)| {
            let later: Vec<f64> = own.irradiance.iter().zip(&own.direct).map(|(h, d)| h - d).collect();
            coating.reflected(&starts, &later)
        };
        let reflected = ReflectedLight {
            all: bands().map(reflected).collect(),
            again: bands().map(again).collect(),
            once: apart,
        };
        let sources = emission.emitters(elements.list());
        let masked = masks.light(elements, &sources.coatings, Some(&reflected));
        let bounce = bounce_through_masks(lit_scene, &sources, masks, &masked);
        let bounce = bounce.repainted(&sources.coatings, &sources.coatings);
        let entry = DirectLightEntry::Split(bounce.expect("the coatings are those it was made for"));
        Self { entry, masked: Some(Arc::new(masked)), ..self }
    }

    /// This light, projected on the functions of a subspace.
    pub(super) fn within(self, subspace: &Subspace) -> Self {
        let projected = |bands: Vec<Vec<f64>>| bands.iter().map(|own| subspace.projected(own)).collect();
        let entry = match self.entry {
            DirectLightEntry::Carried => DirectLightEntry::Carried,
            DirectLightEntry::Lit(lit) => DirectLightEntry::Lit(projected(lit)),
            DirectLightEntry::Arrived(direct) => DirectLightEntry::Arrived(projected(direct)),
            DirectLightEntry::Split(Bounce { direct, reflected, apart }) => {
                let [direct, reflected] = [direct, reflected].map(projected);
                let apart = apart.into_iter().map(|(element, own)| (element, projected(own))).collect();
                DirectLightEntry::Split(Bounce { direct, reflected, apart })
            }
        };
        Self { entry, ..self }
    }
}

impl FirstLight {
    /// Whether light that emitters reflect goes through masks.
    pub(super) fn is_reflected(&self) -> bool {
        self.sources.iter().any(|own| own.masks.as_ref().is_some_and(|masks| masks.reflect()))
    }

    /// The emissions whose light this is.
    pub(super) fn emissions(&self) -> &[Emission] {
        &self.emissions
    }

    /// Whether direct light is known apart.
    pub(super) fn is_apart(&self) -> bool {
        self.way != DirectWay::Carried
    }

    /// The first light of other `emissions`, known in the way of this one.
    pub(super) fn anew(&self, lit_scene: &LitScene<'_>, emissions: Vec<Emission>) -> Self {
        Self::by(lit_scene, emissions, self.way)
    }

    /// The first light of `emissions`, known in this way.
    pub(super) fn by(lit_scene: &LitScene<'_>, emissions: Vec<Emission>, way: DirectWay) -> Self {
        let masks = masked_pairs(lit_scene, &emissions).map(Arc::new);
        let of = |emission| EmissionLight::of(lit_scene, emission, masks.clone(), way);
        let sources = emissions.iter().map(of).collect();
        Self { way, emissions, sources }
    }

    /// The first light of each of `emissions` on surfaces of other reflectances. None where it has to be
    /// computed anew.
    pub(super) fn reflected(&self, emissions: &[Emission]) -> Option<Vec<EnteringLight>> {
        if self.emissions.len() != emissions.len() {
            return None;
        }
        let own = self.emissions.iter().zip(&self.sources).zip(emissions);
        own.map(|((old, source), new)| source.reflected(old, new)).collect()
    }
}

impl EmissionLight {
    /// The source of an emission, of whose direct light is known what `way` says.
    fn of(
        lit_scene: &LitScene<'_>,
        emission: &Emission,
        masks: Option<Arc<MaskedPairs>>,
        way: DirectWay,
    ) -> Self {
        let LitScene { elements, visibility, options, ranks, .. } = *lit_scene;
        let sources = emission.emitters(elements.list());
        let masked = masks.as_ref().map(|masks| masks.light(elements, &sources.coatings, None));
        let eps = POINT_OVER_BLOCK * options.shadow_eps;
        let direct = match (masks.as_ref().zip(masked.as_ref()), way) {
            (Some((masks, masked)), _) => {
                DirectEntry::Split(bounce_through_masks(lit_scene, &sources, masks, masked))
            }
            (None, DirectWay::Arrived) => {
                let rays =
                    DirectByRays::of(elements, &sources, visibility, options.ray_budget(lit_scene.scene));
                let lit = |element: usize, own: &NumberedNode<'_>| rays.at(element, own);
                DirectEntry::Arrived(arrived(&sources, visibility, &lit, ranks))
            }
            (None, DirectWay::Split) => {
                DirectEntry::Split(CoatedBounce::new(&sources, visibility, eps, ranks))
            }
            (None, DirectWay::Carried) if sources.points.is_empty() => DirectEntry::Carried,
            (None, DirectWay::Carried) => DirectEntry::Lit(lit_by(&sources, visibility, ranks)),
        };
        Self { masks, masked: masked.map(Arc::new), direct }
    }

    /// The light for the reflectances of the emission `new`, where this is that of `old` in all else.
    fn reflected(&self, old: &Emission, new: &Emission) -> Option<EnteringLight> {
        if !old.emits_as(new) {
            return None;
        }
        let entry = match &self.direct {
            DirectEntry::Carried => DirectLightEntry::Carried,
            DirectEntry::Lit(lit) => DirectLightEntry::Lit(lit.clone()),
            DirectEntry::Arrived(direct) => DirectLightEntry::Arrived(direct.clone()),
            DirectEntry::Split(bounce) => {
                DirectLightEntry::Split(bounce.repainted(&old.list(), &new.list())?)
            }
        };
        Some(EnteringLight { masks: self.masks.clone(), masked: self.masked.clone(), entry })
    }
}

fn bounce_through_masks(
    lit_scene: &LitScene<'_>,
    sources: &Emitters<'_>,
    masks: &MaskedPairs,
    masked: &MaskedLight,
) -> CoatedBounce {
    let list = sources.elements;
    let lit = |element: usize, node: &Node| {
        let parameters = node.parameters.to_array();
        let at = |band| masked.at(band, list, element, node.position, parameters);
        (0..sources.coatings.len()).map(at).collect()
    };
    let light = GivenLight { lit: &lit, apart: &masks.reflecting() };
    CoatedBounce::of(sources, lit_scene.visibility, light, lit_scene.options.shadow_eps, lit_scene.ranks)
}

/// The masked pairs of a scene with these emissions, where masks are asked for.
fn masked_pairs(lit_scene: &LitScene<'_>, emissions: &[Emission]) -> Option<MaskedPairs> {
    let LitScene { scene, elements, visibility, options, ranks } = *lit_scene;
    let how = options.masks?;
    let open = Visibility::open(scene);
    let coatings: Vec<&Coating> = emissions.iter().flat_map(Emission::list).collect();
    let setting = Setting {
        elements,
        coatings: &coatings,
        chosen: &scene.masks,
        visibility,
        open: &open,
        accuracy: options.accuracy(),
        rules: options.kernel,
    };
    Some(MaskedPairs::new(&setting, how, ranks))
}
