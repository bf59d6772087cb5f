//! A model: the elements of a scene and the blocks between them, to be solved for any materials.
//!
//! G is geometry only. Reflectance and emission enter the system that is made of it, so that a change of
//! materials needs no new blocks. Light that was reflected once is linear in the reflectance of what
//! reflected it: where direct light is split off, a change of reflectance does not gather it anew. Only two
//! choices depend on the materials of the scene from which a model was assembled: which pairs are left
//! out because neither side ever sends light, and where rays were sent from.

use std::sync::Arc;
use std::time::Duration;

use radiosity_core::norm;
use radiosity_elements::Elements;
use radiosity_elements::mesh::Mesh;
use radiosity_kernel::Blocks;
use radiosity_kernel::block_columns::ByColumn;
use radiosity_light::first_bounce::DirectLightEntry;
use radiosity_scene::Scene;
use radiosity_solvers::method::Access;
use radiosity_transport::ColumnsAsShot;
use radiosity_visibility::Visibility;
use radiosity_work::ranks::Ranks;
use radiosity_work::{Progress, Stage, Work};

use crate::checks::{Balance, Checks, largest_bound};
use crate::solution::Solution;
use crate::solution::group_light::GroupLight;
use crate::system::Coefficients;
use crate::system::known_light::KnownLight;
use crate::system::shooting::ambient;
use crate::system::vector::distance;

use super::assembly::carried;
use super::band_systems::{BandSystems, SolvedLight};
use super::cut_scene::CutScene;
use super::decisions::{AssemblyPlan, Layout};
use super::emission::Emission;
use super::failure::Failure;
use super::first_light::EnteringLight;
use super::kept_model::{KeptModel, WholeBlocks};
use super::options::Options;
use super::outcome::{FrameLight, Outcome, Stages, timed};
use super::ready::Ready;
use super::requirements::require_diffuse;
use super::sampling::Sampling;
use super::shooting::ColumnSource;
use super::shots::ShotLimit;
use super::subject::Subject;
use super::transport_choice::TransportChoice;
use super::unknowns::Unknowns;

/// Most solutions for light that emitters reflect through masks. Each changes the radiosity by less than the
/// one before where masks take little of what is reflected, and by more where they take much and reflectances
/// are high: then there is no light to be told.
const MOST_ROUNDS: usize = 20;

/// Change of the radiosity from one of these solutions to the next at which it is the last, over the accuracy
/// of the blocks.
const ROUND_OVER_BLOCK: f64 = 0.1;

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
    ready: Ready,
    blocks: Blocks,
    sampling: Option<Sampling>,
    /// Whether self-checks bound the spectral radius.
    is_bounded: bool,
}

/// The emissions of a scene with their first light.
struct Entered {
    emissions: Vec<Emission>,
    first: Vec<EnteringLight>,
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

    /// Computes the blocks between elements of `scene` on the cells of `mesh`, whatever `options` say of them.
    ///
    /// # Errors
    /// As [`Model::assemble`].
    pub fn assemble_on(
        mesh: &Mesh,
        scene: &Scene,
        options: &Options,
        work: &Work<'_>,
    ) -> Result<Self, Failure> {
        options
            .in_threads(work.ranks, || Self::assembled(scene, options, AssemblyPlan::on(mesh), None, work))?
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
        kept: Option<&mut KeptModel>,
        work: &Work<'_>,
    ) -> Result<Self, Failure> {
        options.in_threads(work.ranks, || Self::assembled(scene, options, layout.plan(), kept, work))?
    }

    /// Bytes that the model of `scene` and its solution take at the most on each of these ranks, estimated.
    pub fn peak_memory(scene: &Scene, options: &Options, ranks: &Ranks) -> u64 {
        AssemblyPlan::default().decided(scene, options, None).peak_memory(scene, options, ranks)
    }

    /// As [`peak_memory`](Self::peak_memory), on the cells of `mesh`.
    pub fn peak_memory_on(mesh: &Mesh, scene: &Scene, options: &Options, ranks: &Ranks) -> u64 {
        AssemblyPlan::on(mesh).decided(scene, options, None).peak_memory(scene, options, ranks)
    }

    /// Solves `scene` by exact blocks, for the reason `why`, between the elements of a refined mesh if there is
    /// one.
    pub(super) fn solve_exactly(
        scene: &Scene,
        options: &Options,
        why: &str,
        mesh: Option<&Mesh>,
        work: &Work<'_>,
    ) -> Result<Outcome, Failure> {
        let choice = Some(TransportChoice { sampled: false, why: why.to_owned() });
        let plan = AssemblyPlan { choice, mesh, ..AssemblyPlan::default() };
        options.in_threads(work.ranks, || Self::solution(scene, options, plan, work))?
    }

    /// Solves `scene` once.
    pub(super) fn solve_once(scene: &Scene, options: &Options, work: &Work<'_>) -> Result<Outcome, Failure> {
        let plan = AssemblyPlan::default();
        options.in_threads(work.ranks, || Self::solution(scene, options, plan, work))?
    }

    fn assembled(
        scene: &Scene,
        options: &Options,
        plan: AssemblyPlan<'_>,
        kept: Option<&mut KeptModel>,
        work: &Work<'_>,
    ) -> Result<Self, Failure> {
        let ready = Ready::of(scene, options, plan, kept.as_deref(), work)?;
        Ok(Self::carried(ready, kept, work))
    }

    /// The model of a scene that is ready, with all its blocks.
    fn carried(mut ready: Ready, mut kept: Option<&mut KeptModel>, work: &Work<'_>) -> Self {
        let Ready { cut, first, .. } = &ready;
        let CutScene { scene, options, elements, visibility, rays, .. } = cut;
        let bands = &Emission::by_band(first.emissions());
        let entries = first.reflected(first.emissions()).expect("the emission is the same");
        let entries = &entries.into_iter().map(|own| own.entry).collect::<Vec<_>>();
        let subject = Subject { elements, bands, entries, visibility, options, work };
        // Of scenes that follow the first one nobody asks how long they take.
        let is_first = kept.as_deref().is_none_or(|kept| kept.blocks.elements().is_none());
        if let Some(kept) = &mut kept {
            kept.blocks.move_to(scene, elements, visibility);
        }
        let mut took = Duration::ZERO;
        let known =
            kept.as_deref_mut().and_then(|kept| kept.unchanged(&senders(scene), &|| subject.shares()));
        let found = || {
            if is_first {
                work.report(Progress::Expected {
                    stage: Stage::Blocks,
                    seconds: ready.cut.seconds_of_pairs(work),
                });
            }
            known.unwrap_or_else(|| carried(scene, &subject, *rays, kept))
        };
        let (blocks, sampling) = timed(&mut took, || work.during(Stage::Blocks, found));
        ready.cut.seconds.blocks = took;
        Self { ready, blocks, sampling, is_bounded: true }
    }

    /// Solves `scene` as `plan` says; where the solver shoots, a column of the matrix is integrated when it
    /// is first shot, if it can be.
    fn solution(
        scene: &Scene,
        options: &Options,
        plan: AssemblyPlan<'_>,
        work: &Work<'_>,
    ) -> Result<Outcome, Failure> {
        let ready = Ready::of(scene, options, plan, None, work)?;
        match ready.is_lazy(work.ranks)? {
            true => Self::shot(ready, work),
            false => Self::carried(ready, None, work).solved(scene, None, work),
        }
    }

    /// Shoots the light of a scene that is ready by columns that are integrated when they are first shot.
    fn shot(mut ready: Ready, work: &Work<'_>) -> Result<Outcome, Failure> {
        let mut took = Duration::ZERO;
        let wanted = |a, b| ready.cut.sends(a) || ready.cut.sends(b);
        let emissions = Emission::all(&ready.cut.scene, ready.cut.elements.list());
        let first = ready.first_light(&ready.cut.scene, &emissions, work.ranks);
        work.report(Progress::Expected { stage: Stage::Blocks, seconds: ready.cut.seconds_of_pairs(work) });
        let columns = work.during(Stage::Blocks, || ColumnsAsShot::new(ready.demand(&wanted), *work));
        let source = ColumnSource { columns: &columns, before: columns.seconds(), all_first: None };
        let shooter = ready.shooter(&ready.cut.scene, &emissions, &first);
        let shoot = || shooter.shot(source, &Unknowns::default(), work);
        let shot = timed(&mut took, || work.during(Stage::Solve, shoot))?;
        let integrated = columns.seconds();
        let before = source.before;
        let blocks = columns.into_blocks();
        let light = shooter.light(&shot, &blocks);
        ready.cut.seconds.blocks = integrated;
        ready.cut.seconds.solve = (before + took).saturating_sub(integrated);
        let seconds = ready.cut.seconds;
        let scene = ready.cut.scene.clone();
        let model = Self { ready, blocks, sampling: None, is_bounded: true };
        let light = SolvedLight::shot(light, shot);
        Ok(model.outcome(&scene, Entered { emissions, first }, light, seconds, work))
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
        self.ready.cut.options.in_threads(work.ranks, || self.solved(scene, None, work))?
    }

    /// Solves as [`Model::solve`] for one of many scenes, the light of some of which is `known`: light that follows
    /// from it, to the tolerance of the solver, is not solved for, and all of it is known from then on.
    ///
    /// # Errors
    /// As [`Model::solve`].
    pub fn solve_beside(
        &self,
        scene: &Scene,
        known: &mut KnownLight,
        work: &Work<'_>,
    ) -> Result<Outcome, Failure> {
        self.check(scene)?;
        self.ready.cut.options.in_threads(work.ranks, || self.solved(scene, Some(known), work))?
    }

    /// The light of `scene` as [`Model::solve`] finds it, beside `known` light as [`Model::solve_beside`] if there is
    /// any, without self-checks.
    ///
    /// # Errors
    /// As [`Model::solve`].
    pub fn light_of(
        &self,
        scene: &Scene,
        known: Option<&mut KnownLight>,
        work: &Work<'_>,
    ) -> Result<Solution, Failure> {
        self.check(scene)?;
        self.ready.cut.options.in_threads(work.ranks, || {
            let mut seconds = Stages::default();
            let solve = || self.entered(scene, known, &mut seconds, work);
            let (entered, SolvedLight { light, before, .. }) = work.during(Stage::Solve, solve)?;
            Ok(self.solution_of(scene, entered, light, before))
        })?
    }

    /// This model, to be solved by so many shots.
    pub(crate) fn with_shots(mut self, shots: Option<ShotLimit>) -> Self {
        self.ready.cut.options.shots = shots;
        self
    }

    /// Solves systems to this tolerance from now on.
    pub fn set_tolerance(&mut self, tolerance: f64) {
        self.ready.cut.options.tolerance = tolerance;
    }

    /// The model, whose self-checks bound no spectral radius from now on: it takes longer than many a solution.
    #[must_use]
    pub fn without_spectral_bound(self) -> Self {
        Self { is_bounded: false, ..self }
    }

    /// The elements of the model's surfaces.
    pub fn elements(&self) -> &Elements {
        &self.ready.cut.elements
    }

    /// The blocks between the elements.
    pub fn blocks(&self) -> &Blocks {
        &self.blocks
    }

    /// The visibility between the surfaces.
    pub fn visibility(&self) -> &Visibility {
        &self.ready.cut.visibility
    }

    /// The visibility between the surfaces, when nothing else of the model is needed any more but what `kept`
    /// keeps for the next scene.
    pub(crate) fn into_visibility(self, kept: Option<&mut KeptModel>) -> Visibility {
        let Self { ready, blocks, sampling, .. } = self;
        let CutScene { visibility, scene, .. } = ready.cut;
        if let Some(kept) = kept {
            kept.keep(WholeBlocks { senders: senders(&scene), blocks, sampling });
        }
        visibility
    }

    /// This model with what `correct` makes of its blocks.
    #[must_use]
    pub fn with_corrected(self, correct: impl FnOnce(&Elements, Blocks) -> Blocks) -> Self {
        let Self { ready, blocks, sampling, is_bounded } = self;
        let blocks = correct(&ready.cut.elements, blocks);
        Self { ready, blocks, sampling, is_bounded }
    }

    /// Refuses a scene of other surfaces, and light from surfaces whose blocks were left out.
    fn check(&self, scene: &Scene) -> Result<(), Failure> {
        require_diffuse(scene, &self.ready.cut.options)?;
        let (own, given) = (&self.ready.cut.scene.surfaces, &scene.surfaces);
        let names = || given.iter().chain(own).map(|surface| surface.name.clone());
        if own.len() != given.len() || self.ready.cut.scene.bands != scene.bands {
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

    fn solved(
        &self,
        scene: &Scene,
        known: Option<&mut KnownLight>,
        work: &Work<'_>,
    ) -> Result<Outcome, Failure> {
        let mut seconds = self.ready.cut.seconds;
        let solve = || self.entered(scene, known, &mut seconds, work);
        let (entered, light) = work.during(Stage::Solve, solve)?;
        Ok(self.outcome(scene, entered, light, seconds, work))
    }

    /// The light of a scene with what enters first, timed; beside `known` light, if there is any.
    fn entered(
        &self,
        scene: &Scene,
        known: Option<&mut KnownLight>,
        seconds: &mut Stages,
        work: &Work<'_>,
    ) -> Result<(Entered, SolvedLight), Failure> {
        let emissions = Emission::all(scene, self.ready.cut.elements.list());
        let mut again = Duration::ZERO;
        let first = timed(&mut again, || self.ready.first_light(scene, &emissions, work.ranks));
        seconds.direct += again;
        let find = || match known.filter(|_| self.is_all_carried(&first)) {
            Some(known) => self.bands(scene).solved_beside(&emissions, known, work),
            None => self.light(scene, &emissions, &first, &Unknowns::default(), work),
        };
        let light = timed(&mut seconds.solve, find)?;
        let entered = Entered { emissions, first };
        let found = timed(&mut again, || self.through_masks(scene, entered, light, work))?;
        seconds.direct += again;
        Ok(found)
    }

    /// Whether G carries all light between functions of the elements, and systems are solved for it.
    fn is_all_carried(&self, first: &[EnteringLight]) -> bool {
        let Options { bounces, solver, .. } = self.ready.cut.options;
        let are_solved =
            bounces.is_none() && solver.access != Access::Columns && self.ready.cut.subspace.is_none();
        are_solved && first.iter().all(|own| matches!(own.entry, DirectLightEntry::Carried))
    }

    /// The light of a frame, the scene from which the model was assembled, found from the unknowns `before` of
    /// another frame, if there are any.
    ///
    /// # Errors
    /// As [`Model::solve`].
    pub(crate) fn frame_light(&self, before: &Unknowns, work: &Work<'_>) -> Result<FrameLight, Failure> {
        self.ready.cut.options.in_threads(work.ranks, || self.found_from(before, work))?
    }

    fn found_from(&self, before: &Unknowns, work: &Work<'_>) -> Result<FrameLight, Failure> {
        let scene = &self.ready.cut.scene;
        let emissions = Emission::all(scene, self.ready.cut.elements.list());
        let first = self.ready.first_light(scene, &emissions, work.ranks);
        let mut seconds = self.ready.cut.seconds;
        let solve = || self.light(scene, &emissions, &first, before, work);
        let light = timed(&mut seconds.solve, || work.during(Stage::Solve, solve))?;
        let (entered, light) = self.through_masks(scene, Entered { emissions, first }, light, work)?;
        let SolvedLight { light, before, unknowns, costs, .. } = light;
        let solution = self.solution_of(scene, entered, light, before);
        Ok(FrameLight {
            residual: solution.residual(),
            solution,
            converged: costs.iter().all(|cost| cost.converged),
            worst_error: self.blocks.statistics.worst_error,
            sampling: self.sampling,
            seconds,
            unknowns,
        })
    }

    /// The light of `emissions` that entered as `first`, found from the unknowns of a similar scene where
    /// some are given.
    fn light(
        &self,
        scene: &Scene,
        emissions: &[Emission],
        first: &[EnteringLight],
        before: &Unknowns,
        work: &Work<'_>,
    ) -> Result<SolvedLight, Failure> {
        let (bands, options) = (self.bands(scene), &self.ready.cut.options);
        let shoots = options.solver.access == Access::Columns && self.ready.cut.subspace.is_none();
        match options.bounces {
            None if shoots => self.shot_from_all(scene, emissions, first, before, work),
            None => bands.solved(emissions, first, before, work),
            Some(bounces) => Ok(bands.bounced(emissions, first, bounces)),
        }
    }

    /// The light where what emitters reflect goes through masks, too: solved anew from the reflection of each
    /// solution, until that changes no more. Light of the first reflections or shots alone stays as it is.
    ///
    /// # Errors
    /// [`Failure::MasksUnsettled`] where it still changes after [`MOST_ROUNDS`].
    fn through_masks(
        &self,
        scene: &Scene,
        mut entered: Entered,
        mut light: SolvedLight,
        work: &Work<'_>,
    ) -> Result<(Entered, SolvedLight), Failure> {
        let options = &self.ready.cut.options;
        let is_partial = options.bounces.is_some() || options.shots.is_some();
        if is_partial || !entered.first.iter().any(EnteringLight::is_reflected) {
            return Ok((entered, light));
        }
        let lit_scene = self.ready.lit_scene(scene, work.ranks);
        for _ in 0..MOST_ROUNDS {
            let lit = entered.first.into_iter().zip(&entered.emissions).zip(&light.light);
            let again = |((first, emission), own): ((EnteringLight, _), &Vec<_>)| {
                first.again(&lit_scene, emission, own)
            };
            let first: Vec<EnteringLight> = lit.map(again).collect();
            let next = self.light(scene, &entered.emissions, &first, &Unknowns::default(), work)?;
            let change = change(&light.light, &next.light);
            entered.first = first;
            light = next;
            if change <= options.eps * ROUND_OVER_BLOCK {
                return Ok((entered, light));
            }
        }
        Err(Failure::MasksUnsettled { rounds: MOST_ROUNDS })
    }

    /// Shoots light by columns of the blocks that are all there.
    fn shot_from_all(
        &self,
        scene: &Scene,
        emissions: &[Emission],
        first: &[EnteringLight],
        before: &Unknowns,
        work: &Work<'_>,
    ) -> Result<SolvedLight, Failure> {
        let all = self.blocks.gathered();
        let columns = ByColumn::of(&all);
        let why = self.ready.all_first(work.ranks).unwrap_or("other light is solved for by them, too");
        let source =
            ColumnSource { columns: &columns, before: self.ready.cut.seconds.blocks, all_first: Some(why) };
        let shooter = self.ready.shooter(scene, emissions, first);
        let shot = shooter.shot(source, before, work)?;
        Ok(SolvedLight::shot(shooter.light(&shot, &self.blocks), shot))
    }

    /// The outcome for the light of a scene, with its self-checks.
    fn outcome(
        &self,
        scene: &Scene,
        entered: Entered,
        light: SolvedLight,
        seconds: Stages,
        work: &Work<'_>,
    ) -> Outcome {
        work.during(Stage::Checks, || self.checked(scene, entered, light, seconds, work))
    }

    fn checked(
        &self,
        scene: &Scene,
        entered: Entered,
        light: SolvedLight,
        seconds: Stages,
        work: &Work<'_>,
    ) -> Outcome {
        let SolvedLight { light, before, costs, functionals, shots, .. } = light;
        let slowest = costs.iter().max_by_key(|cost| cost.iterations);
        let (solver, iterations) =
            slowest.map_or((self.ready.cut.options.solver.name, 0), |cost| (cost.solver, cost.iterations));
        let solution = self.solution_of(scene, entered, light, before);
        let powers = solution.powers().unwrap_or_default();
        let residual = solution.residual();
        // Its products take longer than many a solution.
        let is_bounded = self.is_bounded && !work.is_late();
        let bound = if is_bounded { largest_bound(&solution, &self.blocks, work.ranks) } else { 0.0 };
        let checks = Checks::with_powers(&solution, &self.blocks, powers, bound);
        let statistics = &self.blocks.statistics;
        Outcome {
            solution,
            checks,
            pairs: statistics.pairs,
            samples: statistics.samples,
            distinct: statistics.distinct,
            rays: statistics.rays,
            accuracy_reached: statistics.accuracy_reached,
            worst_error: statistics.worst_error,
            solver,
            iterations,
            residual,
            split: self.ready.first.is_apart(),
            converged: costs.iter().all(|cost| cost.converged),
            choice: self.ready.cut.choice.clone(),
            unknowns: self.ready.cut.unknowns(),
            functionals,
            sampling: self.sampling,
            links: None,
            shots,
            seconds,
        }
    }

    /// The solution of light that entered a scene, with one reflection less in `before` where their number
    /// is limited.
    fn solution_of(
        &self,
        scene: &Scene,
        Entered { emissions, first }: Entered,
        light: Vec<Vec<Coefficients>>,
        before: Option<Vec<Vec<Coefficients>>>,
    ) -> Solution {
        let groups = self.groups(emissions, first, light);
        let before = before.map(|light| lit_before(&groups, light));
        let before =
            before.map(|groups| Solution::of_groups(Arc::clone(&self.ready.cut.elements), scene, groups));
        let solution = Solution::of_groups(Arc::clone(&self.ready.cut.elements), scene, groups);
        match self.ready.cut.options.bounces {
            Some(_) => solution.truncated(before),
            None => solution,
        }
    }

    fn bands<'a>(&'a self, scene: &'a Scene) -> BandSystems<'a> {
        let (elements, subspace) = (self.ready.cut.elements.list(), self.ready.cut.subspace.as_ref());
        BandSystems {
            names: &scene.bands,
            elements,
            blocks: &self.blocks,
            subspace,
            options: &self.ready.cut.options,
        }
    }

    /// The light of each emission with its balance of power.
    fn groups(
        &self,
        emissions: Vec<Emission>,
        first: Vec<EnteringLight>,
        light: Vec<Vec<Coefficients>>,
    ) -> Vec<GroupLight> {
        let elements = &self.ready.cut.elements;
        let balance = Balance::of(elements, &self.blocks);
        let lit = emissions.into_iter().zip(first).zip(light);
        let is_ambient = self.ready.cut.options.shots.is_some_and(|shots| shots.ambient);
        let group = |((emission, first), light): ((Emission, EnteringLight), Vec<Coefficients>)| {
            let bands = light.iter().zip(&emission.coatings).filter(|_| is_ambient);
            let around = bands.map(|(own, coating)| {
                own.waiting.as_ref().map_or(0.0, |waiting| ambient(elements.list(), coating, waiting))
            });
            let around: Vec<f64> = around.collect();
            emission.lit(&balance, &first.entry, light, first.masked).brightened(elements, &around)
        };
        lit.map(group).collect()
    }
}

/// Whether each surface of a scene sends light.
fn senders(scene: &Scene) -> Vec<bool> {
    scene.surfaces.iter().map(|surface| surface.material.sends()).collect()
}

/// The largest relative change of the radiosity of an emission in a band.
fn change(before: &[Vec<Coefficients>], after: &[Vec<Coefficients>]) -> f64 {
    let pairs = before.iter().flatten().zip(after.iter().flatten());
    let changes = pairs.map(|(before, after)| {
        let size = norm(&after.radiosity);
        if size > 0.0 { distance(&after.radiosity, &before.radiosity) / size } else { 0.0 }
    });
    changes.fold(0.0, f64::max)
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
