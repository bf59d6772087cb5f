//! An estimate of a solution's memory, before anything is allocated.
//!
//! With m_i functions on element i, n unknowns in the band that has most, and P the pairs of elements whose planes
//! allow them to see each other, in bytes
//!
//! ```text
//! elements   Σ (8 m_i² + 3000)             (bases; patches, hulls, coefficients)
//! blocks     2 · 8 Σ_P m_i m_j + 300 |P|   (as integrated, and as stored; data of each pair)
//! system     8 n² , twice for a method that factors the matrix
//! ```
//!
//! and 10 MB for the program. Integrated blocks are freed before the system is set up, so the peak is the larger of the
//! two sums. Pairs that repeat or are hidden reduce it, which is not known beforehand.

use radiosity_geom::{DVec3, PlanarRegion, Rect};
use radiosity_solvers::method::Method;

use crate::elements::{CutSize, Discretization, cut_sizes};
use crate::scene::{Scene, SceneSurface};

/// Bytes of an f64.
const NUMBER: u64 = 8;

/// Bytes of an element beside its basis: patches, hull, coefficients of all bands. Chosen; not tuned.
const ELEMENT: u64 = 3000;

/// Bytes of a pair beside its block. Chosen; not tuned.
const PAIR: u64 = 300;

/// Rays that a pair of elements carries, if any; two to ten in real rooms.
const HITS_PER_PAIR: f64 = 3.0;

/// Bytes of the hits that are counted at a time.
const CHUNK: u64 = 60_000_000;

/// Bytes of the program itself. Chosen; not tuned.
const PROGRAM: u64 = 10_000_000;

/// Most unknowns for which `auto` factors the matrix: `DIRECT` of `radiosity-solvers` with faer.
const FACTORED: u64 = 500;

/// Heights below this part of the pair's size count as zero. Chosen; not tuned.
const FLAT: f64 = 1e-9;

/// Bytes of a solution at each of its stages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Footprint {
    /// The elements with their bases.
    pub elements: u64,
    /// The stored blocks of G.
    pub blocks: u64,
    /// Data of the pairs while their blocks are integrated.
    pub pairs: u64,
    /// The matrix of one band, with its factors if the method makes some.
    pub system: u64,
}

impl Footprint {
    /// The footprint of `scene`, cut as `how` says and solved by `method`.
    pub fn of(scene: &Scene, how: &Discretization, method: &Method) -> Self {
        let sizes = cut_sizes(scene, how);
        let elements =
            sizes.iter().map(|cut| cut.elements * (NUMBER * cut.functions * cut.functions + ELEMENT));
        let outlines: Vec<Outline> = scene.surfaces.iter().map(Outline::of).collect();
        let (mut blocks, mut pairs) = (0, 0);
        for (i, cut) in sizes.iter().enumerate() {
            for (j, other) in sizes.iter().enumerate().take(i + 1) {
                if exchanging(&outlines[i], &outlines[j]) {
                    let count = if i == j {
                        cut.elements * (cut.elements + 1) / 2
                    } else {
                        cut.elements * other.elements
                    };
                    pairs += PAIR * count;
                    blocks += NUMBER * cut.functions * other.functions * count;
                }
            }
        }
        let unknowns = most_unknowns(scene, &sizes);
        let system = NUMBER * unknowns * unknowns * copies(method, unknowns);
        Self { elements: elements.sum(), blocks, pairs, system }
    }

    /// The footprint of `scene`, cut as `how` says and carried by so many rays: an upper bound.
    pub fn of_rays(scene: &Scene, how: &Discretization, rays: u64) -> Self {
        let sizes = cut_sizes(scene, how);
        let elements =
            sizes.iter().map(|cut| cut.elements * (NUMBER * cut.functions * cut.functions + ELEMENT));
        let areas: Vec<f64> = scene.surfaces.iter().map(|surface| surface.shape.area()).collect();
        let area: f64 = areas.iter().sum();
        let shares = sizes.iter().zip(&areas).map(|(cut, own)| cut.functions as f64 * own / area);
        let functions: f64 = shares.sum();
        let unknowns: u64 = sizes.iter().map(|cut| cut.elements * cut.functions).sum();
        let all = 0.5 * (unknowns as f64).powi(2);
        let entries = (rays as f64 * functions * functions / HITS_PER_PAIR).min(all);
        let numbers = (NUMBER as f64 * entries) as u64;
        // Sums of two halves while rays are sent; then the blocks of each half, and a matrix with both triangles.
        Self { elements: elements.sum(), blocks: 2 * numbers, pairs: CHUNK, system: 4 * numbers }
    }

    /// Largest sum at any time.
    pub fn peak(&self) -> u64 {
        PROGRAM + self.elements + self.blocks + self.system.max(self.blocks + self.pairs)
    }
}

fn most_unknowns(scene: &Scene, sizes: &[CutSize]) -> u64 {
    let of_band = |band: usize| {
        let reflecting = scene.surfaces.iter().zip(sizes).filter(|(s, _)| s.material.reflectance[band] > 0.0);
        reflecting.map(|(_, cut)| cut.elements * cut.functions).sum()
    };
    (0..scene.bands.len()).map(of_band).max().unwrap_or(0)
}

/// 1 for the matrix, 2 if a copy becomes its factors.
fn copies(method: &Method, unknowns: u64) -> u64 {
    let factors = match method.name {
        "auto" => unknowns <= FACTORED,
        name => matches!(name, "lu" | "cholesky"),
    };
    if factors { 2 } else { 1 }
}

/// The outline of a surface, to find whether it can see others.
struct Outline {
    /// A point, the unit normal and the tolerance of its plane, if it is flat.
    plane: Option<(DVec3, DVec3, f64)>,
    /// Points whose convex hull contains it.
    hull: Vec<DVec3>,
}

impl Outline {
    fn of(surface: &SceneSurface) -> Self {
        let shape = &surface.shape;
        let plane =
            |region: &PlanarRegion| (region.origin(), shape.jet(0.0, 0.0).normal, FLAT * region.extent());
        Self { plane: shape.region().map(plane), hull: shape.hull(&Rect::FULL) }
    }

    /// Whether some of `other` lies in front of the plane; true for a curved surface.
    fn reaches_before(&self, other: &Outline) -> bool {
        self.plane.is_none_or(|(origin, normal, tolerance)| {
            other.hull.iter().any(|point| (*point - origin).dot(normal) > tolerance)
        })
    }
}

/// Whether neither surface lies wholly behind or in the plane of the other.
fn exchanging(a: &Outline, b: &Outline) -> bool {
    a.reaches_before(b) && b.reaches_before(a)
}
