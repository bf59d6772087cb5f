//! What stands between two elements, as a few rays tell.
//!
//! Most surfaces that reach into the hull of two elements hide nothing of one from the other. Where none of n rays between
//! points that face each other is hidden by a set of surfaces, these together hide less than 3/n of what passes between the
//! elements, at 95 %; where all of them are hidden, less than 3/n passes. Where some are hidden nothing is passed over, however
//! few rays a surface meets: many that hide a little each would be missed together, and always to one side.

use crate::elements::patch::Patch;
use crate::visibility::Visibility;

use crate::transport::moments::integrand::kernel;
use crate::transport::moments::kronecker::node_pair;

/// Pairs of points, about, by which the share is found that face each other, and the fewest in a pair of parts.
const LOOKS: u64 = 128;
const FEWEST_LOOKS: u64 = 4;
/// Most points in a pair of parts.
const MOST_POINTS: u64 = 1 << 16;

/// What a few rays between two elements met.
#[derive(Debug)]
pub(in crate::transport) struct ProbingRays {
    /// How many of them were hidden.
    pub hidden: Hidden,
    /// Those surfaces of the elements themselves that hid any, ascending.
    pub own: Vec<usize>,
    /// Rays between points that face each other.
    pub rays: u64,
}

/// How many of some rays are hidden.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::transport) enum Hidden {
    /// None.
    None,
    /// Some.
    Some,
    /// All, and there are any.
    All,
}

impl ProbingRays {
    /// What about `enough` rays or more between two elements, given by their parts and `surfaces`, meet of `blockers` and of
    /// their `own` surfaces; fewer rays where these tell all.
    pub(in crate::transport) fn between(
        [receivers, emitters]: [&[Patch]; 2],
        surfaces: [usize; 2],
        [blockers, own]: [&[usize]; 2],
        visibility: &Visibility,
        enough: f64,
    ) -> Self {
        let pairs: Vec<[&Patch; 2]> =
            receivers.iter().flat_map(|p| emitters.iter().map(move |q| [p, q])).collect();
        let points = points(&pairs, enough);
        let (mut others, mut unmet, mut met) = (blockers.to_vec(), own.to_vec(), Vec::new());
        let (mut rays, mut passed) = (0, 0);
        let ends = (0..points).flat_map(|index| pairs.iter().map(move |pair| node_pair(*pair, index)));
        for [x, y] in ends.filter(|[x, y]| kernel(x, y) > 0.0) {
            rays += 1;
            let meets = |surface: &usize| {
                !visibility.free_between(surfaces, std::slice::from_ref(surface), x.position, y.position)
            };
            if let Some(place) = unmet.iter().position(meets) {
                met.push(unmet.remove(place));
            } else if let Some(place) = others.iter().position(meets) {
                // What was met is likely to be met again.
                others[..=place].rotate_right(1);
            } else if !met.iter().any(meets) {
                passed += 1;
            }
            if unmet.is_empty() && 0 < passed && passed < rays {
                break;
            }
        }
        met.sort_unstable();
        let hidden = match passed {
            0 if rays > 0 => Hidden::All,
            _ if passed == rays => Hidden::None,
            _ => Hidden::Some,
        };
        Self { hidden, own: met, rays }
    }
}

/// Points in each pair of parts for `enough` pairs of points that face each other.
fn points(pairs: &[[&Patch; 2]], enough: f64) -> u64 {
    let looks = (LOOKS / pairs.len() as u64).max(FEWEST_LOOKS);
    let looked = (0..looks).flat_map(|index| pairs.iter().map(move |pair| node_pair(*pair, index)));
    let facing = looked.filter(|[x, y]| kernel(x, y) > 0.0).count();
    let share = facing.max(1) as f64 / (looks * pairs.len() as u64) as f64;
    ((enough / (share * pairs.len() as f64)).ceil() as u64).min(MOST_POINTS)
}
