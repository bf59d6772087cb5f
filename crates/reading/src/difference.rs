//! The difference of two rasters of one view, in percent.
//!
//! ```text
//! d = 100 (B − B′) / mean B′
//! ```
//!
//! with B and B′ the means over the bands of a pixel, or one band of both, and the mean of B′ over all pixels
//! that see something in it: relative to the picture, since in its dark places the ratio of two small numbers
//! says nothing.

use crate::field::Field;

/// A signed difference per pixel with statistics, all in percent of the other picture's mean.
#[derive(Clone, Debug)]
pub struct Difference {
    /// The difference at pixels that see something in both pictures.
    pub field: Field,
    /// Root mean square over those pixels.
    pub rms: f64,
    /// Largest absolute value.
    pub largest: f64,
}

impl Difference {
    /// `field` less `other`; None if their sizes differ or `other` is black.
    pub fn new(field: &Field, other: &Field) -> Option<Self> {
        let (count, sum) = other.seen().fold((0usize, 0.0), |(count, sum), value| (count + 1, sum + value));
        if field.size() != other.size() || sum <= 0.0 {
            return None;
        }
        let mean = sum / count as f64;
        let pixel = |((a, seen), (b, other)): ((f64, f64), (f64, f64))| {
            let both = if other > 0.0 { seen } else { 0.0 };
            (if both > 0.0 { 100.0 * (a - b) / mean } else { 0.0 }, both)
        };
        let (values, coverage) = field.pixels().zip(other.pixels()).map(pixel).unzip();
        let field = Field::new(field.size(), values, coverage);
        let squares: Vec<f64> = field.seen().map(|d| d * d).collect();
        let rms = (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt();
        let largest = field.seen().map(f64::abs).fold(0.0, f64::max);
        Some(Self { field, rms, largest })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_of_two_pixels() {
        let field = |values: [f64; 3]| Field::new([3, 1], values.to_vec(), vec![1.0, 1.0, 0.0]);
        let difference =
            Difference::new(&field([3.0, 1.0, 7.0]), &field([2.0, 2.0, 0.0])).expect("equal sizes");
        let expected = field([50.0, -50.0, 0.0]);
        assert_eq!(difference.field, expected);
        assert_eq!((difference.rms, difference.largest), (50.0, 50.0));
        assert!(Difference::new(&expected, &field([0.0; 3])).is_none(), "nothing to compare with");
    }
}
