//! The accuracy that is wanted, and of what.

use radiosity_geom::DVec3;
use serde::{Deserialize, Serialize};

/// What is wanted.
#[derive(Clone, Debug)]
pub struct Goal {
    /// Relative L2 error, all bands pooled.
    pub accuracy: f64,
    /// Of what.
    pub of: Aim,
    /// Where light is read, if that is [`Aim::Points`]: positions, from the scene's middle as its surfaces, and unit normals.
    pub points: Vec<[DVec3; 2]>,
    /// A run with more unknowns per band is not begun, except the first.
    pub most_unknowns: usize,
}

/// What is to be accurate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Aim {
    /// The polynomials of the radiosity, without the emitted exitance.
    #[default]
    Solution,
    /// The light that surfaces reflect of what is gathered from the solution at their points, as sensors and pictures
    /// are read.
    Gathered,
    /// The light gathered at given points.
    Points,
}

impl Goal {
    /// `accuracy` of the polynomials, or of light gathered on all surfaces, with at most 8000 unknowns per band, whose matrix
    /// has half a gigabyte (8000² · 8 bytes).
    pub fn new(accuracy: f64, of: Aim) -> Self {
        Self { accuracy, of, points: Vec::new(), most_unknowns: 8000 }
    }

    /// The same of light gathered at these points.
    pub fn at(accuracy: f64, points: Vec<[DVec3; 2]>) -> Self {
        Self { points, ..Self::new(accuracy, Aim::Points) }
    }
}
