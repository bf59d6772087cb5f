//! Reflected light at the nodes of some frames that follow each other: gathered in some, interpolated in others.
//!
//! A node of a surface, which moves with it, is known in five frames of a span where these predict each other,
//!
//! ```text
//! |f(t_k) − p_2(t_k)| ≤ τ √(E max(E, Ē)) + s ,     k = 1, 3 ,     p_2 through f(t_0), f(t_2), f(t_4) ,
//! ```
//!
//! with s the deviation of gathered light, and in the others a polynomial of degree 4 gives it (`span`). Elsewhere the
//! span is halved, until all of its frames are gathered: beside what moves (`movement`), where the polynomials of
//! the solution, which are known in all frames, tell that light does something between the five, where the node is
//! covered in one of them, and where some of the frames are at rest and others not. So frames at rest are alike to the
//! bit.

use std::collections::HashMap;

use radiosity_geom::DVec3;
use radiosity_work::Work;
use rayon::prelude::*;

use super::film_error::FilmError;
use super::movement::Movement;
use super::span::{EVEN, ODD, POINTS, Span, interpolated, weights};
use crate::pictures::eye::SeenPlace;
use crate::pictures::light_field::NodeSource;
use crate::pictures::light_field::node_gatherer::{Node, NodeGatherer, NodeIndex};
use crate::pictures::picture_light::ComputedLight;

/// Most difference τ of light from its prediction. Chosen: as fits between nodes may leave.
const SMOOTH: f64 = 7e-3;

/// Most difference of the solution's polynomials from those in time, in the same unit. Chosen: their own errors
/// change from frame to frame.
const BUMP: f64 = 3e-2;

/// Nodes of one that is gathered although it is interpolated, to tell the error. Chosen.
const TOLD_EACH: usize = 32;

/// Most difference of the parameters of a node that stays in its place on a surface: roundings.
const STAYS: f64 = 1e-6;

/// Nodes of frames that follow each other.
pub(super) struct Stretch<'a> {
    gatherers: Vec<NodeGatherer<'a>>,
    /// Nodes that were gathered, of each frame; None where they have no place.
    known: Vec<HashMap<NodeIndex, Option<Node>>>,
    movement: Movement,
    /// Whether the light of a node may be interpolated over a span, as far as that was asked.
    smooth: HashMap<NodeSpan, bool>,
    error: FilmError,
}

/// A node in some frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct NodeSpan {
    node: NodeIndex,
    span: Span,
}

/// A node in one frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct NodeMoment {
    frame: usize,
    node: NodeIndex,
}

/// What the light of a node in a frame follows from.
#[derive(Clone, Copy, Debug)]
enum Origin {
    /// It is gathered.
    Gathered,
    /// It is interpolated over a span, if it is smooth there: that is known, or not yet.
    Interpolated(Span),
    Open(Span),
}

impl<'a> Stretch<'a> {
    /// The nodes of the frames of these gatherers, of which those of the first are known so far.
    pub(super) fn new(
        gatherers: Vec<NodeGatherer<'a>>,
        movement: Movement,
        first: HashMap<NodeIndex, Option<Node>>,
    ) -> Self {
        let mut known = vec![HashMap::new(); gatherers.len()];
        known[0] = first;
        Self { gatherers, known, movement, smooth: HashMap::new(), error: FilmError::default() }
    }

    /// The error of what was interpolated, and the nodes that were gathered in the last frame.
    pub(super) fn end(mut self) -> (FilmError, HashMap<NodeIndex, Option<Node>>) {
        (self.error, self.known.pop().unwrap_or_default())
    }

    /// The nodes of these indices in a frame.
    fn nodes(&mut self, frame: usize, wanted: &[NodeIndex], work: &Work<'_>) -> Vec<Option<Node>> {
        for gatherer in &mut self.gatherers {
            gatherer.prepare(wanted.iter().map(|node| node.surface));
        }
        let origins = self.origins(frame, wanted, work);
        let is_gathered = |origin: &Origin| matches!(origin, Origin::Gathered);
        let alone = wanted.iter().zip(&origins).filter(|(_, origin)| is_gathered(origin));
        self.gather(alone.map(|(node, _)| NodeMoment { frame, node: *node }).collect(), work);
        let found: Vec<Option<Node>> = wanted
            .par_iter()
            .zip(&origins)
            .map(|(node, origin)| match origin {
                Origin::Interpolated(span) => self.interpolated(*node, *span, frame),
                Origin::Gathered | Origin::Open(_) => self.known[frame].get(node)?.clone(),
            })
            .collect();
        let own = || (0..wanted.len()).filter(|index| !is_gathered(&origins[*index]));
        self.error.count(0, own().count());
        let told: Vec<usize> = own().skip(frame % TOLD_EACH).step_by(TOLD_EACH).collect();
        self.tell(
            frame,
            &told.iter().map(|index| (wanted[*index], found[*index].as_ref())).collect::<Vec<_>>(),
            work,
        );
        found
    }

    /// What the light of these nodes in a frame follows from.
    fn origins(&mut self, frame: usize, wanted: &[NodeIndex], work: &Work<'_>) -> Vec<Origin> {
        let whole = Span { first: 0, last: self.gatherers.len() - 1 };
        let mut origins = vec![Origin::Open(whole); wanted.len()];
        loop {
            let next: Vec<(Origin, Vec<NodeSpan>)> = wanted
                .par_iter()
                .zip(&origins)
                .map(|(node, origin)| match origin {
                    Origin::Open(span) => self.origin(*node, *span, frame),
                    known => (*known, Vec::new()),
                })
                .collect();
            for (own, (origin, rough)) in origins.iter_mut().zip(next) {
                *own = origin;
                self.smooth.extend(rough.into_iter().map(|span| (span, false)));
            }
            let open: Vec<NodeSpan> = wanted
                .iter()
                .zip(&origins)
                .filter_map(|(node, origin)| match origin {
                    Origin::Open(span) => Some(NodeSpan { node: *node, span: *span }),
                    _ => None,
                })
                .collect();
            if open.is_empty() {
                return origins;
            }
            self.try_smooth(&open, work);
        }
    }

    /// What the light of a node in a frame follows from, as far as that is known without gathering more; and spans
    /// over which it is not smooth.
    fn origin(&self, node: NodeIndex, mut span: Span, frame: usize) -> (Origin, Vec<NodeSpan>) {
        let mut rough = Vec::new();
        loop {
            let Some(points) = span.points().filter(|points| !points.contains(&frame)) else {
                return (Origin::Gathered, rough);
            };
            match self.smooth.get(&NodeSpan { node, span }) {
                Some(true) => return (Origin::Interpolated(span), rough),
                None if self.may_be_smooth(node, span, points) => return (Origin::Open(span), rough),
                None => rough.push(NodeSpan { node, span }),
                Some(false) => {}
            }
            span = span.half(frame);
        }
    }

    /// Whether nothing that is known without gathering light speaks against interpolating that of a node.
    fn may_be_smooth(&self, node: NodeIndex, span: Span, points: [usize; POINTS]) -> bool {
        let place = |frame: usize| self.gatherers[frame].place(node);
        let places: Option<Vec<SeenPlace>> = span.frames().map(place).collect();
        let Some(places) = places.filter(|_| self.movement.is_even(span)) else { return false };
        let stays = |one: &SeenPlace| {
            let pairs = one.place.parameters.iter().zip(places[0].place.parameters);
            pairs.into_iter().all(|(one, other)| (one - other).abs() <= STAYS)
        };
        let at: [DVec3; POINTS] = points.map(|frame| places[frame - span.first].place.position);
        places.iter().all(stays)
            && self.movement.passes(node.surface, at, span, points)
            && self.has_no_bump(&places, span, points)
    }

    /// Whether the polynomials of the solution at a place, in all frames of a span, are about met by those in five.
    fn has_no_bump(&self, places: &[SeenPlace], span: Span, points: [usize; POINTS]) -> bool {
        let light = |frame: usize| self.gatherers[frame].light();
        let own = |frame: usize| light(frame).polynomials(&places[frame - span.first]).iter().sum::<f64>();
        let values: Vec<f64> = span.frames().map(own).collect();
        let known = points.map(|frame| values[frame - span.first]);
        span.frames().zip(&values).all(|(frame, value)| {
            let off = interpolated(weights(points, frame), known) - value;
            off.abs() <= BUMP * light(frame).judged_by(*value)
        })
    }

    /// Gathers the light of nodes in five frames of spans, and finds out whether it is smooth.
    fn try_smooth(&mut self, open: &[NodeSpan], work: &Work<'_>) {
        let moments = |own: &NodeSpan| {
            let node = own.node;
            own.span.points().into_iter().flatten().map(move |frame| NodeMoment { frame, node })
        };
        self.gather(open.iter().flat_map(moments).collect(), work);
        let smooth: Vec<bool> = open.par_iter().map(|own| self.is_smooth(*own).unwrap_or(false)).collect();
        self.smooth.extend(open.iter().copied().zip(smooth));
    }

    /// Whether the light of a node in five frames of a span, which is known, is smooth; None where it has no place.
    fn is_smooth(&self, NodeSpan { node, span }: NodeSpan) -> Option<bool> {
        let points = span.points()?;
        let nodes = self.known_in(node, points)?;
        let all = |node: &Node| node.light.bands.iter().sum::<f64>();
        let even = EVEN.map(|k| points[k]);
        Some(ODD.into_iter().all(|k| {
            let predicted = interpolated(weights(even, points[k]), EVEN.map(|k| all(nodes[k])));
            let Node { light, lit, .. } = nodes[k];
            let judged = self.gatherers[points[k]].light().judged_by(all(nodes[k]) + lit);
            (predicted - all(nodes[k])).abs() <= SMOOTH * judged + light.error
        }))
    }

    /// A node that is known in some frames.
    fn known_in<const N: usize>(&self, node: NodeIndex, frames: [usize; N]) -> Option<[&Node; N]> {
        let known = frames.iter().map(|frame| self.known[*frame].get(&node)?.as_ref());
        known.collect::<Option<Vec<&Node>>>()?.try_into().ok()
    }

    /// A node in a frame, by those in five.
    fn interpolated(&self, node: NodeIndex, span: Span, frame: usize) -> Option<Node> {
        let points = span.points()?;
        let nodes = self.known_in(node, points)?;
        let seen = self.gatherers[frame].place(node)?;
        let weights = weights(points, frame);
        let of = |value: &dyn Fn(&Node) -> f64| interpolated(weights, nodes.map(value));
        let band = |band: usize| of(&|node| node.light.bands[band]).max(0.0);
        let bands = (0..nodes[0].light.bands.len()).map(band).collect();
        let error = nodes.iter().map(|node| node.light.error).fold(0.0, f64::max);
        Some(Node { seen, light: ComputedLight { bands, error }, lit: of(&|node| node.lit) })
    }

    /// Gathers nodes that are not known yet.
    fn gather(&mut self, mut moments: Vec<NodeMoment>, work: &Work<'_>) {
        moments.retain(|moment| !self.known[moment.frame].contains_key(&moment.node));
        moments.sort_unstable();
        moments.dedup();
        for own in moments.chunk_by(|one, other| one.frame == other.frame) {
            let frame = own[0].frame;
            let nodes: Vec<NodeIndex> = own.iter().map(|moment| moment.node).collect();
            let gathered = self.gatherers[frame].nodes(&nodes, work);
            self.known[frame].extend(nodes.into_iter().zip(gathered));
        }
        self.error.count(moments.len(), 0);
    }

    /// Gathers some nodes of a frame that are interpolated, to tell the error of these.
    fn tell(&mut self, frame: usize, found: &[(NodeIndex, Option<&Node>)], work: &Work<'_>) {
        let nodes: Vec<NodeIndex> = found.iter().map(|(node, _)| *node).collect();
        let gathered = self.gatherers[frame].nodes(&nodes, work);
        for ((_, own), gathered) in found.iter().zip(gathered) {
            let (Some(own), Some(right)) = (own, gathered) else { continue };
            let sum = |node: &Node| node.light.bands.iter().sum::<f64>();
            self.error.take(sum(own) - sum(&right), sum(&right) + right.lit);
        }
    }
}

/// One frame of a stretch.
pub(super) struct StretchFrame<'a, 'b> {
    /// The stretch.
    pub stretch: &'a mut Stretch<'b>,
    /// The frame, counted from the first of the stretch.
    pub frame: usize,
}

impl NodeSource for StretchFrame<'_, '_> {
    fn nodes(&mut self, wanted: &[NodeIndex], work: &Work<'_>) -> Vec<Option<Node>> {
        self.stretch.nodes(self.frame, wanted, work)
    }
}
