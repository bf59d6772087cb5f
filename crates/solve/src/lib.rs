//! Solving: elements and blocks → systems → solutions, and what is asked of them.
//!
//! In order: `tolerances`, `geometry` (what tells the transfers of a scene from others), `system` (one per band),
//! `solution` (what it was solved to), `gather` (light at points), `checks` (of energy), `facet_choice` (whether
//! pairs have rays of their own), `driver` (scene →
//! solution, timed), `goal` (accuracy that is asked for), `solved` (a scene with its solution), `studies`
//! (adaptation to a goal, convergence), `animation` (light that follows moving things) and `view_factors`.
//!
//! Imports `core`, `geom`, `solvers`, `work`, `scene`, `audit`, `visibility`, `elements`, `kernel`, `transport`,
//! `light` and `published`.

pub mod tolerances;
mod geometry;
pub mod system;
pub mod solution;
pub mod gather;
pub mod checks;
mod facet_choice;
pub mod driver;
pub(crate) mod goal;
pub mod solved;
pub mod studies;
pub mod animation;
pub mod view_factors;

pub use driver::{
    ColumnChoice, Direct, Failure, Functional, LightMethod, Linking, MOST_RAYS, MemoryReduction, Model,
    Options, Outcome, Preconditioning, RelaxedAtOnce, Relaxing, Sampling, Shot, ShotLimit, Shots, Stages,
    SweepOrder, Transport, TransportChoice, in_threads, solve,
};
pub use geometry::geometry;
pub use system::known_light::KnownLight;
