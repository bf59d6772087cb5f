//! A scene ready for blocks: its elements, its visibility and its first light.

use std::sync::Arc;

use radiosity_elements::Elements;
use radiosity_published::bases::Subspace;
use radiosity_scene::{MaskedPair, Scene, SceneSurface};
use radiosity_solvers::method::Access;
use radiosity_transport::Demand;
use radiosity_visibility::Visibility;
use radiosity_work::ranks::Ranks;
use radiosity_work::wording::{option, set};
use radiosity_work::{Allowance, Stage, Work};

use super::column_choice::ColumnChoice;
use super::decisions::{AssemblyPlan, Decisions};
use super::direct::{Direct, Transfers};
use super::emission::Emission;
use super::failure::Failure;
use super::first_light::{EnteringLight, FirstLight, LitScene};
use super::forecast::seconds_of_pairs;
use super::kept_model::KeptModel;
use super::light_method::LightMethod;
use super::options::Options;
use super::outcome::{Stages, timed};
use super::outline::Outline;
use super::shooting::Shooter;
use super::transport_choice::TransportChoice;
use crate::geometry::AssemblyGeometry;

/// A scene ready for blocks.
#[derive(Debug)]
pub(super) struct Ready {
    /// The scene from which it was made.
    pub scene: Scene,
    pub options: Options,
    pub elements: Arc<Elements>,
    pub visibility: Visibility,
    /// Span of the functions of the basis; None where they are those of the elements.
    pub subspace: Option<Subspace>,
    pub choice: TransportChoice,
    /// Rays that carry the pairs, if rays do.
    pub rays: Option<u64>,
    /// Direct light and its first bounce, for the emission of the scene.
    pub first: FirstLight,
    pub seconds: Stages,
}

impl Ready {
    /// The elements of `scene`, its visibility and first light.
    ///
    /// # Errors
    /// A scene that cannot be cut into elements, or memory that does not suffice.
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
            if elements_before.is_none() {
                decisions.require_memory(scene, options, before.is_some(), work.ranks)?;
            }
            let elements = elements(scene, &decisions, elements_before)?;
            let subspace = subspace(scene, options, &elements);
            Ok::<_, Failure>((elements, subspace))
        };
        let (elements, subspace) = timed(&mut seconds.elements, || work.during(Stage::Elements, cut))?;
        let Decisions { visibility, choice, rays, .. } = decisions;
        let sends = |element: usize| scene.surfaces[elements.list()[element].surface].material.sends();
        let geometry = AssemblyGeometry { scene, elements: &elements, wanted: &|a, b| sends(a) || sends(b) };
        // The choice may depend on time or memory, which no fingerprint holds.
        work.ranks.note_assembly(&(options.of_transfers(), choice.sampled, rays, geometry));
        let emissions = Emission::all(scene, elements.list());
        let lit_scene =
            LitScene { scene, elements: &elements, visibility: &visibility, options, ranks: work.ranks };
        let transfers = match options.kernel {
            _ if choice.sampled => Transfers::Rays,
            None => Transfers::Rules,
            Some(_) => Transfers::Changed,
        };
        let light = || work.during(Stage::Direct, || FirstLight::of(&lit_scene, emissions, transfers));
        let first = timed(&mut seconds.direct, light);
        Ok(Self {
            scene: scene.clone(),
            options: *options,
            elements,
            visibility,
            subspace,
            choice,
            rays,
            first,
            seconds,
        })
    }

    /// The first light of each emission: that of the scene it was assembled from, if it emits as much. With a
    /// subspace, light that enters apart is projected on it.
    pub(super) fn first_light(
        &self,
        scene: &Scene,
        emissions: &[Emission],
        ranks: &Ranks,
    ) -> Vec<EnteringLight> {
        let first = self.first.reflected(emissions).unwrap_or_else(|| {
            let lit_scene = self.lit_scene(scene, ranks);
            let anew = Emission::all(scene, self.elements.list());
            let first = self.first.anew(&lit_scene, anew);
            first.reflected(emissions).expect("the emission is the same")
        });
        match &self.subspace {
            None => first,
            Some(subspace) => first.into_iter().map(|own| own.within(subspace)).collect(),
        }
    }

    /// A scene of these surfaces, as direct light is computed from it.
    pub(super) fn lit_scene<'a>(&'a self, scene: &'a Scene, ranks: &'a Ranks) -> LitScene<'a> {
        let Self { elements, visibility, options, .. } = self;
        LitScene { scene, elements, visibility, options, ranks }
    }

    /// The shooter of the light of a scene of these surfaces.
    pub(super) fn shooter<'a>(
        &'a self,
        scene: &'a Scene,
        emissions: &'a [Emission],
        first: &'a [EnteringLight],
    ) -> Shooter<'a> {
        let elements = self.elements.list();
        Shooter { names: &scene.bands, elements, emissions, first, options: &self.options }
    }

    /// Why all columns have to be integrated before the first shot of a solver that shoots, if they have to.
    pub(super) fn all_first(&self, ranks: &Ranks) -> Option<&'static str> {
        let Self { options, subspace, choice, .. } = self;
        Some(match options {
            _ if choice.sampled => "rays carry the light",
            Options { kernel: Some(_), .. } => "the rules of 1993 make the whole matrix",
            Options { method: LightMethod::Collocation, .. } => "collocation makes whole rows",
            _ if subspace.is_some() => "functions of the basis reach over elements",
            _ if !ranks.are_alone() => "several processes share the blocks",
            _ if ranks.journal().is_some() => "blocks are kept in a file",
            _ if self.first.is_reflected() => "masks of what emitters reflect take the light of all",
            Options { columns: Some(ColumnChoice::All), .. } => "that was asked for",
            _ => return None,
        })
    }

    /// Whether the light is shot, each column integrated when it is first shot.
    ///
    /// # Errors
    /// [`Failure::AllFirst`] where that is asked for and cannot be.
    pub(super) fn is_lazy(&self, ranks: &Ranks) -> Result<bool, Failure> {
        let shoots = self.options.solver.access == Access::Columns && self.options.bounces.is_none();
        match self.all_first(ranks) {
            Some(why) if shoots && self.options.columns == Some(ColumnChoice::Shot) => {
                Err(Failure::AllFirst { why })
            }
            all_first => Ok(shoots && all_first.is_none()),
        }
    }

    /// About the seconds that its blocks take two threads.
    pub(super) fn seconds_of_pairs(&self) -> f64 {
        seconds_of_pairs(&self.scene, &self.elements, &self.visibility, self.rays)
    }

    /// Whether an element sends light.
    pub(super) fn sends(&self, element: usize) -> bool {
        self.scene.surfaces[self.elements.list()[element].surface].material.sends()
    }

    /// The pairs of which an element is `wanted` that sends light.
    pub(super) fn demand<'a>(&'a self, wanted: &'a (dyn Fn(usize, usize) -> bool + Sync)) -> Demand<'a> {
        Demand::all(&self.elements, &self.visibility, self.options.accuracy()).of(wanted)
    }
}

/// Refuses what cannot carry the light of luminaires or of a sky.
pub(super) fn require_diffuse(scene: &Scene, options: &Options) -> Result<(), Failure> {
    require_even(scene, options)?;
    let shines = scene.luminaires.iter().find(|own| own.emits()).filter(|_| options.masks.is_some());
    if let Some(own) = shines {
        return Err(Failure::Unmasked { luminaire: own.name.clone() });
    }
    let is_frame = scene.source.as_ref().is_some_and(|own| own.moment.is_some());
    if options.masks.is_some() && !is_frame {
        scene.masks.iter().try_for_each(|pair| require_light_between(scene, pair))?;
    }
    let what = match options {
        Options { masks: Some(_), .. } => set("shadows", "mask"),
        Options { direct: Direct::Projected, .. } => set("direct", "projected"),
        Options { kernel: Some(_), .. } => option("kernel") + " with the rules of 1993",
        _ => return Ok(()),
    };
    match scene.surfaces.iter().find(|own| own.radiance.is_some()) {
        Some(own) => {
            let light = if own.is_opening() { "an opening to a sky" } else { "a luminaire" };
            Err(Failure::NotDiffuse { surface: own.name.clone(), light, what })
        }
        None => Ok(()),
    }
}

/// Refuses a pair that was chosen for a mask and that no light goes between.
fn require_light_between(scene: &Scene, pair: &MaskedPair) -> Result<(), Failure> {
    let refused = |why| {
        let MaskedPair { emitter, receiver, .. } = pair;
        Err(Failure::NoMask { emitter: emitter.clone(), receiver: receiver.clone(), why })
    };
    let sending = pair.emitters.iter().copied().filter(|own| scene.surfaces[*own].material.sends());
    let sending: Vec<usize> = sending.collect();
    if sending.is_empty() {
        return refused("the emitter sends no light, it neither emits nor reflects");
    }
    let outlines = |list: &[usize]| list.iter().map(|own| Outline::of(&scene.surfaces[*own])).collect();
    let [emitters, receivers]: [Vec<Outline>; 2] = [&sending, &pair.receivers].map(|list| outlines(list));
    let receives = |emitter: &Outline| receivers.iter().any(|own| own.exchanges_with(emitter));
    match emitters.iter().any(receives) {
        true => Ok(()),
        false => refused("their fronts do not see each other"),
    }
}

/// Refuses functions over several elements where S does not commute with their projection: power would be
/// lost.
fn require_even(scene: &Scene, options: &Options) -> Result<(), Failure> {
    let basis = options.basis;
    if basis.is_elementwise() {
        return Ok(());
    }
    let varies = |own: &&SceneSurface| own.material.reflectance_pattern.is_some() || own.material.transmits();
    match scene.surfaces.iter().find(varies) {
        Some(own) => Err(Failure::NotEven { surface: own.name.clone(), basis: basis.name() }),
        None => Ok(()),
    }
}

/// Span of the functions of the basis on `elements`; None where they are those of the elements.
fn subspace(scene: &Scene, options: &Options, elements: &Elements) -> Option<Subspace> {
    let degree = |surface: usize| scene.surfaces[surface].order.unwrap_or(options.order);
    Subspace::new(options.basis, elements, &degree, options.space)
}

/// The elements of `scene`; those that are known from `before`, where some surfaces stood elsewhere.
pub(super) fn elements(
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
