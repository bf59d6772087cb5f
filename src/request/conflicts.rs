//! Options of a method that do not go with each other.

use super::method::MethodRequest;
use super::modes::{Order, Shadows};
use super::refusal::Refusal;
use crate::bases::Basis;
use crate::solve::{Algorithm, Direct, Preconditioning, Transport};
use crate::studies::convergence::Way;

impl MethodRequest {
    /// Refuses options that do not go with each other, or do nothing beside others.
    ///
    /// # Errors
    /// The first such options.
    pub fn check(&self) -> Result<(), Refusal> {
        check_time_limit(self)?;
        check_algorithm(self)?;
        check_rays(self)?;
        check_basis(self)?;
        check_bounces(self)?;
        check_preconditioner(self)
    }
}

/// Refuses a time limit without a wanted accuracy.
fn check_time_limit(method: &MethodRequest) -> Result<(), Refusal> {
    match method.time_limit {
        Some(_) if method.wanted_accuracy().is_none() => Err(Refusal::new(
            "--time-limit does nothing without an accuracy that is wanted",
            "add --accuracy, such as --accuracy 1e-2, or leave --time-limit out",
        )),
        _ => Ok(()),
    }
}

/// Refuses options that hierarchical radiosity does not know.
fn check_algorithm(method: &MethodRequest) -> Result<(), Refusal> {
    let is_higher = matches!(method.order, Some(Order::Degree(1..)));
    let unknown = [
        (is_higher, "--order above 0"),
        (method.tensor, "--tensor"),
        (method.subdivide.is_some(), "--subdivide"),
        (method.layers.count > 0, "--layers"),
        (method.kernel.rules().is_some(), "--kernel"),
        (method.transport != Transport::Auto, "--transport"),
        (method.rays.is_some(), "--rays"),
        (method.shadows != Shadows::Auto, "--shadows"),
        (method.shadow_eps.is_some(), "--shadow-eps"),
        (method.direct != Direct::Auto, "--direct"),
    ];
    match unknown.into_iter().find(|(is_typed, _)| *is_typed) {
        Some((_, name)) if method.algorithm == Algorithm::Hierarchical => Err(Refusal::new(
            format!("--method hierarchical knows no {name}: it links constants"),
            format!("leave {name} out, or leave --method out"),
        )),
        _ => Ok(()),
    }
}

/// Refuses rays together with the methods of 1993, which know none.
fn check_rays(method: &MethodRequest) -> Result<(), Refusal> {
    let rays = match (method.transport, method.rays) {
        (Transport::Sampled, _) => "--transport sampled",
        (_, Some(_)) => "--rays",
        _ => return Ok(()),
    };
    let others = [
        (method.kernel.rules().is_some(), "--kernel"),
        (method.shadows == Shadows::Mask, "--shadows mask"),
        (method.shadows == Shadows::Off, "--shadows off"),
        (method.transport == Transport::Exact, "--transport exact"),
    ];
    refuse(rays, &others)
}

/// Refuses a preconditioner for a solver that takes none.
fn check_preconditioner(method: &MethodRequest) -> Result<(), Refusal> {
    let iterates = ["auto", "cg", "gmres"].contains(&method.solver.name);
    if method.preconditioner == Preconditioning::None && !iterates {
        return Err(Refusal::new(
            format!("--preconditioner does nothing with --solver {}", method.solver.name),
            "take --solver cg or gmres, or leave --preconditioner out",
        ));
    }
    Ok(())
}

fn check_basis(method: &MethodRequest) -> Result<(), Refusal> {
    let basis = method.basis;
    let name = basis.name();
    if basis == Basis::Legendre {
        return Ok(());
    }
    refuse(&format!("--basis {name}"), &others(method))?;
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
        format!("--basis {name} has no --order {order}: its functions are of degree {own} on each cell"),
        "leave --order out, and take finer cells: --subdivide 8",
    ))
}

fn check_bounces(method: &MethodRequest) -> Result<(), Refusal> {
    if method.bounces.is_none() {
        return Ok(());
    }
    let unknown = [
        (method.algorithm == Algorithm::Hierarchical, "--method hierarchical"),
        (method.wanted_accuracy().is_some(), "--accuracy"),
    ];
    refuse("--bounces", &unknown)
}

/// Refuses ways of a convergence study that do not go with what is asked of all.
///
/// # Errors
/// The first such option.
pub fn check_ways(method: &MethodRequest, ways: &[Way]) -> Result<(), Refusal> {
    for way in ways {
        let name = format!("--with {}", way.name());
        match way {
            Way::Uniform => {}
            Way::Constant | Way::Linear | Way::Harmonic => refuse(&name, &others(method))?,
            Way::Hierarchical | Way::Hp | Way::Sampled => refuse(
                &name,
                &[
                    (method.basis != Basis::Legendre, "--basis"),
                    (method.bounces.is_some() && *way != Way::Sampled, "--bounces"),
                ],
            )?,
        }
    }
    Ok(())
}

/// Options that know polynomials on elements only, and whether they are typed.
fn others(method: &MethodRequest) -> [(bool, &'static str); 8] {
    let has_no_degree = matches!(method.basis, Basis::Constant | Basis::Linear);
    [
        (method.algorithm == Algorithm::Hierarchical, "--method hierarchical"),
        (method.wanted_accuracy().is_some(), "--accuracy"),
        (method.aim.is_some(), "--for"),
        (method.kernel.rules().is_some(), "--kernel"),
        (method.shadows == Shadows::Mask, "--shadows mask"),
        (method.transport == Transport::Sampled, "--transport sampled"),
        (method.rays.is_some(), "--rays"),
        (method.tensor && has_no_degree, "--tensor"),
    ]
}

fn refuse(what: &str, others: &[(bool, &str)]) -> Result<(), Refusal> {
    match others.iter().find(|(is_typed, _)| *is_typed) {
        Some((_, other)) => {
            Err(Refusal::new(format!("{what} does not go with {other}"), "leave one of them out"))
        }
        None => Ok(()),
    }
}

/// Refuses to keep light of the first reflections alone, which others would gather from as if it were all.
///
/// # Errors
/// Where reflections are limited.
pub fn require_all_bounces(method: &MethodRequest, verb: &str, cure: &str) -> Result<(), Refusal> {
    match method.bounces {
        None => Ok(()),
        Some(bounces) => Err(Refusal::new(format!("--bounces {bounces}: {verb}"), cure)),
    }
}
