//! Refinement of those elements that are responsible for the error of what is read.
//!
//! From run to run the elements that bear most of the error (`gathered`) are cut, or get more polynomials
//! (`smoothness`): as few as bear what must go, so that surfaces whose light is read nowhere stay as they
//! are. (W. Dörfler, *A convergent adaptive algorithm for Poisson's equation*, SIAM J. Numer. Anal. 33
//! (1996), for the choice by a part of the whole.)

use radiosity_elements::Elements;
use radiosity_elements::mesh::{CellRefinement, Mesh};
use radiosity_scene::Scene;

use super::run::{Adaptation, FIRST_ORDER, PlannedRun};
use super::smoothness::refinement;
use crate::driver::{Failure, Options};
use crate::goal::EndReason;
use crate::solution::Solution;
use crate::solved::Solved;
use crate::tolerances::SHARPENING_IN_VAIN;

/// Part of the squared error that the refined elements bear, at the least and at the most: less would take
/// many runs, of more the last elements err by little.
const BORNE: [f64; 2] = [0.5, 0.95];

/// Part of the squared error that is wanted which refined elements may leave; the other half is for what the
/// refined ones will have.
const LEFT: f64 = 0.5;

/// Accuracy of blocks and of their shadows over the expected error: errors of single blocks balance in what
/// is gathered. With a quarter and 1 the errors were mostly the same, in up to three times the time.
const OF_BLOCKS: f64 = 0.5;
const OF_SHADOWS: f64 = 3.0;

/// After so many runs without a smaller error errors of blocks are taken for the cause, and their accuracies
/// are multiplied by [`SHARPENING_IN_VAIN`]: one run may look worse by chance. Chosen.
const VAIN: usize = 2;

/// Error that the first run is expected to have where less is wanted: the elements of a scene as it is err by
/// more, and finer transfers would be in vain.
const FIRST: f64 = 3e-3;

/// The least part of the last error that the next run is expected to have; its transfers are made for that.
/// Chosen: refined where 95 % of the squared error is borne, errors fell by a factor of 1.5 to 4.
const NEXT: f64 = 0.25;

/// Solves `scene` by exact blocks on elements refined where the goal needs it.
pub(super) fn locally(scene: Scene, options: &Options, adaptation: &Adaptation) -> Result<Solved, Failure> {
    let accuracy = adaptation.goal.accuracy;
    let planned = |expected: f64, sharper: f64| {
        let options = Options {
            order: options.order.max(FIRST_ORDER),
            eps: sharper * options.eps.min(OF_BLOCKS * expected),
            shadow_eps: sharper * options.shadow_eps.min(OF_SHADOWS * expected),
            ..*options
        };
        PlannedRun { expected, ..adaptation.first(options) }
    };
    let (mut sharper, mut least, mut vain) = (1.0, f64::INFINITY, 0);
    adaptation.refined(scene, planned(accuracy.max(FIRST), sharper), |run, found| {
        let error = found.error;
        let own = match found.own {
            Some(own) => own,
            None => adaptation.own(run, error)?,
        };
        let solution = &run.outcome.solution;
        let left = (LEFT * (accuracy / error).powi(2)).clamp(1.0 - BORNE[1], 1.0 - BORNE[0]);
        let Some(mesh) = refined(&run.scene, solution, &own.shares, 1.0 - left) else {
            return Ok(Err(EndReason::Finest));
        };
        vain = if error < least { 0 } else { vain + 1 };
        least = least.min(error);
        if vain == VAIN {
            (sharper, vain) = (SHARPENING_IN_VAIN * sharper, 0);
        }
        let next = planned(accuracy.max(NEXT * error), sharper);
        let elements = solution.elements();
        // Cuts may leave cells too thin for their order.
        let cut = Elements::of_mesh(&run.scene, elements.discretization(), mesh.clone());
        let unknowns = cut.ok().map(|cut| cut.coefficients());
        let is_finer = |unknowns: &usize| *unknowns != elements.coefficients() || sharper != 1.0;
        let Some(unknowns) = unknowns.filter(is_finer) else { return Ok(Err(EndReason::Finest)) };
        let growth = adaptation.growth(run, unknowns);
        Ok(growth.map(|growth| PlannedRun { mesh: Some(mesh), growth, ..next }))
    })
}

/// The mesh with those elements refined that bear this part of what all bear; None where none of them may be.
/// Surfaces that state their own order or cuts keep them.
fn refined(scene: &Scene, solution: &Solution, shares: &[f64], part: f64) -> Option<Mesh> {
    let list = solution.elements().list();
    let is_free = |index: &usize| {
        let surface = &scene.surfaces[list[*index].surface];
        let is_own = surface.order.is_some() || surface.subdivide.is_some();
        shares[*index] > 0.0 && list[*index].is_cell() && !is_own
    };
    let mut bearing: Vec<usize> = (0..list.len()).filter(is_free).collect();
    bearing.sort_by(|a, b| shares[*b].total_cmp(&shares[*a]));
    let wanted = part * bearing.iter().map(|index| shares[*index]).sum::<f64>();
    let starts = solution.elements().starts();
    let mut refinements = vec![CellRefinement::Keep; list.len()];
    let mut borne = 0.0;
    for index in bearing {
        if borne >= wanted {
            break;
        }
        borne += shares[index];
        refinements[index] = refinement(solution, &starts, index);
    }
    (borne > 0.0).then(|| solution.elements().refined(&refinements))
}
