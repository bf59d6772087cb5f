//! Words for transfers that miss what was asked of them.

use crate::transport::{FINEST_BY_RAYS, Miss};
use crate::wording::{Wording, option, words};

/// What is missed between two surfaces, and the cure.
pub fn missed(miss: &Miss, [one, other]: [&str; 2]) -> Wording {
    let place = match one == other {
        true => format!("of '{one}' to itself"),
        false => format!("between '{one}' and '{other}'"),
    };
    let cure = match miss.by_rays {
        true if miss.asked > FINEST_BY_RAYS => {
            words("a smaller ")
                + option("eps")
                + ", and "
                + option("shadow-eps")
                + " where it is given, sends more rays"
        }
        true => words("rays cannot do better, an ") + option("eps") + " below 1e-5 sends no more of them",
        false => words("subdivide these surfaces, or ask for less"),
    };
    let relative = match miss.by_rays {
        true => "the largest of their row",
        false => "their size",
    };
    let told = format!(
        "the transfers {place}, perhaps more, are good to about {:.0e} of {relative} only: ",
        miss.error
    );
    words(told) + cure
}
