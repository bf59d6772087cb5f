//! Nearly white rooms: every solver, many iterations, and what the residual is worth at the end.
//!
//! In a closed room all that is emitted is absorbed: Σ ∫ (1 − ρ) B dA = Σ ∫ E₀ dA. A residual r leaves ⟨1, r⟩
//! of it unaccounted for, and the transfers what they miss of c = G c over 1 − ρ.

use radiosity::scene::Scene;
use radiosity::solve::Options;
use radiosity_solvers::method::Method;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::outcome_of;

use crate::row::Row;
use radiosity_test_support::walls::walls;

/// The box with a bright ceiling, of some reflectance.
fn room(reflectance: f64) -> Scene {
    let materials = format!(
        "bands = ['grey']\n[materials.white]\nreflectance = {reflectance:?}\n
         [materials.lamp]\nreflectance = {reflectance:?}\nemission = 1\n"
    );
    let materials_of = ["white", "lamp", "white", "white", "white", "white"];
    let surface = |(material, wall): (&str, String)| format!("[[surfaces]]\nmaterial = '{material}'\n{wall}");
    let walls: String = materials_of.into_iter().zip(walls([1.0; 3])).map(surface).collect();
    typed(&(materials + &walls))
}

/// Most that a solver may take.
const PATIENCE: usize = 200_000_000;

/// The residual asked for. At 1 − ρ = 1e-6 that of Gauss–Seidel falls by less than it is rounded from sweep
/// to sweep once it is below 3e-7, and it ends there, unconverged by its own account.
fn tolerance(loss: f64) -> f64 {
    if loss < 3e-6 { 1e-6 } else { 1e-8 }
}

/// Solves rooms of reflectance 1 − `losses` by every method.
fn all(range: &str, losses: &[f64], order: usize) {
    let balance = Row::new(
        "power of nearly white rooms, each solver (southwell to 1 − 1e-5)",
        range,
        1.0,
        "of residual and transfers",
    );
    let residual = Row::new("residual at the end, of that asked for", range, 1.0, "");
    let mut longest = (0, "");
    for loss in losses {
        let scene = room(1.0 - loss);
        // Shooting ends there after some hundred shots, and says so: its residual wavers by more than it
        // falls.
        for method in Method::ALL.iter().filter(|method| *loss > 3e-6 || method.name != "southwell") {
            let options = Options {
                order,
                eps: 1e-10,
                solver: method,
                tolerance: tolerance(*loss),
                max_iterations: PATIENCE,
                ..Options::default()
            };
            let outcome = outcome_of(&scene, &options);
            let checks = &outcome.checks;
            let off = (checks.energy_absorbed / checks.energy_in - 1.0).abs();
            let case = || format!("1 − ρ = {loss:e}, {}: {off:e}", method.name);
            // Six walls of equal area: ⟨1, r⟩ ≤ √6 ‖r‖ with ‖r‖ ≤ tolerance ‖e‖, ‖e‖² the power of one wall.
            let allowed = 6f64.sqrt() * options.tolerance + (checks.closure_max + 1e-14) / loss;
            balance.add(off / allowed, case);
            residual.add(outcome.residual / options.tolerance, case);
            longest = longest.max((outcome.iterations, method.name));
        }
    }
    println!("| most iterations | {} | {} | | |", longest.1, longest.0);
}

#[test]
fn nearly_white_rooms_keep_their_power() {
    all("ρ to 1 − 1e-3, order 1", &[1e-1, 1e-3], 1);
}

#[test]
#[ignore = "millions of iterations"]
fn white_rooms_keep_their_power() {
    all("ρ to 1 − 1e-6, order 1", &[1e-2, 1e-4, 1e-5, 1e-6], 1);
    all("ρ to 1 − 1e-4, order 4", &[1e-2, 1e-4], 4);
}
