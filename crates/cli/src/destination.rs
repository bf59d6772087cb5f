//! Where a table goes: a file, or standard output.

use std::io::{self, BufWriter, ErrorKind, Write, stdout};

use radiosity_work::ranks::Ranks;

use crate::{error::CliError, output_file::OutputFile};

/// A file, or standard output.
#[derive(Debug)]
pub(crate) enum Destination {
    /// This file.
    File(OutputFile),
    /// Standard output.
    Stdout,
    /// That of another rank.
    Elsewhere,
}

impl Destination {
    /// This file, or the standard output of the first of these ranks.
    pub(crate) fn of(file: Option<OutputFile>, ranks: &Ranks) -> Self {
        match file {
            Some(file) => Self::File(file),
            None if ranks.is_first() => Self::Stdout,
            None => Self::Elsewhere,
        }
    }

    /// Has `write` write the whole table. A closed pipe is no error, so that other outputs follow.
    pub(crate) fn write(&self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), CliError> {
        match self {
            Self::File(file) => file.write(|writer| write(writer)),
            Self::Elsewhere => Ok(()),
            Self::Stdout => {
                let mut writer = BufWriter::new(stdout().lock());
                match write(&mut writer).and_then(|()| writer.flush()) {
                    Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
                    ended => Ok(ended?),
                }
            }
        }
    }
}
