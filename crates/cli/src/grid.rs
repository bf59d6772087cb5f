//! `radiosity grid`: mean irradiance and radiosity over the cells of every surface.

use clap::Args;
use radiosity_output::table::{Column, Table, Value};
use radiosity_reading::cell_counts::CellCounts;
use radiosity_reading::checked_readings::{CheckedReadings, PrintedReading};
use radiosity_reading::grid::{Cell, Rates, grid};
use radiosity_reading::own_error::OwnError;
use radiosity_reading::read_error::ReadError;
use radiosity_request::ReadRequest;
use radiosity_request::cells::require_cells;
use radiosity_scene::Scene;
use radiosity_work::Stage;
use radiosity_work::ranks::Ranks;

use crate::{
    aim::wanted,
    data::DataArgs,
    error::CliError,
    loaded::Loaded,
    numbers::counts,
    options::{PARAMETER_OR_GROUP, SCENE_OR_SOLUTION, SceneArg},
    read::samples,
    run::{Run, RunArgs},
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

    /// Cells of equal parameter size along u and v of every surface [default: 16x16, or where these were more than
    /// 5000 cells of about one size]
    #[arg(long, value_name = "NxM", value_parser = counts)]
    pub(crate) cells: Option<[u32; 2]>,

    #[command(flatten)]
    pub(crate) read: ReadRequest,

    /// Points along each side of a cell at which direct and gathered light are computed [default: 4,2; as
    /// --quality says; light is then gathered by cells]
    #[arg(long, value_name = "D,I", value_parser = samples)]
    pub(crate) read_samples: Option<Rates>,

    #[command(flatten)]
    data: DataArgs,

    #[command(flatten)]
    pub(crate) run: RunArgs,
}

impl GridArgs {
    /// The request for reading.
    fn request(&self) -> ReadRequest {
        ReadRequest { samples: self.read_samples, ..self.read }
    }
}

/// Solves the scene and prints the means.
pub(crate) fn run(args: &GridArgs, loaded: Loaded, ranks: &Ranks) -> Result<(), CliError> {
    let method = &args.run.method;
    let cells = args.cells.map(|cells| cells.map(|count| count as usize));
    let counts = cells.map_or_else(|| CellCounts::usual(loaded.scene()), CellCounts::from);
    let readings = counts.total(loaded.scene().surfaces.len());
    require_cells(readings, loaded.scene(), method.memory, ranks)?;
    let request = args.request();
    request.check(&loaded.options(method, ranks), method)?;
    let data = args.data.reserve(&loaded, &args.run.report, ranks, Ok)?;
    let goal = wanted(method, loaded.scene(), ranks)?;
    let by = args.read.read_by.unwrap_or_default();
    let goal = goal.map(|goal| goal.read_by(by).for_readings(readings));
    let mut run = Run::to(goal, loaded, &args.run, ranks)?;
    let reading = request.reading(method, &run.solved, run.is_saved());
    let pace = run.pace(readings);
    run.tell_readings(&reading, readings, Stage::Cells);
    let read = || grid(&run.reader(&reading, pace.as_ref()), counts.clone(), reading.rates, &run.work());
    let cells = run.in_threads(read)?;
    let scene = &run.solved.scene;
    let own = OwnError::of(&run.solved, &reading);
    let printed = |number: usize| {
        let cell = &cells[number];
        PrintedReading::of_cell(cell, counts.of(cell.surface), scene, &own)
    };
    let checked = run.check(cells.len(), printed, run.seconds_to_read(&reading, cells.len()))?;
    let estimates = cells.iter().map(|cell| own.of_reading(&cell.irradiance, cell.uncertainty));
    let errors = CheckedReadings::all_told(checked.as_ref(), estimates);
    data.write(&scene.bands, "cells", &table(scene, &cells, &errors))?;
    run.add_checked(checked.map(|own| own.checked), reading.read);
    run.take_error_of_walks(cells.iter().map(|cell| (&cell.irradiance[..], cell.uncertainty.deviation)));
    run.add_read_error(
        ReadError::of(cells.iter().map(|cell| cell.uncertainty.deviation)),
        reading.eps,
        pace.as_ref(),
    );
    run.finish(data.written())
}

/// A row per cell: `surface,i,j,E_<band>…,B_<band>…,error,area,x,y,z`, with the error that is told of the
/// irradiance.
fn table<'a>(scene: &'a Scene, cells: &'a [Cell], errors: &'a [f64]) -> Table<'a> {
    let columns = [
        Column::text("surface"),
        Column::numbers("i", ""),
        Column::numbers("j", ""),
        Column::bands("irradiance", 'E', &scene.bands),
        Column::bands("radiosity", 'B', &scene.bands),
        Column::numbers("error", ""),
        Column::numbers("area", ""),
        Column::several("position", ["x", "y", "z"]),
    ];
    let row = |(cell, error): (&'a Cell, &'a f64)| {
        [
            Value::from(scene.surfaces[cell.surface].name.as_str()),
            cell.index[0].into(),
            cell.index[1].into(),
            Value::numbers(&cell.irradiance),
            Value::numbers(&cell.radiosity),
            (*error).into(),
            cell.area.into(),
            Value::numbers((cell.position + scene.middle).to_array().to_vec()),
        ]
    };
    Table::new(columns, cells.iter().zip(errors).map(row))
}
