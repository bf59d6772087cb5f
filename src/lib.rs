//! High-order Galerkin radiosity on curved, untessellated surfaces.
//!
//! ```text
//! B(x) = E₀(x) + ρ(x) ∫ κ(x, y) V(x, y) B(y) dA_y
//! ```
//!
//! The modules are the nouns that flow from a scene to its picture, each a function of those before it:
//! scene → (visibility) → elements → blocks → system → solution → output. A module imports only modules
//! listed above it.

pub mod scene;
pub mod visibility;
pub mod elements;
pub mod kernel;
pub mod system;
pub mod solution;
pub mod checks;
pub mod solve;
pub mod output;
