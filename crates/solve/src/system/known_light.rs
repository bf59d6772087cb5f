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
            // Light that surfaces would keep for good tells of no emission: it takes no part.
            let size = norm(&rest);
            let [diagonal, factor] = if size > ROUNDING { [size, 1.0 / size] } else { [1.0, 0.0] };
            column.push(diagonal);
            columns.push(column);
            basis.push(scaled(rest, factor));
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

#[cfg(test)]
mod tests {
    use radiosity_work::ranks::Ranks;

    use super::*;

    /// G of six elements of one coefficient, which sends on nine tenths of all at the most.
    fn blocks() -> Blocks {
        let mut blocks = Blocks::empty((0..=6).collect(), true, Ranks::alone());
        for (row, column) in (0..6).flat_map(|row| (row + 1..6).map(move |column| (row, column))) {
            blocks.push(row, column, &[0.06 * ((row + 2 * column) % 4) as f64]);
        }
        blocks
    }

    /// Light b of reflectances ρ, one element after the other, by so many reflections that nothing is left.
    fn light(blocks: &Blocks, coating: &Coating) -> Vec<f64> {
        (0..500).fold(coating.exitance.clone(), |light, _| {
            let arrived = blocks.apply(&light);
            let reflected = coating.reflected(blocks.starts(), &arrived);
            coating.exitance.iter().zip(reflected).map(|(e, own)| e + own).collect()
        })
    }

    fn coating(swept: f64, level: f64) -> Coating {
        let exitance = vec![(1.0 - swept) * level, (1.0 - swept) * level, 0.3, 0.0, 0.1, 0.0];
        Coating::constant(vec![swept, swept, 0.7, 0.4, 0.9, 1.0], exitance)
    }

    fn off(nearest: &NearestLight, right: &[f64]) -> f64 {
        let differences = nearest.radiosity.iter().zip(right).map(|(own, right)| (own - right).abs());
        differences.fold(0.0, f64::max)
    }

    #[test]
    fn products_of_what_is_known_are_not_made_again() {
        let blocks = blocks();
        let mut known = KnownLight::default();
        let [one, other] = [coating(0.2, 1.0), coating(0.8, 2.0)].map(|own| own.exitance);
        known.carried(&blocks, &[one.clone(), other.clone()]);
        let sum: Vec<f64> = one.iter().zip(&other).map(|(one, other)| 3.0 * one - 0.5 * other).collect();
        let carried = known.carried(&blocks, std::slice::from_ref(&sum)).remove(0);
        assert_eq!(known.sent.len(), 2);
        let right = blocks.apply(&sum);
        assert!(carried.iter().zip(&right).all(|(own, right)| (own - right).abs() < 1e-14), "{carried:?}");
    }

    /// Two cases tell the light of any level; those of more reflectances that of another, the nearer the more they are.
    #[test]
    fn light_of_other_cases_is_found_with_what_it_leaves() {
        let blocks = blocks();
        let nearest = |cases: &[Coating], wanted: &Coating| {
            let mut known = KnownLight::default();
            let all: Vec<Vec<f64>> = cases.iter().map(|own| light(&blocks, own)).collect();
            known.carried(&blocks, &all);
            known.nearest(wanted, blocks.starts(), std::slice::from_ref(&wanted.exitance)).remove(0)
        };
        let wanted = coating(0.2, 7.0);
        let found = nearest(&[coating(0.2, 1.0), coating(0.2, 2.0)], &wanted);
        assert!(found.residual < 1e-14 && off(&found, &light(&blocks, &wanted)) < 1e-13, "{found:?}");
        let wanted = coating(0.45, 1.0);
        let right = light(&blocks, &wanted);
        let few = nearest(&[0.2, 0.8].map(|own| coating(own, 1.0)), &wanted);
        let more = nearest(&[0.2, 0.35, 0.5, 0.8].map(|own| coating(own, 1.0)), &wanted);
        assert!(few.residual > 1e3 * more.residual, "{few:?} {more:?}");
        assert!(off(&few, &right) > 1e-5 && off(&more, &right) < 1e-6, "{few:?} {more:?}");
    }
}
