//! The accuracy that is wanted of light, and that which is reached.

use radiosity_geom::DVec3;
use serde::{Deserialize, Serialize};

use crate::gather::gather_method::GatherMethod;
use crate::tolerances::{OF_ACCURACY, OF_WALKS};

/// The wanted accuracy, and what is to have it.
#[derive(Clone, Debug)]
pub struct Goal {
    /// Relative L2 error, all bands pooled.
    pub accuracy: f64,
    /// Light that is to have this accuracy.
    pub of: Aim,
    /// Where light is read, if that is [`Aim::Points`] or [`Aim::Seen`]: positions, from the scene's middle
    /// as its surfaces, and unit normals.
    pub points: Vec<[DVec3; 2]>,
    /// The way light is read.
    pub by: GatherMethod,
    /// Number of readings for which the solution is made, none where it is itself what is wanted: a few readings
    /// are sooner made right by walks than the solution by refinement.
    pub readings: Option<usize>,
    /// A run with more unknowns per band is not begun, except the first, and but for links, which need no
    /// matrix.
    pub most_unknowns: usize,
}

/// Light that is to be accurate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Aim {
    /// The polynomials of the radiosity, without the emitted exitance.
    #[default]
    Solution,
    /// The light that surfaces reflect of what is gathered from the solution at their points, as sensors and
    /// pictures are read.
    Gathered,
    /// The light gathered at given points.
    Points,
    /// The light that surfaces reflect of what is gathered at given points, as pictures show it.
    Seen,
}

impl Goal {
    /// `accuracy` of the polynomials, or of light gathered on all surfaces, with at most 8000 unknowns per
    /// band, whose matrix has half a gigabyte (8000² · 8 bytes).
    pub fn new(accuracy: f64, of: Aim) -> Self {
        Self { accuracy, of, points: Vec::new(), by: GatherMethod::Auto, readings: None, most_unknowns: 8000 }
    }

    /// The goal of this accuracy for light gathered at these points.
    pub fn at(accuracy: f64, points: Vec<[DVec3; 2]>) -> Self {
        Self { points, ..Self::new(accuracy, Aim::Points) }
    }

    /// The goal of this accuracy for the light that a picture shows of surfaces at these points.
    pub fn seen(accuracy: f64, points: Vec<[DVec3; 2]>) -> Self {
        Self { points, ..Self::new(accuracy, Aim::Seen) }
    }

    /// This goal, with light read by cells or rays.
    pub fn read_by(self, by: GatherMethod) -> Self {
        Self { by, ..self }
    }

    /// This goal, for so many readings alone.
    pub fn for_readings(self, readings: usize) -> Self {
        Self { readings: Some(readings), ..self }
    }

    /// Relative accuracy that light is read to, so that its error is hardly more than that of what it is read
    /// from.
    pub fn reading(accuracy: f64) -> f64 {
        OF_ACCURACY * accuracy
    }
}

/// The accuracy that an adaptation reached.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Achieved {
    /// Relative error of the finest run, as a referee found it, or, below what that sees, by the method's own
    /// estimate; None where its solver did not converge.
    pub estimate: Option<f64>,
    /// Relative error that was wanted; None in files of older versions.
    #[serde(default)]
    pub wanted: Option<f64>,
    /// Light whose error this is.
    #[serde(default)]
    pub of: Aim,
    /// Reason why no finer run followed.
    pub end: EndReason,
    /// The way in which the light has to be read to have this accuracy.
    #[serde(default)]
    pub by: GatherMethod,
}

impl Achieved {
    /// The accuracy with which a sequence for `goal` ended.
    pub(super) fn new(goal: &Goal, estimate: Option<f64>, end: EndReason) -> Self {
        Self { estimate, wanted: Some(goal.accuracy), of: goal.of, end, by: goal.by }
    }

    /// The accuracy of light for `goal` that is read by walks.
    pub(super) fn by_walks(goal: &Goal) -> Self {
        Self { by: GatherMethod::Walks, ..Self::new(goal, None, EndReason::Reached) }
    }

    /// This accuracy with the error that light read by walks has, by its standard deviations; too large a one ends
    /// as walks did.
    pub fn read(self, error: f64) -> Self {
        let is_reached = self.wanted.is_none_or(|wanted| error <= wanted);
        let end = if is_reached { self.end } else { EndReason::Walks };
        Self { estimate: Some(error), end, ..self }
    }

    /// Relative accuracy that light is read to for the accuracy that was wanted: by walks nothing else errs.
    pub fn reading(&self) -> Option<f64> {
        let wanted = self.wanted.or(self.estimate)?;
        Some(if self.by == GatherMethod::Walks { OF_WALKS * wanted } else { Goal::reading(wanted) })
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
    /// Readings by walks ended before they were as accurate as wanted.
    Walks,
    /// A person [wished](radiosity_work::Deadline::wish) the end.
    Stopped,
}
