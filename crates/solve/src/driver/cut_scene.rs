//! A scene cut into elements, with all decisions about it: a solution and its forecast begin with it.

use std::sync::Arc;

use radiosity_elements::Elements;
use radiosity_light::emitters::Emitters;
use radiosity_published::bases::Subspace;
use radiosity_scene::Scene;
use radiosity_visibility::Visibility;
use radiosity_work::ranks::Ranks;
use radiosity_work::{Allowance, Stage, Work};

use super::decisions::{AssemblyPlan, Decisions};
use super::direct::{DirectWay, Transfers};
use super::emission::Emission;
use super::failure::Failure;
use super::first_light::LitScene;
use super::forecast::seconds_of_pairs;
use super::kept_model::KeptModel;
use super::options::Options;
use super::outcome::{Stages, timed};
use super::pair_rays;
use super::requirements::require_diffuse;
use super::transport_choice::TransportChoice;

/// A scene cut into elements.
#[derive(Debug)]
pub(super) struct CutScene {
    /// The scene from which it was made.
    pub scene: Scene,
    pub options: Options,
    pub elements: Arc<Elements>,
    /// Span of the functions of the basis; None where they are those of the elements.
    pub subspace: Option<Subspace>,
    pub visibility: Visibility,
    pub choice: TransportChoice,
    /// Rays that carry the pairs, if rays do.
    pub rays: Option<u64>,
    /// Bytes that a solution takes at the most, estimated; None where it follows that of another scene.
    pub bytes: Option<u64>,
    pub seconds: Stages,
}

impl CutScene {
    /// The elements of `scene`, as `plan` says; those of `before`, where some surfaces stood elsewhere.
    ///
    /// # Errors
    /// Options that the scene does not allow, a scene that cannot be cut into elements, or memory that does not
    /// suffice.
    pub(super) fn of(
        scene: &Scene,
        options: &Options,
        plan: AssemblyPlan<'_>,
        before: Option<&KeptModel>,
        work: &Work<'_>,
    ) -> Result<Self, Failure> {
        require_diffuse(scene, options)?;
        let mut seconds = Stages::default();
        let left = Allowance::of(work, work.ranks.threads(options.threads));
        let decide = || work.during(Stage::Visibility, || plan.decided(scene, options, left));
        let decisions = timed(&mut seconds.visibility, decide);
        let elements_before = before.and_then(|kept| kept.blocks.elements());
        let cut = || {
            // Scenes that follow need as much as the first one.
            let bytes = match elements_before {
                Some(_) => None,
                None => Some(decisions.require_memory(scene, options, before.is_some(), work.ranks)?),
            };
            let elements = elements(scene, &decisions, elements_before)?;
            let subspace = subspace(scene, options, &elements);
            Ok::<_, Failure>((elements, subspace, bytes))
        };
        let (elements, subspace, bytes) = timed(&mut seconds.elements, || work.during(Stage::Elements, cut))?;
        let Decisions { visibility, choice, rays, .. } = decisions;
        Ok(Self {
            scene: scene.clone(),
            options: *options,
            elements,
            subspace,
            visibility,
            choice,
            rays,
            bytes,
            seconds,
        })
    }

    /// Number of coefficients per band.
    pub(super) fn unknowns(&self) -> usize {
        self.subspace.as_ref().map_or_else(|| self.elements.coefficients(), Subspace::dim)
    }

    /// The scene, as direct light is computed from it.
    pub(super) fn lit_scene<'a>(&'a self, ranks: &'a Ranks) -> LitScene<'a> {
        let Self { scene, elements, visibility, options, .. } = self;
        LitScene { scene, elements, visibility, options, ranks }
    }

    /// The emissions of the scene.
    pub(super) fn emissions(&self) -> Vec<Emission> {
        Emission::all(&self.scene, self.elements.list())
    }

    /// The way in which direct light of `emissions` is known.
    pub(super) fn direct_way(&self, emissions: &[Emission]) -> DirectWay {
        let Self { elements, visibility, options, choice, .. } = self;
        let transfers = match options.kernel {
            _ if options.masks.is_some() => return DirectWay::Split,
            _ if choice.sampled => Transfers::Rays,
            None => Transfers::Rules,
            Some(_) => Transfers::Changed,
        };
        let all: Vec<Emitters<'_>> = emissions.iter().map(|own| own.emitters(elements.list())).collect();
        options.direct.way(&all, visibility, transfers)
    }

    /// About the seconds that its blocks take two threads.
    pub(super) fn seconds_of_pairs(&self, work: &Work<'_>) -> f64 {
        let Self { scene, elements, visibility, options, rays, .. } = self;
        let by_pairs = || pair_rays::transport(elements, visibility, options, work);
        match rays.and_then(|_| by_pairs()) {
            Some(transport) => pair_rays::seconds(&transport, elements),
            None => seconds_of_pairs(scene, elements, visibility, *rays),
        }
    }

    /// Whether an element sends light.
    pub(super) fn sends(&self, element: usize) -> bool {
        self.scene.surfaces[self.elements.list()[element].surface].material.sends()
    }
}

/// The elements of `scene`; those that are known from `before`, where some surfaces stood elsewhere.
fn elements(
    scene: &Scene,
    decisions: &Decisions<'_>,
    before: Option<&Elements>,
) -> Result<Arc<Elements>, Failure> {
    let elements = match (before, decisions.mesh.as_deref()) {
        (Some(before), _) => before.moved(scene),
        (None, Some(mesh)) => Elements::of_mesh(scene, &decisions.how, mesh.clone()),
        (None, None) => Elements::new(scene, &decisions.how),
    };
    Ok(Arc::new(elements?))
}

/// Span of the functions of the basis on `elements`; None where they are those of the elements.
fn subspace(scene: &Scene, options: &Options, elements: &Elements) -> Option<Subspace> {
    let degree = |surface: usize| scene.surfaces[surface].order.unwrap_or(options.order);
    Subspace::new(options.basis, elements, &degree, options.space)
}
