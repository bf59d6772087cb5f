//! Readings of planes of sensors.

use numpy::PyArrayDyn;
use pyo3::prelude::*;
use radiosity::geom::DVec3;
use radiosity::reading::plane_figures::{BandFigures, PlaneFigures};
use radiosity::reading::probe::ProbeReading;
use radiosity::reading::uniformity::Uniformity;
use radiosity::scene::{Scene, SensorPlane};
use radiosity::work::wording::Wording;

use crate::arrays::array;
use crate::checked;
use crate::error::Trouble;
use crate::told::Told;

/// A plane as it is given: by its name in the scene, or by a corner, two edges and the largest spacing along
/// each.
#[derive(FromPyObject)]
pub(crate) enum Given {
    Named(String),
    Typed([f64; 3], [f64; 3], [f64; 3], [f64; 2]),
}

impl Given {
    /// The plane in a scene.
    pub(crate) fn of(self, scene: &Scene) -> Result<SensorPlane, Trouble> {
        match self {
            Self::Named(name) => Ok(scene.plane_named(&name)?.clone()),
            Self::Typed(origin, first, second, spacing) => {
                let edges = [first, second].map(DVec3::from_array);
                Ok(SensorPlane::new("plane-1", DVec3::from_array(origin), edges, spacing)?)
            }
        }
    }
}

/// The irradiance on a plane of sensors.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct Plane {
    plane: SensorPlane,
    bands: usize,
    told: Told<ProbeReading>,
    figures: PlaneFigures,
}

impl Plane {
    pub(crate) fn new(plane: SensorPlane, scene: &Scene, told: Told<ProbeReading>) -> Self {
        let figures = PlaneFigures::of(&plane, &scene.bands, &told.readings, &told.errors);
        Self { plane, bands: scene.bands.len(), told, figures }
    }

    /// Warning of sensors that get no light, if there are any.
    pub(crate) fn warning(&self) -> Option<Wording> {
        self.figures.warning().map(|warning| warning.message)
    }

    fn of_bands(&self) -> Vec<Uniformity> {
        match &self.figures.figures {
            BandFigures::One(own) => vec![*own],
            BandFigures::Several { bands } => bands.iter().map(|band| band.figures).collect(),
        }
    }
}

#[pymethods]
impl Plane {
    #[getter]
    fn name(&self) -> &str {
        self.plane.name()
    }

    /// Irradiance: an array (rows, columns, bands), rows along the first edge.
    #[getter]
    fn values<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        let [rows, columns] = self.plane.counts();
        let numbers = self.told.readings.iter().flat_map(|reading| reading.irradiance.iter().copied());
        array(py, &[rows, columns, self.bands], numbers.collect())
    }

    /// The error that is told of each sensor: an array (rows, columns).
    #[getter]
    fn errors<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        array(py, &self.plane.counts(), self.told.errors.clone())
    }

    /// The error that is told of the mean.
    #[getter]
    fn mean_error(&self) -> Option<f64> {
        self.figures.error
    }

    /// JSON of what a referee found; None where it did not look.
    #[getter]
    fn checked(&self) -> Option<String> {
        checked::json(self.told.checked.as_ref())
    }

    /// Positions of the sensors: an array (rows, columns, 3).
    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        let [rows, columns] = self.plane.counts();
        let numbers = self.plane.sensors().flat_map(|point| point.to_array());
        array(py, &[rows, columns, 3], numbers.collect())
    }

    /// Unit normal along which the sensors receive.
    #[getter]
    fn normal(&self) -> [f64; 3] {
        self.plane.normal().to_array()
    }

    /// Mean, least and greatest irradiance, U0 and Ud of each band; U0 and Ud are not a number in the dark.
    #[getter]
    fn figures(&self) -> Vec<[f64; 5]> {
        let numbers = |own: Uniformity| {
            [own.mean, own.min, own.max, own.u0.unwrap_or(f64::NAN), own.ud.unwrap_or(f64::NAN)]
        };
        self.of_bands().into_iter().map(numbers).collect()
    }

    /// Number of sensors outside of the room or in solids, which the figures leave out.
    #[getter]
    fn left_out(&self) -> usize {
        self.figures.left_out
    }

    /// Number of the other sensors that get no light.
    #[getter]
    fn dark(&self) -> usize {
        self.figures.dark
    }
}
