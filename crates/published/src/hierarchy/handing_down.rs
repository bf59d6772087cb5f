//! Links handed down to cells that exist.
//!
//! ```text
//! F_c = w_cq/A_c ,  F_p = w_pq/A_p :   a link p–q stays where |F_c − F_p| ≤ eps for all cells c of p, and of q
//! ```
//!
//! A link gives all cells below a face one irradiance. The power of the link bounds what this errs in the
//! mean, not in a cell: where walls meet, cells of the size √eps see as much of the near wall as they can,
//! by their own links, and as much of all of it as a larger face sees in the mean, so that their form factors
//! added up to 1.5 in closed rooms, however small eps was. So each link whose form factor is above eps
//! is compared with those of the cells at either end, shadows included, and replaced by them where one differs
//! by more; no face is cut for it. Then row sums tend to 1 as eps falls.
//!
//! Links of clusters stay: their errors fall with the distance from which on they are linked.

use radiosity_geom::RayTree;

use super::links::Link;
use super::pair_refinement::Pair;
use super::tree::Tree;

/// Data that handing down needs.
#[derive(Debug)]
pub(crate) struct HandingDown<'a> {
    pub tree: &'a Tree,
    pub obstacles: &'a RayTree,
    /// Rays that find the visibility of a link.
    pub rays: usize,
    /// Greatest difference of form factors under one link.
    pub eps: f64,
}

impl HandingDown<'_> {
    /// The links that stand for a link.
    pub(crate) fn down(&self, link: Link) -> Vec<Link> {
        let (mut open, mut found) = (vec![link], Vec::new());
        while let Some(link) = open.pop() {
            match self.parts(&link) {
                Some(parts) => open.extend(parts),
                None => found.push(link),
            }
        }
        found
    }

    /// The links of the cells of one end that are to stand for a link; None where it may stay.
    fn parts(&self, link: &Link) -> Option<Vec<Link>> {
        let [p, q] = link.pair;
        let is_of_faces = [p, q].iter().all(|node| *node as usize >= self.tree.clusters());
        if p == q || !is_of_faces {
            return None;
        }
        [[p, q], [q, p]].into_iter().find_map(|ends| self.parts_of(ends, link))
    }

    /// The links of the cells of the first of two nodes with the second, where one of them differs.
    fn parts_of(&self, [node, other]: Pair, link: &Link) -> Option<Vec<Link>> {
        let area = |node: u32| self.tree.nodes()[node as usize].area;
        if link.unhidden <= self.eps * area(node) {
            return None;
        }
        let cells = self.tree.children(node as usize);
        let made = |cell| Link::new(self.tree, self.obstacles, [cell as u32, other], self.rays);
        let parts: Vec<Link> = cells.map(made).collect();
        let form_factor = link.weight / area(node);
        let differs = |part: &Link| (part.weight / area(part.pair[0]) - form_factor).abs() > self.eps;
        parts.iter().any(differs).then_some(parts)
    }
}
