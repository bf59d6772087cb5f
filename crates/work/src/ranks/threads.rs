//! Ranks that are threads of one process: what ranks compute can so be tested where nothing else is
//! installed.

use std::sync::{Arc, Barrier, Mutex};
use std::thread;

use super::Ranks;
use super::comm::Comm;
use super::machine_share::MachineShare;
use super::shares;

/// A thread among several that are ranks to each other.
#[derive(Debug)]
struct Thread {
    rank: usize,
    table: Arc<Table>,
}

/// The place where the threads leave messages for each other.
#[derive(Debug)]
struct Table {
    barrier: Barrier,
    /// The bytes from each to each.
    messages: Vec<Vec<Mutex<Vec<u8>>>>,
}

/// Does `work` on `count` ranks, each a thread, which is given them as it sees them; the results in their
/// order.
///
/// # Panics
/// If one of them does; the others would wait for it, therefore `work` must not panic on some of them only.
pub fn on_ranks<T: Send>(count: usize, work: impl Fn(&Ranks) -> T + Sync) -> Vec<T> {
    let row = || (0..count).map(|_| Mutex::default()).collect();
    let messages = (0..count).map(|_| row()).collect();
    let table = Arc::new(Table { barrier: Barrier::new(count), messages });
    let rank = |rank: usize| Ranks::of(Thread { rank, table: Arc::clone(&table) });
    thread::scope(|scope| {
        let work = &work;
        let started: Vec<_> = (0..count)
            .map(|number| {
                let rank = rank(number);
                scope.spawn(move || work(&rank))
            })
            .collect();
        started.into_iter().map(|thread| thread.join().expect("no rank panics")).collect()
    })
}

impl Thread {
    fn slot(&self, from: usize, to: usize) -> std::sync::MutexGuard<'_, Vec<u8>> {
        self.table.messages[from][to].lock().expect("no rank panics")
    }
}

impl Comm for Thread {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.table.messages.len()
    }

    fn machine_share(&self) -> MachineShare {
        MachineShare::beside(self.size())
    }

    fn meet(&self) {
        self.table.barrier.wait();
    }

    fn all_gather(&self, own: Vec<u8>) -> Vec<Vec<u8>> {
        self.exchange(vec![own; self.size()])
    }

    fn exchange(&self, to: Vec<Vec<u8>>) -> Vec<Vec<u8>> {
        to.into_iter().enumerate().for_each(|(rank, bytes)| *self.slot(self.rank, rank) = bytes);
        self.table.barrier.wait();
        let received =
            (0..self.size()).map(|rank| std::mem::take(&mut *self.slot(rank, self.rank))).collect();
        self.table.barrier.wait();
        received
    }

    fn complete(&self, values: &mut [f64], ends: &[usize]) {
        let own =
            values[shares::range(ends, self.rank)].iter().flat_map(|value| value.to_le_bytes()).collect();
        for (rank, bytes) in self.all_gather(own).into_iter().enumerate() {
            let numbers = bytes.as_chunks::<8>().0.iter().map(|bytes| f64::from_le_bytes(*bytes));
            values[shares::range(ends, rank)]
                .iter_mut()
                .zip(numbers)
                .for_each(|(value, number)| *value = number);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ranks::PartName;

    #[test]
    fn every_rank_gets_all_pieces_in_order() {
        let costs: Vec<f64> = (0..37).map(|k| f64::from(k % 5)).collect();
        let squares: Vec<f64> = (0..37).map(|k| f64::from(k * k) / 3.0).collect();
        for ranks in 1..=4 {
            let found = on_ranks(ranks, |ranks| {
                ranks.map(PartName::Points, &costs, |piece| (piece as f64).powi(2) / 3.0)
            });
            assert_eq!(found, vec![squares.clone(); ranks]);
        }
    }

    #[test]
    fn messages_and_numbers_arrive_where_they_belong() {
        let found = on_ranks(3, |ranks| {
            let received = ranks.exchange((0..3).map(|to| (ranks.number(), to)).collect());
            let mut values = vec![f64::NAN; 5];
            let ends = [2, 2, 5];
            for machine_share in shares::range(&ends, ranks.number()) {
                values[machine_share] = machine_share as f64;
            }
            ranks.complete(&mut values, &ends);
            (received, values, ranks.any(ranks.number() == 2), ranks.traffic().numbers)
        });
        for (rank, (received, values, any, _)) in found.iter().enumerate() {
            assert_eq!(*received, (0..3).map(|from| (from, rank)).collect::<Vec<_>>());
            assert_eq!(*values, [0.0, 1.0, 2.0, 3.0, 4.0]);
            assert!(any);
        }
        // Two numbers of the first and three of the last, to two others each.
        assert_eq!(found.iter().map(|(.., sent)| *sent).collect::<Vec<_>>(), [32, 0, 48]);
    }
}
