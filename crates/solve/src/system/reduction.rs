//! The map from the coefficients of reflecting elements to those of a subspace, and back.
//!
//! Unknowns stand in the groups of elements some of which reflect, in their order; coefficients of elements
//! that reflect nothing are zero.

use std::ops::Range;

use radiosity_published::bases::Subspace;
use radiosity_published::bases::subspace::Group;

/// The subspace of a basis beside the reflecting elements.
#[derive(Debug)]
pub(super) struct Reduction<'a> {
    subspace: &'a Subspace,
    groups: Vec<&'a Group>,
    /// Where the coefficients of the reflecting elements stand among those of all.
    reflecting: Vec<Range<usize>>,
    dim: usize,
}

impl<'a> Reduction<'a> {
    /// The reduction to `subspace` where the elements `reflecting` of those with these `starts` reflect.
    pub(super) fn new(subspace: &'a Subspace, reflecting: &[usize], starts: &[usize]) -> Self {
        let reflects =
            |group: &&Group| group.elements.iter().any(|index| reflecting.binary_search(index).is_ok());
        Self {
            subspace,
            groups: subspace.groups().iter().filter(reflects).collect(),
            reflecting: reflecting.iter().map(|index| starts[*index]..starts[index + 1]).collect(),
            dim: starts[starts.len() - 1],
        }
    }

    /// Number of unknowns of each group.
    pub(super) fn sizes(&self) -> Vec<usize> {
        self.groups.iter().map(|group| group.count()).collect()
    }

    /// P x, for coefficients of all elements.
    pub(super) fn projected(&self, x: &[f64]) -> Vec<f64> {
        self.subspace.projected(x)
    }

    /// Qᵀ x, for coefficients of the reflecting elements.
    pub(super) fn restricted(&self, x: &[f64]) -> Vec<f64> {
        let all = self.spread(x);
        self.groups.iter().flat_map(|group| group.restricted(&all)).collect()
    }

    /// |Q|ᵀ m, for measures of the reflecting elements.
    pub(super) fn bounded(&self, m: &[f64]) -> Vec<f64> {
        let all = self.spread(m);
        self.groups.iter().flat_map(|group| group.bounded(&all)).collect()
    }

    /// Q a, on the reflecting elements.
    pub(super) fn extended(&self, a: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; self.dim];
        let mut rest = a;
        for group in &self.groups {
            let (own, others) = rest.split_at(group.count());
            group.extend(own, &mut all);
            rest = others;
        }
        self.reflecting.iter().flat_map(|range| &all[range.clone()]).copied().collect()
    }

    fn spread(&self, x: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; self.dim];
        let mut rest = x;
        for range in &self.reflecting {
            let (own, others) = rest.split_at(range.len());
            all[range.clone()].copy_from_slice(own);
            rest = others;
        }
        all
    }
}
