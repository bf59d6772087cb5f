//! Congruent pairs: parallelograms that are equal up to similarity, and therefore share one block.
//!
//! G has neither scale nor directions. With the centres c, the half sides a and b along which the basis runs,
//! and d = c_j − c_i, the pose of a pair is the table of scalar products of a_i, b_i, a_j, b_j and d, divided
//! by |d|², together with the sides on which the fronts lie. Motions and reflections do not change it.
//! Reversing a half side, or exchanging the two of an element, only changes signs or order of the
//! polynomials; exchanging the elements transposes the block. Each pair is therefore brought to a standard
//! form first.
//!
//! Poses are found by a hash of their rounded entries and compared entry by entry. Where rounding makes the
//! standard form ambiguous, congruent pairs may be missed; pairs that are not congruent never pass.

use std::hash::{DefaultHasher, Hash, Hasher};

use radiosity_core::basis::total;
use radiosity_elements::Element;
use radiosity_elements::basis::Frame;
use radiosity_elements::space::Space;
use radiosity_geom::DVec3;

/// Poses are equal if no entry differs by more, absolutely below 1 and relatively above: some hundred
/// rounding errors.
const EQUAL: f64 = 1e-13;
/// Grid of the hash: entries are rounded to multiples of this. Far above rounding, far below differences
/// between distinct pairs in practice.
const GRID: f64 = 1e-8;
/// Offset of the grid, so that frequent entries such as 0 and ½ do not lie where rounding changes. Any odd
/// fraction serves.
const OFFSET: f64 = 0.37;

/// A parallelogram element: centre and the half sides along which its polynomials run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Panel {
    center: DVec3,
    sides: [DVec3; 2],
    normal: DVec3,
    order: usize,
}

impl Panel {
    /// The element as a panel, if it is a parallelogram that fills its frame and carries product polynomials
    /// of total degree.
    pub(crate) fn of(element: &Element) -> Option<Self> {
        let (Some(plane), [patch]) = (element.plane, &element.patches[..]) else { return None };
        let Frame::Plane { origin, first, second } = element.basis.frame() else { return None };
        let plain = element.basis.is_product() && element.basis.space() == Space::Total;
        if !plain || !patch.is_parallelogram() {
            return None;
        }
        let axis = first.cross(*second);
        let sides = [second.cross(axis), axis.cross(*first)].map(|side| side / axis.length_squared());
        let filled = (4.0 * sides[0].cross(sides[1]).length() - element.area).abs() <= EQUAL * element.area;
        let order = element.basis.order();
        filled.then_some(Self { center: *origin, sides, normal: plane.normal, order })
    }
}

/// A pair of panels in standard form.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pose {
    /// Scalar products over |d|².
    entries: [f64; 14],
    fronts: [bool; 2],
    orders: [usize; 2],
    /// Whether the emitter comes first.
    transposed: bool,
    /// Turns of the sides of either panel into the standard form.
    turns: [Turn; 2],
}

/// Exchange of the two half sides of a panel, then reversal of either.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Turn {
    exchanged: bool,
    reversed: [bool; 2],
}

impl Pose {
    /// The standard form of a pair. None where the centre of one lies in the plane of the other to 1e-6 of
    /// the distance: the fronts are then not certain.
    pub(crate) fn of(receiver: &Panel, emitter: &Panel) -> Option<Self> {
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

    /// Equal for equal poses.
    pub(crate) fn hash(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.entries.map(rounded).hash(&mut hasher);
        (self.fronts, self.orders).hash(&mut hasher);
        hasher.finish()
    }

    /// Whether both have the same block in standard form.
    pub(crate) fn equals(&self, other: &Self) -> bool {
        let close = |(x, y): (&f64, &f64)| (x - y).abs() <= EQUAL * x.abs().max(1.0);
        self.fronts == other.fronts
            && self.orders == other.orders
            && self.entries.iter().zip(&other.entries).all(close)
    }

    /// The block of this pair, from the `block` of the congruent pair `other`.
    pub(crate) fn block_from(&self, other: &Self, block: &[f64]) -> Vec<f64> {
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
    /// Place in the element's order and sign of each polynomial of the standard form.
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

/// Brings two half sides into standard form: the longer first, else the one with the larger product with the
/// first of `others`. Each is reversed if needed so that its first nonzero product with one of `others` is
/// positive.
fn stand([a, b]: [DVec3; 2], others: &[DVec3; 3], scale: f64) -> ([DVec3; 2], Turn) {
    let rank = |side: DVec3| {
        let along = |other: &DVec3| rounded(side.dot(*other).abs() / scale);
        // The two sides of the other panel are not ordered yet; their sum of squares is independent of their
        // order.
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
