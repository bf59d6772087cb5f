//! Requests of users, as the command line and the package of Python have them in common: the options of a
//! method with their presets, ranges and checks, and their translation to options of the library.
//!
//! Either front end turns what it is given into a request. Refusals hold options as data
//! ([`Wording`](radiosity_work::wording::Wording)), so that each front end spells them as its own.
//!
//! In order: [`Refusal`]; [`ranges`] (of numbers), `modes` (names of kernels, shadows, solvers), [`memory`]
//! and [`aim`] (of an accuracy); [`MethodRequest`] and `conflicts` (how light is computed), [`ReadRequest`]
//! (how it is read), [`AuditRequest`] (how it is judged), [`TransferRequest`] and [`HeatRequest`], [`HeatSweep`],
//! [`SceneRequest`] (which scene), [`view`] (from where), [`picture`] and [`cells`] (what results need of memory).
//!
//! Imports `geom`, `solvers`, `work`, `photometry`, `formats`, `scene`, `language`, `audit`, `visibility`,
//! `elements`, `kernel`, `published`, `solve`, `reading` and `heat`.

mod refusal;
pub mod ranges;
mod modes;
pub mod memory;
pub mod aim;
mod method;
mod conflicts;
mod reading;
mod audit;
mod transfers;
mod heat_sweep;
mod scene;
pub mod view;
pub mod picture;
pub mod cells;

pub use audit::{AuditRequest, CheckRequest};
pub use conflicts::{KEPT, check_series, require_all_light};
pub use heat_sweep::{HeatSweep, SweepError, SweptHeat};
pub use method::MethodRequest;
pub use modes::{Kernel, LightShadows};
pub use reading::{ReadRequest, check_aim};
pub use refusal::Refusal;
pub use scene::{ImportRequest, LoadError, SceneRequest};
pub use transfers::{HeatRequest, TransferRequest};
