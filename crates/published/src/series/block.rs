//! The block of two elements as a power series along the motion between them.

use radiosity_kernel::terms::blocks;

use super::error::SeriesError;
use super::facing::Facing;
use super::motion::RelativeMotion;
use super::pair::MovedPair;
use super::remainder::tail;
use super::samples::Samples;
use super::settings::Settings;
use super::span::Span;

/// Halvings of the range in which the radius is sought, for 9 digits of it: more than a bound of a remainder
/// has.
const BISECTIONS: usize = 30;

/// G(p) ≈ Σ_{n ≤ N} Φ_n tⁿ of two flat elements, without anything between them, t = p − centre, or tan((p −
/// centre)/2) where one turns.
#[derive(Clone, Debug)]
pub struct BlockSeries {
    centre: f64,
    motion: RelativeMotion,
    /// Where the series may be evaluated.
    range: Span,
    /// t for which it holds at the most on either side of the centre.
    radius: f64,
    /// Φ_n, each row-major, receiver's functions by emitter's.
    terms: Vec<Vec<f64>>,
    remainder: Remainder,
    /// Error of the rules (no unit).
    rule_error: f64,
    samples: u64,
}

/// A block at one p.
#[derive(Clone, Debug, PartialEq)]
pub struct MovedBlock {
    /// G_kl, row-major, receiver's functions by emitter's.
    pub values: Vec<f64>,
    /// Bound of the error of an entry.
    pub error: f64,
}

/// Data of the bound of the powers left out.
#[derive(Clone, Copy, Debug)]
struct Remainder {
    orders: usize,
    /// Degree of the numerator of the kernel.
    degree: usize,
    /// (∫∫ b²_{N+1} dA dA)^½.
    first: f64,
    /// The t below which the series converges.
    convergence: f64,
}

impl Remainder {
    fn at(&self, step: f64) -> f64 {
        if self.first == 0.0 || step == 0.0 {
            return 0.0;
        }
        self.first
            * step.powi(self.orders as i32 + 1)
            * tail(self.orders, self.degree, step / self.convergence)
    }

    /// The largest step within `most` of which the remainder is at most `limit`.
    fn reach(&self, most: f64, limit: f64) -> f64 {
        if self.at(most) <= limit {
            return most;
        }
        let (mut low, mut high) = (0.0, most);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            *(if self.at(middle) <= limit { &mut low } else { &mut high }) = middle;
        }
        low
    }
}

impl BlockSeries {
    /// Expands the block of `pair` about p = `centre`.
    ///
    /// # Errors
    /// A tolerance out of range; elements that touch or nearly do there, or of which one passes through the
    /// plane of the other.
    pub fn new(pair: &MovedPair, centre: f64, settings: Settings) -> Result<Self, SeriesError> {
        Ok(Self::of(&Facing::of(pair, centre, settings)?))
    }

    /// Expands the block of parts that face each other.
    pub(crate) fn of(facing: &Facing) -> Self {
        let Facing { pair, centre, settings: Settings { orders, tolerance }, convergence, .. } = *facing;
        let MovedPair { receiver, emitter, motion, .. } = pair;
        let mut kernel = Samples { place: pair.place(centre), motion, orders };
        let (mut terms, samples) = blocks([receiver, emitter], &facing.parts, &mut kernel);
        // φ_0 φ_0 = (A_i A_j)^−½ times the integral.
        let area = (receiver.area * emitter.area).sqrt();
        let squares = terms.pop().map_or(0.0, |block| block[0]) * area;
        let remainder = Remainder { orders, degree: motion.degree(), first: squares.sqrt(), convergence };
        let largest = terms[0].iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        let rule_error = 0.5 * tolerance * largest;
        let radius = remainder.reach(facing.most(), rule_error);
        let range = facing.within(radius);
        Self { centre, motion, range, radius, terms, remainder, rule_error, samples }
    }

    /// The p at which the series may be evaluated: within its radius, and as long as the same
    /// parts of the elements face each other.
    pub fn range(&self) -> Span {
        self.range
    }

    /// The largest |p − centre| for which the bound of what is left out is half the tolerance and the rules
    /// have enough points; infinite where the elements do not face each other.
    pub fn radius(&self) -> f64 {
        self.motion.step(self.radius)
    }

    /// A |p − centre| below which the series converges: of a translation the least distance of the elements at
    /// the centre, over the length of the direction.
    pub fn convergence(&self) -> f64 {
        self.motion.step(self.remainder.convergence)
    }

    /// Bound of what the powers left out add to an entry at p; infinite where the series diverges.
    pub fn remainder(&self, p: f64) -> f64 {
        self.remainder.at(self.motion.variable(p - self.centre).abs())
    }

    /// Φ_n, row-major, receiver's functions by emitter's, 1/lengthⁿ where p is a length; n = 0 … N.
    pub fn terms(&self) -> &[Vec<f64>] {
        &self.terms
    }

    /// Pairs of points at which the kernel was expanded.
    pub fn samples(&self) -> u64 {
        self.samples
    }

    /// The block at p, in 2 N multiplications an entry.
    ///
    /// # Errors
    /// A p outside the range.
    pub fn at(&self, p: f64) -> Result<MovedBlock, SeriesError> {
        if !self.range.contains(p) {
            return Err(SeriesError::Range { p, range: self.range });
        }
        Ok(MovedBlock { values: self.sum(p), error: self.remainder(p) + self.rule_error })
    }

    /// Σ Φ_n tⁿ at any p, also where it is no block.
    pub fn sum(&self, p: f64) -> Vec<f64> {
        let step = self.motion.variable(p - self.centre);
        let mut values = vec![0.0; self.terms[0].len()];
        for term in self.terms.iter().rev() {
            values.iter_mut().zip(term).for_each(|(value, phi)| *value = *value * step + phi);
        }
        values
    }
}
