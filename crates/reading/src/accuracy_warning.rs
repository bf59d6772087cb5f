//! Words for transfers that miss what was asked of them.

use radiosity_kernel::WorstError;
use radiosity_transport::FINEST_BY_RAYS;
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
