//! Words for transfers that miss what was asked of them.

use radiosity_kernel::WorstError;
use radiosity_transport::FINEST_BY_RAYS;
use radiosity_work::wording::{Wording, option, words};

/// Words for the error that is left in the transfers between two surfaces, and the cure.
pub fn missed(worst: &WorstError, [one, other]: [&str; 2]) -> Wording {
    let place = match one == other {
        true => format!("of '{one}' to itself"),
        false => format!("between '{one}' and '{other}'"),
    };
    let cure = match worst.by_rays {
        true if worst.asked > FINEST_BY_RAYS => {
            words("a smaller ")
                + option("eps")
                + ", and "
                + option("shadow-eps")
                + " where it is given, sends more rays"
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

/// Words for the part that errors of heat leave out where there is no memory to solve at the next order too.
pub fn no_error_of_order(order: usize) -> Wording {
    let told = format!(
        "the errors are those of the transfers alone: there is no memory for order {} beside order {order}, which tells what even \
         fluxes miss; allow more with ",
        order + 1
    );
    words(told) + option("memory")
}

/// Words for the correction of transfers of a closed scene whose row sums missed 1 by `moved` at the most.
pub fn corrected(moved: f64) -> String {
    format!(
        "row sums of view factors were within {moved:.1e} of 1, and transfers were corrected to make them 1"
    )
}
