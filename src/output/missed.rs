//! Words for transfers that miss what was asked of them.

use crate::transport::{FINEST_BY_RAYS, Miss};

/// What is missed between two surfaces, and the cure.
pub fn missed(miss: &Miss, [one, other]: [&str; 2]) -> String {
    let place = match one == other {
        true => format!("of '{one}' to itself"),
        false => format!("between '{one}' and '{other}'"),
    };
    let cure = match miss.by_rays {
        true if miss.asked > FINEST_BY_RAYS => {
            "a smaller --eps, and --shadow-eps where it is given, sends more rays"
        }
        true => "rays cannot do better, an --eps below 1e-5 sends no more of them",
        false => "subdivide these surfaces, or ask for less",
    };
    let relative = match miss.by_rays {
        true => "the largest of their row",
        false => "their size",
    };
    format!(
        "the transfers {place}, perhaps more, are good to about {:.0e} of {relative} only: {cure}",
        miss.error
    )
}
