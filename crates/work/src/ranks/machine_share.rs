//! The share of its machine that a rank may use.

use std::num::NonZero;
use std::thread;

/// The share of a rank in its machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MachineShare {
    /// Ranks on this machine, which share its memory.
    pub ranks: usize,
    /// Threads that this rank runs unless told otherwise.
    pub threads: usize,
}

impl MachineShare {
    /// The share of a rank that has its machine for itself.
    pub(super) fn alone() -> Self {
        Self { ranks: 1, threads: available() }
    }

    /// The share of one of so many ranks that may use all processors alike.
    pub(super) fn beside(ranks: usize) -> Self {
        Self { ranks, threads: (available() / ranks).max(1) }
    }

    /// The share of the rank `own` of a machine on which each rank may run on `processors` of its own; empty
    /// where these are not known. Ranks that are bound to different processors have them for themselves,
    /// others share.
    pub fn among(processors: &[Vec<usize>], own: usize) -> Self {
        let ranks = processors.len();
        let mine = &processors[own];
        if processors.iter().any(Vec::is_empty) {
            return Self::beside(ranks);
        }
        let users = |processor: &usize| processors.iter().filter(|all| all.contains(processor)).count();
        let share: f64 = mine.iter().map(|processor| 1.0 / users(processor) as f64).sum();
        // A control group may allow fewer than there are.
        let allowed = available() as f64 / mine.len() as f64;
        Self { ranks, threads: ((share * allowed.min(1.0) + 1e-9) as usize).max(1) }
    }
}

/// Processors that this process may use.
pub(crate) fn available() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}

/// The processors on which Linux lets this process run; none where that is not known.
pub fn allowed() -> Vec<usize> {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("Cpus_allowed_list:"));
    line.and_then(listed).unwrap_or_default()
}

/// The numbers of a list such as `0-3,8`.
fn listed(text: &str) -> Option<Vec<usize>> {
    let mut numbers = Vec::new();
    for part in text.trim().split(',') {
        let (first, last) = part.split_once('-').unwrap_or((part, part));
        numbers.extend(first.parse().ok()?..=last.parse::<usize>().ok()?);
    }
    Some(numbers)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_of_processors_are_read() {
        assert_eq!(listed("\t0-2,5"), Some(vec![0, 1, 2, 5]));
        assert_eq!(listed("7"), Some(vec![7]));
        assert_eq!(listed("all"), None);
    }

    #[test]
    fn bound_ranks_keep_their_processors_and_others_share() {
        let free: Vec<usize> = (0..available()).collect();
        // Alone, and bound to what nobody else may use: all of it.
        let bound = [free.clone(), vec![1000, 1001]];
        assert_eq!(MachineShare::among(&bound, 0), MachineShare { ranks: 2, threads: available() });
        // Nobody is bound.
        assert_eq!(MachineShare::among(&vec![free.clone(); 4], 3).threads, (available() / 4).max(1));
        assert_eq!(MachineShare::among(&[free, Vec::new()], 0), MachineShare::beside(2));
    }
}
