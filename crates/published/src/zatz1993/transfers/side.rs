//! One side of a transfer: the points of a piece, and what each counts for each function of its element.

use nalgebra::DMatrix;
use radiosity_elements::basis::AreaBasis;
use radiosity_elements::measure::Measure;
use radiosity_elements::patch::{Node, Patch};

use super::axis::{Axis, DOUBLE_ZERO};
use super::piece::Piece;
use super::rules::HybridReading;

/// Points with a row of numbers each, one for each function of the element.
#[derive(Clone, Debug)]
pub(crate) struct Side {
    /// The points.
    pub nodes: Vec<Node>,
    /// The rows.
    pub rows: Vec<Vec<f64>>,
}

/// Points of a piece with the weights of a rule.
struct Points {
    nodes: Vec<Node>,
    weights: Vec<f64>,
}

impl Points {
    fn of(patch: &Patch, [along, across]: &[Axis; 2]) -> Self {
        let (mut nodes, mut weights) = (Vec::new(), Vec::new());
        for ((s, ws), (t, wt)) in along.iter().flat_map(|s| across.iter().map(move |t| (s, t))) {
            nodes.push(patch.node(s, t));
            weights.push(ws * wt);
        }
        Self { nodes, weights }
    }
}

impl Side {
    /// A receiver by Gauss–Legendre points: Σ_a C_k(a) H(a) is the part of this piece in
    /// ∫ φ_k H dA, or in the coefficient k of the projection in the parameters.
    pub(crate) fn receiving(piece: &Piece, points: usize) -> Self {
        let axis = Axis::new(points, [0, 0]);
        let points = Points::of(&piece.patch, &[axis.clone(), axis]);
        if piece.patch.is_flat() { Self::weighted(piece, points) } else { Self::nearest(piece, points) }
    }

    /// A receiver whose edge at t = 0 is that of the emitter.
    pub(super) fn receiving_at_edge(piece: &Piece, points: usize, reading: HybridReading) -> Self {
        let axes = [Axis::new(points, reading.along()), Axis::new(points, DOUBLE_ZERO)];
        Self::nearest(piece, Points::of(&piece.patch, &axes))
    }

    /// An emitter by Gauss–Legendre points: Σ_c κ(c) E_l(c) is H_l.
    pub(super) fn sending(piece: &Piece, points: usize) -> Self {
        let axis = Axis::new(points, [0, 0]);
        Self::weighted(piece, Points::of(&piece.patch, &[axis.clone(), axis]))
    }

    /// An emitter whose edge at t = 0 is that of the receiver.
    pub(super) fn sending_at_edge(piece: &Piece, points: usize, reading: HybridReading) -> Self {
        let plain = || Axis::new(points, [0, 0]);
        let moved = || Axis::new(points, DOUBLE_ZERO);
        let across = match reading {
            HybridReading::H1 | HybridReading::H3 => plain(),
            HybridReading::H2 => moved().divided(),
            // The weight on [−1, 1] as it is printed.
            HybridReading::Literal => moved(),
        };
        Self::weighted(piece, Points::of(&piece.patch, &[plain(), across]))
    }

    /// w A φ_k at the points.
    fn weighted(piece: &Piece, points: Points) -> Self {
        let basis = &piece.element.basis;
        let row = |(node, weight): (&Node, &f64)| {
            let mut row = basis.values(node);
            row.iter_mut().for_each(|value| *value *= weight * node.area);
            row
        };
        let rows = points.nodes.iter().zip(&points.weights).map(row).collect();
        Self { nodes: points.nodes, rows }
    }

    /// The share of each point in the coefficients of the element, if the light that arrives is replaced by the
    /// polynomial nearest to it at the points: that is found in functions of the piece, and projected on those of the
    /// element.
    fn nearest(piece: &Piece, points: Points) -> Self {
        let functions = if piece.is_whole {
            Some(piece.element.basis.clone())
        } else {
            let basis = &piece.element.basis;
            AreaBasis::new(basis.order(), piece.frame(), std::slice::from_ref(&piece.patch))
        };
        // So thin that its rounded points do not tell polynomials apart: it receives nothing.
        let Some(functions) = functions else { return Self { nodes: Vec::new(), rows: Vec::new() } };
        let is_flat = piece.patch.is_flat();
        let scale = |node: &Node, weight: f64| (if is_flat { weight * node.area } else { weight }).sqrt();
        let roots: Vec<f64> = points.nodes.iter().zip(&points.weights).map(|(n, w)| scale(n, *w)).collect();
        let table: Vec<f64> = points
            .nodes
            .iter()
            .zip(&roots)
            .flat_map(|(node, root)| functions.values(node).into_iter().map(move |value| root * value))
            .collect();
        let table = DMatrix::from_row_slice(points.nodes.len(), functions.len(), &table);
        let (orthogonal, upper) = table.qr().unpack();
        // Coefficients of the nearest polynomial from values times roots of weights.
        let fitted = upper.solve_upper_triangular(&orthogonal.transpose());
        let fitted = fitted.expect("points of a Gauss rule tell its polynomials apart");
        let fitted = if piece.is_whole { fitted } else { projection(piece, &functions) * fitted };
        let row = |(a, root): (usize, &f64)| fitted.column(a).iter().map(|value| root * value).collect();
        let rows = roots.iter().enumerate().map(row).collect();
        Self { nodes: points.nodes, rows }
    }
}

/// ∫ φ_k ψ_m dA over a flat piece, φ the functions of its element and ψ its own.
fn projection(piece: &Piece, own: &AreaBasis) -> DMatrix<f64> {
    let basis = &piece.element.basis;
    let mut integrals = DMatrix::zeros(basis.len(), own.len());
    for point in Measure::new(std::slice::from_ref(&piece.patch), basis.order()).points {
        let (of_element, of_piece) = (basis.values(&point.node), own.values(&point.node));
        for (k, m) in (0..basis.len()).flat_map(|k| (0..own.len()).map(move |m| (k, m))) {
            integrals[(k, m)] += point.weight * of_element[k] * of_piece[m];
        }
    }
    integrals
}
