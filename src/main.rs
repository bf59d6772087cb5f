//! The `radiosity` command: scene files and options in, pictures, tables and reports out.
//!
//! Data goes to stdout, progress and diagnostics to stderr. Exit code 0: done; 1: failed; 2: the command line or a
//! scene file has to be changed first.

mod cli;

use std::{io::Write, process::ExitCode};

use crate::cli::Cli;

fn main() -> ExitCode {
    match Cli::typed().run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // A closed stderr is no error: nobody would see a message.
            let _ = std::io::stderr().write_all(error.explain().as_bytes());
            error.exit_code()
        }
    }
}
