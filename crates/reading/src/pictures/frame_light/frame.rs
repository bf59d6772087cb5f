//! Places in rows: those that the middles of pixels see in some rows of a picture, or the texels of a
//! surface.

use std::ops::Range;

use radiosity_work::ranks::{PartName, Ranks};

use crate::pictures::pinhole::Pinhole;

use crate::pictures::eye::{Eye, SeenPlace};

/// Pixels that one thread looks through after each other. Chosen: they take about a microsecond each.
const TOGETHER: usize = 256;

/// The places seen, row by row.
#[derive(Debug)]
pub(crate) struct Frame {
    width: usize,
    rows: Range<usize>,
    seen: Vec<Option<SeenPlace>>,
    spacing: Spacing,
}

/// Distance of the places beside a place that is seen.
#[derive(Clone, Copy, Debug)]
enum Spacing {
    /// Pixels: their distance at that of the place from the eye.
    Pixels(Pinhole),
    /// A length (scene length).
    Texels(f64),
}

impl Frame {
    /// The frame of the rows `rows` of a picture of so many columns.
    pub(crate) fn new(eye: &Eye, view: &Pinhole, width: usize, rows: Range<usize>, ranks: &Ranks) -> Self {
        let first = rows.start * width;
        let seen = ranks.map_even(PartName::Seen, rows.len() * width, TOGETHER, |index| {
            let (row, column) = ((first + index) / width, (first + index) % width);
            eye.along(&view.ray(column as f64 + 0.5, row as f64 + 0.5))
        });
        Self { width, rows, seen, spacing: Spacing::Pixels(*view) }
    }

    /// The frame of these places of a surface, row by row of so many columns, `apart` from each other (scene
    /// length).
    pub(crate) fn of(width: usize, seen: Vec<Option<SeenPlace>>, apart: f64) -> Self {
        Self { width, rows: 0..seen.len() / width, seen, spacing: Spacing::Texels(apart) }
    }

    /// About the distance of the places beside one (scene length); 0 where nothing is seen.
    pub(crate) fn footprint(&self, pixel: usize) -> f64 {
        match &self.spacing {
            Spacing::Pixels(view) => self.seen(pixel).map_or(0.0, |seen| view.footprint(seen.place.position)),
            Spacing::Texels(apart) => *apart,
        }
    }

    /// Number of pixels.
    pub(crate) fn len(&self) -> usize {
        self.seen.len()
    }

    /// Column and row, counted from the first of these rows, of a pixel.
    pub(crate) fn place(&self, pixel: usize) -> [usize; 2] {
        [pixel % self.width, pixel / self.width]
    }

    /// The pixel at a column and a row, counted from the first of these, if it is one of them.
    pub(crate) fn pixel(&self, [column, row]: [isize; 2]) -> Option<usize> {
        let is_within =
            (0..self.width as isize).contains(&column) && (0..self.rows.len() as isize).contains(&row);
        is_within.then(|| row as usize * self.width + column as usize)
    }

    /// The place that a pixel sees; None where it sees nothing.
    pub(crate) fn seen(&self, pixel: usize) -> Option<&SeenPlace> {
        self.seen[pixel].as_ref()
    }
}
