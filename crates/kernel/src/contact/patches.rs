//! Contact of two patches: a common edge, a common corner, a cut, a tip, or none.
//!
//! The contact alone decides the rule. Rules exist for a whole common edge and for a common corner. Flat pairs
//! come already cut, so that contacts are one of these ([`crate::contact::clip`]). Where a patch is curved,
//! other contacts are reduced to them. A corner on a side of the other patch cuts that patch. A contact at a
//! tip, a side of the chart that is one point (the apex of a cone, the pole of a sphere), is halved towards the
//! tip until the rest carries nothing. An edge run through at different speeds goes by
//! [`crate::rules::common_edge::unequal_speed`].

use radiosity_elements::patch::{Direction, Patch};
use radiosity_geom::{Border, DVec3, distance_to_segment};

use crate::contact::gap::gap;

/// Contact of two patches, which are oriented inside as the rule needs them.
#[derive(Clone, Debug)]
pub enum Contact {
    /// A whole common edge: t = 0 in both charts, in the same sense, and if `matched` at equal speed.
    Edge {
        /// The patch of the receiver.
        p: Patch,
        /// The patch of the emitter.
        q: Patch,
        /// Whether s = u is the same point of the edge.
        matched: bool,
    },
    /// One common corner, at (0, 0) in both charts.
    Vertex(Patch, Patch),
    /// A corner lies on a side: where to cut either patch.
    Cut([Option<CutPlace>; 2]),
    /// At a collapsed side of either patch: the direction along which to halve it.
    Tip([Option<Direction>; 2]),
    /// No common point, with a lower bound of the distance; zero where no rule covers the contact.
    Apart(f64),
}

/// Where to cut a patch.
#[derive(Clone, Copy, Debug)]
pub struct CutPlace {
    /// The direction of the chart that is cut.
    pub direction: Direction,
    /// Parameter of the cut, strictly between 0 and 1.
    pub at: f64,
}

impl Contact {
    /// The contact of two flat patches that come already cut; points closer than `tolerance` coincide.
    pub fn of_flat(p: &Patch, q: &Patch, tolerance: f64) -> Self {
        let polygons = [p.polygon(), q.polygon()];
        match &shared_corners(&polygons, tolerance)[..] {
            [] => Self::Apart(gap(p, q)),
            [corner] if have_overlapping_sides(&polygons, *corner, tolerance) => Self::Apart(0.0),
            shared => Self::at(shared, [p, q], &polygons, |p, q| Some(Self::Edge { p, q, matched: true })),
        }
    }

    /// The contact of two patches of any kind; points closer than `tolerance` coincide.
    pub fn of(p: &Patch, q: &Patch, tolerance: f64) -> Self {
        let gap = gap(p, q);
        if gap > tolerance {
            return Self::Apart(gap);
        }
        let polygons = [p.polygon(), q.polygon()];
        let shared = shared_corners(&polygons, tolerance);
        let tips = [tip(p, shared.iter().map(|s| s.0)), tip(q, shared.iter().map(|s| s.1))];
        if tips.iter().any(Option::is_some) {
            return Self::Tip(tips);
        }
        let cuts = [place_on(p, &polygons[1], tolerance), place_on(q, &polygons[0], tolerance)];
        if cuts.iter().any(Option::is_some) {
            return Self::Cut(cuts);
        }
        Self::at(&shared, [p, q], &polygons, |p, q| edge(p, q, tolerance))
    }

    /// The contact at these shared corners of the patches' polygons; `edge` is that of a common side.
    fn at(
        shared: &[(usize, usize)],
        [p, q]: [&Patch; 2],
        polygons: &[Vec<DVec3>; 2],
        edge: impl FnOnce(Patch, Patch) -> Option<Self>,
    ) -> Self {
        let [m, n] = [polygons[0].len(), polygons[1].len()];
        match *shared {
            [(i, j)] => Self::Vertex(p.oriented(i, (i + 1) % m), q.oriented(j, (j + 1) % n)),
            [(i, j), (k, l)] if neighbours(i, k, m) && neighbours(j, l, n) => {
                edge(p.oriented(i, k), q.oriented(j, l)).unwrap_or(Self::Apart(0.0))
            }
            _ => Self::Apart(0.0),
        }
    }

    /// The distance of the patches, or a lower bound; 0 where they touch.
    pub fn gap(&self) -> f64 {
        if let Self::Apart(gap) = self { *gap } else { 0.0 }
    }

    /// Whether the patches have a point in common.
    pub fn touches(&self) -> bool {
        !matches!(self, Self::Apart(_))
    }
}

/// The pairs of corners of two polygons that coincide, by their indices.
fn shared_corners([p, q]: &[Vec<DVec3>; 2], tolerance: f64) -> Vec<(usize, usize)> {
    let pairs = (0..p.len()).flat_map(|i| (0..q.len()).map(move |j| (i, j)));
    pairs.filter(|(i, j)| p[*i].distance(q[*j]) <= tolerance).collect()
}

/// Whether two of `count` corners are the ends of one side.
fn neighbours(i: usize, j: usize, count: usize) -> bool {
    (i + 1) % count == j || (j + 1) % count == i
}

/// Whether two sides that leave the common corner `(i, j)` lie along each other.
fn have_overlapping_sides([p, q]: &[Vec<DVec3>; 2], (i, j): (usize, usize), tolerance: f64) -> bool {
    let around = |points: &[DVec3], k: usize| {
        let n = points.len();
        [points[(k + 1) % n], points[(k + n - 1) % n]]
    };
    let corner = p[i];
    let (sides_p, sides_q) = (around(p, i), around(q, j));
    sides_p.iter().any(|a| {
        sides_q.iter().any(|b| {
            distance_to_segment(*a, [corner, *b]) <= tolerance
                || distance_to_segment(*b, [corner, *a]) <= tolerance
        })
    })
}

/// The sides of a patch, from corner k to corner k + 1 of [`Patch::polygon`].
pub(crate) fn sides(patch: &Patch) -> Vec<Border<'_>> {
    match patch {
        Patch::Flat { .. } => {
            let corners = patch.polygon();
            (0..corners.len())
                .map(|k| Border::Segment(corners[k], corners[(k + 1) % corners.len()]))
                .collect()
        }
        Patch::Curved { surface, origin, along, across } => {
            let corners = [*origin, *origin + *along, *origin + *along + *across, *origin + *across];
            let side = |k: usize| {
                Border::Side(surface.as_ref(), corners[k].to_array(), corners[(k + 1) % 4].to_array())
            };
            (0..4).map(side).collect()
        }
    }
}

/// The direction along which to halve a curved patch that is touched at one of `corners`, if a side there is
/// collapsed.
fn tip(patch: &Patch, corners: impl Iterator<Item = usize> + Clone) -> Option<Direction> {
    let collapsed = collapsed(patch);
    corners.clone().find_map(|corner| {
        let side = [corner, (corner + 3) % 4].into_iter().find(|side| collapsed.contains(side))?;
        Some(if side % 2 == 0 { Direction::Across } else { Direction::Along })
    })
}

/// The sides of a curved patch that are single points, to 1e-12 of its extent.
pub fn collapsed(patch: &Patch) -> Vec<usize> {
    if patch.is_flat() {
        return Vec::new();
    }
    let extent = patch.extents().into_iter().fold(0.0, f64::max);
    let is_point = |side: &Border| {
        let points = [-1.0, 0.0, 1.0].map(|w| side.point(w));
        points[0].distance(points[1]).max(points[0].distance(points[2])) <= 1e-12 * extent
    };
    sides(patch).iter().enumerate().filter(|(_, side)| is_point(side)).map(|(k, _)| k).collect()
}

/// Where one of `corners` lies on a side of the patch, more than 1e-6 of the parameter away from its ends.
fn place_on(patch: &Patch, corners: &[DVec3], tolerance: f64) -> Option<CutPlace> {
    let triangle = patch.is_triangle();
    let on = |(k, side): (usize, &Border)| {
        let ends = [-1.0, 1.0].map(|w| side.point(w));
        // A side turns little: its points lie within twice its chord from both ends.
        let reach = 2.0 * ends[0].distance(ends[1]) + tolerance;
        corners.iter().find_map(|corner| {
            let apart = ends.iter().map(|end| end.distance(*corner));
            if apart.clone().any(|d| d <= tolerance) || apart.fold(0.0, f64::max) > reach {
                return None;
            }
            let w = side.nearest(*corner);
            if side.point(w).distance(*corner) > tolerance {
                return None;
            }
            let at = 0.5 * (1.0 + w);
            // Side 2 of a triangle is side 3 of its chart.
            let (direction, at) = match if triangle && k == 2 { 3 } else { k } {
                0 => (Direction::Along, at),
                1 => (Direction::Across, at),
                2 => (Direction::Along, 1.0 - at),
                _ => (Direction::Across, 1.0 - at),
            };
            (1e-6..1.0 - 1e-6).contains(&at).then_some(CutPlace { direction, at })
        })
    };
    sides(patch).iter().enumerate().find_map(on)
}

/// The contact of two patches oriented by the common ends of their sides t = 0, if these sides are one curve.
fn edge(p: Patch, q: Patch, tolerance: f64) -> Option<Contact> {
    // Inner points at which two edges are compared, beside their ends. Curves that agree in these points and
    // nowhere else would count as one edge; more points take longer for each pair of sides. An arbitrary
    // choice.
    const PLACES: [f64; 3] = [0.25, 0.5, 0.75];
    let at = |s: f64| p.node(s, 0.0).position;
    let matched = PLACES.iter().all(|s| at(*s).distance(q.node(*s, 0.0).position) <= tolerance);
    let one_curve = matched || {
        let (first, second) = (sides(&p), sides(&q));
        let lies_on = |a: &Border, b: &Border| {
            let mut points = PLACES.iter().map(|s| a.point(2.0 * s - 1.0));
            points.all(|x| b.point(b.nearest(x)).distance(x) <= tolerance)
        };
        lies_on(&first[0], &second[0]) && lies_on(&second[0], &first[0])
    };
    one_curve.then_some(Contact::Edge { p, q, matched })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quad(corners: [[f64; 3]; 4]) -> Patch {
        let corners = corners.map(DVec3::from_array);
        let normal = (corners[1] - corners[0]).cross(corners[3] - corners[0]).normalize();
        Patch::Flat { corners, normal }
    }

    #[test]
    fn hinge_is_an_edge_run_the_same_way() {
        let floor = quad([[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]]);
        let wall = quad([[0., 0., 1.], [1., 0., 1.], [1., 0., 0.], [0., 0., 0.]]);
        let Contact::Edge { p, q, .. } = Contact::of_flat(&floor, &wall, 1e-12) else {
            panic!("they share an edge")
        };
        for s in [0.0, 0.3, 1.0] {
            assert!(p.node(s, 0.0).position.distance(q.node(s, 0.0).position) < 1e-15);
        }
    }

    #[test]
    fn corner_and_gap() {
        let floor = quad([[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]]);
        let beyond = quad([[1., 1., 0.], [2., 1., 0.], [2., 1., 1.], [1., 1., 1.]]);
        assert!(matches!(Contact::of_flat(&floor, &beyond, 1e-12), Contact::Vertex(..)));
        let above = quad([[0.2, 0.2, 0.5], [0.8, 0.2, 0.7], [0.8, 0.8, 0.7], [0.2, 0.8, 0.5]]);
        let Contact::Apart(gap) = Contact::of_flat(&floor, &above, 1e-12) else { panic!("apart") };
        assert!((gap - 0.5).abs() < 1e-15);
    }

    #[test]
    fn partly_common_sides_are_no_vertex_contact() {
        let floor = quad([[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]]);
        let low = quad([[0., 0., 0.], [0.5, 0., 0.], [0.5, 0., 1.], [0., 0., 1.]]);
        let Contact::Apart(gap) = Contact::of_flat(&floor, &low, 1e-12) else { panic!("no rule covers it") };
        assert_eq!(gap, 0.0);
    }
}
