//! The accuracy that is wanted, and of what.

use radiosity_geom::DVec3;
use serde::{Deserialize, Serialize};

use crate::gather::gather_method::GatherMethod;
use crate::tolerances::OF_ACCURACY;

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
        Self { accuracy, of, points: Vec::new(), by: GatherMethod::Auto, most_unknowns: 8000 }
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

    /// Relative accuracy that light is read to, so that its error is hardly more than that of what it is read
    /// from.
    pub fn reading(accuracy: f64) -> f64 {
        OF_ACCURACY * accuracy
    }
}
