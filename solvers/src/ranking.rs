//! Items ordered by a key that changes: which is the largest?

/// A binary heap of the items `0..keys.len()` whose keys may be changed in place.
///
/// The largest key is on top; of equal keys the lowest item, so that the order does not depend on history.
pub(crate) struct Ranking {
    keys: Vec<f64>,
    /// Items, each ahead of the two at 2i+1 and 2i+2.
    heap: Vec<usize>,
    /// Where each item stands in `heap`.
    places: Vec<usize>,
}

impl Ranking {
    /// Ranks the items by their `keys`, none of them NaN.
    pub(crate) fn new(keys: Vec<f64>) -> Self {
        let items = keys.len();
        let mut ranking = Self { keys, heap: (0..items).collect(), places: (0..items).collect() };
        for place in (0..items / 2).rev() {
            ranking.sink(place);
        }
        ranking
    }

    /// The item with the largest key, and that key.
    pub(crate) fn top(&self) -> Option<(usize, f64)> {
        self.heap.first().map(|item| (*item, self.keys[*item]))
    }

    /// All keys, by item.
    pub(crate) fn keys(&self) -> &[f64] {
        &self.keys
    }

    /// Gives `item` another key.
    pub(crate) fn set(&mut self, item: usize, key: f64) {
        let rises = key > self.keys[item];
        self.keys[item] = key;
        if rises { self.rise(self.places[item]) } else { self.sink(self.places[item]) }
    }

    /// Whether the item at place `i` belongs above the one at place `j`.
    fn ahead(&self, i: usize, j: usize) -> bool {
        let (i, j) = (self.heap[i], self.heap[j]);
        self.keys[i] > self.keys[j] || (self.keys[i] == self.keys[j] && i < j)
    }

    fn swap(&mut self, i: usize, j: usize) {
        self.heap.swap(i, j);
        self.places[self.heap[i]] = i;
        self.places[self.heap[j]] = j;
    }

    fn rise(&mut self, mut place: usize) {
        while place > 0 && self.ahead(place, (place - 1) / 2) {
            self.swap(place, (place - 1) / 2);
            place = (place - 1) / 2;
        }
    }

    fn sink(&mut self, mut place: usize) {
        loop {
            let children = (2 * place + 1)..self.heap.len().min(2 * place + 3);
            let Some(child) = children.reduce(|i, j| if self.ahead(j, i) { j } else { i }) else { return };
            if !self.ahead(child, place) {
                return;
            }
            self.swap(place, child);
            place = child;
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn top_is_the_first_largest(
            keys in prop::collection::vec(0..9u8, 1..40),
            changes in prop::collection::vec((any::<prop::sample::Index>(), 0..9u8), 0..80),
        ) {
            let mut keys: Vec<f64> = keys.into_iter().map(f64::from).collect();
            let mut ranking = Ranking::new(keys.clone());
            for (item, key) in changes {
                let item = item.index(keys.len());
                keys[item] = f64::from(key);
                ranking.set(item, keys[item]);
                let largest = keys.iter().copied().fold(0.0, f64::max);
                let first = keys.iter().position(|key| *key == largest).unwrap();
                prop_assert_eq!(ranking.top(), Some((first, largest)));
            }
        }
    }
}
