//! Visibility between two patches by quasi-Monte Carlo sampling.
//!
//! ```text
//! S_kl = ∫∫ φ_k(x) φ_l(y) κ(x, y) [V(x, y) = v] dA_x dA_y ≈ 1/n Σ_m f(z_m)
//! ```
//!
//! where v = 1 sums what is seen and v = 0 what is hidden: whichever is rarer; the other follows from a
//! smooth rule over all. The integrand jumps at the edges of shadows, where a tensor rule makes errors of one
//! sign wherever an edge runs along its grid. The points z_m of a Kronecker sequence
//! ([`radiosity_elements::sampling::kronecker`]) lie on no grid.
//!
//! The sequence is cut into [`BATCHES`] equal batches, each nearly equidistributed. The error is estimated as
//! half the standard deviation of the mean of their sums, as if these were independent: consecutive batches
//! balance each other's errors. Batches with few points of the kind that is summed may agree by chance, so
//! that the error is at least the contribution of one such point, or of three if none was met.

use radiosity_elements::basis::AreaBasis;
use radiosity_elements::patch::{Node, Patch};
use radiosity_kernel::moments::Moments;
use radiosity_kernel::moments::node_pair::node_pair;
use radiosity_kernel::{kernel, moments::integrand::Sees};
use radiosity_work::interruption::check_interrupt_at;

use crate::tolerances::{BATCHES, DEVIATIONS, RULE_OF_THREE};

/// Points that decide which kind is rarer. If they decide wrongly, more points are needed for the same error,
/// which is told all the same.
const PILOT: usize = 32;
/// Fewest points in a batch: smaller ones agree by chance.
const FEWEST: usize = 16;
/// Most points in a batch, 131 072 in all: a bound of time. What is left of the error is told.
const MOST: usize = 1 << 14;
/// Points that cost about as much as a rule over all where a horizon cuts the patches: an estimate of time.
/// Up to so many what is seen is summed without that rule.
const DEAR: f64 = 3e3;
/// Counting error of the points that are summed, if any was met: one point. If none was, it is
/// [`RULE_OF_THREE`].
const OFF: f64 = 1.0;

/// The points that are summed: those that see each other, or those hidden from each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SummedPoints {
    /// The seen or the hidden points, whichever are rarer: if a rule over all is cheap.
    Rarer,
    /// The seen points, unless that needs many, else whichever are rarer: if a rule over all is expensive.
    Seen,
}

/// The sampled integral of what is seen, or of what is hidden.
#[derive(Debug)]
pub(crate) struct SampledVisibility {
    /// In raw polynomials, row-major, receiver's functions by emitter's.
    pub values: Vec<f64>,
    /// Whether `values` are of what is hidden.
    pub hidden: bool,
    /// Estimated error of `values` (a standard deviation, see the module's header) where it exceeds the
    /// limit; else zero.
    pub error: f64,
    pub samples: u64,
    pub rays: u64,
}

impl SampledVisibility {
    /// The sampled integral between `patches`, each with the basis of its element, with an estimated error up
    /// to `limit` if [`MOST`] points reach that.
    pub(crate) fn new(
        patches: [&Patch; 2],
        bases: [&AreaBasis; 2],
        sees: Sees,
        limit: f64,
        summed: SummedPoints,
    ) -> Self {
        let constants = bases.map(AreaBasis::constant).iter().product();
        let mut work = PairSampler {
            patches,
            bases,
            constants,
            sees,
            rays: 0,
            hidden: false,
            count: PointCounts::default(),
        };
        let of_seen = (summed == SummedPoints::Seen).then(|| work.sum(limit, DEAR));
        // If no points face each other, they decide nothing.
        let enough = of_seen.filter(|(_, error)| *error <= limit && work.count.facing > 0);
        let (values, error) = enough.unwrap_or_else(|| work.rarer(limit));
        let error = if error <= limit { 0.0 } else { error };
        let PairSampler { hidden, count: PointCounts { samples, .. }, rays, .. } = work;
        Self { values, hidden, error, samples, rays }
    }

    /// Adds what is seen to the moments of the pair, or subtracts what is hidden.
    pub(crate) fn add_to(&self, moments: &mut Moments) {
        let sign = if self.hidden { -1.0 } else { 1.0 };
        let values: Vec<f64> = self.values.iter().map(|value| sign * value).collect();
        moments.add_raw(&values, self.samples);
        moments.rays += self.rays;
    }
}

struct PairSampler<'a> {
    patches: [&'a Patch; 2],
    bases: [&'a AreaBasis; 2],
    /// Product of the constants of both bases.
    constants: f64,
    sees: Sees<'a>,
    /// Segments tested, over all sums.
    rays: u64,
    /// Whether what is hidden is summed.
    hidden: bool,
    count: PointCounts,
}

/// The points of a sum.
#[derive(Clone, Copy, Debug, Default)]
struct PointCounts {
    samples: u64,
    /// Samples whose two points face each other, and those that see each other.
    facing: u64,
    seen: u64,
    /// Sum of the kernel times both areas.
    weight: f64,
}

impl PairSampler<'_> {
    /// The integral of what is rarer, and its estimated error.
    fn rarer(&mut self, limit: f64) -> (Vec<f64>, f64) {
        if self.count.samples == 0 {
            self.batch(PILOT);
        }
        let PointCounts { facing, seen, .. } = std::mem::take(&mut self.count);
        self.hidden = 2 * seen >= facing;
        self.sum(limit, f64::INFINITY)
    }

    /// The integral and its estimated error. The latter exceeds `limit` if [`MOST`] points do not suffice, or
    /// as soon as more than `most` points are predicted to be needed.
    fn sum(&mut self, limit: f64, most: f64) -> (Vec<f64>, f64) {
        let mut points = FEWEST;
        let mut batches: Vec<Vec<f64>> = (0..BATCHES).map(|_| self.batch(points)).collect();
        loop {
            let error = (DEVIATIONS * deviation(&batches)).max(self.least_error());
            // The error falls about like 1/n.
            let is_hopeless = points >= MOST || self.count.samples as f64 * error > most * limit;
            if error <= limit || is_hopeless {
                return (mean(&batches), error);
            }
            batches = batches.chunks(2).map(mean).collect();
            points *= 2;
            batches.extend((0..BATCHES / 2).map(|_| self.batch(points)).collect::<Vec<_>>());
        }
    }

    /// The integral by the next `count` points of the sequence.
    fn batch(&mut self, count: usize) -> Vec<f64> {
        let [receiver, emitter] = self.bases;
        let mut sum = vec![0.0; receiver.len() * emitter.len()];
        let (mut left, mut right) = (vec![0.0; receiver.len()], vec![0.0; emitter.len()]);
        let first = self.count.samples;
        for index in first..first + count as u64 {
            check_interrupt_at(index);
            let [x, y] = node_pair(self.patches, index);
            let value = kernel(&x, &y) * x.area * y.area;
            if value == 0.0 || self.look(&x, &y, value) == self.hidden {
                continue;
            }
            let value = value / count as f64;
            receiver.raw(receiver.frame().coordinates(&x), &mut left);
            emitter.raw(emitter.frame().coordinates(&y), &mut right);
            for (row, l) in sum.chunks_exact_mut(right.len()).zip(&left) {
                row.iter_mut().zip(&right).for_each(|(sum, r)| *sum += value * l * r);
            }
        }
        self.count.samples += count as u64;
        sum
    }

    /// The contribution of [`OFF`] or [`RULE_OF_THREE`] points: batches with few points of the summed kind
    /// may agree by chance.
    fn least_error(&self) -> f64 {
        let PointCounts { samples, facing, seen, weight } = self.count;
        if facing == 0 {
            return 0.0;
        }
        let met = if self.hidden { facing - seen } else { seen };
        let off = if met > 0 { OFF } else { RULE_OF_THREE };
        off / facing as f64 * weight / samples as f64 * self.constants
    }

    /// Whether two points that face each other see each other; counts them.
    fn look(&mut self, x: &Node, y: &Node, value: f64) -> bool {
        let seen = (self.sees)(x.position, y.position);
        self.rays += 1;
        self.count.facing += 1;
        self.count.seen += u64::from(seen);
        self.count.weight += value;
        seen
    }
}

/// The mean of estimates of the same integrals.
fn mean(batches: &[Vec<f64>]) -> Vec<f64> {
    let entry = |k: usize| batches.iter().map(|batch| batch[k]).sum::<f64>() / batches.len() as f64;
    (0..batches[0].len()).map(entry).collect()
}

/// Standard deviation of the mean of independent estimates, the largest of all integrals.
fn deviation(batches: &[Vec<f64>]) -> f64 {
    let (mean, count) = (mean(batches), batches.len() as f64);
    let square = |k: usize| batches.iter().map(|batch| (batch[k] - mean[k]).powi(2)).sum::<f64>();
    let largest = (0..mean.len()).map(square).fold(0.0, f64::max);
    (largest / (count * (count - 1.0))).sqrt()
}

#[cfg(test)]
mod tests {
    use radiosity_elements::frame::Frame;
    use radiosity_geom::DVec3;
    use radiosity_kernel::polygon_exchange;

    use super::*;

    fn square(z: f64, up: bool) -> [DVec3; 4] {
        let mut corners = [[0., 0.], [1., 0.], [1., 1.], [0., 1.]].map(|[x, y]| DVec3::new(x, y, z));
        if !up {
            corners.reverse();
        }
        corners
    }

    fn basis(patches: &[Patch]) -> AreaBasis {
        let corners = patches[0].polygon();
        let frame = Frame::bounding(&corners, [DVec3::X, DVec3::Y]);
        AreaBasis::new(0, frame, patches).expect("a square has area")
    }

    /// For two squares, one above the other, of which the lower one sees the upper one from x < `to` only:
    /// the result, and the exact integral.
    fn found(to: f64, limit: f64) -> (SampledVisibility, f64) {
        found_of(to, limit, SummedPoints::Rarer)
    }

    fn found_of(to: f64, limit: f64, summed: SummedPoints) -> (SampledVisibility, f64) {
        let (floor, ceiling) = (square(0.0, true), square(1.0, false));
        let p = Patch::of_polygon(&floor, DVec3::Z);
        let q = Patch::of_polygon(&ceiling, -DVec3::Z);
        let bases = [basis(&p), basis(&q)];
        let sees = |x: DVec3, _| x.x < to;
        let found = SampledVisibility::new([&p[0], &q[0]], [&bases[0], &bases[1]], &sees, limit, summed);
        let part = |from: f64, to: f64| {
            let corners = [[from, 0.], [to, 0.], [to, 1.], [from, 1.]].map(|[x, y]| DVec3::new(x, y, 0.0));
            polygon_exchange(&corners, &ceiling)
        };
        // The first polynomials are ½.
        let exact = 0.25 * if found.hidden { part(to, 1.0) } else { part(0.0, to) };
        (found, exact)
    }

    #[test]
    fn the_rarer_is_summed_to_twice_the_limit() {
        for (to, hidden) in [(0.13, false), (0.31, false), (0.77, true)] {
            for limit in [3e-4, 3e-5] {
                let (found, exact) = found(to, limit);
                assert_eq!(found.hidden, hidden);
                // `limit` is a standard deviation.
                let error = found.values[0] - exact;
                assert!(error.abs() <= 2.0 * limit, "{to} {limit:e}: {error:e}");
            }
        }
    }

    #[test]
    fn what_is_seen_is_summed_unless_that_is_dear() {
        for (limit, hidden) in [(1e-3, false), (1e-5, true)] {
            let (found, exact) = found_of(0.99, limit, SummedPoints::Seen);
            assert_eq!(found.hidden, hidden);
            assert!((found.values[0] - exact).abs() <= 3.0 * limit);
        }
    }

    #[test]
    fn patches_of_which_no_points_face_each_other_are_left_to_the_rule_over_all() {
        let (up, down) = (square(0.0, true), square(-1.0, false));
        let [p, q] = [Patch::of_polygon(&up, DVec3::Z), Patch::of_polygon(&down, -DVec3::Z)];
        let bases = [basis(&p), basis(&q)];
        let found = SampledVisibility::new(
            [&p[0], &q[0]],
            [&bases[0], &bases[1]],
            &|_, _| true,
            1e-3,
            SummedPoints::Seen,
        );
        assert!(found.hidden && found.values == [0.0] && found.error == 0.0 && found.rays == 0);
    }

    #[test]
    fn a_narrow_strip_is_not_missed() {
        for share in [0.04, 0.02, 0.01, 0.005] {
            for (to, limit) in [(1.0 - share, 1e-4), (share, 1e-4), (1.0 - share, 1e-5)] {
                let (found, exact) = found(to, limit);
                let error = found.values[0] - exact;
                assert!(error.abs() <= 3.0 * limit, "{to} {limit:e}: {error:e}");
            }
        }
    }

    #[test]
    fn where_nothing_is_hidden_points_are_taken_until_little_can_be() {
        for limit in [1e-2, 1e-3, 1e-4] {
            let (found, exact) = found(2.0, limit);
            assert!(found.hidden && found.values == [0.0] && found.error == 0.0);
            let all = exact.abs().max(0.25 * 0.2);
            let needed = 3.0 * all / limit;
            let samples = found.samples as f64;
            let fewest = (BATCHES * FEWEST) as f64;
            assert!(needed <= 1.1 * samples && samples <= fewest.max(2.2 * needed), "{limit:e}: {samples}");
        }
        assert!(found(2.0, 1e-9).0.error > 1e-9, "that much is more than the most points can tell");
    }
}
