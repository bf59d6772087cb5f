//! Errors of light gathered by rays, over all points or cells.

use std::fmt;

use radiosity_solve::gather::read_irradiance::Deviation;
use radiosity_work::wording::{option, words};
use serde::Serialize;

use crate::warning::Warning;
use radiosity_work::digits::decimals;

/// Errors of readings, over those asked for, that are worth a warning. Chosen.
const MISSED: f64 = 1.5;

/// Standard deviations of readings by rays, relative to each.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ReadError {
    /// Root mean square of the relative deviations.
    pub rms: f64,
    /// Largest relative deviation.
    pub largest: f64,
    /// Number of readings that are left out, as theirs are small relative to the light of the scene: in narrow gaps,
    /// in shadow, of less than 2 % of the scene's mean radiosity in a band, and of cells of less than its usual
    /// irradiance.
    pub dark: usize,
}

impl ReadError {
    /// The errors of these readings; None where light was not gathered by rays, or in dark places alone.
    pub fn of(readings: impl Iterator<Item = Option<Deviation>>) -> Option<Self> {
        let (dim, deviations): (Vec<Deviation>, Vec<Deviation>) =
            readings.flatten().partition(|deviation| deviation.is_dark);
        let squares: f64 = deviations.iter().map(|deviation| deviation.relative.powi(2)).sum();
        let largest = deviations.iter().map(|deviation| deviation.relative).reduce(f64::max)?;
        Some(Self { rms: (squares / deviations.len() as f64).sqrt(), largest, dark: dim.len() })
    }
}

impl ReadError {
    /// A warning where readings that were to err by `asked` err by much more, whose time was up or not.
    pub fn warning(&self, asked: f64, was_cut_short: bool) -> Option<Warning> {
        let message = || {
            if was_cut_short {
                let told = format!(
                    "time was up before all was read as accurately as asked for: rays leave errors of {:.1e} in what is \
                     read, {:.1e} at most, where {asked:.1e} was asked for; allow more with ",
                    self.rms, self.largest
                );
                return words(told) + option("time-limit");
            }
            let told = format!(
                "rays leave errors of {:.1e} in what is read, {:.1e} at most, where {asked:.1e} was asked for: some points \
                 see small bright things or the edges of many; ask for a smaller ",
                self.rms, self.largest
            );
            words(told) + option("read-eps") + " there"
        };
        (self.rms > MISSED * asked).then(|| Warning::general("reading-error", message()))
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [rms, largest] = [self.rms, self.largest].map(|error| decimals(100.0 * error, 2));
        write!(f, "light gathered by rays: standard deviation {rms} % of what is read, {largest} % at most")?;
        match self.dark {
            0 => Ok(()),
            dark => {
                write!(f, "; {dark} readings in dim places are as well known beside the light of the scene")
            }
        }
    }
}
