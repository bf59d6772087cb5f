//! About the seconds that the pairs of a scene take, told before.

use super::choose_transport::price_of_pairs;
use super::cost::seconds_of_rays;
use super::ready::Ready;

/// About the seconds that the blocks between the elements of a scene take two threads.
pub(super) fn seconds_of_pairs(ready: &Ready) -> f64 {
    let Ready { scene, elements, visibility, rays, .. } = ready;
    if let Some(rays) = rays {
        return seconds_of_rays(*rays as f64);
    }
    let counts: Vec<u64> =
        (0..scene.surfaces.len()).map(|surface| elements.of_surface(surface).len() as u64).collect();
    let sends = |surface: usize| scene.surfaces[surface].material.sends();
    seconds_of_rays(price_of_pairs(scene, &counts, &|i, j| sends(i) || sends(j), visibility))
}
