//! Cost of an exact block, in rays of the sampled transport.

use radiosity_geom::DVec3;
use radiosity_visibility::Visibility;

use crate::coaxial;
use crate::occlusion::beside_frusta::{are_round, have_frusta};

/// Rays that take as long as the exact block of two flat elements with nothing between; with flat blockers,
/// and in addition for each of these; and of all others. From blocks of 30 µs, 200 µs and 250 µs a blocker,
/// and 20 ms, and a million rays a second; whole scenes cost from a tenth to twice as much.
const FREE: f64 = 30.0;
const PARTLY_HIDDEN: f64 = 200.0;
const BLOCKER: f64 = 250.0;
const CURVED: f64 = 20_000.0;

/// Rays that take as long as what a can, a cone or a disk hides of a flat pair. Measured: 2 to 8 ms at 1e-3.
const FRUSTUM: f64 = 4_000.0;

/// Rays that take as long as the block of two rings that the rule of coaxial surfaces knows. Measured: 1.5 to 2
/// ms at 1e-3, twice as long at 1e-7.
const COAXIAL: f64 = 2_000.0;

/// The least price of any pair.
pub const LEAST: f64 = FREE;

/// Two elements or surfaces.
#[derive(Clone, Copy, Debug)]
pub struct ElementPair<'a> {
    /// Places of their surfaces.
    pub surfaces: [usize; 2],
    /// Points whose convex hulls contain them.
    pub hulls: [&'a [DVec3]; 2],
    /// Whether both are flat.
    pub are_flat: bool,
    /// Whether both carry constants.
    pub are_constant: bool,
    /// Whether both are whole surfaces that carry constants.
    pub are_whole: bool,
}

/// About how many rays take as long as the exact block of a pair.
pub fn price(pair: &ElementPair, visibility: &Visibility) -> f64 {
    price_up_to(f64::INFINITY, pair, visibility)
}

/// The [`price`] of a pair up to a limit; a price above it may be returned as any other one above it. Fewer
/// blockers are looked for the lower it is.
pub(crate) fn price_up_to(limit: f64, pair: &ElementPair, visibility: &Visibility) -> f64 {
    let ElementPair { surfaces, hulls: [a, b], are_flat, are_constant, are_whole } = *pair;
    if !are_flat {
        return if are_whole && coaxial::knows(surfaces, visibility) { COAXIAL } else { CURVED };
    }
    let most = match limit {
        limit if limit < CURVED => ((limit - PARTLY_HIDDEN) / BLOCKER).max(0.0) as usize,
        _ => usize::MAX - 1,
    };
    let blockers = visibility.some_candidates(a, b, surfaces, most + 1);
    match blockers.len() {
        count if count > most => f64::INFINITY,
        _ => of_blockers(true, are_constant, &blockers, visibility),
    }
}

/// The [`price`] of a pair that is flat or not, and carries constants or not, with these blockers between. What cans,
/// cones and disks hide has a closed form for constants, where nothing but round things stands between.
pub(crate) fn of_blockers(
    are_flat: bool,
    are_constant: bool,
    blockers: &[usize],
    visibility: &Visibility,
) -> f64 {
    let of_blocker = |own: &usize| if visibility.frustum(*own).is_some() { FRUSTUM } else { BLOCKER };
    let has_outlines = || {
        let is_closed_form = || are_constant && are_round(blockers, visibility);
        visibility.has_outlines(blockers) && (!have_frusta(blockers, visibility) || is_closed_form())
    };
    match blockers.len() {
        _ if !are_flat => CURVED,
        0 => FREE,
        _ if has_outlines() => PARTLY_HIDDEN + blockers.iter().map(of_blocker).sum::<f64>(),
        _ => CURVED,
    }
}
