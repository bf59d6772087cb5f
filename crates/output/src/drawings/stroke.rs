//! Strokes: lines of many pieces whose coverage is counted once where pieces meet, so that they have an even
//! tone.

use super::picture::{Colour, Picture};

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
            self.piece([ends[0], ends[1]], width);
        }
    }

    fn piece(&mut self, [from, to]: [[f64; 2]; 2], width: f64) {
        let reach = 0.5 * width + 1.0;
        let [columns, rows] = [0, 1].map(|k| {
            let [low, high] = [from[k].min(to[k]) - reach, from[k].max(to[k]) + reach];
            (low.max(0.0) as u32)..(high.ceil().clamp(0.0, f64::from(self.size[k])) as u32)
        });
        for (row, column) in rows.flat_map(|row| columns.clone().map(move |column| (row, column))) {
            let distance = distance([from, to], [f64::from(column) + 0.5, f64::from(row) + 0.5]);
            let part = &mut self.coverage[row as usize * self.size[0] as usize + column as usize];
            *part = part.max((0.5 + 0.5 * width - distance).clamp(0.0, 1.0));
        }
    }

    /// Draws the lines; `opacity` in [0, 1].
    pub(crate) fn draw(&self, picture: &mut Picture, colour: Colour, opacity: f64) {
        let coverage: Vec<f64> = self.coverage.iter().map(|part| opacity * part).collect();
        picture.overlay(&coverage, self.size[0], colour);
    }
}

/// Distance of a point from the straight line between two others.
fn distance([from, to]: [[f64; 2]; 2], [x, y]: [f64; 2]) -> f64 {
    let along = [to[0] - from[0], to[1] - from[1]];
    let length2 = (along[0] * along[0] + along[1] * along[1]).max(f64::MIN_POSITIVE);
    let [dx, dy] = [x - from[0], y - from[1]];
    let t = ((dx * along[0] + dy * along[1]) / length2).clamp(0.0, 1.0);
    (dx - t * along[0]).hypot(dy - t * along[1])
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
        let drawn = draw(&pieces);
        assert_eq!(drawn, draw(&[pieces[0], pieces[120]]));
        let darkness: f64 = drawn.codes().chunks(3).map(|p| 1.0 - f64::from(p[0]) / 255.0).sum();
        assert!((darkness - 0.7 * 36.0 * 1.5).abs() < 0.7 * 1.5 * 1.5 + 0.2, "{darkness}: all but its ends");
    }
}
