//! Planes that lie before others: sheets that are apart tell which, also over sheets between them.
//!
//! Of three sheets on each other the first and the last may share no area, and lie within each other's tolerance:
//! were they given one plane, the one between them would lie in it as well.

use std::collections::{HashMap, HashSet};

use radiosity_geom::DVec3;

use super::apart::Apart;
use super::forest::Forest;
use super::sheet::Sheets;

/// A sheet that is apart from another one.
#[derive(Clone, Copy, Debug)]
struct Beside {
    sheet: usize,
    /// Unit vector from the other one towards it.
    direction: DVec3,
}

/// Sheets that are apart, by the planes that they are in.
#[derive(Debug)]
pub(super) struct Layers {
    beside: HashMap<usize, Vec<Beside>>,
    /// By the root of each tree its sheets that others are apart from.
    members: HashMap<usize, Vec<usize>>,
}

impl Layers {
    /// The sheets that are `apart`, each in a plane of its own.
    pub(super) fn of(sheets: &Sheets, apart: &Apart) -> Self {
        let mut pairs: Vec<(usize, usize)> = apart.iter().copied().collect();
        pairs.sort_unstable();
        let mut beside: HashMap<usize, Vec<Beside>> = HashMap::new();
        for (own, sheet) in pairs {
            let Some(region) = &sheets.list[own].region else { continue };
            let [low, high] = sheets.list[sheet].heights_over(region);
            let direction = (low + high).signum() * region.normal();
            beside.entry(own).or_default().push(Beside { sheet, direction });
        }
        let members = beside.keys().map(|own| (*own, vec![*own])).collect();
        Self { beside, members }
    }

    /// Joins the planes of two sheets in the forest, unless one lies before the other.
    pub(super) fn join(&mut self, forest: &mut Forest, one: usize, other: usize) {
        let [one, other] = [one, other].map(|sheet| forest.root(sheet));
        if one == other || self.lies_before(forest, one, other) {
            return;
        }
        forest.join(one, other);
        let joined = [one, other].map(|root| self.members.remove(&root)).into_iter().flatten().flatten();
        let joined: Vec<usize> = joined.collect();
        if !joined.is_empty() {
            self.members.insert(forest.root(one), joined);
        }
    }

    /// Whether planes that lie before each other lead from one root to the other on either side.
    fn lies_before(&self, forest: &Forest, one: usize, other: usize) -> bool {
        let of =
            |root: usize| self.members.get(&root).into_iter().flatten().flat_map(|own| &self.beside[own]);
        if of(one).next().is_none() || of(other).next().is_none() {
            return false;
        }
        of(one).any(|first| {
            let mut known = HashSet::new();
            let mut open = vec![forest.root(first.sheet)];
            while let Some(root) = open.pop() {
                if root == other {
                    return true;
                }
                if known.insert(root) {
                    let onwards = of(root).filter(|next| next.direction.dot(first.direction) > 0.0);
                    open.extend(onwards.map(|next| forest.root(next.sheet)));
                }
            }
            false
        })
    }
}
