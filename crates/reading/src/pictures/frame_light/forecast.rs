//! Forecast of the time that the light of many places takes, from the rays of a few of them, which are counted:
//!
//! ```text
//! ½ ( a places + b (direct rays + spots · rays of a spot) )     seconds of two threads .
//! ```

use radiosity_light::penumbra::{RayEffort, VisibleEmitters};
use radiosity_work::FORECAST_THREADS;
use radiosity_work::counted::with_rays;
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
const GATHERED: usize = 128;

/// Places of all by which it is found how many each surface has. Chosen: a millisecond.
const GLANCES: usize = 1024;

/// Seconds of one core to see a place and to fit its light where direct light has closed forms, and where rays find
/// it. Measured on eight scenes with closed forms, 4 to 10 µs, and on four others, 10 to 20.
const EXACT: f64 = 7e-6;
const BY_RAYS: f64 = 15e-6;

/// Seconds of one core of a ray with what is made of it, and by which part longer rays take where all surfaces are
/// found by search, neither flat nor round. Measured: 0.8 to 1.2 µs in rooms and shops, 1.3 about a teapot, 2 in the
/// temple; not so in a cathedral of rational patches, 5.
const RAY: f64 = 0.95e-6;
const SEARCHED: f64 = 0.8;

/// Spots at which light is gathered on a surface, over the square root of the number of its places, where all is
/// uneven, and the power of the part that is. Measured in twelve scenes of 128 × 128 to 512 × 512 places of which the
/// parts 0.02 to 0.54 are uneven: 0.6 to 1.3 times as many, but for the temple 1.7 and an empty box 2.1.
const SPOTS: f64 = 68.0;
const OF_UNEVEN: f64 = 0.6;

/// Part of a length by which points follow each other evenly.
const GOLDEN: f64 = 0.618_033_988_749_895;

/// Nodes of a light field over the square root of the number of places. Measured in pictures of 160 × 120 and 480
/// × 360: two boxes 16 and 11, the Cornell box 32 and 23, the teapot 12 and 10, an office 25 and 25; in smaller ones
/// the temple 45, a cathedral 32, a soda shop 29, a billiard room 12.
const NODES: f64 = 20.0;

/// Direct light in all over that of the places themselves: samples of pixels at edges take about as much again.
/// Measured in ten built-in scenes, an office and a soda shop: 0.2 to 1 more.
const MORE: f64 = 1.8;

/// Rays for direct light at a place.
const FIRST: RayEffort = RayEffort { error_factor: 1.0, sure: false };

/// About the nodes of the light field by which so many places get their light.
pub(crate) fn nodes(places: f64) -> f64 {
    (NODES * places.sqrt()).min(places)
}

/// About the seconds that the light of so many places takes two threads, by the rays of a few, evenly chosen; `seen`
/// gives what a place sees. The first of these ranks tries it.
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
    /// Some of them, by the surfaces that they see.
    glances: Glances,
    seen: Vec<Option<SeenPlace>>,
    direct: Vec<DirectIrradiance>,
    /// Rays for the direct light of a place, in the mean.
    direct_rays: f64,
}

impl<'a> Trial<'a> {
    /// Tries some of so many places.
    fn new(
        light: &'a PictureLight,
        places: usize,
        seen_at: &(dyn Fn(usize) -> Option<SeenPlace> + Sync),
    ) -> Self {
        // Runs begin in all columns, whatever the width is.
        let place = |trial: usize| {
            let run = (trial / RUN) as f64;
            let part = (run + (GOLDEN * (run + 0.5)).fract()) / RUNS as f64;
            ((part * places as f64) as usize + trial % RUN).min(places - 1)
        };
        let seen: Vec<Option<SeenPlace>> =
            (0..RUNS * RUN).into_par_iter().map(|trial| seen_at(place(trial))).collect();
        // Squares of the picture hold no more than one run.
        let pixel = |trial: usize| [trial % RUN, 2 * RUN * (trial / RUN)];
        let neighbourhoods =
            Neighbourhoods::of(light, seen.len(), |own| Some((pixel(own), seen[own].as_ref()?)));
        let of = |own: usize| {
            let around = neighbourhoods.around(own);
            let direct = |seen: &SeenPlace| with_rays(|| light.direct(seen, around, FIRST));
            seen[own].as_ref().map_or_else(Default::default, direct)
        };
        let (direct, rays): (Vec<DirectIrradiance>, Vec<u64>) =
            (0..seen.len()).into_par_iter().map(of).unzip();
        let direct_rays = rays.iter().sum::<u64>() as f64 / seen.len() as f64;
        let glances = Glances::new(places, seen_at);
        Self { light, places: places as f64, glances, seen, direct, direct_rays }
    }

    /// About the seconds that the light of all places takes two threads.
    fn seconds(&self) -> f64 {
        let place = match self.light.penumbra() {
            None => EXACT,
            Some(_) => BY_RAYS + MORE * self.computed() * self.direct_rays * self.ray(),
        };
        let gathered = if self.light.gathers() { self.gathered() } else { 0.0 };
        (self.places * place + gathered) / FORECAST_THREADS
    }

    /// Seconds of a ray with what is made of it.
    fn ray(&self) -> f64 {
        let elements = self.light.solution().elements();
        let is_searched = |surface: &usize| {
            let shape = elements.shape(*surface);
            shape.region().is_none() && shape.ball().is_none() && shape.meridian().is_none()
        };
        let searched = (0..elements.surfaces()).filter(is_searched).count() as f64;
        RAY * (1.0 + SEARCHED * searched / elements.surfaces() as f64)
    }

    /// About the part of all places at which direct light is computed.
    fn computed(&self) -> f64 {
        if self.light.penumbra().is_none() {
            return 1.0;
        }
        let even = 1.0 - self.uneven();
        1.0 - even * even * (1.0 - 2.0 / (STEP * STEP) as f64)
    }

    /// Part of the places whose cell of the grid of direct light is uneven.
    fn uneven(&self) -> f64 {
        let cells = (0..RUNS * RUN).filter(|first| Self::has_end(*first));
        cells.clone().filter(|first| !self.goes_on(*first)).count() as f64 / cells.count() as f64
    }

    /// Whether the cell of the grid of direct light that begins at a place, along its run, ends in the run.
    fn has_end(first: usize) -> bool {
        first % RUN + STEP < RUN
    }

    /// Whether the ends of the cell that begins at a place are on one surface and in the same light.
    fn goes_on(&self, first: usize) -> bool {
        match (&self.seen[first], &self.seen[first + STEP]) {
            (Some(one), Some(other)) => one.goes_with(other) && self.sees(first) == self.sees(first + STEP),
            (None, None) => true,
            _ => false,
        }
    }

    fn sees(&self, place: usize) -> Option<VisibleEmitters> {
        self.direct[place].visible
    }

    /// About the seconds of one core in which reflected light is gathered.
    fn gathered(&self) -> f64 {
        let spots = self.spots();
        let cells = if self.light.gathers_by_rays() { 0.0 } else { self.light.seconds_by_cells(spots) };
        cells + spots * self.rays_of_spot() * self.ray()
    }

    /// About the spots at which reflected light is gathered.
    fn spots(&self) -> f64 {
        let uneven = self.uneven().max(1.0 / self.seen.len() as f64);
        let of_surface = |seen: f64| (SPOTS * uneven.powf(OF_UNEVEN) * seen.sqrt()).min(seen);
        self.glances.by_surface.iter().map(|own| of_surface(self.glances.places(own))).sum()
    }

    /// Rays that gather the reflected light of a spot, in the mean over some: of each surface as many as it has spots.
    fn rays_of_spot(&self) -> f64 {
        let chosen = self.glances.some(GATHERED);
        let rays = |seen: &&SeenPlace| {
            let direct = self.light.direct(seen, None, FIRST);
            with_rays(|| self.light.rest(seen, &direct.bands, 1.0)).1
        };
        chosen.par_iter().map(rays).sum::<u64>() as f64 / chosen.len().max(1) as f64
    }
}

/// Places of a few of many, evenly spread, by the surfaces that they see.
struct Glances {
    by_surface: Vec<Vec<SeenPlace>>,
    /// Places that each stands for.
    each: f64,
}

impl Glances {
    /// Of so many places.
    fn new(places: usize, seen: &(dyn Fn(usize) -> Option<SeenPlace> + Sync)) -> Self {
        let place = |glance: usize| ((glance as f64 + 0.5) * GOLDEN).fract();
        let seen = |glance: usize| seen((place(glance) * places as f64) as usize);
        let mut found: Vec<SeenPlace> = (0..GLANCES).into_par_iter().filter_map(seen).collect();
        found.sort_by_key(|seen| seen.place.surface);
        let mut by_surface: Vec<Vec<SeenPlace>> = Vec::new();
        for seen in found {
            match by_surface.last_mut() {
                Some(own) if own[0].place.surface == seen.place.surface => own.push(seen),
                _ => by_surface.push(vec![seen]),
            }
        }
        Self { by_surface, each: places as f64 / GLANCES as f64 }
    }

    /// About the places that see the surface that these see.
    fn places(&self, own: &[SeenPlace]) -> f64 {
        self.each * own.len() as f64
    }

    /// About so many of them, of each surface in proportion to the square root of its places.
    fn some(&self, count: usize) -> Vec<&SeenPlace> {
        let root = |own: &Vec<SeenPlace>| (own.len() as f64).sqrt();
        let all: f64 = self.by_surface.iter().map(root).sum();
        let of = |own: &'_ Vec<SeenPlace>| {
            let wanted = (count as f64 * root(own) / all).round().max(1.0) as usize;
            (own.len() / wanted).max(1)
        };
        self.by_surface.iter().flat_map(|own| own.iter().step_by(of(own))).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use radiosity_solve::solved::Solved;
    use radiosity_solve::{Options, in_threads};
    use radiosity_work::{Progress, Stage, Work};

    use super::*;
    use crate::pictures::eye::Eye;
    use crate::pictures::picture_light::GATHERED_FOR_PICTURES;
    use crate::pictures::pinhole::Pinhole;
    use crate::pictures::render::PictureRequest;
    use crate::quantity::Quantity;
    use crate::reader::ReadMode;

    /// Spots of a picture of a built-in scene as they are told and as they are gathered, and its seconds as so many
    /// threads tell them.
    fn told_and_gathered(name: &str, threads: usize) -> ([f64; 2], f64) {
        let scene = radiosity_language::builtin(name).expect("it is built in");
        let camera = scene.camera.clone().expect("it has one");
        let camera = radiosity_scene::Camera { width: 128, height: 96, ..camera };
        let solved = Solved::new(scene, Options::default(), &Work::alone()).expect("a solution");
        let (solution, visibility) = (&solved.outcome.solution, solved.visibility());
        let gathered = AtomicUsize::new(0);
        let observer = |progress| {
            if let Progress::Done { stage: Stage::GatheredPixels, done, of } = progress
                && done == of
            {
                gathered.fetch_add(of, Ordering::Relaxed);
            }
        };
        let request = PictureRequest {
            solution,
            visibility,
            camera: &camera,
            samples: 3,
            read: ReadMode::Gather,
            shown: Quantity::Radiosity,
            is_preview: false,
        };
        let seconds = || request.seconds(&Work::alone());
        let seconds = in_threads(threads, seconds).expect("threads");
        drop(request.picture(&Work::alone().observed_by(&observer)));
        let light = PictureLight::new(solution, visibility, ReadMode::Gather, GATHERED_FOR_PICTURES);
        let eye = Eye::of(solution, visibility);
        let view = Pinhole::new(&camera);
        let middle = |pixel: usize| [pixel % 128, pixel / 128].map(|at| at as f64 + 0.5);
        let seen = |pixel: usize| {
            let [column, row] = middle(pixel);
            eye.along(&view.ray(column, row))
        };
        let told = Trial::new(&light, 128 * 96, &seen).spots();
        ([told, gathered.into_inner() as f64], seconds)
    }

    /// Nodes, places without a fit and samples at edges together, which nobody knows before they are gathered.
    #[test]
    fn spots_are_told_within_a_factor() {
        for name in ["cornell-box", "two-boxes", "billiard", "occluder-box"] {
            let ([told, gathered], _) = told_and_gathered(name, 1);
            assert!((0.4..2.5).contains(&(told / gathered)), "{name}: {told} of {gathered}");
        }
    }

    #[test]
    fn forecasts_follow_from_counts_alone() {
        let [one, other] = [1, 3].map(|threads| told_and_gathered("two-boxes", threads).1);
        assert_eq!(one.to_bits(), other.to_bits());
        assert!(one > 0.0);
    }
}
