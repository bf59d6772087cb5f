//! Light along a known path: solved in few frames, interpolated between them.
//!
//! The coefficients h of the light are smooth functions of the moment t as long as no shadow edge passes and
//! the path does not bend. Between the bends of all paths they are solved, on segments, in 5, 9 or 17 whole
//! frames near Chebyshev points ([`super::chebyshev`]), which are nested: where 2 m intervals add a frame,
//! the interpolant through those of m shows its error d_m. For analytic functions d falls geometrically: the
//! interpolant through all 2 m + 1 errs by about d_m r², r = d_m / d_{m/2}, of which three times d_m r is
//! told. Where that is above what is wanted, and twice as many points are not expected to do (d_m r³), the
//! segment is halved. Before a segment is accepted, its frame farthest from all others is solved as well;
//! what it or any other frame in it that is known is missed by is told if that is more.
//!
//! No frame is solved in vain: each is kept until it is asked for. So all can cost more than one frame after
//! the other only as far as a frame has less in common with one that is far than with the one before, which
//! is bounded beforehand ([`Patience`]); and it is looked before it starts. Five frames are solved one after
//! the other, as all are where nothing is interpolated. Where the second and the fourth are not met by the
//! others, light follows shadow edges or the errors of blocks and rays, and no polynomial of few terms will
//! meet it: some more frames are solved one by one before it is looked again.
//!
//! Frames that are solved follow from whichever was solved last ([`Sequence::incremental`]); what they leave
//! unsolved counts to the error of interpolation. A frame whose elements are not those of the nodes is solved,
//! too: things that slide over others change the elements below.

use std::collections::BTreeMap;
use std::sync::Arc;

use radiosity_scene::{Animation, Scene};
use radiosity_work::Work;

use crate::solution::Solution;

use super::chebyshev;
use super::error::AnimationError;
use super::frame::Frame;
use super::patience::Patience;
use super::segment::{Interpolant, Node, Segment, are_alike, carry_alike, missed};
use super::sequence::Sequence;
use super::sequence_report::SequenceReport;

/// Numbers of intervals between the nodes of a segment.
const LEVELS: [usize; 3] = [4, 8, 16];

/// Factor on the error that is told: points see the error of kinks, where shadow edges pass, in a few places
/// only. Measured: beside a panel that moves before blocks 1e-4 was told and 3.7e-4 true without it.
const SURE: f64 = 3.0;

/// Part of the error that rays leave which interpolation may add to it: finer would be to follow their noise.
/// Chosen.
const OF_NOISE: f64 = 0.3;

/// Factor on the tolerance for what is missed in single frames beside the nodes: each strays by what its own
/// blocks miss. Measured: with a lamp that slides without shadows, at an accuracy of 1e-3, by up to 1.4e-4
/// where light is smooth to 4e-5.
const STRAY: f64 = 2.0;

/// Frames that are solved one after the other to see whether light is smooth.
const LOOK: usize = 5;

/// Frames that are solved one by one where it is not, before it is looked again. Chosen.
const ROUGH: usize = 20;

/// The light of frames along a known path.
#[derive(Debug)]
pub(super) struct PathInterpolation<'a> {
    sequence: Sequence<'a>,
    tolerance: f64,
    /// First and last frames of what is not decided yet, the next one last.
    ahead: Vec<[usize; 2]>,
    segments: Vec<Segment>,
    patience: Patience,
    /// Frames that were solved and may be needed again, by number.
    nodes: BTreeMap<usize, Arc<Node>>,
    /// The frame that was solved last.
    latest: Option<usize>,
}

/// Outcomes of an attempt on some frames ahead.
enum Attempt {
    Found(Interpolant),
    /// The frames are to be solved one by one.
    Single,
    /// Each half may be found by itself.
    Halved,
}

impl<'a> PathInterpolation<'a> {
    /// The light of the frames `first` to `last` of a sequence, to be interpolated to the relative accuracy
    /// `tolerance`. Nothing is solved yet.
    pub(super) fn new(sequence: Sequence<'a>, [first, last]: [usize; 2], tolerance: f64) -> Self {
        let last = last.max(first);
        Self {
            ahead: between_bends(&sequence, [first, last]),
            sequence,
            tolerance,
            segments: Vec::new(),
            patience: Patience::with(last - first + 1),
            nodes: BTreeMap::new(),
            latest: None,
        }
    }

    /// Cost and error of the frames that were solved so far.
    pub(super) fn report(&self) -> &SequenceReport {
        self.sequence.report()
    }

    /// Cost of all solutions so far, in solutions of a frame alone ([`Sequence::spent`]).
    pub(super) fn spent(&self) -> f64 {
        self.sequence.spent()
    }

    /// Number of segments so far in which light is interpolated.
    pub(super) fn segments(&self) -> usize {
        self.interpolants().count()
    }

    /// Largest error that is told of any frame so far.
    pub(super) fn error(&self) -> Option<f64> {
        let interpolated = self.interpolants().map(Interpolant::error_told);
        Some(interpolated.fold(self.report().unsolved, f64::max))
    }

    fn interpolants(&self) -> impl Iterator<Item = &Interpolant> {
        self.segments.iter().filter_map(|segment| match segment {
            Segment::Single(_) => None,
            Segment::Smooth(interpolant) => Some(interpolant),
        })
    }

    /// The light of a frame; segments up to it are found where they are not yet. A frame outside of those
    /// that were asked for is solved by itself.
    ///
    /// # Errors
    /// As [`Sequence::at`].
    pub(super) fn frame(&mut self, frame: usize, work: &Work<'_>) -> Result<Frame, AnimationError> {
        while !self.segments.iter().any(|segment| segment.holds(frame)) {
            match self.ahead.last().copied() {
                Some(next) => self.go_on(next, work)?,
                None => self.segments.push(Segment::Single([frame, frame])),
            }
        }
        let segment = self.segments.iter().find(|segment| segment.holds(frame));
        if let Some(Segment::Smooth(interpolant)) = segment {
            return match interpolant.solved(frame).cloned() {
                Some(node) => self.known(&node),
                None => self.interpolated(frame, work),
            };
        }
        match self.nodes.get(&frame).cloned() {
            Some(node) => self.known(&node),
            None => self.solved(frame, work),
        }
    }

    /// The light of a frame that is interpolated, if its elements are those of the nodes.
    fn interpolated(&mut self, frame: usize, work: &Work<'_>) -> Result<Frame, AnimationError> {
        let moment = frame as f64;
        let scene = self.sequence.scene().at_moment(moment)?;
        let found = self.segments.iter().find_map(|segment| match segment {
            Segment::Smooth(interpolant) if segment.holds(frame) => Some(interpolant),
            _ => None,
        });
        if let Some(interpolant) = found {
            let elements = interpolant.elements().moved(&scene);
            let elements = elements.map_err(|source| AnimationError::of(moment, source.into()))?;
            if carry_alike(&elements, interpolant.elements()) {
                let solution = Solution::of_groups(Arc::new(elements), &scene, interpolant.light(frame));
                let error = interpolant.error_told();
                return Ok(self.lit(scene, solution, error, interpolant.noise()));
            }
        }
        self.solved(frame, work)
    }

    /// A frame that was solved before.
    fn known(&self, node: &Node) -> Result<Frame, AnimationError> {
        let scene = self.sequence.scene().at_moment(node.frame as f64)?;
        let solution = Solution::of_groups(Arc::clone(&node.elements), &scene, node.light.clone());
        Ok(self.lit(scene, solution, node.unsolved, node.noise))
    }

    /// The frame of a scene with its light, the error of interpolation and the one that rays left.
    fn lit(&self, scene: Scene, solution: Solution, error: f64, rays: f64) -> Frame {
        let visibility = self.sequence.options().visibility(&scene);
        Frame { scene, visibility, solution, interpolated: Some(error), rays }
    }

    /// Decides how the frames that are ahead next are found, or the first ones of them.
    fn go_on(&mut self, frames @ [first, last]: [usize; 2], work: &Work<'_>) -> Result<(), AnimationError> {
        // What was solved before is behind.
        self.nodes.retain(|frame, _| *frame >= first);
        let attempt = match self.is_smooth(frames, work) {
            Ok(true) => self.attempt(frames, work),
            Ok(false) => Ok(Attempt::Single),
            Err(error) => Err(error),
        };
        // A frame that cannot be is told when it is asked for.
        let attempt = match attempt {
            Err(AnimationError::Scene(_)) => Attempt::Single,
            attempt => attempt?,
        };
        // Not before: what fails or is interrupted is still ahead.
        self.ahead.pop();
        match attempt {
            Attempt::Found(interpolant) => self.segments.push(Segment::Smooth(interpolant)),
            Attempt::Single if last - first < ROUGH + LOOK || !self.patience.has_any() => {
                self.segments.push(Segment::Single(frames));
            }
            Attempt::Single => {
                self.segments.push(Segment::Single([first, first + ROUGH - 1]));
                self.ahead.push([first + ROUGH, last]);
            }
            Attempt::Halved => {
                // A node of the attempt.
                let middle = first + (last - first).div_ceil(2);
                self.ahead.extend([[middle, last], [first, middle]]);
            }
        }
        Ok(())
    }

    /// Whether the first ones of these frames, solved one after the other, are met by polynomials, and
    /// interpolation of all may pay.
    fn is_smooth(&mut self, [first, last]: [usize; 2], work: &Work<'_>) -> Result<bool, AnimationError> {
        if last - first < 2 * LOOK || !self.patience.has_any() {
            return Ok(false);
        }
        let nodes = (first..first + LOOK).map(|frame| self.node(frame, work));
        let nodes = nodes.collect::<Result<Vec<Arc<Node>>, _>>()?;
        let tolerance = self.tolerance_at(&nodes);
        Ok(are_alike(&nodes) && missed(&nodes, LOOK / 2) <= tolerance)
    }

    /// Tries to interpolate these frames.
    fn attempt(&mut self, frames: [usize; 2], work: &Work<'_>) -> Result<Attempt, AnimationError> {
        let before = self.report().moments;
        let mut is_tried = false;
        for intervals in LEVELS {
            let Some(numbers) = chebyshev::frames(frames, intervals) else { break };
            if !self.pays(frames, &numbers) {
                break;
            }
            let nodes = numbers.iter().map(|frame| self.node(*frame, work));
            let nodes = nodes.collect::<Result<Vec<Arc<Node>>, _>>()?;
            is_tried = true;
            if !are_alike(&nodes) {
                break;
            }
            let tolerance = self.tolerance_at(&nodes);
            let (interpolant, falls) = Interpolant::through(nodes, SURE);
            if interpolant.error <= tolerance {
                match self.checked(interpolant, tolerance, work)? {
                    Some(checked) => return Ok(Attempt::Found(checked)),
                    None => break,
                }
            }
            if interpolant.error * falls.powi(2) > tolerance {
                break;
            }
        }
        self.patience.spend(self.report().moments - before);
        Ok(if is_tried { Attempt::Halved } else { Attempt::Single })
    }

    /// Whether to solve the frames of these numbers, and one more, is expected to take less than half of what
    /// all that are not solved yet take one after the other.
    fn pays(&self, [first, last]: [usize; 2], numbers: &[usize]) -> bool {
        let unsolved = last - first + 1 - self.nodes.range(first..=last).count();
        let missing = numbers.iter().filter(|frame| !self.nodes.contains_key(frame)).count();
        self.patience.has_any() && 2.0 * self.patience.cost(missing + 1) < unsolved as f64
    }

    /// The interpolant with the frame that is farthest from its nodes, and all others that are known; None
    /// where it misses them.
    fn checked(
        &mut self,
        mut interpolant: Interpolant,
        tolerance: f64,
        work: &Work<'_>,
    ) -> Result<Option<Interpolant>, AnimationError> {
        let farthest = self.node(interpolant.farthest(), work)?;
        let missed = interpolant.check(&farthest, SURE);
        let [first, last] = interpolant.ends();
        let others = self.nodes.range(first..=last);
        let missed = others.map(|(_, node)| interpolant.check(node, 1.0)).fold(missed, f64::max);
        Ok((missed <= STRAY * tolerance).then_some(interpolant))
    }

    /// The error that interpolation through these nodes may have.
    fn tolerance_at(&self, nodes: &[Arc<Node>]) -> f64 {
        let noise = nodes.iter().map(|node| node.noise).fold(0.0, f64::max);
        self.tolerance.max(OF_NOISE * noise)
    }

    /// The light of a frame that is to be kept until it is behind.
    fn node(&mut self, frame: usize, work: &Work<'_>) -> Result<Arc<Node>, AnimationError> {
        if let Some(known) = self.nodes.get(&frame) {
            return Ok(Arc::clone(known));
        }
        let (before, is_next) = (self.spent(), self.latest.is_some_and(|latest| latest + 1 == frame));
        let Frame { solution, rays: noise, interpolated, .. } = self.solved(frame, work)?;
        if is_next {
            self.patience.note_next(self.spent() - before);
        }
        let light = solution.light().ok_or(AnimationError::Masked)?;
        let unsolved = interpolated.unwrap_or(0.0);
        let node = Arc::new(Node { frame, light, elements: solution.shared_elements(), noise, unsolved });
        self.nodes.insert(frame, Arc::clone(&node));
        Ok(node)
    }

    /// A frame, solved after whichever was solved last.
    fn solved(&mut self, frame: usize, work: &Work<'_>) -> Result<Frame, AnimationError> {
        let solved = self.sequence.at(frame as f64, work)?;
        self.latest = Some(frame);
        Ok(solved)
    }
}

/// The frames cut where a path bends, the last ones first.
fn between_bends(sequence: &Sequence<'_>, [first, last]: [usize; 2]) -> Vec<[usize; 2]> {
    let bends = sequence.scene().animation.as_ref().map(Animation::bends).unwrap_or_default();
    let inside = bends.into_iter().filter(|bend| (first as f64..last as f64).contains(bend));
    let (mut parts, mut start) = (Vec::new(), first);
    for bend in inside {
        let (before, after) = (bend.floor() as usize, bend.ceil() as usize);
        if before >= start && after > start {
            parts.push([start, before]);
            start = after;
        }
    }
    parts.push([start, last]);
    parts.reverse();
    parts
}
