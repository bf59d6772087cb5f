//! `radiosity scenes`: the built-in scenes.

use clap::Args;
use radiosity_language::Parameter;
use radiosity_output::table::{Column, Table};
use radiosity_work::ranks::Ranks;

use crate::{console, error::CliError};

/// Lists the built-in scenes
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  radiosity scenes")]
pub(crate) struct ScenesArgs {}

/// Prints name, number of surfaces and title of every built-in scene, then their parameters.
pub(crate) fn run(_: &ScenesArgs, ranks: &Ranks) -> Result<(), CliError> {
    let (mut scenes, mut parameters) = (Vec::new(), Vec::new());
    for builtin in radiosity_language::builtins() {
        let scene = radiosity_language::builtin(builtin.name)?;
        scenes.push([scene.name, scene.surfaces.len().to_string(), scene.title.unwrap_or_default()]);
        for Parameter { name, default, range, meaning, .. } in builtin.parameters {
            let [default, least, most] = [*default, range[0], range[1]].map(|number| number.to_string());
            let [scene, name, meaning] = [builtin.name, name, meaning].map(str::to_owned);
            parameters.push([scene, name, default, least, most, meaning]);
        }
    }
    let scenes = Table::new(["scene", "surfaces", "title"].map(Column::text), scenes);
    let columns = ["scene", "parameter", "default", "from", "to", "meaning"];
    let parameters = Table::new(columns.map(Column::text), parameters);
    let hint = "for example: radiosity render teapot --set height=1.3";
    Ok(console::print(format!("{scenes}\n{parameters}\n{hint}\n").as_bytes(), ranks)?)
}
