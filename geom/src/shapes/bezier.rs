//! Bicubic Bézier patch: X(u, v) = Σᵢⱼ Bᵢ(s) Bⱼ(t) Pᵢⱼ, s = ½(1 + u), t = ½(1 + v), B the cubic Bernstein
//! polynomials.
//!
//! Front x_u × x_v. Area by quadrature. Range: any control points that span an area; an edge may be collapsed
//! to a point, where the normal is the limit of X_u × X_v over the distance from the edge, ±X_u × X_uv or
//! ±X_uv × X_v.
//!
//! Ray: seen along it, the control points form a planar net, whose zeros are bracketed.

use super::check_finite;
use super::net::{check_area, jet, part, sample};
use super::tiles::Tiles;
use crate::{Aabb, Hit, Jet, Ray, Rect, ShapeError, Surface, TangentPlanes};
use glam::DVec3;

/// A bicubic patch, as in the Utah teapot.
#[derive(Clone, Debug)]
pub struct Bezier {
    points: [[DVec3; 4]; 4],
    tiles: Tiles<DVec3>,
}

impl Bezier {
    /// The patch with control points `points[i][j]`, i along u, j along v.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, points that span no area or turn back in a plane.
    pub fn new(points: [[DVec3; 4]; 4]) -> Result<Bezier, ShapeError> {
        for x in points.as_flattened() {
            check_finite("points", *x)?;
        }
        check_area("points", |s, t| sample(&points, s, t))?;
        Ok(Bezier { points, tiles: Tiles::new(&points) })
    }
}

impl Surface for Bezier {
    fn jet(&self, u: f64, v: f64) -> Jet {
        jet(u, v, |u, v| sample(&self.points, 0.5 * (1.0 + u), 0.5 * (1.0 + v)))
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        // The control points of four parts keep closer to the patch than those of the whole.
        Aabb::around(
            rect.quarters()
                .into_iter()
                .flat_map(|quarter| part(&self.points, &quarter).into_iter().flatten()),
        )
    }

    fn tangent_planes(&self) -> Option<TangentPlanes> {
        Some(TangentPlanes::new(&self.points.map(|row| row.map(|p| p.extend(1.0)))))
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        self.tiles.nearest(ray)
    }

    fn occludes(&self, ray: &Ray) -> bool {
        self.tiles.any(ray)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bilinear patch through four corners, raised to degree three.
    fn bilinear([p, q, r, s]: [DVec3; 4]) -> [[DVec3; 4]; 4] {
        let third = |k: usize| k as f64 / 3.0;
        std::array::from_fn(|i| {
            std::array::from_fn(|j| p.lerp(q, third(i)).lerp(s.lerp(r, third(i)), third(j)))
        })
    }

    #[test]
    fn collapsed_edges_have_normals() {
        let (top, x, y) = (DVec3::Z, DVec3::X, DVec3::Y);
        // A quarter tent: edge i = 0 collapsed to the top.
        let points = bilinear([top, x, y, top]);
        let tent = Bezier::new(points).unwrap();
        let outward = DVec3::ONE.normalize();
        for v in [-1.0, -0.3, 1.0] {
            assert!(tent.jet(-1.0, v).normal.distance(outward) < 1e-14);
            assert_eq!(tent.jet(-1.0, v).area, 0.0);
        }
        let mut mirrored = points;
        mirrored.reverse();
        assert!(Bezier::new(mirrored).unwrap().jet(1.0, 0.2).normal.distance(-outward) < 1e-14);
        let transposed = std::array::from_fn(|i| std::array::from_fn(|j| points[j][i]));
        assert!(Bezier::new(transposed).unwrap().jet(0.2, -1.0).normal.distance(-outward) < 1e-14);
    }

    #[test]
    fn patches_without_area_are_refused() {
        let no_area = ShapeError::NoArea { field: "points".into() };
        assert_eq!(Bezier::new([[DVec3::ONE; 4]; 4]).unwrap_err(), no_area);
        let line = bilinear([DVec3::ZERO, DVec3::X, 3.0 * DVec3::X, DVec3::X]);
        assert_eq!(Bezier::new(line).unwrap_err(), no_area);
        assert_eq!(Bezier::new([[DVec3::INFINITY; 4]; 4]).unwrap_err().field(), "points");
    }

    #[test]
    fn a_ray_through_a_collapsed_corner_hits_once_nearest() {
        let tent = Bezier::new(bilinear([DVec3::Z, DVec3::X, DVec3::Y, DVec3::Z])).unwrap();
        let hit = tent.intersect(&Ray::new(2.0 * DVec3::Z, -DVec3::Z)).unwrap();
        assert!((hit.t - 1.0).abs() < 1e-12 && hit.u < -1.0 + 1e-9);
    }
}
