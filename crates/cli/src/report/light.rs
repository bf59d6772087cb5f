//! The light of a report: what is wanted of it, and its reading.

use radiosity_output::documents::plan_page::plan_page;
use radiosity_output::documents::report_page::{LightPart, PICTURE, ReportedPlane, plan_name};
use radiosity_output::drawings::picture::Picture;
use radiosity_output::pictures::image::Image;
use radiosity_reading::cell_counts::CellCounts;
use radiosity_reading::checked_readings::{CheckedReadings, PrintedReading};
use radiosity_reading::grid::grid;
use radiosity_reading::own_error::OwnError;
use radiosity_reading::pictures::render::{PictureRequest, usual_read, white_balance};
use radiosity_reading::plane_figures::{PlaneFigures, in_room, is_in_room};
use radiosity_reading::probe::{ProbeReading, probe};
use radiosity_reading::quality::ReadSettings;
use radiosity_reading::quantity::{Quantity, band_name, of_bands};
use radiosity_reading::read_error::ReadError;
use radiosity_reading::surface_light::SurfaceLight;
use radiosity_reading::uniformity::Uniformity;
use radiosity_request::picture::{SAMPLES, pixels, require_pixels, sized};
use radiosity_scene::{Camera, Scene, SensorPlane};
use radiosity_solve::solved::Solved;
use radiosity_work::{Stage, ranks::Ranks};

use super::args::ReportPageArgs;
use crate::{
    colours::ColourArgs, error::CliError, loaded::Loaded, planes::plane, run::Run, sensors::Sensors,
};

/// Most cells along each side of a surface, and about as many as all surfaces have beyond one each. Chosen: cells of
/// half a metre in an office.
const SIDE: usize = 8;
const ABOUT: usize = 2000;

/// Light that a report shows: picture, sensors and cells.
#[derive(Debug)]
pub(super) struct ReportLight<'a> {
    camera: Option<Camera>,
    sensors: Sensors,
    band: Option<usize>,
    /// Cells along u and v of every surface; none where they are of one size.
    cells: Option<[usize; 2]>,
    colours: &'a ColourArgs,
}

/// The light that was read.
#[derive(Debug)]
pub(super) struct ReadLight {
    reading: ReadSettings,
    picture: Option<Picture>,
    sensed: Vec<ProbeReading>,
    surfaces: Vec<SurfaceLight>,
}

impl<'a> ReportLight<'a> {
    /// The light of `scene` that was asked for.
    pub(super) fn of(args: &'a ReportPageArgs, scene: &Scene, ranks: &Ranks) -> Result<Self, CliError> {
        args.colours.check()?;
        let camera = scene.camera.clone().map(|camera| sized(camera, args.size));
        camera.iter().try_for_each(|camera| require_pixels(camera, scene, args.run.method.memory, ranks))?;
        let mut planes = scene.planes.clone();
        for (index, text) in args.plane.iter().enumerate() {
            let typed = plane(text, index, scene)?;
            // A plane of the scene that is named as well stands there once.
            if !planes.contains(&typed) {
                planes.push(typed);
            }
        }
        let cells = args.cells.map(|cells| cells.map(|count| count as usize));
        let band = args.colours.band(scene)?;
        Ok(Self { camera, sensors: Sensors::Planes(planes), band, cells, colours: &args.colours })
    }

    /// The names of its figures.
    pub(super) fn figures(&self) -> Vec<String> {
        let picture = self.camera.iter().map(|_| PICTURE.to_owned());
        picture.chain((0..self.sensors.planes().len()).map(plan_name)).collect()
    }

    /// Solves the scene and reads what is wanted.
    pub(super) fn read(
        &self,
        args: &ReportPageArgs,
        loaded: Loaded,
        ranks: &Ranks,
    ) -> Result<(Run, ReadLight), CliError> {
        let mut run = Run::solve(loaded, &args.run, ranks)?;
        let reading = args.read.reading(&args.run.method, &run.solved, run.is_saved());
        let Solved { scene, outcome, .. } = &run.solved;
        let by_size = || CellCounts::by_size(scene, ABOUT, SIDE);
        let counts = self.cells.map_or_else(by_size, CellCounts::from);
        let probes = self.sensors.probes();
        let pace = run.pace(probes.len() + counts.total(scene.surfaces.len()));
        run.tell_readings(&reading, probes.len(), Stage::Points);
        run.tell_readings(&reading, counts.total(scene.surfaces.len()), Stage::Cells);
        let (sensed, cells) = run.in_threads(|| {
            let (reader, work) = (run.reader(&reading, pace.as_ref()), run.work());
            let sensed = probe(&reader, &probes, scene.middle, &work);
            (sensed, grid(&reader, counts.clone(), reading.rates, &work))
        })?;
        let sensed = sensed.map_err(|(index, fault)| self.sensors.unreadable(index, fault))?;
        let picture = self.camera.as_ref().map(|camera| picture(&run, camera)).transpose()?;
        let surfaces = SurfaceLight::of(&outcome.solution, &cells);
        let planes = self.sensors.by_plane(&sensed);
        let own = OwnError::of(&run.solved, &reading);
        let printed = |number: usize| match sensed.get(number) {
            Some(reading) => {
                let plane = self.sensors.plane_of(number).map(SensorPlane::name);
                PrintedReading::of_probe(reading, scene, &own, plane)
            }
            None => {
                let cell = &cells[number - sensed.len()];
                PrintedReading::of_cell(cell, counts.of(cell.surface), scene, &own)
            }
        };
        let count = sensed.len() + cells.len();
        let checked = run.check(count, printed, run.seconds_to_read(&reading, count))?;
        let estimates = sensed.iter().map(|reading| own.of_reading(&reading.irradiance, reading.uncertainty));
        let errors = CheckedReadings::all_told(checked.as_ref(), estimates);
        let figures = planes.map(|on| {
            let errors = &errors[on.first..on.first + on.items.len()];
            PlaneFigures::of(on.plane, &scene.bands, on.items, errors)
        });
        let figures = figures.collect();
        let deviations = sensed.iter().map(|reading| reading.uncertainty.deviation);
        let error = ReadError::of(deviations.chain(cells.iter().map(|cell| cell.uncertainty.deviation)));
        run.add_checked(checked.map(|own| own.checked), reading.read);
        run.add_read_error(error, reading.eps, pace.as_ref());
        run.add_planes(figures);
        Ok((run, ReadLight { reading, picture, sensed, surfaces }))
    }
}

/// The picture through the camera, as `radiosity render` takes it.
fn picture(run: &Run, camera: &Camera) -> Result<Picture, CliError> {
    let (solution, visibility) = (&run.solved.outcome.solution, run.solved.visibility());
    let read = usual_read(solution, visibility, pixels(camera), run.time_left());
    let shown = Quantity::Radiosity;
    let request =
        PictureRequest { solution, visibility, camera, samples: SAMPLES, read, shown, is_preview: false };
    let raster = run.in_threads(|| request.picture(&run.work()))?;
    let image = Image::new(&raster, white_balance(solution));
    Ok(image.exposed(image.automatic_exposure()))
}

impl ReadLight {
    /// The part of the report on light.
    pub(super) fn part<'a>(&'a self, wanted: &'a ReportLight, run: &'a Run) -> LightPart<'a> {
        let scene = &run.solved.scene;
        let shown = |readings: &[ProbeReading]| {
            let readings = in_room(readings, &is_in_room(readings));
            Uniformity::of(readings.iter().map(|own| of_bands(&own.irradiance, wanted.band)))
        };
        let plans = wanted.sensors.by_plane(&self.sensed).map(|on| ReportedPlane {
            plane: on.plane,
            shown: shown(on.items),
            band: band_name(&scene.bands, wanted.band),
            picture: plan_page(scene, on.plane, on.items, wanted.band, |range| wanted.colours.of_plan(range)),
        });
        LightPart {
            report: run.report(),
            options: &run.solved.options,
            reading: self.reading,
            plans: plans.collect(),
            picture: self.picture.clone(),
            cells: wanted.cells,
            surfaces: self.surfaces.clone(),
        }
    }
}
