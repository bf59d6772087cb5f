//! Surfaces that may stand between facets of one cluster and others, looked up for all pairs of two clusters at once.

use radiosity_visibility::{BetweenGroups, Normals, Places, Visibility};

use super::clusters::Clusters;
use super::facet::Facet;

/// Surfaces that may stand between facets of one cluster and those of any other, as far as it has been asked for.
#[derive(Debug)]
pub(super) struct ClusterSight<'a> {
    facets: &'a [Facet],
    clusters: &'a Clusters,
    visibility: &'a Visibility,
    /// The number of the cluster.
    own: usize,
    /// Surfaces that may stand between the cluster and each.
    past: Vec<Option<PastCluster>>,
    /// Planes that keep surfaces out, of facets of the cluster and of others.
    normals: [Normals; 2],
}

/// Surfaces that may stand between two clusters.
#[derive(Debug)]
enum PastCluster {
    /// Many, of which nothing more is known.
    Many,
    Few(FewBetween),
}

/// The few surfaces that may stand between two clusters.
#[derive(Debug)]
struct FewBetween {
    between: BetweenGroups,
    /// Some of these: what may stand between the first one and each facet of the other.
    others: Vec<Places>,
}

/// Surfaces that may stand between a facet of a cluster and others.
#[derive(Debug)]
pub(super) struct FacetSight<'a, 'b> {
    cluster: &'b mut ClusterSight<'a>,
    own: &'a Facet,
    /// Surfaces that may stand between the facet and each cluster.
    places: Vec<Option<Places>>,
}

/// The passage of a pair, as far as clusters tell.
#[derive(Clone, Copy, Debug)]
pub(super) enum Passage<'a> {
    /// Nothing.
    Unknown,
    /// These may stand there.
    Past { between: &'a BetweenGroups, places: [&'a Places; 2] },
}

impl<'a> ClusterSight<'a> {
    /// The sight of the cluster of this number.
    pub(super) fn of(
        facets: &'a [Facet],
        clusters: &'a Clusters,
        visibility: &'a Visibility,
        own: usize,
    ) -> Self {
        let past = clusters.list().iter().map(|_| None).collect();
        let normals = [visibility.no_normals(), visibility.no_normals()];
        Self { facets, clusters, visibility, own, past, normals }
    }

    /// The sight of one of its facets.
    pub(super) fn of_facet(&mut self, facet: usize) -> FacetSight<'a, '_> {
        let (own, places) = (&self.facets[facet], vec![None; self.clusters.list().len()]);
        FacetSight { cluster: self, own, places }
    }
}

impl FacetSight<'_, '_> {
    /// Surfaces that may stand between the facet and another one.
    pub(super) fn past(&mut self, other: usize) -> Passage<'_> {
        let ClusterSight { facets, clusters, visibility, own, past, normals } = &mut *self.cluster;
        let (number, place) = clusters.of_facet(other);
        let groups = [*own, number].map(|number| &clusters.list()[number].neighbours);
        let past = past[number].get_or_insert_with(|| {
            let Some(between) = visibility.between_groups(groups, normals) else { return PastCluster::Many };
            let places = |member: &u32| {
                visibility.between(facets[*member as usize].end(), 1, groups, &between, &mut normals[1])
            };
            let others = clusters.list()[number].members.iter().map(places).collect();
            PastCluster::Few(FewBetween { between, others })
        });
        let PastCluster::Few(FewBetween { between, others }) = past else { return Passage::Unknown };
        let places = self.places[number]
            .get_or_insert_with(|| visibility.between(self.own.end(), 0, groups, between, &mut normals[0]));
        Passage::Past { between, places: [places, &others[place]] }
    }
}

impl Passage<'_> {
    /// Whether nothing may stand there.
    pub(super) fn is_open(&self) -> bool {
        matches!(self, Self::Past { places: [one, other], .. } if one.are_apart(other))
    }

    /// Whether it takes long to tell if it is clear.
    pub(super) fn is_unknown(&self) -> bool {
        matches!(self, Self::Unknown)
    }

    /// Whether nothing can stand between these two.
    pub(super) fn is_clear(&self, [one, other]: [&Facet; 2], visibility: &Visibility) -> bool {
        let ends = [one.end(), other.end()];
        match self {
            Self::Unknown => visibility.is_clear_of_all(ends),
            Self::Past { between, places } => visibility.is_clear(ends, between, *places),
        }
    }
}
