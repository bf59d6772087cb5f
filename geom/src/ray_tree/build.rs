//! From boxes to a tree of forks.
//!
//! Top-down: of the parts of a node the one of largest area is split until there are eight. A part is split
//! between the two of 32 bins of box centres that minimise Σ area · cost (the surface-area heuristic;
//! Goldsmith and Salmon, 1987; binning after Wald, 2007); few boxes are each a bin of their own. Up to four
//! flat surfaces make a leaf, as does any other one.

use super::flats;
use super::fork::{Fork, WIDTH};
use super::frame::Box32;
use smallvec::SmallVec;

/// Below this depth parts are chosen by the number of their boxes and cut in halves instead, which bounds the
/// depth of the stack: 8¹⁰ boxes are then ten forks deep.
const HEURISTIC_DEPTH: usize = 11;

/// Forks from the root to any leaf, at most.
pub(super) const DEEPEST: usize = HEURISTIC_DEPTH + 10;

/// Bins of box centres. Measured in a classroom: with half as many rays visit 3 % more forks, with twice as
/// many as many forks.
const BINS: usize = 32;

/// Expected cost of a flat surface in a leaf, in tests of a curved one.
const FLAT_COST: f32 = 0.3;

/// Content of a child: a fork, four flats, or a curved surface, by its place in the list of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Content {
    Fork(usize),
    Flats(usize),
    Curved(usize),
}

const KIND: u32 = 30;

impl Content {
    #[inline]
    pub(super) fn of(child: u32) -> Content {
        let place = (child & ((1 << KIND) - 1)) as usize;
        match child >> KIND {
            0 => Content::Fork(place),
            1 => Content::Flats(place),
            _ => Content::Curved(place),
        }
    }

    fn child(self) -> u32 {
        let (kind, place) = match self {
            Content::Fork(place) => (0, place),
            Content::Flats(place) => (1, place),
            Content::Curved(place) => (2, place),
        };
        assert!(place < 1 << KIND, "fewer than 2³⁰ surfaces");
        kind << KIND | place as u32
    }
}

/// A surface to be put into the tree.
#[derive(Clone, Copy, Debug)]
pub(super) struct Item {
    pub(super) bounds: Box32,
    pub(super) surface: u32,
    pub(super) is_flat: bool,
}

/// Forks, the first of which is the root, and the flat surfaces of each leaf of such.
#[derive(Debug, Default)]
pub(super) struct Layout {
    pub(super) forks: Vec<Fork>,
    pub(super) flats: Vec<Vec<u32>>,
    /// Forks from the root to any leaf, at most.
    pub(super) depth: usize,
}

impl Layout {
    /// The tree over `items`; none without them.
    pub(super) fn new(mut items: Vec<Item>) -> Layout {
        let mut layout = Layout::default();
        if !items.is_empty() {
            layout.fork(&mut items, 0);
        }
        layout
    }

    /// Adds a fork over `items`.
    fn fork(&mut self, items: &mut [Item], depth: usize) -> Content {
        let place = self.forks.len();
        self.depth = self.depth.max(depth + 1);
        self.forks.push(Fork::new(&[], &[]));
        let (mut boxes, mut children) = (Vec::with_capacity(WIDTH), Vec::with_capacity(WIDTH));
        for part in parts(items, depth) {
            boxes.push(around(part));
            children.push(self.content(part, depth + 1).child());
        }
        self.forks[place] = Fork::new(&boxes, &children);
        Content::Fork(place)
    }

    fn content(&mut self, items: &mut [Item], depth: usize) -> Content {
        if !is_leaf(items) {
            return self.fork(items, depth);
        }
        if !items[0].is_flat {
            return Content::Curved(items[0].surface as usize);
        }
        self.flats.push(items.iter().map(|item| item.surface).collect());
        Content::Flats(self.flats.len() - 1)
    }
}

fn is_leaf(items: &[Item]) -> bool {
    items.len() == 1 || items.len() <= flats::WIDTH && items.iter().all(|item| item.is_flat)
}

fn around(items: &[Item]) -> Box32 {
    items.iter().fold(Box32::EMPTY, |bounds, item| bounds.union(&item.bounds))
}

/// Splits `items` into up to eight.
fn parts(items: &mut [Item], depth: usize) -> Vec<&mut [Item]> {
    let mut parts = vec![items];
    while parts.len() < WIDTH {
        let open = parts.iter().enumerate().filter(|(_, part)| !is_leaf(part));
        let sizes = open.map(|(place, part)| (place, size(part, depth)));
        let Some((largest, _)) = sizes.max_by(|a, b| a.1.total_cmp(&b.1)) else { break };
        let part = parts.swap_remove(largest);
        let middle = if depth < HEURISTIC_DEPTH { split_by_area(part) } else { None };
        let middle = middle.unwrap_or_else(|| split_in_half(part));
        let (left, right) = part.split_at_mut(middle);
        parts.extend([left, right]);
    }
    parts
}

/// By which the part to be split next is chosen.
fn size(items: &[Item], depth: usize) -> f32 {
    if depth < HEURISTIC_DEPTH { around(items).half_area() } else { items.len() as f32 }
}

/// The cost of what is in a bin.
#[derive(Clone, Copy)]
struct Bin {
    bounds: Box32,
    flats: u32,
    curved: u32,
}

impl Bin {
    const EMPTY: Bin = Bin { bounds: Box32::EMPTY, flats: 0, curved: 0 };

    fn of(item: &Item) -> Bin {
        Bin { bounds: item.bounds, flats: u32::from(item.is_flat), curved: u32::from(!item.is_flat) }
    }

    fn add(&mut self, other: &Bin) {
        self.bounds = self.bounds.union(&other.bounds);
        self.flats += other.flats;
        self.curved += other.curved;
    }

    fn cost(&self) -> f32 {
        if self.flats + self.curved == 0 {
            return 0.0;
        }
        self.bounds.half_area() * (FLAT_COST * self.flats as f32 + self.curved as f32)
    }
}

/// Reorders `items` by the best plane between bins; returns how many come before it. None where all centres
/// agree.
fn split_by_area(items: &mut [Item]) -> Option<usize> {
    let (low, high) = spread(items);
    let axes = (0..3).filter(|axis| high[*axis] > low[*axis]);
    if items.len() <= BINS {
        let cuts = axes.map(|axis| {
            sort_along(items, axis);
            best_cut(axis, &items.iter().map(Bin::of).collect::<SmallVec<[Bin; BINS]>>())
        });
        let BinCut { axis, bin, .. } = cuts.min_by(|a, b| a.cost.total_cmp(&b.cost))?;
        sort_along(items, axis);
        return Some(bin + 1);
    }
    let bin_along = |item: &Item, axis: usize| bin_of(item.bounds.middle()[axis], low[axis], high[axis]);
    let cuts = axes.map(|axis| {
        let mut bins = [Bin::EMPTY; BINS];
        items.iter().for_each(|item| bins[bin_along(item, axis)].add(&Bin::of(item)));
        best_cut(axis, &bins)
    });
    let BinCut { axis, bin, .. } = cuts.min_by(|a, b| a.cost.total_cmp(&b.cost))?;
    Some(partition(items, |item| bin_along(item, axis) <= bin))
}

/// Sorts by the middles along `axis`.
fn sort_along(items: &mut [Item], axis: usize) {
    let key = |item: &Item| item.bounds.middle()[axis];
    items.sort_unstable_by(|a, b| key(a).total_cmp(&key(b)).then(a.surface.cmp(&b.surface)));
}

/// Range of the middles.
fn spread(items: &[Item]) -> ([f32; 3], [f32; 3]) {
    let start = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    items.iter().fold(start, |(mut low, mut high), item| {
        let middle = item.bounds.middle();
        for axis in 0..3 {
            low[axis] = low[axis].min(middle[axis]);
            high[axis] = high[axis].max(middle[axis]);
        }
        (low, high)
    })
}

/// A cut between two bins.
struct BinCut {
    axis: usize,
    /// The bin after which to cut.
    bin: usize,
    /// Cost of both sides.
    cost: f32,
}

/// The best cut between two or more bins along `axis`.
fn best_cut(axis: usize, bins: &[Bin]) -> BinCut {
    let mut right = [0.0; BINS];
    let mut side = Bin::EMPTY;
    for bin in (1..bins.len()).rev() {
        side.add(&bins[bin]);
        right[bin] = side.cost();
    }
    let mut side = Bin::EMPTY;
    let cuts = (0..bins.len() - 1).map(|bin| {
        side.add(&bins[bin]);
        BinCut { axis, bin, cost: side.cost() + right[bin + 1] }
    });
    cuts.min_by(|a, b| a.cost.total_cmp(&b.cost)).expect("some bins")
}

fn bin_of(middle: f32, low: f32, high: f32) -> usize {
    (((middle - low) / (high - low) * BINS as f32) as usize).min(BINS - 1)
}

/// Brings those items to the front of which `is_left` holds; returns how many.
fn partition(items: &mut [Item], is_left: impl Fn(&Item) -> bool) -> usize {
    let mut count = 0;
    for k in 0..items.len() {
        if is_left(&items[k]) {
            items.swap(count, k);
            count += 1;
        }
    }
    count
}

/// Reorders `items` about the median middle along the longest spread; returns how many come before it.
fn split_in_half(items: &mut [Item]) -> usize {
    let (low, high) = spread(items);
    let longest = |a: &usize, b: &usize| (high[*a] - low[*a]).total_cmp(&(high[*b] - low[*b]));
    let axis = (0..3).max_by(longest).expect("three axes");
    let half = items.len() / 2;
    sort_along(items, axis);
    half
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The surfaces below a child, and how deep they lie.
    fn gather(layout: &Layout, content: Content, depth: usize, found: &mut Vec<(u32, usize)>) {
        match content {
            Content::Fork(fork) => {
                layout.forks[fork]
                    .contents()
                    .for_each(|child| gather(layout, Content::of(child), depth + 1, found));
            }
            Content::Flats(leaf) => found.extend(layout.flats[leaf].iter().map(|surface| (*surface, depth))),
            Content::Curved(surface) => found.push((surface as u32, depth)),
        }
    }

    proptest! {
        /// Also of boxes in one place, and of such whose middles crowd ever more.
        #[test]
        fn every_surface_is_in_one_leaf(count in 1usize..400, crowding in 0.0..1.0_f32, every in 1usize..5) {
            let items: Vec<Item> = (0..count).map(|k| {
                let x = crowding.powi(k as i32);
                let bounds = Box32 { min: [x, 0.0, x], max: [x + 0.1, 1.0, 2.0 * x] };
                Item { bounds, surface: k as u32, is_flat: k % every == 0 }
            }).collect();
            let mut found = Vec::new();
            let layout = Layout::new(items);
            gather(&layout, Content::Fork(0), 0, &mut found);
            found.sort_unstable();
            prop_assert!(found.iter().map(|(surface, _)| *surface as usize).eq(0..count));
            let deepest = found.iter().map(|(_, depth)| *depth).max();
            prop_assert_eq!(deepest, Some(layout.depth));
            prop_assert!(layout.depth <= DEEPEST);
        }
    }
}
