//! High-order Galerkin radiosity on curved, untessellated surfaces.
//!
//! ```text
//! B(x) = E₀(x) + ρ(x) ∫ κ(x, y) V(x, y) B(y) dA_y
//! ```
//!
//! The modules are the nouns that flow from a scene to its picture, each a function of those before it:
//! scene → (visibility) → elements → blocks → system → solution → output. A module imports only modules
//! listed above it.
//!
//! ```
//! use radiosity::scene::Scene;
//! use radiosity::solve::{Options, solve};
//!
//! let scene = Scene::builtin("furnace-cube")?;
//! let outcome = solve(&scene, &Options::default(), &|_progress| {})?;
//! // In a closed room of reflectance ½ that emits 1 everywhere, every face absorbs what it emits.
//! assert!((outcome.checks.energy_in - 6.0).abs() < 1e-12);
//! assert!((outcome.checks.energy_absorbed - 6.0).abs() < 6e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod scene;
pub mod visibility;
pub mod inspection;
pub mod elements;
pub mod kernel;
pub mod system;
pub mod solution;
pub mod distance;
pub mod view;
pub mod direct;
pub mod gather;
pub mod checks;
pub mod solve;
pub mod adaptation;
pub mod convergence;
pub mod solved;
pub mod view_factors;
pub mod output;
