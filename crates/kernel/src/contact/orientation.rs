//! Mutual orientation of two patches: whether they face each other wholly, partly or not at all.
//!
//! The kernel vanishes where one of
//!
//! ```text
//! f(x, y) = n_x·(y − x) ,   f(y, x) = n_y·(x − y)
//! ```
//!
//! is negative, and is smooth only on patches where neither changes sign. f is sampled on uniform grids over
//! both patches. Between the samples it differs from the multilinear interpolant by at most Σ_d h_d²/8
//! max|∂_d² f|. With second differences Δ for h²∂², a point C amid the other patch, and R the distance of its
//! farthest sample from C,
//!
//! ```text
//! |f − interpolant| ≤ ⅛ Σ_d { |Δ_d n| R + |Δ_d n·(C − x)| + |Δ_d y| } ,
//! ```
//!
//! Twice this bound is used, because the differences are themselves sampled. A sign is certain only beyond
//! it; everything else is `Partly`, for which the rules are right though slower. Where patches touch, f
//! vanishes and no margin can be kept: there a denser grid decides alone.
//!
//! About δ² of the most that two patches can exchange comes at cosines below δ. If no cosine is below −δ, the
//! pairs of points that do not see each other matter as little; a slightly bent wall and its floor are such a
//! pair. They count as facing each other wholly if δ² is below `SLIGHT` times the accuracy.

use radiosity_elements::patch::{Node, Patch};
use radiosity_geom::DVec3;

use crate::tolerances::LEVEL_OF_SAMPLES;

/// Samples per direction on a curved patch that is apart from the other, with the margin. With fewer the
/// margin is wider and more pairs count as `Partly`; the time grows with their fourth power.
const APART: usize = 5;
/// Samples per direction on a curved patch that touches the other, without a margin: more than apart, since a
/// change of sign between samples is missed.
const TOUCHING: usize = 8;
/// Largest δ² of points behind each other's tangent planes, as a share of ε: a twentieth of the error that is
/// allowed. With a larger value that error would be noticed; with a smaller one pairs that are slightly bent
/// would go by the slower rules for horizons.
const SLIGHT: f64 = 0.05;

/// Mutual orientation of two patches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Facing {
    /// Every point of either lies in front of all tangent planes of the other.
    Wholly,
    /// Perhaps some points do not.
    Partly,
    /// All of one lies behind all tangent planes of the other.
    Away,
}

/// Mutual orientation of two different patches; `touching` if they have a point in common. Relative errors up
/// to `eps` are allowed.
pub fn facing(p: &Patch, q: &Patch, touching: bool, eps: f64) -> Facing {
    if p.is_flat() && q.is_flat() {
        return Facing::Wholly;
    }
    let count = if touching { TOUCHING } else { APART };
    let (a, b) = (Samples::of(p, count), Samples::of(q, count));
    let margins = if touching { [0.0; 2] } else { [a.margin(&b), b.margin(&a)] };
    let level = LEVEL_OF_SAMPLES * a.extent().max(b.extent());
    let verdict = verdict([a.heights(&b), b.heights(&a)], margins, level);
    let least = -(SLIGHT * eps).sqrt();
    let is_slight = || a.rises_above(&b, margins[0], least) && b.rises_above(&a, margins[1], least);
    if verdict == Facing::Partly && is_slight() { Facing::Wholly } else { verdict }
}

/// Whether a point of a patch may have some of a ball before it: heights of the centre over tangent planes,
/// with the margin of patches apart.
pub(crate) fn may_face_ball(patch: &Patch, center: DVec3, radius: f64) -> bool {
    let samples = Samples::of(patch, APART);
    let height = |x: &Node| x.normal.dot(center - x.position);
    let margin = 0.25 * samples.second_differences(|a, b, c| (height(a) - 2.0 * height(b) + height(c)).abs());
    samples.nodes.iter().any(|x| height(x) + radius + margin > 0.0)
}

/// Orientation of a patch to itself: wholly if concave, away if convex or flat.
pub fn own(patch: &Patch) -> Facing {
    if patch.is_flat() {
        return Facing::Away;
    }
    let samples = Samples::of(patch, TOUCHING);
    verdict([samples.heights(&samples); 2], [0.0; 2], LEVEL_OF_SAMPLES * samples.extent())
}

fn verdict(ranges: [[f64; 2]; 2], margins: [f64; 2], level: f64) -> Facing {
    let sides = [0, 1].map(|k| [ranges[k][0] - margins[k], ranges[k][1] + margins[k]]);
    if sides.iter().any(|[_, high]| *high <= level) {
        Facing::Away
    } else if sides.iter().all(|[low, _]| *low >= -level) {
        Facing::Wholly
    } else {
        Facing::Partly
    }
}

/// A uniform grid of nodes over a patch.
struct Samples {
    nodes: Vec<Node>,
    /// Nodes a direction.
    count: usize,
    flat: bool,
}

impl Samples {
    fn of(patch: &Patch, count: usize) -> Self {
        let count = if patch.is_flat() { 2 } else { count };
        let place = |k: usize| k as f64 / (count - 1) as f64;
        let nodes = (0..count * count).map(|k| patch.node(place(k / count), place(k % count))).collect();
        Self { nodes, count, flat: patch.is_flat() }
    }

    /// Least and largest height of the other's samples over all tangent planes.
    fn heights(&self, other: &Self) -> [f64; 2] {
        let planes = if self.flat { &self.nodes[..1] } else { &self.nodes[..] };
        let heights = planes
            .iter()
            .flat_map(|x| other.nodes.iter().map(move |y| x.normal.dot(y.position - x.position)));
        heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], h| [low.min(h), high.max(h)])
    }

    /// Whether all samples of the other, lowered by `margin`, are at a sine of at least `least` above all
    /// tangent planes.
    fn rises_above(&self, other: &Self, margin: f64, least: f64) -> bool {
        let planes = if self.flat { &self.nodes[..1] } else { &self.nodes[..] };
        planes.iter().all(|x| {
            other.nodes.iter().all(|y| {
                let offset = y.position - x.position;
                x.normal.dot(offset) - margin >= least * offset.length()
            })
        })
    }

    /// Margin beyond the range of the samples that the heights of the other over the tangent planes may have:
    /// twice ⅛ of the second differences (scene length).
    fn margin(&self, other: &Self) -> f64 {
        let (center, reach) = other.ball();
        let bend = |x: &Node| (x.normal, x.normal.dot(center - x.position));
        let own = self.second_differences(|a, b, c| {
            let [(na, ha), (nb, hb), (nc, hc)] = [a, b, c].map(bend);
            (na - 2.0 * nb + nc).length() * reach + (ha - 2.0 * hb + hc).abs()
        });
        let theirs =
            other.second_differences(|a, b, c| (a.position - 2.0 * b.position + c.position).length());
        0.25 * (own + theirs)
    }

    /// The largest second difference in either direction, summed over both.
    fn second_differences(&self, difference: impl Fn(&Node, &Node, &Node) -> f64) -> f64 {
        let n = self.count;
        let at = |i: usize, j: usize| &self.nodes[i * n + j];
        let (mut along, mut across) = (0.0f64, 0.0f64);
        for i in 1..n - 1 {
            for j in 0..n {
                along = along.max(difference(at(i - 1, j), at(i, j), at(i + 1, j)));
                across = across.max(difference(at(j, i - 1), at(j, i), at(j, i + 1)));
            }
        }
        along + across
    }

    fn ball(&self) -> (DVec3, f64) {
        let center = self.nodes.iter().map(|x| x.position).sum::<DVec3>() / self.nodes.len() as f64;
        (center, self.nodes.iter().map(|x| x.position.distance(center)).fold(0.0, f64::max))
    }

    fn extent(&self) -> f64 {
        2.0 * self.ball().1
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use radiosity_geom::shapes::{Bezier, Bilinear, Cylinder, FULL_TURN, Sphere, Torus};
    use radiosity_geom::{Flipped, Rect, Surface};

    use super::*;

    const EXACTLY: f64 = 0.0;

    fn patch(surface: impl Surface + 'static, u: [f64; 2], v: [f64; 2]) -> Patch {
        Patch::curved(Arc::new(surface), &Rect { u, v })
    }

    fn ball(center: DVec3) -> Sphere {
        Sphere::new(center, 1.0, DVec3::Z, [-1.0, 1.0], FULL_TURN).expect("a sphere")
    }

    #[test]
    fn inside_and_outside_of_a_sphere() {
        let outside = ball(DVec3::ZERO);
        let inside = Flipped::new(Box::new(outside.clone()));
        assert_eq!(own(&patch(outside, [0.0, 0.4], [-0.2, 0.5])), Facing::Away);
        assert_eq!(own(&patch(inside, [0.0, 0.4], [-0.2, 0.5])), Facing::Wholly);
    }

    #[test]
    fn the_inner_side_of_a_ring_faces_itself_partly() {
        let ring = Torus::new(DVec3::ZERO, DVec3::Z, 2.0, 0.5, FULL_TURN, FULL_TURN).expect("a ring");
        // The tube's angle runs from 0 at v = −1; π is the inner side.
        assert_eq!(own(&patch(ring.clone(), [0.0, 0.2], [-0.1, 0.1])), Facing::Partly);
        assert_eq!(own(&patch(ring, [0.0, 0.2], [0.8, 1.0])), Facing::Away);
    }

    #[test]
    fn two_balls_face_with_one_side_only() {
        let quarter = |x: f64, u: [f64; 2]| patch(ball(DVec3::new(x, 0.0, 0.0)), u, [-0.3, 0.3]);
        // Angle 0 is at u = −1, angle π at u = 0.
        let right = quarter(9.0, [-0.1, 0.1]);
        assert_eq!(facing(&quarter(0.0, [-1.0, -0.9]), &right, false, EXACTLY), Facing::Wholly);
        assert_eq!(facing(&quarter(0.0, [-0.1, 0.1]), &right, false, EXACTLY), Facing::Away);
        assert_eq!(facing(&quarter(0.0, [-0.7, -0.3]), &right, false, EXACTLY), Facing::Partly);
    }

    /// Points of the unit ball at the latitude ψ, on the side of another one, 2.1 aside and 1 below, have some of it
    /// above their horizons where 2.1 cos ψ > sin ψ: below 64.5°, v = 0.717.
    #[test]
    fn a_border_that_faces_a_ball_is_noticed() {
        let cap = |low: f64| patch(ball(DVec3::ZERO), [-0.5, 0.5], [low, 1.0]);
        let aside = cap(0.7).node(0.5, 0.0).position.with_z(0.0).normalize();
        let center = 2.1 * aside - DVec3::Z;
        assert!(may_face_ball(&cap(0.7), center, 1.0));
        assert!(!may_face_ball(&cap(0.9), center, 1.0));
    }

    #[test]
    fn a_bump_between_the_corners_is_noticed() {
        // Flat at its border, which a low observer sees from the front; the bump faces away from the observer
        // between.
        let height = |i: usize, j: usize| if (1..3).contains(&i) && (1..3).contains(&j) { 1.0 } else { 0.0 };
        let points = std::array::from_fn(|i| {
            std::array::from_fn(|j| DVec3::new(i as f64 / 3.0, j as f64 / 3.0, height(i, j)))
        });
        let bump = patch(Bezier::new(points).expect("a sheet"), [-1.0, 1.0], [-1.0, 1.0]);
        let corners = [[3., 0., 0.1], [3., 1., 0.1], [3., 1., 0.2], [3., 0., 0.2]].map(DVec3::from_array);
        let observer = Patch::Flat { corners, normal: -DVec3::X };
        assert_eq!(facing(&bump, &observer, false, EXACTLY), Facing::Partly);
    }

    #[test]
    fn sectors_of_a_tube_face_inwards() {
        let tube = Cylinder::new(DVec3::ZERO, DVec3::Z, 1.0, FULL_TURN).expect("a tube");
        let inside = Flipped::new(Box::new(tube));
        let inside: Arc<dyn Surface> = Arc::new(inside);
        let sector = |u| Patch::curved(Arc::clone(&inside), &Rect { u, v: [-1.0, 1.0] });
        assert_eq!(facing(&sector([-0.5, 0.0]), &sector([0.0, 0.5]), true, EXACTLY), Facing::Wholly);
    }

    #[test]
    fn a_wall_bent_a_little_faces_its_floor_as_far_as_the_accuracy_goes() {
        let corners = [[0., 0., 0.], [0., 1., 0.], [0., 1., 1.], [-0.005, 0., 1.]].map(DVec3::from_array);
        let wall = Bilinear::new(corners).expect("a wall");
        let floor = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]].map(DVec3::from_array);
        let floor = Patch::Flat { corners: floor, normal: DVec3::Z };
        let wall = patch(wall, [-1.0, 1.0], [-1.0, 1.0]);
        assert_eq!(wall.node(0.5, 0.5).normal.x.signum(), 1.0);
        assert_eq!(facing(&wall, &floor, true, 1e-2), Facing::Wholly);
        assert_eq!(facing(&wall, &floor, true, 1e-6), Facing::Partly);
    }
}
