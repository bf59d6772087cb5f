//! The transfers between two elements that are displaced against each other, as a power series.
//!
//! x on the receiver, y on the emitter, r = y − x, and the emitter moved by p·d relative to the receiver (d:
//! the direction, the displacement per unit of p; a receiver that moves has −d). The kernel without its
//! clipping to positive cosines is
//!
//! ```text
//! κ(p) = −(n_y·r′)(n_x·r′)/(π |r′|⁴) ,   r′ = r + p d ,
//!      = κ₀ (a + b p + c p²) / (1 + A p + B p²)² ,   κ₀ = −1/(π r⁴) ,  A = 2 d·r/r² ,  B = d²/r²
//! a = (n_y·r)(n_x·r) ,  b = (n_y·d)(n_x·r) + (n_y·r)(n_x·d) ,  c = (n_y·d)(n_x·d)
//! κ(p) = Σ φ_n pⁿ ,     G(p) = Σ Φ_n pⁿ     with Φ_n the moments of φ_n in the elements' functions.
//! ```
//!
//! * Range: |p d| < r for a pair of points; the least distance of the two elements for a block. Both elements
//!   have to face each other, or to stand in front of each other's planes in a part that does not change.
//! * The sum is always formed at the centre of the expansion, never from the last sum: errors do not add up.
//!
//! Reference: D. Arquès, V. Biri, S. Michelin (2001), corrected as `docs/theory/animation.md` tells.

pub mod power_series;
mod remainder;
mod span;
pub mod point_pair;
pub mod displacement;
mod error;
mod settings;
mod pair;
mod faces;
mod samples;
mod block;
mod moving;

pub use block::{BlockSeries, MovedBlock};
pub use error::SeriesError;
pub use moving::MovingBlock;
pub use pair::TranslatedPair;
pub use settings::Settings;
