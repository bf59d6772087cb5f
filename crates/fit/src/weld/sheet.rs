//! Sheets: the surfaces that are given by their corners.

use std::sync::Arc;

use radiosity_geom::{Aabb, Bvh, DVec3, PlanarRegion, Surface, coordinate_rounding, sides};

use super::tolerance::{Evidence, Measures, Tolerance, computed, decimal};

/// A surface given by its corners.
#[derive(Debug)]
pub(super) struct Sheet {
    /// Corners in the order of [`Surface::corners`].
    pub(super) corners: Vec<DVec3>,
    /// The region of a flat sheet.
    pub(super) region: Option<PlanarRegion>,
    pub(super) tolerance: Tolerance,
    bounds: Aabb,
}

/// All sheets of a scene.
#[derive(Debug)]
pub(super) struct Sheets {
    pub(super) list: Vec<Sheet>,
    tree: Bvh,
    /// Largest coordinate of any corner (scene length).
    largest: f64,
}

impl Sheets {
    /// The sheets among `shapes`, from which `middle` was subtracted; `asked` is the user's tolerance (scene
    /// length).
    pub(super) fn of(shapes: &[&mut Arc<dyn Surface>], middle: DVec3, asked: Option<f64>) -> Self {
        let shapes: Vec<&Arc<dyn Surface>> =
            shapes.iter().map(|shape| &**shape).filter(|shape| !shape.corners().is_empty()).collect();
        let measures: Vec<Measures> = shapes.iter().map(|shape| measures(shape, middle)).collect();
        let corners = || shapes.iter().flat_map(|shape| shape.corners());
        let evidence = Evidence {
            unevenness: measures.iter().map(|measures| measures.unevenness).fold(0.0, f64::max),
            decimal: decimal(corners().map(|x| x + middle), Aabb::around(corners()).diagonal()),
        };
        let tolerance = |measures: &Measures| match asked {
            Some(length) => Tolerance::asked(measures, length),
            None => Tolerance::of(measures, evidence),
        };
        let mut list: Vec<Sheet> =
            shapes.iter().zip(&measures).map(|(shape, own)| Sheet::of(shape, tolerance(own))).collect();
        // Ordered by corners, independently of the order of the surfaces.
        list.sort_by_cached_key(Sheet::key);
        let boxes: Vec<Aabb> = list.iter().map(|sheet| sheet.bounds).collect();
        let largest = list.iter().flat_map(|sheet| &sheet.corners).map(|x| x.abs().max_element());
        Self { tree: Bvh::build(&boxes), largest: largest.fold(0.0, f64::max), list }
    }

    /// The distance below which points agree to double precision (scene length).
    pub(super) fn reach(&self) -> f64 {
        computed(self.largest)
    }

    /// The sheets whose boxes, enlarged by their tolerances, overlap `bounds`, ascending.
    pub(super) fn near(&self, bounds: &Aabb) -> Vec<usize> {
        self.tree.near(bounds)
    }
}

impl Sheet {
    fn of(shape: &Arc<dyn Surface>, tolerance: Tolerance) -> Self {
        let corners = shape.corners();
        let bounds = Aabb::around(corners.iter().copied()).inflate(tolerance.most());
        let region = shape.region().cloned().or_else(|| flattened(&corners, tolerance.largest()));
        Self { region, corners, tolerance, bounds }
    }

    /// The bits of its corners, sorted: a key for the order of sheets.
    fn key(&self) -> Vec<[u64; 3]> {
        let mut bits: Vec<[u64; 3]> = self.corners.iter().map(|x| x.to_array().map(f64::to_bits)).collect();
        bits.sort_unstable();
        bits
    }

    /// The bounding box, enlarged by the tolerance.
    pub(super) fn bounds(&self) -> &Aabb {
        &self.bounds
    }

    /// The least and the largest height of its corners over the plane of `region` (scene length).
    pub(super) fn heights_over(&self, region: &PlanarRegion) -> [f64; 2] {
        let range = |[low, high]: [f64; 2], h: f64| [low.min(h), high.max(h)];
        self.corners.iter().map(|x| region.height(*x)).fold([f64::INFINITY, f64::NEG_INFINITY], range)
    }
}

/// The region of a quadrilateral that is meant to be flat, being bent by at most `tolerance` (scene length).
fn flattened(corners: &[DVec3], tolerance: f64) -> Option<PlanarRegion> {
    let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
    let corner = |[a, b]: [DVec3; 2]| (a - middle).cross(b - middle);
    let normal = sides(corners).map(corner).sum::<DVec3>().try_normalize()?;
    let height = |x: &DVec3| (*x - middle).dot(normal);
    let is_flat = corners.iter().all(|x| height(x).abs() <= tolerance);
    let on_plane = corners.iter().map(|x| *x - height(x) * normal).collect();
    is_flat.then(|| PlanarRegion::new(on_plane, Vec::new()).ok()).flatten()
}

/// The measures of a shape with corners; their coordinates were rounded before `middle` was subtracted.
fn measures(shape: &Arc<dyn Surface>, middle: DVec3) -> Measures {
    let (corners, region) = (shape.corners(), shape.region());
    let extent = Aabb::around(corners.iter().copied()).diagonal();
    let rings: Vec<&[DVec3]> = match region {
        Some(region) => {
            std::iter::once(region.outer()).chain(region.holes().iter().map(Vec::as_slice)).collect()
        }
        None => vec![&corners],
    };
    let sides = rings.iter().flat_map(|ring| sides(ring));
    let typed: Vec<DVec3> = corners.iter().map(|x| *x + middle).collect();
    let height = |x: &DVec3| region.map_or(0.0, |region| region.height(*x).abs());
    Measures {
        extent,
        shortest: sides.map(|[a, b]| a.distance(b)).fold(f64::INFINITY, f64::min),
        breadth: region.map_or(extent, |region| region.area() / extent),
        unevenness: corners.iter().map(height).fold(0.0, f64::max),
        rounding: coordinate_rounding(&typed, region.map(PlanarRegion::normal)),
    }
}
