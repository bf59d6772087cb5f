//! What a block may err, and how many samples and rays it may take for it.

use crate::elements::patch::Patch;
use crate::transport::blocks::block::Accuracy;
use crate::transport::moments::Moments;

use crate::transport::pair::curved::size::area;

/// Samples of one block after which contacts are refined no more, per squared digit of 1/ε.
const CONTACT_SAMPLES: f64 = 5e5;
/// The same for horizons, whose samples are cheaper.
const HORIZON_SAMPLES: f64 = 1e6;
/// Part of the largest entry of its row below which a block gets less of these, and the least part of them it gets.
const SMALL_IN_ROW: f64 = 0.25;
const LEAST_WORTH: f64 = 0.25;
/// Rays of one block after which shadows of contacts and small parts are sampled by the coarsest rule, times the square of
/// their accuracy.
const RAYS: f64 = 1.0;
/// How many times the samples of contacts and horizons together a block may take before what is left is summed at once.
const OVERDRAFT: u64 = 2;
/// Parts that carry less than this times ε of the block are left out.
const NEGLIGIBLE: f64 = 1e-3;

/// What a block may err and take, and what horizons took of it.
pub(super) struct Budget {
    /// What is asked of the block.
    pub accuracy: Accuracy,
    /// What sampled shadows may err in an entry, a standard deviation.
    pub shadow_error: f64,
    /// √(A_i A_j): ∫∫κ over it is the block's first entry.
    pub unit: f64,
    /// About the block's first entry.
    pub scale: f64,
    /// About the largest entry of its row.
    pub row: f64,
    /// Samples spent on horizons.
    pub horizons: u64,
}

impl Budget {
    /// The error that entries of the block may have.
    pub(super) fn may_err(&self) -> f64 {
        self.accuracy.eps * self.scale
    }

    /// What a pair of parts can carry at the most, as a part of what a block can.
    pub(super) fn share(&self, p: &Patch, q: &Patch) -> f64 {
        area(p).min(area(q)) / self.unit
    }

    /// Whether parts of so large a share are left out.
    pub(super) fn neglects(&self, share: f64) -> bool {
        share < NEGLIGIBLE * self.may_err()
    }

    /// Whether nothing is looked at closer any more: parts that were queued when the samples were spent take their own.
    pub(super) fn overdrawn(&self, moments: &Moments) -> bool {
        moments.distinct > OVERDRAFT * (self.most(CONTACT_SAMPLES) + self.most_for_horizons())
    }

    /// Whether contacts may be refined no more.
    pub(super) fn spent(&self, moments: &Moments) -> bool {
        moments.distinct - self.horizons > self.most(CONTACT_SAMPLES)
    }

    /// Whether horizons may be cut no more.
    pub(super) fn horizons_spent(&self) -> bool {
        self.horizons > self.most_for_horizons()
    }

    /// Samples that horizons may still take.
    pub(super) fn left_for_horizons(&self) -> u64 {
        self.most_for_horizons().saturating_sub(self.horizons)
    }

    /// Samples that horizons may take: beyond four digits their need grows faster still.
    fn most_for_horizons(&self) -> u64 {
        (self.beyond() * self.most(HORIZON_SAMPLES) as f64) as u64
    }

    /// Digits over four where more are asked, else 1.
    pub(super) fn beyond(&self) -> f64 {
        (-0.25 * self.accuracy.eps.log10()).max(1.0)
    }

    /// Whether enough rays were cast for the accuracy of shadows: that of n rays is about 1/√n.
    pub(super) fn shadows_spent(&self, moments: &Moments) -> bool {
        let enough = self.worth() * RAYS / self.accuracy.shadow_eps.powi(2);
        moments.rays as f64 > enough
    }

    /// What part of all samples a block gets that is small beside its row.
    fn worth(&self) -> f64 {
        (self.scale / (SMALL_IN_ROW * self.row)).clamp(LEAST_WORTH, 1.0)
    }

    /// Samples that go with a number for each squared digit; fewer where less than four digits are asked and for a block that
    /// is small beside its row, more beyond four digits.
    fn most(&self, per_digit: f64) -> u64 {
        let digits = -self.accuracy.eps.log10().min(-2.0);
        let squared = (digits * digits).min(digits.powi(4) / 16.0);
        (self.worth() * per_digit * squared * self.beyond().powi(2)) as u64
    }

    /// Accuracy for a part that carries at most `share` of what a block can: small parts need fewer digits.
    pub(super) fn eps(&self, share: f64) -> f64 {
        (self.accuracy.eps * (0.25 * self.scale / share).max(1.0)).min(1e-2)
    }

    /// What of the most that a part of so large a `share` can carry may be wrong: blocks that carry little by grazing light allow
    /// less than their accuracy.
    pub(super) fn slight(&self, share: f64) -> f64 {
        self.accuracy.eps * (self.scale / share).min(1.0)
    }

    pub(super) fn part_eps(&self, p: &Patch, q: &Patch) -> f64 {
        self.eps(self.share(p, q))
    }
}
