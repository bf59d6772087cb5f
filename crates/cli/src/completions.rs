//! `radiosity completions`: what a shell needs to complete the command line.

use clap::{Args, Command};
use clap_complete::{Shell, generate};
use radiosity_work::ranks::Ranks;

use crate::console;
use crate::error::CliError;

/// Prints the completions of a shell
#[derive(Debug, Args)]
#[command(
    after_help = "Example:\n  radiosity completions bash > ~/.local/share/bash-completion/completions/radiosity"
)]
pub(crate) struct CompletionsArgs {
    /// The shell
    #[arg(value_name = "SHELL")]
    pub(crate) shell: Shell,
}

/// Prints the script for `command`, the whole command line.
pub(crate) fn run(args: &CompletionsArgs, mut command: Command, ranks: &Ranks) -> Result<(), CliError> {
    let name = command.get_name().to_owned();
    let mut script = Vec::new();
    generate(args.shell, &mut command, name, &mut script);
    Ok(console::print(&script, ranks)?)
}
