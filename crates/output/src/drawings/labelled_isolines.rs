//! Isolines on a picture with their values, as on a map.
//!
//! A line is dark in a light casing, so that it is seen on every colour. Its value stands in a gap of the
//! line, along it and never upside down, where the line is about straight, and where the text meets neither
//! another text, nor another line, nor the border of the picture. A line without such a place has none.

use super::isolines::Isoline;
use super::label::Label;
use super::picture::{Colour, Picture};
use super::polyline::Polyline;
use super::stroke::Stroke;

const INK: Colour = [0; 3];
const CASING: Colour = [255; 3];
/// Share of what is below that the casing hides. Chosen.
const OPACITY: f64 = 0.45;
/// Times that steps of a pixel are evened out. Chosen by eye.
const EVENED: usize = 6;
/// Shortest line that is drawn, over the height of a text; and shortest that gets a value, over the text's
/// breadth. Chosen.
const SHORTEST: f64 = 2.0;
const ROOM: f64 = 2.0;
/// Least chord over length of the piece of line under a text. Chosen.
const STRAIGHT: f64 = 0.96;
/// Length of line, over the longer side of the picture, for each of which one value is told; and most of
/// them. Chosen.
const STRETCH: f64 = 0.9;
const MOST: usize = 4;
/// Cosine of the angle with the horizontal below which a line counts as steep. Chosen.
const STEEP: f64 = 0.15;
/// Step between places that are tried (pixels). Chosen.
const STEP: f64 = 4.0;

/// Isolines with the text of each.
#[derive(Clone, Debug, Default)]
pub(super) struct LabelledIsolines {
    lines: Vec<LabelledIsoline>,
}

/// An isoline with the text of its value.
#[derive(Clone, Debug)]
struct LabelledIsoline {
    line: Isoline,
    text: String,
}

impl LabelledIsolines {
    /// Adds the lines of one value, which is told by `text`.
    pub(super) fn add(&mut self, lines: &[Isoline], text: &str) {
        let labelled =
            |line: &Isoline| LabelledIsoline { line: line.smoothed(EVENED), text: text.to_owned() };
        self.lines.extend(lines.iter().map(labelled));
    }

    /// Draws them all.
    pub(super) fn draw(&self, picture: &mut Picture) {
        let [width, height] = picture.size();
        let size = if height.min(width) >= 900 { 20.0 } else { 16.0 };
        let map = LabelMap::new(&self.lines, size, [width, height].map(f64::from));
        let breadth = size / 11.0;
        for (colour, breadth, opacity) in [(CASING, breadth + 2.4, OPACITY), (INK, breadth, 1.0)] {
            let mut stroke = Stroke::new([width, height]);
            map.pieces().iter().for_each(|piece| stroke.line(piece, breadth));
            stroke.draw(picture, colour, opacity);
        }
        map.placed.iter().for_each(|placed| placed.label.draw(picture));
    }
}

/// The lines that are drawn, longest first, and where their values stand.
struct LabelMap<'a> {
    size: f64,
    extent: [f64; 2],
    isolines: Vec<DrawnIsoline<'a>>,
    placed: Vec<PlacedLabel<'a>>,
}

/// A line with the text of its value.
struct DrawnIsoline<'a> {
    polyline: Polyline<'a>,
    text: &'a str,
}

/// A text in a gap of a line.
struct PlacedLabel<'a> {
    line: usize,
    /// Lengths along the line at which the gap begins and ends.
    gap: [f64; 2],
    label: Label<'a>,
}

impl<'a> LabelMap<'a> {
    fn new(lines: &'a [LabelledIsoline], size: f64, extent: [f64; 2]) -> Self {
        let drawn = |labelled: &'a LabelledIsoline| DrawnIsoline {
            polyline: Polyline::new(&labelled.line.points),
            text: &labelled.text,
        };
        let mut isolines: Vec<DrawnIsoline> = lines.iter().map(drawn).collect();
        isolines.retain(|isoline| isoline.polyline.length() > SHORTEST * size);
        isolines.sort_by(|a, b| b.polyline.length().total_cmp(&a.polyline.length()));
        let mut map = Self { size, extent, isolines, placed: Vec::new() };
        (0..map.isolines.len()).for_each(|line| map.label(line));
        map
    }

    /// Places the values of a line.
    fn label(&mut self, line: usize) {
        let length = self.isolines[line].polyline.length();
        let usual = self.extent[0].max(self.extent[1]) * STRETCH;
        let stretches = ((length / usual) as usize).clamp(1, MOST);
        for stretch in 0..stretches {
            let ends = [stretch, stretch + 1].map(|k| length * k as f64 / stretches as f64);
            self.placed.extend(self.place(line, ends));
        }
    }

    /// The place nearest to the middle of a stretch of a line where a text may stand.
    fn place(&self, line: usize, [from, to]: [f64; 2]) -> Option<PlacedLabel<'a>> {
        let middle = 0.5 * (from + to);
        let level =
            Label { text: self.isolines[line].text, size: self.size, middle: [0.0; 2], along: [1.0, 0.0] };
        let half = level.half()[0];
        if to - from < 2.0 * ROOM * half {
            return None;
        }
        let most = ((0.5 * (to - from) - half) / STEP) as usize;
        let lengths = (0..=most).flat_map(|k| [middle + STEP * k as f64, middle - STEP * k as f64]);
        lengths
            .filter_map(|length| {
                let gap = [length - half, length + half];
                let label = self.label_at(line, gap)?;
                self.is_free(line, &label).then_some(PlacedLabel { line, gap, label })
            })
            .next()
    }

    /// The text along the piece of a line, if that is about straight.
    fn label_at(&self, line: usize, [from, to]: [f64; 2]) -> Option<Label<'a>> {
        let DrawnIsoline { polyline, text } = &self.isolines[line];
        let [start, end] = [from, to].map(|length| polyline.at(length));
        let chord = (end[0] - start[0]).hypot(end[1] - start[1]);
        if chord < STRAIGHT * (to - from) {
            return None;
        }
        let along = upright([0, 1].map(|k| (end[k] - start[k]) / chord));
        Some(Label { text, size: self.size, middle: polyline.at(0.5 * (from + to)), along })
    }

    fn is_free(&self, line: usize, label: &Label) -> bool {
        let inside = |corner: [f64; 2]| (0..2).all(|k| (1.0..self.extent[k] - 1.0).contains(&corner[k]));
        let crosses = |(other, isoline): (usize, &DrawnIsoline)| {
            other != line && isoline.polyline.points().iter().any(|point| label.covers(*point))
        };
        label.corners().into_iter().all(inside)
            && !self.placed.iter().any(|placed| placed.label.overlaps(label))
            && !self.isolines.iter().enumerate().any(crosses)
    }

    /// The lines outside their gaps.
    fn pieces(&self) -> Vec<Vec<[f64; 2]>> {
        let mut pieces = Vec::new();
        for (line, DrawnIsoline { polyline, .. }) in self.isolines.iter().enumerate() {
            let gaps = self.placed.iter().filter(|placed| placed.line == line).map(|placed| placed.gap);
            let mut from = 0.0;
            for [begin, end] in gaps.chain([[polyline.length(); 2]]) {
                pieces.push(polyline.between([from, begin]));
                from = end;
            }
        }
        pieces
    }
}

/// The direction or its opposite: letters are read from the left, on steep lines from below.
fn upright([right, down]: [f64; 2]) -> [f64; 2] {
    let is_upright = if right.abs() < STEEP { down < 0.0 } else { right > 0.0 };
    if is_upright { [right, down] } else { [-right, -down] }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Circles about the middle of a picture of 400 × 300 pixels, some of which leave it.
    fn rings() -> Vec<LabelledIsoline> {
        let ring = |radius: f64| {
            let point = |k: i32| {
                let angle = f64::from(k) / 720.0 * std::f64::consts::TAU;
                [200.0 + radius * angle.cos(), 150.0 + radius * angle.sin()]
            };
            let line = Isoline { level: radius, points: (0..=720).map(point).collect() };
            LabelledIsoline { line, text: format!("{radius}") }
        };
        [8.0, 30.0, 60.0, 75.0, 80.0, 120.0, 190.0].map(ring).to_vec()
    }

    #[test]
    fn labels_stand_apart_and_within_on_their_lines() {
        let lines = rings();
        let map = LabelMap::new(&lines, 15.0, [400.0, 300.0]);
        assert!(map.placed.len() >= 4, "{} of 7 rings have a label", map.placed.len());
        for (k, placed) in map.placed.iter().enumerate() {
            let label = &placed.label;
            assert!(map.placed[..k].iter().all(|other| !other.label.overlaps(label)));
            assert!(label.along[0] > -STEEP, "no text is upside down");
            let radius: f64 = label.text.parse().unwrap();
            let [x, y] = [label.middle[0] - 200.0, label.middle[1] - 150.0];
            assert!((x.hypot(y) - radius).abs() < 0.01, "the text {} stands on its ring", label.text);
            assert!((x * label.along[0] + y * label.along[1]).abs() < 0.01 * radius, "and runs along it");
            for [x, y] in label.corners() {
                assert!((0.0..400.0).contains(&x) && (0.0..300.0).contains(&y));
            }
        }
        assert!(
            !map.placed.iter().any(|placed| placed.label.text == "8"),
            "there is no room on a short line"
        );
    }

    #[test]
    fn lines_have_a_gap_at_their_labels() {
        let lines = rings();
        let map = LabelMap::new(&lines, 15.0, [400.0, 300.0]);
        let length = |points: &[[f64; 2]]| Polyline::new(points).length();
        let drawn: f64 = map.pieces().iter().map(|piece| length(piece)).sum();
        let whole: f64 = map.isolines.iter().map(|isoline| isoline.polyline.length()).sum();
        let gaps: f64 = map.placed.iter().map(|placed| placed.gap[1] - placed.gap[0]).sum();
        assert!((drawn - (whole - gaps)).abs() < 1e-9 * whole);
    }
}
