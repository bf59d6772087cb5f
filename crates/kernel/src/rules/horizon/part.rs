//! W_l(x) of an inner patch q: integration over the part q(x) above all horizons, for any outer point x.
//!
//! The three heights h of `view` are known on a grid of 6 × 6 nodes. Between its nodes they stay within its
//! range but for a margin, twice the ⅛ of second differences Δ_d that linear interpolation leaves,
//!
//! ```text
//! ¼ Σ_d max |Δ_d h| ,     |Δ h₁| ≤ |Δ y| ,     |Δ h₂| ≤ |Δ n_y| |x − C| + |Δ (n_y·(C − y))| ,
//! ```
//!
//! with C the mean of the nodes; those of h₃ are taken as they are. Then W_l(x) is
//!
//! * 0 if some height is positive nowhere, margin included;
//! * the tensor rule on q if all heights stay positive beyond the margin;
//! * summed line by line (`line`) if in one direction of the chart the heights that may vanish are linear on
//!   all lines of the grid, or monotone on all of them: each then crosses a line once at most;
//! * the sum over the quarters of q otherwise. Quarters of the last depth given, 5 at the most, are summed
//!   line by line along s, with any number of roots on a line.
//!
//! On each strip of lines the integrand and the ends of its lines are smooth, so that Gauss rules converge
//! exponentially. A height is taken for monotone whose steps on the grid have one sign, none below a tenth of
//! the largest: a turn between two nodes is missed where that is wrong.

use std::sync::Arc;

use radiosity_elements::basis::AreaBasis;
use radiosity_elements::patch::{Direction, Node, Patch};
use radiosity_elements::rule::UnitRule;
use radiosity_geom::{DVec3, ROUNDING};

use crate::moments::integrand::kernel;
use crate::rules::horizon::line::{Lines, seen};
use crate::rules::horizon::view::{HEIGHTS, Heights, View};
use crate::tolerances::GRID_OF_HEIGHTS;

/// The inner patch or a quarter of it, with the data to be integrated as seen from any point.
pub(super) struct Part<'a> {
    patch: Patch,
    basis: &'a AreaBasis,
    /// Points along and across by depth, as deep as quarters go.
    points: Arc<[[usize; 2]]>,
    depth: usize,
    grid: Vec<Node>,
    center: DVec3,
    /// Largest second differences of y, of n, and of n·(C − y) on the grid, summed over both directions.
    bends: [f64; 3],
    /// The rule on the whole patch: nodes, and rows of w A L_l; empty until used.
    nodes: Vec<Node>,
    rows: Vec<f64>,
    /// Quarters of the patch; empty until used.
    quarters: Vec<Part<'a>>,
}

impl<'a> Part<'a> {
    pub(super) fn new(patch: Patch, basis: &'a AreaBasis, points: Arc<[[usize; 2]]>, depth: usize) -> Self {
        let place = |k: usize| k as f64 / (GRID_OF_HEIGHTS - 1) as f64;
        let grid: Vec<Node> = (0..GRID_OF_HEIGHTS * GRID_OF_HEIGHTS)
            .map(|k| patch.node(place(k / GRID_OF_HEIGHTS), place(k % GRID_OF_HEIGHTS)))
            .collect();
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

    pub(super) fn patch(&self) -> &Patch {
        &self.patch
    }

    /// Whether the point may see any of it.
    pub(super) fn may_be_seen_from(&self, x: &View) -> bool {
        let grid: Vec<Heights> = self.grid.iter().map(|y| x.heights(y)).collect();
        !is_dark(&ranges(&grid), &self.margins(x, &grid))
    }

    /// Margins beyond their ranges on the grid that heights may have: twice ⅛ of the second differences.
    fn margins(&self, x: &View, grid: &[Heights]) -> Heights {
        let reach = x.node.position.distance(self.center);
        let over_ball = x.ball.map_or(0.0, |_| bend(grid));
        [self.bends[0], self.bends[1] * reach + self.bends[2], over_ball].map(|bend| 0.25 * bend)
    }

    /// Adds W_l(x) to `out`; returns the number of evaluations.
    pub(super) fn seen_from(&mut self, x: &View, out: &mut [f64]) -> u64 {
        let grid: Vec<Heights> = self.grid.iter().map(|y| x.heights(y)).collect();
        let (ranges, margins) = (ranges(&grid), self.margins(x, &grid));
        let spent = grid.len() as u64;
        if is_dark(&ranges, &margins) {
            return spent;
        }
        let clipped: Vec<usize> = (0..HEIGHTS).filter(|k| ranges[*k][0] < margins[*k]).collect();
        if clipped.is_empty() {
            return spent + self.whole(x, out);
        }
        let find = |crosses: &dyn Fn(usize, Direction) -> bool| {
            [Direction::Along, Direction::Across]
                .into_iter()
                .find(|d| clipped.iter().all(|k| crosses(*k, *d)))
        };
        // On a line where heights are linear the root is as smooth a function of the line as the heights.
        let plain = find(&|k, d| straight(&grid, k, d)).or_else(|| find(&|k, d| monotone(&grid, k, d)));
        match plain {
            Some(direction) => spent + self.cut(x, Lines::Plain(direction), out),
            None if self.depth + 1 == self.points.len() => {
                spent + self.cut(x, Lines::Winding(Direction::Along), out)
            }
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

    /// Adds the part that x sees, line by line.
    fn cut(&self, x: &View, lines: Lines, out: &mut [f64]) -> u64 {
        let mut values = vec![0.0; self.basis.len()];
        let points = self.points[self.depth];
        seen(&self.patch, lines, points, &|y| x.heights(y), |y, factors| {
            let value = factors.into_iter().fold(kernel(&x.node, y), |value, factor| value * factor);
            self.basis.raw(self.basis.frame().coordinates(y), &mut values);
            out.iter_mut().zip(&values).for_each(|(o, l)| *o += value * l);
        })
    }
}

/// Least and largest of each height on a grid.
fn ranges(grid: &[Heights]) -> [[f64; 2]; HEIGHTS] {
    std::array::from_fn(|k| {
        let values = grid.iter().map(|h| h[k]);
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], h| [low.min(h), high.max(h)])
    })
}

/// Whether some height is nowhere positive.
fn is_dark(ranges: &[[f64; 2]; HEIGHTS], margins: &Heights) -> bool {
    ranges.iter().zip(margins).any(|([_, high], margin)| high + margin <= 0.0)
}

/// The sum over both directions of the largest second difference of the last height, the one over the ball's
/// cone.
fn bend(grid: &[Heights]) -> f64 {
    let height = |place: usize| grid[place][HEIGHTS - 1];
    second_differences(|a, b, c| (height(a) - 2.0 * height(b) + height(c)).abs())
}

/// Whether a height is monotone along all lines of a direction.
fn monotone(grid: &[Heights], which: usize, direction: Direction) -> bool {
    let (step, first) =
        if direction == Direction::Along { (GRID_OF_HEIGHTS, 1) } else { (1, GRID_OF_HEIGHTS) };
    let steps = (0..GRID_OF_HEIGHTS).flat_map(|line| {
        (1..GRID_OF_HEIGHTS)
            .map(move |k| grid[line * first + k * step][which] - grid[line * first + (k - 1) * step][which])
    });
    let [low, high] =
        steps.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], d| [low.min(d), high.max(d)]);
    // Steps of one sign, none below a tenth of the largest, beside which a turn might lie. With more
    // than a tenth more patches are quartered, with less more turns are missed.
    (low > 0.0 || high < 0.0) && low.abs().min(high.abs()) > 0.1 * low.abs().max(high.abs())
}

/// Whether a height is linear along all lines of a direction.
fn straight(grid: &[Heights], which: usize, direction: Direction) -> bool {
    let (step, first) =
        if direction == Direction::Along { (GRID_OF_HEIGHTS, 1) } else { (1, GRID_OF_HEIGHTS) };
    let size = grid.iter().map(|h| h[which].abs()).fold(0.0, f64::max);
    let bends = (0..GRID_OF_HEIGHTS).flat_map(|line| {
        (1..GRID_OF_HEIGHTS - 1).map(move |k| {
            let at = |k: usize| grid[line * first + k * step][which];
            at(k - 1) - 2.0 * at(k) + at(k + 1)
        })
    });
    bends.map(f64::abs).fold(0.0, f64::max) <= ROUNDING * size
}

/// The largest `second` of three consecutive grid points in either direction, summed over both.
fn second_differences(second: impl Fn(usize, usize, usize) -> f64) -> f64 {
    let at = |i: usize, j: usize| i * GRID_OF_HEIGHTS + j;
    let mut largest = [0.0f64; 2];
    for i in 1..GRID_OF_HEIGHTS - 1 {
        for j in 0..GRID_OF_HEIGHTS {
            largest[0] = largest[0].max(second(at(i - 1, j), at(i, j), at(i + 1, j)));
            largest[1] = largest[1].max(second(at(j, i - 1), at(j, i), at(j, i + 1)));
        }
    }
    largest[0] + largest[1]
}

#[cfg(test)]
mod tests {
    use radiosity_elements::basis::Frame;
    use radiosity_geom::shapes::{FULL_TURN, Sphere};
    use radiosity_geom::{DVec2, Flipped, Rect, Surface};

    use super::*;
    use crate::tolerances::MOST_QUARTERINGS;

    /// Inside a sphere every point sees nothing but the sphere: ∫κ dA = 1.
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
        let mut parts: Vec<Part> = eighths
            .map(|patch| Part::new(patch, &basis, [[16; 2]; MOST_QUARTERINGS + 1].into(), 0))
            .collect();
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
