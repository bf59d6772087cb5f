//! A segment of a path: light at some of its frames, and between them.

use std::sync::Arc;

use radiosity_elements::{Element, Elements};

use crate::solution::group_light::GroupLight;
use crate::system::vector::relative_distance;

use super::chebyshev;

/// The light of a frame that was solved.
#[derive(Debug)]
pub(super) struct Node {
    pub(super) frame: usize,
    pub(super) light: Vec<GroupLight>,
    pub(super) elements: Arc<Elements>,
    /// Relative error that rays left, where they carried the pairs.
    pub(super) noise: f64,
    /// Relative error of what is left unsolved.
    pub(super) unsolved: f64,
}

/// A part of the path.
#[derive(Debug)]
pub(super) enum Segment {
    /// Solved frame by frame, from the first to the last.
    Single([usize; 2]),
    /// Interpolated where frames are not solved.
    Smooth(Interpolant),
}

/// Light interpolated through frames that were solved.
#[derive(Debug)]
pub(super) struct Interpolant {
    nodes: Vec<Arc<Node>>,
    /// Frames between that were solved as well.
    between: Vec<Arc<Node>>,
    /// Estimated relative error of the frames that are interpolated.
    pub(super) error: f64,
}

impl Segment {
    /// Whether a frame is in it.
    pub(super) fn holds(&self, frame: usize) -> bool {
        let [first, last] = match self {
            Self::Single(ends) => *ends,
            Self::Smooth(interpolant) => interpolant.ends(),
        };
        (first..=last).contains(&frame)
    }
}

impl Interpolant {
    /// The interpolant through these nodes, five or more, at frames near nested points
    /// ([`chebyshev::frames`]); its error as far as the nodes show it is `sure` times what they say.
    ///
    /// ```text
    /// d_m = max_k ‖h(t_k) − h_m(t_k)‖ / ‖h(t_k)‖ ,    r = d_m / d_{m/2} ,    error = sure · d_m r
    /// ```
    ///
    /// t_k are the nodes that 2 m intervals have and m do not. Second, the ratio r, at most 1.
    pub(super) fn through(nodes: Vec<Arc<Node>>, sure: f64) -> (Self, f64) {
        let intervals = nodes.len() - 1;
        let [missed, coarser] = [2, 4].map(|part| missed(&nodes, intervals / part));
        let falls = if coarser > 0.0 { (missed / coarser).min(1.0) } else { 1.0 };
        (Self { nodes, between: Vec::new(), error: sure * missed * falls }, falls)
    }

    /// First and last frame.
    pub(super) fn ends(&self) -> [usize; 2] {
        [self.nodes[0].frame, self.nodes[self.nodes.len() - 1].frame]
    }

    /// Adds a frame that was solved between the nodes; the error is at least `sure` times what is missed
    /// there, which is returned.
    pub(super) fn check(&mut self, node: &Arc<Node>, sure: f64) -> f64 {
        if self.solved(node.frame).is_some() {
            return 0.0;
        }
        let missed = match carry_alike(&node.elements, self.elements()) {
            true => sure * apart(&self.light(node.frame), &node.light),
            false => f64::INFINITY,
        };
        self.error = self.error.max(missed);
        self.between.push(Arc::clone(node));
        missed
    }

    /// The frame that is farthest from all nodes.
    pub(super) fn farthest(&self) -> usize {
        let [first, last] = self.ends();
        let gap = |frame: &usize| self.nodes.iter().map(|node| node.frame.abs_diff(*frame)).min();
        (first..=last).max_by_key(gap).unwrap_or(first)
    }

    /// A frame that was solved, a node or one between.
    pub(super) fn solved(&self, frame: usize) -> Option<&Arc<Node>> {
        self.nodes.iter().chain(&self.between).find(|node| node.frame == frame)
    }

    /// Error of the frames that are interpolated, with what the nodes leave unsolved.
    pub(super) fn error_told(&self) -> f64 {
        self.error + self.nodes.iter().map(|node| node.unsolved).fold(0.0, f64::max)
    }

    /// Largest error that rays left at any node.
    pub(super) fn noise(&self) -> f64 {
        self.nodes.iter().map(|node| node.noise).fold(0.0, f64::max)
    }

    /// The elements of a node.
    pub(super) fn elements(&self) -> &Elements {
        &self.nodes[0].elements
    }

    /// The interpolated light of each group in a frame.
    pub(super) fn light(&self, frame: usize) -> Vec<GroupLight> {
        interpolated(&self.nodes, frame)
    }
}

/// How far the light of every other node is from the interpolant through those beside.
pub(super) fn missed(nodes: &[Arc<Node>], intervals: usize) -> f64 {
    let step = (nodes.len() - 1) / (2 * intervals);
    let known: Vec<Arc<Node>> = nodes.iter().step_by(2 * step).cloned().collect();
    let between = nodes.iter().skip(step).step_by(2 * step);
    between.map(|node| apart(&interpolated(&known, node.frame), &node.light)).fold(0.0, f64::max)
}

/// Whether the same functions carry the light of all nodes.
pub(super) fn are_alike(nodes: &[Arc<Node>]) -> bool {
    nodes[1..].iter().all(|node| carry_alike(&nodes[0].elements, &node.elements))
}

/// Whether the same functions carry light on both, and what others cover is the same on both to the bit: how
/// it is cut follows from what covers it.
pub(super) fn carry_alike(first: &Elements, other: &Elements) -> bool {
    let mut pairs = first.list().iter().zip(other.list());
    let is_kept = |(a, b): (&Element, &Element)| {
        a.is_of_part(b) && (a.is_cell() || (a.patches == b.patches && a.basis == b.basis))
    };
    first.starts() == other.starts() && pairs.all(is_kept)
}

/// The light of each group in a frame, interpolated through the `nodes`.
fn interpolated(nodes: &[Arc<Node>], frame: usize) -> Vec<GroupLight> {
    let frames: Vec<usize> = nodes.iter().map(|node| node.frame).collect();
    let factors = chebyshev::factors(&frames, frame as f64);
    let groups = 0..nodes.first().map_or(0, |node| node.light.len());
    groups.map(|group| GroupLight::together(&factors, nodes.iter().map(|node| &node.light[group]))).collect()
}

/// The largest relative difference of any group in any band.
fn apart(light: &[GroupLight], right: &[GroupLight]) -> f64 {
    let bands = light.iter().zip(right).flat_map(|(own, other)| own.bands.iter().zip(&other.bands));
    let relative = bands.map(|(own, other)| relative_distance(&own.irradiance, &other.irradiance));
    relative.fold(0.0, f64::max)
}
