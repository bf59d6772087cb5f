//! Bilinear patch through four corners: X(u, v) = a + u b + v c + u v d, with
//!
//! a = ¼(v₀ + v₁ + v₂ + v₃), b = ¼(−v₀ + v₁ + v₂ − v₃), c = ¼(−v₀ − v₁ + v₂ + v₃), d = ¼(v₀ − v₁ + v₂ − v₃);
//! v₀ … v₃ at (−1, −1), (1, −1), (1, 1), (−1, 1).
//!
//! X_u × X_v = b × c + u b × d + v d × c is affine in u and v. The three cross products are independent
//! unless b, c, d lie in a plane: a patch that is not planar never folds; a planar one folds exactly when its
//! outline is not convex. Front (v₁ − v₀) × (v₃ − v₀) at the first corner. Area by quadrature; planar: by the
//! outline.
//!
//! Ray o + t w: it meets the ruling a + u b + v (c + u d) where (o − a − u b) · (w × (c + u d)) = 0, a
//! quadratic in u (Ramsey, Potter, Hansen, *Ray bilinear patch intersections*, 2004, with the elimination
//! written as a triple product).

use super::check_finite;
use crate::roots::quadratic;
use crate::surface::{foot_from_middle, nearest_foot};
use crate::tolerances::{NO_AREA, PLANARITY, ROUNDING};
use crate::{Aabb, Foot, Hit, Jet, PlanarRegion, Ray, Rect, ShapeError, Surface};
use glam::DVec3;

/// A four-cornered patch of straight rulings both ways; planar convex quadrilaterals included.
#[derive(Clone, Debug)]
pub struct Bilinear {
    vertices: [DVec3; 4],
    a: DVec3,
    b: DVec3,
    c: DVec3,
    d: DVec3,
    region: Option<PlanarRegion>,
}

impl Bilinear {
    /// The patch with `vertices` at u, v = (−1, −1), (1, −1), (1, 1), (−1, 1).
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, coinciding neighbours, corners on one line, a planar outline that is not
    /// strictly convex.
    pub fn new(vertices: [DVec3; 4]) -> Result<Bilinear, ShapeError> {
        let [p, q, r, s] = vertices;
        for x in vertices {
            check_finite("vertices", x)?;
        }
        let extent = vertices.iter().map(|x| x.distance(p)).fold(0.0, f64::max);
        if let Some(index) =
            (0..4).find(|&k| vertices[k].distance(vertices[(k + 1) % 4]) <= ROUNDING * extent)
        {
            return Err(ShapeError::RepeatedVertex { field: "vertices".into(), index });
        }
        let (a, b) = (0.25 * (p + q + r + s), 0.25 * (q + r - p - s));
        let (c, d) = (0.25 * (r + s - p - q), 0.25 * (p + r - q - s));
        if !spans_area(&vertices, extent) {
            return Err(ShapeError::NoArea { field: "vertices".into() });
        }
        let normal = b.cross(c);
        if normal.length() <= NO_AREA * extent * extent {
            return Err(ShapeError::Folded { field: "vertices".into() });
        }
        // The corners lie d · n above and below the middle plane, 2 d · n off the plane through the first
        // corner. 0.499 instead of ½, so that rounding cannot make the region refuse.
        let planar = d.dot(normal.normalize()).abs() <= 0.499 * PLANARITY * extent;
        if planar && !is_convex(&vertices, normal) {
            return Err(ShapeError::Folded { field: "vertices".into() });
        }
        let region = planar.then(|| PlanarRegion::new(vertices.to_vec(), vec![])).transpose()?;
        Ok(Bilinear { vertices, a, b, c, d, region })
    }

    fn point(&self, u: f64, v: f64) -> DVec3 {
        self.a + u * self.b + v * (self.c + u * self.d)
    }

    /// t and v where the ray's line passes the ruling of constant u: the nearest points of the two lines.
    fn on_ruling(&self, ray: &Ray, u: f64) -> (f64, f64) {
        let ruling = self.c + u * self.d;
        let normal = ray.direction.cross(ruling);
        let gap = self.a + u * self.b - ray.origin;
        let scale = 1.0 / normal.length_squared();
        (scale * gap.cross(ruling).dot(normal), scale * gap.cross(ray.direction).dot(normal))
    }
}

impl Surface for Bilinear {
    fn jet(&self, u: f64, v: f64) -> Jet {
        Jet::regular(self.point(u, v), self.b + v * self.d, self.c + u * self.d)
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        Aabb::around(rect.corners().map(|[u, v]| self.point(u, v)))
    }

    fn hull(&self, rect: &Rect) -> Vec<DVec3> {
        rect.corners().map(|[u, v]| self.point(u, v)).to_vec()
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let from = ray.origin - self.a;
        let (across, twist) = (ray.direction.cross(self.c), ray.direction.cross(self.d));
        let roots = quadratic(-self.b.dot(twist), from.dot(twist) - self.b.dot(across), from.dot(across));
        let hits = roots.into_iter().filter(|u| u.abs() <= 1.0 + Hit::SEAM).filter_map(|u| {
            let (t, v) = self.on_ruling(ray, u);
            Hit::accept(ray, t, u, v)
        });
        hits.min_by(|x, y| x.t.total_cmp(&y.t))
    }

    fn region(&self) -> Option<&PlanarRegion> {
        self.region.as_ref()
    }

    fn corners(&self) -> Vec<DVec3> {
        self.vertices.to_vec()
    }

    fn with_corners(&self, place: &dyn Fn(DVec3) -> DVec3) -> Option<Result<Box<dyn Surface>, ShapeError>> {
        Some(Bilinear::new(self.vertices.map(place)).map(|moved| Box::new(moved) as Box<dyn Surface>))
    }

    /// A point on the patch has one pair of parameters, and a descent from anywhere finds it.
    fn project(&self, point: DVec3) -> Foot {
        foot_from_middle(self, point).unwrap_or_else(|| nearest_foot(self, point))
    }
}

/// Whether some of the corners lie off the line through two others.
fn spans_area(vertices: &[DVec3; 4], extent: f64) -> bool {
    let [e, f, g] = [1, 2, 3].map(|k| vertices[k] - vertices[0]);
    [e.cross(f), f.cross(g), g.cross(e)].iter().any(|area| area.length() > NO_AREA * extent * extent)
}

/// Whether the outline turns the same way at all four corners.
fn is_convex(vertices: &[DVec3; 4], normal: DVec3) -> bool {
    (0..4).all(|k| {
        let (before, at, after) = (vertices[k], vertices[(k + 1) % 4], vertices[(k + 2) % 4]);
        let (e, f) = (at - before, after - at);
        e.cross(f).dot(normal) > 1e-9 * e.length() * f.length() * normal.length()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The left wall of the Cornell box: its fourth corner is 3.2 mm off the plane of the others.
    const LEFT_WALL: [DVec3; 4] = [
        DVec3::new(552.8, 0.0, 0.0),
        DVec3::new(549.6, 0.0, 559.2),
        DVec3::new(556.0, 548.8, 559.2),
        DVec3::new(556.0, 548.8, 0.0),
    ];

    #[test]
    fn a_slightly_twisted_wall_is_curved() {
        let wall = Bilinear::new(LEFT_WALL).unwrap();
        assert!(wall.region().is_none());
        let mut flat = LEFT_WALL;
        flat[2] = flat[1] + flat[3] - flat[0];
        assert!(Bilinear::new(flat).unwrap().region().is_some());
    }

    #[test]
    fn a_ray_along_a_ruling_of_the_other_family_hits() {
        let saddle = Bilinear::new([
            DVec3::new(-1.0, -1.0, 1.0),
            DVec3::new(1.0, -1.0, -1.0),
            DVec3::new(1.0, 1.0, 1.0),
            DVec3::new(-1.0, 1.0, -1.0),
        ])
        .unwrap();
        // The saddle is z = x y; the vertical ray above (x, y) meets it there and only there.
        for (x, y) in [(0.3, -0.7), (0.0, 0.0), (1.0, 1.0), (-1.0, 0.25)] {
            let hit = saddle.intersect(&Ray::new(DVec3::new(x, y, 5.0), -DVec3::Z)).unwrap();
            assert!(
                (hit.t - (5.0 - x * y)).abs() < 1e-14
                    && (hit.u - x).abs() < 1e-14
                    && (hit.v - y).abs() < 1e-14
            );
        }
        // A slanted ray through two points of it meets it twice, nearest first.
        let (p, q) = (DVec3::new(0.5, 0.5, 0.25), DVec3::new(-0.5, -0.5, 0.25));
        let hit = saddle.intersect(&Ray::segment(2.0 * p - q, q)).unwrap();
        assert!((hit.t - 0.5).abs() < 1e-14);
    }

    #[test]
    fn folded_quads_are_refused() {
        let [o, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let folded = ShapeError::Folded { field: "vertices".into() };
        assert_eq!(Bilinear::new([o, x + y, x, y]).unwrap_err(), folded);
        assert_eq!(Bilinear::new([o, x, 0.2 * (x + y), y]).unwrap_err(), folded);
        let no_area = ShapeError::NoArea { field: "vertices".into() };
        assert_eq!(Bilinear::new([o, x, 3.0 * x, 2.0 * x]).unwrap_err(), no_area);
        assert_eq!(Bilinear::new([o, x, 3.0 * x, 2.0 * x + 1e-3 * y]).unwrap_err(), folded);
        assert!(matches!(
            Bilinear::new([o, x, x, y]).unwrap_err(),
            ShapeError::RepeatedVertex { index: 1, .. }
        ));
        assert_eq!(Bilinear::new([o, x, DVec3::NAN, y]).unwrap_err().field(), "vertices");
    }
}
