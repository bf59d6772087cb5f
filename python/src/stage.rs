//! Stages: scenes whose movers are placed by a program, frame after frame.

use std::sync::{Mutex, MutexGuard};

use pyo3::prelude::*;
use pyo3::types::PyDict;
use radiosity::geom::{DQuat, DVec3};
use radiosity::reading::accuracy_warning::missed;
use radiosity::request::{MethodRequest, require_all_light};
use radiosity::scene::Pose;
use radiosity::solve::animation::sequence_report::{SequenceReport, WorstTransfer};
use radiosity::solve::animation::stage;
use radiosity::solve::{LightMethod, Options, in_threads};
use radiosity::work::Work;
use radiosity::work::ranks::Ranks;
use radiosity::work::wording::{option, words};
use serde_json::json;

use crate::arguments::Arguments;
use crate::error::{Trouble, warn};
use crate::found::Found;
use crate::light::Light;
use crate::scene::Scene;
use crate::work::work;

/// A scene whose movers are placed by a program.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct Stage {
    /// Locked while a frame is found.
    stage: Mutex<stage::Stage>,
    method: MethodRequest,
    options: Options,
}

impl Stage {
    /// The stage, unless another thread waits for its frame: that one could not go on where this one waited
    /// with the lock of the interpreter.
    fn free(&self) -> Result<MutexGuard<'_, stage::Stage>, Trouble> {
        self.stage.try_lock().map_err(|_| {
            let cure = "wait for that thread, or give each thread a stage of its own";
            Trouble::new("the stage is finding a frame in another thread", cure)
        })
    }
}

/// Refuses methods that frames do not share.
fn check_method(method: &MethodRequest) -> Result<(), Trouble> {
    method.check()?;
    method.check_time_of_many()?;
    let cure = |name: &'static str| words("leave it out; a scene alone is solved with ") + option(name);
    require_all_light(method, "frames that follow each other hold all light", cure)?;
    let cure = "leave it out and choose quality=, or order= and eps=, which hold for all frames";
    if method.wanted_accuracy().is_some() {
        return Err(Trouble::new("accuracy=: elements that one frame needs are not those of another", cure));
    }
    if method.method == Some(LightMethod::Hierarchical) {
        let told = "method=\"hierarchical\": links of one frame are not those of another";
        return Err(Trouble::new(told, "leave it out; a scene alone is solved by links"));
    }
    Ok(())
}

#[pymethods]
impl Stage {
    /// The stage of a scene; frames are solved as `given`.
    #[new]
    fn new(py: Python<'_>, scene: &Scene, given: &Bound<'_, PyDict>) -> PyResult<Self> {
        let mut given = Arguments::of(given)?;
        let keep_partial = given.flag("keep_partial")?;
        let method: MethodRequest = given.fields()?;
        given.finish("Stage")?;
        check_method(&method)?;
        scene.scene.require_light().map_err(Trouble::from)?;
        let options = Options { keep_partial, ..method.options(Ranks::alone()) };
        let own = scene.scene.clone();
        let made = || in_threads(options.threads, || stage::Stage::new(own, &options));
        let stage = work(py, None, |_| -> Result<_, Trouble> { Ok(made()??) })?;
        Ok(Self { stage: Mutex::new(stage), method, options })
    }

    /// Names of the motions whose things can be moved and dimmed.
    #[getter]
    fn movers(&self) -> Result<Vec<String>, Trouble> {
        let stage = self.free()?;
        let movers = stage.scene().animation.iter().flat_map(|animation| &animation.movers);
        Ok(movers.map(|mover| mover.name.clone()).collect())
    }

    /// Puts a mover, from rest, turned by a quaternion (x, y, z, w) about `center`, then moved by `shift`.
    fn move_to(
        &self,
        mover: &str,
        center: [f64; 3],
        rotation: [f64; 4],
        shift: [f64; 3],
    ) -> Result<(), Trouble> {
        let [center, shift] = [center, shift].map(DVec3::from_array);
        let pose = Pose::rigid(center, DQuat::from_array(rotation), shift)?;
        Ok(self.free()?.move_to(mover, pose)?)
    }

    /// Lets a mover emit these parts of what it emits at rest, one for each band.
    fn emit(&self, mover: &str, factors: Vec<f64>) -> Result<(), Trouble> {
        Ok(self.free()?.emit(mover, &factors)?)
    }

    /// The light where all movers are now, the bound of what is left unsolved, and the error of rays.
    fn frame(&self, py: Python<'_>, observer: Option<Bound<'_, PyAny>>) -> PyResult<(Light, f64, f64)> {
        let mut stage = self.free()?;
        let (stage, threads) = (&mut *stage, self.options.threads);
        let before = stage.report().clone();
        let frame = work(py, observer.as_ref(), |progress| -> Result<_, Trouble> {
            let work = Work::alone().observed_by(progress);
            Ok(in_threads(threads, || stage.frame(&work))??)
        })?;
        let after = stage.report();
        if after.unconverged.moments > before.unconverged.moments {
            let message = words("the solver did not converge: the light of the frame is incomplete; raise ")
                + option("max-iterations")
                + " or take another "
                + option("solver");
            warn(py, &message)?;
        }
        if let Some(WorstTransfer { error, surfaces: [one, other] }) = &after.worst
            && after.missing > before.missing
        {
            warn(py, &missed(error, [one, other]))?;
        }
        let (unsolved, noise) = (frame.interpolated.unwrap_or(0.0), frame.rays);
        let found = Found::Frame(Box::new(frame));
        Ok((Light::new(found, self.options, self.method.clone()), unsolved, noise))
    }

    /// Cost and error of all frames so far, in JSON.
    #[getter]
    fn report(&self) -> Result<String, Trouble> {
        let stage = self.free()?;
        let SequenceReport { moments, rays, seconds, unconverged, missing, unsolved, noise, .. } =
            stage.report();
        let told = json!({
            "frames": moments,
            "rays": { "traced": rays.traced, "recalled": rays.recalled },
            "seconds": {
                "elements": seconds.elements.as_secs_f64(),
                "visibility": seconds.visibility.as_secs_f64(),
                "blocks": seconds.blocks.as_secs_f64(),
                "direct": seconds.direct.as_secs_f64(),
                "solve": seconds.solve.as_secs_f64(),
            },
            "unconverged": unconverged.moments,
            "residual": unconverged.residual,
            "missing": missing,
            "unsolved": unsolved,
            "noise": noise,
        });
        Ok(told.to_string())
    }
}
