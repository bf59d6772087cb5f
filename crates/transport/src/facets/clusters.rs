//! Clusters of facets that lie beside each other.

use radiosity_geom::Aabb;
use radiosity_visibility::{FlatEnd, Neighbours};

use super::facet::Facet;

/// Most facets of a cluster. Chosen.
const MOST: usize = 16;

/// Facets by clusters that lie beside each other.
#[derive(Debug)]
pub(super) struct Clusters {
    list: Vec<Cluster>,
    /// The cluster of each facet, and its place among the members of that.
    of: Vec<(u32, u32)>,
}

/// Facets that lie beside each other.
#[derive(Debug)]
pub(super) struct Cluster {
    /// Their numbers, ascending.
    pub members: Vec<u32>,
    pub neighbours: Neighbours,
}

impl Clusters {
    /// Clusters of all facets, by halves along the longest side of the box around their centres.
    pub(super) fn of(facets: &[Facet]) -> Self {
        let mut clusters = Self { list: Vec::new(), of: vec![(0, 0); facets.len()] };
        let mut all: Vec<u32> = (0..facets.len() as u32).collect();
        clusters.divide(facets, &mut all);
        clusters
    }

    fn divide(&mut self, facets: &[Facet], members: &mut [u32]) {
        let center = |member: u32| facets[member as usize].center();
        if members.len() > MOST {
            let around = Aabb::around(members.iter().map(|member| center(*member)));
            let axis = (around.max - around.min).max_position();
            let place = |member: u32| center(member)[axis];
            let middle = members.len() / 2;
            members.select_nth_unstable_by(middle, |a, b| place(*a).total_cmp(&place(*b)).then(a.cmp(b)));
            let (low, high) = members.split_at_mut(middle);
            self.divide(facets, low);
            return self.divide(facets, high);
        }
        members.sort_unstable();
        for (place, member) in (0..).zip(members.iter()) {
            self.of[*member as usize] = (self.list.len() as u32, place);
        }
        let ends: Vec<FlatEnd> = members.iter().map(|member| facets[*member as usize].end()).collect();
        self.list.push(Cluster { members: members.to_vec(), neighbours: Neighbours::of(&ends) });
    }

    /// All of them.
    pub(super) fn list(&self) -> &[Cluster] {
        &self.list
    }

    /// The number of the cluster of a facet, and its place among the members of that.
    pub(super) fn of_facet(&self, facet: usize) -> (usize, usize) {
        let (cluster, place) = self.of[facet];
        (cluster as usize, place as usize)
    }
}
