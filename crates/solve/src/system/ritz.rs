//! Ritz's method: the system of one band in the functions of a basis.
//!
//! With orthonormal columns Q of a [subspace](radiosity_published::bases::subspace) and y = Q a, the minimum
//! of the variational functional
//!
//! ```text
//! I(y) = ½ ⟨(I − √ρ G √ρ) y, y⟩ − ⟨f, y⟩ ,     f = √ρ times the irradiance of the first transport
//! ```
//!
//! over the subspace is where
//!
//! ```text
//! (I − Qᵀ √ρ G √ρ Q) a = Qᵀ f ,
//! ```
//!
//! which is symmetric and positive definite with the whole system, its eigenvalues between those of the
//! latter. Polynomials of an order on each element are the case Q = I. Irradiance and direct light are told
//! in the subspace as well, P h and P d: what is read is what the basis can say. Constants lie in each
//! subspace, so the balance of power is that of the polynomials, kept to rounding.
//!
//! Light of the first K reflections alone (`--bounces`) is a sum of powers instead, with t_k the irradiance
//! that was reflected exactly k times:
//!
//! ```text
//! h_K = d + Σ_{k=1..K} t_k ,     t_{k+1} = P G ρ t_k .
//! ```
//!
//! Reference: L. Szirmay-Kalos, *Application of variational calculus in the radiosity method*, Periodica
//! Polytechnica El. Eng. 40 (1996), 123–138.

use std::borrow::Cow;

use radiosity_core::dot;
use radiosity_published::bases::Subspace;
use radiosity_solvers::method::{Access, Method};
use radiosity_solvers::{Operator, Preconditioner, SolveError};

use super::known_light::NearestLight;
use super::projected::Projected;
use super::reduction::Reduction;
use super::{Coefficients, System};

/// The system of one band in the functions of a basis.
#[derive(Debug)]
pub struct Ritz<'a> {
    system: System<'a>,
    /// None where the functions are those of the elements.
    reduction: Option<Reduction<'a>>,
}

/// A solution of one band, with the value of the functional there.
#[derive(Clone, Debug)]
pub struct RitzSolution {
    /// Irradiance and radiosity.
    pub coefficients: Coefficients,
    /// I(y), in the square of the unit of exitance times scene length².
    pub functional: f64,
}

/// Light of the first reflections of one band.
#[derive(Clone, Debug)]
pub(crate) struct Bounced {
    /// Irradiance and radiosity.
    pub coefficients: Coefficients,
    /// Irradiance and radiosity without the last reflection; None of direct light alone.
    pub before: Option<Coefficients>,
}

impl<'a> Ritz<'a> {
    /// `system` in the functions of a subspace; in those of its elements for None. Direct light that enters
    /// it apart lies in the subspace.
    pub fn new(system: System<'a>, subspace: Option<&'a Subspace>) -> Self {
        let starts = system.blocks.starts();
        let reduction = subspace.map(|own| Reduction::new(own, &system.reflecting, starts));
        Self { system, reduction }
    }

    /// The solver in place of the one that was asked for, where the matrix `is_symmetric` or not. In a
    /// subspace it is known by its products, so that a choice that is left open falls on a solver that
    /// multiplies.
    pub(crate) fn solver(&self, asked: &'static Method, is_symmetric: bool) -> &'static Method {
        if self.reduction.is_none() || asked.access != Access::BySize {
            return asked;
        }
        if is_symmetric { &Method::CG } else { &Method::GMRES }
    }

    /// The solver that multiplies where the choice is left open.
    pub(crate) fn multiplying(&self) -> &'static Method {
        if self.system.is_symmetric() { &Method::CG } else { &Method::GMRES }
    }

    /// The matrix by its products alone where it is symmetric, for few of them; as [`Ritz::operator`] else.
    ///
    /// # Errors
    /// Values that are not finite.
    pub(crate) fn product(
        &self,
        asked: Preconditioner,
        threads: usize,
    ) -> Result<(Box<dyn Operator + '_>, Preconditioner), SolveError> {
        match self.reduction {
            None if self.system.is_symmetric() => Ok((self.system.product(), asked)),
            _ => self.operator(self.multiplying(), asked, 1, threads),
        }
    }

    /// The matrix for the solver `solver` and so many right-hand sides, and how residuals are to be preconditioned
    /// where `asked` says how.
    ///
    /// # Errors
    /// Values that are not finite.
    pub fn operator(
        &self,
        solver: &Method,
        asked: Preconditioner,
        rights: usize,
        threads: usize,
    ) -> Result<(Box<dyn Operator + '_>, Preconditioner), SolveError> {
        let Some(reduction) = &self.reduction else {
            return Ok((self.system.operator(solver, rights, threads)?, asked));
        };
        let product = Projected::new(reduction, self.system.operator(&Method::CG, 1, threads)?);
        if solver.only_multiplies() {
            // Diagonal blocks would cost as much as the whole matrix; those of flat surfaces are the
            // identity.
            return Ok((Box::new(product), Preconditioner::None));
        }
        Ok((Box::new(product.entries(self.system.ranks())?), asked))
    }

    /// Qᵀ f, the right-hand side in the functions of the subspace.
    pub fn right_hand_side(&self) -> Vec<f64> {
        let own = self.system.right_hand_side();
        self.reduction.as_ref().map_or_else(|| own.clone(), |reduction| reduction.restricted(&own))
    }

    /// Shooting measures of the unknowns ([`System::shooting_measure`]), or bounds of them.
    pub(crate) fn shooting_measure(&self) -> Vec<f64> {
        let own = self.system.shooting_measure();
        self.reduction.as_ref().map_or_else(|| own.clone(), |reduction| reduction.bounded(&own))
    }

    /// Irradiance and radiosity for the unknowns a.
    pub fn found(&self, unknowns: &[f64]) -> RitzSolution {
        let own = self.extended(unknowns);
        let unknown = self.unknown_radiosity(&own);
        let arrived = self.system.blocks.apply(&self.system.carried(&unknown));
        self.solution(&own, &unknown, arrived)
    }

    /// Irradiance and radiosity of each of some systems of the same blocks, for its unknowns a.
    pub(crate) fn found_of_each(systems: &[Self], unknowns: &[Vec<f64>]) -> Vec<RitzSolution> {
        let Some(first) = systems.first() else { return Vec::new() };
        let own: Vec<Cow<'_, [f64]>> =
            systems.iter().zip(unknowns).map(|(system, own)| system.extended(own)).collect();
        let unknown: Vec<Vec<f64>> =
            systems.iter().zip(&own).map(|(system, own)| system.unknown_radiosity(own)).collect();
        let carried = systems.iter().zip(&unknown).map(|(one, unknown)| one.system.carried(unknown));
        let arrived = first.system.blocks.apply_to_each(&carried.collect::<Vec<_>>());
        let all = systems.iter().zip(own).zip(unknown).zip(arrived);
        all.map(|(((system, own), unknown), arrived)| system.solution(&own, &unknown, arrived)).collect()
    }

    /// The solution of a system in the functions of its elements, all light of which G carries, by known light.
    pub(crate) fn known(&self, NearestLight { radiosity, irradiance, .. }: NearestLight) -> RitzSolution {
        let (own, unknown) = (self.starting(&irradiance), self.system.unknown_part(&radiosity));
        self.solution(&own, &unknown, irradiance)
    }

    /// The unknowns of such a system for the irradiance that all its light makes.
    pub(crate) fn starting(&self, irradiance: &[f64]) -> Vec<f64> {
        self.system.halved_unknowns(irradiance)
    }

    /// The unknowns of the elements for the unknowns a.
    fn extended<'u>(&self, unknowns: &'u [f64]) -> Cow<'u, [f64]> {
        match &self.reduction {
            None => Cow::Borrowed(unknowns),
            Some(reduction) => Cow::Owned(reduction.extended(unknowns)),
        }
    }

    /// √ρ y for the unknowns y of the elements.
    fn unknown_radiosity(&self, own: &[f64]) -> Vec<f64> {
        self.system.unknown_radiosity(0..self.system.reflecting.len(), own)
    }

    /// The solution for the unknowns y of the elements with their radiosity √ρ y, where what is carried of it has
    /// `arrived`.
    fn solution(&self, own: &[f64], unknown: &[f64], arrived: Vec<f64>) -> RitzSolution {
        let irradiance = self.system.irradiance(arrived);
        let functional = self.system.functional(own, unknown, &irradiance);
        let [irradiance, direct] = [irradiance, self.system.direct.clone()].map(|own| self.projected(own));
        RitzSolution { coefficients: self.system.with_irradiance(unknown, irradiance, direct), functional }
    }

    /// Light that was reflected `bounces` times at the most, and once less. Residuals are the radiosity of
    /// the next reflection, as for [`Coefficients::residual`].
    pub(crate) fn bounced(&self, bounces: usize) -> Bounced {
        let direct = self.projected(self.system.direct.clone());
        let mut irradiance = direct.clone();
        let mut term = self.projected(self.system.reflected_once(&direct));
        let mut before = None;
        for bounce in 1..=bounces {
            if bounce == bounces {
                before = Some(self.system.truncated(irradiance.clone(), direct.clone(), &term));
            }
            irradiance.iter_mut().zip(&term).for_each(|(sum, t)| *sum += t);
            term = self.projected(self.system.reflected_again(&term));
        }
        Bounced { coefficients: self.system.truncated(irradiance, direct, &term), before }
    }

    /// P x, the projection on the subspace.
    fn projected(&self, x: Vec<f64>) -> Vec<f64> {
        match &self.reduction {
            None => x,
            Some(reduction) => reduction.projected(&x),
        }
    }
}

impl System<'_> {
    /// I(y) for the unknowns y with their radiosity √ρ y and the irradiance that follows.
    fn functional(&self, unknowns: &[f64], unknown: &[f64], irradiance: &[f64]) -> f64 {
        let nothing = || Cow::Owned(vec![0.0; self.first.len()]);
        let apart = self.apart.as_deref().map_or_else(nothing, Cow::Borrowed);
        let of_unknown = irradiance.iter().zip(apart.iter()).zip(&self.first).map(|((h, l), g)| h - l - g);
        let carried: f64 = unknown.iter().zip(of_unknown).map(|(b, h)| b * h).sum();
        0.5 * (dot(unknowns, unknowns) - carried) - dot(unknown, &self.first)
    }
}
