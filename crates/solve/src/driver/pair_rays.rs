//! Light whose pairs have rays of their own: whether it has, and what that takes.

use radiosity_elements::Elements;
use radiosity_scene::Scene;
use radiosity_transport::FacetTransport;
use radiosity_visibility::Visibility;
use radiosity_work::Work;

use crate::facet_choice::{PairBytes, are_many_flat, of_many_flat};

use super::options::Options;

/// Bytes of a pair: its exchange and its block, 12 each, and what is known of it where something hides a part.
/// Measured: 24 in dented balls of five and ten thousand triangles. And bytes of all pairs where nothing is said of
/// memory. Chosen.
const PAIR: f64 = 28.0;
const USUALLY_MOST: f64 = 2e9;

/// Seconds of two threads that the blocks of a pair take and the light that tells their error. Measured in such balls.
const BLOCK: f64 = 3e-7;

/// Accuracy of view factors over that of light that they carry, where each pair has rays of its own. Measured: flows of
/// heat in a dented ball, sums of a thousand, err by a thirtieth of what the factors do.
const OF_FACTORS: f64 = 10.0;

/// The transport by rays of each pair; None where elements are few, bent or of polynomials, or that is not asked for.
pub(super) fn transport<'a>(
    elements: &'a Elements,
    visibility: &'a Visibility,
    options: &Options,
    work: &'a Work<'a>,
) -> Option<FacetTransport<'a>> {
    let eps = OF_FACTORS * options.accuracy().shadow_eps;
    let bytes = bytes(options.memory);
    options.rays_of_pairs.then(|| of_many_flat(elements, visibility, eps, bytes, work)).flatten()
}

/// About the seconds that the blocks of all pairs take two threads.
pub(super) fn seconds(transport: &FacetTransport, elements: &Elements) -> f64 {
    transport.seconds() + BLOCK * 0.5 * (elements.list().len() as f64).powi(2)
}

/// Bytes of all pairs of the surfaces of a scene that are elements as they are; None where they have no rays of their
/// own.
pub(super) fn memory(scene: &Scene, options: &Options) -> Option<u64> {
    let (surfaces, bytes) = (scene.surfaces.len(), bytes(options.memory));
    let have_rays = options.rays_of_pairs && options.subdivide.is_none() && are_many_flat(scene);
    (have_rays && bytes.suffice(surfaces)).then(|| bytes.needed(surfaces) as u64)
}

fn bytes(allowed: Option<u64>) -> PairBytes {
    PairBytes { each: PAIR, usually_most: USUALLY_MOST, allowed }
}
