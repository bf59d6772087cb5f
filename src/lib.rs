//! High-order Galerkin radiosity on curved, untessellated surfaces.
//!
//! ```text
//! B(x) = E₀(x) + ρ(x) ∫ κ(x, y) V(x, y) B(y) dA_y
//! ```
//!
//! This crate passes on those that do the work, each with a module here; each imports only what is listed
//! before it: [`work`] (interruption, ranks, progress, deadlines, sentences of messages) → [`fit`] (rounded
//! shapes made to agree) → [`photometry`] → [`formats`] (scenes of other programs) → [`scene`] (the
//! model) → [`language`] (its texts) → [`audit`] (a referee by path tracing) → [`visibility`] → [`elements`] →
//! [`kernel`] (integrals over pairs) → [`transport`] (all blocks) → [`light`] (direct, first bounce) →
//! [`published`] (methods of four papers) → [`mod@solve`] (systems, solutions, the driver, animation) →
//! [`reading`] (of solutions) → [`heat`] → `output` (by a feature) → [`request`] (what is typed, checked).
//! Below them stand [`geom`], [`solvers`] and `radiosity-core`. Terms and places: `docs/glossary.md`;
//! derivations: `docs/theory/`; the picture: `docs/architecture.md`.
//!
//! Lux at a point of a room, in ten lines:
//!
//! ```
//! use radiosity::geom::DVec3;
//! use radiosity::{Options, Solved, Work};
//!
//! // A built-in scene; your own by `radiosity::load("office.toml")?`.
//! let scene = radiosity::builtin("furnace-cube")?;
//! let solved = Solved::new(scene, Options::default(), &Work::alone())?;
//! let lux = solved.irradiance_at(DVec3::new(0.5, 0.5, 0.5), DVec3::Z)[0];
//! println!("{lux:.3} lx");
//! // In a closed room of reflectance ½ that emits 1 everywhere, 2 arrives at every point.
//! assert!((lux - 2.0).abs() < 1e-2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Scenes are built in, read from files ([`load`]), or made in code:
//!
//! ```
//! use radiosity::geom::DVec3;
//! use radiosity::geom::shapes::{Disk, FULL_TURN, Parallelogram};
//! use radiosity::{Material, Options, SceneBuilder, Work, solve};
//!
//! let mut desk = SceneBuilder::new("desk", ["grey"]);
//! let wood = desk.material("wood", Material::new(vec![0.4], vec![0.0])?);
//! let glow = desk.material("glow", Material::new(vec![0.0], vec![1000.0])?);
//! desk.surface("top", Parallelogram::new(DVec3::ZERO, DVec3::X, DVec3::Y)?, &wood);
//! let above = DVec3::new(0.5, 0.5, 1.0);
//! desk.surface("lamp", Disk::new(above, -DVec3::Z, 0.1, 0.0, FULL_TURN)?, &glow).order(1);
//! let scene = desk.build()?;
//! let outcome = solve(&scene, &Options::default(), &Work::alone())?;
//! assert!(outcome.solution.mean_irradiance(0, scene.surface_named("top")?) > 0.0);
//! // Energy is kept: what the lamp emits is absorbed or lost.
//! let checks = outcome.checks;
//! assert!((checks.energy_absorbed + checks.energy_lost - checks.energy_in).abs() < 1e-6 * checks.energy_in);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(doctest)]
#[doc = include_str!("../docs/embedding.md")]
struct Embedding;

pub use radiosity_audit as audit;
pub use radiosity_elements as elements;
pub use radiosity_fit as fit;
pub use radiosity_formats as formats;
pub use radiosity_geom as geom;
pub use radiosity_heat as heat;
pub use radiosity_kernel as kernel;
pub use radiosity_language as language;
pub use radiosity_light as light;
#[cfg(feature = "output")]
pub use radiosity_output as output;
pub use radiosity_photometry as photometry;
pub use radiosity_published as published;
pub use radiosity_reading as reading;
pub use radiosity_request as request;
pub use radiosity_scene as scene;
pub use radiosity_solve as solve;
pub use radiosity_solvers as solvers;
pub use radiosity_transport as transport;
pub use radiosity_visibility as visibility;
pub use radiosity_work as work;

pub use radiosity_language::{builtin, load};
pub use radiosity_published::bases::Basis;
pub use radiosity_scene::{Material, Scene, SceneBuilder, SceneError};
pub use radiosity_solve::solution::Solution;
pub use radiosity_solve::solved::Solved;
pub use radiosity_solve::view_factors::ViewFactors;
pub use radiosity_solve::{Failure, Model, Options, Outcome, solve};
pub use radiosity_work::Work;
