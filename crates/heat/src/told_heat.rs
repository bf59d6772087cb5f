//! The figures of a balance that files tell, without its light.

use radiosity_audit::Checked;
use serde::Serialize;

use super::Heat;
use super::figures::SurfaceHeat;

/// The figures of a balance of heat that files tell.
#[derive(Clone, Debug, Serialize)]
pub struct ToldHeat {
    surfaces: Vec<SurfaceHeat>,
    lost: f64,
    residual: f64,
    solver: &'static str,
    iterations: usize,
    closure_max: f64,
    accuracy_reached: f64,
    #[serde(flatten)]
    checked: Option<Checked>,
}

impl ToldHeat {
    /// The figures of each surface.
    pub fn surfaces(&self) -> &[SurfaceHeat] {
        &self.surfaces
    }
}

impl From<&Heat> for ToldHeat {
    fn from(heat: &Heat) -> Self {
        Self {
            surfaces: heat.surfaces.clone(),
            lost: heat.lost,
            residual: heat.outcome.residual,
            solver: heat.outcome.solver,
            iterations: heat.outcome.iterations,
            closure_max: heat.outcome.checks.closure_max,
            accuracy_reached: heat.outcome.accuracy_reached,
            checked: heat.checked.clone(),
        }
    }
}

impl From<Heat> for ToldHeat {
    fn from(heat: Heat) -> Self {
        Self::from(&heat)
    }
}

impl AsMut<[SurfaceHeat]> for ToldHeat {
    fn as_mut(&mut self) -> &mut [SurfaceHeat] {
        &mut self.surfaces
    }
}

impl AsMut<[SurfaceHeat]> for Heat {
    fn as_mut(&mut self) -> &mut [SurfaceHeat] {
        &mut self.surfaces
    }
}
