//! Messages cut into rounds: MPI counts the entries that a call moves in 31 bits.

use std::ops::Range;

/// Rounds in which messages of these lengths travel, where a round moves `most` entries in all: for each
/// round the part of every message that travels in it. All messages get the same room.
pub fn rounds(lengths: &[usize], most: usize) -> Vec<Vec<Range<usize>>> {
    if lengths.iter().sum::<usize>() <= most {
        return vec![lengths.iter().map(|length| 0..*length).collect()];
    }
    let room = room(lengths.len(), most);
    let longest = lengths.iter().copied().max().unwrap_or(0);
    (0..longest.div_ceil(room)).map(|round| parts(lengths, room, round)).collect()
}

/// Number of entries of each of so many messages that travel in a round.
pub fn room(messages: usize, most: usize) -> usize {
    (most / messages.max(1)).max(1)
}

/// The part of each message that travels in a round.
pub fn parts(lengths: &[usize], room: usize, round: usize) -> Vec<Range<usize>> {
    let part = |length: &usize| (round * room).min(*length)..((round + 1) * room).min(*length);
    lengths.iter().map(part).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn every_thing_goes_once_and_no_round_is_too_large(
            lengths in prop::collection::vec(0..100usize, 1..9),
            most in 9..200usize,
        ) {
            let rounds = rounds(&lengths, most);
            let mut gone = vec![0; lengths.len()];
            for round in &rounds {
                prop_assert!(round.iter().map(ExactSizeIterator::len).sum::<usize>() <= most);
                for (gone, part) in gone.iter_mut().zip(round) {
                    if !part.is_empty() {
                        prop_assert_eq!(part.start, *gone);
                        *gone = part.end;
                    }
                }
            }
            prop_assert_eq!(gone, lengths);
        }
    }
}
