//! Ways of solvers that relax.

use radiosity_solvers::{Granularity, Settings, Sweep};
use serde::{Deserialize, Serialize};

/// Unknowns that are relaxed at a time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum RelaxedAtOnce {
    /// All coefficients of an element
    #[default]
    Block,
    /// One coefficient
    Coefficient,
}

/// The order in which gauss-seidel visits the elements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum SweepOrder {
    /// First to last
    #[default]
    Forward,
    /// First to last, then last to first
    Symmetric,
}

/// Ways of solvers that relax, and of gmres.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Relaxing {
    /// jacobi, gauss-seidel, southwell: the unknowns that are relaxed at a time.
    pub at_once: RelaxedAtOnce,
    /// gauss-seidel: the order of its visits.
    pub sweep: SweepOrder,
    /// jacobi, gauss-seidel, southwell, richardson: the factor of every correction, in (0, 2).
    pub relaxation: f64,
    /// gmres: vectors that are kept before it restarts.
    pub restart: usize,
}

impl Default for Relaxing {
    fn default() -> Self {
        let Settings { relaxation, restart, .. } = Settings::default();
        Self { at_once: RelaxedAtOnce::Block, sweep: SweepOrder::Forward, relaxation, restart }
    }
}

impl Relaxing {
    /// Whether all ways are the usual ones.
    pub(super) fn is_usual(&self) -> bool {
        *self == Self::default()
    }

    /// `settings` in these ways.
    pub(super) fn set<'a>(&self, settings: Settings<'a>) -> Settings<'a> {
        let granularity = match self.at_once {
            RelaxedAtOnce::Block => Granularity::Block,
            RelaxedAtOnce::Coefficient => Granularity::Coefficient,
        };
        let sweep = match self.sweep {
            SweepOrder::Forward => Sweep::Forward,
            SweepOrder::Symmetric => Sweep::Symmetric,
        };
        settings
            .with_granularity(granularity)
            .with_sweep(sweep)
            .with_relaxation(self.relaxation)
            .with_restart(self.restart)
    }
}
