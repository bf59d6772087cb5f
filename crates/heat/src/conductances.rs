//! Conductances between surfaces, for thermal networks.
//!
//! Where surface i alone emits, at the level σ T⁴ = 1 of a black surface, and all surfaces reflect 1 − ε,
//! surface j absorbs C_ij (m²): directly, and after any number of reflections. C is symmetric, and Σ_j
//! C_ij + C_i0 = ε_i A_i with the loss C_i0 to the surroundings. Between isothermal surfaces flows
//!
//! ```text
//! Q_ij = C_ij σ (T_i⁴ − T_j⁴) .
//! ```
//!
//! C_ij = A_i ε_i B_ij with Gebhart's factors B_ij (Gebhart 1961); σ C_ij is the radiative conductor of
//! thermal networks. In a network each surface has one temperature; in the balance that of a surface of known flux
//! varies over it, whatever the order.
//!
//! Where a surface hardly sees another, polynomials may swing below 0. Negative C_ij are made 0, and with factors
//! s_i near 1 the rows keep their sums,
//!
//! ```text
//! C_ij = s_i s_j C⁺_ij ,     C_i0 = s_i C⁺_i0 ,     Σ_j C_ij + C_i0 = ε_i A_i .
//! ```

use radiosity_core::dot;
use radiosity_scene::{LightGroup, Scene};
use radiosity_solve::Model;
use radiosity_work::Work;
use rayon::prelude::*;

use super::coats::{Coat, coated};
use super::error::HeatError;
use super::figures::{areas, received};
use super::roles::{Role, Roles, named};

/// Most turns of the factors of rows. Measured: fifty settle random ones of which some are −1e-5 to −1e-2, a hundred
/// three surfaces with one of −0.6.
const TURNS: usize = 200;

/// Relative change of sums of rows at which the factors are settled: some roundings.
const SETTLED: f64 = 1e-14;

/// The conductances C_ij (scene length²) of all pairs of surfaces.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Conductances {
    /// C_ij in row i, made symmetric.
    pub rows: Vec<Vec<f64>>,
    /// C_i0, what surface i loses to the surroundings.
    pub lost: Vec<f64>,
    /// Largest |C_ij − C_ji| over the larger of ε_i A_i and ε_j A_j, before C was made symmetric.
    pub asymmetry: f64,
    /// Largest −C_ij over the larger of ε_i A_i and ε_j A_j, before negative ones were made 0.
    pub negative: f64,
}

impl Conductances {
    /// The conductances of `scene`, one solution of `model` for each surface.
    pub(super) fn of(
        scene: &Scene,
        roles: &Roles,
        model: &Model,
        work: &Work<'_>,
    ) -> Result<Self, HeatError> {
        let grey = emissivities(scene, roles)?;
        let lit = each_alone(scene, roles)?;
        let outcome = model.solve(&lit, work)?;
        let elements = outcome.solution.elements();
        let mut raw = vec![vec![0.0; grey.len()]; grey.len()];
        let rows = outcome.solution.groups().par_iter().filter_map(|group| {
            let from: usize = group.group.as_deref()?.parse().ok()?;
            let light = received(elements, &group.bands[0].irradiance);
            Some((from, light.iter().zip(&grey).map(|(light, emissivity)| emissivity * light).collect()))
        });
        for (from, row) in rows.collect::<Vec<(usize, Vec<f64>)>>() {
            raw[from] = row;
        }
        let emitted: Vec<f64> = areas(elements).iter().zip(&grey).map(|(area, e)| area * e).collect();
        Ok(Self::symmetric(&raw, &emitted))
    }

    fn symmetric(raw: &[Vec<f64>], emitted: &[f64]) -> Self {
        let count = raw.len();
        let mut rows = raw.to_vec();
        let mut asymmetry: f64 = 0.0;
        for i in 0..count {
            for j in 0..i {
                let (own, other) = (raw[i][j], raw[j][i]);
                let scale = emitted[i].max(emitted[j]);
                asymmetry = asymmetry.max(if scale > 0.0 { (own - other).abs() / scale } else { 0.0 });
                (rows[i][j], rows[j][i]) = (0.5 * (own + other), 0.5 * (own + other));
            }
        }
        let lost = rows.iter().zip(emitted).map(|(row, emitted)| emitted - row.iter().sum::<f64>()).collect();
        Self { rows, lost, asymmetry, negative: 0.0 }.not_negative(emitted)
    }

    /// These without negative entries, with rows of equal sums.
    fn not_negative(mut self, emitted: &[f64]) -> Self {
        for i in 0..emitted.len() {
            let own = self.lost[i];
            let scales = self.rows[i].iter().zip(emitted).map(|(own, other)| (own, emitted[i].max(*other)));
            let below = scales.chain([(&own, emitted[i])]).filter(|(own, _)| **own < 0.0);
            let below = below.map(|(own, scale)| -own / scale).fold(0.0, f64::max);
            self.negative = self.negative.max(below);
            self.rows[i].iter_mut().chain([&mut self.lost[i]]).for_each(|own| *own = own.max(0.0));
        }
        if self.negative == 0.0 {
            return self;
        }
        let factors = self.factors(emitted);
        for (i, factor) in factors.iter().enumerate() {
            self.rows[i].iter_mut().zip(&factors).for_each(|(own, other)| *own *= factor * other);
            self.lost[i] *= factor;
        }
        self
    }

    /// The factors s_i with which the rows sum to what is emitted: s_i² (Σ_j s_j C_ij + C_i0) / ε_i A_i s_i → 1.
    fn factors(&self, emitted: &[f64]) -> Vec<f64> {
        let mut factors = vec![1.0; emitted.len()];
        for _ in 0..TURNS {
            let sums = self.rows.par_iter().zip(&self.lost).map(|(row, lost)| lost + dot(row, &factors));
            let sums: Vec<f64> = sums.collect();
            let mut moved: f64 = 0.0;
            for ((factor, sum), emitted) in factors.iter_mut().zip(sums).zip(emitted) {
                let off = if sum > 0.0 { emitted / (*factor * sum) } else { 1.0 };
                moved = moved.max((off - 1.0).abs());
                *factor *= off.sqrt();
            }
            if moved <= SETTLED {
                break;
            }
        }
        factors
    }
}

/// The scene in which each surface emits at the level 1, as a light group of its own.
pub(super) fn each_alone(scene: &Scene, roles: &Roles) -> Result<Scene, HeatError> {
    let grey = emissivities(scene, roles)?;
    let mut lit = coated(scene, roles, |_| Coat { reflectance: 0.0, emission: 0.0 });
    for (index, (surface, emissivity)) in lit.surfaces.iter_mut().zip(&grey).enumerate() {
        surface.material.reflectance = vec![1.0 - emissivity];
        surface.material.emission = vec![*emissivity];
        surface.group = Some(LightGroup::new(format!("{index}")));
    }
    Ok(lit)
}

/// The emissivity of each surface.
fn emissivities(scene: &Scene, roles: &Roles) -> Result<Vec<f64>, HeatError> {
    let known: Vec<Option<f64>> = roles.list.iter().map(Role::emissivity).collect();
    let surfaces = named(scene, |surface, _| known[surface].is_none());
    if surfaces.is_empty() {
        return Ok(known.into_iter().flatten().collect());
    }
    Err(HeatError::NoEmissivity { surfaces })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of three surfaces that emit 1 each, the third to the surroundings too, two hardly see each other.
    #[test]
    fn rows_without_negative_entries_keep_their_sums() {
        let raw = [vec![0.2, -0.01, 0.81], vec![-0.01, 0.5, 0.51], vec![0.81, 0.51, -0.62]];
        let emitted = [1.0, 1.0, 1.0];
        let Conductances { rows, lost, asymmetry, negative } = Conductances::symmetric(&raw, &emitted);
        assert!((asymmetry, negative) == (0.0, 0.62));
        for (i, row) in rows.iter().enumerate() {
            assert!(row.iter().chain([&lost[i]]).all(|own| *own >= 0.0), "{row:?}, {lost:?}");
            assert!((row.iter().sum::<f64>() + lost[i] - 1.0).abs() < 1e-12, "{row:?}, {lost:?}");
            assert!((0..3).all(|j| row[j] == rows[j][i]), "{rows:?}");
        }
        assert_eq!(rows[0][1], 0.0);
    }
}
