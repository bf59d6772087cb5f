//! Strokes: lines of many pieces whose coverage is counted once where pieces meet, so that they have an even
//! tone.

use super::picture::{Colour, Picture};
use super::segment::Segment;

/// The part of each pixel that lines cover.
#[derive(Clone, Debug)]
pub(crate) struct Stroke {
    size: [u32; 2],
    coverage: Vec<f64>,
}

impl Stroke {
    /// The coverage of no line, for a picture of `size` (pixels across and down).
    pub(crate) fn new(size: [u32; 2]) -> Self {
        Self { size, coverage: vec![0.0; size[0] as usize * size[1] as usize] }
    }

    /// Adds a line of `width` pixels through `points`.
    pub(crate) fn line(&mut self, points: &[[f64; 2]], width: f64) {
        for ends in points.windows(2) {
            self.piece(Segment { from: ends[0], to: ends[1] }, width);
        }
    }

    fn piece(&mut self, piece: Segment, width: f64) {
        let [columns, rows] = piece.bounds(0.5 * width + 1.0);
        let range = |[low, high]: [f64; 2], end: u32| {
            (low.max(0.0) as u32)..(high.ceil().clamp(0.0, f64::from(end)) as u32)
        };
        for row in range(rows, self.size[1]) {
            for column in range(columns, self.size[0]) {
                let distance = piece.distance([f64::from(column) + 0.5, f64::from(row) + 0.5]);
                let part = &mut self.coverage[row as usize * self.size[0] as usize + column as usize];
                *part = part.max((0.5 + 0.5 * width - distance).clamp(0.0, 1.0));
            }
        }
    }

    /// Draws the lines; `opacity` in [0, 1].
    pub(crate) fn draw(&self, picture: &mut Picture, colour: Colour, opacity: f64) {
        let coverage: Vec<f64> = self.coverage.iter().map(|part| opacity * part).collect();
        picture.overlay(&coverage, self.size[0], colour);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_of_many_pieces_are_as_dark_as_one() {
        let draw = |points: &[[f64; 2]]| {
            let mut picture = Picture::filled(40, 12, [255; 3]);
            let mut stroke = Stroke::new(picture.size());
            stroke.line(points, 1.5);
            stroke.draw(&mut picture, [0; 3], 0.7);
            picture
        };
        let pieces: Vec<[f64; 2]> = (0..=120).map(|k| [2.0 + 0.3 * f64::from(k), 5.3]).collect();
        assert_eq!(draw(&pieces), draw(&[pieces[0], pieces[120]]));
    }
}
