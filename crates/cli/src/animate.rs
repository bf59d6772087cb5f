//! `radiosity animate`: the frames of a scene in which things move.

mod encoder;
mod frame_files;
mod frames;
mod readings;
mod summary;

use std::path::PathBuf;
use std::time::Instant;

use clap::{Args, ValueEnum};
use radiosity_audit::{Referee, evenly};
use radiosity_output::drawings::picture::Picture;
use radiosity_output::pictures::image::Image;
use radiosity_reading::checked_readings::{CheckedReadings, PrintedReading};
use radiosity_reading::exposure::Exposure;
use radiosity_reading::own_error::OwnError;
use radiosity_reading::pictures::printed_pixels::{PrintedPixels, settings_of_pictures};
use radiosity_reading::pictures::raster::Raster;
use radiosity_reading::pictures::render::{render, usual_read, white_balance};
use radiosity_reading::quantity::Quantity;
use radiosity_reading::rank_work::RanksWork;
use radiosity_reading::reader::ReadMode;
use radiosity_reading::report::underestimated;
use radiosity_request::picture::{SAMPLES, pixels, require_pixels, sized};
use radiosity_request::ranges::{Fraction, Positive};
use radiosity_request::require_all_light;
use radiosity_request::view::{View, ViewRequest};
use radiosity_request::{CheckRequest, MethodRequest, ReadRequest};
use radiosity_scene::{Camera, Scene};
use radiosity_solve::animation::follower::{FollowMode, Follower};
use radiosity_solve::animation::frame::Frame;
use radiosity_solve::{LightMethod, Options};
use radiosity_visibility::inspection::passages;
use radiosity_work::Work;
use radiosity_work::ranks::Ranks;
use radiosity_work::wording::{option, words};

use crate::{
    console,
    error::CliError,
    exposure::{EXPOSURE, TypedExposure},
    loaded::Loaded,
    numbers::{counts, number},
    options::SceneArg,
    points::Points,
    progress::Progress,
};
use frame_files::FrameFiles;
use frames::FrameRange;
use readings::Readings;

/// Solves the frames of a scene in which things move, and takes a picture of each
#[derive(Debug, Args)]
#[command(mut_arg("scene", |scene| scene.default_value("billiard")), mut_arg("frame", |frame| frame.hide(true)), after_help = "\
What moves is written in the scene: [[motion]], docs/scene.md. Frames are counted from 0. Where light changes smoothly along \
the path it is solved in some frames and interpolated between them, to --path-eps; elsewhere each frame follows from the one before, \
shadows and all: what has moved or shines otherwise is found anew, and the difference is solved for. --animation selective gives each \
frame as it is alone, to the bit.

Examples:
  radiosity animate billiard -o out/billiard-####.png
  radiosity animate billiard --frames 20..40 --size 320x240 -o swing.gif
  radiosity animate sliding-light --animation series --shadows off --transport exact -o light.mp4
  radiosity animate room.toml --probe desk.csv > lux-over-time.csv")]
pub(crate) struct AnimateArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// Files of the pictures, .png or .exr, in which #### stands for the number of the frame; or one film:
    /// .gif, or .mp4 or .webm, which ffmpeg makes [default: SCENE-####.png, and none with --probe]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// First and last frame, such as 0..99, or one [default: all]
    #[arg(long, value_name = "A..B")]
    frames: Option<FrameRange>,

    /// Points whose irradiance over time is printed as CSV, a row for each frame and point: a file as that of
    /// probe --points
    #[arg(long, value_name = "FILE.csv")]
    probe: Option<String>,

    /// Leaves alone the pictures that are there already, of a run that was stopped, and makes the others
    #[arg(long)]
    resume: bool,

    /// How frames follow each other
    #[arg(long = "animation", value_name = "WAY", default_value = "path")]
    way: Follow,

    /// Relative error that light interpolated along a path may have, twice that where single frames stray; by
    /// rays 0.3 of the error that these leave, if that is more. With series that of a block, relative to its
    /// largest entry
    #[arg(long, value_name = "E", default_value = "1e-4", value_parser = number::<Fraction>)]
    path_eps: f64,

    /// Pixels across and down [default: as the scene's camera says]
    #[arg(long, value_name = "WxH", value_parser = counts)]
    size: Option<[u32; 2]>,

    /// Camera rays along each side of a pixel: S × S in all [default: 3]
    #[arg(long, value_name = "S", value_parser = clap::value_parser!(u32).range(1..=64))]
    samples: Option<u32>,

    /// Exposure of all pictures: a factor on radiosities before they become colours, or exposure values such as
    /// -6.5EV, log₂ of it; or auto, that which render chooses for the first picture [default: auto]
    #[arg(long, value_name = "auto|X|nEV", allow_hyphen_values = true)]
    exposure: Option<TypedExposure>,

    /// Pictures a second of a film [default: those of the scene's time, if it has any; else 25]
    #[arg(long, value_name = "N", value_parser = number::<Positive>)]
    fps: Option<f64>,

    #[command(flatten)]
    read: ReadRequest,

    #[command(flatten)]
    view: ViewRequest,

    #[command(flatten)]
    method: MethodRequest,

    #[command(flatten)]
    check: CheckRequest,

    /// Prints neither progress nor a summary
    #[arg(short, long, help_heading = "Messages")]
    quiet: bool,
}

/// Quantity that pictures show.
const RADIOSITY: &str = "radiosity";

/// Most surfaces that pass through others of which a line tells.
const LISTED: usize = 4;

/// Way in which frames follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Follow {
    /// Each frame by itself, with nothing kept.
    Fresh,
    /// One frame after the other, each as it is alone, to the bit; blocks and rays that have not changed are
    /// kept.
    Selective,
    /// One frame after the other; what has changed is found anew, and the difference from the frame before
    /// is solved for.
    Incremental,
    /// Solved in some frames, interpolated between them where light is smooth; elsewhere as incremental.
    Path,
    /// As selective; blocks of flat things that are translated or turn about an axis, with nothing between,
    /// are sums of power series.
    Series,
}

impl AnimateArgs {
    fn way(&self) -> FollowMode {
        match self.way {
            Follow::Fresh => FollowMode::Fresh,
            Follow::Selective => FollowMode::Selective,
            Follow::Incremental => FollowMode::Incremental,
            Follow::Path => FollowMode::Path { tolerance: self.path_eps },
            Follow::Series => FollowMode::Series { tolerance: self.path_eps },
        }
    }

    /// Refuses methods that frames do not share.
    fn check_method(&self, asked: &Options) -> Result<(), CliError> {
        self.method.check()?;
        self.check.check(asked)?;
        let frames = "frames that follow each other hold all light";
        let cure = |name: &'static str| words("take single frames: render --frame K ") + option(name) + " …";
        require_all_light(&self.method, frames, cure)?;
        let refuse = |message: &str, cure: &str| Err(CliError::refused(message, cure));
        if self.method.wanted_accuracy().is_some() {
            return refuse(
                "--accuracy: elements that one frame needs are not those of another",
                "leave it out and choose --quality, or --order and --eps, which hold for all frames",
            );
        }
        if asked.method == LightMethod::Hierarchical {
            return refuse(
                "--method hierarchical: links of one frame are not those of another",
                "leave it out; solve --frame K solves a single frame by links",
            );
        }
        if asked.masks.is_some() && self.way == Follow::Path {
            return refuse(
                "light that goes through shadow masks cannot be interpolated along a path",
                "add --animation selective, or choose other --shadows",
            );
        }
        Ok(())
    }

    /// Whether pictures are asked for.
    fn has_pictures(&self) -> bool {
        self.output.is_some() || self.probe.is_none()
    }

    /// The files or the film of the pictures; None where none were asked for.
    fn film(&self, loaded: &Loaded, first: usize, ranks: &Ranks) -> Result<Option<FrameFiles>, CliError> {
        let output = match (&self.output, &self.probe) {
            (Some(output), _) => output.clone(),
            (None, Some(_)) => return Ok(None),
            (None, None) => format!("{}-####.png", loaded.scene().name).into(),
        };
        let rate = loaded.scene().animation.as_ref().map(|animation| animation.rate);
        let of_scene = rate.filter(|rate| *rate != 1.0);
        let film = FrameFiles::new(&output, self.fps, of_scene, first, loaded, ranks)?;
        if film.is_exr() && self.exposure.is_some() {
            return Err(CliError::refused(
                "--exposure: an .exr holds the values and nothing else",
                "leave it out, or choose files ending in .png",
            ));
        }
        let camera = sized(View::usual(loaded.scene()).camera, self.size);
        require_pixels(&camera, loaded.scene(), self.method.memory, ranks)?;
        Ok(Some(film))
    }
}

/// Maker of readings at points and of pictures of frames, all taken alike.
struct Shutter<'a> {
    args: &'a AnimateArgs,
    /// Options that the frames are solved with.
    asked: &'a Options,
    /// Number of the frame that is checked.
    judged: usize,
    /// The findings of that: in its readings, or, where it has none, in its picture.
    found: Option<CheckedReadings>,
    readings: Option<Readings>,
    film: Option<FrameFiles>,
    /// The camera of all pictures, where they are not taken through those of the frames.
    view: Option<Camera>,
    /// Exposure of all pictures; that of the first picture unless told.
    exposure: Option<Exposure>,
    /// Source of the light, as for the first picture unless told.
    read: Option<ReadMode>,
}

impl Shutter<'_> {
    /// Whether the picture of a frame was made by a run that is resumed.
    fn has(&self, number: usize, ranks: &Ranks) -> bool {
        self.args.resume && self.film.as_ref().is_some_and(|film| film.has(number, ranks))
    }

    /// Whether nothing says yet how pictures are exposed and read.
    fn is_unset(&self) -> bool {
        self.exposure.is_none() || self.read.is_none()
    }

    /// Reads a frame, and writes its picture unless that `is_there`; the first one exposes all others.
    fn record(
        &mut self,
        number: usize,
        frame: &Frame,
        is_first: bool,
        is_there: bool,
        ranks: &Ranks,
    ) -> Result<(), CliError> {
        if let Some(readings) = &mut self.readings {
            readings.read(number, frame, self.asked, ranks)?;
        }
        if let Some(readings) = self.readings.as_ref().filter(|_| number == self.judged) {
            let printed = |point: usize| readings.printed(point, frame);
            self.found = self.check(frame, readings.count(), printed, ranks);
        }
        let Some(mut film) = self.film.take() else { return Ok(()) };
        if is_first || !is_there {
            let raster = self.take(frame, ranks);
            if number == self.judged && self.readings.is_none() {
                self.found = self.check_picture(frame, &raster, ranks);
            }
            let mut develop = || self.developed(&raster, frame);
            match is_there {
                true => drop(develop()),
                false => film.add(number, &raster, [RADIOSITY, &frame.scene.unit], develop, ranks)?,
            }
        }
        self.film = Some(film);
        Ok(())
    }

    /// The check of `count` numbers of a frame that `printed` gives; None where a referee does not know such
    /// light.
    fn check(
        &self,
        frame: &Frame,
        count: usize,
        printed: impl Fn(usize) -> Option<PrintedReading>,
        ranks: &Ranks,
    ) -> Option<CheckedReadings> {
        // Frames keep no counts of their work: it is the least effort, unless told otherwise.
        let effort = self.args.check.of_light(0.0, count, &frame.scene, self.asked)?;
        let referee = Referee::of_light(&frame.scene);
        let found = CheckedReadings::of(&referee, count, printed, &effort, &Work::among(ranks));
        (!found.judged.is_empty()).then_some(found)
    }

    /// The check of a picture of a frame.
    fn check_picture(&self, frame: &Frame, raster: &Raster, ranks: &Ranks) -> Option<CheckedReadings> {
        let camera = self.camera(&frame.scene);
        let settings = settings_of_pictures(self.read.unwrap_or(ReadMode::Gather));
        let own = OwnError::of_frame(frame, self.asked, &settings);
        let pixels = PrintedPixels::of(raster, &camera, &frame.scene, &frame.visibility, own);
        self.check(frame, pixels.count(), |number| pixels.reading(number), ranks)
    }

    /// The camera of a frame: its own, unless there is one view of all.
    fn camera(&self, scene: &Scene) -> Camera {
        let camera = self.view.clone().unwrap_or_else(|| View::usual(scene).camera);
        sized(camera, self.args.size)
    }

    /// The picture of a frame.
    fn take(&mut self, frame: &Frame, ranks: &Ranks) -> Raster {
        let camera = self.camera(&frame.scene);
        let visibility = &frame.visibility;
        let usual = || usual_read(&frame.solution, visibility, pixels(&camera));
        let read = *self.read.get_or_insert_with(usual);
        let samples = self.args.samples.unwrap_or(SAMPLES);
        let (shown, work) = (Quantity::Radiosity, Work::among(ranks));
        render(&frame.solution, visibility, &camera, samples, read, shown, &work)
    }

    /// The picture of a frame in colours.
    fn developed(&mut self, raster: &Raster, frame: &Frame) -> Picture {
        let image = Image::new(raster, white_balance(&frame.solution));
        let exposure = *self.exposure.get_or_insert_with(|| image.automatic_exposure());
        image.exposed(exposure).with_remark(EXPOSURE, exposure.told(RADIOSITY, &frame.scene.unit))
    }
}

/// Solves the frames and writes what was asked for.
pub(crate) fn run(args: &AnimateArgs, loaded: Loaded, ranks: &Ranks) -> Result<(), CliError> {
    let begun = Instant::now();
    let scene = loaded.scene();
    let asked = args.method.options(ranks);
    args.check_method(&asked)?;
    let range = FrameRange::within(args.frames, scene)?;
    if !args.quiet {
        warn_of_passages(scene, range.ends(), ranks);
    }
    let (view, chosen) = match args.view.beside_own(scene)? {
        Some(View { camera, told }) => (Some(camera), told.filter(|_| args.has_pictures())),
        None => (None, None),
    };
    let points = args.probe.as_deref().map(|points| Points::load(points, ranks)).transpose()?;
    let film = args.film(&loaded, range.ends()[0], ranks)?;
    let (progress, deadline) = (Progress::new(args.quiet, ranks), args.method.deadline());
    let work = Work { ranks, observer: &progress, deadline: deadline.as_ref() };
    let mut follower = Follower::new(scene, &asked, args.way(), range.ends());
    let readings = points.map(|points| Readings::new(points, args.read.plain(&args.method)));
    let judged = evenly(range.numbers(), range.count(), 1, 0).next().unwrap_or_default();
    let (exposure, read) = (TypedExposure::fixed(args.exposure), args.read.read);
    let mut shutter =
        Shutter { args, asked: &asked, judged, found: None, readings, film, view, exposure, read };
    let mut made = 0;
    for (done, number) in range.numbers().enumerate() {
        progress.say_whole(standing(done, range.count(), made, begun));
        let (is_first, is_there) = (done == 0, shutter.has(number, ranks));
        if is_there && shutter.readings.is_none() && !(is_first && shutter.is_unset()) {
            continue;
        }
        let frame = follower.frame(number, &work)?;
        made += 1;
        asked.in_threads(ranks, || shutter.record(number, &frame, is_first, is_there, ranks))??;
    }
    let Shutter { film, readings, found, read, exposure, .. } = shutter;
    film.map_or(Ok(()), FrameFiles::finish)?;
    let read_error = readings.as_ref().and_then(Readings::error);
    readings.map_or(Ok(()), |readings| readings.write(&scene.bands, judged, found.as_ref(), ranks))?;
    let checked = found.map(|found| found.checked);
    drop(progress);
    if !args.quiet {
        let mut lines = summary::lines(&follower, made, begun.elapsed().as_secs_f64());
        lines.extend(RanksWork::so_far(ranks, asked.threads).map(|work| work.to_string()));
        lines.extend(chosen);
        lines.extend(exposure.map(|exposure| exposure.told(RADIOSITY, &scene.unit)));
        lines.extend(read_error.map(|error| error.to_string()));
        lines.extend(checked.as_ref().map(|checked| format!("frame {judged} {checked}")));
        let read = read.unwrap_or(ReadMode::Gather);
        let warning = checked.as_ref().and_then(|checked| underestimated(checked, read));
        lines.extend(warning.map(|warning| warning.to_string()));
        console::tell(&lines, ranks);
    }
    match checked {
        Some(checked) if args.scene.strict && checked.finds_more() => {
            Err(CliError::FoundMore { what: "the light is", told: checked.own_error })
        }
        _ => Ok(()),
    }
}

/// Tells which surfaces pass through others in these frames or between them.
fn warn_of_passages(scene: &Scene, frames: [usize; 2], ranks: &Ranks) {
    let passages = passages(scene, frames);
    let mut lines: Vec<String> = passages
        .iter()
        .take(LISTED)
        .map(|passage| format!("warning: {}", passage.warning().message))
        .collect();
    if let Some(rest) = passages.len().checked_sub(LISTED).filter(|rest| *rest > 0) {
        lines.push(format!("warning: {rest} more pairs do; radiosity check names them all"));
    }
    if !lines.is_empty() {
        console::tell(&lines, ranks);
    }
}

/// Progress of the frames in words: `done` of `count` are behind, of which so many were made.
fn standing(done: usize, count: usize, made: usize, begun: Instant) -> String {
    let rate = made as f64 / begun.elapsed().as_secs_f64();
    let rate = if made > 0 { format!(", {rate:.2} a second") } else { String::new() };
    format!("; frame {} of {count}{rate}", done + 1)
}
