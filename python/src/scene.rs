//! Scenes, read from files or texts.

use std::collections::BTreeMap;

use numpy::PyArray2;
use numpy::ndarray::arr2;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use radiosity::geom::DVec3;
use radiosity::reading::probe::Probe;
use radiosity::request::SceneRequest;
use radiosity::request::ranges::{Finite, Length, Number};
use radiosity::scene;
use radiosity::scene::Notation;
use radiosity::work::ranks::Ranks;

use crate::arguments::Arguments;
use crate::error::Trouble;
use crate::tree;
use crate::work::work;

/// An array (n, 3).
type Rows<'py> = Bound<'py, PyArray2<f64>>;

/// A valid scene, which can be solved.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct Scene {
    pub(crate) scene: scene::Scene,
}

/// The scene in a file, or one that is built in; `settings` are its parameters, variables and light groups,
/// the other arguments those of `radiosity.load`.
#[pyfunction]
pub(crate) fn load(
    py: Python<'_>,
    source: String,
    settings: BTreeMap<String, f64>,
    given: &Bound<'_, PyDict>,
) -> PyResult<Scene> {
    let mut given = Arguments::of(given)?;
    let request = SceneRequest {
        source,
        settings: settings.into_iter().collect(),
        frame: given.value::<Number<Finite>>("frame")?.map(f64::from),
        tolerance: given.value::<Number<Length>>("tolerance_length")?.map(f64::from),
        strict: given.flag("strict")?,
        reach: radiosity::photometry::files::Reach::Inside,
        import: given.fields()?,
    };
    given.finish("load")?;
    Ok(Scene { scene: work(py, None, |_| request.load_lit(Ranks::alone()))? })
}

/// The scene in a text in TOML or JSON; `name` stands before messages. Files that it names are looked for in
/// the current folder and below.
#[pyfunction]
pub(crate) fn parse(text: &str, name: &str) -> Result<Scene, Trouble> {
    let source = scene::Source::new(name, text).with_files();
    Ok(Scene { scene: radiosity::language::read(&source)? })
}

/// The scene of these parts by the keys of scene files; `name` stands before messages. Files that they name
/// are looked for in the current folder.
#[pyfunction]
pub(crate) fn made(py: Python<'_>, parts: &Bound<'_, PyDict>, name: &str) -> Result<Scene, Trouble> {
    let tree = tree::tree(parts);
    let scene = py.detach(|| radiosity::language::read(&scene::Source::of_tree(name, tree)?.with_files()));
    Ok(Scene { scene: scene? })
}

/// The names of the built-in scenes with their parameters and the values these have unless set.
#[pyfunction]
pub(crate) fn builtins() -> BTreeMap<&'static str, BTreeMap<&'static str, f64>> {
    let parameters =
        |own: &'static radiosity::language::Builtin| own.parameters.iter().map(|one| (one.name, one.default));
    radiosity::language::builtins().iter().map(|own| (own.name, parameters(own).collect())).collect()
}

#[pymethods]
impl Scene {
    #[getter]
    fn name(&self) -> &str {
        &self.scene.name
    }

    #[getter]
    fn title(&self) -> Option<&str> {
        self.scene.title.as_deref()
    }

    #[getter]
    fn bands(&self) -> Vec<String> {
        self.scene.bands.clone()
    }

    #[getter]
    fn unit(&self) -> &str {
        &self.scene.unit
    }

    #[getter]
    fn surfaces(&self) -> Vec<String> {
        self.scene.surfaces.iter().map(|surface| surface.name.clone()).collect()
    }

    #[getter]
    fn planes(&self) -> Vec<String> {
        self.scene.planes.iter().map(|plane| plane.name().to_owned()).collect()
    }

    /// The factor of each light group.
    #[getter]
    fn light_groups(&self) -> BTreeMap<String, f64> {
        let groups = self.scene.light_groups().into_iter();
        groups.map(|group| (group.name.clone(), group.factor)).collect()
    }

    /// Remarks on the import and the repair of a file of another program, and on shapes that nearly meet.
    #[getter]
    fn remarks(&self) -> Vec<String> {
        remarks(&self.scene)
    }

    /// The sensors of a plane of the scene: points (n, 3) and normals (n, 3).
    fn sensors<'py>(&self, py: Python<'py>, name: &str) -> Result<(Rows<'py>, Rows<'py>), Trouble> {
        let sensors: Vec<Probe> = Probe::of_plane(self.scene.plane_named(name)?).collect();
        let rows = |of: fn(&Probe) -> DVec3| sensors.iter().map(|own| of(own).to_array()).collect::<Vec<_>>();
        let rows = |of| PyArray2::from_owned_array(py, arr2(&rows(of)));
        Ok((rows(|own| own.position), rows(|own| own.normal)))
    }

    /// Text of the scene in TOML.
    fn to_toml(&self) -> Result<String, Trouble> {
        Ok(radiosity::language::text(&self.scene, Notation::Toml)?)
    }
}

/// Remarks on the reading of a scene: its import, and shapes that nearly meet.
pub(crate) fn remarks(scene: &scene::Scene) -> Vec<String> {
    let imported = scene.imported().into_iter().flat_map(|imported| imported.lines());
    imported.chain(scene.fitted.line()).collect()
}
