//! Clusters of facets that lie beside each other.

use radiosity_geom::Aabb;
use radiosity_visibility::Neighbours;

use super::facet::Facet;

/// Most facets of a cluster. Chosen.
const MOST: usize = 16;

/// Facets by clusters that lie beside each other.
#[derive(Debug)]
pub(super) struct Clusters {
    list: Vec<Neighbours>,
    /// The cluster of each facet.
    of: Vec<u32>,
}

impl Clusters {
    /// Clusters of all facets, by halves along the longest side of the box around their centres.
    pub(super) fn of(facets: &[Facet]) -> Self {
        let mut clusters = Self { list: Vec::new(), of: vec![0; facets.len()] };
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
        members.iter().for_each(|member| self.of[*member as usize] = self.list.len() as u32);
        let corners = members.iter().flat_map(|member| facets[*member as usize].end().hull);
        self.list.push(Neighbours::within(&Aabb::around(corners.copied())));
    }

    /// Number of clusters.
    pub(super) fn count(&self) -> usize {
        self.list.len()
    }

    /// The number of the cluster of a facet.
    pub(super) fn number(&self, facet: usize) -> usize {
        self.of[facet] as usize
    }

    /// A cluster.
    pub(super) fn cluster(&self, number: usize) -> &Neighbours {
        &self.list[number]
    }
}
