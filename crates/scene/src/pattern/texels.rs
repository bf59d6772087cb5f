//! Grids of texels on a surface.

use radiosity_core::dot;

use super::placement::Placement;

/// A grid of texels with its placement on the surface.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Texels {
    pub(super) columns: usize,
    pub(super) rows: usize,
    /// Values of each band, row after row from v = −1, each along u.
    pub(super) values: Vec<Vec<f64>>,
    pub(super) placement: Placement,
}

impl Texels {
    /// The grid with a factor on each band.
    pub(super) fn dimmed(&self, factors: &[f64]) -> Self {
        let band = |(own, factor): (&Vec<f64>, &f64)| own.iter().map(|value| value * factor).collect();
        Self { values: self.values.iter().zip(factors).map(band).collect(), ..self.clone() }
    }

    /// Value of a band at (u, v).
    pub(super) fn at(&self, band: usize, parameters: [f64; 2]) -> f64 {
        let [i, j] = [0, 1].map(|axis| self.line(axis, parameters[axis]));
        self.values[band][i + self.columns * j]
    }

    /// The column at a parameter along u (axis 0), or the row at one along v (axis 1).
    pub(super) fn line(&self, axis: usize, parameter: f64) -> usize {
        self.placement.texel(axis, [self.columns, self.rows][axis], parameter)
    }

    /// The parameters along u, and along v, between texels that differ.
    pub(super) fn breaks(&self) -> [Vec<f64>; 2] {
        let counts = [self.columns, self.rows];
        [0, 1].map(|axis| self.placement.breaks(axis, counts[axis]))
    }

    /// Mean of a band over the square of parameters.
    pub(super) fn mean(&self, band: usize) -> f64 {
        let across = self.placement.shares(0, self.columns);
        let down = self.placement.shares(1, self.rows);
        self.values[band]
            .chunks_exact(self.columns)
            .zip(down)
            .map(|(own, share)| share * dot(own, &across))
            .sum()
    }

    /// The largest number of a band times `sign`, with its column from the left and its row from the top,
    /// counted from 0.
    pub(super) fn maximum(&self, band: usize, sign: f64) -> (f64, [usize; 2]) {
        let all = self.values[band].iter().map(|value| sign * value).enumerate();
        // The last of equal ones: it is the nearest to the top.
        let most = all.max_by(|a, b| a.1.total_cmp(&b.1));
        most.map_or((f64::NAN, [0; 2]), |(index, value)| {
            (value, [index % self.columns, self.rows - 1 - index / self.columns])
        })
    }
}
