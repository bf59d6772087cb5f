//! Segments between two facets, which tell the part of their exchange that nothing hides.
//!
//! Their ends are spread evenly over either facet. Each [`TOGETHER`] of them are paired anew: in one sequence
//! of both ends numbers of two of its four dimensions lie on a few lines, as do bars that stand along what is
//! between.

use radiosity_elements::sampling::shift::shift;
use radiosity_visibility::Visibility;

use super::facet::{End, Facet};

/// Segments whose ends are paired among themselves.
pub(super) const TOGETHER: u64 = 16;

/// Step from one end to the next one's partner: odd, so that each is paired once.
const STEP: u64 = 5;

/// Segments between two facets, from the first on.
pub(super) struct Segments<'a> {
    facets: [&'a Facet; 2],
    /// The surface that they start on.
    surface: usize,
    visibility: &'a Visibility,
    /// Number of the pair.
    number: u64,
    sent: u64,
    /// Σ κ, Σ κ V, Σ κ², Σ κ² V.
    all: f64,
    free: f64,
    squares: f64,
    free_squares: f64,
}

impl<'a> Segments<'a> {
    /// None yet between these facets, the first of which lies on `surface`.
    pub(super) fn between(
        first: &'a Facet,
        other: &'a Facet,
        surface: usize,
        visibility: &'a Visibility,
    ) -> Self {
        let facets = [first, other];
        let [one, two] = facets.map(|facet| facet.end().surface as u64);
        let number = (one << 32) ^ two;
        Self {
            facets,
            surface,
            visibility,
            number,
            sent: 0,
            all: 0.0,
            free: 0.0,
            squares: 0.0,
            free_squares: 0.0,
        }
    }

    /// Sends segments until there are so many.
    pub(super) fn send(&mut self, count: u64) {
        let [first, other] = self.facets;
        for index in self.sent..count {
            let ends = [first.point(End::Start, index), other.point(End::Stop, self.partner(index))];
            let kernel = first.kernel(ends, other);
            self.all += kernel;
            self.squares += kernel * kernel;
            if kernel > 0.0 && self.visibility.is_free(Some(self.surface), ends[0], ends[1]) {
                self.free += kernel;
                self.free_squares += kernel * kernel;
            }
        }
        self.sent = self.sent.max(count);
    }

    /// The end where the segment stops that starts at the end of this index.
    fn partner(&self, index: u64) -> u64 {
        let (round, place) = (index / TOGETHER, index % TOGETHER);
        let [turn] = shift::<1>(self.number ^ (round << 16));
        round * TOGETHER + (STEP * place + (turn * TOGETHER as f64) as u64) % TOGETHER
    }

    /// Segments so far.
    pub(super) fn sent(&self) -> u64 {
        self.sent
    }

    /// Number of segments of one kernel that would tell as much as these do, by their spread; 0 where none carries
    /// anything.
    pub(super) fn carrying(&self) -> f64 {
        if self.all > 0.0 { self.all * self.all / self.squares } else { 0.0 }
    }

    /// Whether all that carry something are free, or all are stopped.
    pub(super) fn agree(&self) -> bool {
        self.are_all_free() || self.are_none_free()
    }

    /// Whether nothing stops any that carries something.
    pub(super) fn are_all_free(&self) -> bool {
        self.free == self.all && self.all > 0.0
    }

    /// Whether all that carry something are stopped.
    pub(super) fn are_none_free(&self) -> bool {
        self.free == 0.0 && self.all > 0.0
    }

    /// The part v that nothing hides; ½ where none carries anything.
    pub(super) fn part(&self) -> f64 {
        if self.all > 0.0 { self.free / self.all } else { 0.5 }
    }

    /// The variance of v; where all agree, the square of the part by which they may be wrong, about.
    pub(super) fn variance(&self) -> f64 {
        if self.all <= 0.0 || self.agree() {
            return (self.carrying() + 2.0).powi(-2);
        }
        let v = self.part();
        let sum = (1.0 - 2.0 * v) * self.free_squares + v * v * self.squares;
        sum.max(0.0) / (self.all * self.all)
    }

    /// Segments that are needed for this error of v.
    pub(super) fn needed(&self, error: f64) -> f64 {
        self.sent as f64 * self.variance() / (error * error)
    }
}
