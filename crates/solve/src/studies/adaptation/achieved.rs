//! The run that an adaptation ends with, and its accuracy.

use serde::{Deserialize, Serialize};

use crate::driver::{Options, Outcome};

use super::goal::{Aim, Goal};

/// The finest run and its accuracy.
#[derive(Debug)]
pub struct Adapted {
    /// The finest possible run.
    pub outcome: Outcome,
    /// The options of the finest run.
    pub options: Options,
    /// The accuracy that it reached.
    pub achieved: Achieved,
}

/// The accuracy that an adaptation reached.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Achieved {
    /// Estimated relative error of the finest run; None where its solver did not converge.
    pub estimate: Option<f64>,
    /// Relative error that was wanted; None in files of older versions.
    #[serde(default)]
    pub wanted: Option<f64>,
    /// Light whose error this is.
    #[serde(default)]
    pub of: Aim,
    /// Reason why no finer run followed.
    pub end: EndReason,
}

impl Achieved {
    /// The accuracy with which a sequence for `goal` ended.
    pub(super) fn new(goal: &Goal, estimate: Option<f64>, end: EndReason) -> Self {
        Self { estimate, wanted: Some(goal.accuracy), of: goal.of, end }
    }

    /// Whether the estimate is as small as wanted.
    pub fn reached(&self) -> bool {
        self.end == EndReason::Reached
    }
}

/// Why an adaptation ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum EndReason {
    /// The estimate is as small as wanted.
    Reached,
    /// The sequence has no finer run.
    Finest,
    /// The next run would have more unknowns than allowed.
    Unknowns,
    /// The next run would need more memory than allowed.
    Memory,
    /// The solver did not converge in the next run, or in the first.
    NotConverged,
    /// The next run would have ended after the [deadline](radiosity_work::Deadline), or its rays or its
    /// solver were stopped there.
    Time,
    /// A person [wished](radiosity_work::Deadline::wish) the end.
    Stopped,
}
