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
//!                                                          where Σ_j F_ij > 1, or surfaces are known to enclose i ,
//! own_i = max( √(Σ e_b²) / A_i ,  0.1 Σ ε_b x_b / A_i , 2⁻⁵² )  elsewhere, as in open scenes ,
//! ```
//!
//! and rounding alone where closed forms carry a row. Rays may carry the pairs, where rules would take long (`plan`);
//! what they leave in a row is about the largest of its errors (`row_noise`), and adds to that of the rules. Of many
//! small flat surfaces each pair has rays of its own, which tell what is hidden of it (`facet_errors`).

mod options;
mod plan;
mod row_noise;
mod by_rays;
mod exchanges;
mod facet_errors;
mod constants;

use std::cell::LazyCell;
use std::time::{Duration, Instant};

use radiosity_elements::Elements;
use radiosity_kernel::{Blocks, PairCounts, RowError, WorstError};
use radiosity_scene::Scene;
use radiosity_transport::FacetExchanges;
use radiosity_visibility::Shadows;
use radiosity_visibility::inspection::Regions;
use radiosity_work::{Stage, Work};

use crate::driver::cost::{seconds_of_rays, seconds_of_samples};
use crate::driver::{Failure, TransportChoice, in_threads};
use constants::{Constants, Found};
use exchanges::Exchanges;
use facet_errors::FacetErrors;
pub use options::Options;
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
    /// A_i F_ij (length²).
    exchanges: Exchanges,
    /// The method's own estimate of the largest error of a factor in the row of each surface.
    pub errors: Vec<f64>,
    /// The carrier of the pairs, and why.
    pub choice: TransportChoice,
    /// Whether each pair had rays of its own.
    pub has_rays_of_pairs: bool,
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
        let threads = work.ranks.threads(options.threads);
        let found = in_threads(threads, || Constants::of(scene, wanted, options, work))??;
        let areas = areas(scene, &found.elements);
        let names = scene.surfaces.iter().map(|surface| surface.name.clone()).collect();
        let is_wanted = |i: usize, j: usize| wanted(i, j) || wanted(j, i);
        let regions = LazyCell::new(|| in_threads(threads, || Regions::of(scene)).ok().flatten());
        let is_closed = |surface: usize| regions.as_ref().is_some_and(|regions| regions.is_closed(surface));
        // Light that passes through surfaces reaches more than one.
        let is_hidden = options.shadows != Shadows::Off;
        let is_wrong = |surface: usize, sum: f64| is_hidden && (sum > 1.0 || is_closed(surface));
        let add_up = || factors(found, areas, names, &is_wanted, &is_wrong);
        let factors = work.during(Stage::Blocks, add_up);
        Ok(Self { elapsed: start.elapsed(), ..factors })
    }

    /// F_ij, the share of the power leaving surface i that reaches surface j.
    pub fn factor(&self, i: usize, j: usize) -> f64 {
        self.exchanges.of(i, j) / self.areas[i]
    }

    /// All factors from surface i, zeros included.
    pub fn row(&self, i: usize) -> Vec<f64> {
        let mut row = vec![0.0; self.names.len()];
        self.exchanges.row(i).for_each(|(j, exchange)| row[j] = exchange / self.areas[i]);
        row
    }

    /// The factors from surface i that are not zero, as (j, F_ij), ascending in j.
    pub fn nonzeros(&self, i: usize) -> impl Iterator<Item = (usize, f64)> {
        let own = self.exchanges.row(i).filter(|(_, exchange)| *exchange != 0.0);
        own.map(move |(j, exchange)| (j, exchange / self.areas[i]))
    }

    /// The rows of all surfaces as [`ViewFactors::row`], one after the other, which takes less than each by itself.
    pub fn rows(&self) -> impl Iterator<Item = Vec<f64>> + Clone {
        self.sparse_rows().map(|own| {
            let mut row = vec![0.0; self.names.len()];
            own.into_iter().for_each(|(j, factor)| row[j] = factor);
            row
        })
    }

    /// The rows of all surfaces as [`ViewFactors::nonzeros`], one after the other, which takes less than each by
    /// itself.
    pub fn sparse_rows(&self) -> impl Iterator<Item = Vec<(usize, f64)>> + Clone {
        self.exchanges.rows().zip(&self.areas).map(|(row, area)| {
            let own = row.into_iter().filter(|(_, exchange)| *exchange != 0.0);
            own.map(|(j, exchange)| (j, exchange / area)).collect()
        })
    }

    /// Σ_j F_ij of each surface: 1 if no power that leaves it is lost.
    pub fn row_sums(&self) -> Vec<f64> {
        self.exchanges.sums().iter().zip(&self.areas).map(|(sum, area)| sum / area).collect()
    }

    /// The error of each row relative to its largest factor, ascending; rows of which none exceeds its error left out.
    pub fn relative_errors(&self) -> Vec<f64> {
        let mut errors: Vec<f64> = self.errors_of_rows().into_iter().flatten().collect();
        errors.sort_by(f64::total_cmp);
        errors
    }

    /// The errors of rows of which no factor exceeds its error, and so may be zero.
    pub fn errors_of_unseen(&self) -> Vec<f64> {
        let rows = self.errors_of_rows().into_iter().zip(&self.errors);
        rows.filter(|(relative, error)| relative.is_none() && **error > 0.0)
            .map(|(_, error)| *error)
            .collect()
    }

    /// The error of each row relative to its largest factor; None where no factor exceeds its error.
    fn errors_of_rows(&self) -> Vec<Option<f64>> {
        let rows = self.exchanges.largest().into_iter().zip(&self.areas).zip(&self.errors);
        rows.map(|((largest, area), error)| (largest > error * area).then(|| error * area / largest))
            .collect()
    }

    /// The rows in which rays leave a larger error than `eps` of the largest factor; None where they leave none.
    pub fn missed_by_rays(&self, eps: f64) -> Option<MissedRows> {
        if !self.choice.sampled {
            return None;
        }
        let rows = self.errors_of_rows().into_iter().enumerate();
        let rows = rows.filter_map(|(i, error)| Some((i, error?)));
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
/// them are known and not all are exact, and `is_wrong` tells whether no right row has one.
fn own_error(error: RowError, area: f64, sum: Option<f64>, is_wrong: impl Fn(f64) -> bool) -> f64 {
    let (known, asked) = (error.squares.sqrt() / area, error.asked / area);
    let sum = sum.map(|sum| sum / area);
    let is_missed = |sum: &f64| (1.0 - sum).abs() <= EXPLAINED * (known + asked) || is_wrong(*sum);
    let missed = sum.filter(is_missed).map_or(REACHED * asked, |sum| (1.0 - sum).abs());
    known.max(missed).max(f64::EPSILON)
}

/// The factors between surfaces of these areas and names by their elements, of the pairs that are wanted; `is_wrong`
/// tells whether the row of a surface cannot have a sum.
fn factors(
    constants: Constants,
    areas: Vec<f64>,
    names: Vec<String>,
    is_wanted: &dyn Fn(usize, usize) -> bool,
    is_wrong: &dyn Fn(usize, f64) -> bool,
) -> ViewFactors {
    let Constants { elements, choice, found } = constants;
    match found {
        Found::Facets(found) => of_facets(found, choice, areas, names),
        Found::Blocks { blocks, noise, exact_pairs } => {
            let exchanges = Exchanges::of_blocks(&elements, &blocks, areas.len(), is_wanted);
            let errors = errors(&elements, &blocks, noise.as_ref(), &areas, &exchanges, is_wanted, is_wrong);
            ViewFactors {
                names,
                errors,
                exchanges,
                areas,
                choice,
                has_rays_of_pairs: false,
                exact_pairs,
                pairs: blocks.statistics.pairs,
                samples: blocks.statistics.distinct,
                rays: blocks.statistics.rays,
                left_in_blocks: blocks.statistics.accuracy_reached,
                worst_error: blocks.statistics.worst_error.map(|worst| WorstError {
                    pair: worst.pair.map(|element| elements.list()[element].surface),
                    ..worst
                }),
                elapsed: Duration::ZERO,
            }
        }
    }
}

/// The factors between many small flat surfaces.
fn of_facets(
    found: FacetExchanges,
    choice: TransportChoice,
    areas: Vec<f64>,
    names: Vec<String>,
) -> ViewFactors {
    let known = FacetErrors::of(&found, &areas);
    let FacetExchanges { rows, pairs, samples, segments, exact, .. } = found;
    let exchanges = Exchanges::of_facets(rows);
    ViewFactors {
        names,
        errors: known.largest(&areas, &exchanges.largest()),
        exchanges,
        choice,
        has_rays_of_pairs: true,
        exact_pairs: exact,
        pairs,
        samples,
        rays: segments,
        left_in_blocks: known.of_sums(&areas),
        worst_error: None,
        areas,
        elapsed: Duration::ZERO,
    }
}

/// The errors of the rows of factors by blocks.
fn errors(
    elements: &Elements,
    blocks: &Blocks,
    noise: Option<&RowNoise>,
    areas: &[f64],
    exchanges: &Exchanges,
    is_wanted: &dyn Fn(usize, usize) -> bool,
    is_wrong: &dyn Fn(usize, f64) -> bool,
) -> Vec<f64> {
    let is_whole = |i: usize| (0..areas.len()).all(|j| is_wanted(i, j));
    let known = row_errors(elements, blocks, areas.len());
    let by_rays = noise.map(|noise| noise.errors(areas));
    let sums = exchanges.sums();
    let error = |i: usize| match &by_rays {
        Some(errors) => own_error(known[i], areas[i], None, |_| false).hypot(errors[i]),
        None => {
            let is_told = known[i] != RowError::default() && is_whole(i);
            own_error(known[i], areas[i], is_told.then(|| sums[i]), |sum| is_wrong(i, sum))
        }
    };
    (0..areas.len()).map(error).collect()
}

fn areas(scene: &Scene, elements: &Elements) -> Vec<f64> {
    let area = |surface| elements.of_surface(surface).map(|element| elements.list()[element].area).sum();
    (0..scene.surfaces.len()).map(area).collect()
}

#[cfg(test)]
mod tests {
    use radiosity_kernel::Accuracy;

    use super::*;
    use crate::driver::{MemoryReduction, Transport};

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

    /// The faces of a box, fronts out, or in where it is `flipped`, each cut into so many tiles along either side.
    fn tiles(origin: f64, size: f64, cuts: usize, flipped: bool) -> String {
        let at = |axis: usize, place: [f64; 3]| -> String {
            let mut point = [0.0; 3];
            (0..3).for_each(|k| point[(axis + k) % 3] = place[k]);
            format!("{point:?}")
        };
        let step = size / cuts as f64;
        let mut text = String::new();
        for (axis, is_far, i, j) in
            (0..6 * cuts * cuts).map(|k| (k % 3, k / 3 % 2 == 1, k / 6 % cuts, k / 6 / cuts))
        {
            let height = origin + if is_far { size } else { 0.0 };
            let corner = at(axis, [height, origin + i as f64 * step, origin + j as f64 * step]);
            let (first, second) = (at(axis, [0.0, step, 0.0]), at(axis, [0.0, 0.0, step]));
            text += &format!(
                "[[surfaces]]\nflip = {}\nparallelogram = {{ origin = {corner}, edge1 = {first}, edge2 = {second} }}\n",
                is_far == flipped
            );
        }
        text
    }

    /// A room with a box in it, all cut into tiles.
    fn tiled_room() -> Scene {
        let text = tiles(0.0, 1.0, 7, true) + &tiles(0.35, 0.3, 2, false);
        radiosity_language::read(&radiosity_scene::Source::new("tiles", &text)).expect("a room")
    }

    #[test]
    fn segments_err_by_what_they_tell() {
        let scene = tiled_room();
        let exact = by(Transport::Exact, None, &scene);
        let options = Options { transport: Transport::Sampled, threads: 2, ..Options::default() };
        let sampled = ViewFactors::new(&scene, &options, &Work::alone()).expect("all have area");
        assert!(sampled.pairs.partly_hidden > 1000, "{:?}", sampled.pairs);
        let rows = found_and_told(&exact, &sampled);
        let within = rows.iter().filter(|[found, told]| *found <= 3.0 * told).count() as f64;
        let sum = |of: usize| rows.iter().map(|row| row[of].powi(2)).sum::<f64>();
        let (share, ratio) = (within / rows.len() as f64, (sum(0) / sum(1)).sqrt());
        // Most is told of pairs whose segments agree, of which few are wrong here.
        assert!(share >= 0.95 && (0.1..1.1).contains(&ratio), "{share} of rows, {ratio}");
        let errors = sampled.relative_errors();
        assert!(errors[errors.len() / 2] < 0.03, "{}", errors[errors.len() / 2]);
        assert!(sampled.row_sums().iter().all(|sum| (sum - 1.0).abs() < 0.01));
        for (i, j) in [(0, 1), (5, 200), (17, 300)] {
            let [one, other] = [(i, j), (j, i)].map(|(i, j)| sampled.areas[i] * sampled.factor(i, j));
            assert!((one - other).abs() <= 4.0 * f64::EPSILON * one, "{i} {j}");
            assert_eq!(sampled.row(i)[j], sampled.factor(i, j));
        }
    }

    /// A plate, in the language of scenes.
    fn plate(origin: [f64; 3], edge1: [f64; 3], edge2: [f64; 3], flip: bool) -> String {
        format!(
            "[[surfaces]]\nflip = {flip}\nparallelogram = {{ origin = {origin:?}, edge1 = {edge1:?}, edge2 = {edge2:?} }}\n"
        )
    }

    /// Asserts that the factors between the first two of three plates, in many places far from each other, err by what
    /// is told of them.
    fn copies_err_by_what_they_tell(three: &dyn Fn(f64) -> String, exact: f64) {
        let text: String = (0..100).map(|copy| three(100.0 * f64::from(copy))).collect();
        let scene = radiosity_language::read(&radiosity_scene::Source::new("copies", &text)).expect("plates");
        let options = Options { transport: Transport::Sampled, threads: 2, ..Options::default() };
        let found = ViewFactors::new(&scene, &options, &Work::alone()).expect("all have area");
        for first in (0..300).step_by(3) {
            let (factor, told) = (found.factor(first, first + 1), found.errors[first]);
            assert!((factor - exact).abs() <= 3.0 * told, "{first}: {factor} +- {told}, not {exact}");
        }
    }

    /// A strip of a fiftieth of two squares between them, beside the first segments of many of them.
    #[test]
    fn strips_beside_the_first_segments_are_found() {
        let (along, across) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
        let three = |x: f64| {
            plate([x, 0.0, 0.0], along, across, false)
                + &plate([x, 0.0, 1.0], along, across, true)
                + &plate([x + 0.5, 0.01, 0.5], [0.02, 0.0, 0.0], [0.0, 0.98, 0.0], false)
        };
        let scene =
            radiosity_language::read(&radiosity_scene::Source::new("three", &three(0.0))).expect("plates");
        copies_err_by_what_they_tell(&three, by(Transport::Exact, None, &scene).factor(0, 1));
    }

    /// A wall rises above a floor by a fiftieth of its height, and a fence hides that: most segments start behind.
    #[test]
    fn segments_that_carry_nothing_tell_nothing() {
        let three = |x: f64| {
            plate([x, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], false)
                + &plate([x + 1.1, -1.0, -1.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.02], true)
                + &plate([x + 1.05, -3.0, -0.5], [0.0, 7.0, 0.0], [0.0, 0.0, 0.6], false)
        };
        copies_err_by_what_they_tell(&three, 0.0);
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
