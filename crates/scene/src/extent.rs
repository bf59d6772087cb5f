//! Extents of luminaires: points, lines or areas that their light comes out of, evenly.
//!
//! A luminaire of the intensity I(ω) sends from each piece dA of its flat luminous area A the intensity I(ω)
//! dA/A, from each piece ds of its line of the length l the intensity I(ω) ds/l: far away it is a point of
//! the intensity I, near by it is as large as it is. As a point, at a distance of n times its size, it errs
//! by about 1/(4 n²) of its light: by 1 % at five times.

use radiosity_geom::{DVec2, DVec3};
use radiosity_photometry::opening::{Form, Opening};

use crate::{
    fault::Fault,
    ranges::{check_number, check_range},
};

/// Lengths of an opening that differ by less than this part are the same. Chosen: files round to millimetres.
const ROUND: f64 = 0.01;

const UPRIGHT: &str = "the opening of the file is upright";

/// Cure of an extent without sides.
const SIDES: &str = "give two sides, e.g. extent = [1.2, 0.3], of which one may be 0 for a line, or a diameter, e.g. \
                     extent = 0.2; or leave the extent out for a point";

/// Cure of an opening that no extent is like.
const NEAREST: &str = "give the rectangle or the disk across the aim that comes nearest, e.g. extent = [1.2, 0.3] or \
                       extent = 0.2, or leave the extent out for a point";

/// Point, line or area that the light of a luminaire comes out of. Lengths are of the scene; x is along C =
/// 0, y along C = 90.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Extent {
    /// A point.
    #[default]
    Point,
    /// A line across the aim.
    Line {
        /// Vector from one end to the other, in x and y (scene length).
        span: DVec2,
    },
    /// A rectangle across the aim.
    Rectangle {
        /// Its sides along x and y (scene length), > 0.
        sides: [f64; 2],
    },
    /// A disk across the aim.
    Disk {
        /// Its diameter (scene length), > 0.
        diameter: f64,
    },
}

impl Extent {
    /// The rectangle of these sides (scene length) along x and y; a line where one of them is 0.
    ///
    /// # Errors
    /// A side that is not finite or out of range, or both 0.
    pub fn rectangle(sides: [f64; 2]) -> Result<Self, Fault> {
        for side in sides {
            check_number(side)?;
            check_range(side, side >= 0.0, "the side of the extent", "side ≥ 0")?;
        }
        match sides {
            [0.0, 0.0] => Err(Fault::bad_extent("both sides are 0", SIDES)),
            [x, y] if x == 0.0 || y == 0.0 => Ok(Self::Line { span: DVec2::new(x, y) }),
            _ => Ok(Self::Rectangle { sides }),
        }
    }

    /// The disk of this diameter (scene length).
    ///
    /// # Errors
    /// A diameter that is not finite or out of range.
    pub fn disk(diameter: f64) -> Result<Self, Fault> {
        check_number(diameter)?;
        check_range(diameter, diameter > 0.0, "the diameter of the extent", "diameter > 0")?;
        Ok(Self::Disk { diameter })
    }

    /// Extent of the luminous opening of a photometric file, where lengths are metres: a box is its rectangle
    /// across the aim, an upright cylinder its disk, and a lying one its axis.
    ///
    /// # Errors
    /// [`FaultKind::Conflict`](crate::FaultKind::Conflict) for a point, and for forms that are neither flat
    /// across the aim nor lines.
    pub fn of_opening(opening: &Opening) -> Result<Self, Fault> {
        let [x, y, z] = opening.extent;
        match opening.form {
            Form::Point => Err(Fault::bad_extent("the file states a point", SIDES)),
            Form::Box if z > 0.0 && (x == 0.0 || y == 0.0) => Err(Fault::bad_extent(UPRIGHT, NEAREST)),
            Form::Box => Self::rectangle([x, y]),
            Form::Upright if (x - y).abs() <= ROUND * x.max(y) => Self::disk(0.5 * (x + y)),
            Form::Upright => Err(Fault::bad_extent("the opening of the file is an ellipse", NEAREST)),
            Form::AlongX => Self::rectangle([x, 0.0]),
            Form::AlongY => Self::rectangle([0.0, y]),
            Form::FacingX => Err(Fault::bad_extent(UPRIGHT, NEAREST)),
            Form::Ellipsoid => Err(Fault::bad_extent("the opening of the file is a ball", NEAREST)),
        }
    }

    /// Largest width (scene length) of the extent; 0 of a point.
    pub fn width(&self) -> f64 {
        match *self {
            Self::Point => 0.0,
            Self::Line { span } => span.length(),
            Self::Rectangle { sides: [x, y] } => x.hypot(y),
            Self::Disk { diameter } => diameter,
        }
    }

    /// Whether the extent is a rectangle or a disk.
    pub fn is_area(&self) -> bool {
        matches!(self, Self::Rectangle { .. } | Self::Disk { .. })
    }

    /// The extent `factor` times as large.
    pub(super) fn scaled(self, factor: f64) -> Self {
        match self {
            Self::Point => Self::Point,
            Self::Line { span } => Self::Line { span: factor * span },
            Self::Rectangle { sides } => Self::Rectangle { sides: sides.map(|side| factor * side) },
            Self::Disk { diameter } => Self::Disk { diameter: factor * diameter },
        }
    }

    /// Vector from the middle of a line to an end (scene length), by the unit vectors of x and y; zero for a
    /// point and for areas.
    pub(super) fn half_line(&self, [x, y]: [DVec3; 2]) -> DVec3 {
        match *self {
            Self::Line { span } => 0.5 * (span.x * x + span.y * y),
            _ => DVec3::ZERO,
        }
    }
}
