//! Words for transfers that miss what was asked of them.

use radiosity_audit::{Checked, HeatFault};
use radiosity_kernel::WorstError;
use radiosity_transport::FINEST_BY_RAYS;
use radiosity_work::digits::significant;
use radiosity_work::wording::{Wording, option, set, words};

/// Accuracy that rays reach with fewer of them, over the error that they leave. Chosen: as that error is known.
const REACHED: f64 = 2.0;

/// Words for the error that is left in the transfers between two surfaces, and the cure.
pub fn missed(worst: &WorstError, [one, other]: [&str; 2]) -> Wording {
    let place = match one == other {
        true => format!("of '{one}' to itself"),
        false => format!("between '{one}' and '{other}'"),
    };
    let cure = match worst.by_rays {
        true if worst.asked > FINEST_BY_RAYS => {
            let reached = format!("{:.0e}", REACHED * worst.error);
            words("a smaller ")
                + option("eps")
                + " sends more rays, and "
                + set("shadow-eps", reached)
                + " asks for no more than these reach"
        }
        true => words("rays cannot do better, an ") + option("eps") + " below 1e-5 sends no more of them",
        false => words("subdivide these surfaces, or ask for less"),
    };
    let relative = match worst.by_rays {
        true => "the largest of their row",
        false => "their size",
    };
    let told = format!(
        "the transfers {place}, perhaps more, are good to about {:.0e} of {relative} only: ",
        worst.error
    );
    words(told) + cure
}

/// Words for the part that errors of heat leave out where elements were not cut once more.
pub fn no_error_of_cut() -> Wording {
    words(
        "the errors are those of the transfers alone: there is no memory or no time to cut elements once more, which tells what \
         even fluxes miss; allow more with ",
    ) + option("memory")
        + ", or take a lower "
        + option("order")
}

/// Words for heat that a referee finds to be off by more than its errors tell.
pub fn heat_underestimated(checked: &Checked) -> Option<Wording> {
    let own = significant(100.0 * checked.own_error, 2);
    let told = |finding: &str| {
        words(format!(
            "the balance by itself tells an error of {own} %, and path tracing finds more: {finding}; take a higher "
        )) + option("order")
            + ", or more elements by "
            + option("subdivide")
    };
    checked.finding().map(told)
}

/// Words for heat that a referee cannot read.
pub fn heat_unchecked(fault: &HeatFault) -> String {
    format!("not checked by path tracing: {fault}")
}

/// Words for the correction of transfers of a closed scene whose row sums missed 1 by `moved` at the most.
pub fn corrected(moved: f64) -> String {
    format!(
        "row sums of view factors were within {moved:.1e} of 1, and transfers were corrected to make them 1"
    )
}
