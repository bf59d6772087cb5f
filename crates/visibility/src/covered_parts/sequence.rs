//! A sequence of boxes in which the first from some place on that overlaps another box is found.
//!
//! Above the boxes stand those around each two neighbours, above these those around each two, and so on.
//! Where neighbours of the sequence lie near each other, one search takes a time in proportion to the
//! logarithm of their number.

use radiosity_geom::Aabb;

/// A sequence of boxes.
pub(super) struct Sequence {
    /// The boxes, then those around each two of the level before.
    levels: Vec<Vec<Aabb>>,
}

impl Sequence {
    pub(super) fn new(boxes: impl IntoIterator<Item = Aabb>) -> Self {
        let mut levels: Vec<Vec<Aabb>> = Vec::new();
        let mut next: Vec<Aabb> = boxes.into_iter().collect();
        while next.len() > 1 {
            let above =
                next.chunks(2).map(|two| two.iter().copied().fold(Aabb::EMPTY, Aabb::union)).collect();
            levels.push(std::mem::replace(&mut next, above));
        }
        levels.push(next);
        Self { levels }
    }

    /// The first box from the place `from` on that overlaps `query`.
    pub(super) fn first_overlapping(&self, from: usize, query: &Aabb) -> Option<usize> {
        let (mut level, mut place) = (0, from);
        loop {
            if self.levels[level].get(place)?.overlaps(query) {
                if level == 0 {
                    return Some(place);
                }
                (level, place) = (level - 1, 2 * place);
            } else {
                place += 1;
                while place.is_multiple_of(2) && level + 1 < self.levels.len() {
                    (level, place) = (level + 1, place / 2);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_geom::DVec3;

    use super::*;

    proptest! {
        #[test]
        fn the_first_of_a_sequence_is_the_one_that_a_loop_finds(
            places in prop::collection::vec(0.0..10.0f64, 0..40), from in 0..45usize, at in 0.0..10.0f64,
        ) {
            let around = |x: f64| Aabb::around([DVec3::splat(x), DVec3::splat(x + 0.4)]);
            let boxes: Vec<Aabb> = places.into_iter().map(around).collect();
            let expected = (from..boxes.len()).find(|place| boxes[*place].overlaps(&around(at)));
            prop_assert_eq!(Sequence::new(boxes).first_overlapping(from, &around(at)), expected);
        }
    }
}
