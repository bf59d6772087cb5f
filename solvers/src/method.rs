//! The list of methods: their names, conditions, cost and memory; a caller's own beside them.

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

/// Property that a matrix must have for a method to succeed.
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

/// The part of a large matrix that a method uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Products with vectors: the matrix need not be stored.
    Products,
    /// Block rows and diagonal blocks.
    Rows,
    /// Block columns and diagonal blocks, of few columns where few matter.
    Columns,
    /// All entries.
    Entries,
    /// Products of a large matrix, all entries of a small one.
    BySize,
}

/// One method of the list, or one of a caller's own.
///
/// A method of one's own is a constant with a [`Solver`] behind it; a [`Methods`] finds it by name beside
/// [those of this crate](Method::ALL).
pub struct Method {
    /// Its name, as typed.
    pub name: &'static str,
    /// Other names that find it.
    pub aliases: &'static [&'static str],
    /// Description, a few words.
    pub summary: &'static str,
    /// Property that the matrix must have for it to succeed.
    pub needs: Needs,
    /// The part of a large matrix that it uses.
    pub access: Access,
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
    /// The choice by the matrix, its size and the tolerance: [`auto`].
    pub const AUTO: Self = Self {
        name: auto::NAME,
        aliases: &[],
        summary: "whatever fits the matrix, its size and the tolerance",
        needs: Needs::Inverse,
        access: Access::BySize,
        cost: "that of its choice",
        storage: "that of its choice",
        solver: &Auto,
    };

    /// Cholesky factorisation: [`cholesky`].
    pub const CHOLESKY: Self = Self {
        name: cholesky::NAME,
        aliases: &[],
        summary: "Cholesky with refinement, LU where that fails",
        needs: Needs::PositiveDefinite,
        access: Access::Entries,
        cost: "n³/6",
        storage: "n²",
        solver: &Cholesky,
    };

    /// LU factorisation: [`lu`].
    pub const LU: Self = Self {
        name: lu::NAME,
        aliases: &[],
        summary: "LU with partial pivoting and refinement",
        needs: Needs::Inverse,
        access: Access::Entries,
        cost: "n³/3",
        storage: "n²",
        solver: &Lu,
    };

    /// Conjugate gradients: [`cg`].
    pub const CG: Self = Self {
        name: cg::NAME,
        aliases: &[],
        summary: "conjugate gradients",
        needs: Needs::PositiveDefinite,
        access: Access::Products,
        cost: "n² per iteration, √κ iterations per digit",
        storage: "4n and the diagonal blocks",
        solver: &Cg,
    };

    /// Generalised minimal residuals: [`gmres`].
    pub const GMRES: Self = Self {
        name: gmres::NAME,
        aliases: &[],
        summary: "restarted minimal residuals",
        needs: Needs::Inverse,
        access: Access::Products,
        cost: "n² per iteration",
        storage: "50n and the diagonal blocks",
        solver: &Gmres,
    };

    /// Gauss–Seidel sweeps: [`gauss_seidel`].
    pub const GAUSS_SEIDEL: Self = Self {
        name: gauss_seidel::NAME,
        aliases: &[],
        summary: "relaxation in order, by block or by coefficient",
        needs: Needs::PositiveDefiniteOrDominant,
        access: Access::Rows,
        cost: "n² per sweep",
        storage: "2n and the diagonal blocks",
        solver: &GaussSeidel,
    };

    /// Jacobi sweeps: [`jacobi`].
    pub const JACOBI: Self = Self {
        name: jacobi::NAME,
        aliases: &[],
        summary: "relaxation of all unknowns at once",
        needs: Needs::Dominant,
        access: Access::Rows,
        cost: "n² per sweep",
        storage: "2n and the diagonal blocks",
        solver: &Jacobi,
    };

    /// Terms of Neumann's series: [`richardson`].
    pub const RICHARDSON: Self = Self {
        name: richardson::NAME,
        aliases: &[],
        summary: "Neumann's series, one reflection more for each iteration",
        needs: Needs::NearIdentity,
        access: Access::Products,
        cost: "n² per term",
        storage: "2n",
        solver: &Richardson,
    };

    /// Progressive refinement by shooting: [`southwell`].
    pub const SOUTHWELL: Self = Self {
        name: southwell::NAME,
        aliases: &["progressive", "shooting"],
        summary: "shooting, brightest first; where exact blocks carry the light, a column is integrated when it is first shot",
        needs: Needs::PositiveDefiniteOrDominant,
        access: Access::Columns,
        cost: "one block column per shot",
        storage: "3n and the diagonal blocks shot",
        solver: &Southwell,
    };

    /// All methods of this crate.
    pub const ALL: &'static [Self] = &[
        Self::AUTO,
        Self::CHOLESKY,
        Self::LU,
        Self::CG,
        Self::GMRES,
        Self::GAUSS_SEIDEL,
        Self::JACOBI,
        Self::RICHARDSON,
        Self::SOUTHWELL,
    ];

    /// Whether it asks nothing of a large matrix but its products with vectors.
    pub fn only_multiplies(&self) -> bool {
        matches!(self.access, Access::Products | Access::BySize)
    }

    /// The method of this crate called `name`, or that has it for an alias.
    ///
    /// # Errors
    /// [`UnknownMethod`], which lists the names there are and suggests the nearest.
    pub fn named(name: &str) -> Result<&'static Self, UnknownMethod> {
        Methods::default().named(name)
    }

    /// Summary of the method, with its other names.
    pub fn summary_with_aliases(&self) -> String {
        match self.aliases {
            [] => self.summary.to_owned(),
            aliases => format!("{} (also: {})", self.summary, aliases.join(", ")),
        }
    }

    /// Name of the method, then its aliases.
    fn names(&self) -> impl Iterator<Item = &'static str> {
        std::iter::once(self.name).chain(self.aliases.iter().copied())
    }
}

/// Methods that are found by name: those of this crate, and a caller's own beside them.
///
/// ```
/// use radiosity_solvers::method::{Access, Method, Methods, Needs};
/// use radiosity_solvers::{Operator, Report, Settings, SolveError, Solver, Step};
///
/// /// x = D⁻¹ b: for diagonal matrices.
/// struct Diagonal;
///
/// impl Solver for Diagonal {
///     fn solve(
///         &self,
///         a: &dyn Operator,
///         b: &[f64],
///         x: &mut [f64],
///         settings: &Settings<'_>,
///         observer: &mut dyn FnMut(&Step<'_>),
///     ) -> Result<Report, SolveError> {
///         let mut diagonal = vec![0.0; b.len()];
///         a.apply(&vec![1.0; b.len()], &mut diagonal);
///         x.iter_mut().zip(b).zip(&diagonal).for_each(|((x, b), d)| *x = b / d);
///         observer(&Step::new(0, 0.0, x));
///         Ok(Report::new("diagonal", vec![0.0]))
///     }
/// }
///
/// static DIAGONAL: Method = Method {
///     name: "diagonal",
///     aliases: &[],
///     summary: "division by the diagonal",
///     needs: Needs::Inverse,
///     access: Access::Products,
///     cost: "n",
///     storage: "n",
///     solver: &Diagonal,
/// };
///
/// let methods = Methods::default().with(&DIAGONAL)?;
/// assert_eq!(methods.named("diagonal")?.summary, "division by the diagonal");
/// assert_eq!(methods.named("progressive")?.name, "southwell");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Methods {
    list: Vec<&'static Method>,
}

impl Default for Methods {
    /// The methods of [`Method::ALL`].
    fn default() -> Self {
        Self { list: Method::ALL.iter().collect() }
    }
}

impl Methods {
    /// Adds a method at the end.
    ///
    /// # Errors
    /// [`NameTaken`] if one of its names finds another method already, or stands twice among its own.
    pub fn with(mut self, method: &'static Method) -> Result<Self, NameTaken> {
        for (place, name) in method.names().enumerate() {
            if self.find(name).is_some() || method.names().take(place).any(|own| own == name) {
                return Err(NameTaken { name });
            }
        }
        self.list.push(method);
        Ok(self)
    }

    /// The method called `name`, or that has it for an alias.
    ///
    /// # Errors
    /// [`UnknownMethod`], which lists the names there are and suggests the nearest.
    pub fn named(&self, name: &str) -> Result<&'static Method, UnknownMethod> {
        self.find(name).ok_or_else(|| UnknownMethod::new(name, &self.list))
    }

    /// All methods, in the order in which they were added.
    pub fn iter(&self) -> impl Iterator<Item = &'static Method> {
        self.list.iter().copied()
    }

    fn find(&self, name: &str) -> Option<&'static Method> {
        self.iter().find(|method| method.names().any(|own| own == name))
    }
}

/// Two methods, or two aliases of one, claim a name.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("a method called \"{name}\" is there already; give yours another name")]
pub struct NameTaken {
    /// The name that two methods claim.
    pub name: &'static str,
}

/// No method has this name.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no method is called \"{name}\"{}; there are {}", self.suggestion(), self.known.join(", "))]
pub struct UnknownMethod {
    /// The name that was asked for.
    pub name: String,
    /// The name or alias most like it, if one is close.
    pub nearest: Option<&'static str>,
    /// The names of all methods.
    pub known: Vec<&'static str>,
}

impl UnknownMethod {
    /// Jaro–Winkler similarity above which a name is suggested. An arbitrary choice: with a smaller value
    /// names are suggested that nobody meant, with a larger one none for a short name with a slip.
    const CLOSE: f64 = 0.7;

    fn new(name: &str, methods: &[&'static Method]) -> Self {
        let similarity = |own: &&str| strsim::jaro_winkler(&name.to_lowercase(), own);
        let names = methods.iter().flat_map(|method| method.names());
        let nearest = names
            .max_by(|a, b| similarity(a).total_cmp(&similarity(b)))
            .filter(|name| similarity(name) > Self::CLOSE);
        Self { name: name.to_owned(), nearest, known: methods.iter().map(|method| method.name).collect() }
    }

    fn suggestion(&self) -> String {
        self.nearest.map_or_else(String::new, |nearest| format!(", did you mean \"{nearest}\"?"))
    }
}
