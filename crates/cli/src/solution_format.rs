//! The form of a solution's file: JSON, which other verbs read, or a grid of VTK.

use std::path::Path;

use radiosity_reading::files::solution_file::SolutionFile;
use radiosity_reading::files::vtu::{Grid, VtuError};
use radiosity_reading::quality::ReadSettings;
use radiosity_request::{MethodRequest, ReadRequest};
use radiosity_solve::Options;
use radiosity_solve::solved::Solved;

use crate::{error::CliError, output_file::OutputFile};

/// The form of a solution's file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SolutionFormat {
    /// All there is, to be read back.
    Json,
    /// Cells of VTK.
    Vtu,
}

impl SolutionFormat {
    /// The grid where `path` ends in .vtu, else JSON.
    pub(crate) fn of(path: &Path) -> Self {
        let is_vtu = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("vtu"));
        if is_vtu { Self::Vtu } else { Self::Json }
    }

    /// Refuses, before the work, what cannot be written of a solution with these options.
    pub(crate) fn check(self, path: &Path, options: &Options) -> Result<(), CliError> {
        match self {
            Self::Vtu if options.masks.is_some() => Err(no_grid(path, &VtuError::Masked)),
            _ => Ok(()),
        }
    }

    /// The reading by which a solution that was written is checked, as those read it who get the file: cells of
    /// VTK are its polynomials.
    pub(crate) fn reading(self, method: &MethodRequest, solved: &Solved, is_saved: bool) -> ReadSettings {
        let reading = if self == Self::Vtu { ReadRequest::of_polynomials } else { ReadRequest::of_written };
        reading(method, solved, is_saved)
    }

    /// Writes `solved` to the file at `path`; returns the words of the summary.
    pub(crate) fn write(self, solved: &Solved, path: &Path, output: &OutputFile) -> Result<String, CliError> {
        if self == Self::Json {
            let file = SolutionFile::new(solved);
            output.write(|writer| Ok(serde_json::to_writer(writer, &file)?))?;
            return Ok(path.display().to_string());
        }
        let grid = Grid::new(&solved.scene, &solved.outcome.solution);
        let grid = grid.map_err(|reason| no_grid(path, &reason))?;
        output.write(|writer| grid.write(writer))?;
        let (cells, points, deviation) = (grid.cells(), grid.points(), grid.deviation());
        let figures = format!("{cells} cells, {points} points, within {deviation:.1e} of the surfaces");
        Ok(format!("{} ({figures})", path.display()))
    }
}

/// The error of a solution that is no grid of VTK.
fn no_grid(path: &Path, reason: &VtuError) -> CliError {
    CliError::refused(format!("{}: {reason}", path.display()), reason.cure().to_string())
}
