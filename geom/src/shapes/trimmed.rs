//! A flat surface with holes cut out; its parameters stay those of the whole.
//!
//! Front, jets and parametrisation of the base. Area: the base's less the holes'.

use crate::{Aabb, Foot, Hit, Jet, PlanarRegion, Ray, Rect, ShapeError, Surface};
use glam::DVec3;

/// A planar polygonal surface with holes.
#[derive(Debug)]
pub struct Trimmed {
    base: Box<dyn Surface>,
    region: PlanarRegion,
}

impl Trimmed {
    /// Cuts `holes` out of `base`, in addition to those it has.
    ///
    /// # Errors
    ///
    /// A base that is not a planar polygon; holes that cross themselves, each other or the outline.
    pub fn new(base: Box<dyn Surface>, holes: Vec<Vec<DVec3>>) -> Result<Trimmed, ShapeError> {
        let whole = base.region().ok_or_else(|| ShapeError::HolesOnCurved { field: "holes".into() })?;
        let all = holes.into_iter().chain(whole.holes().iter().cloned()).collect();
        let region = PlanarRegion::new(whole.outer().to_vec(), all)?;
        Ok(Trimmed { base, region })
    }
}

impl Surface for Trimmed {
    fn jet(&self, u: f64, v: f64) -> Jet {
        self.base.jet(u, v)
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        self.base.bounds(rect)
    }

    fn hull(&self, rect: &Rect) -> Vec<DVec3> {
        self.base.hull(rect)
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let hit = self.base.intersect(ray)?;
        self.region.covers(self.region.to_plane(ray.at(hit.t))).then_some(hit)
    }

    fn region(&self) -> Option<&PlanarRegion> {
        Some(&self.region)
    }

    fn corners(&self) -> Vec<DVec3> {
        self.region.corners()
    }

    fn with_corners(&self, place: &dyn Fn(DVec3) -> DVec3) -> Option<Result<Box<dyn Surface>, ShapeError>> {
        // The holes of the base stand behind those cut out of it, and move with it.
        let of_base = self.base.region().map_or(0, |region| region.holes().len());
        let own = &self.region.holes()[..self.region.holes().len() - of_base];
        let holes = own.iter().map(|hole| hole.iter().map(|x| place(*x)).collect()).collect();
        let moved = self.base.with_corners(place)?.and_then(|base| Trimmed::new(base, holes));
        Some(moved.map(|moved| Box::new(moved) as Box<dyn Surface>))
    }

    fn project(&self, point: DVec3) -> Foot {
        self.base.project(point)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Bilinear, Parallelogram};
    use super::*;

    fn unit_square() -> Box<dyn Surface> {
        Box::new(Parallelogram::new(DVec3::ZERO, DVec3::X, DVec3::Y).unwrap())
    }

    fn hole(low: f64, high: f64) -> Vec<DVec3> {
        [(low, low), (low, high), (high, high), (high, low)].map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec()
    }

    #[test]
    fn holes_add_up_and_parameters_stay() {
        let once = Trimmed::new(unit_square(), vec![hole(0.1, 0.3)]).unwrap();
        assert!((once.area() - 0.96).abs() < 1e-15);
        let twice = Trimmed::new(Box::new(once), vec![hole(0.5, 0.9)]).unwrap();
        assert!((twice.area() - 0.8).abs() < 1e-15);
        let at = |x: f64| twice.intersect(&Ray::new(DVec3::new(x, x, 1.0), -DVec3::Z));
        assert!(at(0.2).is_none() && at(0.7).is_none());
        let hit = at(0.4).unwrap();
        assert!((hit.u + 0.2).abs() < 1e-15 && (hit.v + 0.2).abs() < 1e-15);
    }

    #[test]
    fn curved_surfaces_take_no_holes() {
        let twisted =
            Bilinear::new([DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y + 0.1 * DVec3::Z, DVec3::Y]).unwrap();
        let error = Trimmed::new(Box::new(twisted), vec![hole(0.1, 0.3)]).unwrap_err();
        assert_eq!(error, ShapeError::HolesOnCurved { field: "holes".into() });
        assert_eq!(Trimmed::new(unit_square(), vec![hole(0.5, 1.5)]).unwrap_err().field(), "holes[0]");
    }
}
