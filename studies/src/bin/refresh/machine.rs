//! The commit and the machine of a run.

use std::error::Error;
use std::fs;
use std::path::PathBuf;
use std::thread::available_parallelism;

use radiosity_test_support::documents::stamp::Stamp;

use crate::line_of;

/// Letters of a commit.
const LETTERS: &str = "--short=8";

/// Sources whose changes count: not the documents, which are being written, and their pictures.
const SOURCES: [&str; 4] = [".", ":!docs", ":!*.md", ":!.ci"];

/// The stamp of what is made now.
pub(crate) fn stamp() -> Result<Stamp, Box<dyn Error>> {
    let head = line_of("git", &["rev-parse", LETTERS, "HEAD"])?;
    let status = ["status", "--porcelain", "--untracked-files=no", "--"];
    let changed = line_of("git", &[&status[..], &SOURCES].concat())?;
    let commit = if changed.is_empty() { head } else { format!("{head} with changes") };
    let day = line_of("date", &["+%Y-%m-%d"])?;
    Ok(Stamp { commit, day, machine: format!("{} × {}", available_parallelism()?, processor()) })
}

/// Its name as Linux tells it, without marks of trade; elsewhere its kind.
fn processor() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let named = info.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    let name = named.map_or(std::env::consts::ARCH.to_owned(), |(_, name)| name.trim().to_owned());
    name.replace("(R)", "").replace("(TM)", "")
}

/// The folder of the binaries of this build, with the command as the sources have it.
pub(crate) fn binaries() -> Result<PathBuf, Box<dyn Error>> {
    line_of("cargo", &["build", "-qr"])?;
    let own = std::env::current_exe()?;
    Ok(own.parent().ok_or("a program lies in a folder")?.to_owned())
}
