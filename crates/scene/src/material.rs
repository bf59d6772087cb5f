//! Materials: reflectance ρ, diffuse transmittance τ and emission, per band.

use std::sync::Arc;

use crate::{
    fault::{Fault, FaultKind, shown},
    pattern::Pattern,
    ranges::{check_range, check_range_or},
};

/// A Lambertian material. [`Material::new`] checks the ranges; scenes hold only checked ones.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Material {
    /// Reflectance ρ of each band, 0 ≤ ρ < 1; its mean over the parameters where it is patterned.
    pub reflectance: Vec<f64>,
    /// Emitted exitance of each band, W m⁻², ≥ 0; its mean over the parameters where it is patterned.
    pub emission: Vec<f64>,
    /// Diffuse transmittance τ of each band, the part of what arrives on the other side that leaves here;
    /// 0 ≤ τ, ρ + τ < 1.
    pub transmittance: Vec<f64>,
    /// Pattern of ρ over a surface; none where it is constant.
    pub reflectance_pattern: Option<Arc<Pattern>>,
    /// Pattern of the emitted exitance over a surface; none where it is constant.
    pub emission_pattern: Option<Arc<Pattern>>,
}

impl Material {
    /// A material of as many bands as `reflectance` and `emission` have entries.
    ///
    /// `reflectance`: 0 ≤ ρ < 1. `emission`: exitance, W m⁻², ≥ 0 and finite.
    ///
    /// # Errors
    /// [`FaultKind::OutOfRange`] or [`FaultKind::NotFinite`] for the first number that is wrong,
    /// [`FaultKind::WrongCount`] if the lengths differ.
    pub fn new(reflectance: Vec<f64>, emission: Vec<f64>) -> Result<Self, Fault> {
        let bands = reflectance.len();
        Material { reflectance, emission, ..Material::black(bands) }.checked()
    }

    /// The material with the diffuse `transmittance` τ of each band, a share of what arrives on its other
    /// side; it is for two-sided surfaces.
    ///
    /// # Errors
    /// As [`Material::new`]; ρ + τ < 1 in each band, all over the surface.
    pub fn with_transmittance(self, transmittance: Vec<f64>) -> Result<Self, Fault> {
        Material { transmittance, ..self }.checked()
    }

    /// The material with a reflectance that varies over the surface.
    ///
    /// # Errors
    /// [`FaultKind::OutOfRange`] for a pattern that leaves 0 ≤ ρ < 1 − τ somewhere, [`FaultKind::WrongCount`] for
    /// one of other bands.
    pub fn with_reflectance_pattern(self, pattern: Pattern) -> Result<Self, Fault> {
        check_pattern_bands("the reflectance", &pattern, self.reflectance.len())?;
        let reflectance = pattern.means();
        Material { reflectance, reflectance_pattern: Some(Arc::new(pattern)), ..self }.checked()
    }

    /// The material with an emission (W m⁻²) that varies over the surface.
    ///
    /// # Errors
    /// [`FaultKind::OutOfRange`] for a pattern that falls below 0 somewhere, [`FaultKind::WrongCount`] for one of
    /// other bands.
    pub fn with_emission_pattern(self, pattern: Pattern) -> Result<Self, Fault> {
        check_pattern_bands("the emission", &pattern, self.emission.len())?;
        let emission = pattern.means();
        let own = Material { emission, emission_pattern: Some(Arc::new(pattern)), ..self }.checked()?;
        // A pattern that is dark everywhere is dropped: it conflicts with no flux and no sky.
        let emission_pattern = own.emission_pattern.clone().filter(|_| own.emits());
        Ok(Material { emission_pattern, ..own })
    }

    fn checked(self) -> Result<Self, Fault> {
        self.check(self.reflectance.len())?;
        Ok(self)
    }

    /// Checks that there is a number in range for each of `bands` bands.
    pub fn check(&self, bands: usize) -> Result<(), Fault> {
        check_count("the reflectance", &self.reflectance, bands)?;
        check_count("the emission", &self.emission, bands)?;
        check_count("the transmittance", &self.transmittance, bands)?;
        self.transmittance.iter().try_for_each(|&tau| check_transmittance(tau))?;
        match &self.reflectance_pattern {
            Some(pattern) => check_reflectances(pattern, &self.transmittance)?,
            None => self.reflectance.iter().try_for_each(|&rho| check_reflectance(rho))?,
        }
        match &self.emission_pattern {
            Some(pattern) => check_emissions(pattern, bands)?,
            None => self.emission.iter().try_for_each(|&exitance| check_emission(exitance))?,
        }
        check_means(&self.reflectance, self.reflectance_pattern.as_deref(), "the reflectance")?;
        check_means(&self.emission, self.emission_pattern.as_deref(), "the emission")?;
        self.reflectance.iter().zip(&self.transmittance).try_for_each(|(rho, tau)| check_sum(rho + tau))
    }

    /// The material that neither reflects nor emits.
    pub fn black(bands: usize) -> Self {
        Material {
            reflectance: vec![0.0; bands],
            emission: vec![0.0; bands],
            transmittance: vec![0.0; bands],
            reflectance_pattern: None,
            emission_pattern: None,
        }
    }

    /// The material that emits so much of each band of what it does.
    pub(crate) fn dimmed(&self, factors: &[f64]) -> Self {
        let emission: Vec<f64> =
            self.emission.iter().zip(factors).map(|(own, factor)| own * factor).collect();
        let is_dark = emission.iter().all(|exitance| *exitance == 0.0);
        let emission_pattern = self.emission_pattern.as_ref().filter(|_| !is_dark);
        let emission_pattern = emission_pattern.map(|own| Arc::new(own.dimmed(factors)));
        let emission = emission_pattern.as_ref().map_or(emission, |own| own.means());
        Self { emission, emission_pattern, ..self.clone() }
    }

    /// Whether it emits in any band.
    pub fn emits(&self) -> bool {
        self.emission.iter().any(|&exitance| exitance != 0.0)
    }

    /// Whether it lets light through in some band.
    pub fn transmits(&self) -> bool {
        self.transmittance.iter().any(|&tau| tau > 0.0)
    }

    /// Whether its reflectance or its emission varies over the surface.
    pub fn is_patterned(&self) -> bool {
        self.reflectance_pattern.is_some() || self.emission_pattern.is_some()
    }

    /// Whether any light can leave it: whether it emits, reflects or transmits in some band.
    pub fn sends(&self) -> bool {
        self.emits() || self.reflectance.iter().chain(&self.transmittance).any(|&rho| rho > 0.0)
    }
}

/// Checks that there is one number per band.
pub(super) fn check_count(what: &'static str, numbers: &[f64], bands: usize) -> Result<(), Fault> {
    if numbers.len() == bands {
        return Ok(());
    }
    let expected = match bands {
        1 => "one number, as there is one band".to_owned(),
        _ => format!("{bands} numbers, one per band"),
    };
    Err(Fault::wrong_count(what, &expected, numbers.len()))
}

/// Checks that 0 ≤ ρ < 1.
pub fn check_reflectance(rho: f64) -> Result<(), Fault> {
    let cure = "choose a value in that range; a surface that loses nothing (ρ = 1) has no balance in a closed room, \
                0.999 comes close";
    check_range_or(rho, (0.0..1.0).contains(&rho), "the reflectance", "0 ≤ ρ < 1", cure)
}

/// Checks that 0 ≤ τ < 1.
pub fn check_transmittance(tau: f64) -> Result<(), Fault> {
    check_range(tau, (0.0..1.0).contains(&tau), "the transmittance", "0 ≤ τ < 1")
}

/// Checks that ρ + τ < 1.
fn check_sum(sum: f64) -> Result<(), Fault> {
    check_range(sum, sum < 1.0, "the sum of reflectance and transmittance", "ρ + τ < 1")
}

/// Checks that a pattern has as many bands as the material.
fn check_pattern_bands(what: &'static str, pattern: &Pattern, bands: usize) -> Result<(), Fault> {
    match pattern.bands() == bands {
        true => Ok(()),
        false => {
            let expected = format!("a pattern of {bands} {}", if bands == 1 { "band" } else { "bands" });
            Err(Fault::wrong_count(what, &expected, pattern.bands()))
        }
    }
}

/// Checks that the numbers beside a pattern are its means.
fn check_means(numbers: &[f64], pattern: Option<&Pattern>, what: &'static str) -> Result<(), Fault> {
    let means = pattern.map(Pattern::means).unwrap_or_default();
    let mut differing = numbers.iter().zip(means).filter(|(number, mean)| *number != mean);
    match differing.next() {
        Some((value, _)) => Err(Fault::out_of_range(what, *value, "the mean of its pattern")),
        None => Ok(()),
    }
}

/// Checks that 0 ≤ ρ < 1 − τ all over a pattern.
pub(super) fn check_reflectances(pattern: &Pattern, transmittance: &[f64]) -> Result<(), Fault> {
    check_pattern_bands("the reflectance", pattern, transmittance.len())?;
    let what = "the reflectance";
    check_pattern(pattern, what, "0 ≤ ρ < 1", |band, rho| match rho + transmittance[band] < 1.0 {
        true => None,
        false if rho < 1.0 => Some("ρ + τ < 1"),
        false => Some("0 ≤ ρ < 1"),
    })
}

/// Checks that emission is finite and ≥ 0 all over a pattern.
pub(super) fn check_emissions(pattern: &Pattern, bands: usize) -> Result<(), Fault> {
    check_pattern_bands("the emission", pattern, bands)?;
    let range = "emission ≥ 0";
    check_pattern(pattern, "the emission", range, |_, exitance| (!exitance.is_finite()).then_some(range))
}

/// Checks that no value is below 0, where `range` begins, and that the largest of each band is in the range
/// that `above` names otherwise.
fn check_pattern(
    pattern: &Pattern,
    what: &'static str,
    range: &'static str,
    above: impl Fn(usize, f64) -> Option<&'static str>,
) -> Result<(), Fault> {
    pattern.check()?;
    (0..pattern.bands()).try_for_each(|band| {
        let [least, most] = pattern.extremes(band);
        let below = (least.value < -pattern.rounding(band)).then_some((least, range));
        match below.or_else(|| above(band, most.value).map(|range| (most, range))) {
            None => Ok(()),
            Some((extreme, range)) => {
                let (value, place) = (extreme.value, extreme.spot);
                let cause = format!("{what} is {} {place}, outside {range}", shown(value));
                Err(Fault::new(FaultKind::OutOfRange, cause, pattern_cure(value)))
            }
        }
    })
}

/// Cure of a pattern with this value outside its range.
fn pattern_cure(value: f64) -> String {
    if value < 0.0 {
        return "add a constant to the pattern, or choose another one, so that it is nowhere below 0"
            .to_owned();
    }
    // The largest value, e.g. 1 for white, becomes that of a bright paint, 0.9 at most.
    format!(
        "scale the pattern down: factor = {:.2}, times the factor that it may have already; white paint has ρ = 0.85 or so",
        (0.9 / value).min(0.9)
    )
}

/// Checks that an emission is finite and ≥ 0.
pub fn check_emission(exitance: f64) -> Result<(), Fault> {
    check_range(exitance, exitance >= 0.0, "the emission", "emission ≥ 0")
}

/// Refuses a transmittance of a surface covered with `own` that has no `other` side, or one of another
/// transmittance.
pub(super) fn check_sheet(own: &Material, other: Option<&Material>) -> Result<(), Fault> {
    match other {
        None if own.transmits() => Err(Fault::one_sided("a transmittance")),
        Some(Material { transmittance, .. }) if own.transmittance != *transmittance => {
            let own = &own.transmittance;
            let cause = format!("the transmittances of its two sides differ: {own:?} and {transmittance:?}");
            let cure =
                "give both materials the same transmittance: a diffuse sheet lets through as much either way";
            Err(Fault::conflict(cause, cure))
        }
        _ => Ok(()),
    }
}

/// Checks that a flux is finite and ≥ 0.
pub fn check_flux(flux: f64) -> Result<(), Fault> {
    check_range(flux, flux >= 0.0, "the flux", "flux ≥ 0")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Placement, Polynomial, Term};

    #[test]
    fn reflectance_may_be_zero_but_not_one() {
        assert!(Material::new(vec![0.0], vec![0.0]).is_ok());
        assert!(Material::new(vec![1.0_f64.next_down()], vec![0.0]).is_ok());
        for rho in [1.0, 1.2, -1e-300] {
            assert_eq!(Material::new(vec![rho], vec![0.0]).unwrap_err().kind, FaultKind::OutOfRange);
        }
    }

    #[test]
    fn numbers_are_finite_and_one_per_band() {
        assert_eq!(Material::new(vec![f64::NAN], vec![0.0]).unwrap_err().kind, FaultKind::NotFinite);
        assert_eq!(Material::new(vec![0.5], vec![f64::INFINITY]).unwrap_err().kind, FaultKind::NotFinite);
        assert_eq!(Material::new(vec![0.5], vec![-1.0]).unwrap_err().kind, FaultKind::OutOfRange);
        assert_eq!(Material::new(vec![0.5; 3], vec![1.0]).unwrap_err().kind, FaultKind::WrongCount);
    }

    fn polynomial(terms: &[(u32, u32, f64)]) -> Pattern {
        let terms = terms.iter().map(|&(u, v, factor)| Term { u, v, factor });
        Pattern::polynomial(vec![Polynomial::new(terms)])
    }

    #[test]
    fn reflectance_and_transmittance_stay_below_one_together() {
        let grey =
            |rho, tau| Material::new(vec![rho], vec![0.0]).and_then(|own| own.with_transmittance(vec![tau]));
        assert!(grey(0.5, 0.49).is_ok_and(|own| own.transmits() && own.sends()));
        assert!(grey(0.0, 0.9).is_ok_and(|own| own.sends()));
        for (rho, tau) in [(0.5, 0.5), (0.6, 0.6), (0.0, 1.0), (0.1, -0.1)] {
            assert_eq!(grey(rho, tau).unwrap_err().kind, FaultKind::OutOfRange, "{rho} {tau}");
        }
        let slope = polynomial(&[(0, 0, 0.5), (1, 0, 0.3)]);
        let sheet = grey(0.1, 0.1).and_then(|own| own.with_reflectance_pattern(slope.clone()));
        assert_eq!(sheet.map(|own| own.reflectance), Ok(vec![0.5]));
        let sheet = grey(0.1, 0.2).and_then(|own| own.with_reflectance_pattern(slope));
        let fault = sheet.expect_err("0.8 + 0.2 at u = 1");
        assert!(fault.kind == FaultKind::OutOfRange && fault.to_string().ends_with("ρ + τ < 1"), "{fault}");
    }

    #[test]
    fn patterns_are_in_range_everywhere() {
        let wall = || Material::black(1);
        // 1 − u² is 0 at the border, and 4 (u − v)² is nowhere below 0.
        let touching =
            [polynomial(&[(0, 0, 1.0), (2, 0, -1.0)]), polynomial(&[(2, 0, 4.0), (1, 1, -8.0), (0, 2, 4.0)])];
        for pattern in touching {
            assert!(wall().with_emission_pattern(pattern).is_ok());
        }
        let dip = polynomial(&[(2, 0, 1.0), (1, 0, -0.6), (0, 0, 0.0899)]);
        let fault = wall().with_emission_pattern(dip).expect_err("−10⁻⁴ at u = 0.3");
        assert!(fault.to_string().contains("u = 0.3"), "{fault}");
        let one = polynomial(&[(0, 0, 1.0), (2, 0, -0.5)]);
        let fault = wall().with_reflectance_pattern(one).expect_err("1 at u = 0");
        assert!(fault.to_string().contains("u = 0.0"), "{fault}");
        let texels =
            |value| Pattern::texels(2, vec![vec![0.1, 0.2, 0.3, value]], Placement::default()).unwrap();
        assert!(wall().with_reflectance_pattern(texels(0.99)).is_ok_and(|own| own.reflectance[0] == 0.3975));
        let fault = wall().with_reflectance_pattern(texels(1.0)).expect_err("no loss");
        assert!(fault.to_string().contains("column 2, row 1 from the top"), "{fault}");
        let mut other = wall().with_reflectance_pattern(texels(0.9)).unwrap();
        other.reflectance = vec![0.5];
        let fault = other.check(1).unwrap_err();
        assert_eq!(fault.kind, FaultKind::OutOfRange);
        assert!(fault.to_string().ends_with("the mean of its pattern"), "{fault}");
        let dark = Pattern::texels(1, vec![vec![0.0]], Placement::default()).unwrap();
        assert!(wall().with_emission_pattern(dark).is_ok_and(|own| !own.is_patterned() && !own.emits()));
        let two = Material::black(2).with_reflectance_pattern(texels(0.5));
        assert_eq!(two.unwrap_err().kind, FaultKind::WrongCount);
    }
}
