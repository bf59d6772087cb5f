//! Where a table goes: a file, or standard output.

use std::io::{self, BufWriter, ErrorKind, Write, stdout};

use radiosity_work::ranks;

use crate::{error::CliError, output_file::OutputFile};

/// A file, or standard output.
#[derive(Debug)]
pub(crate) enum Destination {
    /// This file.
    File(OutputFile),
    /// Standard output.
    Stdout,
}

impl From<Option<OutputFile>> for Destination {
    fn from(file: Option<OutputFile>) -> Self {
        file.map_or(Self::Stdout, Self::File)
    }
}

impl Destination {
    /// Has `write` write the whole table. A closed pipe is no error, so that other outputs follow.
    pub(crate) fn write(&self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), CliError> {
        match self {
            Self::File(file) => file.write(|writer| write(writer)),
            Self::Stdout if !ranks::current().is_first() => Ok(()),
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
