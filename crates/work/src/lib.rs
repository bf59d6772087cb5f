//! Work: who shares it, what ends it, and how it is told of.
//!
//! In order: `checksum`, `digits` (numbers as texts), `printable` and `listed` (names in messages), `wording`
//! (sentences of messages, with the names of options as data), `interruption` (ends work of which nothing is
//! wanted any more), `ranks` (processes or threads that share work, and the journal of what they have done),
//! `progress` and `observer` (how far it is, and who observes it), `deadline` (ends it with the best so far),
//! `pace` (shares the time until then among many things), `counted` (rays, from which forecasts are made), `work`
//! (ranks, observer and deadline together, as they are handed down), `machine` (its speed, beside forecasts),
//! `allowance` (the time left beside forecasts).
//!
//! Imports no other crate of the workspace.

pub mod checksum;
pub mod digits;
pub mod printable;
pub mod listed;
pub mod wording;
pub mod interruption;
pub mod counted;
pub mod ranks;
mod progress;
mod observer;
mod deadline;
mod pace;
mod work;
mod machine;
mod allowance;

pub use allowance::Allowance;
pub use deadline::{Deadline, WishGuard};
pub use machine::{FORECAST_THREADS, Machine};
pub use observer::Observer;
pub use pace::Pace;
pub use progress::{Progress, Stage};
pub use work::Work;
