//! Forecast of the time that the light of a frame takes, from the time of a few of its places.

use std::time::Instant;

use radiosity_light::penumbra::RayEffort;
use radiosity_work::ranks::Ranks;
use rayon::prelude::*;

use super::eye::SeenPlace;
use super::picture_light::PictureLight;

/// Places at which light is computed, and of those the ones at which it is gathered. Chosen: a thousandth of
/// a picture.
const TRIAL: usize = 256;
const TRIAL_GATHERED: usize = 32;

/// Direct light in all over that of all places once: some is computed again, or at finer samples. Measured in
/// the built-in scenes: 1.3 to 4.
const MORE: f64 = 1.5;

/// Places for each at which other light is gathered. Measured: 15 to 25.
pub(crate) const INTERPOLATED: f64 = 20.0;

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
    let start = Instant::now();
    let trial: Vec<(SeenPlace, Vec<f64>)> = (0..TRIAL)
        .into_par_iter()
        .filter_map(|k| {
            let seen = seen((k * places + places / 2) / TRIAL)?;
            let direct = light.direct(&seen, None, RayEffort { error_factor: 1.0, sure: false }).bands;
            Some((seen, direct))
        })
        .collect();
    let direct = start.elapsed().as_secs_f64() / TRIAL as f64 * places as f64;
    if !light.gathers() {
        return MORE * direct;
    }
    let step = (trial.len() / TRIAL_GATHERED).max(1);
    let chosen: Vec<&(SeenPlace, Vec<f64>)> = trial.iter().step_by(step).collect();
    let start = Instant::now();
    chosen.par_iter().for_each(|(seen, direct)| drop(light.rest(seen, direct)));
    let gathered = start.elapsed().as_secs_f64() / chosen.len().max(1) as f64;
    MORE * direct + gathered * (places * trial.len()) as f64 / TRIAL as f64 / INTERPOLATED
}
