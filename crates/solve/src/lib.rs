//! Solving: elements and blocks → systems → solutions, and what is asked of them.
//!
//! In order: `tolerances`, `system` (one per band), `solution` (what it was solved to), `gather` (light at
//! points), `checks` (of energy), `driver` (scene → solution, timed), `studies` (accuracy that is asked for,
//! convergence), `solved` (a scene with its solution), `animation` (light that follows moving things) and
//! `view_factors`.
//!
//! Imports `core`, `geom`, `solvers`, `work`, `scene`, `visibility`, `elements`, `kernel`, `transport`,
//! `light` and `published`.

pub mod tolerances;
pub mod system;
pub mod solution;
pub mod gather;
pub mod checks;
pub mod driver;
pub mod studies;
pub mod solved;
pub mod animation;
pub mod view_factors;

pub use driver::{
    Direct, Failure, Functional, LightMethod, MOST_RAYS, MemoryReduction, Model, Options, Outcome,
    Preconditioning, Sampling, Stages, Transport, TransportChoice, in_threads, solve,
};
