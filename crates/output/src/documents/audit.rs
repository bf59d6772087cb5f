//! Judged numbers as text, CSV or JSON: of light, of heat and of view factors.

mod judgement;
pub mod light;
pub mod heat;
pub mod view_factors;

pub use judgement::Judgement;
