//! A forest of disjoint sets, joined pair by pair.

/// Sets of the numbers 0 to n − 1; the least of each represents it.
#[derive(Debug)]
pub(super) struct Forest {
    parents: Vec<usize>,
}

impl Forest {
    /// One set per number.
    pub(super) fn new(count: usize) -> Self {
        Self { parents: (0..count).collect() }
    }

    /// The representative of the set of `place`.
    pub(super) fn root(&self, mut place: usize) -> usize {
        while self.parents[place] != place {
            place = self.parents[place];
        }
        place
    }

    /// Joins the sets of `a` and `b`.
    pub(super) fn join(&mut self, a: usize, b: usize) {
        let [a, b] = [a, b].map(|place| self.root(place));
        self.parents[a.max(b)] = a.min(b);
        self.parents[a.min(b)] = a.min(b);
    }
}
