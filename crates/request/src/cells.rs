//! Means over cells: the memory that they need.

use radiosity_scene::Scene;
use radiosity_work::ranks::Ranks;
use radiosity_work::wording::{option, words};

use super::memory;
use super::ranges::Bytes;
use super::refusal::Refusal;

/// Bytes of a cell beside its bands, and of each band, with the text that is written of them. Measured: 395
/// for three bands.
const CELL: u64 = 140;
const BAND: u64 = 85;

/// Refuses so many cells of a scene for which there is no room in the memory that is `allowed`, or usable.
///
/// # Errors
/// Where there is no room.
pub fn require_cells(
    cells: usize,
    scene: &Scene,
    allowed: Option<Bytes>,
    ranks: &Ranks,
) -> Result<(), Refusal> {
    let needed = cells as u64 * (CELL + BAND * scene.bands.len() as u64);
    memory::require(needed, allowed, "the cells", words("ask for fewer with ") + option("cells"), ranks)
}
