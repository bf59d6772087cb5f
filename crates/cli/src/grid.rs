//! `radiosity grid`: mean irradiance and radiosity over the cells of every surface.

use clap::Args;
use radiosity_output::table::{Column, Table, Value};
use radiosity_reading::grid::{Cell, grid};
use radiosity_reading::read_error::ReadError;
use radiosity_reading::reader::Reader;
use radiosity_request::ReadRequest;
use radiosity_request::cells::require_cells;
use radiosity_scene::Scene;
use radiosity_solve::solved::Solved;
use radiosity_work::Work;
use radiosity_work::ranks::Ranks;

use crate::{
    checkpoint::CheckpointArgs,
    data::DataArgs,
    error::CliError,
    numbers::Counts,
    options::{MethodArgs, PARAMETER_OR_GROUP, ReportArgs, SCENE_OR_SOLUTION, SceneArg},
    progress::Progress,
    read::{ReadArgs, Samples},
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
    pub(crate) read: ReadArgs,

    /// Points along each side of a cell at which direct and gathered light are computed [default: 4,2; as
    /// --quality says; light is then gathered by cells]
    #[arg(long, value_name = "D,I")]
    pub(crate) read_samples: Option<Samples>,

    #[command(flatten)]
    data: DataArgs,

    #[command(flatten)]
    pub(crate) method: MethodArgs,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

impl GridArgs {
    /// The request for reading.
    fn request(&self) -> ReadRequest {
        ReadRequest { samples: self.read_samples.map(|samples| samples.0), ..self.read.request() }
    }
}

/// Solves the scene and prints the means.
pub(crate) fn run(args: &GridArgs, loaded: Loaded, ranks: &Ranks) -> Result<(), CliError> {
    let sides = args.cells.0.map(|count| count as usize);
    require_cells(sides, &loaded.scene, args.method.memory, ranks)?;
    let (method, request) = (args.method.request(), args.request());
    request.check(&loaded.options(&args.method, ranks), &method)?;
    let data = args.data.reserve(&loaded, &args.report, ranks, Ok)?;
    let (progress, deadline) = (Progress::of(&args.report, ranks), args.method.deadline());
    let work = Work { ranks, observer: &progress, deadline: deadline.as_ref() };
    let mut run = Run::to_gather(loaded, &args.method, args.read.by(), &args.report, &work)?;
    let visibility = run.solved.visibility();
    let Solved { scene, outcome, .. } = &run.solved;
    let reading = request.reading(&method, &run.solved, run.is_saved());
    let cells = run.in_threads(|| {
        let reader = Reader::by(reading.by, &outcome.solution, visibility, reading.read, reading.eps);
        grid(&reader, sides, reading.rates, &work)
    })?;
    data.write(&scene.bands, "cells", &table(scene, &cells))?;
    run.add_read_error(ReadError::of(cells.iter().map(|cell| cell.deviation)), reading.eps);
    run.finish(progress, data.written())
}

/// A row per cell: `surface,i,j,E_<band>…,B_<band>…,area,x,y,z` in CSV; in JSON the relative standard
/// deviation of irradiance that rays gathered, too.
fn table<'a>(scene: &'a Scene, cells: &'a [Cell]) -> Table<'a> {
    let columns = [
        Column::text("surface"),
        Column::numbers("i", ""),
        Column::numbers("j", ""),
        Column::bands("irradiance", 'E', &scene.bands),
        Column::bands("radiosity", 'B', &scene.bands),
        Column::several("deviation", [""; 0]),
        Column::numbers("area", ""),
        Column::several("position", ["x", "y", "z"]),
    ];
    let row = |cell: &'a Cell| {
        [
            Value::from(scene.surfaces[cell.surface].name.as_str()),
            cell.index[0].into(),
            cell.index[1].into(),
            Value::numbers(&cell.irradiance),
            Value::numbers(&cell.radiosity),
            cell.deviation.map(|deviation| deviation.relative).into(),
            cell.area.into(),
            Value::numbers((cell.position + scene.middle).to_array().to_vec()),
        ]
    };
    Table::new(columns, cells.iter().map(row))
}
