//! Patches and their borders, between which adjacency is decided.

use crate::{Aabb, Hit, PlanarRegion, Ray, Rect, Surface};
use glam::DVec3;

/// Part of a surface: a planar region, or the image of a parameter rectangle.
#[derive(Clone, Copy, Debug)]
pub enum Patch<'a> {
    /// A polygon with holes.
    Flat(&'a PlanarRegion),
    /// The image of a rectangle of a surface's parameters.
    Curved(&'a dyn Surface, Rect),
}

/// A curve along the border of a patch, with w from −1 at its start to 1 at its end; the patch lies to its
/// left.
#[derive(Clone, Copy, Debug)]
pub enum Border<'a> {
    /// A straight edge.
    Segment(DVec3, DVec3),
    /// A straight line in the parameters of a surface.
    Side(&'a dyn Surface, [f64; 2], [f64; 2]),
}

impl<'a> Patch<'a> {
    /// The whole of a surface.
    pub fn whole(surface: &'a dyn Surface) -> Patch<'a> {
        surface.region().map_or(Patch::Curved(surface, Rect::FULL), Patch::Flat)
    }

    /// A box around the patch.
    pub fn bounds(&self) -> Aabb {
        match self {
            Patch::Flat(region) => Aabb::around(region.outer().iter().copied()),
            Patch::Curved(surface, rect) => surface.bounds(rect),
        }
    }

    /// The curves around the patch, collapsed ones included. Flat: the edges of the outline, then those of
    /// each hole. Curved: v lowest, u highest, v highest, u lowest.
    pub fn borders(&self) -> Vec<Border<'a>> {
        match *self {
            Patch::Flat(region) => {
                let rings = std::iter::once(region.outer()).chain(region.holes().iter().map(Vec::as_slice));
                let edges = |ring: &'a [DVec3]| ring.iter().zip(ring.iter().cycle().skip(1));
                rings.flat_map(edges).map(|(p, q)| Border::Segment(*p, *q)).collect()
            }
            Patch::Curved(surface, rect) => {
                let c = rect.corners();
                (0..4).map(|k| Border::Side(surface, c[k], c[(k + 1) % 4])).collect()
            }
        }
    }

    /// The nearest point of the patch to `x`, for `x` close to it, and the unit normal there.
    pub(crate) fn foot(&self, x: DVec3) -> (DVec3, DVec3) {
        match self {
            Patch::Flat(region) => (region.nearest(x), region.normal()),
            Patch::Curved(surface, rect) => {
                let foot = surface.project(x);
                // Where a surface closes, a point of the seam has its foot on either side of it.
                let inside = rect.contains(foot.u, foot.v);
                let [u, v] = if inside { [foot.u, foot.v] } else { self.border_parameters(x) };
                let jet = surface.jet(u, v);
                (jet.position, jet.normal)
            }
        }
    }

    /// The parameters of the point of the borders nearest to `x`.
    fn border_parameters(&self, x: DVec3) -> [f64; 2] {
        let feet = self.borders().into_iter().map(|border| (border, border.nearest(x)));
        let feet = feet.map(|(border, w)| (border.point(w).distance_squared(x), border.parameters(w)));
        feet.min_by(|a, b| a.0.total_cmp(&b.0)).expect("a patch has borders").1
    }

    /// Points well inside the patch, with their normals; sampled without symmetry, since symmetric patches
    /// may cross at points of a symmetric sample, which would then tell nothing. Five each way are an
    /// arbitrary choice: a part that is shared and smaller than a cell between them is missed.
    pub(crate) fn inner_samples(&self) -> Vec<(DVec3, DVec3)> {
        const STEPS: [f64; 5] = [-0.83, -0.41, 0.03, 0.44, 0.81];
        match self {
            Patch::Flat(region) => {
                region.convex_pieces().iter().flat_map(|piece| scatter(piece, region.normal())).collect()
            }
            Patch::Curved(surface, rect) => {
                let grid = STEPS.into_iter().flat_map(|s| STEPS.map(|t| rect.at(s, t)));
                grid.map(|[u, v]| surface.jet(u, v)).map(|jet| (jet.position, jet.normal)).collect()
            }
        }
    }

    /// Curves that show whether the patch passes through another: its borders and, where it is curved, lines
    /// across it.
    pub(crate) fn lines(&self) -> Vec<Border<'a>> {
        let mut lines = self.borders();
        if let Patch::Curved(surface, rect) = *self {
            for w in [-0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75] {
                lines.push(Border::Side(surface, rect.at(w, -1.0), rect.at(w, 1.0)));
                lines.push(Border::Side(surface, rect.at(-1.0, w), rect.at(1.0, w)));
            }
        }
        lines
    }

    /// Where a ray meets the patch: the point and the unit normal there.
    pub(crate) fn pierced(&self, ray: &Ray) -> Option<(DVec3, DVec3)> {
        match self {
            Patch::Flat(region) => {
                let t =
                    (region.origin() - ray.origin).dot(region.normal()) / ray.direction.dot(region.normal());
                let x = ray.at(t);
                (ray.reaches(t) && region.contains(x)).then_some((x, region.normal()))
            }
            Patch::Curved(surface, rect) => {
                let mut rest = *ray;
                loop {
                    let Hit { t, u, v } = surface.intersect(&rest)?;
                    if rect.contains(u, v) {
                        let jet = surface.jet(u, v);
                        return Some((jet.position, jet.normal));
                    }
                    // Continue 1e-9 beyond a hit outside the rectangle, so that the search ends.
                    rest.range[0] = t + 1e-9 * (1.0 + t.abs());
                }
            }
        }
    }
}

impl Border<'_> {
    /// The point at w ∈ [−1, 1].
    pub fn point(&self, w: f64) -> DVec3 {
        match self {
            Border::Segment(p, q) => p.lerp(*q, 0.5 * (1.0 + w)),
            Border::Side(surface, ..) => {
                let [u, v] = self.parameters(w);
                surface.jet(u, v).position
            }
        }
    }

    /// The parameters of the surface at w; for a segment w itself and 0.
    pub fn parameters(&self, w: f64) -> [f64; 2] {
        match self {
            Border::Segment(..) => [w, 0.0],
            Border::Side(_, from, to) => [0, 1].map(|k| from[k] + 0.5 * (1.0 + w) * (to[k] - from[k])),
        }
    }

    /// The w of the point nearest to `x`.
    pub fn nearest(&self, x: DVec3) -> f64 {
        match self {
            Border::Segment(p, q) => {
                let along = (x - *p).dot(*q - *p) / (*q - *p).length_squared();
                2.0 * along.clamp(0.0, 1.0) - 1.0
            }
            Border::Side(surface, from, to) => {
                let distance = |w: &f64| self.point(*w).distance_squared(x);
                let start = (0..=16).map(|k| f64::from(k) / 8.0 - 1.0);
                let start =
                    start.min_by(|a, b| distance(a).total_cmp(&distance(b))).expect("seventeen places");
                let slope = |jet: crate::Jet| 0.5 * ((to[0] - from[0]) * jet.du + (to[1] - from[1]) * jet.dv);
                slide(start, x, |w| {
                    let [u, v] = self.parameters(w);
                    let jet = surface.jet(u, v);
                    (jet.position, slope(jet))
                })
            }
        }
    }

    /// The longest distance between five points of the curve: 0 for a collapsed side.
    pub(crate) fn extent(&self) -> f64 {
        let points = [-1.0, -0.5, 0.0, 0.5, 1.0].map(|w| self.point(w));
        points.iter().map(|p| p.distance(points[0])).fold(0.0, f64::max)
    }
}

/// Gauss–Newton steps along a curve given by point and derivative, kept within [−1, 1].
fn slide(start: f64, x: DVec3, curve: impl Fn(f64) -> (DVec3, DVec3)) -> f64 {
    let mut w = start;
    for _ in 0..30 {
        let (p, slope) = curve(w);
        let step = (x - p).dot(slope) / slope.length_squared().max(f64::MIN_POSITIVE);
        // Near a cusp of the curve a full step would leap over it: at most 0.25, an eighth of the curve, so
        // that 30 steps pass along all of it three times.
        let next = (w + step.clamp(-0.25, 0.25)).clamp(-1.0, 1.0);
        if (next - w).abs() < 1e-15 {
            break;
        }
        w = next;
    }
    w
}

/// Points inside a convex piece: its middle and points half-way from there to the corners.
fn scatter(piece: &[DVec3], normal: DVec3) -> Vec<(DVec3, DVec3)> {
    let middle = piece.iter().sum::<DVec3>() / piece.len() as f64;
    std::iter::once(middle).chain(piece.iter().map(|x| middle.lerp(*x, 0.49))).map(|x| (x, normal)).collect()
}
