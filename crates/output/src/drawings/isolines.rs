//! Isolines: where a field has one value.
//!
//! Marching squares (Lorensen and Cline 1987, in the plane): the field is linear along the lines between the
//! middles of neighbouring pixels, and in each cell of four middles the places where it takes the value are
//! joined. Of the two ways to join four places the mean of the corners decides (Nielson and Hamann 1991).
//! Cells in which anything is hidden, or that lie in two parts of a picture, hold no isoline: what jumps
//! there has no value in between. Lines therefore may end anywhere, which libraries of closed contours do not
//! offer.

use std::collections::BTreeMap;

use radiosity_reading::field::Field;

/// A line along which a field has the value `level`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Isoline {
    /// The value.
    pub level: f64,
    /// Its points in pixels from the left upper corner, x right and y down; the first again at the end of a
    /// closed line.
    pub points: Vec<[f64; 2]>,
}

impl Isoline {
    /// Whether it ends where it begins.
    fn is_closed(&self) -> bool {
        self.points.len() > 2 && self.points.first() == self.points.last()
    }

    /// The lines of a field at a level; `parts` names, pixel by pixel, the part of the picture that a pixel
    /// belongs to wholly.
    ///
    /// # Panics
    /// If there is not a part per pixel.
    pub(super) fn all(field: &Field, parts: &[Option<u32>], level: f64) -> Vec<Self> {
        let [width, height] = field.size().map(|pixels| pixels as usize);
        assert_eq!(parts.len(), width * height, "one part per pixel");
        let values: Vec<f64> = field.pixels().map(|(value, _)| value).collect();
        let mut crossings = Crossings { width, values: &values, level, next: BTreeMap::new() };
        for y in 0..height.saturating_sub(1) {
            for x in 0..width.saturating_sub(1) {
                let at = |dx: usize, dy: usize| parts[(y + dy) * width + x + dx];
                let part = at(0, 0);
                if part.is_some() && [at(1, 0), at(0, 1), at(1, 1)].iter().all(|other| *other == part) {
                    crossings.add_cell([x, y]);
                }
            }
        }
        crossings.lines().into_iter().map(|points| Self { level, points }).collect()
    }

    /// The line with its steps of a pixel evened out: `times` times each point between its neighbours moves
    /// to the mean of itself and their middle. Straight lines stay, and ends stay.
    #[must_use]
    pub(super) fn smoothed(&self, times: usize) -> Self {
        let mut points = self.points.clone();
        for _ in 0..times {
            points = if self.is_closed() { evened_ring(&points) } else { evened(&points) };
        }
        Self { level: self.level, points }
    }
}

fn mean(before: [f64; 2], own: [f64; 2], after: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|k| 0.5 * own[k] + 0.25 * (before[k] + after[k]))
}

fn evened(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let inner = points.windows(3).map(|three| mean(three[0], three[1], three[2]));
    let (first, last) = (points.first().copied(), points.last().copied());
    first.into_iter().chain(inner).chain(last).collect()
}

fn evened_ring(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let count = points.len() - 1;
    let own = |k: usize| points[k % count];
    (0..=count).map(|k| mean(own(k + count - 1), own(k), own(k + 1))).collect()
}

/// A line between the middles of two neighbouring pixels: twice the index of the left or upper one, plus 1
/// downwards.
type Side = usize;

/// The places where a field takes a value, on the sides of cells, and which of them are joined.
struct Crossings<'a> {
    width: usize,
    values: &'a [f64],
    level: f64,
    /// The one or two sides that a side is joined to.
    next: BTreeMap<Side, Vec<Side>>,
}

impl Crossings<'_> {
    fn is_above(&self, [x, y]: [usize; 2]) -> bool {
        self.values[y * self.width + x] >= self.level
    }

    /// Joins the crossings of the cell with its left upper corner in the middle of a pixel.
    fn add_cell(&mut self, [x, y]: [usize; 2]) {
        let corners = [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]];
        let above = corners.map(|corner| self.is_above(corner));
        let at = |[x, y]: [usize; 2]| y * self.width + x;
        // Top, right, bottom, left: from each corner to the next.
        let sides = [2 * at(corners[0]), 2 * at(corners[1]) + 1, 2 * at(corners[3]), 2 * at(corners[0]) + 1];
        let crossed: Vec<Side> =
            (0..4).filter(|k| above[*k] != above[(k + 1) % 4]).map(|k| sides[k]).collect();
        match crossed[..] {
            [a, b] => self.join(a, b),
            [top, right, bottom, left] => {
                let sum: f64 = corners.iter().map(|corner| self.values[at(*corner)]).sum();
                // Where the middle is as the first corner is, lines cut off its neighbours, else itself.
                if (0.25 * sum >= self.level) == above[0] {
                    self.join(top, right);
                    self.join(bottom, left);
                } else {
                    self.join(left, top);
                    self.join(right, bottom);
                }
            }
            _ => {}
        }
    }

    fn join(&mut self, a: Side, b: Side) {
        self.next.entry(a).or_default().push(b);
        self.next.entry(b).or_default().push(a);
    }

    /// All lines: first those with ends, then the closed ones.
    fn lines(mut self) -> Vec<Vec<[f64; 2]>> {
        let mut lines = Vec::new();
        let ends: Vec<Side> =
            self.next.iter().filter(|(_, next)| next.len() == 1).map(|(side, _)| *side).collect();
        for end in ends {
            if self.next.contains_key(&end) {
                lines.push(self.line(end));
            }
        }
        while let Some((&start, _)) = self.next.first_key_value() {
            let mut line = self.line(start);
            line.push(line[0]);
            lines.push(line);
        }
        lines
    }

    /// Takes out the line from `start` on.
    fn line(&mut self, start: Side) -> Vec<[f64; 2]> {
        let mut points = Vec::new();
        let mut side = Some(start);
        while let Some(own) = side {
            points.push(self.place(own));
            let next = self.next.remove(&own).unwrap_or_default();
            side = next.into_iter().find(|next| self.next.contains_key(next));
        }
        points
    }

    fn place(&self, side: Side) -> [f64; 2] {
        let index = side / 2;
        let step = if side.is_multiple_of(2) { 1 } else { self.width };
        let [from, to] = [self.values[index], self.values[index + step]];
        let part = (self.level - from) / (to - from);
        let [x, y] = [index % self.width, index / self.width].map(|k| k as f64 + 0.5);
        if step == 1 { [x + part, y] } else { [x, y + part] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Isoline {
        /// Its length in pixels.
        pub(crate) fn length(&self) -> f64 {
            self.points.windows(2).map(|ends| distance(ends[0], ends[1])).sum()
        }
    }

    fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
        (b[0] - a[0]).hypot(b[1] - a[1])
    }

    fn field([width, height]: [u32; 2], value: impl Fn(f64, f64) -> f64) -> Field {
        let middles = (0..height).flat_map(|y| (0..width).map(move |x| [x, y].map(|k| f64::from(k) + 0.5)));
        let values: Vec<f64> = middles.map(|[x, y]| value(x, y)).collect();
        let coverage = vec![1.0; values.len()];
        Field::new([width, height], values, coverage)
    }

    fn whole(size: [u32; 2]) -> Vec<Option<u32>> {
        vec![Some(0); (size[0] * size[1]) as usize]
    }

    #[test]
    fn isolines_of_a_linear_field_are_straight_and_in_place() {
        let size = [60, 40];
        for [a, b] in [[1.0, 0.0], [0.3, -0.7], [-2.0, 0.01], [0.0, 1.0], [1.0, 1.0]] {
            let linear = |x: f64, y: f64| a * x + b * y;
            let level = linear(29.8, 20.3);
            let lines = Isoline::all(&field(size, linear), &whole(size), level);
            assert_eq!(lines.len(), 1, "one line of {a} x + {b} y");
            for line in [&lines[0], &lines[0].smoothed(5)] {
                let farthest = line.points.iter().map(|[x, y]| (linear(*x, *y) - level).abs() / a.hypot(b));
                assert!(farthest.fold(0.0, f64::max) < 1e-12);
                let [first, last] = [line.points[0], line.points[line.points.len() - 1]];
                let is_rim =
                    |[x, y]: [f64; 2]| [x - 0.5, 59.5 - x, y - 0.5, 39.5 - y].iter().any(|d| d.abs() < 1e-12);
                assert!(is_rim(first) && is_rim(last), "from {first:?} to {last:?}");
                assert!((line.length() - distance(first, last)).abs() < 1e-9, "it does not turn back");
            }
        }
    }

    #[test]
    fn isolines_of_a_cone_are_circles() {
        let size = [80, 80];
        let cone = |x: f64, y: f64| (x - 40.2).hypot(y - 39.6);
        for radius in [10.0, 25.0, 33.3] {
            let lines = Isoline::all(&field(size, cone), &whole(size), radius);
            assert_eq!(lines.len(), 1);
            assert!(lines[0].is_closed());
            // Between two middles the cone bends by 1/(8r); each of four times a point moves by 1/(4r) to the
            // mean.
            for (line, bound) in [(&lines[0], 0.15 / radius), (&lines[0].smoothed(4), 1.3 / radius)] {
                let farthest =
                    line.points.iter().map(|[x, y]| (cone(*x, *y) - radius).abs()).fold(0.0, f64::max);
                assert!(farthest < bound, "{farthest} at radius {radius}");
                assert!((line.length() / (std::f64::consts::TAU * radius) - 1.0).abs() < 0.02);
            }
        }
    }

    #[test]
    fn parts_of_a_picture_are_apart() {
        let size = [20, 10];
        let mut parts = whole(size);
        for (k, part) in parts.iter_mut().enumerate() {
            *part = match k % 20 {
                0..8 => Some(1),
                8..10 => None,
                _ => Some(2),
            };
        }
        // Along x = 9 the field jumps from 0 to 9: nothing is drawn there, and lines along y are cut.
        let field = field(size, |x, y| y + if x < 9.0 { 0.0 } else { 9.0 });
        assert!(
            Isoline::all(&field, &parts, 9.75).iter().all(|line| line.points.iter().all(|[x, _]| *x > 10.0))
        );
        let lines = Isoline::all(&field, &parts, 9.75);
        assert_eq!(lines.len(), 1);
        assert!((lines[0].length() - 9.0).abs() < 1e-12, "from x = 10.5 to 19.5");
    }

    #[test]
    fn saddles_are_joined_so_that_the_higher_side_follows_the_middle() {
        let corners = |a, b, c, d| Field::new([2, 2], vec![a, b, d, c], vec![1.0; 4]);
        for (field, through) in [(corners(3.0, 0.0, 3.0, 0.0), true), (corners(1.2, 0.0, 1.2, 0.0), false)] {
            let lines = Isoline::all(&field, &whole([2, 2]), 1.0);
            assert_eq!(lines.len(), 2);
            // Lines that let the high corners through cut off the low ones, at the right upper and the left
            // lower corner.
            let near = |line: &Isoline, corner: [f64; 2]| {
                line.points.iter().all(|point| distance(*point, corner) < 1.0)
            };
            let cuts = |corner| lines.iter().any(|line| near(line, corner));
            assert_eq!(cuts([1.5, 0.5]) && cuts([0.5, 1.5]), through);
            assert_eq!(cuts([0.5, 0.5]) && cuts([1.5, 1.5]), !through);
        }
    }
}
