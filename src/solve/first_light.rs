//! The light that comes straight from emitters, and its first bounce, where they are masked or split off.

use std::sync::Arc;

use crate::elements::Elements;
use crate::elements::coating::Coating;
use crate::elements::patch::Node;
use crate::light::first_bounce::Bounce;
use crate::scene::Scene;
use crate::visibility::{Shadows, Visibility};
use crate::zatz1993::masked_light::{MaskedLight, Setting};

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

/// Masks of direct light, where asked for, and the first bounce, where direct light is masked or split off.
#[derive(Debug)]
pub(super) struct FirstLight {
    pub masked: Option<Arc<MaskedLight>>,
    pub bounce: Option<Bounce>,
}

impl FirstLight {
    /// That of emitters with one coating per band; `splits` says whether direct light without masks is split off.
    pub(super) fn of(stage: &Stage<'_>, coatings: &[&Coating], splits: bool) -> Self {
        let Stage { scene, elements, visibility, options } = *stage;
        let masked = masked_light(scene, elements, coatings, visibility, options);
        let bounce = match &masked {
            Some(masked) => Some(through_masks(stage, coatings, masked)),
            None => splits
                .then(|| Bounce::new(elements.list(), coatings, visibility, AT_A_POINT * options.shadow_eps)),
        };
        Self { masked: masked.map(Arc::new), bounce }
    }
}

fn through_masks(stage: &Stage<'_>, coatings: &[&Coating], masked: &MaskedLight) -> Bounce {
    let list = stage.elements.list();
    let lit = |element: usize, node: &Node| {
        let parameters = node.parameters.to_array();
        let at = |band| masked.at(band, list, element, node.position, parameters);
        (0..coatings.len()).map(at).collect()
    };
    Bounce::of(list, coatings, stage.visibility, &lit, stage.options.shadow_eps)
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
