//! Scenes solved: options of the method, and what an accuracy is wanted of.

use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use radiosity::request::aim::AccuracyOf;
use radiosity::request::{CheckRequest, MethodRequest};
use radiosity::scene;
use radiosity::solve::solved::Solved;
use radiosity::solve::studies::adaptation::Goal;
use radiosity::solve::{Failure, Options};
use radiosity::work::Work;
use radiosity::work::ranks::Ranks;

use crate::arguments::Arguments;
use crate::arrays::probes;
use crate::error::Trouble;
use crate::scene::Scene;
use crate::solution::{ReportedSolution, Solution};
use crate::transfers::keeping;
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
    let mut method: MethodRequest = given.fields()?;
    let check: CheckRequest = given.fields()?;
    let ranks = keeping(&mut given, &scene.scene)?;
    given.finish("solve")?;
    method.aim = aim.map(|aim| accuracy_of(aim, sensors.is_some())).transpose()?;
    if method.aim.is_some() && method.wanted_accuracy().is_none() {
        let cure = "add accuracy=, such as accuracy=1e-2, or leave aim= out";
        return Err(Trouble::new("aim= does nothing without an accuracy that is wanted", cure).into());
    }
    method.check().map_err(Trouble::from)?;
    scene.scene.require_light().map_err(Trouble::from)?;
    let options = Options { keep_partial, ..method.options(Ranks::alone()) };
    check.check(&options).map_err(Trouble::from)?;
    // Shapes, patterns and what it was read from are shared; names and numbers of the surfaces are copied.
    let own = scene.scene.clone();
    let sensors = sensors.map(|(points, normals)| probes(&points, &normals)).transpose()?.unwrap_or_default();
    let of = method.aim.as_ref().unwrap_or(&AccuracyOf::Gathered);
    let goal = |accuracy| of.goal::<Trouble>(accuracy, &scene.scene, || Ok(sensors));
    let goal = method.wanted_accuracy().map(goal).transpose()?;
    let found = work(py, observer.as_ref(), |progress| -> Result<_, Trouble> {
        let deadline = method.deadline();
        let work = Work { deadline: deadline.as_ref(), ..Work::among(&ranks).observed_by(progress) };
        Ok(ReportedSolution::of(solved(own, options, goal.as_ref(), &work)?)?)
    })?;
    let solution = Solution::new(py, found, method, check, false)?;
    if check.audit.is_some() {
        solution.judged(py, observer.as_ref())?;
    }
    Ok(solution)
}

fn solved(
    scene: scene::Scene,
    options: Options,
    goal: Option<&Goal>,
    work: &Work<'_>,
) -> Result<Solved, Failure> {
    match goal {
        Some(goal) => Solved::to_accuracy(scene, &options, goal, work),
        None => Solved::new(scene, options, work),
    }
}

/// Light that an accuracy is wanted of, by its name; there are sensors where it is light at points.
fn accuracy_of(aim: &str, has_sensors: bool) -> Result<AccuracyOf, Trouble> {
    match (aim, has_sensors) {
        ("points", true) => Ok(AccuracyOf::Points(aim.to_owned())),
        ("gathered", _) => Ok(AccuracyOf::Gathered),
        ("solution", _) => Ok(AccuracyOf::Solution),
        ("picture", _) => Ok(AccuracyOf::Picture),
        (other, _) => Err(Trouble::new(
            format!("aim={other:?} cannot be"),
            "expected gathered, solution, picture, (\"plane\", name) or (\"points\", points, normals)",
        )),
    }
}
