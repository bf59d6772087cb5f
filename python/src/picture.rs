//! Pictures as arrays.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use radiosity::geom::DVec3;
use radiosity::reading::pictures::raster::Raster;
use radiosity::reading::pictures::render::PictureRequest;
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::ReadMode;
use radiosity::request::picture::{SAMPLES, require_pixels, sized};
use radiosity::request::view::View;
use radiosity::request::{CheckRequest, MethodRequest, check_aim, ranges};
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
    pub(crate) camera: Camera,
    samples: u32,
    read: Option<ReadMode>,
    show: Quantity,
    pub(crate) check: CheckRequest,
    pub(crate) threads: usize,
}

impl Shot {
    /// The picture that `given` describes, through the given camera, that of the scene, or one that is chosen.
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
            Some(own) => own.of(scene)?,
            None => View::usual(scene).camera,
        };
        let shot = Self {
            samples: given
                .value::<ranges::Samples>("samples")?
                .map_or(SAMPLES, |samples| samples.count() as u32),
            read: method.read(given.value("read")?),
            show: given.value("show")?.unwrap_or_default(),
            check: given.fields()?,
            threads: given.value("threads")?.map_or(options.threads, ranges::Threads::count),
            camera: sized(camera, size),
        };
        let memory = given.parsed("memory")?.or(method.memory);
        given.finish("render")?;
        check_aim(shot.read, method).map_err(Trouble::from)?;
        shot.require_check(options)?;
        require_pixels(&shot.camera, scene, memory, Ranks::alone()).map_err(Trouble::from)?;
        Ok(shot)
    }

    /// Refuses a check of pixels that walks of light do not know.
    fn require_check(&self, options: &Options) -> Result<(), Trouble> {
        if self.check.audit.is_some() && self.show == Quantity::Irradiance {
            let cure = "leave show= out, or judge the solution: radiosity.audit(solution)";
            return Err(Trouble::new("audit= checks pictures of radiosity", cure));
        }
        Ok(self.check.check(options)?)
    }

    /// Source of the light that the picture shows.
    pub(crate) fn read(&self) -> ReadMode {
        self.read.unwrap_or(ReadMode::Gather)
    }

    /// Takes the picture of light that is read so.
    pub(crate) fn take(
        &self,
        read: ReadMode,
        light: &Light,
        visibility: &Visibility,
        progress: &Progress,
    ) -> Raster {
        let work = Work::alone().observed_by(progress);
        PictureRequest {
            solution: light,
            visibility,
            camera: &self.camera,
            samples: self.samples,
            read,
            shown: self.show,
            is_preview: false,
        }
        .picture(&work)
    }
}
