//! The transfers between two elements that move against each other, as a power series.
//!
//! x on the receiver, y on the emitter, r = y − x, and the emitter moved relative to the receiver: by p·d (d:
//! the direction, the displacement per unit of p; a receiver that moves has −d), or by the angle p about an
//! axis. With t = p, or t = tan(p/2), the kernel without its clipping to positive cosines is
//!
//! ```text
//! κ = −(n_y′·r′)(n_x·r′)/(π |r′|⁴) = (N₀ + N₁t + … + N_M t^M)/(1 + A t + B t²)² ,     M = 2, or 4
//! κ(t) = Σ φ_n tⁿ ,     G(t) = Σ Φ_n tⁿ     with Φ_n the moments of φ_n in the elements' functions.
//! ```
//!
//! * Range: |t| √B < 1 for a pair of points (|p d| < r where it is translated). Both elements have to face each
//!   other, or to stand in front of each other's planes in a part that does not change.
//! * The sum is always formed at the centre of the expansion, never from the last sum: errors do not add up.
//!
//! Reference: D. Arquès, V. Biri, S. Michelin (2001), corrected as `docs/theory/animation.md` tells.

pub mod power_series;
mod remainder;
mod span;
mod error;
mod motion;
pub mod point_pair;
mod settings;
mod pair;
mod faces;
mod facing;
mod samples;
mod block;
mod moving;

pub use block::{BlockSeries, MovedBlock};
pub use error::SeriesError;
pub(crate) use facing::Facing;
pub use motion::RelativeMotion;
pub use moving::MovingBlock;
pub use pair::MovedPair;
pub use settings::Settings;
