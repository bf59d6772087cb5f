//! `radiosity probe`: irradiance at single points and on planes of sensors.

use std::io;
use std::path::Path;

use clap::Args;
use radiosity_reading::plane_figures::PlaneFigures;
use radiosity_reading::probe::{ProbeReading, probe};
use radiosity_reading::read_error::ReadError;
use radiosity_reading::reader::Reader;
use radiosity_request::MethodRequest;
use radiosity_request::ReadRequest;
use radiosity_scene::Scene;
use radiosity_solve::solved::Solved;
use radiosity_work::Work;
use radiosity_work::ranks::Ranks;
use serde::Serialize;

use crate::{
    checkpoint::CheckpointArgs,
    data::DataArgs,
    error::CliError,
    options::{PARAMETER_OR_GROUP, ReportArgs, SCENE_OR_SOLUTION, SceneArg},
    output_file::OutputFile,
    plan::PictureArgs,
    planes::PlaneArgs,
    points::{COLUMNS, Points, PointsError},
    progress::Progress,
    run::{Loaded, Run},
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
Ud = min/max.

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
    pub(crate) method: MethodRequest,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

impl ProbeArgs {
    /// Reads the points, if any are given, before the scene, so that a fault in them is reported before any
    /// work.
    pub(crate) fn load_points(&self, ranks: &Ranks) -> Result<Option<Points>, CliError> {
        let Some(points) = &self.points else {
            return if self.planes.is_typed() { Ok(None) } else { Err(nowhere()) };
        };
        if self.planes.is_typed() {
            return Err(CliError::Refused {
                message: "--points and --plane both say where to read".to_owned(),
                cure: "leave one of them out, or run the command once for each".to_owned(),
            });
        }
        if points == "-" && self.scene.scene == "-" {
            return Err(CliError::Points(PointsError {
                origin: "<stdin>".to_owned(),
                place: None,
                fault: "scene and points cannot both come from standard input".to_owned(),
                cure: "save one of them to a file".to_owned(),
            }));
        }
        Ok(Some(Points::load(points, ranks)?))
    }

    /// `output`, if it is not the file of the points.
    fn apart(&self, output: OutputFile) -> Result<OutputFile, CliError> {
        match &self.points {
            Some(points) => output.apart_from(Path::new(points), "the points"),
            None => Ok(output),
        }
    }
}

fn nowhere() -> CliError {
    CliError::Refused {
        message: "nothing says where to read".to_owned(),
        cure: "add --points FILE.csv, --plane NAME, or --plane \"origin; edge; edge; spacing\"".to_owned(),
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
        None => Sensors::Planes(args.planes.of(&loaded.scene)?),
    };
    args.read.check(&loaded.options(&args.method, ranks), &args.method)?;
    args.report.reserve(ranks)?.map(|report| args.apart(report)).transpose()?;
    let data = args.data.reserve(&loaded, &args.report, ranks, |output| args.apart(output))?;
    let picture = args.picture.reserve(&loaded, &args.report, &sensors, ranks)?;
    let (progress, deadline) = (Progress::of(&args.report, ranks), args.method.deadline());
    let work = Work { ranks, observer: &progress, deadline: deadline.as_ref() };
    let mut run = Run::for_sensors(
        loaded,
        &sensors.probes(),
        &args.method,
        args.read.read_by.unwrap_or_default(),
        &args.report,
        &work,
    )?;
    let visibility = run.solved.visibility();
    let Solved { scene, outcome, .. } = &run.solved;
    let reading = args.read.reading(&args.method, &run.solved, run.is_saved());
    let readings = run.in_threads(|| {
        let reader = Reader::by(reading.by, &outcome.solution, visibility, reading.read, reading.eps);
        probe(&reader, &sensors.probes(), scene.middle, &work)
    })?;
    let readings = readings.map_err(|(index, fault)| sensors.unreadable(index, fault))?;
    let table = Table { scene, sensors: &sensors, readings: &readings };
    data.write(|| table.csv(), || table.document())?;
    let mut written: Vec<&str> = data.written().into_iter().collect();
    if let Some(picture) = &picture {
        picture.write(scene, &sensors, &readings)?;
        written.push(picture.written());
    }
    let planes = sensors.by_plane(&readings);
    let figures = planes.map(|on| PlaneFigures::of(on.plane, &scene.bands, on.items)).collect();
    run.add_read_error(ReadError::of(readings.iter().map(|reading| reading.deviation)), reading.eps);
    run.add_planes(figures);
    run.finish(progress, (!written.is_empty()).then(|| written.join(" and ")).as_deref())
}

/// The readings as a table.
struct Table<'a> {
    scene: &'a Scene,
    sensors: &'a Sensors,
    readings: &'a [ProbeReading],
}

impl<'a> Table<'a> {
    /// `x,y,z,nx,ny,nz,E_<band>…,surface,u,v,B_<band>…`, a row per point; of several planes `plane` comes
    /// first.
    fn csv(&self) -> io::Result<Vec<u8>> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let bands = |letter: char| self.scene.bands.iter().map(move |band| format!("{letter}_{band}"));
        let names = self.plane_names();
        let plane = (!names.is_empty()).then(|| "plane".to_owned());
        let header = plane.into_iter().chain(COLUMNS.map(str::to_owned)).chain(bands('E'));
        writer.write_record(header.chain(["surface", "u", "v"].map(str::to_owned)).chain(bands('B')))?;
        for (index, reading) in self.readings.iter().enumerate() {
            let name = names.get(index).map(|name| (*name).to_owned());
            writer.write_record(name.into_iter().chain(self.cells(reading)))?;
        }
        writer.into_inner().map_err(|error| error.into_error())
    }

    fn cells(&self, reading: &ProbeReading) -> Vec<String> {
        let [position, normal] = [reading.probe.position, reading.probe.normal].map(|x| x.to_array());
        let numbers = position.into_iter().chain(normal).chain(reading.irradiance.iter().copied());
        let on: Vec<String> = match &reading.on {
            Some(on) => {
                let values = on.parameters.iter().chain(&on.radiosity).map(f64::to_string);
                std::iter::once(self.scene.surfaces[on.surface].name.clone()).chain(values).collect()
            }
            None => vec![String::new(); 3 + self.scene.bands.len()],
        };
        numbers.map(|x| x.to_string()).chain(on).collect()
    }

    fn document(&self) -> Document<'a> {
        let names = self.plane_names();
        let row = |(index, reading): (usize, &'a ProbeReading)| {
            Row::new(self.scene, names.get(index).copied(), reading)
        };
        Document { bands: &self.scene.bands, points: self.readings.iter().enumerate().map(row).collect() }
    }

    /// The plane of each reading where there are several planes, else nothing.
    fn plane_names(&self) -> Vec<&'a str> {
        if self.sensors.planes().len() < 2 {
            return Vec::new();
        }
        let of_plane = self.sensors.by_plane(self.readings);
        of_plane.flat_map(|on| on.items.iter().map(move |_| on.plane.name())).collect()
    }
}

#[derive(Serialize)]
struct Document<'a> {
    bands: &'a [String],
    points: Vec<Row<'a>>,
}

/// A reading; bands in the order of the document's.
#[derive(Serialize)]
struct Row<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    plane: Option<&'a str>,
    position: [f64; 3],
    normal: [f64; 3],
    irradiance: &'a [f64],
    /// Standard deviation of the irradiance, relative to it, where rays gathered it.
    deviation: Option<f64>,
    surface: Option<&'a str>,
    parameters: Option<[f64; 2]>,
    radiosity: Option<&'a [f64]>,
}

impl<'a> Row<'a> {
    fn new(scene: &'a Scene, plane: Option<&'a str>, reading: &'a ProbeReading) -> Self {
        let on = reading.on.as_ref();
        Self {
            plane,
            position: reading.probe.position.to_array(),
            normal: reading.probe.normal.to_array(),
            irradiance: &reading.irradiance,
            deviation: reading.deviation.map(|deviation| deviation.relative),
            surface: on.map(|on| scene.surfaces[on.surface].name.as_str()),
            parameters: on.map(|on| on.parameters),
            radiosity: on.map(|on| on.radiosity.as_slice()),
        }
    }
}
