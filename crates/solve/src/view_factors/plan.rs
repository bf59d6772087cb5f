//! Whether rules or rays carry the pairs of view factors, and about how long that takes, from counts alone.
//!
//! Rules are taken where they end in about [`LONG`] at the default accuracy, and proportionally later at finer ones:
//! they reach what is asked, which rays do not.

use radiosity_elements::Discretization;
use radiosity_scene::Scene;
use radiosity_visibility::{Shadows, Visibility};

use super::options::Options;
use crate::driver::cost::seconds_of_rays;
use crate::driver::{Transport, TransportChoice, exact_price, seconds_of_exact, seconds_of_rays_among};

/// Seconds that rules may take at [`USUAL_EPS`], by their price, where the choice is left to the scene. Measured: ten
/// rooms and six built-in scenes took half of their price, the teapot twice.
const LONG: f64 = 30.0;

/// Accuracy of factors for which these are the numbers.
const USUAL_EPS: f64 = 1e-3;

/// Rays for each surface, in all at least, and in all at the most, at that accuracy. Chosen, not
/// measured: some ten seconds of two threads.
const RAYS_PER_SURFACE: f64 = 2_500.0;
const FEWEST_RAYS: f64 = 4e6;
const USUALLY_MOST: f64 = 1.5e7;

/// Part of these rays that is sent even where any accuracy would do.
const LEAST_PART: f64 = 0.125;

/// A carrier of the pairs of view factors, and what it takes.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    pub choice: TransportChoice,
    /// Rays that are sent, where rays carry the pairs.
    pub rays: u64,
    /// About the seconds that two threads take.
    pub seconds: f64,
}

impl Plan {
    /// The plan for the `wanted` pairs of `scene`, cut as `how` says where rules carry them.
    pub(super) fn of(
        scene: &Scene,
        how: &Discretization,
        wanted: &dyn Fn(usize, usize) -> bool,
        options: &Options,
        visibility: &Visibility,
    ) -> Self {
        let finer = USUAL_EPS / options.accuracy.eps;
        let rays = options.rays.unwrap_or_else(|| usual_rays(scene.surfaces.len(), finer));
        let price = || exact_price(scene, how, wanted, visibility);
        let exact = || seconds_of_exact(&price());
        let limit = LONG * finer.max(1.0);
        let rules = |why: &str, seconds: f64| (false, why.to_owned(), seconds);
        let by_rays = |why: &str| (true, why.to_owned(), seconds_of_rays_among(rays, scene.surfaces.len()));
        let (sampled, why, seconds) = match options.transport {
            _ if options.shadows == Shadows::Off => {
                rules("rays always meet what stands in their way", exact())
            }
            Transport::Exact => rules("asked for", exact()),
            Transport::Sampled => by_rays("asked for"),
            Transport::Auto if options.rays.is_some() => by_rays("a number of rays is given"),
            Transport::Auto => {
                let price = price();
                let most = seconds_of_rays(price.all());
                let why = format!("rules take up to {most:.0e} s, the limit is {limit:.0e} s");
                if most > limit { by_rays(&why) } else { rules(&why, seconds_of_exact(&price)) }
            }
        };
        Self { choice: TransportChoice { sampled, why }, rays, seconds }
    }
}

/// Rays for so many surfaces, at an accuracy so many times finer than the usual one.
fn usual_rays(surfaces: usize, finer: f64) -> u64 {
    let usual = (RAYS_PER_SURFACE * surfaces as f64).clamp(FEWEST_RAYS, USUALLY_MOST);
    (usual * finer.max(LEAST_PART)).ceil() as u64
}
