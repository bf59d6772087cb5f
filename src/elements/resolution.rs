//! Order and cuts of a surface that does not state its own.

use radiosity_geom::{Aabb, Rect};

use super::discretization::{Discretization, Subdivide};
use crate::scene::{Scene, SceneSurface};

/// Order and cuts of each surface of a scene.
#[derive(Debug)]
pub(super) struct Resolution {
    how: Discretization,
    /// Largest side of the bounding box of the scene (scene length).
    extent: f64,
    /// Area of all surfaces (scene length²); only where it matters.
    area: f64,
}

/// A surface that sends at least so many rays carries polynomials of at most `order` on `parts` × `parts` elements.
struct Grade {
    rays: f64,
    order: usize,
    parts: usize,
}

/// The grades, largest surfaces first; constants below. The functions of an element are told apart by its rays: n rays
/// leave
/// eigenvalues of their sums of products off by about 2 √(m/n) for m functions.
const GRADES: [Grade; 4] = [
    Grade { rays: 7200.0, order: 2, parts: 4 },
    Grade { rays: 1100.0, order: 2, parts: 2 },
    Grade { rays: 360.0, order: 2, parts: 1 },
    Grade { rays: 120.0, order: 1, parts: 1 },
];

impl Resolution {
    pub(super) fn new(scene: &Scene, how: &Discretization) -> Self {
        let bounds = scene
            .surfaces
            .iter()
            .fold(Aabb::EMPTY, |bounds, surface| bounds.union(surface.shape.bounds(&Rect::FULL)));
        let extent = (bounds.max - bounds.min).max_element();
        let area = match how.subdivide {
            Subdivide::Graded { .. } => scene.surfaces.iter().map(|surface| surface.shape.area()).sum(),
            Subdivide::Auto { .. } | Subdivide::Uniform(_) => 0.0,
        };
        Self { how: *how, extent, area }
    }

    /// Order of the polynomials on a surface.
    pub(super) fn order(&self, surface: &SceneSurface) -> usize {
        surface.order.unwrap_or_else(|| match self.how.subdivide {
            Subdivide::Graded { .. } => {
                self.grade(surface).map_or(0, |grade| grade.order).min(self.how.order)
            }
            Subdivide::Auto { .. } | Subdivide::Uniform(_) => self.how.order,
        })
    }

    /// Elements of a surface along u and v, layers apart.
    pub(super) fn parts(&self, surface: &SceneSurface) -> [usize; 2] {
        surface.subdivide.unwrap_or_else(|| {
            let parts = match self.how.subdivide {
                Subdivide::Uniform(parts) => parts,
                Subdivide::Graded { .. } => self.grade(surface).map_or(1, |grade| grade.parts),
                Subdivide::Auto { occluded } => {
                    let bounds = surface.shape.bounds(&Rect::FULL);
                    let large = (bounds.max - bounds.min).max_element() > 0.5 * self.extent;
                    if occluded && large { 2 } else { 1 }
                }
            };
            [parts, parts]
        })
    }

    fn grade(&self, surface: &SceneSurface) -> Option<&'static Grade> {
        let Subdivide::Graded { rays } = self.how.subdivide else { return None };
        let own = rays as f64 * surface.shape.area() / self.area;
        GRADES.iter().find(|grade| own >= grade.rays)
    }
}
