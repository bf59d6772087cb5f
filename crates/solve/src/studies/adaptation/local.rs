//! Refinement of those elements that are responsible for the error of what is read.
//!
//! From run to run the elements that bear most of the error (`gathered`) are cut, or get more polynomials
//! (`smoothness`): as few as bear what must go, so that surfaces whose light is read nowhere stay as they
//! are. (W. Dörfler, *A convergent adaptive algorithm for Poisson's equation*, SIAM J. Numer. Anal. 33
//! (1996), for the choice by a part of the whole.)

use std::time::Instant;

use radiosity_elements::mesh::{CellRefinement, Mesh};
use radiosity_scene::Scene;
use radiosity_work::Work;

use super::achieved::{Achieved, Adapted, EndReason};
use super::goal::Goal;
use super::run::{FIRST_ORDER, advise, estimated, finer};
use super::smoothness::refinement;
use crate::driver::{Failure, Options, solve_exactly};
use crate::solution::Solution;
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

/// Solves `scene` by exact blocks, for the reason `why`, on elements refined where the goal needs it.
pub(super) fn locally(
    scene: &Scene,
    options: &Options,
    goal: &Goal,
    why: &str,
    work: &Work<'_>,
) -> Result<Adapted, Failure> {
    let accurate = |accuracy: f64, sharper: f64| Options {
        order: options.order.max(FIRST_ORDER),
        eps: sharper * options.eps.min(OF_BLOCKS * accuracy),
        shadow_eps: sharper * options.shadow_eps.min(OF_SHADOWS * accuracy),
        ..*options
    };
    let mut expected = goal.accuracy.max(FIRST);
    let mut sharper = 1.0;
    let mut chosen = accurate(expected, sharper);
    let mut begun = Instant::now();
    let mut outcome = solve_exactly(scene, &chosen, why, None, work).map_err(advise)?;
    if !outcome.converged {
        let achieved = Achieved::new(goal, None, EndReason::NotConverged);
        return Ok(Adapted { outcome, options: chosen, achieved });
    }
    let mut error;
    let (mut least, mut vain) = (f64::INFINITY, 0);
    let end = loop {
        let estimate = estimated(scene, &mut outcome, &chosen, goal, expected, work)?;
        error = estimate.error;
        if error <= goal.accuracy && expected > goal.accuracy {
            // Light gathered for a larger error may hide as much as is wanted.
            expected = goal.accuracy;
            continue;
        }
        if error <= goal.accuracy {
            break EndReason::Reached;
        }
        let left = (LEFT * (goal.accuracy / error).powi(2)).clamp(1.0 - BORNE[1], 1.0 - BORNE[0]);
        let Some(mesh) = refined(scene, &outcome.solution, &estimate.shares, 1.0 - left) else {
            break EndReason::Finest;
        };
        expected = goal.accuracy.max(NEXT * error);
        vain = if error < least { 0 } else { vain + 1 };
        least = least.min(error);
        if vain == VAIN {
            (sharper, vain) = (SHARPENING_IN_VAIN * sharper, 0);
        }
        let next = accurate(expected, sharper);
        let elements = outcome.solution.elements();
        // Cuts may leave cells too thin for their order.
        let Ok(unknowns) =
            next.elements(scene, elements.discretization(), Some(&mesh)).map(|new| new.coefficients())
        else {
            break EndReason::Finest;
        };
        if unknowns == elements.coefficients() && sharper == 1.0 {
            break EndReason::Finest;
        }
        if unknowns > goal.most_unknowns {
            break EndReason::Unknowns;
        }
        let growth = unknowns as f64 / elements.coefficients() as f64;
        if !work.fits(begun.elapsed().mul_f64(growth.powi(2))) {
            break EndReason::Time;
        }
        begun = Instant::now();
        match finer(solve_exactly(scene, &next, why, Some(&mesh), work))? {
            Ok(finer) => (outcome, chosen) = (finer, next),
            Err(end) => break end,
        }
    };
    Ok(Adapted { outcome, options: chosen, achieved: Achieved::new(goal, Some(error), end) })
}

/// The mesh with those elements refined that bear this part of what all bear; None where none of them may be.
/// Surfaces that state their own order or cuts keep them.
fn refined(scene: &Scene, solution: &Solution, shares: &[f64], part: f64) -> Option<Mesh> {
    let list = solution.elements().list();
    let is_free = |index: &usize| {
        let surface = &scene.surfaces[list[*index].surface];
        let is_own = surface.order.is_some() || surface.subdivide.is_some();
        shares[*index] > 0.0 && list[*index].contact.is_none() && !is_own
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
