//! The unshadowed light of a mask on a curved receiver: by the solid angle of the emitter.
//!
//! Where the receiver is curved, the emitter sets behind its horizon, and the light without obstacles has a
//! border there that no polynomial follows. So the mask takes the cosine at the receiver along with the
//! visibility, and the polynomials keep what is smooth:
//!
//! ```text
//! M = ∫ κ V dA_h / (Ω/π) ,      Ω/π = ∫ cos θ_h⁺ / (π r²) dA_h
//! ```
//!
//! with the solid angle Ω of the emitter. M is the mean over Ω of the cosine times the visibility, in [0, 1].

use nalgebra::{DMatrix, DVector, RowDVector};
use radiosity_core::dot;
use radiosity_elements::Element;
use radiosity_elements::patch::{Node, Patch};
use radiosity_elements::rule::UnitRule;
use radiosity_geom::DVec3;

use crate::zatz1993::mask::Mask;

/// A part of an emitter whose extent exceeds this part of its distance is halved: rules of a few points then
/// miss less than 1e-4 of its solid angle. Chosen.
const NEAR: f64 = 0.5;

/// Most halvings of a part of an emitter, which a point that touches it would halve for ever.
const MOST_HALVINGS: usize = 12;

/// Points along each side of a part beyond the degree of the polynomials.
const EXTRA_POINTS: usize = 2;

/// Cells of a receiver's patch along each side, for the edges that masks have.
const CELLS: usize = 4;

/// Weight ε of places that the mask leaves dark.
const DARK: f64 = 1e-3;

/// The solid angle of an emitter at a point, over π.
pub(super) fn solid_angle(emitter: &Element, x: DVec3) -> f64 {
    let mut sum = 0.0;
    visit(emitter, EXTRA_POINTS, x, &mut |_, weight| sum += weight);
    sum
}

/// The coefficients p_kl on a receiver of Ω/π for each function φ_l of an emitter, row-major: those of
///
/// ```text
/// ∫ (M + ε) φ_k (Σ_m p_ml φ_m − ∫ φ_l cos θ_h⁺ / (π r²) dA_h) dA_i = 0 ,
/// ```
///
/// fitted where the mask M lets light through: power arrives as it would without polynomials.
pub(super) fn block(receiver: &Element, emitter: &Element, mask: &Mask) -> Vec<f64> {
    let (basis, points) = (&receiver.basis, receiver.basis.order() + EXTRA_POINTS);
    let (rows, columns) = (basis.len(), emitter.basis.len());
    let (mut matrix, mut right) = (DMatrix::zeros(rows, rows), DMatrix::zeros(rows, columns));
    let mut raw = vec![0.0; rows];
    for (node, area) in receiver.patches.iter().flat_map(|patch| nodes(patch, points)) {
        let coordinates = basis.frame().coordinates(&node);
        basis.raw(coordinates, &mut raw);
        let own = basis.transform().chunks_exact(rows).map(|row| dot(row, &raw));
        let own = DVector::from_iterator(rows, own);
        let sent = RowDVector::from_vec(arriving(emitter, node.position));
        let weight = area * (mask.at(coordinates) + DARK);
        matrix.ger(weight, &own, &own, 1.0);
        right += weight * &own * sent;
    }
    let factor = matrix.cholesky().expect("the weights are above 0, and the nodes tell the functions apart");
    // Row by row.
    factor.solve(&right).transpose().as_slice().to_vec()
}

/// ∫ φ_l cos θ_h⁺ / (π r²) dA_h at a point.
fn arriving(emitter: &Element, x: DVec3) -> Vec<f64> {
    let basis = &emitter.basis;
    let (mut sums, mut raw) = (vec![0.0; basis.len()], vec![0.0; basis.len()]);
    visit(emitter, basis.order() / 2 + EXTRA_POINTS, x, &mut |node, weight| {
        basis.raw(basis.frame().coordinates(node), &mut raw);
        sums.iter_mut().zip(&raw).for_each(|(sum, raw)| *sum += weight * raw);
    });
    basis.transform().chunks_exact(basis.len()).map(|row| dot(row, &sums)).collect()
}

/// Visits nodes of an emitter, with so many along each side of a part, each with its share of Ω/π at a point.
fn visit(emitter: &Element, points: usize, x: DVec3, see: &mut dyn FnMut(&Node, f64)) {
    let mut open: Vec<(Patch, usize)> = emitter.patches.iter().map(|patch| (patch.clone(), 0)).collect();
    while let Some((part, depth)) = open.pop() {
        let (direction, extent) = part.longest();
        if depth < MOST_HALVINGS && extent > NEAR * part.node(0.5, 0.5).position.distance(x) {
            open.extend(part.halves(direction).map(|half| (half, depth + 1)));
            continue;
        }
        let rule = UnitRule::of(points);
        for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
            let node = part.node(s, t);
            let step = x - node.position;
            let square = step.length_squared();
            let cosine = node.normal.dot(step) / square.sqrt();
            if cosine > 0.0 {
                see(&node, ws * wt * node.area * cosine / (std::f64::consts::PI * square));
            }
        }
    }
}

/// Nodes of a receiver's patch, cut into equal cells with so many points along each side, with their areas.
fn nodes(patch: &Patch, points: usize) -> impl Iterator<Item = (Node, f64)> {
    let rule = UnitRule::of(points);
    let side = 1.0 / CELLS as f64;
    let places = move || {
        (0..CELLS).flat_map(move |cell| rule.iter().map(move |(x, w)| (side * (cell as f64 + x), side * w)))
    };
    places().flat_map(move |s| places().map(move |t| (s, t))).map(|((s, ws), (t, wt))| {
        let node = patch.node(s, t);
        (node, ws * wt * node.area)
    })
}
