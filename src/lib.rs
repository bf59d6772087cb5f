//! High-order Galerkin radiosity on curved, untessellated surfaces.
//!
//! ```text
//! B(x) = E₀(x) + ρ(x) ∫ κ(x, y) V(x, y) B(y) dA_y
//! ```
//!
//! The modules stand in the order of their dependencies; each imports only modules listed above it: wording (sentences of messages) →
//! interruption (ends work) → ranks (who shares it) → scene → visibility → elements → bases (functions that they hold) → transport (the
//! blocks) → light (direct, first bounce) → system → solution → gather → solve (the driver) → solved (a scene with its solution) →
//! output. Terms and places: `docs/glossary.md`; derivations: `docs/theory/`.
//!
//! Lux at a point of a room, in ten lines:
//!
//! ```
//! use radiosity::geom::DVec3;
//! use radiosity::{Options, Scene, Solved};
//!
//! // A built-in scene; your own by `Scene::load("office.toml")?`.
//! let scene = Scene::builtin("furnace-cube")?;
//! let solved = Solved::new(scene, Options::default(), &|_progress| {})?;
//! let lux = solved.irradiance_at(DVec3::new(0.5, 0.5, 0.5), DVec3::Z)[0];
//! println!("{lux:.3} lx");
//! // In a closed room of reflectance ½ that emits 1 everywhere, 2 arrives at every point.
//! assert!((lux - 2.0).abs() < 1e-2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Scenes are built in, read from files ([`scene::Scene::load`]), or made in code:
//!
//! ```
//! use radiosity::geom::DVec3;
//! use radiosity::geom::shapes::{Disk, FULL_TURN, Parallelogram};
//! use radiosity::{Material, Options, SceneBuilder, solve};
//!
//! let mut desk = SceneBuilder::new("desk", ["grey"]);
//! let wood = desk.material("wood", Material::new(vec![0.4], vec![0.0])?);
//! let glow = desk.material("glow", Material::new(vec![0.0], vec![1000.0])?);
//! desk.surface("top", Parallelogram::new(DVec3::ZERO, DVec3::X, DVec3::Y)?, &wood);
//! let above = DVec3::new(0.5, 0.5, 1.0);
//! desk.surface("lamp", Disk::new(above, -DVec3::Z, 0.1, 0.0, FULL_TURN)?, &glow).order(1);
//! let scene = desk.build()?;
//! let outcome = solve(&scene, &Options::default(), &|_progress| {})?;
//! assert!(outcome.solution.mean_irradiance(0, scene.surface_named("top")?) > 0.0);
//! // Energy is kept: what the lamp emits is absorbed or lost.
//! let checks = outcome.checks;
//! assert!((checks.energy_absorbed + checks.energy_lost - checks.energy_in).abs() < 1e-6 * checks.energy_in);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod wording;
pub mod interruption;
pub mod ranks;
pub mod scene;
pub mod visibility;
pub mod irradiance;
pub mod footings;
pub mod covers;
pub mod inspection;
pub mod elements;
pub mod bases;
mod sampling;
pub mod transport;
pub mod light;
pub mod zatz1993;
pub mod system;
pub mod hierarchy;
pub mod solution;
pub mod gather;
pub mod checks;
pub mod solve;
pub mod studies;
pub mod solved;
pub mod animation;
pub mod view_factors;
pub mod heat;
pub mod output;
pub mod request;

pub use radiosity_formats as formats;
pub use radiosity_geom as geom;
pub use radiosity_solvers as solvers;

pub use crate::bases::Basis;
pub use crate::scene::{Material, Scene, SceneBuilder, SceneError};
pub use crate::solution::Solution;
pub use crate::solve::{Failure, Model, Options, Outcome, solve};
pub use crate::solved::Solved;
pub use crate::view_factors::ViewFactors;
