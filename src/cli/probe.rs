//! `radiosity probe`: irradiance at single points.

use std::io;
use std::path::Path;

use clap::Args;
use radiosity::output::probe::{ProbeFault, Reading, probe};
use radiosity::output::reader::Reader;
use radiosity::scene::Scene;
use radiosity::solved::Solved;
use serde::Serialize;

use crate::cli::{
    data::DataArgs,
    error::CliError,
    options::{MethodArgs, PARAMETER_OR_GROUP, ReportArgs, SCENE_OR_SOLUTION, SceneArg},
    output_file::OutputFile,
    points::{COLUMNS, Points, PointsError},
    progress::Progress,
    read::ReadArgs,
    run::{Loaded, Run},
};

/// Solves a scene and prints the irradiance at points of your choice, in the unit of the scene's exitance (lm/m² makes
/// lux)
#[derive(Debug, Args)]
#[command(mut_arg("scene", |scene| scene.help(SCENE_OR_SOLUTION)), mut_arg("settings", |set| set.help(PARAMETER_OR_GROUP)), after_help = "\
Points are lines x,y,z,nx,ny,nz: a place and the direction light is received along. With a header line the columns may stand \
in any order, and others are passed over. A point within 1e-6 of the scene's size of a surface lies on it, on the side the \
normal points to, and its radiosity is printed as well.

Example:
  echo 278,100,200,0,1,0 | radiosity probe cornell-box --points -")]
pub(crate) struct ProbeArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// File of the points, or - for standard input
    #[arg(long, value_name = "FILE.csv")]
    pub(crate) points: String,

    #[command(flatten)]
    pub(crate) read: ReadArgs,

    #[command(flatten)]
    data: DataArgs,

    #[command(flatten)]
    pub(crate) method: MethodArgs,

    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

impl ProbeArgs {
    /// Reads the points before the scene, so that a fault in them is reported before any work.
    pub(crate) fn load_points(&self) -> Result<Points, CliError> {
        if self.points == "-" && self.scene.scene == "-" {
            return Err(CliError::Points(PointsError {
                origin: "<stdin>".to_owned(),
                place: None,
                fault: "scene and points cannot both come from standard input".to_owned(),
                cure: "save one of them to a file".to_owned(),
            }));
        }
        Ok(Points::load(&self.points)?)
    }
}

/// Solves the scene and prints the readings.
pub(crate) fn run(args: &ProbeArgs, points: &Points, loaded: Loaded) -> Result<(), CliError> {
    let points_file = Path::new(&args.points);
    if let Some(report) = args.report.reserve()? {
        report.apart_from(points_file, "the points")?;
    }
    let apart = |output: OutputFile| output.apart_from(points_file, "the points");
    let data = args.data.reserve(&loaded, &args.report, apart)?;
    let progress = Progress::new(args.report.quiet);
    let run = Run::solve(loaded, &args.method, &args.report, &progress)?;
    let visibility = run.solved.visibility();
    let Solved { scene, outcome, .. } = &run.solved;
    let observe = |done, total| progress.show("points", done, total);
    let reading = args.read.reading(&args.method, outcome);
    let readings = run.in_threads(|| {
        let reader = Reader::by(reading.by, &outcome.solution, visibility, reading.read, reading.eps);
        probe(&reader, &points.probes, scene.middle, &observe)
    })?;
    let readings = readings.map_err(|(index, fault)| unreadable(points, index, fault))?;
    data.write(|| csv(scene, &readings), || Document::new(scene, &readings))?;
    run.finish(progress, data.written())
}

fn unreadable(points: &Points, index: usize, fault: ProbeFault) -> PointsError {
    PointsError {
        origin: points.origin.clone(),
        place: Some(points.lines[index]),
        fault: fault.to_string(),
        cure: "the polynomials are known on surfaces alone, along their normals: choose --read gather"
            .to_owned(),
    }
}

/// `x,y,z,nx,ny,nz,E_<band>…,surface,u,v,B_<band>…`, a row per point.
fn csv(scene: &Scene, readings: &[Reading]) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let bands = |letter: char| scene.bands.iter().map(move |band| format!("{letter}_{band}"));
    let header = COLUMNS.map(str::to_owned).into_iter().chain(bands('E'));
    let header = header.chain(["surface", "u", "v"].map(str::to_owned)).chain(bands('B'));
    writer.write_record(header)?;
    for reading in readings {
        let [position, normal] = [reading.probe.position, reading.probe.normal].map(|x| x.to_array());
        let numbers = position.into_iter().chain(normal).chain(reading.irradiance.iter().copied());
        let numbers = numbers.map(|x| x.to_string());
        let on: Vec<String> = match &reading.on {
            Some(on) => {
                let values = on.parameters.iter().chain(&on.radiosity).map(f64::to_string);
                std::iter::once(scene.surfaces[on.surface].name.clone()).chain(values).collect()
            }
            None => vec![String::new(); 3 + scene.bands.len()],
        };
        writer.write_record(numbers.chain(on))?;
    }
    writer.into_inner().map_err(|error| error.into_error())
}

#[derive(Serialize)]
struct Document<'a> {
    bands: &'a [String],
    points: Vec<Row<'a>>,
}

impl<'a> Document<'a> {
    fn new(scene: &'a Scene, readings: &'a [Reading]) -> Self {
        let points = readings.iter().map(|reading| Row::new(scene, reading)).collect();
        Self { bands: &scene.bands, points }
    }
}

/// A reading; bands in the order of the document's.
#[derive(Serialize)]
struct Row<'a> {
    position: [f64; 3],
    normal: [f64; 3],
    irradiance: &'a [f64],
    surface: Option<&'a str>,
    parameters: Option<[f64; 2]>,
    radiosity: Option<&'a [f64]>,
}

impl<'a> Row<'a> {
    fn new(scene: &'a Scene, reading: &'a Reading) -> Self {
        let on = reading.on.as_ref();
        Self {
            position: reading.probe.position.to_array(),
            normal: reading.probe.normal.to_array(),
            irradiance: &reading.irradiance,
            surface: on.map(|on| scene.surfaces[on.surface].name.as_str()),
            parameters: on.map(|on| on.parameters),
            radiosity: on.map(|on| on.radiosity.as_slice()),
        }
    }
}
