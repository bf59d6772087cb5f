//! Words for transfers that miss what was asked of them.

use radiosity_kernel::WorstError;
use radiosity_solve::view_factors::{MissedRows, ViewFactors};
use radiosity_transport::FINEST_BY_RAYS;
use radiosity_work::digits::significant;
use radiosity_work::wording::{Wording, option, set, words};

/// Accuracy that rays reach with fewer of them, over the error that they leave. Chosen: as that error is known.
const REACHED: f64 = 2.0;

/// Bound of accuracies that may be asked for: with one digit they are below 1.
const LARGEST: f64 = 0.95;

/// Words for the error that is left in the transfers between two surfaces, and the cure.
pub fn missed(worst: &WorstError, [one, other]: [&str; 2]) -> Wording {
    let place = match one == other {
        true => format!("of '{one}' to itself"),
        false => format!("between '{one}' and '{other}'"),
    };
    let cure = match worst.by_rays {
        true if worst.asked > FINEST_BY_RAYS => {
            let reached = REACHED * worst.error;
            let more = words("a smaller ") + option("eps") + " sends more rays";
            match reached < LARGEST {
                true => {
                    let enough = set("shadow-eps", format!("{reached:.0e}"));
                    more + ", and " + enough + " asks for no more than these reach"
                }
                // No accuracy is as bad.
                false => more,
            }
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

/// Words for rows of view factors in which rays leave a larger error than `eps` of the largest factor; none where they
/// leave none.
pub fn missed_by_rays(factors: &ViewFactors, eps: f64) -> Option<Wording> {
    let MissedRows { count, surface, error } = factors.missed_by_rays(eps)?;
    let [found, asked] = [error, eps].map(|part| significant(100.0 * part, 2));
    let told = format!(
        "rays leave errors of up to {found} % of the largest factor of a row, that of '{}', where {asked} % was asked for, \
         which {count} of {} rows miss: ",
        factors.names[surface],
        factors.names.len()
    );
    let exact = words(", or take ") + set("transport", "exact");
    Some(match factors.has_rays_of_pairs {
        true => words(told + "a smaller ") + option("eps") + " sends more" + exact + ", which takes its time",
        false => {
            let rays = words(told + "send more with ") + option("rays");
            rays + exact + " without " + option("rays") + ", which takes its time"
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Accuracies of 1 and above are refused, and none is advised.
    #[test]
    fn no_accuracy_is_advised_that_is_refused() {
        for (error, is_advised) in [(0.3, true), (0.47, true), (0.49, false), (1.0, false)] {
            let worst = WorstError { pair: [0, 1], error, asked: 1e-3, by_rays: true };
            let told = missed(&worst, ["floor", "ball"]).to_string();
            assert!(told.contains("a smaller --eps sends more rays"), "{told}");
            assert_eq!(told.contains("--shadow-eps"), is_advised, "{told}");
            assert!(!told.contains("--shadow-eps 1e0"), "{told}");
        }
    }
}
