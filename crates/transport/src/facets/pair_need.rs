//! Segments that a pair needs, and the error that may be asked of all pairs where there are only so many.
//!
//! With the unhidden exchange x of a pair, the part v of it that segments see, the smaller F of the largest exchanges
//! of both rows and the larger share s of x in either, a pair needs for the error e F
//!
//! ```text
//! n = v (1 − v) (x/e F)²                 where a part of it is hidden ,
//! n = max(min(10 s, 1), x/(2 F)) / e     where all segments agree ,
//! ```
//!
//! between some least and most numbers. Few pairs of large x need most of the segments. The error e is that at which
//! all pairs together need as many as there are, and no less than what is asked for, so that none of them is found
//! much better than others of its rows.

use super::row_size::RowSize;

/// Fewest segments of a pair of which a part is hidden, and most of a pair. Chosen.
const FEWEST: f64 = 16.0;
const MOST: f64 = 16_384.0;

/// Part of an exchange that segments that agree may miss, over the error asked for. Chosen: what is missed is then no
/// more than what rays leave in pairs of which a part is hidden.
const MISSED: f64 = 2.0;

/// Share of a row from which a pair has the most segments where all agree, and smaller ones in proportion. Chosen: a
/// row has ten times the most of a pair.
const LARGE: f64 = 0.1;

/// Errors are halved so often between what is asked for and all of an exchange, so that they are known to a thousandth.
const HALVINGS: usize = 14;

/// The sizes of a pair against those of its rows, on which its segments depend.
#[derive(Clone, Copy, Debug)]
pub(super) struct PairNeed {
    /// Its unhidden exchange over the smaller of the largest ones of its rows.
    ratio: f64,
    /// The larger share of that exchange in its rows.
    share: f64,
}

impl PairNeed {
    /// The need of a pair of this unhidden exchange (length²) in rows of these sizes.
    pub(super) fn of(whole: f64, ends: [RowSize; 2]) -> Self {
        let share = ends.map(|size| whole / size.sum.max(whole)).into_iter().fold(0.0, f64::max);
        Self { ratio: whole / ends[0].largest.min(ends[1].largest), share }
    }

    /// Error of its part v at which its exchange errs by `eps` of the largest one.
    pub(super) fn error(&self, eps: f64) -> f64 {
        eps / self.ratio
    }

    /// Segments that it has at the least.
    pub(super) fn fewest(&self, eps: f64, first: u64) -> u64 {
        FEWEST.min(self.ratio / eps).max(first as f64) as u64
    }

    /// Segments that it needs where all agree.
    pub(super) fn agreeing(&self, eps: f64) -> u64 {
        let missed = self.ratio / (MISSED * eps);
        missed.max(agreeing(self.share, eps)).min(MOST) as u64
    }

    /// Segments that it needs of this part and these first ones.
    fn segments(&self, part: f64, eps: f64, first: u64) -> u64 {
        let needed = match part {
            0.0 | 1.0 => self.agreeing(eps),
            _ => (part * (1.0 - part) / self.error(eps).powi(2)).min(MOST) as u64,
        };
        needed.max(self.fewest(eps, first))
    }
}

/// Segments of a pair of this share of a row, where all agree.
fn agreeing(share: f64, eps: f64) -> f64 {
    (share / LARGE).min(1.0) / eps
}

/// Largest share of pairs that have no more than so many segments where all agree.
pub(super) fn largest(segments: u64, eps: f64) -> f64 {
    let part = segments as f64 * eps;
    if part < 1.0 { LARGE * part } else { f64::INFINITY }
}

/// Most segments of a pair.
pub(super) fn most() -> u64 {
    MOST as u64
}

/// The error, no less than `eps`, for which pairs of these needs and parts, that have had so many `first` segments,
/// need no more than so many in all.
pub(super) fn affordable(pairs: &[(PairNeed, f32)], eps: f64, first: u64, segments: f64) -> f64 {
    let needed = |eps: f64| {
        let own = pairs.iter().map(|(need, part)| need.segments(f64::from(*part), eps, first));
        own.sum::<u64>() as f64
    };
    if needed(eps) <= segments {
        return eps;
    }
    let mut between = [eps, 1.0];
    for _ in 0..HALVINGS {
        let middle = (between[0] * between[1]).sqrt();
        between[usize::from(needed(middle) <= segments)] = middle;
    }
    between[1]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A thousand pairs, half hidden by a half, as large as the largest of their rows, have ε² = v (1 − v) N/n.
    #[test]
    fn pairs_share_what_there_is() {
        let size = RowSize { largest: 1.0, sum: 4.0 };
        let pairs = vec![(PairNeed::of(1.0, [size; 2]), 0.5_f32); 1000];
        assert_eq!(affordable(&pairs, 1e-2, 16, 1e8), 1e-2);
        let eps = affordable(&pairs, 1e-3, 16, 1e6);
        assert!((eps / (0.25_f64 * 1e3 / 1e6).sqrt() - 1.0).abs() < 5e-3, "{eps}");
    }

    /// Pairs whose segments agree need one over the error.
    #[test]
    fn pairs_whose_segments_agree_need_few() {
        let size = RowSize { largest: 1.0, sum: 1.0 };
        let pairs = vec![(PairNeed::of(1.0, [size; 2]), 1.0_f32); 100];
        let eps = affordable(&pairs, 1e-3, 16, 1e4);
        assert!((eps / 1e-2 - 1.0).abs() < 2e-2, "{eps}");
    }
}
