//! The picture of where: judged readings on the scene.

use std::path::{Path, PathBuf};

use clap::Args;
use radiosity_output::drawings::legend::Legend;
use radiosity_output::drawings::nice_numbers::round_above;
use radiosity_output::drawings::picture::Picture;
use radiosity_output::drawings::scale::Scale;
use radiosity_output::pictures::marks::{Mark, MarkedPicture};
use radiosity_reading::judging::{JudgedReading, JudgedRun};
use radiosity_request::picture::sized;
use radiosity_request::view::View;
use radiosity_scene::Camera;
use radiosity_solve::solved::Solved;
use radiosity_work::ranks::Ranks;

use crate::{
    error::CliError,
    format::{self, PictureFormat},
    loaded::Loaded,
    numbers::counts,
    options::ReportArgs,
    output_file::OutputFile,
};

/// Standard errors from which a mark is large: by chance one reading in fifty.
const LARGE: f64 = 3.0;

/// `--picture` and its size.
#[derive(Debug, Args)]
#[command(next_help_heading = "Picture")]
pub(crate) struct MarkArgs {
    /// Picture of the scene in grey through its camera, each reading a disk, or a ring where something hides
    /// it, in the colour of its difference, large from three standard errors on, .png
    #[arg(long, value_name = "FILE")]
    pub(crate) picture: Option<PathBuf>,

    /// Pixels across and down [default: as the scene's camera says]
    #[arg(long, value_name = "WxH", requires = "picture", value_parser = counts)]
    size: Option<[u32; 2]>,
}

/// A picture about to be taken.
pub(crate) struct MarkPicture {
    camera: Camera,
    /// Words on its view, where it was chosen.
    pub(crate) told: Option<String>,
    pub(crate) file: OutputFile,
}

impl MarkArgs {
    /// The picture, if one is wanted; `output` is the other file.
    pub(crate) fn wanted(
        &self,
        loaded: &Loaded,
        report: &ReportArgs,
        output: Option<&Path>,
        ranks: &Ranks,
    ) -> Result<Option<MarkPicture>, CliError> {
        let Some(path) = &self.picture else { return Ok(None) };
        format::of_file::<PictureFormat>(path)?;
        let View { camera, told } = View::usual(loaded.scene());
        let file = loaded.reserve(path, report, ranks)?.apart_from(output, "the figures")?;
        Ok(Some(MarkPicture { camera: sized(camera, self.size), told, file }))
    }
}

impl MarkPicture {
    /// The picture of these readings.
    pub(crate) fn take(&self, solved: &Solved, judged: &JudgedRun, ranks: &Ranks) -> Picture {
        let scene = &solved.scene;
        let squares: f64 = judged.readings.iter().map(|own| own.judged.found().powi(2)).sum();
        let mean = (squares / judged.readings.len() as f64).sqrt();
        let mark = |own: &JudgedReading| Mark {
            position: own.probe.position - scene.middle,
            value: 100.0 * own.judged.difference() / mean,
            is_large: own.judged.in_errors().abs() >= LARGE,
        };
        let marks: Vec<Mark> = judged.readings.iter().map(mark).collect();
        let largest = marks.iter().map(|mark| mark.value.abs()).fold(0.0, f64::max);
        let scale = Scale::diverging(round_above(largest.max(f64::MIN_POSITIVE)));
        let taken = MarkedPicture::of(scene, solved.visibility(), &self.camera, &marks, &scale, ranks);
        let title = ["difference", "% of mean"].map(str::to_owned).to_vec();
        let note = vec![
            format!("disks: {} seen", taken.seen),
            format!("rings: {} hidden", taken.hidden),
            "large: 3 s".to_owned(),
        ];
        Legend { scale: &scale, title, note, levels: Vec::new() }.beside(&taken.picture)
    }
}
