//! Surfaces that pass through others in some frame of a scene in which something moves.
//!
//! Some of the frames are looked at, spread evenly from the first to the last, and the step from each to the
//! next frame ([`super::leap`]). What is moved along one path stays as it is at rest to each other; of all
//! other pairs those are tested whose boxes overlap.

use std::collections::BTreeMap;

use radiosity_geom::{Adjacency, Patch};
use radiosity_scene::{Scene, SceneError};
use rayon::prelude::*;

use crate::inspection::{
    leap,
    sheet::{Sheet, Sheets},
    warning::Warning,
};

/// Most frames that are looked at: a bound of time. A passage that is shorter than a hundredth of the
/// frames may be missed.
const LOOKED_AT: usize = 100;

/// A surface that passes through another one, or lies in it, in some frames.
#[derive(Clone, Debug, PartialEq)]
pub struct Passage {
    /// The name of a surface that has moved.
    pub surface: String,
    /// The name of the other one; none where the frame itself is refused.
    pub other: Option<String>,
    /// The frames that were looked at in which it does, ascending.
    pub frames: Vec<usize>,
    /// The frames that were looked at between which and the next one a point of either passes through the
    /// other, ascending.
    pub before: Vec<usize>,
    /// Why the frame is refused.
    refusal: Option<String>,
}

impl Passage {
    /// Warning about the passage.
    pub fn warning(&self) -> Warning {
        let when = match (self.frames.first().zip(self.frames.last()), self.before.first()) {
            (Some((first, last)), _) if first == last => format!("in frame {first}"),
            (Some((first, last)), _) => format!("in frames {first} to {last}"),
            (None, before) => {
                let before = before.copied().unwrap_or_default();
                format!("between frames {before} and {}", before + 1)
            }
        };
        match (&self.other, &self.refusal) {
            (Some(other), _) => {
                let message = format!("passes through {other:?} {when}: lead its path past that");
                Warning::about("passage", &self.surface, message)
            }
            (None, refusal) => {
                let why = refusal.as_deref().unwrap_or_default();
                Warning::about("passage", &self.surface, format!("cannot be shown {when}: {why}"))
            }
        }
    }
}

/// All passages in the frames `first` to `last` of a scene and between them, in the order of the surfaces;
/// none where nothing moves.
pub fn passages(scene: &Scene, frames: [usize; 2]) -> Vec<Passage> {
    match scene.frames() {
        0 => Vec::new(),
        _ => among(scene, &Sheets::of(scene), frames),
    }
}

/// The frames that are looked at.
fn looked_at([first, last]: [usize; 2]) -> Vec<usize> {
    let count = (last - first + 1).min(LOOKED_AT);
    let mut all: Vec<usize> = (0..count).map(|k| first + k * (last - first) / (count - 1).max(1)).collect();
    all.dedup();
    all
}

/// All passages in these frames and between them, in the order of the surfaces; `rest` are the sheets at
/// rest.
pub(super) fn among(scene: &Scene, rest: &Sheets, [first, last]: [usize; 2]) -> Vec<Passage> {
    let frames = looked_at([first, last]);
    let found = frames.par_iter().map(|frame| {
        let leaps = if *frame < last { between(scene, rest, *frame) } else { Vec::new() };
        [in_frame(scene, rest, *frame), leaps]
    });
    let found: Vec<[Vec<Pair>; 2]> = found.collect();
    let mut by_pair: BTreeMap<Pair, [Vec<usize>; 2]> = BTreeMap::new();
    for (frame, pairs) in frames.iter().zip(found) {
        for (kind, pairs) in pairs.into_iter().enumerate() {
            pairs.into_iter().for_each(|pair| by_pair.entry(pair).or_default()[kind].push(*frame));
        }
    }
    let passage = |(pair, [frames, before]): (Pair, [Vec<usize>; 2])| Passage {
        surface: pair.surface,
        other: pair.other,
        frames,
        before,
        refusal: pair.refusal,
    };
    by_pair.into_iter().map(passage).collect()
}

/// A surface that passes through another one.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Pair {
    index: usize,
    surface: String,
    other: Option<String>,
    refusal: Option<String>,
}

impl Pair {
    /// A sheet and another one that it passes through.
    fn of(own: &Sheet, other: &Sheet) -> Self {
        Self { index: own.surface, surface: own.name.clone(), other: Some(other.name.clone()), refusal: None }
    }

    /// A frame that is refused, by the surface that is to blame.
    fn refused(error: &SceneError) -> Self {
        let name = error.owner.as_deref().and_then(|owner| owner.split('"').nth(1)).unwrap_or_default();
        let cure = error.cure().map(|cure| format!("; {cure}")).unwrap_or_default();
        Self {
            index: usize::MAX,
            surface: name.to_owned(),
            other: None,
            refusal: Some(format!("{}{cure}", error.fault)),
        }
    }
}

/// The surfaces that pass through others in a frame, which do not at rest.
fn in_frame(scene: &Scene, rest: &Sheets, frame: usize) -> Vec<Pair> {
    let Ok(movers) = scene.movers_at(frame) else { return Vec::new() };
    let still = match scene.at_frame(frame) {
        Ok(still) => still,
        Err(error) => return vec![Pair::refused(&error)],
    };
    let is_moved = |sheet: &&Sheet| movers[sheet.surface].is_some();
    let moved: Vec<Sheet> = rest.list.iter().filter(is_moved).map(|sheet| sheet.as_in(&still)).collect();
    let mut pairs = Vec::new();
    for own in &moved {
        let near = rest.around(&own.bounds).map(|other| &rest.list[other]);
        let standing = near.filter(|other| movers[other.surface].is_none());
        let moving = moved.iter().filter(|other| {
            let is_later = other.surface > own.surface;
            is_later && movers[other.surface] != movers[own.surface] && other.bounds.overlaps(&own.bounds)
        });
        let crossed = standing.chain(moving).filter(|other| crosses(&own.patch(), &other.patch()));
        pairs.extend(crossed.map(|other| Pair::of(own, other)));
    }
    pairs
}

/// The surfaces that pass through others between a frame and the next one.
fn between(scene: &Scene, rest: &Sheets, frame: usize) -> Vec<Pair> {
    let pairs = leap::leaps(scene, rest, frame).into_iter();
    pairs.map(|[own, other]| Pair::of(&rest.list[own], &rest.list[other])).collect()
}

fn crosses(own: &Patch<'_>, other: &Patch<'_>) -> bool {
    matches!(Adjacency::of(own, other), Some(Adjacency::Crossing { .. }))
}
