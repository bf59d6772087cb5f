//! Why a scene could not be solved.

use radiosity_elements::ElementError;
use radiosity_published::hierarchy::HierarchyError;
use radiosity_solvers::{SolveError, Stop};
use radiosity_work::wording::{Wording, option, set, value, words};
use rayon::ThreadPoolBuildError;

use super::memory_reduction;
use super::memory_reduction::MemoryReduction;

/// Why a scene could not be solved.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The scene could not be cut into elements.
    #[error(transparent)]
    Elements(#[from] ElementError),
    /// The light of a sky or a luminous area was to be carried as diffuse light is.
    #[error("{}", self.message())]
    NotDiffuse {
        /// Name of the first of these surfaces.
        surface: String,
        /// Kind of its light, for the message.
        light: &'static str,
        /// The choice that treats light as diffuse.
        what: Wording,
    },
    /// A basis was asked for whose functions reach over elements, where reflectance varies or light comes
    /// through.
    #[error("{}", self.message())]
    NotEven {
        /// Name of the first of these surfaces.
        surface: String,
        /// Name of the basis.
        basis: &'static str,
    },
    /// Shadow masks were asked for, but they know no light of luminaires.
    #[error("{}", self.message())]
    Unmasked {
        /// Name of the first luminaire that shines.
        luminaire: String,
    },
    /// A pair was chosen for a mask that no light goes between.
    #[error("mask of '{emitter}' on '{receiver}': {why}")]
    NoMask {
        /// Name of the emitter, as it was typed.
        emitter: String,
        /// Name of the receiver, as it was typed.
        receiver: String,
        /// Why there is nothing to mask.
        why: &'static str,
    },
    /// Light that emitters reflect through masks changes from one solution to the next.
    #[error("light that is reflected through shadow masks does not settle in {rounds} solutions")]
    MasksUnsettled {
        /// Number of solutions.
        rounds: usize,
    },
    /// Columns were to be integrated when they are first shot, and cannot be.
    #[error("{}", self.message())]
    AllFirst {
        /// Why all are integrated first.
        why: &'static str,
    },
    /// The linear solver failed.
    #[error("band '{band}': {source}")]
    Solver {
        /// Name of the band.
        band: String,
        /// Error of the solver.
        source: SolveError,
    },
    /// Hierarchical radiosity failed.
    #[error(transparent)]
    Hierarchy(#[from] HierarchyError),
    /// A model was asked to solve a scene of other surfaces.
    #[error(
        "surface '{surface}': the model has another one, or other bands: assemble a model of this scene, or change \
         materials of the scene it was assembled from"
    )]
    OtherSurface {
        /// Name of the first surface that differs.
        surface: String,
    },
    /// Light leaves a surface that was black and dark when a model was assembled, so that its blocks were
    /// left out.
    #[error(
        "surface '{surface}' sends light now, but did not when the model was assembled: assemble the model with a \
         reflectance above 0 there"
    )]
    Unlit {
        /// Name of the surface.
        surface: String,
    },
    /// More memory is needed than allowed.
    #[error("{}", self.message())]
    Memory {
        /// Bytes needed, estimated.
        needed: u64,
        /// Bytes that the run may take.
        allowed: u64,
        /// Changes that would fit, if any.
        fits: Vec<MemoryReduction>,
    },
    /// No threads could be started.
    #[error("{}", self.message())]
    Threads {
        /// Number of threads asked for.
        threads: usize,
        /// Error of the system.
        source: ThreadPoolBuildError,
    },
}

impl Failure {
    /// The fault, as a sentence.
    pub fn message(&self) -> Wording {
        match self {
            Self::Hierarchy(error) => error.message(),
            Self::NotDiffuse { surface, light, what } => {
                words(format!("surface '{surface}' is {light}: "))
                    + what.clone()
                    + " takes all emitted light for diffuse: leave it out, such light is then integrated at every point"
            }
            Self::NotEven { surface, basis } => {
                words(format!("surface '{surface}': its reflectance varies, or light comes through it, "))
                    + "which the functions of "
                    + set("basis", basis)
                    + " do not follow: take "
                    + set("basis", "legendre")
                    + " or "
                    + value("constant")
            }
            Self::Unmasked { luminaire } => {
                words(format!(
                    "luminaire '{luminaire}': shadow masks are made for the light of surfaces only: "
                )) + "choose another kind of "
                    + option("shadows")
                    + ", direct light is then exact at every point"
            }
            Self::AllFirst { why } => {
                set("columns", "shot")
                    + format!(": all columns are integrated before the first shot, as {why}")
            }
            Self::Memory { needed, allowed, fits } => {
                let [needed, allowed] = [needed, allowed].map(|bytes| *bytes as f64 / 1e6);
                words(format!(
                    "not enough memory: about {needed:.1} MB are needed, {allowed:.1} MB allowed; "
                )) + memory_reduction::list(fits)
            }
            Self::Threads { threads, source } => {
                words(format!("cannot start {threads} threads: {source}; ask for fewer with "))
                    + option("threads")
            }
            _ => words(self.to_string()),
        }
    }

    /// A cure, where one is known and the message does not say it.
    pub fn cure(&self) -> Option<Wording> {
        let more = || words("allow more with ") + option("memory");
        Some(match self {
            Self::AllFirst { .. } => {
                words("leave it out, or what needs all columns: rays (")
                    + set("transport", "exact")
                    + " has none), "
                    + option("checkpoint")
                    + ", several processes, the rules of 1993, masks of emitters that reflect"
            }
            Self::MasksUnsettled { .. } => {
                words(
                    "choose fewer pairs in [[masks]], of emitters that reflect little, take weighted masks of more ",
                ) + option("mask-cells")
                    + ", or of more cells where [[masks]] state them, or leave "
                    + set("shadows", "mask")
                    + " out"
            }
            Self::NoMask { .. } => {
                words("take the pair out of [[masks]], or name surfaces whose fronts see each other")
            }
            Self::Memory { fits, .. } if fits.is_empty() => more() + ", or leave it out",
            Self::Memory { .. } => words("ask for one of these, or ") + more(),
            Self::Elements(ElementError::Layers { .. }) => {
                words("take fewer ") + option("layers") + " or a larger " + option("ratio")
            }
            Self::Solver { source: SolveError::NotConverged { stop: Stop::Time, .. }, .. } => {
                words("raise ") + option("time-limit") + ", or take " + set("solver", "cg")
            }
            Self::Solver { source: SolveError::NotConverged { .. }, .. } => {
                words("raise ")
                    + option("tolerance")
                    + " or "
                    + option("max-iterations")
                    + ", or take another "
                    + option("solver")
                    + "; solve "
                    + option("keep-partial")
                    + " writes what there is"
            }
            Self::Solver { source: SolveError::Cancelled { .. }, .. } => return None,
            Self::Solver { .. } => words("take another ") + option("solver"),
            _ => return None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solvers_that_cannot_solve_a_system_are_cured_by_others() {
        let of = |source: SolveError| Failure::Solver { band: "grey".to_owned(), source };
        for source in [
            SolveError::NotPositiveDefinite { method: "cg" },
            SolveError::NotSymmetric { method: "cg" },
            SolveError::Breakdown { method: "bicgstab", iterations: 3 },
        ] {
            let cure = of(source).cure().map(|cure| cure.to_string());
            assert_eq!(cure.as_deref(), Some("take another --solver"));
        }
    }
}
