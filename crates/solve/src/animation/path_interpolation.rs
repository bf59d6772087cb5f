//! Light along a known path: solved at few moments, interpolated between them.
//!
//! The coefficients h of the light are smooth functions of the moment t as long as no shadow edge passes and
//! the path does not bend. Between the bends of all paths they are solved, on segments, at 5, 9 or 17
//! Chebyshev points ([`super::chebyshev`]), which are nested: at the points between m + 1 others the
//! interpolant h_m through these shows its error
//!
//! ```text
//! d_m = max_t ‖h(t) − h_m(t)‖ / ‖h(t)‖ ,    r = d_m / d_{m/2} ,
//! ```
//!
//! norms over all elements, for the worst of the bands and light groups. For analytic functions d falls
//! geometrically: the interpolant through all 2 m + 1 points errs by about d_m r², of which three times d_m r
//! is told. Where that is above what is wanted, and twice as many points are not expected to do (d_m r³), the
//! segment is halved. Before a segment is accepted, its frame farthest from all points is solved as well:
//! what comes and goes between the points is seen if it is there, and what that frame errs by is told if it
//! is more.
//!
//! A segment of few frames, and all after many moments were solved in vain, is solved frame by frame instead:
//! these frames are then as they are alone. So is a frame whose elements are not those of the points: things
//! that slide over others change the elements below.

use std::collections::BTreeMap;
use std::sync::Arc;

use radiosity_core::dot;
use radiosity_elements::{Element, Elements};
use radiosity_scene::{Animation, Scene};
use radiosity_work::Work;

use crate::solution::Solution;
use crate::solution::group_light::GroupLight;

use super::chebyshev;
use super::error::AnimationError;
use super::frame::Frame;
use super::sequence::Sequence;
use super::sequence_report::SequenceReport;

/// Numbers of intervals between the points of a segment.
const LEVELS: [usize; 3] = [4, 8, 16];

/// Factor on the error that is told: points see the error of kinks, where shadow edges pass, in a few places
/// only. Measured: beside a panel that moves before blocks 1e-4 was told and 3.7e-4 true without it.
const SURE: f64 = 3.0;

/// Part of the error that rays leave which interpolation may add to it: finer would be to follow their noise.
/// Chosen.
const OF_NOISE: f64 = 0.3;

/// Moments that may be solved in vain before all other frames are solved one by one: at least so many, and
/// one for so many frames. Chosen.
const PATIENCE: usize = 10;
const FRAMES_EACH: usize = 5;

/// Most frames of a segment that are solved one by one rather than halved again. Chosen: down to 6, twenty
/// frames of a shadow edge cost up to 30 solutions.
const FEW: usize = 24;

/// The light of frames along a known path.
#[derive(Debug)]
pub(super) struct PathInterpolation<'a> {
    sequence: Sequence<'a>,
    tolerance: f64,
    /// First and last frames of what is not solved yet, the next one last.
    ahead: Vec<[usize; 2]>,
    segments: Vec<Segment>,
    /// Moments that may still be solved in vain.
    patience: usize,
    /// Light that was solved and may be needed again, by the bits of the moment, which is not negative.
    nodes: BTreeMap<u64, Arc<Node>>,
}

/// A part of the path.
#[derive(Debug)]
struct Segment {
    /// First and last moment.
    ends: [f64; 2],
    /// Light at its Chebyshev points; none where it is solved frame by frame.
    nodes: Vec<Arc<Node>>,
    /// Estimated relative error between the points; None where it is solved frame by frame.
    error: Option<f64>,
}

/// The light at a moment.
#[derive(Debug)]
struct Node {
    light: Vec<GroupLight>,
    elements: Arc<Elements>,
    /// Relative error that rays left, where they carried the pairs.
    noise: f64,
}

impl<'a> PathInterpolation<'a> {
    /// The light of the frames `first` to `last` of a sequence, to be interpolated to the relative accuracy
    /// `tolerance`. Nothing is solved yet.
    pub(super) fn new(sequence: Sequence<'a>, [first, last]: [usize; 2], tolerance: f64) -> Self {
        Self {
            ahead: between_bends(&sequence, [first, last.max(first)]),
            sequence,
            tolerance,
            segments: Vec::new(),
            patience: PATIENCE.max((last.max(first) - first) / FRAMES_EACH),
            nodes: BTreeMap::new(),
        }
    }

    /// Cost and error of the moments that were solved so far.
    pub(super) fn report(&self) -> &SequenceReport {
        self.sequence.report()
    }

    /// Cost of all solutions so far, in solutions of a frame alone ([`Sequence::spent`]).
    pub(super) fn spent(&self) -> f64 {
        self.sequence.spent()
    }

    /// Number of segments so far.
    pub(super) fn segments(&self) -> usize {
        self.segments.len()
    }

    /// Largest error that is told of any segment so far; None where none was interpolated.
    pub(super) fn error(&self) -> Option<f64> {
        self.segments.iter().filter_map(|segment| segment.error).reduce(f64::max)
    }

    /// The light of a frame; segments up to it are solved where they are not yet. A frame outside of those
    /// that were asked for is solved by itself.
    ///
    /// # Errors
    /// As [`Sequence::at`].
    pub(super) fn frame(&mut self, frame: usize, work: &Work<'_>) -> Result<Frame, AnimationError> {
        let moment = frame as f64;
        let holds = |segment: &Segment| (segment.ends[0]..=segment.ends[1]).contains(&moment);
        while !self.segments.iter().any(holds) {
            let next = self.ahead.last().copied();
            self.solve(next.unwrap_or([frame, frame]), work)?;
        }
        let segment = self.segments.iter().find(|segment| holds(segment)).expect("it was just found");
        if segment.error.is_some() {
            let scene = self.sequence.scene().at_moment(moment)?;
            let elements = segment.nodes[0].elements.moved(&scene);
            let elements = elements.map_err(|source| AnimationError::of(moment, source.into()))?;
            if carry_alike(&elements, &segment.nodes[0].elements) {
                let solution = Solution::of_groups(Arc::new(elements), &scene, segment.light(moment));
                return Ok(self.lit(scene, solution, segment.error, segment.noise()));
            }
        }
        self.alone(moment, work)
    }

    /// The light of a frame that is not interpolated.
    fn alone(&mut self, moment: f64, work: &Work<'_>) -> Result<Frame, AnimationError> {
        if let Some(node) = self.nodes.get(&moment.to_bits()) {
            let scene = self.sequence.scene().at_moment(moment)?;
            let solution = Solution::of_groups(Arc::clone(&node.elements), &scene, node.light.clone());
            return Ok(self.lit(scene, solution, None, node.noise));
        }
        self.sequence.at(moment, work)
    }

    /// The frame of a scene with its light, the error of interpolation and the one that rays left.
    fn lit(&self, scene: Scene, solution: Solution, interpolated: Option<f64>, rays: f64) -> Frame {
        let visibility = self.sequence.options().visibility(&scene);
        Frame { scene, visibility, solution, interpolated, rays }
    }

    /// Solves a segment, or halves it.
    fn solve(&mut self, frames @ [first, last]: [usize; 2], work: &Work<'_>) -> Result<(), AnimationError> {
        // What was solved before is behind.
        self.nodes.retain(|bits, _| f64::from_bits(*bits) >= first as f64);
        let solved = self.segment(frames, work)?;
        // Not before: what fails or is interrupted is still ahead.
        self.ahead.pop_if(|ahead| *ahead == frames);
        match solved {
            Some(segment) => self.segments.push(segment),
            None => {
                let middle = first.midpoint(last);
                self.ahead.extend([[middle, last], [first, middle]]);
            }
        }
        Ok(())
    }

    /// The segment of these frames; None where it has to be halved.
    fn segment(
        &mut self,
        [first, last]: [usize; 2],
        work: &Work<'_>,
    ) -> Result<Option<Segment>, AnimationError> {
        let (ends, frames) = ([first as f64, last as f64], last - first + 1);
        let before = self.report().moments;
        for intervals in LEVELS {
            if 2 * intervals >= frames || self.patience == 0 {
                return Ok(Some(Segment::by_frames(ends)));
            }
            let points: Vec<f64> = (0..=intervals).map(|k| point(ends, k, intervals)).collect();
            let nodes = points.iter().map(|point| self.node(*point, work)).collect();
            // Between frames things may be where they cannot be.
            let nodes: Vec<Arc<Node>> = match nodes {
                Err(AnimationError::Scene(_)) => return Ok(Some(Segment::by_frames(ends))),
                nodes => nodes?,
            };
            if !are_alike(&nodes) {
                break;
            }
            let [missed, coarser] = [2, 4].map(|part| missed(&nodes, intervals / part));
            let falls = if coarser > 0.0 { (missed / coarser).min(1.0) } else { 1.0 };
            let error = SURE * missed * falls;
            let segment = Segment { ends, nodes, error: Some(error) };
            let tolerance = self.tolerance.max(OF_NOISE * segment.noise());
            if error <= tolerance {
                let checked = self.checked(segment, farthest([first, last], &points), work)?;
                if checked.error.is_some_and(|error| error <= tolerance) {
                    return Ok(Some(checked));
                }
                break;
            }
            if error * falls.powi(2) > tolerance {
                break;
            }
        }
        self.patience = self.patience.saturating_sub(self.report().moments - before);
        Ok((frames <= FEW).then(|| Segment::by_frames(ends)))
    }

    /// The segment, with the error of this frame if that is more.
    fn checked(
        &mut self,
        segment: Segment,
        frame: usize,
        work: &Work<'_>,
    ) -> Result<Segment, AnimationError> {
        let node = self.node(frame as f64, work)?;
        let apart = match carry_alike(&node.elements, &segment.nodes[0].elements) {
            true => apart(&segment.light(frame as f64), &node.light),
            false => f64::INFINITY,
        };
        Ok(Segment { error: segment.error.map(|error| error.max(apart)), ..segment })
    }

    /// The light at a moment.
    fn node(&mut self, moment: f64, work: &Work<'_>) -> Result<Arc<Node>, AnimationError> {
        if let Some(known) = self.nodes.get(&moment.to_bits()) {
            return Ok(Arc::clone(known));
        }
        let Frame { solution, rays: noise, .. } = self.sequence.at(moment, work)?;
        let light = solution.light().ok_or(AnimationError::Masked)?;
        let node = Arc::new(Node { light, elements: solution.shared_elements(), noise });
        self.nodes.insert(moment.to_bits(), Arc::clone(&node));
        Ok(node)
    }
}

/// The Chebyshev point of a number between the ends of a segment.
fn point([first, last]: [f64; 2], number: usize, intervals: usize) -> f64 {
    0.5 * (first + last + (last - first) * chebyshev::point(number, intervals))
}

impl Segment {
    /// Largest error that rays left at any point.
    fn noise(&self) -> f64 {
        self.nodes.iter().map(|node| node.noise).fold(0.0, f64::max)
    }

    /// A segment whose frames are solved one by one.
    fn by_frames(ends: [f64; 2]) -> Self {
        Self { ends, nodes: Vec::new(), error: None }
    }

    /// The interpolated light of each group at a moment.
    fn light(&self, moment: f64) -> Vec<GroupLight> {
        let [first, last] = self.ends;
        let place = (2.0 * moment - first - last) / (last - first);
        interpolated(&self.nodes, &chebyshev::factors(self.nodes.len() - 1, place))
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

/// The light of each group, as the sum of that of the `nodes` with `factors`.
fn interpolated(nodes: &[Arc<Node>], factors: &[f64]) -> Vec<GroupLight> {
    let groups = 0..nodes.first().map_or(0, |node| node.light.len());
    groups.map(|group| GroupLight::together(factors, nodes.iter().map(|node| &node.light[group]))).collect()
}

/// Whether the same functions carry the light of all nodes.
fn are_alike(nodes: &[Arc<Node>]) -> bool {
    nodes[1..].iter().all(|node| carry_alike(&nodes[0].elements, &node.elements))
}

/// Whether the same functions carry light on both, and what others cover is the same on both to the bit: how
/// it is cut follows from what covers it.
fn carry_alike(first: &Elements, other: &Elements) -> bool {
    let mut pairs = first.list().iter().zip(other.list());
    let is_kept = |(a, b): (&Element, &Element)| {
        a.contact == b.contact && (a.contact.is_none() || (a.patches == b.patches && a.basis == b.basis))
    };
    first.starts() == other.starts() && pairs.all(is_kept)
}

/// The frame from `first` to `last` that is farthest from all `points`.
fn farthest([first, last]: [usize; 2], points: &[f64]) -> usize {
    let gap =
        |frame: &usize| points.iter().map(|point| (point - *frame as f64).abs()).fold(f64::MAX, f64::min);
    (first..=last).max_by(|a, b| gap(a).total_cmp(&gap(b))).unwrap_or(first)
}

/// d_m for m = `coarse` intervals: how far the light of those nodes between is from the interpolant through
/// the others.
fn missed(nodes: &[Arc<Node>], coarse: usize) -> f64 {
    let step = (nodes.len() - 1) / (2 * coarse);
    let known: Vec<Arc<Node>> = nodes.iter().step_by(2 * step).cloned().collect();
    let between = (0..coarse).map(|k| {
        let factors = chebyshev::factors(coarse, chebyshev::point(2 * k + 1, 2 * coarse));
        apart(&interpolated(&known, &factors), &nodes[(2 * k + 1) * step].light)
    });
    between.fold(0.0, f64::max)
}

/// The largest relative difference of any group in any band.
fn apart(light: &[GroupLight], right: &[GroupLight]) -> f64 {
    let bands = light.iter().zip(right).flat_map(|(own, other)| own.bands.iter().zip(&other.bands));
    let relative = bands.map(|(own, other)| {
        let pairs = own.irradiance.iter().zip(&other.irradiance);
        let difference = pairs.map(|(a, b)| (a - b).powi(2)).sum::<f64>();
        let size = dot(&other.irradiance, &other.irradiance);
        match size {
            size if size > 0.0 => (difference / size).sqrt(),
            _ if difference > 0.0 => f64::INFINITY,
            _ => 0.0,
        }
    });
    relative.fold(0.0, f64::max)
}
