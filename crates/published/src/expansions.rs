//! Blocks of the pairs of which one element is translated, by series, frame after frame.
//!
//! G(p) = Σ Φ_n (p − c)ⁿ for flat elements with nothing between them ([`super::series`]), p along the line on
//! which the pair moves. It is always summed from its centre c, never from the frame before, so that nothing
//! adds up. Where a displacement leaves the line, where the bound of what is left out exceeds what is
//! allowed, or where other parts begin to face each other, the pair is expanded anew, if enough frames will
//! lie within the range; else, as where it is rotated, curved, touching or has something between, it is
//! integrated like that of any other scene.

mod element_places;
mod expansion;

use std::collections::HashMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use radiosity_elements::Element;
use radiosity_geom::DVec3;
use radiosity_kernel::{PairKind, blocks::block::Block};
use radiosity_transport::{Known, KnownBlocks};
use radiosity_work::ranks::Ranks;

use super::series::MovedBlock;
use element_places::{ElementPlace, ElementPlaces};
use expansion::Expansion;
pub use expansion::ORDERS;

/// Steps of this part of the extents of a pair are rounding.
const ROUNDED: f64 = 1e-13;

/// The loosest tolerance of a block that is small beside others of its row: a series of few orders is cheap,
/// and with a larger value single blocks would show.
const LOOSEST: f64 = 0.05;

/// The series of the pairs of a scene that moves.
#[derive(Debug)]
pub struct Expansions {
    /// Error that the series of blocks may have, relative to their largest entries, where rules are allowed
    /// `eps`.
    tolerance: f64,
    eps: f64,
    places: Mutex<ElementPlaces>,
    pairs: Mutex<HashMap<[usize; 2], Pair>>,
    /// Blocks that were summed for this frame.
    summed: AtomicUsize,
    expanded: AtomicUsize,
}

/// Numbers of blocks that were summed or expanded for a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SeriesCounts {
    /// Blocks that were summed; those that rest, and copies, are not counted.
    pub summed: usize,
    /// Blocks that were expanded.
    pub expanded: usize,
}

/// A pair of elements as it was seen last, with its expansion.
#[derive(Debug)]
struct Pair {
    /// Number of times that each element was seen anew.
    turns: [u32; 2],
    /// Displacement of the second element relative to the first, since both were seen anew (scene length).
    displacement: DVec3,
    /// Whether the kept block was integrated, at this displacement.
    is_integrated: bool,
    expansion: Option<Expansion>,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Expansions {
    /// None yet; series may be off by `tolerance` times the largest entries of blocks, where rules are
    /// allowed `eps`.
    pub fn new(tolerance: f64, eps: f64) -> Self {
        Self {
            tolerance,
            eps,
            places: Mutex::default(),
            pairs: Mutex::default(),
            summed: AtomicUsize::new(0),
            expanded: AtomicUsize::new(0),
        }
    }

    /// Expansions of the same accuracy, of no pair yet.
    pub fn anew(&self) -> Self {
        Self::new(self.tolerance, self.eps)
    }

    /// Begins another frame.
    pub fn begin(&self) {
        self.summed.store(0, Ordering::Relaxed);
        self.expanded.store(0, Ordering::Relaxed);
    }

    /// Numbers of blocks that all of these ranks together summed and expanded for this frame.
    pub fn counts(&self, ranks: &Ranks) -> SeriesCounts {
        let own = [&self.summed, &self.expanded].map(|count| count.load(Ordering::Relaxed) as u64);
        let sums = ranks.sums(own.to_vec());
        SeriesCounts { summed: sums[0] as usize, expanded: sums[1] as usize }
    }

    /// The block of a pair that has moved, by `step` since it was seen last, to the displacement `now`; and
    /// the samples of its expansion if it was expanded anew.
    fn moved(
        &self,
        pair: &mut Pair,
        ends: &[ElementPlace; 2],
        step: DVec3,
        tolerance: f64,
    ) -> Option<(MovedBlock, u64)> {
        let now = pair.displacement;
        if let Some(block) = pair.expansion.as_ref().and_then(|known| known.at(now, tolerance)) {
            return Some((block, 0));
        }
        let elements = ends.each_ref().map(|place| &*place.reference);
        pair.expansion = Expansion::ahead(elements, now, step, tolerance);
        let expansion = pair.expansion.as_ref()?;
        self.expanded.fetch_add(1, Ordering::Relaxed);
        Some((expansion.at(now, tolerance)?, expansion.samples()))
    }
}

impl KnownBlocks for Expansions {
    fn move_to(&self, elements: &[Element]) {
        let mut places = locked(&self.places);
        if !places.are_of(elements.len()) {
            locked(&self.pairs).clear();
        }
        places.move_to(elements);
    }

    fn block(&self, places: [usize; 2], elements: [&Element; 2], eps: f64) -> Option<Known> {
        let ends = {
            let seen = locked(&self.places);
            [seen.of(places[0])?, seen.of(places[1])?]
        };
        let turns = ends.each_ref().map(|place| place.turn);
        let now = ends[1].shift - ends[0].shift;
        let mut pairs = locked(&self.pairs);
        let Some(mut pair) = pairs.remove(&places).filter(|pair| pair.turns == turns) else {
            // How a pair moves is not known before it was seen twice.
            pairs.insert(places, Pair { turns, displacement: now, is_integrated: true, expansion: None });
            return None;
        };
        drop(pairs);
        let step = now - pair.displacement;
        let rests = step.length() <= ROUNDED * (elements[0].extent + elements[1].extent);
        if rests && pair.is_integrated {
            // The displacement stays that of the integral, so that rounding does not add up.
            locked(&self.pairs).insert(places, pair);
            return Some(Known::Same);
        }
        pair.displacement = now;
        let factor = (eps / self.eps).clamp(1.0, (LOOSEST / self.tolerance).max(1.0));
        let found = self.moved(&mut pair, &ends, step, factor * self.tolerance);
        pair.is_integrated = found.is_none();
        locked(&self.pairs).insert(places, pair);
        let (MovedBlock { values, error }, samples) = found?;
        self.summed.fetch_add(1, Ordering::Relaxed);
        let mut block = Block::exact(values, PairKind::Separated, samples);
        block.report.error = error;
        let remainder = error + eps * block.largest();
        Some(Known::Block { block, remainder })
    }
}

/// A shared reference, as [`radiosity_transport::KeptBlocks`] asks for.
pub fn known(expansions: &Arc<Expansions>) -> Arc<dyn KnownBlocks> {
    Arc::<Expansions>::clone(expansions)
}
