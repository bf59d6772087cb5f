//! The light of one group, apart from that of all others.
//!
//! Light is linear in emission: with h_g the irradiance of group g alone, not dimmed, and f_g its factor, the
//! scene's irradiance is h = Σ_g f_g h_g. So are its direct part, the shadow masks and the powers of its
//! balance.

use std::sync::Arc;

use radiosity_elements::Elements;
use radiosity_published::zatz1993::masked_light::MaskedLight;

use crate::system::Coefficients;

use super::powers::Powers;

/// The light of one group, not dimmed.
#[derive(Clone, Debug)]
pub struct GroupLight {
    /// Name of the group; None for the light of surfaces without a group, which cannot be dimmed.
    pub group: Option<String>,
    /// Irradiance from the group, in each band.
    pub bands: Vec<Incident>,
    /// Balance of the group's power.
    pub powers: Powers,
    /// Direct light of the group with shadow masks, where there are any.
    pub masked: Option<Arc<MaskedLight>>,
}

/// The light of a group at a factor.
#[derive(Clone, Copy)]
pub(super) struct DimmedGroup<'a> {
    pub light: &'a GroupLight,
    pub factor: f64,
}

impl GroupLight {
    /// This light with a uniform irradiance (W m⁻²) added in each band, on all `elements` that nothing covers;
    /// none where `around` is empty. Its balance of power stays.
    pub(crate) fn brightened(mut self, elements: &Elements, around: &[f64]) -> Self {
        for (own, around) in self.bands.iter_mut().zip(around) {
            let constants = elements.list().iter().flat_map(|element| {
                let share = f64::from(u8::from(element.contact.is_none()));
                element.constant.iter().map(move |c| share * c)
            });
            own.irradiance.iter_mut().zip(constants).for_each(|(h, c)| *h += around * c);
        }
        self
    }

    /// Σ f x over the `parts` x with their `factors` f, all of one group and over the same functions, without
    /// masks.
    pub(crate) fn together<'a>(factors: &[f64], parts: impl Iterator<Item = &'a Self> + Clone) -> Self {
        let first = parts.clone().next();
        let bands = 0..first.map_or(0, |part| part.bands.len());
        let powers = factors.iter().zip(parts.clone()).map(|(factor, part)| *factor * part.powers);
        Self {
            group: first.and_then(|part| part.group.clone()),
            bands: bands
                .map(|band| Incident::together(factors, parts.clone().map(|part| &part.bands[band])))
                .collect(),
            powers: powers.fold(Powers::default(), |sum, part| sum + part),
            masked: None,
        }
    }
}

/// Irradiance of one band, by coefficients in the orthonormal bases, element by element, in W m⁻² times scene
/// length.
#[derive(Clone, Debug)]
pub struct Incident {
    /// h of the irradiance.
    pub irradiance: Vec<f64>,
    /// The part of h that comes straight from the emitters.
    pub direct: Vec<f64>,
    /// Relative residual of the linear system ([`Coefficients::residual`]).
    pub residual: f64,
}

impl From<Coefficients> for Incident {
    fn from(Coefficients { irradiance, direct, residual, .. }: Coefficients) -> Self {
        Self { irradiance, direct, residual }
    }
}

impl Incident {
    /// Σ f x over the `parts` x with their `factors` f; the residual is the largest of any part that is not
    /// dark.
    pub(super) fn together<'a>(factors: &[f64], parts: impl Iterator<Item = &'a Self> + Clone) -> Self {
        let sum = |of: fn(&Self) -> &Vec<f64>| {
            let mut sum: Vec<f64> = Vec::new();
            for (factor, part) in factors.iter().zip(parts.clone()) {
                sum.resize(of(part).len(), 0.0);
                sum.iter_mut().zip(of(part)).for_each(|(sum, x)| *sum += factor * x);
            }
            sum
        };
        let lit = factors.iter().zip(parts.clone()).filter(|(factor, _)| **factor != 0.0);
        Self {
            irradiance: sum(|part| &part.irradiance),
            direct: sum(|part| &part.direct),
            residual: lit.map(|(_, part)| part.residual).fold(0.0, f64::max),
        }
    }
}
