//! Requests for the computation of light, and the library's options that follow.

use std::num::NonZeroUsize;
use std::time::{Duration, Instant};

use radiosity_elements::cells::Layers;
use radiosity_elements::space::Space;
use radiosity_published::bases::Basis;
use radiosity_published::hierarchy::LinkMeasure;
use radiosity_published::zatz1993::masking::{Average, Masking};
use radiosity_reading::quality::Quality;
use radiosity_reading::reader::ReadMode;
use radiosity_solve::{
    ColumnChoice, Direct, LightMethod, Linking, Options, Preconditioning, RelaxedAtOnce, Relaxing, ShotLimit,
    SweepOrder, Transport,
};
use radiosity_solvers::method::Method;
use radiosity_work::Deadline;
use radiosity_work::ranks::Ranks;
use serde::Deserialize;

use super::aim::AccuracyOf;
use super::memory;
use super::modes::{self, Kernel, LightShadows};
use super::ranges::{self, Accuracy, Bytes, Fraction, Number, Order, Positive, Seconds, Subdivide, by_text};

/// The accuracy that `--order auto` means. Chosen.
const AUTO_ACCURACY: f64 = 1e-2;

/// Options of the computation of light; None where nothing is said.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Method"))]
pub struct MethodRequest {
    /// Preset of order and accuracies, and of how finely probe, grid and report read; single options go
    /// before it [default: default]
    #[cfg_attr(feature = "clap", arg(long, value_name = "Q"))]
    pub quality: Option<Quality>,

    /// Which algorithm finds the light [default: galerkin]
    #[cfg_attr(feature = "clap", arg(long, value_name = "NAME"))]
    pub method: Option<LightMethod>,

    /// Functions whose sums the light on surfaces is; those other than legendre are for comparison [default:
    /// legendre]
    #[cfg_attr(feature = "clap", arg(long, value_name = "NAME"))]
    pub basis: Option<Basis>,

    /// Degree of the polynomials on each element; 0 is classical radiosity, auto is --accuracy 1e-2 [default:
    /// 3; as --quality says]
    #[serde(deserialize_with = "by_text")]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N|auto"))]
    pub order: Option<Order>,

    /// Wanted relative error: raises order, layers, cuts and accuracies until it is reached
    #[cfg_attr(feature = "clap", arg(long, value_name = "A"))]
    pub accuracy: Option<Number<Fraction>>,

    /// Of what the accuracy is wanted: gathered (light on all surfaces, as sensors and pictures read it),
    /// solution (the polynomials), picture (what the scene's camera sees), points FILE.csv, or plane NAME
    /// [default: gathered; the sensors that probe reads]
    #[serde(skip)]
    #[cfg_attr(feature = "clap", arg(long = "for", id = "for", value_name = "WHAT"))]
    pub aim: Option<AccuracyOf>,

    /// Seconds in which the run is to end with the best so far and its error: rays end, half of them before light is
    /// read, no finer run begins, and pictures take what is done in time. What is asked for by rules takes its time,
    /// and so do .glb and .html; an accuracy that is wanted and missed ends with exit code 3
    #[cfg_attr(feature = "clap", arg(long, value_name = "SECONDS"))]
    pub time_limit: Option<Number<Seconds>>,

    /// Polynomials of that degree in each coordinate, not in both together
    #[cfg_attr(feature = "clap", arg(long))]
    pub tensor: bool,

    /// Cuts each surface into K × K elements; auto looks at what the scene needs [default: auto]
    #[serde(deserialize_with = "by_text")]
    #[cfg_attr(feature = "clap", arg(long, value_name = "auto|K"))]
    pub subdivide: Option<Subdivide>,

    /// Layers of elements graded towards the sides of every surface [default: 0]
    #[cfg_attr(feature = "clap", arg(long, value_name = "L"))]
    pub layers: Option<ranges::Layers>,

    /// Size of each layer against the next, between 0 and 1 [default: 0.25]
    #[cfg_attr(feature = "clap", arg(long, value_name = "Q"))]
    pub ratio: Option<Number<Fraction>>,

    /// Accuracy of the transfers between elements, between 0 and 1; of hierarchical radiosity the greatest
    /// power of a link, in parts of all that is emitted, or form factor [default: 1e-3; as --quality says]
    #[cfg_attr(feature = "clap", arg(long, value_name = "E"))]
    pub eps: Option<Number<Accuracy>>,

    /// The measure of a link that --eps bounds, of hierarchical radiosity [default: power]
    #[cfg_attr(feature = "clap", arg(long, value_name = "WHAT"))]
    pub link_measure: Option<LinkMeasure>,

    /// Rays that find what is hidden of a link of hierarchical radiosity [default: 16]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N", allow_negative_numbers = true))]
    pub link_rays: Option<ranges::LinkRays>,

    /// Part of the area of all surfaces up to which hierarchical radiosity does not cut faces [default: 1e-6;
    /// 1e-3 by form factors]
    #[cfg_attr(feature = "clap", arg(long, value_name = "A", allow_negative_numbers = true))]
    pub least_area: Option<Number<Fraction>>,

    /// Rules of the transfers between elements; those of 1993 ignore --eps [default: default]
    #[cfg_attr(feature = "clap", arg(long, value_name = "MODE"))]
    pub kernel: Option<Kernel>,

    /// How the pairs of elements are carried [default: auto]
    #[cfg_attr(feature = "clap", arg(long, value_name = "MODE"))]
    pub transport: Option<Transport>,

    /// Rays of the sampled transport [default: by the number of surfaces and --shadow-eps]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub rays: Option<ranges::Rays>,

    /// Solver of the linear system [default: auto]
    #[serde(deserialize_with = "modes::solver")]
    #[cfg_attr(feature = "clap", arg(long, value_name = "NAME", value_parser = modes::solvers()))]
    pub solver: Option<&'static Method>,

    /// How cg and gmres precondition [default: block]
    #[cfg_attr(feature = "clap", arg(long, value_name = "NAME"))]
    pub preconditioner: Option<Preconditioning>,

    /// With --solver southwell, when a block column of the transfers is integrated [default: as it is shot; all where
    /// rays carry the light, and wherever else the summary says so]
    #[cfg_attr(feature = "clap", arg(long, value_name = "WHEN"))]
    pub columns: Option<ColumnChoice>,

    /// Stops after K shots of --solver southwell in each band and light group: the polynomials then hold what
    /// was shot and what has arrived [default: as many as --tolerance takes]
    #[cfg_attr(feature = "clap", arg(long, value_name = "K", allow_negative_numbers = true))]
    pub shots: Option<ranges::ShotCount>,

    /// Adds to the light of --shots the ambient term of Cohen 1988: what all further shots would bring, if it
    /// were the same everywhere
    #[cfg_attr(feature = "clap", arg(long))]
    pub ambient: bool,

    /// Unknowns that jacobi, gauss-seidel and southwell relax at a time [default: block]
    #[cfg_attr(feature = "clap", arg(long, value_name = "WHAT"))]
    pub at_once: Option<RelaxedAtOnce>,

    /// The order in which gauss-seidel visits the elements [default: forward]
    #[cfg_attr(feature = "clap", arg(long, value_name = "ORDER"))]
    pub sweep: Option<SweepOrder>,

    /// Factor of every correction of jacobi, richardson, gauss-seidel and southwell, between 0 and 2: above 1
    /// overshoots [default: 1]
    #[cfg_attr(feature = "clap", arg(long, value_name = "W", allow_negative_numbers = true))]
    pub relaxation: Option<Number<ranges::Relaxation>>,

    /// Vectors that gmres keeps before it restarts [default: 50]
    #[cfg_attr(feature = "clap", arg(long, value_name = "K", allow_negative_numbers = true))]
    pub restart: Option<ranges::Restart>,

    /// Light that was reflected K times at the most before it arrives: 0 for light straight from emitters
    /// [default: all]
    #[cfg_attr(feature = "clap", arg(long, value_name = "K", allow_negative_numbers = true))]
    pub bounces: Option<ranges::Bounces>,

    /// Relative residual at which an iterative solver stops [default: 1e-8]
    #[cfg_attr(feature = "clap", arg(long, value_name = "T"))]
    pub tolerance: Option<Number<Positive>>,

    /// Iterations after which an iterative solver gives up [default: 1000]
    #[cfg_attr(feature = "clap", arg(long, value_name = "K"))]
    pub max_iterations: Option<ranges::Iterations>,

    /// How it is found out what surfaces hide from each other [default: auto]
    #[cfg_attr(feature = "clap", arg(long, value_name = "MODE"))]
    pub shadows: Option<LightShadows>,

    /// How light straight from emitters enters the solution [default: auto]
    #[cfg_attr(feature = "clap", arg(long, value_name = "MODE"))]
    pub direct: Option<Direct>,

    /// Part of the light between two elements that may be in or out of shadow unnoticed, between 0 and 1
    /// [default: --eps where that is given, else 3e-3, as --quality says]
    #[cfg_attr(feature = "clap", arg(long, value_name = "E"))]
    pub shadow_eps: Option<Number<Accuracy>>,

    /// Cells of a shadow mask along each side, at the finest, with --shadows mask [default: 40]
    #[cfg_attr(feature = "clap", arg(long, value_name = "M"))]
    pub mask_cells: Option<ranges::MaskCells>,

    /// Values of a mask [default: weighted]
    #[cfg_attr(feature = "clap", arg(long, value_name = "MODE"))]
    pub mask_average: Option<Average>,

    /// Most memory to use, such as 500M, 2G or 2GiB [default: 80 % of what is free]
    #[serde(deserialize_with = "by_text")]
    #[cfg_attr(feature = "clap", arg(long, value_name = "BYTES"))]
    pub memory: Option<Bytes>,

    /// Threads to use, all by default; results do not depend on it
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub threads: Option<ranges::Threads>,
}

impl MethodRequest {
    /// The relative error wanted, if one is.
    pub fn wanted_accuracy(&self) -> Option<f64> {
        let of_order = || (self.order == Some(Order::Auto)).then_some(AUTO_ACCURACY);
        self.accuracy.map(f64::from).or_else(of_order)
    }

    /// The library's options on these ranks.
    pub fn options(&self, ranks: &Ranks) -> Options {
        let usual = self.quality.unwrap_or_default().options();
        Options {
            method: self.method.unwrap_or(usual.method),
            basis: self.basis.unwrap_or(usual.basis),
            order: self.degree(usual.order),
            space: if self.tensor { Space::Tensor } else { Space::Total },
            subdivide: self.subdivide.unwrap_or_default().0,
            layers: self.graded_layers(),
            eps: self.eps.map_or(usual.eps, f64::from),
            linking: self.linking(),
            kernel: self.kernel.unwrap_or_default().rules(),
            transport: self.transport.unwrap_or(usual.transport),
            rays: self.rays.map(u64::from),
            shadow_eps: self.shadow_eps.or(self.eps).map_or(usual.shadow_eps, f64::from),
            shadows: self.shadows.map_or(usual.shadows, LightShadows::found),
            masks: (self.shadows == Some(LightShadows::Mask)).then(|| self.masking()),
            direct: self.direct.unwrap_or(usual.direct),
            solver: self.solver().unwrap_or(usual.solver),
            preconditioner: self.preconditioner.unwrap_or(usual.preconditioner),
            relaxing: self.relaxing(),
            columns: self.columns,
            shots: self.shots.map(|shots| ShotLimit { count: shots.count(), ambient: self.ambient }),
            bounces: self.bounces.map(ranges::Bounces::count),
            tolerance: self.tolerance.map_or(usual.tolerance, f64::from),
            max_iterations: self.max_iterations.map_or(usual.max_iterations, ranges::Iterations::count),
            memory: memory::allowed(self.memory, ranks),
            threads: self.threads.map_or(usual.threads, ranges::Threads::count),
            ..usual
        }
    }

    /// The solver that was asked for, or follows from a number of shots.
    pub(super) fn solver(&self) -> Option<&'static Method> {
        self.solver.or(self.shots.map(|_| &Method::SOUTHWELL))
    }

    /// Ways of solvers that relax, and of gmres.
    fn relaxing(&self) -> Relaxing {
        let usual = Relaxing::default();
        Relaxing {
            at_once: self.at_once.unwrap_or(usual.at_once),
            sweep: self.sweep.unwrap_or(usual.sweep),
            relaxation: self.relaxation.map_or(usual.relaxation, f64::from),
            restart: self.restart.map_or(usual.restart, ranges::Restart::count),
        }
    }

    /// The reading that was asked for; of a number of shots the polynomials, which alone hold their light.
    pub fn read(&self, asked: Option<ReadMode>) -> Option<ReadMode> {
        asked.or(self.shots.map(|_| ReadMode::Basis))
    }

    /// Graded layers of elements.
    pub(super) fn graded_layers(&self) -> Layers {
        Layers {
            count: self.layers.map_or(Layers::NONE.count, ranges::Layers::count),
            ratio: self.ratio.map_or(Layers::NONE.ratio, f64::from),
        }
    }

    /// Links of hierarchical radiosity.
    pub(super) fn linking(&self) -> Linking {
        let usual = Linking::by(self.link_measure.unwrap_or_default());
        Linking {
            measure: usual.measure,
            least_area: self.least_area.map_or(usual.least_area, f64::from),
            rays_per_link: self.link_rays.map_or(usual.rays_per_link, ranges::LinkRays::count),
        }
    }

    /// Cells and averages of shadow masks.
    pub(super) fn masking(&self) -> Masking {
        let usual = Masking::default();
        let cells = self.mask_cells.and_then(|cells| NonZeroUsize::new(cells.count()));
        Masking { cells: cells.unwrap_or(usual.cells), average: self.mask_average.unwrap_or(usual.average) }
    }

    /// The degree to begin with.
    fn degree(&self, usual: usize) -> usize {
        match (self.basis, self.order) {
            (Some(Basis::Constant), _) => 0,
            (Some(Basis::Linear), _) => 1,
            (_, Some(Order::Degree(order))) => order,
            (_, None) if self.wanted_accuracy().is_none() => usual,
            (_, Some(Order::Auto) | None) => 0,
        }
    }

    /// Time at which this part of the time limit ends, of a run that began at `start`; none without a limit.
    pub fn part_ends(&self, start: Instant, part: f64) -> Option<Instant> {
        let limit = Duration::try_from_secs_f64(self.time_limit?.into()).ok()?;
        start.checked_add(limit.mul_f64(part))
    }

    /// The deadline of the time limit, from now on; none without a limit.
    pub fn deadline(&self) -> Option<Deadline> {
        self.part_ends(Instant::now(), 1.0).map(|at| Deadline::at(Some(at)))
    }
}
