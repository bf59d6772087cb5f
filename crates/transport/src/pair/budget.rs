//! The error allowed for a block, and the samples and rays it may take.

use radiosity_elements::patch::Patch;
use radiosity_kernel::Accuracy;
use radiosity_kernel::moments::Moments;

use crate::pair::size::area;
use crate::tolerances::{LOOSEST_OF_PARTS, NEGLIGIBLE};

/// Samples of a block after which contacts are refined no more, per squared digit of 1/ε: 5 ms at 10 ns each.
/// An arbitrary choice between the time of a block and the number of blocks that are left to rays.
const CONTACT_SAMPLES: f64 = 5e5;
/// Samples of a block after which horizons are refined no more, per squared digit of 1/ε. They are cheaper
/// than those of contacts, and twice as many take about as long.
const HORIZON_SAMPLES: f64 = 1e6;
/// Share of its row's largest entry below which a block gets fewer samples in proportion, since its error
/// weighs less.
const SMALL_IN_ROW: f64 = 0.25;
/// Least share of the samples that a small block gets: with fewer no rule converges.
const LEAST_WORTH: f64 = 0.25;
/// Rays of a block, times ε_shadow², after which shadows of contacts and small parts are sampled by the
/// coarsest rule: the error of n rays is about 1/√n.
const RAYS: f64 = 1.0;
/// Samples, as a multiple of those for contacts and horizons together, after which all that is left is summed
/// at once. Parts that were queued before the samples were spent are still attempted up to there.
const OVERDRAFT: u64 = 2;
/// Samples that take as long as to look how two parts lie to each other. Chosen: 10 µs against 10 ns.
const LOOK: u64 = 1000;

/// The error allowed for a block, and the samples it may take.
pub(super) struct Budget {
    pub accuracy: Accuracy,
    /// Standard deviation allowed in an entry from sampled shadows.
    pub shadow_error: f64,
    /// √(A_i A_j): ∫∫ κ dA dA / `unit` is the block's first entry.
    pub unit: f64,
    /// About the block's first entry, or the larger scale its error is measured against.
    pub scale: f64,
    /// About the largest entry of its row.
    pub row: f64,
    /// Samples spent on horizons.
    pub horizons: u64,
    /// Pairs of parts that were looked at.
    pub looks: u64,
}

impl Budget {
    /// The error allowed in an entry.
    pub(super) fn may_err(&self) -> f64 {
        self.accuracy.eps * self.scale
    }

    /// Upper bound of the first entry that a pair of parts adds: ∫κ dA ≤ 1 on either side.
    pub(super) fn share(&self, p: &Patch, q: &Patch) -> f64 {
        area(p).min(area(q)) / self.unit
    }

    /// Part of all pairs of points that two parts hold.
    pub(super) fn part(&self, p: &Patch, q: &Patch) -> f64 {
        area(p) * area(q) / (self.unit * self.unit)
    }

    /// Whether parts of this `share` are left out.
    pub(super) fn neglects(&self, share: f64) -> bool {
        share < NEGLIGIBLE * self.may_err()
    }

    /// Whether everything left is summed at once: parts already queued when the samples were spent take some
    /// too.
    pub(super) fn overdrawn(&self, moments: &Moments) -> bool {
        moments.distinct + LOOK * self.looks
            > OVERDRAFT * (self.most(CONTACT_SAMPLES) + self.most_for_horizons())
    }

    /// Whether contacts are refined no more.
    pub(super) fn spent(&self, moments: &Moments) -> bool {
        moments.distinct - self.horizons > self.most(CONTACT_SAMPLES)
    }

    /// Whether horizons are cut no more.
    pub(super) fn horizons_spent(&self) -> bool {
        self.horizons > self.most_for_horizons()
    }

    /// Samples left for horizons.
    pub(super) fn left_for_horizons(&self) -> u64 {
        self.most_for_horizons().saturating_sub(self.horizons)
    }

    /// Samples for horizons; beyond four digits they grow faster than those for contacts.
    fn most_for_horizons(&self) -> u64 {
        (self.beyond() * self.most(HORIZON_SAMPLES) as f64) as u64
    }

    /// A quarter of the digits asked, at least 1.
    pub(super) fn beyond(&self) -> f64 {
        (-0.25 * self.accuracy.eps.log10()).max(1.0)
    }

    /// Whether enough rays were cast for the accuracy of shadows.
    pub(super) fn shadows_spent(&self, moments: &Moments) -> bool {
        let enough = self.worth() * RAYS / self.accuracy.shadow_eps.powi(2);
        moments.rays as f64 > enough
    }

    /// Share of all samples for a block that is small compared with its row.
    fn worth(&self) -> f64 {
        (self.scale / (SMALL_IN_ROW * self.row)).clamp(LEAST_WORTH, 1.0)
    }

    /// Samples, given those per squared digit d²: for d < 4 they fall like d⁴/16, for d > 4 they grow like d²
    /// (d/4)², times [`Budget::worth`]. Both meet d² at d = 4. An arbitrary curve: few digits need few
    /// samples, and of many digits the last ones cost most.
    fn most(&self, per_digit: f64) -> u64 {
        let digits = -self.accuracy.eps.log10().min(-2.0);
        let squared = (digits * digits).min(digits.powi(4) / 16.0);
        (self.worth() * per_digit * squared * self.beyond().powi(2)) as u64
    }

    /// ε for a part of this `share`: small parts need fewer digits, and four parts of the scale may err by
    /// all of ε.
    pub(super) fn eps(&self, share: f64) -> f64 {
        (self.accuracy.eps * (0.25 * self.scale / share).max(1.0)).min(LOOSEST_OF_PARTS)
    }

    /// Allowed error of a part, relative to its upper bound `share`: less than ε where the block carries
    /// little, by grazing light.
    pub(super) fn slight(&self, share: f64) -> f64 {
        self.accuracy.eps * (self.scale / share).min(1.0)
    }

    pub(super) fn part_eps(&self, p: &Patch, q: &Patch) -> f64 {
        self.eps(self.share(p, q))
    }
}
