//! The `radiosity` command: scene files and options in, pictures, tables and reports out.
//!
//! Data goes to stdout, progress and diagnostics to stderr. Exit code 0: done; 1: failed; 2: the command line
//! or a scene file has to be changed first.

#[cfg(feature = "mpi")]
mod processes;

fn main() -> std::process::ExitCode {
    #[cfg(feature = "mpi")]
    let connect = Some(processes::connect as _);
    #[cfg(not(feature = "mpi"))]
    let connect = None;
    radiosity_cli::launch::launch(connect)
}
