//! Work and error of one run: a row of the CSV.

use std::path::Path;

use serde::{Deserialize, Serialize};

/// A run with its settings, work and error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Record {
    /// The study it belongs to.
    pub(crate) scene: String,
    /// `default`, `gathered`, `paper-legendre` or `paper-hybrid`.
    pub(crate) kernel: String,
    /// Degree of the polynomials.
    pub(crate) order: usize,
    /// Layers of graded elements.
    pub(crate) layers: usize,
    /// Cuts along each side of a surface; 0 where the scene chooses.
    pub(crate) cells: usize,
    /// Accuracy of the transfers.
    pub(crate) eps: f64,
    /// Coefficients per band.
    pub(crate) unknowns: usize,
    /// Terms of the kernel's quadrature rules.
    pub(crate) samples: u64,
    /// Segments tested for visibility.
    pub(crate) rays: u64,
    /// CPU time of one thread (s).
    pub(crate) seconds: f64,
    /// Relative error, as its study judges it.
    pub(crate) error: f64,
}

/// Writes the runs as CSV.
pub(crate) fn write(path: &Path, records: &[Record]) -> csv::Result<()> {
    let mut writer = csv::Writer::from_path(path)?;
    records.iter().try_for_each(|record| writer.serialize(record))?;
    Ok(writer.flush()?)
}

/// Reads them back.
pub(crate) fn read(path: &Path) -> csv::Result<Vec<Record>> {
    csv::Reader::from_path(path)?.deserialize().collect()
}
