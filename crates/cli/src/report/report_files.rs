//! The files of a report: one of HTML, or Markdown with its pictures.

use std::path::Path;

use clap::ValueEnum;
use radiosity_output::documents::document::{Block, Document};
use radiosity_output::documents::{html, markdown};

use crate::error::CliError;
use crate::format;
use crate::output_file::OutputFile;

/// The files of a report, reserved before the work.
#[derive(Debug)]
pub(super) struct ReportFiles {
    kind: ReportFormat,
    page: OutputFile,
    path: String,
}

#[derive(Debug)]
enum ReportFormat {
    Html,
    Markdown {
        /// The name of the text without its ending.
        stem: String,
        figures: Vec<FigureFile>,
    },
}

/// Ending of the name of a report.
#[derive(Clone, Copy, ValueEnum)]
enum Ending {
    #[value(alias = "htm")]
    Html,
    Md,
}

/// The file of a figure.
#[derive(Debug)]
struct FigureFile {
    /// Name of the figure.
    figure: String,
    file: OutputFile,
}

impl ReportFiles {
    /// The files that the ending of `path` tells, for a document with these figures; `reserve` finds out
    /// whether one can be written.
    pub(super) fn reserve(
        path: &Path,
        figures: &[String],
        reserve: impl Fn(&Path) -> Result<OutputFile, CliError>,
    ) -> Result<Self, CliError> {
        let cure = "choose a file ending in .html (one file with all) or .md (with pictures beside it)";
        let kind = match format::of_kind(path, "kind of report", cure)? {
            Ending::Html => ReportFormat::Html,
            Ending::Md => {
                let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
                let file = |figure: &String| {
                    let path = path.with_file_name(markdown::picture_name(&stem, figure));
                    Ok(FigureFile { figure: figure.clone(), file: reserve(&path)? })
                };
                let figures = figures.iter().map(file).collect::<Result<_, CliError>>()?;
                ReportFormat::Markdown { stem, figures }
            }
        };
        Ok(Self { kind, page: reserve(path)?, path: path.display().to_string() })
    }

    /// Writes the document: pictures first, so that no text lacks them.
    pub(super) fn write(&self, document: &Document) -> Result<(), CliError> {
        match &self.kind {
            ReportFormat::Html => self.page.write(|writer| html::write(document, writer)),
            ReportFormat::Markdown { stem, figures } => {
                for block in &document.blocks {
                    let Block::Figure(figure) = block else { continue };
                    let own = figures.iter().find(|own| own.figure == figure.name);
                    let FigureFile { file, .. } = own.expect("its file was reserved");
                    file.write(|writer| figure.picture.write_png(writer))?;
                }
                self.page.write(|writer| markdown::write(document, stem, writer))
            }
        }
    }

    /// Path of the report and number of pictures beside it, for the summary.
    pub(super) fn written(&self) -> String {
        match &self.kind {
            ReportFormat::Markdown { figures, .. } => match figures.len() {
                0 => self.path.clone(),
                1 => format!("{} and a picture beside it", self.path),
                count => format!("{} and {count} pictures beside it", self.path),
            },
            ReportFormat::Html => self.path.clone(),
        }
    }
}
