//! Warnings of a report.

use radiosity_audit::Checked;
use radiosity_core::dot;
use radiosity_kernel::WorstError;
use radiosity_scene::Scene;
use radiosity_solve::solution::Band;
use radiosity_solve::solved::Solved;
use radiosity_solve::studies::adaptation::{Achieved, EndReason};
use radiosity_solve::{LightMethod, Options, Outcome, Sampling};
use radiosity_visibility::Shadows;
use radiosity_visibility::inspection::{BEFORE_OPENINGS, Inspection, before_openings};
use radiosity_work::digits::significant;
use radiosity_work::wording::{Wording, option, set, words};

use crate::accuracy_warning::missed;
use crate::reader::ReadMode;

use crate::warning::Warning;

/// The warnings of a solved scene.
pub(super) fn warnings(solved: &Solved) -> Vec<Warning> {
    let Solved { scene, options, outcome, achieved, .. } = solved;
    // As many shots as were asked for end where they should.
    let is_short = !outcome.converged && options.shots.is_none();
    let unconverged = is_short.then(|| unconverged(outcome));
    let adapted = achieved.iter().flat_map(|achieved| adaptation(scene, options, achieved));
    let is_reached = achieved.is_some_and(|achieved| achieved.reached());
    let transfers = discretization(scene, options, outcome, is_reached);
    unconverged
        .into_iter()
        .chain(partial(options, outcome))
        .chain(adapted)
        .chain(transfers)
        .chain(power(solved))
        .chain(before_openings(scene).into_iter().map(of_inspection))
        .chain(geometry(scene, outcome))
        .chain(unused_masks(scene, options))
        .collect()
}

/// A warning where a referee found more of light that was read from `read` than the method's own estimates tell, with
/// the names of the places.
pub fn underestimated(checked: &Checked, read: ReadMode) -> Option<Warning> {
    let own = significant(100.0 * checked.own_error, 2);
    let finding = checked.finding()?;
    let message = words(format!(
        "the method tells an error of {own} %, and path tracing finds more: {finding}; ask for an "
    )) + option("accuracy")
        + match read {
            ReadMode::Basis => {
                words(" with ") + set("for", "solution") + ", or take " + set("read", "gather")
            }
            ReadMode::Direct | ReadMode::Gather | ReadMode::GatherTwice => {
                words(", or a smaller ") + option("eps")
            }
        };
    Some(Warning::general("error-underestimated", message))
}

/// Faults that an inspection finds in a scene that loses power, or elements of which send more than they
/// have. Scenes of many surfaces are left to `radiosity check`.
fn geometry(scene: &Scene, outcome: &Outcome) -> Vec<Warning> {
    let checks = &outcome.checks;
    let is_odd = checks.energy_lost.abs() > ODD * checks.energy_in || checks.row_sum_max > 1.0 + ODD;
    if !is_odd || scene.surfaces.len() > FEW {
        return Vec::new();
    }
    let is_told = |code: &str| code == BEFORE_OPENINGS;
    let found = Inspection::of(scene).warnings.into_iter();
    let new = found.filter(|found| !found.is_of_something_missing() && !is_told(found.code));
    new.map(of_inspection).collect()
}

/// A finding of an inspection as a warning of a run.
fn of_inspection(found: radiosity_visibility::inspection::Warning) -> Warning {
    Warning { surface: found.surface, ..Warning::general(found.code, found.message) }
}

/// A warning where power appears, or is lost though no element sends light past all others by more than their
/// transfers may worst.
fn power(solved: &Solved) -> Option<Warning> {
    let Solved { options, outcome, .. } = solved;
    let checks = &outcome.checks;
    let lost = checks.energy_lost / checks.energy_in;
    let error = options.accuracy().eps.max(outcome.accuracy_reached);
    let looks_closed = checks.row_sum_min > 1.0 - CLOSED * error;
    let message = match lost {
        _ if lost < -ODD => format!("{:.0} % more power is absorbed than emitted", -100.0 * lost),
        _ if lost > ODD && looks_closed => {
            format!("{:.0} % of the power is lost in a scene that looks closed", 100.0 * lost)
        }
        _ => return None,
    };
    Some(Warning::general("power-balance", words(message) + "; " + cure_of_power(options, outcome)))
}

/// Why power is lost or found, and what helps. Transfers lose of the radiosity B that they carry what their
/// row sums miss 1 by,
///
/// ```text
/// |⟨B, c − G c⟩| ≲ max_i |1 − Σ_j F_ij| ∫ B dA ,
/// ```
///
/// and nothing where rays made these sums agree. What is much more than that is direct light, which enters
/// otherwise.
fn cure_of_power(options: &Options, outcome: &Outcome) -> Wording {
    let Outcome { checks, solution, .. } = outcome;
    let has_points = !solution.emitters().points.is_empty();
    let missed = match outcome.sampling {
        Some(_) => 0.0,
        None => (1.0 - checks.row_sum_min).max(checks.row_sum_max - 1.0).max(0.0),
    };
    let ones = solution.elements().constant();
    let of_band = |band: &Band| dot(&band.coefficients.radiosity, &ones);
    let carried: f64 = solution.bands().iter().map(of_band).sum();
    let is_direct = checks.energy_lost.abs() > BEYOND * missed * carried;
    if options.masks.is_some() {
        return words(
            "where surfaces reflect nearly all light, what masks and transfers err by counts once for every reflection: lower ",
        ) + option("eps")
            + ", take more "
            + option("mask-cells")
            + ", or more cells in [[masks]] that state them, or leave "
            + set("shadows", "mask")
            + " out";
    }
    match (is_direct, has_points, outcome.split) {
        (true, true, _) => words(
            "narrow beams and patches of luminaires or the sun fall between the points at which elements take their light, and \
                 what they reflect is off by as much: give the surfaces that they fall on a finer subdivide = [n, n] of their own",
        ),
        (true, false, true) => {
            words(
                "direct light, which is split off, falls on elements with borders that they do not resolve: give the surfaces that \
                 it falls on a finer subdivide = [n, n] of their own, or take ",
            ) + set("direct", "projected")
        }
        _ => {
            let usual = match (options.shadows, outcome.sampling) {
                (Shadows::Off, _) => sees_through(),
                (_, Some(Sampling { rays, planned, .. })) if rays < planned => {
                    words("give rays more time with ") + option("time-limit")
                }
                (_, Some(_)) => words("send more ") + option("rays"),
                (_, None) => words("lower ") + option("eps"),
            };
            words(
                "where surfaces reflect nearly all light, the error of the transfers counts once for every reflection: ",
            ) + cure(options, usual)
        }
    }
}

/// A warning that the scene chooses masks, and light is not masked.
fn unused_masks(scene: &Scene, options: &Options) -> Option<Warning> {
    if scene.masks.is_empty() || options.masks.is_some() {
        return None;
    }
    let message = words("the scene chooses pairs for shadow masks, [[masks]], which have no effect without ");
    Some(Warning::general("masks-unused", message + set("shadows", "mask")))
}

/// A warning that the light is what a number of shots brought.
fn partial(options: &Options, outcome: &Outcome) -> Option<Warning> {
    let limit = options.shots?;
    let waiting = outcome.shots.as_ref().map_or(0.0, |shots| shots.unshot);
    let ambient = if limit.ambient { ", for which an ambient term stands" } else { "" };
    let message = format!(
        "the light is partial: after the shots that were asked for {:.0} % of the power to be shot waits{ambient}",
        100.0 * waiting
    );
    (waiting > WAITING).then(|| Warning::general("shots", words(message)))
}

fn unconverged(outcome: &Outcome) -> Warning {
    let told = format!(
        "the solver did not converge, the relative residual is {:.1e}: the light is incomplete; raise ",
        outcome.residual
    );
    let message = words(told) + option("max-iterations") + " or take another " + option("solver");
    Warning::general("not-converged", message)
}

/// Warnings if a wanted accuracy was not reached.
fn adaptation(scene: &Scene, options: &Options, achieved: &Achieved) -> Vec<Warning> {
    let mut warnings: Vec<Warning> = missed_accuracy(scene, options, achieved).into_iter().collect();
    if states_elements(scene) {
        let message = "some surfaces state their own order or subdivide and keep it: no run is finer there, and what \
                       they miss stays in the estimated error";
        warnings.push(Warning::general("accuracy-fixed", message));
    }
    warnings
}

/// Whether surfaces state their own order or subdivide.
fn states_elements(scene: &Scene) -> bool {
    scene.surfaces.iter().any(|surface| surface.order.is_some() || surface.subdivide.is_some())
}

/// A warning if a wanted accuracy was not reached.
pub(super) fn missed_accuracy(scene: &Scene, options: &Options, achieved: &Achieved) -> Option<Warning> {
    let why = why(scene, options, achieved.end)?;
    let estimate = match achieved.estimate {
        Some(estimate) => format!("the estimated error is {estimate:.1e}, more than asked for"),
        None => "there is no estimate of the error".to_owned(),
    };
    Some(Warning::general("accuracy-not-reached", words(estimate) + ", and " + why))
}

/// Why no finer run followed and what to do; None if none was needed.
fn why(scene: &Scene, options: &Options, end: EndReason) -> Option<Wording> {
    Some(match end {
        EndReason::Reached => return None,
        EndReason::Finest => words("there is no finer run to try: ") + cure_of_finest(scene, options),
        EndReason::Unknowns => words(
            "the next finer elements would be too many: give surfaces with shadows or small details a subdivide of their \
             own, or ask for less",
        ),
        EndReason::Memory => {
            words("the next finer run does not fit into memory: allow more with ")
                + option("memory")
                + ", or ask for less"
        }
        EndReason::NotConverged => {
            words("the solver did not converge in a finer run: raise ")
                + option("max-iterations")
                + ", or take another "
                + option("solver")
        }
        EndReason::Time => {
            words("the next finer run would have taken longer than allowed: allow more with ")
                + option("time-limit")
                + ", or ask for less"
        }
        EndReason::Walks => {
            words("walks end where each reading has had its most: take ")
                + set("read-by", "rays")
                + ", or ask for less"
        }
        EndReason::Stopped => words("the run was stopped: let it go on, or ask for less"),
    })
}

/// Advice where the finest run misses the accuracy: a higher order helps where surfaces take it, and where neither
/// rays nor links carry the light.
fn cure_of_finest(scene: &Scene, options: &Options) -> Wording {
    if options.method == LightMethod::Hierarchical || options.rays.is_some() {
        return words("ask for less");
    }
    match states_elements(scene) {
        true => words("leave out the order and the subdivide that surfaces state, or ask for less"),
        false => words("begin with a higher ") + option("order") + ", or ask for less",
    }
}

/// Share of the power that is lost, and of what an element sends too much, from which the geometry is
/// inspected; and the number of surfaces up to which that takes about a second at most. Chosen.
const ODD: f64 = 0.01;
const FEW: usize = 300;

/// Power that is lost, over the most that transfers lose, from which direct light loses it. Chosen.
const BEYOND: f64 = 2.0;

/// Errors of the transfers within which row sums count as 1.
const CLOSED: f64 = 3.0;

/// Part of the power that waits to be shot from which on light is told to be partial. Chosen.
const WAITING: f64 = 1e-3;

/// Error of the mean irradiances of elements above which more rays are advised. Chosen: light gathered from
/// such elements at points was 3 % off in a classroom.
const ROUGH: f64 = 0.15;

/// A warning where rays leave a large error. Those that ended before all were sent had too little time.
fn rays(sampling: &Sampling) -> Option<Warning> {
    let Sampling { error, rays, planned, .. } = *sampling;
    let cure = match rays < planned {
        true => {
            words(format!("{rays} of {planned} were sent: give them more time with ")) + option("time-limit")
        }
        false => words("send more with ") + option("rays"),
    };
    let message = || match error {
        None => words("rays leave an unknown error: half of them are too few for a solution; ") + cure,
        Some(error) => {
            let told = format!(
                "rays leave an error of about {:.0} % in the mean irradiances of the elements, less in gathered light: ",
                100.0 * error
            );
            words(told) + cure + ", or ask for an " + option("accuracy")
        }
    };
    error.is_none_or(|error| error > ROUGH).then(|| Warning::general("sampling-error", message()))
}

/// Warnings about what elements and transfers worst.
fn discretization(scene: &Scene, options: &Options, outcome: &Outcome, is_reached: bool) -> Vec<Warning> {
    if let Some(sampling) = outcome.sampling {
        // What exact pairs miss is a part of it; light of the accuracy that was asked for is fine as it is.
        return rays(&sampling).filter(|_| !is_reached).into_iter().collect();
    }
    let worst = outcome.worst_error.filter(WorstError::is_real);
    let warnings = [
        worst.map(|worst| inaccurate(scene, outcome, &worst)),
        unresolved(outcome),
        row_sum(options, outcome),
        spectral_bound(options, outcome),
    ];
    warnings.into_iter().flatten().collect()
}

/// A warning about pairs that were not split to the end.
fn unresolved(outcome: &Outcome) -> Option<Warning> {
    let message = || {
        format!(
            "{} pairs come so near each other, or touch in such a way, that splitting stopped: their blocks may \
             miss the accuracy asked; subdivide the surfaces there",
            outcome.pairs.unresolved
        )
    };
    (outcome.pairs.unresolved > 0).then(|| Warning::general("near-floor", words(message())))
}

/// A warning about transfers that carry more light than is sent.
fn row_sum(options: &Options, outcome: &Outcome) -> Option<Warning> {
    let excess = outcome.checks.row_sum_max - 1.0;
    let message = || {
        words(format!(
            "an element sends {:.2} % more than it has: its transfers miss the accuracy asked; ",
            100.0 * excess
        ))
    };
    let usual = || match options.shadows {
        Shadows::Off => sees_through(),
        _ => words("lower ") + option("eps") + ", or subdivide surfaces that meet at small angles",
    };
    let allowed = 10.0 * options.eps.max(if outcome.rays > 0 { options.shadow_eps } else { 0.0 });
    (excess > allowed).then(|| Warning::general("row-sum", message() + cure(options, usual())))
}

/// Advice where elements see what others hide from them.
fn sees_through() -> Wording {
    words("lower ")
        + option("eps")
        + "; where surfaces stand between others, leave "
        + set("shadows", "off")
        + " out, which lets light through them"
}

/// A warning about transfers whose light grows with each reflection.
fn spectral_bound(options: &Options, outcome: &Outcome) -> Option<Warning> {
    let bound = outcome.checks.spectral_bound;
    let message = || {
        words(format!(
            "the spectral radius is about {bound:.6}: quadrature is too coarse for so little loss; "
        ))
    };
    let usual = || words("lower ") + option("eps");
    (bound >= 1.0).then(|| Warning::general("spectral-bound", message() + cure(options, usual())))
}

/// The cure of transfers that are not accurate enough. The rules of 1993 have no accuracy, collocation loses what
/// interpolation errs, and links are rough where faces meet.
fn cure(options: &Options, usual: Wording) -> Wording {
    match options {
        Options { kernel: Some(_), .. } => words("choose the default kernel"),
        Options { method: LightMethod::Collocation, .. } => {
            words("leave ") + set("method", "collocation") + " out, or take a higher " + option("order")
        }
        Options { method: LightMethod::Hierarchical, .. } => {
            words("its links are rough where faces meet, leave ") + set("method", "hierarchical") + " out"
        }
        _ => usual,
    }
}

/// A warning about transfers that miss what was asked.
fn inaccurate(scene: &Scene, outcome: &Outcome, worst: &WorstError) -> Warning {
    let list = outcome.solution.elements().list();
    let [surface, other] = worst.pair.map(|element| &scene.surfaces[list[element].surface].name);
    let told = Warning::general("accuracy-reached", missed(worst, [surface, other]));
    Warning { surface: Some(surface.clone()), other: Some(other.clone()), size: Some(worst.error), ..told }
}
