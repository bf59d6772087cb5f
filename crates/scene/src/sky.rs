//! Skies: the radiance that comes from each direction, and the sun.
//!
//! With the zenith angle Z of a direction, its angle χ from the sun and the zenith angle Z_s of the sun,
//! relative radiances are
//!
//! ```text
//! uniform     l = 1
//! overcast    l = (1 + 2 cos Z) / 3                                          CIE traditional overcast sky (type 16)
//! clear       l = f(χ) φ(Z) ,   f = 1 + 10 (e^(−3 χ) − e^(−3 π/2)) + 0.45 cos² χ ,   φ = 1 − e^(−0.32 / cos Z)
//!                                                                            CIE standard clear sky (type 12)
//! ```
//!
//! times what makes the irradiance of the level ground right: E = ∫ l cos Z dω, which is π for the uniform
//! and 7π/9 for the overcast sky. Below the horizon the ground shines evenly with ρ_g (E + E_sun)/π, all
//! bands together, in the colour of the sky.
//!
//! Reference: ISO 15469:2004 / CIE S 011, *Spatial distribution of daylight – CIE standard general sky*,
//! equations 1 to 4 and table 1.

use std::f64::consts::{FRAC_PI_2, PI};

use radiosity_geom::DVec3;

use crate::{
    fault::Fault,
    material::{check_count, check_reflectance},
    ranges::{check_number, check_range, check_range_or},
};

/// Distribution of radiance over the sky.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SkyModel {
    /// Even radiance.
    Uniform,
    /// The CIE traditional overcast sky.
    Overcast,
    /// The CIE standard clear sky, which needs a sun.
    Clear,
}

/// The sun: its direction and its irradiance.
#[derive(Clone, Debug, PartialEq)]
pub struct Sun {
    /// Unit vector to it, above the horizon.
    pub direction: DVec3,
    /// Irradiance of a plane across its beam, per band (W m⁻²).
    pub irradiance: Vec<f64>,
}

/// A sky over level ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Sky {
    model: SkyModel,
    /// Unit vector to the zenith.
    up: DVec3,
    /// Irradiance of level ground by the sky alone, per band (W m⁻²).
    irradiance: Vec<f64>,
    sun: Option<Sun>,
    /// Integral ∫ l cos Z dω of the relative radiance over the sky.
    whole: f64,
    /// Radiance of the ground over the irradiance of level ground by the sky.
    below: f64,
}

impl Sky {
    /// A sky that gives level ground of the reflectance `ground` the irradiance `irradiance` of each band;
    /// `up` is any vector to the zenith.
    ///
    /// # Errors
    /// A number that is not finite or out of range, other bands of the sun, `up` without a length, a clear sky
    /// without sun, a sun below the horizon.
    pub fn new(
        model: SkyModel,
        up: DVec3,
        irradiance: Vec<f64>,
        ground: f64,
        sun: Option<Sun>,
    ) -> Result<Self, Fault> {
        up.to_array().into_iter().try_for_each(check_number)?;
        let up = up.try_normalize().ok_or_else(no_up)?;
        irradiance.iter().try_for_each(|value| check_irradiance(*value))?;
        check_reflectance(ground)?;
        if let Some(sun) = &sun {
            check_count("the irradiance of the sun", &sun.irradiance, irradiance.len())?;
            sun.irradiance.iter().try_for_each(|value| check_irradiance(*value))?;
            if sun.direction.dot(up) <= 0.0 {
                let cure = "give a direction above the horizon, or leave the sun out";
                return Err(Fault::conflict("the sun is not above the horizon", cure));
            }
        }
        if model == SkyModel::Clear && sun.is_none() {
            return Err(Fault::missing_key("sun", ", where the sun is: { elevation = 40, azimuth = 180 }"));
        }
        let all: f64 = irradiance.iter().sum();
        if all <= 0.0 {
            let fault = Fault::out_of_range("the illuminance of the sky", all, "illuminance > 0 in a band");
            return Err(fault.cured(
                "give what level ground gets from the sky without the sun, e.g. 10000 lx; at night leave the sky and its \
                 openings out",
            ));
        }
        let beam = sun.as_ref().map_or(0.0, |sun| sun.irradiance.iter().sum::<f64>() * sun.direction.dot(up));
        let below = ground * (1.0 + beam / all) / PI;
        let sky = Self { model, up, irradiance, sun, whole: 1.0, below };
        let whole = sky.level();
        Ok(Self { whole, ..sky })
    }

    /// The sky with a factor on each band of its light, of that of the ground and of the sun.
    pub(crate) fn dimmed(&self, factors: &[f64]) -> Self {
        let dimmed = |light: &[f64]| light.iter().zip(factors).map(|(own, factor)| own * factor).collect();
        let sun = self.sun.as_ref().map(|own| Sun { irradiance: dimmed(&own.irradiance), ..*own });
        Self { irradiance: dimmed(&self.irradiance), sun, ..*self }
    }

    /// The sun, if there is one.
    pub(crate) fn sun(&self) -> Option<&Sun> {
        self.sun.as_ref()
    }

    /// Irradiance of level ground per band, the sun left out (W m⁻²).
    pub(crate) fn irradiance(&self) -> &[f64] {
        &self.irradiance
    }

    /// Unit vector to the zenith.
    pub(crate) fn zenith(&self) -> DVec3 {
        self.up
    }

    /// Whether the radiance is even above the horizon.
    pub(crate) fn is_even(&self) -> bool {
        self.model == SkyModel::Uniform
    }

    /// Unit vector to where the radiance has a tip: the sun in a clear sky.
    pub(crate) fn peak(&self) -> Option<DVec3> {
        self.sun.as_ref().filter(|_| self.model == SkyModel::Clear).map(|sun| sun.direction)
    }

    /// Radiance (1/sr) from the unit direction `from`, over the irradiance of level ground in the band.
    pub(crate) fn radiance(&self, from: DVec3) -> f64 {
        match from.dot(self.up) {
            cosine if cosine > 0.0 => self.relative(cosine, from) / self.whole,
            _ => self.below,
        }
    }

    /// Relative radiance l from the unit direction `from` above the horizon; `cosine` is cos Z.
    fn relative(&self, cosine: f64, from: DVec3) -> f64 {
        match (self.model, &self.sun) {
            (SkyModel::Overcast, _) => (1.0 + 2.0 * cosine) / 3.0,
            (SkyModel::Clear, Some(sun)) => {
                let beside = from.dot(sun.direction);
                let chi = from.cross(sun.direction).length().atan2(beside);
                let near = 10.0 * ((-3.0 * chi).exp() - (-3.0 * FRAC_PI_2).exp());
                (1.0 + near + 0.45 * beside * beside) * (1.0 - (-0.32 / cosine).exp())
            }
            _ => 1.0,
        }
    }

    /// Integral ∫ l cos Z dω of the relative radiance over the sky.
    fn level(&self) -> f64 {
        match self.model {
            SkyModel::Uniform => PI,
            SkyModel::Overcast => 7.0 * PI / 9.0,
            SkyModel::Clear => over_hemisphere(self.up, |from, cosine| self.relative(cosine, from)),
        }
    }
}

/// ∫ f(ω, cos θ) cos θ dω over the hemisphere about a unit vector, by midpoints even in cos θ and in the
/// angle about it.
pub(crate) fn over_hemisphere(normal: DVec3, f: impl Fn(DVec3, f64) -> f64) -> f64 {
    // Chosen: what the sky sends level ground is then right to 1e-5.
    const RINGS: usize = 256;
    const TURNS: usize = 512;
    let (along, across) = normal.any_orthonormal_pair();
    let ring = |k: usize| -> f64 {
        let cosine = (k as f64 + 0.5) / RINGS as f64;
        let sine = (1.0 - cosine * cosine).sqrt();
        let at = |j: usize| {
            let (sin, cos) = ((j as f64 + 0.5) * 2.0 * PI / TURNS as f64).sin_cos();
            f(sine * (cos * along + sin * across) + cosine * normal, cosine)
        };
        cosine * (0..TURNS).map(at).sum::<f64>()
    };
    2.0 * PI / (RINGS * TURNS) as f64 * (0..RINGS).map(ring).sum::<f64>()
}

/// A vector to the zenith without a length.
pub fn no_up() -> Fault {
    Fault::no_direction("up", "give the direction to the zenith, e.g. [0, 0, 1]")
}

/// Checks that an irradiance is finite and ≥ 0.
pub fn check_irradiance(value: f64) -> Result<(), Fault> {
    check_range(value, value >= 0.0, "the illuminance", "illuminance ≥ 0")
}

/// Checks that 0 < elevation ≤ 90 degrees.
pub fn check_elevation(value: f64) -> Result<(), Fault> {
    let range = "0 < elevation ≤ 90 degrees";
    let cure = "choose a value in that range; a sun at or below the horizon sends no light: leave it out";
    check_range_or(value, value > 0.0 && value <= 90.0, "the elevation of the sun", range, cure)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sky(model: SkyModel, sun: Option<Sun>) -> Sky {
        Sky::new(model, DVec3::Z, vec![1.0], 0.0, sun).expect("a sky")
    }

    /// E = ∫ L cos Z dω is what was asked for.
    #[test]
    fn level_ground_gets_what_was_asked_for() {
        let direction = DVec3::new(0.5, -0.3, 0.7).normalize();
        let sun = Sun { direction, irradiance: vec![0.0] };
        let skies =
            [sky(SkyModel::Uniform, None), sky(SkyModel::Overcast, None), sky(SkyModel::Clear, Some(sun))];
        for sky in skies {
            let found = over_hemisphere(DVec3::Z, |from, _| sky.radiance(from));
            assert!((found - 1.0).abs() < 1e-5, "{:?}: {found}", sky.model);
        }
    }

    /// The zenith of the overcast sky is three times as bright as its horizon; the clear sky is brightest
    /// about the sun.
    #[test]
    fn skies_are_bright_where_the_standard_says() {
        let overcast = sky(SkyModel::Overcast, None);
        let horizon = DVec3::new(1.0, 0.0, 1e-12).normalize();
        assert!((overcast.radiance(DVec3::Z) / overcast.radiance(horizon) - 3.0).abs() < 1e-9);
        assert!((overcast.radiance(DVec3::Z) - 9.0 / (7.0 * PI)).abs() < 1e-15);
        let direction = DVec3::new(0.0, 1.0, 1.0).normalize();
        let clear = sky(SkyModel::Clear, Some(Sun { direction, irradiance: vec![0.0] }));
        // Table 1 of the standard with χ = 0: f(0) φ(45°) over f(45°) φ(0).
        let f = |chi: f64| 1.0 + 10.0 * ((-3.0 * chi).exp() - (-1.5 * PI).exp()) + 0.45 * chi.cos().powi(2);
        let phi = |z: f64| 1.0 - (-0.32 / z.cos()).exp();
        let exact = f(0.0) * phi(PI / 4.0) / (f(PI / 4.0) * phi(0.0));
        assert!((clear.radiance(direction) / clear.radiance(DVec3::Z) - exact).abs() < 1e-9 * exact);
    }
}
