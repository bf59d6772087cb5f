//! A referee: unbiased estimates of light, heat and view factors by path tracing, and what they say of printed
//! numbers.
//!
//! It knows what a ray meets first, what a point there sends out and reflects, and points on lamps, and nothing
//! else of how this program computes light: no rules, no elements, no cells, no lists of blockers. What it
//! shares with what it judges is the scene itself: the text, the shapes, their fitting, and the models of
//! luminaires, skies and glass.
//!
//! In order: an even choice ([`evenly`]), draws (`random`, `lattice`), bands that walk together (`spectrum`),
//! points spread over surfaces (`spread`), what rays meet (`rays`), what surfaces send (`skin`, `groups`, `lamps`,
//! `suns`, `sheets`), walks (`walk`), what is read (`spot`, `sample`), how much of it (`walk_cost`, `effort`), the
//! [`Referee`] of light, those of heat ([`HeatReferee`]) and of view factors ([`ViewFactorReferee`]), what is by
//! chance (`chance`), means of signed differences ([`SignedMean`]), the [`Verdict`] on printed numbers, the second
//! look at what stands out (`second_look`), and what it makes of the errors that a run tells ([`Checked`]).
//!
//! Imports `geom`, `work` and `scene`.

mod even_choice;
mod random;
mod lattice;
mod spectrum;
mod spread;
mod rays;
mod skin;
mod groups;
mod lamps;
mod suns;
mod sheets;
mod walk;
mod spot;
mod sample;
mod walk_cost;
mod effort;
mod referee;
mod heat;
mod view_factors;
mod chance;
mod signed_mean;
mod verdict;
mod second_look;
mod checked;

pub use checked::{Checked, Looked, Named};
pub use effort::Effort;
pub use even_choice::{evenly, spread};
pub use heat::{HeatEstimate, HeatFault, HeatReferee};
pub use referee::{Estimate, Mean, Referee};
pub use sample::SamplePoint;
pub use signed_mean::SignedMean;
pub use spot::{Pixel, Spot};
pub use verdict::{Judged, Verdict, WorstReading};
pub use view_factors::{ViewFactor, ViewFactorReferee, ViewFactorRow};
pub use walk_cost::WalkCost;
