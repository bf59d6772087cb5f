//! Elements that carry constants, and the exchanges between them: by rules, by rays of each surface, or by rays of each
//! pair of many small flat surfaces.

use std::fmt::Debug;

use radiosity_elements::cells::Layers;
use radiosity_elements::space::Space;
use radiosity_elements::{Discretization, Elements, Subdivide};
use radiosity_kernel::Blocks;
use radiosity_scene::Scene;
use radiosity_solvers::method::Method;
use radiosity_transport as transport;
use radiosity_transport::{Demand, FacetExchanges, FacetTransport, FactorEnds};
use radiosity_visibility::Visibility;
use radiosity_work::{Progress, Stage, Work};

use super::by_rays::{Carried, FactorRays};
use super::options::Options;
use super::plan::Plan;
use super::row_noise::RowNoise;
use crate::driver::memory_estimate::MemoryEstimate;
use crate::driver::{Failure, MemoryReduction, TransportChoice};
use crate::facet_choice::{PairBytes, of_many_flat};
use crate::geometry::AssemblyGeometry;

/// Surfaces that go all the way round an axis, at most, of which pairs are looked at before rules are chosen.
/// Chosen: the pairs of a thousand in a soda shop took 16 s, its rays 9.
const FEW_RINGS: usize = 100;

/// Bytes that a pair of small flat surfaces takes, at the most: an exchange, and errors of those of which a part is
/// hidden. Counted from their types, not measured.
const FACET_PAIR: f64 = 20.0;

/// Bytes that such pairs take where nothing is said of memory. Chosen.
const USUALLY_MOST: f64 = 5e9;

/// Elements that carry constants, and what is known of their pairs.
pub(super) struct Constants {
    pub elements: Elements,
    pub choice: TransportChoice,
    pub found: Found,
}

/// Exchanges of elements.
pub(super) enum Found {
    /// Blocks by rules or by rays.
    Blocks {
        blocks: Box<Blocks>,
        /// The errors that rays leave, where they carry the pairs.
        noise: Option<RowNoise>,
        exact_pairs: usize,
    },
    /// Exchanges of many small flat surfaces.
    Facets(FacetExchanges),
}

/// A scene whose carrier is chosen.
struct Ready<'a> {
    scene: Scene,
    visibility: Visibility,
    /// Cuts of surfaces where rules carry the pairs.
    how: Discretization,
    /// Whether surfaces are still to be found that rules know whole.
    is_cut: bool,
    plan: Plan,
    wanted: &'a (dyn Fn(usize, usize) -> bool + Sync),
    options: &'a Options,
    work: &'a Work<'a>,
}

impl Constants {
    /// The elements of `scene`, and the exchanges of the `wanted` pairs of its surfaces.
    ///
    /// # Errors
    /// Surfaces without area; too little memory.
    pub(super) fn of(
        scene: &Scene,
        wanted: &(dyn Fn(usize, usize) -> bool + Sync),
        options: &Options,
        work: &Work<'_>,
    ) -> Result<Self, Failure> {
        let wanted = |i: usize, j: usize| wanted(i, j) || wanted(j, i);
        let decide = || Ready::of(scene.clone(), &wanted, options, work);
        let ready = work.during(Stage::Visibility, decide);
        if ready.plan.choice.sampled { ready.by_rays() } else { ready.by_rules() }
    }
}

impl<'a> Ready<'a> {
    fn of(
        mut scene: Scene,
        wanted: &'a (dyn Fn(usize, usize) -> bool + Sync),
        options: &'a Options,
        work: &'a Work<'a>,
    ) -> Self {
        scene.surfaces.iter_mut().for_each(|surface| surface.order = None);
        let visibility = Visibility::new(&scene, options.shadows, options.block_accuracy().shadow_eps);
        let auto = || Subdivide::Auto { occluded: visibility.any_shadow(), near_layers: false };
        let how = constant_on(options.subdivide.map_or_else(auto, Subdivide::Uniform));
        let mut is_cut = options.subdivide.is_none();
        if is_cut && has_few_rings(&scene, &visibility) {
            keep_whole(&mut scene, &visibility);
            is_cut = false;
        }
        let plan = Plan::of(&scene, &how, wanted, options, &visibility);
        Self { scene, visibility, how, is_cut, plan, wanted, options, work }
    }

    fn by_rays(mut self) -> Result<Constants, Failure> {
        // Rays find shadows wherever they are.
        self.scene.surfaces.iter_mut().for_each(|surface| surface.subdivide = None);
        let Self { scene, visibility, plan: Plan { choice, rays, seconds }, wanted, options, work, .. } =
            self;
        let cut = || Elements::new(&scene, &constant_on(Subdivide::Uniform(1)));
        let elements = work.during(Stage::Elements, cut)?;
        let accuracy = options.block_accuracy();
        note_assembly(&scene, &elements, wanted, &(accuracy, options.shadows, rays), work);
        if let Some(transport) = facets(&elements, &visibility, options, work) {
            expect(transport.seconds(), work);
            let find = || transport.exchanges(wanted);
            let found = Found::Facets(work.during(Stage::Blocks, find));
            return Ok(Constants { elements, choice, found });
        }
        expect(seconds, work);
        let (is_given, memory) = (options.rays.is_some(), options.memory);
        let sent = FactorRays {
            elements: &elements,
            visibility: &visibility,
            accuracy,
            rays,
            is_given,
            memory,
            work,
        };
        let Carried { blocks, noise, exact_pairs } = work.during(Stage::Blocks, || sent.carried())?;
        let found = Found::Blocks { blocks: Box::new(blocks), noise: Some(noise), exact_pairs };
        Ok(Constants { elements, choice, found })
    }

    fn by_rules(mut self) -> Result<Constants, Failure> {
        let work = self.work;
        expect(self.plan.seconds, work);
        if self.is_cut {
            work.during(Stage::Visibility, || keep_whole(&mut self.scene, &self.visibility));
        }
        let Self { scene, visibility, how, plan, wanted, options, .. } = self;
        require_memory(&scene, &how, options, work)?;
        let elements = work.during(Stage::Elements, || Elements::new(&scene, &how))?;
        let accuracy = options.block_accuracy();
        note_assembly(&scene, &elements, wanted, &(accuracy, options.shadows), work);
        let surface = |element: usize| elements.list()[element].surface;
        let wanted = |a, b| wanted(surface(a), surface(b));
        let demand = Demand { whole: FactorEnds::Surface, ..Demand::all(&elements, &visibility, accuracy) };
        let blocks = work.during(Stage::Blocks, || transport::assemble(demand.of(&wanted), None, work));
        let found = Found::Blocks { blocks: Box::new(blocks), noise: None, exact_pairs: 0 };
        Ok(Constants { elements, choice: plan.choice, found })
    }
}

/// Tells about how many seconds the pairs take.
fn expect(seconds: f64, work: &Work<'_>) {
    work.report(Progress::Expected { stage: Stage::Blocks, seconds });
}

/// The transport by rays of each pair, where surfaces are many, small and flat, and no number of rays is given.
fn facets<'a>(
    elements: &'a Elements,
    visibility: &'a Visibility,
    options: &Options,
    work: &'a Work<'a>,
) -> Option<FacetTransport<'a>> {
    let mut list = elements.list().iter().enumerate();
    let are_surfaces = list.all(|(index, element)| element.surface == index);
    let bytes = PairBytes { each: FACET_PAIR, usually_most: USUALLY_MOST, allowed: options.memory };
    let found = || of_many_flat(elements, visibility, options.accuracy.eps, bytes, work);
    if are_surfaces && options.rays.is_none() { found() } else { None }
}

/// Notes what the factors between the elements of `wanted` pairs of surfaces follow from, by these `options`.
fn note_assembly(
    scene: &Scene,
    elements: &Elements,
    wanted: &(dyn Fn(usize, usize) -> bool + Sync),
    options: &dyn Debug,
    work: &Work<'_>,
) {
    let surface = |element: usize| elements.list()[element].surface;
    let wanted = |a: usize, b: usize| wanted(surface(a), surface(b));
    work.ranks.note_assembly(&(options, AssemblyGeometry { scene, elements, wanted: &wanted }));
}

/// Whether few surfaces of a scene go all the way round an axis: pairs of them are looked at before it is known
/// whether rules carry any.
fn has_few_rings(scene: &Scene, visibility: &Visibility) -> bool {
    let is_ring = |surface: &usize| visibility.meridian(*surface).is_some();
    (0..scene.surfaces.len()).filter(is_ring).count() <= FEW_RINGS
}

/// Leaves surfaces uncut between whose wholes a rule knows what is seen past coaxial cylinders.
fn keep_whole(scene: &mut Scene, visibility: &Visibility) {
    let are_whole = transport::best_whole(visibility, scene.surfaces.len());
    let whole = scene.surfaces.iter_mut().zip(are_whole).filter(|(_, is_whole)| *is_whole);
    whole.for_each(|(surface, _)| surface.subdivide = surface.subdivide.or(Some([1, 1])));
}

/// Elements of constants.
fn constant_on(subdivide: Subdivide) -> Discretization {
    Discretization { order: 0, space: Space::Total, subdivide, layers: Layers::NONE }
}

/// Refuses rules that need more memory than allowed.
fn require_memory(
    scene: &Scene,
    how: &Discretization,
    options: &Options,
    work: &Work<'_>,
) -> Result<(), Failure> {
    let Some(allowed) = options.memory else { return Ok(()) };
    let needed = MemoryEstimate::of(scene, how, &Method::CG, work.ranks).peak();
    match needed <= allowed {
        true => Ok(()),
        false => Err(Failure::Memory { needed, allowed, fits: vec![MemoryReduction::SampledTransport] }),
    }
}
