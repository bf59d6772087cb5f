//! `radiosity probe`: irradiance at single points and on planes of sensors.

use std::path::Path;

use clap::Args;
use radiosity_output::table::{Column, Table, Value};
use radiosity_reading::checked_readings::{CheckedReadings, PrintedReading};
use radiosity_reading::own_error::OwnError;
use radiosity_reading::plane_figures::PlaneFigures;
use radiosity_reading::probe::{Probe, ProbeReading, probe};
use radiosity_reading::read_error::ReadError;
use radiosity_request::ReadRequest;
use radiosity_request::aim::at_probes;
use radiosity_scene::{Scene, SensorPlane};
use radiosity_solve::studies::adaptation::Goal;
use radiosity_work::Stage;
use radiosity_work::ranks::Ranks;

use crate::{
    aim::wanted,
    data::DataArgs,
    error::CliError,
    loaded::Loaded,
    options::{PARAMETER_OR_GROUP, SCENE_OR_SOLUTION, SceneArg},
    output_file::OutputFile,
    plan::PictureArgs,
    planes::PlaneArgs,
    points::Points,
    run::{Run, RunArgs},
    sensors::Sensors,
};

/// Solves a scene and prints the irradiance at points or on planes of sensors, in the unit of the scene's
/// exitance (lm/m² makes lux)
#[derive(Debug, Args)]
#[command(mut_arg("scene", |scene| scene.help(SCENE_OR_SOLUTION)), mut_arg("settings", |set| set.help(PARAMETER_OR_GROUP)), after_help = "\
Points are lines x,y,z,nx,ny,nz: a place and the direction light is received along. With a header line the columns may stand \
in any order, and others are passed over. A point within 1e-6 of the scene's size of a surface lies on it, on the side the \
normal points to, and its radiosity is printed as well.

A plane has its name from the scene (docs/scene.md), or is typed: origin, two edges, and the largest spacing of sensors, one \
number or one along each edge. Sensors stand in the middles of equal cells and receive along the first edge × the second. \
The summary and the report have the mean, the least and the greatest value, and the uniformities U0 = min/mean (EN 12464-1) and \
Ud = min/max. Sensors outside of the room and in solids stay in the table, but are left out of these figures.

Examples:
  echo 278,100,200,0,1,0 | radiosity probe cornell-box --points -
  radiosity probe room.toml --plane desk --picture desk.png
  radiosity probe cornell-box --plane \"50,170,50; 0,0,450; 450,0,0; 25\" > plane.csv")]
pub(crate) struct ProbeArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// File of the points, or - for standard input
    #[arg(long, value_name = "FILE.csv")]
    pub(crate) points: Option<String>,

    #[command(flatten)]
    pub(crate) planes: PlaneArgs,

    #[command(flatten)]
    pub(crate) read: ReadRequest,

    #[command(flatten)]
    data: DataArgs,

    #[command(flatten)]
    pub(crate) picture: PictureArgs,

    #[command(flatten)]
    pub(crate) run: RunArgs,
}

impl ProbeArgs {
    /// Reads the points, if any are given, before the scene, so that a fault in them is reported before any
    /// work.
    pub(crate) fn load_points(&self, ranks: &Ranks) -> Result<Option<Points>, CliError> {
        let Some(points) = &self.points else {
            let nowhere = CliError::refused(
                "nothing says where to read",
                "add --points FILE.csv, --plane NAME, or --plane \"origin; edge; edge; spacing\"",
            );
            return self.planes.is_typed().then_some(None).ok_or(nowhere);
        };
        if self.planes.is_typed() {
            return Err(CliError::refused(
                "--points and --plane both say where to read",
                "leave one of them out, or run the command once for each",
            ));
        }
        if points == "-" && self.scene.scene == "-" {
            return Err(CliError::refused(
                "<stdin>: scene and points cannot both come from standard input",
                "save one of them to a file",
            ));
        }
        Points::load(points, ranks).map(Some)
    }

    /// `output`, if it is not the file of the points.
    fn apart(&self, output: OutputFile) -> Result<OutputFile, CliError> {
        output.apart_from(self.points.as_deref().map(Path::new), "the points")
    }

    /// The accuracy that is wanted, and its aim, if one is wanted: where nothing says of what, that of the
    /// light at the sensors.
    fn goal(&self, sensors: &[Probe], scene: &Scene, ranks: &Ranks) -> Result<Option<Goal>, CliError> {
        let method = &self.run.method;
        let goal = match (&method.aim, method.wanted_accuracy()) {
            (None, Some(accuracy)) => Some(at_probes(accuracy, sensors, scene).for_readings(sensors.len())),
            _ => wanted(method, scene, ranks)?,
        };
        Ok(goal.map(|goal| goal.read_by(self.read.read_by.unwrap_or_default())))
    }
}

/// Solves the scene and prints the readings.
pub(crate) fn run(
    args: &ProbeArgs,
    points: Option<Points>,
    loaded: Loaded,
    ranks: &Ranks,
) -> Result<(), CliError> {
    let sensors = match points {
        Some(points) => Sensors::Points(points),
        None => Sensors::Planes(args.planes.of(loaded.scene())?),
    };
    let RunArgs { method, report, .. } = &args.run;
    args.read.check(&loaded.options(method, ranks), method)?;
    report.reserve(ranks)?.map(|report| args.apart(report)).transpose()?;
    let data = args.data.reserve(&loaded, report, ranks, |output| args.apart(output))?;
    let picture = args.picture.reserve(&loaded, report, &sensors, ranks)?;
    let goal = args.goal(&sensors.probes(), loaded.scene(), ranks)?;
    let mut run = Run::to(goal, loaded, &args.run, ranks)?;
    let scene = &run.solved.scene;
    let reading = args.read.reading(method, &run.solved, run.is_saved());
    let probes = sensors.probes();
    let pace = run.pace(probes.len());
    run.tell_readings(&reading, probes.len(), Stage::Points);
    let read = || probe(&run.reader(&reading, pace.as_ref()), &probes, scene.middle, &run.work());
    let readings = run.in_threads(read)?;
    let readings = readings.map_err(|(index, fault)| sensors.unreadable(index, fault))?;
    let own = OwnError::of(&run.solved, &reading);
    let printed = |number: usize| {
        let plane = sensors.plane_of(number).map(SensorPlane::name);
        PrintedReading::of_probe(&readings[number], scene, &own, plane)
    };
    let seconds = run.seconds_to_read(&reading, readings.len());
    let checked = run.check(readings.len(), printed, seconds)?;
    let estimates = readings.iter().map(|reading| own.of_reading(&reading.irradiance, reading.uncertainty));
    let errors = CheckedReadings::all_told(checked.as_ref(), estimates);
    data.write(&scene.bands, "points", &table(scene, &sensors, &readings, &errors))?;
    let mut written: Vec<&str> = data.written().into_iter().collect();
    if let Some(picture) = &picture {
        picture.write(scene, &sensors, &readings)?;
        written.push(picture.written());
    }
    let planes = sensors.by_plane(&readings);
    let figures = planes.map(|on| {
        let errors = &errors[on.first..on.first + on.items.len()];
        PlaneFigures::of(on.plane, &scene.bands, on.items, errors)
    });
    let figures = figures.collect();
    run.add_checked(checked.map(|own| own.checked), reading.read);
    run.take_error_of_walks(
        readings.iter().map(|reading| (&reading.irradiance[..], reading.uncertainty.deviation)),
    );
    run.add_read_error(
        ReadError::of(readings.iter().map(|reading| reading.uncertainty.deviation)),
        reading.eps,
        pace.as_ref(),
    );
    run.add_planes(figures);
    if let Sensors::Points(_) = sensors {
        run.add_points(&readings);
    }
    run.finish((!written.is_empty()).then(|| written.join(" and ")).as_deref())
}

/// A row per point: `x,y,z,nx,ny,nz,E_<band>…,error,surface,u,v,B_<band>…`, with the error that is told of
/// the irradiance; of several planes `plane` comes first.
fn table<'a>(
    scene: &'a Scene,
    sensors: &'a Sensors,
    readings: &'a [ProbeReading],
    errors: &'a [f64],
) -> Table<'a> {
    let names = plane_names(sensors, readings);
    let columns = [
        Column::several("position", ["x", "y", "z"]),
        Column::several("normal", ["nx", "ny", "nz"]),
        Column::bands("irradiance", 'E', &scene.bands),
        Column::numbers("error", ""),
        Column::text("surface"),
        Column::several("parameters", ["u", "v"]),
        Column::bands("radiosity", 'B', &scene.bands),
    ];
    let plane = (!names.is_empty()).then(|| Column::text("plane"));
    let rows = readings.iter().enumerate().map(|(index, reading)| {
        let name = names.get(index).map(|name| Value::from(*name));
        name.into_iter().chain(values(scene, reading, errors[index]))
    });
    Table::new(plane.into_iter().chain(columns).collect::<Vec<_>>(), rows)
}

fn values<'a>(scene: &'a Scene, reading: &'a ProbeReading, error: f64) -> [Value<'a>; 7] {
    let on = reading.on.as_ref();
    [
        Value::numbers(reading.probe.position.to_array().to_vec()),
        Value::numbers(reading.probe.normal.to_array().to_vec()),
        Value::numbers(&reading.irradiance),
        error.into(),
        on.map(|on| scene.surfaces[on.surface].name.as_str()).into(),
        on.map(|on| Value::numbers(&on.parameters)).into(),
        on.map(|on| Value::numbers(&on.radiosity)).into(),
    ]
}

/// The plane of each reading where there are several planes, else nothing.
fn plane_names<'a>(sensors: &'a Sensors, readings: &'a [ProbeReading]) -> Vec<&'a str> {
    if sensors.planes().len() < 2 {
        return Vec::new();
    }
    let of_plane = sensors.by_plane(readings);
    of_plane.flat_map(|on| on.items.iter().map(move |_| on.plane.name())).collect()
}
