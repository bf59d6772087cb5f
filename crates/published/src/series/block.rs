//! The block of two elements as a power series of the displacement between them.

use radiosity_elements::patch::Patch;
use radiosity_geom::touching;
use radiosity_kernel::terms::{Demand, PatchPair, blocks};

use super::error::SeriesError;
use super::faces::Faces;
use super::pair::TranslatedPair;
use super::remainder::tail;
use super::samples::Samples;
use super::settings::Settings;
use super::span::Span;

/// Halvings of the range in which the radius is sought, for 9 digits of it: more than a bound of a remainder
/// has.
const BISECTIONS: usize = 30;

/// G(p) ≈ Σ_{n ≤ N} Φ_n (p − centre)ⁿ of two flat elements, without anything between them.
#[derive(Clone, Debug)]
pub struct BlockSeries {
    centre: f64,
    /// Where the series may be evaluated.
    range: Span,
    /// Displacement for which it holds at the most on either side of the centre.
    radius: f64,
    /// Φ_n, each row-major, receiver's functions by emitter's.
    terms: Vec<Vec<f64>>,
    remainder: Remainder,
    /// Error of the rules (no unit).
    rule_error: f64,
    samples: u64,
}

/// A block at one displacement.
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
    /// (∫∫ b²_{N+1} dA dA)^½.
    first: f64,
    /// Least distance of the elements over the length of the direction.
    convergence: f64,
}

impl Remainder {
    fn at(&self, step: f64) -> f64 {
        if self.first == 0.0 || step == 0.0 {
            return 0.0;
        }
        self.first * step.powi(self.orders as i32 + 1) * tail(self.orders, step / self.convergence)
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

/// The pairs of parts that face each other.
struct Facing {
    pairs: Vec<PatchPair>,
    /// p − centre for which they do.
    span: Span,
    /// Their least distance (scene length).
    distance: f64,
}

impl BlockSeries {
    /// Expands the block of `pair` about p = `centre`.
    ///
    /// # Errors
    /// A tolerance out of range; elements that touch or nearly do there, or of which one passes through the
    /// plane of the other.
    pub fn new(pair: &TranslatedPair, centre: f64, settings: Settings) -> Result<Self, SeriesError> {
        settings.checked()?;
        let Settings { orders, tolerance } = settings;
        let shift = pair.offset + pair.direction * centre;
        let facing = facing(pair, centre, &settings)?;
        let mut samples = Samples { shift, direction: pair.direction, orders };
        let elements = [pair.receiver, pair.emitter];
        let (mut terms, count) = blocks(elements, &facing.pairs, &mut samples);
        // φ_0 φ_0 = (A_i A_j)^−½ times the integral.
        let area = (pair.receiver.area * pair.emitter.area).sqrt();
        let squares = terms.pop().map_or(0.0, |block| block[0]) * area;
        let convergence = facing.distance / pair.direction.length();
        let remainder = Remainder { orders, first: squares.sqrt(), convergence };
        let largest = terms[0].iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        let rule_error = 0.5 * tolerance * largest;
        let radius = remainder.reach(settings.reach() * convergence, rule_error);
        let range = facing.span.common(&Span { from: -radius, to: radius }).moved(centre);
        Ok(Self { centre, range, radius, terms, remainder, rule_error, samples: count })
    }

    /// The displacements at which the series may be evaluated: within its radius, and as long as the same
    /// parts of the elements face each other.
    pub fn range(&self) -> Span {
        self.range
    }

    /// The largest |p − centre| for which the bound of what is left out is half the tolerance and the rules
    /// have enough points; infinite where the elements do not face each other.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The |p − centre| below which the series converges: the least distance of the elements at the centre,
    /// over the length of the direction.
    pub fn convergence(&self) -> f64 {
        self.remainder.convergence
    }

    /// Bound of what the powers left out add to an entry at p; infinite where the series diverges.
    pub fn remainder(&self, p: f64) -> f64 {
        self.remainder.at((p - self.centre).abs())
    }

    /// Φ_n, row-major, receiver's functions by emitter's, 1/lengthⁿ where the direction is a length; n = 0 …
    /// N.
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
    /// A displacement outside the range.
    pub fn at(&self, p: f64) -> Result<MovedBlock, SeriesError> {
        if !self.range.contains(p) {
            return Err(SeriesError::Range { p, range: self.range });
        }
        Ok(MovedBlock { values: self.sum(p), error: self.remainder(p) + self.rule_error })
    }

    /// Σ Φ_n (p − centre)ⁿ at any p, also where it is no block.
    pub fn sum(&self, p: f64) -> Vec<f64> {
        let step = p - self.centre;
        let mut values = vec![0.0; self.terms[0].len()];
        for term in self.terms.iter().rev() {
            values.iter_mut().zip(term).for_each(|(value, phi)| *value = *value * step + phi);
        }
        values
    }
}

/// The parts of a pair that face each other at p = `centre`, with points for rules as `settings` demand.
fn facing(pair: &TranslatedPair, centre: f64, settings: &Settings) -> Result<Facing, SeriesError> {
    let TranslatedPair { receiver, emitter, direction, offset } = *pair;
    let [small, large] = [f64::min, f64::max].map(|of| of(receiver.extent, emitter.extent));
    let degrees = [receiver, emitter].map(|element| element.basis.total_degree());
    let (nearest, eps) = (1.0 - settings.reach(), 0.5 * settings.tolerance);
    let demand = Demand { shift: offset + direction * centre, degrees, nearest, eps };
    let mut facing = Facing { pairs: Vec::new(), span: Span::ALL, distance: f64::INFINITY };
    let pairs = receiver.patches.iter().flat_map(|p| emitter.patches.iter().map(move |q| [p, q]));
    for [p, q] in pairs {
        let surfaces = pair.surfaces();
        match Faces::of([p, q], demand.shift, direction, touching(small, large)) {
            None | Some(Faces::Changing) => return Err(SeriesError::Horizon { surfaces, at: centre }),
            Some(Faces::Nothing(span)) => facing.span = facing.span.common(&span),
            Some(Faces::Parts(parts, span)) => {
                facing.span = facing.span.common(&span);
                facing.add(&demand, &parts).ok_or(SeriesError::Touching { surfaces, at: centre })?;
            }
        }
    }
    Ok(facing)
}

impl Facing {
    /// Adds the pairs of `parts`; None where they touch.
    fn add(&mut self, demand: &Demand, [of_receiver, of_emitter]: &[Vec<Patch>; 2]) -> Option<()> {
        for p in of_receiver {
            for q in of_emitter {
                self.pairs.extend(demand.divided(p, q)?);
                self.distance = self.distance.min(demand.distance(p, q));
            }
        }
        Some(())
    }
}
