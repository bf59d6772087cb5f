//! Patches apart of which some points do not see each other for their own horizons.
//!
//! The kernel is clipped where either of n_x·(y − x), n_y·(x − y) changes sign, and a tensor rule converges only like
//! 1/n² or so. Instead the integral is iterated: for every outer point x,
//!
//! ```text
//! W_l(x) = ∫_q κ(x, y) φ_l(y) dA_y
//! ```
//!
//! is computed on exactly the part of q that x sees. q is quartered until each horizon in a quarter crosses either all
//! lines along s or all lines along t at most once. There the visible stretch of a line ends at a root, and across
//! the lines the quarter is cut where a horizon leaves it through a side: on each stretch the integrand is analytic.
//! The kernel vanishes linearly at a horizon, so roots to 1e-9 do.
//!
//! A ball that stands between is cut away in the same manner. With e from x to its centre, d = y − x and the squared
//! length E = |e|² − r² of the tangents from x, y is hidden where it lies within the cone of the tangents and beyond the
//! plane e·d = E of the points where they touch, and so where
//!
//! ```text
//! h = E |d|² − (e·d)²  if e·d > E ,     h = E (|y − c|² − r²)  otherwise
//! ```
//!
//! is negative; h and its gradient are continuous, and the second is positive outside the ball.
//!
//! W itself loses smoothness (of second order or higher) only where a horizon starts to leave q; there the outer
//! patch is halved until the halves together agree with the whole.

use std::sync::Arc;

use radiosity_geom::DVec3;

use crate::elements::basis::AreaBasis;
use crate::elements::patch::{Direction, Node, Patch};
use crate::elements::rule::UnitRule;

use super::integrand::kernel;

/// Nodes a direction by which a patch and its quarters are judged.
const GRID: usize = 6;
/// Places by which roots on a side are bracketed.
const PLACES: usize = 6;
/// Most often that an inner patch is quartered.
pub(super) const DEEPEST: usize = 5;

/// Points of the rules that are tried on an outer patch, as parts of those that the kernel would take.
const RUNGS: [f64; 3] = [0.35, 0.55, 1.0];
/// Fewest points of these rules.
const FEWEST: usize = 4;
/// Part of the tolerance within which two of them have to agree.
const CLIMB_SHARE: f64 = 0.5;

/// By what at least the error of halves is smaller than that of the whole: a kink of second order gives 2⁻³.
const FINER: f64 = 0.125;

/// What a pair of patches gave.
#[derive(Debug)]
pub(super) struct Cut {
    /// Moments in the raw polynomials, row-major, outer functions by inner functions.
    pub moments: Vec<f64>,
    /// Estimate of their largest error.
    pub error: f64,
    /// Kernel and horizon evaluations.
    pub samples: u64,
}

/// A ball that may stand between.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball {
    /// Its centre.
    pub center: DVec3,
    /// Its radius.
    pub radius: f64,
}

/// An outer patch.
pub(super) struct Side<'a> {
    /// The patch.
    pub patch: &'a Patch,
    /// Its element's polynomials.
    pub basis: &'a AreaBasis,
    /// Points along and across.
    pub points: [usize; 2],
    /// What may stand between it and the inner patches; both lie outside it.
    pub ball: Option<Ball>,
}

/// The moments of an outer patch with inner ones apart from it, to `tolerance` in absolute terms, with about `budget`
/// evaluations. Inner patches come with their points along and across, and those of their parts by how often these
/// are quartered, which is done as often as points are given.
pub(super) fn integrate(
    outer: &Side,
    basis: &AreaBasis,
    inner: &[(Patch, Arc<[[usize; 2]]>)],
    tolerance: f64,
    budget: u64,
) -> Cut {
    let parts = inner.iter().map(|(patch, points)| Part::new(patch.clone(), basis, Arc::clone(points), 0));
    let mut job = Job {
        outer,
        columns: basis.len(),
        inner: parts.collect(),
        tolerance,
        budget,
        cut: Cut { moments: vec![0.0; outer.basis.len() * basis.len()], error: 0.0, samples: 0 },
    };
    match job.climb() {
        Ok(moments) => job.cut.moments = moments,
        Err(whole) => job.refine(outer.patch, &whole),
    }
    job.cut
}

struct Job<'a> {
    outer: &'a Side<'a>,
    columns: usize,
    inner: Vec<Part<'a>>,
    tolerance: f64,
    budget: u64,
    cut: Cut,
}

impl Job<'_> {
    /// Tries rules of few points on the outer patch, as W is often much smoother than the kernel: the moments of the
    /// first that agrees with the one before, or else of the last, which has all points.
    fn climb(&mut self) -> Result<Vec<f64>, Vec<f64>> {
        let most = self.outer.points;
        let mut before: Option<Vec<f64>> = None;
        for share in RUNGS {
            let points = most.map(|n| ((share * n as f64).ceil() as usize).max(FEWEST).min(n));
            let moments = self.cell(self.outer.patch, points);
            let difference = before.map_or(f64::INFINITY, |coarse| largest_difference(&coarse, &moments));
            if difference <= CLIMB_SHARE * self.tolerance {
                self.cut.error += FINER * difference;
                return Ok(moments);
            }
            before = Some(moments);
        }
        Err(before.expect("there are rungs"))
    }

    /// Adds a part of the outer patch whose moments by one rule are `whole`.
    fn refine(&mut self, part: &Patch, whole: &[f64]) {
        let [along, across] = part.extents();
        let halves = part.halves(if along >= across { Direction::Along } else { Direction::Across });
        let points = self.outer.points;
        let moments = [self.cell(&halves[0], points), self.cell(&halves[1], points)];
        let sum: Vec<f64> = moments[0].iter().zip(&moments[1]).map(|(a, b)| a + b).collect();
        let difference = largest_difference(&sum, whole);
        let spent = self.cut.samples > self.budget;
        if difference <= self.tolerance || spent {
            self.cut.moments.iter_mut().zip(&sum).for_each(|(m, s)| *m += s);
            self.cut.error += if spent { difference } else { FINER * difference };
            return;
        }
        for (half, moments) in halves.iter().zip(&moments) {
            self.refine(half, moments);
        }
    }

    /// Moments of a part of the outer patch by one tensor rule.
    fn cell(&mut self, part: &Patch, points: [usize; 2]) -> Vec<f64> {
        let (rows, columns) = (self.outer.basis.len(), self.columns);
        let [along, across] = points.map(UnitRule::of);
        let mut moments = vec![0.0; rows * columns];
        let (mut left, mut right) = (vec![0.0; rows], vec![0.0; columns]);
        for ((s, ws), (t, wt)) in along.iter().flat_map(|s| across.iter().map(move |t| (s, t))) {
            let x = part.node(s, t);
            right.fill(0.0);
            let x = View { node: x, ball: self.outer.ball };
            self.cut.samples += self.inner.iter_mut().map(|part| part.seen_from(&x, &mut right)).sum::<u64>();
            let x = x.node;
            self.outer.basis.raw(self.outer.basis.frame().coordinates(&x), &mut left);
            let weight = ws * wt * x.area;
            for (row, l) in moments.chunks_exact_mut(columns).zip(&left) {
                row.iter_mut().zip(&right).for_each(|(m, r)| *m += weight * l * r);
            }
        }
        moments
    }
}

/// The inner patch or a quarter of it, ready to be integrated as seen from any point.
struct Part<'a> {
    patch: Patch,
    basis: &'a AreaBasis,
    /// By depth; as many as there may be.
    points: Arc<[[usize; 2]]>,
    depth: usize,
    grid: Vec<Node>,
    center: DVec3,
    /// Bounds of the second differences of y, of n, and of n·(C − y) on the grid, summed over directions.
    bends: [f64; 3],
    /// The uncut rule: nodes, and rows of w A L_l; empty until it is used.
    nodes: Vec<Node>,
    rows: Vec<f64>,
    /// Empty until they are used.
    quarters: Vec<Part<'a>>,
}

impl<'a> Part<'a> {
    fn new(patch: Patch, basis: &'a AreaBasis, points: Arc<[[usize; 2]]>, depth: usize) -> Self {
        let place = |k: usize| k as f64 / (GRID - 1) as f64;
        let grid: Vec<Node> =
            (0..GRID * GRID).map(|k| patch.node(place(k / GRID), place(k % GRID))).collect();
        let center = grid.iter().map(|y| y.position).sum::<DVec3>() / grid.len() as f64;
        let bend = |value: &dyn Fn(&Node) -> DVec3| {
            let at = |place: usize| value(&grid[place]);
            second_differences(|a, b, c| (at(a) - 2.0 * at(b) + at(c)).length())
        };
        let bends = [
            bend(&|y| y.position),
            bend(&|y| y.normal),
            bend(&|y| DVec3::X * y.normal.dot(center - y.position)),
        ];
        let (nodes, rows, quarters) = (Vec::new(), Vec::new(), Vec::new());
        Self { patch, basis, points, depth, grid, center, bends, nodes, rows, quarters }
    }

    /// Adds W_l(x) to `out`; returns the number of evaluations.
    fn seen_from(&mut self, x: &View, out: &mut [f64]) -> u64 {
        let grid: Vec<Heights> = self.grid.iter().map(|y| x.heights(y)).collect();
        let reach = x.node.position.distance(self.center);
        let bends =
            [self.bends[0], self.bends[1] * reach + self.bends[2], x.ball.map_or(0.0, |_| bend(&grid))];
        let margins = bends.map(|bend| 0.25 * bend);
        let range = |k: usize| {
            let values = grid.iter().map(|h| h[k]);
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], h| [low.min(h), high.max(h)])
        };
        let ranges = [0, 1, 2].map(range);
        let spent = grid.len() as u64;
        if (0..HEIGHTS).any(|k| ranges[k][1] + margins[k] <= 0.0) {
            return spent;
        }
        let clipped: Vec<usize> = (0..HEIGHTS).filter(|k| ranges[*k][0] < margins[*k]).collect();
        if clipped.is_empty() {
            return spent + self.whole(x, out);
        }
        let crosses = |direction| clipped.iter().all(|k| monotone(&grid, *k, direction));
        let direction = [Direction::Along, Direction::Across].into_iter().find(|d| crosses(*d));
        match direction {
            Some(direction) => spent + self.cut(x, direction, out),
            None if self.depth + 1 == self.points.len() => spent + self.cut(x, Direction::Along, out),
            None => spent + self.quartered(x, out),
        }
    }

    fn quartered(&mut self, x: &View, out: &mut [f64]) -> u64 {
        if self.quarters.is_empty() {
            let halves = self.patch.halves(Direction::Along);
            let quarters = halves.iter().flat_map(|half| half.halves(Direction::Across));
            let (basis, points, depth) = (self.basis, self.points.clone(), self.depth + 1);
            self.quarters = quarters.map(|patch| Part::new(patch, basis, points.clone(), depth)).collect();
        }
        self.quarters.iter_mut().map(|quarter| quarter.seen_from(x, out)).sum()
    }

    fn whole(&mut self, x: &View, out: &mut [f64]) -> u64 {
        if self.nodes.is_empty() {
            self.tabulate();
        }
        for (y, row) in self.nodes.iter().zip(self.rows.chunks_exact(out.len())) {
            let value = kernel(&x.node, y);
            out.iter_mut().zip(row).for_each(|(o, r)| *o += value * r);
        }
        self.nodes.len() as u64
    }

    fn tabulate(&mut self) {
        let [along, across] = self.points[self.depth].map(UnitRule::of);
        let mut row = vec![0.0; self.basis.len()];
        for ((s, ws), (t, wt)) in along.iter().flat_map(|s| across.iter().map(move |t| (s, t))) {
            let node = self.patch.node(s, t);
            self.basis.raw(self.basis.frame().coordinates(&node), &mut row);
            self.rows.extend(row.iter().map(|value| ws * wt * node.area * value));
            self.nodes.push(node);
        }
    }

    /// The part that x sees, along lines of the given direction.
    fn cut(&self, x: &View, direction: Direction, out: &mut [f64]) -> u64 {
        let node = |w: f64, z: f64| match direction {
            Direction::Along => self.patch.node(w, z),
            Direction::Across => self.patch.node(z, w),
        };
        let [along, across] = self.points[self.depth].map(UnitRule::of);
        let (line, over) = if direction == Direction::Along { (along, across) } else { (across, along) };
        let mut values = vec![0.0; self.basis.len()];
        let mut evaluations = 0;
        let mut breaks = vec![0.0, 1.0];
        for side in [0.0, 1.0] {
            evaluations += roots(|z| x.heights(&node(side, z)), &mut breaks);
        }
        breaks.sort_by(f64::total_cmp);
        for (low, high) in stretches(&breaks) {
            for (z, wz) in over.iter() {
                let z = low + (high - low) * z;
                let Some([start, end]) = visible(|w| x.heights(&node(w, z)), &mut evaluations) else {
                    continue;
                };
                evaluations += line.nodes.len() as u64;
                for (w, ww) in line.iter() {
                    let y = node(start + (end - start) * w, z);
                    let value = kernel(&x.node, &y) * y.area * wz * ww * (high - low) * (end - start);
                    self.basis.raw(self.basis.frame().coordinates(&y), &mut values);
                    out.iter_mut().zip(&values).for_each(|(o, l)| *o += value * l);
                }
            }
        }
        evaluations
    }
}

/// What has to be positive for two points to see each other.
const HEIGHTS: usize = 3;
type Heights = [f64; HEIGHTS];

/// A point that looks at an inner patch, with what may stand in between.
struct View {
    node: Node,
    ball: Option<Ball>,
}

impl View {
    /// [n_x·(y − x), n_y·(x − y), h]: the heights of each over the tangent plane of the other, and that over the cone of
    /// the ball, 1 if there is none.
    fn heights(&self, y: &Node) -> Heights {
        let d = y.position - self.node.position;
        let over_ball = self.ball.map_or(1.0, |ball| ball.clearance(self.node.position, y.position));
        [self.node.normal.dot(d), -y.normal.dot(d), over_ball]
    }
}

impl Ball {
    /// h of the module's head.
    fn clearance(&self, x: DVec3, y: DVec3) -> f64 {
        let (e, d) = (self.center - x, y - x);
        let tangent = e.length_squared() - self.radius * self.radius;
        let along = e.dot(d);
        if along > tangent {
            tangent * d.length_squared() - along * along
        } else {
            tangent * (y.distance_squared(self.center) - self.radius * self.radius)
        }
    }
}

/// The sum over both directions of the largest second difference of the last height.
fn bend(grid: &[Heights]) -> f64 {
    let height = |place: usize| grid[place][HEIGHTS - 1];
    second_differences(|a, b, c| (height(a) - 2.0 * height(b) + height(c)).abs())
}

/// Whether a height rises, or falls, along all lines of a direction.
fn monotone(grid: &[Heights], which: usize, direction: Direction) -> bool {
    let (step, first) = if direction == Direction::Along { (GRID, 1) } else { (1, GRID) };
    let steps = (0..GRID).flat_map(|line| {
        (1..GRID)
            .map(move |k| grid[line * first + k * step][which] - grid[line * first + (k - 1) * step][which])
    });
    let [low, high] =
        steps.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], d| [low.min(d), high.max(d)]);
    // Steps of one sign, and none so small beside the others that a turn may lie in its neighbourhood.
    (low > 0.0 || high < 0.0) && low.abs().min(high.abs()) > 0.1 * low.abs().max(high.abs())
}

/// The stretch of a line on which all heights, each monotone, are positive.
fn visible(f: impl Fn(f64) -> Heights, evaluations: &mut u64) -> Option<[f64; 2]> {
    let (first, last) = (f(0.0), f(1.0));
    *evaluations += 2;
    let mut stretch = [0.0f64, 1.0];
    for k in 0..HEIGHTS {
        if first[k].max(last[k]) <= 0.0 {
            return None;
        }
        if first[k].min(last[k]) < 0.0 {
            let at = root(|w| f(w)[k], [0.0, 1.0], [first[k], last[k]], evaluations);
            stretch = if first[k] < 0.0 {
                [stretch[0].max(at), stretch[1]]
            } else {
                [stretch[0], stretch[1].min(at)]
            };
        }
    }
    (stretch[0] < stretch[1]).then_some(stretch)
}

/// Appends the roots in (0, 1) of all heights; returns the number of evaluations.
fn roots(f: impl Fn(f64) -> Heights, out: &mut Vec<f64>) -> u64 {
    let place = |k: usize| k as f64 / (PLACES - 1) as f64;
    let values: [Heights; PLACES] = std::array::from_fn(|k| f(place(k)));
    let mut evaluations = PLACES as u64;
    for which in 0..HEIGHTS {
        let mut brackets = Vec::new();
        for k in 1..PLACES {
            let (low, high) = (values[k - 1][which], values[k][which]);
            if low * high < 0.0 {
                brackets.push(([place(k - 1), place(k)], [low, high]));
            }
        }
        // Two roots between neighbours of one sign: at the vertex of the parabola through three the sign may differ.
        for k in 1..PLACES - 1 {
            let [a, b, c] = [k - 1, k, k + 1].map(|k| values[k][which]);
            let bend = a - 2.0 * b + c;
            if !(a * b > 0.0 && b * c > 0.0 && b * bend > 0.0 && (a - c).abs() < 2.0 * bend.abs()) {
                continue;
            }
            let w = place(k) + 0.5 * (a - c) / bend / (PLACES - 1) as f64;
            let value = f(w)[which];
            evaluations += 1;
            if value * b < 0.0 {
                brackets.push(([place(k - 1), w], [a, value]));
                brackets.push(([w, place(k + 1)], [value, c]));
            }
        }
        for (ends, values) in brackets {
            out.push(root(|w| f(w)[which], ends, values, &mut evaluations));
        }
    }
    evaluations
}

/// A bracketed root by the Illinois variant of false position.
fn root(f: impl Fn(f64) -> f64, mut ends: [f64; 2], mut values: [f64; 2], evaluations: &mut u64) -> f64 {
    let mut last = ends[0];
    for _ in 0..40 {
        let w = (ends[0] * values[1] - ends[1] * values[0]) / (values[1] - values[0]);
        if (w - last).abs() <= 1e-9 {
            return w;
        }
        last = w;
        let value = f(w);
        *evaluations += 1;
        if value * values[1] < 0.0 {
            (ends[0], values[0]) = (ends[1], values[1]);
        } else {
            values[0] *= 0.5;
        }
        (ends[1], values[1]) = (w, value);
    }
    last
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The stretches between sorted breaks.
fn stretches(breaks: &[f64]) -> impl Iterator<Item = (f64, f64)> + '_ {
    breaks.windows(2).map(|w| (w[0], w[1])).filter(|(low, high)| high - low > 1e-12)
}

/// The sum over both directions of the grid of the largest second difference, as `second` takes its size from three places
/// that follow each other.
fn second_differences(second: impl Fn(usize, usize, usize) -> f64) -> f64 {
    let at = |i: usize, j: usize| i * GRID + j;
    let mut largest = [0.0f64; 2];
    for i in 1..GRID - 1 {
        for j in 0..GRID {
            largest[0] = largest[0].max(second(at(i - 1, j), at(i, j), at(i + 1, j)));
            largest[1] = largest[1].max(second(at(j, i - 1), at(j, i), at(j, i + 1)));
        }
    }
    largest[0] + largest[1]
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::elements::basis::Frame;
    use proptest::prelude::*;
    use radiosity_geom::shapes::{FULL_TURN, Sphere};
    use radiosity_geom::{DVec2, Flipped, Ray, Rect, Surface};

    proptest! {
        /// The sign of the clearance tells what a ray against the sphere tells.
        #[test]
        fn clearance_is_negative_where_the_ball_stands_between(
            x in prop::array::uniform3(-3.0..3.0f64), y in prop::array::uniform3(-3.0..3.0f64),
        ) {
            let (x, y) = (DVec3::from_array(x), DVec3::from_array(y));
            prop_assume!(x.length() > 1.0 && y.length() > 1.0);
            let ball = Ball { center: DVec3::ZERO, radius: 1.0 };
            let sphere = Sphere::new(DVec3::ZERO, 1.0, DVec3::Z, [-1.0, 1.0], FULL_TURN).expect("a sphere");
            let clearance = ball.clearance(x, y);
            prop_assume!(clearance.abs() > 1e-9);
            prop_assert_eq!(clearance < 0.0, sphere.occludes(&Ray::segment(x, y)));
        }
    }

    /// Within a sphere every point facing any way sees the sphere alone: ∫κ dA = 1.
    #[test]
    fn a_point_in_a_sphere_sees_it_wholly() {
        let sphere = Sphere::new(DVec3::ZERO, 2.0, DVec3::Z, [-2.0, 2.0], FULL_TURN).expect("a sphere");
        let inside: Arc<dyn Surface> = Arc::new(Flipped::new(Box::new(sphere)));
        let whole = Patch::curved(Arc::clone(&inside), &Rect::FULL);
        let frame = Frame::Parameters { center: DVec2::ZERO, half: DVec2::ONE };
        let basis = AreaBasis::new(0, frame, std::slice::from_ref(&whole)).expect("it has area");
        let halves = |patch: &Patch, direction| patch.halves(direction).to_vec();
        let quarters =
            halves(&whole, Direction::Along).into_iter().flat_map(|p| halves(&p, Direction::Along));
        let eighths = quarters.flat_map(|p| halves(&p, Direction::Across));
        let mut parts: Vec<Part> =
            eighths.map(|patch| Part::new(patch, &basis, [[16; 2]; DEEPEST + 1].into(), 0)).collect();
        for k in 0..40 {
            let (sin, cos) = (0.7 * f64::from(k)).sin_cos();
            let z = 0.96 - 0.05 * f64::from(k);
            let normal = DVec3::new((1.0 - z * z).sqrt() * cos, (1.0 - z * z).sqrt() * sin, z);
            let node = Node { position: normal, normal, area: 1.0, parameters: DVec2::ZERO };
            let x = View { node, ball: None };
            let mut out = [0.0];
            parts.iter_mut().for_each(|part| _ = part.seen_from(&x, &mut out));
            // L₀ = ½.
            assert!((2.0 * out[0] - 1.0).abs() < 2e-8, "{z}: {:e}", 2.0 * out[0] - 1.0);
        }
    }
}
