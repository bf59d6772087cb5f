//! Output files that are written wholly or not at all.

use std::{
    fs::{File, OpenOptions},
    io::{self, BufWriter, Write},
    path::{Path, PathBuf},
};

use radiosity_work::ranks::Ranks;
use tempfile::{Builder, NamedTempFile};

use crate::error::CliError;
use crate::interrupt::temporary_files;

/// A file that will be written. The text goes to a temporary file in the same folder, which takes the file's
/// name when it is complete.
#[derive(Debug)]
pub(crate) struct OutputFile {
    typed: PathBuf,
    target: Target,
    ranks: Ranks,
}

#[derive(Debug)]
enum Target {
    /// A file of this name, or none yet; links are followed.
    Regular(PathBuf),
    /// A device or a pipe, which cannot be replaced.
    Special,
    /// A file that another rank writes.
    Elsewhere,
}

impl OutputFile {
    /// Finds out whether `path` can be written by the first of these ranks, before any long work. Leaves no
    /// file behind.
    ///
    /// # Errors
    /// [`CliError::Refused`] for `-`, a folder, or a file in a folder that does not exist or cannot be
    /// written to.
    pub(crate) fn reserve(path: &Path, ranks: &Ranks) -> Result<Self, CliError> {
        if path == Path::new("-") {
            let cure = "without -o tables go to standard output; ./- is a file of that name";
            return Err(CliError::refused("-: an output needs a name", cure));
        }
        let target = match ranks.is_first() {
            true => target(path).map_err(|reason| {
                let cure = "choose a file in a folder that exists and can be written to";
                CliError::refused(format!("{}: cannot be written: {reason}", path.display()), cure)
            })?,
            false => Target::Elsewhere,
        };
        // Where the first fails, no other goes on.
        ranks.meet();
        Ok(OutputFile { typed: path.to_owned(), target, ranks: ranks.clone() })
    }

    /// Whether another rank writes the output.
    pub(crate) fn is_elsewhere(&self) -> bool {
        matches!(self.target, Target::Elsewhere)
    }

    /// This output, if it is another file than `path`, if there is one, which belongs to `what`.
    ///
    /// # Errors
    /// [`CliError::Refused`] if both are one file, through links or not.
    pub(crate) fn apart_from(self, path: Option<&Path>, what: &str) -> Result<Self, CliError> {
        let is_same = match (&self.target, path) {
            (Target::Regular(own), Some(path)) => resolved(path).is_ok_and(|path| path == *own),
            _ => false,
        };
        if self.ranks.of_first(is_same) {
            let message = format!("{}: this is the file of {what} as well", self.typed.display());
            return Err(CliError::refused(message, "choose another name"));
        }
        Ok(self)
    }

    /// Has `write` write the whole output, then puts it in place.
    ///
    /// # Errors
    /// [`CliError::Unwritten`] if anything fails; the old file at the path is then unchanged.
    pub(crate) fn write(
        &self,
        write: impl FnOnce(&mut BufWriter<&File>) -> io::Result<()>,
    ) -> Result<(), CliError> {
        self.pending(write)?.put()
    }

    /// Has `write` write the whole output, which [`PendingOutput::put`] puts in place: for files that belong
    /// together.
    ///
    /// # Errors
    /// [`CliError::Unwritten`] if anything fails; the old file at the path is then unchanged.
    pub(crate) fn pending(
        &self,
        write: impl FnOnce(&mut BufWriter<&File>) -> io::Result<()>,
    ) -> Result<PendingOutput<'_>, CliError> {
        let temporary = self.try_fill(write).map_err(|reason| self.unwritten(reason))?;
        Ok(PendingOutput { output: self, temporary })
    }

    /// An empty file for another program to fill, which [`OutputFile::put`] puts in place; nothing stays of
    /// it if it never is.
    ///
    /// # Errors
    /// [`CliError::Unwritten`]
    pub(crate) fn draft(&self) -> Result<Draft, CliError> {
        match &self.target {
            Target::Special | Target::Elsewhere => Ok(Draft { path: self.typed.clone(), temporary: None }),
            Target::Regular(path) => {
                let temporary = Temporary::beside(path).map_err(|reason| self.unwritten(reason))?;
                Ok(Draft { path: temporary.file.path().to_owned(), temporary: Some(temporary) })
            }
        }
    }

    /// Puts in place what another program filled.
    ///
    /// # Errors
    /// [`CliError::Unwritten`]; the old file at the path is then unchanged.
    pub(crate) fn put(&self, draft: Draft) -> Result<(), CliError> {
        PendingOutput { output: self, temporary: draft.temporary }.put()
    }

    /// The error of an output whose writing failed.
    pub(crate) fn unwritten(&self, reason: io::Error) -> CliError {
        CliError::Unwritten { path: self.typed.clone(), reason }
    }

    /// Writes the temporary file; None where the output needs none.
    fn try_fill(
        &self,
        write: impl FnOnce(&mut BufWriter<&File>) -> io::Result<()>,
    ) -> io::Result<Option<Temporary>> {
        let fill = |file: &File| {
            let mut writer = BufWriter::new(file);
            write(&mut writer)?;
            writer.flush()
        };
        match &self.target {
            Target::Elsewhere => Ok(None),
            Target::Special => fill(&OpenOptions::new().write(true).open(&self.typed)?).map(|()| None),
            Target::Regular(path) => {
                let temporary = Temporary::beside(path)?;
                fill(temporary.file.as_file())?;
                Ok(Some(temporary))
            }
        }
    }
}

/// A file for another program to fill.
#[derive(Debug)]
pub(crate) struct Draft {
    path: PathBuf,
    temporary: Option<Temporary>,
}

impl Draft {
    /// The file.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }
}

/// An output that is written and not yet in place; nothing stays of it if it never is.
pub(crate) struct PendingOutput<'a> {
    output: &'a OutputFile,
    temporary: Option<Temporary>,
}

impl PendingOutput<'_> {
    /// Puts the output in place.
    ///
    /// # Errors
    /// [`CliError::Unwritten`]; the old file at the path is then unchanged.
    pub(crate) fn put(self) -> Result<(), CliError> {
        let (Target::Regular(path), Some(temporary)) = (&self.output.target, self.temporary) else {
            return Ok(());
        };
        temporary.take_name(path).map_err(|reason| self.output.unwritten(reason))
    }
}

fn target(path: &Path) -> io::Result<Target> {
    match path.metadata() {
        Ok(metadata) if metadata.is_dir() => Err(io::Error::other("it is a folder")),
        Ok(metadata) if !metadata.is_file() => {
            OpenOptions::new().write(true).open(path).map(|_| Target::Special)
        }
        _ => {
            let path = resolved(path).map_err(|error| told(&error))?;
            drop(Temporary::beside(&path)?);
            Ok(Target::Regular(path))
        }
    }
}

/// The path without links, where a file is or can be made.
fn resolved(path: &Path) -> io::Result<PathBuf> {
    if path.exists() {
        return path.canonicalize();
    }
    let name = path.file_name().ok_or_else(|| io::Error::other("it names no file"))?;
    Ok(folder(path).canonicalize()?.join(name))
}

fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// A temporary file that Ctrl-C removes.
#[derive(Debug)]
struct Temporary {
    file: NamedTempFile,
}

impl Temporary {
    /// A temporary file in the folder of `path`.
    fn beside(path: &Path) -> io::Result<Self> {
        let mut files = temporary_files();
        let file = temporary_beside(path)?;
        files.insert(file.path().to_owned());
        Ok(Self { file })
    }

    /// Gives the file the name `path`, in place of an older one.
    fn take_name(self, path: &Path) -> io::Result<()> {
        let mut files = temporary_files();
        let own = self.file.path().to_owned();
        let named = self.file.persist(path).map(drop).map_err(|error| error.error);
        files.remove(&own);
        named
    }
}

/// A temporary file in the folder of `path`, with the permissions an ordinary new file has.
fn temporary_beside(path: &Path) -> io::Result<NamedTempFile> {
    if path.file_name().is_none() {
        return Err(io::Error::other("it names no file"));
    }
    let mut builder = Builder::new();
    builder.prefix(".radiosity-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder(path)).map_err(|error| told(&error))
}

/// The system's message only: the temporary name would confuse.
fn told(error: &io::Error) -> io::Error {
    match error.kind() {
        io::ErrorKind::NotFound => io::Error::other("its folder does not exist"),
        io::ErrorKind::Other => io::Error::other(error.to_string()),
        kind => io::Error::from(kind),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn a_failed_write_leaves_the_old_file_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.txt");
        fs::write(&path, "old").unwrap();
        let output = OutputFile::reserve(&path, Ranks::alone()).unwrap();
        let failed = output.write(|file| {
            file.write_all(b"half of it")?;
            Err(io::Error::other("no more"))
        });
        assert!(matches!(failed, Err(CliError::Unwritten { .. })));
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        output.write(|file| file.write_all(b"new")).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "new");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn of_two_files_that_belong_together_none_is_new_where_one_fails() {
        let folder = tempfile::tempdir().unwrap();
        let [first, second] = ["a", "b"].map(|name| folder.path().join(name));
        fs::write(&first, "old").unwrap();
        let [one, other] = [&first, &second].map(|path| OutputFile::reserve(path, Ranks::alone()).unwrap());
        let pending = one.pending(|file| file.write_all(b"new")).unwrap();
        assert!(other.pending(|_| Err(io::Error::other("no more"))).is_err());
        drop(pending);
        assert_eq!(fs::read_to_string(&first).unwrap(), "old");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn reserving_creates_nothing() {
        let folder = tempfile::tempdir().unwrap();
        OutputFile::reserve(&folder.path().join("out.txt"), Ranks::alone()).unwrap();
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn folders_and_files_in_no_folder_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        for path in [folder.path().to_owned(), folder.path().join("none/out.txt")] {
            assert!(matches!(OutputFile::reserve(&path, Ranks::alone()), Err(CliError::Refused { .. })));
        }
    }

    #[cfg(unix)]
    #[test]
    fn devices_are_written_to_not_replaced() {
        use std::os::unix::fs::FileTypeExt;
        let null = Path::new("/dev/null");
        OutputFile::reserve(null, Ranks::alone()).unwrap().write(|file| file.write_all(b"gone")).unwrap();
        assert!(fs::metadata(null).unwrap().file_type().is_char_device());
    }
}
