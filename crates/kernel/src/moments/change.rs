//! The matrix C that changes moments from the polynomials of a patch to those of its element.
//!
//! T_m(s, t) = p_i(2s − 1) p_j(2t − 1) are the patch's own polynomials, L_k the element's raw functions. On a
//! flat patch L_k is a polynomial of the chart, so that L_k = Σ_m C_km T_m exactly. Where an affine chart
//! covers the whole box of the element's frame, C only permutes and changes signs; elsewhere it is the
//! projection by an exact Gauss rule.

use radiosity_core::basis::total;
use radiosity_elements::basis::AreaBasis;
use radiosity_elements::patch::Patch;
use radiosity_elements::rule::UnitRule;
use radiosity_elements::space::Space;

use crate::moments::legendre_values::polynomials;

/// The matrix C of one patch.
#[derive(Debug)]
pub(crate) enum Change {
    /// L_k = sign_k T_{place_k}.
    Signed(Vec<SignedPlace>),
    /// Row-major, element's functions by patch's.
    Dense {
        matrix: Vec<f64>,
        /// Number of the patch's functions.
        own: usize,
    },
}

/// A function of a patch that is one of its element but for its sign.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SignedPlace {
    /// Its place among the patch's functions.
    place: usize,
    /// 1 or −1.
    sign: f64,
}

impl Change {
    /// The change from the polynomials of total degree of the parallelogram `patch`.
    pub(crate) fn new(patch: &Patch, basis: &AreaBasis) -> Self {
        Self::signed(patch, basis).unwrap_or_else(|| {
            let degrees: Vec<_> = (0..total::count(basis.total_degree())).map(total::degrees).collect();
            Self::projected(patch, basis, &degrees)
        })
    }

    /// The change from the patch's polynomials of the given `degrees` (along, across), which span the
    /// element's.
    pub(crate) fn projected(patch: &Patch, basis: &AreaBasis, degrees: &[(usize, usize)]) -> Self {
        let (count, own, width) = (basis.len(), degrees.len(), basis.total_degree() + 1);
        let rule = UnitRule::of(width);
        let tables: Vec<Vec<f64>> = rule.nodes.iter().map(|x| own_polynomials(*x, width)).collect();
        let mut matrix = vec![0.0; count * own];
        let mut theirs = vec![0.0; count];
        for (ps, (s, ws)) in tables.iter().zip(rule.iter()) {
            for (pt, (t, wt)) in tables.iter().zip(rule.iter()) {
                basis.raw(basis.frame().coordinates(&patch.node(s, t)), &mut theirs);
                for (row, l) in matrix.chunks_exact_mut(own).zip(&theirs) {
                    // Factor 4: the area of [−1, 1]² over that of the unit square.
                    let factor = 4.0 * ws * wt * l;
                    row.iter_mut().zip(degrees).for_each(|(c, (i, j))| *c += factor * ps[*i] * pt[*j]);
                }
            }
        }
        Self::Dense { matrix, own }
    }

    /// Number of the patch's functions.
    pub(crate) fn own(&self) -> usize {
        match self {
            Self::Signed(places) => places.len(),
            Self::Dense { own, .. } => *own,
        }
    }

    /// Σ_m C_km rows_m: from rows indexed by T to rows indexed by L, each of `width` entries.
    pub(crate) fn rows(&self, rows: &[f64], width: usize) -> Vec<f64> {
        match self {
            Self::Signed(places) => places
                .iter()
                .flat_map(|SignedPlace { place, sign }| {
                    rows[place * width..(place + 1) * width].iter().map(move |x| sign * x)
                })
                .collect(),
            Self::Dense { matrix, own } => {
                let mut out = vec![0.0; matrix.len() / own * width];
                for (line, out) in matrix.chunks_exact(*own).zip(out.chunks_exact_mut(width)) {
                    for (c, row) in line.iter().zip(rows.chunks_exact(width)) {
                        out.iter_mut().zip(row).for_each(|(o, x)| *o += c * x);
                    }
                }
                out
            }
        }
    }

    fn signed(patch: &Patch, basis: &AreaBasis) -> Option<Self> {
        if !basis.is_product() || basis.space() != Space::Total {
            return None;
        }
        let at = |s: f64, t: f64| basis.frame().coordinates(&patch.node(s, t));
        let corners = [at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0)];
        let near = |x: f64, y: f64| (x - y).abs() <= 1e-13;
        // Each coordinate runs from ∓1 to ±1 in one direction of the chart and is constant in the other.
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
            SignedPlace { place: if first == 0 { k } else { total::index(j, i) }, sign }
        };
        Some(Self::Signed((0..basis.len()).map(place).collect()))
    }
}

fn own_polynomials(x: f64, width: usize) -> Vec<f64> {
    let mut values = vec![0.0; width];
    polynomials(2.0 * x - 1.0, &mut values);
    values
}
