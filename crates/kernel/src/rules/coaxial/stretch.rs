//! Map t = c + w sinh μ of the unit interval onto itself, linear in μ.
//!
//! Functions with poles at c ± iw are smooth in μ, the more so the smaller the interval of μ, which grows like
//! ln 1/w. Poles beside the interval, on its line, have the distance from it for w: steps toward it shrink
//! geometrically. Places are known to rounding, and w is no less.

use radiosity_geom::DVec2;

/// A stretched parameter from 0 to 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretch {
    center: f64,
    width: f64,
    /// μ at 0, and its range.
    first: f64,
    range: f64,
}

impl Stretch {
    /// The map for a pole c + iw.
    pub(super) fn about(pole: DVec2) -> Self {
        let center = pole.x;
        let width = pole.y.max(-center).max(center - 1.0).max(f64::EPSILON);
        let [first, last] = [0.0, 1.0].map(|t| ((t - center) / width).asinh());
        Self { center, width, first, range: last - first }
    }

    /// The place at a parameter, and its change with that.
    pub(super) fn at(&self, parameter: f64) -> (f64, f64) {
        let mu = self.first + parameter * self.range;
        ((self.center + self.width * mu.sinh()).clamp(0.0, 1.0), self.width * mu.cosh() * self.range)
    }
}

#[cfg(test)]
mod tests {
    use radiosity_core::gauss::Legendre;

    use super::*;

    #[test]
    fn peaks_are_integrated_however_narrow() {
        for (center, width) in [(0.3, 1e-3), (0.3, 1e-8), (-0.1, 1e-3), (1.0, 1e-5), (2.0, 0.5)] {
            let stretch = Stretch::about(DVec2::new(center, width));
            let peak = |parameter: f64| {
                let (t, change) = stretch.at(parameter);
                change * width / ((t - center).powi(2) + width * width)
            };
            let parts = 8;
            let of_part = |k: i32| {
                let at = |x: f64| (f64::from(k) + 0.5 + 0.5 * x) / f64::from(parts);
                0.5 / f64::from(parts) * Legendre::<16>::RULE.sum(|x| peak(at(x)))
            };
            let found: f64 = (0..parts).map(of_part).sum();
            let right = ((1.0 - center) / width).atan() + (center / width).atan();
            assert!((found - right).abs() < 1e-9 * right, "{center} {width}: {found} {right}");
        }
    }
}
