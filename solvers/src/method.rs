//! The list of methods: their names, conditions, cost and memory.

use std::fmt;

use crate::auto::{self, Auto};
use crate::cg::{self, Cg};
use crate::cholesky::{self, Cholesky};
use crate::gauss_seidel::{self, GaussSeidel};
use crate::gmres::{self, Gmres};
use crate::jacobi::{self, Jacobi};
use crate::lu::{self, Lu};
use crate::richardson::{self, Richardson};
use crate::solver::Solver;
use crate::southwell::{self, Southwell};

/// What a matrix must have for a method to succeed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needs {
    /// An inverse.
    Inverse,
    /// Symmetry and positive eigenvalues.
    PositiveDefinite,
    /// Symmetry and positive eigenvalues, or a diagonal that outweighs the rest.
    PositiveDefiniteOrDominant,
    /// A diagonal that outweighs the rest.
    Dominant,
    /// Eigenvalues within 1 of 1.
    NearIdentity,
}

impl fmt::Display for Needs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Inverse => "any invertible matrix",
            Self::PositiveDefinite => "symmetric positive definite",
            Self::PositiveDefiniteOrDominant => "symmetric positive definite, or diagonally dominant",
            Self::Dominant => "diagonally dominant",
            Self::NearIdentity => "eigenvalues within 1 of 1",
        })
    }
}

/// One method of the list.
pub struct Method {
    /// Its name, as typed.
    pub name: &'static str,
    /// What it does, in a few words.
    pub summary: &'static str,
    /// What it needs to succeed.
    pub needs: Needs,
    /// Multiplications for n unknowns.
    pub cost: &'static str,
    /// Numbers stored besides the operator's own.
    pub storage: &'static str,
    /// The method itself.
    pub solver: &'static dyn Solver,
}

impl fmt::Debug for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Method").field("name", &self.name).finish_non_exhaustive()
    }
}

impl Method {
    /// All methods of this build.
    pub const ALL: &'static [Self] = &[
        Self {
            name: auto::NAME,
            summary: "whatever fits the matrix, its size and the tolerance",
            needs: Needs::Inverse,
            cost: "that of its choice",
            storage: "that of its choice",
            solver: &Auto,
        },
        Self {
            name: cholesky::NAME,
            summary: "Cholesky with refinement, LU where that fails",
            needs: Needs::PositiveDefinite,
            cost: "n³/6",
            storage: "n²",
            solver: &Cholesky,
        },
        Self {
            name: lu::NAME,
            summary: "LU with partial pivoting and refinement",
            needs: Needs::Inverse,
            cost: "n³/3",
            storage: "n²",
            solver: &Lu,
        },
        Self {
            name: cg::NAME,
            summary: "conjugate gradients",
            needs: Needs::PositiveDefinite,
            cost: "n² per iteration, √κ iterations per digit",
            storage: "4n and the diagonal blocks",
            solver: &Cg,
        },
        Self {
            name: gmres::NAME,
            summary: "restarted minimal residuals",
            needs: Needs::Inverse,
            cost: "n² per iteration",
            storage: "50n and the diagonal blocks",
            solver: &Gmres,
        },
        Self {
            name: gauss_seidel::NAME,
            summary: "relaxation in order, by block or by coefficient",
            needs: Needs::PositiveDefiniteOrDominant,
            cost: "n² per sweep",
            storage: "2n and the diagonal blocks",
            solver: &GaussSeidel,
        },
        Self {
            name: jacobi::NAME,
            summary: "relaxation of all unknowns at once",
            needs: Needs::Dominant,
            cost: "n² per sweep",
            storage: "2n and the diagonal blocks",
            solver: &Jacobi,
        },
        Self {
            name: richardson::NAME,
            summary: "Neumann's series, one reflection more for each iteration",
            needs: Needs::NearIdentity,
            cost: "n² per term",
            storage: "2n",
            solver: &Richardson,
        },
        Self {
            name: southwell::NAME,
            summary: "shooting, largest residual first, of columns computed on demand",
            needs: Needs::PositiveDefiniteOrDominant,
            cost: "one block column per shot",
            storage: "3n and the diagonal blocks shot",
            solver: &Southwell,
        },
    ];

    /// Whether the method called `name` asks nothing of a large matrix but its products with vectors.
    pub fn only_multiplies(name: &str) -> bool {
        [auto::NAME, cg::NAME, gmres::NAME, richardson::NAME].contains(&name)
    }

    /// The method called `name`.
    ///
    /// # Errors
    /// [`UnknownMethod`], which lists the names there are and suggests the nearest.
    pub fn named(name: &str) -> Result<&'static Self, UnknownMethod> {
        Self::ALL.iter().find(|method| method.name == name).ok_or_else(|| UnknownMethod::new(name))
    }
}

/// No method has this name.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no method is called \"{name}\"{}; there are {}", self.suggestion(), Self::names())]
pub struct UnknownMethod {
    /// The name that was asked for.
    pub name: String,
    /// The name most like it, if one is close.
    pub nearest: Option<&'static str>,
}

impl UnknownMethod {
    /// Jaro–Winkler similarity above which a name is suggested. Chosen; not tuned.
    const CLOSE: f64 = 0.7;

    fn new(name: &str) -> Self {
        let similar = |method: &Method| strsim::jaro_winkler(&name.to_lowercase(), method.name);
        let nearest = Method::ALL
            .iter()
            .max_by(|a, b| similar(a).total_cmp(&similar(b)))
            .filter(|method| similar(method) > Self::CLOSE)
            .map(|method| method.name);
        Self { name: name.to_owned(), nearest }
    }

    fn suggestion(&self) -> String {
        self.nearest.map_or_else(String::new, |nearest| format!(", did you mean \"{nearest}\"?"))
    }

    fn names() -> String {
        Method::ALL.iter().map(|method| method.name).collect::<Vec<_>>().join(", ")
    }
}
