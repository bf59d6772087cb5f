//! The report of a run: JSON with stable keys.

mod warnings;

use std::collections::{BTreeMap, BTreeSet};

use radiosity_audit::Checked;
use radiosity_elements::Elements;
use radiosity_kernel::PairCounts;
use radiosity_published::hierarchy::Counts;
use radiosity_scene::{Fitted, Imported, LightGroup};
use radiosity_solve::checks::{Checks, JointJump, joint_jump};
use radiosity_solve::solved::Solved;
use radiosity_solve::{Functional, Outcome, Shots};
use serde::Serialize;

use crate::checkpoint::Checkpoint;
use crate::exposure::Exposure;
pub use crate::masked_surfaces::MaskedSurfaces;
use crate::plane_figures::{PlaneFigures, outside_points};
use crate::probe::ProbeReading;
use crate::rank_work::{RanksWork, peak_bytes};
use crate::read_error::ReadError;
use crate::reader::ReadMode;
pub use crate::warning::Warning;
pub use warnings::underestimated;
use warnings::{missed_accuracy, warnings};

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
    /// Changes to the file of another program that the scene was read from; none for other scenes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub imported: Option<Imported>,
    /// Files that were read outside the folder of the scene, as it names them.
    #[serde(skip_serializing_if = "BTreeSet::is_empty")]
    pub read_outside: BTreeSet<String>,
    /// Changes that made the shapes of surfaces fit together when the scene was read.
    pub fitted: Fitted,
    /// Its light groups with their factors.
    pub light_groups: Vec<LightGroup>,
    /// Number of elements.
    pub elements: usize,
    /// Number of coefficients per band.
    pub unknowns: usize,
    /// Name of the basis whose functions are summed.
    pub basis: &'static str,
    /// The variational functional at the solution, for each band and light group; empty where nothing was
    /// solved for, or a file was read.
    pub functionals: Vec<Functional>,
    /// Total degree where a surface does not state its own.
    pub order: usize,
    /// Lowest and highest degree of any element.
    pub orders: [usize; 2],
    /// Name of the solver that was used.
    pub solver: String,
    /// Threads used.
    pub threads: usize,
    /// Work done and bytes sent by each rank, where several share the work.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ranks: Option<RanksWork>,
    /// Counts of work taken from a checkpoint and added to it, where work is recorded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub checkpoint: Option<Checkpoint>,
    /// Version of the program.
    pub version: &'static str,
    /// Wall time per stage.
    pub seconds: Seconds,
    /// Peak memory, where the system reports it.
    pub peak_bytes: Option<u64>,
    /// Transport that carried the pairs of elements, with its reason and error.
    pub transport: Transport,
    /// Numbers of pairs of elements by how they were treated.
    pub pairs: PairCounts,
    /// Terms of the kernel's quadrature rules.
    pub kernel_samples: u64,
    /// Kernel evaluations; fewer than the terms where kernel values repeat.
    pub kernel_samples_distinct: u64,
    /// Segments tested for visibility.
    pub shadow_rays: u64,
    /// Largest error that unresolved parts leave in a block, relative to the larger of its largest entry and
    /// a hundredth of its row's; zero where every part was resolved.
    pub accuracy_reached: f64,
    /// Estimated relative error of the radiosity, where an accuracy was wanted.
    pub accuracy_estimate: Option<f64>,
    /// Shots, and columns of the transfers that were integrated for them, where light was shot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shots: Option<Shots>,
    /// Way in which direct light entered: `split` or `projected`.
    pub direct: &'static str,
    /// Shadow masks by pairs of surfaces, where direct light is masked.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub masks: Vec<MaskedSurfaces>,
    /// Iterations of the solver, largest over the bands.
    pub iterations: usize,
    /// ‖b − e − ρ h‖₂ / ‖e‖₂, largest over the bands.
    pub residual: f64,
    /// Whether the solver reached its tolerance.
    pub converged: bool,
    /// Self-checks.
    pub checks: Checks,
    /// The largest jump of irradiance between surfaces that go on smoothly, where it was looked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint_jump_max: Option<NamedJump>,
    /// Exposure of the picture, where one was exposed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exposure: Option<Exposure>,
    /// Figures of the sensors of planes.
    pub planes: Vec<PlaneFigures>,
    /// Errors of light that rays gathered at points.
    pub read_error: Option<ReadError>,
    /// Error that a referee found in what was printed, where it was checked.
    #[serde(flatten)]
    pub checked: Option<Checked>,
    /// Warnings to the user.
    pub warnings: Vec<Warning>,
    /// Power that is emitted over the area of all surfaces (W m⁻²), beside which readings are dark.
    #[serde(skip)]
    mean_exitance: f64,
}

/// The transport that carried the pairs of elements.
#[derive(Clone, Debug, Serialize)]
pub struct Transport {
    /// `exact`, `sampled` or `hierarchical`.
    pub kind: &'static str,
    /// Reason of the choice.
    pub why: String,
    /// Rays sent; 0 if exact.
    pub rays: u64,
    /// Pairs of elements that were carried exactly beside the rays.
    pub exact_pairs: usize,
    /// Estimate of the relative error that rays leave in the mean irradiances of the elements (L2, largest of
    /// the bands); none if exact.
    pub error: Option<f64>,
    /// Numbers of nodes, links and pairs, if hierarchical.
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

/// A jump of irradiance between two surfaces.
#[derive(Clone, Debug, Serialize)]
pub struct NamedJump {
    /// The jump over the larger of the two irradiances.
    pub jump: f64,
    /// Names of the surfaces.
    pub surfaces: [String; 2],
}

/// Wall time of the stages, s. They sum to the total but for what lies in none.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Seconds {
    /// The stages by their names: `load`, the reading of the scene; `visibility`, `elements`, `direct`, `blocks`
    /// and `solve` of all solutions; `estimate` of a wanted accuracy; `tables` that readings share, and `points`,
    /// `cells`, `picture` and `texels` that were read; `referee`, the check; `output`, what was made for files.
    #[serde(flatten)]
    pub stages: BTreeMap<&'static str, f64>,
    /// The whole run.
    pub total: f64,
}

impl Report {
    /// The report of a scene that was solved with so many threads; the caller sets the times of its stages, and the
    /// figures of planes.
    pub fn new(solved: &Solved, threads: usize) -> Self {
        let Solved { scene, options, outcome, achieved, .. } = solved;
        let elements = outcome.solution.elements();
        Self {
            scene: scene.name.clone(),
            bands: scene.bands.clone(),
            unit: scene.unit.clone(),
            surfaces: scene.surfaces.len(),
            imported: scene.imported().cloned(),
            read_outside: scene.source.as_ref().map(|source| source.outside().clone()).unwrap_or_default(),
            fitted: scene.fitted.clone(),
            light_groups: scene.light_groups().into_iter().cloned().collect(),
            elements: elements.list().len(),
            unknowns: outcome.unknowns,
            basis: options.basis.name(),
            functionals: outcome.functionals.clone(),
            order: options.order,
            orders: orders(elements),
            solver: outcome.solver.to_owned(),
            threads,
            ranks: None,
            checkpoint: None,
            version: env!("CARGO_PKG_VERSION"),
            seconds: Seconds::default(),
            peak_bytes: peak_bytes(),
            transport: Transport::of(outcome),
            pairs: outcome.pairs,
            kernel_samples: outcome.samples,
            kernel_samples_distinct: outcome.distinct,
            shadow_rays: outcome.rays,
            accuracy_reached: outcome.accuracy_reached,
            accuracy_estimate: achieved.and_then(|achieved| achieved.estimate),
            shots: outcome.shots.clone(),
            direct: if outcome.split { "split" } else { "projected" },
            masks: MaskedSurfaces::of(scene, &outcome.solution),
            iterations: outcome.iterations,
            residual: outcome.residual,
            converged: outcome.converged,
            checks: outcome.checks,
            joint_jump_max: None,
            exposure: None,
            planes: Vec::new(),
            read_error: None,
            checked: None,
            warnings: warnings(solved),
            mean_exitance: outcome.checks.energy_in
                / scene.surfaces.iter().map(|own| own.shape.area()).sum::<f64>(),
        }
    }

    /// Takes the accuracy that readings by walks reached, with a warning where it is not what was wanted.
    pub fn take_achieved(&mut self, solved: &Solved) {
        let Some(achieved) = &solved.achieved else { return };
        self.accuracy_estimate = achieved.estimate;
        self.warnings.extend(missed_accuracy(&solved.scene, &solved.options, achieved));
    }

    /// Adds the errors of readings by rays that were to err by `asked`, with a warning where they err by much
    /// more.
    pub fn add_read_error(&mut self, error: Option<ReadError>, asked: f64, was_cut_short: bool) {
        self.warnings.extend(error.and_then(|error| error.warning(asked, was_cut_short)));
        self.read_error = error;
    }

    /// Adds what a referee says of light that was read from `read` and printed, with a warning where that is more than
    /// the method tells.
    pub fn add_checked(&mut self, checked: Checked, read: ReadMode) {
        self.warnings.extend(underestimated(&checked, read));
        self.checked = Some(checked);
    }

    /// Looks for the largest jump of irradiance between surfaces that go on smoothly.
    pub fn compare_joints(&mut self, Solved { scene, outcome, .. }: &Solved) {
        let named = |JointJump { jump, surfaces }| NamedJump {
            jump,
            surfaces: surfaces.map(|surface: usize| scene.surfaces[surface].name.clone()),
        };
        self.joint_jump_max = joint_jump(&outcome.solution).map(named);
    }

    /// Adds the counts of a checkpoint, with a warning where its record is incomplete.
    pub fn add_checkpoint(&mut self, checkpoint: Option<Checkpoint>) {
        self.warnings.extend(checkpoint.as_ref().and_then(Checkpoint::warning));
        self.checkpoint = checkpoint;
    }

    /// Adds the figures of planes, with warnings of sensors without light.
    pub fn add_planes(&mut self, planes: Vec<PlaneFigures>) {
        self.warnings.extend(planes.iter().filter_map(PlaneFigures::warning));
        self.planes.extend(planes);
    }

    /// Warns of points outside of the room.
    pub fn add_points(&mut self, readings: &[ProbeReading]) {
        self.warnings.extend(outside_points(readings, self.mean_exitance));
    }
}

/// Lowest and highest degree of the elements; zeros if there are none.
fn orders(elements: &Elements) -> [usize; 2] {
    let orders = || elements.list().iter().map(|element| element.basis.order());
    [orders().min().unwrap_or(0), orders().max().unwrap_or(0)]
}
