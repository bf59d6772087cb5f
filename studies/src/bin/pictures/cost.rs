//! Seconds of pictures, told before and spent.

use std::error::Error;
use std::sync::Mutex;

use cpu_time::ProcessTime;

use radiosity::reading::pictures::film::{Film, FilmFrame};
use radiosity::reading::pictures::render::PictureRequest;
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::ReadMode;
use radiosity::scene::{Camera, Scene};
use radiosity::solve::Options;
use radiosity::solve::animation::follower::{FollowMode, Follower};
use radiosity::solve::animation::frame::Frame;
use radiosity::work::{Progress, Stage};
use radiosity::{Solved, Work};

/// Samples along each side of a pixel.
const SAMPLES: u32 = 3;

/// Seconds of the processor of a picture, or of a film.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cost {
    /// Pixels of all frames.
    pub(crate) pixels: f64,
    pub(crate) solve: f64,
    /// The forecast and the pictures.
    pub(crate) picture: f64,
    pub(crate) forecast: f64,
    /// Places at which reflected light was gathered.
    pub(crate) gathers: usize,
}

/// Reports of the work on pictures.
#[derive(Default)]
struct Told {
    forecast: f64,
    gathers: usize,
}

impl Told {
    fn take(told: &Mutex<Self>, progress: Progress) {
        let mut told = told.lock().expect("no other panicked");
        match progress {
            Progress::Expected { stage: Stage::Picture, seconds } => told.forecast = seconds,
            Progress::Done { stage: Stage::GatheredPixels, done, of } if done == of => told.gathers += of,
            _ => {}
        }
    }
}

impl Cost {
    /// Solves a scene and takes its picture.
    pub(crate) fn of_picture(scene: &Scene, camera: &Camera) -> Result<Self, Box<dyn Error>> {
        let start = ProcessTime::now();
        let solved = Solved::new(scene.clone(), Options::default(), &Work::alone())?;
        let solve = start.elapsed().as_secs_f64();
        let told = Mutex::new(Told::default());
        let observer = |progress| Told::take(&told, progress);
        let work = Work::alone().observed_by(&observer);
        let (solution, visibility) = (&solved.outcome.solution, solved.visibility());
        let start = ProcessTime::now();
        let _ = PictureRequest {
            solution,
            visibility,
            camera,
            samples: SAMPLES,
            read: ReadMode::Gather,
            shown: Quantity::Radiosity,
            is_preview: false,
        }
        .picture(&work);
        let picture = start.elapsed().as_secs_f64();
        let Told { forecast, gathers } = told.into_inner().map_err(|_| "an observer panicked")?;
        Ok(Self { pixels: pixels(camera), solve, picture, forecast, gathers })
    }

    /// Solves the first frames of a scene that moves, one stretch of a film, and takes their pictures.
    pub(crate) fn of_film(scene: &Scene, camera: &Camera, frames: usize) -> Result<Self, Box<dyn Error>> {
        let options = Options::default();
        let mut follower = Follower::new(scene, &options, FollowMode::Selective, [0, frames - 1]);
        let start = ProcessTime::now();
        let solved = (0..frames).map(|number| follower.frame(number, &Work::alone()));
        let solved: Vec<Frame> = solved.collect::<Result<_, _>>()?;
        let solve = start.elapsed().as_secs_f64();
        let shown = |(number, frame)| FilmFrame { number, frame, camera: camera.clone(), is_wanted: true };
        let shown: Vec<FilmFrame> = solved.iter().enumerate().map(shown).collect();
        let told = Mutex::new(Told::default());
        let observer = |progress| Told::take(&told, progress);
        let start = ProcessTime::now();
        let mut film = Film::new(scene, &solved[0], ReadMode::Gather, SAMPLES);
        let forecast = frames as f64 * film.seconds(&shown[0], &Work::alone());
        film.pictures(&shown, &Work::alone().observed_by(&observer), |_, _| Ok::<(), Box<dyn Error>>(()))?;
        let picture = start.elapsed().as_secs_f64();
        let gathers = told.into_inner().map_err(|_| "an observer panicked")?.gathers;
        Ok(Self { pixels: frames as f64 * pixels(camera), solve, picture, forecast, gathers })
    }

    /// The power p of seconds ~ pixelsᵖ from another picture to this one.
    pub(crate) fn exponent(&self, before: &Self) -> f64 {
        (self.picture / before.picture).ln() / (self.pixels / before.pixels).ln()
    }
}

fn pixels(camera: &Camera) -> f64 {
    f64::from(camera.width) * f64::from(camera.height)
}
