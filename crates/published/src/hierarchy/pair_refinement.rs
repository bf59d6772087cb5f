//! Refinement: the pairs of nodes that are to be linked.
//!
//! From the pair of the root with itself on, a pair is linked, left out or replaced by pairs of children: of
//! the larger node, by radius, or of the other where the larger is no larger than the least area (Hanrahan,
//! Salzman, Aupperle 1991, with clusters as of Smits, Arvo, Greenberg 1994). A node's pair with itself
//! becomes the pairs of its children.

use radiosity_work::interruption::check_interrupt;

use super::oracle::{Oracle, Verdict};
use super::tree::Tree;

/// A pair of nodes; equal ones for the light that a curved face sends to itself.
pub(crate) type Pair = [u32; 2];

/// The state of a refinement.
#[derive(Debug)]
pub(crate) struct PairRefinement<'a> {
    pub tree: &'a mut Tree,
    pub oracle: Oracle,
    /// Faces up to this area are not cut (scene length²).
    pub least_area: f64,
    /// The power that each node sends, per band, in parts of the emitted power.
    pub light: &'a mut [Vec<f64>],
    /// Pairs left out since they face away.
    pub dropped: usize,
}

impl PairRefinement<'_> {
    /// The pairs to be linked that stand for `pairs`.
    pub(crate) fn refine(&mut self, pairs: Vec<Pair>) -> Vec<Pair> {
        let (mut open, mut found) = (pairs, Vec::new());
        while let Some(pair) = open.pop() {
            check_interrupt();
            if pair[0] == pair[1] {
                self.refine_alone(pair[0], &mut open, &mut found);
                continue;
            }
            match self.judge(pair) {
                Verdict::FacesAway => self.dropped += 1,
                Verdict::Link => found.push(pair),
                Verdict::Split => match self.split(pair) {
                    Some(parts) => open.extend(parts),
                    None => found.push(pair),
                },
            }
        }
        found
    }

    /// Whether a pair that is linked has to be refined.
    pub(crate) fn is_too_bright(&self, pair: Pair) -> bool {
        if pair[0] == pair[1] {
            return !self.oracle.links_itself(self.tree, self.light, pair[0] as usize);
        }
        self.judge(pair) == Verdict::Split && pair.iter().any(|node| self.can_split(*node))
    }

    fn judge(&self, pair: Pair) -> Verdict {
        check_interrupt();
        self.oracle.judge(self.tree, self.light, pair.map(|node| node as usize))
    }

    /// A node's pair with itself: nothing for flat faces, a link for dim curved ones, else pairs of children.
    fn refine_alone(&mut self, node: u32, open: &mut Vec<Pair>, found: &mut Vec<Pair>) {
        let index = node as usize;
        let face = self.tree.nodes()[index].face.as_ref();
        if face.is_some_and(|face| face.normal.is_some()) {
            return;
        }
        let is_face = face.is_some();
        let is_dim = is_face && self.oracle.links_itself(self.tree, self.light, index);
        if is_dim || !self.divide(node) {
            is_face.then(|| found.push([node; 2]));
            return;
        }
        let children = &self.tree.nodes()[index].children;
        for (k, first) in children.iter().enumerate() {
            open.extend(children[k..].iter().map(|second| [*first, *second]));
        }
    }

    /// The pairs of the children of one node with the other.
    fn split(&mut self, [p, q]: Pair) -> Option<Vec<Pair>> {
        let radius = |node: u32| self.tree.nodes()[node as usize].radius;
        let (large, small) = if radius(p) >= radius(q) { (p, q) } else { (q, p) };
        let (split, kept) =
            [(large, small), (small, large)].into_iter().find(|(node, _)| self.divide(*node))?;
        Some(self.tree.nodes()[split as usize].children.iter().map(|child| [*child, kept]).collect())
    }

    fn can_split(&self, node: u32) -> bool {
        let node = &self.tree.nodes()[node as usize];
        !node.children.is_empty() || (node.face.is_some() && node.area > self.least_area)
    }

    /// Gives a node children, unless it is too small. Returns whether it has any.
    fn divide(&mut self, node: u32) -> bool {
        let index = node as usize;
        let is_new = self.tree.nodes()[index].children.is_empty();
        if !self.can_split(node) || !self.tree.cut(index) {
            return false;
        }
        if is_new {
            let whole = self.tree.nodes()[index].area;
            for child in self.tree.children(index) {
                let share = self.tree.nodes()[child].area / whole;
                self.light.iter_mut().for_each(|band| band.push(share * band[index]));
            }
        }
        true
    }
}
