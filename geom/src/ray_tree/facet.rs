//! A flat surface of three or four corners, ready for rays in double precision.
//!
//! With the affine parameters X(u, v) = m + u a + v b of the surface, n its normal and a*, b* the dual
//! vectors, the ray o + t w meets the plane at t = (m − o) · n / (w · n), at u = (x − m) · a*,
//! v = (x − m) · b*: the formulas of the surfaces themselves. A convex outline is the meet of half-planes p
//! u + q v ≤ r. Inside of all by [`BORDER`] is a hit, outside of one by that is none; what lies between, on
//! the border within roundings and the tolerance at seams, the surface has to tell.

use crate::{Hit, Jet, PlanarRegion, Ray, Surface};
use glam::DVec3;

/// Half the breadth of a border, in units of the outline's extent: some times the tolerance at seams.
const BORDER: f64 = 1e-8;

/// Corners farther off the places that affine parameters give them, as a part of their coordinates, belong to
/// other parameters.
const AFFINE: f64 = 1e-14;

const SIDES: usize = 4;

/// A convex polygon of three or four corners.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facet {
    center: DVec3,
    normal: DVec3,
    /// a*, b*.
    dual: [DVec3; 2],
    /// p, q, r of each side, p and q such that r − p u − q v is a distance in units of the extent.
    sides: [[f64; 3]; SIDES],
}

/// Meeting of a ray with a facet, as far as the facet can tell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Meeting {
    None,
    /// The hit, and whether the front is met.
    At(Hit, bool),
    /// The ray meets the border: only the surface can tell.
    Doubtful,
}

impl Facet {
    /// The facet that a surface is; none of other surfaces.
    pub(super) fn of(surface: &dyn Surface) -> Option<Facet> {
        let region = surface.region()?;
        let corners = region.outer();
        let jet = surface.jet(0.0, 0.0);
        let is_simple =
            corners.len() <= SIDES && region.holes().is_empty() && region.convex_pieces().len() == 1;
        if !is_simple || !has_affine_parameters(surface, &jet, region.extent()) {
            return None;
        }
        let cross = jet.du.cross(jet.dv);
        let scale = 1.0 / cross.length_squared();
        let dual = [scale * jet.dv.cross(cross), scale * cross.cross(jet.du)];
        Some(Facet { center: jet.position, normal: jet.normal, dual, sides: sides(region, &jet, dual) })
    }

    /// Where the ray meets the facet.
    #[inline]
    pub(super) fn meet(&self, ray: &Ray) -> Meeting {
        let closing = ray.direction.dot(self.normal);
        let t = (self.center - ray.origin).dot(self.normal) / closing;
        // Of a ray along the plane t is infinite, or no number.
        if !t.is_finite() || !ray.reaches(t) {
            return Meeting::None;
        }
        let from = ray.at(t) - self.center;
        let [u, v] = self.dual.map(|dual| from.dot(dual));
        let inward = self.sides.map(|[p, q, r]| r - p * u - q * v);
        let least = inward[0].min(inward[1]).min(inward[2].min(inward[3]));
        if least >= BORDER {
            Meeting::At(Hit { t, u: u.clamp(-1.0, 1.0), v: v.clamp(-1.0, 1.0) }, closing < 0.0)
        } else if least >= -BORDER {
            Meeting::Doubtful
        } else {
            Meeting::None
        }
    }
}

/// Whether the corners of the parameter square are where the tangents in the middle point to.
fn has_affine_parameters(surface: &dyn Surface, jet: &Jet, extent: f64) -> bool {
    let far = jet.position.abs().max_element() + extent;
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].iter().all(|[u, v]| {
        let corner = surface.jet(*u, *v).position;
        corner.distance(jet.position + *u * jet.du + *v * jet.dv) <= AFFINE * far
    })
}

/// The half-planes of the outline, the last one twice for a triangle.
fn sides(region: &PlanarRegion, jet: &Jet, dual: [DVec3; 2]) -> [[f64; 3]; SIDES] {
    let corners = region.outer();
    std::array::from_fn(|k| {
        let (from, to) = (corners[k % corners.len()], corners[(k + 1) % corners.len()]);
        // The unit vector out of the region, across the side.
        let outward = (to - from).cross(region.normal()).normalize() / region.extent();
        let [p, q] = [jet.du, jet.dv].map(|axis| axis.dot(outward));
        let [u, v] = dual.map(|dual| (from - jet.position).dot(dual));
        [p, q, p * u + q * v]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{Bilinear, Polygon, Triangle};
    use crate::{Motion, Placed};
    use proptest::prelude::*;

    fn corners() -> [DVec3; 4] {
        [[0.0, 0.0], [2.0, 0.0], [1.5, 1.0], [0.0, 1.2]].map(|[x, y]| DVec3::new(x, y, 0.5 * y))
    }

    #[test]
    fn surfaces_of_other_parameters_are_no_facets() {
        let notched = [[0.0, 0.0], [2.0, 0.0], [0.5, 0.5], [0.0, 2.0]].map(|[x, y]| DVec3::new(x, y, 1.0));
        assert!(Facet::of(&Polygon::new(corners().to_vec(), vec![]).expect("a quadrilateral")).is_some());
        assert!(Facet::of(&Bilinear::new(corners()).expect("a quadrilateral")).is_none());
        assert!(Facet::of(&Polygon::new(notched.to_vec(), vec![]).expect("an arrowhead")).is_none());
    }

    #[test]
    fn rays_along_the_plane_are_no_hits() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let facet = Facet::of(&Polygon::new(square.to_vec(), vec![]).expect("a square")).expect("a facet");
        for height in [0.0, 1e-9, -1e-300] {
            assert_eq!(facet.meet(&Ray::new(DVec3::new(0.5, 0.5, height), DVec3::X)), Meeting::None);
        }
    }

    proptest! {
        /// Where the facet is sure, the surface agrees.
        #[test]
        fn facets_agree_with_their_surfaces(
            turn in prop::array::uniform4(-1.0..1.0_f64), scale in -3.0..3.0_f64, is_triangle in prop::bool::ANY,
            rays in prop::collection::vec(prop::array::uniform5(-1.1..1.1_f64), 30),
        ) {
            let [p, q, r, s] = corners();
            let flat: Box<dyn Surface> = match is_triangle {
                true => Box::new(Triangle::new([p, q, r]).expect("a triangle")),
                false => Box::new(Polygon::new(vec![p, q, r, s], vec![]).expect("a quadrilateral")),
            };
            let [x, y, z, angle] = turn;
            let scale = 10.0_f64.powf(scale);
            let motion = Motion::new(3.0 * scale * DVec3::new(z, x, y), DVec3::new(x, y, z), 3.0 * angle, scale);
            let surface = Placed::new(flat, motion.expect("a motion"));
            let facet = Facet::of(&surface).expect("it is flat");
            for [x, y, z, u, v] in rays {
                let target = surface.jet(u, v).position;
                let ray = Ray::segment(target + scale * DVec3::new(x, y, z), target - scale * DVec3::new(z, x, y));
                let hit = surface.intersect(&ray);
                match facet.meet(&ray) {
                    Meeting::None => prop_assert_eq!(hit, None),
                    Meeting::Doubtful => {}
                    Meeting::At(Hit { t, u, v }, front) => {
                        let hit = hit.expect("the facet is sure");
                        prop_assert!((hit.t - t).abs() < 1e-11 && (hit.u - u).abs() < 1e-9 && (hit.v - v).abs() < 1e-9);
                        prop_assert_eq!(front, surface.jet(u, v).normal.dot(ray.direction) < 0.0);
                    }
                }
            }
        }
    }
}
