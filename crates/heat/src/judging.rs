//! Heat judged by a referee: flows and temperatures that are printed, beside what walks find.
//!
//! A number in watts stands for each surface, so that all weigh alike: with its printed area A
//!
//! ```text
//! T known:   Q = q A ;        flux known, or that of a sheet:   σ T⁴ A .
//! ```

use radiosity_audit::{Checked, Effort, HeatEstimate, HeatFault, HeatReferee, Judged, Mean, Verdict};
use radiosity_scene::Scene;
use radiosity_work::Work;

use super::Heat;
use super::black_body::STEFAN_BOLTZMANN;
use super::figures::SurfaceHeat;

/// Rounding of walks, over what a surface sends out: a smaller error tells nothing. Measured: 2e-12 in a cube of one
/// temperature.
const ROUNDING: f64 = 1e-11;

/// Surfaces of a balance, judged.
#[derive(Clone, Debug)]
pub struct JudgedHeat {
    /// The surfaces.
    pub surfaces: Vec<JudgedSurface>,
    /// Surfaces of which walks found no number.
    pub unread: usize,
    /// Walks for each of them.
    pub walks: u64,
    /// Verdict of the referee on them.
    pub verdict: Verdict,
    /// Errors that follow from it and from those that the balance tells.
    pub checked: Checked,
}

/// A judged surface.
#[derive(Clone, Debug)]
pub struct JudgedSurface {
    /// Printed flow (W) or temperature (K).
    pub printed: f64,
    /// Whether that is its flow.
    pub is_flow: bool,
    /// The error that was told with it.
    pub told: f64,
    /// Found flow (W) or temperature (K).
    pub found: Mean,
    /// Both as flow or level times area (W); the class is its name.
    pub judged: Judged,
    /// The told error (W).
    pub(super) told_watts: f64,
    /// Its index in the scene.
    pub(super) surface: usize,
}

impl Heat {
    /// Surfaces of `scene` that can be judged: those of some area, and of sheets of one temperature one side.
    pub fn judgeable(&self, scene: &Scene) -> Vec<usize> {
        let is_sheet = |surface: usize| {
            !self.surfaces[surface].is_temperature_known && !self.surfaces[surface].is_flow_known
        };
        let is_second = |surface: usize| {
            let other = self.other_sides[surface].filter(|other| *other < surface);
            other.is_some_and(|other| is_sheet(surface) && is_sheet(other))
        };
        let all = 0..scene.surfaces.len();
        let can_be = |own: &SurfaceHeat| own.area > 0.0 && own.has_level();
        all.filter(|surface| can_be(&self.surfaces[*surface]) && !is_second(*surface)).collect()
    }
}

impl JudgedHeat {
    /// Judges these surfaces of the balance of a scene, by their indices.
    ///
    /// # Errors
    /// Heat that cannot be read by walks.
    pub fn of(
        scene: &Scene,
        heat: &Heat,
        surfaces: &[usize],
        effort: &Effort,
        work: &Work<'_>,
    ) -> Result<Self, HeatFault> {
        let effort = effort.of_surfaces();
        let estimates = HeatReferee::of(scene)?.estimates(surfaces, &effort, work);
        let all = estimates.iter().map(|found| JudgedSurface::of(&heat.surfaces[found.surface], found));
        let all: Vec<JudgedSurface> = all.filter(|own| own.judged.found().is_finite()).collect();
        let judged: Vec<Judged> = all.iter().map(|own| own.judged.clone()).collect();
        let own: Vec<f64> = all.iter().map(|own| own.told_watts).collect();
        let verdict = Verdict::of(&judged, Verdict::WORST);
        let checked = Checked::of(&judged, &own, &verdict, "surfaces");
        let unread = surfaces.len() - all.len();
        Ok(Self { surfaces: all, unread, walks: effort.walks(), verdict, checked })
    }
}

impl JudgedSurface {
    fn of(own: &SurfaceHeat, found: &HeatEstimate) -> Self {
        let rounding = ROUNDING * own.area * own.radiosity;
        let number = |printed, mean: Mean| {
            let mean = Mean { error: mean.error.max(rounding), ..mean };
            let judged = Judged::of_number(&own.name, printed, mean, found.rays);
            Judged { size: own.absorbing_area(), ..judged }
        };
        if own.is_temperature_known {
            Self {
                printed: own.flow,
                is_flow: true,
                told: own.flow_error,
                found: found.flow,
                judged: number(own.flow, found.flow),
                told_watts: own.flow_error,
                surface: found.surface,
            }
        } else {
            let watts = STEFAN_BOLTZMANN * own.area;
            let level = Mean { value: found.level.value * own.area, error: found.level.error * own.area };
            Self {
                printed: own.temperature,
                is_flow: false,
                told: own.temperature_error,
                found: found.temperature,
                judged: number(watts * own.temperature.powi(4), level),
                told_watts: 4.0 * watts * own.temperature.powi(3) * own.temperature_error,
                surface: found.surface,
            }
        }
    }
}
