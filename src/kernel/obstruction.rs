//! What stands between two elements, as a few rays tell.
//!
//! Most surfaces that reach into the hull of two elements hide nothing of one from the other, or nothing that others do not
//! hide as well. Where none of n rays between points that face each other is hidden by a set of surfaces, these hide less than
//! 3/n of what passes between the elements, at 95 %; where all of them are hidden, less than 3/n passes.

use crate::elements::patch::{Node, Patch};
use crate::visibility::Visibility;

use super::integrand::kernel;
use super::rough::nodes;

/// Points a direction by which the share of pairs is found that face each other; fewer where there are so many pairs of parts.
const LOOKS: [usize; 2] = [3, 4];
const FEWER_LOOKS: [usize; 2] = [1, 2];
const MANY_PARTS: usize = 64;
/// Most points a direction.
const MOST_POINTS: usize = 16;

/// What a few rays between two elements met.
#[derive(Debug)]
pub(super) struct Obstruction {
    /// The surfaces that hid any, ascending.
    pub blockers: Vec<usize>,
    /// Whether all were hidden.
    pub hidden: bool,
    /// Rays between points that face each other.
    pub rays: u64,
}

impl Obstruction {
    /// What about `enough` rays or more between two elements, given by their parts and `surfaces`, meet of `blockers`.
    pub(super) fn between(
        [receivers, emitters]: [&[Patch]; 2],
        surfaces: [usize; 2],
        blockers: &[usize],
        visibility: &Visibility,
        enough: f64,
    ) -> Self {
        let points = points(receivers, emitters, enough);
        let (xs, ys) = (grid(receivers, points), grid(emitters, points + 1));
        let (mut met, mut rest) = (Vec::new(), blockers.to_vec());
        let (mut rays, mut passed) = (0, 0);
        let free = |blockers: &[usize], x: &Node, y: &Node| {
            visibility.free_between(blockers, [x.end(surfaces[0]), y.end(surfaces[1])])
        };
        for (x, y) in
            xs.iter().flat_map(|x| ys.iter().map(move |y| (x, y))).filter(|(x, y)| kernel(x, y) > 0.0)
        {
            rays += 1;
            if !free(&met, x, y) {
                continue;
            }
            match rest.iter().position(|blocker| !free(&[*blocker], x, y)) {
                // The last one that was met is likely to be met again.
                Some(place) => met.insert(0, rest.remove(place)),
                None => passed += 1,
            }
        }
        met.sort_unstable();
        Self { blockers: met, hidden: rays > 0 && passed == 0, rays }
    }
}

/// Points a direction on the receiver, one less than on the emitter, for `enough` pairs that face each other.
fn points(receivers: &[Patch], emitters: &[Patch], enough: f64) -> usize {
    let many = receivers.len() * emitters.len() > MANY_PARTS;
    let [few, more] = if many { FEWER_LOOKS } else { LOOKS };
    let (xs, ys) = (grid(receivers, few), grid(emitters, more));
    let facing = xs.iter().flat_map(|x| ys.iter().map(move |y| kernel(x, y))).filter(|k| *k > 0.0).count();
    let share = facing.max(1) as f64 / (xs.len() * ys.len()) as f64;
    let pairs = enough / (share * (receivers.len() * emitters.len()) as f64);
    // n (n + 1) is nearly (n + ½)².
    ((pairs.sqrt().sqrt() - 0.5).ceil() as usize).clamp(1, MOST_POINTS)
}

fn grid(patches: &[Patch], points: usize) -> Vec<Node> {
    patches.iter().flat_map(|patch| nodes(patch, points)).collect()
}
