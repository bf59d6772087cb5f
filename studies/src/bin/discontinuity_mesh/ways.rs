//! Ways to the light of the floor.

use std::error::Error;
use std::num::NonZeroUsize;

use cpu_time::ProcessTime;
use radiosity::elements::{Discretization, Subdivide};
use radiosity::published::zatz1993::masking::{Average, Masking};
use radiosity::reading::quality::{Quality, ReadSettings};
use radiosity::reading::reader::ReadMode;
use radiosity::solve::driver::memory_estimate::MemoryEstimate;
use radiosity::solve::{Direct, Options, Transport, solve};
use radiosity::work::ranks::Ranks;
use radiosity::{Scene, Work};

use crate::judge::Judge;
use crate::mesh::meshed;

/// Orders of whole surfaces by polynomials alone, and with light gathered at points.
const ORDERS: [usize; 7] = [2, 3, 4, 5, 6, 7, 8];
const GATHERED: [usize; 3] = [2, 3, 4];
/// Cells of masks, and the orders of the floor and the lamp and of all others with them, as in figure 8.
const CELLS: [usize; 3] = [10, 20, 40];
const MASKED: [usize; 2] = [8, 4];
/// Order of the discontinuity mesh, and how long its pieces may be, in parts of the floor's side.
const QUADRATIC: usize = 2;
const LENGTHS: [f64; 3] = [f64::INFINITY, 0.5, 0.25];
/// Cells along each side of a surface of a mesh of that order that knows no shadows: odd numbers, as some
/// critical lines are at quarters.
const EVEN: [usize; 3] = [3, 5, 7];

/// A way to solve and to read.
pub(crate) struct Way {
    label: &'static str,
    text: String,
    scene: Scene,
    options: Options,
    read: ReadMode,
}

/// Size, error and time of a way.
pub(crate) struct Run {
    pub(crate) label: &'static str,
    pub(crate) text: String,
    pub(crate) elements: usize,
    pub(crate) unknowns: usize,
    pub(crate) megabytes: f64,
    pub(crate) error: f64,
    pub(crate) seconds: f64,
}

/// All ways of the tables, those of a kind one after another.
pub(crate) fn all(scene: &Scene, occluders: &[&str]) -> Result<Vec<Way>, Box<dyn Error>> {
    let by_order = |label, order, direct, read| Way {
        label,
        text: format!("order {order}"),
        scene: scene.clone(),
        options: Options { direct, ..of_order(order) },
        read,
    };
    let polynomials = ORDERS.map(|order| by_order("polynomials", order, Direct::Projected, ReadMode::Basis));
    let direct = GATHERED.map(|order| by_order("--read direct", order, Direct::Split, ReadMode::Direct));
    let gathered = GATHERED.map(|order| by_order("--read gather", order, Direct::Split, ReadMode::Gather));
    let ways = polynomials.into_iter().chain(meshes(scene, occluders)?).chain(masks(scene)?);
    Ok(ways.chain(direct).chain(gathered).collect())
}

/// Polynomials of an order on whole surfaces, all light in them.
fn of_order(order: usize) -> Options {
    Options {
        order,
        subdivide: Some(1),
        transport: Transport::Exact,
        direct: Direct::Projected,
        ..Options::default()
    }
}

/// Meshes cut along critical lines, and even ones.
fn meshes(scene: &Scene, occluders: &[&str]) -> Result<Vec<Way>, Box<dyn Error>> {
    let corners = scene.surfaces[scene.surface_named("floor")?].shape.corners();
    let side = corners[0].distance(corners[1]);
    let (options, read) = (of_order(QUADRATIC), ReadMode::Basis);
    let cut = LENGTHS.map(|length| Way {
        label: "discontinuity mesh, order 2",
        text: if length.is_finite() { format!("≤ {length} of the floor") } else { "as cut".to_owned() },
        scene: meshed(scene, occluders, length * side),
        options,
        read,
    });
    let even = EVEN.map(|cells| Way {
        label: "even mesh, order 2",
        text: format!("{cells} × {cells}"),
        scene: scene.clone(),
        options: Options { subdivide: Some(cells), ..options },
        read,
    });
    Ok(cut.into_iter().chain(even).collect())
}

/// Masks of both averages.
fn masks(scene: &Scene) -> Result<Vec<Way>, Box<dyn Error>> {
    let mut ways = Vec::new();
    for (label, average) in [("masks of 1993", Average::Plain), ("weighted masks", Average::Weighted)] {
        for cells in CELLS {
            let masking = Masking { cells: NonZeroUsize::new(cells).ok_or("no cells")?, average };
            ways.push(Way {
                label,
                text: format!("{cells} × {cells} cells"),
                scene: with_orders(scene)?,
                options: Options { masks: Some(masking), direct: Direct::Auto, ..of_order(MASKED[1]) },
                read: ReadMode::Basis,
            });
        }
    }
    Ok(ways)
}

fn with_orders(scene: &Scene) -> Result<Scene, Box<dyn Error>> {
    let mut scene = scene.clone();
    for name in ["floor", "lamp"] {
        let surface = scene.surface_named(name)?;
        scene.surfaces[surface].order = Some(MASKED[0]);
    }
    Ok(scene)
}

impl Way {
    /// Solves, reads the floor, and judges that.
    pub(crate) fn run(&self, judge: &Judge) -> Result<Run, Box<dyn Error>> {
        let Self { label, text, scene, options, read } = self;
        let start = ProcessTime::now();
        let outcome = solve(scene, options, &Work::alone())?;
        let solving = start.elapsed();
        if outcome.choice.sampled || outcome.sampling.is_some() {
            return Err("rays carried pairs of elements".into());
        }
        let reading = ReadSettings { read: *read, ..Quality::Default.reading() };
        let visibility = options.visibility(scene);
        let (error, time) = judge.error(scene, &outcome.solution, &visibility, reading)?;
        let Options { order, space, layers, solver, subdivide, .. } = *options;
        let subdivide = Subdivide::Uniform(subdivide.unwrap_or(1));
        let how = Discretization { order, space, subdivide, layers };
        Ok(Run {
            label,
            text: text.clone(),
            elements: outcome.solution.elements().list().len(),
            unknowns: outcome.solution.elements().coefficients(),
            megabytes: MemoryEstimate::of(scene, &how, solver, Ranks::alone()).peak() as f64 / 1e6,
            error,
            seconds: (solving + time).as_secs_f64(),
        })
    }
}
