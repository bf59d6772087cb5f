//! The picture of a probe: a plane of sensors as a plan.

use std::path::PathBuf;

use clap::Args;
use radiosity::output::plan::Plan;
use radiosity::output::plan_page::PlanPage;
use radiosity::output::probe::Reading;
use radiosity::output::shown::Shown;
use radiosity::output::uniformity::Uniformity;
use radiosity::scene::Scene;

use crate::cli::{
    colours::ColourArgs,
    error::CliError,
    options::ReportArgs,
    output_file::OutputFile,
    run::Loaded,
    sensors::{OnPlane, Sensors},
};

/// Options of the plan.
#[derive(Debug, Args)]
pub(crate) struct PictureArgs {
    /// Draws the plane as a plan in false colours, with isolines, their values and U0
    #[arg(long, value_name = "FILE.png")]
    pub(crate) picture: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) colours: ColourArgs,
}

/// A plan that will be drawn.
#[derive(Debug)]
pub(crate) struct Drawing<'a> {
    colours: &'a ColourArgs,
    band: Option<usize>,
    output: OutputFile,
    written: String,
}

impl PictureArgs {
    /// Checks, before the work, whether there is one plane to draw, and whether it can be written.
    pub(crate) fn reserve(
        &self,
        loaded: &Loaded,
        report: &ReportArgs,
        sensors: &Sensors,
    ) -> Result<Option<Drawing<'_>>, CliError> {
        let Some(path) = &self.picture else { return self.without() };
        if !path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png")) {
            return Err(CliError::Refused {
                message: format!("{}: the ending names no kind of plan", path.display()),
                cure: "choose a file ending in .png".to_owned(),
            });
        }
        if sensors.planes().len() != 1 {
            return Err(CliError::Refused {
                message: format!("--picture draws one plane, {} are read", sensors.planes().len()),
                cure: "choose one with --plane, and run the command once for each".to_owned(),
            });
        }
        self.colours.check()?;
        let band = self.colours.band(&loaded.scene)?;
        let output = loaded.reserve(path, report)?;
        Ok(Some(Drawing { colours: &self.colours, band, output, written: path.display().to_string() }))
    }

    /// Refuses options of a picture that is not drawn.
    fn without(&self) -> Result<Option<Drawing<'_>>, CliError> {
        match self.colours.typed()[..] {
            [] => Ok(None),
            [option, ..] => Err(CliError::Refused {
                message: format!("{option} speaks of a picture"),
                cure: "add --picture FILE.png, or leave it out".to_owned(),
            }),
        }
    }
}

impl Drawing<'_> {
    /// The file, as it was typed.
    pub(crate) fn written(&self) -> &str {
        &self.written
    }

    /// Draws the only plane.
    pub(crate) fn write(
        &self,
        scene: &Scene,
        sensors: &Sensors,
        readings: &[Reading],
    ) -> Result<(), CliError> {
        sensors.by_plane(readings).try_for_each(|on| self.draw(scene, &on))
    }

    fn draw(&self, scene: &Scene, on: &OnPlane<Reading>) -> Result<(), CliError> {
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let one = |reading: &Reading| {
            self.band.map_or_else(|| mean(&reading.irradiance), |band| reading.irradiance[band])
        };
        let values: Vec<f64> = on.items.iter().map(one).collect();
        let figures = Uniformity::of(values.iter().copied());
        let quantity = Shown::Irradiance.name(&scene.unit).to_owned();
        let legend = [quantity].into_iter().chain(self.colours.band_name(scene)).chain([scene.unit.clone()]);
        let page = PlanPage {
            plan: &Plan::new(on.plane, &values),
            name: on.plane.name(),
            figures: &figures.told(&scene.unit),
            legend: legend.collect(),
        };
        let range = [figures.min, figures.max];
        let colours = self.colours.colours(range);
        // Without levels of its own a plan has round ones.
        let colours =
            if self.colours.isolines.is_none() { colours.with_round_isolines(range) } else { colours };
        self.output.write(|writer| page.picture(&colours).write_png(writer))
    }
}
