//! The part of an outer patch before the plane of inner ones.
//!
//! All points of a plane share one horizon. Where x passes through it, all of a planar inner patch comes into
//! sight at once,
//!
//! ```text
//! W(x) ∝ max(0, h(x)) ,     h(x) = n·(x − y) ,
//! ```
//!
//! and W has a kink of first order across the outer patch. Rules then converge like 1/n² and their
//! differences say little about their errors. Hence rules run only over the part h > 0, where W is smooth:
//! the tensor rule where that is the whole patch, else line by line (`line`) in the direction of the least
//! bent lines among those that cross the plane once at most, on quarters of the patch where neither direction
//! has only such lines, and after 5 quarterings on lines with any number of roots.

use radiosity_elements::measure::WeightedNode;
use radiosity_elements::patch::{Direction, Node, Patch};
use radiosity_elements::rule::UnitRule;
use radiosity_geom::{COINCIDENT, Plane};

use crate::rules::horizon::line::{Lines, seen};
use crate::tolerances::{GRID_OF_HEIGHTS, LEVEL_OF_STEPS, MOST_QUARTERINGS, MOST_SPLITS};

/// The side of the inner patches' plane from which they are seen.
#[derive(Debug)]
pub struct Front {
    plane: Plane,
}

/// Points of a rule, and the evaluations that found them.
#[derive(Debug, Default)]
pub struct Nodes {
    pub nodes: Vec<WeightedNode>,
    /// Whether they are those of a tensor rule, in its order.
    pub is_tensor: bool,
    /// Evaluations of heights and points besides `nodes`.
    pub evaluations: u64,
}

impl Nodes {
    /// The tensor rule with these points along and across.
    pub(super) fn of(patch: &Patch, points: [usize; 2]) -> Self {
        let [along, across] = points.map(UnitRule::of);
        let places = along.iter().flat_map(|s| across.iter().map(move |t| (s, t)));
        let node = |((s, ws), (t, wt))| {
            let node = patch.node(s, t);
            WeightedNode { node, weight: ws * wt * node.area }
        };
        Self { nodes: places.map(node).collect(), is_tensor: true, evaluations: 0 }
    }
}

impl Front {
    /// The front of a plane.
    pub fn of(plane: Plane) -> Self {
        Self { plane }
    }

    pub(super) fn height(&self, x: &Node) -> f64 {
        self.plane.height(x.position)
    }

    /// Whether a part of a patch lies behind the plane.
    pub fn cuts(&self, patch: &Patch) -> bool {
        Grid::of(patch, self).low() < 0.0
    }

    /// Whether points of a patch lie behind the plane by more than rounding.
    pub(super) fn hides_points_of(&self, patch: &Patch) -> bool {
        let level = -COINCIDENT * patch.longest().1;
        Grid::of(patch, self).all().any(|height| height < level)
    }

    /// The rule with these points along and across on the part of a patch before the plane.
    pub fn nodes(&self, patch: &Patch, points: [usize; 2]) -> Nodes {
        let grid = Grid::of(patch, self);
        if grid.low() >= 0.0 {
            return Nodes::of(patch, points);
        }
        let mut nodes = Nodes::default();
        self.add(patch, points, grid, MOST_QUARTERINGS, &mut nodes);
        nodes
    }

    /// Cuts a patch into parts on each of which the rule with `points` integrates h and h² to a relative
    /// error of about `eps`: near the centre of a disk the lines end at the plane in very different places.
    pub fn parts(&self, patch: &Patch, points: [usize; 2], eps: f64) -> Vec<Patch> {
        let limit = self.moments(patch, points).map(|moment| eps * moment);
        let mut parts = Vec::new();
        let mut open = vec![(patch.clone(), 0)];
        while let Some((part, depth)) = open.pop() {
            match self.uneven(&part, points, limit) {
                Some(direction) if depth < MOST_SPLITS => {
                    open.extend(part.halves(direction).map(|half| (half, depth + 1)));
                }
                _ => parts.push(part),
            }
        }
        parts
    }

    /// The direction in which the moments of the halves differ most from those of the whole, if by more than
    /// `limit`.
    fn uneven(&self, part: &Patch, points: [usize; 2], limit: [f64; 2]) -> Option<Direction> {
        let whole = self.moments(part, points);
        let off = |direction: Direction| {
            let [first, second] = part.halves(direction).map(|half| self.moments(&half, points));
            (0..2).map(|k| (whole[k] - first[k] - second[k]).abs() / limit[k]).fold(0.0, f64::max)
        };
        let [along, across] = [Direction::Along, Direction::Across].map(off);
        let worse = if across > along { Direction::Across } else { Direction::Along };
        (along.max(across) > 1.0).then_some(worse)
    }

    /// ∫ h dA and ∫ h² dA over the part of a patch before the plane.
    fn moments(&self, patch: &Patch, points: [usize; 2]) -> [f64; 2] {
        let nodes = self.nodes(patch, points).nodes;
        nodes.iter().fold([0.0; 2], |[first, second], WeightedNode { node, weight }| {
            let h = self.height(node);
            [first + weight * h, second + weight * h * h]
        })
    }

    /// Adds the rule on the part of a patch before the plane; `grid` holds its heights.
    fn add(&self, patch: &Patch, points: [usize; 2], grid: Grid, depth: usize, out: &mut Nodes) {
        out.evaluations += (GRID_OF_HEIGHTS * GRID_OF_HEIGHTS) as u64;
        if grid.high() <= 0.0 {
            return;
        }
        let direction = grid.straightest();
        if direction.is_none() && depth > 0 {
            let halves = patch.halves(Direction::Along);
            for quarter in halves.iter().flat_map(|half| half.halves(Direction::Across)) {
                self.add(&quarter, points, Grid::of(&quarter, self), depth - 1, out);
            }
            return;
        }
        let lines = direction.map_or(Lines::Winding(Direction::Along), Lines::Plain);
        let heights = |x: &Node| [self.height(x), 1.0, 1.0];
        let Nodes { nodes, evaluations, .. } = out;
        *evaluations += seen(patch, lines, points, &heights, |x, factors| {
            nodes.push(WeightedNode { node: *x, weight: factors.iter().product() });
        });
    }
}

/// Heights of a patch over the plane on a uniform grid.
struct Grid {
    heights: [[f64; GRID_OF_HEIGHTS]; GRID_OF_HEIGHTS],
}

impl Grid {
    fn of(patch: &Patch, front: &Front) -> Self {
        let place = |k: usize| k as f64 / (GRID_OF_HEIGHTS - 1) as f64;
        let height = |i: usize, j: usize| front.height(&patch.node(place(i), place(j)));
        Self { heights: std::array::from_fn(|i| std::array::from_fn(|j| height(i, j))) }
    }

    fn all(&self) -> impl Iterator<Item = f64> {
        self.heights.iter().flatten().copied()
    }

    /// Lower bound of the heights, by second differences.
    fn low(&self) -> f64 {
        self.all().fold(f64::INFINITY, f64::min) - self.margin()
    }

    /// Upper bound of the heights, by second differences.
    fn high(&self) -> f64 {
        self.all().fold(f64::NEG_INFINITY, f64::max) + self.margin()
    }

    /// Margin beyond their range on the grid that heights may have: twice ⅛ of the second differences (scene
    /// length).
    fn margin(&self) -> f64 {
        0.25 * (self.bend(Direction::Along) + self.bend(Direction::Across))
    }

    fn lines(&self, direction: Direction) -> impl Iterator<Item = [f64; GRID_OF_HEIGHTS]> {
        let line = move |k: usize| match direction {
            Direction::Along => std::array::from_fn(|i| self.heights[i][k]),
            Direction::Across => self.heights[k],
        };
        (0..GRID_OF_HEIGHTS).map(line)
    }

    /// The largest second difference along lines of one direction.
    fn bend(&self, direction: Direction) -> f64 {
        let second = |w: &[f64]| (w[0] - 2.0 * w[1] + w[2]).abs();
        let bend = |line: [f64; GRID_OF_HEIGHTS]| line.windows(3).map(second).fold(0.0, f64::max);
        self.lines(direction).map(bend).fold(0.0, f64::max)
    }

    /// The direction with the least bent lines, among those whose lines all cross the plane once at most.
    fn straightest(&self) -> Option<Direction> {
        let level = LEVEL_OF_STEPS * self.all().map(f64::abs).fold(0.0, f64::max);
        let is_monotone = |line: [f64; GRID_OF_HEIGHTS]| {
            let steps = || line.windows(2).map(|w| w[1] - w[0]);
            steps().all(|step| step >= -level) || steps().all(|step| step <= level)
        };
        [Direction::Along, Direction::Across]
            .into_iter()
            .filter(|direction| self.lines(*direction).all(is_monotone))
            .min_by(|a, b| self.bend(*a).total_cmp(&self.bend(*b)))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use radiosity_geom::shapes::{Disk, FULL_TURN};
    use radiosity_geom::{DVec3, Rect, Surface};

    use super::*;

    /// A quarter of the unit disk in z = 0, from angle 0 on.
    fn quarter() -> Patch {
        let disk = Disk::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0, FULL_TURN).expect("a disk");
        let disk: Arc<dyn Surface> = Arc::new(disk);
        let start = disk.invert(DVec3::X).expect("it is on the rim")[0];
        Patch::curved(disk, &Rect { u: [start.min(0.0), start.min(0.0) + 0.5], v: [-1.0, 1.0] })
    }

    /// The part x > d of the quarter disk x² + y² < 1 has the area ½ (acos d − d √(1 − d²)), and ∫ (x − d) dA
    /// over it is ⅓ (1 − d²)^(3/2) minus d times that.
    #[test]
    fn segments_of_a_disk_have_their_area_and_moment() {
        for d in [0.5f64, 0.1, 0.01] {
            let quarter = quarter();
            let middle = quarter.node(0.5, 0.5).position;
            let normal = DVec3::new(middle.x.signum(), 0.0, 0.0);
            let front = Front::of(Plane { point: d * normal, normal });
            let root = (1.0 - d * d).sqrt();
            let area = 0.5 * (d.acos() - d * root);
            let moment = root.powi(3) / 3.0 - d * area;
            let parts = front.parts(&quarter, [10; 2], 1e-9);
            let nodes: Vec<WeightedNode> =
                parts.iter().flat_map(|part| front.nodes(part, [10; 2]).nodes).collect();
            let sum =
                |value: &dyn Fn(&Node) -> f64| nodes.iter().map(|x| x.weight * value(&x.node)).sum::<f64>();
            let found = [sum(&|_| 1.0), sum(&|x| front.height(x))];
            assert!((found[0] / area - 1.0).abs() < 1e-7, "{d}: {} for {area}", found[0]);
            assert!((found[1] / moment - 1.0).abs() < 1e-8, "{d}: {} for {moment}", found[1]);
        }
    }

    #[test]
    fn what_is_before_the_plane_keeps_its_rule() {
        let quarter = quarter();
        let far = Front::of(Plane { point: -2.0 * DVec3::X, normal: DVec3::X });
        assert!(!far.cuts(&quarter));
        let [cut, plain] = [far.nodes(&quarter, [3; 2]), Nodes::of(&quarter, [3; 2])].map(|rule| rule.nodes);
        assert!(
            cut.iter().zip(&plain).all(|(x, y)| x.node.position == y.node.position && x.weight == y.weight)
        );
        let behind = Front::of(Plane { point: 2.0 * DVec3::X, normal: DVec3::X });
        assert!(behind.cuts(&quarter) && behind.nodes(&quarter, [3; 2]).nodes.is_empty());
    }
}
