//! `radiosity scenes`: the built-in scenes.

use std::io::{Write, stdout};

use clap::Args;
use radiosity::scene::Scene;

use crate::cli::{error::CliError, table::Table};

/// Lists the built-in scenes
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  radiosity scenes")]
pub(crate) struct ScenesArgs {}

/// Prints name, number of surfaces and title of every built-in scene.
pub(crate) fn run(_: &ScenesArgs) -> Result<(), CliError> {
    let mut table = Table::new(["scene", "surfaces", "title"]);
    for name in Scene::builtin_names() {
        let scene = Scene::builtin(name)?;
        table.row([scene.name, scene.surfaces.len().to_string(), scene.title.unwrap_or_default()]);
    }
    Ok(stdout().write_all(table.to_string().as_bytes())?)
}
