//! Patterns: how reflectance or emission varies over a surface.
//!
//! ```text
//! q(u, v) ,     (u, v) ∈ [−1, 1]², the parameters of the surface, one q per band
//! ```
//!
//! is a polynomial Σ c_ij u^i v^j, or constant on every texel of a grid. A grid of m × n texels lies on the
//! surface by the coordinates
//!
//! ```text
//! s = o_s + k_s (u + 1)/2 ,     t = o_t + k_t (v + 1)/2 ,
//! ```
//!
//! texel (i, j) being i/m ≤ s < (i + 1)/m, j/n ≤ t < (j + 1)/n; beyond [0, 1)² the grid is repeated,
//! mirrored, or its border is continued. Texels are not interpolated: the mean of a whole grid is then the
//! mean of its numbers.

mod placement;
mod polynomial;
mod extremes;
mod texels;

pub use placement::{Placement, Wrap};
pub use polynomial::{Polynomial, Term};
use texels::Texels;

use std::{fmt, sync::Arc};

use crate::{
    fault::Fault,
    ranges::{MAX_ORDER, check_number, check_range},
};
use extremes::maximum;

/// Highest power of u and of v, as the highest order of a basis.
const HIGHEST: u32 = MAX_ORDER as u32;

/// Most texels along u or v across a surface, those that repeat counted again: each is 2·10⁻⁶ of the
/// parameters wide, well above rounding. Finer ones no element tells from their mean.
const MOST_ACROSS: f64 = 1e6;

/// A number per band that varies over a surface: reflectance, or emission (W m⁻²).
#[derive(Clone, Debug, PartialEq)]
pub struct Pattern {
    kind: PatternForm,
    picture: Option<Arc<PictureFile>>,
}

#[derive(Clone, Debug, PartialEq)]
enum PatternForm {
    Polynomial(Vec<Polynomial>),
    Texels(Texels),
}

/// The picture file that the texels of a pattern were read from.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureFile {
    /// Path of the file.
    pub path: String,
    /// Remarks on the conversion of its numbers, in the order of the steps.
    pub remarks: Vec<String>,
}

/// An extreme value of a band and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extreme {
    pub(super) value: f64,
    pub(super) spot: Spot,
}

/// A place in a pattern: a texel, or parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Spot {
    /// Column from the left and row from the top, counted from 0.
    Texel([usize; 2]),
    /// Parameters (u, v) ∈ [−1, 1]².
    Parameters([f64; 2]),
}

impl fmt::Display for Spot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Spot::Texel([column, row]) => {
                write!(f, "in the texel of column {}, row {} from the top", column + 1, row + 1)
            }
            Spot::Parameters([u, v]) => write!(f, "at u = {u:.4}, v = {v:.4}"),
        }
    }
}

impl Pattern {
    /// A polynomial per band, of powers up to 20.
    pub fn polynomial(bands: Vec<Polynomial>) -> Self {
        Self { kind: PatternForm::Polynomial(bands), picture: None }
    }

    /// A grid of `columns` × `rows` texels; `values` are given band after band, row after row from v = −1,
    /// each along u.
    ///
    /// # Errors
    /// A band with another count of numbers, or none; a number that is not finite.
    pub fn texels(columns: usize, values: Vec<Vec<f64>>, placement: Placement) -> Result<Self, Fault> {
        let count = values.first().map_or(0, Vec::len);
        let is_full = columns > 0 && count > 0 && count.is_multiple_of(columns);
        let is_full = is_full && values.iter().all(|band| band.len() == count);
        check_range(columns as f64, is_full, "the number of columns", "as many as make whole rows")?;
        values.iter().flatten().try_for_each(|value| check_number(*value))?;
        let rows = count / columns;
        check_placement(&placement, [columns, rows])?;
        Ok(Self { kind: PatternForm::Texels(Texels { columns, rows, values, placement }), picture: None })
    }

    /// The pattern with the path of the picture file that it was read from, and remarks on its conversion.
    pub fn of_file(self, path: &str, remarks: Vec<String>) -> Self {
        Self { picture: Some(Arc::new(PictureFile { path: path.to_owned(), remarks })), ..self }
    }

    /// The pattern with a factor on each band.
    pub(crate) fn dimmed(&self, factors: &[f64]) -> Self {
        let kind = match &self.kind {
            PatternForm::Polynomial(bands) => PatternForm::Polynomial(
                bands.iter().zip(factors).map(|(own, factor)| own.times(*factor)).collect(),
            ),
            PatternForm::Texels(texels) => PatternForm::Texels(texels.dimmed(factors)),
        };
        Self { kind, picture: self.picture.clone() }
    }

    /// The picture file that the pattern was read from, if any.
    pub fn picture(&self) -> Option<&PictureFile> {
        self.picture.as_deref()
    }

    /// Number of bands.
    pub fn bands(&self) -> usize {
        match &self.kind {
            PatternForm::Polynomial(bands) => bands.len(),
            PatternForm::Texels(texels) => texels.values.len(),
        }
    }

    /// Value q of a band at the parameters (u, v).
    pub fn at(&self, band: usize, parameters: [f64; 2]) -> f64 {
        match &self.kind {
            PatternForm::Polynomial(bands) => bands[band].at(parameters),
            PatternForm::Texels(texels) => texels.at(band, parameters),
        }
    }

    /// The column of texels at a parameter along u (axis 0), or the row at one along v (axis 1); 0 for
    /// polynomials.
    pub fn line(&self, axis: usize, parameter: f64) -> usize {
        match &self.kind {
            PatternForm::Polynomial(_) => 0,
            PatternForm::Texels(texels) => texels.line(axis, parameter),
        }
    }

    /// Largest total degree of the polynomials of all bands; none for texels.
    pub fn degree(&self) -> Option<u32> {
        match &self.kind {
            PatternForm::Polynomial(bands) => bands.iter().map(Polynomial::degree).max().or(Some(0)),
            PatternForm::Texels(_) => None,
        }
    }

    /// Numbers of columns and rows of the grid; none for polynomials.
    pub fn grid(&self) -> Option<[usize; 2]> {
        match &self.kind {
            PatternForm::Polynomial(_) => None,
            PatternForm::Texels(texels) => Some([texels.columns, texels.rows]),
        }
    }

    /// Placement of the grid on the surface; none for polynomials.
    pub fn placement(&self) -> Option<&Placement> {
        match &self.kind {
            PatternForm::Polynomial(_) => None,
            PatternForm::Texels(texels) => Some(&texels.placement),
        }
    }

    /// The parameters along u, and along v, at which q may jump, within (−1, 1), ascending.
    pub fn breaks(&self) -> [Vec<f64>; 2] {
        match &self.kind {
            PatternForm::Polynomial(_) => [Vec::new(), Vec::new()],
            PatternForm::Texels(texels) => texels.breaks(),
        }
    }

    /// Mean of a band over the square of parameters.
    pub fn mean(&self, band: usize) -> f64 {
        match &self.kind {
            PatternForm::Polynomial(bands) => bands[band].mean(),
            PatternForm::Texels(texels) => texels.mean(band),
        }
    }

    /// Mean of each band over the square of parameters.
    pub fn means(&self) -> Vec<f64> {
        (0..self.bands()).map(|band| self.mean(band)).collect()
    }

    /// The least and the largest value of a band: of all texels, laid on the surface or not; of a polynomial
    /// proven bounds, which are within 10⁻⁹ of the sum of its coefficients (absolute) unless it is very
    /// uneven.
    pub fn range(&self, band: usize) -> [f64; 2] {
        self.extremes(band).map(|extreme| extreme.value)
    }

    /// The least and the largest value of a band, with their places.
    pub(super) fn extremes(&self, band: usize) -> [Extreme; 2] {
        [-1.0, 1.0].map(|sign| match &self.kind {
            PatternForm::Polynomial(bands) => {
                let found = maximum(&bands[band].times(sign));
                Extreme { value: sign * found.bound, spot: Spot::Parameters(found.at) }
            }
            PatternForm::Texels(texels) => {
                let (value, place) = texels.maximum(band, sign);
                Extreme { value: sign * value, spot: Spot::Texel(place) }
            }
        })
    }

    /// Distance by which a value of a band may lie below 0 and still count as 0: proven bounds are no nearer
    /// to the values.
    pub(super) fn rounding(&self, band: usize) -> f64 {
        match &self.kind {
            PatternForm::Polynomial(bands) => {
                2e-9 * bands[band].terms().iter().map(|term| term.factor.abs()).sum::<f64>()
            }
            PatternForm::Texels(_) => 0.0,
        }
    }

    /// Checks that factors are finite and powers at most 20.
    pub(super) fn check(&self) -> Result<(), Fault> {
        let PatternForm::Polynomial(bands) = &self.kind else { return Ok(()) };
        bands.iter().flat_map(Polynomial::terms).try_for_each(check_term)
    }
}

/// Checks that a term has a finite factor, and powers up to `HIGHEST`.
pub fn check_term(term: &Term) -> Result<(), Fault> {
    check_number(term.factor)?;
    [term.u, term.v]
        .into_iter()
        .try_for_each(|power| check_range(f64::from(power), power <= HIGHEST, "the power", "0 ≤ power ≤ 20"))
}

/// Checks that scales are above 0, and that the surface has no more texels across than can be told apart.
fn check_placement(placement: &Placement, counts: [usize; 2]) -> Result<(), Fault> {
    for (axis, count) in counts.into_iter().enumerate() {
        let scale = placement.scale[axis];
        check_range(scale, scale > 0.0, "the scale", "scale > 0")?;
        let across = scale * count as f64;
        check_range(across, across <= MOST_ACROSS, "the number of texels across the surface", "at most 10⁶")?;
        let offset = placement.offset[axis];
        check_range(offset, offset.abs() <= MOST_ACROSS, "the offset", "−10⁶ ≤ offset ≤ 10⁶")?;
    }
    Ok(())
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
