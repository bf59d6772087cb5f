//! Light that is known, among which that of other coatings is sought.
//!
//! With radiosities v_k and the irradiances G v_k that follow from them, which no coating changes, b = Σ a_k v_k leaves
//! of b = e + ρ G b the residual
//!
//! ```text
//! r = Σ a_k (v_k − ρ G v_k) − e ,
//! ```
//!
//! without a product with G. The a of the least ‖r‖ follow from an orthonormal basis of the v_k − ρ G v_k by two passes
//! of modified Gram-Schmidt, to which e is added last. Light is linear in what is emitted, and a rational function of a
//! reflectance, whose poles lie beyond 1: the light of few cases spans that of all between them.
//!
//! Reference: Å. Björck, *Numerical Methods for Least Squares Problems*, SIAM 1996, §2.4.

use radiosity_core::{dot, norm};
use radiosity_elements::coating::Coating;
use radiosity_kernel::Blocks;

/// Part of a radiosity beside what is known below which it is rounding. Chosen: fifty roundings.
const ROUNDING: f64 = 1e-14;

/// Most v that are kept: their products with each other take some times as long as one with G. Chosen.
const MOST: usize = 96;

/// Passes of orthogonalisation: after the second a vector is orthogonal to rounding.
const PASSES: usize = 2;

/// Radiosities with the irradiances that G makes of them.
#[derive(Clone, Debug, Default)]
pub struct KnownLight {
    /// v_k, orthonormal.
    sent: Vec<Vec<f64>>,
    /// G v_k.
    arrived: Vec<Vec<f64>>,
}

/// Light of the least residual.
#[derive(Clone, Debug)]
pub(crate) struct NearestLight {
    /// b.
    pub radiosity: Vec<f64>,
    /// G b.
    pub irradiance: Vec<f64>,
    /// ‖b − e − ρ G b‖₂.
    pub residual: f64,
}

impl KnownLight {
    /// Whether no light is known.
    pub(crate) fn is_none(&self) -> bool {
        self.sent.is_empty()
    }

    /// G times each of some radiosities, which are known from now on where there is room; what is known already is not
    /// multiplied.
    pub(crate) fn carried(&mut self, blocks: &Blocks, radiosities: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let parts: Vec<Vec<f64>> = radiosities.iter().map(|own| self.parts_with_rest(own)).collect();
        let arrived = blocks.apply_to_each(&self.sent[self.arrived.len()..]);
        self.arrived.extend(arrived);
        let carried = parts.iter().map(|parts| combined(parts, &self.arrived, blocks.dim())).collect();
        self.sent.truncate(MOST);
        self.arrived.truncate(MOST);
        carried
    }

    /// The parts of a radiosity along the v_k; what is beside them becomes another v_k.
    fn parts_with_rest(&mut self, radiosity: &[f64]) -> Vec<f64> {
        let mut rest = radiosity.to_vec();
        let mut parts = taken_off(&self.sent, &mut rest);
        let size = norm(&rest);
        if size > ROUNDING * norm(radiosity) {
            parts.push(size);
            self.sent.push(scaled(rest, 1.0 / size));
        }
        parts
    }

    /// The light of the least residual for each of these emissions `emitted` of surfaces of this reflection, whose
    /// coefficients begin at `starts`.
    pub(crate) fn nearest(
        &self,
        coating: &Coating,
        starts: &[usize],
        emitted: &[Vec<f64>],
    ) -> Vec<NearestLight> {
        let (mut basis, mut columns) = (Vec::new(), Vec::new());
        for (sent, arrived) in self.sent.iter().zip(&self.arrived) {
            let reflected = coating.reflected(starts, arrived);
            let mut rest: Vec<f64> = sent.iter().zip(&reflected).map(|(v, own)| v - own).collect();
            let mut column = taken_off(&basis, &mut rest);
            let size = norm(&rest);
            column.push(size);
            columns.push(column);
            basis.push(scaled(rest, 1.0 / size));
        }
        let nearest = |emitted: &Vec<f64>| {
            let mut rest = emitted.clone();
            let parts = solved(&columns, taken_off(&basis, &mut rest));
            let [radiosity, irradiance] =
                [&self.sent, &self.arrived].map(|all| combined(&parts, all, emitted.len()));
            NearestLight { radiosity, irradiance, residual: norm(&rest) }
        };
        emitted.iter().map(nearest).collect()
    }
}

/// The parts of a vector along orthonormal ones, which are taken off it.
fn taken_off(basis: &[Vec<f64>], rest: &mut [f64]) -> Vec<f64> {
    let mut parts = vec![0.0; basis.len()];
    for _ in 0..PASSES {
        for (part, own) in parts.iter_mut().zip(basis) {
            let along = dot(own, rest);
            *part += along;
            add_multiple(own, -along, rest);
        }
    }
    parts
}

/// The x of R x = `right` for the `columns` of an upper triangle R, each down to its diagonal.
fn solved(columns: &[Vec<f64>], mut right: Vec<f64>) -> Vec<f64> {
    for (k, column) in columns.iter().enumerate().rev() {
        let (above, own) = right.split_at_mut(k);
        own[0] /= column[k];
        add_multiple(&column[..k], -own[0], above);
    }
    right
}

/// Σ parts_k all_k, of so many numbers.
fn combined(parts: &[f64], all: &[Vec<f64>], dim: usize) -> Vec<f64> {
    let mut sum = vec![0.0; dim];
    parts.iter().zip(all).for_each(|(part, own)| add_multiple(own, *part, &mut sum));
    sum
}

fn scaled(mut x: Vec<f64>, factor: f64) -> Vec<f64> {
    x.iter_mut().for_each(|x| *x *= factor);
    x
}

/// y ← y + factor x.
fn add_multiple(x: &[f64], factor: f64, y: &mut [f64]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y += factor * x);
}
