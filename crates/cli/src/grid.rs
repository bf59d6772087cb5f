//! `radiosity grid`: mean irradiance and radiosity over the cells of every surface.

use std::io;

use clap::Args;
use radiosity_reading::grid::{Cell, grid};
use radiosity_reading::read_error::ReadError;
use radiosity_reading::reader::Reader;
use radiosity_request::MethodRequest;
use radiosity_request::ReadRequest;
use radiosity_request::cells::require_cells;
use radiosity_scene::Scene;
use radiosity_solve::solved::Solved;
use radiosity_work::Work;
use radiosity_work::ranks::Ranks;
use serde::Serialize;

use crate::{
    checkpoint::CheckpointArgs,
    data::DataArgs,
    error::CliError,
    numbers::Counts,
    options::{PARAMETER_OR_GROUP, ReportArgs, SCENE_OR_SOLUTION, SceneArg},
    progress::Progress,
    read::Samples,
    run::{Loaded, Run},
};

/// Solves a scene and prints means over the cells of every surface, with the place x, y, z of each cell's
/// middle
#[derive(Debug, Args)]
#[command(mut_arg("scene", |scene| scene.help(SCENE_OR_SOLUTION)), mut_arg("settings", |set| set.help(PARAMETER_OR_GROUP)), after_help = "\
Examples:
  radiosity grid cornell-box --cells 16x16 > cells.csv
  radiosity grid cornell-box --read basis --format json -o cells.json")]
pub(crate) struct GridArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// Cells of equal parameter size along u and v of every surface
    #[arg(long, value_name = "NxM", default_value = "16x16")]
    pub(crate) cells: Counts,

    #[command(flatten)]
    pub(crate) read: ReadRequest,

    /// Points along each side of a cell at which direct and gathered light are computed [default: 4,2; as
    /// --quality says; light is then gathered by cells]
    #[arg(long, value_name = "D,I")]
    pub(crate) read_samples: Option<Samples>,

    #[command(flatten)]
    data: DataArgs,

    #[command(flatten)]
    pub(crate) method: MethodRequest,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

impl GridArgs {
    /// The request for reading.
    fn request(&self) -> ReadRequest {
        ReadRequest { samples: self.read_samples.map(|samples| samples.0), ..self.read }
    }
}

/// Solves the scene and prints the means.
pub(crate) fn run(args: &GridArgs, loaded: Loaded, ranks: &Ranks) -> Result<(), CliError> {
    let sides = args.cells.0.map(|count| count as usize);
    require_cells(sides, &loaded.scene, args.method.memory, ranks)?;
    let (method, request) = (&args.method, args.request());
    request.check(&loaded.options(method, ranks), method)?;
    let data = args.data.reserve(&loaded, &args.report, ranks, Ok)?;
    let (progress, deadline) = (Progress::of(&args.report, ranks), args.method.deadline());
    let work = Work { ranks, observer: &progress, deadline: deadline.as_ref() };
    let mut run =
        Run::to_gather(loaded, &args.method, args.read.read_by.unwrap_or_default(), &args.report, &work)?;
    let visibility = run.solved.visibility();
    let Solved { scene, outcome, .. } = &run.solved;
    let reading = request.reading(&method, &run.solved, run.is_saved());
    let cells = run.in_threads(|| {
        let reader = Reader::by(reading.by, &outcome.solution, visibility, reading.read, reading.eps);
        grid(&reader, sides, reading.rates, &work)
    })?;
    data.write(|| csv(scene, &cells), || Document::new(scene, &cells))?;
    run.add_read_error(ReadError::of(cells.iter().map(|cell| cell.deviation)), reading.eps);
    run.finish(progress, data.written())
}

/// `surface,i,j,E_<band>…,B_<band>…,area,x,y,z`, a row per cell.
fn csv(scene: &Scene, cells: &[Cell]) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let bands = |letter: char| scene.bands.iter().map(move |band| format!("{letter}_{band}"));
    let header = ["surface", "i", "j"].map(str::to_owned).into_iter().chain(bands('E')).chain(bands('B'));
    writer.write_record(header.chain(["area", "x", "y", "z"].map(str::to_owned)))?;
    for cell in cells {
        let place = [scene.surfaces[cell.surface].name.clone()];
        let place = place.into_iter().chain(cell.index.map(|index| index.to_string()));
        let position = (cell.position + scene.middle).to_array();
        let numbers = cell.irradiance.iter().chain(&cell.radiosity).chain([&cell.area]).chain(&position);
        writer.write_record(place.chain(numbers.map(f64::to_string)))?;
    }
    writer.into_inner().map_err(|error| error.into_error())
}

#[derive(Serialize)]
struct Document<'a> {
    bands: &'a [String],
    cells: Vec<Row<'a>>,
}

impl<'a> Document<'a> {
    fn new(scene: &'a Scene, cells: &'a [Cell]) -> Self {
        let cells = cells.iter().map(|cell| Row::new(scene, cell)).collect();
        Self { bands: &scene.bands, cells }
    }
}

/// A cell; bands in the order of the document's.
#[derive(Serialize)]
struct Row<'a> {
    surface: &'a str,
    i: usize,
    j: usize,
    irradiance: &'a [f64],
    radiosity: &'a [f64],
    /// Standard deviation of the irradiance, relative to it, where rays gathered it.
    deviation: Option<f64>,
    area: f64,
    position: [f64; 3],
}

impl<'a> Row<'a> {
    fn new(scene: &'a Scene, cell: &'a Cell) -> Self {
        let [i, j] = cell.index;
        let surface = &scene.surfaces[cell.surface].name;
        let position = (cell.position + scene.middle).to_array();
        Self {
            surface,
            i,
            j,
            irradiance: &cell.irradiance,
            radiosity: &cell.radiosity,
            deviation: cell.deviation.map(|deviation| deviation.relative),
            area: cell.area,
            position,
        }
    }
}
