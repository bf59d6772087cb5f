//! Requests for the reading of a solution, and the accuracy that a solution is worth being read to.

use radiosity_reading::grid::Rates;
use radiosity_reading::quality::ReadSettings;
use radiosity_reading::reader::ReadMode;
use radiosity_solve::Options;
use radiosity_solve::gather::gather_method::GatherMethod;
use radiosity_solve::solved::Solved;
use radiosity_solve::studies::adaptation::{Achieved, Aim};
use radiosity_visibility::Shadows;
use radiosity_work::wording::{Wording, option, set, value, words};
use serde::Deserialize;

use super::aim::AccuracyOf;
use super::method::MethodRequest;
use super::ranges::{Accuracy, Number};
use super::refusal::Refusal;

/// Accuracy of readings by walks, which take four times as long for half of it. Chosen.
const BY_WALKS: f64 = 1e-2;

/// Options of the reading of a solution; None where nothing is said.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "clap", derive(clap::Args))]
pub struct ReadRequest {
    /// Light that is read [default: gather; with --quality finest gather-twice]
    #[cfg_attr(feature = "clap", arg(long, value_name = "MODE"))]
    pub read: Option<ReadMode>,

    /// By what light is gathered [default: auto]
    #[cfg_attr(feature = "clap", arg(long, value_name = "WAY"))]
    pub read_by: Option<GatherMethod>,

    /// Accuracy of recomputed light, relative, between 0 and 1 [default: 1.25e-3, as --quality says; 5e-3 of
    /// a solution by rays; less for a wanted accuracy below 4e-3: 0.3 of that]
    #[cfg_attr(feature = "clap", arg(long, value_name = "E"))]
    pub read_eps: Option<Number<Accuracy>>,

    /// Points along each side of a cell; light is then gathered by cells.
    #[serde(skip)]
    #[cfg_attr(feature = "clap", arg(skip))]
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
            Some(ReadMode::Basis) if self.read_eps.is_some() => refuse(
                option("read-eps")
                    + " is the accuracy of recomputed light, and "
                    + set("read", "basis")
                    + " recomputes none",
                words("leave one of them out"),
            ),
            Some(ReadMode::Basis | ReadMode::Direct) if self.read_by.is_some() => refuse(
                option("read-by")
                    + " says by what light is gathered, and "
                    + set("read", "basis")
                    + " and "
                    + value("direct")
                    + " gather none",
                words("leave one of them out, or take ") + set("read", "gather"),
            ),
            _ if self.read_by == Some(GatherMethod::Rays) => self.check_rays(options, "rays"),
            _ if self.read_by == Some(GatherMethod::Walks) => self.check_rays(options, "walks"),
            _ => Ok(()),
        }
    }

    /// Refuses rays, or walks of them, where they cannot gather what is asked for.
    fn check_rays(&self, options: &Options, name: &str) -> Result<(), Refusal> {
        if self.read_by == Some(GatherMethod::Walks) && options.bounces.is_some() {
            return Err(Refusal::new(
                set("read-by", name)
                    + " finds all light, and the solution has that of some reflections alone",
                words("take ") + set("read-by", "rays") + ", or leave " + option("bounces") + " out",
            ));
        }
        if options.masks.is_some() || options.shadows == Shadows::Off {
            return Err(Refusal::new(
                set("read-by", name)
                    + " always sees exact shadows, and the solution has others: "
                    + set("shadows", "mask")
                    + " or "
                    + value("off"),
                words("take ") + set("read-by", "cells") + ", or solve with other shadows",
            ));
        }
        if self.samples.is_some() {
            return Err(Refusal::new(
                option("read-samples")
                    + " counts points, and "
                    + set("read-by", name)
                    + " sends rays until their error is small",
                words("leave one of them out; ") + option("read-eps") + " says how small",
            ));
        }
        Ok(())
    }

    /// The reading that was asked for; the rest as the quality says.
    pub fn plain(&self, method: &MethodRequest) -> ReadSettings {
        let usual = method.quality.unwrap_or_default().reading();
        self.asked(method, usual, method.eps.map_or(usual.eps, f64::from))
    }

    /// The reading that was asked for; the accuracy `eps` where none was, and the rest as in `usual`.
    fn asked(&self, method: &MethodRequest, usual: ReadSettings, eps: f64) -> ReadSettings {
        ReadSettings {
            read: method.read(self.read).unwrap_or(usual.read),
            // Rays count no points.
            by: if self.samples.is_some() { GatherMethod::Cells } else { self.read_by.unwrap_or(usual.by) },
            eps: self.read_eps.map_or(eps, f64::from),
            rates: self.samples.unwrap_or(usual.rates),
        }
    }

    /// The reading that was asked for; the rest as the quality and the solution say; no coarser than the
    /// accuracy of the solution, where one was asked for. `is_saved`: the solution was read from a file.
    pub fn reading(&self, method: &MethodRequest, solved: &Solved, is_saved: bool) -> ReadSettings {
        let achieved = solved.achieved;
        let by = self.read_by.or(achieved.map(|achieved| achieved.by)).unwrap_or_default();
        let quality = method.quality.unwrap_or_default();
        let usual = ReadSettings { by, ..quality.reading() };
        let wanted = achieved.and_then(|achieved| achieved.reading());
        if by == GatherMethod::Walks {
            return self.asked(method, usual, wanted.unwrap_or(BY_WALKS));
        }
        let is_sampled = solved.outcome.sampling.is_some();
        let of_solution = if is_sampled { usual.eps.max(quality.worth_by_rays()) } else { usual.eps };
        let saved = if is_saved && achieved.is_none() { saved_accuracy(solved) } else { None };
        let asked = [method.eps.map(f64::from), wanted, saved].into_iter().flatten();
        self.asked(method, usual, asked.fold(of_solution, f64::min))
    }

    /// The reading by which a solution that is written is checked: that of the verbs that read it, and of its
    /// polynomials where these were to be accurate.
    pub fn of_written(method: &MethodRequest, solved: &Solved, is_saved: bool) -> ReadSettings {
        match solved.achieved {
            Some(Achieved { of: Aim::Solution, .. }) => Self::of_polynomials(method, solved, is_saved),
            _ => Self::default().reading(method, solved, is_saved),
        }
    }

    /// The reading by which a solution is checked of which the polynomials alone are written.
    pub fn of_polynomials(method: &MethodRequest, solved: &Solved, is_saved: bool) -> ReadSettings {
        Self { read: Some(ReadMode::Basis), ..Self::default() }.reading(method, solved, is_saved)
    }
}

/// Relative accuracy that a solution read from a file is worth being read to, where that is finer than usual.
fn saved_accuracy(solved: &Solved) -> Option<f64> {
    Some(solved.options.eps).filter(|eps| *eps < Options::default().eps)
}

/// Refuses an accuracy of gathered light where polynomials are read, and light of some shots where more than
/// polynomials is read.
///
/// # Errors
/// If that is what was asked for.
pub fn check_aim(read: Option<ReadMode>, method: &MethodRequest) -> Result<(), Refusal> {
    let is_of_gathered = method.wanted_accuracy().is_some() && method.aim != Some(AccuracyOf::Solution);
    match read {
        Some(ReadMode::Direct | ReadMode::Gather | ReadMode::GatherTwice) if method.shots.is_some() => {
            Err(Refusal::new(
                option("shots")
                    + " limits the light of the polynomials, and other readings add light that was not shot",
                words("take ") + set("read", "basis") + ", or leave " + option("read") + " out",
            ))
        }
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
