//! The driver: scene → elements → blocks → system per band → solution, timed.
//!
//! A [`Model`] holds what does not depend on materials, the elements and their blocks; it is solved for any
//! materials of the same surfaces.
//!
//! It ends at interruptions ([`radiosity_work::interruption`]):
//!
//! ```
//! use radiosity_work::interruption::{Interrupted, Interruption};
//! use radiosity_solve::{Options, solve};
//! use radiosity_work::Work;
//! use std::thread;
//! use std::time::Duration;
//!
//! let scene = radiosity_language::builtin("cornell-box")?;
//! let options = Options { order: 7, eps: 1e-9, ..Options::default() };
//! let interruption = Interruption::new();
//! let found = thread::scope(|scope| {
//!     // Any thread may raise it: one that waits for a key or a deadline, or a handler of signals.
//!     scope.spawn(|| {
//!         thread::sleep(Duration::from_millis(50));
//!         interruption.raise();
//!     });
//!     interruption.within(|| solve(&scene, &options, &Work::alone()))
//! });
//! assert!(matches!(found, Err(Interrupted)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod direct;
mod preconditioning;
mod relaxing;
mod column_choice;
mod shots;
mod outline;
pub mod memory_estimate;
mod memory_reduction;
mod failure;
mod in_threads;
mod light_method;
mod linking;
mod transport_choice;
mod options;
pub mod cost;
mod choose_transport;
mod forecast;
mod pair_rays;
mod memory_need;
mod decisions;
mod emission;
mod unknowns;
mod solve_band;
mod sampling;
mod light_shares;
mod kept_model;
mod subject;
mod assembly;
mod first_light;
mod outcome;
mod shooting;
mod beside_known;
mod band_systems;
mod direct_price;
mod requirements;
mod cut_scene;
mod ready;
mod run_forecast;
mod model;
mod by_links;

use radiosity_elements::mesh::Mesh;
use radiosity_scene::Scene;
use radiosity_work::Work;

use by_links::solve_by_links;
pub(crate) use choose_transport::exact_price;
pub use column_choice::ColumnChoice;
pub(crate) use decisions::Layout;
pub use direct::Direct;
pub use failure::Failure;
pub(crate) use forecast::{seconds_of_exact, seconds_of_rays_among};
pub use in_threads::in_threads;
pub(crate) use kept_model::{KeptModel, Standing};
pub use light_method::LightMethod;
pub use linking::Linking;
pub use memory_reduction::MemoryReduction;
pub use model::Model;
pub use options::Options;
pub(crate) use outcome::{FrameLight, timed};
pub use outcome::{Functional, Outcome, Stages};
pub use preconditioning::Preconditioning;
pub use relaxing::{RelaxedAtOnce, Relaxing, SweepOrder};
pub use run_forecast::RunForecast;
pub use sampling::Sampling;
pub use shots::{Shot, ShotLimit, Shots};
pub use transport_choice::{MOST_RAYS, Transport, TransportChoice};
pub(crate) use unknowns::Unknowns;

/// Solves `scene`.
///
/// # Errors
/// A scene that cannot be cut into elements, a linear solver that fails or does not converge, or threads
/// that cannot be started.
pub fn solve(scene: &Scene, options: &Options, work: &Work<'_>) -> Result<Outcome, Failure> {
    match options.method {
        LightMethod::Galerkin | LightMethod::Collocation => Model::solve_once(scene, options, work),
        LightMethod::Hierarchical => solve_by_links(scene, options, work),
    }
}

/// Solves `scene` by exact blocks, for the reason `why`, between the elements of a refined mesh if there is
/// one.
///
/// # Errors
/// As [`solve`].
pub(crate) fn solve_exactly(
    scene: &Scene,
    options: &Options,
    why: &str,
    mesh: Option<&Mesh>,
    work: &Work<'_>,
) -> Result<Outcome, Failure> {
    Model::solve_exactly(scene, options, why, mesh, work)
}
