//! The `radiosity` command: scene files and options in, pictures, tables and reports out.
//!
//! Data goes to stdout, progress and diagnostics to stderr. Exit code 0: done; 1: failed; 2: something in the command line
//! or in a scene file has to be changed first.

mod cli;

use std::{io::Write, process::ExitCode};

use crate::cli::Cli;

fn main() -> ExitCode {
    match Cli::typed().run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // Nobody is left to tell if stderr is closed.
            let _ = std::io::stderr().write_all(error.explain().as_bytes());
            error.exit_code()
        }
    }
}
