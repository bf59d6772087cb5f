//! Pairs that are equal up to similarity.
//!
//! G has no scale and knows no directions: two pairs of parallelograms of the same relative pose have the same block.
//! With centres c, half sides a and b (the coordinates of the basis run along them) and d = c_j − c_i the pose is
//! the table of the scalar products of a_i, b_i, a_j, b_j and d over |d|², which no motion and no reflection changes, and
//! the sides on which the fronts lie. Turning a half side round, or exchanging the two, only changes the signs or the order of
//! the polynomials, and exchanging the elements transposes the block: each pair is brought to a standard form first.
//!
//! Poses are found by a hash of their rounded entries and compared entry by entry before they count as equal. Where the standard
//! form is not unique for want of digits, equal pairs may be missed; unequal ones never pass.

use std::hash::{DefaultHasher, Hash, Hasher};

use radiosity_core::basis::total;
use radiosity_geom::DVec3;

use crate::elements::Element;
use crate::elements::basis::Frame;
use crate::elements::space::Space;

/// Poses whose entries differ by less are equal.
const EQUAL: f64 = 1e-13;
/// Entries are rounded to multiples of this for the hash.
const GRID: f64 = 1e-8;
/// Keeps entries such as 0 and ½, and their negatives, away from where truncation turns.
const OFFSET: f64 = 0.37;

/// A parallelogram element: its centre and the half sides along which its polynomials run.
#[derive(Clone, Copy, Debug)]
pub(in crate::transport) struct Panel {
    center: DVec3,
    sides: [DVec3; 2],
    normal: DVec3,
    order: usize,
}

impl Panel {
    /// The panel that fills the frame of an element with product polynomials of total degree.
    pub(in crate::transport) fn of(element: &Element) -> Option<Self> {
        let (Some((_, normal)), [patch]) = (element.plane, &element.patches[..]) else { return None };
        let Frame::Plane { origin, first, second } = element.basis.frame() else { return None };
        let plain = element.basis.is_product() && element.basis.space() == Space::Total;
        if !plain || !patch.is_parallelogram() {
            return None;
        }
        let axis = first.cross(*second);
        let sides = [second.cross(axis), axis.cross(*first)].map(|side| side / axis.length_squared());
        let filled = (4.0 * sides[0].cross(sides[1]).length() - element.area).abs() <= EQUAL * element.area;
        filled.then_some(Self { center: *origin, sides, normal, order: element.basis.order() })
    }
}

/// A pair of panels in standard form.
#[derive(Clone, Copy, Debug)]
pub(in crate::transport) struct Pose {
    /// Scalar products over |d|².
    entries: [f64; 14],
    fronts: [bool; 2],
    orders: [usize; 2],
    /// Whether the emitter stands first.
    transposed: bool,
    /// How each of the two stands in the standard form.
    turns: [Turn; 2],
}

/// Which half sides were exchanged, then turned round.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Turn {
    exchanged: bool,
    reversed: [bool; 2],
}

impl Pose {
    /// The standard form of a pair; None where the centre of one lies in the plane of the other.
    pub(in crate::transport) fn of(receiver: &Panel, emitter: &Panel) -> Option<Self> {
        let d = emitter.center - receiver.center;
        let scale = d.length_squared();
        let height = |panel: &Panel, d: DVec3| panel.normal.dot(d) / scale.sqrt();
        let heights = [height(receiver, d), height(emitter, -d)];
        if heights.iter().any(|h| h.abs() < 1e-6) {
            return None;
        }
        let rank = |panel: &Panel, height: f64| {
            let [a, b] = panel.sides.map(|side| side.length_squared() / scale);
            [rounded(a + b), rounded(a * b), rounded(height)]
        };
        let transposed = rank(receiver, heights[0]) < rank(emitter, heights[1]);
        let (panels, d, heights) = if transposed {
            ([emitter, receiver], -d, [heights[1], heights[0]])
        } else {
            ([receiver, emitter], d, heights)
        };
        let (first, turn_i) = stand(panels[0].sides, &[d, panels[1].sides[0], panels[1].sides[1]], scale);
        let (second, turn_j) = stand(panels[1].sides, &[d, first[0], first[1]], scale);
        let dot = |x: DVec3, y: DVec3| x.dot(y) / scale;
        let [a, b] = first;
        let [e, f] = second;
        let entries = [
            dot(a, a),
            dot(a, b),
            dot(b, b),
            dot(e, e),
            dot(e, f),
            dot(f, f),
            dot(a, e),
            dot(a, f),
            dot(b, e),
            dot(b, f),
            dot(d, a),
            dot(d, b),
            dot(d, e),
            dot(d, f),
        ];
        Some(Self {
            entries,
            fronts: heights.map(|h| h > 0.0),
            orders: panels.map(|panel| panel.order),
            transposed,
            turns: [turn_i, turn_j],
        })
    }

    /// A number that equal poses share.
    pub(in crate::transport) fn hash(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.entries.map(rounded).hash(&mut hasher);
        (self.fronts, self.orders).hash(&mut hasher);
        hasher.finish()
    }

    /// Whether both have the same block in standard form.
    pub(in crate::transport) fn equals(&self, other: &Self) -> bool {
        let close = |(x, y): (&f64, &f64)| (x - y).abs() <= EQUAL * x.abs().max(1.0);
        self.fronts == other.fronts
            && self.orders == other.orders
            && self.entries.iter().zip(&other.entries).all(close)
    }

    /// The block of this pair from the `block` of the equal pair `other`.
    pub(in crate::transport) fn block_from(&self, other: &Self, block: &[f64]) -> Vec<f64> {
        let own = [0, 1].map(|side| self.turns[side].places(self.orders[side]));
        let theirs = [0, 1].map(|side| other.turns[side].places(self.orders[side]));
        let counts = self.orders.map(total::count);
        let at = |pose: &Self, k: usize, l: usize| {
            if pose.transposed { l * counts[0] + k } else { k * counts[1] + l }
        };
        let mut values = vec![0.0; block.len()];
        for ((k, s), (m, r)) in own[0].iter().zip(&theirs[0]) {
            for ((l, t), (n, q)) in own[1].iter().zip(&theirs[1]) {
                values[at(self, *k, *l)] = s * t * r * q * block[at(other, *m, *n)];
            }
        }
        values
    }
}

impl Turn {
    /// For each polynomial of the standard form its place in the element's order, and its sign.
    fn places(self, order: usize) -> Vec<(usize, f64)> {
        let sign = |reversed: bool, degree: usize| if reversed && degree % 2 == 1 { -1.0 } else { 1.0 };
        let place = |k: usize| {
            let (i, j) = total::degrees(k);
            let sign = sign(self.reversed[0], i) * sign(self.reversed[1], j);
            (if self.exchanged { total::index(j, i) } else { k }, sign)
        };
        (0..total::count(order)).map(place).collect()
    }
}

/// Brings two half sides into standard form: the longer first, then the one that points more along the first of the
/// `others`; each turned so that its first product with one of them that is not zero is positive.
fn stand([a, b]: [DVec3; 2], others: &[DVec3; 3], scale: f64) -> ([DVec3; 2], Turn) {
    let rank = |side: DVec3| {
        let along = |other: &DVec3| rounded(side.dot(*other).abs() / scale);
        // The two sides of the other are not in order yet: their sum of squares is.
        let both = others[1..].iter().map(|other| (side.dot(*other) / scale).powi(2)).sum::<f64>();
        [rounded(side.length_squared() / scale), along(&others[0]), rounded(both)]
    };
    let exchanged = rank(a) < rank(b);
    let sides = if exchanged { [b, a] } else { [a, b] };
    let reversed = sides.map(|side| {
        let products = others.iter().map(|other| side.dot(*other) / scale);
        products.into_iter().find(|x| x.abs() > GRID).is_some_and(|x| x < 0.0)
    });
    let turned = |k: usize| if reversed[k] { -sides[k] } else { sides[k] };
    ([turned(0), turned(1)], Turn { exchanged, reversed })
}

fn rounded(x: f64) -> i64 {
    (x * (1.0 / GRID) + OFFSET) as i64
}
