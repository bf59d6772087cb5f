//! Contact of two patches of which at least one is curved.
//!
//! Rules exist for a whole common edge and for a common corner. Other contacts are reduced to these. A corner
//! on a side of the other patch cuts that patch. A contact at a tip, a side of the chart that is one point
//! (the apex of a cone, the pole of a sphere), is halved towards the tip until the rest carries nothing. An
//! edge run through at different speeds goes by [`crate::rules::common_edge::unequal_speed`].

use radiosity_elements::patch::{Direction, Patch};
use radiosity_geom::{Border, DVec3};

use crate::contact::flat::{gap, neighbours, shared_corners};

/// Contact of two patches, which are oriented inside as the rule needs them.
#[derive(Clone, Debug)]
pub enum CurvedContact {
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

/// Contact of two patches; points closer than `tolerance` coincide.
pub fn classify(p: &Patch, q: &Patch, tolerance: f64) -> CurvedContact {
    let gap = gap(p, q);
    if gap > tolerance {
        return CurvedContact::Apart(gap);
    }
    let (corners_p, corners_q) = (p.polygon(), q.polygon());
    let shared = shared_corners(&corners_p, &corners_q, tolerance);
    let tips = [tip(p, shared.iter().map(|s| s.0)), tip(q, shared.iter().map(|s| s.1))];
    if tips.iter().any(Option::is_some) {
        return CurvedContact::Tip(tips);
    }
    let cuts = [place_on(p, &corners_q, tolerance), place_on(q, &corners_p, tolerance)];
    if cuts.iter().any(Option::is_some) {
        return CurvedContact::Cut(cuts);
    }
    match shared[..] {
        [(i, j)] => CurvedContact::Vertex(
            p.oriented(i, (i + 1) % corners_p.len()),
            q.oriented(j, (j + 1) % corners_q.len()),
        ),
        [(i, j), (k, l)] if neighbours(i, k, corners_p.len()) && neighbours(j, l, corners_q.len()) => {
            edge(p.oriented(i, k), q.oriented(j, l), tolerance).unwrap_or(CurvedContact::Apart(0.0))
        }
        _ => CurvedContact::Apart(0.0),
    }
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
fn edge(p: Patch, q: Patch, tolerance: f64) -> Option<CurvedContact> {
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
    one_curve.then_some(CurvedContact::Edge { p, q, matched })
}
