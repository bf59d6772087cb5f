//! Presets: how finely a scene is solved and read, from a draft to the last useful digit.
//!
//! | quality | order | transfers | their shadows | their rays | gathered light | by rays | points a cell side |
//! | --- | --- | --- | --- | --- | --- | --- | --- |
//! | quick | 2 | 5e-2 | 0.2 | 1/8 | 2e-3 | 5e-3 | 3, 1 |
//! | default | 3 | 1e-3 | 3e-3 | 1 | 1.25e-3 | 5e-3 | 4, 2 |
//! | fine | 4 | 1e-3 | 3e-3 | 4 | 7e-4 | 2.5e-3 | 4, 2 |
//! | finest | 4 | 1e-3 | 3e-3 | 8 | 4e-4, twice | 1.25e-3, twice | 4, 3 |
//!
//! Rays are multiples of the usual number; more rays carry polynomials on finer elements. Points are those of direct
//! and of gathered light.
//!
//! Chosen on the Cornell box (`cargo run --release -p radiosity-studies --bin read_off`) so that the errors
//! of all stages are similar. Shadows of the draft's transfers may be rough: cells and points are gathered
//! with exact shadows, and in pictures read from polynomials the error of the basis dominates.

use radiosity_solve::Options;
use radiosity_solve::gather::gather_method::GatherMethod;
use radiosity_solve::solution::Solution;
use radiosity_solve::tolerances::USUAL_EPS;
use radiosity_visibility::Visibility;
use serde::Deserialize;

use crate::grid::Rates;
use crate::reader::{ReadMode, Reader};

/// A preset.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "kebab-case")]
pub enum Quality {
    /// A draft.
    Quick,
    /// For most purposes.
    #[default]
    Default,
    /// A higher order, or four times the rays where rays carry the light, gathered more accurately.
    Fine,
    /// Light gathered twice, from twice the rays of `fine`.
    Finest,
}

/// Settings by which light is read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReadSettings {
    /// The source of light at cells and points.
    pub read: ReadMode,
    /// Way of gathering light: by cells or by rays.
    pub by: GatherMethod,
    /// Relative accuracy of gathered light.
    pub eps: f64,
    /// Points along each side of a cell.
    pub rates: Rates,
}

impl ReadSettings {
    /// The reader of `solution` among these obstacles.
    pub fn reader<'a>(&self, solution: &'a Solution, visibility: &'a Visibility) -> Reader<'a> {
        Reader::by(self.by, solution, visibility, self.read, self.eps)
    }
}

impl Quality {
    /// Options to solve with; all others are as in [`Options::default`].
    pub fn options(self) -> Options {
        let (order, eps, shadow_eps, finer_rays) = match self {
            Self::Quick => (2, 5e-2, 0.2, 1),
            Self::Default => return Options::default(),
            Self::Fine => (4, 1e-3, 3e-3, 4),
            Self::Finest => (4, 1e-3, 3e-3, 8),
        };
        Options { order, eps, shadow_eps, finer_rays, ..Options::default() }
    }

    /// Accuracy that a solution by rays is worth being read to. Measured on sixty random rooms at the default: with
    /// 1e-2 the noise of reading was most of the error in the median, .58 %.
    pub fn worth_by_rays(self) -> f64 {
        match self {
            Self::Quick | Self::Default => 5e-3,
            Self::Fine => 2.5e-3,
            Self::Finest => 1.25e-3,
        }
    }

    /// Settings to read a scene that was solved with [`Quality::options`].
    pub fn reading(self) -> ReadSettings {
        let (read, eps, direct, indirect) = match self {
            Self::Quick => (ReadMode::Gather, 2e-3, 3, 1),
            Self::Default => (ReadMode::Gather, USUAL_EPS, 4, 2),
            Self::Fine => (ReadMode::Gather, 7e-4, 4, 2),
            Self::Finest => (ReadMode::GatherTwice, 4e-4, 4, 3),
        };
        ReadSettings { read, by: GatherMethod::Auto, eps, rates: Rates { direct, indirect } }
    }
}
