//! Luminous areas: flat surfaces that send the light of a luminaire.
//!
//! An even area A with the unit normal n sends the intensity I(ω) of the luminaire by the radiance L = I / (A
//! cos θ), cos θ = n·ω. Its exitance is M = Φ/A with the flux Φ of the directions before it; over that of a
//! diffuse emitter it sends
//!
//! ```text
//! a(ω) = π L / M = π d(ω) / (Ω cos θ) ,     ∫ a cos θ dω = π ,
//! ```
//!
//! with the relative intensity d and its integral Ω over these directions ([`crate::Distribution`]).

use std::f64::consts::PI;

use radiosity_geom::{DVec3, Motion};

use crate::{
    distribution::{Distribution, Hemisphere},
    luminaire::Luminaire,
};

/// Part of the width of the steepest fall of intensity up to which the points of a cell tell its mean: two
/// points of a rule then lie on the fall, or within a quarter of its width from it. With a larger value falls
/// may be missed, with a smaller one cells are divided that are even.
const RESOLVED: f64 = 0.5;

/// Error of a cell's points over the range of what they sample, where an edge of light crosses it. Chosen: an
/// edge anywhere between the two points of a rule leaves it right to a quarter.
const CUT: f64 = 0.25;

/// Least cosine by which a bound of intensity becomes one of radiance; nearer to its plane an area sends next
/// to nothing. Chosen.
const GRAZING: f64 = 1e-3;

/// One side of the luminous area of a luminaire.
#[derive(Clone, Debug)]
pub struct LuminousArea {
    luminaire: Luminaire,
    /// Unit normal: along the aim, or against it.
    normal: DVec3,
    /// Flux factor Ω of the directions before the side.
    flux_factor: f64,
    /// Angle (degrees) up to which the values at the points of a cell tell its mean.
    resolved: f64,
}

impl PartialEq for LuminousArea {
    /// Whether both spread their light alike, whatever they are called.
    fn eq(&self, other: &Self) -> bool {
        self.luminaire.is_aimed_as(&other.luminaire) && self.normal == other.normal
    }
}

impl LuminousArea {
    /// The side along the aim of a luminaire and the one against it, each where it sends any light.
    pub(super) fn sides(luminaire: &Luminaire) -> [Option<Self>; 2] {
        let side = |normal: DVec3, Hemisphere { flux_factor, scale }: Hemisphere| Self {
            luminaire: luminaire.clone(),
            normal,
            flux_factor,
            resolved: RESOLVED * scale,
        };
        let [along, against] = luminaire.distribution.hemispheres();
        [along.map(|own| side(luminaire.aim, own)), against.map(|own| side(-luminaire.aim, own))]
    }

    /// The side, moved without a change of size.
    pub(super) fn moved(&self, motion: &Motion) -> Self {
        let luminaire = self.luminaire.clone().moved(motion);
        Self { luminaire, normal: motion.direction(self.normal), ..*self }
    }

    /// The side of a luminaire with a factor on each band.
    pub(super) fn dimmed(&self, factors: &[f64]) -> Self {
        let mut luminaire = self.luminaire.clone();
        luminaire.dim(factors);
        Self { luminaire, ..*self }
    }

    /// Flux of each band (W) that it sends, not dimmed by its light group.
    pub(super) fn flux(&self) -> Vec<f64> {
        self.luminaire.strength.iter().map(|strength| strength * self.flux_factor).collect()
    }

    /// Relative radiance a in a unit direction from the side.
    pub(super) fn relative(&self, into: DVec3) -> f64 {
        match into.dot(self.normal) {
            cosine if cosine > 0.0 => PI * self.luminaire.relative(into) / (self.flux_factor * cosine),
            _ => 0.0,
        }
    }

    /// Error of the mean of a over a cell by what is between its points: 0 where the cell is small beside the
    /// steepest falls of intensity, else a part of the range of a over all directions `into`, of any length,
    /// from the corners of the cell.
    pub(super) fn left_out(&self, into: &[DVec3]) -> f64 {
        let middle = into.iter().map(|step| step.normalize_or_zero()).sum::<DVec3>().normalize_or_zero();
        let angle = |step: &DVec3| middle.cross(*step).length().atan2(middle.dot(*step)).to_degrees();
        let within = into.iter().map(angle).fold(0.0, f64::max);
        if within <= self.resolved {
            return 0.0;
        }
        let gamma = self.luminaire.gamma(middle);
        let [least, most] = self.luminaire.distribution.range(gamma, within);
        PI * CUT * (most - least) / (self.flux_factor * middle.dot(self.normal).max(GRAZING))
    }

    /// Whether its intensity may bend at once from one direction to the next, as a table does at its angles.
    pub(super) fn bends(&self) -> bool {
        matches!(self.luminaire.distribution, Distribution::Table(_) | Distribution::Cone { .. })
    }
}
