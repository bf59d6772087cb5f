//! Forecast of the time that the light of a frame takes, from the time of a few of its places.

use std::time::Instant;

use radiosity_light::penumbra::{RayEffort, VisibleEmitters};
use radiosity_work::ranks::Ranks;
use rayon::prelude::*;

use crate::pictures::eye::SeenPlace;
use crate::pictures::neighbourhoods::Neighbourhoods;
use crate::pictures::picture_light::{DirectIrradiance, PictureLight};

use super::direct_pass::STEP;

/// Runs of places beside each other at which direct light is computed, places of each, and places of all at which
/// light is gathered. Chosen: a thousandth of a picture.
const RUNS: usize = 16;
const RUN: usize = 16;
const TRIAL_GATHERED: usize = 32;

/// Places that share a list of what may stand before emitters. Measured in an office: 100 to 300.
const PER_LIST: f64 = 200.0;

/// Nodes of a light field over the square root of the number of places. Measured in pictures of 160 × 120 and 480
/// × 360: two boxes 16 and 11, the Cornell box 32 and 23, the teapot 12 and 10, an office 25 and 25; in smaller ones
/// the temple 45, a cathedral 32, a soda shop 29, a billiard room 12.
const NODES: f64 = 20.0;

/// Direct light in all over that of the places themselves: samples of pixels at edges take about as much again.
/// Measured in ten built-in scenes, an office and a soda shop: 0.2 to 1 more.
const MORE: f64 = 1.8;

/// Places at which light is gathered in all, over the square root of the number of places: nodes, places and samples
/// where no fit holds, and those in gaps, weighed by what they take beside places of the trial. Measured in pictures of
/// 160 × 120 to 480 × 360: a billiard room 20, an office 120 to 160, the temple and a soda shop 170, the teapot 110 to
/// 260, a cathedral 260.
const GATHERED: f64 = 110.0;

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
    let tried = if ranks.is_first() { Trial::new(light, places, seen).seconds() } else { 0.0 };
    ranks.of_first(tried) / ranks.count() as f64
}

/// Light of a few places of many, in runs of places beside each other.
struct Trial<'a> {
    light: &'a PictureLight<'a>,
    /// Number of all places.
    places: f64,
    seen: Vec<Option<SeenPlace>>,
    direct: Vec<DirectIrradiance>,
    /// Seconds to see one place, to list what stands before emitters for one square, and of direct light at one place.
    sight: f64,
    list: f64,
    direct_light: f64,
}

impl<'a> Trial<'a> {
    /// Tries some of so many places.
    fn new(
        light: &'a PictureLight,
        places: usize,
        seen: &(dyn Fn(usize) -> Option<SeenPlace> + Sync),
    ) -> Self {
        let place = |trial: usize| {
            let first = (2 * (trial / RUN) + 1) * places / (2 * RUNS);
            (first + trial % RUN).min(places - 1)
        };
        let start = Instant::now();
        let seen: Vec<Option<SeenPlace>> =
            (0..RUNS * RUN).into_par_iter().map(|trial| seen(place(trial))).collect();
        let sight = start.elapsed().as_secs_f64() / seen.len() as f64;
        let start = Instant::now();
        // Squares of the picture hold no more than one run.
        let pixel = |trial: usize| [trial % RUN, 2 * RUN * (trial / RUN)];
        let neighbourhoods =
            Neighbourhoods::of(light, seen.len(), |own| Some((pixel(own), seen[own].as_ref()?)));
        let list = start.elapsed().as_secs_f64() / RUNS as f64;
        let start = Instant::now();
        let of = |own: usize| {
            let around = neighbourhoods.around(own);
            seen[own]
                .as_ref()
                .map_or_else(DirectIrradiance::default, |seen| light.direct(seen, around, FIRST))
        };
        let direct: Vec<DirectIrradiance> = (0..seen.len()).into_par_iter().map(of).collect();
        let direct_light = start.elapsed().as_secs_f64() / seen.len() as f64;
        Self { light, places: places as f64, seen, direct, sight, list, direct_light }
    }

    /// About the seconds that the light of all places takes.
    fn seconds(&self) -> f64 {
        let direct = self.direct_light * self.computed() + self.list / PER_LIST;
        self.places * MORE * (self.sight + direct) + if self.light.gathers() { self.gathered() } else { 0.0 }
    }

    /// About the part of all places at which direct light is computed.
    fn computed(&self) -> f64 {
        if self.light.penumbra().is_none() {
            return 1.0;
        }
        let even = 1.0 - self.uneven();
        1.0 - even * even * (1.0 - 2.0 / (STEP * STEP) as f64)
    }

    /// Part of the places whose cell of the grid of direct light, along the run, has ends on two surfaces or in other
    /// light.
    fn uneven(&self) -> f64 {
        let goes_on = |first: usize| match (&self.seen[first], &self.seen[first + STEP]) {
            (Some(one), Some(other)) => one.goes_with(other) && self.sees(first) == self.sees(first + STEP),
            (None, None) => true,
            _ => false,
        };
        let cells = (0..RUNS * RUN).filter(|first| first % RUN + STEP < RUN);
        let uneven = cells.clone().filter(|first| !goes_on(*first)).count();
        uneven as f64 / cells.count() as f64
    }

    fn sees(&self, place: usize) -> Option<VisibleEmitters> {
        self.direct[place].visible
    }

    /// About the seconds in which reflected light is gathered.
    fn gathered(&self) -> f64 {
        let lit = self.seen.iter().zip(&self.direct);
        let lit: Vec<(&SeenPlace, &DirectIrradiance)> =
            lit.filter_map(|(seen, direct)| Some((seen.as_ref()?, direct))).collect();
        let chosen: Vec<_> = lit.iter().step_by((lit.len() / TRIAL_GATHERED).max(1)).collect();
        let start = Instant::now();
        chosen.par_iter().for_each(|(seen, direct)| drop(self.light.rest(seen, &direct.bands, 1.0)));
        let each = start.elapsed().as_secs_f64() / chosen.len().max(1) as f64;
        let all = self.places * lit.len() as f64 / self.seen.len() as f64;
        each * (GATHERED * all.sqrt()).min(all)
    }
}
