//! Rational bicubic patch: X(u, v) = Σ wᵢⱼ Bᵢ(s) Bⱼ(t) Pᵢⱼ / Σ wᵢⱼ Bᵢ(s) Bⱼ(t), s = ½(1 + u), t = ½(1 + v).
//!
//! With the numerator A and the denominator w: X_s = (A_s − w_s X)/w, X_st = (A_st − w_s X_t − w_t X_s − w_st
//! X)/w. Front x_u × x_v. Area by quadrature. Range: weights > 0; collapsed edges as for the polynomial
//! patch.
//!
//! Ray: the numerators of the coordinates across the ray form a planar polynomial net with the same zeros.

use super::net::{Sample, check_area, jet, part, sample};
use super::tiles::Tiles;
use super::{check_finite, check_positive};
use crate::{Aabb, Hit, Jet, Ray, Rect, ShapeError, Surface, TangentPlanes};
use glam::{DVec3, DVec4};

/// A rational bicubic patch: spheres, cylinders and cones among them.
#[derive(Clone, Debug)]
pub struct Rational {
    /// w P and w.
    weighted: [[DVec4; 4]; 4],
    tiles: Tiles<DVec4>,
}

impl Rational {
    /// The patch with control points `points[i][j]` and weights `weights[i][j]`, i along u, j along v.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, weights not above zero, points that span no area or turn
    /// back in a plane.
    pub fn new(points: [[DVec3; 4]; 4], weights: [[f64; 4]; 4]) -> Result<Rational, ShapeError> {
        for (x, w) in points.as_flattened().iter().zip(weights.as_flattened()) {
            check_finite("points", *x)?;
            check_positive("weights", *w)?;
        }
        let weighted = std::array::from_fn(|i| {
            std::array::from_fn(|j| (weights[i][j] * points[i][j]).extend(weights[i][j]))
        });
        check_area("points", |s, t| divide(sample(&weighted, s, t)))?;
        Ok(Rational { weighted, tiles: Tiles::new(&weighted) })
    }
}

impl Surface for Rational {
    fn jet(&self, u: f64, v: f64) -> Jet {
        jet(u, v, |u, v| divide(sample(&self.weighted, 0.5 * (1.0 + u), 0.5 * (1.0 + v))))
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        // The control points of four parts keep closer to the patch than those of the whole.
        Aabb::around(
            rect.quarters()
                .into_iter()
                .flat_map(|quarter| part(&self.weighted, &quarter).into_iter().flatten().map(project)),
        )
    }

    fn tangent_planes(&self) -> Option<TangentPlanes> {
        Some(TangentPlanes::new(&self.weighted))
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        self.tiles.nearest(ray)
    }

    fn occludes(&self, ray: &Ray) -> bool {
        self.tiles.any(ray)
    }
}

fn project(p: DVec4) -> DVec3 {
    p.truncate() / p.w
}

/// The quotient's value and derivatives from those of numerator and denominator.
fn divide(at: Sample<DVec4>) -> Sample<DVec3> {
    let w = at.value.w;
    let value = project(at.value);
    let by_s = (at.by_s.truncate() - at.by_s.w * value) / w;
    let by_t = (at.by_t.truncate() - at.by_t.w * value) / w;
    let by_st = (at.by_st.truncate() - at.by_s.w * by_t - at.by_t.w * by_s - at.by_st.w * value) / w;
    Sample { value, by_s, by_t, by_st }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_weights_give_the_polynomial_patch() {
        let points = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                DVec3::new(i as f64, j as f64, (i * j) as f64 * 0.3 - (i * i) as f64 * 0.1)
            })
        });
        let rational = Rational::new(points, [[2.5; 4]; 4]).unwrap();
        let plain = super::super::Bezier::new(points).unwrap();
        for (u, v) in [(-1.0, -1.0), (0.2, -0.6), (1.0, 0.3)] {
            let (a, b) = (rational.jet(u, v), plain.jet(u, v));
            assert!(
                a.position.distance(b.position) < 1e-14
                    && a.du.distance(b.du) < 1e-14
                    && a.dv.distance(b.dv) < 1e-14
            );
        }
    }

    #[test]
    fn errors_name_the_field() {
        let points = std::array::from_fn(|i| std::array::from_fn(|j| DVec3::new(i as f64, j as f64, 0.0)));
        let mut weights = [[1.0; 4]; 4];
        weights[2][1] = 0.0;
        assert_eq!(
            Rational::new(points, weights).unwrap_err(),
            ShapeError::NotPositive { field: "weights".into(), value: 0.0 }
        );
        assert_eq!(Rational::new([[DVec3::ZERO; 4]; 4], [[1.0; 4]; 4]).unwrap_err().field(), "points");
    }
}
