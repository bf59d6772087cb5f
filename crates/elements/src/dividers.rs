//! Dividers: flat surfaces that stand on another flat one and part its light, as a partition does that of a floor.
//!
//! Light differs by a step from one side of the foot of a partition to the other. Polynomials over both sides miss it
//! by as much, whatever their order: of a dark room beside a bright one they tell the light of neither. So a surface
//! is cut along the feet that reach across most of it, at constant u or v.

use radiosity_geom::{Aabb, Bvh, DVec3, LOOSE, PlanarRegion, Rect, Surface};
use radiosity_scene::Scene;

/// Part of the width of a surface that feet on one line reach across at least. Chosen: light beside a shorter one is
/// even again over much of an element.
const ACROSS: f64 = 0.5;

/// Height of a divider over the square root of the area of the surface that it stands on, at least. Chosen: a lower
/// one parts the light beside it alone.
const HIGH: f64 = 0.1;

/// Least part of the width of a surface that is cut off. Chosen: a narrower one carries little.
const LEAST_PART: f64 = 0.05;

/// Width of the parameters of a surface, [−1, 1].
const WIDTH: f64 = 2.0;

/// The flat surfaces of a scene, as dividers of each other.
#[derive(Debug)]
pub(super) struct Dividers<'a> {
    scene: &'a Scene,
    /// Index of each.
    flat: Vec<usize>,
    tree: Bvh,
}

/// Lines of constant u, and of constant v, at which a surface is divided, ascending.
pub(super) type Lines = [Vec<f64>; 2];

/// The foot of a divider: a part of a line of constant u or v.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot {
    /// The parameter that is constant, 0 or 1.
    pub across: usize,
    pub at: f64,
    /// Range of the other parameter.
    pub span: [f64; 2],
}

impl<'a> Dividers<'a> {
    pub(super) fn of(scene: &'a Scene) -> Self {
        let shape = |index: &usize| &scene.surfaces[*index].shape;
        let flat: Vec<usize> =
            (0..scene.surfaces.len()).filter(|index| shape(index).region().is_some()).collect();
        let tree = Bvh::build(&flat.iter().map(|index| around(&**shape(index))).collect::<Vec<_>>());
        Self { scene, flat, tree }
    }

    /// Where the surface of this index is divided.
    pub(super) fn lines(&self, surface: usize) -> Lines {
        let shape = &*self.scene.surfaces[surface].shape;
        let Some(region) = shape.region() else { return Lines::default() };
        let near = self.tree.near(&around(shape)).into_iter().map(|place| self.flat[place]);
        let others = near.filter(|other| *other != surface);
        let standing = others.filter_map(|other| self.scene.surfaces[other].shape.region());
        let tall = standing.filter(|other| {
            let heights = other.corners().into_iter().map(|corner| region.height(corner));
            heights.fold(0.0, f64::max) > HIGH * region.area().sqrt()
        });
        let feet: Vec<Foot> = tall.flat_map(|other| feet(shape, region, other)).collect();
        [0, 1].map(|across| lines_of(feet.iter().filter(|foot| foot.across == across).copied().collect()))
    }
}

/// The ends of equal parts with these lines among them: ends that are nearer to a line than half of a part are left
/// out, so that one line adds no part to two.
pub(super) fn divided(ends: &[f64], lines: &[f64]) -> Vec<f64> {
    let half = 0.5 * (ends[1] - ends[0]);
    let is_kept = |end: &f64| end.abs() >= 1.0 || lines.iter().all(|line| (end - line).abs() >= half);
    let mut all: Vec<f64> = ends.iter().copied().filter(is_kept).chain(lines.iter().copied()).collect();
    all.sort_by(f64::total_cmp);
    all
}

/// The box around a surface, and what touches it.
fn around(shape: &dyn Surface) -> Aabb {
    let bounds = shape.bounds(&Rect::FULL);
    bounds.inflate(LOOSE * bounds.diagonal())
}

/// The feet of `other` on a surface.
fn feet(shape: &dyn Surface, region: &PlanarRegion, other: &PlanarRegion) -> Vec<Foot> {
    let is_on = |x: &DVec3| region.height(*x).abs() <= LOOSE * region.extent();
    let rings = std::iter::once(other.outer()).chain(other.holes().iter().map(Vec::as_slice));
    let edges = rings.flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
    let on = edges.filter(|(a, b)| is_on(a) && is_on(b));
    on.filter_map(|(a, b)| foot(shape, [*a, *b])).collect()
}

/// The foot between the feet of two points on a surface; None where it is skew to its parameters.
pub(super) fn foot(shape: &dyn Surface, ends: [DVec3; 2]) -> Option<Foot> {
    let [a, b] = ends.map(|end| shape.project(end)).map(|foot| [foot.u, foot.v]);
    let across = (0..2).find(|across| (a[*across] - b[*across]).abs() <= LOOSE)?;
    let along = 1 - across;
    let span = [a[along].min(b[along]), a[along].max(b[along])];
    Some(Foot { across, at: 0.5 * (a[across] + b[across]), span })
}

/// The lines on which these feet reach across most of a surface, well apart from each other and from its sides.
fn lines_of(mut feet: Vec<Foot>) -> Vec<f64> {
    feet.sort_by(|a, b| a.at.total_cmp(&b.at).then(a.span[0].total_cmp(&b.span[0])));
    let mut lines: Vec<f64> = Vec::new();
    for own in feet.chunk_by(|a, b| b.at - a.at <= LOOSE) {
        let at = own[0].at;
        let before = lines.last().copied().unwrap_or(-1.0);
        let is_apart = at - before >= LEAST_PART * WIDTH && 1.0 - at >= LEAST_PART * WIDTH;
        if is_apart && covered(own) >= ACROSS * WIDTH {
            lines.push(at);
        }
    }
    lines
}

/// Length that feet on one line cover together.
fn covered(feet: &[Foot]) -> f64 {
    let mut spans: Vec<[f64; 2]> = feet.iter().map(|foot| foot.span).collect();
    spans.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (mut length, mut end) = (0.0, -1.0_f64);
    for [low, high] in spans {
        length += (high - low.max(end)).max(0.0);
        end = end.max(high);
    }
    length
}

#[cfg(test)]
mod tests {
    use radiosity_scene::Source;

    use super::*;

    fn lines(surfaces: &str) -> Lines {
        let floor = r#"
            { name = "floor", material = "grey",
              parallelogram = { origin = [0, 0, 0], edge1 = [4, 0, 0], edge2 = [0, 2, 0] } },"#;
        let text = format!(
            "bands = [\"grey\"]\nmaterials = {{ grey = {{ reflectance = 0.5 }} }}\nsurfaces = [{floor}{surfaces}]\n"
        );
        let scene = radiosity_language::read(&Source::new("floor.toml", &text)).expect("it is a scene");
        Dividers::of(&scene).lines(0)
    }

    /// A wall over the line from y = `start` to 2 at x = `x`.
    fn wall(x: f64, start: f64, height: f64) -> String {
        format!(
            r#" {{ name = "wall{x}", material = "grey", two_sided = true, parallelogram = {{
                 origin = [{x}, {start}, 0], edge1 = [0, {}, 0], edge2 = [0, 0, {height}] }} }},"#,
            2.0 - start
        )
    }

    #[test]
    fn a_partition_divides_the_floor_where_it_stands() {
        let [u, v] = lines(&wall(3.0, 0.0, 1.0));
        assert!(u.len() == 1 && (u[0] - 0.5).abs() < 1e-12 && v.is_empty(), "{u:?} {v:?}");
        // One with a door, and both walls of a corridor.
        assert_eq!(lines(&wall(3.0, 0.9, 1.0))[0].len(), 1);
        assert_eq!(lines(&(wall(1.0, 0.0, 1.0) + &wall(3.0, 0.0, 1.0)))[0].len(), 2);
    }

    #[test]
    fn short_and_low_dividers_and_those_at_a_side_part_nothing() {
        for (x, start, height) in [(3.0, 1.1, 1.0), (3.0, 0.0, 0.1), (3.9, 0.0, 1.0), (3.0, 0.0, -1.0)] {
            assert_eq!(lines(&wall(x, start, height)), Lines::default(), "{x} {start} {height}");
        }
    }

    #[test]
    fn a_line_takes_the_place_of_the_break_beside_it() {
        assert_eq!(divided(&[-1.0, 0.0, 1.0], &[0.25]), [-1.0, 0.25, 1.0]);
        assert_eq!(divided(&[-1.0, 0.0, 1.0], &[0.75]), [-1.0, 0.0, 0.75, 1.0]);
        assert_eq!(divided(&[-1.0, 1.0], &[-0.5]), [-1.0, -0.5, 1.0]);
        assert_eq!(divided(&[-1.0, -0.5, 0.0, 0.5, 1.0], &[]), [-1.0, -0.5, 0.0, 0.5, 1.0]);
    }
}
