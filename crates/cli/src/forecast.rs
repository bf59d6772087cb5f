//! Memory that results will need, reckoned before the work.

use radiosity_request::MethodRequest;
use radiosity_request::memory::require;
use radiosity_scene::Scene;
use radiosity_work::ranks::Ranks;

use crate::error::CliError;

/// Bytes of a texel beside its bands, of each band, and of each band of a light group. Measured in textures:
/// 150 for three bands without groups; pages take less.
const TEXEL: u64 = 80;
const BAND: u64 = 20;
const OF_GROUP: u64 = 4;

/// Refuses to begin on so many texels of the light of `scene` where there is no room for them; `less` says
/// how to need less.
pub(crate) fn require_texels(
    texels: usize,
    scene: &Scene,
    method: &MethodRequest,
    less: &str,
    ranks: &Ranks,
) -> Result<(), CliError> {
    let parts = 1 + scene.light_groups().len() as u64;
    let texel = TEXEL + scene.bands.len() as u64 * (BAND + parts * OF_GROUP);
    Ok(require(texels as u64 * texel, method.memory, "the texels", less, ranks)?)
}
