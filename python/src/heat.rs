//! Balances of radiant heat.

use numpy::PyArrayDyn;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use radiosity::audit::HeatFault;
use radiosity::heat as library;
use radiosity::heat::SurfaceHeat;
use radiosity::heat::remarks::{adiabatic_backs, idle_order, light_without_heat, without_level};
use radiosity::heat::remarks::{corrected, heat_unchecked, heat_underestimated, no_error_of_cut};
use radiosity::kernel::WorstError;
use radiosity::reading::accuracy_warning::missed;
use radiosity::request::{CheckRequest, HeatRequest, HeatSweep, SweptHeat, TransferRequest};
use radiosity::scene::HeatSetting;
use radiosity::work::Work;
use radiosity::work::ranks::Ranks;

use crate::arguments::Arguments;
use crate::arrays::array;
use crate::checked;
use crate::error::{Trouble, warn};
use crate::scene::{Scene, remarks};
use crate::transfers::keeping;
use crate::work::work;

/// The balance of heat of a scene.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct Heat {
    heat: library::Heat,
    remarks: Vec<String>,
}

/// The balance of heat of a scene.
#[pyfunction]
pub(crate) fn heat_of(
    py: Python<'_>,
    scene: &Scene,
    given: &Bound<'_, PyDict>,
    observer: Option<Bound<'_, PyAny>>,
) -> PyResult<Heat> {
    let mut given = Arguments::of(given)?;
    let transfers: TransferRequest = given.fields()?;
    let conductances = given.flag("conductances")?;
    let request: HeatRequest = given.fields()?;
    let check: CheckRequest = given.fields()?;
    let ranks = keeping(&mut given, &scene.scene)?;
    given.finish("heat")?;
    let options = request.options(&transfers, conductances, Ranks::alone()).map_err(Trouble::from)?;
    let (heat, unchecked) = work(py, observer.as_ref(), |progress| {
        let work = Work::among(&ranks).observed_by(progress);
        let mut heat = library::Heat::of(&scene.scene, &options, &work)?;
        let checked = || check.check_heat(&mut heat, &scene.scene, options.options.shadows, &work);
        let checked = options.options.in_threads(work.ranks, checked)?;
        Ok::<_, library::HeatError>((heat, checked.err()))
    })?;
    warn_of(py, &heat, request.asked_order())?;
    Ok(Heat::of(heat, scene, unchecked.as_ref()))
}

/// The balances of a scene for some values of a quantity of heat, such as `panel.emissivity`.
#[pyfunction]
pub(crate) fn heats_of(
    py: Python<'_>,
    scene: &Scene,
    quantity: &str,
    values: Vec<f64>,
    given: &Bound<'_, PyDict>,
    observer: Option<Bound<'_, PyAny>>,
) -> PyResult<Vec<Heat>> {
    let mut given = Arguments::of(given)?;
    let transfers: TransferRequest = given.fields()?;
    let request: HeatRequest = given.fields()?;
    let check: CheckRequest = given.fields()?;
    let ranks = keeping(&mut given, &scene.scene)?;
    given.finish("heat_sweep")?;
    let sweep = HeatSweep::new(HeatSetting::named(quantity).map_err(Trouble::from)?, values);
    if sweep.values().is_empty() {
        return Ok(Vec::new());
    }
    let options = request.options(&transfers, false, Ranks::alone()).map_err(Trouble::from)?.options;
    let mut swept: SweptHeat<library::Heat> = work(py, observer.as_ref(), |progress| {
        sweep.balances(&scene.scene, &options, &check, &Work::among(&ranks).observed_by(progress))
    })?;
    warn_of(py, &swept.largest, request.asked_order())?;
    let unchecked = swept.unchecked.take();
    Ok(swept.into_balances().into_iter().map(|heat| Heat::of(heat, scene, unchecked.as_ref())).collect())
}

/// Warns where a balance may be off, or has another order than was asked for.
fn warn_of(py: Python<'_>, heat: &library::Heat, asked_order: Option<usize>) -> PyResult<()> {
    if let Some(worst) = heat.outcome.worst_error.filter(WorstError::is_real) {
        let surface = |element: usize| heat.outcome.solution.elements().list()[element].surface;
        warn(py, &missed(&worst, worst.pair.map(|element| heat.surfaces[surface(element)].name.as_str())))?;
    }
    let underestimated = heat.checked.as_ref().and_then(|own| heat_underestimated(own, &heat.outcome));
    let no_error = (!heat.is_cut).then(|| no_error_of_cut(&heat.outcome));
    let warnings = [idle_order(&heat.outcome, asked_order), no_error, underestimated];
    warnings.into_iter().flatten().try_for_each(|warning| warn(py, &warning))
}

impl Heat {
    /// A balance of `scene`, which no referee may have been able to read.
    fn of(heat: library::Heat, scene: &Scene, unchecked: Option<&HeatFault>) -> Self {
        let moved = heat.moved.map(corrected);
        let backs = adiabatic_backs(&heat.usual_backs(&scene.scene));
        let remarks = remarks(&scene.scene)
            .into_iter()
            .chain(light_without_heat(&scene.scene))
            .chain(backs)
            .chain(without_level(&heat.without_level))
            .chain(moved)
            .chain(unchecked.map(heat_unchecked))
            .collect();
        Self { heat, remarks }
    }

    fn of_surfaces<'py>(&self, py: Python<'py>, of: fn(&SurfaceHeat) -> f64) -> Bound<'py, PyArrayDyn<f64>> {
        array(py, &[self.heat.surfaces.len()], self.heat.surfaces.iter().map(of).collect())
    }
}

#[pymethods]
impl Heat {
    #[getter]
    fn names(&self) -> Vec<String> {
        self.heat.surfaces.iter().map(|own| own.name.clone()).collect()
    }

    #[getter]
    fn areas<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.of_surfaces(py, |own| own.area)
    }

    /// Emissivity of each surface: an array (n,), not a number where it is not known.
    #[getter]
    fn emissivity<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.of_surfaces(py, |own| own.emissivity.unwrap_or(f64::NAN))
    }

    #[getter]
    fn temperature<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.of_surfaces(py, |own| own.temperature)
    }

    #[getter]
    fn temperature_error<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.of_surfaces(py, |own| own.temperature_error)
    }

    #[getter]
    fn flux<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.of_surfaces(py, |own| own.flux)
    }

    #[getter]
    fn power<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.of_surfaces(py, |own| own.flow)
    }

    #[getter]
    fn power_error<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.of_surfaces(py, |own| own.flow_error)
    }

    #[getter]
    fn radiosity<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.of_surfaces(py, |own| own.radiosity)
    }

    #[getter]
    fn irradiance<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.of_surfaces(py, |own| own.irradiance)
    }

    #[getter]
    fn lost(&self) -> f64 {
        self.heat.lost
    }

    #[getter]
    fn is_closed(&self) -> bool {
        self.heat.is_closed()
    }

    /// JSON of what path tracing found; None where it cannot read the surfaces.
    #[getter]
    fn checked(&self) -> Option<String> {
        checked::json(self.heat.checked.as_ref())
    }

    /// Remarks on the reading of the scene, and on the correction of the transfers.
    #[getter]
    fn remarks(&self) -> Vec<String> {
        self.remarks.clone()
    }

    /// Conductances between the surfaces (length²): an array (n, n), if they were asked for.
    #[getter]
    fn conductances<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArrayDyn<f64>>> {
        let rows = &self.heat.conductances.as_ref()?.rows;
        Some(array(py, &[rows.len(), rows.len()], rows.iter().flatten().copied().collect()))
    }

    /// Conductances to the surroundings (length²): an array (n,), if they were asked for.
    #[getter]
    fn surroundings<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArrayDyn<f64>>> {
        let lost = &self.heat.conductances.as_ref()?.lost;
        Some(array(py, &[lost.len()], lost.clone()))
    }
}
