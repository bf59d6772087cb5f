//! Why a journal cannot be kept.

use std::io;
use std::path::{Path, PathBuf};

/// Why a journal cannot be kept.
#[derive(Debug, thiserror::Error)]
pub enum JournalError {
    /// The folder or a file of it cannot be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The folder or the file.
        path: PathBuf,
        /// Error of the system.
        source: io::Error,
    },
    /// The folder holds a journal, and nothing says that the run goes on from it.
    #[error("{}: a run was recorded here", path.display())]
    Used {
        /// The folder.
        path: PathBuf,
    },
    /// The folder holds the journal of an earlier version of the program, whose pieces are of no use.
    #[error("{}: this was recorded by an earlier version of this program", path.display())]
    Earlier {
        /// A file of that journal.
        path: PathBuf,
    },
    /// The file holds something else than transfers between these surfaces.
    #[error("{}: these are no transfers between the surfaces of this scene, or another version of this program kept them", path.display())]
    OtherGeometry {
        /// The file.
        path: PathBuf,
    },
    /// The file holds transfers of an earlier version of the program, which are of no use.
    #[error("{}: these transfers were kept by an earlier version of this program", path.display())]
    EarlierTransfers {
        /// The file.
        path: PathBuf,
    },
    /// Another run adds to the file of transfers.
    #[error("{}: another run adds to these transfers now", path.display())]
    Held {
        /// The file.
        path: PathBuf,
    },
    /// A file of transfers cannot be read or written.
    #[error("{}: {source}", path.display())]
    Transfers {
        /// The file.
        path: PathBuf,
        /// Error of the system.
        source: io::Error,
    },
    /// The folder holds the journal of another run.
    #[error("{}: this records a run of another scene, or with other options, or of another program", path.display())]
    Other {
        /// A file of that journal.
        path: PathBuf,
    },
}

impl JournalError {
    /// The cure, as a sentence.
    pub fn cure(&self) -> &'static str {
        match self {
            Self::File { .. } => {
                "choose a folder that exists or can be made, that can be written to and has room"
            }
            Self::Used { .. } => "add --resume to go on from there, or choose another folder",
            Self::Earlier { .. } => "start anew in another folder, or go on with the program that began it",
            Self::OtherGeometry { .. } => {
                "give the scene whose transfers are kept there, or choose a file that is not there yet"
            }
            Self::EarlierTransfers { .. } => "choose a file that is not there yet, or remove this one",
            Self::Held { .. } => "wait until that run has ended, or give each run a file of its own",
            Self::Transfers { .. } => "choose a file that can be read and written, in a folder that exists",
            Self::Other { .. } => "give the scene and the options of that run, or choose another folder",
        }
    }

    /// Whether it is about a file of transfers.
    pub fn is_of_transfers(&self) -> bool {
        match self {
            Self::OtherGeometry { .. }
            | Self::EarlierTransfers { .. }
            | Self::Held { .. }
            | Self::Transfers { .. } => true,
            Self::File { .. } | Self::Used { .. } | Self::Earlier { .. } | Self::Other { .. } => false,
        }
    }

    pub(super) fn of(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::File { path, source }
    }

    pub(super) fn of_transfers(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Transfers { path, source }
    }
}
