//! Scenes: read from files or texts, and solved.

use std::collections::BTreeMap;

use pyo3::prelude::*;
use radiosity::solved::Solved;
use radiosity::{Options, scene};

use crate::error::Trouble;
use crate::solution::Solution;
use crate::work::work;

/// A valid scene.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct Scene {
    pub(crate) scene: scene::Scene,
}

/// The scene in a file, or one that is built in; `settings` are its variables, parameters and light groups.
#[pyfunction]
pub(crate) fn load(source: &str, settings: BTreeMap<String, f64>) -> Result<Scene, Trouble> {
    let settings: Vec<(&str, f64)> = settings.iter().map(|(name, value)| (name.as_str(), *value)).collect();
    Ok(Scene { scene: scene::Scene::load_with(source, &settings)? })
}

/// The scene in a text in TOML or JSON; `name` stands before messages.
#[pyfunction]
pub(crate) fn parse(text: &str, name: &str) -> Result<Scene, Trouble> {
    Ok(Scene { scene: scene::Scene::parse(&scene::Source::new(name, text))? })
}

/// The names of the built-in scenes.
#[pyfunction]
pub(crate) fn builtins() -> Vec<&'static str> {
    scene::Scene::builtin_names().collect()
}

#[pymethods]
impl Scene {
    /// Its name.
    #[getter]
    fn name(&self) -> &str {
        &self.scene.name
    }

    /// Names of its bands.
    #[getter]
    fn bands(&self) -> Vec<String> {
        self.scene.bands.clone()
    }

    /// Unit of exitance, irradiance and radiosity.
    #[getter]
    fn unit(&self) -> &str {
        &self.scene.unit
    }

    /// Names of its surfaces.
    #[getter]
    fn surfaces(&self) -> Vec<String> {
        self.scene.surfaces.iter().map(|surface| surface.name.clone()).collect()
    }

    /// Solves it.
    fn solve(&self, py: Python<'_>, observer: Option<Bound<'_, PyAny>>) -> PyResult<Solution> {
        let scene = self.scene.clone();
        let bands = scene.bands.len();
        let solved = work(py, observer.as_ref(), |progress| {
            Solved::new(scene, Options::default(), &|stage| progress.stage(stage, bands))
        })?;
        Ok(Solution { solved })
    }
}
