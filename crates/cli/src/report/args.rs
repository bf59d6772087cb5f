//! The options of `radiosity report`.

use std::path::PathBuf;

use clap::Args;
use radiosity_request::ReadRequest;

use crate::{
    colours::ColourArgs,
    numbers::counts,
    options::{PARAMETER_OR_GROUP, SCENE_OR_SOLUTION, SceneArg},
    run::RunArgs,
};

/// Solves a scene and writes a report for people: picture, planes of sensors, surfaces, checks and settings
#[derive(Debug, Args)]
#[command(mut_arg("scene", |scene| scene.help(SCENE_OR_SOLUTION)), mut_arg("settings", |set| set.help(PARAMETER_OR_GROUP)), after_help = "\
The report has the picture of the scene's camera, each of its planes of sensors with a plan, a table of its surfaces, the \
self-checks, the settings, and the command that makes it again; where surfaces have thermal conditions, the balance of heat as \
well. HTML is one file that needs no network and prints on A4; the pictures of Markdown are files beside it.

Examples:
  radiosity report examples/office.toml -o office.html
  radiosity report office.solution.json --set lamps=0.5 -o evening.html
  radiosity report room.toml --plane \"0,0,0.75; 4,0,0; 0,3,0; 0.25\" -o room.md")]
pub(crate) struct ReportPageArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// File of the report, .html or .md [default: SCENE.html]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    /// Plane of sensors besides those of the scene, "origin; edge; edge; spacing", as often as needed
    #[arg(long = "plane", value_name = "PLANE", allow_hyphen_values = true)]
    pub(crate) plane: Vec<String>,

    /// Cells along u and v of every surface for least and greatest values [default: of about
    /// one size, 8x8 at the most]
    #[arg(long, value_name = "NxM", value_parser = counts)]
    pub(crate) cells: Option<[u32; 2]>,

    /// Pixels of the picture across and down [default: as the scene's camera says]
    #[arg(long, value_name = "WxH", value_parser = counts)]
    pub(crate) size: Option<[u32; 2]>,

    #[command(flatten)]
    pub(crate) read: ReadRequest,

    #[command(flatten)]
    pub(crate) colours: ColourArgs,

    #[command(flatten)]
    pub(crate) run: RunArgs,
}
