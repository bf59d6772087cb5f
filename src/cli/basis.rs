//! What goes with a basis other than polynomials on elements, and with light of the first reflections alone.

use radiosity::Basis;
use radiosity::solve::{Algorithm, Preconditioning, Transport};
use radiosity::studies::convergence::Way;

use crate::cli::{
    error::CliError,
    modes::{Order, Shadows},
    options::MethodArgs,
};

/// Refuses options of the method that do not go with each other.
pub(crate) fn check(method: &MethodArgs) -> Result<(), CliError> {
    method.check()?;
    check_basis(method)?;
    check_bounces(method)?;
    let iterates = ["auto", "cg", "gmres"].contains(&method.solver.name);
    if method.preconditioner == Preconditioning::None && !iterates {
        return Err(CliError::Refused {
            message: format!("--preconditioner does nothing with --solver {}", method.solver.name),
            cure: "take --solver cg or gmres, or leave --preconditioner out".to_owned(),
        });
    }
    Ok(())
}

fn check_basis(method: &MethodArgs) -> Result<(), CliError> {
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
    Err(CliError::Refused {
        message: format!(
            "--basis {name} has no --order {order}: its functions are of degree {own} on each cell"
        ),
        cure: "leave --order out, and take finer cells: --subdivide 8".to_owned(),
    })
}

fn check_bounces(method: &MethodArgs) -> Result<(), CliError> {
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
pub(crate) fn check_ways(method: &MethodArgs, ways: &[Way]) -> Result<(), CliError> {
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
fn others(method: &MethodArgs) -> [(bool, &'static str); 8] {
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

fn refuse(what: &str, others: &[(bool, &str)]) -> Result<(), CliError> {
    match others.iter().find(|(is_typed, _)| *is_typed) {
        Some((_, other)) => Err(CliError::Refused {
            message: format!("{what} does not go with {other}"),
            cure: "leave one of them out".to_owned(),
        }),
        None => Ok(()),
    }
}

/// Refuses to keep light of the first reflections alone, which others would gather from as if it were all.
pub(crate) fn require_all_bounces(method: &MethodArgs, verb: &str, cure: &str) -> Result<(), CliError> {
    match method.bounces {
        None => Ok(()),
        Some(bounces) => {
            Err(CliError::Refused { message: format!("--bounces {bounces}: {verb}"), cure: cure.to_owned() })
        }
    }
}
