//! A field: one number per pixel, and how much of the pixel it speaks of.

/// Numbers in rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    size: [u32; 2],
    values: Vec<f64>,
    coverage: Vec<f64>,
}

impl Field {
    /// `values` in row order, each over the part `coverage` in [0, 1] of its pixel; where that is 0 the value
    /// is without meaning.
    ///
    /// # Panics
    /// If the numbers of values and coverages are not that of the pixels.
    pub fn new(size: [u32; 2], values: Vec<f64>, coverage: Vec<f64>) -> Self {
        let pixels = size[0] as usize * size[1] as usize;
        assert!(values.len() == pixels && coverage.len() == pixels, "one value and one coverage per pixel");
        Self { size, values, coverage }
    }

    /// Pixels across and down.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The numbers with their coverages, in row order.
    pub fn pixels(&self) -> impl Iterator<Item = (f64, f64)> {
        self.values.iter().copied().zip(self.coverage.iter().copied())
    }

    /// The field of `f` of each number, with the same coverages.
    #[must_use]
    pub fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        Self { values: self.values.iter().map(|value| f(*value)).collect(), ..self.clone() }
    }

    /// The numbers of pixels in which something is seen.
    pub fn seen(&self) -> impl Iterator<Item = f64> {
        self.pixels().filter(|(_, coverage)| *coverage > 0.0).map(|(value, _)| value)
    }

    /// The field without the pixels that are `left_out`, of which there is one entry per pixel.
    #[must_use]
    pub fn without(&self, left_out: &[bool]) -> Self {
        let kept =
            self.coverage.iter().zip(left_out).map(|(part, left_out)| if *left_out { 0.0 } else { *part });
        Self { size: self.size, values: self.values.clone(), coverage: kept.collect() }
    }

    /// The 2nd and the 98th percentile; none where nothing is seen.
    pub fn usual_range(&self) -> Option<[f64; 2]> {
        let mut values: Vec<f64> = self.seen().collect();
        values.sort_by(f64::total_cmp);
        let last = values.len().checked_sub(1)?;
        Some([last * 2 / 100, last * 98 / 100].map(|index| values[index]))
    }

    /// The 98th percentile of the absolute values; 0 where nothing is seen.
    pub fn usual_size(&self) -> f64 {
        let mut sizes: Vec<f64> = self.seen().map(f64::abs).collect();
        sizes.sort_by(f64::total_cmp);
        sizes.get(sizes.len().saturating_sub(1) * 98 / 100).copied().unwrap_or(0.0)
    }
}
