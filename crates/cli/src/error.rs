//! Errors that end a command, their messages, and the exit code.

use std::{fmt::Write, io, path::PathBuf};

use radiosity_heat::HeatError;
use radiosity_published::hierarchy::HierarchyError;
use radiosity_reading::files::solution_file::SolutionError;
use radiosity_reading::files::vtu::VtuError;
use radiosity_request::picture::NoCamera;
use radiosity_request::{LoadError, Refusal};
use radiosity_scene::SceneError;
use radiosity_solve::Failure;
use radiosity_solve::animation::error::AnimationError;
use radiosity_solve::solved::RelightError;
use radiosity_work::ranks::journal::JournalError;
use thiserror::Error;

use crate::points::PointsError;

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
    /// A solution, where a verb needs an unsolved scene.
    #[error("{origin}: this is a solution already")]
    AlreadySolved {
        /// The file as typed.
        origin: String,
    },
    /// A scene, where a verb needs a solution.
    #[error("{origin}: this is no solution")]
    NotSolved {
        /// The file as typed.
        origin: String,
    },
    /// Light groups of a solution cannot be dimmed.
    #[error(transparent)]
    Relight(#[from] RelightError),
    /// An option of the method with a scene that is already solved.
    #[error("{option}: {origin} is a solution, how it was found cannot be changed")]
    Fixed {
        /// The file as typed.
        origin: String,
        /// The option as typed.
        option: String,
    },
    /// Something is wrong with the points of a probe.
    #[error(transparent)]
    Points(#[from] PointsError),
    /// An output that cannot be written, found before the work.
    #[error("{}: cannot be written: {reason}", path.display())]
    Unwritable {
        /// The output as typed.
        path: PathBuf,
        /// The system's error.
        reason: io::Error,
    },
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
    /// A strict check found something.
    #[error("{count} of the findings look wrong")]
    LooksWrong {
        /// Number of warnings.
        count: usize,
    },
    /// A picture was asked of a scene without a camera.
    #[error(transparent)]
    NoCamera(#[from] NoCamera),
    /// A request that cannot be fulfilled.
    #[error("{message}")]
    Refused {
        /// The fault, in a sentence.
        message: String,
        /// The way to mend it, in a sentence.
        cure: String,
    },
    /// A solution is no grid of VTK.
    #[error("{}: {reason}", path.display())]
    Vtu {
        /// The output as typed.
        path: PathBuf,
        /// Reason why it is none.
        reason: VtuError,
    },
    /// A value of `--pairs` without two names.
    #[error("--pairs {text}: two names are needed")]
    NoPair {
        /// Value of the option as typed.
        text: String,
    },
    /// An output whose ending names no format.
    #[error("{}: the ending names no format", path.display())]
    UnknownFormat {
        /// The output as typed.
        path: PathBuf,
        /// The formats there are, such as `csv or json`.
        known: String,
    },
    /// A few pairs were asked for in a format that holds a matrix.
    #[error("--pairs are no matrix, which is all that {format} holds")]
    PairsAsArray {
        /// Name of the format.
        format: String,
    },
    /// A run cannot be recorded, or does not go on from what was recorded.
    #[error("--checkpoint {0}")]
    Checkpoint(#[from] JournalError),
    /// Standard output failed.
    #[error("standard output: {0}")]
    Stdout(#[from] io::Error),
}

impl From<HeatError> for CliError {
    fn from(error: HeatError) -> Self {
        match error {
            HeatError::Solve(failure) => Self::Solve(failure),
            other => Self::Heat(other),
        }
    }
}

impl From<Refusal> for CliError {
    fn from(Refusal { message, cure }: Refusal) -> Self {
        Self::Refused { message: message.to_string(), cure: cure.to_string() }
    }
}

impl From<LoadError> for CliError {
    fn from(error: LoadError) -> Self {
        match error {
            LoadError::Scene(error) => Self::Scene(error),
            LoadError::Solved { origin } => Self::AlreadySolved { origin },
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
            AnimationError::ByRays => Self::Refused {
                message: error.to_string(),
                cure: "add --transport exact, or choose another --animation".to_owned(),
            },
            AnimationError::Masked => Self::Refused {
                message: error.to_string(),
                cure: "add --animation selective, or choose other --shadows".to_owned(),
            },
        }
    }
}

impl CliError {
    /// 2 if the command line or a file has to be changed, 3 if an accuracy was not reached, else 1. A closed
    /// pipe on standard output is no error, nor is a wish for help.
    pub(crate) fn exit_code(&self) -> u8 {
        match self {
            CliError::Typed(error) => error.exit_code() as u8,
            CliError::Scene(_)
            | CliError::Solution(_)
            | CliError::Points(_)
            | CliError::AlreadySolved { .. }
            | CliError::NotSolved { .. }
            | CliError::Relight(_)
            | CliError::Fixed { .. }
            | CliError::Unwritable { .. }
            | CliError::NoCamera(_)
            | CliError::NoPair { .. }
            | CliError::UnknownFormat { .. }
            | CliError::PairsAsArray { .. }
            | CliError::Heat(_)
            | CliError::Vtu { .. }
            | CliError::Checkpoint(_)
            | CliError::Refused { .. } => 2,
            CliError::Solve(
                Failure::Elements(_)
                | Failure::NoChart { .. }
                | Failure::Unmasked { .. }
                | Failure::NotDiffuse { .. }
                | Failure::NotEven { .. }
                | Failure::Hierarchy(
                    HierarchyError::Luminaire { .. }
                    | HierarchyError::Opening { .. }
                    | HierarchyError::Coating { .. },
                )
                | Failure::Memory { .. },
            ) => 2,
            CliError::Frame { cause, .. } => cause.exit_code(),
            CliError::Stdout(error) if error.kind() == io::ErrorKind::BrokenPipe => 0,
            CliError::Missed { .. } => 3,
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
            CliError::AlreadySolved { .. } => Some(
                "give it to render, probe or grid; for anything else, give the scene it was made from".into(),
            ),
            CliError::NotSolved { .. } => Some(
                "solve it first with `radiosity solve`; render, probe and grid take --set for scenes as well"
                    .into(),
            ),
            CliError::Relight(RelightError::Scene(error)) => error.cure(),
            CliError::Fixed { .. } => {
                Some("leave the option out, or give the scene instead of its solution".into())
            }
            CliError::Points(error) => Some(error.cure.clone()),
            CliError::Unwritable { .. } => {
                Some("choose a file in a folder that exists and can be written to".into())
            }
            CliError::NoCamera(error) => Some(error.cure()),
            CliError::Refused { cure, .. } => Some(cure.clone()),
            CliError::Checkpoint(error) => Some(error.cure().into()),
            CliError::NoPair { .. } => {
                Some("write the names of two surfaces, as in --pairs floor,ceiling".into())
            }
            CliError::UnknownFormat { known, .. } => {
                Some(format!("end the name in .{}, or add --format {known}", known.replace("or ", "or .")))
            }
            CliError::Vtu { reason, .. } => Some(reason.cure().to_string()),
            CliError::Heat(error) => error.cure().map(|cure| cure.to_string()),
            CliError::PairsAsArray { .. } => Some("choose --format csv or json".into()),
            CliError::Solve(failure) => failure.cure().map(|cure| cure.to_string()),
            CliError::Typed(_)
            | CliError::LooksWrong { .. }
            | CliError::Missed { .. }
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
