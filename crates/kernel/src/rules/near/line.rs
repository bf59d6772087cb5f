//! The rule for one direction of a cell, plain or stretched, or where to cut the cell.

use num_complex::Complex64;
use radiosity_elements::rule::MOST_POINTS;

use crate::rules::near::stretch::Stretch;

/// Points for which no better rule is sought: one point less would save less than the search takes.
const FEW: usize = 2;

/// The integrand along one direction of a cell: part of the element's frame, degree, and accuracy.
pub(super) struct Request {
    pub fraction: f64,
    pub degree: usize,
    pub eps: f64,
}

/// The rule of one direction of a cell.
pub(super) struct LineRule {
    /// The rule, uncut.
    pub rule: StretchedRule,
    /// The cut that saves points.
    pub cut: Option<LineCut>,
}

/// A Gauss rule with its stretch.
#[derive(Clone, Copy, Debug)]
pub(super) struct StretchedRule {
    pub stretch: Stretch,
    pub points: usize,
}

impl StretchedRule {
    /// Nodes in [0, 1] with their weights.
    pub(super) fn nodes(&self) -> impl Iterator<Item = (f64, f64)> {
        self.stretch.nodes(self.points)
    }
}

/// A cut of a direction in two.
#[derive(Clone, Copy, Debug)]
pub(super) struct LineCut {
    /// Parameter of the cut, in (0, 1).
    pub place: f64,
    /// Points of both parts together.
    pub points: usize,
}

/// A rule with the singularity that limits it.
#[derive(Clone, Copy)]
struct LimitedRule {
    rule: StretchedRule,
    singularity: Complex64,
}

impl LineRule {
    pub(super) fn of(roots: &[Complex64], request: &Request) -> Self {
        let LimitedRule { rule, singularity } = Self::whole(roots, request);
        let StretchedRule { stretch, points } = rule;
        let parts = |place: f64| {
            let part = |low: f64, width: f64| {
                let moved: Vec<Complex64> = roots.iter().map(|root| (root - low) / width).collect();
                Self::whole(&moved, &Request { fraction: request.fraction * width, ..*request }).rule.points
            };
            LineCut { place, points: part(0.0, place) + part(place, 1.0 - place) }
        };
        let cut = (points > FEW)
            .then(|| {
                [stretch.middle(), singularity.re, 0.5]
                    .into_iter()
                    .filter(|place| *place > 0.0 && *place < 1.0)
                    .map(parts)
                    .min_by_key(|cut| cut.points)
            })
            .flatten()
            .filter(|cut| cut.points < points || points > MOST_POINTS);
        Self { rule, cut }
    }

    /// The better of the plain and the stretched rule, uncut.
    fn whole(roots: &[Complex64], request: &Request) -> LimitedRule {
        let Request { fraction, degree, eps } = *request;
        let rule = |stretch: Stretch| {
            let (rho, root) = roots.iter().map(|root| (stretch.ellipse(*root), *root)).fold(
                (f64::INFINITY, Complex64::ONE),
                |best, next| if next.0 < best.0 { next } else { best },
            );
            let points = stretch.points(rho, fraction, degree, eps);
            LimitedRule { rule: StretchedRule { stretch, points }, singularity: root }
        };
        let plain = rule(Stretch::PLAIN);
        if plain.rule.points <= FEW {
            return plain;
        }
        let stretched = rule(Stretch::around(plain.singularity.re, plain.singularity.im));
        if stretched.rule.points < plain.rule.points { stretched } else { plain }
    }

    /// The factor by which a cut saves points.
    pub(super) fn gain(&self) -> f64 {
        self.cut.map_or(0.0, |cut| self.rule.points as f64 / cut.points as f64)
    }
}
