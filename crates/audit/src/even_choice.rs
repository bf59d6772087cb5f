//! An even choice of some of many things: one of each part of equal length.
//!
//! ```text
//! number of part k = ⌊(k + {(k + 1) (s + 1) / φ}) n / m⌋ ,     k = 0, …, m − 1 ,
//! ```
//!
//! of n things m, with the golden ratio φ and the seed s: the place within a part is another in each, so that it
//! does not keep step with the rows of a plane or the columns of a picture.

/// At most `most` of `count` things, in their order; others with another seed.
pub fn evenly<T>(
    things: impl Iterator<Item = T>,
    count: usize,
    most: usize,
    seed: u64,
) -> impl Iterator<Item = T> {
    // Multiples of an irrational number, which keeps its digits for so many seeds.
    const SEEDS: u64 = 1 << 20;
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let wanted = most.min(count);
    let place = move |part: usize| {
        let within = ((seed % SEEDS + 1) as f64 * (part as f64 + 1.0) * golden).fract();
        ((part as f64 + within) * count as f64 / wanted as f64) as usize
    };
    let mut next = 0;
    things.enumerate().filter_map(move |(number, thing)| {
        let is_next = next < wanted && number >= place(next);
        next += usize::from(is_next);
        is_next.then_some(thing)
    })
}

/// An order of so many things of which the first are spread evenly over all, however many they are: that of their
/// numbers with the bits reversed.
pub fn spread(count: usize) -> impl Iterator<Item = usize> {
    let all = count.next_power_of_two();
    let reversed = move |k: usize| if all > 1 { k.reverse_bits() >> (usize::BITS - all.ilog2()) } else { k };
    (0..all).map(reversed).filter(move |number| *number < count)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    fn chosen(count: usize, most: usize, seed: u64) -> Vec<usize> {
        evenly(0..count, count, most, seed).collect()
    }

    #[test]
    fn few_are_all_taken() {
        assert_eq!(chosen(300, 512, 0), (0..300).collect::<Vec<_>>());
        assert!(chosen(0, 512, 0).is_empty() && chosen(300, 0, 0).is_empty());
    }

    #[test]
    fn many_are_taken_of_every_part_and_of_every_column() {
        // A plane of 512 × 64 sensors: their columns are numbers modulo 64.
        let taken = chosen(512 * 64, 512, 0);
        assert_eq!(taken.iter().map(|number| number / 64).collect::<Vec<_>>(), (0..512).collect::<Vec<_>>());
        assert_eq!(taken.iter().map(|number| number % 64).collect::<BTreeSet<_>>().len(), 64);
    }

    #[test]
    fn the_first_of_an_order_are_spread_over_all() {
        for count in [0, 1, 2, 5, 64, 100] {
            let order: Vec<usize> = spread(count).collect();
            assert_eq!(
                order.iter().collect::<BTreeSet<_>>(),
                (0..count).collect::<Vec<_>>().iter().collect()
            );
        }
        let first: BTreeSet<usize> = spread(100).take(13).map(|number| number / 8).collect();
        assert_eq!(first.len(), 13);
    }

    #[test]
    fn seeds_choose_others() {
        let [first, second] = [1, 2].map(|seed| chosen(10_000, 100, seed));
        assert!(first.len() == 100 && first.iter().filter(|number| second.contains(number)).count() < 10);
    }
}
