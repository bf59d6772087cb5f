//! Requests for the reading of a solution, and the accuracy that a solution is worth being read to.

use radiosity_reading::grid::Rates;
use radiosity_reading::quality::ReadSettings;
use radiosity_reading::reader::ReadMode;
use radiosity_solve::Options;
use radiosity_solve::gather::gather_method::GatherMethod;
use radiosity_solve::solved::Solved;
use radiosity_solve::studies::adaptation::{Aim, Goal};
use radiosity_visibility::Hiding;
use radiosity_work::wording::{Wording, option, set, value, words};

use super::method::MethodRequest;
use super::refusal::Refusal;

/// Accuracy that a solution by rays is worth being read to. Chosen: its own error is some percent, of which
/// this adds little.
const BY_RAYS: f64 = 1e-2;

/// Request for the reading of a solution; None where nothing was said.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ReadRequest {
    /// Source of irradiance: polynomials or recomputed light.
    pub read: Option<ReadMode>,
    /// Method of gathering: by cells or by rays.
    pub by: Option<GatherMethod>,
    /// Relative accuracy of recomputed light.
    pub eps: Option<f64>,
    /// Points along each side of a cell; light is then gathered by cells.
    pub samples: Option<Rates>,
}

impl ReadRequest {
    /// Refuses what would have no effect on the reading of a solution with these options, or an accuracy of
    /// what is not read.
    ///
    /// # Errors
    /// The first such option.
    pub fn check(&self, options: &Options, method: &MethodRequest) -> Result<(), Refusal> {
        check_aim(self.read, method)?;
        let refuse = |message: Wording, cure: Wording| Err(Refusal::new(message, cure));
        match self.read {
            Some(ReadMode::Basis) if self.eps.is_some() => refuse(
                option("read-eps")
                    + " is the accuracy of recomputed light, and "
                    + set("read", "basis")
                    + " recomputes none",
                words("leave one of them out"),
            ),
            Some(ReadMode::Basis | ReadMode::Direct) if self.by.is_some() => refuse(
                option("read-by")
                    + " says by what light is gathered, and "
                    + set("read", "basis")
                    + " and "
                    + value("direct")
                    + " gather none",
                words("leave one of them out, or take ") + set("read", "gather"),
            ),
            _ if self.by == Some(GatherMethod::Rays)
                && (options.masks.is_some() || options.shadows == Hiding::Off) =>
            {
                refuse(
                    set("read-by", "rays")
                        + " always sees exact shadows, and the solution has others: "
                        + set("shadows", "mask")
                        + " or "
                        + value("off"),
                    words("take ") + set("read-by", "cells") + ", or solve with other shadows",
                )
            }
            _ if self.by == Some(GatherMethod::Rays) && self.samples.is_some() => refuse(
                option("read-samples")
                    + " counts points, and "
                    + set("read-by", "rays")
                    + " sends rays until their error is small",
                words("leave one of them out; ") + option("read-eps") + " says how small",
            ),
            _ => Ok(()),
        }
    }

    /// The reading that was asked for; the rest as the quality says.
    pub fn plain(&self, method: &MethodRequest) -> ReadSettings {
        let usual = method.quality.reading();
        self.asked(usual, method.eps.unwrap_or(usual.eps))
    }

    /// The reading that was asked for; the accuracy `eps` where none was, and the rest as in `usual`.
    fn asked(&self, usual: ReadSettings, eps: f64) -> ReadSettings {
        ReadSettings {
            read: self.read.unwrap_or(usual.read),
            // Rays count no points.
            by: if self.samples.is_some() { GatherMethod::Cells } else { self.by.unwrap_or_default() },
            eps: self.eps.unwrap_or(eps),
            rates: self.samples.unwrap_or(usual.rates),
        }
    }

    /// The reading that was asked for; the rest as the quality and the solution say; no coarser than the
    /// accuracy of the solution, where one was asked for. `is_saved`: the solution was read from a file.
    pub fn reading(&self, method: &MethodRequest, solved: &Solved, is_saved: bool) -> ReadSettings {
        let usual = method.quality.reading();
        let is_sampled = solved.outcome.sampling.is_some();
        let of_solution = if is_sampled { usual.eps.max(BY_RAYS) } else { usual.eps };
        let saved = if is_saved { saved_accuracy(solved) } else { None };
        let asked = [method.eps, method.wanted_accuracy().map(Goal::reading), saved].into_iter().flatten();
        self.asked(usual, asked.fold(of_solution, f64::min))
    }
}

/// Relative accuracy that a solution read from a file is worth being read to, where that is finer than usual.
fn saved_accuracy(solved: &Solved) -> Option<f64> {
    let Solved { options, achieved, .. } = solved;
    match achieved {
        Some(achieved) => achieved.wanted.or(achieved.estimate).map(Goal::reading),
        None => Some(options.eps).filter(|eps| *eps < Options::default().eps),
    }
}

/// Refuses an accuracy of gathered light where polynomials are read.
///
/// # Errors
/// If that is what was asked for.
pub fn check_aim(read: Option<ReadMode>, method: &MethodRequest) -> Result<(), Refusal> {
    let is_of_gathered = method.wanted_accuracy().is_some() && method.aim != Some(Aim::Solution);
    match read {
        Some(ReadMode::Basis | ReadMode::Direct) if is_of_gathered => Err(Refusal::new(
            option("accuracy")
                + " is that of gathered light, and "
                + set("read", "basis")
                + " and "
                + value("direct")
                + " read polynomials",
            words("add ") + set("for", "solution") + ", or take " + set("read", "gather"),
        )),
        _ => Ok(()),
    }
}
