//! View factors between the surfaces of a scene.
//!
//! ```text
//! F_ij = 1/A_i ∫∫ κ(x, y) V(x, y) dA_x dA_y ,     A_i F_ij = A_j F_ji ,     Σ_j F_ij ≤ 1 ,
//! ```
//!
//! the share of the diffuse power leaving surface i that reaches surface j, without unit. F follows from G if
//! each element carries a constant, φ = 1/√A: with elements a of surface i and b of surface j,
//!
//! ```text
//! A_i F_ij = Σ_a Σ_b √(A_a A_b) G_ab .
//! ```
//!
//! In a closed scene each row sums to 1. Neither materials nor emitters matter.
//!
//! Error of the factors in a row: with e_b the errors that rules and rays know of the exchanges of its blocks, and
//! ε_b those asked of exchanges x_b by quadrature,
//!
//! ```text
//! own_i = max( √(Σ e_b²) / A_i ,  |1 − Σ_j F_ij| , 2⁻⁵² )  where |1 − Σ_j F_ij| ≤ 3 (√(Σ e_b²) + Σ ε_b x_b) / A_i ,
//! own_i = max( √(Σ e_b²) / A_i ,  0.1 Σ ε_b x_b / A_i , 2⁻⁵² )  elsewhere, as in open scenes ,
//! ```
//!
//! and rounding alone where closed forms carry a row. Rays may carry the pairs, where rules would take long (`plan`);
//! what they leave in a row is about the largest of its errors (`row_noise`), and adds to that of the rules.

mod options;
mod plan;
mod row_noise;
mod by_rays;

use std::time::{Duration, Instant};

use radiosity_elements::cells::Layers;
use radiosity_elements::space::Space;
use radiosity_elements::{Discretization, Elements, Subdivide};
use radiosity_kernel::{Blocks, PairCounts, PlacedBlock, RowError, WorstError};
use radiosity_scene::Scene;
use radiosity_solvers::method::Method;
use radiosity_transport as transport;
use radiosity_transport::{Demand, FactorEnds};
use radiosity_visibility::Visibility;
use radiosity_work::{Progress, Stage, Work};

use crate::driver::cost::{seconds_of_rays, seconds_of_samples};
use crate::driver::memory_estimate::MemoryEstimate;
use crate::driver::{Failure, MemoryReduction, TransportChoice, in_threads};
use by_rays::{Carried, FactorRays};
pub use options::Options;
use plan::Plan;
use row_noise::RowNoise;

/// Errors that are known or asked by which the row sum of a closed scene may miss 1. Chosen: as rows that are told
/// to be closed.
const EXPLAINED: f64 = 3.0;

/// Part of what is asked that rules miss. Measured: at 1e-3 less on most of 45 closed forms, a
/// third on a paraboloid.
const REACHED: f64 = 0.1;

/// The view factors of a scene. Only pairs that see each other take memory.
#[derive(Debug)]
pub struct ViewFactors {
    /// Names of the surfaces.
    pub names: Vec<String>,
    /// Areas of the surfaces (scene length²).
    pub areas: Vec<f64>,
    /// The pairs (j, A_i F_ij) of each surface i (length²), ascending in j; each exchange is stored for i and
    /// for j.
    exchanges: Vec<Vec<(u32, f64)>>,
    /// The method's own estimate of the largest error of a factor in the row of each surface.
    pub errors: Vec<f64>,
    /// The carrier of the pairs, and why.
    pub choice: TransportChoice,
    /// Pairs of elements that rules carried where rays carried the others.
    pub exact_pairs: usize,
    /// Numbers of pairs by how they were treated.
    pub pairs: PairCounts,
    /// Evaluations of the kernel, or of logarithms in contour integrals.
    pub samples: u64,
    /// Segments tested for visibility, or rays that carried pairs.
    pub rays: u64,
    /// Largest error that is left in the exchange of two elements, relative to the scale of its block
    /// ([`radiosity_kernel::BlockStatistics::accuracy_reached`]).
    pub left_in_blocks: f64,
    /// The two surfaces whose error is the largest multiple of what was asked.
    pub worst_error: Option<WorstError>,
    /// Wall time of the computation.
    pub elapsed: Duration,
}

/// Rows of view factors in which rays leave a larger error than was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MissedRows {
    /// Number of these rows.
    pub count: usize,
    /// The surface whose row is the worst.
    pub surface: usize,
    /// The error there, over the largest factor.
    pub error: f64,
}

impl ViewFactors {
    /// Computes the factors of all pairs of surfaces.
    ///
    /// # Errors
    /// A surface without area, or threads that cannot be started.
    pub fn new(scene: &Scene, options: &Options, work: &Work<'_>) -> Result<Self, Failure> {
        Self::of_pairs(scene, &|_, _| true, options, work)
    }

    /// Computes the factors of the pairs of surfaces that are `wanted` in either order; all others are zero.
    ///
    /// # Errors
    /// As for [`ViewFactors::new`].
    pub fn of_pairs(
        scene: &Scene,
        wanted: &(dyn Fn(usize, usize) -> bool + Sync),
        options: &Options,
        work: &Work<'_>,
    ) -> Result<Self, Failure> {
        let start = Instant::now();
        let found =
            in_threads(work.ranks.threads(options.threads), || constants(scene, wanted, options, work))??;
        let Constants { elements, blocks, choice, noise, exact_pairs } = found;
        let areas = areas(scene, &elements);
        let is_wanted = |i: usize, j: usize| wanted(i, j) || wanted(j, i);
        let add_up = || exchanges(&elements, &blocks, areas.len(), &is_wanted);
        let exchanges = work.during(Stage::Blocks, add_up);
        let is_whole = |i: usize| (0..areas.len()).all(|j| is_wanted(i, j));
        let known = row_errors(&elements, &blocks, areas.len());
        let by_rays = noise.as_ref().map(|noise| noise.errors(&areas));
        let error = |i: usize| match &by_rays {
            Some(errors) => own_error(known[i], areas[i], None).hypot(errors[i]),
            None => {
                let is_told = known[i] != RowError::default() && is_whole(i);
                own_error(known[i], areas[i], is_told.then(|| sum(&exchanges[i])))
            }
        };
        let errors = (0..areas.len()).map(error).collect();
        Ok(Self {
            names: scene.surfaces.iter().map(|surface| surface.name.clone()).collect(),
            errors,
            exchanges,
            areas,
            choice,
            exact_pairs,
            pairs: blocks.statistics.pairs,
            samples: blocks.statistics.distinct,
            rays: blocks.statistics.rays,
            left_in_blocks: blocks.statistics.accuracy_reached,
            worst_error: blocks.statistics.worst_error.map(|worst| WorstError {
                pair: worst.pair.map(|element| elements.list()[element].surface),
                ..worst
            }),
            elapsed: start.elapsed(),
        })
    }

    /// F_ij, the share of the power leaving surface i that reaches surface j.
    pub fn factor(&self, i: usize, j: usize) -> f64 {
        let row = &self.exchanges[i];
        row.binary_search_by_key(&j, |(column, _)| *column as usize)
            .map_or(0.0, |place| row[place].1 / self.areas[i])
    }

    /// All factors from surface i, zeros included.
    pub fn row(&self, i: usize) -> Vec<f64> {
        let mut row = vec![0.0; self.names.len()];
        self.exchanges[i].iter().for_each(|(j, exchange)| row[*j as usize] = exchange / self.areas[i]);
        row
    }

    /// The factors from surface i that are not zero, as (j, F_ij), ascending in j.
    pub fn nonzeros(&self, i: usize) -> impl Iterator<Item = (usize, f64)> {
        let own = self.exchanges[i].iter().filter(|(_, exchange)| *exchange != 0.0);
        own.map(move |(j, exchange)| (*j as usize, exchange / self.areas[i]))
    }

    /// Σ_j F_ij of each surface: 1 if no power that leaves it is lost.
    pub fn row_sums(&self) -> Vec<f64> {
        self.exchanges.iter().zip(&self.areas).map(|(row, area)| sum(row) / area).collect()
    }

    /// The error of each row relative to its largest factor, ascending; of rows without one nothing.
    pub fn relative_errors(&self) -> Vec<f64> {
        let mut errors: Vec<f64> = (0..self.errors.len()).filter_map(|i| self.relative_error(i)).collect();
        errors.sort_by(f64::total_cmp);
        errors
    }

    /// The error of a row relative to its largest factor; None of a row without one.
    fn relative_error(&self, i: usize) -> Option<f64> {
        let exchanges = self.exchanges[i].iter().map(|(_, exchange)| *exchange);
        let largest = exchanges.fold(0.0, f64::max) / self.areas[i];
        (largest > 0.0).then(|| self.errors[i] / largest)
    }

    /// The rows in which rays leave a larger error than `eps` of the largest factor; None where they leave none.
    pub fn missed_by_rays(&self, eps: f64) -> Option<MissedRows> {
        if !self.choice.sampled {
            return None;
        }
        let rows = (0..self.errors.len()).filter_map(|i| Some((i, self.relative_error(i)?)));
        let missed: Vec<(usize, f64)> = rows.filter(|(_, error)| *error > eps).collect();
        let (surface, error) = missed.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1))?;
        Some(MissedRows { count: missed.len(), surface, error })
    }

    /// Time that such work takes (s), by its counts.
    pub fn forecast(&self) -> f64 {
        seconds_of_samples(self.samples as f64) + seconds_of_rays(self.rays as f64)
    }

    /// Whether closed forms carry all pairs, and nothing hides a part of one.
    pub fn are_exact(&self) -> bool {
        !self.choice.sampled
            && self.rays == 0
            && self.pairs.partly_hidden == 0
            && self.pairs.contour == self.pairs.integrated()
    }
}

/// Σ_j A_i F_ij of a row (length²).
fn sum(row: &[(u32, f64)]) -> f64 {
    row.iter().map(|(_, exchange)| exchange).sum()
}

/// The errors of the exchanges of each surface.
fn row_errors(elements: &Elements, blocks: &Blocks, surfaces: usize) -> Vec<RowError> {
    let mut rows = vec![RowError::default(); surfaces];
    for (element, error) in elements.list().iter().zip(&blocks.statistics.row_errors) {
        let row = &mut rows[element.surface];
        (row.squares, row.asked) = (row.squares + error.squares, row.asked + error.asked);
    }
    rows
}

/// The own estimate of the error of the factors of a surface of this area; `sum` is that of its exchanges where all of
/// them are known and not all are exact.
fn own_error(error: RowError, area: f64, sum: Option<f64>) -> f64 {
    let (known, asked) = (error.squares.sqrt() / area, error.asked / area);
    let open = sum.map(|sum| (1.0 - sum / area).abs());
    let missed = open.filter(|open| *open <= EXPLAINED * (known + asked)).unwrap_or(REACHED * asked);
    known.max(missed).max(f64::EPSILON)
}

/// Elements that carry constants, their blocks, and what is known of these.
struct Constants {
    elements: Elements,
    blocks: Blocks,
    choice: TransportChoice,
    /// The errors that rays leave, where they carry the pairs.
    noise: Option<RowNoise>,
    exact_pairs: usize,
}

fn constants(
    scene: &Scene,
    wanted: &(dyn Fn(usize, usize) -> bool + Sync),
    options: &Options,
    work: &Work<'_>,
) -> Result<Constants, Failure> {
    let mut scene = scene.clone();
    scene.surfaces.iter_mut().for_each(|surface| surface.order = None);
    let accuracy = options.block_accuracy();
    let wanted = |i: usize, j: usize| wanted(i, j) || wanted(j, i);
    let decide = || {
        let visibility = Visibility::new(&scene, options.shadows, accuracy.shadow_eps);
        let auto = || Subdivide::Auto { occluded: visibility.any_shadow(), near_layers: false };
        let how = constant_on(options.subdivide.map_or_else(auto, Subdivide::Uniform));
        let plan = Plan::of(&scene, &how, &wanted, options, &visibility);
        (visibility, how, plan)
    };
    let (visibility, how, Plan { choice, rays, seconds }) = work.during(Stage::Visibility, decide);
    work.ranks.note_choice(&choice.sampled);
    work.report(Progress::Expected { stage: Stage::Blocks, seconds });
    if choice.sampled {
        // Rays find shadows wherever they are.
        scene.surfaces.iter_mut().for_each(|surface| surface.subdivide = None);
        let cut = || Elements::new(&scene, &constant_on(Subdivide::Uniform(1)));
        let elements = work.during(Stage::Elements, cut)?;
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
        return Ok(Constants { elements, blocks, choice, noise: Some(noise), exact_pairs });
    }
    if options.subdivide.is_none() {
        work.during(Stage::Visibility, || keep_whole(&mut scene, &visibility));
    }
    require_memory(&scene, &how, options, work)?;
    let elements = work.during(Stage::Elements, || Elements::new(&scene, &how))?;
    let surface = |element: usize| elements.list()[element].surface;
    let wanted = |a, b| wanted(surface(a), surface(b));
    let demand = Demand { whole: FactorEnds::Surface, ..Demand::all(&elements, &visibility, accuracy) };
    let blocks = work.during(Stage::Blocks, || transport::assemble(demand.of(&wanted), None, work));
    Ok(Constants { elements, blocks, choice, noise: None, exact_pairs: 0 })
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

fn areas(scene: &Scene, elements: &Elements) -> Vec<f64> {
    let area = |surface| elements.of_surface(surface).map(|element| elements.list()[element].area).sum();
    (0..scene.surfaces.len()).map(area).collect()
}

/// A_i F_ij of all pairs that are wanted and exchange anything.
fn exchanges(
    elements: &Elements,
    blocks: &Blocks,
    surfaces: usize,
    is_wanted: &dyn Fn(usize, usize) -> bool,
) -> Vec<Vec<(u32, f64)>> {
    let list = elements.list();
    let mut rows: Vec<Vec<(u32, f64)>> = vec![Vec::new(); surfaces];
    for PlacedBlock { row: a, column: b, values } in blocks.gathered().iter() {
        let exchange = values[0] * (list[a].area * list[b].area).sqrt();
        let (i, j) = (list[a].surface, list[b].surface);
        if !is_wanted(i, j) {
            continue;
        }
        rows[i].push((j as u32, exchange));
        // Two different elements of one surface exchange in both directions.
        if a != b {
            rows[j].push((i as u32, exchange));
        }
    }
    for row in &mut rows {
        row.sort_by_key(|(column, _)| *column);
        row.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            kept.1 += if same { next.1 } else { 0.0 };
            same
        });
        row.shrink_to_fit();
    }
    rows
}

#[cfg(test)]
mod tests {
    use radiosity_kernel::Accuracy;

    use super::*;
    use crate::driver::Transport;

    fn factors(scene: &Scene, subdivide: usize) -> ViewFactors {
        let accuracy = Accuracy { eps: 1e-6, shadow_eps: 1e-2 };
        let options = Options { subdivide: Some(subdivide), accuracy, threads: 2, ..Options::default() };
        ViewFactors::new(scene, &options, &Work::alone()).expect("all have area")
    }

    #[test]
    fn cut_walls_of_a_box_see_what_whole_walls_see() {
        let scene = radiosity_language::builtin("empty-box").expect("it is built in");
        let (whole, cut) = (factors(&scene, 1), factors(&scene, 3));
        for i in 0..6 {
            assert!((cut.areas[i] - 1.0).abs() < 1e-14);
            assert!((whole.row_sums()[i] - 1.0).abs() < 1e-13 && (cut.row_sums()[i] - 1.0).abs() < 1e-13);
            for j in 0..6 {
                assert!((whole.factor(i, j) - cut.factor(i, j)).abs() < 1e-14, "{i} {j}");
            }
        }
    }

    #[test]
    fn only_the_pairs_wanted_are_integrated() {
        let scene = radiosity_language::builtin("empty-box").expect("it is built in");
        let accuracy = Accuracy { eps: 1e-3, shadow_eps: 1e-2 };
        let options = Options { subdivide: Some(1), accuracy, threads: 1, ..Options::default() };
        let wanted = |i, j| (i, j) == (4, 1);
        let some = ViewFactors::of_pairs(&scene, &wanted, &options, &Work::alone()).expect("all have area");
        let all = ViewFactors::new(&scene, &options, &Work::alone()).expect("all have area");
        assert_eq!([some.factor(4, 1), some.factor(1, 4)], [all.factor(4, 1), all.factor(1, 4)]);
        assert_eq!(some.row(0), vec![0.0; 6]);
    }

    /// Rooms whose walls things hide in part, and one where nothing does.
    const ROOMS: [&str; 5] = ["empty-box", "oven", "occluder-box", "two-boxes", "cornell-box"];

    fn by(transport: Transport, rays: Option<u64>, scene: &Scene) -> ViewFactors {
        let accuracy = Accuracy { eps: 1e-4, shadow_eps: 1e-4 };
        let options = Options { accuracy, transport, rays, threads: 2, ..Options::default() };
        ViewFactors::new(scene, &options, &Work::alone()).expect("all have area")
    }

    /// The error of each row of a scene by so many rays, as rules find it and as it is told.
    fn found_and_told(exact: &ViewFactors, sampled: &ViewFactors) -> Vec<[f64; 2]> {
        let difference = |i: usize| {
            let pairs = exact.row(i).into_iter().zip(sampled.row(i));
            pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        (0..exact.names.len()).map(|i| [difference(i), sampled.errors[i]]).collect()
    }

    #[test]
    fn rays_err_by_what_they_tell() {
        let mut rows = Vec::new();
        for name in ROOMS {
            let scene = radiosity_language::builtin(name).expect("it is built in");
            let exact = by(Transport::Exact, None, &scene);
            for rays in [20_000, 50_000, 120_000] {
                let sampled = by(Transport::Sampled, Some(rays), &scene);
                assert!(sampled.choice.sampled && sampled.rays >= rays);
                rows.extend(found_and_told(&exact, &sampled));
            }
        }
        let within = |[found, told]: &&[f64; 2]| found <= &(3.0 * told);
        let share = rows.iter().filter(within).count() as f64 / rows.len() as f64;
        let sum = |of: usize| rows.iter().map(|row| row[of].powi(2)).sum::<f64>();
        let ratio = (sum(0) / sum(1)).sqrt();
        assert!(share >= 0.95 && (0.5..1.1).contains(&ratio), "{share} of rows, {ratio}: {rows:?}");
    }

    #[test]
    fn factors_by_rays_are_symmetric_and_close() {
        let scene = radiosity_language::builtin("empty-box").expect("it is built in");
        let sampled = by(Transport::Sampled, Some(50_000), &scene);
        for i in 0..6 {
            assert!((sampled.row_sums()[i] - 1.0).abs() < 1e-5, "{}", sampled.row_sums()[i]);
            for j in 0..6 {
                let [one, other] = [(i, j), (j, i)].map(|(i, j)| sampled.areas[i] * sampled.factor(i, j));
                assert!((one - other).abs() <= 4.0 * f64::EPSILON * one, "{i} {j}");
            }
        }
    }

    #[test]
    fn rules_stay_where_they_end_soon() {
        for name in ROOMS {
            let scene = radiosity_language::builtin(name).expect("it is built in");
            assert!(!by(Transport::Auto, None, &scene).choice.sampled, "{name}");
        }
        let scene = radiosity_language::builtin("empty-box").expect("it is built in");
        assert!(by(Transport::Auto, Some(20_000), &scene).choice.sampled);
    }

    #[test]
    fn too_little_memory_refuses_rules_and_given_rays() {
        let scene = radiosity_language::builtin("cornell-box").expect("it is built in");
        for (transport, rays) in [(Transport::Exact, None), (Transport::Sampled, Some(50_000))] {
            let options = Options { transport, rays, memory: Some(1_000), ..Options::default() };
            let refused = ViewFactors::new(&scene, &options, &Work::alone());
            assert!(matches!(refused, Err(Failure::Memory { needed, allowed, .. }) if needed > allowed));
        }
    }

    #[test]
    fn numbers_of_rays_that_are_told_to_fit_do() {
        let scene = radiosity_language::builtin("cornell-box").expect("it is built in");
        let by = |rays: u64, bytes: u64| {
            let (transport, rays) = (Transport::Sampled, Some(rays));
            let options = Options { transport, rays, memory: Some(bytes), threads: 2, ..Options::default() };
            ViewFactors::new(&scene, &options, &Work::alone())
        };
        let mut offered = 0;
        for bytes in (6_000..20_000).step_by(1_000) {
            let Err(Failure::Memory { fits, .. }) = by(1_000_000, bytes) else { continue };
            let Some(MemoryReduction::Rays(rays)) = fits.first() else { continue };
            assert!(by(*rays, bytes).is_ok(), "{rays} rays in {bytes} bytes");
            offered += 1;
        }
        assert!(offered > 2, "{offered}");
    }

    #[test]
    fn rows_that_rays_miss_are_named_and_those_of_rules_are_not() {
        let scene = radiosity_language::builtin("oven").expect("it is built in");
        let sampled = by(Transport::Sampled, Some(20_000), &scene);
        let largest = sampled.relative_errors()[6];
        let MissedRows { count, surface, error } = sampled.missed_by_rays(1e-4).expect("they are few");
        assert_eq!((count, error), (7, largest));
        let row = sampled.row(surface).into_iter().fold(0.0, f64::max);
        assert!((sampled.errors[surface] / row - largest).abs() < 1e-12);
        assert_eq!(sampled.missed_by_rays(largest), None);
        assert_eq!(by(Transport::Exact, None, &scene).missed_by_rays(1e-12), None);
    }

    /// Few rays: halves that agree, or that meet nothing, know less than they seem to.
    #[test]
    fn few_rays_tell_what_they_may_miss() {
        let hinge = radiosity_language::builtin("hinge-squares").expect("it is built in");
        // Two unit squares with a common edge at a right angle: closed form C-14 of Howell's catalogue.
        let right = 0.200_043_776_075_403;
        for rays in [1, 2, 4, 8, 16, 64, 256, 4096] {
            let found = by(Transport::Sampled, Some(rays), &hinge);
            let off = (found.factor(0, 1) - right).abs();
            assert!(off <= 3.0 * found.errors[0], "{rays}: {off} {}", found.errors[0]);
        }
    }
}
