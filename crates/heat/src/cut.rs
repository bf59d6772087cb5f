//! A balance on elements that are cut once more, which tells the error of the one that is printed.
//!
//! With the flows Q on elements as they are and Q′ on their quarters, and errors that fall as the power p of the
//! length of elements,
//!
//! ```text
//! Q − Q_∞ = c (Q − Q′) ,     c = 2ᵖ/(2ᵖ − 1) ,     p = 3/2
//! ```
//!
//! whatever the order: where surfaces meet or lie near each other, the irradiance is not smooth. Far above the gap of
//! two surfaces errors fall slower, where all is smooth faster; the true c lies between 1 and 2. Quarters carry order 2
//! at least: by symmetry orders 0 and 1, and quarters of order 0, may all tell the same.
//!
//! Where pairs are many, only surfaces are cut on which a part of the irradiance is reflected that varies much,
//!
//! ```text
//! v = ρ Σ (‖h‖² − (h·c)²/c·c)     over the elements of a surface,     h its coefficients, c those of 1 ;
//! ```
//!
//! at order 0 with ‖h‖² for the difference. What they tell counts as their part of Σ v. Pairs of n′ elements instead of
//! n take about
//!
//! ```text
//! near √(n′/n) + far (n′/n)²     seconds,     far = ½ n² (N + 1)⁴ terms ,
//! ```
//!
//! as rules cut near elements by themselves.

use radiosity_core::dot;
use radiosity_elements::Elements;
use radiosity_elements::mesh::{CellRefinement, Mesh};
use radiosity_solve::driver::cost::seconds_of_samples;
use radiosity_solve::{Model, Outcome};

use super::roles::{Role, Roles};

/// Time that pairs of elements of the cut may always take, by counts (s). Chosen: small enclosures are cut as a whole.
const LEAST: f64 = 2.5;

/// Time that they may take over that of the balance. Chosen: no balance takes much longer for its error.
const OF_A_RUN: f64 = 2.5;

/// Longest time that they may take where rays carry them, by counts (s). Chosen: a furnished room of ten thousand sides
/// would take its minutes twice, and what rays leave in it is more than even fluxes miss.
const LONGEST_BY_RAYS: f64 = 30.0;

/// Accuracy of the transfers between elements that are cut, over that of the balance. Chosen: they take half of the
/// time, and differences of smooth enclosures are still those of their ninth digit.
pub(super) const COARSER: f64 = 3.0;

/// c. Measured: true ones of sixty random scenes and of cavities, grooves and narrow gaps lie between 1 and 1.75.
const CONVERGENCE: f64 = 1.55;

/// Least order of the quarters. Chosen: the least that tells more than order 0 where all is symmetrical.
const LEAST_ORDER: usize = 2;

/// Elements that are cut once more.
#[derive(Debug)]
pub(super) struct Cut {
    /// Its cells.
    pub(super) mesh: Mesh,
    /// The order of the elements.
    pub(super) order: usize,
    /// Whether all surfaces are cut.
    pub(super) is_whole: bool,
    /// The surfaces that are cut.
    chosen: Vec<usize>,
}

impl Cut {
    /// The cut of the elements of a model, whose `outcome` it tells the error of; None where there is no time for it.
    pub(super) fn of(roles: &Roles, model: &Model, outcome: &Outcome) -> Option<Self> {
        let elements = model.elements();
        let order = elements.discretization().order.max(LEAST_ORDER);
        let varied = variations(elements, roles, outcome);
        let chosen = chosen(&varied, elements, Time::of(elements, order, outcome));
        if chosen.is_empty() {
            return None;
        }
        let is_whole = chosen.len() == varied.len();
        let by_rays = outcome.sampling.is_some();
        Some(Self { mesh: refined(elements, &chosen, by_rays), order, is_whole, chosen })
    }

    /// The factor that makes errors of the differences from the balance of an `outcome`: c, and what surfaces that are
    /// left whole add; None where light varies on these alone.
    pub(super) fn factor(&self, roles: &Roles, outcome: &Outcome) -> Option<f64> {
        let varied = variations(outcome.solution.elements(), roles, outcome);
        let part: f64 = self.chosen.iter().map(|surface| varied[*surface]).sum();
        let all: f64 = varied.iter().sum();
        match (part > 0.0, all > 0.0) {
            (true, _) => Some(CONVERGENCE * all / part),
            (false, true) => None,
            (false, false) => Some(CONVERGENCE),
        }
    }
}

/// The cells of these elements, those of the surfaces `chosen` in quarters; of orders that rays support, if rays carry
/// them.
fn refined(elements: &Elements, chosen: &[usize], by_rays: bool) -> Mesh {
    let mut of_surfaces = vec![CellRefinement::Keep; elements.surfaces()];
    for surface in chosen {
        of_surfaces[*surface] = CellRefinement::Cut(None);
    }
    let refinement: Vec<CellRefinement> =
        elements.list().iter().map(|element| of_surfaces[element.surface]).collect();
    let least = if by_rays { 0 } else { LEAST_ORDER };
    elements.refined(&refinement).with_orders(&|_, order| order.max(least))
}

/// v of each surface.
fn variations(elements: &Elements, roles: &Roles, outcome: &Outcome) -> Vec<f64> {
    let mut varied = vec![0.0; elements.surfaces()];
    let mut rest: &[f64] = &outcome.solution.bands()[0].coefficients.irradiance;
    for element in elements.list() {
        let (own, others) = rest.split_at(element.constant.len());
        let mean = match own.len() {
            1 => 0.0,
            _ => dot(&element.constant, own).powi(2) / dot(&element.constant, &element.constant),
        };
        varied[element.surface] += reflected(&roles.list[element.surface]) * (dot(own, own) - mean).max(0.0);
        rest = others;
    }
    varied
}

/// ρ of the balance.
fn reflected(role: &Role) -> f64 {
    match *role {
        Role::Temperature { emissivity, .. } | Role::Shield { emissivity, .. } => 1.0 - emissivity,
        Role::Flux { .. } => 1.0,
        Role::Idle { .. } => 0.0,
    }
}

/// Time for the pairs of a cut, in seconds by counts.
#[derive(Clone, Copy, Debug)]
struct Time {
    elements: f64,
    /// Terms of the rules of a pair that is far apart, on elements of the cut.
    terms: f64,
    near: f64,
    most: f64,
}

impl Time {
    /// The time for elements of this order.
    fn of(elements: &Elements, order: usize, outcome: &Outcome) -> Self {
        let count = elements.list().len() as f64;
        let terms = |order: usize| 0.5 * ((order + 1) as f64).powi(4);
        let far = seconds_of_samples(count * count * terms(elements.discretization().order));
        let longest = if outcome.sampling.is_some() { LONGEST_BY_RAYS } else { f64::INFINITY };
        Self {
            elements: count,
            terms: terms(order),
            near: (seconds_of_samples(outcome.samples as f64) - far).max(0.0),
            most: LEAST.max(OF_A_RUN * outcome.seconds_by_counts()).min(longest),
        }
    }

    /// Whether there is time for so many elements.
    fn suffices(&self, elements: f64) -> bool {
        let far = seconds_of_samples(elements * elements * self.terms);
        self.near * (elements / self.elements).sqrt() + far <= self.most
    }
}

/// The surfaces that are cut: those of large v first, as many as there is time for.
fn chosen(varied: &[f64], elements: &Elements, time: Time) -> Vec<usize> {
    let mut order: Vec<usize> = (0..varied.len()).collect();
    order.sort_by(|a, b| varied[*b].total_cmp(&varied[*a]).then(a.cmp(b)));
    let mut count = time.elements;
    let fits = |surface: &usize| {
        let more = count + 3.0 * elements.of_surface(*surface).len() as f64;
        let fits = time.suffices(more);
        count = if fits { more } else { count };
        fits
    };
    order.into_iter().filter(fits).collect()
}
