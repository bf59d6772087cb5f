//! Averaging a picture while it is read.
//!
//! The m × n texels that are kept are the means of the w × h of the file over their areas: along a row the
//! texel x of the file covers [x m, (x + 1) m] of the line [0, w m], the kept texel i covers [i w, (i + 1)
//! w], and what they have in common is the weight, a whole number. So the mean of all stays what it was.

use radiosity_photometry::error::Refusal;

use super::refusals::{damaged, not_finite};

/// Numbers of texels, row after row from the top, each from the left.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Texels along a row.
    pub columns: usize,
    /// Rows of texels.
    pub rows: usize,
    /// One channel of a grey picture; red, green and blue of a coloured one. Linear.
    pub channels: Vec<Vec<f64>>,
    /// Remarks on changes of the file's numbers.
    pub remarks: Vec<String>,
}

/// A picture that is being read.
#[derive(Debug)]
pub(super) struct Reduction {
    /// Columns and rows of the file.
    from: [usize; 2],
    /// Columns and rows of the picture.
    to: [usize; 2],
    sums: Vec<Vec<f64>>,
    /// Texels that were taken in.
    count: usize,
    /// The refusal of the first texel that was refused.
    refused: Option<Refusal>,
}

impl Reduction {
    /// A reduction from so many columns and rows of the file to at most `most` texels.
    pub(super) fn new(from: [usize; 2], channels: usize, most: usize) -> Self {
        let smaller = |part: usize| from.map(|side| (side / part).max(1));
        let part = (1..).find(|part| smaller(*part).iter().product::<usize>() <= most.max(1)).unwrap_or(1);
        let to = smaller(part);
        let sums = vec![vec![0.0; to[0] * to[1]]; channels];
        Self { from, to, sums, count: 0, refused: None }
    }

    /// Takes in a texel of the file.
    pub(super) fn add(&mut self, [column, row]: [usize; 2], values: &[f64]) {
        self.count += 1;
        if let Some(value) = values.iter().find(|value| !value.is_finite()) {
            self.refuse(|| not_finite([column, row], *value));
            return;
        }
        if self.from == self.to {
            let index = column + row * self.from[0];
            self.sums.iter_mut().zip(values).for_each(|(sums, value)| sums[index] = *value);
            return;
        }
        let across = cells(column, self.from[0], self.to[0]);
        for (j, down) in cells(row, self.from[1], self.to[1]) {
            for (i, width) in across {
                let index = i.min(self.to[0] - 1) + j.min(self.to[1] - 1) * self.to[0];
                let weight = (width * down) as f64;
                self.sums.iter_mut().zip(values).for_each(|(sums, value)| sums[index] += weight * value);
            }
        }
    }

    /// Remembers the first texel that is refused.
    pub(super) fn refuse(&mut self, refusal: impl FnOnce() -> Refusal) {
        self.refused.get_or_insert_with(refusal);
    }

    /// The picture; `remarks` are what was done to the numbers before.
    ///
    /// # Errors
    /// A texel that was refused, or one that is missing.
    pub(super) fn finish(mut self, mut remarks: Vec<String>) -> Result<Picture, Refusal> {
        if let Some(refusal) = self.refused {
            return Err(refusal);
        }
        if self.count < self.from[0] * self.from[1] {
            return Err(damaged("texels are missing"));
        }
        let ([w, h], [columns, rows]) = (self.from, self.to);
        if self.from != self.to {
            let all = (w * h) as f64;
            self.sums.iter_mut().flatten().for_each(|sum| *sum /= all);
            remarks.push(format!("averaged from {w} × {h} to {columns} × {rows} texels"));
        }
        Ok(Picture { columns, rows, channels: self.sums, remarks })
    }
}

/// The kept texels, at most two, that a texel of the file lies in, with the lengths of what they have in
/// common.
fn cells(place: usize, from: usize, to: usize) -> [(usize, usize); 2] {
    let (start, end) = (place * to, (place + 1) * to);
    let first = start / from;
    let border = (first + 1) * from;
    [(first, end.min(border) - start), (first + 1, end.saturating_sub(border))]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reduced(from: [usize; 2], most: usize) -> Picture {
        let mut reduction = Reduction::new(from, 1, most);
        for row in 0..from[1] {
            for column in 0..from[0] {
                reduction.add([column, row], &[(column * column + 10 * row) as f64]);
            }
        }
        reduction.finish(Vec::new()).expect("no texel is missing")
    }

    #[test]
    fn small_pictures_stay_as_they_are() {
        let picture = reduced([3, 2], 6);
        assert_eq!((picture.columns, picture.rows), (3, 2));
        assert_eq!(picture.channels, [vec![0.0, 1.0, 4.0, 10.0, 11.0, 14.0]]);
        assert!(picture.remarks.is_empty());
    }

    #[test]
    fn whole_boxes_are_averaged() {
        let picture = reduced([4, 2], 2);
        assert_eq!((picture.columns, picture.rows), (2, 1));
        assert_eq!(picture.channels, [vec![0.5 + 5.0, 6.5 + 5.0]]);
        assert_eq!(picture.remarks, ["averaged from 4 × 2 to 2 × 1 texels"]);
    }

    #[test]
    fn the_mean_stays_where_boxes_cut_texels() {
        for (from, most) in [([7, 5], 9), ([11, 3], 8), ([1, 9], 4), ([13, 17], 1)] {
            let mean = |channel: &[f64]| channel.iter().sum::<f64>() / channel.len() as f64;
            let (all, few) = (reduced(from, usize::MAX), reduced(from, most));
            assert!(few.channels[0].len() <= most);
            let [all, few] = [all, few].map(|own| mean(&own.channels[0]));
            assert!((all - few).abs() < 1e-12 * all, "{from:?} to {most}: {all} {few}");
        }
    }
}
