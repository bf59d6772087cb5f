//! The light that comes straight from emitters, and its first bounce, where they are masked or split off.

use std::sync::Arc;

use crate::elements::Elements;
use crate::elements::coating::Coating;
use crate::elements::patch::Node;
use crate::light::first_bounce::{Bounce, CoatedBounce};
use crate::scene::Scene;
use crate::visibility::{Shadows, Visibility};
use crate::zatz1993::masked_light::{MaskedLight, Setting};

use super::emission::Emission;
use super::options::Options;

/// Tolerance of gathered light at a point over that of shadows in a block, a mean of many. Chosen; not tuned.
const AT_A_POINT: f64 = 3.0;

/// What direct light is computed from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stage<'a> {
    pub scene: &'a Scene,
    pub elements: &'a Elements,
    pub visibility: &'a Visibility,
    pub options: &'a Options,
}

/// The first light of all emissions of a scene.
#[derive(Debug)]
pub(super) struct FirstLight {
    /// Whether direct light is masked or split off.
    pub is_split: bool,
    emissions: Vec<Emission>,
    sources: Vec<Source>,
}

/// The first light of one emission.
#[derive(Debug)]
struct Source {
    masked: Option<Arc<MaskedLight>>,
    bounce: Option<CoatedBounce>,
}

/// The first light of one emission for certain reflectances.
#[derive(Debug)]
pub(super) struct Reflected {
    pub masked: Option<Arc<MaskedLight>>,
    pub bounce: Option<Bounce>,
}

impl FirstLight {
    /// That of `emissions`; `by_rules` says whether the transfers are those of the default kernel without changes.
    pub(super) fn of(stage: &Stage<'_>, emissions: Vec<Emission>, by_rules: bool) -> Self {
        let Stage { elements, visibility, options, .. } = *stage;
        let all: Vec<&Coating> = emissions.iter().flat_map(|emission| &emission.coatings).collect();
        let is_split =
            options.masks.is_some() || options.direct.splits(elements.list(), &all, visibility, by_rules);
        Self::as_split(stage, emissions, is_split)
    }

    /// The same where it is known whether direct light is masked or split off.
    pub(super) fn as_split(stage: &Stage<'_>, emissions: Vec<Emission>, is_split: bool) -> Self {
        let sources = emissions.iter().map(|emission| Source::of(stage, emission, is_split)).collect();
        Self { is_split, emissions, sources }
    }

    /// The same light on surfaces of other reflectances, for each of `emissions`. None where it has to be computed
    /// anew.
    pub(super) fn reflected(&self, emissions: &[Emission]) -> Option<Vec<Reflected>> {
        if self.emissions.len() != emissions.len() {
            return None;
        }
        let own = self.emissions.iter().zip(&self.sources).zip(emissions);
        own.map(|((old, source), new)| source.reflected(old, new)).collect()
    }
}

impl Source {
    /// That of an emission; `is_split` says whether direct light is masked or split off.
    fn of(stage: &Stage<'_>, emission: &Emission, is_split: bool) -> Self {
        let Stage { scene, elements, visibility, options } = *stage;
        let coatings = emission.list();
        let masked = masked_light(scene, elements, &coatings, visibility, options);
        let bounce = match &masked {
            Some(masked) => Some(through_masks(stage, &coatings, masked)),
            None => is_split.then(|| {
                let eps = AT_A_POINT * options.shadow_eps;
                CoatedBounce::new(elements.list(), &coatings, visibility, eps)
            }),
        };
        Self { masked: masked.map(Arc::new), bounce }
    }

    /// For the reflectances of the emission `new`, where it is that of `old` in all else.
    fn reflected(&self, old: &Emission, new: &Emission) -> Option<Reflected> {
        if !old.emits_as(new) {
            return None;
        }
        let bounce = match &self.bounce {
            None => None,
            Some(bounce) => Some(bounce.repainted(&old.list(), &new.list())?),
        };
        Some(Reflected { masked: self.masked.clone(), bounce })
    }
}

fn through_masks(stage: &Stage<'_>, coatings: &[&Coating], masked: &MaskedLight) -> CoatedBounce {
    let list = stage.elements.list();
    let lit = |element: usize, node: &Node| {
        let parameters = node.parameters.to_array();
        let at = |band| masked.at(band, list, element, node.position, parameters);
        (0..coatings.len()).map(at).collect()
    };
    CoatedBounce::of(list, coatings, stage.visibility, &lit, stage.options.shadow_eps)
}

/// The masked direct light, where masks are asked for.
pub(crate) fn masked_light(
    scene: &Scene,
    elements: &Elements,
    coatings: &[&Coating],
    visibility: &Visibility,
    options: &Options,
) -> Option<MaskedLight> {
    let how = options.masks?;
    let open = Visibility::new(scene, Shadows::Off);
    let setting = Setting { elements, coatings, visibility, open: &open, accuracy: options.accuracy() };
    Some(MaskedLight::new(&setting, how))
}
