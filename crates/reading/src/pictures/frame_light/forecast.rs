//! Forecast of the time that the light of a frame takes, from the time of a few of its places.

use std::time::Instant;

use radiosity_light::penumbra::RayEffort;
use radiosity_work::ranks::Ranks;
use rayon::prelude::*;

use crate::pictures::eye::SeenPlace;
use crate::pictures::neighbourhoods::Neighbourhoods;
use crate::pictures::picture_light::PictureLight;

/// Runs of places beside each other at which direct light is computed, places of each, and places of all at which
/// light is gathered. Chosen: a thousandth of a picture.
const RUNS: usize = 8;
const RUN: usize = 32;
const TRIAL_GATHERED: usize = 32;

/// Places that share a list of what may stand before emitters. Measured in an office: 100 to 300.
const PER_LIST: f64 = 200.0;

/// Direct light in all over that of all places once: some is computed again, or at finer samples. Measured in
/// the built-in scenes: 1.3 to 4.
const MORE: f64 = 1.5;

/// Nodes of the light field over the square root of the number of places. Measured in pictures of 160 × 120 and 640
/// × 480: two boxes 5 and 3, the Cornell box 11 and 6, the teapot 15 and 10, an office 29 and 25, the temple 40 and
/// 23.
const NODES: f64 = 20.0;

/// Rays for direct light at a place.
const FIRST: RayEffort = RayEffort { error_factor: 1.0, sure: false };

/// About the nodes of the light field by which so many places get their light.
pub(crate) fn nodes(places: f64) -> f64 {
    (NODES * places.sqrt()).min(places)
}

/// About the seconds that the light of so many places takes, by those of a few, evenly chosen; `seen` gives
/// what a place sees. The first of these ranks tries it.
pub(crate) fn seconds(
    light: &PictureLight,
    places: usize,
    seen: &(dyn Fn(usize) -> Option<SeenPlace> + Sync),
    ranks: &Ranks,
) -> f64 {
    let tried = if ranks.is_first() { tried(light, places, seen) } else { 0.0 };
    ranks.of_first(tried) / ranks.count() as f64
}

/// About the seconds that the light of so many places takes one rank.
fn tried(light: &PictureLight, places: usize, seen: &(dyn Fn(usize) -> Option<SeenPlace> + Sync)) -> f64 {
    let place = |trial: usize| {
        let first = (2 * (trial / RUN) + 1) * places / (2 * RUNS);
        (first + trial % RUN).min(places - 1)
    };
    let start = Instant::now();
    let trial: Vec<Option<SeenPlace>> =
        (0..RUNS * RUN).into_par_iter().map(|trial| seen(place(trial))).collect();
    let sights = start.elapsed().as_secs_f64() / trial.len() as f64;
    let start = Instant::now();
    // Squares of the picture hold no more than one run.
    let pixel = |trial: usize| [trial % RUN, RUN * (trial / RUN)];
    let neighbourhoods =
        Neighbourhoods::of(light, trial.len(), |own| Some((pixel(own), trial[own].as_ref()?)));
    let list = start.elapsed().as_secs_f64() / RUNS as f64;
    let start = Instant::now();
    let direct: Vec<Vec<f64>> = (0..trial.len())
        .into_par_iter()
        .map(|own| {
            let around = neighbourhoods.around(own);
            trial[own].as_ref().map_or_else(Vec::new, |seen| light.direct(seen, around, FIRST).bands)
        })
        .collect();
    let each = start.elapsed().as_secs_f64() / trial.len() as f64;
    let all = places as f64;
    let direct_seconds = all * (sights + MORE * (each + list / PER_LIST));
    if !light.gathers() {
        return direct_seconds;
    }
    let lit: Vec<(&SeenPlace, &Vec<f64>)> =
        trial.iter().zip(&direct).filter_map(|(seen, direct)| Some((seen.as_ref()?, direct))).collect();
    let chosen: Vec<_> = lit.iter().step_by((lit.len() / TRIAL_GATHERED).max(1)).collect();
    let start = Instant::now();
    chosen.par_iter().for_each(|(seen, direct)| drop(light.rest(seen, direct, 1.0)));
    let gathered = start.elapsed().as_secs_f64() / chosen.len().max(1) as f64;
    direct_seconds + gathered * nodes(all * lit.len() as f64 / trial.len() as f64)
}
