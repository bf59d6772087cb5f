//! Patterns: how reflectance or emission varies over a surface.
//!
//! ```text
//! q(u, v) ,     (u, v) ∈ [−1, 1]², the parameters of the surface, one q per band
//! ```
//!
//! is a polynomial Σ c_ij u^i v^j, or constant on every texel of a grid. A grid of m × n texels lies on the surface by the
//! coordinates
//!
//! ```text
//! s = o_s + k_s (u + 1)/2 ,     t = o_t + k_t (v + 1)/2 ,
//! ```
//!
//! texel (i, j) being i/m ≤ s < (i + 1)/m, j/n ≤ t < (j + 1)/n; beyond [0, 1)² the grid is repeated, mirrored, or its border
//! is continued. Texels are not interpolated: the mean of a whole grid is then the mean of its numbers.

use crate::scene::error::Fault;
use crate::scene::ranges::check_range;

/// How a number per band varies over a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Pattern(Kind);

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Polynomial(Vec<Polynomial>),
    Texels(Texels),
}

/// Σ c_ij u^i v^j of one band.
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial(Vec<Term>);

/// c u^i v^j.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// i.
    pub u: u32,
    /// j.
    pub v: u32,
    /// c.
    pub factor: f64,
}

/// A grid of texels and how it lies on the surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Texels {
    columns: usize,
    rows: usize,
    /// Band after band, row after row from v = −1, each along u.
    values: Vec<Vec<f64>>,
    placement: Placement,
}

/// How a grid lies on a surface; see the head of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// (o_s, o_t).
    pub offset: [f64; 2],
    /// (k_s, k_t), how often the grid fits along u and along v.
    pub scale: [f64; 2],
    /// What is beyond the grid.
    pub wrap: Wrap,
}

/// What is beyond a grid of texels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// The grid again.
    #[default]
    Repeat,
    /// The grid mirrored at its border.
    Mirror,
    /// The texels of its border.
    Clamp,
}

impl Default for Placement {
    /// Once over the whole surface.
    fn default() -> Self {
        Self { offset: [0.0; 2], scale: [1.0; 2], wrap: Wrap::Repeat }
    }
}

impl Pattern {
    /// A polynomial per band.
    pub fn polynomial(bands: Vec<Polynomial>) -> Self {
        Self(Kind::Polynomial(bands))
    }

    /// A grid of `columns` × `rows` texels; `values` are given band after band, row after row from v = −1, each along u.
    ///
    /// # Errors
    /// [`Fault::OutOfRange`] where a band has another count of numbers, or none.
    pub fn texels(columns: usize, values: Vec<Vec<f64>>, placement: Placement) -> Result<Self, Fault> {
        let count = values.first().map_or(0, Vec::len);
        let is_full = columns > 0 && count > 0 && count % columns == 0;
        let is_full = is_full && values.iter().all(|band| band.len() == count);
        check_range(columns as f64, is_full, "the number of columns", "as many as make whole rows")?;
        Ok(Self(Kind::Texels(Texels { columns, rows: count / columns, values, placement })))
    }

    /// Number of bands.
    pub fn bands(&self) -> usize {
        match &self.0 {
            Kind::Polynomial(bands) => bands.len(),
            Kind::Texels(texels) => texels.values.len(),
        }
    }

    /// q of a band at (u, v).
    pub fn at(&self, band: usize, parameters: [f64; 2]) -> f64 {
        match &self.0 {
            Kind::Polynomial(bands) => bands[band].at(parameters),
            Kind::Texels(texels) => texels.values[band][texels.index(parameters)],
        }
    }

    /// Total degree, where all bands are polynomials.
    pub fn degree(&self) -> Option<u32> {
        match &self.0 {
            Kind::Polynomial(bands) => {
                bands.iter().flat_map(|band| &band.0).map(|term| term.u + term.v).max().or(Some(0))
            }
            Kind::Texels(_) => None,
        }
    }

    /// The parameters along u, and along v, at which q may jump, within (−1, 1), ascending.
    pub fn breaks(&self) -> [Vec<f64>; 2] {
        match &self.0 {
            Kind::Polynomial(_) => [Vec::new(), Vec::new()],
            Kind::Texels(Texels { columns, rows, placement, .. }) => {
                [0, 1].map(|axis| placement.breaks(axis, [*columns, *rows][axis]))
            }
        }
    }
}

impl Polynomial {
    /// The sum of these terms.
    pub fn new(terms: impl IntoIterator<Item = Term>) -> Self {
        Self(terms.into_iter().collect())
    }

    fn at(&self, [u, v]: [f64; 2]) -> f64 {
        self.0.iter().map(|term| term.factor * u.powi(term.u as i32) * v.powi(term.v as i32)).sum()
    }
}

impl Texels {
    fn index(&self, parameters: [f64; 2]) -> usize {
        let counts = [self.columns, self.rows];
        let [i, j] = [0, 1].map(|axis| self.placement.texel(axis, counts[axis], parameters[axis]));
        i + self.columns * j
    }
}

impl Placement {
    /// The texel at a parameter along an axis of `count` texels.
    fn texel(&self, axis: usize, count: usize, parameter: f64) -> usize {
        let s = self.offset[axis] + self.scale[axis] * 0.5 * (parameter + 1.0);
        let place = (s * count as f64).floor();
        let all = count as f64;
        let place = match self.wrap {
            // The end of the surface belongs to its last texel, not to the first of a grid that is not there.
            _ if parameter >= 1.0 && self.scale[axis] > 0.0 && place == (s * all) => place - 1.0,
            _ => place,
        };
        let place = match self.wrap {
            Wrap::Repeat => place.rem_euclid(all),
            Wrap::Clamp => place.clamp(0.0, all - 1.0),
            Wrap::Mirror => {
                let place = place.rem_euclid(2.0 * all);
                if place < all { place } else { 2.0 * all - 1.0 - place }
            }
        };
        place as usize
    }

    /// The parameters along an axis between texels.
    fn breaks(&self, axis: usize, count: usize) -> Vec<f64> {
        let (offset, scale, all) = (self.offset[axis], self.scale[axis], count as f64);
        let ends = [offset * all, (offset + scale) * all];
        let (low, high) = (ends[0].min(ends[1]).ceil() as i64, ends[0].max(ends[1]).floor() as i64);
        let at = |k: i64| 2.0 * (k as f64 / all - offset) / scale - 1.0;
        let mut breaks: Vec<f64> = (low..=high).map(at).filter(|x| x.abs() < 1.0).collect();
        breaks.sort_by(f64::total_cmp);
        breaks
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(placement: Placement) -> Pattern {
        let values = vec![vec![0.0, 0.1, 0.2, 1.0, 1.1, 1.2]];
        Pattern::texels(3, values, placement).expect("two rows of three")
    }

    #[test]
    fn texels_lie_from_the_lowest_parameters_on() {
        let plain = grid(Placement::default());
        let at = |u, v| plain.at(0, [u, v]);
        assert_eq!([at(-1.0, -1.0), at(0.0, -0.5), at(1.0, -1.0)], [0.0, 0.1, 0.2]);
        assert_eq!([at(-0.9, 1.0), at(1.0, 1.0), at(-0.34, 0.01)], [1.0, 1.2, 1.0]);
        assert_eq!(plain.breaks().map(|breaks| breaks.len()), [2, 1]);
        assert_eq!(plain.breaks()[1], [0.0]);
    }

    #[test]
    fn beyond_its_border_a_grid_repeats_mirrors_or_goes_on() {
        let twice = |wrap| grid(Placement { scale: [2.0, 1.0], wrap, ..Placement::default() });
        let row = |pattern: &Pattern| [-0.9, -0.6, -0.2, 0.2, 0.5, 0.9].map(|u| pattern.at(0, [u, -0.5]));
        assert_eq!(row(&twice(Wrap::Repeat)), [0.0, 0.1, 0.2, 0.0, 0.1, 0.2]);
        assert_eq!(row(&twice(Wrap::Mirror)), [0.0, 0.1, 0.2, 0.2, 0.1, 0.0]);
        assert_eq!(row(&twice(Wrap::Clamp)), [0.0, 0.1, 0.2, 0.2, 0.2, 0.2]);
        assert_eq!(twice(Wrap::Repeat).breaks()[0].len(), 5);
    }

    #[test]
    fn polynomials_are_summed_by_terms() {
        let terms = [Term { u: 0, v: 0, factor: 0.5 }, Term { u: 2, v: 1, factor: 0.25 }];
        let pattern = Pattern::polynomial(vec![Polynomial::new(terms)]);
        assert_eq!(pattern.at(0, [-1.0, 1.0]), 0.75);
        assert_eq!((pattern.degree(), pattern.bands()), (Some(3), 1));
    }
}
