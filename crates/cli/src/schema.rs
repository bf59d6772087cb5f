//! `radiosity schema`: the scene format for editors and other programs.

use clap::Args;
use radiosity_language::schema;
use radiosity_work::ranks::Ranks;

use crate::console;
use crate::error::CliError;

/// Prints the JSON schema of the scene format
#[derive(Debug, Args)]
#[command(after_help = "\
Editors complete keys, show what they mean and underline what is wrong: in TOML, write `#:schema radiosity.schema.json` on the first \
line of a scene (Taplo, Even Better TOML).

Example:
  radiosity schema > radiosity.schema.json")]
pub(crate) struct SchemaArgs {}

/// Prints the schema.
pub(crate) fn run(_: &SchemaArgs, ranks: &Ranks) -> Result<(), CliError> {
    Ok(console::print(format!("{:#}\n", schema()).as_bytes(), ranks)?)
}
