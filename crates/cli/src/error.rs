//! Errors that end a command, their messages, and the exit code.

use std::{fmt::Write, io, path::PathBuf};

use radiosity_audit::HeatFault;
use radiosity_heat::HeatError;
use radiosity_published::hierarchy::HierarchyError;
use radiosity_reading::files::solution_file::SolutionError;
use radiosity_request::{LoadError, Refusal, SweepError};
use radiosity_scene::{Fault, SceneError};
use radiosity_solve::Failure;
use radiosity_solve::animation::error::AnimationError;
use radiosity_solve::solved::RelightError;
use radiosity_work::ranks::journal::JournalError;
use thiserror::Error;

/// Why a command ended early.
#[derive(Debug, Error)]
pub(crate) enum CliError {
    /// The command line makes no sense, or asks for help.
    #[error(transparent)]
    Typed(#[from] clap::Error),
    /// Something is wrong with the scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// Something is wrong with a solution file.
    #[error(transparent)]
    Solution(#[from] SolutionError),
    /// Light groups of a solution cannot be dimmed.
    #[error(transparent)]
    Relight(#[from] RelightError),
    /// An output that failed while it was written; the file is unchanged.
    #[error("{}: writing failed: {reason}", path.display())]
    Unwritten {
        /// The output as typed.
        path: PathBuf,
        /// The system's error.
        reason: io::Error,
    },
    /// The scene could not be solved.
    #[error(transparent)]
    Solve(#[from] Failure),
    /// A frame could not be solved.
    #[error("frame {moment}: {cause}")]
    Frame {
        /// The moment, in frames.
        moment: f64,
        /// Error of the frame.
        cause: Box<CliError>,
    },
    /// The heat of the scene has no balance.
    #[error(transparent)]
    Heat(HeatError),
    /// A solution that was written all the same.
    #[error("{}: the solver did not converge, the relative residual is {residual:.2e}; what is written is marked so", path.display())]
    Partial {
        /// The output as typed.
        path: PathBuf,
        /// Relative residual, the largest of any band.
        residual: f64,
    },
    /// A solution by fewer rays than were to be sent, written all the same.
    #[error("{}: stopped after {rays} of {planned} rays; the error that is told is that of these", path.display())]
    Stopped {
        /// The output as typed.
        path: PathBuf,
        /// Rays sent.
        rays: u64,
        /// Rays that were to be sent.
        planned: u64,
    },
    /// The accuracy asked for was not reached; all was written, with the error that was.
    #[error("the accuracy asked for was not reached: {}; what there is was written", estimated(*estimate))]
    Missed {
        /// Estimated relative error.
        estimate: Option<f64>,
    },
    /// A strict referee found more than the run tells; all was written.
    #[error("{what} off by more than the {told:.1e} that the run tells; what there is was written")]
    FoundMore {
        /// Subject and verb of the message.
        what: &'static str,
        /// The relative error that is told.
        told: f64,
    },
    /// A strict check found something.
    #[error("{count} of the findings look wrong")]
    LooksWrong {
        /// Number of warnings.
        count: usize,
    },
    /// A request that cannot be fulfilled, found before the work.
    #[error("{message}")]
    Refused {
        /// The fault, in a sentence.
        message: String,
        /// The way to mend it, in a sentence.
        cure: String,
    },
    /// A run cannot be recorded, or does not go on from what was recorded.
    #[error("{option} {0}", option = option(.0))]
    Checkpoint(#[from] JournalError),
    /// Standard output failed.
    #[error("standard output: {0}")]
    Stdout(#[from] io::Error),
}

/// The option that an error is about.
fn option(error: &JournalError) -> &'static str {
    if error.is_of_transfers() { "--transfers" } else { "--checkpoint" }
}

impl From<HeatError> for CliError {
    fn from(error: HeatError) -> Self {
        match error {
            HeatError::Solve(failure) => Self::Solve(failure),
            other => Self::Heat(other),
        }
    }
}

impl From<SweepError> for CliError {
    fn from(error: SweepError) -> Self {
        match error {
            SweepError::Scene(error) => error.into(),
            SweepError::Heat(error) => error.into(),
        }
    }
}

impl From<HeatFault> for CliError {
    fn from(fault: HeatFault) -> Self {
        Self::refused(fault.to_string(), fault.cure().to_string())
    }
}

impl From<Refusal> for CliError {
    fn from(Refusal { message, cure }: Refusal) -> Self {
        Self::refused(message.to_string(), cure.to_string())
    }
}

impl From<Fault> for CliError {
    fn from(fault: Fault) -> Self {
        Self::refused(fault.to_string(), fault.cure().unwrap_or_default())
    }
}

impl From<LoadError> for CliError {
    fn from(error: LoadError) -> Self {
        match error {
            LoadError::Scene(error) => Self::Scene(error),
            LoadError::Solved { origin } => Self::refused(
                format!("{origin}: this is a solution already"),
                "give it to render, probe or grid; for anything else, give the scene it was made from",
            ),
            LoadError::Refused(refusal) => refusal.into(),
        }
    }
}

impl From<AnimationError> for CliError {
    fn from(error: AnimationError) -> Self {
        match error {
            AnimationError::Scene(error) => Self::Scene(error),
            AnimationError::Unsolved { moment, failure } => {
                Self::Frame { moment, cause: Box::new(Self::Solve(*failure)) }
            }
            AnimationError::UnsolvedByHand { failure } => Self::Solve(*failure),
            AnimationError::ByRays => {
                Self::refused(error.to_string(), "add --transport exact, or choose another --animation")
            }
            AnimationError::Masked => {
                Self::refused(error.to_string(), "add --animation selective, or choose other --shadows")
            }
        }
    }
}

impl CliError {
    /// A request that cannot be fulfilled, and the way to mend it.
    pub(crate) fn refused(message: impl Into<String>, cure: impl Into<String>) -> Self {
        Self::Refused { message: message.into(), cure: cure.into() }
    }

    /// An `option` of the method with a scene that is solved, that of the file `origin`.
    pub(crate) fn fixed(origin: &str, option: &str) -> Self {
        Self::refused(
            format!("{option}: {origin} is a solution, how it was found cannot be changed"),
            "leave the option out, or give the scene instead of its solution",
        )
    }

    /// 2 if the command line or a file has to be changed, 3 if an accuracy was not reached or a referee found more than
    /// is told, else 1. A closed
    /// pipe on standard output is no error, nor is a wish for help.
    pub(crate) fn exit_code(&self) -> u8 {
        match self {
            CliError::Typed(error) => error.exit_code() as u8,
            CliError::Scene(_)
            | CliError::Solution(_)
            | CliError::Relight(_)
            | CliError::Heat(_)
            | CliError::Checkpoint(_)
            | CliError::Refused { .. } => 2,
            CliError::Solve(
                Failure::Elements(_)
                | Failure::Unmasked { .. }
                | Failure::NotDiffuse { .. }
                | Failure::NotEven { .. }
                | Failure::NoMask { .. }
                | Failure::Hierarchy(
                    HierarchyError::Luminaire { .. }
                    | HierarchyError::Opening { .. }
                    | HierarchyError::Coating { .. },
                )
                | Failure::Memory { .. },
            ) => 2,
            CliError::Frame { cause, .. } => cause.exit_code(),
            CliError::Stdout(error) if error.kind() == io::ErrorKind::BrokenPipe => 0,
            CliError::Missed { .. } | CliError::FoundMore { .. } => 3,
            CliError::LooksWrong { .. }
            | CliError::Partial { .. }
            | CliError::Stopped { .. }
            | CliError::Unwritten { .. }
            | CliError::Solve(_)
            | CliError::Stdout(_) => 1,
        }
    }

    /// The text for stderr: message, the line in question, cure.
    pub(crate) fn explain(&self) -> String {
        if matches!(self, CliError::Stdout(error) if error.kind() == io::ErrorKind::BrokenPipe) {
            return String::new();
        }
        let mut text = format!("error: {self}\n");
        if let CliError::Scene(SceneError { place: Some(place), .. }) = self {
            text += &place.excerpt();
        }
        if let Some(cure) = self.cure() {
            writeln!(text, "help: {cure}").expect("a String takes all text");
        }
        text
    }

    fn cure(&self) -> Option<String> {
        match self {
            CliError::Scene(error) => error.cure(),
            CliError::Frame { cause, .. } => cause.cure(),
            CliError::Solution(error) => Some(error.cure().into()),
            CliError::Relight(RelightError::Scene(error)) => error.cure(),
            CliError::Refused { cure, .. } => Some(cure.clone()),
            CliError::Checkpoint(error) => Some(error.cure().into()),
            CliError::Heat(error) => error.cure().map(|cure| cure.to_string()),
            CliError::Solve(failure) => failure.cure().map(|cure| cure.to_string()),
            CliError::Typed(_)
            | CliError::LooksWrong { .. }
            | CliError::Missed { .. }
            | CliError::FoundMore { .. }
            | CliError::Relight(RelightError::NotApart)
            | CliError::Partial { .. }
            | CliError::Stopped { .. }
            | CliError::Unwritten { .. }
            | CliError::Stdout(_) => None,
        }
    }
}

/// An estimated error in words.
fn estimated(estimate: Option<f64>) -> String {
    estimate.map_or_else(
        || "its error is not known".to_owned(),
        |estimate| format!("the estimated error is {estimate:.1e}"),
    )
}
