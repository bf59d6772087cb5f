//! The area-orthonormal basis of an element.
//!
//! Raw functions L_k(a, b) = p_i(a) p_j(b), i + j ≤ N, products of orthonormal Legendre polynomials
//! in coordinates (a, b) ∈ [−1, 1]² of the element: affine coordinates in its plane, or its surface's
//! parameters. The basis proper is
//!
//! ```text
//! φ_k = Σ_{l ≤ k} T_kl L_l ,      ∫ φ_k φ_l dA = δ_kl .
//! ```
//!
//! T comes from Gram–Schmidt, twice, on the table √w_a L_k(x_a) of a rule that is exact for the
//! products: the condition number of the element's shape enters once, not squared as it would by a
//! Cholesky factor of the Gram matrix. φ₀ is constant, so constants are in the span and power is
//! conserved to rounding. (The parameter-orthonormal basis of Zatz 1993, eq. 7, differs from this
//! one on every element whose area element varies.)

use radiosity_core::{basis::total, legendre};
use radiosity_geom::{DVec2, DVec3};

use crate::scene::MAX_ORDER;

use super::patch::{Node, Patch};
use super::rule::UnitRule;

/// Highest total degree offered.
pub const HIGHEST_ORDER: usize = MAX_ORDER;

/// Largest loss of orthonormality with which a basis is still used.
pub const LARGEST_DEFECT: f64 = 1e-8;

/// Coordinates (a, b) of an element, [−1, 1]² over it.
#[derive(Clone, Debug)]
pub enum Frame {
    /// Affine in the plane: a = (x − origin)·first, b = (x − origin)·second.
    Plane {
        /// Centre of the bounding parallelogram.
        origin: DVec3,
        /// Gradient of a.
        first: DVec3,
        /// Gradient of b.
        second: DVec3,
    },
    /// A rectangle of surface parameters.
    Parameters {
        /// Centre of the rectangle.
        center: DVec2,
        /// Half its sides.
        half: DVec2,
    },
}

impl Frame {
    /// The parallelogram around coplanar `points` with sides along `sides`, two directions in their plane
    /// that are not parallel.
    ///
    /// A parallelogram with its own sides fills its frame: its basis is as well conditioned as the square's.
    pub fn bounding(points: &[DVec3], sides: [DVec3; 2]) -> Self {
        let normal = sides[0].cross(sides[1]);
        // Gradients of the coordinates along the two sides: dual to them in the plane.
        let duals = [sides[1].cross(normal), normal.cross(sides[0])].map(|d| d / normal.length_squared());
        let bounds = duals.map(|dual| {
            points
                .iter()
                .map(|p| (p - points[0]).dot(dual))
                .fold((0.0f64, 0.0f64), |(low, high), x| (low.min(x), high.max(x)))
        });
        let [a, b] = bounds.map(|(low, high)| 0.5 * (low + high));
        let [first, second] = [0, 1].map(|k| duals[k] * (2.0 / (bounds[k].1 - bounds[k].0)));
        Self::Plane { origin: points[0] + sides[0] * a + sides[1] * b, first, second }
    }

    /// (a, b) of a node.
    pub fn coordinates(&self, node: &Node) -> [f64; 2] {
        match self {
            Self::Plane { .. } => self.locate(node.position, DVec2::ZERO),
            Self::Parameters { .. } => self.locate(DVec3::ZERO, node.parameters),
        }
    }

    /// (a, b) of a point: by its position on a plane, by its parameters on a curved surface.
    pub fn locate(&self, position: DVec3, parameters: DVec2) -> [f64; 2] {
        match self {
            Self::Plane { origin, first, second } => {
                let d = position - origin;
                [d.dot(*first), d.dot(*second)]
            }
            Self::Parameters { center, half } => ((parameters - center) / half).to_array(),
        }
    }
}

/// Orthonormal polynomials of total degree ≤ N with respect to area.
#[derive(Clone, Debug)]
pub struct AreaBasis {
    order: usize,
    frame: Frame,
    /// T, row-major, lower triangular, `len × len`.
    transform: Vec<f64>,
}

impl AreaBasis {
    /// The basis of total degree `order` over `patches`.
    ///
    /// None where the element has no area, or fills its frame so badly that functions of this degree,
    /// evaluated through the frame's polynomials, lose their orthonormality beyond [`LARGEST_DEFECT`].
    pub fn new(order: usize, frame: Frame, patches: &[Patch]) -> Option<Self> {
        let mut basis = Self { order, frame, transform: Vec::new() };
        let table = basis.weighted_table(patches);
        basis.transform = orthonormalise(&table, total::count(order))?;
        (basis.defect(&table) <= LARGEST_DEFECT).then_some(basis)
    }

    /// Total degree N.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Number of functions, (N + 1)(N + 2)/2.
    pub fn len(&self) -> usize {
        total::count(self.order)
    }

    /// False: the constant is always there.
    pub fn is_empty(&self) -> bool {
        false
    }

    /// The coordinates in which the polynomials are written.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// T, row-major, lower triangular: φ_k = Σ_l T_kl L_l.
    pub fn transform(&self) -> &[f64] {
        &self.transform
    }

    /// L_k at (a, b) into `out` (length [`AreaBasis::len`]).
    pub fn raw(&self, [a, b]: [f64; 2], out: &mut [f64]) {
        match self.order {
            0..=2 => products::<3>(self.order, [a, b], out),
            3..=4 => products::<5>(self.order, [a, b], out),
            5..=8 => products::<9>(self.order, [a, b], out),
            _ => products::<{ HIGHEST_ORDER + 1 }>(self.order, [a, b], out),
        }
    }

    /// Coefficients c of Σ_k x_k φ_k = Σ_l c_l L_l, that is c = Tᵀ x.
    pub fn to_raw(&self, coefficients: &[f64]) -> Vec<f64> {
        let n = self.len();
        let mut raw = vec![0.0; n];
        for (k, x) in coefficients.iter().enumerate() {
            for (r, t) in raw.iter_mut().zip(&self.transform[k * n..=k * n + k]) {
                *r += x * t;
            }
        }
        raw
    }

    /// max |∫ φ_k φ_l dA − δ_kl| as evaluated through the raw polynomials of a weighted table.
    fn defect(&self, table: &[Vec<f64>]) -> f64 {
        let count = self.len();
        let mut gram = vec![0.0; count * count];
        let mut values = vec![0.0; count];
        for row in table {
            for (k, value) in values.iter_mut().enumerate() {
                *value = dot(&self.transform[k * count..=k * count + k], &row[..=k]);
            }
            for (line, x) in gram.chunks_exact_mut(count).zip(&values) {
                line.iter_mut().zip(&values).for_each(|(g, y)| *g += x * y);
            }
        }
        gram.iter_mut().step_by(count + 1).for_each(|diagonal| *diagonal -= 1.0);
        // Not a number counts as the largest of defects.
        gram.iter().map(|g| if g.is_nan() { f64::INFINITY } else { g.abs() }).fold(0.0, f64::max)
    }

    /// One row per point of a rule exact for products of two functions: √w L_k.
    fn weighted_table(&self, patches: &[Patch]) -> Vec<Vec<f64>> {
        let mut rows = Vec::new();
        for patch in patches {
            let extra = if patch.is_flat() { 2 } else { 12 };
            let rule = UnitRule::of(self.order + extra);
            for (s, ws) in rule.iter() {
                for (t, wt) in rule.iter() {
                    let node = patch.node(s, t);
                    let mut row = vec![0.0; self.len()];
                    self.raw(self.frame.coordinates(&node), &mut row);
                    let root = (ws * wt * node.area).sqrt();
                    row.iter_mut().for_each(|value| *value *= root);
                    rows.push(row);
                }
            }
        }
        rows
    }
}

/// p_i(a) p_j(b), i + j ≤ order < N, by total degree. Inside the element the plain recurrence keeps all the digits
/// that quadrature needs, at a fraction of the time of the form that is exact to the last one near ±1.
fn products<const N: usize>(order: usize, [a, b]: [f64; 2], out: &mut [f64]) {
    let (mut first, mut second) = ([0.0; N], [0.0; N]);
    legendre::Table::<N>::RECURRENCE.values(a, &mut first);
    legendre::Table::<N>::RECURRENCE.values(b, &mut second);
    let mut k = 0;
    for degree in 0..=order {
        for j in 0..=degree {
            out[k] = first[degree - j] * second[j];
            k += 1;
        }
    }
}

/// Gram–Schmidt, two passes per column; the rows of T are carried along.
fn orthonormalise(rows: &[Vec<f64>], count: usize) -> Option<Vec<f64>> {
    let mut columns: Vec<Vec<f64>> = (0..count).map(|k| rows.iter().map(|row| row[k]).collect()).collect();
    let mut transform = vec![0.0; count * count];
    for k in 0..count {
        let (done, rest) = columns.split_at_mut(k);
        let column = &mut rest[0];
        let before = dot(column, column).sqrt();
        let mut row = vec![0.0; count];
        row[k] = 1.0;
        for _pass in 0..2 {
            for (j, other) in done.iter().enumerate() {
                let overlap = dot(column, other);
                column.iter_mut().zip(other).for_each(|(x, y)| *x -= overlap * y);
                let theirs = &transform[j * count..(j + 1) * count];
                row.iter_mut().zip(theirs).for_each(|(x, y)| *x -= overlap * y);
            }
        }
        let norm = dot(column, column).sqrt();
        if norm.is_nan() || norm <= f64::EPSILON * before {
            return None;
        }
        column.iter_mut().for_each(|x| *x /= norm);
        for (out, x) in transform[k * count..].iter_mut().zip(&row) {
            *out = x / norm;
        }
    }
    Some(transform)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Max |M − I| of the basis, by a rule of its own (6 more points a side).
    fn orthonormality_defect(basis: &AreaBasis, patches: &[Patch]) -> f64 {
        let n = basis.len();
        let mut gram = vec![0.0; n * n];
        let mut raw = vec![0.0; n];
        for patch in patches {
            let rule = UnitRule::of(basis.order() + 8);
            for (s, ws) in rule.iter() {
                for (t, wt) in rule.iter() {
                    let node = patch.node(s, t);
                    basis.raw(basis.frame().coordinates(&node), &mut raw);
                    let values: Vec<f64> =
                        (0..n).map(|k| dot(&basis.transform()[k * n..(k + 1) * n], &raw)).collect();
                    for k in 0..n {
                        for l in 0..n {
                            gram[k * n + l] += ws * wt * node.area * values[k] * values[l];
                        }
                    }
                }
            }
        }
        (0..n * n).map(|i| (gram[i] - f64::from(u8::from(i / n == i % n))).abs()).fold(0.0, f64::max)
    }

    /// The further a shape is from its bounding box, the more digits evaluation through the box's polynomials
    /// costs, and the sooner in order: an L that fills half of its box keeps 1e-12 to order 6.
    #[test]
    fn orthonormal_over_an_l_shape() {
        let p = |x: f64, y: f64| DVec3::new(x, y, 0.0);
        let arms = [
            vec![p(0.0, 0.0), p(3.0, 0.0), p(3.0, 1.0), p(0.0, 1.0)],
            vec![p(0.0, 1.0), p(1.0, 1.0), p(1.0, 2.0), p(0.0, 2.5)],
        ];
        let patches: Vec<Patch> = arms.iter().flat_map(|arm| Patch::of_polygon(arm, DVec3::Z)).collect();
        for order in 0..=6 {
            let frame = Frame::bounding(&arms.concat(), [DVec3::X, DVec3::Y]);
            let basis = AreaBasis::new(order, frame, &patches).expect("the shape has area");
            let defect = orthonormality_defect(&basis, &patches);
            assert!(defect < 1e-12, "order {order}: {defect:e}");
        }
    }

    #[test]
    fn orthonormal_over_a_quadrilateral() {
        let corners = [[0.0, 0.0], [3.0, 0.0], [2.8, 1.0], [0.1, 1.2]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let patches = Patch::of_polygon(&corners, DVec3::Z);
        for order in 0..=12 {
            let frame = Frame::bounding(&corners, [DVec3::X, DVec3::Y]);
            let basis = AreaBasis::new(order, frame, &patches).expect("the shape has area");
            let defect = orthonormality_defect(&basis, &patches);
            assert!(defect < 1e-12, "order {order}: {defect:e}");
        }
    }

    #[test]
    fn sheared_parallelogram_is_as_good_as_a_square() {
        let (a, b) = (DVec3::new(1.0, 0.0, 0.0), DVec3::new(100.0, 1.0, 0.5));
        let corners = [DVec3::ZERO, a, a + b, b];
        let patches = Patch::of_polygon(&corners, a.cross(b).normalize());
        let basis = AreaBasis::new(HIGHEST_ORDER, Frame::bounding(&corners, [a, b]), &patches);
        let defect = orthonormality_defect(&basis.expect("it has area"), &patches);
        assert!(defect < 1e-12, "{defect:e}");
    }

    #[test]
    fn a_shape_that_loses_its_digits_is_refused() {
        let p = |x: f64, y: f64| DVec3::new(x, y, 0.0);
        let arms = [
            vec![p(0.0, 0.0), p(1.0, 0.0), p(1.0, 0.1), p(0.0, 0.1)],
            vec![p(0.0, 0.1), p(0.1, 0.1), p(0.1, 1.0), p(0.0, 1.0)],
        ];
        let patches: Vec<Patch> = arms.iter().flat_map(|arm| Patch::of_polygon(arm, DVec3::Z)).collect();
        let frame = Frame::bounding(&arms.concat(), [DVec3::X, DVec3::Y]);
        assert!(AreaBasis::new(20, frame.clone(), &patches).is_none());
        assert!(AreaBasis::new(4, frame, &patches).is_some());
    }

    #[test]
    fn no_area_gives_no_basis() {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::X, DVec3::ZERO];
        let patch = Patch::Flat { corners, normal: DVec3::Z };
        let frame = Frame::Plane { origin: DVec3::ZERO, first: DVec3::X, second: DVec3::Y };
        assert!(AreaBasis::new(1, frame, &[patch]).is_none());
    }
}
