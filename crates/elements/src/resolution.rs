//! Order and cuts of a surface that does not state its own.

use radiosity_geom::{Aabb, Rect};
use radiosity_scene::{Pattern, Scene, SceneSurface};
use rayon::prelude::*;

use super::cells::{Layers, equal_parts, with_layers};
use super::discretization::{Discretization, Subdivide};
use super::dividers::{Dividers, Lines, divided};
use super::mesh::{Mesh, Tree};
use super::near_outlines::{NearOutlines, merged};
use super::nearness::Nearness;

/// Order and cuts of each surface of a scene.
#[derive(Debug)]
pub(super) struct Resolution<'a> {
    how: Discretization,
    /// Largest side of the bounding box of the scene (scene length).
    extent: f64,
    /// Share of each surface in the area of all; empty where it does not matter.
    shares: Vec<f64>,
    /// Partitions that part the light of surfaces; None where a number of elements is asked for.
    dividers: Option<Dividers<'a>>,
    /// Outlines of faces that are near, where surfaces are cut along them.
    near_outlines: NearOutlines,
    /// Faces that are near, where surfaces have layers for them.
    nearness: Option<Nearness>,
}

/// A surface that sends at least so many rays carries polynomials of at most `order` on `parts` × `parts`
/// elements.
struct Grade {
    rays: f64,
    order: usize,
    parts: usize,
}

/// The grades, largest surfaces first; constants below. The functions of an element are told apart by its
/// rays: n rays leave eigenvalues of their sums of products off by about 2 √(m/n) for m functions.
const GRADES: [Grade; 6] = [
    Grade { rays: 1.8e6, order: 2, parts: 16 },
    Grade { rays: 1.15e5, order: 2, parts: 8 },
    Grade { rays: 7200.0, order: 2, parts: 4 },
    Grade { rays: 1100.0, order: 2, parts: 2 },
    Grade { rays: 360.0, order: 2, parts: 1 },
    Grade { rays: 120.0, order: 1, parts: 1 },
];

impl<'a> Resolution<'a> {
    pub(super) fn new(scene: &'a Scene, how: &Discretization) -> Self {
        let bounds = scene
            .surfaces
            .iter()
            .fold(Aabb::EMPTY, |bounds, surface| bounds.union(surface.shape.bounds(&Rect::FULL)));
        let extent = (bounds.max - bounds.min).max_element();
        let shares = match how.subdivide {
            Subdivide::Graded { .. } => shares(scene),
            Subdivide::Auto { .. } | Subdivide::Uniform(_) => Vec::new(),
        };
        let dividers = how.subdivide.follows_light().then(|| Dividers::of(scene));
        let nearness = how.follows_near_faces().then(|| Nearness::of(scene));
        Self { how: *how, extent, shares, dividers, near_outlines: near_outlines(scene, how), nearness }
    }

    /// Order of the polynomials on the `index`-th surface.
    pub(super) fn order(&self, index: usize, surface: &SceneSurface) -> usize {
        surface.order.unwrap_or_else(|| match self.how.subdivide {
            Subdivide::Graded { rays } => {
                self.grade(index, rays).map_or(0, |grade| grade.order).min(self.how.order)
            }
            Subdivide::Auto { .. } | Subdivide::Uniform(_) => self.how.order,
        })
    }

    /// Elements of the `index`-th surface along u and v, layers and dividers apart.
    fn parts(&self, index: usize, surface: &SceneSurface) -> [usize; 2] {
        surface.subdivide.unwrap_or_else(|| {
            let parts = match self.how.subdivide {
                Subdivide::Uniform(parts) => parts,
                Subdivide::Graded { rays } => self.grade(index, rays).map_or(1, |grade| grade.parts),
                Subdivide::Auto { occluded, .. } => {
                    let bounds = surface.shape.bounds(&Rect::FULL);
                    let large = (bounds.max - bounds.min).max_element() > 0.5 * self.extent;
                    if occluded && large { 2 } else { 1 }
                }
            };
            let least_parts = surface.material.emission_pattern.as_deref().map_or([1, 1], parts_of_emitter);
            least_parts.map(|least| parts.max(least))
        })
    }

    /// Ends of the cells of the `index`-th surface along u and v.
    pub(super) fn breaks(&self, index: usize, surface: &SceneSurface) -> [Vec<f64>; 2] {
        let parts = self.parts(index, surface).map(equal_parts);
        let lines = self.lines(index, surface);
        let layers = self.layers(index, surface);
        [0, 1].map(|across| with_layers(&divided(&parts[across], &lines[across]), layers[across]))
    }

    /// Layers of the `index`-th surface along u and v, at the lower and the upper side: those that are asked for, or
    /// what is near wants; the latter not where its cells are stated.
    fn layers(&self, index: usize, surface: &SceneSurface) -> [[Layers; 2]; 2] {
        let nearness = self.nearness.as_ref().filter(|_| surface.subdivide.is_none());
        nearness.map_or([[self.how.layers; 2]; 2], |nearness| nearness.layers(index))
    }

    /// The lines along which the `index`-th surface is cut besides; none where its cells are stated, or are those of
    /// its emission.
    fn lines(&self, index: usize, surface: &SceneSurface) -> Lines {
        let is_free = surface.subdivide.is_none() && surface.material.emission_pattern.is_none();
        let divided = self.dividers.as_ref().filter(|_| is_free);
        let divided = divided.map_or_else(Lines::default, |all| all.lines(index));
        let outlined = self.near_outlines.lines(index);
        [0, 1].map(|across| merged(&divided[across], &outlined[across]))
    }

    fn grade(&self, index: usize, rays: u64) -> Option<&'static Grade> {
        let own = rays as f64 * self.shares[index];
        GRADES.iter().find(|grade| own >= grade.rays)
    }
}

/// The near outlines along which surfaces are cut; none where layers or a number of elements are asked for.
pub(super) fn near_outlines(scene: &Scene, how: &Discretization) -> NearOutlines {
    if how.follows_near_faces() { NearOutlines::of(scene) } else { NearOutlines::default() }
}

/// The mesh that follows from `how`.
pub fn usual_mesh(scene: &Scene, how: &Discretization) -> Mesh {
    let resolution = Resolution::new(scene, how);
    let tree = |(index, surface): (usize, &SceneSurface)| {
        Tree::grid(&resolution.breaks(index, surface), resolution.order(index, surface))
    };
    Mesh::new(scene.surfaces.iter().enumerate().map(tree).collect())
}

/// Most elements along each direction for the sake of emission that varies: 64 in all. With more each emitter
/// takes longer, with fewer its light is off farther from it.
const MOST_OF_EMITTER: usize = 8;
/// Elements along each direction for the sake of emission by a polynomial, which varies less than texels do.
const OF_POLYNOMIAL: usize = 4;

/// Elements of an emitter along u and v. Direct light takes the exitance of each as constant, so that what it
/// misses falls with their size over the distance; elements as texels, where these are few, miss nothing.
fn parts_of_emitter(pattern: &Pattern) -> [usize; 2] {
    match pattern.degree() {
        Some(0) => [1, 1],
        Some(_) => [OF_POLYNOMIAL; 2],
        None => pattern.breaks().map(|breaks| {
            let texels = breaks.len() + 1;
            if texels <= 2 * MOST_OF_EMITTER { texels } else { MOST_OF_EMITTER }
        }),
    }
}

/// Share of each surface in the area of all.
pub fn shares(scene: &Scene) -> Vec<f64> {
    let areas: Vec<f64> = scene.surfaces.par_iter().map(|surface| surface.shape.area()).collect();
    let all: f64 = areas.iter().sum();
    areas.iter().map(|area| area / all).collect()
}
