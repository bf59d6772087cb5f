//! View factors by rays: a pilot tells which rows need how many, and which pairs rules carry for less.
//!
//! A row whose largest factor is F knows that one to √((1 − F)/(F n)) of itself by n rays, if these were independent.
//! The rays after the pilot are spread by what this takes to be the same for all rows,
//!
//! ```text
//! n_i ∝ (1 − F_i)/F_i ,   between a quarter of the even share and sixteen times as much.
//! ```
//!
//! Each pair that a ray meets takes memory. The pilot tells how many rays it takes to meet one more, and where there
//! is no room for as many as were planned, fewer are sent, or the run is refused where their number was given. A pilot
//! of fewer rays meets more pairs with each, so that the number that would fit is tried before it is told.

use radiosity_elements::Elements;
use radiosity_kernel::{Accuracy, Blocks, PlacedBlock};
use radiosity_transport::{Rays, SampledTransport};
use radiosity_visibility::Visibility;
use radiosity_work::{Progress, Work};

use super::row_noise::RowNoise;
use crate::driver::{Failure, MemoryReduction};

/// Share of the rays that the pilot sends. Its hits do not count.
const PILOT: f64 = 0.1;

/// Fewest rays of an element in a round, so that no row is without any.
const FEWEST: u64 = 16;

/// Bounds of what a row needs against one whose largest factor is ½. Chosen: rows of many small factors would take
/// all rays, and gain little.
const NEEDS: [f64; 2] = [0.25, 16.0];

/// Accuracy of pairs that rules carry, in multiples of n^-½ for n rays in all: as for light.
const EXACT: f64 = 5.0;

/// Bytes that a pair takes that a ray has met, at the most: its sums, the blocks by either half of the rays, and how
/// rows are made to close. Counted from their types, not measured.
const PAIR: f64 = 130.0;

/// Rays that are tried next, over those that would fit if they met pairs as the last ones did. Chosen.
const LESS: f64 = 0.9;

/// Pairs that are met where nothing is said of rays: a gigabyte with the rest of a run. Chosen.
const USUALLY_MOST: f64 = 6e6;

/// The transport that carries view factors by rays.
pub(super) struct FactorRays<'a> {
    pub elements: &'a Elements,
    pub visibility: &'a Visibility,
    /// Accuracy asked of the factors.
    pub accuracy: Accuracy,
    /// Rays that were planned, and whether their number was given.
    pub rays: u64,
    pub is_given: bool,
    /// Most bytes to use.
    pub memory: Option<u64>,
    pub work: &'a Work<'a>,
}

/// Blocks by rays, and how far off they are.
pub(super) struct Carried {
    pub blocks: Blocks,
    pub noise: RowNoise,
    /// Pairs that rules carry beside the rays.
    pub exact_pairs: usize,
}

impl FactorRays<'_> {
    /// The blocks by rays.
    ///
    /// # Errors
    /// A given number of rays that would take more memory than allowed.
    pub(super) fn carried(&self) -> Result<Carried, Failure> {
        let Self { elements, visibility, work, .. } = *self;
        let mut transport = SampledTransport::new(elements, visibility, work.ranks);
        self.send(&mut transport, &self.pilot(self.rays as f64), self.rays);
        let rays = self.affordable(&transport)?;
        // What follows depends on memory, which no fingerprint holds.
        work.ranks.note_choice(&rays);
        let planned = self.by_need(&transport.blocks(Rays::All), rays);
        transport.settle(&planned, self.exact_accuracy(rays), work);
        let all = transport.sent().iter().sum::<u64>() + planned.iter().sum::<u64>();
        self.send(&mut transport, &planned, all);
        let noise = RowNoise::of(&transport, elements);
        let exact_pairs = transport.exact_pairs();
        Ok(Carried { blocks: transport.blocks(Rays::All), noise, exact_pairs })
    }

    /// Sends so many rays of each element, and tells how many of `all` there are.
    fn send(&self, transport: &mut SampledTransport, planned: &[u64], all: u64) {
        let before: u64 = transport.sent().iter().sum();
        transport.send(planned, &mut |more| {
            self.work.report(Progress::Rays { done: before + more, of: all, error: None });
            !self.work.is_ended()
        });
    }

    /// The rays for which there is room, by the pairs that those of the pilot have met.
    fn affordable(&self, transport: &SampledTransport) -> Result<f64, Failure> {
        let allowed = self.memory.map_or(f64::INFINITY, |bytes| bytes as f64 / PAIR);
        let most = if self.is_given { allowed } else { allowed.min(USUALLY_MOST) };
        let rays = self.rays as f64;
        let met = self.met(transport, rays);
        if met <= most {
            return Ok(rays);
        }
        let fits = rays * most / met;
        if !self.is_given {
            return Ok(fits);
        }
        let [needed, allowed] = [met, allowed].map(|pairs| (PAIR * pairs) as u64);
        let fits = self.fitting(fits, most).map(MemoryReduction::Rays);
        Err(Failure::Memory { needed, allowed, fits: fits.into_iter().collect() })
    }

    /// About the number of pairs that so many rays meet, by those that a pilot has met.
    fn met(&self, pilot: &SampledTransport, rays: f64) -> f64 {
        let sent: u64 = pilot.sent().iter().sum();
        let count = self.elements.list().len() as f64;
        let by_ray = pilot.pairs_met() as f64 / (sent as f64).max(1.0);
        (by_ray * rays.max(FEWEST as f64 * count)).min(0.5 * count * (count + 1.0))
    }

    /// A number of rays, `about` so many, that by its own pilot meets no more than `most` pairs; None where even a few
    /// do.
    fn fitting(&self, about: f64, most: f64) -> Option<u64> {
        let mut rays = about.floor();
        while rays >= 1.0 {
            let mut pilot = SampledTransport::new(self.elements, self.visibility, self.work.ranks);
            pilot.send(&self.pilot(rays), &mut |_| true);
            let met = self.met(&pilot, rays);
            if met <= most {
                return Some(rays as u64);
            }
            rays = (LESS * rays * most / met).floor();
        }
        None
    }

    /// The rays of a pilot of so many.
    fn pilot(&self, rays: f64) -> Vec<u64> {
        self.shared(PILOT * rays, |_| 1.0)
    }

    /// Accuracy of the pairs that rules carry: better than that of most others.
    fn exact_accuracy(&self, rays: f64) -> Accuracy {
        let noise = EXACT / rays.sqrt();
        let Accuracy { eps, shadow_eps } = self.accuracy;
        Accuracy { eps: eps.max(noise), shadow_eps: shadow_eps.max(noise) }
    }

    /// So many rays, shared out by what the row of each element needs.
    fn by_need(&self, blocks: &Blocks, rays: f64) -> Vec<u64> {
        let list = self.elements.list();
        let mut largest = vec![0.0_f64; list.len()];
        for PlacedBlock { row, column, values } in blocks.gathered().iter() {
            let exchange = values[0] * (list[row].area * list[column].area).sqrt();
            for end in [row, column] {
                largest[end] = largest[end].max(exchange / list[end].area);
            }
        }
        let need = |element: usize| ((1.0 - largest[element]) / largest[element]).clamp(NEEDS[0], NEEDS[1]);
        self.shared(rays, need)
    }

    /// So many rays, shared out in these parts; elements that others cover send none.
    fn shared(&self, rays: f64, part: impl Fn(usize) -> f64) -> Vec<u64> {
        let list = self.elements.list();
        let sends = |element: usize| list[element].contact.is_none();
        let parts: Vec<f64> =
            (0..list.len()).map(|element| if sends(element) { part(element) } else { 0.0 }).collect();
        let all = parts.iter().sum::<f64>();
        let share = |part: f64| if part > 0.0 { ((rays * part / all) as u64).max(FEWEST) } else { 0 };
        parts.into_iter().map(share).collect()
    }
}
