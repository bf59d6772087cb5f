//! The errors of a balance, made true by what a referee finds.
//!
//! Every error becomes κ times what it was, and that of a surface that is off by more than chance at least the
//! difference that was found ([`Checked`](radiosity_audit::Checked)), d of a flow, d/(4 σ T³ A) of a temperature. Heat
//! that surfaces of known temperature are found to gain or lose beyond their errors e is missed or met by others, since
//! flows sum to 0, as if the irradiance of all were off by
//!
//! ```text
//! Σ max(d − e, 0) / Σ ε A     W/m²,     ε A of the surfaces of known temperature .
//! ```
//!
//! Balances of kept transfers share a check: the errors of each surface grow by the factors by which they grew where it
//! was made, and by κ where there was none that could grow.

use radiosity_audit::{Effort, HeatFault, evenly};
use radiosity_scene::Scene;
use radiosity_work::Work;

use super::Heat;
use super::figures::{ErrorGrowth, SurfaceHeat, add_errors_of_irradiance, taking_up};
use super::judging::JudgedHeat;

impl Heat {
    /// Surfaces for a referee to look at, at most `most`: evenly those that can be judged.
    pub fn to_check(&self, scene: &Scene, most: usize) -> Vec<usize> {
        let all = self.judgeable(scene);
        let count = all.len();
        evenly(all.into_iter(), count, most, 0).collect()
    }

    /// Makes the errors of a balance of `scene` true by what a referee finds at these surfaces.
    ///
    /// # Errors
    /// Heat that cannot be read by walks: nothing is changed. Surfaces from which no walk ends: what is told follows
    /// from the others.
    pub fn check(
        &mut self,
        scene: &Scene,
        surfaces: &[usize],
        effort: &Effort,
        work: &Work<'_>,
    ) -> Result<(), HeatFault> {
        let run = JudgedHeat::of(scene, self, surfaces, effort, work)?;
        let read: Vec<usize> = run.surfaces.iter().map(|looked| looked.surface).collect();
        if !read.is_empty() {
            self.take(run);
        }
        let unread = surfaces.iter().filter(|surface| !read.contains(surface));
        let unread: Vec<String> = unread.map(|surface| scene.shown_name(*surface).to_owned()).collect();
        if unread.is_empty() { Ok(()) } else { Err(HeatFault::NoLevel { surfaces: unread }) }
    }

    /// Makes the errors of other figures of the same surfaces larger as a check has made those of this balance.
    pub fn check_others(&self, others: &mut [SurfaceHeat]) {
        for (own, growth) in others.iter_mut().zip(&self.growth) {
            own.temperature_error *= growth.temperature;
            own.flow_error *= growth.flow;
        }
    }

    /// Takes over what was found.
    fn take(&mut self, run: JudgedHeat) {
        let checked = run.checked;
        let before = self.surfaces.clone();
        for own in self.surfaces.iter_mut().filter(|own| own.has_level()) {
            own.flow_error = checked.told(own.flow_error, None);
            own.temperature_error = checked.told(own.temperature_error, None);
        }
        let mut missed = 0.0;
        for (reading, looked) in run.surfaces.iter().enumerate() {
            let difference = checked.told(0.0, Some(reading));
            if looked.is_flow {
                missed += (difference - checked.told(looked.told_watts, None)).max(0.0);
            }
            self.take_difference(looked.surface, difference);
        }
        self.miss(missed);
        let pairs = before.iter().zip(&self.surfaces);
        let growth = |(before, after)| ErrorGrowth::between(before, after, checked.error_factor);
        self.growth = pairs.map(growth).collect();
        self.checked = Some(checked);
    }

    /// Makes the errors of all surfaces at least those of so many watts that arrive elsewhere than they should.
    fn miss(&mut self, watts: f64) {
        let all = taking_up(&self.surfaces);
        if watts > 0.0 && all > 0.0 {
            let with_level = self.surfaces.iter_mut().filter(|own| own.has_level());
            with_level.for_each(|own| add_errors_of_irradiance(own, watts / all));
        }
    }

    /// Makes the error of a surface at least that of a difference in watts, and of the other side of a sheet too.
    fn take_difference(&mut self, surface: usize, watts: f64) {
        let own = &mut self.surfaces[surface];
        if own.is_temperature_known {
            own.flow_error = own.flow_error.max(watts);
            return;
        }
        let kelvin = if watts > 0.0 { own.kelvin_of(watts / own.area) } else { 0.0 };
        own.temperature_error = own.temperature_error.max(kelvin);
        if own.is_flow_known {
            return;
        }
        if let Some(other) = self.other_sides[surface] {
            let other = &mut self.surfaces[other];
            other.temperature_error = other.temperature_error.max(kelvin);
        }
    }
}
