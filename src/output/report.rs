//! The report of a run: JSON with stable keys.

use serde::Serialize;

use crate::checks::Checks;
use crate::elements::Elements;
use crate::hierarchy::Counts;
use crate::inspection::Inspection;
use crate::output::missed::missed;
use crate::output::plane_figures::PlaneFigures;
use crate::output::read_error::ReadError;
use crate::scene::{Fitted, Imported, LightGroup, Scene};
use crate::solve::{Options, Outcome};
use crate::solved::Solved;
use crate::studies::adaptation::{Achieved, End};
use crate::transport::{Miss, PairCounts};

/// The report of a run: what was done, its cost, and self-checks.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Name of the scene.
    pub scene: String,
    /// Names of its bands.
    pub bands: Vec<String>,
    /// Unit of exitance, irradiance and radiosity.
    pub unit: String,
    /// Number of surfaces.
    pub surfaces: usize,
    /// What was done to the file of another program that it was read from; none for other scenes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub imported: Option<Imported>,
    /// How their shapes were changed to fit together when the scene was read.
    pub fitted: Fitted,
    /// Its light groups with their factors.
    pub light_groups: Vec<LightGroup>,
    /// Number of elements.
    pub elements: usize,
    /// Number of coefficients per band.
    pub unknowns: usize,
    /// Total degree where a surface does not state its own.
    pub order: usize,
    /// Lowest and highest degree of any element.
    pub orders: [usize; 2],
    /// Name of the solver that was used.
    pub solver: String,
    /// Threads used.
    pub threads: usize,
    /// Version of the program.
    pub version: &'static str,
    /// Wall time per stage.
    pub seconds: Seconds,
    /// Peak memory, where the system reports it.
    pub peak_bytes: Option<u64>,
    /// What carried the pairs of elements, why, and how well.
    pub transport: Transport,
    /// Numbers of pairs of elements by how they were treated.
    pub pairs: PairCounts,
    /// Terms of the kernel's quadrature rules.
    pub kernel_samples: u64,
    /// Kernel evaluations; fewer than the terms where kernel values repeat.
    pub kernel_samples_distinct: u64,
    /// Segments tested for visibility.
    pub shadow_rays: u64,
    /// Largest error that unresolved parts leave in a block, relative to the larger of its largest entry and a
    /// hundredth of its row's; zero where every part was resolved.
    pub accuracy_reached: f64,
    /// Estimated relative error of the radiosity, where an accuracy was wanted.
    pub accuracy_estimate: Option<f64>,
    /// How direct light entered: `split` or `projected`.
    pub direct: &'static str,
    /// Iterations of the solver, largest over the bands.
    pub iterations: usize,
    /// ‖b − e − ρ h‖₂ / ‖e‖₂, largest over the bands.
    pub residual: f64,
    /// Whether the solver reached its tolerance.
    pub converged: bool,
    /// Self-checks.
    pub checks: Checks,
    /// What the sensors of planes read.
    pub planes: Vec<PlaneFigures>,
    /// Errors of light that rays gathered at points.
    pub read_error: Option<ReadError>,
    /// Warnings to the user.
    pub warnings: Vec<Warning>,
}

/// What carried the pairs of elements.
#[derive(Clone, Debug, Serialize)]
pub struct Transport {
    /// `exact`, `sampled` or `hierarchical`.
    pub kind: &'static str,
    /// Why it was chosen.
    pub why: String,
    /// Rays sent; 0 if exact.
    pub rays: u64,
    /// Pairs of elements that were carried exactly beside the rays.
    pub exact_pairs: usize,
    /// Estimate of the relative error that rays leave in the mean irradiances of the elements (L2, largest of the
    /// bands); none if exact.
    pub error: Option<f64>,
    /// What was linked, if hierarchical.
    pub links: Option<Counts>,
}

impl Transport {
    fn of(outcome: &Outcome) -> Self {
        let kind = match outcome.links {
            Some(_) => "hierarchical",
            None if outcome.choice.sampled => "sampled",
            None => "exact",
        };
        let rays = outcome.sampling.map_or(0, |sampling| sampling.rays);
        let error = outcome.sampling.and_then(|sampling| sampling.error);
        let exact_pairs = outcome.sampling.map_or(0, |sampling| sampling.exact_pairs);
        Self { kind, why: outcome.choice.why.clone(), rays, exact_pairs, error, links: outcome.links }
    }
}

/// Wall time per stage, s.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Seconds {
    /// Reading the scene.
    pub load: f64,
    /// Cutting it into elements.
    pub elements: f64,
    /// Blocks of G, visibility within them included.
    pub blocks: f64,
    /// Finding surfaces that can cast a shadow.
    pub visibility: f64,
    /// Direct light and its first bounce, where they are split off.
    pub direct: f64,
    /// The linear systems.
    pub solve: f64,
    /// Estimation of the error from gathered light, where an accuracy is wanted.
    pub estimate: f64,
    /// Pictures, grids and files.
    pub output: f64,
    /// Everything.
    pub total: f64,
}

/// Something the user should know.
#[derive(Clone, Debug, Serialize)]
pub struct Warning {
    /// Stable name of the kind of warning.
    pub code: String,
    /// The warning, with its cure.
    pub message: String,
    /// The surface concerned.
    pub surface: Option<String>,
    /// The other surface, where it concerns a pair.
    pub other: Option<String>,
    /// How large it is: the error that is left, or a row sum above 1.
    pub size: Option<f64>,
}

impl Report {
    /// The report of a solved scene; the caller sets the times of loading and output, the total, and what planes
    /// read.
    pub fn new(solved: &Solved) -> Self {
        let Solved { scene, options, outcome, achieved, .. } = solved;
        let elements = outcome.solution.elements();
        Self {
            scene: scene.name.clone(),
            bands: scene.bands.clone(),
            unit: scene.unit.clone(),
            surfaces: scene.surfaces.len(),
            imported: scene.imported().cloned(),
            fitted: scene.fitted.clone(),
            light_groups: scene.light_groups().into_iter().cloned().collect(),
            elements: elements.list().len(),
            unknowns: elements.coefficients(),
            order: options.order,
            orders: orders(elements),
            solver: outcome.solver.to_owned(),
            threads: options.threads,
            version: env!("CARGO_PKG_VERSION"),
            seconds: seconds(outcome),
            peak_bytes: peak_bytes(),
            transport: Transport::of(outcome),
            pairs: outcome.pairs,
            kernel_samples: outcome.samples,
            kernel_samples_distinct: outcome.distinct,
            shadow_rays: outcome.rays,
            accuracy_reached: outcome.accuracy_reached,
            accuracy_estimate: achieved.and_then(|achieved| achieved.estimate),
            direct: if outcome.split { "split" } else { "projected" },
            iterations: outcome.iterations,
            residual: outcome.residual,
            converged: outcome.converged,
            checks: outcome.checks,
            planes: Vec::new(),
            read_error: None,
            warnings: warnings(solved),
        }
    }

    /// Adds the errors of readings by rays that were to err by `asked`, with a warning where they err by much more.
    pub fn add_read_error(&mut self, error: Option<ReadError>, asked: f64) {
        let missed = error.filter(|error| error.rms > MISSED * asked);
        self.warnings.extend(missed.map(|error| {
            let message = format!(
                "rays leave errors of {:.1e} in what is read, {:.1e} at most, where {asked:.1e} was asked for: some points \
                 see small bright things or the edges of many; ask for a smaller --read-eps there",
                error.rms, error.largest
            );
            warning("reading-error", message)
        }));
        self.read_error = error;
    }

    /// Adds what planes read, with warnings of sensors without light.
    pub fn add_planes(&mut self, planes: Vec<PlaneFigures>) {
        self.warnings.extend(planes.iter().filter_map(dark));
        self.planes.extend(planes);
    }
}

/// Errors of readings, over those asked for, that are worth a warning. Chosen.
const MISSED: f64 = 1.5;

/// A warning about sensors without light, which a plane that goes through furniture has.
fn dark(plane: &PlaneFigures) -> Option<Warning> {
    let message = || {
        format!(
            "{} of the {} sensors of plane {:?} get no light, as sensors within a body do, and count in its figures: move \
             the plane, or read several planes around what stands in it",
            plane.dark, plane.points, plane.name
        )
    };
    (plane.dark > 0).then(|| warning("dark-sensors", message()))
}

/// Lowest and highest degree of the elements; zeros if there are none.
fn orders(elements: &Elements) -> [usize; 2] {
    let orders = || elements.list().iter().map(|element| element.basis.order());
    [orders().min().unwrap_or(0), orders().max().unwrap_or(0)]
}

fn seconds(outcome: &Outcome) -> Seconds {
    let stages = outcome.seconds;
    Seconds {
        elements: stages.elements.as_secs_f64(),
        blocks: stages.blocks.as_secs_f64(),
        visibility: stages.visibility.as_secs_f64(),
        direct: stages.direct.as_secs_f64(),
        solve: stages.solve.as_secs_f64(),
        estimate: stages.estimate.as_secs_f64(),
        ..Seconds::default()
    }
}

fn warnings(solved: &Solved) -> Vec<Warning> {
    let Solved { scene, options, outcome, achieved, .. } = solved;
    let unconverged = (!outcome.converged).then(|| unconverged(outcome));
    let adapted = achieved.iter().flat_map(|achieved| adaptation(scene, achieved));
    let transfers = discretization(scene, options, outcome);
    let power = power(&outcome.checks, options.accuracy().eps.max(outcome.accuracy_reached));
    unconverged
        .into_iter()
        .chain(adapted)
        .chain(transfers)
        .chain(power)
        .chain(geometry(scene, outcome))
        .collect()
}

/// What an inspection finds wrong with a scene that loses power, or elements of which send more than they have. Scenes
/// of many surfaces are left to `radiosity check`.
fn geometry(scene: &Scene, outcome: &Outcome) -> Vec<Warning> {
    let checks = &outcome.checks;
    let is_odd = checks.energy_lost.abs() > ODD * checks.energy_in || checks.row_sum_max > 1.0 + ODD;
    if !is_odd || scene.surfaces.len() > FEW {
        return Vec::new();
    }
    let found = Inspection::of(scene).warnings.into_iter().filter(|found| !found.is_of_something_missing());
    found.map(|found| Warning { surface: found.surface, ..warning(found.code, found.message) }).collect()
}

/// A warning where power appears, or is lost though no element sends light past all others by more than their transfers
/// may miss: where little is absorbed, every reflection adds their error once more.
fn power(checks: &Checks, error: f64) -> Option<Warning> {
    let lost = checks.energy_lost / checks.energy_in;
    let looks_closed = checks.row_sum_min > 1.0 - CLOSED * error;
    let message = match lost {
        _ if lost < -ODD => format!("{:.0} % more power is absorbed than emitted", -100.0 * lost),
        _ if lost > ODD && looks_closed => {
            format!("{:.0} % of the power is lost in a scene that looks closed", 100.0 * lost)
        }
        _ => return None,
    };
    let cure = "where surfaces reflect nearly all light, the error of the transfers counts once for every reflection: lower \
                --eps, or send more --rays";
    Some(warning("power-balance", format!("{message}; {cure}")))
}

fn warning(code: &str, message: String) -> Warning {
    Warning { code: code.to_owned(), message, surface: None, other: None, size: None }
}

fn unconverged(outcome: &Outcome) -> Warning {
    let message = format!(
        "the solver did not converge, the relative residual is {:.1e}: the light is incomplete; raise --max-iterations or \
         take another --solver",
        outcome.residual
    );
    warning("not-converged", message)
}

/// Warnings if a wanted accuracy was not reached.
fn adaptation(scene: &Scene, achieved: &Achieved) -> Vec<Warning> {
    let mut warnings = Vec::new();
    if let Some(why) = why(achieved.end) {
        let estimate = match achieved.estimate {
            Some(estimate) => format!("the estimated error is {estimate:.1e}, more than asked for"),
            None => "there is no estimate of the error".to_owned(),
        };
        warnings.push(warning("accuracy-not-reached", format!("{estimate}, and {why}")));
    }
    if scene.surfaces.iter().any(|surface| surface.order.is_some() || surface.subdivide.is_some()) {
        let message = "some surfaces state their own order or subdivide and keep it: no run is finer there, and what \
                       they miss stays in the estimated error";
        warnings.push(warning("accuracy-fixed", message.to_owned()));
    }
    warnings
}

/// Why no finer run followed and what to do; None if none was needed.
fn why(end: End) -> Option<&'static str> {
    match end {
        End::Reached => None,
        End::Finest => Some("there is no finer run to try: begin with a higher --order, or ask for less"),
        End::Unknowns => Some(
            "the next finer elements would be too many: give surfaces with shadows or small details a subdivide of their \
             own, or ask for less",
        ),
        End::Memory => {
            Some("the next finer run does not fit into memory: allow more with --memory, or ask for less")
        }
        End::NotConverged => Some(
            "the solver did not converge in a finer run: raise --max-iterations, or take another --solver",
        ),
        End::Time => Some(
            "the next finer run would have taken longer than allowed: allow more with --time-limit, or ask for less",
        ),
        End::Stopped => Some("the run was stopped: let it go on, or ask for less"),
    }
}

/// Share of the power that is lost, and of what an element sends too much, from which the geometry is inspected; and the
/// number of surfaces up to which that takes about a second at most. Chosen.
const ODD: f64 = 0.01;
const FEW: usize = 300;

/// Errors of the transfers within which row sums count as 1.
const CLOSED: f64 = 3.0;

/// Error of the mean irradiances of elements above which more rays are advised. Chosen: light gathered from such
/// elements at points was
/// 3 % off in a classroom.
const ROUGH: f64 = 0.15;

/// A warning where rays leave a large error.
fn rays(error: Option<f64>) -> Option<Warning> {
    let message = || match error {
        None => "rays leave an unknown error: half of them are too few for a solution; send more with --rays"
            .to_owned(),
        Some(error) => format!(
            "rays leave an error of about {:.0} % in the mean irradiances of the elements, less in gathered light: send more \
             with --rays, or ask for an --accuracy",
            100.0 * error
        ),
    };
    error.is_none_or(|error| error > ROUGH).then(|| warning("sampling-error", message()))
}

/// Warnings about what elements and transfers miss.
fn discretization(scene: &Scene, options: &Options, outcome: &Outcome) -> Vec<Warning> {
    if let Some(sampling) = outcome.sampling {
        // What exact pairs miss is a part of it.
        return rays(sampling.error).into_iter().collect();
    }
    let mut warnings: Vec<Warning> = outcome
        .miss
        .filter(Miss::is_real)
        .map(|miss| inaccurate(scene, outcome, &miss))
        .into_iter()
        .collect();
    let mut warn = |code: &str, message: String| warnings.push(warning(code, message));
    if outcome.pairs.unresolved > 0 {
        warn(
            "near-floor",
            format!(
                "{} pairs come so near each other, or touch in such a way, that splitting stopped: their blocks may \
                 miss the accuracy asked; subdivide the surfaces there",
                outcome.pairs.unresolved
            ),
        );
    }
    // The rules of 1993 have no accuracy.
    let cure = |usual| if options.kernel.is_some() { "choose the default kernel" } else { usual };
    let excess = outcome.checks.row_sum_max - 1.0;
    if excess > 10.0 * options.eps.max(if outcome.rays > 0 { options.shadow_eps } else { 0.0 }) {
        let message = format!(
            "an element sends {:.2} % more than it has: its transfers miss the accuracy asked; {}",
            100.0 * excess,
            cure("lower --eps, or subdivide surfaces that meet at small angles")
        );
        warn("row-sum", message);
    }
    if outcome.checks.spectral_bound >= 1.0 {
        let message = format!(
            "the spectral radius is about {:.6}: quadrature is too coarse for so little loss; {}",
            outcome.checks.spectral_bound,
            cure("lower --eps")
        );
        warn("spectral-bound", message);
    }
    warnings
}

/// A warning about transfers that miss what was asked.
fn inaccurate(scene: &Scene, outcome: &Outcome, miss: &Miss) -> Warning {
    let list = outcome.solution.elements().list();
    let [surface, other] = miss.pair.map(|element| &scene.surfaces[list[element].surface].name);
    let told = warning("accuracy-reached", missed(miss, [surface, other]));
    Warning { surface: Some(surface.clone()), other: Some(other.clone()), size: Some(miss.error), ..told }
}

/// Peak resident memory as Linux reports it; None elsewhere.
fn peak_bytes() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024 * kibibytes)
}
