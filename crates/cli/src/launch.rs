//! One process, or one rank of several that MPI connects.
//!
//! `mpirun`, `srun` and the like tell each process by variables that it was started with others. Without them
//! nothing of MPI is begun.

use std::env::args_os;
use std::env::var;
use std::io::{Write, stderr};
use std::process::ExitCode;

use radiosity_work::printable::printable_lines;
use radiosity_work::ranks::Ranks;
use radiosity_work::ranks::failure::Failure;

use crate::{Cli, CliError};

/// Variables of which one holds the number of a process: set by Open MPI, by PMI (MPICH and what is made of
/// it), by PMIx.
const NUMBERS: [&str; 3] = ["OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"];

/// The work of one rank.
pub type RankWork<'a> = dyn Fn(&Ranks) -> Result<(), Failure> + 'a;

/// Says why all ranks end.
pub type Tell<'a> = dyn Fn(&str) + 'a;

/// Does work on the ranks of all processes that were started together, and says why where it fails; None where
/// they cannot be connected again. The program that knows of MPI has one.
pub type Connect = fn(&RankWork<'_>, &Tell<'_>) -> Option<ExitCode>;

/// Runs the command line, on several ranks where `connect` is there and others were started, and says why where
/// it fails.
pub fn launch(connect: Option<Connect>) -> ExitCode {
    match (NUMBERS.iter().find_map(|name| var(name).ok()), connect) {
        (Some(_), Some(connect)) => among_others(connect),
        (Some(number), None) => refuse_others(&number),
        (None, _) => alone(),
    }
}

/// Runs the command line in this process.
fn alone() -> ExitCode {
    match Cli::typed().and_then(|cli| cli.run(Ranks::alone())) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            tell(&error);
            ExitCode::from(error.exit_code())
        }
    }
}

/// Says why a command ended early.
fn tell(error: &CliError) {
    match error {
        CliError::Typed(error) => drop(error.print()),
        // A closed stderr is no error: nobody would see a message.
        error => drop(stderr().write_all(printable_lines(&error.explain()).as_bytes())),
    }
}

/// Runs the command line on all ranks.
fn among_others(connect: Connect) -> ExitCode {
    let work = |ranks: &Ranks| {
        // Nobody has begun threads before.
        drop(rayon::ThreadPoolBuilder::new().num_threads(ranks.machine_share().threads).build_global());
        same_arguments(ranks)?;
        let Err(error) = Cli::typed().and_then(|cli| cli.run(ranks)) else { return Ok(()) };
        let is_told = matches!(error, CliError::Typed(_));
        if is_told && ranks.is_first() {
            tell(&error);
        }
        let message = if is_told { String::new() } else { error.explain() };
        match error.exit_code() {
            0 => Ok(()),
            code => Err(Failure { code, message }),
        }
    };
    let tell = |message: &str| drop(stderr().write_all(printable_lines(message).as_bytes()));
    connect(&work, &tell).unwrap_or_else(alone)
}

/// Refuses ranks that were started to do different things: they would wait for each other.
fn same_arguments(ranks: &Ranks) -> Result<(), Failure> {
    let own: Vec<String> =
        args_os().skip(1).map(|argument| argument.to_string_lossy().into_owned()).collect();
    let Some(other) = ranks.differing(own) else { return Ok(()) };
    let error = CliError::refused(
        format!("rank {other} was started with other arguments than rank 0"),
        "start all ranks with the same command line: they share the work of one run",
    );
    Err(Failure { code: error.exit_code(), message: error.explain() })
}

/// Refuses to run one command several times.
fn refuse_others(number: &str) -> ExitCode {
    /// Variables of which one holds the number of processes; that of Slurm is for steps that it starts
    /// itself, by PMIx.
    const COUNTS: [&str; 3] = ["OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"];
    let count = COUNTS.iter().find_map(|name| var(name).ok()?.parse::<usize>().ok());
    if count.is_none_or(|count| count < 2) {
        return alone();
    }
    let error = CliError::refused(
        "several processes were started, but this program was built without MPI, by which they share their work",
        "build it with `cargo build --release --features mpi` (docs/ranks.md), or start one process",
    );
    if number == "0" {
        tell(&error);
    }
    ExitCode::from(error.exit_code())
}
