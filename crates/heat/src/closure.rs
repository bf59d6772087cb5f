//! The closure of transfers: in a closed scene each row sums to 1.
//!
//! All that leaves an element i of a closed region arrives somewhere, and what two elements exchange is the
//! same both ways:
//!
//! ```text
//! Σ_j G_ij c_j = c_i ,     G_ji = G_ijᵀ ,     c_i the coefficients of the constant 1 on element i .
//! ```
//!
//! Blocks by quadrature or by rays keep the second exactly, the first to their accuracy. They are moved until
//! they keep both ([`correction`]), so that no heat is made or lost. Some view factors follow from the two
//! alone: those of a body without hollows in a ball, F₁₂ = 1, F₂₁ = A₁/A₂ and F₂₂ = 1 − A₁/A₂, are exact
//! then, however roughly they were found ([`pairs`]).
//!
//! Whether a region is closed is read off the borders of its surfaces ([`Regions`]), not off the transfers.
//! Where these say otherwise by more than they may err, nothing is moved.

mod pairs;
mod correction;

use radiosity_scene::Scene;
use radiosity_solve::{Model, Options};
use radiosity_visibility::inspection::Regions;

use correction::{Deficit, corrected};
use pairs::Pairs;

/// Largest distance of a row sum from 1, over the error of the transfers, that is theirs and not that of the
/// scene: what is told of errors may be too small by some factor. With a larger value gaps of a scene would
/// be corrected away.
const TRUSTED: f64 = 10.0;

/// Accuracy of the transfers between the elements of a scene.
#[derive(Clone, Copy, Debug)]
pub(super) struct Closure {
    /// Largest distance of a row sum from 1 before the rows were made to sum to 1; None where they were left
    /// as they were.
    pub(super) moved: Option<f64>,
    /// Whether all exchanges are exact: elements carry constants, and what is not integrated exactly follows
    /// from sums.
    pub(super) is_exact: bool,
}

/// The model with rows that sum to 1 where its `scene` is closed.
pub(super) fn close(scene: &Scene, model: Model, options: &Options) -> (Model, Closure) {
    let regions = if may_be_moved(&model) { Regions::of(scene) } else { None };
    let elements = model.elements();
    let is_closed = |surface: usize| regions.as_ref().is_some_and(|regions| regions.is_closed(surface));
    let rows: Vec<bool> = elements.list().iter().map(|element| is_closed(element.surface)).collect();
    let moved = Deficit::of(elements, model.blocks(), &rows).largest(elements);
    let told = options.eps.max(options.shadow_eps).max(model.blocks().statistics.accuracy_reached);
    let is_trusted = rows.contains(&true) && moved <= TRUSTED * told;
    let pairs = Pairs::of(&model, regions.as_ref());
    let are_constants = elements.list().iter().all(|element| element.basis.len() == 1);
    let is_exact = are_constants && (pairs.are_exact() || (is_trusted && pairs.follow_from(&rows)));
    if !is_trusted {
        return (model, Closure { moved: None, is_exact });
    }
    let blocks = corrected(elements, model.blocks(), &pairs, &rows);
    (model.with_blocks(blocks), Closure { moved: Some(moved), is_exact })
}

/// Whether rows may be moved: rays that carried all pairs have closed theirs themselves, and elements that
/// lie on each other see each other alone.
fn may_be_moved(model: &Model) -> bool {
    !model.blocks().is_by_rays() && model.elements().list().iter().all(|element| element.contact.is_none())
}
