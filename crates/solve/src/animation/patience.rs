//! Bound of what is lost where frames are solved far from each other.
//!
//! Costs are counted in frames that are solved one after the other. Such a frame shares all pairs with the
//! one before but those past what moves. A frame far away also lacks the pairs that are past where things are
//! now: it costs at most twice as much, and no more than a frame alone. Where only emission changes, all share
//! all pairs, and none costs more.

/// Part of all frames that may be lost. Chosen: with what is uncounted, a tenth is not exceeded.
const LOST: f64 = 0.06;

/// Most that a frame far away costs.
const DEAREST: f64 = 2.0;

/// Time that may still be lost, in frames that are solved one after the other.
#[derive(Debug)]
pub(super) struct Patience {
    left: f64,
    /// Cost of a frame after the one before, in solutions of a frame alone; None as long as none is known.
    next: Option<f64>,
}

impl Patience {
    /// The patience with so many frames.
    pub(super) fn with(frames: usize) -> Self {
        Self { left: LOST * frames as f64, next: None }
    }

    /// Takes note of the cost of a frame after the one before it, in solutions of a frame alone.
    pub(super) fn note_next(&mut self, cost: f64) {
        self.next = Some(cost);
    }

    /// Cost of so many frames that are far from each other.
    pub(super) fn cost(&self, frames: usize) -> f64 {
        let each = self.next.map_or(DEAREST, |next| if next > 0.0 { 1.0 / next } else { 1.0 });
        frames as f64 * each.clamp(1.0, DEAREST)
    }

    /// Takes note that so many frames far from each other were solved to no other end than to be kept.
    pub(super) fn spend(&mut self, frames: usize) {
        self.left -= self.cost(frames) - frames as f64;
    }

    /// Whether more may be lost.
    pub(super) fn has_any(&self) -> bool {
        self.left > 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn far_frames_cost_twice_the_next_one_or_as_much_as_alone_or_nothing_more() {
        let mut patience = Patience::with(100);
        for (next, far) in [(0.25, 2.0), (0.5, 2.0), (0.8, 1.25), (1.0, 1.0), (0.0, 1.0)] {
            patience.note_next(next);
            assert!((patience.cost(4) - 4.0 * far).abs() < 1e-12, "{next}");
        }
        // Frames that share nothing lose nothing by being far; others lose up to 6 of 100.
        patience.note_next(1.0);
        patience.spend(50);
        assert!(patience.has_any());
        patience.note_next(0.5);
        patience.spend(5);
        assert!(patience.has_any());
        patience.spend(1);
        assert!(!patience.has_any());
    }
}
