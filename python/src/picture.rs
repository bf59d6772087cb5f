//! Pictures as arrays.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use radiosity::geom::DVec3;
use radiosity::reading::pictures::raster::Raster;
use radiosity::reading::pictures::render::{render, usual_read};
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::ReadMode;
use radiosity::request::picture::{SAMPLES, camera, pixels, require_pixels, sized};
use radiosity::request::{MethodRequest, check_aim, ranges};
use radiosity::scene::{Camera, Scene};
use radiosity::solve::Options;
use radiosity::solve::solution::Solution as Light;
use radiosity::visibility::Visibility;
use radiosity::work::Work;
use radiosity::work::ranks::Ranks;

use crate::arguments::Arguments;
use crate::error::Trouble;
use crate::progress::Progress;

/// A camera as it is given: eye, target, up, and the vertical angle of view in degrees.
#[derive(FromPyObject)]
pub(crate) struct Given([f64; 3], [f64; 3], [f64; 3], f64);

impl Given {
    /// The camera in the coordinates of a scene's surfaces.
    fn of(self, scene: &Scene) -> Result<Camera, Trouble> {
        let Self(eye, target, up, fov) = self;
        let [eye, target, up] = [eye, target, up].map(DVec3::from_array);
        let camera = Camera { up, fov, ..Camera::new(eye, target) }.checked()?;
        Ok(camera.about(scene.middle))
    }
}

/// A picture about to be taken.
pub(crate) struct Shot {
    camera: Camera,
    samples: u32,
    read: Option<ReadMode>,
    show: Quantity,
    pub(crate) threads: usize,
}

impl Shot {
    /// The picture that `given` describes, through the given camera or that of the scene.
    pub(crate) fn of(
        through: Option<Given>,
        given: &Bound<'_, PyDict>,
        scene: &Scene,
        options: &Options,
        method: &MethodRequest,
    ) -> PyResult<Self> {
        let mut given = Arguments::of(given)?;
        let size = given.pair::<ranges::Pixels>("size")?.map(|size| size.map(|pixels| pixels.count() as u32));
        let camera = match through {
            Some(own) => sized(own.of(scene)?, size),
            None => camera(size, scene).map_err(Trouble::from)?,
        };
        let shot = Self {
            samples: given
                .value::<ranges::Samples>("samples")?
                .map_or(SAMPLES, |samples| samples.count() as u32),
            read: method.read(given.value("read")?),
            show: given.value("show")?.unwrap_or_default(),
            threads: given.value("threads")?.map_or(options.threads, ranges::Threads::count),
            camera,
        };
        let memory = given.parsed("memory")?.or(method.memory);
        given.finish("render")?;
        check_aim(shot.read, method).map_err(Trouble::from)?;
        require_pixels(&shot.camera, scene, memory, Ranks::alone()).map_err(Trouble::from)?;
        Ok(shot)
    }

    /// Takes the picture.
    pub(crate) fn take(&self, light: &Light, visibility: &Visibility, progress: &Progress) -> Raster {
        let usual = || usual_read(light, visibility, pixels(&self.camera));
        let read = self.read.unwrap_or_else(usual);
        let work = Work::alone().observed_by(progress);
        render(light, visibility, &self.camera, self.samples, read, self.show, &work)
    }
}
