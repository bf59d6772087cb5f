//! Probing rays: which of the candidate blockers hide anything of one element from the other.
//!
//! Most surfaces that reach into the hull of two elements hide nothing. n rays join points that face each
//! other, evenly spread over the parameters of both sides. If none is hidden by a set of surfaces, these hide
//! less than 3/n of all such rays at 95 % (the rule of three, which holds for independent rays; these are
//! quasi-random). If all are hidden, less than 3/n pass. The share of rays is taken for the share of the
//! light. If some are hidden, no blocker is dropped, not even one that no ray meets: many such blockers would
//! be missed together, and always to the same side. The rays then end early.

use radiosity_elements::patch::Patch;
use radiosity_visibility::Visibility;
use radiosity_work::interruption::check_interrupt_at;

use crate::moments::integrand::kernel;
use crate::moments::node_pair::node_pair;

/// Pairs of points in all that estimate the share of points that face each other, which only decides how many
/// rays are sent: 128 tell a share of a half to 9 %.
const LOOKS: u64 = 128;
/// Least pairs of points in each pair of parts for that estimate, so that every pair of parts counts.
const FEWEST_LOOKS: u64 = 4;
/// Most points in a pair of parts: a bound of time where hardly any points face each other.
const MOST_POINTS: u64 = 1 << 16;

/// The outcome of probing rays.
#[derive(Debug)]
pub struct ProbingRays {
    /// Whether none, some or all of them were hidden.
    pub hidden: Hidden,
    /// The elements' own surfaces that hid some ray, ascending.
    pub own: Vec<usize>,
    /// Number of rays between points that face each other.
    pub rays: u64,
}

/// Whether none, some or all rays are hidden.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hidden {
    /// No ray is hidden, or there were none.
    None,
    /// Some rays are hidden, and some are not.
    Some,
    /// All rays are hidden, and there was at least one.
    All,
}

impl ProbingRays {
    /// Casts at least about `enough` rays between two elements, given by their parts and `surfaces`, against
    /// `blockers` and their `own` surfaces; fewer once some rays passed, some did not and all `own` surfaces
    /// were met.
    pub fn between(
        [receivers, emitters]: [&[Patch]; 2],
        surfaces: [usize; 2],
        blockers: &[usize],
        own: &[usize],
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
            check_interrupt_at(rays);
            let meets = |surface: &usize| {
                !visibility.free_between(surfaces, std::slice::from_ref(surface), x.position, y.position)
            };
            if let Some(place) = unmet.iter().position(meets) {
                met.push(unmet.remove(place));
            } else if let Some(place) = others.iter().position(meets) {
                // The blocker just met is likely to be met again: it comes first.
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

/// Points in each pair of parts that yield `enough` pairs of points that face each other.
fn points(pairs: &[[&Patch; 2]], enough: f64) -> u64 {
    let looks = (LOOKS / pairs.len() as u64).max(FEWEST_LOOKS);
    let looked = (0..looks).flat_map(|index| pairs.iter().map(move |pair| node_pair(*pair, index)));
    let facing = looked.filter(|[x, y]| kernel(x, y) > 0.0).count();
    let share = facing.max(1) as f64 / (looks * pairs.len() as u64) as f64;
    ((enough / (share * pairs.len() as f64)).ceil() as u64).min(MOST_POINTS)
}
