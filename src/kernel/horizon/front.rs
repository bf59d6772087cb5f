//! What of an outer patch lies before the plane of inner ones.
//!
//! All points of a plane have one horizon. Where x comes through it, all of a planar inner patch comes into sight at once,
//!
//! ```text
//! W(x) ∝ max(0, h(x)) ,     h(x) = n·(x − y) ,
//! ```
//!
//! and W has a kink of first order all across the outer patch, which no halving finds fast. So rules for such patches run over
//! what is before the plane alone, where W is smooth.

use crate::elements::patch::{Direction, Node, Patch};
use crate::elements::rule::UnitRule;
use crate::kernel::planes::Plane;

use super::line::{Lines, seen};

/// Places a direction at which heights over the plane are looked at.
const GRID: usize = 6;
/// Most often that a patch is quartered until its lines cross the plane at most once.
const DEEPEST: usize = 5;
/// Most often that a patch is halved until a rule gives the moments of its heights.
const MOST_SPLITS: usize = 8;
/// Steps of a height below this part of all heights are none.
const LEVEL: f64 = 1e-13;

/// The side of the plane from which inner patches are seen.
#[derive(Debug)]
pub(in crate::kernel) struct Front {
    plane: Plane,
}

/// Points with their weights in area, and what was evaluated to find them.
#[derive(Debug, Default)]
pub(in crate::kernel) struct Nodes {
    /// Points and weights.
    pub nodes: Vec<(Node, f64)>,
    /// Heights and points beyond these.
    pub evaluations: u64,
}

impl Nodes {
    /// A tensor rule of so many points along and across.
    pub(super) fn of(patch: &Patch, points: [usize; 2]) -> Self {
        let [along, across] = points.map(UnitRule::of);
        let places = along.iter().flat_map(|s| across.iter().map(move |t| (s, t)));
        let node = |((s, ws), (t, wt))| {
            let x: Node = patch.node(s, t);
            (x, ws * wt * x.area)
        };
        Self { nodes: places.map(node).collect(), evaluations: 0 }
    }
}

impl Front {
    /// That of a plane.
    pub(in crate::kernel) fn of(plane: Plane) -> Self {
        Self { plane }
    }

    /// Height of a point over the plane.
    pub(super) fn height(&self, x: &Node) -> f64 {
        (x.position - self.plane.0).dot(self.plane.1)
    }

    /// Whether a part of a patch lies behind the plane.
    pub(in crate::kernel) fn cuts(&self, patch: &Patch) -> bool {
        Grid::of(patch, self).low() < 0.0
    }

    /// The rule of so many points along and across on what of a patch is before the plane.
    pub(in crate::kernel) fn nodes(&self, patch: &Patch, points: [usize; 2]) -> Nodes {
        let grid = Grid::of(patch, self);
        if grid.low() >= 0.0 {
            return Nodes::of(patch, points);
        }
        let mut nodes = Nodes::default();
        self.add(patch, points, grid, DEEPEST, &mut nodes);
        nodes
    }

    /// A patch in parts, on each of which so many points give the first moments of h to a relative error of about `eps`: next to
    /// the centre of a disk lines end at the plane in ever different places.
    pub(in crate::kernel) fn parts(&self, patch: &Patch, points: [usize; 2], eps: f64) -> Vec<Patch> {
        let sum = self.moments(patch, points);
        let mut parts = Vec::new();
        self.split(patch.clone(), sum, points, sum.map(|moment| eps * moment), MOST_SPLITS, &mut parts);
        parts
    }

    fn split(
        &self,
        patch: Patch,
        sum: [f64; 2],
        points: [usize; 2],
        limit: [f64; 2],
        depth: usize,
        out: &mut Vec<Patch>,
    ) {
        let differ = |direction| {
            let halves = patch.halves(direction);
            let sums = [&halves[0], &halves[1]].map(|half| self.moments(half, points));
            let off = (0..2).map(|k| (sum[k] - sums[0][k] - sums[1][k]).abs() / limit[k]).fold(0.0, f64::max);
            (off, halves, sums)
        };
        let worse =
            [Direction::Along, Direction::Across].map(differ).into_iter().max_by(|a, b| a.0.total_cmp(&b.0));
        match worse {
            Some((off, halves, sums)) if off > 1.0 && depth > 0 => {
                for (half, sum) in halves.into_iter().zip(sums) {
                    self.split(half, sum, points, limit, depth - 1, out);
                }
            }
            _ => out.push(patch),
        }
    }

    /// ∫ h dA and ∫ h² dA over what of a patch is before the plane.
    fn moments(&self, patch: &Patch, points: [usize; 2]) -> [f64; 2] {
        let nodes = self.nodes(patch, points).nodes;
        nodes.iter().fold([0.0; 2], |[first, second], (x, weight)| {
            let h = self.height(x);
            [first + weight * h, second + weight * h * h]
        })
    }

    /// Adds the rule on what of a patch with these heights is before the plane.
    fn add(&self, patch: &Patch, points: [usize; 2], grid: Grid, depth: usize, out: &mut Nodes) {
        out.evaluations += (GRID * GRID) as u64;
        if grid.high() <= 0.0 {
            return;
        }
        match grid.straightest() {
            None if depth > 0 => {
                for quarter in patch.halves(Direction::Along).iter().flat_map(|p| p.halves(Direction::Across))
                {
                    self.add(&quarter, points, Grid::of(&quarter, self), depth - 1, out);
                }
            }
            direction => {
                let lines = direction.map_or(Lines::Winding(Direction::Along), Lines::Plain);
                let heights = |x: &Node| [self.height(x), 1.0, 1.0];
                let nodes = &mut out.nodes;
                out.evaluations += seen(patch, lines, points, &heights, |x, factors| {
                    nodes.push((*x, factors.iter().product()));
                });
            }
        }
    }
}

/// Heights of a patch over the plane, at the crossings of lines along and across.
struct Grid {
    heights: [[f64; GRID]; GRID],
}

impl Grid {
    fn of(patch: &Patch, front: &Front) -> Self {
        let place = |k: usize| k as f64 / (GRID - 1) as f64;
        let height = |i: usize, j: usize| front.height(&patch.node(place(i), place(j)));
        Self { heights: std::array::from_fn(|i| std::array::from_fn(|j| height(i, j))) }
    }

    fn all(&self) -> impl Iterator<Item = f64> {
        self.heights.iter().flatten().copied()
    }

    /// The least height of the patch, about, from below.
    fn low(&self) -> f64 {
        self.all().fold(f64::INFINITY, f64::min) - self.margin()
    }

    /// The largest, from above.
    fn high(&self) -> f64 {
        self.all().fold(f64::NEG_INFINITY, f64::max) + self.margin()
    }

    /// By how much heights may leave the range of those on the grid.
    fn margin(&self) -> f64 {
        0.25 * (self.bend(Direction::Along) + self.bend(Direction::Across))
    }

    fn lines(&self, direction: Direction) -> impl Iterator<Item = [f64; GRID]> {
        let line = move |k: usize| match direction {
            Direction::Along => std::array::from_fn(|i| self.heights[i][k]),
            Direction::Across => self.heights[k],
        };
        (0..GRID).map(line)
    }

    /// The largest second difference along lines of a direction.
    fn bend(&self, direction: Direction) -> f64 {
        let second = |w: &[f64]| (w[0] - 2.0 * w[1] + w[2]).abs();
        let bend = |line: [f64; GRID]| line.windows(3).map(second).fold(0.0, f64::max);
        self.lines(direction).map(bend).fold(0.0, f64::max)
    }

    /// The direction whose lines are bent least, among those each of whose lines crosses the plane at most once.
    fn straightest(&self) -> Option<Direction> {
        let level = LEVEL * self.all().map(f64::abs).fold(0.0, f64::max);
        let is_monotone = |line: [f64; GRID]| {
            let steps = || line.windows(2).map(|w| w[1] - w[0]);
            steps().all(|step| step >= -level) || steps().all(|step| step <= level)
        };
        [Direction::Along, Direction::Across]
            .into_iter()
            .filter(|direction| self.lines(*direction).all(is_monotone))
            .min_by(|a, b| self.bend(*a).total_cmp(&self.bend(*b)))
    }
}
