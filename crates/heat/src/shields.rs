//! The levels of shields.
//!
//! With the level x = σ T⁴ of each shield, its area A on either side s, the power P_s that arrives there from
//! all surfaces of known temperature or flux, and P_s^(l) from shield l at the level 1, the given flow is
//!
//! ```text
//! q A = Σ_s ε (A x_k − P_s − Σ_l P_s^(l) x_l) .
//! ```

use std::collections::BTreeMap;

use radiosity_scene::Scene;
use radiosity_solve::solution::Solution;
use radiosity_solvers::method::Method;
use radiosity_solvers::{Dense, Partition, Settings};

use super::coats::{at_levels, group_of_shield};
use super::figures::{areas, received};
use super::roles::{Role, Roles};

/// The scene `radiant` with its shields at their levels by the light of all of them at the level 1; None without
/// shields.
pub(super) fn lit(radiant: Scene, roles: &Roles, solution: &Solution) -> Option<Scene> {
    (!roles.shields.is_empty()).then(|| at_levels(radiant, roles, &levels(roles, solution)))
}

/// The level σ T⁴ (W m⁻²) of each shield, from the light of all of them at the level 1. Not a number where
/// the flows have no balance.
fn levels(roles: &Roles, solution: &Solution) -> Vec<f64> {
    let count = roles.shields.len();
    let elements = solution.elements();
    let areas = areas(elements);
    let mut others = vec![0.0; elements.surfaces()];
    let mut at_one = vec![vec![0.0; elements.surfaces()]; count];
    let shields: BTreeMap<String, usize> =
        (0..count).map(|shield| (group_of_shield(shield), shield)).collect();
    for group in solution.groups() {
        let light = received(elements, &group.bands[0].irradiance);
        match group.group.as_ref().and_then(|name| shields.get(name)) {
            Some(shield) => at_one[*shield] = light,
            None => others = light,
        }
    }
    let emissivity = |side: usize| match roles.list[side] {
        Role::Shield { emissivity, .. } => emissivity,
        Role::Temperature { .. } | Role::Flux { .. } | Role::Idle { .. } => 0.0,
    };
    let absorbed = |k: usize, light: &[f64]| -> f64 {
        roles.shields[k].sides.iter().map(|side| emissivity(*side) * light[*side]).sum()
    };
    let emitted = |k: usize| absorbed(k, &areas);
    let matrix = (0..count).flat_map(|l| {
        let light = &at_one[l];
        (0..count).map(move |k| (if k == l { emitted(k) } else { 0.0 }) - absorbed(k, light))
    });
    let given = |k: usize| roles.shields[k].flux * areas[roles.shields[k].sides[0]] + absorbed(k, &others);
    solve(matrix.collect(), (0..count).map(given).collect())
}

/// The solution of a small dense system, entry (i, j) at `values[j·n + i]`; not numbers if it has none.
fn solve(values: Vec<f64>, right: Vec<f64>) -> Vec<f64> {
    let mut levels = vec![0.0; right.len()];
    let solver = Method::LU.solver;
    let solved = Dense::new(Partition::points(right.len()), values, false)
        .and_then(|a| solver.solve(&a, &right, &mut levels, &Settings::default(), &mut |_| ()));
    if solved.is_err() {
        levels.fill(f64::NAN);
    }
    levels
}
