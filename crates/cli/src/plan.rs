//! The picture of a probe: a plane of sensors as a plan.

use std::path::PathBuf;

use clap::Args;
use radiosity_output::documents::plan_page::plan_page;
use radiosity_reading::probe::ProbeReading;
use radiosity_scene::Scene;
use radiosity_work::ranks::Ranks;

use crate::{
    colours::ColourArgs,
    error::CliError,
    format::{self, PictureFormat},
    loaded::Loaded,
    options::ReportArgs,
    output_file::OutputFile,
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
        ranks: &Ranks,
    ) -> Result<Option<Drawing<'_>>, CliError> {
        self.colours.require_picture(self.picture.is_some())?;
        let Some(path) = &self.picture else { return Ok(None) };
        format::of_kind::<PictureFormat>(path, "kind of plan", "choose a file ending in .png")?;
        if sensors.planes().len() != 1 {
            return Err(CliError::refused(
                format!("--picture draws one plane, {} are read", sensors.planes().len()),
                "choose one with --plane, and run the command once for each",
            ));
        }
        self.colours.check()?;
        let band = self.colours.band(loaded.scene())?;
        let output = loaded.reserve(path, report, ranks)?;
        Ok(Some(Drawing { colours: &self.colours, band, output, written: path.display().to_string() }))
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
        readings: &[ProbeReading],
    ) -> Result<(), CliError> {
        sensors.by_plane(readings).try_for_each(|on| self.draw(scene, &on))
    }

    fn draw(&self, scene: &Scene, on: &OnPlane<ProbeReading>) -> Result<(), CliError> {
        let picture = plan_page(scene, on.plane, on.items, self.band, |range| self.colours.of_plan(range));
        self.output.write(|writer| picture.write_png(writer))
    }
}
