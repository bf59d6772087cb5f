//! Commands of documents, run.

use std::env::{self, JoinPathsError};
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use tempfile::TempDir;

use crate::documents::steps::{Kind, Step};

/// Pages that lead from nothing to a result. Their commands follow each other in a folder of their own, where
/// nothing is but the examples, and what the page has its reader write.
pub const WALKS: [&str; 3] = ["README.md", "docs/room.md", "docs/enclosure.md"];

/// Documents with the output of commands that are run in the root, each by itself.
pub const TABLES: [&str; 2] = ["docs/measured.md", "benches/README.md"];

/// Documents that repeat numbers of these tables.
pub const QUOTING: [&str; 3] = ["docs/limits.md", "docs/theory/scale.md", "docs/theory/visibility.md"];

/// How walks call the command where they do not call it by its name.
const BY_CARGO: &str = "cargo run -qr -- ";

/// Where commands are run.
pub struct Shell {
    folder: PathBuf,
    /// The folder of a walk, as long as that takes.
    own: Option<TempDir>,
    path: OsString,
}

impl Shell {
    /// In the root of the repository.
    pub fn at(root: &Path) -> Self {
        Self { folder: root.to_owned(), own: None, path: env::var_os("PATH").unwrap_or_default() }
    }

    /// In a folder of its own, where `radiosity` is what lies among these binaries.
    ///
    /// # Errors
    /// A folder that cannot be made.
    pub fn of_walk(root: &Path, binaries: &Path) -> io::Result<Self> {
        let own = tempfile::tempdir()?;
        let folder = own.path().to_owned();
        std::os::unix::fs::symlink(root.join("examples"), folder.join("examples"))?;
        fs::create_dir(folder.join("docs"))?;
        let path = path_with(binaries).map_err(io::Error::other)?;
        Ok(Self { folder, own: Some(own), path })
    }

    /// Does a step, and returns what its command prints; drawings only where these are wanted.
    ///
    /// # Errors
    /// A command that fails, or a file that cannot be written.
    pub fn done(&self, step: &Step, draws: bool) -> Result<String, String> {
        match &step.kind {
            Kind::File { name, text } => {
                let written = fs::write(self.folder.join(name), text);
                written.map(|()| String::new()).map_err(|why| format!("{name}: {why}"))
            }
            Kind::Drawn if !draws => Ok(String::new()),
            _ => self.printed(&step.command),
        }
    }

    /// The standard output of a command.
    ///
    /// # Errors
    /// A command that fails, with what it says.
    pub fn printed(&self, command: &str) -> Result<String, String> {
        let typed = match (command.strip_prefix(BY_CARGO), &self.own) {
            (Some(typed), Some(_)) => format!("radiosity {typed}"),
            _ => command.to_owned(),
        };
        let mut shell = Command::new("bash");
        shell.args(["-o", "pipefail", "-c", &typed]).env("PATH", &self.path).current_dir(&self.folder);
        let ran = shell.stdin(Stdio::null()).output();
        let ran = ran.map_err(|why| format!("'{command}' could not be run: {why}"))?;
        if !ran.status.success() {
            return Err(format!("'{command}' fails: {}", String::from_utf8_lossy(&ran.stderr)));
        }
        String::from_utf8(ran.stdout).map_err(|_| format!("what '{command}' prints is no text"))
    }

    /// The pictures of a page that its commands have drawn: names relative to the page, and files.
    pub fn pictures(&self, text: &str) -> Vec<(String, PathBuf)> {
        let shown = text.split("![").skip(1).filter_map(|rest| rest.split_once("](")?.1.split(')').next());
        let drawn = shown.map(|name| (name.to_owned(), self.folder.join(name)));
        drawn.filter(|(_, file)| file.exists()).collect()
    }
}

fn path_with(binaries: &Path) -> Result<OsString, JoinPathsError> {
    let others = env::var_os("PATH").unwrap_or_default();
    env::join_paths([binaries.to_owned()].into_iter().chain(env::split_paths(&others)))
}
