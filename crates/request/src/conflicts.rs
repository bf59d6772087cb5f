//! Options of a method that do not go with each other.

use radiosity_elements::cells::Layers;
use radiosity_published::bases::Basis;
use radiosity_published::zatz1993::masking::Masking;
use radiosity_solve::studies::convergence::RunSeries;
use radiosity_solve::{ColumnChoice, Direct, LightMethod, Preconditioning, Transport};
use radiosity_solvers::method::{Access, Method};
use radiosity_visibility::Shadows;
use radiosity_work::wording::{Wording, option, set, value, words};

use super::method::MethodRequest;
use super::modes::LightShadows;
use super::ranges::Order;
use super::refusal::Refusal;

impl MethodRequest {
    /// Refuses options that do not go with each other, or do nothing beside others.
    ///
    /// # Errors
    /// The first such options.
    pub fn check(&self) -> Result<(), Refusal> {
        check_idle(self)?;
        check_hierarchical(self)?;
        check_collocation(self)?;
        check_rays(self)?;
        check_kernel(self)?;
        check_basis(self)?;
        check_bounces(self)?;
        check_shots(self)?;
        check_columns(self)?;
        check_relaxing(self)?;
        check_preconditioner(self)
    }

    /// Refuses a time limit where many solutions follow each other, of which none is the best so far.
    ///
    /// # Errors
    /// Such a limit.
    pub fn check_time_of_many(&self) -> Result<(), Refusal> {
        match self.time_limit {
            None => Ok(()),
            Some(_) => Err(Refusal::new(
                option("time-limit") + " does nothing where many solutions follow each other",
                words("leave it out, or solve one scene with ") + option("time-limit"),
            )),
        }
    }
}

/// Refuses numbers that say how something is done that is not asked for.
fn check_idle(method: &MethodRequest) -> Result<(), Refusal> {
    let (layers, masking, usual) = (method.graded_layers(), method.masking(), Masking::default());
    let has_masks = method.shadows == Some(LightShadows::Mask);
    let has_links = method.method == Some(LightMethod::Hierarchical);
    let links = || set("method", "hierarchical");
    let idle = [
        (method.link_measure.is_some() && !has_links, "link-measure", links()),
        (method.link_rays.is_some() && !has_links, "link-rays", links()),
        (method.least_area.is_some() && !has_links, "least-area", links()),
        (layers.ratio != Layers::NONE.ratio && layers.count == 0, "ratio", option("layers")),
        (masking.cells != usual.cells && !has_masks, "mask-cells", set("shadows", "mask")),
        (masking.average != usual.average && !has_masks, "mask-average", set("shadows", "mask")),
    ];
    match idle.into_iter().find(|(is_idle, ..)| *is_idle) {
        Some((_, name, needed)) => Err(Refusal::new(
            option(name) + " does nothing without " + needed.clone(),
            words("add ") + needed + ", or leave " + option(name) + " out",
        )),
        None => Ok(()),
    }
}

/// Refuses options that hierarchical radiosity does not know.
fn check_hierarchical(method: &MethodRequest) -> Result<(), Refusal> {
    let is_higher = matches!(method.order, Some(Order::Degree(1..)));
    let unknown = [
        (is_higher, option("order") + " above 0"),
        (method.tensor, option("tensor")),
        (method.subdivide.unwrap_or_default().0.is_some(), option("subdivide")),
        (method.graded_layers().count > 0, option("layers")),
        (method.kernel.unwrap_or_default().rules().is_some(), option("kernel")),
        (method.transport.unwrap_or_default() != Transport::Auto, option("transport")),
        (method.rays.is_some(), option("rays")),
        (
            method.shadows.is_some_and(|shadows| shadows != LightShadows::Found(Shadows::Auto)),
            option("shadows"),
        ),
        (method.shadow_eps.is_some(), option("shadow-eps")),
        (method.direct.is_some_and(|direct| direct != Direct::Auto), option("direct")),
    ];
    match unknown.into_iter().find(|(is_typed, _)| *is_typed) {
        Some((_, name)) if method.method == Some(LightMethod::Hierarchical) => Err(Refusal::new(
            set("method", "hierarchical") + " knows no " + name.clone() + ": it links constants",
            words("leave ") + name + " out, or leave " + option("method") + " out",
        )),
        _ => Ok(()),
    }
}

/// Refuses what collocation does not know: light that no rule integrates, and estimates of its error.
fn check_collocation(method: &MethodRequest) -> Result<(), Refusal> {
    if method.method != Some(LightMethod::Collocation) {
        return Ok(());
    }
    let unknown = [
        method.kernel.unwrap_or_default().rules().map(|_| option("kernel")),
        (method.shadows == Some(LightShadows::Mask)).then(|| set("shadows", "mask")),
        (method.transport == Some(Transport::Sampled)).then(|| set("transport", "sampled")),
        method.rays.map(|_| option("rays")),
        method.wanted_accuracy().map(|_| option("accuracy")),
        method.aim.as_ref().map(|_| option("for")),
    ];
    refuse(set("method", "collocation"), unknown)
}

/// Refuses rays together with the methods of 1993, which know none.
fn check_rays(method: &MethodRequest) -> Result<(), Refusal> {
    let Some(rays) = asked_rays(method.transport, method.rays.is_some()) else { return Ok(()) };
    let others = [
        method.kernel.unwrap_or_default().rules().map(|_| option("kernel")),
        (method.shadows == Some(LightShadows::Mask)).then(|| set("shadows", "mask")),
        (method.shadows == Some(LightShadows::Found(Shadows::Off))).then(|| set("shadows", "off")),
        (method.transport == Some(Transport::Exact)).then(|| set("transport", "exact")),
    ];
    refuse(rays, others)
}

/// The option that asks for rays, if one does: a transport, or their number.
pub(super) fn asked_rays(transport: Option<Transport>, has_number: bool) -> Option<Wording> {
    match transport {
        Some(Transport::Sampled) => Some(set("transport", "sampled")),
        _ => has_number.then(|| option("rays")),
    }
}

/// Refuses polynomials of a degree in each coordinate for the rules of 1993, which know a total degree.
fn check_kernel(method: &MethodRequest) -> Result<(), Refusal> {
    match method.kernel.unwrap_or_default().rules() {
        Some(_) => {
            let tensor = method.tensor.then(|| option("tensor"));
            refuse(option("kernel") + " with the rules of 1993", [tensor])
        }
        None => Ok(()),
    }
}

/// Refuses a preconditioner for a solver that takes none.
fn check_preconditioner(method: &MethodRequest) -> Result<(), Refusal> {
    let solver = method.solver().map_or("auto", |solver| solver.name);
    if method.preconditioner == Some(Preconditioning::None) && !["auto", "cg", "gmres"].contains(&solver) {
        return Err(Refusal::new(
            option("preconditioner") + " does nothing with " + set("solver", solver),
            words("take ")
                + set("solver", "cg")
                + " or "
                + value("gmres")
                + ", or leave "
                + option("preconditioner")
                + " out",
        ));
    }
    Ok(())
}

fn check_basis(method: &MethodRequest) -> Result<(), Refusal> {
    let basis = method.basis.unwrap_or_default();
    let name = basis.name();
    if basis == Basis::Legendre {
        return Ok(());
    }
    refuse(set("basis", name), others(method))?;
    let order = match method.order {
        Some(Order::Degree(order)) => order,
        _ => return Ok(()),
    };
    let own = match basis {
        Basis::Constant => 0,
        Basis::Linear => 1,
        Basis::Legendre | Basis::Harmonic => return Ok(()),
    };
    if order == own {
        return Ok(());
    }
    Err(Refusal::new(
        set("basis", name)
            + " has no "
            + set("order", order)
            + format!(": its functions are of degree {own} on each cell"),
        words("leave ") + option("order") + " out, and take finer cells: " + set("subdivide", 8),
    ))
}

fn check_bounces(method: &MethodRequest) -> Result<(), Refusal> {
    if method.bounces.is_none() {
        return Ok(());
    }
    let unknown = [
        (method.method == Some(LightMethod::Hierarchical)).then(|| set("method", "hierarchical")),
        method.wanted_accuracy().map(|_| option("accuracy")),
    ];
    refuse(option("bounces"), unknown)
}

/// Refuses shots where light is not shot, or another number of terms is asked for.
fn check_shots(method: &MethodRequest) -> Result<(), Refusal> {
    if method.ambient && method.shots.is_none() {
        return Err(Refusal::new(
            option("ambient") + " does nothing without " + option("shots"),
            words("add ") + set("shots", 10) + ", or leave " + option("ambient") + " out",
        ));
    }
    if method.shots.is_none() {
        return Ok(());
    }
    require_southwell(method, option("shots"))?;
    let unknown = [
        (method.method == Some(LightMethod::Hierarchical)).then(|| set("method", "hierarchical")),
        method.wanted_accuracy().map(|_| option("accuracy")),
        method.bounces.map(|_| option("bounces")),
        other_basis(method),
    ];
    refuse(option("shots"), unknown)
}

/// Refuses a choice of columns where light is not shot, and columns integrated when they are shot where all
/// are at hand before.
fn check_columns(method: &MethodRequest) -> Result<(), Refusal> {
    let Some(columns) = method.columns else { return Ok(()) };
    require_southwell(method, option("columns"))?;
    if columns == ColumnChoice::All {
        return Ok(());
    }
    let unknown = [
        other_method(method),
        (method.transport == Some(Transport::Sampled)).then(|| set("transport", "sampled")),
        method.rays.map(|_| option("rays")),
        method.kernel.unwrap_or_default().rules().map(|_| option("kernel")),
        method.bounces.map(|_| option("bounces")),
        other_basis(method),
    ];
    refuse(set("columns", "shot"), unknown)
}

/// A method other than Galerkin's, if one is asked for.
fn other_method(method: &MethodRequest) -> Option<Wording> {
    match method.method? {
        LightMethod::Galerkin => None,
        LightMethod::Collocation => Some(set("method", "collocation")),
        LightMethod::Hierarchical => Some(set("method", "hierarchical")),
    }
}

/// A basis whose functions reach over elements, if one is asked for.
fn other_basis(method: &MethodRequest) -> Option<Wording> {
    method.basis.filter(|basis| !basis.is_elementwise()).map(|basis| set("basis", basis.name()))
}

fn require_southwell(method: &MethodRequest, what: Wording) -> Result<(), Refusal> {
    if method.solver().is_some_and(|solver| solver.access == Access::Columns) {
        return Ok(());
    }
    let southwell = || set("solver", Method::SOUTHWELL.name);
    Err(Refusal::new(
        what.clone() + " does nothing without " + southwell() + ", which shoots light",
        words("add ") + southwell() + ", or leave " + what + " out",
    ))
}

/// Refuses ways of relaxing for a solver that does not take them.
fn check_relaxing(method: &MethodRequest) -> Result<(), Refusal> {
    let solver = method.solver().map_or("auto", |solver| solver.name);
    let ways: [(bool, &str, &[&str]); 4] = [
        (method.at_once.is_some(), "at-once", &["gauss-seidel", "jacobi", "southwell"]),
        (method.sweep.is_some(), "sweep", &["gauss-seidel"]),
        (method.relaxation.is_some(), "relaxation", &["gauss-seidel", "jacobi", "richardson", "southwell"]),
        (method.restart.is_some(), "restart", &["gmres"]),
    ];
    let idle = ways.into_iter().find(|(is_typed, _, takers)| *is_typed && !takers.contains(&solver));
    match idle {
        Some((_, name, takers)) => Err(Refusal::new(
            option(name) + " does nothing with " + set("solver", solver),
            words("take ") + set("solver", takers[0]) + ", or leave " + option(name) + " out",
        )),
        None => Ok(()),
    }
}

/// Refuses ways of a convergence study that do not go with what is asked of all.
///
/// # Errors
/// The first such option.
pub fn check_series(method: &MethodRequest, series: &[RunSeries]) -> Result<(), Refusal> {
    for series in series {
        let name = set("with", series.name());
        match series {
            RunSeries::Uniform | RunSeries::Shots | RunSeries::ShotsOfAll => {}
            RunSeries::Constant | RunSeries::Linear | RunSeries::Harmonic => refuse(name, others(method))?,
            RunSeries::Hierarchical | RunSeries::Hp | RunSeries::Sampled => refuse(
                name,
                [
                    (method.basis.unwrap_or_default() != Basis::Legendre).then(|| option("basis")),
                    method.bounces.filter(|_| *series != RunSeries::Sampled).map(|_| option("bounces")),
                ],
            )?,
        }
    }
    Ok(())
}

/// The typed ones of options that know polynomials on elements only.
fn others(method: &MethodRequest) -> [Option<Wording>; 8] {
    let has_no_degree = matches!(method.basis, Some(Basis::Constant | Basis::Linear));
    [
        other_method(method),
        method.wanted_accuracy().map(|_| option("accuracy")),
        method.aim.as_ref().map(|_| option("for")),
        method.kernel.unwrap_or_default().rules().map(|_| option("kernel")),
        (method.shadows == Some(LightShadows::Mask)).then(|| set("shadows", "mask")),
        (method.transport == Some(Transport::Sampled)).then(|| set("transport", "sampled")),
        method.rays.as_ref().map(|_| option("rays")),
        (method.tensor && has_no_degree).then(|| option("tensor")),
    ]
}

/// Refuses `what` together with the first of the `others` that is typed.
pub(super) fn refuse(
    what: Wording,
    others: impl IntoIterator<Item = Option<Wording>>,
) -> Result<(), Refusal> {
    match others.into_iter().flatten().next() {
        Some(other) => Err(Refusal::new(what + " does not go with " + other, "leave one of them out")),
        None => Ok(()),
    }
}

/// Why a solution is not kept whose reflections or shots are limited.
pub const KEPT: &str = "a solution is kept for readers, who would gather from it as if it were all light";

/// Refuses to keep light of the first reflections or shots alone, which others would gather from as if it
/// were all; the cure follows from the name of the option.
///
/// # Errors
/// Where reflections or shots are limited.
pub fn require_all_light(
    method: &MethodRequest,
    verb: &str,
    cure: impl FnOnce(&'static str) -> Wording,
) -> Result<(), Refusal> {
    let [bounces, shots] = [method.bounces.map(|own| own.count()), method.shots.map(|own| own.count())];
    let limited = [("bounces", bounces), ("shots", shots)];
    match limited.into_iter().find_map(|(name, count)| Some((name, count?))) {
        None => Ok(()),
        Some((name, count)) => Err(Refusal::new(set(name, count) + format!(": {verb}"), cure(name))),
    }
}
