//! K between two patches: chooses the points of the rule, sums, and converts back to Legendre functions.

use radiosity_core::{basis::total, convert};
use serde::{Deserialize, Serialize};

use crate::zatz1993::transfers::axis::Axis;
use crate::zatz1993::transfers::border;
use crate::zatz1993::transfers::border::Border;
use crate::zatz1993::transfers::charted_element::ChartedElement;
use crate::zatz1993::transfers::sum::{Sees, Sum};

/// Which of the paper's rules.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum PaperRules {
    /// Gauss–Legendre points for every pair (eq. 26).
    Legendre,
    /// Gauss–Jacobi points for pairs with a common edge (eq. 27), Gauss–Legendre for all others.
    Hybrid(HybridReading),
}

/// Reading of eq. 27; see the module `transfers`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum HybridReading {
    /// Weight (1 − s²)² (1 + t)², Gauss–Legendre points on the emitter: nearest to the paper's numbers.
    H1,
    /// Weight (1 + t)², Gauss–Jacobi points on the emitter with the weight divided out: nearest to the
    /// paper's text.
    H2,
    /// Weight (1 + t)², Gauss–Legendre points on the emitter.
    H3,
    /// The weight as printed, not divided out on the emitter: wrong, whatever the number of points.
    Literal,
}

/// K between two patches, and its cost.
#[derive(Clone, Debug)]
pub struct Transfer {
    /// K^kl, row-major, the receiver's (N + 1)(N + 2)/2 functions by the emitter's, in the order of
    /// [`total`].
    pub values: Vec<f64>,
    /// Whether the patches have a whole edge in common.
    pub edge: bool,
    /// Kernel evaluations.
    pub samples: u64,
    /// Segments handed to the visibility test.
    pub rays: u64,
}

/// K^kl from `emitter` to `receiver`; `sees`, where given, says whether the segment between two points is
/// free.
///
/// # Panics
/// If an element has no points.
pub fn transfer(
    receiver: ChartedElement,
    emitter: ChartedElement,
    rules: PaperRules,
    sees: Option<Sees>,
) -> Transfer {
    let borders = border::common(receiver.patch, emitter.patch);
    let (rows, columns) = match (rules, borders) {
        (PaperRules::Hybrid(reading), Some([near, far])) => {
            (receiver_axes(receiver, reading, near), emitter_axes(emitter, reading, far))
        }
        _ => (plain(receiver), plain(emitter)),
    };
    let mut sum = Sum::new([receiver, emitter], sees);
    sum.add(&rows, &columns);
    let mut values = sum.values;
    to_legendre(&mut values, receiver.order, [rows[0].weight, rows[1].weight]);
    Transfer { values, edge: borders.is_some(), samples: sum.samples, rays: sum.rays }
}

fn plain(element: ChartedElement) -> [Axis; 2] {
    let axis = Axis::new(element.order, element.points, [0, 0]);
    [axis.clone(), axis]
}

fn receiver_axes(element: ChartedElement, reading: HybridReading, border: Border) -> [Axis; 2] {
    let along = match reading {
        HybridReading::H1 => [2, 2],
        HybridReading::H2 | HybridReading::H3 | HybridReading::Literal => [0, 0],
    };
    let across = Axis::new(element.order, element.points, border.double_zero());
    border.placed(Axis::new(element.order, element.points, along), across)
}

fn emitter_axes(element: ChartedElement, reading: HybridReading, border: Border) -> [Axis; 2] {
    let along = Axis::new(element.order, element.points, [0, 0]);
    let moved = || Axis::with_legendre(element.order, element.points, border.double_zero());
    let across = match reading {
        HybridReading::H1 | HybridReading::H3 => along.clone(),
        HybridReading::H2 => moved().divided(border.double_zero()),
        HybridReading::Literal => moved(),
    };
    border.placed(along, across)
}

/// Converts rows of K_J in the functions of two weights to rows of K in Legendre functions, column by column.
///
/// Conversion never raises a degree, so each direction is converted by itself within the total degree.
fn to_legendre(values: &mut [f64], order: usize, [first, second]: [[u8; 2]; 2]) {
    let columns = values.len() / total::count(order);
    let mut line = vec![0.0; order + 1];
    let mut convert = |[a, b]: [u8; 2], other: usize, index: &dyn Fn(usize) -> usize| {
        if [a, b] == [0, 0] {
            return;
        }
        let line = &mut line[..=order - other];
        for l in 0..columns {
            line.iter_mut().enumerate().for_each(|(p, x)| *x = values[index(p) * columns + l]);
            convert::to_legendre(a, b, line);
            line.iter().enumerate().for_each(|(p, x)| values[index(p) * columns + l] = *x);
        }
    };
    for other in 0..=order {
        convert(first, other, &|p| total::index(p, other));
    }
    for other in 0..=order {
        convert(second, other, &|q| total::index(other, q));
    }
}
