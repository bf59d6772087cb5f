//! `--checkpoint` and `--resume`: a run that is recorded, and goes on where it was ended; `--transfers`: a file of
//! transfers, which other runs take up.

use std::env::current_exe;
use std::fmt::Debug;
use std::fs;
use std::hash::{DefaultHasher, Hasher};
use std::io;
use std::path::{Path, PathBuf};

use clap::Args;
use radiosity_scene::Scene;
use radiosity_solve::geometry;
use radiosity_work::ranks::Ranks;
use radiosity_work::ranks::journal::{Begin, fingerprint};

use crate::error::CliError;
use crate::typed_options::TypedOptions;

/// Where a run is recorded.
#[derive(Debug, Args)]
#[command(next_help_heading = "Checkpoint")]
pub(crate) struct CheckpointArgs {
    /// Folder in which work is recorded as it is done: the same command with --resume goes on from there if
    /// this one is killed
    #[arg(long, value_name = "FOLDER")]
    checkpoint: Option<PathBuf>,

    /// Goes on from what --checkpoint holds, or begins where it holds nothing yet, with any number of threads
    /// and processes; results are those of one run, bit for bit
    #[arg(long, requires = "checkpoint")]
    resume: bool,

    /// File of the transfers between the surfaces, which is made where there is none: runs on the same surfaces, with
    /// other materials, temperatures or lamps, find none of them again; those of other options are added
    #[arg(long, value_name = "FILE", conflicts_with = "checkpoint")]
    transfers: Option<PathBuf>,
}

impl CheckpointArgs {
    /// The ranks, which record their work if `--checkpoint` was typed, and keep the transfers of `scene` if
    /// `--transfers` was. Results depend on the options `given`, on `content`, and on the files that the verb `reads`
    /// besides: all ranks must have the same.
    ///
    /// # Errors
    /// Ranks that differ; a folder or a file that does not hold what was asked for, or cannot be written.
    pub(crate) fn recording(
        &self,
        given: &TypedOptions,
        content: &dyn Debug,
        scene: &Scene,
        reads: &[Option<&Path>],
        ranks: &Ranks,
    ) -> Result<Ranks, CliError> {
        if self.checkpoint.is_none() && ranks.are_alone() {
            return self.keeping(scene, ranks);
        }
        if self.transfers.is_some() {
            return Err(CliError::refused(
                "--transfers: several processes share no file of transfers",
                "run one process, or record the run with --checkpoint FOLDER",
            ));
        }
        let reads =
            reads.iter().flatten().filter(|path| self.checkpoint.is_some() || **path != Path::new("-"));
        let reads = reads.map(|path| file(path)).collect::<Result<Vec<_>, _>>()?;
        let run = fingerprint(&(program()?, given, content, reads));
        if let Some(other) = ranks.differing(run) {
            return Err(CliError::refused(
                format!("rank {other} is another build of this program than rank 0, or reads other files"),
                "start the same build on all nodes, and let all ranks read the same files",
            ));
        }
        let Some(folder) = &self.checkpoint else { return Ok(ranks.clone()) };
        let begin = if self.resume { Begin::Resume } else { Begin::Anew };
        Ok(ranks.recording(folder, run, begin)?)
    }

    /// This rank, with the transfers of `scene` in their file, if one was typed.
    fn keeping(&self, scene: &Scene, ranks: &Ranks) -> Result<Ranks, CliError> {
        match &self.transfers {
            Some(path) => Ok(ranks.keeping_transfers(path, geometry(scene))?),
            None => Ok(ranks.clone()),
        }
    }
}

/// A hash of this program's file: builds of one version may differ in numbers.
fn program() -> Result<u64, CliError> {
    let cure = "allow it to read its own file: ranks, and runs that go on, must be of one build";
    let unreadable = "the program cannot be told from others, its file cannot be read";
    let refused = |reason| CliError::refused(format!("{unreadable}: {reason}"), cure);
    current_exe().and_then(|path| number(&path)).map_err(refused)
}

/// A hash of a file's content; None where it cannot be read, which is told where it is needed.
fn file(path: &Path) -> Result<Option<u64>, CliError> {
    if path == Path::new("-") {
        return Err(CliError::refused(
            "--checkpoint: points from standard input cannot be told from others",
            "save them to a file, and give its path",
        ));
    }
    Ok(number(path).ok())
}

fn number(path: &Path) -> io::Result<u64> {
    let mut hashed = DefaultHasher::new();
    hashed.write(&fs::read(path)?);
    Ok(hashed.finish())
}
