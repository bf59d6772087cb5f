//! Readings and pictures of frames that are solved, all taken alike.

use radiosity_audit::Referee;
use radiosity_output::drawings::picture::Picture;
use radiosity_output::pictures::image::Image;
use radiosity_reading::checked_readings::{CheckedReadings, PrintedReading};
use radiosity_reading::exposure::Exposure;
use radiosity_reading::own_error::OwnError;
use radiosity_reading::pictures::film::{Film, FilmFrame};
use radiosity_reading::pictures::printed_pixels::{PrintedPixels, settings_of_pictures};
use radiosity_reading::pictures::raster::Raster;
use radiosity_reading::pictures::render::white_balance;
use radiosity_reading::reader::ReadMode;
use radiosity_request::CheckRequest;
use radiosity_request::picture::sized;
use radiosity_request::view::View;
use radiosity_scene::{Camera, Scene};
use radiosity_solve::Options;
use radiosity_solve::animation::frame::Frame;
use radiosity_work::{Stage, Work};

use super::frame_files::FrameFiles;
use super::readings::Readings;
use crate::error::CliError;
use crate::exposure::EXPOSURE;

/// Quantity that pictures show.
pub(super) const RADIOSITY: &str = "radiosity";

/// Maker of readings at points and of pictures of frames.
pub(super) struct Shutter<'a> {
    /// Pixels across and down, where they are not those of the camera.
    pub size: Option<[u32; 2]>,
    /// Camera rays along each side of a pixel.
    pub samples: u32,
    /// Source of the light of pictures.
    pub read: ReadMode,
    /// Whether pictures that are there already stay.
    pub resumes: bool,
    /// Work that the check is worth.
    pub check: &'a CheckRequest,
    /// Options that the frames are solved with.
    pub asked: &'a Options,
    /// Number of the frame that is checked.
    pub judged: usize,
    /// The findings of that: in its readings, or, where it has none, in its picture.
    pub found: Option<CheckedReadings>,
    pub readings: Option<Readings>,
    pub files: Option<FrameFiles>,
    /// The camera of all pictures, where they are not taken through those of the frames.
    pub view: Option<Camera>,
    /// Exposure of all pictures; that of the first picture unless told.
    pub exposure: Option<Exposure>,
    /// The work, whose observer hears of its stages.
    pub work: Work<'a>,
}

/// A frame that is solved.
pub(super) struct SolvedFrame {
    /// Its number.
    pub number: usize,
    /// Its light.
    pub frame: Frame,
}

impl<'a> Shutter<'a> {
    /// The film of a scene, of which this is the first frame.
    pub(super) fn film(&self, scene: &'a Scene, first: &Frame) -> Film<'a> {
        Film::new(scene, first, self.read, self.samples)
    }

    /// Whether anything of a frame is wanted, the first of all if it `is_first`.
    pub(super) fn wants(&self, number: usize, is_first: bool) -> bool {
        self.readings.is_some() || self.wants_picture(number, is_first)
    }

    /// Whether a picture of a frame is to be taken: where a run that is resumed has not made it, or the first one
    /// exposes all others.
    fn wants_picture(&self, number: usize, is_first: bool) -> bool {
        self.files.is_some() && (!self.has(number) || (is_first && self.exposure.is_none()))
    }

    /// Whether the picture of a frame was made by a run that is resumed.
    fn has(&self, number: usize) -> bool {
        self.resumes && self.files.as_ref().is_some_and(|files| files.has(number, self.work.ranks))
    }

    /// A frame as a film shows it.
    pub(super) fn shown<'b>(&self, own: &'b SolvedFrame, is_wanted: bool) -> FilmFrame<'b> {
        let camera = self.camera(&own.frame.scene);
        FilmFrame { number: own.number, frame: &own.frame, camera, is_wanted }
    }

    /// Reads the frames of a stretch that are `wanted` and takes their pictures; the first of all exposes all others.
    pub(super) fn record(
        &mut self,
        solved: &[SolvedFrame],
        wanted: &[usize],
        film: Option<&mut Film>,
        first: usize,
        made: &mut dyn FnMut(),
    ) -> Result<(), CliError> {
        for own in solved.iter().filter(|own| wanted.contains(&own.number)) {
            self.take_readings(own)?;
        }
        let Some(film) = film else {
            wanted.iter().for_each(|_| made());
            return Ok(());
        };
        let is_wanted =
            |number: usize| wanted.contains(&number) && self.wants_picture(number, number == first);
        let shown: Vec<FilmFrame> = solved.iter().map(|own| self.shown(own, is_wanted(own.number))).collect();
        let work = self.work;
        film.pictures(&shown, &work, |own, raster| {
            let written = self.keep(own, &raster);
            made();
            written
        })
    }

    /// Reads the points in a frame.
    fn take_readings(&mut self, own: &SolvedFrame) -> Result<(), CliError> {
        let Some(readings) = &mut self.readings else { return Ok(()) };
        readings.read(own.number, &own.frame, self.asked, &self.work)?;
        if let Some(readings) = self.readings.as_ref().filter(|_| own.number == self.judged) {
            let printed = |point: usize| readings.printed(point, &own.frame);
            self.found = self.checked(&own.frame, readings.count(), printed);
        }
        Ok(())
    }

    /// Keeps the picture of a frame, unless it is there.
    fn keep(&mut self, own: &FilmFrame, raster: &Raster) -> Result<(), CliError> {
        if own.number == self.judged && self.readings.is_none() {
            self.found = self.check_picture(own, raster);
        }
        let is_there = self.has(own.number);
        let Some(mut files) = self.files.take() else { return Ok(()) };
        let (frame, ranks) = (own.frame, self.work.ranks);
        let mut develop = || self.developed(raster, frame);
        match is_there {
            true => drop(develop()),
            false => files.add(own.number, raster, [RADIOSITY, &frame.scene.unit], develop, ranks)?,
        }
        self.files = Some(files);
        Ok(())
    }

    /// The check of `count` numbers of a frame that `printed` gives; None where a referee does not know such
    /// light.
    fn checked(
        &self,
        frame: &Frame,
        count: usize,
        printed: impl Fn(usize) -> Option<PrintedReading>,
    ) -> Option<CheckedReadings> {
        // Frames keep no counts of their work: it is the least effort, unless told otherwise.
        let effort = self.check.of_light(0.0, count, &frame.scene, self.asked)?;
        let judge = || {
            let referee = Referee::of_light(&frame.scene);
            CheckedReadings::of(&referee, count, printed, &effort, &self.work)
        };
        let found = self.work.during(Stage::Referee, judge);
        (!found.judged.is_empty()).then_some(found)
    }

    /// The check of a picture of a frame.
    fn check_picture(&self, own: &FilmFrame, raster: &Raster) -> Option<CheckedReadings> {
        let (frame, camera) = (own.frame, &own.camera);
        let error = OwnError::of_frame(frame, self.asked, &settings_of_pictures(self.read));
        let pixels = PrintedPixels::of(raster, camera, &frame.scene, &frame.visibility, error);
        self.checked(frame, pixels.count(), |number| pixels.reading(number))
    }

    /// The camera of a frame: its own, unless there is one view of all.
    fn camera(&self, scene: &Scene) -> Camera {
        let camera = self.view.clone().unwrap_or_else(|| View::usual(scene).camera);
        sized(camera, self.size)
    }

    /// The picture of a frame in colours.
    fn developed(&mut self, raster: &Raster, frame: &Frame) -> Picture {
        let image = Image::new(raster, white_balance(&frame.solution));
        let exposure = *self.exposure.get_or_insert_with(|| image.automatic_exposure());
        image.exposed(exposure).with_remark(EXPOSURE, exposure.told(RADIOSITY, &frame.scene.unit))
    }
}
