//! Openings to the sky: surfaces that send the radiance of a sky, through glass or without.
//!
//! A flat opening with the unit normal n, which points into the room, sends into the direction ω the radiance
//! L(−ω) τ(n·ω) of the sky. Its exitance is M = ∫ L τ cos θ dω; over that it sends
//!
//! ```text
//! a(ω) = π L(−ω) τ(n·ω) / M ,     ∫ a cos θ dω = π ,
//! ```
//!
//! 1 for a diffuse emitter. What stands outside is not seen.

use std::f64::consts::PI;
use std::sync::Arc;

use radiosity_geom::{DVec3, ROUNDING};

use crate::{
    glass::Glass,
    sky::{Sky, over_hemisphere},
};

/// Error of 2 × 2 points for the mean of a cone over a cell, over what it falls to the farthest corner: 0.036
/// with the tip in the middle, less with it elsewhere; rounded up.
const CONE: f64 = 0.05;

/// The sky and the glass of an opening.
#[derive(Clone, Debug, PartialEq)]
pub struct Opening {
    /// The sky outside.
    pub sky: Arc<Sky>,
    /// The glass in the opening, if any.
    pub glass: Option<Glass>,
}

/// Radiance by direction that a flat opening to a sky sends into the room.
#[derive(Clone, Debug, PartialEq)]
pub struct Outlook {
    opening: Opening,
    normal: DVec3,
    /// Exitance M over the irradiance of level ground.
    share: f64,
}

impl Outlook {
    /// The outlook of an opening with this unit normal, which points into the room.
    pub(super) fn new(opening: Opening, normal: DVec3) -> Self {
        let Opening { sky, glass } = &opening;
        let share =
            over_hemisphere(normal, |into, cosine| sky.radiance(-into) * through(glass.as_ref(), cosine));
        Self { share, opening, normal }
    }

    /// The outlook of the same opening with its normal turned.
    pub(super) fn turned(&self, turn: impl FnOnce(DVec3) -> DVec3) -> Self {
        let normal = turn(self.normal);
        match normal.distance(self.normal) <= ROUNDING {
            true => self.clone(),
            false => Self::new(self.opening.clone(), normal),
        }
    }

    /// The outlook on a sky, and a sun, of which so much of each band comes in, as behind a blind.
    pub(super) fn dimmed(&self, factors: &[f64]) -> Self {
        let Opening { sky, glass } = &self.opening;
        let opening = Opening { sky: Arc::new(sky.dimmed(factors)), glass: *glass };
        Self { opening, ..*self }
    }

    /// Exitance M of each band (W m⁻²).
    pub fn exitance(&self) -> Vec<f64> {
        self.opening.sky.irradiance().iter().map(|own| own * self.share).collect()
    }

    /// Relative radiance a in the unit direction `into` the room.
    pub(crate) fn relative(&self, into: DVec3) -> f64 {
        let Opening { sky, glass } = &self.opening;
        match self.share {
            0.0 => 0.0,
            share => PI * sky.radiance(-into) * through(glass.as_ref(), into.dot(self.normal)) / share,
        }
    }

    /// Whether a varies between directions that rise, or between those that fall.
    pub(crate) fn is_graded(&self) -> bool {
        self.opening.glass.is_some() || !self.opening.sky.is_even()
    }

    /// Unit vector to the zenith.
    pub(crate) fn zenith(&self) -> DVec3 {
        self.opening.sky.zenith()
    }

    /// Error of the mean of a over a cell whose corners send light along `into`, of any length: the radiance of
    /// a clear sky is a cone about the sun.
    pub(crate) fn left_out(&self, into: &[DVec3]) -> f64 {
        let Some(peak) = self.opening.sky.peak() else { return 0.0 };
        let units = || into.iter().map(|into| into.normalize_or_zero());
        let axis = units().sum::<DVec3>().normalize_or_zero();
        let widest = units().map(|unit| unit.dot(axis)).fold(1.0, f64::min);
        if axis.dot(-peak) < widest {
            return 0.0;
        }
        let least = units().map(|unit| self.relative(unit)).fold(f64::INFINITY, f64::min);
        CONE * (self.relative(-peak) - least).max(0.0)
    }

    /// The direction to the sun, and the irradiance per band (W m⁻²) across its beam behind the opening; None
    /// without a sun that shines in.
    pub fn beam(&self) -> Option<(DVec3, Vec<f64>)> {
        let Opening { sky, glass } = &self.opening;
        let sun = sky.sun()?;
        let through = through(glass.as_ref(), -sun.direction.dot(self.normal));
        let irradiance: Vec<f64> = sun.irradiance.iter().map(|own| through * own).collect();
        irradiance.iter().any(|own| *own > 0.0).then_some((sun.direction, irradiance))
    }

    /// The cosine of a direction to the sun at the opening; 0 from behind.
    pub fn incidence(&self, to_sun: DVec3) -> f64 {
        (-to_sun.dot(self.normal)).max(0.0)
    }
}

/// Outlooks of the openings of a scene, each computed once for all openings that look alike.
#[derive(Debug, Default)]
pub(super) struct KnownOutlooks(Vec<Arc<Outlook>>);

impl KnownOutlooks {
    /// The outlook of an opening with this unit normal, which points into the room; computed where it is new.
    pub(super) fn of(&mut self, opening: &Opening, normal: DVec3) -> Arc<Outlook> {
        let is_alike =
            |own: &&Arc<Outlook>| own.opening == *opening && own.normal.distance(normal) <= ROUNDING;
        if let Some(known) = self.0.iter().find(is_alike) {
            return Arc::clone(known);
        }
        let outlook = Arc::new(Outlook::new(opening.clone(), normal));
        self.0.push(Arc::clone(&outlook));
        outlook
    }
}

/// Transmittance of an opening at a cosine: of its glass, or 1 without glass; 0 from behind.
fn through(glass: Option<&Glass>, cosine: f64) -> f64 {
    match glass {
        _ if cosine <= 0.0 => 0.0,
        None => 1.0,
        Some(glass) => glass.transmittance(cosine),
    }
}
