//! Blocks of the pairs of which one element moves, by series, frame after frame.
//!
//! G = Σ Φ_n tⁿ for flat elements with nothing between them ([`super::series`]), along the course on which the
//! pair moves: a line, or an axis about which one turns. It is always summed from its centre, never from the
//! frame before, so that nothing adds up. Where a pair leaves its course, where the bound of what is left out
//! exceeds what is allowed, or where other parts begin to face each other, it is expanded anew, if enough
//! frames will lie within the range; else, as where it is curved, touching or has something between, it is
//! integrated like that of any other scene. A pair whose series was not repaid is integrated until it has
//! kept to one course for twice as many frames as it had to before.

mod course;
mod element_places;
mod ends;
mod expansion;
mod pair;

use std::collections::HashMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use radiosity_elements::Element;
use radiosity_kernel::{PairKind, blocks::block::Block};
use radiosity_transport::{Known, KnownBlocks};
use radiosity_work::ranks::Ranks;

use super::series::MovedBlock;
use element_places::ElementPlaces;
use ends::Ends;
use expansion::Expansion;
pub use expansion::ORDERS;
use pair::Pair;

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

    /// The block of a pair that has moved, by `step` on its course; and the samples of its expansion if it was
    /// expanded anew.
    fn moved(&self, pair: &mut Pair, ends: &Ends, step: Option<f64>) -> Option<(MovedBlock, u64)> {
        let place = pair.place;
        let at = |expansion: &mut Expansion| {
            let p = ends.parameter(expansion.course(), &place)?;
            expansion.at(p, ends.tolerance)
        };
        if let Some(block) = pair.expansion.as_mut().and_then(at) {
            return Some((block, 0));
        }
        let expansion = pair.expand(step, ends)?;
        self.expanded.fetch_add(1, Ordering::Relaxed);
        Some((at(expansion)?, expansion.samples()))
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

    fn block(
        &self,
        places: [usize; 2],
        elements: [&Element; 2],
        eps: f64,
        samples: Option<u64>,
    ) -> Option<Known> {
        let ends = {
            let seen = locked(&self.places);
            [seen.of(places[0])?, seen.of(places[1])?]
        };
        let changes = ends.each_ref().map(|place| place.changes);
        let now = ends[1].place.then(&ends[0].place.inverse());
        let mut pairs = locked(&self.pairs);
        let Some(mut pair) = pairs.remove(&places).filter(|pair| pair.changes == changes) else {
            // How a pair moves is not known before it was seen twice.
            pairs.insert(places, Pair::seen(changes, now));
            return None;
        };
        drop(pairs);
        if pair.is_integrated {
            pair.integral = samples;
        }
        let references = ends.each_ref().map(|place| &*place.reference);
        let factor = (eps / self.eps).clamp(1.0, (LOOSEST / self.tolerance).max(1.0));
        let extent = elements[0].extent + elements[1].extent;
        let tolerance = factor * self.tolerance;
        let ends = Ends { elements: references, extent, tolerance, integral: pair.integral };
        if pair.is_integrated && ends.rests(&pair.place, &now) {
            // The place stays that of the integral, so that rounding does not add up.
            locked(&self.pairs).insert(places, pair);
            return Some(Known::Same);
        }
        let step = pair.move_to(now, &ends);
        let found = self.moved(&mut pair, &ends, step);
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
