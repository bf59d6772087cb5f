//! The driver: scene → elements → blocks → system per band → solution, timed.

mod direct;
mod outline;
pub mod memory;
mod fit;
mod failure;
mod choice;
mod stop;
mod options;
mod decision;
mod progress;
mod band;
mod sampling;
mod outcome;

use std::time::{Duration, Instant};

use radiosity_solvers::{Step, method::Method};

use crate::checks::Checks;
use crate::elements::cells::Layers;
use crate::elements::coating::Coating;
use crate::elements::patch::Node;
use crate::elements::{Discretization, Elements, Subdivide};
use crate::light::first_bounce::Bounce;
use crate::scene::Scene;
use crate::solution::{Band, Solution};
use crate::solve::memory::Footprint;
use crate::system::System;
use crate::transport;
use crate::transport::Blocks;
use crate::visibility::{Shadows, Visibility};
use crate::zatz1993::masked_light::{MaskedLight, Setting};
use crate::zatz1993::transfers;

use band::{Effort, solve_band};
pub use choice::{Choice, MOST_RAYS, Transport};
pub use direct::Direct;
pub use failure::Failure;
pub use fit::Fit;
pub use options::Options;
pub use outcome::{Outcome, Stages};
pub use progress::Progress;
pub use sampling::Sampling;
use sampling::Subject;
pub use stop::Stop;

/// Tolerance of gathered light at a point over that of shadows in a block, a mean of many. Chosen; not tuned.
const AT_A_POINT: f64 = 3.0;

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
    in_threads(options.threads, || solve_in_pool(scene, options, Choice::of(scene, options), progress))?
}

/// The same by exact blocks, for the reason `why`.
///
/// # Errors
/// As [`solve`].
pub(crate) fn solve_exactly(
    scene: &Scene,
    options: &Options,
    why: &str,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Outcome, Failure> {
    let choice = Choice { sampled: false, why: why.to_owned() };
    in_threads(options.threads, || solve_in_pool(scene, options, choice, progress))?
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
    choice: Choice,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Outcome, Failure> {
    let mut seconds = Stages::default();
    let rays = choice.sampled.then(|| options.ray_budget(scene));
    let (visibility, how) = timed(&mut seconds.visibility, || {
        let visibility = Visibility::new(scene, options.into());
        let how = discretization(&visibility, options, rays);
        (visibility, how)
    });
    progress(Progress::Finished("visibility", seconds.visibility));
    require_memory(scene, &how, options, rays)?;
    let elements = timed(&mut seconds.elements, || options.elements(scene, &how))?;
    progress(Progress::Finished("elements", seconds.elements));
    let coatings: Vec<Coating> =
        (0..scene.bands.len()).map(|band| Coating::of(scene, elements.list(), band)).collect();
    let subject = Subject { elements: &elements, coatings: &coatings, visibility: &visibility, options };
    let (blocks, sampling) = timed(&mut seconds.blocks, || carried(scene, &subject, rays, progress))?;
    progress(Progress::Finished("blocks", seconds.blocks));
    let (masked, bounce) = timed(&mut seconds.direct, || direct_light(scene, &subject, choice.sampled));
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
    let Blocks { pairs, samples, distinct, rays, accuracy_reached, miss, .. } = blocks;
    Ok(Outcome {
        solution,
        checks,
        pairs,
        samples,
        distinct,
        rays,
        accuracy_reached,
        miss,
        solver,
        iterations,
        residual,
        split: bounce.is_some(),
        converged,
        choice,
        sampling,
        seconds,
    })
}

/// How the scene is cut, given the rays that carry its pairs, if any.
fn discretization(visibility: &Visibility, options: &Options, rays: Option<u64>) -> Discretization {
    let auto = || match rays {
        Some(rays) => Subdivide::Graded { rays },
        None => Subdivide::Auto { occluded: visibility.any_shadow() },
    };
    let subdivide = options.subdivide.map_or_else(auto, Subdivide::Uniform);
    Discretization { order: options.order, space: options.space, subdivide, layers: options.layers }
}

/// The blocks, by that many rays or exactly.
fn carried(
    scene: &Scene,
    subject: &Subject,
    rays: Option<u64>,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<(Blocks, Option<Sampling>), Failure> {
    if let Some(rays) = rays {
        let (blocks, sampling) = subject.sample(rays, progress);
        return Ok((blocks, Some(sampling)));
    }
    let report = |done, total| progress(Progress::Blocks(done, total));
    Ok((blocks(scene, subject.elements, subject.visibility, subject.options, &report)?, None))
}

/// Masks of direct light, where asked for, and the first bounce, where direct light is masked or split off.
fn direct_light(
    scene: &Scene,
    Subject { elements, coatings, visibility, options }: &Subject,
    is_sampled: bool,
) -> (Option<MaskedLight>, Option<Bounce>) {
    let coatings: Vec<&Coating> = coatings.iter().collect();
    let masked = masked_light(scene, elements, &coatings, visibility, options);
    let by_rules = options.kernel.is_none() && !is_sampled;
    let bounce = bounce(elements, &coatings, visibility, masked.as_ref(), options, by_rules);
    (masked, bounce)
}

/// Refuses a run that needs more memory than allowed.
fn require_memory(
    scene: &Scene,
    how: &Discretization,
    options: &Options,
    rays: Option<u64>,
) -> Result<(), Failure> {
    let Some(allowed) = options.memory else { return Ok(()) };
    if let Some(rays) = rays {
        return require_memory_of_rays(scene, how, options.method, rays, allowed);
    }
    let footprint = if options.kernel.is_some() { Footprint::of_1993 } else { Footprint::of };
    let peak = |how: &Discretization, method| footprint(scene, how, method).peak();
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

/// The same for the sampled transport, whose elements follow from the number of rays where nothing else is asked for.
fn require_memory_of_rays(
    scene: &Scene,
    how: &Discretization,
    method: &Method,
    rays: u64,
    allowed: u64,
) -> Result<(), Failure> {
    let peak = |rays: u64| {
        let subdivide = match how.subdivide {
            Subdivide::Graded { .. } => Subdivide::Graded { rays },
            given => given,
        };
        Footprint::of_rays(scene, &Discretization { subdivide, ..*how }, method, rays).peak()
    };
    let needed = peak(rays);
    if needed <= allowed {
        return Ok(());
    }
    let fewer = (1..u64::BITS).map(|halvings| rays >> halvings).take_while(|rays| *rays > 0);
    let fits = fewer.filter(|rays| peak(*rays) <= allowed).take(1).map(Fit::Rays).collect();
    Err(Failure::Memory { needed, allowed, fits })
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
    by_rules: bool,
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
    let splits = options.direct.splits(list, coatings, visibility, by_rules);
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

/// Runs `work`, and stores its wall time in `stage`.
pub(crate) fn timed<T>(stage: &mut Duration, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    *stage = start.elapsed();
    result
}
