//! Messages of ranks to each other, in rounds whose lengths MPI can count.

use std::ops::Range;

use mpi::Count;
use mpi::collective::SystemOperation;
use mpi::datatype::{Partition, PartitionMut};
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives, Equivalence};
use radiosity_cli::rounds::{parts, room, rounds};
use radiosity_work::ranks::shares;

/// Most entries that a call of MPI moves.
const MOST: usize = Count::MAX as usize;

/// Gathers the bytes of each rank, in the order of the ranks.
pub(super) fn all_gather(comm: &SimpleCommunicator, own: &[u8]) -> Vec<Vec<u8>> {
    let mut lengths = vec![0u64; comm.size() as usize];
    comm.all_gather_into(&(own.len() as u64), &mut lengths[..]);
    let mut end = 0;
    let ends: Vec<usize> = lengths
        .iter()
        .map(|length| {
            end += *length as usize;
            end
        })
        .collect();
    let mut all = vec![0; end];
    complete(comm, own, &ends, &mut all);
    (0..ends.len()).map(|rank| all[shares::range(&ends, rank)].to_vec()).collect()
}

/// Fills `all`, of which rank k has the part that ends at `ends[k]`; `own` is the part of this rank.
pub(super) fn complete<T>(comm: &SimpleCommunicator, own: &[T], ends: &[usize], all: &mut [T])
where
    T: Equivalence + Copy + Default,
{
    let starts: Vec<usize> = (0..ends.len()).map(|rank| shares::range(ends, rank).start).collect();
    let lengths: Vec<usize> = ends.iter().zip(&starts).map(|(end, start)| end - start).collect();
    let rounds = rounds(&lengths, MOST);
    if let [only] = &rounds[..] {
        let places = Places::of(only);
        comm.all_gather_varcount_into(own, &mut PartitionMut::new(all, places.counts, places.starts));
        return;
    }
    for round in rounds {
        let places = Places::of(&round);
        let mut some = vec![T::default(); round.iter().map(ExactSizeIterator::len).sum()];
        let own = &own[round[comm.rank() as usize].clone()];
        comm.all_gather_varcount_into(
            own,
            &mut PartitionMut::new(&mut some[..], places.counts, places.starts),
        );
        let mut rest = &some[..];
        for (start, part) in starts.iter().zip(&round) {
            let (now, later) = rest.split_at(part.len());
            all[start + part.start..start + part.end].copy_from_slice(now);
            rest = later;
        }
    }
}

/// Exchanges bytes: returns those that each rank has for this one; `to[k]` are the bytes of this one for rank
/// k.
pub(super) fn exchange(comm: &SimpleCommunicator, to: Vec<Vec<u8>>) -> Vec<Vec<u8>> {
    let sent: Vec<u64> = to.iter().map(|bytes| bytes.len() as u64).collect();
    let mut received = vec![0u64; sent.len()];
    comm.all_to_all_into(&sent[..], &mut received[..]);
    let room = room(sent.len(), MOST);
    let mut rounds = 0u64;
    let own = sent.iter().map(|length| length.div_ceil(room as u64)).max().unwrap_or(0);
    comm.all_reduce_into(&own, &mut rounds, SystemOperation::max());
    let [sent, received] =
        [sent, received].map(|lengths| lengths.iter().map(|x| *x as usize).collect::<Vec<_>>());
    let mut all: Vec<Vec<u8>> = received.iter().map(|length| Vec::with_capacity(*length)).collect();
    for round in 0..rounds as usize {
        let [going, coming] = [&sent, &received].map(|lengths| parts(lengths, room, round));
        let out: Vec<u8> =
            to.iter().zip(&going).flat_map(|(bytes, part)| &bytes[part.clone()]).copied().collect();
        let mut into = vec![0; coming.iter().map(ExactSizeIterator::len).sum()];
        let [from, places] = [&going, &coming].map(|parts| Places::of(parts));
        comm.all_to_all_varcount_into(
            &Partition::new(&out[..], from.counts, from.starts),
            &mut PartitionMut::new(&mut into[..], places.counts, places.starts),
        );
        let mut rest = &into[..];
        for (bytes, part) in all.iter_mut().zip(&coming) {
            let (now, later) = rest.split_at(part.len());
            bytes.extend_from_slice(now);
            rest = later;
        }
    }
    all
}

/// Lengths and starts of parts that follow each other in a buffer.
struct Places {
    counts: Vec<Count>,
    starts: Vec<Count>,
}

impl Places {
    fn of(parts: &[Range<usize>]) -> Self {
        let count = |length: usize| Count::try_from(length).expect("rounds are no larger than MPI can count");
        let mut start = 0;
        let place = |part: &Range<usize>| {
            let own = start;
            start += part.len();
            (count(part.len()), count(own))
        };
        let (counts, starts) = parts.iter().map(place).unzip();
        Self { counts, starts }
    }
}
