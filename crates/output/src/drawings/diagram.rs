//! Diagrams: panels of curves over logarithmic or linear abscissas, with one legend.

use super::drawing::{Drawing, Shape, Words};
use super::nice_numbers::{multiples, ratios, round_above, round_around, round_below};
use super::picture::Colour;
use super::tick::Tick;

/// Colours that most eyes distinguish, in grey too (Okabe and Ito).
pub const COLOURS: [Colour; 6] =
    [[0, 114, 178], [213, 94, 0], [0, 158, 115], [204, 121, 167], [86, 180, 233], [230, 159, 0]];

/// Units across and down of a panel, and what its axes leave free at the left, right, top and foot. Chosen.
const PANEL: [f64; 2] = [460.0, 390.0];
const FREE: [[f64; 2]; 2] = [[72.0, 16.0], [30.0, 50.0]];
/// Heights of lines of text: title, others, numbers beside points; and of a line with the space below it.
const TITLE: f64 = 20.0;
const LINE: f64 = 16.0;
const SMALL: f64 = 14.0;
const STEP: f64 = 22.0;
/// Length of line in the legend, space to its text and to the next, breadth of a letter. Chosen.
const SWATCH: f64 = 28.0;
const GAP: f64 = 8.0;
const LETTER: f64 = 0.5 * LINE;
const INK: Colour = [0; 3];
const GREY: Colour = [90; 3];
/// Lines of the numbers that are told, and of those between.
const BOLD: Colour = [190; 3];
const LIGHT: Colour = [235; 3];

/// Panels side by side under a title.
#[derive(Clone, Debug)]
pub struct Diagram {
    /// The title.
    pub title: String,
    /// The line below the title.
    pub caption: String,
    /// Panels in a row.
    pub columns: usize,
    /// The panels, row by row, at least one.
    pub panels: Vec<Panel>,
}

/// A pair of axes with curves.
#[derive(Clone, Debug)]
pub struct Panel {
    /// The title; empty for none.
    pub title: String,
    /// Quantities along and up.
    pub axes: [String; 2],
    /// Spacing of the numbers along; those up are logarithmic.
    pub along: Spacing,
    /// The curves, later ones above earlier ones.
    pub curves: Vec<Curve>,
}

/// Spacing of the numbers of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spacing {
    /// Equal lengths for equal ratios; numbers are positive.
    Logarithmic,
    /// Equal lengths for equal differences.
    Linear,
}

/// A line through dots. The legend tells curves of equal labels once, in their first colour.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Its text in the legend.
    pub label: String,
    /// Its colour.
    pub colour: Colour,
    /// The dots on the line.
    pub dots: Vec<Dot>,
    /// Places of paler dots beside the line.
    pub others: Vec<[f64; 2]>,
}

/// A dot at numbers that are positive where the axis is logarithmic.
#[derive(Clone, Debug)]
pub struct Dot {
    /// Along and up.
    pub place: [f64; 2],
    /// Text beside it.
    pub text: String,
}

impl Diagram {
    /// The diagram as a drawing.
    pub fn drawing(&self) -> Drawing {
        let width = PANEL[0] * self.columns as f64;
        let title = words(&self.title, TITLE, [0.5 * width, STEP], 0.5);
        let caption = words(&self.caption, LINE, [0.5 * width, 2.0 * STEP], 0.5);
        let mut shapes = vec![Shape::Text(title), Shape::Text(Words { colour: GREY, ..caption })];
        let legend = self.legend();
        let longest = legend.iter().map(|curve| curve.label.chars().count()).max().unwrap_or(0);
        let entry = SWATCH + 3.0 * GAP + LETTER * longest as f64;
        let in_a_row = ((width / entry) as usize).clamp(1, legend.len().max(1));
        let mut top = 3.25 * STEP;
        for row in legend.chunks(in_a_row) {
            let left = 0.5 * (width - entry * in_a_row as f64) + GAP;
            let entries = (0..).zip(row);
            shapes.extend(entries.flat_map(|(k, curve)| curve.entry([left + entry * f64::from(k), top])));
            top += STEP;
        }
        for (k, panel) in self.panels.iter().enumerate() {
            let [column, row] = [k % self.columns, k / self.columns].map(|place| place as f64);
            shapes.extend(panel.shapes([PANEL[0] * column, top + PANEL[1] * row]));
        }
        let rows = self.panels.len().div_ceil(self.columns) as f64;
        Drawing { size: [width, top + PANEL[1] * rows], shapes }
    }

    /// The first curve of each label.
    fn legend(&self) -> Vec<&Curve> {
        let mut legend: Vec<&Curve> = Vec::new();
        for curve in self.panels.iter().flat_map(|panel| &panel.curves) {
            if legend.iter().all(|other| other.label != curve.label) {
                legend.push(curve);
            }
        }
        legend
    }
}

impl Curve {
    /// The numbers of all its places along axis `k`.
    fn numbers(&self, k: usize) -> impl Iterator<Item = f64> {
        self.dots.iter().map(|dot| dot.place).chain(self.others.iter().copied()).map(move |place| place[k])
    }

    /// Its line in the legend.
    fn entry(&self, [x, y]: [f64; 2]) -> [Shape; 3] {
        let lines = vec![vec![[x, y], [x + SWATCH, y]]];
        [
            Shape::Lines { lines, width: 2.0, colour: self.colour },
            Shape::Disk { center: [x + 0.5 * SWATCH, y], radius: 3.0, colour: self.colour },
            Shape::Text(words(&self.label, LINE, [x + SWATCH + GAP, y], 0.0)),
        ]
    }

    fn shapes(&self, axes: &[Axis; 2]) -> Vec<Shape> {
        let colour = self.colour;
        let at = |place: [f64; 2]| [0, 1].map(|k| axes[k].at(place[k]));
        let pale = colour.map(|code| 128 + code / 2);
        let other = |place: &[f64; 2]| Shape::Disk { center: at(*place), radius: 2.0, colour: pale };
        let line = self.dots.iter().map(|dot| at(dot.place)).collect();
        let line = Shape::Lines { lines: vec![line], width: 2.0, colour };
        let dot = |dot: &Dot| Shape::Disk { center: at(dot.place), radius: 3.0, colour };
        let text = |dot: &Dot| {
            let [x, y] = at(dot.place);
            Shape::Text(Words { colour, ..words(&dot.text, SMALL, [x + 6.0, y - 8.0], 0.0) })
        };
        let texts = self.dots.iter().filter(|dot| !dot.text.is_empty()).map(text);
        let dots = self.dots.iter().map(dot);
        self.others.iter().map(other).chain([line]).chain(dots).chain(texts).collect()
    }
}

impl Panel {
    fn shapes(&self, [left, top]: [f64; 2]) -> Vec<Shape> {
        let [across, down] = [0, 1].map(|k| [left, top][k] + FREE[k][0]);
        let [right, foot] = [0, 1].map(|k| [left, top][k] + PANEL[k] - FREE[k][1]);
        let places = |k: usize| self.curves.iter().flat_map(move |curve| curve.numbers(k));
        let axes = [
            Axis::around(places(0), self.along, [across, right]),
            Axis::around(places(1), Spacing::Logarithmic, [foot, down]),
        ];
        let middle = [0.5 * (across + right), 0.5 * (down + foot)];
        let upright = Words { upright: true, ..words(&self.axes[1], LINE, [left + 16.0, middle[1]], 0.5) };
        let titles = [
            words(&self.axes[0], LINE, [middle[0], top + PANEL[1] - 14.0], 0.5),
            upright,
            words(&self.title, LINE + 2.0, [middle[0], top + 14.0], 0.5),
        ];
        let titles = titles.into_iter().map(Shape::Text);
        let curves = self.curves.iter().flat_map(|curve| curve.shapes(&axes));
        titles.chain(grid(&axes)).chain(curves).collect()
    }
}

/// The lines across both axes, and the numbers beside them.
fn grid(axes: &[Axis; 2]) -> Vec<Shape> {
    let rule = |k: usize, value: f64| -> Vec<[f64; 2]> {
        let along = axes[k].at(value).floor() + 0.5;
        axes[1 - k].ends.map(|other| if k == 0 { [along, other] } else { [other, along] }).to_vec()
    };
    let both = |numbers: &dyn Fn(&Axis) -> Vec<f64>, colour: Colour| {
        let lines = [0, 1].map(|k| numbers(&axes[k]).into_iter().map(|x| rule(k, x)).collect::<Vec<_>>());
        Shape::Lines { lines: lines.concat(), width: 1.0, colour }
    };
    let told = |axis: &Axis| axis.ticks().into_iter().map(|tick| tick.value).collect();
    let lines = [both(&Axis::between, LIGHT), both(&told, BOLD), both(&|axis| vec![axis.range[0]], INK)];
    let [across, up] = [&axes[0], &axes[1]];
    let mut last = f64::NEG_INFINITY;
    let below = across.ticks().into_iter().filter_map(|tick| {
        let (place, half) = (across.at(tick.value), 0.25 * SMALL * (tick.text.chars().count() + 1) as f64);
        let is_free = place - half > last;
        last = if is_free { place + half } else { last };
        is_free.then(|| words(&tick.text, SMALL, [place, up.ends[0] + 12.0], 0.5))
    });
    let beside = up
        .ticks()
        .into_iter()
        .map(|tick| words(&tick.text, SMALL, [across.ends[0] - 6.0, up.at(tick.value)], 1.0));
    lines.into_iter().chain(below.chain(beside).map(Shape::Text)).collect()
}

/// An axis.
struct Axis {
    spacing: Spacing,
    /// Round numbers at its ends.
    range: [f64; 2],
    /// The places of its ends.
    ends: [f64; 2],
}

impl Axis {
    /// The axis around `numbers`, of any length where there are none.
    fn around(numbers: impl Iterator<Item = f64>, spacing: Spacing, ends: [f64; 2]) -> Self {
        let [low, high] =
            numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [x.min(low), x.max(high)]);
        let range = match spacing {
            _ if low > high => [1.0, 10.0],
            Spacing::Linear => round_around([low, high]),
            Spacing::Logarithmic => {
                let [low, high] = [round_below(low), round_above(high)];
                [low, if high > low { high } else { 10.0 * low }]
            }
        };
        Self { spacing, range, ends }
    }

    /// The place of a number.
    fn at(&self, value: f64) -> f64 {
        let ([low, high], [first, last]) = (self.range, self.ends);
        let part = match self.spacing {
            Spacing::Linear => (value - low) / (high - low),
            Spacing::Logarithmic => (value / low).ln() / (high / low).ln(),
        };
        first + (last - first) * part
    }

    /// The numbers that are told.
    fn ticks(&self) -> Vec<Tick> {
        match self.spacing {
            Spacing::Linear => multiples(self.range),
            Spacing::Logarithmic => ratios(self.range),
        }
    }

    /// All numbers of one digit, of a logarithmic axis.
    fn between(&self) -> Vec<f64> {
        if self.spacing == Spacing::Linear {
            return Vec::new();
        }
        let [low, high] = self.range;
        let powers = low.log10().floor() as i32..=high.log10().ceil() as i32;
        let digits = powers.flat_map(|power| (1..10).map(move |digit| f64::from(digit) * 10f64.powi(power)));
        digits.filter(|x| (low..=high).contains(x)).collect()
    }
}

fn words(text: &str, size: f64, place: [f64; 2], before: f64) -> Words {
    Words { text: text.to_owned(), size, place, before, colour: INK, upright: false }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_have_round_ends_and_equal_lengths_for_equal_ratios() {
        let logarithmic =
            |numbers: &[f64]| Axis::around(numbers.iter().copied(), Spacing::Logarithmic, [0.0, 300.0]);
        let axis = logarithmic(&[0.0213, 7.0, 0.5]);
        assert_eq!(axis.range, [0.02, 8.0]);
        assert!((2.0 * axis.at(0.4) - 300.0).abs() < 1e-9, "√(0.02 · 8) is in the middle");
        assert_eq!(logarithmic(&[5.0]).range, [5.0, 50.0]);
        assert_eq!(logarithmic(&[]).range, [1.0, 10.0]);
    }

    #[test]
    fn linear_axes_have_equal_lengths_for_equal_differences() {
        let axis = Axis::around([0.0, 3.0, 9.0].into_iter(), Spacing::Linear, [20.0, 200.0]);
        assert_eq!(axis.range, [0.0, 9.0]);
        assert_eq!([0.0, 4.5, 9.0].map(|x| axis.at(x)), [20.0, 110.0, 200.0]);
        let told: Vec<f64> = axis.ticks().into_iter().map(|tick| tick.value).collect();
        assert_eq!(told, [0.0, 2.0, 4.0, 6.0, 8.0]);
    }
}
