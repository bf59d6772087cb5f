//! The driver: scene → elements → blocks → system per band → solution, timed.

mod direct;
pub mod memory;
mod fit;
mod options;

use std::time::{Duration, Instant};

use radiosity_solvers::{Report, Settings, SolveError, Step, method::Method};
use rayon::ThreadPoolBuildError;

use crate::checks::Checks;
use crate::elements::cells::Layers;
use crate::elements::coating::Coating;
use crate::elements::patch::Node;
use crate::elements::{Discretization, ElementError, Elements, Subdivide};
use crate::light::first_bounce::Bounce;
use crate::scene::Scene;
use crate::solution::{Band, Solution};
use crate::solve::memory::Footprint;
use crate::system::{Coefficients, System};
use crate::transport;
use crate::transport::{Blocks, PairCounts};
use crate::visibility::{Shadows, Visibility};
use crate::zatz1993::masked_light::{MaskedLight, Setting};
use crate::zatz1993::transfers;

pub use direct::Direct;
pub use fit::Fit;
pub use options::Options;

/// Tolerance of gathered light at a point over that of shadows in a block, a mean of many. Chosen; not tuned.
const AT_A_POINT: f64 = 3.0;

/// Where the work stands.
#[derive(Clone, Copy, Debug)]
pub enum Progress {
    /// Pairs of elements integrated, and pairs in all.
    Blocks(usize, usize),
    /// Band, iteration and relative residual of the solver.
    Solve(usize, usize, f64),
    /// Elements whose error is estimated, and elements in all.
    Estimate(usize, usize),
    /// A finished stage with its wall time; the names are those of [`Stages`].
    Finished(&'static str, Duration),
}

/// The solution with its cost and self-checks.
#[derive(Debug)]
pub struct Outcome {
    /// Polynomials of irradiance and radiosity.
    pub solution: Solution,
    /// Self-checks.
    pub checks: Checks,
    /// Numbers of pairs by how they were treated.
    pub pairs: PairCounts,
    /// Terms of the kernel's quadrature rules.
    pub samples: u64,
    /// Kernel evaluations; fewer than the terms where kernel values repeat.
    pub distinct: u64,
    /// Segments tested for visibility.
    pub rays: u64,
    /// Largest error that unresolved parts leave in a block, relative to its scale ([`Blocks::accuracy_reached`]).
    pub accuracy_reached: f64,
    /// Name of the solver that was used, also where the choice was left open.
    pub solver: &'static str,
    /// Iterations, largest over the bands.
    pub iterations: usize,
    /// Relative residual of the original system, largest over the bands.
    pub residual: f64,
    /// Whether direct light was split off.
    pub split: bool,
    /// Whether the solver converged in every band; if not, the solution is its best iterate.
    pub converged: bool,
    /// Wall time of each stage.
    pub seconds: Stages,
}

/// Wall time per stage.
#[derive(Clone, Copy, Debug, Default)]
pub struct Stages {
    /// Cutting into elements, with their bases.
    pub elements: Duration,
    /// Finding out whether anything can cast a shadow.
    pub visibility: Duration,
    /// Blocks of G, visibility within them included.
    pub blocks: Duration,
    /// Direct light and its first bounce, where they are split off.
    pub direct: Duration,
    /// The linear systems.
    pub solve: Duration,
    /// Estimation of the error from gathered light, where an accuracy is wanted.
    pub estimate: Duration,
}

/// Why a scene could not be solved.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The scene could not be cut into elements.
    #[error(transparent)]
    Elements(#[from] ElementError),
    /// The rules of 1993 were asked for, but they do not know the shape of a surface.
    #[error(
        "surface '{surface}': the rules of 1993 know parallelograms and curved surfaces only, without holes: \
         choose the default kernel, or cut the surface into parallelograms"
    )]
    NoChart {
        /// Name of the surface.
        surface: String,
    },
    /// The linear solver failed.
    #[error("band '{band}': {source}")]
    Solver {
        /// Name of the band.
        band: String,
        /// What the solver says.
        source: SolveError,
    },
    /// More memory is needed than allowed.
    #[error(
        "not enough memory: about {:.1} MB are needed, {:.1} MB allowed; {}",
        *needed as f64 / 1e6, *allowed as f64 / 1e6, fit::list(fits)
    )]
    Memory {
        /// Bytes needed, estimated.
        needed: u64,
        /// Bytes allowed.
        allowed: u64,
        /// Changes that would fit, if any.
        fits: Vec<Fit>,
    },
    /// No threads could be started.
    #[error("cannot start {threads} threads: {source}; ask for fewer with --threads")]
    Threads {
        /// How many were asked for.
        threads: usize,
        /// What the system says.
        source: ThreadPoolBuildError,
    },
}

/// Solves `scene`; `progress` may be called from any thread.
///
/// # Errors
/// A scene that cannot be cut into elements, a linear solver that fails or does not converge, or threads
/// that cannot be started.
pub fn solve(
    scene: &Scene,
    options: &Options,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Outcome, Failure> {
    in_threads(options.threads, || solve_in_pool(scene, options, progress))?
}

/// Runs `work` with that many threads.
///
/// # Errors
/// Threads that cannot be started.
pub fn in_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> Result<T, Failure> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|source| Failure::Threads { threads, source })?;
    Ok(pool.install(work))
}

fn solve_in_pool(
    scene: &Scene,
    options: &Options,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Outcome, Failure> {
    let mut seconds = Stages::default();
    let (visibility, subdivide) = timed(&mut seconds.visibility, || {
        let visibility = Visibility::new(scene, options.into());
        let auto = || Subdivide::Auto { occluded: visibility.any_shadow() };
        let subdivide = options.subdivide.map_or_else(auto, Subdivide::Uniform);
        (visibility, subdivide)
    });
    let how =
        Discretization { order: options.order, space: options.space, subdivide, layers: options.layers };
    progress(Progress::Finished("visibility", seconds.visibility));
    require_memory(scene, &how, options)?;
    let elements = timed(&mut seconds.elements, || options.elements(scene, &how))?;
    progress(Progress::Finished("elements", seconds.elements));
    let report_pairs = |done, total| progress(Progress::Blocks(done, total));
    let blocks =
        timed(&mut seconds.blocks, || blocks(scene, &elements, &visibility, options, &report_pairs))?;
    progress(Progress::Finished("blocks", seconds.blocks));
    let coatings: Vec<Coating> =
        (0..scene.bands.len()).map(|band| Coating::of(scene, elements.list(), band)).collect();
    let (masked, bounce) = timed(&mut seconds.direct, || {
        let coatings: Vec<&Coating> = coatings.iter().collect();
        let masked = masked_light(scene, &elements, &coatings, &visibility, options);
        let bounce = bounce(&elements, &coatings, &visibility, masked.as_ref(), options);
        (masked, bounce)
    });
    if bounce.is_some() {
        progress(Progress::Finished("direct", seconds.direct));
    }
    let known = Known { elements: &elements, blocks: &blocks, bounce: bounce.as_ref() };
    let solved = timed(&mut seconds.solve, || solve_bands(scene, coatings, &known, options, progress))?;
    progress(Progress::Finished("solve", seconds.solve));
    let slowest = solved.iter().filter_map(|(_, effort)| effort.as_ref()).max_by_key(|e| e.iterations);
    let (solver, iterations) = slowest.map_or((options.method.name, 0), |e| (e.method, e.iterations));
    let converged = solved.iter().flat_map(|(_, effort)| effort).all(|effort| effort.converged);
    let bands: Vec<Band> = solved.into_iter().map(|(band, _)| band).collect();
    let residual = bands.iter().map(|band| band.coefficients.residual).fold(0.0, f64::max);
    let solution = Solution::new(elements, bands).with_masks(masked);
    let checks = Checks::of(&solution, &blocks, bounce.as_ref());
    let Blocks { pairs, samples, distinct, rays, accuracy_reached, .. } = blocks;
    Ok(Outcome {
        solution,
        checks,
        pairs,
        samples,
        distinct,
        rays,
        accuracy_reached,
        solver,
        iterations,
        residual,
        split: bounce.is_some(),
        converged,
        seconds,
    })
}

/// Refuses a run that needs more memory than allowed.
fn require_memory(scene: &Scene, how: &Discretization, options: &Options) -> Result<(), Failure> {
    let Some(allowed) = options.memory else { return Ok(()) };
    let peak = |how: &Discretization, method| Footprint::of(scene, how, method).peak();
    let needed = peak(how, options.method);
    if needed <= allowed {
        return Ok(());
    }
    let mut fits = Vec::new();
    let cg = Method::named("cg").expect("cg is always listed");
    if peak(how, cg) <= allowed {
        fits.push(Fit::ConjugateGradients);
    }
    let lower = (0..how.order)
        .rev()
        .find(|order| peak(&Discretization { order: *order, ..*how }, options.method) <= allowed);
    fits.extend(lower.map(Fit::Order));
    let whole = Discretization { subdivide: Subdivide::Uniform(1), layers: Layers::NONE, ..*how };
    if peak(&whole, options.method) <= allowed {
        fits.push(Fit::WholeSurfaces);
    }
    Err(Failure::Memory { needed, allowed, fits })
}

fn blocks(
    scene: &Scene,
    elements: &Elements,
    visibility: &Visibility,
    options: &Options,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Blocks, Failure> {
    let Some(rules) = options.kernel else {
        let sends = |element: usize| scene.surfaces[elements.list()[element].surface].material.sends();
        return Ok(transport::assemble_senders(elements, &sends, visibility, options.accuracy(), progress));
    };
    transfers::assemble(elements, visibility, rules, transfers::EXTRA_POINTS, progress)
        .map_err(|error| Failure::NoChart { surface: scene.surfaces[error.surface].name.clone() })
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

/// The first bounce, where direct light is split off or masked.
fn bounce(
    elements: &Elements,
    coatings: &[&Coating],
    visibility: &Visibility,
    masked: Option<&MaskedLight>,
    options: &Options,
) -> Option<Bounce> {
    let list = elements.list();
    if let Some(masked) = masked {
        let lit = |element: usize, node: &Node| {
            let parameters = node.parameters.to_array();
            let at = |band| masked.at(band, list, element, node.position, parameters);
            (0..coatings.len()).map(at).collect()
        };
        return Some(Bounce::of(list, coatings, visibility, &lit, options.shadow_eps));
    }
    let splits = options.direct.splits(list, coatings, visibility, options.kernel.is_none());
    splits.then(|| Bounce::new(list, coatings, visibility, AT_A_POINT * options.shadow_eps))
}

/// Data that the bands share.
struct Known<'a> {
    elements: &'a Elements,
    blocks: &'a Blocks,
    bounce: Option<&'a Bounce>,
}

impl Known<'_> {
    fn system<'a>(&'a self, band: usize, coating: &'a Coating) -> System<'a> {
        let list = self.elements.list();
        match self.bounce {
            None => System::new(list, self.blocks, coating),
            Some(Bounce { direct, reflected }) => {
                System::split(list, self.blocks, coating, direct[band].clone(), reflected[band].clone())
            }
        }
    }
}

fn solve_bands(
    scene: &Scene,
    coatings: Vec<Coating>,
    known: &Known,
    options: &Options,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Vec<(Band, Option<Effort>)>, Failure> {
    let solve = |(index, coating): (usize, Coating)| {
        let name = &scene.bands[index];
        let mut observe = |step: &Step<'_>| progress(Progress::Solve(index, step.iteration, step.residual));
        let solved = solve_band(&known.system(index, &coating), options, &mut observe);
        let (coefficients, effort) =
            solved.map_err(|source| Failure::Solver { band: name.clone(), source })?;
        Ok((Band::new(name.clone(), known.elements, coating, coefficients), effort))
    };
    coatings.into_iter().enumerate().map(solve).collect()
}

/// The cost of a band's linear system.
struct Effort {
    method: &'static str,
    iterations: usize,
    converged: bool,
}

/// The cost of a finished solver; with `keep_partial` the best iterate of one that did not converge counts too.
fn effort(ended: Result<Report, SolveError>, keep_partial: bool) -> Result<Effort, SolveError> {
    match ended {
        Ok(Report { method, iterations, .. }) => Ok(Effort { method, iterations, converged: true }),
        Err(SolveError::NotConverged { method, iterations, .. }) if keep_partial => {
            Ok(Effort { method, iterations, converged: false })
        }
        Err(error) => Err(error),
    }
}

fn solve_band(
    system: &System,
    options: &Options,
    observe: &mut dyn FnMut(&Step<'_>),
) -> Result<(Coefficients, Option<Effort>), SolveError> {
    let right = system.right_hand_side();
    let mut unknowns = vec![0.0; right.len()];
    // Only shooting needs it, and it costs as much as a basis.
    let measure = (options.method.name == "southwell").then(|| system.shooting_measure());
    let mut needed = None;
    if right.iter().any(|value| *value != 0.0) {
        let settings = Settings {
            tolerance: options.tolerance,
            max_iterations: options.max_iterations,
            threads: options.threads,
            measure: measure.as_deref(),
            ..Settings::default()
        };
        let solver = options.method.solver;
        let ended = solver.solve(&system.matrix()?, &right, &mut unknowns, &settings, observe);
        needed = Some(effort(ended, options.keep_partial)?);
    }
    Ok((system.coefficients(&unknowns), needed))
}

/// Runs `work`, and stores its wall time in `stage`.
pub(crate) fn timed<T>(stage: &mut Duration, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    *stage = start.elapsed();
    result
}
