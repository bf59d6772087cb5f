//! Segments between two facets, which tell the part of their exchange that nothing hides.
//!
//! Their ends are spread evenly over either facet. Each [`TOGETHER`] of them are paired at random: in one
//! sequence of both ends, or by a fixed step, numbers of two of the four dimensions lie on a few lines, as do
//! bars that stand along what is between.
//!
//! Where few of them carry most of the exchange, as beside a common edge, the end of each is drawn among sixteen by
//! what it would carry, and each segment stands for the mean of these (J. Talbot, D. Cline, P. Egbert, *EGSR* (2005)
//! 139-146).

use radiosity_elements::sampling::shift::shift;
use radiosity_geom::DVec3;
use radiosity_visibility::Visibility;

use super::facet::{End, Facet};

/// Segments whose ends are paired among themselves.
pub(super) const TOGETHER: u64 = 16;

/// Places of the partners of the ends of a round, each once.
type Partners = [u8; TOGETHER as usize];

/// Ends among which that of a segment is drawn.
type Candidates = [DVec3; TOGETHER as usize];

/// Segments between two facets, from the first on.
pub(super) struct Segments<'a> {
    facets: [&'a Facet; 2],
    /// The surface that they start on.
    surface: usize,
    visibility: &'a Visibility,
    /// Number of the pair.
    number: u64,
    partners: Partners,
    chooses_ends: bool,
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
        let [one, two] = facets.map(Facet::number);
        let number = (one << 32) ^ two;
        Self {
            facets,
            surface,
            visibility,
            number,
            partners: partners(number, 0),
            chooses_ends: false,
            sent: 0,
            all: 0.0,
            free: 0.0,
            squares: 0.0,
            free_squares: 0.0,
        }
    }

    /// Sends segments until there are so many.
    pub(super) fn send(&mut self, count: u64) {
        for index in self.sent..count {
            let (ends, kernel) = self.next(index);
            self.all += kernel;
            self.squares += kernel * kernel;
            if kernel > 0.0 && self.visibility.is_free(Some(self.surface), ends[0], ends[1]) {
                self.free += kernel;
                self.free_squares += kernel * kernel;
            }
        }
        self.sent = self.sent.max(count);
    }

    /// Begins again, with ends that are drawn by what segments to them carry.
    pub(super) fn choose_ends(&mut self) {
        let Self { facets: [first, other], surface, visibility, .. } = *self;
        *self = Self { chooses_ends: true, ..Self::between(first, other, surface, visibility) };
    }

    /// The ends of the segment of this index, the next one, and what it stands for (length⁻²).
    fn next(&mut self, index: u64) -> ([DVec3; 2], f64) {
        let [first, other] = self.facets;
        let start = first.point(End::Start, index);
        if !self.chooses_ends {
            let ends = [start, other.point(End::Stop, self.partner(index))];
            return (ends, first.kernel(ends, other));
        }
        let candidates = index * TOGETHER;
        let stops: Candidates =
            std::array::from_fn(|place| other.point(End::Stop, candidates + place as u64));
        let kernels = stops.map(|stop| first.kernel([start, stop], other));
        let sum: f64 = kernels.iter().sum();
        let [draw] = shift::<1>(self.number.wrapping_add(index << 20).wrapping_mul(TOGETHER));
        let mut left = draw * sum;
        let is_drawn = |kernel: &f64| {
            left -= kernel;
            left < 0.0
        };
        let place = kernels.iter().position(is_drawn).unwrap_or(0);
        ([start, stops[place]], sum / TOGETHER as f64)
    }

    /// The end where the segment stops that starts at the end of this index, the next one.
    fn partner(&mut self, index: u64) -> u64 {
        let (round, place) = (index / TOGETHER, index % TOGETHER);
        if place == 0 && round > 0 {
            self.partners = partners(self.number, round);
        }
        round * TOGETHER + u64::from(self.partners[place as usize])
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

    /// Segments for each that tells as much as one of one kernel.
    pub(super) fn spread(&self) -> f64 {
        self.sent as f64 / self.carrying().max(1.0)
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

    /// The variance of v, no less than the square of the part by which as many segments of one kernel may be wrong if
    /// they agree: where few carry most of the exchange, these may agree by chance.
    pub(super) fn variance(&self) -> f64 {
        let least = (self.carrying() + 2.0).powi(-2);
        if self.all <= 0.0 {
            return least;
        }
        let v = self.part();
        let sum = (1.0 - 2.0 * v) * self.free_squares + v * v * self.squares;
        (sum / (self.all * self.all)).max(least)
    }

    /// Segments that are needed for this error of v.
    pub(super) fn needed(&self, error: f64) -> f64 {
        self.sent as f64 * self.variance() / (error * error)
    }
}

/// The partners of a round of a pair: a permutation by random draws (R. Durstenfeld, *Comm. ACM* 7 (1964) 420).
fn partners(pair: u64, round: u64) -> Partners {
    let draws = shift::<{ TOGETHER as usize }>(pair.wrapping_add(round << 20).wrapping_mul(TOGETHER));
    let mut partners: Partners = std::array::from_fn(|place| place as u8);
    for (place, draw) in draws.into_iter().enumerate().skip(1) {
        partners.swap(place, (draw * (place + 1) as f64) as usize);
    }
    partners
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A fixed step from partner to partner would put numbers of both ends on a few lines.
    #[test]
    fn ends_are_paired_once_in_a_round_and_by_no_step() {
        const PAIRS: u64 = 16_000;
        let mut steps = [0u64; TOGETHER as usize];
        for pair in 0..PAIRS {
            let partners = partners(pair, pair % 3);
            let mut sorted = partners;
            sorted.sort_unstable();
            assert!(sorted.iter().copied().eq(0..TOGETHER as u8), "{partners:?}");
            steps[usize::from((16 + partners[8] - partners[7]) % 16)] += 1;
        }
        let usual = PAIRS as f64 / (TOGETHER - 1) as f64;
        let is_usual = |count: &u64| (*count as f64 - usual).abs() < 5.0 * usual.sqrt();
        assert!(steps[0] == 0 && steps[1..].iter().all(is_usual), "{steps:?}");
    }
}
