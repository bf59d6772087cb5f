//! Labels: short texts on a picture at any angle, dark in a light halo.
//!
//! Letters are taken at twice or more of their size and averaged, so that turned ones are as smooth as
//! upright ones.

use super::lettering::Lettering;
use super::picture::{Colour, Picture};

/// Height of the letters that are made smaller (pixels), of which the font has the largest.
const LARGE: u32 = 32;
/// Breadth of the halo over the height of a line. Chosen.
const HALO: f64 = 0.14;
/// Share of what is below that the halo hides. Chosen.
const OPACITY: f64 = 0.85;
/// Samples along each side of a pixel.
const SAMPLES: usize = 3;
const INK: Colour = [0; 3];
const PAPER: Colour = [255; 3];

/// A text with its middle at a place of a picture.
#[derive(Clone, Debug)]
pub(crate) struct Label<'a> {
    /// The text.
    pub text: &'a str,
    /// Height of a line (pixels).
    pub size: f64,
    /// The middle, in pixels from the left upper corner.
    pub middle: [f64; 2],
    /// The unit vector along which it is read.
    pub along: [f64; 2],
}

impl Label<'_> {
    /// Half of its breadth and half of its height, halo included (pixels).
    pub(crate) fn half(&self) -> [f64; 2] {
        self.lettering().extent().map(|length| 0.5 * f64::from(length) * self.scale() + HALO * self.size)
    }

    /// Its corners in order, halo included.
    pub(crate) fn corners(&self) -> [[f64; 2]; 4] {
        let [breadth, height] = self.half();
        [[-breadth, -height], [breadth, -height], [breadth, height], [-breadth, height]]
            .map(|offset| self.at(offset))
    }

    /// Whether both cover a place: no line parallel to a side of either parts them.
    pub(crate) fn overlaps(&self, other: &Label) -> bool {
        let parts = |label: &Label| {
            [label.along, label.down()].into_iter().any(|axis| {
                let range = |corners: [[f64; 2]; 4]| {
                    let places = corners.map(|corner| corner[0] * axis[0] + corner[1] * axis[1]);
                    places.into_iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], place| {
                        [low.min(place), high.max(place)]
                    })
                };
                let [[low, high], [other_low, other_high]] = [range(self.corners()), range(other.corners())];
                high < other_low || other_high < low
            })
        };
        !parts(self) && !parts(other)
    }

    /// Whether a place lies in it, halo included.
    pub(crate) fn covers(&self, point: [f64; 2]) -> bool {
        let offset = self.offset(point);
        self.half().iter().zip(offset).all(|(half, offset)| offset.abs() < *half)
    }

    /// Draws the halo, then the letters.
    pub(crate) fn draw(&self, picture: &mut Picture) {
        let letters = Ink::of(&self.lettering());
        let halo = letters.widened(HALO * self.size / self.scale());
        for (ink, colour, opacity) in [(&halo, PAPER, OPACITY), (&letters, INK, 1.0)] {
            self.cover(picture, |offset| opacity * ink.at(offset.map(|x| x / self.scale())), colour);
        }
    }

    /// Lets pixels take `colour` by the mean of `part`, a function of the offset from the middle along and
    /// across.
    fn cover(&self, picture: &mut Picture, part: impl Fn([f64; 2]) -> f64, colour: Colour) {
        let corners = self.corners();
        let range = |k: usize| {
            let low = corners.iter().map(|corner| corner[k]).fold(f64::INFINITY, f64::min);
            let high = corners.iter().map(|corner| corner[k]).fold(f64::NEG_INFINITY, f64::max);
            low.floor() as i32..high.ceil() as i32
        };
        let offsets = (0..SAMPLES).map(|k| (k as f64 + 0.5) / SAMPLES as f64);
        let samples: Vec<[f64; 2]> =
            offsets.clone().flat_map(|y| offsets.clone().map(move |x| [x, y])).collect();
        for y in range(1) {
            for x in range(0) {
                let sample = |[dx, dy]: &[f64; 2]| part(self.offset([f64::from(x) + dx, f64::from(y) + dy]));
                let mean = samples.iter().map(sample).sum::<f64>() / samples.len() as f64;
                picture.blend(x, y, colour, mean);
            }
        }
    }

    fn lettering(&self) -> Lettering<'_> {
        Lettering::level(self.text, LARGE)
    }

    /// Pixels of the picture per pixel of the large letters.
    fn scale(&self) -> f64 {
        self.size / f64::from(LARGE)
    }

    fn down(&self) -> [f64; 2] {
        [-self.along[1], self.along[0]]
    }

    fn at(&self, [right, below]: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| self.middle[k] + right * self.along[k] + below * self.down()[k])
    }

    fn offset(&self, point: [f64; 2]) -> [f64; 2] {
        let from = [point[0] - self.middle[0], point[1] - self.middle[1]];
        [self.along, self.down()].map(|axis| from[0] * axis[0] + from[1] * axis[1])
    }
}

/// The parts of pixels that large letters cover, with a margin.
struct Ink {
    size: [i32; 2],
    margin: i32,
    parts: Vec<f64>,
}

impl Ink {
    fn of(lettering: &Lettering) -> Self {
        let size = lettering.extent();
        let mut ink = Self { size, margin: 0, parts: vec![0.0; (size[0] * size[1]) as usize] };
        lettering.ink(|place, part| ink.add(place, part));
        ink
    }

    /// The ink with everything within `radius` of a letter covered (pixels of the large letters).
    fn widened(&self, radius: f64) -> Self {
        let margin = radius.ceil() as i32;
        let [width, height] = self.size.map(|length| length + 2 * margin);
        let mut wide = Self { size: self.size, margin, parts: vec![0.0; (width * height) as usize] };
        let disk = (-margin..=margin).flat_map(|y| (-margin..=margin).map(move |x| [x, y]));
        let disk: Vec<[i32; 2]> =
            disk.filter(|[x, y]| f64::from(*x).hypot(f64::from(*y)) <= radius).collect();
        for (k, part) in self.parts.iter().enumerate().filter(|(_, part)| **part > 0.0) {
            let [x, y] = [k as i32 % self.size[0], k as i32 / self.size[0]];
            disk.iter().for_each(|[dx, dy]| wide.add([x + dx, y + dy], *part));
        }
        wide
    }

    fn add(&mut self, place: [i32; 2], part: f64) {
        if let Some(index) = self.index(place) {
            self.parts[index] = self.parts[index].max(part);
        }
    }

    /// The part covered at an offset from the middle, in pixels of the large letters; linear between their
    /// middles.
    fn at(&self, offset: [f64; 2]) -> f64 {
        let [x, y] = [0, 1].map(|k| offset[k] + 0.5 * f64::from(self.size[k]) - 0.5);
        let [left, top] = [x, y].map(f64::floor);
        let part = |dx: i32, dy: i32| {
            self.index([left as i32 + dx, top as i32 + dy]).map_or(0.0, |index| self.parts[index])
        };
        let row = |dy: i32| part(0, dy) + (x - left) * (part(1, dy) - part(0, dy));
        row(0) + (y - top) * (row(1) - row(0))
    }

    fn index(&self, place: [i32; 2]) -> Option<usize> {
        let [x, y] = place.map(|k| k + self.margin);
        let [width, height] = self.size.map(|length| length + 2 * self.margin);
        let is_inside = (0..width).contains(&x) && (0..height).contains(&y);
        is_inside.then(|| (y * width + x) as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn label(middle: [f64; 2], degrees: f64) -> Label<'static> {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Label { text: "250", size: 16.0, middle, along: [cos, sin] }
    }

    #[test]
    fn what_is_drawn_lies_in_the_corners() {
        for degrees in [0.0, 30.0, -75.0, 90.0] {
            let label = label([50.0, 40.0], degrees);
            let mut picture = Picture::filled(100, 80, [128; 3]);
            label.draw(&mut picture);
            let changed = (0..80).flat_map(|y| (0..100).map(move |x| [x, y]));
            let changed: Vec<[i32; 2]> =
                changed.filter(|[x, y]| picture.at(*x, *y) != Some([128; 3])).collect();
            assert!(changed.len() > 100);
            // Half the diagonal of a pixel may stand out.
            let [breadth, height] = label.half().map(|half| half + 0.71);
            for [x, y] in changed {
                let [right, below] = label.offset([f64::from(x) + 0.5, f64::from(y) + 0.5]);
                assert!(right.abs() < breadth && below.abs() < height, "{degrees}°: {right} {below}");
            }
        }
    }

    #[test]
    fn labels_that_share_a_place_overlap() {
        let [breadth, height] = label([0.0; 2], 0.0).half();
        let level = label([0.0; 2], 0.0);
        assert!(level.overlaps(&label([2.0 * breadth - 0.1, 0.0], 0.0)));
        assert!(!level.overlaps(&label([2.0 * breadth + 0.1, 0.0], 0.0)));
        // An upright one beside it, and one across it whose corners lie outside.
        assert!(!level.overlaps(&label([breadth + height + 0.1, 0.0], 90.0)));
        assert!(level.overlaps(&label([0.0; 2], 90.0)));
        // The boxes of these about the axes overlap, they do not.
        let turned = label([0.0; 2], 45.0);
        assert!(!turned.overlaps(&label([1.5 * height, -1.5 * height], 45.0)));
        assert!(turned.covers([0.9 * breadth / 2f64.sqrt(), 0.9 * breadth / 2f64.sqrt()]));
    }
}
