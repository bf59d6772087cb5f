//! First hits of rays, and their starts on surfaces.

use std::iter;

use radiosity_geom::{DVec3, Encounter, Ray, touching};
use radiosity_work::counted::count_rays;

use super::Visibility;
use crate::tolerances::OWN_END;

impl Visibility {
    /// The first surface that a ray meets. Front and back of a two-sided surface are met at once, and the
    /// front counts.
    pub fn nearest(&self, ray: &Ray) -> Option<Encounter> {
        count_rays(1);
        self.rays.nearest(ray)
    }

    /// The first surface that a ray meets which starts at `origin`, on `surface`, and goes along `direction`:
    /// not that surface itself, but where it bends back.
    pub fn nearest_from(&self, surface: usize, origin: DVec3, direction: DVec3) -> Option<Encounter> {
        count_rays(1);
        self.rays.nearest_from(surface, origin, direction)
    }

    /// Key of how rays start on a surface ([`radiosity_geom::RayTree::start_on`]).
    pub fn start_on(&self, surface: usize) -> [u64; 2] {
        self.rays.start_on(surface)
    }

    /// Distance from its start within which a ray may still meet what it starts on (scene length;
    /// [`radiosity_geom::RayTree::reach`]).
    pub fn reach(&self) -> f64 {
        self.rays.reach()
    }

    /// The surfaces that a ray meets one after another, from `x`, on `surface` if on any, along `direction`,
    /// which is a unit vector.
    pub fn met_along(
        &self,
        surface: Option<usize>,
        x: DVec3,
        direction: DVec3,
    ) -> impl Iterator<Item = Encounter> {
        let mut last = None;
        iter::from_fn(move || {
            let ray = Ray::new(x, direction);
            let beyond = |t: f64| t + touching(self.bounds().diagonal(), t);
            let met = match (last, surface) {
                (Some(t), _) => self.nearest(&Ray { range: [beyond(t), f64::INFINITY], ..ray }),
                (None, Some(surface)) => self.nearest_from(surface, x, direction),
                (None, None) => self.nearest(&ray),
            }?;
            last = Some(met.hit.t);
            Some(met)
        })
    }

    /// Whether nothing stands between `x`, on `surface` if on any, and `y`, which may lie on another.
    pub fn is_free(&self, surface: Option<usize>, x: DVec3, y: DVec3) -> bool {
        count_rays(1);
        match surface {
            Some(surface) => self.rays.is_free_from(surface, x, y - x, 1.0 - OWN_END),
            None => self.rays.nearest(&Ray { range: [0.0, 1.0 - OWN_END], ..Ray::new(x, y - x) }).is_none(),
        }
    }
}
