//! From a parallelogram's own polynomials to those of its element.
//!
//! T_m(s, t) = p_i(2s − 1) p_α(2t − 1) are the patch's, L_k(a, b) the element's. The chart is affine, so the space
//! of total degree N is the same, and L_k = Σ_m C_km T_m exactly. Where the patch is the whole box of the element's
//! frame, C only permutes and changes signs; else it is the projection by an exact Gauss rule.

use radiosity_core::basis::total;

use crate::elements::basis::AreaBasis;
use crate::elements::patch::Patch;
use crate::elements::rule::UnitRule;

/// The matrix C of one patch.
#[derive(Debug)]
pub(super) enum Change {
    /// L_k = sign_k T_{place_k}.
    Signed(Vec<(usize, f64)>),
    /// Row-major, `len × len`.
    Dense(Vec<f64>),
}

impl Change {
    /// The change from `patch`, a parallelogram, to the element's `basis`.
    pub(super) fn new(patch: &Patch, basis: &AreaBasis) -> Self {
        Self::signed(patch, basis).unwrap_or_else(|| Self::projected(patch, basis))
    }

    /// Σ_m C_km rows_m: from rows indexed by T to rows indexed by L; `width` entries a row.
    pub(super) fn rows(&self, rows: &[f64], width: usize) -> Vec<f64> {
        match self {
            Self::Signed(places) => places
                .iter()
                .flat_map(|(place, sign)| {
                    rows[place * width..(place + 1) * width].iter().map(move |x| sign * x)
                })
                .collect(),
            Self::Dense(matrix) => {
                let count = rows.len() / width;
                let mut out = vec![0.0; rows.len()];
                for (line, out) in matrix.chunks_exact(count).zip(out.chunks_exact_mut(width)) {
                    for (c, row) in line.iter().zip(rows.chunks_exact(width)) {
                        out.iter_mut().zip(row).for_each(|(o, x)| *o += c * x);
                    }
                }
                out
            }
        }
    }

    fn signed(patch: &Patch, basis: &AreaBasis) -> Option<Self> {
        if !basis.is_product() {
            return None;
        }
        let at = |s: f64, t: f64| basis.frame().coordinates(&patch.node(s, t));
        let corners = [at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0)];
        let near = |x: f64, y: f64| (x - y).abs() <= 1e-13;
        // Each coordinate runs from ∓1 to ±1 along one direction and stays along the other.
        let direction = |axis: usize| {
            let [origin, along, across] = corners.map(|corner| corner[axis]);
            let sign = -origin;
            if !near(sign.abs(), 1.0) {
                return None;
            }
            match (near(along, sign), near(across, origin), near(across, sign), near(along, origin)) {
                (true, true, ..) => Some((0, sign.signum())),
                (.., true, true) => Some((1, sign.signum())),
                _ => None,
            }
        };
        let ((first, a), (second, b)) = (direction(0)?, direction(1)?);
        if first == second {
            return None;
        }
        let place = |k: usize| {
            let (i, j) = total::degrees(k);
            let sign = a.powi(i as i32) * b.powi(j as i32);
            (if first == 0 { k } else { total::index(j, i) }, sign)
        };
        Some(Self::Signed((0..basis.len()).map(place).collect()))
    }

    fn projected(patch: &Patch, basis: &AreaBasis) -> Self {
        let count = basis.len();
        let rule = UnitRule::of(basis.order() + 1);
        let mut matrix = vec![0.0; count * count];
        let (mut theirs, mut own) = (vec![0.0; count], vec![0.0; count]);
        for (s, ws) in rule.iter() {
            for (t, wt) in rule.iter() {
                basis.raw(basis.frame().coordinates(&patch.node(s, t)), &mut theirs);
                total::values(basis.order(), 2.0 * s - 1.0, 2.0 * t - 1.0, &mut own);
                for (row, l) in matrix.chunks_exact_mut(count).zip(&theirs) {
                    // Four: the measure of [−1, 1]² against that of the unit square.
                    row.iter_mut().zip(&own).for_each(|(c, t)| *c += 4.0 * ws * wt * l * t);
                }
            }
        }
        Self::Dense(matrix)
    }
}
