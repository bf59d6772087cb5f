//! Scenes solved: options of the method, and what an accuracy is wanted of.

use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use radiosity::reading::probe::Probe;
use radiosity::request::MethodRequest;
use radiosity::request::aim::{at_probes, of_picture};
use radiosity::scene;
use radiosity::solve::solved::Solved;
use radiosity::solve::studies::adaptation::{Aim, Goal};
use radiosity::solve::{Failure, Options};
use radiosity::work::ranks::Ranks;
use radiosity::work::{Deadline, Work};

use crate::arguments::Arguments;
use crate::arrays::probes;
use crate::error::Trouble;
use crate::requests;
use crate::scene::Scene;
use crate::solution::{ReportedSolution, Solution};
use crate::work::work;

/// Solves a scene. `aim` is what an accuracy is wanted of: "gathered", "solution", "picture", or "points"
/// with `sensors`.
#[pyfunction]
pub(crate) fn solution_of(
    py: Python<'_>,
    scene: &Scene,
    given: &Bound<'_, PyDict>,
    aim: Option<&str>,
    sensors: Option<(PyReadonlyArray2<'_, f64>, PyReadonlyArray2<'_, f64>)>,
    observer: Option<Bound<'_, PyAny>>,
) -> PyResult<Solution> {
    let mut given = Arguments::of(given)?;
    let keep_partial = given.flag("keep_partial")?;
    let mut method = requests::method(&mut given)?;
    given.finish("solve")?;
    let wanted = AimArgument::of(aim, sensors)?;
    method.aim = aim.is_some().then_some(wanted.aim());
    if method.aim.is_some() && method.wanted_accuracy().is_none() {
        let cure = "add accuracy=, such as accuracy=1e-2, or leave aim= out";
        return Err(Trouble::new("aim= does nothing without an accuracy that is wanted", cure).into());
    }
    method.check().map_err(Trouble::from)?;
    scene.scene.require_light().map_err(Trouble::from)?;
    let options = Options { keep_partial, ..method.options(Ranks::alone()) };
    // Shapes, patterns and what it was read from are shared; names and numbers of the surfaces are copied.
    let own = scene.scene.clone();
    let found = work(py, observer.as_ref(), |progress| -> Result<_, Trouble> {
        let deadline = method.deadline().map(|at| Deadline::at(Some(at)));
        let work = Work { deadline: deadline.as_ref(), ..Work::alone().observed_by(progress) };
        Ok(ReportedSolution::of(solved(own, options, wanted.goal(&method, &scene.scene)?, &work)?)?)
    })?;
    Solution::new(py, found, method, false)
}

fn solved(
    scene: scene::Scene,
    options: Options,
    goal: Option<Goal>,
    work: &Work<'_>,
) -> Result<Solved, Failure> {
    match goal {
        Some(goal) => Solved::to_accuracy(scene, &options, &goal, work),
        None => Solved::new(scene, options, work),
    }
}

/// Quantity that an accuracy is wanted of.
enum AimArgument {
    Gathered,
    Solution,
    Picture,
    At(Vec<Probe>),
}

impl AimArgument {
    fn of(
        aim: Option<&str>,
        sensors: Option<(PyReadonlyArray2<'_, f64>, PyReadonlyArray2<'_, f64>)>,
    ) -> Result<Self, Trouble> {
        match (aim.unwrap_or("gathered"), sensors) {
            ("points", Some((points, normals))) => Ok(Self::At(probes(&points, &normals)?)),
            ("gathered", _) => Ok(Self::Gathered),
            ("solution", _) => Ok(Self::Solution),
            ("picture", _) => Ok(Self::Picture),
            (other, _) => Err(Trouble::new(
                format!("aim={other:?} cannot be"),
                "expected gathered, solution, picture, (\"plane\", name) or (\"points\", points, normals)",
            )),
        }
    }

    fn aim(&self) -> Aim {
        match self {
            Self::Gathered => Aim::Gathered,
            Self::Solution => Aim::Solution,
            Self::Picture => Aim::Seen,
            Self::At(_) => Aim::Points,
        }
    }

    /// The goal in a scene, if an accuracy is wanted.
    fn goal(&self, method: &MethodRequest, scene: &scene::Scene) -> Result<Option<Goal>, Trouble> {
        let Some(accuracy) = method.wanted_accuracy() else { return Ok(None) };
        Ok(Some(match self {
            Self::Gathered => Goal::new(accuracy, Aim::Gathered),
            Self::Solution => Goal::new(accuracy, Aim::Solution),
            Self::Picture => of_picture(accuracy, scene)?,
            Self::At(probes) => at_probes(accuracy, probes, scene),
        }))
    }
}
