//! Data that a verb prints: their form and destination.

use std::path::PathBuf;

use clap::Args;
use radiosity_output::table::Table;
use radiosity_work::ranks::Ranks;
use serde::ser::{SerializeMap, Serializer};

use crate::{
    destination::Destination,
    error::CliError,
    format::{self, Format},
    loaded::Loaded,
    options::ReportArgs,
    output_file::OutputFile,
};

/// `--format` and `--output` of readings.
#[derive(Debug, Args)]
pub(crate) struct DataArgs {
    /// Form of the table [default: that of the file's ending, or csv]
    #[arg(long, value_name = "FORMAT")]
    format: Option<Format>,

    /// File of the table, .csv or .json [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl DataArgs {
    /// Checks, before the work, the form of the data and whether they can be written; `apart` refuses another
    /// file of the verb.
    pub(crate) fn reserve(
        &self,
        loaded: &Loaded,
        report: &ReportArgs,
        ranks: &Ranks,
        apart: impl Fn(OutputFile) -> Result<OutputFile, CliError>,
    ) -> Result<Data, CliError> {
        let reserve = |path| apart(loaded.reserve(path, report, ranks)?);
        let destination = Destination::of(self.output.as_deref().map(reserve).transpose()?, ranks);
        let format = format::chosen(self.format, self.output.as_deref(), Format::Csv)?;
        let written = self.output.as_ref().map(|path| path.display().to_string());
        Ok(Data { format, destination, written })
    }
}

/// Form and destination of data.
#[derive(Debug)]
pub(crate) struct Data {
    format: Format,
    destination: Destination,
    written: Option<String>,
}

impl Data {
    /// Writes a table with values of these bands in the form that was asked for; `rows` is the word for its
    /// rows.
    pub(crate) fn write(&self, bands: &[String], rows: &str, table: &Table) -> Result<(), CliError> {
        self.destination.write(|writer| match self.format {
            Format::Csv => table.listed().csv(writer),
            Format::Json => {
                let mut json = serde_json::Serializer::pretty(&mut *writer);
                let mut document = json.serialize_map(Some(2))?;
                document.serialize_entry("bands", bands)?;
                document.serialize_entry(rows, &table.listed())?;
                document.end()?;
                writeln!(writer)
            }
        })
    }

    /// The file of the data, if any, as it was typed.
    pub(crate) fn written(&self) -> Option<&str> {
        self.written.as_deref()
    }
}
