//! `radiosity render`: a picture of a scene.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use radiosity::output::exr_file::write_exr;
use radiosity::output::render::{Read, render, white_balance};
use radiosity::output::wireframe::wireframe;
use radiosity::scene::{Camera, Scene};

use crate::cli::{
    error::CliError,
    options::{Counts, MethodArgs, ReportArgs, SceneArg},
    output_file::OutputFile,
    progress::Progress,
    run::{Loaded, Run},
    style::{Kind, StyleArgs},
};

/// Solves a scene and takes a picture through its camera
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  radiosity render cornell-box --order 5 --size 800x800 -o box.png")]
pub(crate) struct RenderArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// File of the picture: .png, or .exr for radiosities in W/m² as they are [default: SCENE.png]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    /// Pixels across and down [default: as the scene's camera says]
    #[arg(long, value_name = "WxH")]
    pub(crate) size: Option<Counts>,

    /// Camera rays along each side of a pixel: S × S in all
    #[arg(long, value_name = "S", default_value = "3", value_parser = clap::value_parser!(u32).range(1..=64))]
    pub(crate) samples: u32,

    /// What the picture is read from
    #[arg(long, value_name = "MODE", default_value = "direct")]
    pub(crate) read: ReadMode,

    #[command(flatten)]
    pub(crate) style: StyleArgs,

    #[command(flatten)]
    pub(crate) method: MethodArgs,

    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

/// `--read` of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ReadMode {
    /// The polynomials of the elements alone
    Basis,
    /// Direct light and its shadows exact at every point, the rest from the polynomials
    Direct,
}

/// Solves the scene and writes a picture.
pub(crate) fn run(args: &RenderArgs, loaded: Loaded) -> Result<(), CliError> {
    let path = args.output.clone().unwrap_or_else(|| format!("{}.png", loaded.scene.name).into());
    let kind = args.style.kind(&path)?;
    let output = OutputFile::reserve(&path)?;
    let camera = camera(args, &loaded.scene)?;
    let style = args.style.prepare(&loaded.scene, &camera)?;
    let progress = Progress::new(args.report.quiet);
    let run = Run::solve(loaded, &args.method, &args.report, &progress)?;
    let visibility = run.solved.visibility();
    let read = match args.read {
        ReadMode::Basis => Read::Basis,
        ReadMode::Direct => Read::Direct,
    };
    let rows = |done, total| progress.show("picture", done, total);
    let solution = &run.solved.outcome.solution;
    let (raster, borders) = run.in_threads(|| {
        let raster = render(solution, &visibility, &camera, args.samples, read, &rows);
        let borders = || wireframe(solution.elements(), &visibility, &camera, args.samples);
        (raster, args.style.wireframe.then(borders))
    })?;
    let mut written = path.display().to_string();
    match kind {
        Kind::Exr => output.write(|writer| write_exr(&raster, writer))?,
        Kind::Png => {
            let (picture, figures) = style.picture(&raster, white_balance(solution), borders.as_deref())?;
            written += &figures;
            output.write(|writer| picture.write_png(writer))?;
        }
    }
    run.finish(progress, Some(&written))
}

fn camera(args: &RenderArgs, scene: &Scene) -> Result<Camera, CliError> {
    let no_camera = || CliError::NoCamera { origin: scene.origin.clone() };
    let camera = scene.camera.clone().ok_or_else(no_camera)?;
    Ok(match args.size {
        Some(Counts([width, height])) => Camera { width, height, ..camera },
        None => camera,
    })
}
