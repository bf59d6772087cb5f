//! A model: the elements of a scene and the blocks between them, to be solved for any materials.
//!
//! G is geometry only. Reflectance and emission enter the system that is made of it, so that a change of
//! materials needs no new blocks. Light that was reflected once is linear in the reflectance of what
//! reflected it: where direct light is split off, a change of reflectance does not gather it anew. Only two
//! choices depend on the materials of the scene from which a model was assembled: which pairs are left
//! out because neither side ever sends light, and where rays were sent from.

use std::sync::Arc;
use std::time::Duration;

use radiosity_elements::Elements;
use radiosity_elements::mesh::Mesh;
use radiosity_kernel::Blocks;
use radiosity_published::bases::Subspace;
use radiosity_scene::{Scene, SceneSurface};
use radiosity_transport::KeptBlocks;
use radiosity_visibility::Visibility;
use radiosity_work::ranks::Ranks;
use radiosity_work::wording::{option, set};
use radiosity_work::{Progress, Stage, Work};

use crate::checks::{Balance, Checks};
use crate::solution::Solution;
use crate::solution::group_light::GroupLight;
use crate::system::Coefficients;

use super::assembly::carried;
use super::band_systems::{BandSystems, SolvedLight};
use super::decisions::{AssemblyPlan, Decisions, Layout};
use super::direct::Direct;
use super::emission::Emission;
use super::failure::Failure;
use super::first_light::{EnteringLight, FirstLight, LitScene};
use super::options::Options;
use super::outcome::{Outcome, Stages, timed};
use super::sampling::{Sampling, Subject};
use super::solve_band::SolveCost;
use super::transport_choice::TransportChoice;

/// The elements of a scene and the blocks between them.
///
/// ```
/// use radiosity_scene::{Material, Scene};
/// use radiosity_solve::{Model, Options};
/// use radiosity_work::Work;
///
/// let scene = radiosity_language::builtin("furnace-cube")?;
/// let model = Model::assemble(&scene, &Options::default(), &Work::alone())?;
/// // A closed room of reflectance ρ that emits 1 everywhere: 1 / (1 − ρ) arrives.
/// for reflectance in [0.25, 0.5, 0.75] {
///     let painted = scene.with_material("wall", Material::new(vec![reflectance], vec![1.0])?)?;
///     let outcome = model.solve(&painted, &Work::alone())?;
///     assert!((outcome.solution.mean_irradiance(0, 0) - 1.0 / (1.0 - reflectance)).abs() < 1e-2);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Model {
    /// The scene from which it was assembled.
    scene: Scene,
    options: Options,
    elements: Arc<Elements>,
    visibility: Visibility,
    blocks: Blocks,
    /// Span of the functions of the basis; None where they are those of the elements.
    subspace: Option<Subspace>,
    choice: TransportChoice,
    sampling: Option<Sampling>,
    /// Direct light and its first bounce, for the emission of the scene.
    first: FirstLight,
    seconds: Stages,
}

impl Model {
    /// Cuts `scene` into elements and computes the blocks between them.
    ///
    /// # Errors
    /// A scene that cannot be cut into elements, memory that does not suffice, or threads that cannot be
    /// started.
    pub fn assemble(scene: &Scene, options: &Options, work: &Work<'_>) -> Result<Self, Failure> {
        let plan = AssemblyPlan::default();
        options.in_threads(work.ranks, || Self::assembled(scene, options, plan, None, work))?
    }

    /// A model of this layout; blocks and rays that `kept` holds of earlier scenes, in which some surfaces
    /// stood elsewhere, are not computed again.
    ///
    /// # Errors
    /// As [`Model::assemble`].
    pub(crate) fn assemble_again(
        scene: &Scene,
        options: &Options,
        layout: &Layout,
        kept: Option<&mut KeptBlocks>,
        work: &Work<'_>,
    ) -> Result<Self, Failure> {
        options.in_threads(work.ranks, || Self::assembled(scene, options, layout.plan(), kept, work))?
    }

    /// Bytes that the model of `scene` and its solution take at the most on each of these ranks, estimated.
    pub fn peak_memory(scene: &Scene, options: &Options, ranks: &Ranks) -> u64 {
        AssemblyPlan::default().decided(scene, options).peak_memory(scene, options, ranks)
    }

    /// A model by exact blocks, for the reason `why`, between the elements of a refined mesh if there is one.
    pub(super) fn assemble_exactly(
        scene: &Scene,
        options: &Options,
        why: &str,
        mesh: Option<&Mesh>,
        work: &Work<'_>,
    ) -> Result<Self, Failure> {
        let choice = Some(TransportChoice { sampled: false, why: why.to_owned() });
        let plan = AssemblyPlan { choice, how: None, mesh };
        options.in_threads(work.ranks, || Self::assembled(scene, options, plan, None, work))?
    }

    fn assembled(
        scene: &Scene,
        options: &Options,
        plan: AssemblyPlan<'_>,
        mut kept: Option<&mut KeptBlocks>,
        work: &Work<'_>,
    ) -> Result<Self, Failure> {
        require_diffuse(scene, options)?;
        let ranks = work.ranks;
        let mut seconds = Stages::default();
        let decisions = timed(&mut seconds.visibility, || plan.decided(scene, options));
        // The choice may depend on time or memory, which no fingerprint holds.
        ranks.note_choice(&(options.neutral(), decisions.choice.sampled));
        work.report(Progress::Finished { stage: Stage::Visibility, took: seconds.visibility });
        decisions.require_memory(scene, options, kept.is_some(), ranks)?;
        let before = kept.as_ref().and_then(|kept| kept.elements());
        let elements = timed(&mut seconds.elements, || elements(scene, &decisions, before))?;
        let subspace = timed(&mut seconds.elements, || subspace(scene, options, &elements));
        work.report(Progress::Finished { stage: Stage::Elements, took: seconds.elements });
        let Decisions { visibility, choice, rays, .. } = decisions;
        let first = timed(&mut seconds.direct, || {
            let lit_scene = LitScene { scene, elements: &elements, visibility: &visibility, options, ranks };
            let by_rules = options.kernel.is_none() && !choice.sampled;
            FirstLight::of(&lit_scene, Emission::all(scene, elements.list()), by_rules)
        });
        if first.is_split {
            work.report(Progress::Finished { stage: Stage::Direct, took: seconds.direct });
        }
        let bands = &Emission::by_band(first.emissions());
        let entries = first.reflected(first.emissions()).expect("the emission is the same");
        let entries = &entries.into_iter().map(|own| own.entry).collect::<Vec<_>>();
        let subject = Subject { elements: &elements, bands, entries, visibility: &visibility, options, work };
        if let Some(kept) = &mut kept {
            kept.move_to(scene, &elements, &visibility);
        }
        let (blocks, sampling) = timed(&mut seconds.blocks, || carried(scene, &subject, rays, kept));
        work.report(Progress::Finished { stage: Stage::Blocks, took: seconds.blocks });
        let (scene, options) = (scene.clone(), *options);
        Ok(Self { scene, options, elements, visibility, blocks, subspace, choice, sampling, first, seconds })
    }

    /// Solves for the materials of `scene`, and the factors of its light groups. Its surfaces are those of
    /// the scene from which the model was assembled, such as [`Scene::with_material`] and [`Scene::dimmed`]
    /// keep them.
    ///
    /// # Errors
    /// [`Failure::OtherSurface`] and [`Failure::Unlit`] for a scene that the model is not made for; a linear
    /// solver that fails or does not converge, or threads that cannot be started.
    pub fn solve(&self, scene: &Scene, work: &Work<'_>) -> Result<Outcome, Failure> {
        self.check(scene)?;
        self.options.in_threads(work.ranks, || self.solved(scene, work))?
    }

    /// The elements of the model's surfaces.
    pub fn elements(&self) -> &Elements {
        &self.elements
    }

    /// The blocks between the elements.
    pub fn blocks(&self) -> &Blocks {
        &self.blocks
    }

    /// The visibility between the surfaces.
    pub fn visibility(&self) -> &Visibility {
        &self.visibility
    }

    /// The visibility between the surfaces, when nothing else of the model is needed any more.
    pub(crate) fn into_visibility(self) -> Visibility {
        self.visibility
    }

    /// This model with blocks that were corrected.
    pub fn with_blocks(self, blocks: Blocks) -> Self {
        Self { blocks, ..self }
    }

    /// Refuses a scene of other surfaces, and light from surfaces whose blocks were left out.
    fn check(&self, scene: &Scene) -> Result<(), Failure> {
        require_diffuse(scene, &self.options)?;
        let (own, given) = (&self.scene.surfaces, &scene.surfaces);
        let names = || given.iter().chain(own).map(|surface| surface.name.clone());
        if own.len() != given.len() || self.scene.bands != scene.bands {
            return Err(Failure::OtherSurface { surface: names().next_back().unwrap_or_default() });
        }
        for (own, given) in own.iter().zip(given) {
            if !Arc::ptr_eq(&own.shape, &given.shape) {
                return Err(Failure::OtherSurface { surface: given.name.clone() });
            }
            if given.material.sends() && !own.material.sends() {
                return Err(Failure::Unlit { surface: given.name.clone() });
            }
        }
        Ok(())
    }

    fn solved(&self, scene: &Scene, work: &Work<'_>) -> Result<Outcome, Failure> {
        let mut seconds = self.seconds;
        let emissions = Emission::all(scene, self.elements.list());
        let mut again = Duration::ZERO;
        let first = timed(&mut again, || self.first_light(scene, &emissions, work.ranks));
        seconds.direct += again;
        let bands = self.bands(scene);
        let lit = timed(&mut seconds.solve, || match self.options.bounces {
            None => bands.solved(&emissions, &first, work),
            Some(bounces) => Ok(bands.bounced(&emissions, &first, bounces)),
        })?;
        work.report(Progress::Finished { stage: Stage::Solve, took: seconds.solve });
        let SolvedLight { light, before, costs, functionals } = lit;
        let groups = self.groups(emissions, first, light);
        let before = before.map(|light| lit_before(&groups, light));
        let of_groups = |groups| Solution::of_groups(Arc::clone(&self.elements), scene, groups);
        let (before, solution) = (before.map(of_groups), of_groups(groups));
        let solution = match self.options.bounces {
            Some(_) => solution.truncated(before),
            None => solution,
        };
        Ok(Outcome { functionals, seconds, ..self.outcome(solution, &costs, work.ranks) })
    }

    /// A solution that took so much, with its checks.
    fn outcome(&self, solution: Solution, costs: &[SolveCost], ranks: &Ranks) -> Outcome {
        let slowest = costs.iter().max_by_key(|cost| cost.iterations);
        let powers = solution.powers().unwrap_or_default();
        let checks = Checks::with_powers(&solution, &self.blocks, powers, ranks);
        let statistics = &self.blocks.statistics;
        Outcome {
            checks,
            pairs: statistics.pairs,
            samples: statistics.samples,
            distinct: statistics.distinct,
            rays: statistics.rays,
            accuracy_reached: statistics.accuracy_reached,
            worst_error: statistics.worst_error,
            solver: slowest.map_or(self.options.solver.name, |cost| cost.solver),
            iterations: slowest.map_or(0, |cost| cost.iterations),
            residual: solution.bands().iter().map(|band| band.coefficients.residual).fold(0.0, f64::max),
            split: self.first.is_split,
            converged: costs.iter().all(|cost| cost.converged),
            choice: self.choice.clone(),
            unknowns: self.unknowns(),
            functionals: Vec::new(),
            sampling: self.sampling,
            links: None,
            seconds: self.seconds,
            solution,
        }
    }

    /// Number of coefficients per band.
    fn unknowns(&self) -> usize {
        self.subspace.as_ref().map_or_else(|| self.elements.coefficients(), Subspace::dim)
    }

    /// The first light of each emission: that of the scene it was assembled from, if it emits as much. With a
    /// subspace, light that enters apart is projected on it.
    fn first_light(&self, scene: &Scene, emissions: &[Emission], ranks: &Ranks) -> Vec<EnteringLight> {
        let first = self.first.reflected(emissions).unwrap_or_else(|| {
            let lit_scene = LitScene {
                scene,
                elements: &self.elements,
                visibility: &self.visibility,
                options: &self.options,
                ranks,
            };
            let anew = Emission::all(scene, self.elements.list());
            let first = FirstLight::as_split(&lit_scene, anew, self.first.is_split);
            first.reflected(emissions).expect("the emission is the same")
        });
        match &self.subspace {
            None => first,
            Some(subspace) => first.into_iter().map(|own| own.within(subspace)).collect(),
        }
    }

    fn bands<'a>(&'a self, scene: &'a Scene) -> BandSystems<'a> {
        let (elements, subspace) = (self.elements.list(), self.subspace.as_ref());
        BandSystems { names: &scene.bands, elements, blocks: &self.blocks, subspace, options: &self.options }
    }

    /// The light of each emission with its balance of power.
    fn groups(
        &self,
        emissions: Vec<Emission>,
        first: Vec<EnteringLight>,
        light: Vec<Vec<Coefficients>>,
    ) -> Vec<GroupLight> {
        let balance = Balance::of(&self.elements, &self.blocks);
        let lit = emissions.into_iter().zip(first).zip(light);
        let group = |((emission, first), light): ((Emission, EnteringLight), Vec<_>)| {
            emission.lit(&balance, &first.entry, light, first.masked)
        };
        lit.map(group).collect()
    }
}

/// Refuses what cannot carry the light of luminaires or of a sky.
fn require_diffuse(scene: &Scene, options: &Options) -> Result<(), Failure> {
    require_even(scene, options)?;
    let shines = scene.luminaires.iter().find(|own| own.emits()).filter(|_| options.masks.is_some());
    if let Some(own) = shines {
        return Err(Failure::Unmasked { luminaire: own.name.clone() });
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

/// The groups with other `light`, by coefficients of each in each band.
fn lit_before(groups: &[GroupLight], light: Vec<Vec<Coefficients>>) -> Vec<GroupLight> {
    let other = |(own, bands): (&GroupLight, Vec<Coefficients>)| GroupLight {
        group: own.group.clone(),
        bands: bands.into_iter().map(Coefficients::into).collect(),
        powers: own.powers,
        masked: own.masked.clone(),
    };
    groups.iter().zip(light).map(other).collect()
}
