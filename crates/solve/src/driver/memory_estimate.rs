//! An estimate of a solution's memory, before anything is allocated.
//!
//! With m_i functions on element i, n unknowns in the band that has most, and P the pairs of elements whose
//! planes allow them to see each other, in bytes
//!
//! ```text
//! elements   Σ (8 m_i² + 3000)             (bases; patches, hulls, coefficients)
//! blocks     2 · 8 Σ_P m_i m_j + 300 |P|   (as integrated, and as stored; data of each pair)
//! system     8 n² , twice for a solver that factors the matrix, up to 3000 unknowns (4500 with many
//!            light groups, which ask for such a solver) and for such a solver;
//!            320 n above that for a solver that only multiplies, and twice the blocks for others
//! groups     8 g (2 b + 8) Σ m_i          (g light groups in b bands: what is kept, and the work on one band)
//! kept       elements and blocks once more, 300 |P|, and 96 for each ray, where the next scene differs in
//!            the places of some things
//! ```
//!
//! and 10 MB for the program. Of N ranks each holds 2/N − 1/N² of the blocks, those of its rows and of its
//! columns, and all else; a solver that needs single entries gathers all blocks, once as they are and twice
//! as messages. Integrated blocks are freed before the system is set up, so the peak is the larger of the two
//! sums. Pairs that repeat or are hidden reduce it, which is not known beforehand.

use radiosity_elements::{CutSize, Discretization, cut_sizes, shares};
use radiosity_scene::{Material, Scene};
use radiosity_solvers::auto::{DENSE, DIRECT};
use radiosity_solvers::method::{Access, Method};
use radiosity_transport::kept_blocks::kept_rays::{BYTES as KEPT_RAY, MOST as MOST_KEPT};
use radiosity_transport::price::LEAST;
use radiosity_work::ranks::Ranks;

use crate::driver::outline::Outline;
use crate::system::{MANY, MOST_FOR_MANY};

/// Bytes of an f64.
const NUMBER: u64 = 8;

/// Bytes of an element beside its basis: patches, hull, coefficients of all bands. A rough estimate.
const ELEMENT: u64 = 3000;

/// Vectors of a solver that multiplies by the blocks as they are. A rough estimate: conjugate gradients take
/// fewer, GMRES before it restarts takes 50.
const VECTORS: u64 = 40;

/// Vectors of a light group while a band is solved, and those that it keeps of every band.
const AT_WORK: u64 = 8;
const KEPT: u64 = 2;

/// Bytes of a pair beside its block: what is known of it while blocks are made. A rough estimate.
const PAIR: u64 = 300;

/// Bytes per entry of pairs with a curved element, of which rules leave some to rays. Measured: 12 in a room
/// of 20 cylinders at order 10, all of whose shadows go by rays.
const BY_RAYS: u64 = 14;

/// Rays that a pair of elements carries, if any; two to ten in real rooms.
const HITS_PER_PAIR: f64 = 3.0;

/// Bytes of the hits that are counted at a time.
const CHUNK: u64 = 60_000_000;

/// Bytes of the program itself. A rough estimate, which counts in the smallest scenes alone.
const PROGRAM: u64 = 10_000_000;

/// Bytes of a solution at each of its stages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MemoryEstimate {
    /// The elements with their bases.
    elements: u64,
    /// The stored blocks of G.
    blocks: u64,
    /// Data of the pairs while their blocks are integrated.
    pairs: u64,
    /// The matrix of one band, with its factors if the solver makes some, and the light of groups.
    system: u64,
    /// Bytes of blocks and rays of the scene that are kept for the next one, if any are.
    kept: u64,
}

impl MemoryEstimate {
    /// The bytes of `scene`, cut as `how` says and solved by `solver`, on each of these ranks.
    pub fn of(scene: &Scene, how: &Discretization, solver: &Method, ranks: &Ranks) -> Self {
        Self::of_sizes(scene, &cut_sizes(scene, how), solver, ranks)
    }

    /// The bytes of `scene`, whose surfaces are cut into so many elements.
    pub(super) fn of_sizes(scene: &Scene, sizes: &[CutSize], solver: &Method, ranks: &Ranks) -> Self {
        let own = Self::of_blocks(scene, sizes);
        let (unknowns, ranks) = (most_unknowns(scene, sizes), ranks.count() as u64);
        let gathered = gathered(solver, unknowns, own.blocks, ranks);
        let system = system(solver, unknowns, own.blocks, rights(scene)) + gathered + groups(scene, sizes);
        Self { blocks: held(own.blocks, ranks), system, ..own }
    }

    /// The bytes by the rules of 1993, whose blocks are not symmetric: all of them are stored, and the
    /// matrix is dense.
    pub(super) fn unsymmetric(scene: &Scene, how: &Discretization, solver: &Method) -> Self {
        let sizes = cut_sizes(scene, how);
        let own = Self::of_blocks(scene, &sizes);
        let matrix = NUMBER * most_unknowns(scene, &sizes).pow(2);
        let matrices = matrix * if matches!(solver.access, Access::Entries | Access::BySize) { 2 } else { 1 };
        let system = matrices + groups(scene, &sizes);
        Self { blocks: 2 * own.blocks, system, ..own }
    }

    /// The bytes without a system.
    fn of_blocks(scene: &Scene, sizes: &[CutSize]) -> Self {
        let elements =
            sizes.iter().map(|cut| cut.elements * (NUMBER * cut.functions * cut.functions + ELEMENT));
        let outlines: Vec<Outline> = scene.surfaces.iter().map(Outline::of).collect();
        let (mut blocks, mut pairs, mut by_rays) = (0, 0, 0u64);
        for (i, cut) in sizes.iter().enumerate() {
            for (j, other) in sizes.iter().enumerate().take(i + 1) {
                if outlines[i].exchanges_with(&outlines[j]) {
                    let count = if i == j {
                        cut.elements * (cut.elements + 1) / 2
                    } else {
                        cut.elements * other.elements
                    };
                    pairs += PAIR * count;
                    blocks += NUMBER * cut.functions * other.functions * count;
                    if !outlines[i].is_flat() || !outlines[j].is_flat() {
                        by_rays += BY_RAYS * cut.functions * other.functions * count;
                    }
                }
            }
        }
        let elements = elements.sum();
        let rays = if by_rays > 0 { 2 * MOST_KEPT * KEPT_RAY } else { 0 };
        Self { elements, blocks, pairs: pairs + by_rays, system: 0, kept: elements + blocks + pairs + rays }
    }

    /// The bytes of `scene`, cut as `how` says and carried by so many rays: an upper bound.
    pub(super) fn of_rays(
        scene: &Scene,
        how: &Discretization,
        solver: &Method,
        rays: u64,
        ranks: &Ranks,
    ) -> Self {
        let sizes = cut_sizes(scene, how);
        let elements =
            sizes.iter().map(|cut| cut.elements * (NUMBER * cut.functions * cut.functions + ELEMENT));
        let functions: f64 =
            sizes.iter().zip(shares(scene)).map(|(cut, share)| cut.functions as f64 * share).sum();
        let unknowns: u64 = sizes.iter().map(|cut| cut.elements * cut.functions).sum();
        let all = 0.5 * (unknowns as f64).powi(2);
        let entries = (rays as f64 * functions * functions / HITS_PER_PAIR).min(all);
        let numbers = (NUMBER as f64 * entries) as u64;
        let ranks = ranks.count() as u64;
        let own = held(numbers, ranks);
        // Sums of two halves while rays are sent; then the blocks, of each half at its time, and the system.
        let gathered = gathered(solver, unknowns, numbers, ranks);
        let system =
            own + system(solver, unknowns, numbers, rights(scene)) + gathered + groups(scene, &sizes);
        let elements = elements.sum();
        let kept = 3 * KEPT_RAY * rays.saturating_add(rays / 8).min(MOST_KEPT);
        // Pairs are carried exactly where more rays than their least price are expected.
        let exact = rays / LEAST as u64 * (PAIR + NUMBER * (functions * functions) as u64);
        Self { elements, blocks: 2 * own, pairs: CHUNK, system, kept: elements + kept + exact }
    }

    /// These bytes where pairs that have rays of their own take so many.
    pub(super) fn by_pairs(self, pairs: u64) -> Self {
        Self { blocks: 0, pairs, ..self }
    }

    /// Largest sum at any time, with nothing kept for the next scene.
    pub fn peak(&self) -> u64 {
        PROGRAM + self.elements + self.blocks + self.system.max(self.blocks + self.pairs)
    }

    /// Largest sum at any time (bytes), with what is kept for the next scene.
    pub(super) fn peak_with_kept(&self) -> u64 {
        self.peak() + self.kept
    }
}

/// Bytes of the blocks that each of so many ranks holds.
fn held(blocks: u64, ranks: u64) -> u64 {
    (u128::from(blocks) * u128::from(2 * ranks - 1)).div_ceil(u128::from(ranks * ranks)) as u64
}

/// Bytes on their way to all of so many ranks, where a solver needs the entries of all blocks.
fn gathered(solver: &Method, unknowns: u64, blocks: u64, ranks: u64) -> u64 {
    let only_multiplies = solver.only_multiplies() && unknowns > DENSE as u64;
    if ranks == 1 || only_multiplies { 0 } else { 3 * blocks }
}

fn most_unknowns(scene: &Scene, sizes: &[CutSize]) -> u64 {
    let of_band = |band: usize| {
        let reflecting = scene.surfaces.iter().zip(sizes).filter(|(s, _)| scatters(&s.material, band));
        reflecting.map(|(_, cut)| cut.elements * cut.functions).sum()
    };
    (0..scene.bands.len()).map(of_band).max().unwrap_or(0)
}

fn scatters(material: &Material, band: usize) -> bool {
    material.reflectance[band] > 0.0 || material.transmittance[band] > 0.0
}

/// Bytes of the light of groups, in a scene that has any.
fn groups(scene: &Scene, sizes: &[CutSize]) -> u64 {
    let count = scene.light_groups().len() as u64;
    let coefficients: u64 = sizes.iter().map(|cut| cut.elements * cut.functions).sum();
    NUMBER * count * (KEPT * scene.bands.len() as u64 + AT_WORK) * coefficients
}

/// Right-hand sides of the system of a band: one for each light group, and one for the rest.
fn rights(scene: &Scene) -> u64 {
    1 + scene.light_groups().len() as u64
}

/// Bytes of the system of a band with so many unknowns, blocks of so many bytes, and so many right-hand sides.
fn system(solver: &Method, unknowns: u64, blocks: u64, rights: u64) -> u64 {
    let matrix = NUMBER * unknowns * unknowns;
    match solver.access {
        Access::Entries => 2 * matrix,
        Access::BySize if rights >= MANY as u64 && unknowns <= MOST_FOR_MANY as u64 => 2 * matrix,
        Access::BySize if unknowns <= (DENSE as u64).min(DIRECT as u64 * rights) => 2 * matrix,
        _ if unknowns <= DENSE as u64 => matrix,
        Access::Products | Access::BySize => NUMBER * unknowns * VECTORS,
        // Blocks and their transposes.
        Access::Rows | Access::Columns => 2 * blocks,
    }
}
