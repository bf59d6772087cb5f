//! About the seconds that direct light takes two threads before anything is carried, from counts alone:
//!
//! ```text
//! carried   0
//! arrived   p r · rays to emitters
//! split     ½ (nodes of d · a + tables of all elements + q · nodes of g · (a + b))
//! ```
//!
//! and p r for each node and each luminaire, with the prices r of a ray ([`super::forecast`]) and a, b of a point by
//! cells ([`CellPrice`]). Too small where things stand close before what no light falls on, as the housing of a lamp
//! under a ceiling: nodes between them take a hundred times as long. What is masked is not told.

use radiosity_light::emitters::Emitters;
use radiosity_light::first_bounce::{LOOSEST, NodeCounts};
use radiosity_work::FORECAST_THREADS;

use super::direct::DirectWay;
use super::emission::Emission;
use super::first_light::LitScene;
use super::forecast::seconds_of_rays_among;
use crate::gather::cell_price::CellPrice;
use crate::tolerances::POINT_OVER_BLOCK;

/// p and q: a ray to an emitter is not counted in pairs, and g is gathered more coarsely than what is read. Measured in
/// four rooms each: 0.6 to 0.9, and 0.24 to 0.53.
const OF_RAYS: f64 = 0.6;
const OF_GATHERED: f64 = 0.37;

/// About the seconds of the direct light of `emissions`, known in this way.
pub(super) fn seconds_of_direct(lit_scene: &LitScene<'_>, emissions: &[Emission], way: DirectWay) -> f64 {
    let elements = lit_scene.elements.list();
    emissions.iter().map(|own| seconds_of(lit_scene, &own.emitters(elements), way)).sum()
}

fn seconds_of(lit_scene: &LitScene<'_>, sources: &Emitters<'_>, way: DirectWay) -> f64 {
    let LitScene { scene, visibility, options, .. } = *lit_scene;
    if options.masks.is_some() || (way == DirectWay::Carried && sources.points.is_empty()) {
        return 0.0;
    }
    let nodes = NodeCounts::of(sources);
    let rays = |count: u64| OF_RAYS * seconds_of_rays_among(count, scene.surfaces.len());
    let of_points = rays((nodes.of_points * sources.points.count()) as u64);
    of_points
        + match way {
            DirectWay::Carried => 0.0,
            DirectWay::Arrived => rays(options.ray_budget(scene).max(nodes.direct as u64)),
            DirectWay::Split => {
                let eps = LOOSEST.min(POINT_OVER_BLOCK * options.shadow_eps);
                let CellPrice { once, point } = CellPrice::of(sources, visibility, eps, false);
                let direct = nodes.direct as f64 * CellPrice::of_direct(sources, visibility);
                (direct + once + OF_GATHERED * nodes.reflected as f64 * point) / FORECAST_THREADS
            }
        }
}
