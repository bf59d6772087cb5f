//! `radiosity animate`: the frames of a scene in which things move.

mod refusal;
mod encoder;
mod apng;
mod frame_files;
mod frames;
mod readings;
mod shutter;
mod time_left;
mod shooting;
mod summary;

use std::path::PathBuf;
use std::time::Instant;

use clap::{Args, ValueEnum};
use radiosity_audit::evenly;
use radiosity_reading::rank_work::RanksWork;
use radiosity_reading::report::underestimated;
use radiosity_request::picture::{SAMPLES, require_pixels, sized};
use radiosity_request::ranges::{Fraction, Positive};
use radiosity_request::require_all_light;
use radiosity_request::view::{View, ViewRequest};
use radiosity_request::{CheckRequest, MethodRequest, ReadRequest};
use radiosity_scene::Scene;
use radiosity_solve::animation::follower::{FollowMode, Follower};
use radiosity_solve::{LightMethod, Options};
use radiosity_visibility::inspection::passages;
use radiosity_work::ranks::Ranks;
use radiosity_work::wording::{option, words};
use radiosity_work::{Observer, Progress as Event, Work};

use crate::{
    console,
    error::CliError,
    exposure::TypedExposure,
    loaded::{Loaded, outside},
    numbers::{counts, number},
    options::SceneArg,
    points::Points,
    progress::Progress,
};
use frame_files::FrameFiles;
use frames::FrameRange;
use readings::Readings;
use shooting::{Made, Shooting};
use shutter::{RADIOSITY, Shutter};

/// Solves the frames of a scene in which things move, and takes a picture of each
#[derive(Debug, Args)]
#[command(mut_arg("scene", |scene| scene.default_value("billiard")), mut_arg("frame", |frame| frame.hide(true)), after_help = "\
What moves is written in the scene: [[motion]], docs/scene.md. Frames are counted from 0. Where light changes smoothly along \
the path it is solved in some frames and interpolated between them, to --path-eps; elsewhere each frame follows from the one before, \
shadows and all: what has moved or shines otherwise is found anew, and the difference is solved for. --animation selective solves each \
frame as it is alone, to the bit.

Pictures share the light that is gathered, whatever --animation says: beside what moves, and where light changes in other ways than smoothly, it is gathered in each \
frame, elsewhere in every eighth and interpolated between; the summary tells the error that this makes. About how long all takes is told \
before the first picture.

Examples:
  radiosity animate billiard -o out/billiard-####.png
  radiosity animate billiard --frames 20..40 --size 320x240 -o swing.gif
  radiosity animate sliding-light --animation series --shadows off --transport exact -o light.mp4
  radiosity animate room.toml --probe desk.csv > lux-over-time.csv")]
pub(crate) struct AnimateArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// Files of the pictures, .png or .exr, in which #### stands for the number of the frame; or one film:
    /// .gif or .apng, or .mp4 or .webm, which ffmpeg makes [default: SCENE-####.png, and none with --probe]
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

    /// Camera rays along each side of a pixel, about: S² + 1 in all, on a square grid that is turned [default: 3]
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

/// Most surfaces that pass through others of which a line tells.
const LISTED: usize = 4;

/// Way in which frames follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Follow {
    /// Each frame is solved by itself, and nothing of the solution is kept.
    Fresh,
    /// One frame after the other, each with the solution that it has alone, to the bit; blocks and rays that have
    /// not changed are kept.
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
        self.method.check_time_of_many()?;
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
    fn files(&self, loaded: &Loaded, first: usize, ranks: &Ranks) -> Result<Option<FrameFiles>, CliError> {
        let output = match (&self.output, &self.probe) {
            (Some(output), _) => output.clone(),
            (None, Some(_)) => return Ok(None),
            (None, None) => format!("{}-####.png", loaded.scene().name).into(),
        };
        let rate = loaded.scene().animation.as_ref().map(|animation| animation.rate);
        let of_scene = rate.filter(|rate| *rate != 1.0);
        let files = FrameFiles::new(&output, self.fps, of_scene, first, loaded, ranks)?;
        if files.is_exr() && self.exposure.is_some() {
            return Err(CliError::refused(
                "--exposure: an .exr holds the values and nothing else",
                "leave it out, or choose files ending in .png",
            ));
        }
        let camera = sized(View::usual(loaded.scene()).camera, self.size);
        require_pixels(&camera, loaded.scene(), self.method.memory, ranks)?;
        Ok(Some(files))
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
    let files = args.files(&loaded, range.ends()[0], ranks)?;
    let progress = Progress::new(args.quiet, asked.threads, loaded.started, ranks);
    progress.begin_output();
    let work = Work::among(ranks).observed_by(&progress);
    let stages = |event| {
        if let Event::Expected { .. } | Event::Began { .. } | Event::Ended { .. } = event {
            progress.report(event);
        }
    };
    let follower = Follower::new(scene, &asked, args.way(), range.ends());
    let settings = args.read.plain(&args.method);
    let read = settings.read;
    let readings = points.map(|points| Readings::new(points, settings));
    let judged = evenly(range.numbers(), range.count(), 1, 0).next().unwrap_or_default();
    let exposure = TypedExposure::fixed(args.exposure);
    let shutter = Shutter {
        size: args.size,
        samples: args.samples.unwrap_or(SAMPLES),
        read,
        resumes: args.resume,
        check: &args.check,
        asked: &asked,
        judged,
        found: None,
        readings,
        files,
        view,
        exposure,
        work: Work::among(ranks).observed_by(&stages),
    };
    let shooting = Shooting::new(shutter, scene, follower, range, &progress, &work);
    let Made { shutter, follower, made, error } = shooting.shoot()?;
    let Shutter { files, readings, found, exposure, .. } = shutter;
    files.map_or(Ok(()), FrameFiles::finish)?;
    let read_error = readings.as_ref().and_then(Readings::error);
    readings.map_or(Ok(()), |readings| readings.write(&scene.bands, judged, found.as_ref(), ranks))?;
    let checked = found.map(|found| found.checked);
    progress.clear();
    if !args.quiet {
        let mut lines = summary::lines(&follower, made, begun.elapsed().as_secs_f64());
        lines.push(progress.stages());
        lines.extend(RanksWork::so_far(ranks, asked.threads).map(|work| work.to_string()));
        lines.extend(outside(scene));
        lines.extend(chosen);
        lines.extend(exposure.map(|exposure| exposure.told(RADIOSITY, &scene.unit)));
        lines.extend(error.told().map(|_| error.to_string()));
        lines.extend(read_error.map(|error| error.to_string()));
        lines.extend(checked.as_ref().map(|checked| format!("frame {judged} {checked}")));
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
