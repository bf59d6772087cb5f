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
    pub stretch: Stretch,
    pub points: usize,
    /// Where a cut saves points, and the points of both parts together.
    pub cut: Option<(f64, usize)>,
}

impl LineRule {
    pub(super) fn of(roots: &[Complex64], request: &Request) -> Self {
        let (stretch, points, slowest) = Self::whole(roots, request);
        let parts = |place: f64| {
            let part = |low: f64, width: f64| {
                let moved: Vec<Complex64> = roots.iter().map(|root| (root - low) / width).collect();
                Self::whole(&moved, &Request { fraction: request.fraction * width, ..*request }).1
            };
            (place, part(0.0, place) + part(place, 1.0 - place))
        };
        let cut = (points > FEW)
            .then(|| {
                [stretch.middle(), slowest.re, 0.5]
                    .into_iter()
                    .filter(|place| *place > 0.0 && *place < 1.0)
                    .map(parts)
                    .min_by_key(|(_, count)| *count)
            })
            .flatten()
            .filter(|(_, count)| *count < points || points > MOST_POINTS);
        Self { stretch, points, cut }
    }

    /// The better of the plain and the stretched rule, uncut, and the singularity that limits it.
    fn whole(roots: &[Complex64], request: &Request) -> (Stretch, usize, Complex64) {
        let Request { fraction, degree, eps } = *request;
        let rule = |stretch: Stretch| {
            let (rho, root) = roots.iter().map(|root| (stretch.ellipse(*root), *root)).fold(
                (f64::INFINITY, Complex64::ONE),
                |best, next| if next.0 < best.0 { next } else { best },
            );
            (stretch, stretch.points(rho, fraction, degree, eps), root)
        };
        let plain = rule(Stretch::PLAIN);
        if plain.1 <= FEW {
            return plain;
        }
        let stretched = rule(Stretch::around(plain.2.re, plain.2.im));
        if stretched.1 < plain.1 { stretched } else { plain }
    }

    /// The factor by which a cut saves points.
    pub(super) fn gain(&self) -> f64 {
        self.cut.map_or(0.0, |(_, count)| self.points as f64 / count as f64)
    }
}
