//! Sectors: the patches of an element, halved until their lines and normals turn by no more than about a
//! quarter circle.

use std::collections::VecDeque;

use radiosity_elements::Element;
use radiosity_elements::patch::{Direction, Node, Patch};
use radiosity_geom::DVec3;
use radiosity_work::interruption::check_interrupt;

/// Largest turn of the lines and normals of a sector, radians. A quarter circle is 1.571: the rest of 0.03 is
/// a margin, so that exact quarters, whose turn is estimated from chords, are not cut.
pub(crate) const LARGEST_TURN: f64 = 1.6;
/// Most sectors of an element, after which larger turns remain: a crease turns by the same angle however
/// short the line across it. A bound of time, far above the eight sectors of a ball.
const MOST_SECTORS: usize = 256;

/// The patches of an element, each halved until it turns by `LARGEST_TURN` at most, or `MOST_SECTORS` are
/// reached.
pub fn sectors(element: &Element) -> Vec<Patch> {
    check_interrupt();
    let mut open: VecDeque<Patch> = element.patches.iter().cloned().collect();
    let mut done = Vec::new();
    while let Some(patch) = open.pop_front() {
        let turns = if patch.is_flat() { [0.0; 2] } else { turns(&patch) };
        if turns[0].max(turns[1]) <= LARGEST_TURN || open.len() + done.len() >= MOST_SECTORS {
            done.push(patch);
        } else {
            let direction = if turns[0] >= turns[1] { Direction::Along } else { Direction::Across };
            open.extend(patch.halves(direction));
        }
    }
    done
}

/// Largest turns of lines and normals along s and along t, in radians, from 8 chords of three lines; 0 along
/// a side that is one point.
fn turns(patch: &Patch) -> [f64; 2] {
    const STEPS: usize = 8;
    let place = |k: usize| k as f64 / STEPS as f64;
    let turn = |node: &dyn Fn(f64) -> Node| {
        let line: Vec<Node> = (0..=STEPS).map(|k| node(place(k))).collect();
        let normals = line.windows(2).map(|w| w[0].normal.angle_between(w[1].normal)).sum::<f64>();
        let steps: Vec<DVec3> = line.windows(2).map(|w| w[1].position - w[0].position).collect();
        let total: f64 = steps.iter().map(|d| d.length()).sum();
        if total <= 1e-9 * patch.hull()[0].distance(patch.node(0.5, 0.5).position) {
            return 0.0;
        }
        let bends = steps.windows(2).map(|w| w[0].angle_between(w[1])).sum::<f64>();
        normals.max(bends * STEPS as f64 / (STEPS - 1) as f64)
    };
    let most = |turn: &dyn Fn(f64) -> f64| [0.0, 0.5, 1.0].map(turn).into_iter().fold(0.0, f64::max);
    [most(&|t| turn(&|s| patch.node(s, t))), most(&|s| turn(&|t| patch.node(s, t)))]
}
