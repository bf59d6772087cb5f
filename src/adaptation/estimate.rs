//! The error of a run, from how its coefficients decay and how far it is from the run before.
//!
//! With g and a the geometric and the algebraic [tail](super::tail) and d the difference of the run from the one before,
//!
//! ```text
//! smooth:     e ≈ g
//! singular:   e ≈ ¾ √(min(a, D) D) ,   D = max(d, g) .
//! ```
//!
//! Radiosity is smooth where flat surfaces neither touch nor shade each other; on a curved one it has a kink where the horizon
//! crosses what shines. At edges and shadows a few degrees do not show how slow the
//! decay will be: a alone is much too large while the smooth part of the light still prevails, and d is the error of the
//! run before. The factor was chosen such that the estimate of the empty box, of hinges and of shaded plates lies about the error.
//!
//! From the third run on, the estimate e′ of the run before can be judged, √(d² + e²) being its error; half of what it was wrong by,
//! in the logarithm, is taken for a fault of the present one as well:
//!
//! ```text
//! e ← e √(√(d² + e²)/e′) ,    by a factor of two at the most.
//! ```
//!
//! What the transfers may miss acts on many blocks at random: it is added as a tenth of the largest, as a sum of squares.

use crate::elements::Element;
use crate::solve::{Options, Outcome};

use super::tail::Tail;

/// Middle of the error between both bounds in a singular scene.
const MIDDLE: f64 = 0.75;

/// Most by which the fault of the estimate before changes one.
const LARGEST_FAULT: f64 = 2.0;

/// Part of what a transfer may miss that the radiosity misses.
const TRANSFERRED: f64 = 0.1;

/// Judges run after run.
#[derive(Debug, Default)]
pub(super) struct Estimator {
    before: Option<f64>,
}

impl Estimator {
    /// The relative error of `outcome`, which differs from the run before by `difference`.
    pub(super) fn estimate(&mut self, outcome: &Outcome, options: &Options, difference: f64) -> f64 {
        let Tail { geometric, algebraic } = Tail::of(&outcome.solution);
        let mut error = geometric;
        if is_singular(outcome) {
            let most = difference.max(geometric);
            error = MIDDLE * (algebraic.min(most) * most).sqrt();
            if let Some(before) = self.before {
                let fault = (difference.hypot(error) / before).sqrt();
                error *= fault.clamp(1.0 / LARGEST_FAULT, LARGEST_FAULT);
            }
        }
        self.before = Some(error).filter(|error| *error > 0.0);
        error.hypot(TRANSFERRED * missed(outcome, options))
    }
}

/// Whether surfaces touch or shade each other, or bend.
fn is_singular(outcome: &Outcome) -> bool {
    let pairs = &outcome.pairs;
    let bends = |element: &Element| element.plane.is_none();
    pairs.edge + pairs.vertex + pairs.contact + pairs.partly_hidden > 0
        || outcome.solution.elements().list().iter().any(bends)
}

/// What the worst transfer may miss, as part of it.
fn missed(outcome: &Outcome, options: &Options) -> f64 {
    let accuracy = options.accuracy();
    let shadows = if outcome.pairs.partly_hidden > 0 { accuracy.shadow_eps } else { 0.0 };
    accuracy.eps.max(shadows).max(outcome.accuracy_reached)
}
